// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A mesh of sites made in parts, so that its tiles are never all in memory.
//
// Computes: for each run of leaves its mesh of tiles, in which the sites far from its rim are placed, and
//           vertices that are not needed are removed. The parts are then joined to one mesh.
// Bound:    O(n) work besides that on the parts, not counting the sorting of what is on rims. The memory is
//           that of one run and of the coarsened parts.
// Method:   The triangles at the rim of a part are sealed: nobody writes their vertices. Nor does removal
//           touch what will move when a site is placed that waits, here or across the rim: its tiles are there
//           when the parts are joined.
//           Vertices on rims are identified by their places in the grid.
//
// A part stays as it is until leaves in it are split. So a site that fails costs only the part that it is in.
// Runs depend on the leaves alone, so results have the same bits for any number of threads.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_MESH_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_MESH_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_forest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Site_mesh_parts {
public:
  using Forest = Tile_forest<ConcurrencyTag, Geometry>;

  /// Makes the parts that are not there yet, or whose leaves have changed. Calls `coarsen(mesh, r)` for those in
  /// which all is well. Returns the sites that are to blame where not.
  template <class Coarsen>
  std::vector<std::size_t> make(Forest& forest, const Angle_range& range, const Coarsen& coarsen) {
    std::vector<std::size_t> to_blame;
    parts_.resize(forest.number_of_runs());
    for (std::size_t r = 0; r < parts_.size(); ++r) {
      if (parts_[r].state == forest.state_of_run(r)) continue;
      parts_[r] = Part();
      Rim_mesh<Geometry> part = forest.part(r);
      Site_mesh<Geometry>& mesh = part.mesh;
      mesh.seal_rim();
      const std::size_t corners = mesh.mesh.number_of_triangles();
      Site_mesh_relaxer<ConcurrencyTag, Geometry> relaxer(mesh, range);
      const std::vector<std::size_t> failing = relaxer.place_sites([](std::size_t) { return true; });
      const std::vector<std::uint32_t>& numbers = forest.sites_of_run(r);
      for (const std::size_t i : failing) to_blame.push_back(numbers[i]);
      if (!failing.empty()) continue;
      const std::size_t triangles = part.number_of_triangles + mesh.mesh.number_of_triangles() - corners;
      mesh.seal_waiting();
      coarsen(mesh, r);
      parts_[r] = compacted(part);
      parts_[r].triangles = triangles;
      parts_[r].state = forest.state_of_run(r);
    }
    std::sort(to_blame.begin(), to_blame.end());
    return to_blame;
  }

  /// Of the parts before they were coarsened.
  std::size_t number_of_triangles() const {
    std::size_t sum = 0;
    for (const Part& p : parts_) sum += p.triangles;
    return sum;
  }

  /// The mesh of all parts. \pre they are all made
  Site_mesh<Geometry> joined(const Forest& forest) const {
    Site_mesh<Geometry> result = forest.empty_mesh();
    std::vector<std::size_t> first{0};
    for (const Part& p : parts_) first.push_back(first.back() + p.rings.size());
    check_number_of_vertices(first.back());
    result.mesh.points.resize(first.back());
    result.mesh.rings.resize(first.back());
    const Indexed_vector<Ring_vertex, Ring_vertex> kept = identified(first);
    for (std::size_t r = 0; r < parts_.size(); ++r) copy(parts_[r], first[r], kept, result);
    for (std::size_t r = 0; r < parts_.size(); ++r) {
      const auto& numbers = forest.sites_of_run(r);
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        result.vertex_of_site[numbers[i]] = in_whole(parts_[r].vertex_of_site[i], first[r]);
        result.is_placed[numbers[i]] = parts_[r].is_placed[i];
      }
    }
    for (const Ring_vertex v : kept.ids())
      if (kept[v] != v) take_out(result.mesh.ring(v));
    close_rims(first, kept, result);
    return result;
  }

