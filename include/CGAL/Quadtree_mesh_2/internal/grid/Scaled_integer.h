// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The product of an integer of unlimited length and a power of two. All doubles and their sums, of any size,
// are such numbers. Their differences and products need no common divisors.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_SCALED_INTEGER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_SCALED_INTEGER_H

#include <CGAL/Fraction_traits.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Long_words.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

struct Scaled_integer {
  Long_word integer = 0;
  int exponent = 0;

  Scaled_integer() = default;
  Scaled_integer(Long_word i, int e) : integer(std::move(i)), exponent(e) {}
  /// \pre `v` is finite
  explicit Scaled_integer(double v) {
    if (v == 0) return;
    integer = static_cast<std::int64_t>(std::ldexp(std::frexp(v, &exponent), 53));
    exponent -= 53;
  }

  bool is_zero() const { return integer == 0; }
  /// The largest k with 2^k not above its magnitude.
  /// \pre it is not 0
  int logarithm() const { return static_cast<int>(msb(Long_word(abs(integer)))) + exponent; }

  /// Whether it is a double that is not subnormal.
  bool is_double() const {
    if (integer == 0) return true;
    const Long_word magnitude = abs(integer);
    const int high = static_cast<int>(msb(magnitude)), low = static_cast<int>(lsb(magnitude));
    return high - low < 53 && -1022 <= high + exponent && high + exponent <= 1023;
  }

  /// The nearest v 2^exponent with a double v.
  struct Rounded {
    double v;
    int exponent;
  };
  Rounded rounded() const {
    if (integer == 0) return {0, 0};
    const Long_word magnitude = abs(integer);
    const int shift = static_cast<int>(msb(magnitude)) - 61;
    std::int64_t top = 0;
    if (shift <= 0) {
      top = static_cast<std::int64_t>(magnitude);
    } else {
      // What is cut off counts only if the rest lies in the middle between two doubles: one bit tells.
      top = static_cast<std::int64_t>(Long_word(magnitude >> shift));
      if (static_cast<int>(lsb(magnitude)) < shift) top |= 1;
    }
    const double v = static_cast<double>(top);
    return {integer < 0 ? -v : v, exponent + std::max(shift, 0)};
  }
  /// The nearest double.
  double to_double() const {
    const Rounded r = rounded();
    return std::ldexp(r.v, r.exponent);
  }

  /// It exactly, as a number of a field.
  /// \param unit 2^exponent
  template <class Number>
  Number to_exact(const Number& unit) const {
    if constexpr (Has_integer_parts<Number>::value)
      return Number(to_integer<typename Fraction_traits<Number>::Numerator_type>()) * unit;
    else
      return to_integer<Number>() * unit;
  }

  /// Without zeros at the end of the integer.
  Scaled_integer shortened() const {
    if (integer == 0) return {};
    const unsigned zeros = static_cast<unsigned>(lsb(Long_word(abs(integer))));
    return {Long_word(integer >> zeros), exponent + static_cast<int>(zeros)};
  }
  /// The largest multiple of 2^e that is not above it.
  Scaled_integer floor(int e) const {
    return {e > exponent ? floor_of_quotient(e - exponent) : Long_word(integer << (exponent - e)), e};
  }

  friend Scaled_integer operator-(const Scaled_integer& a, const Scaled_integer& b) {
    const int e = std::min(a.exponent, b.exponent);
    if (a.exponent == b.exponent) return {Long_word(a.integer - b.integer), e};
    return {Long_word((a.integer << (a.exponent - e)) - (b.integer << (b.exponent - e))), e};
  }
  friend Scaled_integer operator+(const Scaled_integer& a, const Scaled_integer& b) {
    return a - Scaled_integer{Long_word(-b.integer), b.exponent};
  }
  friend Scaled_integer operator*(const Scaled_integer& a, const Scaled_integer& b) {
    return {Long_word(a.integer * b.integer), a.exponent + b.exponent};
  }

private:
  Long_word floor_of_quotient(int shift) const {
    if (integer >= 0) return integer >> shift;
    return -Long_word((Long_word(-integer - 1) >> shift) + 1);
  }

  template <class Integer>
  Integer to_integer() const {
    const Integer base(std::ldexp(1.0, bits_of_piece));
    std::vector<std::uint64_t> pieces;
    export_bits(Long_word(abs(integer)), std::back_inserter(pieces), unsigned(bits_of_piece));
    Integer result(0);
    for (const std::uint64_t piece : pieces) {
      result *= base;
      result += Integer(static_cast<double>(piece));
    }
    return integer < 0 ? Integer(-result) : result;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_SCALED_INTEGER_H
