// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The mesh at one change of sizes, above an edge, in a window of its own.
//
// Computes: the vertices that Column_rule.h keeps for an edge y = slope x + offset, for x in [-2, 3/2], up to
//           a row of kept corners. Coarse columns of width 1 are at x < 0, fine ones of width 1/2 at x > 0.
//           Then the Delaunay triangulation of these vertices, its least angle, and which of two vectors of
//           thresholds gives the larger one.
// Bound:    O(1): at most 80 vertices.
// Source:   Lawson, Software for C1 surface interpolation (1977): flips, from a triangulation strip by strip.
// Deviates: computed in doubles. Cocircular points are left as they are, because the choice does not matter
//           for the least angle.
//
// Points on the edge are on the boundary of the window. So its Delaunay triangulation is a part of the
// constrained one of the plane, or that one is even better. Windows of an edge do not overlap, so choices are
// independent.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_WINDOW_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_WINDOW_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_rule.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The fine side of a change of sizes, along the edge.
enum class Fine_side { GREATER, LESS };
/// The side of an edge that is looked at.
enum class Edge_side { ABOVE, BELOW };

/// An edge as its window sees it: y = slope x + offset, 0 <= offset < 1.
struct Window_line {
  double slope;
  double offset;
};

/// Mirrors an edge such that the fine side is that of greater x, and the side looked at is above.
/// \param height where the edge meets the line of the change of sizes, in sides of coarse leaves; these have their
///        corners at integers
inline Window_line window_line(double slope, double height, Fine_side fine, Edge_side side) {
  const double h = side == Edge_side::ABOVE ? height : -height;
  const bool is_mirrored = (fine == Fine_side::LESS) != (side == Edge_side::BELOW);
  return {is_mirrored ? -slope : slope, h - std::floor(h)};
}

/// The triangulation of a window.
class Column_window {
public:
  static constexpr std::size_t number_of_columns = 6;
  static constexpr std::size_t max_vertices = 80;
  struct Point {
    double x;
    double y;
  };
  struct Triangle {
    std::array<std::uint8_t, 3> vertices;  ///< counterclockwise
    std::array<std::uint8_t, 3> neighbors; ///< opposite to the vertices; `none` at the boundary
  };
  static constexpr std::uint8_t none = 255;
  /// Of the determinant that tells circles' insides: four vertices up to this are on one circle.
  static constexpr double least_determinant = 1e-9;

  /// The abscissae of grid lines.
  static constexpr double column(std::size_t c) { return c < 3 ? double(c) - 2 : (double(c) - 2) / 2; }
  /// The distance of leaf corners on a grid line.
  static constexpr double step(std::size_t c) { return c < 2 ? 1 : 0.5; }
  /// The place of a corner on a grid line.
  static constexpr Column_place place(std::size_t c, bool is_hanging) {
    return c == 1   ? Column_place::BEFORE
           : c == 2 ? (is_hanging ? Column_place::HANGING : Column_place::COARSE)
           : c == 3 ? Column_place::HALF
           : c == 4 ? Column_place::ONE
                    : Column_place::EQUAL_LEAVES;
  }
  /// The width of columns beside a grid line, by which thresholds for equal leaves count.
  static constexpr double unit(std::size_t c) { return c == 5 ? 0.5 : 1; }

  /// \pre -1 <= `line.slope` <= 1
  Column_window(const Transition_thresholds& thresholds, const Window_line& line) {
    CGAL_precondition(-1 <= line.slope && line.slope <= 1);
    place_vertices(thresholds, line);
    triangulate();
  }

  /// Triangulates given vertices: on each grid line one on the edge first, then upwards to a common height.
  /// \param begins where grid lines begin in `points`, and their end
  template <class Points>
  Column_window(const Points& points, const std::array<std::size_t, number_of_columns + 1>& begins) {
    CGAL_precondition(begins.back() <= max_vertices);
    begins_ = begins;
    for (std::size_t i = 0; i < begins.back(); ++i) points_[i] = points[i];
    triangulate();
  }

