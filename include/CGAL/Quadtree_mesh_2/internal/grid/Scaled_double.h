// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A double with an exponent of its own. Products of lengths neither overflow nor underflow, whatever the
// lengths are.
//
// Computes: the arithmetic of doubles, rounded as theirs, over a range of 2^(2^38) and its inverse.
// Bound:    For numbers near 1, the operation on doubles and a comparison.
// Source:   the usual representation by mantissa and exponent, as in MPFR or CGAL's Gmpzf.
// Deviates: the exponent goes in steps of 2^512. So it rarely changes, and numbers of one step are added as
//           they are. A mantissa is from 2^-256 to 2^256, so the product of two mantissas is a double.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_SCALED_DOUBLE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_SCALED_DOUBLE_H

#include <CGAL/Quadtree_mesh_2/internal/grid/Scaled_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Scaled_double {
public:
  static constexpr int bits_of_step = 512;

  Scaled_double() = default;
  Scaled_double(double v) : mantissa_(v), step_(0) { normalize(); } // NOLINT: as doubles become longer ones
  /// v 2^exponent
  static Scaled_double scaled(double v, int exponent) {
    Scaled_double result(v);
    if (v == 0 || !std::isfinite(v)) return result;
    const int steps = exponent / bits_of_step;
    result.mantissa_ = std::ldexp(result.mantissa_, exponent - steps * bits_of_step);
    result.step_ += steps;
    result.normalize();
    return result;
  }
  /// The nearest one to a number of an exact field, or one next to it.
  template <class Field>
  static Scaled_double of(const Field& v) {
    const double rounded = CGAL::to_double(v);
    const bool is_moderate = std::fabs(rounded) > 0x1p-900 && std::fabs(rounded) < 0x1p900;
    if (is_moderate || CGAL::is_zero(v)) return rounded;
    const int exponent = floor_of_logarithm(Field(CGAL::is_negative(v) ? Field(-v) : v));
    return scaled(CGAL::to_double(Field(v * power_of_two<Field>(-exponent))), exponent);
  }

  /// The nearest one.
  static Scaled_double of(const Scaled_integer& v) {
    const Scaled_integer::Rounded r = v.rounded();
    return scaled(r.v, r.exponent);
  }

  bool is_zero() const { return mantissa_ == 0; }
  Scaled_integer to_integer() const {
    Scaled_integer result(mantissa_);
    if (!is_zero()) result.exponent += step_ * bits_of_step;
    return result;
  }
  /// The number as a double; 0 or infinite beyond the range of doubles.
  double to_double() const {
    if (step_ == 0) return mantissa_;
    return is_zero() || step_ < -3 ? 0 * mantissa_ : std::ldexp(mantissa_, std::min(step_, 4) * bits_of_step);
  }
  template <class Field>
  Field exact() const {
    if (step_ == 0) return Field(mantissa_);
    return is_zero() ? Field(0) : Field(Field(mantissa_) * power_of_two<Field>(step_ * bits_of_step));
  }
  friend Scaled_double operator-(Scaled_double a) {
    a.mantissa_ = -a.mantissa_;
    return a;
  }
  friend Scaled_double operator*(Scaled_double a, const Scaled_double& b) {
    a.mantissa_ *= b.mantissa_, a.step_ += b.step_;
    a.normalize();
    return a;
  }
  friend Scaled_double operator/(Scaled_double a, const Scaled_double& b) {
    a.mantissa_ /= b.mantissa_, a.step_ -= b.step_;
    a.normalize();
    return a;
  }
  friend Scaled_double operator+(const Scaled_double& a, const Scaled_double& b) {
    if (a.step_ == b.step_) return {a.mantissa_ + b.mantissa_, a.step_};
    const Scaled_double &large = a.step_ > b.step_ ? a : b, &small = a.step_ > b.step_ ? b : a;
    if (large.step_ - small.step_ > 1) return large; // what is left of the small one is no bit of the sum
    return {large.mantissa_ + small.mantissa_ * 0x1p-512, large.step_};
  }
  friend Scaled_double operator-(const Scaled_double& a, const Scaled_double& b) { return a + -b; }
  Scaled_double& operator+=(const Scaled_double& b) { return *this = *this + b; }

  friend bool operator<(const Scaled_double& a, const Scaled_double& b) {
    if (a.step_ == b.step_) return a.mantissa_ < b.mantissa_;
    return a.step_ > b.step_ ? a.mantissa_ < 0 : b.mantissa_ > 0;
  }
  friend bool operator>(const Scaled_double& a, const Scaled_double& b) { return b < a; }
  friend bool operator<=(const Scaled_double& a, const Scaled_double& b) { return a < b || a == b; }
  friend bool operator>=(const Scaled_double& a, const Scaled_double& b) { return b <= a; }
  friend bool operator==(const Scaled_double& a, const Scaled_double& b) {
    return a.step_ == b.step_ && a.mantissa_ == b.mantissa_;
  }

  friend Scaled_double fabs(Scaled_double a) {
    a.mantissa_ = std::fabs(a.mantissa_);
    return a;
  }
  friend Scaled_double sqrt(const Scaled_double& a) {
    if (a.step_ % 2 == 0) return {std::sqrt(a.mantissa_), a.step_ / 2};
    return {std::sqrt(a.mantissa_) * 0x1p256, (a.step_ - 1) / 2}; // the even step below
  }
  /// The natural logarithm, for positive numbers.
  friend double log(const Scaled_double& a) {
    constexpr double log_of_step = 0.69314718055994530942 * bits_of_step;
    return std::log(a.mantissa_) + a.step_ * log_of_step;
  }
  /// As `std::ilogb()`, for numbers that are not 0.
  friend int ilogb(const Scaled_double& a) { return std::ilogb(a.mantissa_) + a.step_ * bits_of_step; }

private:
  static constexpr double least_ = 0x1p-256, greatest_ = 0x1p256;
  static constexpr int step_of_zero_ = -(1 << 29), step_of_infinity_ = 1 << 29;

  double mantissa_ = 0;
  int step_ = step_of_zero_;

  Scaled_double(double mantissa, int step) : mantissa_(mantissa), step_(step) { normalize(); }

  void normalize() {
    const double magnitude = std::fabs(mantissa_);
    if (!(magnitude >= least_ && magnitude < greatest_)) change_step(magnitude);
  }

  void change_step(double magnitude) {
    if (magnitude == 0)
      step_ = step_of_zero_;
    else if (!std::isfinite(magnitude))
      step_ = step_of_infinity_;
    else if (magnitude < least_) {
      mantissa_ *= 0x1p512, --step_;
      normalize(); // again for what was below 2^-768
    } else {
      mantissa_ *= 0x1p-512, ++step_;
      normalize();
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_SCALED_DOUBLE_H
