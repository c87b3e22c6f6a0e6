// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Errors about a graph, in the user's numbers and coordinates. The stages number vertices in shuffle order.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_INPUT_WORDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_INPUT_WORDS_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Open_ends.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/part_names.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/validate_pslg_2.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What is wrong with a graph, in words for its owner.
template <class Point>
class Input_words {
public:
  /// \param order the input vertex of each kernel vertex; looked at when an error is made
  /// \param before_use called before the graph is read, for callers that do not have it at hand
  Input_words(const Pslg_2<Point>& pslg, const Order& order, std::function<void()> before_use = {})
      : pslg_(pslg), order_(order), before_use_(std::move(before_use)) {}

  /// "vertex 3 (0.5, 0.25)", by its number in the input
  std::string vertex(std::size_t v) const { return vertex_text(pslg(), v); }
  /// The same, by its number in the kernel.
  std::string kernel_vertex(Vertex_id v) const { return vertex(std::size_t(of_input(v))); }

  /// For a vertex that has no place in the grid of quadtrees.
  Pslg_error_2 out_of_range(const Point_error& error) const {
    const std::size_t v(error.point());
    return {Pslg_error_2::Kind::OUT_OF_RANGE, vertex(v) + ' ' + error.reason(),
            Pslg_parts_2().vertex(Vertex_index(v))};
  }

  /// For a vertex or seed that the mesher's coordinates do not have.
  /// \param name the name of the point
  Pslg_error_2 out_of_range(const std::string& name, const std::string& reason, Pslg_parts_2 point) const {
    return {Pslg_error_2::Kind::OUT_OF_RANGE, name + ": " + reason, std::move(point)};
  }

  /// For vertices that are too far apart.
  /// \param limit the limit and its owner
  Pslg_error_2 too_wide(const std::string& limit) const {
    const auto& all = pslg().vertices;
    const auto x = std::minmax_element(all.begin(), all.end(),
                                       [](const Point& p, const Point& q) { return p.x() < q.x(); });
    const auto y = std::minmax_element(all.begin(), all.end(),
                                       [](const Point& p, const Point& q) { return p.y() < q.y(); });
    const bool is_wide = y.second->y() - y.first->y() < x.second->x() - x.first->x();
    const auto [low, high] = is_wide ? x : y;
    const auto a = static_cast<std::size_t>(low - all.begin()),
               b = static_cast<std::size_t>(high - all.begin());
    return {Pslg_error_2::Kind::OUT_OF_RANGE,
            "the coordinates span more than " + limit + ": from " + vertex(a) + " to " + vertex(b),
            Pslg_parts_2().vertex(Vertex_index(a)).vertex(Vertex_index(b))};
  }

  /// For kernel vertices that are too near to each other, or to being on a line.
  /// \param fault what is wrong with them
  template <class Vertices>
  Pslg_error_2 too_near(const Vertices& vertices, const std::string& fault) const {
    std::string text;
    Pslg_parts_2 parts;
    for (const Vertex_id v : vertices) {
      const bool is_last = parts.vertices.size() + 1 == std::size(vertices);
      text += (parts.vertices.empty() ? "" : is_last ? " and " : ", ") + kernel_vertex(v);
      parts.vertex(of_input(v));
    }
    return {Pslg_error_2::Kind::TOO_NEAR, text + fault, std::move(parts)};
  }

  /// For two input edges that cross.
  Pslg_crossing_error_2 crossing(const Edges_of_segments& edges, const Crossing& crossing) const {
    const Segment_index other = edges.find(crossing.a, crossing.b);
    return Pslg_crossing_error_2(segment(crossing.segment) + " crosses " + segment(other),
                                 {crossing.segment, other});
  }

  /// For a hole's or a region's point on a segment or vertex between components.
  Pslg_seed_error_2 ambiguous_seed(const Ambiguous_seed& seed, const Input_edges& edges) const {
    using Mark = Pslg_seed_error_2::Mark;
    const Mark mark = seed.of == Ambiguous_seed::Of::HOLE ? Mark::HOLE : Mark::REGION;
    if (seed.a == seed.b)
      return make_seed_error(pslg(), mark, seed.number, of_input(seed.a), Segment_index());
    const Edge_id e = edges.between(seed.a, seed.b);
    return make_seed_error(pslg(), mark, seed.number, Vertex_index(), edges[e].segment);
  }

  /// For a graph that asks for too many triangles.
  /// \param gap the narrow gap that asks for most of them
  /// \param unit of the input, in the coordinates of the gap
  template <class Gap>
  Pslg_gap_error_2 gap(const std::string& refusal, const Gap& gap, double unit) const {
    const auto name = [this](Segment_index s) { return segment_text(pslg(), std::size_t(s)); };
    return Pslg_gap_error_2(refusal, gap.in_words(name, unit), gap.segments(), ratio(gap.width(), unit));
  }
  /// The same where no gap is to blame.
  /// \param v the kernel vertex next to the triangles that are left
  Pslg_error_2 endless(const std::string& refusal, Vertex_id v) const {
    return {Pslg_error_2::Kind::TOO_MANY_TRIANGLES, refusal + " what is left is next to " + kernel_vertex(v),
            Pslg_parts_2().vertex(of_input(v))};
  }

  /// For a graph of which nothing is to be meshed. Names the ends where a border may be open.
  Pslg_error_2 no_domain(Quality_mesh_options_2::Domain rule, const Input_edges& edges) const {
    constexpr auto kind = Pslg_error_2::Kind::NO_DOMAIN;
    if (pslg().segments.empty()) return {kind, "there are no segments, so there is no domain to mesh"};
    if (edges.size() == 0) return {kind, "there is no domain to mesh: all segments have length 0"};
    Pslg_parts_2 parts;
    const std::string ends = open_ends_text(edges, parts);
    if (!has_ring(edges, order_.size()))
      return {kind, "the segments enclose no domain: no ring of them is closed" + ends, std::move(parts)};
    if (rule == Quality_mesh_options_2::Domain::MARKED)
      return {kind, "no domain: no region's point is in a component that segments enclose" + ends,
              std::move(parts)};
    return {kind, "no domain is left: all of its components have points of holes" + ends, std::move(parts)};
  }

private:
  const Pslg_2<Point>& pslg_;
  const Order& order_;
  std::function<void()> before_use_;

  const Pslg_2<Point>& pslg() const {
    if (before_use_) before_use_();
    return pslg_;
  }

  Vertex_index of_input(Vertex_id v) const { return Vertex_index(order_[v.value()]); }
  std::string segment(Segment_index s) const { return segment_text(pslg(), std::size_t(s)); }

  /// Where a border may be open, to go behind what is wrong; empty if each segment goes on at both ends.
  /// \param parts gets the vertices that are named
  std::string open_ends_text(const Input_edges& edges, Pslg_parts_2& parts) const {
    const std::vector<Vertex_index> ends = open_ends(edges, order_);
    if (ends.empty()) return "";
    parts.vertices = first_gap(ends, pslg().vertices);
    std::string text = "; " + vertex(std::size_t(parts.vertices[0])) + " is an end of one segment only";
    if (parts.vertices.size() == 2)
      text += ", the nearest other such end is " + vertex(std::size_t(parts.vertices[1]));
    return text;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_INPUT_WORDS_H
