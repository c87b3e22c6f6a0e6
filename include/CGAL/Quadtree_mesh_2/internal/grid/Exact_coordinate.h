// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A number of an exact field that also keeps the nearest sum of two doubles (Dekker, 1971).
//
// Most numbers of a mesh are exactly doubles or such sums. Most others are multiples of powers of two
// (Scaled_integer.h): corners of small squares far from 0, and what is made between them. These keep a third
// double, by which most differences are told without the integers. The rest, for
// example 1/3, has a number of the field, and beside it the multiple of a power of two below it. This
// multiple tells numbers apart wherever it is fine enough. So common divisors are hardly ever computed. With
// numbers of thousands of bits, these would take most of the time.
//
// Once a number is made, what belongs to it never changes. There are no lazy expressions. So several threads
// may copy and read numbers at once. The field only has to allow its arithmetic on different results at the
// same time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_EXACT_COORDINATE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_EXACT_COORDINATE_H

#include <CGAL/Quadtree_mesh_2/internal/grid/Scaled_double.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Scaled_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \tparam Field an exact ordered field with a constructor from `double`.
template <class Field>
class Exact_coordinate {
public:
  Exact_coordinate() = default;
  explicit Exact_coordinate(double value) : high_(value) {}

  explicit Exact_coordinate(Field value) {
    *this = nearest_sum(value);
    const Field rest = value - Field(high_) - Field(low_);
    if (!CGAL::is_zero(rest))
      long_ = std::make_shared<const Long_number>(Long_number::of(std::move(value), CGAL::to_double(rest)));
  }

  explicit Exact_coordinate(const Scaled_integer& value) {
    *this = sum(value.to_double(), 0);
    low_ = (value - Scaled_integer(high_)).to_double();
    const Scaled_integer rest = value - sum_as_integer();
    if (rest.is_zero()) return;
    long_ =
        std::make_shared<const Long_number>(Long_number{value.shortened(), std::nullopt, rest.to_double()});
  }

  /// The sum of three doubles that has at most 106 bits, each of the doubles far smaller than the one before.
  static Exact_coordinate of_parts(double high, double middle, double low) {
    const Exact_coordinate s = sum(high, middle);
    return sum(s.high_, s.low_ + low);
  }

  bool is_double() const { return low_ == 0 && !long_; }
  /// The nearest double.
  double high() const { return high_; }
  Field exact() const {
    if (!long_) return low_ == 0 ? Field(high_) : Field(high_) + Field(low_);
    return long_->field ? *long_->field : to_field(long_->floor);
  }

  /// a - b, rounded: to half a unit in the last place and a relative 2^-60 of that.
  static double difference(const Exact_coordinate& a, const Exact_coordinate& b) {
    const std::optional<double> of_sums = difference_of_sums(a, b);
    return of_sums ? *of_sums : difference_of_long(a, b).to_double();
  }

  /// The same for differences of any size.
  static Scaled_double scaled_difference(const Exact_coordinate& a, const Exact_coordinate& b) {
    const std::optional<double> of_sums = difference_of_sums(a, b);
    return of_sums ? Scaled_double(*of_sums) : difference_of_long(a, b);
  }

  /// a - b
  static Field exact_difference(const Exact_coordinate& a, const Exact_coordinate& b) {
    if (a.is_multiple() && b.is_multiple()) return to_field((a.floor() - b.floor()).shortened());
    return a.exact() - b.exact();
  }

  /// p + share (q - p), exactly.
  static Exact_coordinate between(const Exact_coordinate& p, const Exact_coordinate& q,
                                  const Scaled_double& share) {
    if (p == q) return p;
    if (p.is_multiple() && q.is_multiple()) {
      const Scaled_integer start = p.floor();
      return Exact_coordinate(start + share.to_integer().shortened() * (q.floor() - start));
    }
    const Field start = p.exact();
    return Exact_coordinate(Field(start + share.template exact<Field>() * (q.exact() - start)));
  }

  /// A multiple of 2^exponent next to p + v; not always the nearest where the sum is about in the middle between two.
  static Exact_coordinate nearest_multiple(const Exact_coordinate& p, const Scaled_double& scaled_v,
                                           int exponent) {
    if (exponent < -900) return exact_multiple(p, scaled_v, exponent);
    const double unit = std::ldexp(1.0, exponent), v = scaled_v.to_double();
    Exact_coordinate s = sum(p.high_, v);
    s = sum(s.high_, s.low_ + p.low_);
    const double units = std::fabs(s.high_ / unit);
    if (units < 0x1p52) return Exact_coordinate(unit * std::floor(s.high_ / unit + 0.5));
    // from here on the head is such a multiple itself
    if (units < 0x1p100) return sum(s.high_, unit * std::floor(s.low_ / unit + 0.5));
    return exact_multiple(p, scaled_v, exponent);
  }

  friend bool operator==(const Exact_coordinate& a, const Exact_coordinate& b) { return compare(a, b) == 0; }
  friend bool operator<(const Exact_coordinate& a, const Exact_coordinate& b) { return compare(a, b) < 0; }

private:
  /// A number that is at least `floor` and below the next multiple of the same power of two. It is `floor`
  /// itself if there is no `field`.
  struct Long_number {
    Scaled_integer floor;
    std::optional<Field> field;
    double tail; ///< what it has beyond the sum of two doubles, rounded

    /// If a number is not a multiple of a power of two, its floor has this many bits more than its
    /// denominator. So the floor tells it apart from numbers that are about as long.
    static constexpr int bits_below = 256;

