// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Hundreds to thousands of vertices on a line, a circle, a parabola, or in a thin box: what fans of long triangles are
// made of.

#include "families.h"
#include "shape_tools.h"

namespace soak {

namespace {

int some_hundreds(Random& random) { return 1 << random.integer(4, 11); }

/// A frame with vertices on one line in it, joined or not.
Pslg on_line(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int n = some_hundreds(random);
  add_square(b, Point(-1, -1), 2);
  const Vector along = random.integer(0, 1) == 0 ? Vector(1, 0) : direction(random);
  const bool is_joined = random.integer(0, 1) == 0;
  for (int i = 0; i < n; ++i) {
    const double t = (i + random.between(0, 0.9)) / n - 0.5;
    const std::size_t v = b.vertex(Point(t * along.x(), t * along.y()));
    if (is_joined && i > 0) b.segment(v - 1, v);
  }
  return b.pslg;
}

/// A polygon with its vertices on a circle.
Pslg on_circle(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  b.loop(
      star_around(random, random_point(random, -1, 1), magnitude(random, -2, 2), some_hundreds(random), 1));
  return b.pslg;
}

/// A polygon with its vertices on a parabola.
Pslg on_parabola(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int n = some_hundreds(random);
  std::vector<Point> ring;
  for (int i = 0; i <= n; ++i) {
    const double t = 2.0 * i / n - 1;
    ring.emplace_back(t, t * t);
  }
  b.loop(ring);
  return b.pslg;
}

/// Two legs of one apex, cut at distances that shrink by one factor, with some of the rungs between them: strips that
/// become narrow with edges nearly on a line, in a frame or not.
Pslg ladder(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const Vector along = random.integer(0, 1) == 0 ? Vector(1, 0) : direction(random);
  const double width = magnitude(random, -8, -1), factor = random.between(0.01, 0.9);
  const Vector other = along + width * Vector(-along.y(), along.x());
  double distance = 1;
  for (int i = random.integer(2, 12), rung = 0; rung < i; ++rung, distance *= factor) {
    const std::size_t v = b.vertex(Point(0, 0) + distance * along),
                      w = b.vertex(Point(0, 0) + distance * other);
    if (rung > 0) b.segment(v - 2, v), b.segment(w - 2, w);
    if (rung == 0 || rung == i - 1 || random.integer(0, 1) == 0) b.segment(v, w);
  }
  if (random.integer(0, 1) == 0) add_square(b, Point(-2, -2), 4);
  return b.pslg;
}

/// A box that is 10 to 10^4 times as wide as high, with vertices on its sides or inside.
Pslg in_thin_box(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int n = some_hundreds(random) / 2;
  const double height = power_of_ten(-random.integer(1, 3)) * random.between(0.1, 1);
  std::vector<Point> low, high;
  for (int i = 0; i < n; ++i) low.emplace_back((i + random.between(0, 0.9)) / n, 0);
  for (int i = n; i > 0; --i) high.emplace_back((i - random.between(0, 0.9)) / n, height);
  low.insert(low.end(), high.begin(), high.end());
  b.loop(low);
  for (int k = random.integer(0, n / 4); k > 0; --k)
    b.vertex(Point(random.between(0.1, 0.9), height * random.between(0.2, 0.8)));
  return b.pslg;
}

} // namespace

std::vector<Family> thin_families() {
  return {{"on-line", on_line},
          {"on-circle", on_circle},
          {"on-parabola", on_parabola},
          {"in-thin-box", in_thin_box},
          {"ladder", ladder}};
}

} // namespace soak
