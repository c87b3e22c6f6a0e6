// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Ties: angles at the bounds, points on circles and lattices, exactly or after a turn that rounds.

#include "families.h"
#include "shape_tools.h"

namespace soak {

namespace {

/// Corners of 60, 45, 30, 20.7048 and 18.43 degrees and near them, with legs of the same or of other lengths, alone or
/// in a frame.
Pslg exact_angles(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const bool has_frame = random.integer(0, 1) == 0;
  if (has_frame) add_square(b, Point(-4, -4), 8);
  const double tangents[] = {std::sqrt(3.0), 1,   1 / std::sqrt(3.0), 1 / std::sqrt(7.0),
                             1.0 / 3,        0.5, 2 - std::sqrt(3.0)};
  const Vector turn = random.integer(0, 1) == 0 ? Vector(1, 0) : direction(random);
  const auto turned = [&](double x, double y) {
    return Point(turn.x() * x - turn.y() * y, turn.y() * x + turn.x() * y);
  };
  std::vector<Point> ring;
  double x = 1, y = 0;
  ring.push_back(turned(x, y));
  const double length = random.integer(0, 1) == 0 ? 1 : random.between(0.5, 2);
  for (int legs = random.integer(1, 5); legs > 0; --legs) {
    const double t = tangents[random.integer(0, 6)], norm = std::sqrt(1 + t * t);
    const double u = (x - t * y) / norm, v = (t * x + y) / norm;
    x = u, y = v;
    Point p = turned(length * x, length * y);
    if (random.integer(0, 1) == 0) p = near_by(random, p, 2);
    ring.push_back(p);
  }
  const std::size_t apex = b.vertex(Point(0, 0));
  std::size_t last = apex;
  const bool is_closed = random.integer(0, 1) == 0 || !has_frame;
  for (const Point& p : ring) {
    if (crosses_any(b, Point(0, 0), p)) continue;
    const std::size_t v = b.vertex(p);
    b.segment(apex, v);
    if (is_closed && last != apex && !crosses_any(b, b.pslg.vertices[last], p)) b.segment(last, v);
    last = v;
  }
  return b.pslg;
}

/// Points on one circle, exactly, joined around or to the center.
Pslg cocircular(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double unit = random.integer(0, 1) == 0 ? std::ldexp(1.0, random.integer(-20, 20)) : 0.1;
  std::vector<Point> points;
  for (const auto& [x, y] : {std::pair<int, int>{65, 0},
                             {63, 16},
                             {60, 25},
                             {56, 33},
                             {52, 39},
                             {39, 52},
                             {33, 56},
                             {25, 60},
                             {16, 63}})
    points.emplace_back(unit * x, unit * y);
  const std::size_t quarter = points.size();
  for (int k = 1; k < 4; ++k)
    for (std::size_t i = 0; i < quarter; ++i) {
      const Point p = points[(static_cast<std::size_t>(k) - 1) * quarter + i];
      points.emplace_back(-p.y(), p.x());
    }
  std::vector<Point> ring;
  for (const Point& p : points)
    if (random.integer(0, 3) > 0) ring.push_back(p);
  if (ring.size() < 3) ring = points;
  b.loop(ring);
  if (random.integer(0, 1) == 0) b.vertex(Point(0, 0));
  for (int k = random.integer(0, 8); k > 0; --k) {
    const auto any = [&] {
      return static_cast<std::size_t>(random.integer(0, static_cast<int>(ring.size()) - 1));
    };
    const std::size_t i = any(), j = any();
    if (i != j && !crosses_any(b, ring[i], ring[j])) b.segment(i, j);
  }
  return b.pslg;
}

/// All points of a lattice, with segments between some of them.
Pslg full_lattice(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int n = random.integer(2, 12);
  const double units[] = {1, 0.1, 1.0 / 3, 0x1p-40, 1e7};
  const double unit = units[random.integer(0, 4)], offset = random.integer(0, 1) == 0 ? 0 : unit * 1e6;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) b.vertex(Point(offset + unit * i, offset + unit * j));
  const auto index = [n](int i, int j) { return static_cast<std::size_t>(i * (n + 1) + j); };
  const auto add = [&](std::size_t p, std::size_t q) {
    if (p != q && !crosses_any(b, b.pslg.vertices[p], b.pslg.vertices[q])) b.segment(p, q);
  };
  add(index(0, 0), index(n, 0)), add(index(n, 0), index(n, n)), add(index(n, n), index(0, n)),
      add(index(0, n), index(0, 0));
  for (int k = random.integer(0, 4 * n); k > 0; --k) {
    const int i = random.integer(0, n), j = random.integer(0, n);
    if (random.integer(0, 1) == 0)
      add(index(i, j), index(std::min(n, i + random.integer(0, 1)), std::min(n, j + random.integer(0, 1))));
    else
      add(index(i, j), index(random.integer(0, n), random.integer(0, n)));
  }
  return b.pslg;
}

/// A lattice with segments, turned by a rational angle: what was exact is rounded.
Pslg rotated_rationals(std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = random.integer(0, 1) == 0 ? full_lattice(seed) : random_pslg::lattice(seed);
  constexpr int triples[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}};
  const auto& t = triples[random.integer(0, 3)];
  const double c = double(t[0]) / t[2], s = double(t[1]) / t[2];
  for (Point& p : pslg.vertices) p = Point(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  return pslg;
}

} // namespace

std::vector<Family> exact_families() {
  return {{"exact-angles", exact_angles},
          {"cocircular", cocircular},
          {"full-lattice", full_lattice},
          {"rotated-rationals", rotated_rationals}};
}

} // namespace soak
