// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// From numbers of exact fields to integers of unlimited length and back.
//
// All scales are powers of two, given by their exponents. Exponents do not overflow where the numbers would.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_EXACT_GRID_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_EXACT_GRID_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Long_words.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Numbers are cut into pieces of so many bits: integers that doubles hold, with bits to spare.
constexpr int bits_of_piece = 50;

/// Returns the largest integer not above `v * 2^shift`, without arithmetic on long numbers where it is short.
/// \pre `v` is finite
inline Long_word floor_of_scaled(double v, int shift) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(v, &exponent), 53));
  shift += exponent - 53;
  if (shift <= -63) return mantissa < 0 ? -1 : 0;
  if (shift <= 0) return mantissa >> -shift; // rounds down, also below 0
  if (shift < 10) return mantissa * (std::int64_t(1) << shift);
  Long_word result = mantissa;
  result <<= shift;
  return result;
}

/// Whether numbers of a field are quotients of integers that can be divided with remainder.
template <class Number, bool = Fraction_traits<Number>::Is_fraction::value>
struct Has_integer_parts : std::false_type {};
template <class Number>
struct Has_integer_parts<Number, true> {
  using Integer = typename Fraction_traits<Number>::Numerator_type;
  static constexpr bool value =
      std::is_same<Integer, typename Fraction_traits<Number>::Denominator_type>::value &&
      std::is_base_of<Euclidean_ring_tag,
                      typename Algebraic_structure_traits<Integer>::Algebraic_category>::value;
};

/// Returns 2^k; for quotients of integers without a common divisor to look for.
template <class Number>
Number power_of_two(int k) {
  if constexpr (Has_integer_parts<Number>::value) {
    using Integer = typename Fraction_traits<Number>::Numerator_type;
    const Integer power = power_of_two<Integer>(std::abs(k));
    typename Fraction_traits<Number>::Compose compose;
    return k < 0 ? compose(Integer(1), power) : compose(power, Integer(1));
  } else {
    Number result(1), square(2);
    for (unsigned n = static_cast<unsigned>(std::abs(k)); n != 0; n >>= 1) {
      if (n % 2 != 0) result *= square;
      if (n > 1) square *= Number(square);
    }
    return k < 0 ? Number(Number(1) / result) : result;
  }
}

/// Returns an integer of a CGAL number type as one of ours.
template <class Integer>
Long_word to_long_word(const Integer& i) {
  if constexpr (std::is_same<Integer, Long_word>::value) {
    return i;
  } else {
    const bool is_negative = CGAL::is_negative(i);
    const Integer base(std::ldexp(1.0, bits_of_piece));
    Integer rest = is_negative ? Integer(-i) : i;
    std::vector<std::uint64_t> pieces;
    while (!CGAL::is_zero(rest)) {
      Integer quotient, remainder;
      CGAL::div_mod(rest, base, quotient, remainder);
      pieces.push_back(static_cast<std::uint64_t>(CGAL::to_double(remainder)));
      std::swap(rest, quotient);
    }
    Long_word result = 0;
    if (!pieces.empty()) import_bits(result, pieces.begin(), pieces.end(), unsigned(bits_of_piece), false);
    return is_negative ? Long_word(-result) : result;
  }
}

/// Returns a lower bound for the largest `k` with 2^k <= v, mostly that or one less.
template <class Number>
int estimate_logarithm(const Number& v) {
  const double low = CGAL::to_interval(v).first;
  if (low > 0x1p-1000 && low < 0x1p1000) return std::ilogb(low);
  if constexpr (Has_integer_parts<Number>::value) {
    typename Fraction_traits<Number>::Numerator_type numerator;
    typename Fraction_traits<Number>::Denominator_type denominator;
    typename Fraction_traits<Number>::Decompose()(v, numerator, denominator);
    return static_cast<int>(msb(Long_word(abs(to_long_word(numerator))))) -
           static_cast<int>(msb(Long_word(abs(to_long_word(denominator))))) - 1;
  }
  return 0;
}

/// Returns the largest `k` with 2^k <= v, for `v` of any size.
/// \pre `v > 0`
template <class Number>
int floor_of_logarithm(const Number& v) {
  const auto is_above = [&](int k) { return v < power_of_two<Number>(k); };
  int k = estimate_logarithm(v);
  for (int step = 1; is_above(k); step *= 2) k -= step;
  int step = 1;
  for (; !is_above(k + step); step *= 2) k += step;
  for (; step > 0; step /= 2)
    if (!is_above(k + step)) k += step;
  return k;
}

