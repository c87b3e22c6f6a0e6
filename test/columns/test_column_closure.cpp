// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Edges through random balanced quadtrees: the closure's conditions are checked by brute force over all leaves,
// and the least angle of the constrained Delaunay triangulation against the bounds of test_column_rule.cpp.

#include "column_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/columns/Column_placement.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace test_column_closure {

namespace {

using namespace column_test;
using namespace CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Vertex_index;

const auto nothing = [](const Point&, std::uint32_t) { return false; };

/// A line through the whole of the root, not far from its center; in units.
void add_line(Random& random, int kind, Case& c) {
  double slope = 2 * random() - 1;
  if (kind % 4 == 1) slope = random.below(2) == 0 ? -1 : 1;
  if (kind % 4 == 2) slope = (random.below(9) - 4) / 4.0;
  double middle = extent / 2 + 24 * (random() - 0.5);
  if (kind % 8 == 5) middle = std::floor(middle);
  const bool is_steep = random.below(2) == 0;
  const auto end = [&](double u) {
    const double v = middle + slope * (u - extent / 2);
    const auto on_grid = [](double w) { return static_cast<std::uint32_t>(std::llround(w * unit)); };
    return is_steep ? Point{on_grid(v), on_grid(u)} : Point{on_grid(u), on_grid(v)};
  };
  const std::size_t n = c.points.size();
  c.points.push_back(end(14));
  c.points.push_back(end(extent - 14));
  c.segments.push_back({Vertex_index(n), Vertex_index(n + 1)});
}

/// \name The conditions, from the definition
/// @{

int width_in_units(const Tree&, int level) { return 1 << (fine_level - level); }

/// For each unit of u the width of its column, 0 beyond the ends of the edge.
std::vector<int> column_widths(const Tree& tree, const Line& line) {
  std::vector<int> widths(extent, 0);
  for (const Leaf_index l : leaves_of(tree, line)) {
    const auto square = tree.square(l);
    const int width = width_in_units(tree, square.level);
    const auto first = line.u({square.x, square.y}) / unit;
    for (auto u = first; u < first + static_cast<std::uint32_t>(width); ++u)
      widths[u] = widths[u] == 0 ? width : std::min(widths[u], width);
  }
  return widths;
}

/// Widths of columns one after the other; columns that begin at aligned places.
std::vector<std::pair<int, int>> columns_of(const std::vector<int>& widths) {
  std::vector<std::pair<int, int>> columns;
  for (std::size_t u = 0; u < widths.size(); ++u)
    if (widths[u] > 0 && static_cast<int>(u) % widths[u] == 0)
      columns.push_back({static_cast<int>(u), widths[u]});
  return columns;
}

bool have_columns_good_lengths(const std::vector<std::pair<int, int>>& columns,
                               const Column_closure_options& o) {
  std::vector<std::pair<int, std::size_t>> runs; // width and length
  for (const auto& c : columns) {
    if (runs.empty() || runs.back().first != c.second) runs.push_back({c.second, 0});
    ++runs.back().second;
  }
  for (std::size_t i = 0; i + 1 < runs.size(); ++i)
    if (std::max(runs[i].first, runs[i + 1].first) != 2 * std::min(runs[i].first, runs[i + 1].first))
      return false;
  if (runs.size() > 1 && std::min(runs.front().second, runs.back().second) < o.columns_at_ends) return false;
  if (runs.size() == 1 && runs[0].second < o.columns_between_ends) return false;
  for (std::size_t i = 1; i + 1 < runs.size(); ++i) {
    const int wider =
        (runs[i - 1].first > runs[i].first ? 1 : 0) + (runs[i + 1].first > runs[i].first ? 1 : 0);
    if (runs[i].second < (wider == 0 ? 4u : wider == 1 ? 5u : 6u)) return false;
  }
  return true;
}

/// Whether all leaves in the band over a column have its width as side.
bool is_band_equal(const Tree& tree, const Line& line, int u, int width, int band) {
  const double left = line.v_from(static_cast<std::int64_t>(u) * unit, 0) / unit;
  const double right = line.v_from(static_cast<std::int64_t>(u + width) * unit, 0) / unit;
  const double low = std::min(left, right) - band, high = std::max(left, right) + band;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    const auto square = tree.square(Leaf_index(i));
    const int side = width_in_units(tree, square.level);
    const double x = double(line.u({square.x, square.y})) / unit,
                 y = double(line.v({square.x, square.y})) / unit;
    if (x >= u + width || x + side <= u || y >= high || y + side <= low) continue;
    if (side != width) return false;
  }
  return true;
}

bool is_closed(const Tree& tree, const Line& line, const Column_closure_options& options) {
  const auto columns = columns_of(column_widths(tree, line));
  if (!have_columns_good_lengths(columns, options)) return false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    int widest = columns[i].second;
    for (std::size_t j = i < 3 ? 0 : i - 3; j < std::min(columns.size(), i + 4); ++j)
      widest = std::max(widest, columns[j].second);
    if (!is_band_equal(tree, line, columns[i].first, columns[i].second, options.band * widest)) return false;
  }
  return true;
}

/// @}

