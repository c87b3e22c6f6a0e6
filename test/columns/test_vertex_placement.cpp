// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Stars of edges through random balanced quadtrees: vertices and columns together.

#include "column_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/columns/Column_placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_vertex_placement {

namespace {

using namespace column_test;
using namespace CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Point_index;
using CGAL::Quadtree_mesh_2::Vertex_index;

/// A vertex near the center of the root, and edges from it, in counterclockwise order.
Case random_star(Random& random) {
  const auto point = [](double x, double y) {
    const auto on_grid = [](double w) { return static_cast<std::uint32_t>(std::llround(w * unit)); };
    return Point{on_grid(x), on_grid(y)};
  };
  const double x = extent / 2 + 8 * random(), y = extent / 2 + 8 * random(),
               step = (least_sector + 0.1) * CGAL_PI / 180;
  Case c;
  c.points.push_back(point(x, y));
  const double first = random.below(4) == 0 ? random.below(8) * CGAL_PI / 4 : 2 * CGAL_PI * random();
  for (double a = first; a < first + 2 * CGAL_PI - step;
       a += step + (random.below(2) == 0 ? 0 : 2 * random())) {
    const double length = 65 + 30 * random();
    c.segments.push_back({Vertex_index(0), Vertex_index(c.points.size())});
    c.points.push_back(point(x + length * std::cos(a), y + length * std::sin(a)));
  }
  return c;
}

/// A tree with small leaves near the vertices, at random of one or two units.
Tree tree_of_star(Random& random, const Case& c) {
  const std::uint32_t side_at_vertices = unit << random.below(2);
  return random_tree(random, c.points, [=](const Point& low, std::uint32_t side) {
    return side > side_at_vertices && std::any_of(c.points.begin(), c.points.end(), [&](const Point& p) {
             const double margin = 4. * side_at_vertices, s = side;
             const double dx = double(p.x()) - double(low.x()), dy = double(p.y()) - double(low.y());
             return dx > -margin && dx < s + margin && dy > -margin && dy < s + margin;
           });
  });
}

struct Vertex {
  Grid_point place;
  double side; ///< of its leaf, in grid units
  Vertex_placement<std::uint32_t> placement;
};

Vertex vertex_of(const Tree& tree, Vertex_index v) {
  const Point_index i(v.value());
  const auto square = tree.square(tree.leaf(i));
  const std::uint32_t side = 1u << (Traits::depth - square.level);
  const Grid_point place = tree.framework().grid_point(tree.framework().rank(i));
  return {place, double(side), Vertex_placement<std::uint32_t>(place, side)};
}

Window_point direction_from(const Grid_point& a, const Grid_point& b) {
  const double x = double(b.x) - double(a.x), y = double(b.y) - double(a.y), length = std::hypot(x, y);
  return {x / length, y / length};
}

/// The mesh of a star, in units.
Cdt triangulation(const Tree& tree, const Case& c, Transition_rule rule) {
  auto corners = corners_of_leaves(tree);
  const auto drop = [&](const Grid_point& p) { corners.erase({p.x, p.y}); };
  Cdt cdt;
  const Vertex center = vertex_of(tree, Vertex_index(0));
  std::vector<Window_point> directions;
  for (const auto& s : c.segments) {
    const Line line = line_of_segment(tree, s);
    const Vertex other = vertex_of(tree, s[1]);
    const bool is_forwards = std::int64_t(line.u(center.place)) == line.first_u();
    const std::array<Vertex, 2> ends{is_forwards ? center : other, is_forwards ? other : center};
    const Window_point direction = direction_from(ends[0].place, ends[1].place);
    const Window_point back{-direction.x, -direction.y};
    const std::array<Edge_axis, 2> axes{Edge_axis{line.is_steep(), true}, Edge_axis{line.is_steep(), false}};
    const Edge_start first = ends[0].placement.start_of_edge(direction, axes[0]),
                     last = ends[1].placement.start_of_edge(back, axes[1]);
    const auto columns = columns_along(tree, leaves_of(tree, line), line);
    const auto reach_of = [&](std::size_t end, const Edge_start& start) {
      const std::int64_t u = line.u(ends[end].placement.corner()), side = ends[end].placement.side();
      return Column_placement<Tree>::End{u + side * start.first_line,
                                         u + side * axes[end].line(first_far_line)};
    };
    const std::array<Column_placement<Tree>::End, 2> reach{reach_of(0, first), reach_of(1, last)};
    const Column_placement<Tree> placement(tree, line, columns, rule, reach);
    placement.for_each_dropped_corner(drop);
    // Points along the edge.
    std::vector<Kernel::Point_2> chain;
    const auto append = [&](const Vertex& v, const Window_point& d, double t) {
      chain.push_back({(double(v.place.x) + t * d.x) / unit, (double(v.place.y) + t * d.y) / unit});
    };
    append(ends[0], direction, 0);
    for (const double distance : first.distances) append(ends[0], direction, distance * ends[0].side);
    placement.for_each_crossing([&](std::uint32_t u) {
      const double x = double(u) / unit, y = line.v_from(u, 0) / unit;
      chain.push_back(line.is_steep() ? Kernel::Point_2(y, x) : Kernel::Point_2(x, y));
    });
    for (std::size_t i = last.distances.size(); i-- > 0;)
      append(ends[1], back, last.distances[i] * ends[1].side);
    append(ends[1], back, 0);
    cdt.insert_constraint(chain.begin(), chain.end());
    const Window_point inwards = direction_from(other.place, center.place);
    other.placement.for_each_dropped_corner(inwards, inwards, drop);
    directions.push_back(direction_from(center.place, other.place));
  }
  for (std::size_t i = 0; i < directions.size(); ++i)
    center.placement.for_each_dropped_corner(directions[i], directions[(i + 1) % directions.size()], drop);
  std::vector<Kernel::Point_2> points;
  for (const auto& p : corners) points.push_back({double(p.first) / unit, double(p.second) / unit});
  cdt.insert(points.begin(), points.end());
  return cdt;
}

bool is_amid_equal_leaves(const Tree& tree, Vertex_index v) {
  const auto own = tree.square(tree.leaf(Point_index(v.value())));
  const std::int64_t side = std::int64_t(1) << (Traits::depth - own.level);
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    const auto other = tree.square(Leaf_index(i));
    const std::int64_t s = std::int64_t(1) << (Traits::depth - other.level);
    const auto is_near = [&](std::uint32_t own_low, std::uint32_t low) {
      return std::int64_t(low) < own_low + 4 * side && low + s > own_low - 3 * side;
    };
    if (is_near(own.x, other.x) && is_near(own.y, other.y) && other.level != own.level) return false;
  }
  return true;
}

