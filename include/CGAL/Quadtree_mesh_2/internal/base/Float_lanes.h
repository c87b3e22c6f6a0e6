// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Four floats that are processed at once.
//
// Uses the vector extension that GCC and Clang share, in the one width that every 64-bit processor has (SSE2,
// NEON). Each lane does what the same expression on a float does, so results do not depend on the processor.
// Other compilers get an array and loops.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FLOAT_LANES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FLOAT_LANES_H

#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Float_lanes {
public:
  static constexpr int size = 4;

  Float_lanes() = default;
  Float_lanes(float x) : Float_lanes(x, x, x, x) {}
  Float_lanes(float a, float b, float c, float d) : v_{a, b, c, d} {}
  float operator[](int k) const { return v_[k]; }
  /// Of four successive numbers.
  static Float_lanes load(const float* x) { return {x[0], x[1], x[2], x[3]}; }

#if defined(__GNUC__)
  friend Float_lanes operator+(Float_lanes a, Float_lanes b) { return a.v_ + b.v_; }
  friend Float_lanes operator-(Float_lanes a, Float_lanes b) { return a.v_ - b.v_; }
  friend Float_lanes operator*(Float_lanes a, Float_lanes b) { return a.v_ * b.v_; }
  friend Float_lanes operator/(Float_lanes a, Float_lanes b) { return a.v_ / b.v_; }
  friend Float_lanes abs(Float_lanes a) { return Floats(Masks(a.v_) & 0x7fffffff); }
  /// In each lane x where a < b, y elsewhere.
  friend Float_lanes select_where_less(Float_lanes a, Float_lanes b, Float_lanes x, Float_lanes y) {
    return a.v_ < b.v_ ? x.v_ : y.v_;
  }
  /// Whether a lane of a or of b is at least the bound.
  friend bool is_any_at_least(Float_lanes a, Float_lanes b, Float_lanes bound) {
    const Words m = Words((a.v_ >= bound.v_) | (b.v_ >= bound.v_));
    return (m[0] | m[1]) != 0;
  }

private:
  using Floats = float __attribute__((vector_size(16)));
  using Masks = int __attribute__((vector_size(16)));
  using Words = long long __attribute__((vector_size(16)));
  Floats v_;
  Float_lanes(Floats v) : v_(v) {}
#else
  friend Float_lanes operator+(Float_lanes a, Float_lanes b) {
    return each([&](int k) { return a.v_[k] + b.v_[k]; });
  }
  friend Float_lanes operator-(Float_lanes a, Float_lanes b) {
    return each([&](int k) { return a.v_[k] - b.v_[k]; });
  }
  friend Float_lanes operator*(Float_lanes a, Float_lanes b) {
    return each([&](int k) { return a.v_[k] * b.v_[k]; });
  }
  friend Float_lanes operator/(Float_lanes a, Float_lanes b) {
    return each([&](int k) { return a.v_[k] / b.v_[k]; });
  }
  friend Float_lanes abs(Float_lanes a) {
    return each([&](int k) { return std::fabs(a.v_[k]); });
  }
  friend Float_lanes select_where_less(Float_lanes a, Float_lanes b, Float_lanes x, Float_lanes y) {
    return each([&](int k) { return a.v_[k] < b.v_[k] ? x.v_[k] : y.v_[k]; });
  }
  friend bool is_any_at_least(Float_lanes a, Float_lanes b, Float_lanes bound) {
    bool is_any = false;
    for (int k = 0; k < size; ++k) is_any |= a.v_[k] >= bound.v_[k] || b.v_[k] >= bound.v_[k];
    return is_any;
  }

private:
  float v_[size];
  template <class Function>
  static Float_lanes each(Function f) {
    return {f(0), f(1), f(2), f(3)};
  }
#endif

public:
  friend Float_lanes min(Float_lanes a, Float_lanes b) { return select_where_less(a, b, a, b); }
  friend Float_lanes max(Float_lanes a, Float_lanes b) { return select_where_less(a, b, b, a); }
  /// Added in pairs, always the same.
  friend float sum(Float_lanes a) { return (a.v_[0] + a.v_[1]) + (a.v_[2] + a.v_[3]); }
  friend float least(Float_lanes a) {
    const float x = a.v_[0] < a.v_[1] ? a.v_[0] : a.v_[1], y = a.v_[2] < a.v_[3] ? a.v_[2] : a.v_[3];
    return x < y ? x : y;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FLOAT_LANES_H
