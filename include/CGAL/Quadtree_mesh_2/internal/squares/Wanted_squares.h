// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The squares that bounds of size ask for, and the kind of each: inside the domain and away from all
// features, outside, or near a feature.
//
// Works top down, square by square, with the constrained edges and the triangles of the domain's
// triangulation that meet the square. A square is near a feature if a constrained edge or a vertex comes
// within `margin` times its side. Any other square lies wholly inside or wholly outside. It is inside if any
// triangle of the domain meets it, so nothing has to be located. All tests use floating point with closed,
// widened boxes. That is enough, because a feature counts as away only if it is farther away than `margin`
// sides.
//
// Near squares are split until they are as small as the bounds want, and no further: the kernel does the rest
// there. Sizes are looked up at places inside the domain only.
//
// O((n + k) levels) tests for n edges and triangles that each meet O(1) squares of a level, and k near
// squares.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_WANTED_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_WANTED_SQUARES_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Square_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

enum class Square_kind : std::int8_t { OUTSIDE, NEAR_FEATURE, INSIDE };

template <class Geometry>
class Wanted_squares {
public:
  using Point = typename Geometry::Point;

  /// A square, or with children the squares in it. An inside square stands for all squares of `level` in it.
  struct Node {
    std::int32_t first_child = -1; ///< of four; -1: none
    Square_kind kind = Square_kind::OUTSIDE;
    std::int8_t level = 0;
    bool has_center = false; ///< an inside square is small enough with a vertex in its center only
    Triangle_id triangle;    ///< one that meets an inside square
  };

  /// \param largest_number of nodes; more than that, and `is_complete()` is false
  Wanted_squares(const Meshing_state<Geometry>& state, const Square_grid<Geometry>& grid,
                 std::size_t largest_number)
      : state_(state), grid_(grid), largest_number_(largest_number) {
    for (int level = 0; level <= Grid_square::depth; ++level) side_[level] = grid.side(level);
    finest_level_ =
        grid.finest_level() - (state.bounds.is_local() ? 1 : 0); // centers are corners one level below
    // edges to centers are shorter than sides, and features may be a little nearer than a side
    while (finest_level_ > 0 &&
           0.5 * side_[finest_level_] * side_[finest_level_] < state.bounds.least_squared_length)
      --finest_level_;
    collect_features();
    collect_triangles();
    nodes_.emplace_back();
    visit(0, Grid_square(), {0, features_.size()}, {0, triangles_.size()});
  }

  /// The level of the smallest squares there may be.
  int finest_level() const { return finest_level_; }
  const Node& node(std::size_t i) const { return nodes_[i]; }
  bool is_complete() const { return nodes_.size() <= largest_number_; }
  /// How many squares there are inside and away from features.
  double number_of_inside_squares() const { return number_inside_; }

  /// Whether a square of the given level in node i is to be split.
  bool must_split(std::size_t i, int level) const {
    return nodes_[i].first_child >= 0 || level < nodes_[i].level;
  }
  /// The node of child c of a square in node i: of squares below the least recorded one that holds them.
  std::size_t child(std::size_t i, int c) const {
    return nodes_[i].first_child >= 0 ? std::size_t(nodes_[i].first_child) + std::size_t(c) : i;
  }

  /// The node of the least recorded square that holds the given one.
  std::size_t node_at(const Grid_square& s) const {
    std::size_t i = 0;
    for (int level = 0; level < s.level && nodes_[i].first_child >= 0; ++level) i = child_at(i, level, s);
    return i;
  }

  /// Whether a square in the given node needs a center.
  bool has_center(std::size_t i, int level) const { return nodes_[i].has_center && level == nodes_[i].level; }

private:
  /// Of its side: how near a feature may come to a square that is away from features.
  static constexpr double margin = 0.9;
  /// Sizes are looked up at distances of at most this share of the extent.
  static constexpr double widest_step = 1.0 / 32;
  /// Of the side: what counts as near beyond the margin, so that rounding loses nothing.
  static constexpr double slack = 1e-9;

  struct Range {
    std::size_t begin, end;
    bool is_empty() const { return begin == end; }
  };
  struct Feature {
    Vector a, b;
  };
  struct Box {
    Vector center;
    double half;
  };

  const Meshing_state<Geometry>& state_;
  const Square_grid<Geometry>& grid_;
  std::size_t largest_number_;
  double side_[Grid_square::depth + 1];
  int finest_level_ = 0;
  std::vector<Node> nodes_;
  double number_inside_ = 0;
  std::vector<Feature> features_;
  std::vector<Triangle_id> triangles_;
  // those that meet the squares on the way down, one square's after the other
  std::vector<std::uint32_t> feature_stack_;
  std::vector<Triangle_id> triangle_stack_;

  std::size_t child_at(std::size_t i, int level, const Grid_square& s) const {
    const int shift = Grid_square::depth - 1 - level;
    return std::size_t(nodes_[i].first_child) + 2 * (s.x >> shift & 1u) + (s.y >> shift & 1u);
  }

