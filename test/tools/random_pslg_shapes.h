// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// More families of inputs that are hard to mesh, small and by number like those of random_pslg.h: each seed
// gives another valid one.

#ifndef QUADTREE_MESH_2_TEST_RANDOM_PSLG_SHAPES_H
#define QUADTREE_MESH_2_TEST_RANDOM_PSLG_SHAPES_H

#include "random_pslg.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace random_pslg {

/// 10 to the power of a number in [low, high).
inline double power_of_ten(Random& random, double low, double high) {
  return std::pow(10, random.between(low, high));
}

/// Adds a segment between two new vertices unless it would meet another one.
inline void add_if_free(Builder& b, const Point& p, const Point& q) {
  if (p == q || !b.is_free(p, q, no_vertex)) return;
  const std::size_t v = b.vertex(p);
  b.segment(v, b.vertex(q));
}

/// A simple polygon through random points: crossings of a random tour are undone until there are none. Every
/// step makes the tour shorter, so this ends.
inline Pslg polygon(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> tour;
  const double flatness = power_of_ten(random, -3, 0);
  for (int k = random.integer(3, 30); k > 0; --k)
    tour.emplace_back(random.between(0, 1), flatness * random.between(0, 1));
  const auto uncross = [&tour] {
    for (std::size_t i = 0; i < tour.size(); ++i)
      for (std::size_t j = i + 2; j < tour.size(); ++j) {
        const std::size_t end = (j + 1) % tour.size();
        if (end == i || !CGAL::do_intersect(Kernel::Segment_2(tour[i], tour[i + 1]),
                                            Kernel::Segment_2(tour[j], tour[end])))
          continue;
        std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     tour.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        return true;
      }
    return false;
  };
  while (uncross()) {
  }
  Builder b;
  b.loop(tour);
  return b.pslg;
}

/// All spokes of a circle, or of a sector, from 0.1 to 30 degrees apart, at most 400 of them; of one length,
/// of lengths in turns, or of random lengths.
inline Pslg fan(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_box(b, random, 2);
  const std::size_t center = b.vertex(Point(random.between(-0.1, 0.1), random.between(-0.1, 0.1)));
  const Point o = b.pslg.vertices[center];
  const double step = power_of_ten(random, -1, 1.48) * CGAL_PI / 180;
  const int spokes = std::min(random.integer(3, 400), static_cast<int>(2 * CGAL_PI / step));
  const int kind = random.integer(0, 2);
  const double begin = random.between(0, 2 * CGAL_PI), ratio = random.between(0.3, 0.99);
  for (int i = 0; i < spokes; ++i) {
    const double length = kind == 0 ? 1 : kind == 1 ? (i % 2 == 0 ? 1 : ratio) : random.between(0.05, 1);
    b.segment(center, b.vertex(polar(o, length, begin + i * step)));
  }
  return b.pslg;
}

/// Bundles of segments that are parallel or nearly so, with gaps down to a two-thousandth of their lengths:
/// any mesh with a bound on angles has at least as many triangles as gaps fit in the length.
inline Pslg near_parallel(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_box(b, random, 2);
  for (int bundles = random.integer(1, 3); bundles > 0; --bundles) {
    Point p(random.between(-1, 1), random.between(-1, 1));
    const double angle = random.between(0, 2 * CGAL_PI), length = power_of_ten(random, -1, 0);
    const double gap = length * power_of_ten(random, -3.3, -1);
    const double turn = random.integer(0, 1) == 0 ? 0 : gap * random.between(-0.5, 0.5);
    for (int k = random.integer(2, 6); k > 0; --k) {
      add_if_free(b, p, polar(p, length * random.between(0.7, 1), angle + k * turn));
      p = polar(polar(p, gap, angle + CGAL_PI / 2), length * random.between(-0.3, 0.3), angle);
    }
  }
  return b.pslg;
}

/// Points, ends of segments and corners that all but touch other segments, at distances down to 1e-12.
inline Pslg near_touching(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_box(b, random, 2);
  for (int k = random.integer(1, 4); k > 0; --k) {
    const Point p(random.between(-1, 1), random.between(-1, 1));
    const double angle = random.between(0, 2 * CGAL_PI), length = random.between(0.2, 1);
    add_if_free(b, p, polar(p, length, angle));
    for (int others = random.integer(1, 3); others > 0; --others) {
      const double side = random.integer(0, 1) == 0 ? CGAL_PI / 2 : -CGAL_PI / 2;
      const Point foot = polar(p, length * random.between(-0.01, 1.01), angle);
      const Point tip = polar(foot, power_of_ten(random, -12, -1), angle + side);
      const double leave = angle + side * random.between(0.1, 1.9);
      const Point end = polar(tip, random.between(0.01, 0.5), leave);
      if (random.integer(0, 2) == 0)
        b.vertex(tip);
      else
        add_if_free(b, tip, end);
    }
  }
  return b.pslg;
}

