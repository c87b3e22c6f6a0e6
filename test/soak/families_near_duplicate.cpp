// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertices, segments and corners that are 1 to 100 steps of doubles apart.

#include "families.h"
#include "shape_tools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace soak {

namespace {

/// A polygon far from the origin, with vertices beside some of its own.
Pslg offset_duplicates(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double offset = power_of_ten(random.integer(0, 12));
  const Point center(offset * random.between(-1, 1), offset * random.between(-1, 1));
  const double radius = magnitude(random, -3, 12);
  b.loop(star_around(random, center, radius, random.integer(3, 20), 0.4));
  const std::size_t corners = b.pslg.vertices.size();
  const int most = random.integer(1, 100);
  for (int k = random.integer(1, 6); k > 0; --k) {
    const Point p = b.pslg.vertices[static_cast<std::size_t>(random.integer(0, int(corners) - 1))];
    const Point q = near_by(random, p, most);
    if (random.integer(0, 1) == 0)
      b.vertex(q);
    else
      add_uncrossed(b, q, random.integer(0, 1) == 0 ? center : near_by(random, q, most));
  }
  for (int k = random.integer(0, 4); k > 0; --k) {
    const Point p = center + radius * random.between(-0.3, 0.3) * direction(random);
    b.vertex(p);
    b.vertex(near_by(random, p, most));
  }
  return b.pslg;
}

/// A polygon some of whose vertices are two, with an edge of a few steps between.
Pslg split_corners(std::uint64_t seed) {
  Random random(seed);
  const double offset = power_of_ten(random.integer(0, 9));
  const Point center(offset * random.between(-1, 1), offset * random.between(-1, 1));
  const int most = random.integer(1, 100);
  std::vector<Point> points;
  for (const Point& p : star_around(random, center, magnitude(random, -2, 8), random.integer(3, 12), 0.5)) {
    points.push_back(p);
    if (random.integer(0, 2) == 0) points.push_back(near_by(random, p, most));
  }
  Builder b;
  b.loop(points);
  if (random.integer(0, 1) == 0) b.pslg.holes.push_back(center + Vector(1e9, 0));
  return b.pslg;
}

/// Segments that end a few steps beside others, as if they were meant to end on them.
Pslg missed_junctions(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double offset = random.integer(0, 1) == 0 ? 0 : power_of_ten(random.integer(0, 8));
  const Point low(offset, offset * random.between(-1, 1));
  add_square(b, low, 4);
  const int most = random.integer(0, 20);
  for (int k = random.integer(1, 12); k > 0; --k) {
    const auto& s = b.pslg.segments[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(b.pslg.segments.size()) - 1))];
    const Point a = b.pslg.point(s[0]), c = b.pslg.point(s[1]);
    const Point on = a + random.between(0.05, 0.95) * (c - a);
    const Point end = most == 0 ? on : near_by(random, on, most);
    const Point other(low.x() + random.between(0.1, 3.9), low.y() + random.between(0.1, 3.9));
    if (random.integer(0, 3) == 0)
      b.vertex(end);
    else
      add_uncrossed(b, end, other);
  }
  return b.pslg;
}

/// Legs at one vertex that all but lie on each other.
Pslg near_parallel_legs(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double offset = random.integer(0, 2) == 0 ? power_of_ten(random.integer(0, 6)) : 0;
  add_square(b, Point(offset - 2, offset - 2), 4);
  for (int apexes = random.integer(1, 3); apexes > 0; --apexes) {
    const Point o(offset + random.between(-0.5, 0.5), offset + random.between(-0.5, 0.5));
    const Vector along = direction(random), across(-along.y(), along.x());
    const std::size_t apex = b.vertex(o);
    const int bits = random.integer(10, 54);
    for (int legs = random.integer(2, 5); legs > 0; --legs) {
      const double length = random.integer(0, 1) == 0 ? 1 : random.between(0.05, 1);
      const Point far = o + length * along;
      const Point end = random.integer(0, 2) == 0 ? near_by(random, far, 10)
                                                  : far + std::ldexp(random.between(-1, 1), -bits) * across;
      if (end == o || crosses_any(b, o, end)) continue;
      b.segment(apex, b.vertex(end));
    }
  }
  return b.pslg;
}

