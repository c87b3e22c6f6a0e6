// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Families of inputs that are hard to mesh, by number: each is valid (no crossings) and each seed gives
// another one.

#ifndef QUADTREE_MESH_2_TEST_RANDOM_PSLG_H
#define QUADTREE_MESH_2_TEST_RANDOM_PSLG_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace random_pslg {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;

/// Numbers that are the same with every standard library (splitmix64).
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  int integer(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }

private:
  std::uint64_t state_;
};

/// Adds segments only where they cross nothing, so that whatever is tried the graph stays planar.
class Builder {
public:
  Pslg pslg;

  std::size_t vertex(Point p) { return std::size_t(pslg.add_vertex(p)); }

  void segment(std::size_t a, std::size_t b) {
    pslg.add_segment(CGAL::Quadtree_mesh_2::Vertex_index(a), CGAL::Quadtree_mesh_2::Vertex_index(b));
  }

  void loop(const std::vector<Point>& points) {
    const std::size_t first = pslg.vertices.size();
    for (const Point& p : points) vertex(p);
    for (std::size_t i = 0; i < points.size(); ++i) segment(first + i, first + (i + 1) % points.size());
  }

  /// Whether the open segment from p to q meets no other one; those that end at vertex `end` may meet it
  /// there.
  bool is_free(const Point& p, const Point& q, std::size_t end) const {
    const Kernel::Segment_2 s(p, q);
    for (const auto& t : pslg.segments) {
      const bool shares = std::size_t(t[0]) == end || std::size_t(t[1]) == end;
      const Point &a = pslg.point(t[0]), &b = pslg.point(t[1]);
      if (!shares && CGAL::do_intersect(s, Kernel::Segment_2(a, b))) return false;
      const Point& other = std::size_t(t[0]) == end ? b : a;
      if (shares && (s.has_on(other) || Kernel::Segment_2(a, b).has_on(q))) return false;
    }
    return true;
  }
};

constexpr std::size_t no_vertex = std::size_t(-1);

inline Point polar(const Point& c, double r, double angle) {
  return Point(c.x() + r * std::cos(angle), c.y() + r * std::sin(angle));
}

/// A rotated square around what follows.
inline void add_box(Builder& b, Random& random, double half) {
  const double angle = random.between(0, 2 * CGAL_PI);
  std::vector<Point> corners;
  for (int i = 0; i < 4; ++i)
    corners.push_back(polar(Point(0, 0), half * std::sqrt(2.0), angle + i * CGAL_PI / 2));
  b.loop(corners);
}

/// Fans with angles from 0.1 degree up, and pairs of nearly parallel segments, in a rotated box.
inline Pslg fans_and_pairs(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_box(b, random, 2);
  for (int k = random.integer(1, 3); k > 0; --k) {
    const Point o(random.between(-1.2, 1.2), random.between(-1.2, 1.2));
    const std::size_t center = b.vertex(o);
    const double begin = random.between(0, 2 * CGAL_PI);
    for (double angle = begin; angle < begin + 2 * CGAL_PI - 0.02;) {
      const Point q = polar(o, random.between(0, 1) < 0.7 ? random.between(0.1, 0.9) : 0.5, angle);
      if (b.is_free(o, q, center)) b.segment(center, b.vertex(q));
      const double ranges[5] = {0.1, 5, 30, 60, 170};
      const int r = random.integer(0, 3);
      angle += random.between(ranges[r], ranges[r + 1]) * CGAL_PI / 180;
    }
  }
  for (int k = random.integer(0, 6); k > 0; --k) {
    const Point p(random.between(-1.5, 1.5), random.between(-1.5, 1.5));
    const double angle = random.between(0, 2 * CGAL_PI), length = random.between(0.1, 0.8);
    const double gap = std::pow(10, random.between(-3, -1));
    for (const double g : {0.0, gap}) {
      const Point a = polar(p, g, angle + CGAL_PI / 2), c = polar(a, length, angle + 0.5 * g);
      if (b.is_free(a, c, no_vertex)) {
        const std::size_t v = b.vertex(a);
        b.segment(v, b.vertex(c));
      }
    }
  }
  return b.pslg;
}

/// A star polygon with thin tips, and a star-shaped hole in it.
inline Pslg star(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int tips = random.integer(3, 40);
  for (const double scale : {1.0, 0.1}) {
    std::vector<Point> points;
    for (int i = 0; i < 2 * tips; ++i)
      points.push_back(polar(Point(0, 0), scale * (i % 2 ? random.between(0.2, 0.3) : random.between(0.5, 3)),
                             CGAL_PI * (i + 0.3 * random.between(0, 1)) / tips));
    b.loop(points);
  }
  if (random.integer(0, 1) == 1) b.pslg.holes.push_back(Point(0, 0));
  return b.pslg;
}

