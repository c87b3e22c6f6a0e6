// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The functions of dyadic_steps.h for coordinates of an exact field.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_DYADIC_STEPS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_DYADIC_STEPS_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/dyadic_steps.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Exact_coordinate.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Field>
Exact_coordinate<Field> add_steps(const Exact_coordinate<Field>& p, std::int64_t n, int exponent) {
  const Split_integer steps(n);
  const double high = std::ldexp(steps.high, exponent), low = std::ldexp(steps.low, exponent);
  if (p.is_double()) {
    const Sum_of_doubles head(p.high(), high), sum(head.value, low);
    if (head.rest == 0 && sum.rest == 0) return Exact_coordinate<Field>(sum.value);
  }
  return Exact_coordinate<Field>(Field(p.exact() + Field(high) + Field(low)));
}

template <class Field>
std::int64_t count_steps(const Exact_coordinate<Field>& c, const Exact_coordinate<Field>& p, int exponent) {
  const Field difference = c.exact() - p.exact();
  const double head = CGAL::to_double(difference);
  return floor_of_steps(head, CGAL::to_double(Field(difference - Field(head))), exponent);
}

template <class Field>
Exact_coordinate<Field> middle_multiple(const Exact_coordinate<Field>& a, const Exact_coordinate<Field>& b,
                                        int exponent) {
  return Exact_coordinate<Field>::nearest_multiple(a, Exact_coordinate<Field>::difference(b, a) / 2,
                                                   exponent);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_DYADIC_STEPS_H
