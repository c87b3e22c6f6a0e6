// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The vertices of a mesh from a quadtree that separates the features of a graph.
//
// Computes: points on the edges, and corners of leaves. A constrained Delaunay triangulation of them and the
//           graph has few small angles.
// Bound:    O(1) for each piece of an edge and each corner.
// Source:   Bern, Eppstein, Teng, Theorem 5: "local warping". The rule is ours: Column_rule.h.
// Deviates: nothing is warped. An edge gets a vertex where it crosses the sides of leaves transversal to it,
//           and corners near edges and vertices are dropped. Where the leaves along an edge are equal, the
//           rule of Column_rule.h holds with its bound. At changes of sizes the same rule is used with its
//           distances for equal leaves. It does not need columns there, and sometimes misses the bound: see
//           Tree_construction.h.
//
// Nothing depends on anything further away than a leaf or two, so everything is done at the same time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_PLACEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_PLACEMENT_H

#include <CGAL/Quadtree_mesh_2/internal/columns/Column_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Grid_box.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Placement_scope.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Tree_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Corner_location.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_rooms.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Leg_spacing.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Near_segment.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Window_placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Distances at a vertex, in sides of the leaves there, whatever their sizes around it. With them alone sectors of at
/// least 60 degrees have angles of at least 21.2 degrees amid equal leaves, and of 45 degrees 19.4: established by
/// random search.
struct Vertex_clearance {
  double of_crossings = .825; ///< nearer ones are not used
  double of_corners = 1.187;  ///< nearer ones are dropped
  double of_edges = .741;     ///< corners nearer to an edge are dropped where their foot is near the vertex
};
constexpr Vertex_clearance vertex_clearance{};

template <class Traits, class ConcurrencyTag>
class Tree_placement {
public:
  using Trees = Separation_trees<Traits, ConcurrencyTag>;
  using Geometry = typename Trees::Geometry;
  using Point = typename Geometry::Point;
  using Problem = Meshing_problem<Geometry>;

  /// \param scope the edges that get vertices, and the leaves whose corners are kept or not
  Tree_placement(const Problem& problem, const Trees& trees, const Edge_triangles<Geometry>& triangles,
                 const Placement_scope& scope)
      : problem_(problem), trees_(trees), triangles_(triangles), scope_(scope), rooms_(problem, triangles),
        tree_(trees.tree()), corners_(trees.tree()), box_(box_of_points<ConcurrencyTag>(trees.tree())),
        windows_(problem, trees), legs_(problem) {}

  Placed_vertices<Geometry> run() {
    Placed_vertices<Geometry> placed(problem_.input_points);
    placed.template append_vertices_of_edges<ConcurrencyTag>(
        problem_.edges, scope_, rooms_, [this](Edge_id e, auto& crossings) { cut_edge(e, crossings); });
    find_corners_kept();
    drop_corners_at_vertices();
    windows_.drop_corners(corners_, is_kept_);
    placed.template append_corners<ConcurrencyTag>(trees_, corners_, is_kept_,
                                                   Location(problem_, trees_, corners_, triangles_, scope_));
    return placed;
  }

private:
  using Tree = typename Trees::Tree;
  using Grid_point = typename Trees::Grid_point;
  using Corners = Tree_corners<Tree>;
  using Location = Corner_location<Traits, ConcurrencyTag>;
  using Name = typename Corners::Name;

  static constexpr std::size_t block_of_leaves_ = 256;
  static constexpr std::size_t block_of_corners_ = 1024;
  /// On a leg of an acute corner, in sides of its apex's leaf along x or y: a vertex up to there may be the first one.
  static constexpr double next_to_apex_ = 2.25;

  const Problem& problem_;
  const Trees& trees_;
  const Edge_triangles<Geometry>& triangles_;
  const Placement_scope& scope_;
  const Edge_rooms<Geometry> rooms_;
  const Tree& tree_;
  Corners corners_;
  const Grid_box<Grid_point> box_;
  const Window_placement<Traits, ConcurrencyTag> windows_;
  const Leg_spacing<Geometry> legs_;
  std::vector<char> is_kept_; // by name of a corner

  // ---- on edges

  using Shares = typename Window_placement<Traits, ConcurrencyTag>::Shares;

