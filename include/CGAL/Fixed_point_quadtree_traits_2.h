// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_FIXED_POINT_QUADTREE_TRAITS_2_H
#define CGAL_FIXED_POINT_QUADTREE_TRAITS_2_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry_fwd.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Traits
/// A point with unsigned integer coordinates: the paper's fixed-point model of input.
/// \tparam Word `std::uint32_t` or `std::uint64_t`.
template <class Word>
struct Fixed_point_2 {
  static_assert(std::is_same<Word, std::uint32_t>::value || std::is_same<Word, std::uint64_t>::value,
                "words have 32 or 64 bits");
  Word x_ = 0; ///< the first coordinate
  Word y_ = 0; ///< the second

  /// The first coordinate.
  constexpr Word x() const { return x_; }
  /// The second coordinate.
  constexpr Word y() const { return y_; }

  /// Whether the places are the same.
  friend constexpr bool operator==(const Fixed_point_2& p, const Fixed_point_2& q) {
    return p.x_ == q.x_ && p.y_ == q.y_;
  }
  /// Whether the places differ.
  friend constexpr bool operator!=(const Fixed_point_2& p, const Fixed_point_2& q) { return !(p == q); }
  /// Lexicographic order.
  friend constexpr bool operator<(const Fixed_point_2& p, const Fixed_point_2& q) {
    return p.x_ != q.x_ ? p.x_ < q.x_ : p.y_ < q.y_;
  }
  /// Writes both coordinates, with a space between them.
  friend std::ostream& operator<<(std::ostream& out, const Fixed_point_2& p) {
    return out << p.x_ << ' ' << p.y_;
  }
};

/// \ingroup PkgQuadtreeMesh2Traits
/// Traits for quadtrees of points with integer coordinates. The grid is that of the integers. The root is
/// [0, 2^31)^2 or [0, 2^62)^2, so upper corners and differences of coordinates fit signed
/// words.
/// \tparam Word_ `std::uint32_t` or `std::uint64_t`.
/// \cgalModels{QuadtreeTraits_2}
template <class Word_>
class Fixed_point_quadtree_traits_2 {
public:
  /// \name Types
  /// @{

  /// A grid coordinate.
  using Word = Word_;
  /// A point of the input.
  using Point_2 = Fixed_point_2<Word>;
  /// The logarithm of the root's side, 31 or 62.
  static constexpr int depth = std::is_same<Word, std::uint32_t>::value ? 31 : 62;
  /// A point of the grid.
  using Grid_point = Quadtree_mesh_2::Grid_point_2<Word>;
  /// The arithmetic of the meshers on these points.
  using Meshing_geometry_2 = Quadtree_mesh_2::internal::Integer_geometry_2<Word>;
  /// @}

  /// The identity.
  class Grid_2 {
  public:
    /// The logarithm of the root's side, 31 or 62.
    int depth() const { return Fixed_point_quadtree_traits_2::depth; }
    /// Returns false: the words cannot be longer.
    bool refine() { return false; }

    /// Whether `p` has coordinates below 2^depth.
    bool is_in_root(const Point_2& p) const { return ((p.x() | p.y()) >> depth()) == 0; }
    /// The grid point with the coordinates of `p`.
    /// \pre `is_in_root(p)`
    Grid_point grid_point(const Point_2& p) const { return {p.x(), p.y()}; }
    /// The point at a crossing of two grid lines.
    Point_2 point(const Grid_point& g) const { return {g.x, g.y}; }
  };

  /// Checks that points lie in the root.
  struct Construct_grid_2 {
    /// Makes the grid, which is the same for all points.
    /// \tparam PointRange a range with value type `Point_2`.
    /// \throws Quadtree_mesh_2::Point_error for a coordinate that is not below 2^depth.
    template <class PointRange>
    Grid_2 operator()(const PointRange& points) const {
      using Quadtree_mesh_2::Point_error;
      const Grid_2 grid;
      std::size_t i = 0;
      for (const Point_2& p : points) {
        if (!grid.is_in_root(p))
          throw Point_error(Quadtree_mesh_2::Point_index(i),
                            "below 2^" + std::to_string(Fixed_point_quadtree_traits_2::depth));
        ++i;
      }
      return grid;
    }
  };

  /// The function object that makes grids.
  Construct_grid_2 construct_grid_2_object() const { return {}; }
};

/// \ingroup PkgQuadtreeMesh2Traits
/// The affine map between doubles and fixed points.
///
/// The unit is the smallest power of two with which a bounding box fits the middle half of the root of
/// `Fixed_point_quadtree_traits_2<Word>`, wherever the box is. The box begins at a multiple of the unit. So
/// doubles are mapped exactly if they are multiples of that unit, which is whenever any such map could be
/// exact. With 64-bit words this always holds for a box far from the origin, compared to its extent. For a
/// box around the origin, small coordinates may be rounded.
///
/// The box of a single point has no extent. It begins at the point, which is mapped exactly. The unit is then
/// 1/256, but not less than the distance of the point's coordinates from the next doubles.
template <class Word>
class Fixed_point_scale_2 {
public:
  /// The logarithm of the root's side in units, 31 or 62.
  static constexpr int depth = Fixed_point_quadtree_traits_2<Word>::depth;

