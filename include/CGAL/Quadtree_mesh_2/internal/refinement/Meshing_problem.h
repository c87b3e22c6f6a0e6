// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_PROBLEM_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_PROBLEM_H

#include <CGAL/Quadtree_mesh_2/internal/base/Sparse_values.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Acute_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Bounds.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Edge_room.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/kept_edges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What is the same for the whole mesh and all its blocks.
template <class Geometry>
struct Meshing_problem {
  using Point = typename Geometry::Point;
  using Points = Uninitialized_indexed_vector<Vertex_id, Point>;

  Points input_points;         ///< by input number; none while a mesh lends its own
  Vertex_blocks vertex_blocks; ///< in which a large mesh is refined
  Input_edges edges;
  Kept_edges kept_edges; ///< which of them get no vertices; empty: none
  Acute_corners<Geometry> corners;
  Bounds<Geometry> bounds;
  /// Features of the input nearer to a vertex than this share of an edge at it are none that legs are cut for.
  typename Geometry::Number least_share_of_leg = 0;

  bool keeps_edges() const { return !kept_edges.empty(); }
  bool is_kept(Edge_id e) const { return keeps_edges() && kept_edges[e].is_valid(); }

  std::size_t number_of_input_points() const { return lent_ != nullptr ? number_lent_ : input_points.size(); }
  Span<Point> input_places() const {
    const Point* const first = lent_ != nullptr ? lent_->data() : input_points.data();
    return {first, first + number_of_input_points()};
  }
  /// Numbers of the machine are copied, as those of a mesh move when it grows.
  std::conditional_t<std::is_trivially_copyable_v<Point>, Point, const Point&>
  input_point(Vertex_id number) const {
    return lent_ != nullptr ? (*lent_)[number] : input_points[number];
  }

  /// From now on the points are the first ones of a mesh, which has to keep them there.
  void borrow_points(const Points& of_mesh, std::size_t number) {
    free_arrays(input_points);
    lent_ = &of_mesh, number_lent_ = number;
  }
  /// Copies the points if a mesh lends them, which need not keep them any more.
  void keep_points_apart() {
    if (lent_ == nullptr) return;
    input_points.resize(number_lent_);
    for_each_index<Chosen_tag>(number_lent_, [this](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      input_points[v] = (*lent_)[v];
    });
    lent_ = nullptr;
  }
  void forget_points() {
    free_arrays(input_points);
    lent_ = nullptr;
  }

  Vertex_id nearest_input_vertex(const Point& p) const {
    const auto distance2 = [&p](const auto& q) { return squared_length(Geometry::scaled_difference(q, p)); };
    const Span<Point> places = input_places();
    const auto nearest = std::min_element(places.begin(), places.end(), [&](const auto& a, const auto& b) {
      return distance2(a) < distance2(b);
    });
    return static_cast<Vertex_id>(nearest - places.begin());
  }

  /// Writes or reads what does not follow from the input and the options alone (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(edges, kept_edges);
    if (Archive::is_reading) corners.prepare(edges, 0);
    archive(corners, least_share_of_leg, outer_of_edge_);
  }

  /// Frees what is as long as the graph, for who needs it no more.
  void forget_graph() {
    forget_points();
    free_arrays(edges, outer_of_edge_, corners);
  }

  /// \param outer the triangles outside along the border
  void set_outside(const std::vector<Outer_triangle>& outer) {
    Uninitialized_vector<Edge_id> edge(outer.size());
    for_each_index<Chosen_tag>(outer.size(),
                               [&](std::size_t i) { edge[i] = edges.between(outer[i].a, outer[i].b); });
    outer_of_edge_ = Sparse_values<Edge_id, Outer>(edges.size());
    for (std::size_t i = 0; i < outer.size(); ++i) // no two are at one edge
      outer_of_edge_.at(edge[i]) = Outer(outer[i].apex, outer[i].b < outer[i].a);
  }

  /// The input vertex that faces an edge at the border from the outside, if there is one.
  Vertex_id outer_vertex(Edge_id e) const { return outer_of_edge_[e].apex(); }

  /// The triangle outside at an edge of the border; one without an apex if there is none.
  Outer_triangle outer_triangle(Edge_id e) const {
    const Outer outer = outer_of_edge_[e];
    const Input_edge& edge = edges[e];
    return outer.is_from_greater() ? Outer_triangle{edge.b, edge.a, outer.apex()}
                                   : Outer_triangle{edge.a, edge.b, outer.apex()};
  }

  /// Whether p, a rounded point of an edge, stays clear of what is outside of the border. The mesh does not know it.
  bool is_clear_of_outside(Edge_id e, const Point& p) const {
    if constexpr (Geometry::has_unlimited_coordinates) {
      static_cast<void>(e), static_cast<void>(p); // what is made on an edge lies on it
      return true;
    } else {
      if (!outer_vertex(e).is_valid()) return true;
      const Outer_triangle t = outer_triangle(e);
      const auto a = input_point(t.a), b = input_point(t.b);
      return Edge_room<Geometry>(a, b, input_point(t.apex)).has(a, b, p);
    }
  }

private:
  /// What an edge does not say of the triangle outside, in 4 bytes.
  class Outer {
  public:
    Outer() = default;
    Outer(Vertex_id apex, bool is_from_greater)
        : bits_(apex.value() << 1 | static_cast<std::uint32_t>(is_from_greater)) {}

    Vertex_id apex() const { return bits_ == none ? Vertex_id() : Vertex_id(bits_ >> 1); }
    /// Whether the outside is on the left of the way from the edge's greater vertex to the other.
    bool is_from_greater() const { return (bits_ & 1) != 0; }

  private:
    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
    std::uint32_t bits_ = none;
  };

  const Points* lent_ = nullptr; // by a mesh
  std::size_t number_lent_ = 0;
  Sparse_values<Edge_id, Outer> outer_of_edge_; // none where it is not at the border, or has nothing beyond
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_PROBLEM_H
