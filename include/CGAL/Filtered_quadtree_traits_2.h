// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_FILTERED_QUADTREE_TRAITS_2_H
#define CGAL_FILTERED_QUADTREE_TRAITS_2_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry_fwd.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/double_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Traits
/// Traits for quadtrees of points of a CGAL kernel over `double`.
///
/// The grid has 2^62 units to a side. Its unit is a power of two. The root is the smallest one that
/// holds the points in its middle half. Every point is mapped without rounding to the grid square that
/// contains it. A grid point is mapped to the nearest double. That is exact for all corners of squares not
/// smaller than the spacing of doubles at the largest coordinate.
///
/// Distinct points are told apart unless they differ by less than 2^-62 of the root's side. For
/// doubles this can happen only near 0. Such points are an error that names them. `Exact_quadtree_traits_2`
/// has no such limit.
/// \tparam Kernel a CGAL kernel whose `FT` is `double`.
/// \cgalModels{QuadtreeTraits_2}
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Filtered_quadtree_traits_2 {
  static_assert(std::is_same<typename Kernel::FT, double>::value, "the kernel must be over double");

public:
  /// \name Types
  /// @{

  /// A point of the input.
  using Point_2 = typename Kernel::Point_2;
  /// A grid coordinate.
  using Word = std::uint64_t;
  static constexpr int depth = 62; ///< the logarithm of the root's side in grid units
  /// A point of the grid.
  using Grid_point = Quadtree_mesh_2::Grid_point_2<Word>;
  /// The arithmetic of the meshers on these points.
  using Meshing_geometry_2 = Quadtree_mesh_2::internal::Double_geometry_2<Kernel>;
  /// @}

  /// The map between points and the grid. The default is the grid of no points.
  class Grid_2 {
  public:
    /// The grid of no points.
    Grid_2() = default;

    /// The logarithm of the root's side, 62.
    int depth() const { return Filtered_quadtree_traits_2::depth; }
    /// Returns false: the words cannot be longer.
    bool refine() { return false; }

    /// Returns whether `p` lies in the root square; false if a coordinate is not a number.
    bool is_in_root(const Point_2& p) const { return x_.contains(p.x()) && y_.contains(p.y()); }

    /// Returns the lower left corner of the unit square that contains `p`.
    /// \pre `is_in_root(p)`
    Grid_point grid_point(const Point_2& p) const { return {x_.to_grid(p.x()), y_.to_grid(p.y())}; }

    /// Returns the point at `g`, each coordinate rounded to the nearest double.
    /// \pre coordinates of `g` are at most 2^62
    Point_2 point(const Grid_point& g) const { return Point_2(x_.to_double(g.x), y_.to_double(g.y)); }

  private:
    friend class Filtered_quadtree_traits_2;
    using Axis = Quadtree_mesh_2::internal::Double_axis;

    Grid_2(const Axis& x, const Axis& y) : x_(x), y_(y) {}

    Axis x_;
    Axis y_;
  };

  /// Makes the grid of a range of points.
  class Construct_grid_2 {
  public:
    /// Makes the grid of some points.
    /// \tparam PointRange a range with value type `Point_2`.
    /// \throws Quadtree_mesh_2::Point_error for a coordinate that is not finite or not below
    /// 2^1000.
    template <class PointRange>
    Grid_2 operator()(const PointRange& points) const {
      using Quadtree_mesh_2::internal::Double_axis;
      using Quadtree_mesh_2::internal::Root_side;
      const auto [x, y, is_good] = box_of(points);
      const double greatest = Quadtree_mesh_2::internal::greatest_coordinate();
      if (!is_good || x.magnitude() >= greatest || y.magnitude() >= greatest) throw_for_first_bad(points);
      const Root_side root(std::max(x.extent(), y.extent()), std::max(x.magnitude(), y.magnitude()));
      return Grid_2(Double_axis(root, x.begin()), Double_axis(root, y.begin()));
    }

  private:
    struct Interval {
      double low = std::numeric_limits<double>::max();
      double high = std::numeric_limits<double>::lowest();

      void extend(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
      }
      void extend(const Interval& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
      }
      // The difference may have been rounded down; the next double is never too small.
      double extent() const { return high > low ? std::nextafter(high - low, high - low + 1) : 0; }
      double magnitude() const { return high < low ? 0 : std::max(std::fabs(low), std::fabs(high)); }
      double begin() const { return high < low ? 0 : low; }
    };

    struct Box {
      Interval x, y;
      bool is_finite = true;

      void extend(const Point_2& p) {
        x.extend(p.x());
        y.extend(p.y());
        is_finite &= p.x() - p.x() == 0 && p.y() - p.y() == 0; // false for what is not finite
      }
      void extend(const Box& other) {
        x.extend(other.x);
        y.extend(other.y);
        is_finite &= other.is_finite;
      }
    };

    template <class PointRange>
    static Box box_of(const PointRange& points) {
      using Category = typename std::iterator_traits<decltype(std::begin(points))>::iterator_category;
      const auto of_range = [&](auto begin, auto end) {
        Box box;
        for (auto p = begin; p != end; ++p) box.extend(*p);
        return box;
      };
      if constexpr (std::is_base_of_v<std::random_access_iterator_tag, Category>) {
        const auto first = std::begin(points);
        using Difference = decltype(first - first);
        return Quadtree_mesh_2::internal::reduce<Quadtree_mesh_2::internal::Chosen_tag>(
            static_cast<std::size_t>(std::end(points) - first), Box(),
            [&](std::size_t begin, std::size_t end) {
              return of_range(first + static_cast<Difference>(begin), first + static_cast<Difference>(end));
            },
            [](Box a, const Box& b) {
              a.extend(b);
              return a;
            });
      } else {
        return of_range(std::begin(points), std::end(points));
      }
    }

    template <class PointRange>
    [[noreturn]] static void throw_for_first_bad(const PointRange& points) {
      using Quadtree_mesh_2::Point_error;
      std::size_t i = 0;
      for (const Point_2& p : points) {
        const Quadtree_mesh_2::Point_index index(i++);
        const double magnitude = std::max(std::fabs(p.x()), std::fabs(p.y()));
        if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
          throw Point_error(Point_error::Kind::NOT_FINITE, index);
        if (magnitude >= Quadtree_mesh_2::internal::greatest_coordinate())
          throw Point_error(index, "below 2^1000 in magnitude");
      }
      CGAL_unreachable();
    }
  };

  /// The function object that makes grids.
  Construct_grid_2 construct_grid_2_object() const { return {}; }
};

} // namespace CGAL

#endif // CGAL_FILTERED_QUADTREE_TRAITS_2_H
