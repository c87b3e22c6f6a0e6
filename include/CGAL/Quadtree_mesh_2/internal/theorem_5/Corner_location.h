// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where corners of leaves are in the domain.
//
// Computes: for each corner a triangle in sight of it, in the triangulation of the domain's graph; none for those
//           outside of the domain.
// Bound:    O(1) for each piece of an edge in a leaf, and each triangle at a vertex that is the nearest feature of a
//           corner. O(1) for each leaf without pieces. All at the same time but for these, which are passed once.
// Source:   ours.
//
// - In a leaf that edges pass, a corner sees the point of their pieces that is nearest to it. That is on an edge, whose
//   triangle on this side is in sight then, or an end of an edge, of which one of the triangles points to the corner.
// - A leaf without pieces is in the domain, or outside of it, as a whole. It has its lower left corner in common with
//   the leaf to the left of that, which is before it in shuffle order.
//
// Distances are rounded. So where edges touch, the triangle may be on the wrong side of one. Who walks from it to the
// corner sees that.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CORNER_LOCATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CORNER_LOCATION_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Tree_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Near_segment.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>

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

  /// All are kept by reference.
  Corner_location(const Meshing_problem<Geometry>& problem, const Trees& trees, const Corners& corners,
                  const Edge_triangles<Geometry>& triangles)
      : problem_(problem), trees_(trees), corners_(corners), triangles_(triangles), mesh_(triangles.mesh()) {
    locate_empty_leaves();
  }

  /// A triangle in sight of a corner, or none.
  /// \pre the corner exists
  Triangle_id operator()(Name c) const {
    const Leaf_index l = leaf_with_pieces(c);
    return l.is_valid() ? triangle_in_sight(c, l) : in_empty_leaf_[Corners::leaf_of(c)];
  }

private:
  using Point = typename Geometry::Point;

  const Meshing_problem<Geometry>& problem_;
  const Trees& trees_;
  const Corners& corners_;
  const Edge_triangles<Geometry>& triangles_;
  const Kernel_mesh<Geometry>& mesh_;
  Indexed_vector<Leaf_index, Triangle_id> in_empty_leaf_; // in sight of all of it

  bool has_pieces(Leaf_index l) const { return !trees_.pieces_in_leaves()[l].empty(); }

  /// The first of the leaves around a corner that edges pass.
  Leaf_index leaf_with_pieces(Name c) const {
    for (const Leaf_index l : corners_.leaves_around(c))
      if (l.is_valid() && has_pieces(l)) return l;
    return Leaf_index();
  }

  void locate_empty_leaves() {
    const std::size_t n = trees_.tree().number_of_leaves();
    in_empty_leaf_.resize(n);
    std::vector<Leaf_index> before(n); // of leaves that are located by others
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      const Leaf_index l(i);
      if (has_pieces(l)) return;
      const Name lower_left = corners_.name(l, Leaf_corner::LOWER_LEFT);
      const Leaf_index other = leaf_with_pieces(lower_left);
      if (other.is_valid())
        in_empty_leaf_[l] = triangle_in_sight(lower_left, other);
      else
        before[i] = corners_.leaves_around(lower_left)[1];
    });
    for (std::size_t i = 0; i < n; ++i)
      if (before[i].is_valid()) in_empty_leaf_[Leaf_index(i)] = in_empty_leaf_[before[i]];
  }

  /// The point of an edge's piece that is nearest to a corner.
  struct Nearest {
    Edge_id edge;
    Vertex_id end; ///< of the edge, if it is one
    double squared_distance = std::numeric_limits<double>::infinity();
  };

  Triangle_id triangle_in_sight(Name c, Leaf_index l) const {
    const Point p = trees_.kernel_point(corners_.place(c));
    const Nearest nearest = nearest_in_leaf(p, l);
    if (!nearest.edge.is_valid()) return {};
    if (nearest.end.is_valid()) {
      const Triangle_id t = triangle_toward(p, nearest);
      if (t.is_valid()) return t;
    }
    const Input_edge& edge = problem_.edges[nearest.edge];
    const int side = Geometry::orientation(problem_.input_point(edge.a), problem_.input_point(edge.b), p);
    const auto& pair = triangles_[nearest.edge];
    const Side s = side > 0 ? pair.left : side < 0 ? pair.right : pair.any();
    return s.is_border() ? Triangle_id() : s.triangle();
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
    nearest = {e, is_at(whole.a) ? edge.a : is_at(whole.b) ? edge.b : Vertex_id(), squared_distance};
  }
  static constexpr double tolerance_ = 0x1p-40; // of squared distances, in sides of leaves

  /// Of the triangles at an end of an edge that are connected to those of the edge, the one that has the ray from there
  /// to p.
  Triangle_id triangle_toward(const Point& p, const Nearest& nearest) const {
    const auto& pair = triangles_[nearest.edge];
    for (const Side s : {pair.left, pair.right}) {
      if (s.is_border()) continue;
      Fan_walk<Kernel_mesh<Geometry>> fan(mesh_, nearest.end, s.triangle());
      do {
        const auto& v = mesh_.triangle(fan.triangle()).v;
        const Point& end = mesh_.point(nearest.end);
        if (Geometry::orientation(end, mesh_.point(v[next_slot[fan.slot()]]), p) >= 0 &&
            Geometry::orientation(end, mesh_.point(v[previous_slot[fan.slot()]]), p) <= 0)
          return fan.triangle();
      } while (fan.advance());
    }
    return {};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CORNER_LOCATION_H
