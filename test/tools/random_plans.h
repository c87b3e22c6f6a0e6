// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Families of plain plans by number: few vertices, no acute corner, many right angles and equal coordinates. Vertices
// of their meshes line up, which high bounds on the angle find hard.

#ifndef QUADTREE_MESH_2_TEST_RANDOM_PLANS_H
#define QUADTREE_MESH_2_TEST_RANDOM_PLANS_H

#include "random_pslg.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace random_pslg {

/// A box with up to four vertices in it.
inline Pslg box_with_vertices(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  b.loop({Point(-10, -10), Point(10, -10), Point(10, 10), Point(-10, 10)});
  for (int k = random.integer(0, 4); k > 0; --k) {
    const double x = random.between(-9, 9);
    b.vertex(Point(x, random.between(-9, 9)));
  }
  return b.pslg;
}

/// A box with vertices at places of a lattice in it.
inline Pslg box_with_lattice(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int width = random.integer(2, 6), height = random.integer(2, 6);
  b.loop({Point(0, 0), Point(width, 0), Point(width, height), Point(0, height)});
  for (int x = 1; x < width; ++x)
    for (int y = 1; y < height; ++y)
      if (random.integer(0, 3) == 0) b.vertex(Point(x, y));
  return b.pslg;
}

/// The region below a skyline.
inline Pslg skyline(std::uint64_t seed) {
  Random random(seed);
  const int width = random.integer(1, 8);
  int height = random.integer(1, 6);
  std::vector<Point> border{Point(0, 0), Point(width, 0), Point(width, height)};
  for (int x = width - 1; x > 0; --x) {
    const int next = random.integer(1, 6);
    if (next == height) continue;
    border.emplace_back(x, height), border.emplace_back(x, next);
    height = next;
  }
  border.emplace_back(0, height);
  Builder b;
  b.loop(border);
  return b.pslg;
}

/// A parallelogram without acute corners below 61 degrees, and up to five vertices in it.
inline Pslg parallelogram(std::uint64_t seed) {
  Random random(seed);
  const double angle = random.between(61, 119) * CGAL_PI / 180;
  const double width = random.between(1, 10), height = random.between(1, 10);
  const double dx = height * std::cos(angle), dy = height * std::sin(angle);
  Builder b;
  b.loop({Point(0, 0), Point(width, 0), Point(width + dx, dy), Point(dx, dy)});
  for (int k = random.integer(0, 5); k > 0; --k) {
    const double u = random.between(.05, .95), w = random.between(.05, .95);
    b.vertex(Point(u * width + w * dx, w * dy));
  }
  return b.pslg;
}

inline const std::vector<Family>& plan_families() {
  static const std::vector<Family> all{{"box with vertices", box_with_vertices},
                                       {"box with lattice", box_with_lattice},
                                       {"skyline", skyline},
                                       {"parallelogram", parallelogram}};
  return all;
}

} // namespace random_pslg

#endif // QUADTREE_MESH_2_TEST_RANDOM_PLANS_H
