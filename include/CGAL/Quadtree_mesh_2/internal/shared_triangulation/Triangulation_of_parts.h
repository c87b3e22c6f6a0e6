// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The first triangulation (First_triangulation.h) of a graph that all parts know, each part with its own triangles.
//
// Computes: the canonical triangulation, with the handles of Kept_triangles.h. A part has the triangles whose least
//           vertex is in its run of the vertices. Runs have the same number of vertices.
// Bound:    that of Own_stars.h for each part, and messages for the triangles at seams alone.
// Method:   Parts find their stars alone. They tell each other how many triangles they have, from which all know their
//           handles. A side at a seam is told to the part of its lesser end, which tells both halves of each other.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_TRIANGULATION_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_TRIANGULATION_OF_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Own_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Own_stars.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Own_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Part_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Seed_finder.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Exchange, class Geometry>
class Triangulation_of_parts {
public:
  using Graph = Kernel_graph<Geometry>;
  using Point = typename Geometry::Point;
  using Part = Part_triangles<Geometry>;

  static constexpr std::size_t number_of_auxiliary_vertices =
      First_triangulation<ConcurrencyTag, Geometry>::number_of_auxiliary_vertices;

  /// \param graph the same at all parts, with a vertex at least
  Triangulation_of_parts(Exchange& exchange, const Graph& graph) : exchange_(exchange), graph_(graph) {}

  /// All parts call it.
  /// \param holes, regions places of which this part finds the triangles
  /// \returns false, at all parts, if it was not done: segments cross, for example
  bool run(const std::vector<Point>& holes, const std::vector<Point>& regions) {
    std::optional<Stars> stars;
    std::optional<Own_triangles<Geometry>> own;
    bool is_done = false;
    agree_on_work(exchange_, [&] {
      stars.emplace(graph_, box(), run_of(exchange_.rank()));
      if (!stars->run()) return;
      const Own_edges<ConcurrencyTag, Geometry> edges(graph_, *stars);
      number_of_pieces_ = edges.number(), pieces_ = edges.told();
      own.emplace(stars->mesh(), run_of(exchange_.rank()));
      const Seed_finder<Geometry> finder(stars->mesh(), *own);
      holes_ = finder.find(holes), regions_ = finder.find(regions);
      is_done = !holes_.is_any_doubtful && !regions_.is_any_doubtful;
    });
    if (exchange_.min(is_done ? 1 : 0) == 0) return false;
    name_parts(own->size());
    std::vector<Open_side> open;
    agree_on_work(exchange_, [&] {
      part_.triangles = own->named_from(part_.begin, open);
      for (Open_side& s : open) s.slot |= own->is_constrained(s, part_.begin) ? constrained_ : 0u;
      for (std::size_t k = 0; k < number_of_auxiliary_vertices; ++k)
        auxiliary_[k] = stars->mesh().point(auxiliary_vertex(*stars, k));
      own.reset(), stars.reset();
    });
    return close(open);
  }

  /// The triangles of this part, by the numbers of vertices.
  Part& part() { return part_; }
  const Seeds_found& holes() const { return holes_; }
  const Seeds_found& regions() const { return regions_; }
  /// The place of a vertex. The auxiliary ones follow on those of the graph.
  const Point& point(Vertex_id v) const {
    return v < first_auxiliary() ? graph_.points[v] : auxiliary_[std::size_t(v) - graph_.number_of_vertices];
  }
  Vertex_id first_auxiliary() const { return Vertex_id(graph_.number_of_vertices); }
  /// How many edges segments become whose lesser vertex is in this part's run, those along several counted for each of
  /// them; and those that do not follow from the segments.
  std::size_t number_of_pieces() const { return number_of_pieces_; }
  const std::vector<Told_edge>& pieces() const { return pieces_; }

private:
  using Stars = Own_stars<ConcurrencyTag, Geometry>;
  static constexpr std::uint32_t constrained_ = 4; // in a slot

  Exchange& exchange_;
  const Graph& graph_;
  Part part_;
  Seeds_found holes_, regions_;
  std::array<Point, number_of_auxiliary_vertices> auxiliary_;
  std::size_t number_of_pieces_ = 0;
  std::vector<Told_edge> pieces_;

  /// Two halves of a side, told to the part of the first one.
  struct Pair {
    Open_side here, there;
  };

  Place_box<Point> box() const {
    Place_box<Point> box{graph_.points[Vertex_id(0)], graph_.points[Vertex_id(0)]};
    for (const Vertex_id v : Id_range<Vertex_id>(0, graph_.number_of_vertices)) box.add(graph_.points[v]);
    return box;
  }

  std::size_t first_vertex(int part) const {
    return graph_.number_of_vertices * static_cast<std::size_t>(part) /
           static_cast<std::size_t>(exchange_.size());
  }
  Vertex_run run_of(int part) const { return {first_vertex(part), first_vertex(part + 1)}; }
  /// The part in whose run a vertex is; the last one for auxiliary vertices.
  int part_of(Vertex_id v) const {
    int part = 0;
    while (part + 1 < exchange_.size() && !(std::size_t(v) < first_vertex(part + 1))) ++part;
    return part;
  }

  Vertex_id auxiliary_vertex(const Stars& stars, std::size_t k) const {
    const Kernel_mesh<Geometry>& mesh = stars.mesh();
    for (const Vertex_id v : mesh.points.ids())
      if (mesh.input_number(v) == Vertex_id(graph_.number_of_vertices + k)) return v;
    throw std::logic_error("a triangulation without auxiliary vertices");
  }

  void name_parts(std::size_t own) {
    const auto size = static_cast<std::int64_t>(own);
    part_.begin = static_cast<std::size_t>(exchange_.exclusive_scan(size));
    part_.first = exchange_.gather(static_cast<std::int64_t>(part_.begin));
    part_.first.push_back(exchange_.sum(size));
  }

  /// Fills in what is across the open sides of all parts.
  /// \returns false, at all parts, if it is not told for each of them: then parts have different triangulations
  bool close(const std::vector<Open_side>& open) {
    Records_of_parts<Open_side> outbox;
    for (const Open_side& s : open) outbox[part_of(s.a)].push_back(s);
    std::vector<Open_side> halves = exchange_and_join(exchange_, std::move(outbox));
    std::sort(halves.begin(), halves.end());
    Records_of_parts<Pair> pairs;
    bool is_right = halves.size() % 2 == 0;
    for (std::size_t i = 0; i + 1 < halves.size(); i += 2) {
      is_right = is_right && !(halves[i] < halves[i + 1]);
      pairs[part_.part_of(halves[i].triangle)].push_back({halves[i], halves[i + 1]});
      pairs[part_.part_of(halves[i + 1].triangle)].push_back({halves[i + 1], halves[i]});
    }
    for (const Pair& p : exchange_and_join(exchange_, std::move(pairs)))
      part_.triangles[part_.place(p.here.triangle)].side[p.here.slot & 3] =
          Side(p.there.triangle, static_cast<int>(p.there.slot & 3), (p.here.slot & constrained_) != 0);
    return exchange_.min(is_right ? 1 : 0) == 1;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_TRIANGULATION_OF_PARTS_H
