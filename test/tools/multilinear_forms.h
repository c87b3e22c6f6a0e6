// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_MULTILINEAR_FORMS_H
#define QUADTREE_MESH_2_TEST_MULTILINEAR_FORMS_H

// Points whose coordinates are polynomials in four parameters, of degree one in each, and what is certain of them for
// all parameters in a box, in integers.
//
// Such a polynomial is given by its values at the 16 corners of the box, and is between the least and the greatest of
// them. The product of two has degree two in each parameter. Up to positive factors, its Bernstein coefficient k is the
// sum of the products of values at corners i and j with i + j = k, by coordinates. If all of them are positive, the
// product is positive in the box.

#include <array>
#include <cstddef>
#include <cstdint>

namespace vertex_certificates {

constexpr std::size_t number_of_parameters = 4, number_of_box_corners = 16;

/// Of a box; bit d of the index is set at the greater end of parameter d.
struct Multilinear {
  std::array<std::int64_t, number_of_box_corners> at;
  unsigned parameters; ///< bit d: it depends on parameter d
};

struct Moving_vertex {
  Multilinear x, y;
};

/// Sums of products over the pairs of corners of a box of n parameters that add up to the same.
template <class Integer>
class Product_form {
public:
  /// \param parameters those that factors may depend on
  explicit Product_form(unsigned parameters) {
    number_ = 1;
    std::size_t power = 1;
    for (std::size_t d = 0; d < number_of_parameters; ++d) {
      if ((parameters >> d & 1u) == 0) continue;
      for (std::size_t i = 0; i < number_; ++i) {
        corner_[number_ + i] = corner_[i] + (std::size_t(1) << d);
        place_[number_ + i] = place_[i] + power;
      }
      number_ *= 2;
      power *= 3;
    }
    size_ = power;
  }

  std::size_t size() const { return size_; }
  std::size_t number_of_corners() const { return number_; }
  /// The index of the i-th corner in a `Multilinear`.
  std::size_t corner(std::size_t i) const { return corner_[i]; }

  using Values = std::array<Integer, number_of_box_corners>; ///< of a factor, by `corner()`
  using Coefficients = std::array<Integer, 81>;

  void add(Coefficients& sum, const Values& l, const Values& r) const {
    for (std::size_t i = 0; i < number_; ++i)
      for (std::size_t j = 0; j < number_; ++j) sum[place_[i] + place_[j]] += l[i] * r[j];
  }

private:
  std::array<std::size_t, number_of_box_corners> corner_{}, place_{};
  std::size_t number_, size_;
};

/// That an angle is at least arccot(cotangent / `units`).
struct Angle_bound {
  static constexpr std::int64_t units = 48;
  std::int64_t cotangent;
};
/// 20.704 degrees.
constexpr Angle_bound bound_of_sectors{127};

/// Coordinates of triangles may differ by so much: then all sums are below 2^63.
constexpr std::int64_t greatest_difference = std::int64_t(1) << 25;

/// Whether all angles of a triangle are above the bound for all parameters. Then it is counterclockwise: at least two
/// angles of any other triangle have a dot product that is not negative, but less than something that is not positive.
inline bool is_certainly_above(const Angle_bound& bound, const Moving_vertex& a, const Moving_vertex& b,
                               const Moving_vertex& c) {
  const std::array<const Moving_vertex*, 3> v{&a, &b, &c};
  const Product_form<std::int64_t> form(a.x.parameters | a.y.parameters | b.x.parameters | b.y.parameters |
                                        c.x.parameters | c.y.parameters);
  using Values = Product_form<std::int64_t>::Values;
  std::array<std::array<Values, 2>, 3> side; // from each vertex to the next one
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < form.number_of_corners(); ++i) {
      const std::size_t j = form.corner(i);
      side[k][0][i] = v[(k + 1) % 3]->x.at[j] - v[k]->x.at[j];
      side[k][1][i] = v[(k + 1) % 3]->y.at[j] - v[k]->y.at[j];
      for (const std::int64_t d : {side[k][0][i], side[k][1][i]})
        if (d > greatest_difference || d < -greatest_difference) return false;
    }
  const auto negative = [&](const Values& values) {
    Values n;
    for (std::size_t i = 0; i < form.number_of_corners(); ++i) n[i] = -values[i];
    return n;
  };
  Product_form<std::int64_t>::Coefficients cross{};
  form.add(cross, side[0][0], side[1][1]);
  form.add(cross, negative(side[0][1]), side[1][0]);
  for (std::size_t k = 0; k < 3; ++k) {
    Product_form<std::int64_t>::Coefficients minus_dot{};
    for (std::size_t axis = 0; axis < 2; ++axis) form.add(minus_dot, side[k][axis], side[(k + 2) % 3][axis]);
    for (std::size_t i = 0; i < form.size(); ++i)
      if (bound.cotangent * cross[i] + Angle_bound::units * minus_dot[i] <= 0) return false;
  }
  return true;
}

} // namespace vertex_certificates

#endif // QUADTREE_MESH_2_TEST_MULTILINEAR_FORMS_H
