// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Nothing, or next to nothing.

#include "families.h"
#include "shape_tools.h"

namespace soak {

namespace {

Pslg trifles(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const Point p = random.integer(0, 2) == 0 ? Point(0, 0) : random_point(random, -1e3, 1e3);
  const auto add = [&](const Point& q) { return b.vertex(q); };
  switch (random.integer(0, 11)) {
  case 0:
    break;
  case 1:
    add(p);
    break;
  case 2:
    add(p), add(p + direction(random));
    break;
  case 3:
    for (int k = random.integer(2, 9); k > 0; --k) add(p);
    break;
  case 4:
    b.segment(add(p), add(p + direction(random)));
    break;
  case 5:
    b.segment(add(p), add(p));
    add(p + Vector(1, 0)), add(p + Vector(0, 1));
    break;
  case 6:
    for (int k = random.integer(3, 9); k > 0; --k) add(Point(k * 3, k * 7));
    break;
  case 7:
    b.loop({p, p + Vector(1, 0), p + Vector(0, 1)});
    break;
  case 8: // each segment twice, once in either direction
    b.loop({p, p + Vector(1, 0), p + Vector(0, 1)});
    b.loop({p, p + Vector(0, 1), p + Vector(1, 0)});
    break;
  case 9: // all a hole
    b.loop({p, p + Vector(4, 0), p + Vector(0, 4)});
    b.pslg.holes.push_back(p + Vector(1, 1));
    break;
  case 10: // open
    b.loop({p, p + Vector(4, 0), p + Vector(0, 4)});
    b.pslg.segments.pop_back();
    break;
  default:
    for (int k = random.integer(3, 6); k > 0; --k) add(random_point(random, 0, 1));
  }
  return b.pslg;
}

} // namespace

std::vector<Family> trifle_families() { return {{"trifles", trifles}}; }

} // namespace soak