void sweep(int n, std::uint64_t seed) {
  Random random{std::mt19937_64(seed)};
  double with_one = 180, with_better = 180;
  std::size_t before = 0, after = 0;
  int rounds = 0;
  for (int i = 0; i < n; ++i) {
    CAPTURE(i);
    const Case c = random_star(random);
    Tree tree = tree_of_star(random, c);
    before += tree.number_of_leaves();
    std::vector<Vertex_index> vertices;
    for (std::size_t v = 0; v < c.points.size(); ++v) vertices.push_back(Vertex_index(v));
    rounds = std::max(rounds, close(tree, c.segments, vertices));
    after += tree.number_of_leaves();
    for (const Vertex_index v : vertices) REQUIRE(is_amid_equal_leaves(tree, v));
    const double one = least_angle(triangulation(tree, c, Transition_rule::ONE_FOR_ALL), 12);
    const double better = least_angle(triangulation(tree, c, Transition_rule::BETTER_OF_TWO), 12);
    CHECK(std::min(one, better) >= least_angle_of_sectors);
    with_one = std::min(with_one, one);
    with_better = std::min(with_better, better);
  }
  if (n > 100)
    WARN(n << " stars: least angles " << with_one << " and " << with_better << ", leaves " << before
           << " and " << after << " after the closure, at most " << rounds << " rounds");
}

} // namespace

TEST_CASE("Stars of edges through random trees have no small angles", "[columns]") {
  sweep(is_full_run() ? 5 : 3, 1);
}

TEST_CASE("Stars of edges through many random trees have no small angles", "[columns][.slow]") {
  sweep(500, 2);
}

} // namespace test_vertex_placement
