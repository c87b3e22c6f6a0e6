// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_EXACT_QUADTREE_TRAITS_2_H
#define CGAL_EXACT_QUADTREE_TRAITS_2_H

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/exact_axis_parallel_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_dyadic_steps.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Scaled_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Traits
/// Traits for quadtrees of points of a CGAL kernel with exact constructions, of any depth.
///
/// Coordinates may be any numbers of the kernel's field: 1/3, 10^400 and 2^-5000 in one
/// set. Grid coordinates are integers of unlimited length. The grid first has 2^62 units to a side,
/// and `refine()` squares that number. So all distinct points are eventually told apart, and all rounds
/// together cost about twice the last. The root is the smallest square with a power of two as its side that
/// holds the points in its middle half. Its origin is a multiple of 1/64 of the side.
///
/// Points are mapped to the grid without rounding, and grid points to points exactly. If a coordinate is a
/// double, its mantissa is shifted. Others need one division of long integers. Fields that are not quotients
/// of integers need arithmetic of the field for every 50 bits.
///
/// <h3>Threads</h3>
/// Several threads may use a grid at once while it is not refined. The condition is that several threads may
/// read the kernel's numbers at once, even through different points that share numbers.
/// `Exact_predicates_exact_constructions_kernel` of \cgal 5.4 and later allows that: the first thread to ask
/// finds an exact value, once. It does not if compiled with `CGAL_HAS_NO_THREADS` or if `Exact_rational` is
/// `Gmpq`. Earlier versions do not allow it. Kernels over `Gmpq` copy numbers that share their value without
/// protection. They need points that share no number with points of other threads.
///
/// The same holds for `Quality_mesher_2` with `Parallel_tag`. It computes with exact values of its own, and
/// makes the kernel's points from them.
///
/// \tparam Kernel a CGAL kernel whose `FT` is an exact ordered field with a constructor from `double`, or
/// `double` itself. For `double`, points are mapped to the grid exactly, and grid points to the nearest
/// double.
/// \cgalModels{QuadtreeTraits_2}
template <class Kernel = Exact_predicates_exact_constructions_kernel>
class Exact_quadtree_traits_2 {
  using FT = typename Kernel::FT;
  static constexpr bool is_over_double = std::is_same<FT, double>::value;
  static_assert(is_over_double || Algebraic_structure_traits<FT>::Is_exact::value,
                "the kernel must be exact or over double");

  using Reader = Quadtree_mesh_2::internal::Coordinate_reader<Kernel>;
  using Exact = typename Reader::Exact;
  using Floor = Quadtree_mesh_2::internal::Floor_of_scaled<Exact>;

public:
  /// \name Types
  /// @{

  /// A point of the input.
  using Point_2 = typename Kernel::Point_2;
  /// A grid coordinate.
  using Word = Quadtree_mesh_2::internal::Long_word;
  /// A point of the grid.
  using Grid_point = Quadtree_mesh_2::Grid_point_2<Word>;
  /// The arithmetic of the meshers on these points.
  using Meshing_geometry_2 = std::conditional_t<
      is_over_double,
      Quadtree_mesh_2::internal::Double_geometry_2<Exact_predicates_inexact_constructions_kernel>,
      Quadtree_mesh_2::internal::Exact_geometry_2<Kernel>>;
  /// @}

  /// The map between points and the grid. The default is the grid of no points.
  class Grid_2 {
  public:
    /// The grid of no points.
    Grid_2() : Grid_2(0, {-granules / 4, -granules / 4}) {}

    /// The logarithm of the root's side.
    int depth() const { return depth_; }

    /// Makes the grid finer: doubles the depth and thus the length of grid coordinates. From a depth of
    /// 2^29 on it leaves the grid as it is, and returns false.
    bool refine() {
      if (depth_ >= greatest_depth) return false;
      for (Word& origin : origin_) origin <<= depth_;
      depth_ *= 2;
      set_unit();
      return true;
    }

    /// Returns whether `p` lies in the root square.
    bool is_in_root(const Point_2& p) const { return is_in_root(p, 0) && is_in_root(p, 1); }

    /// Returns the lower left corner of the unit square that contains `p`.
    /// \pre `is_in_root(p)`
    Grid_point grid_point(const Point_2& p) const { return {coordinate(p, 0), coordinate(p, 1)}; }

    /// Returns the point at `g`, exactly if the kernel is exact.
    Point_2 point(const Grid_point& g) const { return Point_2(number(g.x, 0), number(g.y, 1)); }

    /// \cond SKIP_IN_MANUAL
    /// The same as integers times powers of two.
    std::array<Quadtree_mesh_2::internal::Scaled_integer, 2> place(const Grid_point& g) const {
      return {place(g.x, 0), place(g.y, 1)};
    }
    /// \endcond

  private:
    friend class Exact_quadtree_traits_2;

    static constexpr int first_depth = 62;
    static constexpr int greatest_depth = 1 << 29;

    /// \param exponent the logarithm of the root's side in the units of points
    /// \param origin its lower left corner, in granules
    Grid_2(int exponent, std::array<Word, 2> origin)
        : exponent_(exponent), origin_(std::move(origin)), floor_(0), unit_(1) {
      for (Word& v : origin_) v <<= depth_ - log_granules;
      set_unit();
    }

