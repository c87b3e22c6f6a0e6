// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_COLUMN_CERTIFICATES_H
#define QUADTREE_MESH_2_TEST_COLUMN_CERTIFICATES_H

// What is proven here, in exact arithmetic, for every edge y = m x + b with -1 <= m <= 1, in columns of leaves
// that have one size in a band around it, 3 coarse sides up and down:
// - amid equal leaves, the vertices that the column rule keeps have a triangulation above the edge with all angles
//   at least 31.6 degrees;
// - at a change of sizes 21.5 degrees with one vector of thresholds, 26.3 with the better of two.
// As the constrained Delaunay triangulation has the largest least angle of all, no angle of it is smaller, or
// smaller than those in leaves that keep all their corners and hanging nodes and do not meet the edge ("whole"
// ones). By symmetry it holds below the edge, for fine columns on the left, and for |m| > 1 with x and y
// exchanged.
//
// How: branch and bound over boxes of (m, b); b from 0 to 1 suffices, as leaves repeat.
// - Whether a corner is kept in all of the box, or nowhere, follows from the signs of a quadratic polynomial in
//   Bernstein form; thresholds are taken a millionth wider, which covers rounding errors of the rule. What stays
//   open is tried both ways, in all combinations.
// - For each combination some triangulation is found (in floating point, which does not matter) and kept for the
//   whole box: points on the edge are affine in (m, b), angles bounded by quadratic polynomials.
// - That it is a triangulation follows from its combinatorics: all triangles are counterclockwise, the sides that
//   have a triangle on one side only are those of the window, and all vertices are used.
// - Whole leaves are unions of its triangles, so it can be cut down to the others. These have neighbors across
//   sides within the band only. So outside the band leaves may be of any size, and windows fit together.

#include "moving_triangles.h"

#include <CGAL/Quadtree_mesh_2/internal/columns/Column_window.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace column_certificates {

using namespace CGAL::Quadtree_mesh_2::internal;

/// Slopes and offsets of boxes are multiples of 1/`grid`. Coordinates are in units of 1/(2 `grid`).
constexpr std::int64_t grid = 1 << 14;
/// The band, in coarse sides.
constexpr std::int64_t band = 3;

/// A range with this least angle. The other bound does not matter.
inline Cotangent_range at_least(double degrees) { return {degrees, 179}; }

/// A vertex, with coordinates in half coarse sides; y does not matter on the edge.
struct Vertex {
  std::int64_t x, y;
  bool is_on_edge;
};

inline Affine line_at(std::int64_t x) { return {0, x, 2}; }
inline Affine height_above_line(std::int64_t x, std::int64_t y) {
  return Affine{grid * y, 0, 0} - line_at(x);
}

inline Moving_point moving(const Vertex& v) {
  return {Affine{grid * v.x, 0, 0}, v.is_on_edge ? line_at(v.x) : Affine{grid * v.y, 0, 0}};
}

inline std::pair<std::int64_t, std::int64_t> range_over(const Parameter_box& box, const Affine& f) {
  std::pair<std::int64_t, std::int64_t> range{INT64_MAX, INT64_MIN};
  for (const Integer_point& d : box.corners()) {
    const std::int64_t value = f.constant + d[0] * f.x + d[1] * f.y;
    range = {std::min(range.first, value), std::max(range.second, value)};
  }
  return range;
}

/// Whether all points of the box have (y - m x - b)^2 > (threshold sqrt(1 + m^2))^2, or all less, by `sign`; the
/// threshold is in millionths of half a coarse side.
inline bool is_certain(const Parameter_box& box, const Affine& height, std::int64_t threshold, int sign) {
  constexpr Wide millionths = 1000000;
  const Wide squared_threshold = static_cast<Wide>(threshold) * threshold;
  const Affine h = over(box, height), slope = over(box, {0, 1, 0}), one{grid, 0, 0};
  Bernstein_form::Coefficients c{};
  add_product(c, h, h, sign * millionths * millionths);
  add_product(c, slope, slope, -sign * squared_threshold);
  add_product(c, one, one, -sign * squared_threshold);
  return Bernstein_form(c).is_positive();
}

/// Answers to open questions, one combination after the other.
class Combinations {
public:
  bool next_answer() {
    if (next_ == answers_.size()) answers_.push_back(false);
    return answers_[next_++];
  }
  /// Goes on to the next combination, if there is one.
  bool advance() {
    answers_.resize(next_);
    next_ = 0;
    while (!answers_.empty() && answers_.back()) answers_.pop_back();
    if (answers_.empty()) return false;
    return answers_.back() = true;
  }
  std::size_t number_of_questions() const { return next_; }

private:
  std::vector<bool> answers_;
  std::size_t next_ = 0;
};

