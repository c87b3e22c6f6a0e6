// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_FAMILIES_H
#define QUADTREE_MESH_2_TEST_SOAK_FAMILIES_H

// Inputs by name and number: those of the tests and many more, most of them where coordinates run out.
//
// Each is made from its number alone by sums, products, square roots and powers of two, so that it is the same on every
// machine; the families of the tests (random_pslg.h) use sines, which are as exact as the C library has them. Where
// rounding can make segments cross, they may: the judge finds out by exact predicates.

#include "random_pslg.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soak {

struct Family {
  std::string name;
  random_pslg::Pslg (*make)(std::uint64_t seed);
  enum class Kind { GRAPHS, POINTS } kind = Kind::GRAPHS;
};

// By what is hard about them, one file each.
std::vector<Family> near_duplicate_families();
std::vector<Family> tiny_feature_families();
std::vector<Family> near_line_families();
std::vector<Family> exact_families();
std::vector<Family> survey_families();
std::vector<Family> scale_families();
std::vector<Family> thin_families();
std::vector<Family> trifle_families();
std::vector<Family> point_families();

/// Those, and those of the tests with dashes for blanks.
const std::vector<Family>& all_families();

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_FAMILIES_H
