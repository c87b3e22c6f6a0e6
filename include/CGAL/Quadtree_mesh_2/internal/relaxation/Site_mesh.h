// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A mesh on its way from tiles to a mesh of points. Some of its vertices, one for each site, have to move to
// their sites. All triangles have to get into a range of angles. Superfluous vertices then have to be
// removed.
//
// Separation on demand: vertices are moved, and the mesh is relaxed and repaired, first in blocks and then
// near their seams. The answer is the triangles that remain outside the range, and the sites at fault.
// Nothing is guaranteed here. The code that fills tiles knows when they are so small that no triangle can
// remain (Tile_forest.h). Expected O(n) work, not counting sorting.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_SITE_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_SITE_MESH_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Block_worker.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_blocks.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
struct Site_mesh {
  using Point = typename Geometry::Point;

  Ring_mesh<Geometry> mesh;
  std::vector<Point> sites;
  std::vector<Ring_vertex> vertex_of_site;
  /// By site: whether its vertex lies where it has to.
  std::vector<std::uint8_t> is_placed;

  /// \name Parts of meshes
  /// A part has a rim, at which others go on. The rings there are not whole.
  /// @{

  std::vector<Ring_vertex> rim;
  std::vector<std::array<Ring_vertex, 3>> rim_triangles; ///< with a vertex of the rim

  bool is_part() const { return !rim.empty(); }

  /// Nobody may write the corners of the triangles at the rim.
  void seal_rim() {
    for (const auto& t : rim_triangles)
      for (const Ring_vertex v : t) mesh.ring(v).block = Ring::sealed;
  }
  /// Nobody may write what will move when sites are placed that wait, here or across the rim.
  void seal_waiting() {
    std::vector<Ring_vertex> near;
    Indexed_vector<Ring_vertex, std::uint8_t> is_near(mesh.number_of_vertices(), 0);
    const auto add = [&](Ring_vertex v) {
      if (is_near[v] != 0) return;
      is_near[v] = 1;
      near.push_back(v);
    };
    for (const auto& t : rim_triangles)
      for (const Ring_vertex v : t) add(v);
    for (std::size_t s = 0; s < is_placed.size(); ++s)
      if (is_placed[s] == 0) add(vertex_of_site[s]);
    std::size_t begin = 0;
    for (int ring = 0; ring < rings_of_placing; ++ring)
      for (const std::size_t end = near.size(); begin < end; ++begin) {
        const Ring& r = mesh.ring(near[begin]);
        for (int k = 0; k < r.size; ++k) add(r[k]);
      }
    for (const Ring_vertex v : near) mesh.ring(v).block = Ring::sealed;
  }

  /// @}
};

template <class ConcurrencyTag, class Geometry>
class Site_mesh_relaxer {
public:
  Site_mesh_relaxer(Site_mesh<Geometry>& mesh, const Angle_range& range)
      : mesh_(mesh), range_(range), blocks_(mesh.mesh) {}

  /// Moves vertices to their sites and relaxes; in a part, those far from the rim. Returns, of the sites for which
  /// `may_be_blamed(site)` holds, those next to triangles outside the range.
  template <class May_be_blamed>
  std::vector<std::size_t> place_sites(const May_be_blamed& may_be_blamed) {
    for (int pass = 0; pass < Blocks::number_of_passes; ++pass) {
      cut(pass);
      place_in_blocks();
      if (blocks_.is_whole()) break;
    }
    if (!blocks_.is_whole() && is_anything_left()) {
      join();
      place_in_blocks();
    }
    return sites_to_blame(may_be_blamed);
  }

  /// Lets go of what was held, and removes vertices that are not needed. Calls `shall_go_on(share)` with the share of
  /// blocks done before each; where it returns false, blocks are left as they are.
  template <class Shall_go_on>
  void coarsen(const Coarsening_effort& effort, const Shall_go_on& shall_go_on) {
    for (Ring& r : mesh_.mesh.rings)
      if (r.mobility == Mobility::HELD) r.mobility = Mobility::FREE;
    if (effort.most_rings == 0) return;
    constexpr double first_share[Blocks::number_of_passes + 1] = {0, 0.7, 0.9, 1}; // of the work, about
    for (int pass = 0; pass < Blocks::number_of_passes; ++pass) {
      cut(pass);
      std::atomic<std::size_t> done{0};
      blocks_.for_each_block([&](const Ring_block& block, Marks& marks) {
        const double share = static_cast<double>(done++) / static_cast<double>(blocks_.number_of_blocks());
        if (shall_go_on(first_share[pass] + share * (first_share[pass + 1] - first_share[pass])))
          Block_worker<Geometry>(mesh_.mesh, marks, block, range_).coarsen(effort);
      });
      if (blocks_.is_whole()) return;
    }
  }

private:
  using Blocks = Ring_blocks<ConcurrencyTag, Geometry>;
  using Marks = typename Ring_patch<Geometry>::Marks;
  using Point = typename Geometry::Point;