private:
  using Point = typename Geometry::Point;
  struct Part {
    std::array<std::size_t, 2> state{}; ///< of its run, when it was made; 0 if it is not
    std::size_t triangles = 0;
    std::vector<Point> points;
    std::vector<Ring> rings;
    std::vector<Ring_vertex> vertex_of_site;
    std::vector<std::uint8_t> is_placed;
    std::vector<Tile_place> rim_places;
    std::vector<Ring_vertex> rim;
    std::vector<std::array<Ring_vertex, 3>> rim_triangles;
  };

  std::vector<Part> parts_;

  static Ring_vertex in_whole(Ring_vertex v, std::size_t first) { return Ring_vertex(first + v.value()); }

  static void take_out(Ring& r) {
    r.mobility = Mobility::REMOVED;
    r.size = 0;
  }

  /// Without the vertices that are not in use.
  static Part compacted(Rim_mesh<Geometry>& from) {
    Part part;
    const auto& mesh = from.mesh.mesh;
    Indexed_vector<Ring_vertex, Ring_vertex> number(mesh.number_of_vertices());
    std::size_t n = 0;
    for (const Ring_vertex v : mesh.rings.ids())
      if (mesh.is_alive(v)) number[v] = Ring_vertex(n++);
    part.points.reserve(n);
    part.rings.reserve(n);
    for (const Ring_vertex v : mesh.rings.ids()) {
      if (!mesh.is_alive(v)) continue;
      part.points.push_back(mesh.point(v));
      part.rings.push_back(mesh.ring(v));
      Ring& r = part.rings.back();
      for (int k = 0; k < r.size; ++k) r.neighbor[std::size_t(k)] = number[r[k]];
    }
    for (const Ring_vertex v : from.mesh.vertex_of_site) part.vertex_of_site.push_back(number[v]);
    part.is_placed = std::move(from.mesh.is_placed);
    part.rim_places = std::move(from.rim_places);
    for (const Ring_vertex v : from.mesh.rim) part.rim.push_back(number[v]);
    for (const auto& t : from.mesh.rim_triangles)
      part.rim_triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    return part;
  }

  /// For each vertex the first one with the same place.
  Indexed_vector<Ring_vertex, Ring_vertex> identified(const std::vector<std::size_t>& first) const {
    Indexed_vector<Ring_vertex, Ring_vertex> kept(first.back());
    for (const Ring_vertex v : kept.ids()) kept[v] = v;
    std::vector<std::tuple<std::uint64_t, std::uint64_t, Ring_vertex>> rims;
    for (std::size_t r = 0; r < parts_.size(); ++r)
      for (std::size_t i = 0; i < parts_[r].rim.size(); ++i) {
        const Tile_place& p = parts_[r].rim_places[i];
        rims.emplace_back(p.x, p.y, in_whole(parts_[r].rim[i], first[r]));
      }
    std::sort(rims.begin(), rims.end());
    for (std::size_t i = 1; i < rims.size(); ++i) {
      const auto& [x, y, v] = rims[i - 1];
      if (std::get<0>(rims[i]) == x && std::get<1>(rims[i]) == y) kept[std::get<2>(rims[i])] = kept[v];
    }
    return kept;
  }

  static void copy(const Part& part, std::size_t first, const Indexed_vector<Ring_vertex, Ring_vertex>& kept,
                   Site_mesh<Geometry>& result) {
    for_each_index<ConcurrencyTag>(part.rings.size(), [&](std::size_t i) {
      result.mesh.points[Ring_vertex(first + i)] = part.points[i];
      Ring& r = result.mesh.ring(Ring_vertex(first + i));
      r = part.rings[i];
      r.block = 0;
      for (int k = 0; k < r.size; ++k) r.neighbor[std::size_t(k)] = kept[in_whole(r[k], first)];
    });
  }

  /// Makes the rings of the vertices on rims, of the triangles of all parts there.
  void close_rims(const std::vector<std::size_t>& first, const Indexed_vector<Ring_vertex, Ring_vertex>& kept,
                  Site_mesh<Geometry>& result) const {
    Indexed_vector<Ring_vertex, std::uint8_t> is_on_rim(first.back(), 0);
    for (std::size_t r = 0; r < parts_.size(); ++r)
      for (const Ring_vertex v : parts_[r].rim) is_on_rim[kept[in_whole(v, first[r])]] = 1;
    using Opposite_side = std::array<Ring_vertex, 2>;
    std::vector<std::pair<Ring_vertex, Opposite_side>> sides;
    for (std::size_t r = 0; r < parts_.size(); ++r)
      for (const auto& t : parts_[r].rim_triangles)
        for (std::size_t k = 0; k < 3; ++k) {
          const auto corner = [&](std::size_t i) { return kept[in_whole(t[i % 3], first[r])]; };
          if (is_on_rim[corner(k)] != 0) sides.push_back({corner(k), {corner(k + 1), corner(k + 2)}});
        }
    std::sort(sides.begin(), sides.end());
    std::vector<Opposite_side> around;
    for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
      around.clear();
      for (end = begin; end < sides.size() && sides[end].first == sides[begin].first; ++end)
        around.push_back(sides[end].second);
      result.mesh.set_ring(sides[begin].first, around);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_MESH_PARTS_H