/// A few points of a small lattice, most of them twice, 2^-30 to 2^-52 apart, and many segments between: acute corners
/// whose legs all but coincide, with vertices next to their ends and middles.
Pslg doubled_lattice(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int side = 1 << random.integer(2, 4);
  std::vector<Point> points;
  const auto add = [&](const Point& p) {
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  };
  for (const Point& p : {Point(0, 0), Point(side, 0), Point(side, side), Point(0, side)}) add(p);
  for (int k = random.integer(3, 7); k > 0; --k) {
    const int x = random.integer(0, side), y = random.integer(0, side);
    add(Point(x, y));
  }
  const int lattice_points = static_cast<int>(points.size());
  for (int k = random.integer(1, 5); k > 0; --k) {
    const Point p = points[static_cast<std::size_t>(random.integer(0, lattice_points - 1))];
    const double step = std::ldexp(random.integer(1, 3), -random.integer(30, 52));
    const int i = random.integer(-1, 1), j = random.integer(-1, 1);
    const Point q(p.x() + i * step, p.y() + j * step);
    if (q.x() >= 0 && q.x() <= side && q.y() >= 0 && q.y() <= side) add(q);
  }
  for (const Point& p : points) b.vertex(p);
  for (std::size_t i = 0; i < 4; ++i) b.segment(i, (i + 1) % 4);
  const int last = static_cast<int>(points.size()) - 1;
  for (int k = random.integer(3, 25); k > 0; --k) {
    const auto i = static_cast<std::size_t>(random.integer(0, last)),
               j = static_cast<std::size_t>(random.integer(0, last));
    if (i != j && !crosses_any(b, points[i], points[j])) b.segment(i, j);
  }
  return b.pslg;
}

/// A triangle, a square or a sliver on the right of the segment from `a` to `c`.
void add_shape_beside(Random& random, Builder& b, const Point& a, const Point& c) {
  const Vector along = c - a, down(along.y(), -along.x());
  const int kind = random.integer(0, 2);
  if (kind == 0) {
    b.loop({a, a + down, c + down, c});
  } else {
    const double height = kind == 1 ? random.between(0.3, 1) : magnitude(random, -12, -3);
    b.loop({a, a + random.between(0, 1) * along + height * down, c});
  }
}

/// Zero or not.
double some_share(Random& random, double most) {
  return random.integer(0, 1) == 0 ? 0 : random.between(0, most);
}

/// Two shapes with sides that face each other across a gap of a few steps, which is outside. Some have a corner in
/// common.
Pslg outer_gaps(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double offset = power_of_ten(3 * random.integer(0, 3)), length = magnitude(random, -3, 8);
  const Vector along = length * direction(random);
  const Point a = random_point(random, -offset, offset), c = a + along;
  const int most = random.integer(0, 1) == 0 ? 4 : random.integer(1, 100);
  const auto facing = [&](double share) {
    for (;;) {
      const Point p = near_by(random, a + share * along, most);
      if (CGAL::orientation(a, c, p) == CGAL::LEFT_TURN) return p;
    }
  };
  const Point d = random.integer(0, 2) == 0 ? a : facing(some_share(random, 0.5)),
              e = facing(1 - some_share(random, 0.4));
  add_shape_beside(random, b, a, c);
  add_shape_beside(random, b, e, d);
  return b.pslg;
}

} // namespace

std::vector<Family> near_duplicate_families() {
  return {{"offset-duplicates", offset_duplicates}, {"split-corners", split_corners},
          {"missed-junctions", missed_junctions},   {"near-parallel-legs", near_parallel_legs},
          {"doubled-lattice", doubled_lattice},     {"outer-gaps", outer_gaps}};
}

} // namespace soak
