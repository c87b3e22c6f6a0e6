// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Inputs of other families from 1e-300 to 1e300.

#include "families.h"
#include "shape_tools.h"

#include "random_pslg_shapes.h"

namespace soak {

namespace {

Pslg any_small(Random& random, std::uint64_t seed) {
  const std::vector<random_pslg::Family> families = random_pslg::all_families();
  return families[static_cast<std::size_t>(random.integer(0, static_cast<int>(families.size()) - 1))].make(
      seed);
}

/// Scaled by a power of two, which rounds nothing.
Pslg scaled_by_two(std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = any_small(random, seed);
  scale(pslg, std::ldexp(1.0, random.integer(-960, 990)));
  return pslg;
}

/// Scaled by a power of ten, which does.
Pslg scaled_by_ten(std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = any_small(random, seed);
  scale(pslg, power_of_ten(random.integer(-285, 295)));
  return pslg;
}

/// Moved away by 1 to 10^9 of its extent, which rounds its coordinates.
Pslg moved(std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = any_small(random, seed);
  move(pslg, power_of_ten(random.integer(0, 9)) * direction(random));
  return pslg;
}

/// One coordinate ten to a thousand times the other: more would need millions of triangles.
Pslg stretched(std::uint64_t seed) {
  Random random(seed);
  Pslg pslg = random_pslg::polygon(seed);
  const double by = power_of_ten(random.integer(1, 3));
  for (Point& p : pslg.vertices) p = Point(by * p.x(), p.y());
  return pslg;
}

} // namespace

std::vector<Family> scale_families() {
  return {{"scaled-by-two", scaled_by_two},
          {"scaled-by-ten", scaled_by_ten},
          {"moved", moved},
          {"stretched", stretched}};
}

} // namespace soak
