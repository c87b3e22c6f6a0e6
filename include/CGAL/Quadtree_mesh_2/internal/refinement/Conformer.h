// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Splits constrained edges that are not Delaunay.
//
// Computes: the constrained edges with a vertex in sight in their diametral circle. If there is any, the third vertex
//           of a triangle beside the edge is one, so it sees the edge under an obtuse angle. Each of them is split.
//           Without such edges, all triangles of a constrained Delaunay triangulation are Delaunay, and no circumcenter
//           is beyond the border.
// Bound:    O(n) for n triangles, in parallel, besides the splits, one after the other.
// Source:   Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation" (1995): encroached
//           subsegments.
// Deviates: only at the end, when all else is done, so that edges are not split for vertices that are removed later. A
//           split goes where the corner at an end of the edge needs it (Splitter.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_CONFORMER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_CONFORMER_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Conformer {
public:
  Conformer(Meshing_state<Geometry>& state, Splitter<Geometry>& splitter)
      : state_(state), mesh_(state.mesh), splitter_(splitter) {}

  /// Splits each encroached edge once, while the mesh has fewer vertices than the limit. Triangles that may miss a
  /// bound then are on the worklist.
  /// \returns whether there was an edge that could be split
  bool split_encroached(std::size_t most_vertices) {
    bool is_any_split = false;
    for (const Side s : encroached_sides()) {
      if (mesh_.number_of_vertices() >= most_vertices) break;
      if (mesh_.is_alive(s.triangle()) && is_encroached(s)) is_any_split |= split(s);
    }
    state_.legalize();
    return is_any_split;
  }

  /// How many edges are encroached.
  std::size_t number_of_encroached() const {
    std::size_t n = 0;
    for (const Side s : encroached_sides()) {
      const Side o = mesh_.across(s); // an edge may be so from both sides, and counts from the first one
      n += o.is_border() || s.triangle() < o.triangle() || !is_encroached(o) ? 1 : 0;
    }
    return n;
  }

private:
  using Number = typename Geometry::Number;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Splitter<Geometry>& splitter_;

  struct Part {
    std::vector<Side> sides;
  };

  std::vector<Side> encroached_sides() const {
    const std::size_t n = mesh_.triangles.size();
    std::vector<Part> parts((n + default_block - 1) / default_block);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      mesh_.for_each_alive({begin, end}, [&](Triangle_id t) {
        for (int k = 0; k < 3; ++k)
          if (is_encroached(Side(t, k))) parts[b].sides.push_back(Side(t, k));
      });
    });
    std::vector<Side> all;
    append_all<ConcurrencyTag>(
        all, parts, [](const Part& part) -> const auto& { return part.sides; });
    return all;
  }

  /// A piece that matches a vertex of another edge is not to be much shorter than the other one, as halves come nearer
  /// to the vertex, but where there are no halves. Halves are at new radii, which other edges have to match.
  bool split(Side s) {
    constexpr double least_share = 0.02;
    return split_to_match(s, least_share) ||
           splitter_.split(s.triangle(), s.slot(), nullptr, Asker::ORDINARY) == Outcome::CHANGED ||
           split_to_match(s, 0) || split_at_end(s);
  }

  bool split_to_match(Side s, double least_share) {
    const Edge_id e = state_.edges.carrying(mesh_, mesh_.source(s), mesh_.target(s));
    return e.is_valid() && (split_to_match(s, e, 0, least_share) || split_to_match(s, e, 1, least_share));
  }

  /// If the third vertex of the side's triangle lies on another edge with the same end, splits the side as far from
  /// this end as that vertex is: then neither edge has vertices in the circles of the other there, as each circle is
  /// between those around the end through the ends of its piece.
  /// \param least_share of the side, that is not to be cut off
  bool split_to_match(Side s, Edge_id e, std::size_t end, double least_share) {
    const Vertex_id v = mesh_.triangle(s.triangle()).v[s.slot()];
    const Vertex_id apex = end == 0 ? state_.edges[e].a : state_.edges[e].b;
    if (!is_on_edge_from(apex, v)) return false;
    const auto radius = [&](Vertex_id x) {
      return length(Geometry::scaled_difference(mesh_.point(x), state_.problem.input_point(apex)));
    };
    const Number r = radius(v), p = radius(mesh_.source(s)), q = radius(mesh_.target(s));
    const Number low = lesser(p, q), high = greater(p, q), least = least_share * (high - low);
    return low < r && r < high && r - low >= least && high - r >= least && splitter_.split_at(s, e, end, r);
  }

  /// Splits a side at an end of its edge where the splitter does not, as for angles there might be no end of it. Here
  /// there is: each end gets at most 33 such pieces, as they become no shorter than a share of the edge.
  bool split_at_end(Side s) {
    constexpr double share = 0.6, least_share_of_edge = 0x1p-24;
    const Edge_id e = state_.edges.carrying(mesh_, mesh_.source(s), mesh_.target(s));
    if (!e.is_valid()) return false;
    const auto &a = state_.problem.input_point(state_.edges[e].a),
               &b = state_.problem.input_point(state_.edges[e].b);
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
      const auto radius = [&](Vertex_id x) {
        return length(Geometry::scaled_difference(mesh_.point(x), end == 0 ? a : b));
      };
      const Number p = radius(mesh_.source(s)), q = radius(mesh_.target(s)), r = share * greater(p, q);
      if (lesser(p, q) == 0 && r >= least_share_of_edge * length(Geometry::scaled_difference(b, a)))
        return splitter_.split_at(s, e, end, r);
    }
    return false;
  }

  /// Whether v lies on an edge that ends at an input vertex.
  bool is_on_edge_from(Vertex_id end, Vertex_id v) const {
    if (mesh_.is_input(v)) return state_.edges.between(end, mesh_.input_number(v)).is_valid();
    if (!mesh_.edge(v).is_valid()) return false;
    const Input_edge& edge = state_.edges[mesh_.edge(v)];
    return edge.a == end || edge.b == end;
  }

  /// Whether the third vertex of its triangle is within the circle of a constrained side. If doubles cannot tell, what
  /// counts is whether the side is Delaunay, exactly.
  bool is_encroached(Side s) const {
    const auto& r = mesh_.triangle(s.triangle());
    const Side o = r.side[s.slot()];
    if (!o.is_constrained()) return false;
    const auto shape = mesh_.shape(r);
    if (shape.is_certainly_acute(s.slot())) return false;
    if (shape.is_certainly_obtuse(s.slot())) return true;
    return !o.is_border() && Geometry::is_in_circle(mesh_.point(r.v[0]), mesh_.point(r.v[1]),
                                                    mesh_.point(r.v[2]), mesh_.point(mesh_.opposite(o)));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_CONFORMER_H