  Site_mesh<Geometry>& mesh_;
  const Angle_range& range_;
  Blocks blocks_;

  void cut(int pass) {
    blocks_.cut(pass);
    follow();
  }
  void join() {
    blocks_.join();
    follow();
  }
  void follow() {
    for_each_index<ConcurrencyTag>(mesh_.vertex_of_site.size(), [&](std::size_t i) {
      mesh_.vertex_of_site[i] = blocks_.new_number(mesh_.vertex_of_site[i]);
    });
    for (Ring_vertex& v : mesh_.rim) v = blocks_.new_number(v);
    for (auto& t : mesh_.rim_triangles)
      for (Ring_vertex& v : t) v = blocks_.new_number(v);
  }

  void place_in_blocks() {
    const std::vector<std::vector<std::uint32_t>> sites = waiting_sites();
    blocks_.for_each_block([&](const Ring_block& block, Marks& marks) {
      Block_worker<Geometry> worker(mesh_.mesh, marks, block, range_);
      std::vector<std::pair<Ring_vertex, Point>> moves;
      for (const std::uint32_t s : sites[std::size_t(block.number)]) {
        if (!worker.is_well_inside(mesh_.vertex_of_site[s])) continue;
        moves.push_back({mesh_.vertex_of_site[s], mesh_.sites[s]});
        mesh_.is_placed[s] = 1;
      }
      worker.move_and_relax(moves);
      worker.repair();
    });
  }

  /// By block, the sites whose vertices are in it and not yet there.
  std::vector<std::vector<std::uint32_t>> waiting_sites() const {
    std::vector<std::vector<std::uint32_t>> result(blocks_.number_of_blocks());
    for (std::size_t s = 0; s < mesh_.sites.size(); ++s) {
      if (mesh_.is_placed[s] != 0) continue;
      const std::int32_t b = mesh_.mesh.ring(mesh_.vertex_of_site[s]).block;
      if (b >= 0) result[std::size_t(b)].push_back(static_cast<std::uint32_t>(s));
    }
    return result;
  }

  bool is_in_range(std::size_t v) const {
    return !mesh_.mesh.is_alive(Ring_vertex(v)) ||
           Star_vectors(mesh_.mesh, Ring_vertex(v)).is_in_range(range_);
  }
  std::vector<std::uint32_t> violated() const {
    return pack<ConcurrencyTag>(mesh_.mesh.number_of_vertices(),
                                [this](std::size_t v) { return !is_in_range(v); });
  }
  bool is_anything_left() const {
    if (!mesh_.is_part() && std::count(mesh_.is_placed.begin(), mesh_.is_placed.end(), 0) > 0) return true;
    return !violated().empty();
  }

  /// The sites nearest to violated triangles, in the number of edges.
  template <class May_be_blamed>
  std::vector<std::size_t> sites_to_blame(const May_be_blamed& may_be_blamed) const {
    const std::vector<std::uint32_t> bad = violated();
    std::vector<std::size_t> result;
    if (bad.empty()) return result;
    Indexed_vector<Ring_vertex, std::int32_t> site_of_vertex(mesh_.mesh.number_of_vertices(), -1);
    for (std::size_t s = 0; s < mesh_.sites.size(); ++s)
      if (may_be_blamed(s)) site_of_vertex[mesh_.vertex_of_site[s]] = static_cast<std::int32_t>(s);
    std::vector<std::uint8_t> is_blamed(mesh_.sites.size(), 0);
    Indexed_vector<Ring_vertex, std::uint32_t> reached_by(mesh_.mesh.number_of_vertices(), 0);
    std::uint32_t search = 0;
    for (const std::uint32_t v : bad)
      blame_nearest(Ring_vertex(v), ++search, site_of_vertex, reached_by, is_blamed);
    for (std::size_t s = 0; s < is_blamed.size(); ++s)
      if (is_blamed[s] != 0) result.push_back(s);
    return result;
  }

  void blame_nearest(Ring_vertex start, std::uint32_t search,
                     const Indexed_vector<Ring_vertex, std::int32_t>& site_of_vertex,
                     Indexed_vector<Ring_vertex, std::uint32_t>& reached_by,
                     std::vector<std::uint8_t>& is_blamed) const {
    std::vector<Ring_vertex> reached{start};
    reached_by[start] = search;
    bool is_found = false;
    for (std::size_t begin = 0; begin < reached.size() && !is_found;) {
      const std::size_t end = reached.size();
      for (std::size_t i = begin; i < end; ++i) {
        const std::int32_t s = site_of_vertex[reached[i]];
        if (s < 0) continue;
        is_blamed[std::size_t(s)] = 1;
        is_found = true;
      }
      for (; begin < end && !is_found; ++begin) {
        const Ring& r = mesh_.mesh.ring(reached[begin]);
        for (int k = 0; k < r.size; ++k) {
          if (reached_by[r[k]] == search) continue;
          reached_by[r[k]] = search;
          reached.push_back(r[k]);
        }
      }
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_SITE_MESH_H