  /// The scale for points in `box`.
  /// \throws std::invalid_argument if the box is empty or has coordinates not below 2^1000 in
  /// magnitude.
  explicit Fixed_point_scale_2(const Bbox_2& box) {
    const std::array<double, 4> sides{box.xmin(), box.xmax(), box.ymin(), box.ymax()};
    double magnitude = 0;
    for (double v : sides) {
      if (!(std::fabs(v) < std::ldexp(1.0, 1000)))
        throw std::invalid_argument("Fixed_point_scale_2: the box is empty, infinite or too large");
      magnitude = std::max(magnitude, std::fabs(v));
    }
    const double extent = std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    const int exponent = extent > 0 ? exponent_for_extent(extent) : exponent_for_point(magnitude);
    unit_ = std::ldexp(1.0, exponent);
    inverse_unit_ = std::ldexp(1.0, -exponent);
    low_ = {box.xmin(), box.ymin()};
    if (extent > 0)
      for (double& low : low_) low = multiple_at_most(low);
  }

  /// The scale for the bounding box of `points`, whose members have `x()` and `y()` convertible to `double`.
  /// \throws std::invalid_argument if there is no point, or a coordinate is not finite or too large.
  template <class PointRange>
  static Fixed_point_scale_2 of_points(const PointRange& points) {
    Bbox_2 box;
    for (const auto& p : points) {
      const double x = static_cast<double>(p.x()), y = static_cast<double>(p.y());
      box += Bbox_2(x, y, x, y);
    }
    return Fixed_point_scale_2(box);
  }

  /// The distance between neighboring grid lines, a power of two.
  double unit() const { return unit_; }

  /// Returns the grid point nearest to (`x`, `y`).
  /// \pre the point lies in the root, as all points of the bounding box do
  Fixed_point_2<Word> to_fixed(double x, double y) const {
    return {to_word(x, low_[0]), to_word(y, low_[1])};
  }

  /// Returns the doubles nearest to `p`. They are exact if `p` is the image of doubles that were mapped
  /// exactly.
  std::array<double, 2> to_double(const Fixed_point_2<Word>& p) const {
    return {to_coordinate(p.x(), low_[0]), to_coordinate(p.y(), low_[1])};
  }

  /// Returns whether (`x`, `y`) is on the grid, so that `to_double(to_fixed(x, y))` gives it back.
  bool is_exact(double x, double y) const { return to_double(to_fixed(x, y)) == std::array<double, 2>{x, y}; }

private:
  // With less, the inverse of the unit would overflow.
  static constexpr int least_exponent_ = -1022;
  // The lower sides of the box are this many units from those of the root.
  static constexpr std::int64_t quarter_ = std::int64_t(1) << (depth - 2);

  /// A number as the sum of the nearest double and the rest.
  struct Sum {
    double head, rest;
  };
  static Sum sum(double a, double b) { // Knuth's two-sum
    const double head = a + b, of_b = head - a;
    return {head, (a - (head - of_b)) + (b - of_b)};
  }

  static int exponent_for_extent(double extent) {
    const double at_least = std::nextafter(extent, 2 * extent); // the difference may have been rounded down
    int exponent = std::max(least_exponent_, std::ilogb(at_least) - depth);
    while (std::ldexp(at_least, -exponent) > std::ldexp(1.0, depth - 1) - 2) ++exponent;
    return exponent;
  }
  static int exponent_for_point(double magnitude) {
    constexpr int share_of_one = -8;
    return magnitude > 0 ? std::max(share_of_one, std::ilogb(magnitude) - 52) : share_of_one;
  }

  double multiple_at_most(double v) const {
    const double units = v * inverse_unit_;
    return std::fabs(units) < 0x1p53 ? std::floor(units) * unit_ : v; // large ones are multiples already
  }

  Word to_word(double v, double low) const {
    const Sum difference = sum(v, -low);
    const double units = difference.head * inverse_unit_, whole = std::floor(units);
    const std::int64_t g = static_cast<std::int64_t>(whole) +
                           std::llround((units - whole) + difference.rest * inverse_unit_) + quarter_;
    CGAL_precondition(g >= 0 && g < 4 * quarter_);
    return static_cast<Word>(g);
  }

  double to_coordinate(Word w, double low) const {
    const std::int64_t units = static_cast<std::int64_t>(w) - quarter_;
    const double most = static_cast<double>(units);
    const double rest = static_cast<double>(units - static_cast<std::int64_t>(most));
    const Sum place = sum(low, most * unit_);
    return place.head + (place.rest + rest * unit_);
  }

  double unit_ = 1;
  double inverse_unit_ = 1;
  std::array<double, 2> low_{}; // the lower left corner of the box, or less than a unit below it
};

} // namespace CGAL

#endif // CGAL_FIXED_POINT_QUADTREE_TRAITS_2_H