  /// Where an edge crosses the sides of leaves transversal to it, but for those next to its ends. There are the points
  /// of windows, if they are at the ends. Legs of acute corners get more vertices, or fewer.
  void cut_edge(Edge_id e, std::vector<Edge_crossing<Geometry>>& crossings) const {
    const Input_edge& edge = problem_.edges[e];
    const bool is_window_at_a = windows_.is_at(edge.a), is_window_at_b = windows_.is_at(edge.b);
    const double length = std::sqrt(squared_length(direction(e)));
    const Shares of_a = is_window_at_a ? windows_.crossings_at(e, 0) : Shares{clearance(edge.a) / length, 0},
                 of_b = is_window_at_b ? windows_.crossings_at(e, 1) : Shares{clearance(edge.b) / length, 0};
    if (is_window_at_a)
      for (const auto& p : windows_.points_at(e, 0)) crossings.push_back({e, p.point});
    if (legs_.is_leg(e)) {
      std::vector<Point_on_edge<Geometry>> vertices;
      for_each_crossing(e, of_a, of_b, [&](const auto& crossing) { vertices.push_back(crossing); });
      if (!is_window_at_a) space_out(e, 0, of_b, vertices);
      if (!is_window_at_b) space_out(e, 1, of_a, vertices);
      for (const auto& v : vertices) crossings.push_back({e, v.point});
    } else {
      for_each_crossing(e, of_a, of_b, [&](const auto& crossing) {
        crossings.push_back({e, crossing.point});
      });
    }
    if (!is_window_at_b) return;
    const auto [ring, halfway] = windows_.points_at(e, 1);
    crossings.push_back({e, halfway.point}), crossings.push_back({e, ring.point});
  }

  /// Calls `f(crossing)` for those that are used, along the edge.
  template <class F>
  void for_each_crossing(Edge_id e, const Shares& of_a, const Shares& of_b, const F& f) const {
    const Input_edge& edge = problem_.edges[e];
    const Vector d = direction(e);
    const bool is_steep = std::fabs(d.y) > std::fabs(d.x);
    const auto leaves = trees_.pieces()[Segment_index(std::size_t(e))];
    for (std::size_t i = 1; i < leaves.size(); ++i) {
      const Leaf_index behind = side_crossed(leaves[i - 1], leaves[i], is_steep);
      if (!behind.is_valid()) continue;
      const auto s = tree_.square(behind);
      const auto crossing =
          Point_on_edge<Geometry>::beside(trees_.kernel_point({s.x, s.y}), problem_.input_point(edge.a),
                                          problem_.input_point(edge.b), is_steep, trees_.side(behind));
      const bool is_after_a = crossing.share >= of_a.first, is_before_b = crossing.rest >= of_b.first;
      if ((is_after_a && (is_before_b || crossing.share <= of_a.last)) ||
          (is_before_b && crossing.rest <= of_b.last))
        f(crossing);
    }
  }

  /// \param of_other where crossings at the other end begin
  void space_out(Edge_id e, std::size_t end, const Shares& of_other,
                 std::vector<Point_on_edge<Geometry>>& vertices) const {
    if (!legs_.is_leg_at(e, end)) return;
    const Vector d = direction(e);
    const Input_edge& edge = problem_.edges[e];
    const double sides =
        std::max(std::fabs(d.x), std::fabs(d.y)) / side_at(end == 0 ? edge.a : edge.b); // to the other end
    legs_.space_out(e, end, {next_to_apex_ / sides, 1 - of_other.first}, vertices);
  }

  Vector direction(Edge_id e) const {
    const Input_edge& edge = problem_.edges[e];
    return Geometry::difference(problem_.input_point(edge.b), problem_.input_point(edge.a));
  }

  double side_at(Vertex_id v) const { return trees_.side(tree_.leaf(Point_index(std::size_t(v)))); }

  double clearance(Vertex_id v) const { return vertex_clearance.of_crossings * side_at(v); }

  /// Of two leaves that follow each other on an edge the one whose left (or lower) side is crossed; invalid if
  /// they are not beside each other as the edge runs.
  Leaf_index side_crossed(Leaf_index l, Leaf_index m, bool is_steep) const {
    const auto s = tree_.square(l), t = tree_.square(m);
    const auto &x = is_steep ? s.y : s.x, &y = is_steep ? t.y : t.x;
    if (x < y) return x + side(s.level) <= y ? m : Leaf_index();
    return y + side(t.level) <= x ? l : Leaf_index();
  }

  typename Tree::Word side(int level) const {
    return Word_operations<typename Tree::Word>::power_of_two(tree_.framework().grid().depth() - level);
  }

  // ---- corners

  void find_corners_kept() {
    constexpr std::size_t names = Corners::names_of_leaf;
    is_kept_.assign(corners_.number_of_names(), 0);
    for_each_index<ConcurrencyTag>(
        names * scope_.number_of_leaves(tree_.number_of_leaves()),
        [&](std::size_t i) {
          const Name c = names * scope_.leaf(i / names).value() + i % names;
          is_kept_[c] =
              corners_.exists(c) && box_.contains(corners_.place(c)) && is_clear_of_edges(c) ? 1 : 0;
        },
        block_of_corners_);
  }

