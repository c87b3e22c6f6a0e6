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
#include <CGAL/Quadtree_mesh_2/internal/meshing_geometry_fwd.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <type_traits>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Traits
/// A point with unsigned integer coordinates, the paper's fixed-point model of input.
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

  friend constexpr bool operator==(const Fixed_point_2& p, const Fixed_point_2& q) {
    return p.x_ == q.x_ && p.y_ == q.y_;
  }
  friend constexpr bool operator!=(const Fixed_point_2& p, const Fixed_point_2& q) { return !(p == q); }
  /// Lexicographic order.
  friend constexpr bool operator<(const Fixed_point_2& p, const Fixed_point_2& q) {
    return p.x_ != q.x_ ? p.x_ < q.x_ : p.y_ < q.y_;
  }
  friend std::ostream& operator<<(std::ostream& out, const Fixed_point_2& p) {
    return out << p.x_ << ' ' << p.y_;
  }
};

/// \ingroup PkgQuadtreeMesh2Traits
/// Quadtrees of points with integer coordinates. The grid is that of the integers and the root is
/// \f$ [0, 2^{31})^2 \f$ or \f$ [0, 2^{62})^2 \f$: upper corners and differences of coordinates fit signed
/// words.
/// \tparam Word_ `std::uint32_t` or `std::uint64_t`.
/// \cgalModels{QuadtreeTraits_2}
template <class Word_>
class Fixed_point_quadtree_traits_2 {
public:
  /// \name Types
  /// @{

  /// As `QuadtreeTraits_2` has them.
  using Word = Word_;
  using Point_2 = Fixed_point_2<Word>;
  /// The logarithm of the root's side, 31 or 62.
  static constexpr int depth = std::is_same<Word, std::uint32_t>::value ? 31 : 62;
  using Grid_point = Quadtree_mesh_2::Grid_point_2<Word>;
  using Meshing_geometry_2 = Quadtree_mesh_2::internal::Integer_geometry_2<Word>;
  /// @}

  /// The identity.
  class Grid_2 {
  public:
    /// The logarithm of the root's side, 31 or 62.
    int depth() const { return Fixed_point_quadtree_traits_2::depth; }
    /// Returns false: the words cannot be longer.
    bool refine() { return false; }

    /// Whether `p` has coordinates below \f$ 2^{depth} \f$.
    bool is_in_root(const Point_2& p) const { return ((p.x() | p.y()) >> depth()) == 0; }
    /// \pre `is_in_root(p)`
    Grid_point grid_point(const Point_2& p) const { return {p.x(), p.y()}; }
    /// The point at a crossing of two grid lines.
    Point_2 point(const Grid_point& g) const { return {g.x, g.y}; }
  };

  /// Checks that points lie in the root.
  struct Construct_grid_2 {
    /// \tparam PointRange a range with value type `Point_2`.
    /// \throws Quadtree_mesh_2::Point_error for a coordinate that is not below \f$ 2^{depth} \f$.
    template <class PointRange>
    Grid_2 operator()(const PointRange& points) const {
      using Quadtree_mesh_2::Point_error;
      const Grid_2 grid;
      std::size_t i = 0;
      for (const Point_2& p : points) {
        if (!grid.is_in_root(p))
          throw Point_error(Point_error::Kind::OUT_OF_RANGE, Quadtree_mesh_2::Point_index(i));
        ++i;
      }
      return grid;
    }
  };

  /// What makes grids.
  Construct_grid_2 construct_grid_2_object() const { return {}; }
};

/// \ingroup PkgQuadtreeMesh2Traits
/// The affine map between doubles and fixed points.
///
/// The unit is the smallest power of two with which a bounding box fits the middle half of the root of
/// `Fixed_point_quadtree_traits_2<Word>`, and the origin is a multiple of the unit. So doubles are mapped
/// exactly whenever any such map could: whenever they are multiples of that unit.
template <class Word>
class Fixed_point_scale_2 {
public:
  /// The logarithm of the root's side in units, 31 or 62.
  static constexpr int depth = Fixed_point_quadtree_traits_2<Word>::depth;

  /// The scale for what lies in `box`.
  /// \throws std::invalid_argument if the box is empty or has coordinates that are not below \f$ 2^{1000} \f$
  /// in magnitude.
  explicit Fixed_point_scale_2(const Bbox_2& box) {
    const std::array<double, 4> sides{box.xmin(), box.xmax(), box.ymin(), box.ymax()};
    double magnitude = 0;
    for (double v : sides) {
      if (!(std::fabs(v) < std::ldexp(1.0, 1000)))
        throw std::invalid_argument("Fixed_point_scale_2: the box is empty, infinite or too large");
      magnitude = std::max(magnitude, std::fabs(v));
    }
    const double extent = std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    // A box of one point gets units that tell it from its neighbours among the doubles, if there are any.
    int exponent = least_exponent_;
    if (extent > 0) exponent = std::max(exponent, std::ilogb(extent) - depth);
    if (magnitude > 0) exponent = std::max(exponent, std::ilogb(magnitude) - 60);
    while (std::ldexp(extent, -exponent) > std::ldexp(1.0, depth - 1) - 2) ++exponent;
    unit_ = std::ldexp(1.0, exponent);
    inverse_unit_ = std::ldexp(1.0, -exponent);
    origin_ = {origin(box.xmin()), origin(box.ymin())};
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

  /// The distance between neighbouring grid lines, a power of two.
  double unit() const { return unit_; }

  /// Returns the grid point nearest to (`x`, `y`).
  /// \pre the point lies in the root, as all points of the bounding box do
  Fixed_point_2<Word> to_fixed(double x, double y) const {
    return {to_word(x, origin_[0]), to_word(y, origin_[1])};
  }

  /// Returns the point at `p`; it is exact if it is the image of a double that was mapped exactly.
  std::array<double, 2> to_double(const Fixed_point_2<Word>& p) const {
    return {to_coordinate(p.x(), origin_[0]), to_coordinate(p.y(), origin_[1])};
  }

  /// Returns whether (`x`, `y`) is on the grid, so that `to_double(to_fixed(x, y))` gives it back.
  bool is_exact(double x, double y) const { return to_double(to_fixed(x, y)) == std::array<double, 2>{x, y}; }

private:
  // With less, the inverse of the unit would overflow.
  static constexpr int least_exponent_ = -1022;

  std::int64_t origin(double low) const {
    return static_cast<std::int64_t>(std::floor(low * inverse_unit_)) - (std::int64_t(1) << (depth - 2));
  }

  Word to_word(double v, std::int64_t origin) const {
    const std::int64_t g = static_cast<std::int64_t>(std::round(v * inverse_unit_)) - origin;
    CGAL_precondition(g >= 0 && g < (std::int64_t(1) << depth));
    return static_cast<Word>(g);
  }

  double to_coordinate(Word w, std::int64_t origin) const {
    return static_cast<double>(static_cast<std::int64_t>(w) + origin) * unit_;
  }

  double unit_ = 1;
  double inverse_unit_ = 1;
  std::array<std::int64_t, 2> origin_{};
};

} // namespace CGAL

#endif // CGAL_FIXED_POINT_QUADTREE_TRAITS_2_H