  std::size_t number_of_vertices() const { return begins_.back(); }
  std::size_t number_of_triangles() const { return number_of_triangles_; }
  const Point& point(std::size_t v) const { return points_[v]; }
  const Triangle& triangle(std::size_t t) const { return triangles_[t]; }

  /// In degrees.
  double least_angle() const {
    double least = 1;
    for (std::size_t t = 0; t < number_of_triangles_; ++t)
      least = std::min(least, squared_sine_of_least_angle(triangles_[t]));
    return std::asin(std::sqrt(least)) * degrees_per_radian;
  }

private:
  void place_vertices(const Transition_thresholds& t, const Window_line& line) {
    const double length = std::sqrt(1 + line.slope * line.slope);
    const auto distance = [&](double x, double y) { return (y - line.slope * x - line.offset) / length; };
    const double top = std::ceil(std::max(1.5 * line.slope, -2 * line.slope) + line.offset + 2.2);
    const auto is_before_kept = [&](double y) { return is_kept(distance(-1, y), Column_place::BEFORE, t); };
    std::size_t n = 0;
    for (std::size_t c = 0; c < number_of_columns; ++c) {
      const double x = column(c), crossing = line.slope * x + line.offset;
      begins_[c] = n;
      points_[n++] = {x, crossing};
      for (double y = std::ceil(crossing / step(c)) * step(c); y <= top; y += step(c)) {
        const bool is_hanging = c == 2 && y != std::floor(y);
        const auto opposite = is_hanging && !(is_before_kept(y - 0.5) && is_before_kept(y + 0.5))
                                  ? Opposite_corners::NOT_BOTH_KEPT
                                  : Opposite_corners::BOTH_KEPT;
        const Column_place p = place(c, is_hanging);
        const double scale = p == Column_place::EQUAL_LEAVES ? unit(c) : 1;
        if (is_kept(distance(x, y) / scale, p, t, opposite)) points_[n++] = {x, y};
      }
    }
    begins_.back() = n;
  }

  void triangulate() {
    std::array<std::uint8_t, max_vertices> beside{};
    beside.fill(none);
    number_of_triangles_ = 0;
    for (std::size_t c = 0; c + 1 < number_of_columns; ++c) fill_strip(c, beside);
    flip_all();
  }

  /// Triangulates the strip between two grid lines, upwards. `beside[v]` is the triangle at the right column whose
  /// side goes upwards from v: that of the last strip before, and of this one after the call.
  void fill_strip(std::size_t c, std::array<std::uint8_t, max_vertices>& beside) {
    std::size_t l = begins_[c], r = begins_[c + 1];
    const std::size_t l_end = begins_[c + 1], r_end = begins_[c + 2];
    std::uint8_t below = none;
    while (l + 1 < l_end || r + 1 < r_end) {
      const bool goes_left = r + 1 == r_end || (l + 1 < l_end && points_[l + 1].y < points_[r + 1].y);
      const auto t = static_cast<std::uint8_t>(number_of_triangles_++);
      Triangle& triangle = triangles_[t];
      const auto a = static_cast<std::uint8_t>(l), b = static_cast<std::uint8_t>(r);
      if (goes_left) {
        triangle = {{a, b, static_cast<std::uint8_t>(l + 1)}, {none, beside[l], below}};
        if (beside[l] != none) set_neighbor(beside[l], static_cast<std::uint8_t>(l + 1), a, t);
        ++l;
      } else {
        triangle = {{a, b, static_cast<std::uint8_t>(r + 1)}, {none, none, below}};
        beside[r] = t;
        ++r;
      }
      if (below != none) set_neighbor(below, b, a, t);
      below = t;
    }
  }

