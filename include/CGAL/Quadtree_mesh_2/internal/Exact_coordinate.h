// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A number of an exact field, with the sum of two doubles that is nearest to it (Dekker, 1971) at hand.
//
// Most numbers of a mesh are doubles or such sums exactly; only others have a number of the field, which is not
// changed any more once it is made. So numbers may be copied and read by several threads at once whatever the field
// is, as long as that allows its arithmetic on different results, and there are no lazy expressions.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_EXACT_COORDINATE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_EXACT_COORDINATE_H

#include <CGAL/Quadtree_mesh_2/internal/Scaled_double.h>
#include <CGAL/Quadtree_mesh_2/internal/exact_grid.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <memory>
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
    if (!CGAL::is_zero(rest)) exact_ = std::make_shared<const Field>(std::move(value));
  }

  /// The sum of three doubles that has at most 106 bits, each of the doubles far smaller than the one before.
  static Exact_coordinate of_parts(double high, double middle, double low) {
    const Exact_coordinate s = sum(high, middle);
    return sum(s.high_, s.low_ + low);
  }

  bool is_double() const { return low_ == 0 && !exact_; }
  /// The nearest double.
  double high() const { return high_; }
  Field exact() const { return exact_ ? *exact_ : low_ == 0 ? Field(high_) : Field(high_) + Field(low_); }

  /// a - b, rounded: to half a unit in the last place and a relative 2^-60 of that.
  static double difference(const Exact_coordinate& a, const Exact_coordinate& b) {
    const Exact_coordinate heads = sum(a.high_, -b.high_);
    if (a.low_ == 0 && b.low_ == 0 && !a.exact_ && !b.exact_) return heads.high_;
    if (!a.exact_ && !b.exact_) {
      // Where heads cancel, their difference is a double and has no low part.
      const Exact_coordinate tails = sum(a.low_, -b.low_), all = sum(heads.high_, tails.high_);
      return all.high_ + (all.low_ + (heads.low_ + tails.low_));
    }
    const double result = heads.high_ + (heads.low_ + (a.low_ - b.low_));
    const double magnitude = std::max(std::fabs(a.high_), std::fabs(b.high_));
    if (std::fabs(result) > 0x1p-40 * magnitude && magnitude > 1e-250) return result;
    return nearest_sum(a.exact() - b.exact()).high_;
  }

  /// The same for differences of any size.
  static Scaled_double scaled_difference(const Exact_coordinate& a, const Exact_coordinate& b) {
    const double result = difference(a, b);
    if (std::fabs(result) > 0x1p-900 || (!a.exact_ && !b.exact_)) return result;
    return Scaled_double::of(Field(a.exact() - b.exact()));
  }

  /// p + share (q - p), exactly.
  static Exact_coordinate between(const Exact_coordinate& p, const Exact_coordinate& q,
                                  const Scaled_double& share) {
    if (p == q) return p;
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
  // The sum has the head as its nearest double; it is the number if there is no exact one.
  double high_ = 0, low_ = 0;
  std::shared_ptr<const Field> exact_;

  static Exact_coordinate exact_multiple(const Exact_coordinate& p, const Scaled_double& v, int exponent) {
    const Field unit = power_of_two<Field>(exponent);
    const Field place = p.exact() + v.template exact<Field>() + unit / Field(2);
    const Scaled_integer multiple{Floor_of_scaled<Field>(-exponent)(place), exponent};
    return Exact_coordinate(multiple.to_exact(unit));
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
    if (!a.exact_ && !b.exact_)
      return a.high_ != b.high_ ? sign(a.high_, b.high_) : a.low_ != b.low_ ? sign(a.low_, b.low_) : 0;
    if (a.exact_ == b.exact_) return 0;
    const double magnitude = std::max(std::fabs(a.high_), std::fabs(b.high_));
    if (std::fabs(a.high_ - b.high_) > 0x1p-50 * magnitude) return sign(a.high_, b.high_);
    return static_cast<int>(CGAL::compare(a.exact(), b.exact()));
  }
  static int sign(double a, double b) { return a < b ? -1 : 1; }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_EXACT_COORDINATE_H