/// Whether a corner above the line has at least a distance, in coarse sides.
inline bool decide(const Parameter_box& box, std::int64_t x, std::int64_t y, double least,
                   Combinations& open) {
  const Affine height = height_above_line(x, y);
  const auto heights = range_over(box, height);
  if (heights.second <= 0) return false;
  const auto threshold = static_cast<std::int64_t>(std::llround(2e6 * least));
  if (heights.first > 0 && is_certain(box, height, threshold + 2, 1)) return true;
  if (is_certain(box, height, threshold - 2, -1)) return false;
  return open.next_answer();
}

/// The vertices above the edge, by grid lines, upwards.
using Vertex_columns = std::vector<std::vector<Vertex>>;

/// A row above which all corners are kept: 3 sqrt(1/2) is more than all thresholds.
inline std::int64_t top_row(const Parameter_box& box) {
  const std::int64_t highest =
      std::max(range_over(box, line_at(-4)).second, range_over(box, line_at(3)).second);
  return 2 * ((highest + 2 * grid - 1) / (2 * grid) + band);
}
/// A row of the coarse grid below the line.
inline std::int64_t lowest_row(const Parameter_box& box, std::int64_t x) {
  return 2 * (range_over(box, line_at(x)).first / (2 * grid) - 1);
}

/// The corner's own threshold, as the rule gives it for grid line c.
inline bool is_kept(const Transition_thresholds& t, const Parameter_box& box, std::size_t c, const Vertex& v,
                    const std::set<std::int64_t>& kept_before, Combinations& open) {
  const bool is_hanging = c == 2 && v.y % 2 != 0;
  const Column_place place = Column_window::place(c, is_hanging);
  const double unit = place == Column_place::EQUAL_LEAVES ? Column_window::unit(c) : 1;
  const auto has_distance = [&](Opposite_corners o) {
    return decide(box, v.x, v.y, unit * least_distance(place, t, o), open);
  };
  if (!has_distance(Opposite_corners::BOTH_KEPT)) return false;
  if (!is_hanging || (kept_before.count(v.y - 1) > 0 && kept_before.count(v.y + 1) > 0)) return true;
  return has_distance(Opposite_corners::NOT_BOTH_KEPT);
}

inline Vertex_columns kept_vertices(const Transition_thresholds& t, const Parameter_box& box,
                                    Combinations& open) {
  Vertex_columns columns;
  std::set<std::int64_t> kept_before;
  for (std::size_t c = 0; c < Column_window::number_of_columns; ++c) {
    const auto x = static_cast<std::int64_t>(2 * Column_window::column(c));
    const auto step = static_cast<std::int64_t>(2 * Column_window::step(c));
    std::vector<Vertex> column{{x, 0, true}};
    for (std::int64_t y = lowest_row(box, x); y <= top_row(box); y += step)
      if (is_kept(t, box, c, {x, y, false}, kept_before, open)) {
        column.push_back({x, y, false});
        if (c == 1) kept_before.insert(y);
      }
    columns.push_back(std::move(column));
  }
  return columns;
}

