// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Signed integers of 128 bits: those of the compiler where it has them, else pairs of words of 64 bits, with the same
// values. CGAL_QUADTREE_MESH_2_NO_INT128 asks for pairs of words with any compiler.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_WIDE_INTEGER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_WIDE_INTEGER_H

#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The product of two words of 64 bits, whose halves are words.
struct Product_of_words {
  std::uint64_t high = 0, low = 0;

  friend constexpr bool operator==(Product_of_words p, Product_of_words q) {
    return p.high == q.high && p.low == q.low;
  }
};

constexpr Product_of_words product_of_words(std::uint64_t x, std::uint64_t y) {
  constexpr std::uint64_t half = 0xffffffff;
  const std::uint64_t low = (x & half) * (y & half), first = (x >> 32) * (y & half),
                      second = (x & half) * (y >> 32), high = (x >> 32) * (y >> 32);
  const std::uint64_t middle = (low >> 32) + (first & half) + (second & half);
  return {high + (first >> 32) + (second >> 32) + (middle >> 32), middle << 32 | (low & half)};
}

/// An integer of 128 bits in two words, as two's complement. It has the operations of the compiler's integers that are
/// in use here. As there, the quotient is rounded to zero, and numbers become the nearest doubles.
class Two_word_integer {
public:
  constexpr Two_word_integer() = default;
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  constexpr Two_word_integer(Integer v)
      : high_(v < Integer(0) ? ~std::uint64_t(0) : 0), low_(static_cast<std::uint64_t>(v)) {}
  /// The integer next to it towards zero.
  /// \pre the number is less than 2^127
  explicit constexpr Two_word_integer(double v) {
    const double m = v < 0 ? -v : v;
    high_ = static_cast<std::uint64_t>(m * 0x1p-64);
    low_ = static_cast<std::uint64_t>(m - static_cast<double>(high_) * 0x1p64);
    if (v < 0) *this = -*this;
  }

  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  explicit constexpr operator Integer() const {
    return static_cast<Integer>(low_);
  }
  explicit constexpr operator bool() const { return (high_ | low_) != 0; }
  explicit operator double() const {
    const Two_word_integer m = magnitude();
    double v;
    if (m.high_ == 0) {
      v = static_cast<double>(m.low_);
    } else {
      // The highest 64 bits, of which the last one tells whether there are lower ones: rounded once.
      const int dropped = bit_width(m.high_);
      const bool is_rest = (m.low_ & (~std::uint64_t(0) >> (64 - dropped))) != 0;
      v = std::ldexp(static_cast<double>(shifted_right(m, dropped).low_ | (is_rest ? 1 : 0)), dropped);
    }
    return is_negative() ? -v : v;
  }

  friend constexpr bool operator==(Two_word_integer a, Two_word_integer b) {
    return a.high_ == b.high_ && a.low_ == b.low_;
  }
  friend constexpr bool operator!=(Two_word_integer a, Two_word_integer b) { return !(a == b); }
  friend constexpr bool operator<(Two_word_integer a, Two_word_integer b) {
    if (a.is_negative() != b.is_negative()) return a.is_negative();
    return is_less_as_words(a, b);
  }
  friend constexpr bool operator>(Two_word_integer a, Two_word_integer b) { return b < a; }
  friend constexpr bool operator<=(Two_word_integer a, Two_word_integer b) { return !(b < a); }
  friend constexpr bool operator>=(Two_word_integer a, Two_word_integer b) { return !(a < b); }

