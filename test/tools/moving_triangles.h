// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_MOVING_TRIANGLES_H
#define QUADTREE_MESH_2_TEST_MOVING_TRIANGLES_H

// Triangles whose vertices are affine functions of two parameters, and what is certain of their angles for all
// parameters in a box.

#include "integer_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>

/// Products of three numbers.
__extension__ using Wide = __int128;

/// A coordinate, or a difference of such, as constant + x d_x + y d_y for two parameters d; below 2^29 in absolute
/// value, and so are its parts.
struct Affine {
  std::int64_t constant, x, y;
  friend Affine operator-(const Affine& l, const Affine& r) {
    return {l.constant - r.constant, l.x - r.x, l.y - r.y};
  }
};

using Moving_point = std::array<Affine, 2>;
using Moving_triangle = std::array<Moving_point, 3>;

/// All (x, y) with x in [x, x + side] and y in [y, y + side].
struct Parameter_box {
  std::int64_t x, y, side;
  std::array<Parameter_box, 4> quarters() const {
    const std::int64_t h = side / 2;
    return {Parameter_box{x, y, h}, Parameter_box{x + h, y, h}, Parameter_box{x, y + h, h},
            Parameter_box{x + h, y + h, h}};
  }
  std::array<Integer_point, 4> corners() const {
    return {Integer_point{x, y}, {x + side, y}, {x, y + side}, {x + side, y + side}};
  }
};

/// A quadratic polynomial over a box.
class Bernstein_form {
public:
  /// Of 1, s, t, s^2, s t, t^2, where s and t go from 0 to 1 from the left to the right, and upwards.
  using Coefficients = std::array<Wide, 6>;

  explicit Bernstein_form(const Coefficients& c) : c_(c) {}

  /// Whether all coefficients of the Bernstein form are; then the polynomial is positive in the box.
  bool is_positive() const {
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; j <= 2; ++j)
        if (4 * c_[0] + 2 * i * c_[1] + 2 * j * c_[2] + (i == 2 ? 4 : 0) * c_[3] + i * j * c_[4] +
                (j == 2 ? 4 : 0) * c_[5] <=
            0)
          return false;
    return true;
  }

private:
  Coefficients c_;
};

inline Affine over(const Parameter_box& d, const Affine& f) {
  return {f.constant + d.x * f.x + d.y * f.y, d.side * f.x, d.side * f.y};
}

inline void add_product(Bernstein_form::Coefficients& sum, const Affine& l, const Affine& r, Wide factor) {
  const auto product = [&](std::int64_t a, std::int64_t b) { return factor * a * b; };
  sum[0] += product(l.constant, r.constant);
  sum[1] += product(l.constant, r.x) + product(l.x, r.constant);
  sum[2] += product(l.constant, r.y) + product(l.y, r.constant);
  sum[3] += product(l.x, r.x);
  sum[4] += product(l.x, r.y) + product(l.y, r.x);
  sum[5] += product(l.y, r.y);
}

/// Whether all angles of the triangle are in the range, certainly, for all d in the box.
inline bool has_angles_within(const Cotangent_range& range, const Moving_triangle& triangle,
                              const Parameter_box& d) {
  std::array<std::array<Affine, 2>, 3> edges{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 2; ++axis)
      edges[i][axis] = over(d, triangle[(i + 1) % 3][axis] - triangle[i][axis]);
  Bernstein_form::Coefficients cross{};
  add_product(cross, edges[0][0], edges[1][1], 1);
  add_product(cross, edges[0][1], edges[1][0], -1);
  for (std::size_t i = 0; i < 3; ++i) {
    Bernstein_form::Coefficients minus_dot{}, above{}, below{};
    for (std::size_t axis = 0; axis < 2; ++axis)
      add_product(minus_dot, edges[i][axis], edges[(i + 2) % 3][axis], 1);
    for (std::size_t k = 0; k < 6; ++k) {
      const Wide dot = -Cotangent_range::units * minus_dot[k];
      above[k] = dot - range.least * cross[k];
      below[k] = range.greatest * cross[k] - dot;
    }
    if (!Bernstein_form(above).is_positive() || !Bernstein_form(below).is_positive()) return false;
  }
  return true;
}

#endif // QUADTREE_MESH_2_TEST_MOVING_TRIANGLES_H