/// A triangulation of the window for all of a box.
class Window {
public:
  Window(const Vertex_columns& columns, const Parameter_box& box) : columns_(columns), box_(box) {
    std::array<std::size_t, Column_window::number_of_columns + 1> begins{};
    std::vector<Column_window::Point> points;
    const double m = (double(box.x) + 0.5 * double(box.side)) / double(grid),
                 b = (double(box.y) + 0.5 * double(box.side)) / double(grid);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      for (const Vertex& v : columns[c]) {
        vertices_.push_back(v);
        const double x = double(v.x) / 2;
        points.push_back({x, v.is_on_edge ? m * x + b : double(v.y) / 2});
      }
      begins[c + 1] = vertices_.size();
    }
    const Column_window window(points, begins);
    for (std::size_t t = 0; t < window.number_of_triangles(); ++t) {
      const auto& v = window.triangle(t).vertices;
      triangles_.push_back({v[0], v[1], v[2]});
    }
    for (const auto& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i)
        are_sides_different_ &= sides_.insert({t[i], t[(i + 1) % 3]}).second;
  }

  bool is_good(const Cotangent_range& range) const {
    return std::all_of(triangles_.begin(), triangles_.end(), [&](const std::array<std::size_t, 3>& t) {
      return has_angles_within(
          range, {moving(vertices_[t[0]]), moving(vertices_[t[1]]), moving(vertices_[t[2]])}, box_);
    });
  }

  /// Whether counterclockwise triangles cover the window once and use all vertices: by Euler's formula, with the
  /// number of triangles.
  bool is_complete() const {
    std::set<std::pair<std::size_t, std::size_t>> open;
    for (const auto& s : sides_)
      if (sides_.count({s.second, s.first}) == 0) open.insert(s);
    const auto boundary = sides_of_window();
    return are_sides_different_ && open == boundary &&
           triangles_.size() == 2 * vertices_.size() - boundary.size() - 2;
  }

  /// Whether sides of whole leaves are sides of triangles and the others have all neighbors in the band.
  bool fits_leaves() const {
    for (std::size_t c = 0; c + 1 < columns_.size(); ++c) {
      const std::int64_t left = columns_[c][0].x, right = columns_[c + 1][0].x, side = right - left;
      for (std::int64_t y = lowest_row(box_, left) - 2 * band; y < top_row(box_); y += side)
        if (!is_whole(c, left, right, y) && !has_neighbors_in_band(left, right, y)) return false;
    }
    return true;
  }

private:
  /// From edge to edge counterclockwise: the vertices on grid lines are numbered upwards, and one after the other.
  std::set<std::pair<std::size_t, std::size_t>> sides_of_window() const {
    std::set<std::pair<std::size_t, std::size_t>> sides;
    std::size_t first = 0;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const std::size_t last = first + columns_[c].size() - 1;
      if (c + 1 < columns_.size()) sides.insert({first, last + 1});
      if (c > 0) sides.insert({last, first - 1});
      const bool goes_up = c + 1 == columns_.size();
      if (c == 0 || goes_up)
        for (std::size_t v = first; v < last; ++v)
          sides.insert(goes_up ? std::make_pair(v, v + 1) : std::make_pair(v + 1, v));
      first = last + 1;
    }
    return sides;
  }

  std::optional<std::size_t> find(std::int64_t x, std::int64_t y) const {
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      if (!vertices_[v].is_on_edge && vertices_[v].x == x && vertices_[v].y == y) return v;
    return std::nullopt;
  }

  /// Whether the leaf with this lower side in strip c keeps its corners and hanging node and is cut out by sides.
  bool is_whole(std::size_t c, std::int64_t left, std::int64_t right, std::int64_t y) const {
    const std::int64_t top = y + right - left;
    std::vector<Integer_point> corners{{left, y}, {right, y}};
    if (c == 1) corners.push_back({right, y + 1});
    corners.push_back({right, top});
    corners.push_back({left, top});
    std::vector<std::size_t> around;
    for (const Integer_point& p : corners) {
      const auto v = find(p[0], p[1]);
      if (!v) return false;
      around.push_back(*v);
    }
    for (std::size_t i = 0; i < around.size(); ++i)
      if (sides_.count({around[i], around[(i + 1) % around.size()]}) == 0) return false;
    return true;
  }

  /// Neighbors beside the leaf begin at its lower side, that above it at its upper side.
  bool has_neighbors_in_band(std::int64_t left, std::int64_t right, std::int64_t y) const {
    const auto is_in_band = [&](std::int64_t x, std::int64_t row) {
      return range_over(box_, height_above_line(x, row)).second < band * 2 * grid;
    };
    const std::int64_t top = y + right - left;
    return is_in_band(left, y) && is_in_band(right, y) && (is_in_band(left, top) || is_in_band(right, top));
  }

  const Vertex_columns& columns_;
  Parameter_box box_;
  std::vector<Vertex> vertices_;
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::set<std::pair<std::size_t, std::size_t>> sides_;
  bool are_sides_different_ = true;
};

constexpr std::size_t max_questions = 8;

inline bool has_top_row(const Vertex_columns& columns, std::int64_t top) {
  return std::all_of(columns.begin(), columns.end(), [&](const auto& c) { return c.back().y == top; });
}

/// Whether a vector of thresholds is good for all edges of the box.
inline bool is_good_for(const Transition_thresholds& t, const Cotangent_range& range,
                        const Parameter_box& box) {
  Combinations open;
  do {
    const Vertex_columns columns = kept_vertices(t, box, open);
    if (open.number_of_questions() > max_questions) return false;
    if (!has_top_row(columns, top_row(box))) return false;
    const Window window(columns, box);
    if (!window.is_good(range) || !window.is_complete() || !window.fits_leaves()) return false;
  } while (open.advance());
  return true;
}