  void collect_features() {
    const auto& mesh = state_.mesh;
    Indexed_vector<Vertex_id, char> is_covered(mesh.number_of_vertices(), 0);
    for (const Triangle_id t : mesh.triangles.ids()) {
      if (!mesh.is_alive(t)) continue;
      for (int k = 0; k < 3; ++k) {
        const Side s(t, k), o = mesh.across(s);
        if (!o.is_constrained()) continue;
        const Vertex_id a = mesh.source(s), b = mesh.target(s);
        is_covered[a] = is_covered[b] = 1;
        if (o.is_border() || t < o.triangle())
          features_.push_back({grid_.vector(mesh.point(a)), grid_.vector(mesh.point(b))});
      }
    }
    for (const Vertex_id v : is_covered.ids())
      if (is_covered[v] == 0 && mesh.is_used(v)) {
        const Vector p = grid_.vector(mesh.point(v));
        features_.push_back({p, p});
      }
    for (std::size_t i = 0; i < features_.size(); ++i)
      feature_stack_.push_back(static_cast<std::uint32_t>(i));
  }

  /// All triangles that free vertices may enter: those within the lock of a corner are left out. So are,
  /// where all squares inside have one size, triangles too small to hold the middle of one, which is farther
  /// than 1/2 + margin sides from all vertices.
  void collect_triangles() {
    const auto& mesh = state_.mesh;
    const double least_distance = (0.5 + margin - slack) * side_[grid_.given_level()];
    const double least_longest =
        state_.bounds.is_local() ? 0 : 3 * least_distance * least_distance * (1 - slack);
    for (const Triangle_id t : mesh.triangles.ids()) {
      const auto& r = mesh.triangle(t);
      if (!r.v[0].is_valid() || mesh.shape(r).longest() < least_longest) continue;
      const Sector_id s = state_.corners.sector_of(mesh, r.v[0], r.v[1], r.v[2]);
      if (!s.is_valid() || state_.corners.sector(s).lock_radius == 0) triangles_.push_back(t);
    }
    triangle_stack_ = triangles_;
  }

  Box box(const Grid_square& s) const {
    const double half = 0.5 * side_[s.level];
    return {grid_.corner(s.x, s.y) + Vector{half, half}, half};
  }

  void visit(std::size_t i, const Grid_square& s, Range features, Range triangles) {
    if (triangles.is_empty() || !is_complete()) return;
    if (features.is_empty()) return visit_inside(i, s, triangle_stack_[triangles.begin]);
    nodes_[i].kind = Square_kind::NEAR_FEATURE;
    nodes_[i].level = static_cast<std::int8_t>(s.level);
    if (s.level >= finest_level_ || !is_too_large_for_any(s, triangles)) return;
    const std::size_t first = add_children(i);
    for (int c = 0; c < 4; ++c) {
      const Grid_square child = s.child(c);
      const Range f = features_near(child, features), t = triangles_in(child, triangles);
      visit(first + std::size_t(c), child, f, t);
      feature_stack_.resize(f.begin), triangle_stack_.resize(t.begin);
    }
  }

  /// A square away from features, of which all places lie inside, in the region of triangle t.
  void visit_inside(std::size_t i, const Grid_square& s, Triangle_id t) {
    nodes_[i].kind = Square_kind::INSIDE;
    nodes_[i].triangle = t;
    const Region_id region = state_.mesh.region(t);
    int level = s.level;
    if (!state_.bounds.is_local()) {
      while (level < finest_level_ && is_too_large_everywhere({level, Center::WITHOUT}, region)) ++level;
    } else if (is_too_large_somewhere(s, Center::WITHOUT, region)) {
      if (s.level < finest_level_ && is_complete() && is_too_large_somewhere(s, Center::WITH, region)) {
        const std::size_t first = add_children(i);
        for (int c = 0; c < 4; ++c) visit_inside(first + std::size_t(c), s.child(c), t);
        return;
      }
      nodes_[i].has_center = true;
    }
    nodes_[i].level = static_cast<std::int8_t>(level);
    number_inside_ += std::exp2(2 * (level - s.level));
  }

  std::size_t add_children(std::size_t i) {
    const std::size_t first = nodes_.size();
    nodes_[i].first_child = static_cast<std::int32_t>(first);
    nodes_.resize(first + 4);
    return first;
  }

  // ---- what meets a square

  Range features_near(const Grid_square& s, Range among) {
    Box b = box(s);
    b.half += (margin + slack) * side_[s.level];
    const std::size_t begin = feature_stack_.size();
    for (std::size_t i = among.begin; i < among.end; ++i) {
      const std::uint32_t f = feature_stack_[i];
      if (do_meet(features_[f].a, features_[f].b, b)) feature_stack_.push_back(f);
    }
    return {begin, feature_stack_.size()};
  }

  Range triangles_in(const Grid_square& s, Range among) {
    Box b = box(s);
    b.half += slack * side_[s.level];
    const std::size_t begin = triangle_stack_.size();
    for (std::size_t i = among.begin; i < among.end; ++i) {
      const Triangle_id t = triangle_stack_[i];
      if (do_meet(t, b)) triangle_stack_.push_back(t);
    }
    return {begin, triangle_stack_.size()};
  }

