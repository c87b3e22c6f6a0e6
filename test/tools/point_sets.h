// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_POINT_SETS_H
#define QUADTREE_MESH_2_TEST_POINT_SETS_H

// Point sets for meshes: those of the benchmarks, nasty ones, and small ones at random.

#include "quadtree_inputs.h"
#include "random_numbers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace point_sets {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Points = std::vector<Point>;

struct Named_points {
  std::string name;
  Points points;
};

inline Points moved(Points points, double scale, double x, double y) {
  for (Point& p : points) p = Point(scale * p.x() + x, scale * p.y() + y);
  return points;
}

inline Points joined(Points a, const Points& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline Points clustered(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  while (points.size() < n) {
    const double x = random(), y = random(), width = std::exp2(-2 - 12 * random());
    for (int i = 0; i < 20 && points.size() < n; ++i)
      points.emplace_back(x + width * random(), y + width * random());
  }
  return points;
}

/// Winds inward until its radius is `ratio` times the first.
inline Points spiral(std::size_t n, double ratio) {
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double share = double(i) / double(n), r = std::pow(ratio, share), angle = 2.4 * double(i);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return points;
}

/// On the circle of radius 65 around the origin: exactly.
inline Points lattice_circle() {
  Points points;
  for (const auto& [a, b] : {std::pair<int, int>{65, 0}, {63, 16}, {60, 25}, {56, 33}, {52, 39}})
    for (const int s : {-1, 1})
      for (const int t : {-1, 1}) {
        points.emplace_back(s * a, t * b);
        points.emplace_back(s * b, t * a);
      }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

inline Points circle(std::size_t n) {
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * double(i) / double(n);
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  return points;
}

/// n points, each with another one at a distance of `gap`.
inline Points close_pairs(std::size_t n, double gap, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  while (points.size() < n) {
    const double x = random(), y = random(), angle = 7 * random();
    points.emplace_back(x, y);
    points.emplace_back(x + gap * std::cos(angle), y + gap * std::sin(angle));
  }
  return points;
}

/// Clusters of five, each in the place of a point of a cluster that is `ratio` times as wide.
inline Points nested_clusters(std::size_t n, double ratio, int depth, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  while (points.size() < n) {
    double x = random(), y = random(), width = ratio;
    for (int d = 0; d < depth; ++d, width *= ratio) {
      for (int i = 0; i < 4; ++i) points.emplace_back(x + width * random(), y + width * random());
      x += width * random(), y += width * random();
    }
    points.emplace_back(x, y);
  }
  points.resize(n);
  return points;
}

inline Points horizontal_line(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  while (points.size() < n) points.emplace_back(random(), 0.3);
  return points;
}

inline Points duplicates(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  while (points.size() < n) points.emplace_back(std::floor(6 * random()), std::floor(6 * random()));
  return points;
}

/// One of each kind, of at most about `20 size` points.
inline std::vector<Named_points> nasty(std::size_t size) {
  const Points some = quadtree_inputs::uniform(5 + size, 5);
  return {{"none", {}},
          {"one", {{0.3, -7}}},
          {"one at the origin", {{0, 0}}},
          {"equal", {{0.3, -7}, {0.3, -7}, {0.3, -7}}},
          {"two", {{0, 0}, {1, 0.25}}},
          {"two nearby, far away", {{1e6, 1e6}, {1e6 + 1e-4, 1e6}}},
          {"three collinear", {{0, 0}, {1, 1}, {3, 3}}},
          {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
          {"uniform", quadtree_inputs::uniform(20 * size, 1)},
          {"clustered", clustered(15 * size, 2)},
          {"kuzmin", quadtree_inputs::kuzmin(15 * size, 3)},
          {"plummer", quadtree_inputs::plummer(15 * size, 4)},
          {"grid", quadtree_inputs::grid(10 * size, 0)},
          {"grid away from powers of two", moved(quadtree_inputs::grid(5 * size, 0), 0.1, 0.7, -0.3)},
          {"horizontal line", horizontal_line(5 * size, 6)},
          {"slanted line", quadtree_inputs::line(5 * size, 7)},
          {"spiral", spiral(10 * size, 0x1p-30)},
          {"spiral around another place", moved(spiral(6 * size, 0x1p-24), 0.3, 0.5, 0.7)},
          {"circle", circle(8 * size)},
          {"lattice circle", lattice_circle()},
          {"duplicates", duplicates(8 * size, 8)},
          {"near pairs among others", joined(some, close_pairs(2 * size, 1e-8, 9))},
          {"nested clusters", nested_clusters(6 * size, 1e-4, 3, 10)},
          {"near powers of two", {{0.5, 0.5}, {0.5 + 0x1p-20, 0.5 - 0x1p-20}, {0.25, 0.75}, {0.75, 0.25}}},
          {"far from the origin", moved(quadtree_inputs::uniform(3 * size, 11), 1e-3, 1e6, -1e6)},
          {"tiny", moved(quadtree_inputs::uniform(3 * size, 12), 1e-200, 0, 0)},
          {"huge", moved(quadtree_inputs::uniform(3 * size, 13), 1e200, -3e199, 0)}};
}

// --- small sets at random ---

/// Up to 60 points of one to four kinds in the unit square; coordinates are often short, points often on lines and
/// circles, and some a distance of 2^-45 or more from another.
class Random_small_set {
public:
  explicit Random_small_set(std::uint64_t seed) : random_(seed) {}

  Points operator()() {
    const std::size_t n = 2 + below(59), kinds = 1 + below(4);
    for (std::size_t k = 0; k < kinds; ++k) add(1 + below(1 + 2 * n / kinds));
    if (points_.size() > n) points_.resize(n);
    while (points_.size() < 2) points_.push_back(any());
    shuffle();
    return std::move(points_);
  }

private:
  Random_numbers random_;
  Points points_;

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() * double(n)); }
  Point any() {
    const double x = random_(), y = random_();
    return {x, y};
  }
  Point in_unit_square(double x, double y) const {
    return {std::min(std::max(x, 0.0), 1.0), std::min(std::max(y, 0.0), 1.0)};
  }
  void put(double x, double y) { points_.push_back(in_unit_square(x, y)); }

  void add(std::size_t n) {
    switch (below(8)) {
    case 0:
      return add_uniform(n);
    case 1:
      return add_lattice(n);
    case 2:
      return add_circle(n);
    case 3:
      return add_line(n);
    case 4:
      return add_near(n, 45);
    case 5:
      return add_near(n, 12);
    case 6:
      return add_cluster(n);
    default:
      return add_sequence(n);
    }
  }
  void add_uniform(std::size_t n) {
    while (n-- > 0) points_.push_back(any());
  }
  /// Integers, divided by a power of two.
  void add_lattice(std::size_t n) {
    const double units = std::exp2(double(1 + below(6)));
    while (n-- > 0) {
      const double x = std::floor(units * random_()), y = std::floor(units * random_());
      put(x / units, y / units);
    }
  }
  void add_circle(std::size_t n) {
    const Points all = lattice_circle();
    const Point c = any();
    const double scale = std::exp2(-double(7 + below(10)));
    const bool is_exact = below(2) == 0;
    while (n-- > 0) {
      const Point p = all[below(all.size())];
      const auto rounded = [&](double x) { return std::floor(x / scale) * scale; };
      put(p.x() * scale + (is_exact ? rounded(c.x()) : c.x()),
          p.y() * scale + (is_exact ? rounded(c.y()) : c.y()));
    }
  }
  void add_line(std::size_t n) {
    const Point p = any(), q = any();
    const std::size_t direction = below(4), steps = 1 + below(20);
    while (n-- > 0) {
      const double t = direction < 2 ? random_() : double(below(steps + 1)) / double(steps);
      put(p.x() + (direction % 2 == 0 ? t * (q.x() - p.x()) : 0), p.y() + t * (q.y() - p.y()));
    }
  }
  /// Near points that are there.
  void add_near(std::size_t n, std::size_t bits) {
    if (points_.empty()) points_.push_back(any());
    while (n-- > 0) {
      const Point p = points_[below(points_.size())];
      const double gap = std::exp2(-double(1 + below(bits))), angle = 7 * random_();
      switch (below(4)) {
      case 0:
        put(p.x() + gap, p.y());
        break;
      case 1:
        put(p.x(), p.y() - gap);
        break;
      case 2:
        put(p.x() + gap, p.y() + gap);
        break;
      default:
        put(p.x() + gap * std::cos(angle), p.y() + gap * std::sin(angle));
      }
    }
  }
  void add_cluster(std::size_t n) {
    const Point c = any();
    const double width = std::exp2(-double(1 + below(35)));
    while (n-- > 0) {
      const double x = random_(), y = random_();
      put(c.x() + width * x, c.y() + width * y);
    }
  }
  /// Toward a point, each a share nearer than the last.
  void add_sequence(std::size_t n) {
    const Point c = any(), d = any();
    const double share = std::exp2(-random_() * 3);
    double r = 1;
    for (; n-- > 0 && r > 0x1p-44; r *= share) put(c.x() + r * (d.x() - 0.5), c.y() + r * (d.y() - 0.5));
  }
  void shuffle() {
    for (std::size_t i = points_.size(); i > 1; --i) std::swap(points_[i - 1], points_[below(i)]);
  }
};

/// The least distance of two that are not equal, by brute force; infinite if there are none.
inline double least_distance(const Points& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (points[i] != points[j])
        least = std::min(least, std::hypot(points[i].x() - points[j].x(), points[i].y() - points[j].y()));
  return least;
}

} // namespace point_sets

#endif // QUADTREE_MESH_2_TEST_POINT_SETS_H
