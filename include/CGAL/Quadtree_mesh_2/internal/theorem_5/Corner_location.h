// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where corners of leaves are in the domain.
//
// Computes: for each corner the triangle that has it, in the constrained Delaunay triangulation of the domain; none for
//           those outside.
// Bound:    O(1) for each piece of an edge in a leaf, for each edge and triangle at a vertex that is the nearest
//           feature of a corner, for each leaf without pieces, and each triangle between a corner and its nearest
//           feature. All at the same time but for leaves without pieces, which are passed once.
// Source:   ours.
//
// - In a leaf that edges pass, a corner sees the point of their pieces that is nearest to it. A walk begins there: in
//   the triangle on this side of the edge, or, at the end of an edge, in the triangle that has the way to the corner.
// - A leaf without pieces has its lower left corner in common with the leaf to the left of it, which is before it in
//   shuffle order. No edge is between corners of such a leaf.
//
// Distances are rounded. So where edges touch, a walk may begin on the wrong side of one. It ends at the border then,
// and the corner is taken for one outside.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CORNER_LOCATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CORNER_LOCATION_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Placement_scope.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Tree_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Near_segment.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class ConcurrencyTag>
class Corner_location {
public:
  using Trees = Separation_trees<Traits, ConcurrencyTag>;
  using Geometry = typename Trees::Geometry;
  using Corners = Tree_corners<typename Trees::Tree>;
  using Name = typename Corners::Name;

  /// All are kept by reference, but for the scope.
  /// \param scope the leaves that own corners to be located
  Corner_location(const Meshing_problem<Geometry>& problem, const Trees& trees, const Corners& corners,
                  const Edge_triangles<Geometry>& triangles, const Placement_scope& scope)
      : problem_(problem), trees_(trees), corners_(corners), triangles_(triangles), mesh_(triangles.mesh()) {
    if (scope.is_all)
      locate_empty_leaves();
    else
      locate_empty_leaves_of(scope);
  }

  /// The triangle that has a corner, or none.
  /// \pre the corner exists, and belongs to a leaf of the scope
  Triangle_id operator()(Name c) const {
    const Leaf_index l = leaf_with_pieces(c), own = Corners::leaf_of(c);
    return l.is_valid() ? locate_by_pieces(c, l) : locate_by_corner(c, lower_left(own), at_lower_left_[own]);
  }

private:
  using Point = typename Geometry::Point;

  const Meshing_problem<Geometry>& problem_;
  const Trees& trees_;
  const Corners& corners_;
  const Edge_triangles<Geometry>& triangles_;
  const Kernel_mesh<Geometry>& mesh_;
  Indexed_vector<Leaf_index, Triangle_id> at_lower_left_; // of leaves without pieces

  bool has_pieces(Leaf_index l) const { return !trees_.pieces_in_leaves()[l].empty(); }

  /// The first of the leaves around a corner that edges pass.
  Leaf_index leaf_with_pieces(Name c) const {
    for (const Leaf_index l : corners_.leaves_around(c))
      if (l.is_valid() && has_pieces(l)) return l;
    return Leaf_index();
  }

  Name lower_left(Leaf_index l) const { return corners_.name(l, Leaf_corner::LOWER_LEFT); }
  Point place(Name c) const { return trees_.kernel_point(corners_.place(c)); }

