// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The chains of mesh edges along input segments, for the check of a mesh.
//
// The mesh itself says which edges make a chain: its constrained edges are linked, vertex by vertex. Geometry
// then judges, exactly. Each step has to lead ahead, and each vertex has to be within reach of the segment
// (Straight_segment.h). If a mesh has no constrained edges, a chain is searched among the edges that geometry
// allows. O(n log n) for n constrained edges. The search looks at each vertex near a segment once.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_CHAIN_FINDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_CHAIN_FINDER_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Half_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Mesh_error_log.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Straight_segment.h>
#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Chain_finder {
public:
  using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
  using Mesh = Indexed_mesh_2<Point>;
  using Pslg = Pslg_2<Point>;
  using Line = Straight_segment<Point>;
  using Chain = std::vector<std::uint32_t>;

  Chain_finder(const Mesh& mesh, const Pslg& pslg, const Mesh_quality_options_2& options,
               const Half_edges& half_edges, Mesh_error_log& log)
      : mesh_(mesh), pslg_(pslg), options_(options), half_edges_(half_edges), log_(log),
        segment_of_vertex_(mesh.points.size(), Half_edges::none) {
    if (has_constrained_edges()) link_constrained_edges();
  }

  Line line(Segment_index s) const {
    const auto& ends = pslg_.segments[std::size_t(s)];
    return Line(pslg_.point(ends[0]), pslg_.point(ends[1]), options_.coordinate_unit());
  }

  /// Says which constrained edges cannot be in chains.
  void report_links() {
    for (const std::size_t e : without_link_) {
      const auto& edge = mesh_.constrained_edges[e];
      if (has_range(edge))
        log_.add("constrained edge ", e, " (", edge.vertices[0], " ", edge.vertices[1],
                 ") is not an edge of the mesh");
      else
        log_.add("constrained edge ", e, " has an index that does not exist");
    }
  }

  /// \param piece a part of an input segment without an input vertex inside, in the segment's direction
  /// \param a,b the mesh vertices at its ends
  /// \returns the mesh vertices along it; none if there is no chain, which is an error.
  template <class Piece>
  Chain find(const Piece& piece, std::uint32_t a, std::uint32_t b) {
    Chain chain{a};
    if (has_constrained_edges() && follow_links(piece.segment, b, chain)) {
      check_vertices(piece.segment, chain);
      return chain;
    }
    chain = search(piece.segment, a, b);
    if (chain.empty()) {
      log_.add("input segment ", piece.segment, " is not a chain of mesh edges between vertices ", a, " and ",
               b);
      return chain;
    }
    if (has_constrained_edges())
      log_.add("not all edges of input segment ", piece.segment, " between vertices ", a, " and ", b,
               " are constrained edges of it");
    check_vertices(piece.segment, chain);
    return chain;
  }

  /// After all chains are found.
  void check_unused_constrained_edges() {
    for (std::size_t e = 0; e < is_used_.size(); ++e) {
      if (is_used_[e] != 0) continue;
      const auto& edge = mesh_.constrained_edges[e];
      log_.add("constrained edge ", e, " (", edge.vertices[0], " ", edge.vertices[1],
               ") is listed twice, or not in the chain of input segment ", edge.segment,
               ", or this is not the first one along it");
    }
  }

  /// Per vertex, the segment with a chain that it is inside of, `Half_edges::none` for none.
  const std::vector<std::uint32_t>& segment_of_vertex() const { return segment_of_vertex_; }