  friend constexpr Two_word_integer operator+(Two_word_integer a, Two_word_integer b) {
    const std::uint64_t low = a.low_ + b.low_;
    return of_words(a.high_ + b.high_ + (low < a.low_ ? 1 : 0), low);
  }
  friend constexpr Two_word_integer operator-(Two_word_integer a) {
    return of_words(~a.high_ + (a.low_ == 0 ? 1 : 0), ~a.low_ + 1);
  }
  friend constexpr Two_word_integer operator-(Two_word_integer a, Two_word_integer b) { return a + -b; }
  friend constexpr Two_word_integer operator*(Two_word_integer a, Two_word_integer b) {
    const Product_of_words low = product_of_words(a.low_, b.low_);
    return of_words(low.high + a.high_ * b.low_ + a.low_ * b.high_, low.low);
  }
  friend constexpr Two_word_integer operator/(Two_word_integer a, Two_word_integer b) {
    const Two_word_integer quotient = quotient_of_magnitudes(a.magnitude(), b.magnitude());
    return a.is_negative() != b.is_negative() ? -quotient : quotient;
  }
  friend constexpr Two_word_integer operator%(Two_word_integer a, Two_word_integer b) {
    return a - a / b * b;
  }

  friend constexpr Two_word_integer operator&(Two_word_integer a, Two_word_integer b) {
    return of_words(a.high_ & b.high_, a.low_ & b.low_);
  }
  friend constexpr Two_word_integer operator~(Two_word_integer a) { return of_words(~a.high_, ~a.low_); }
  /// \pre 0 <= i < 128, for both shifts
  friend constexpr Two_word_integer operator<<(Two_word_integer a, int i) {
    if (i == 0) return a;
    if (i >= 64) return of_words(a.low_ << (i - 64), 0);
    return of_words(a.high_ << i | a.low_ >> (64 - i), a.low_ << i);
  }
  friend constexpr Two_word_integer operator>>(Two_word_integer a, int i) {
    return a.is_negative() ? ~shifted_right(~a, i) : shifted_right(a, i);
  }

  constexpr Two_word_integer& operator+=(Two_word_integer b) { return *this = *this + b; }
  constexpr Two_word_integer& operator-=(Two_word_integer b) { return *this = *this - b; }
  constexpr Two_word_integer& operator*=(Two_word_integer b) { return *this = *this * b; }
  constexpr Two_word_integer& operator++() { return *this += 1; }
  constexpr Two_word_integer& operator--() { return *this -= 1; }

private:
  std::uint64_t high_ = 0, low_ = 0;

  static constexpr Two_word_integer of_words(std::uint64_t high, std::uint64_t low) {
    Two_word_integer result;
    result.high_ = high, result.low_ = low;
    return result;
  }
  constexpr bool is_negative() const { return high_ >> 63 != 0; }
  constexpr Two_word_integer magnitude() const { return is_negative() ? -*this : *this; }

  static constexpr bool is_less_as_words(Two_word_integer a, Two_word_integer b) {
    return a.high_ != b.high_ ? a.high_ < b.high_ : a.low_ < b.low_;
  }
  static constexpr Two_word_integer shifted_right(Two_word_integer a, int i) {
    if (i == 0) return a;
    if (i >= 64) return of_words(0, a.high_ >> (i - 64));
    return of_words(a.high_ >> i, a.low_ >> i | a.high_ << (64 - i));
  }

  /// Of numbers without sign; bit by bit where they do not fit a word.
  static constexpr Two_word_integer quotient_of_magnitudes(Two_word_integer a, Two_word_integer b) {
    if (a.high_ == 0 && b.high_ == 0) return a.low_ / b.low_;
    Two_word_integer quotient, remainder;
    for (int i = 127; i >= 0; --i) {
      remainder = remainder << 1;
      remainder.low_ |= shifted_right(a, i).low_ & 1;
      quotient = quotient << 1;
      if (is_less_as_words(remainder, b)) continue;
      remainder -= b;
      quotient.low_ |= 1;
    }
    return quotient;
  }
};

#if defined(__SIZEOF_INT128__) && !defined(CGAL_QUADTREE_MESH_2_NO_INT128)
__extension__ typedef __int128 Wide_integer;
#else
using Wide_integer = Two_word_integer;
#endif

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_WIDE_INTEGER_H