  void locate_empty_leaves() {
    const std::size_t n = trees_.tree().number_of_leaves();
    at_lower_left_.resize(n);
    std::vector<Leaf_index> before(n); // of leaves that are located from another one
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      const Leaf_index l(i);
      if (has_pieces(l)) return;
      const Name c = lower_left(l);
      const Leaf_index other = leaf_with_pieces(c);
      if (other.is_valid())
        at_lower_left_[l] = locate_by_pieces(c, other);
      else
        before[i] = corners_.leaves_around(c)[1];
    });
    for (std::size_t i = 0; i < n; ++i)
      if (before[i].is_valid())
        at_lower_left_[Leaf_index(i)] =
            locate_by_corner(lower_left(Leaf_index(i)), lower_left(before[i]), at_lower_left_[before[i]]);
  }

  /// The same for those of a part. Each is reached from leaves to the left of it.
  void locate_empty_leaves_of(const Placement_scope& scope) {
    at_lower_left_.resize(trees_.tree().number_of_leaves());
    Indexed_vector<Leaf_index, char> is_located(at_lower_left_.size(), 0);
    std::vector<Leaf_index> way;
    for (const Leaf_index wanted : scope.leaves) {
      way.clear();
      for (Leaf_index l = wanted; l.is_valid() && !has_pieces(l) && is_located[l] == 0;) {
        way.push_back(l);
        is_located[l] = 1;
        const Leaf_index other = leaf_with_pieces(lower_left(l));
        if (other.is_valid()) {
          at_lower_left_[l] = locate_by_pieces(lower_left(l), other);
          way.pop_back();
          break;
        }
        l = corners_.leaves_around(lower_left(l))[1];
      }
      for (; !way.empty(); way.pop_back()) {
        const Leaf_index l = way.back(), before = corners_.leaves_around(lower_left(l))[1];
        if (before.is_valid())
          at_lower_left_[l] = locate_by_corner(lower_left(l), lower_left(before), at_lower_left_[before]);
      }
    }
  }

  /// From another corner of a leaf without pieces, which is in triangle t.
  Triangle_id locate_by_corner(Name c, Name other, Triangle_id t) const {
    return t.is_valid() && c != other ? walk_to(place(c), place(other), t) : t;
  }

  Triangle_id walk_to(const Point& p, const Point& from, Triangle_id t) const {
    const Walk_end end = walk_along(mesh_, t, from, p);
    return end.is_blocked() ? Triangle_id() : end.triangle;
  }

  /// The point of an edge's piece that is nearest to a corner.
  struct Nearest {
    Edge_id edge;
    Vertex_id end; ///< of the edge, if it is one
    Vector place;  ///< relative to the corner
    double squared_distance = std::numeric_limits<double>::infinity();
  };

  /// \param l a leaf around the corner
  Triangle_id locate_by_pieces(Name c, Leaf_index l) const {
    const Point p = place(c);
    const Nearest nearest = nearest_in_leaf(p, l);
    if (!nearest.edge.is_valid()) return {};
    if (nearest.end.is_valid()) {
      const Triangle_id t = triangle_toward(p, nearest);
      return t.is_valid() ? walk_to(p, mesh_.point(nearest.end), t) : t;
    }
    const Input_edge& edge = problem_.edges[nearest.edge];
    const int side = Geometry::orientation(problem_.input_point(edge.a), problem_.input_point(edge.b), p);
    const auto& pair = triangles_[nearest.edge];
    const Side s = side > 0 ? pair.left : side < 0 ? pair.right : pair.any();
    return s.is_border() ? Triangle_id() : walk_to(p, Geometry::translate(p, nearest.place), s.triangle());
  }

  Nearest nearest_in_leaf(const Point& p, Leaf_index l) const {
    const auto square = trees_.tree().square(l);
    const double side = trees_.side(square.level);
    const Vector corner = Geometry::difference(p, trees_.kernel_point({square.x, square.y}));
    Nearest nearest;
    for (const Edge_piece& piece : trees_.pieces_in_leaves()[l])
      take_nearer(static_cast<Edge_id>(piece.segment.value()), p, corner, side, nearest);
    return nearest;
  }

  /// \param corner p, relative to the leaf
  void take_nearer(Edge_id e, const Point& p, Vector corner, double side, Nearest& nearest) const {
    const Input_edge& edge = problem_.edges[e];
    const Local_segment whole =
        Near_segment<Geometry>::of(problem_.input_point(edge.a), problem_.input_point(edge.b), p, side);
    Local_segment piece{whole.a + corner, whole.b + corner};
    if (!piece.clip(0, side)) return; // it touches the leaf
    const Vector place = piece.nearest_to(corner) - corner;
    const double squared_distance = squared_length(place);
    if (!(squared_distance < nearest.squared_distance)) return;
    const auto is_at = [&](Vector end) { return squared_length(place - end) <= tolerance_ * side * side; };
    nearest = {e, is_at(whole.a) ? edge.a : is_at(whole.b) ? edge.b : Vertex_id(), place, squared_distance};
  }
  static constexpr double tolerance_ = 0x1p-40; // of squared distances, in sides of leaves

  /// Of the triangles at an end of an edge, the one that has the ray from there to p.
  Triangle_id triangle_toward(const Point& p, const Nearest& nearest) const {
    const Triangle_id t = triangle_toward(p, nearest.end, triangles_[nearest.edge]);
    if (t.is_valid()) return t;
    // Where parts of the domain touch, they have borders of their own.
    for (const auto incidence : problem_.edges.at(nearest.end)) {
      const auto& pair = triangles_[incidence.edge];
      if (incidence.edge == nearest.edge || pair.left.is_border() == pair.right.is_border()) continue;
      if (const Triangle_id u = triangle_toward(p, nearest.end, pair); u.is_valid()) return u;
    }
    return {};
  }

  /// The same of triangles that are connected to those of an edge.
  Triangle_id triangle_toward(const Point& p, Vertex_id end,
                              const typename Edge_triangles<Geometry>::Pair& pair) const {
    for (const Side s : {pair.left, pair.right}) {
      if (s.is_border()) continue;
      const Triangle_id t = internal::triangle_toward(mesh_, end, s.triangle(), p);
      if (t.is_valid()) return t;
    }
    return {};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CORNER_LOCATION_H
