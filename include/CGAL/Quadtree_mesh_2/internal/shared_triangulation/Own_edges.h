// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The edges that segments become, of those whose lesser vertex is of a part's run (Own_stars.h).
//
// Computes: how many there are, an edge counted for each segment along it; and those that somebody who has the segments
//           does not know: the edges of segments that vertices cut, and of those that run along edges of others.
// Bound:    O(s) for s segments and pieces at the run on average, and O(s log s) if any edge has several segments.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_EDGES_H

#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Own_stars.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// An edge of a segment, by the numbers of its vertices, the lesser one first.
struct Told_edge {
  Segment_index segment;
  Vertex_id a, b;
  std::uint32_t is_whole;    ///< it is all of the segment
  std::uint32_t is_repeated; ///< another segment is the first one along it

  friend bool operator<(const Told_edge& p, const Told_edge& q) {
    // the first segment along an edge is one that is all of it, if there is any
    return std::tuple(p.a, p.b, 1 - p.is_whole, p.segment) < std::tuple(q.a, q.b, 1 - q.is_whole, q.segment);
  }
};

template <class ConcurrencyTag, class Geometry>
class Own_edges {
public:
  using Stars = Own_stars<ConcurrencyTag, Geometry>;
  using Graph = Kernel_graph<Geometry>;
  using Mesh = Kernel_mesh<Geometry>;

  Own_edges(const Graph& graph, const Stars& stars) : graph_(graph), mesh_(stars.mesh()), stars_(stars) {
    for (std::size_t s = 0; s < graph.segments.size(); ++s) add(Segment_index(s));
    if (number_ != number_of_edges()) find_repeated();
  }

  /// How many there are, of all segments.
  std::size_t number() const { return number_; }
  /// Those that the segments do not tell: of segments that are several edges, and repeated ones.
  const std::vector<Told_edge>& told() const { return told_; }

private:
  const Graph& graph_;
  const Mesh& mesh_;
  const Stars& stars_;
  std::size_t number_ = 0;
  std::vector<Told_edge> told_;

  bool is_own(Vertex_id a, Vertex_id b) const { return stars_.own().has(std::min(a, b)); }

  void add(Segment_index s) {
    const auto& [a, b] = graph_.segments[std::size_t(s)];
    if (a == b || !stars_.is_in(s)) return;
    const Vertex_id x = stars_.local(a), y = stars_.local(b);
    if (!mesh_.find_side(x, y).is_border())
      number_ += is_own(a, b) ? 1 : 0;
    else
      add_pieces(s, x, y);
  }

  /// Goes along a segment from both ends, in step around the vertices there: one of them may be a hub.
  void add_pieces(Segment_index s, Vertex_id from, Vertex_id to) {
    while (from != to) {
      Fan_walk<Mesh> at_from(mesh_, from), at_to(mesh_, to);
      Vertex_id next = next_on_way(at_from, from, to), before = next_on_way(at_to, to, from);
      while (!next.is_valid() && !before.is_valid()) {
        const bool has_more = at_from.advance(), other_has_more = at_to.advance();
        if (!has_more && !other_has_more) throw std::logic_error("a segment is not in a triangulation");
        next = next_on_way(at_from, from, to), before = next_on_way(at_to, to, from);
      }
      if (next.is_valid())
        add_piece(s, std::exchange(from, next), next);
      else
        add_piece(s, std::exchange(to, before), before);
    }
  }
  void add_piece(Segment_index s, Vertex_id v, Vertex_id w) {
    const Vertex_id a = mesh_.input_number(v), b = mesh_.input_number(w);
    if (is_own(a, b)) told_.push_back({s, std::min(a, b), std::max(a, b), 0, 0}), ++number_;
  }

  /// The first vertex after another one on a segment that ends at a third one, if the triangle of the walk has it.
  Vertex_id next_on_way(const Fan_walk<Mesh>& walk, Vertex_id from, Vertex_id to) const {
    const auto& r = mesh_.triangle(walk.triangle());
    const Vertex_id v = r.v[next_slot[walk.slot()]];
    if (!r.side[previous_slot[walk.slot()]].is_constrained() || mesh_.orientation(from, v, to) != 0)
      return {};
    Place_box<typename Geometry::Point> box{mesh_.point(from), mesh_.point(from)};
    box.add(mesh_.point(to));
    return do_meet(box, {mesh_.point(v), mesh_.point(v)}) ? v : Vertex_id();
  }

  /// The constrained edges of the triangulation with their lesser vertex in the run. All triangles at it are there.
  std::size_t number_of_edges() const {
    return reduce<ConcurrencyTag>(
        mesh_.triangles.size(), std::size_t(0),
        [this](std::size_t begin, std::size_t end) {
          std::size_t found = 0;
          for (const Triangle_id t : Id_range<Triangle_id>(begin, end))
            for (int k = 0; k < 3; ++k) {
              const Side s(t, k);
              if (!mesh_.across(s).is_constrained() || mesh_.across(s).is_border()) continue;
              const Vertex_id a = mesh_.input_number(mesh_.source(s)),
                              b = mesh_.input_number(mesh_.target(s));
              found += a < b && stars_.own().has(a) ? 1 : 0;
            }
          return found;
        },
        std::plus<>());
  }

  /// Lists what is repeated, also of segments that are one edge.
  void find_repeated() {
    std::vector<Told_edge> all = std::move(told_);
    for (std::size_t s = 0; s < graph_.segments.size(); ++s) {
      const auto& [a, b] = graph_.segments[s];
      const Vertex_id x = stars_.local(a), y = stars_.local(b);
      if (a != b && is_own(a, b) && !mesh_.find_side(x, y).is_border())
        all.push_back({Segment_index(s), std::min(a, b), std::max(a, b), 1, 0});
    }
    std::sort(all.begin(), all.end());
    told_.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
      Told_edge& p = all[i];
      p.is_repeated = i > 0 && all[i - 1].a == p.a && all[i - 1].b == p.b ? 1 : 0;
      if (p.is_repeated != 0 || p.is_whole == 0) told_.push_back(p);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_EDGES_H