/// Koch's snowflake, scaled and turned, with bumps out, in or both at random.
inline Pslg koch(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> curve;
  const double turn = random.between(0, 2 * CGAL_PI), scale = power_of_ten(random, -6, 6);
  for (int i = 0; i < 3; ++i) curve.push_back(polar(Point(0, 0), scale, turn + 2 * CGAL_PI * i / 3));
  const int kind = random.integer(0, 2);
  // Above a half of the height of an equilateral triangle, bumps on both sides could meet.
  const double height = kind == 0 ? std::sqrt(0.75) / 3 : 0.22;
  for (int level = random.integer(1, 4); level > 0; --level) {
    std::vector<Point> next;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Point &p = curve[i], &q = curve[(i + 1) % curve.size()];
      const double side = kind == 0 ? 1 : kind == 1 ? -1 : random.integer(0, 1) * 2 - 1;
      const Kernel::Vector_2 d = q - p, n(d.y(), -d.x());
      next.insert(next.end(), {p, p + d / 3, p + d / 2 + side * height * n, p + 2 * d / 3});
    }
    curve = std::move(next);
  }
  Builder b;
  b.loop(curve);
  return b.pslg;
}

/// Segments from every vertex of a few to as many others as cross nothing: small graphs with many angles.
inline Pslg visibility_graph(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int n = random.integer(3, 14);
  for (int i = 0; i < n; ++i) b.vertex(Point(random.between(0, 1), random.between(0, 1)));
  const auto is_free = [&b](std::size_t i, std::size_t j) {
    const auto& points = b.pslg.vertices;
    for (const auto& s : b.pslg.segments) {
      const std::size_t k = std::size_t(s[0]), l = std::size_t(s[1]);
      if (k == i || k == j || l == i || l == j) continue;
      if (CGAL::do_intersect(Kernel::Segment_2(points[i], points[j]),
                             Kernel::Segment_2(points[k], points[l])))
        return false;
    }
    return true;
  };
  // A border first, so that something is enclosed.
  std::vector<std::size_t> hull(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < hull.size(); ++i) hull[i] = i;
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i + 1; j < hull.size(); ++j) {
      int left = 0, right = 0;
      for (const Point& p : b.pslg.vertices) {
        const auto side = CGAL::orientation(b.pslg.vertices[i], b.pslg.vertices[j], p);
        left += side == CGAL::LEFT_TURN;
        right += side == CGAL::RIGHT_TURN;
      }
      if (left == 0 || right == 0) b.segment(i, j);
    }
  for (int k = random.integer(0, 3 * n); k > 0; --k) {
    const std::size_t i = std::size_t(random.integer(0, n - 1)), j = std::size_t(random.integer(0, n - 1));
    if (i != j && is_free(i, j)) b.segment(i, j);
  }
  return b.pslg;
}

/// A needle of 1 to 0.0001 degrees as the domain itself, alone or with a second one on its long side.
inline Pslg needle(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double turn = random.between(0, 2 * CGAL_PI), length = power_of_ten(random, -3, 3);
  const double angle = power_of_ten(random, -4, 0) * CGAL_PI / 180;
  const Point apex(random.between(-1, 1), random.between(-1, 1));
  const Point p = polar(apex, length, turn);
  const Point q = polar(apex, length * random.between(0.3, 1), turn + angle);
  b.loop({apex, p, q});
  if (random.integer(0, 1) == 0) return b.pslg;
  const std::size_t r =
      b.vertex(polar(apex, length * random.between(0.3, 1), turn + angle * random.between(1.5, 3)));
  b.segment(0, r);
  b.segment(2, r);
  return b.pslg;
}

/// A ring with hexagonal holes that come as near to each other and to its border as a millionth.
inline Pslg holes(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int columns = random.integer(1, 4), rows = random.integer(1, 4);
  b.loop({Point(0, 0), Point(columns, 0), Point(columns, rows), Point(0, rows)});
  const double radius = 0.5 - power_of_ten(random, -6, -0.5);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const Point center(i + 0.5, j + 0.5);
      std::vector<Point> points;
      const double begin = random.integer(0, 1) == 0 ? 0 : random.between(0, 2 * CGAL_PI);
      for (int k = 0; k < 6; ++k) points.push_back(polar(center, radius, begin + k * CGAL_PI / 3));
      b.loop(points);
      if (random.integer(0, 3) > 0) b.pslg.holes.push_back(center);
    }
  return b.pslg;
}

/// The families of this header; those of `families()` are others.
inline const std::vector<Family>& shape_families() {
  static const std::vector<Family> all{{"polygon", polygon},
                                       {"fan", fan},
                                       {"near parallel", near_parallel},
                                       {"near touching", near_touching},
                                       {"koch", koch},
                                       {"visibility graph", visibility_graph},
                                       {"needle", needle},
                                       {"holes", holes}};
  return all;
}

/// All families.
inline std::vector<Family> all_families() {
  std::vector<Family> all = families();
  all.insert(all.end(), shape_families().begin(), shape_families().end());
  return all;
}

} // namespace random_pslg

#endif // QUADTREE_MESH_2_TEST_RANDOM_PSLG_SHAPES_H