    void set_unit() {
      floor_ = Floor(depth_ - exponent_);
      unit_ = Quadtree_mesh_2::internal::power_of_two<Exact>(exponent_ - depth_);
    }

    // Also right for points outside the root, although not meaningful there.
    Word coordinate(const Point_2& p, int axis) const {
      const std::pair<double, double> v = Reader::interval(p, axis);
      Word result = v.first == v.second && std::isfinite(v.first)
                        ? Quadtree_mesh_2::internal::floor_of_scaled(v.first, depth_ - exponent_)
                        : floor_(Reader::exact(p, axis));
      result -= origin_[static_cast<std::size_t>(axis)];
      return result;
    }

    bool is_in_root(const Point_2& p, int axis) const {
      if constexpr (is_over_double)
        if (!std::isfinite(axis == 0 ? p.x() : p.y())) return false;
      const Word w = coordinate(p, axis);
      return w == 0 || (w > 0 && static_cast<int>(msb(w)) < depth_);
    }

    Quadtree_mesh_2::internal::Scaled_integer place(const Word& w, int axis) const {
      return {w + origin_[static_cast<std::size_t>(axis)], exponent_ - depth_};
    }

    FT number(const Word& w, int axis) const {
      const Quadtree_mesh_2::internal::Scaled_integer v = place(w, axis);
      if constexpr (is_over_double)
        return v.to_double();
      else
        return v.is_double() ? FT(v.to_double()) : FT(v.to_exact(unit_));
    }

    int depth_ = first_depth;
    int exponent_;
    std::array<Word, 2> origin_; // in units of the grid
    Floor floor_;
    Exact unit_;
  };

  /// Makes the grid of a range of points.
  class Construct_grid_2 {
  public:
    /// Makes the grid of some points.
    /// \tparam PointRange a range with value type `Point_2`.
    /// \throws Quadtree_mesh_2::Point_error if coordinates are doubles and one is not finite or not below
    /// 2^1000.
    template <class PointRange>
    Grid_2 operator()(const PointRange& points) const {
      std::size_t n = 0;
      std::array<Point_2, 4> extremes; // lowest and highest x, lowest and highest y
      for (const Point_2& p : points) {
        check(p, Quadtree_mesh_2::Point_index(n));
        if (n++ == 0)
          extremes = {p, p, p, p};
        else
          extend(extremes, p);
      }
      return n == 0 ? Grid_2() : make_grid(extremes);
    }

  private:
    static void extend(std::array<Point_2, 4>& extremes, const Point_2& p) {
      const auto compare_x = Kernel().compare_x_2_object();
      const auto compare_y = Kernel().compare_y_2_object();
      if (compare_x(p, extremes[0]) == SMALLER) extremes[0] = p;
      if (compare_x(p, extremes[1]) == LARGER) extremes[1] = p;
      if (compare_y(p, extremes[2]) == SMALLER) extremes[2] = p;
      if (compare_y(p, extremes[3]) == LARGER) extremes[3] = p;
    }

    static Grid_2 make_grid(const std::array<Point_2, 4>& extremes) {
      const Exact x = Reader::exact(extremes[0], 0), y = Reader::exact(extremes[2], 1);
      const Exact width = Reader::exact(extremes[1], 0) - x, height = Reader::exact(extremes[3], 1) - y;
      const int exponent = exponent_for(width < height ? height : width);
      const Floor in_granules(log_granules - exponent);
      return Grid_2(exponent, {in_granules(x) - granules / 4, in_granules(y) - granules / 4});
    }

    // The box may begin anywhere in a granule, so it can be as large as half the root less one granule.
    static int exponent_for(const Exact& extent) {
      using Quadtree_mesh_2::internal::floor_of_logarithm;
      using Quadtree_mesh_2::internal::power_of_two;
      if (CGAL::is_zero(extent)) return 0;
      const int k = floor_of_logarithm(extent);
      const Exact greatest = power_of_two<Exact>(k + 2 - log_granules) * Exact(granules / 2 - 1);
      return greatest < extent ? k + 3 : k + 2;
    }

    static void check(const Point_2& p, Quadtree_mesh_2::Point_index i) {
      if constexpr (is_over_double) {
        using Quadtree_mesh_2::Point_error;
        if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
          throw Point_error(Point_error::Kind::NOT_FINITE, i);
        // Corners of the root have to be finite.
        const double limit = std::ldexp(1.0, 1000);
        if (!(std::fabs(p.x()) < limit && std::fabs(p.y()) < limit))
          throw Point_error(i, "below 2^1000 in magnitude");
      }
    }
  };

  /// The function object that makes grids.
  Construct_grid_2 construct_grid_2_object() const { return {}; }

private:
  // The origin of the root is a multiple of a granule.
  static constexpr int log_granules = 6;
  static constexpr int granules = 1 << log_granules;
};

} // namespace CGAL

#define CGAL_QUADTREE_MESH_2_HAS_EXACT_TRAITS
#include <CGAL/Quadtree_mesh_2/compiled_meshers.h>

#endif // CGAL_EXACT_QUADTREE_TRAITS_2_H
