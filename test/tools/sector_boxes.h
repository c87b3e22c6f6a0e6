// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SECTOR_BOXES_H
#define QUADTREE_MESH_2_TEST_SECTOR_BOXES_H

// Sectors at a vertex amid equal leaves of side 1, by four parameters, and what the rule at vertices says for all
// parameters in a box.
//
// The vertex is (x, y), in the leaf [0, 1]^2. An edge has its direction in one of eight octants, counterclockwise from
// that between the directions (1, 0) and (1, 1); there it is (1, m), (m, 1), (-m, 1) and so on, with 0 <= m <= 1.

#include "multilinear_forms.h"

#include <CGAL/Quadtree_mesh_2/internal/columns/Column_rule.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vertex_certificates {

using namespace CGAL::Quadtree_mesh_2::internal;
__extension__ using Wide = __int128;

/// Boxes have corners at multiples of 1/`grid`. Coordinates are in units of 1/`units`, thresholds in 64ths.
constexpr std::int64_t grid = 1 << 11, units = 2 * grid * grid, threshold_units = 64;

/// Ranges of x, y and the m of both edges.
struct Sector_parameters {
  std::array<std::int64_t, 4> low, side;
};

/// Of the two edges of a sector, counterclockwise.
struct Octants {
  std::size_t first, second;
};
/// How sectors with edges in the same octant go around.
enum class Turn {
  LESS_THAN_HALF,
  ALMOST_FULL,
  FULL ///< of the only edge of a vertex; the fourth parameter does not matter
};

/// What is certain for a box.
enum class Answer { NO, YES, OPEN };

struct Range {
  std::int64_t least, greatest;
};

inline Range range_of(const Multilinear& f) {
  const auto [least, greatest] = std::minmax_element(f.at.begin(), f.at.end());
  return {*least, *greatest};
}

/// (constant + slope m) in both coordinates.
struct Octant_direction {
  std::array<int, 2> constant, slope;
  /// The axis that the edge follows more, and which way.
  std::size_t axis() const { return constant[0] != 0 ? 0 : 1; }
  int sign() const { return constant[axis()]; }
};

inline Octant_direction direction_in(std::size_t octant) {
  constexpr std::array<std::array<int, 4>, 8> all{{{1, 0, 0, 1},
                                                   {0, 1, 1, 0},
                                                   {0, 1, -1, 0},
                                                   {-1, 0, 0, 1},
                                                   {-1, 0, 0, -1},
                                                   {0, -1, -1, 0},
                                                   {0, -1, 1, 0},
                                                   {1, 0, 0, -1}}};
  const auto& d = all[octant];
  return {{d[0], d[1]}, {d[2], d[3]}};
}

/// A sector whose parameters are anywhere in a box.
class Sector_box {
public:
  Sector_box(const Octants& octants, Turn turn, const Sector_parameters& box)
      : box_(box), is_only_edge_(turn == Turn::FULL),
        eighths_(turn == Turn::LESS_THAN_HALF ? (octants.second + 8 - octants.first) % 8 : 8),
        directions_{direction_in(octants.first), direction_in(octants.second)} {
    for (std::size_t d = 0; d < number_of_parameters; ++d)
      for (std::size_t i = 0; i < number_of_box_corners; ++i)
        parameter_[d].at[i] = box.low[d] + ((i >> d & 1u) != 0 ? box.side[d] : 0);
    for (std::size_t d = 0; d < number_of_parameters; ++d) parameter_[d].parameters = 1u << d;
  }

  const Sector_parameters& box() const { return box_; }
  const Octant_direction& direction(std::size_t edge) const { return directions_[edge]; }
  bool is_only_edge() const { return is_only_edge_; }
  /// Octants from the first edge to the second one.
  std::size_t eighths() const { return eighths_; }
  /// The m of an edge, in units of 1/`grid`.
  const Multilinear& slope(std::size_t edge) const { return parameter_[is_only_edge_ ? 2 : 2 + edge]; }

  /// The edge's direction, in units of 1/`grid`.
  Multilinear direction_along(std::size_t edge, std::size_t axis) const {
    const Octant_direction& d = directions_[edge];
    return combination(slope(edge), d.slope[axis], d.constant[axis] * grid);
  }

  Moving_vertex vertex() const {
    return {combination(parameter_[0], 2 * grid, 0), combination(parameter_[1], 2 * grid, 0)};
  }
  static Moving_vertex corner(std::int64_t i, std::int64_t j) {
    Moving_vertex v;
    v.x.at.fill(units * i);
    v.y.at.fill(units * j);
    v.x.parameters = v.y.parameters = 0;
    return v;
  }