/// A comb: teeth with angles down to a tenth of a degree on a bar.
inline Pslg comb(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int teeth = random.integer(1, 60);
  const double height = std::pow(10, random.between(-1, 2.5));
  std::vector<Point> points{Point(0, -1)};
  points.push_back(Point(teeth, -1));
  for (int i = teeth; i > 0; --i) {
    points.push_back(Point(i, 0));
    points.push_back(Point(i - random.between(0.2, 0.8), height * random.between(0.5, 1)));
  }
  points.push_back(Point(0, 0));
  b.loop(points);
  return b.pslg;
}

/// Disjoint random segments of widely different lengths in a box.
inline Pslg segments(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_box(b, random, 1.5);
  for (int k = random.integer(1, 60); k > 0; --k) {
    const Point p(random.between(-1, 1), random.between(-1, 1));
    const Point q = polar(p, std::pow(10, random.between(-4, -0.5)), random.between(0, 2 * CGAL_PI));
    if (!b.is_free(p, q, no_vertex)) continue;
    const std::size_t v = b.vertex(p);
    b.segment(v, b.vertex(q));
  }
  return b.pslg;
}

/// Segments between points of a small integer grid: cocircular, collinear, with vertices on segments.
inline Pslg lattice(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int n = random.integer(2, 12);
  b.loop({Point(0, 0), Point(n, 0), Point(n, n), Point(0, n)});
  std::set<std::pair<int, int>> used;
  for (int k = random.integer(0, 3 * n); k > 0; --k) {
    const int x = random.integer(0, n), y = random.integer(0, n);
    const Point p(x, y), q(random.integer(0, n), random.integer(0, n));
    if (p == q) continue;
    bool crosses = false;
    for (const auto& t : b.pslg.segments) {
      const Point &a = b.pslg.point(t[0]), &c = b.pslg.point(t[1]);
      const auto o1 = CGAL::orientation(a, c, p), o2 = CGAL::orientation(a, c, q),
                 o3 = CGAL::orientation(p, q, a), o4 = CGAL::orientation(p, q, c);
      crosses = crosses || (o1 * o2 < 0 && o3 * o4 < 0);
    }
    if (crosses) continue;
    const std::size_t v = b.vertex(p);
    b.segment(v, b.vertex(q));
  }
  return b.pslg;
}

/// A Koch-like curve with random indentation angles.
inline Pslg fractal(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> curve;
  const int sides = random.integer(3, 6);
  for (int i = 0; i < sides; ++i) curve.push_back(polar(Point(0, 0), 1, 2 * CGAL_PI * i / sides));
  const double bump = random.between(0.02, 0.28);
  for (int level = random.integer(1, 4); level > 0; --level) {
    std::vector<Point> next;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Point &p = curve[i], &q = curve[(i + 1) % curve.size()];
      const Kernel::Vector_2 d = q - p, n(d.y(), -d.x());
      next.insert(next.end(), {p, p + d / 3, p + d / 2 + bump * n, p + 2 * d / 3});
    }
    curve = next;
  }
  Builder b;
  b.loop(curve);
  return b.pslg;
}

/// A wedge of 10 to 0.0001 degrees with legs of nearly equal or very different lengths, in a box.
inline Pslg wedge(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_box(b, random, 2);
  const std::size_t apex = b.vertex(Point(random.between(-0.2, 0.2), random.between(-0.2, 0.2)));
  const Point o = b.pslg.vertices[apex];
  double angle = random.between(0, 2 * CGAL_PI), length = random.between(0.1, 1);
  for (int legs = random.integer(2, 5); legs > 0; --legs) {
    b.segment(apex, b.vertex(polar(o, length, angle)));
    angle += std::pow(10, random.between(-4, 1)) * CGAL_PI / 180;
    length = random.integer(0, 1) == 0 ? length * (1 + std::pow(10, random.between(-9, -1)))
                                       : random.between(0.1, 1);
  }
  return b.pslg;
}

struct Family {
  const char* name;
  Pslg (*make)(std::uint64_t seed);
};

inline const std::vector<Family>& families() {
  static const std::vector<Family> all{{"fans and pairs", fans_and_pairs},
                                       {"star", star},
                                       {"comb", comb},
                                       {"segments", segments},
                                       {"lattice", lattice},
                                       {"fractal", fractal},
                                       {"wedge", wedge}};
  return all;
}

/// As many seeds as wanted, or two of needles, of which above the established angle each takes hundreds of thousands of
/// triangles.
inline std::uint64_t number_of_seeds(const Family& family, std::uint64_t wanted) {
  return family.make == wedge ? std::min<std::uint64_t>(wanted, 2) : wanted;
}

} // namespace random_pslg

#endif // QUADTREE_MESH_2_TEST_RANDOM_PSLG_H