/// The lowest row whose corners and those above it are kept on both grid lines; above it leaves are whole.
inline std::int64_t first_whole_row(const std::array<std::vector<std::int64_t>, 2>& kept, std::int64_t top) {
  std::int64_t row = top;
  const auto has = [](const std::vector<std::int64_t>& rows, std::int64_t y) {
    return std::find(rows.begin(), rows.end(), y) != rows.end();
  };
  while (has(kept[0], row - 2) && has(kept[1], row - 2)) row -= 2;
  return row;
}

/// Whether the strip between two lines of equal leaves has a good triangulation up to the whole leaves. Each
/// triangle has a side on one of the lines; those that can be reached from the edge are found row by row.
inline bool has_good_strip(const std::array<std::vector<Vertex>, 2>& lines, const Cotangent_range& range,
                           const Parameter_box& box) {
  std::vector<std::vector<bool>> is_reached(lines[0].size(), std::vector<bool>(lines[1].size(), false));
  is_reached[0][0] = true;
  for (std::size_t l = 0; l < lines[0].size(); ++l)
    for (std::size_t r = 0; r < lines[1].size(); ++r) {
      if (!is_reached[l][r]) continue;
      const Moving_point a = moving(lines[0][l]), b = moving(lines[1][r]);
      if (l + 1 < lines[0].size() && has_angles_within(range, {a, b, moving(lines[0][l + 1])}, box))
        is_reached[l + 1][r] = true;
      if (r + 1 < lines[1].size() && has_angles_within(range, {a, b, moving(lines[1][r + 1])}, box))
        is_reached[l][r + 1] = true;
    }
  return is_reached.back().back();
}

/// Whether the rule for equal leaves of side 1 is good between x = 0 and x = 1.
inline bool is_good_for_equal_leaves(double threshold, const Cotangent_range& range,
                                     const Parameter_box& box) {
  Combinations open;
  const std::int64_t top = top_row(box);
  do {
    std::array<std::vector<std::int64_t>, 2> kept;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::int64_t y = -4; y <= top; y += 2)
        if (decide(box, 2 * static_cast<std::int64_t>(i), y, threshold, open)) kept[i].push_back(y);
    if (open.number_of_questions() > max_questions) return false;
    const std::int64_t row = first_whole_row(kept, top);
    std::array<std::vector<Vertex>, 2> lines;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::int64_t x = 2 * static_cast<std::int64_t>(i);
      // The leaf below that row has its neighbors in the band.
      if (range_over(box, height_above_line(x, row)).second >= 2 * grid * band) return false;
      lines[i].push_back({x, 0, true});
      for (const std::int64_t y : kept[i])
        if (y <= row) lines[i].push_back({x, y, false});
    }
    if (!has_good_strip(lines, range, box)) return false;
  } while (open.advance());
  return true;
}

struct Certificate {
  bool is_proven = false;
  std::size_t number_of_boxes = 0;
  std::int64_t least_side = 2 * grid;
};

/// Divides all slopes and offsets into boxes that are good, if possible.
template <class Is_good>
Certificate certify(Is_good is_good) {
  Certificate result;
  std::vector<Parameter_box> left{{-grid, 0, grid}, {0, 0, grid}};
  while (!left.empty()) {
    const Parameter_box box = left.back();
    left.pop_back();
    if (box.side <= grid / 8 && is_good(box)) {
      ++result.number_of_boxes;
      result.least_side = std::min(result.least_side, box.side);
    } else {
      if (box.side == 1) return result;
      for (const Parameter_box& quarter : box.quarters()) left.push_back(quarter);
    }
  }
  result.is_proven = true;
  return result;
}

inline Certificate certify_equal_leaves(double degrees) {
  const Cotangent_range range = at_least(degrees);
  return certify(
      [&](const Parameter_box& box) { return is_good_for_equal_leaves(equal_leaves_threshold, range, box); });
}

/// That one of the vectors is good in each box.
inline Certificate certify_transitions(const std::vector<Transition_thresholds>& rules, double degrees) {
  const Cotangent_range range = at_least(degrees);
  return certify([&](const Parameter_box& box) {
    return std::any_of(rules.begin(), rules.end(),
                       [&](const Transition_thresholds& t) { return is_good_for(t, range, box); });
  });
}

} // namespace column_certificates

#endif // QUADTREE_MESH_2_TEST_COLUMN_CERTIFICATES_H
