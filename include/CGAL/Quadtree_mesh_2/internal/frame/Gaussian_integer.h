// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Rotations by complex integers.
//
// Computes: for a vector and a number n, a complex integer a + bi whose direction differs from the vector's
//           by at most 1 / n, without sign. Here a and b have no common factor and are less than max(n, 16).
// Bound:    O(log n) operations.
// Source:   Bern, Eppstein, Teng, section 5: points are treated as complex integers and multiplied by another
//           such number, of size O(n).
// Deviates: the number is a convergent of the continued fraction of the vector's slope, the first one that is
//           near enough. Mostly it has size O(sqrt(n)), and costs half as many bits.
//
// Proof. A convergent h / k is the slope t, or differs from it by at most 1 / (k k'), where k' is the
// denominator of the next convergent. The first convergent with k k' >= n is taken, so k times the
// denominator before it is below n. Tangents are at most 1. So the directions of (k, h) and (1, t) differ by
// at most |h / k - t|.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_GAUSSIAN_INTEGER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_GAUSSIAN_INTEGER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Wide_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The complex number a + bi.
struct Gaussian_integer {
  std::int64_t a = 1, b = 0;

  std::int64_t norm() const { return a * a + b * b; }
  bool is_one() const { return a == 1 && b == 0; }
  friend bool operator==(Gaussian_integer z, Gaussian_integer w) { return z.a == w.a && z.b == w.b; }
};

/// A vector of long integers.
struct Wide_vector {
  Wide_integer x = 0, y = 0;
};

/// The product with the conjugate of z: a turn by which the direction of z becomes that of the x axis.
inline Wide_vector turned_from(Wide_vector p, Gaussian_integer z) {
  return {p.x * z.a + p.y * z.b, p.y * z.a - p.x * z.b};
}
/// The product with z. Both together multiply by the norm of z.
inline Wide_vector turned_to(Wide_vector p, Gaussian_integer z) {
  return {p.x * z.a - p.y * z.b, p.x * z.b + p.y * z.a};
}

/// The first convergent of p / q that differs from it by at most 1 / n, as (denominator, numerator).
/// \pre 0 <= p <= q, q > 0
inline std::pair<std::int64_t, std::int64_t> near_convergent(std::int64_t p, std::int64_t q, std::int64_t n) {
  std::int64_t h = 0, k = 1, h_before = 1, k_before = 0; // the convergent 0 / 1 and the one before it
  for (;;) {
    if (p == 0) return {k, h}; // the quotient itself
    const std::int64_t digit = q / p;
    if (Wide_integer(k) * (Wide_integer(digit) * k + k_before) >= n) return {k, h}; // the next denominator
    h_before = std::exchange(h, digit * h + h_before);
    k_before = std::exchange(k, digit * k + k_before);
    q = std::exchange(p, q % p);
  }
}

/// Angles are not approximated better than this, whatever n is: so that coordinates times such numbers twice fit
/// words of 128 bits.
constexpr std::int64_t finest_rotation = std::int64_t(1) << 28;

/// The rotation for the direction of v; its real part is positive, or it is i.
inline Gaussian_integer rotation_near(Vector v, std::size_t n) {
  const double longest = std::max(std::fabs(v.x), std::fabs(v.y));
  if (!(longest > 0 && std::isfinite(longest))) return {};
  const auto to_integer = [e = 60 - std::ilogb(longest)](double c) { return std::llround(std::ldexp(c, e)); };
  const std::int64_t x = to_integer(std::fabs(v.x)), y = to_integer(std::fabs(v.y));
  const std::int64_t steps = static_cast<std::int64_t>(
      std::min(std::max(n, std::size_t(16)), static_cast<std::size_t>(finest_rotation)));
  const bool is_steep = x < y;
  const auto [k, h] = near_convergent(std::min(x, y), std::max(x, y), steps);
  Gaussian_integer z = is_steep ? Gaussian_integer{h, k} : Gaussian_integer{k, h};
  if (z.a != 0 && (v.x < 0) != (v.y < 0)) z.b = -z.b;
  return z;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_GAUSSIAN_INTEGER_H
