// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Segments that lie on each other, exactly or all but, and holes that touch.

#include "families.h"
#include "shape_tools.h"

namespace soak {

namespace {

/// Pieces of a few lines through a lattice, which overlap and repeat each other.
Pslg overlaps(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double unit = std::ldexp(1.0, random.integer(-30, 30));
  const double offset = random.integer(0, 1) == 0 ? 0 : unit * random.integer(1, 1000000);
  const auto at = [&](int x, int y) { return Point(offset + unit * x, offset + unit * y); };
  b.loop({at(-100, -100), at(100, -100), at(100, 100), at(-100, 100)});
  for (int lines = random.integer(1, 4); lines > 0; --lines) {
    const int x = random.integer(-20, 20), y = random.integer(-20, 20), dx = random.integer(-3, 3),
              dy = random.integer(-3, 3);
    if (dx == 0 && dy == 0) continue;
    for (int k = random.integer(2, 7); k > 0; --k) {
      const int i = random.integer(-12, 12), j = random.integer(-12, 12);
      add_uncrossed(b, at(x + i * dx, y + i * dy), at(x + j * dx, y + j * dy));
    }
  }
  return b.pslg;
}

/// The same after a turn that rounds: what lay on a line lies beside it, on one side or the other.
Pslg rotated_overlaps(std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = overlaps(seed);
  const Vector turn = direction(random);
  for (Point& p : pslg.vertices)
    p = Point(turn.x() * p.x() - turn.y() * p.y(), turn.y() * p.x() + turn.x() * p.y());
  return pslg;
}

/// Polygons that touch at vertices, at the middle of an edge or along edges, some of them holes.
Pslg touching_holes(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double unit = random.integer(0, 1) == 0 ? 1 : random.integer(0, 1) == 0 ? 0.1 : 1.0 / 3;
  const double offset = random.integer(0, 2) == 0 ? random.integer(1, 1000000) : 0;
  const auto at = [&](double x, double y) { return Point(offset + unit * x, unit * y); };
  const int n = random.integer(1, 4);
  b.loop({at(-1, -1), at(4 * n + 1, -1), at(4 * n + 1, 4 * n + 1), at(-1, 4 * n + 1)});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = 4 * i, y = 4 * j;
      switch (random.integer(0, 4)) {
      case 0: // a diamond, which touches its neighbors at vertices
        b.loop({at(x + 2, y), at(x + 4, y + 2), at(x + 2, y + 4), at(x, y + 2)});
        break;
      case 1: // a square, which shares edges, or has others' vertices on them
        b.loop({at(x, y), at(x + 4, y), at(x + 4, y + 4), at(x, y + 4)});
        break;
      case 2: // two that touch at a vertex
        b.loop({at(x, y), at(x + 2, y), at(x + 2, y + 2), at(x, y + 2)});
        b.loop({at(x + 2, y + 2), at(x + 4, y + 2), at(x + 4, y + 4), at(x + 2, y + 4)});
        break;
      case 3: // a triangle with its apex on an edge of the next
        b.loop({at(x, y), at(x + 4, y + 1), at(x, y + 2)});
        break;
      default:
        continue;
      }
      if (random.integer(0, 2) > 0) b.pslg.holes.push_back(at(x + 1.9, y + 1.3));
    }
  return b.pslg;
}

/// Holes and regions whose points lie on vertices and segments, or a few steps beside them.
Pslg seeds_on_features(std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = random.integer(0, 1) == 0 ? touching_holes(seed) : random_pslg::lattice(seed);
  for (int k = random.integer(1, 3); k > 0; --k) {
    const auto& s = pslg.segments[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(pslg.segments.size()) - 1))];
    const Point a = pslg.point(s[0]), c = pslg.point(s[1]);
    Point p = random.integer(0, 2) == 0 ? a : a + random.between(0, 1) * (c - a);
    if (random.integer(0, 1) == 0) p = near_by(random, p, 3);
    if (random.integer(0, 1) == 0)
      pslg.holes.push_back(p);
    else
      pslg.regions.push_back({p, double(k), random.integer(0, 1) == 0 ? 0 : 0.5});
  }
  return pslg;
}

/// Random points with nearly all segments that do not cross one drawn before, so that triangles are what segments make
/// them, and holes and regions anywhere.
Pslg seeds_among_segments(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  for (int k = random.integer(10, 26); k > 0; --k) b.vertex(random_point(random, 0, 1));
  const int last = static_cast<int>(b.pslg.vertices.size()) - 1;
  for (int k = 20 * last; k > 0; --k) {
    const auto v = static_cast<std::size_t>(random.integer(0, last)),
               w = static_cast<std::size_t>(random.integer(0, last));
    if (v != w && !crosses_any(b, b.pslg.vertices[v], b.pslg.vertices[w])) b.segment(v, w);
  }
  for (int k = random.integer(0, 1); k > 0; --k) b.pslg.holes.push_back(random_point(random, 0, 1));
  for (int k = random.integer(2, 12); k > 0; --k)
    b.pslg.regions.push_back({random_point(random, 0, 1), double(k), random.integer(0, 1) == 0 ? 0 : 0.01});
  return b.pslg;
}

} // namespace

std::vector<Family> near_line_families() {
  return {{"overlaps", overlaps},
          {"rotated-overlaps", rotated_overlaps},
          {"touching-holes", touching_holes},
          {"seeds-on-features", seeds_on_features},
          {"seeds-among-segments", seeds_among_segments}};
}

} // namespace soak