  /// Whether a corner is far enough from all edges. Those nearer than a side of the smallest leaf around it pass
  /// these leaves.
  bool is_clear_of_edges(Name c) const {
    const auto leaves = corners_.leaves_around(c);
    if (const auto w = windows_.window_at(leaves); w != windows_.none) // others do not count there
      return windows_.is_clear_far_ahead(w, corners_.place(c));
    bool is_any = false;
    for (const Leaf_index l : leaves)
      is_any = is_any || (l.is_valid() && !trees_.pieces_in_leaves()[l].empty());
    if (!is_any) return true;
    const Point p = trees_.kernel_point(corners_.place(c));
    const double side = trees_.side(corners_.level(leaves));
    for (const Leaf_index l : leaves)
      if (l.is_valid())
        for (const Edge_piece& piece : trees_.pieces_in_leaves()[l])
          if (!is_clear_of(static_cast<Edge_id>(piece.segment.value()), p, side)) return false;
    return true;
  }

  bool is_clear_of(Edge_id e, const Point& p, double side) const {
    const Input_edge& edge = problem_.edges[e];
    const auto near =
        Near_segment<Geometry>::of(problem_.input_point(edge.a), problem_.input_point(edge.b), p, side);
    const Vector a = near.a, d = near.b - near.a;
    const double l2 = squared_length(d), foot = -dot(a, d);
    if (foot < 0 || foot > l2) return true; // that is for the rule at vertices
    const double length = std::sqrt(l2), from_end = std::min(foot, l2 - foot) / length;
    const double least = from_end < vertex_reach * side ? vertex_clearance.of_edges : equal_leaves_threshold;
    return std::fabs(cross(a, d)) >= least * side * length;
  }

  /// All corners near a vertex are those of its leaf, or of a leaf next to that.
  void drop_corners_at_vertices() {
    constexpr int away = 2; // from the leaf that a corner belongs to, its vertices may be
    Placement_scope around = scope_;
    if (!around.is_all) around.grow(tree_, away);
    const std::size_t n = around.number_of_leaves(tree_.number_of_leaves());
    std::vector<std::vector<Name>> found((n + block_of_leaves_ - 1) / block_of_leaves_);
    for_each_block<ConcurrencyTag>(n, block_of_leaves_,
                                   [&](std::size_t b, std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       find_corners_near(around.leaf(i), found[b]);
                                   });
    for (const auto& names : found)
      for (const Name c : names) is_kept_[c] = 0;
  }

  /// Finds those of the corners kept that are too near the vertices in a leaf.
  void find_corners_near(Leaf_index own, std::vector<Name>& names) const {
    const Rank_interval vertices = tree_.points(own);
    if (vertices.begin == vertices.end || windows_.has(own)) return;
    find_corners_of(own, own, vertices, names);
    for (const Leaf_index l : tree_.neighbors(own)) find_corners_of(l, own, vertices, names);
  }

  void find_corners_of(Leaf_index l, Leaf_index own, const Rank_interval& vertices,
                       std::vector<Name>& names) const {
    const auto s = tree_.square(l), box = tree_.square(own);
    const Point low = trees_.kernel_point({s.x, s.y});
    const Vector from_box = Geometry::difference(low, trees_.kernel_point({box.x, box.y}));
    const double side = trees_.side(s.level), side_of_box = trees_.side(box.level);
    for (int i = 0; i < 4; ++i) {
      const Vector to_corner{(i & 1) != 0 ? side : 0, (i & 2) != 0 ? side : 0};
      const double distance = distance_to_box(from_box + to_corner, side_of_box);
      if (distance >= vertex_clearance.of_corners * side) continue; // and leaves around it may be smaller
      if (!is_any_nearer(vertices, low, to_corner, vertex_clearance.of_corners * side)) continue;
      const Name c = corners_.name(l, static_cast<Leaf_corner>(i));
      if (c == Corners::none || is_kept_[c] == 0) continue;
      const auto leaves = corners_.leaves_around(c);
      if (windows_.window_at(leaves) != windows_.none) continue;
      const double side_there = trees_.side(corners_.level(leaves));
      if (side_there == side ||
          is_any_nearer(vertices, low, to_corner, vertex_clearance.of_corners * side_there))
        names.push_back(c);
    }
  }

  /// How far a place is from the square [0, side]^2.
  static double distance_to_box(Vector p, double side) {
    const auto beyond = [side](double x) { return std::max({-x, x - side, 0.}); };
    return std::sqrt(squared_length(Vector{beyond(p.x), beyond(p.y)}));
  }

  /// Whether one of some vertices is nearer to a place than so much.
  bool is_any_nearer(const Rank_interval& vertices, const Point& low, Vector from_low, double least) const {
    for (std::size_t r = vertices.begin.value(); r < vertices.end.value(); ++r) {
      const auto v = static_cast<Vertex_id>(tree_.framework().input_point(Point_rank(r)).value());
      if (squared_length(Geometry::difference(low, problem_.input_point(v)) + from_low) < least * least)
        return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_PLACEMENT_H
