// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Coordinates and integer multiples of powers of two, without loss if the result is a coordinate. For doubles
// and integers (for exact coordinates: exact_dyadic_steps.h).
//
// - `add_steps(p, n, e)` is p + n 2^e, rounded if that is not a coordinate. It takes |n| < 2^53, or |n| <
//   2^62 if p is a multiple of 2^e.
// - `count_steps(c, p, e)` is (c - p)/2^e, rounded down, for |c - p| < 2^62 2^e.
// - `middle_multiple(a, b, e)` is a multiple of 2^e next to (a + b)/2.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_DYADIC_STEPS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_DYADIC_STEPS_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// An integer as a sum of two that are doubles; the second is zero if the integer is a double itself.
struct Split_integer {
  double high, low;

  explicit Split_integer(std::int64_t n)
      : high(static_cast<double>(is_double(n) ? n : n & ~low_bits)),
        low(static_cast<double>(is_double(n) ? 0 : n & low_bits)) {}

private:
  static constexpr std::int64_t low_bits = (std::int64_t(1) << 31) - 1, limit = std::int64_t(1) << 53;
  static bool is_double(std::int64_t n) { return -limit <= n && n <= limit; }
};

/// A sum of doubles and what is lost by rounding it (Knuth's two-sum).
struct Sum_of_doubles {
  double value, rest;

  Sum_of_doubles(double a, double b) : value(a + b) {
    const double of_b = value - a;
    rest = (a - (value - of_b)) + (b - of_b);
  }
};

/// The number of steps in a difference that is given as a sum of two doubles.
inline std::int64_t floor_of_steps(double difference, double rest, int exponent) {
  const double steps = std::ldexp(difference, -exponent), whole = std::floor(steps);
  const double more = (steps - whole) + std::ldexp(rest, -exponent);
  return static_cast<std::int64_t>(whole) + static_cast<std::int64_t>(std::floor(more));
}

inline double add_steps(double p, std::int64_t n, int exponent) {
  const Split_integer steps(n);
  const Sum_of_doubles sum(p, std::ldexp(steps.high, exponent));
  return sum.value + (sum.rest + std::ldexp(steps.low, exponent));
}

inline std::int64_t count_steps(double c, double p, int exponent) {
  const Sum_of_doubles difference(c, -p);
  return floor_of_steps(difference.value, difference.rest, exponent);
}

inline double middle_multiple(double a, double b, int exponent) {
  const double middle = a + (b - a) / 2;
  return std::ldexp(std::floor(std::ldexp(middle, -exponent) + 0.5), exponent);
}

/// Halves are rounded up.
inline std::int64_t add_steps(std::int64_t p, std::int64_t n, int exponent) {
  if (exponent >= 0) return p + n * (std::int64_t(1) << exponent);
  if (exponent < -62) return p;
  return p + (((n >> (-exponent - 1)) + 1) >> 1);
}

inline std::int64_t count_steps(std::int64_t c, std::int64_t p, int exponent) {
  return exponent >= 0 ? (c - p) >> exponent : (c - p) * (std::int64_t(1) << -exponent);
}

inline std::int64_t middle_multiple(std::int64_t a, std::int64_t b, int exponent) {
  const std::int64_t middle = a + (b - a) / 2;
  if (exponent <= 0) return middle;
  const std::int64_t step = std::int64_t(1) << exponent;
  return (middle + step / 2) & ~(step - 1);
}

/// What a geometry's coordinates can hold of squares with the side 2^e and of vertices in and around them.
template <class Geometry>
struct Dyadic_room {
  /// The least e for which multiples of 2^-10 of the side are coordinates, up to 12 sides around points whose
  /// coordinates are at most `largest`.
  static int least_exponent(double) { return -900; }
  /// The largest k for which vertices in squares of side 2^(e + k) around such a point are coordinates if they are
  /// multiples of 2^-10 of that side from a multiple of 2^(e - 3).
  static constexpr int bits_of_spokes = 2000;
};

template <class Kernel>
struct Dyadic_room<Double_geometry_2<Kernel>> {
  /// 2^-10 of the side is at least the unit in the last place of numbers below 2^43 sides.
  static int least_exponent(double largest) {
    return largest > 0 ? std::max(-1060, std::ilogb(largest) - 41) : -1060;
  }
  /// 2^-4 of the side, as far as 2^42 + 2^47 sides.
  static constexpr int bits_of_spokes = 48;
};

template <class Word>
struct Dyadic_room<Integer_geometry_2<Word>> {
  static int least_exponent(double) { return 10; }
  static constexpr int bits_of_spokes = 2000;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_DYADIC_STEPS_H