/// Returns the largest integer not above `v`, with `0 <= v < limit`, `limit` at most `2^bits_of_piece`.
template <class Number>
double floor_of_small(const Number& v, double limit) {
  const std::pair<double, double> interval = CGAL::to_interval(v);
  double low = interval.first > 0 ? std::floor(interval.first) : 0;
  double high = interval.second < limit ? std::floor(interval.second) : limit - 1;
  // One comparison at most, unless the interval is wide.
  while (low < high) {
    const double middle = low + std::ceil((high - low) / 2);
    if (v < Number(middle))
      high = middle - 1;
    else
      low = middle;
  }
  return low;
}

/// The map of `x` to the largest integer not above x 2^shift.
///
/// For fields of which no more is known than order and arithmetic, bits are taken off from the highest down.
template <class Number, bool = Has_integer_parts<Number>::value>
class Floor_of_scaled {
public:
  explicit Floor_of_scaled(int shift) : shift_(shift) {}

  Long_word operator()(const Number& x) const {
    if (CGAL::is_zero(x)) return 0;
    const bool is_negative = CGAL::is_negative(x);
    Number rest = is_negative ? Number(-x) : x;
    const int bits = floor_of_logarithm(rest) + 1 + shift_;
    Long_word result = 0;
    if (bits > 0) {
      rest *= power_of_two<Number>(shift_ - bits); // below 1
      result = take_bits(rest, bits);
    }
    if (!is_negative) return result;
    return CGAL::is_zero(rest) ? Long_word(-result) : Long_word(-result - 1);
  }

private:
  static Long_word take_bits(Number& rest, int bits) {
    std::vector<std::uint64_t> pieces;
    int n = (bits - 1) % bits_of_piece + 1; // the first piece is the one that may be short
    for (int left = bits; left > 0; left -= n, n = bits_of_piece) {
      const double limit = std::ldexp(1.0, n);
      rest *= Number(limit);
      const double piece = floor_of_small(rest, limit);
      rest -= Number(piece);
      pieces.push_back(static_cast<std::uint64_t>(piece));
    }
    Long_word result;
    import_bits(result, pieces.begin(), pieces.end(), unsigned(bits_of_piece));
    return result;
  }

  int shift_;
};

/// For quotients of integers it is one division.
template <class Number>
class Floor_of_scaled<Number, true> {
public:
  explicit Floor_of_scaled(int shift)
      : is_up_(shift > 0), power_(power_of_two<Integer>(shift > 0 ? shift : -shift)) {}

  Long_word operator()(const Number& x) const {
    Integer numerator, denominator, quotient, remainder;
    typename Fraction_traits<Number>::Decompose()(x, numerator, denominator);
    if (CGAL::is_negative(denominator)) {
      numerator = Integer(-numerator);
      denominator = Integer(-denominator);
    }
    (is_up_ ? numerator : denominator) *= power_;
    CGAL::div_mod(numerator, denominator, quotient, remainder);
    if (CGAL::is_negative(remainder)) quotient -= Integer(1);
    return to_long_word(quotient);
  }

private:
  using Integer = typename Fraction_traits<Number>::Numerator_type;

  bool is_up_;
  Integer power_;
};

/// The exact field for the arithmetic on numbers of type `FT`: lazy ones would grow expressions.
template <class FT>
struct Exact_field {
  using Type = FT;
};
template <class ET>
struct Exact_field<Lazy_exact_nt<ET>> {
  using Type = ET;
};
template <>
struct Exact_field<double> {
  using Type = Exact_rational;
};

/// Reads the coordinates of points of a CGAL kernel; 0 stands for x and 1 for y.
///
/// For kernels with lazy points it makes no lazy numbers of their coordinates.
template <class Kernel>
class Coordinate_reader {
  using Point = typename Kernel::Point_2;
  template <class P, class = decltype(CGAL::exact(std::declval<const P&>()))>
  static std::true_type test_lazy(int);
  template <class P>
  static std::false_type test_lazy(...);
  static constexpr bool is_lazy = decltype(test_lazy<Point>(0))::value;

public:
  using Exact = typename Exact_field<typename Kernel::FT>::Type;

  static std::pair<double, double> interval(const Point& p, int axis) {
    if constexpr (is_lazy) {
      const auto& box = CGAL::approx(p);
      return (axis == 0 ? box.x() : box.y()).pair();
    } else {
      return CGAL::to_interval(axis == 0 ? p.x() : p.y());
    }
  }

  static Exact exact(const Point& p, int axis) {
    if constexpr (is_lazy) {
      const auto& q = CGAL::exact(p);
      return axis == 0 ? q.x() : q.y();
    } else {
      return exact(axis == 0 ? p.x() : p.y());
    }
  }

private:
  template <class ET>
  static Exact exact(const Lazy_exact_nt<ET>& v) {
    return CGAL::exact(v);
  }
  template <class FT>
  static Exact exact(const FT& v) {
    return Exact(v);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_EXACT_GRID_H
