// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The order in which vertices are inserted, given one in which neighbors are near each other: in rounds, every
// 16^k-th vertex, then every 16^(k-1)-th, and so on, each round in the given order.
//
// A sample inserted first keeps points along curves from making ever longer fans (Amenta, Choi, Rote, "Incremental
// constructions con BRIO", 2003). We take every 16th instead of a sample by chance. That is as good if the given order
// goes along the curve: no part of the curve is then far from the sample.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FOR_EACH_IN_ROUNDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FOR_EACH_IN_ROUNDS_H

#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// By how much each round is larger than the one before it.
constexpr std::size_t growth_of_rounds = 16;

/// Calls `visit(i)` for the i below n that are multiples of `last_step`, in rounds. Each round visits those of the
/// rounds before it again, from 0 on.
template <class Visit>
void for_each_in_rounds(std::size_t n, std::size_t last_step, Visit visit) {
  std::size_t step = last_step;
  while (step < n) step *= growth_of_rounds;
  for (; step >= last_step; step /= growth_of_rounds)
    for (std::size_t i = 0; i < n; i += step) visit(i);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FOR_EACH_IN_ROUNDS_H
