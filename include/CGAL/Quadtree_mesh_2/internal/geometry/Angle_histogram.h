// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Counts the least and the largest angles of triangles by whole degrees, without an inverse function. Squared
// sines and signed squared cosines grow with the angles, so they tell the bins apart. O(1) for a triangle.
// The compiler makes the tables: at run time they would take longer than the mesh of a square.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ANGLE_HISTOGRAM_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ANGLE_HISTOGRAM_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The squared sine of an angle of whole degrees, up to 90.
constexpr double squared_sine_of_degrees(int degrees) {
  if (degrees > 45) return 1 - squared_sine_of_degrees(90 - degrees);
  constexpr long double radians_per_half_degree = 0.00872664625997164788461845384244L;
  const long double x = 4 * degrees * radians_per_half_degree; // twice the angle
  long double sum = 0, term = 1;                               // 1 - cos(x), and its Taylor series
  for (int k = 1; k <= 14; ++k) {
    term *= -x * x / (2 * k * (2 * k - 1));
    sum -= term;
  }
  return static_cast<double>(sum / 2);
}

/// The squared cosine of an angle of whole degrees, up to 180, with the opposite sign of the cosine.
constexpr double signed_squared_cosine_of_degrees(int degrees) {
  return degrees < 90 ? -squared_sine_of_degrees(90 - degrees) : squared_sine_of_degrees(degrees - 90);
}

/// Finds the bin of a number in [low, high] between increasing thresholds: a table leads to one near it.
/// \tparam NumberOfBins below 256.
template <std::size_t NumberOfBins>
class Bin_finder {
public:
  /// Bin i begins at `threshold(i)`, for i up to the number of bins, where the last one ends.
  template <class Threshold>
  constexpr explicit Bin_finder(Threshold threshold) {
    for (std::size_t i = 0; i <= NumberOfBins; ++i) thresholds_[i] = threshold(static_cast<int>(i));
    cells_per_unit_ = (number_of_cells - 1) / (thresholds_[NumberOfBins] - thresholds_[0]);
    std::size_t bin = 0;
    for (std::size_t cell = 0; cell < number_of_cells; ++cell) {
      const double x = thresholds_[0] + (static_cast<double>(cell) - 1e-6) / cells_per_unit_;
      while (bin + 1 < NumberOfBins && thresholds_[bin + 1] <= x) ++bin;
      first_[cell] = static_cast<std::uint8_t>(bin);
    }
  }

  /// What is not a number is put into the first bin.
  std::size_t operator()(double x) const {
    // In this order what is no number, of triangles so small that products underflow, becomes 0.
    const double cell =
        std::min(std::max(0.0, (x - thresholds_[0]) * cells_per_unit_), number_of_cells - 1.0);
    std::size_t bin = first_[static_cast<std::size_t>(cell)];
    bin += x >= thresholds_[bin + 1] ? 1 : 0; // no branch: it would be taken at random
    while (bin + 1 < NumberOfBins && x >= thresholds_[bin + 1]) ++bin;
    return std::min(bin, NumberOfBins - 1);
  }

private:
  static constexpr std::size_t number_of_cells = 1024;
  std::array<double, NumberOfBins + 1> thresholds_{};
  std::array<std::uint8_t, number_of_cells> first_{};
  double cells_per_unit_ = 0;
};

class Angle_histogram {
public:
  template <class Number>
  void add(const Basic_shape<Number>& s) {
    const Places at = places(s);
    ++least_[at.least], ++largest_[at.largest];
  }
  /// Takes a triangle out again.
  template <class Number>
  void take(const Basic_shape<Number>& s) {
    const Places at = places(s);
    --least_[at.least], --largest_[at.largest];
  }
  void add(const Angle_histogram& other) {
    for (std::size_t i = 0; i < least_.size(); ++i) least_[i] += other.least_[i];
    for (std::size_t i = 0; i < largest_.size(); ++i) largest_[i] += other.largest_[i];
  }

  /// Adds the numbers of triangles, by bins of 1 degree from 0 and from 60 degrees.
  void add_to(std::array<std::size_t, 60>& least, std::array<std::size_t, 120>& largest) const {
    for (std::size_t i = 0; i < least.size(); ++i) least[i] += least_[i];
    for (std::size_t i = 0; i < largest.size(); ++i) largest[i] += largest_[i];
  }

private:
  struct Places {
    std::size_t least, largest;
  };
  template <class Number>
  Places places(const Basic_shape<Number>& s) const {
    using std::fabs;
    const Number x = s.shortest(), z = s.longest();
    const Number y = greater(lesser(s.l[0], s.l[1]), lesser(greater(s.l[0], s.l[1]), s.l[2]));
    const Number n = z - x - y;                                           // -2 sqrt(x y) cos(largest)
    if (x == y && n == Number(0) && s.area2 == x) return half_of_square_; // bulks are made of these
    return {bin_of_least_(ratio(s.area2 * s.area2, y * z)),
            bin_of_largest_(ratio(0.25 * n * fabs(n), x * y))};
  }

  static constexpr Bin_finder<60> bin_of_least_{squared_sine_of_degrees};
  static constexpr Bin_finder<120> bin_of_largest_{
      [](int i) { return signed_squared_cosine_of_degrees(60 + i); }};

  static constexpr Places half_of_square_{45, 30};

  std::array<std::uint32_t, 60> least_{};
  std::array<std::uint32_t, 120> largest_{};
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ANGLE_HISTOGRAM_H