  /// The point of an edge at `ring_share / 2` times the ring's distance and `line_share / 2` times that of a grid line,
  /// along the edge's axis.
  Moving_vertex on_edge(std::size_t edge, int ring_share, int line_share, std::int64_t line) const {
    const Octant_direction& d = directions_[edge];
    const std::size_t a = d.axis();
    const std::int64_t radius =
        static_cast<std::int64_t>(threshold_units * vertex_ring.radius) * grid / threshold_units;
    std::array<Multilinear, 2> p;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      p[axis].parameters =
          (1u << axis) | (line_share != 0 ? 1u << a : 0) | (axis != a ? slope(edge).parameters : 0);
      for (std::size_t i = 0; i < number_of_box_corners; ++i) {
        const std::int64_t way =
            ring_share * radius + line_share * d.sign() * (line * grid - parameter_[a].at[i]);
        const std::int64_t step = d.constant[axis] * grid + d.slope[axis] * slope(edge).at[i];
        p[axis].at[i] = 2 * grid * parameter_[axis].at[i] + way * step;
      }
    }
    if (line_share == 2) p[a] = corner(line, line).x; // on the line, wherever the vertex is
    return {p[0], p[1]};
  }

  /// Grid lines are counted along the edge's axis, ahead; the leaf of the vertex is between 0 and 1.
  std::int64_t line_ahead(std::size_t edge, std::int64_t i) const {
    return directions_[edge].sign() > 0 ? i : 1 - i;
  }
  /// The first crossing, in lines ahead. In boxes no coordinate passes a quarter.
  std::int64_t first_crossing(std::size_t edge) const {
    const std::size_t a = directions_[edge].axis();
    const bool is_near =
        directions_[edge].sign() > 0 ? 4 * (box_.low[a] + box_.side[a]) <= grid : 4 * box_.low[a] >= 3 * grid;
    return is_near ? first_far_line : first_far_line + 1;
  }

  /// How far a corner is along an edge's direction, and to its left, from the vertex.
  Multilinear along(std::size_t edge, std::int64_t i, std::int64_t j) const { return turned(edge, i, j, 0); }
  Multilinear left_of(std::size_t edge, std::int64_t i, std::int64_t j) const {
    return turned(edge, i, j, 1);
  }

  /// Whether the sector has at least arccot(`cotangent`/100) degrees.
  Answer is_at_least(std::int64_t cotangent) const {
    if (eighths_ > 2) return Answer::YES;
    const Range r = range_of(sector_form(1, cotangent));
    return r.least >= 0 ? Answer::YES : r.greatest < 0 ? Answer::NO : Answer::OPEN;
  }
  /// Whether the same is true of the other side.
  Answer is_other_side_at_least(std::int64_t cotangent) const {
    if (eighths_ < 6 || is_only_edge_) return Answer::YES;
    const Range r = range_of(sector_form(-1, cotangent));
    return r.least >= 0 ? Answer::YES : r.greatest < 0 ? Answer::NO : Answer::OPEN;
  }

  /// Whether a corner is in the sector.
  Answer is_inside(std::int64_t i, std::int64_t j) const {
    if (is_only_edge_) return Answer::YES;
    const Range left = range_of(left_of(0, i, j)), right = negated(range_of(left_of(1, i, j)));
    const bool is_left = left.least > 0, is_right = right.least > 0;
    const bool is_not_left = left.greatest <= 0, is_not_right = right.greatest <= 0;
    if (eighths_ >= 5) { // more than half a turn
      if (is_left || is_right) return Answer::YES;
      return is_not_left && is_not_right ? Answer::NO : Answer::OPEN;
    }
    if (is_left && is_right) return Answer::YES;
    if (eighths_ <= 3) return is_not_left || is_not_right ? Answer::NO : Answer::OPEN;
    // About half a turn: the edge ahead of which the corner is decides.
    if (is_not_left && is_not_right) return Answer::NO;
    const bool is_ahead_of_first = range_of(along(0, i, j)).least > 0,
               is_ahead_of_second = range_of(along(1, i, j)).least > 0;
    if ((is_ahead_of_first && is_left) || (is_ahead_of_second && is_right)) return Answer::YES;
    if ((is_ahead_of_first && is_not_left) || (is_ahead_of_second && is_not_right)) return Answer::NO;
    return Answer::OPEN;
  }

  /// Whether a corner is at least so far from the vertex, in 64ths. What is within a millionth is open, which covers
  /// rounding errors of the rule.
  Answer is_clear_of_vertex(std::int64_t i, std::int64_t j, std::int64_t threshold) const {
    const std::array<std::int64_t, 2> corner{i * grid, j * grid};
    std::int64_t least = 0, greatest = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::int64_t below = corner[axis] - box_.low[axis], above = below - box_.side[axis];
      if (below < 0 || above > 0) least += std::min(below * below, above * above);
      greatest += std::max(below * below, above * above);
    }
    constexpr std::int64_t fine = 512;
    const std::int64_t t = threshold * grid / threshold_units * fine;
    if (least * fine * fine >= (t + 1) * (t + 1)) return Answer::YES;
    return greatest * fine * fine <= (t - 1) * (t - 1) ? Answer::NO : Answer::OPEN;
  }

  /// The same for an edge's line.
  Answer is_clear_of_edge(std::size_t edge, std::int64_t i, std::int64_t j, std::int64_t threshold) const {
    constexpr std::int64_t fine = 512;
    const Wide t = threshold * grid / threshold_units * fine;
    const Multilinear left = left_of(edge, i, j);
    const Range r = range_of(left);
    // The left side is the distance times a length between 1 and sqrt(2).
    const Wide least = r.least > 0      ? r.least
                       : r.greatest < 0 ? -r.greatest
                                        : 0,
               greatest = std::max(r.greatest, -r.least), scale = grid;
    if (least * least * fine * fine >= 2 * (t + 1) * (t + 1) * scale * scale) return Answer::YES;
    if (greatest * greatest * fine * fine <= (t - 1) * (t - 1) * scale * scale) return Answer::NO;
    if (is_product_positive(left, edge, fine, t + 1, 1)) return Answer::YES;
    return is_product_positive(left, edge, fine, t - 1, -1) ? Answer::NO : Answer::OPEN;
  }

