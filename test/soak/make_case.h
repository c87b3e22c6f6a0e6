// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_MAKE_CASE_H
#define QUADTREE_MESH_2_TEST_SOAK_MAKE_CASE_H

// Which kernel, mode and wishes an input is run with.

#include "Soak_case.h"
#include "families.h"

#include <cstdint>
#include <optional>

namespace soak {

/// What the user wants of all cases; the rest is by chance.
struct Restriction {
  std::optional<Kernel> kernel;
  std::optional<Separation> separation;
  std::optional<Mode> mode;
  std::optional<unsigned> threads;
  bool is_plain = false; ///< the default options only
};

/// The case of a family and a number: the same whenever it is made.
Soak_case make_case(const Family& family, std::uint64_t seed, const Restriction& restriction);

/// Adapts the graph of a case to its kernel and mode: what `make_case()` does, and must be done to a graph that is
/// read.
void prepare(Soak_case& c);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_MAKE_CASE_H