  /// Makes `neighbor` the one across the side from v to w, in the order of the other triangle.
  void set_neighbor(std::uint8_t t, std::uint8_t w, std::uint8_t v, std::uint8_t neighbor) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint8_t p = triangles_[t].vertices[(i + 1) % 3], q = triangles_[t].vertices[(i + 2) % 3];
      if ((p == v && q == w) || (p == w && q == v)) triangles_[t].neighbors[i] = neighbor;
    }
  }

  void flip_all() {
    // Sweeps are few: strips are nearly Delaunay.
    for (int sweep = 0; sweep < 100; ++sweep) {
      bool has_changed = false;
      for (std::size_t t = 0; t < number_of_triangles_; ++t)
        for (std::size_t i = 0; i < 3; ++i)
          if (triangles_[t].neighbors[i] != none && is_to_be_flipped(t, i)) {
            flip(t, i);
            has_changed = true;
          }
      if (!has_changed) return;
    }
  }

  static std::size_t index(const Triangle& t, std::uint8_t neighbor) {
    return t.neighbors[0] == neighbor ? 0 : t.neighbors[1] == neighbor ? 1 : 2;
  }

  /// Whether the vertex across a side is inside the circle, certainly.
  bool is_to_be_flipped(std::size_t t, std::size_t i) const {
    const Triangle& triangle = triangles_[t];
    const Triangle& other = triangles_[triangle.neighbors[i]];
    const Point& d = points_[other.vertices[index(other, static_cast<std::uint8_t>(t))]];
    const auto from_d = [&](std::size_t k) {
      const Point& p = points_[triangle.vertices[k]];
      return Point{p.x - d.x, p.y - d.y};
    };
    const Point a = from_d(0), b = from_d(1), c = from_d(2);
    const auto square = [](const Point& p) { return p.x * p.x + p.y * p.y; };
    const auto cross = [](const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; };
    return square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b) > least_determinant;
  }

  /// Replaces the side opposite to vertex `i` by the other diagonal.
  void flip(std::size_t t, std::size_t i) {
    Triangle& one = triangles_[t];
    const std::uint8_t u = one.neighbors[i], s = static_cast<std::uint8_t>(t);
    Triangle& two = triangles_[u];
    const std::size_t j = index(two, s);
    const std::uint8_t a = one.vertices[i], b = one.vertices[(i + 1) % 3], c = one.vertices[(i + 2) % 3],
                       d = two.vertices[j];
    const std::uint8_t ca = one.neighbors[(i + 1) % 3], ab = one.neighbors[(i + 2) % 3],
                       bd = two.neighbors[(j + 1) % 3], dc = two.neighbors[(j + 2) % 3];
    one = {{a, b, d}, {bd, u, ab}};
    two = {{a, d, c}, {dc, ca, s}};
    if (bd != none) triangles_[bd].neighbors[index(triangles_[bd], u)] = s;
    if (ca != none) triangles_[ca].neighbors[index(triangles_[ca], s)] = u;
  }

  double squared_sine_of_least_angle(const Triangle& t) const {
    const Point &a = points_[t.vertices[0]], &b = points_[t.vertices[1]], &c = points_[t.vertices[2]];
    const auto squared_length = [](const Point& p, const Point& q) {
      return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
    };
    const double cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double p = squared_length(a, b), q = squared_length(b, c), r = squared_length(c, a);
    return cross <= 0 ? 0 : cross * cross * std::min({p, q, r}) / (p * q * r);
  }

  std::array<Point, max_vertices> points_;
  std::array<std::size_t, number_of_columns + 1> begins_;
  std::array<Triangle, 2 * max_vertices> triangles_;
  std::size_t number_of_triangles_ = 0;
};

/// The least angle, in degrees, at a change of sizes above an edge.
inline double least_angle_in_window(const Transition_thresholds& thresholds, double slope, double offset) {
  return Column_window(thresholds, {slope, offset}).least_angle();
}

/// Of two vectors the one with the larger least angle; of equally good ones the first.
inline const Transition_thresholds& better_of(const Transition_thresholds& first,
                                              const Transition_thresholds& second, double slope,
                                              double offset) {
  const double lead =
      least_angle_in_window(second, slope, offset) - least_angle_in_window(first, slope, offset);
  return lead > least_lead ? second : first;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_WINDOW_H