private:
  static Range negated(const Range& r) { return {-r.greatest, -r.least}; }
  static Multilinear combination(const Multilinear& f, std::int64_t factor, std::int64_t constant) {
    Multilinear result;
    result.parameters = factor != 0 ? f.parameters : 0;
    for (std::size_t i = 0; i < number_of_box_corners; ++i) result.at[i] = factor * f.at[i] + constant;
    return result;
  }

  Multilinear turned(std::size_t edge, std::int64_t i, std::int64_t j, std::size_t quarter) const {
    const Octant_direction& d = directions_[edge];
    Multilinear result;
    result.parameters = 3u | slope(edge).parameters;
    for (std::size_t k = 0; k < number_of_box_corners; ++k) {
      const std::int64_t m = slope(edge).at[k];
      const std::int64_t dx = d.constant[0] * grid + d.slope[0] * m,
                         dy = d.constant[1] * grid + d.slope[1] * m;
      const std::int64_t u = i * grid - parameter_[0].at[k], w = j * grid - parameter_[1].at[k];
      result.at[k] = quarter == 0 ? dx * u + dy * w : dx * w - dy * u;
    }
    return result;
  }

  /// `cotangent` times the cross product of the directions, less 100 times the dot product.
  Multilinear sector_form(std::int64_t orientation, std::int64_t cotangent) const {
    Multilinear f;
    f.parameters = 12;
    for (std::size_t k = 0; k < number_of_box_corners; ++k) {
      std::array<std::array<std::int64_t, 2>, 2> d;
      for (std::size_t e = 0; e < 2; ++e)
        for (std::size_t axis = 0; axis < 2; ++axis)
          d[e][axis] = directions_[e].constant[axis] * grid + directions_[e].slope[axis] * slope(e).at[k];
      f.at[k] = cotangent * orientation * (d[0][0] * d[1][1] - d[0][1] * d[1][0]) -
                100 * (d[0][0] * d[1][0] + d[0][1] * d[1][1]);
    }
    return f;
  }

  /// Whether sign ((left fine)^2 - (t length of the direction)^2) is positive in the box.
  bool is_product_positive(const Multilinear& left, std::size_t edge, std::int64_t fine, Wide t,
                           int sign) const {
    const Product_form<Wide> form(left.parameters);
    Product_form<Wide>::Values l, m, one;
    Product_form<Wide>::Coefficients squared{}, length{};
    for (std::size_t k = 0; k < form.number_of_corners(); ++k) {
      l[k] = left.at[form.corner(k)];
      m[k] = slope(edge).at[form.corner(k)];
      one[k] = grid;
    }
    form.add(squared, l, l);
    form.add(length, m, m);
    form.add(length, one, one);
    for (std::size_t k = 0; k < form.size(); ++k)
      if (sign * (squared[k] * fine * fine - t * t * length[k]) <= 0) return false;
    return true;
  }

  Sector_parameters box_;
  bool is_only_edge_;
  std::size_t eighths_;
  std::array<Multilinear, 4> parameter_;
  std::array<Octant_direction, 2> directions_;
};

} // namespace vertex_certificates

#endif // QUADTREE_MESH_2_TEST_SECTOR_BOXES_H