    static Long_number of(Field value, double tail) {
      int exponent = -bits_below;
      if constexpr (Has_integer_parts<Field>::value) {
        typename Fraction_traits<Field>::Numerator_type numerator;
        typename Fraction_traits<Field>::Denominator_type denominator;
        typename Fraction_traits<Field>::Decompose()(value, numerator, denominator);
        const Long_word below = abs(to_long_word(denominator));
        const int bits = static_cast<int>(msb(below));
        if (static_cast<int>(lsb(below)) == bits)
          return {Scaled_integer(to_long_word(numerator), -bits).shortened(), std::nullopt, tail};
        exponent -= bits;
      }
      return {Scaled_integer(Floor_of_scaled<Field>(-exponent)(value), exponent), std::move(value), tail};
    }
  };

  // The sum has the head as its nearest double; it is the number if there is no long one.
  double high_ = 0, low_ = 0;
  std::shared_ptr<const Long_number> long_;

  Scaled_integer sum_as_integer() const { return Scaled_integer(high_) + Scaled_integer(low_); }
  /// Whether it is a multiple of a power of two: `floor()`.
  bool is_multiple() const { return !long_ || !long_->field; }
  Scaled_integer floor() const { return long_ ? long_->floor : sum_as_integer(); }
  double tail() const { return long_ ? long_->tail : 0; }

  static Field to_field(const Scaled_integer& v) {
    return v.template to_exact<Field>(power_of_two<Field>(v.exponent));
  }

  /// By the sums of doubles, where these are the numbers or near enough to them.
  static std::optional<double> difference_of_sums(const Exact_coordinate& a, const Exact_coordinate& b) {
    const Exact_coordinate heads = sum(a.high_, -b.high_);
    if (a.low_ == 0 && b.low_ == 0 && !a.long_ && !b.long_) return heads.high_;
    if (!a.long_ && !b.long_) {
      // Where heads cancel, their difference is a double and has no low part.
      const Exact_coordinate tails = sum(a.low_, -b.low_), all = sum(heads.high_, tails.high_);
      return all.high_ + (all.low_ + (heads.low_ + tails.low_));
    }
    const double magnitude = std::max(std::fabs(a.high_), std::fabs(b.high_));
    if (magnitude <= 1e-250) return std::nullopt;
    const double result = heads.high_ + (heads.low_ + (a.low_ - b.low_));
    if (std::fabs(result) > 0x1p-40 * magnitude) return result;
    // Heads cancel, so their difference has no low part. All that is rounded is below 2^-154 of the magnitude, or of
    // the result's own order.
    const Exact_coordinate middles = sum(a.low_, -b.low_), all = sum(heads.high_, middles.high_);
    const double finer = all.high_ + (all.low_ + (middles.low_ + (a.tail() - b.tail())));
    if (std::fabs(finer) > 0x1p-90 * magnitude) return finer;
    return std::nullopt;
  }

  static Scaled_double difference_of_long(const Exact_coordinate& a, const Exact_coordinate& b) {
    const Scaled_integer difference = a.floor() - b.floor();
    if (difference.is_zero()
            ? a.is_multiple() && b.is_multiple()
            : is_exact_to(a, difference.logarithm()) && is_exact_to(b, difference.logarithm()))
      return Scaled_double::of(difference);
    return Scaled_double::of(Field(a.exact() - b.exact()));
  }
  /// Whether the floor is the number, to a relative 2^-61 of differences with this logarithm.
  static bool is_exact_to(const Exact_coordinate& a, int logarithm) {
    return a.is_multiple() || a.long_->floor.exponent < logarithm - 61;
  }

  static Exact_coordinate exact_multiple(const Exact_coordinate& p, const Scaled_double& v, int exponent) {
    const Scaled_integer half(1, exponent - 1);
    // A floor that is as fine as this is at most a multiple beside.
    if (p.is_multiple() || p.long_->floor.exponent < exponent - 10)
      return Exact_coordinate((p.floor() + v.to_integer() + half).floor(exponent));
    const Field place = p.exact() + v.template exact<Field>() + to_field(half);
    return Exact_coordinate(Scaled_integer(Floor_of_scaled<Field>(-exponent)(place), exponent));
  }

  /// The sum of two doubles, without rounding (Knuth's two-sum).
  static Exact_coordinate sum(double a, double b) {
    Exact_coordinate s;
    s.high_ = a + b;
    const double of_b = s.high_ - a;
    s.low_ = (a - (s.high_ - of_b)) + (b - of_b);
    return s;
  }

  /// Conversions to double may truncate: two of them give all bits and more.
  static Exact_coordinate nearest_sum(const Field& value) {
    const double head = CGAL::to_double(value);
    return sum(head, CGAL::to_double(Field(value - Field(head))));
  }

  static int compare(const Exact_coordinate& a, const Exact_coordinate& b) {
    if (!a.long_ && !b.long_)
      return a.high_ != b.high_ ? sign(a.high_, b.high_) : a.low_ != b.low_ ? sign(a.low_, b.low_) : 0;
    if (a.long_ == b.long_) return 0;
    if (const std::optional<double> of_sums = difference_of_sums(a, b)) return sign(*of_sums, 0);
    const Scaled_double d = difference_of_long(a, b);
    return d.is_zero() ? 0 : d < 0. ? -1 : 1;
  }
  static int sign(double a, double b) { return a < b ? -1 : 1; }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_EXACT_COORDINATE_H