/// Crossings, and corners that are not dropped; in units.
Cdt triangulation(const Tree& tree, const Line& line, Transition_rule rule) {
  const Columns columns = columns_along(tree, leaves_of(tree, line), line);
  const Column_placement<Tree> placement(tree, line, columns, rule);
  auto corners = corners_of_leaves(tree);
  placement.for_each_dropped_corner([&](const Grid_point& p) { corners.erase({p.x, p.y}); });
  std::vector<Kernel::Point_2> crossings;
  placement.for_each_crossing([&](std::uint32_t u) {
    const double x = double(u) / unit, y = line.v_from(u, 0) / unit;
    crossings.push_back(line.is_steep() ? Kernel::Point_2(y, x) : Kernel::Point_2(x, y));
  });
  Cdt cdt;
  cdt.insert_constraint(crossings.begin(), crossings.end());
  std::vector<Kernel::Point_2> points;
  for (const auto& c : corners) points.push_back({double(c.first) / unit, double(c.second) / unit});
  cdt.insert(points.begin(), points.end());
  return cdt;
}

struct Least_angles {
  double one_rule = 180, better_of_two = 180;
};

void sweep(int n, std::uint64_t seed, Least_angles& least) {
  Random random{std::mt19937_64(seed)};
  std::size_t before = 0, after = 0;
  int rounds = 0;
  for (int i = 0; i < n; ++i) {
    CAPTURE(i);
    Case c;
    add_line(random, i, c);
    Tree tree = random_tree(random, c.points, nothing);
    before += tree.number_of_leaves();
    rounds = std::max(rounds, close(tree, c.segments));
    after += tree.number_of_leaves();
    REQUIRE(tree.depth() <= fine_level);
    const Line line = line_of_segment(tree, c.segments[0]);
    REQUIRE(is_closed(tree, line, {}));
    least.one_rule =
        std::min(least.one_rule, least_angle(triangulation(tree, line, Transition_rule::ONE_FOR_ALL), 48));
    const double better = least_angle(triangulation(tree, line, Transition_rule::BETTER_OF_TWO), 48);
    least.better_of_two = std::min(least.better_of_two, better);
  }
  if (n >= 500)
    WARN(n << " trees: least angles " << least.one_rule << " and " << least.better_of_two << ", leaves "
           << before << " and " << after << " after the closure, at most " << rounds << " rounds");
}

} // namespace

TEST_CASE("Lines are functions of the coordinate that changes more", "[columns]") {
  const Line line({10, 20}, {4, 19});
  CHECK_FALSE(line.is_steep());
  CHECK((line.first_u() == 4 && line.last_u() == 10));
  CHECK(line.slope() == Approx(1 / 6.));
  CHECK((line.floor_of_v(4) == 19 && line.ceiling_of_v(4) == 19));
  CHECK((line.floor_of_v(5) == 19 && line.ceiling_of_v(5) == 20));
  CHECK((line.floor_of_v(3) == 18 && line.ceiling_of_v(3) == 19));
  CHECK(line.v_from(7, 19) == Approx(0.5));
  const Line steep({20, 10}, {19, 4});
  CHECK(steep.is_steep());
  CHECK((steep.first_u() == 4 && steep.floor_of_v(5) == 19));
  const Line point({7, 5}, {7, 5});
  CHECK((point.slope() == 0 && point.floor_of_v(9) == 5 && point.ceiling_of_v(9) == 5));
  const std::uint64_t far = (std::uint64_t(1) << 62) - 1;
  const Edge_line<std::uint64_t> longest({0, 0}, {far, far - 1});
  CHECK(longest.floor_of_v(static_cast<std::int64_t>(far)) == static_cast<std::int64_t>(far - 1));
}

TEST_CASE("Equal leaves are in columns already", "[columns]") {
  Random random{std::mt19937_64(1)};
  Case c;
  for (int i = 0; i < 8; ++i) add_line(random, i, c);
  for (const int level : {0, 1, 5}) {
    const auto must_split = [&](const Point& low, const Point& high) {
      return high.x() - low.x() > 1u << (Traits::depth - level);
    };
    CGAL::Quadtree_options options;
    options.max_points_per_leaf(100);
    Tree tree(c.points, options, must_split);
    Column_closure_options of_any_length;
    of_any_length.columns_between_ends = 0;
    CHECK(close(tree, c.segments, {}, of_any_length) == 0);
    CHECK(to_split<CGAL::Sequential_tag>(tree, {}, {}).empty());
    // Short edges in large leaves.
    close(tree, c.segments);
    for (const auto& s : c.segments) CHECK(is_closed(tree, line_of_segment(tree, s), {}));
  }
}

TEST_CASE("Closure makes columns of several edges, and stops", "[columns]") {
  Random random{std::mt19937_64(2)};
  for (int i = 0; i < 3; ++i) {
    Case c;
    for (int k = 0; k < 3; ++k) add_line(random, i + k, c);
    Tree tree = random_tree(random, c.points, nothing);
    close(tree, c.segments);
    CHECK(tree.depth() <= fine_level);
    for (const auto& s : c.segments) CHECK(is_closed(tree, line_of_segment(tree, s), {}));
  }
}

TEST_CASE("Edges through random trees have the angles of the column rule", "[columns]") {
  Least_angles least;
  sweep(is_full_run() ? 12 : 6, 77, least); // lines of all kinds
  CHECK(least.one_rule >= 21.5);
  CHECK(least.better_of_two >= 26.3);
}

TEST_CASE("Edges through many random trees have the angles of the column rule", "[columns][.slow]") {
  Least_angles least;
  sweep(1000, 78, least);
  CHECK(least.one_rule >= 21.5);
  CHECK(least.better_of_two >= 26.3);
}

} // namespace test_column_closure
