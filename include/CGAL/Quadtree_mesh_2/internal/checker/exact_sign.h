// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_EXACT_SIGN_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_EXACT_SIGN_H

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

// The sign of a polynomial in doubles, whatever their size: by intervals, and where these leave a doubt (as they do
// where products leave the range of doubles) by rationals.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \param polynomial called with a number of some type. It evaluates itself in numbers of that type, and
///         returns such a number, not an expression.
template <class Polynomial>
Sign exact_sign(const Polynomial& polynomial) {
  {
    const Protect_FPU_rounding<true> rounding;
    const Uncertain<Sign> sign = CGAL::sign(polynomial(Interval_nt_advanced()));
    if (is_certain(sign)) return get_certain(sign);
  }
  return CGAL::sign(polynomial(Exact_rational()));
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_EXACT_SIGN_H