  static bool do_meet(Vector a, Vector b, const Box& box) {
    const Vector d = b - a, p = a - box.center, q = b - box.center;
    if (std::min(p.x, q.x) > box.half || std::max(p.x, q.x) < -box.half || std::min(p.y, q.y) > box.half ||
        std::max(p.y, q.y) < -box.half)
      return false;
    return std::fabs(cross(d, p)) <= box.half * (std::fabs(d.x) + std::fabs(d.y));
  }

  bool do_meet(Triangle_id t, const Box& box) const {
    const auto& r = state_.mesh.triangle(t);
    Vector p[3];
    for (int k = 0; k < 3; ++k) p[k] = grid_.vector(state_.mesh.point(r.v[k])) - box.center;
    if (std::min(p[0].x, std::min(p[1].x, p[2].x)) > box.half ||
        std::max(p[0].x, std::max(p[1].x, p[2].x)) < -box.half ||
        std::min(p[0].y, std::min(p[1].y, p[2].y)) > box.half ||
        std::max(p[0].y, std::max(p[1].y, p[2].y)) < -box.half)
      return false;
    for (int k = 0; k < 3; ++k) {
      const Vector a = p[next_slot[k]], d = p[previous_slot[k]] - a;
      if (cross(a, d) < -box.half * (std::fabs(d.x) + std::fabs(d.y))) return false;
    }
    return true;
  }

  // ---- sizes

  /// Whether squares have triangles around a center instead of two at a diagonal.
  enum class Center { WITHOUT, WITH };
  /// The triangles of squares of a level.
  struct Triangles_of_squares {
    int level;
    Center center;
  };

  double squared_length(Triangles_of_squares q) const {
    return (q.center == Center::WITH ? 1 : 2) * side_[q.level] * side_[q.level];
  }

  /// Whether such triangles are too large whatever the place.
  bool is_too_large_everywhere(Triangles_of_squares q, Region_id region) const {
    const Bounds<Geometry>& bounds = state_.bounds;
    const double l2 = squared_length(q), area2 = 0.5 * l2;
    if (area2 > bounds.area2 || l2 > bounds.squared_length) return true;
    return region.is_valid() && !bounds.area2_of_region.empty() && area2 > bounds.area2_of_region[region];
  }

  bool is_too_large_at(Triangles_of_squares q, Vector v) const {
    return squared_length(q) >
           state_.bounds.squared_length_at(grid_.point(v)) * (1 - Bounds<Geometry>::margin);
  }

  /// Looks the size up where the centroids of a small square's triangles are, or at a lattice in a large one.
  bool is_too_large_somewhere(const Grid_square& s, Center center, Region_id region) const {
    const Triangles_of_squares q{s.level, center};
    if (is_too_large_everywhere(q, region)) return true;
    if (!state_.bounds.squared_length_at) return false;
    const double side = side_[s.level];
    const Vector low = grid_.corner(s.x, s.y);
    const int steps = static_cast<int>(std::ceil(side / (widest_step * grid_.extent())));
    if (steps > 1) {
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
          if (is_too_large_at(q, low + side / steps * Vector{double(i), double(j)})) return true;
      return false;
    }
    const double f = center == Center::WITH ? 1.0 / 6 : 1.0 / 3;
    if (center == Center::WITHOUT)
      return is_too_large_at(q, low + side * Vector{1 - f, f}) ||
             is_too_large_at(q, low + side * Vector{f, 1 - f});
    for (const Vector v : {Vector{0.5, f}, Vector{1 - f, 0.5}, Vector{0.5, 1 - f}, Vector{f, 0.5}})
      if (is_too_large_at(q, low + side * v)) return true;
    return false;
  }

  /// Whether a square near features is too large for one of the triangles of the domain that meet it.
  bool is_too_large_for_any(const Grid_square& s, Range triangles) const {
    const Triangles_of_squares q{s.level, state_.bounds.is_local() ? Center::WITH : Center::WITHOUT};
    if (is_too_large_everywhere(q, Region_id())) return true;
    if (!state_.bounds.is_local()) return false;
    const Box b = box(s);
    for (std::size_t i = triangles.begin; i < triangles.end; ++i) {
      const Triangle_id t = triangle_stack_[i];
      if (is_too_large_everywhere(q, state_.mesh.region(t))) return true;
      if (state_.bounds.squared_length_at && is_too_large_at(q, place_in(t, b.center))) return true;
    }
    return false;
  }

  /// A place inside triangle t toward the given one.
  Vector place_in(Triangle_id t, Vector want) const {
    const auto& r = state_.mesh.triangle(t);
    const Vector a = grid_.vector(state_.mesh.point(r.v[0])), b = grid_.vector(state_.mesh.point(r.v[1])),
                 c = grid_.vector(state_.mesh.point(r.v[2]));
    const double area2 = cross(b - a, c - a);
    double w[3] = {cross(b - want, c - want), cross(c - want, a - want), cross(a - want, b - want)};
    double sum = 0;
    for (double& x : w) sum += x = std::max(x, 0.02 * area2);
    const Vector p = (w[1] / sum) * (b - a) + (w[2] / sum) * (c - a);
    return a + p;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_WANTED_SQUARES_H