private:
  struct Link {
    std::uint32_t segment, from, to;
    std::size_t edge;
    friend bool operator<(const Link& a, const Link& b) {
      return std::tie(a.segment, a.from, a.edge) < std::tie(b.segment, b.from, b.edge);
    }
  };

  bool has_constrained_edges() const {
    return options_.check_arrays() == Mesh_quality_options_2::Arrays::ALL;
  }
  const Point& point(std::uint32_t v) const { return mesh_.points[v]; }
  bool is_input(std::uint32_t v) const { return v < pslg_.vertices.size(); }

  void link_constrained_edges() {
    is_used_.assign(mesh_.constrained_edges.size(), 0);
    links_.reserve(2 * is_used_.size());
    for (std::size_t e = 0; e < is_used_.size(); ++e) {
      const auto& edge = mesh_.constrained_edges[e];
      const std::uint32_t a = edge.vertices[0].value(), b = edge.vertices[1].value(),
                          s = edge.segment.value();
      if (has_range(edge) && half_edges_.is_edge(a, b)) {
        links_.push_back({s, a, b, e});
        links_.push_back({s, b, a, e});
      } else {
        without_link_.push_back(e);
        is_used_[e] = 1;
      }
    }
    std::sort(links_.begin(), links_.end());
  }

  /// Whether all that a constrained edge names exists.
  bool has_range(const Mesh::Constrained_edge& edge) const {
    return std::size_t(edge.vertices[0]) < mesh_.points.size() &&
           std::size_t(edge.vertices[1]) < mesh_.points.size() &&
           std::size_t(edge.segment) < pslg_.segments.size();
  }

  /// \param[in,out] chain from its first vertex on
  /// \returns whether it reaches `b`.
  bool follow_links(Segment_index segment, std::uint32_t b, Chain& chain) {
    const Line along = line(segment);
    std::vector<std::size_t> used;
    while (chain.back() != b) {
      const std::uint32_t v = chain.back();
      auto link = std::lower_bound(links_.begin(), links_.end(), Link{segment.value(), v, 0, 0});
      const auto is_here = [&] {
        return link != links_.end() && link->segment == segment.value() && link->from == v;
      };
      while (is_here() && (is_used_[link->edge] != 0 || !along.is_ahead(point(v), point(link->to)))) ++link;
      if (!is_here()) return false;
      used.push_back(link->edge);
      chain.push_back(link->to);
    }
    for (std::size_t e : used) is_used_[e] = 1;
    return true;
  }

  void check_vertices(Segment_index segment, const Chain& chain) {
    const Line along = line(segment);
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const std::uint32_t v = chain[i];
      if (is_input(v)) {
        log_.add("input vertex ", v, " is on the chain of input segment ", segment,
                 ", but not on the segment");
        continue;
      }
      if (!along.passes_by(point(v)))
        log_.add("vertex ", v, " is not on input segment ", segment, ", by more than rounding");
      if (segment_of_vertex_[v] != Half_edges::none)
        log_.add("input segments ", segment_of_vertex_[v], " and ", segment, " meet at vertex ", v,
                 ", which is none of the input's");
      segment_of_vertex_[v] = segment.value();
    }
  }

  /// Depth first, the nearest neighbors ahead first; no vertex is looked at twice.
  Chain search(Segment_index segment, std::uint32_t a, std::uint32_t b) const {
    const Line along = line(segment);
    Chain chain{a};
    std::unordered_set<std::uint32_t> seen{a};
    std::vector<std::vector<std::uint32_t>> open{neighbors_ahead(along, a, b, seen)};
    while (chain.back() != b) {
      if (open.back().empty()) {
        open.pop_back(), chain.pop_back();
        if (chain.empty()) return chain;
        continue;
      }
      chain.push_back(open.back().back());
      open.back().pop_back();
      open.push_back(neighbors_ahead(along, chain.back(), b, seen));
    }
    return chain;
  }

  /// Those that may follow `v` on the way to `b`, the nearest one last.
  std::vector<std::uint32_t> neighbors_ahead(const Line& along, std::uint32_t v, std::uint32_t b,
                                             std::unordered_set<std::uint32_t>& seen) const {
    std::vector<std::uint32_t> ahead;
    half_edges_.for_each_neighbor(v, [&](std::uint32_t w) {
      if (!along.is_ahead(point(v), point(w)) || (w != b && (is_input(w) || !along.passes_by(point(w)))) ||
          (w != b && !along.is_ahead(point(w), point(b))))
        return;
      if (seen.insert(w).second) ahead.push_back(w);
    });
    std::sort(ahead.begin(), ahead.end(),
              [&](std::uint32_t w, std::uint32_t x) { return along.is_ahead(point(x), point(w)); });
    return ahead;
  }

  const Mesh& mesh_;
  const Pslg& pslg_;
  const Mesh_quality_options_2& options_;
  const Half_edges& half_edges_;
  Mesh_error_log& log_;
  std::vector<Link> links_;
  std::vector<char> is_used_; // by constrained edge
  std::vector<std::size_t> without_link_;
  std::vector<std::uint32_t> segment_of_vertex_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_CHAIN_FINDER_H
