// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where the quadtree of a cluster lies: its squares in the plane, and the octagon around it.
//
// The root is a square of 8 x 8 cells. The side of a cell, sigma, is a power of two. A window of 5 x 5 cells,
// in columns and rows 1 to 5, is kept (collar_table.h). The sites of the cluster are its own points, and one
// point for each cluster inside it. All sites lie in the middle cell, number 3, and so do the blocks of
// leaves that are forced around them. The center p of the window is a multiple of sigma/8. It stands for the
// cluster in its parent's quadtree.
//
// How large sigma is. Let w be the width of the cluster, and E <= sqrt(2) w the distance from a site to
// another one. A point has a leaf of side l <= E/6, and its block reaches at most 2 l from it. A cluster has
// a leaf of side l <= E/7, and its block reaches at most 2.5 l from it. So a block reaches at most sqrt(2)
// 2.5/7 w = 0.5051 w from its site. In each coordinate, a site is at most w/2 + sigma/16 from p. For points,
// this is so by the choice of p. Centers of clusters may be 0.0003 w farther away (a share of their widths,
// find_clusters.h). Together a block reaches at most 1.0054 w + sigma/16 from p. That is at most sigma/2,
// half of the middle cell, if sigma >= 2.2982 w. So sigma is the least power of two with sigma >= 2.5 w,
// which leaves room for rounding. Then l <= 0.2358 w < sigma/8. A larger sigma does as well, if the parent's
// leaf has room for it.
//
// Exactness. The octagon's vertices are multiples of sigma/512, and the collar's are multiples of sigma/1024.
// All are within 12 sigma of p. The leaf around the octagon has a side s >= 64 sigma, and its spokes are
// multiples of s/1024 from p. So all these vertices are
// - doubles, if coordinates are below 2^42 sigma and s <= 2^48 sigma;
// - integers, if sigma >= 1024 (and all of the root is below 2^62);
// - coordinates of exact fields, always.
// Everything else in the window is at places of the grid, rounded to coordinates.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_FRAME_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_FRAME_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/dyadic_steps.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/collar_table.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/star_table.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What a site is: it says how far its leaf is to be from other sites.
enum class Cluster_site : std::uint8_t { POINT, CLUSTER };

template <class Geometry>
class Cluster_frame {
public:
  using Point = typename Geometry::Point;
  using Coordinate = typename Geometry::Coordinate;
  using Place = Grid_point_2<std::uint64_t>;

  /// \name The quadtree's root and the part of it that is kept, in cells
  /// @{
  static constexpr int log_grid = 62; ///< the root's side in grid units
  static constexpr int level_of_cells = 3;
  static constexpr int window_begin = 1, window_end = 6, middle_cell = 3;
  /// Leaves of sites are at least of this level.
  static constexpr int least_level_of_site = level_of_cells + 3;
  /// @}

  static constexpr double least_cell_in_widths = 2.5;
  /// Sides of leaves are at most this share of the distance to other sites.
  static constexpr double largest_leaf(Cluster_site kind) {
    return kind == Cluster_site::POINT ? 1. / 6 : 1. / 7;
  }
  /// Sites are at least this share of the distance of the clusters apart that they stand for.
  static constexpr double distance_of_sites = 1 - 1. / 512;
  /// log(s/sigma), at least, for the leaf with side s around the octagon
  static constexpr int log_least_leaf = 6;

  Cluster_frame() = default;

  /// The frame around the points of a cluster, whose cells have side 2^exponent.
  Cluster_frame(const std::vector<Point>& points, const Cluster_box& box, int exponent)
      : center_{middle_multiple(points[box.left].x, points[box.right].x, exponent - 3),
                middle_multiple(points[box.bottom].y, points[box.top].y, exponent - 3)},
        exponent_(exponent) {}

  /// log(sigma) for a cluster.
  /// \pre `width > 0`
  static int exponent_for_width(double width) {
    const double least = least_cell_in_widths * width;
    const int exponent = std::ilogb(least);
    return std::ldexp(1.0, exponent) < least ? exponent + 1 : exponent;
  }

  /// The site that stands for the cluster.
  const Point& center() const { return center_; }
  /// log(sigma)
  int exponent() const { return exponent_; }
  double cell() const { return std::ldexp(1.0, exponent_); }

  /// The level of the leaf of a site.
  /// \param distance that of the nearest other point, or from the cluster to it; infinite if there is no other site.
  int level_of_site(double distance, Cluster_site kind) const {
    const double leaf = distance_of_sites * distance * largest_leaf(kind);
    if (!(leaf < cell())) return least_level_of_site;
    return std::max(least_level_of_site, level_of_cells + exponent_ - std::ilogb(leaf));
  }
  /// log of the side of squares of a level, in the plane.
  int log_side(int level) const { return exponent_ + level_of_cells - level; }

  /// A point's place in the grid, rounded down.
  /// \pre it lies in the root
  Place place_of(const Point& p) const {
    return {place_on_axis(p.x, center_.x), place_on_axis(p.y, center_.y)};
  }
  /// The point at a place of the grid, exactly if its coordinates allow it.
  Point point_at(const Place& place) const {
    return {add_steps(center_.x, steps_from_center(place.x), log_unit()),
            add_steps(center_.y, steps_from_center(place.y), log_unit())};
  }

  /// The vertices of the octagon counterclockwise, the first the lower end of the side in the east; exactly.
  Point octagon_vertex(int k) const { return collar_vertex(k); }
  /// A vertex of `collar()`; exactly. Those of the window are points at places, too.
  Point collar_vertex(int k) const {
    const auto& v = collar().vertices[std::size_t(k)];
    return translated(v[0], v[1], exponent_ - log_units);
  }
  /// The neighbors of the vertex in the place of the cluster, counterclockwise from the east.
  /// \param log_leaf log(s) for the leaf with side s of the cluster in its parent's quadtree.
  /// \pre `log_leaf - exponent() >= log_least_leaf`
  Point spoke(int k, int log_leaf) const {
    CGAL_precondition(log_leaf - exponent_ >= log_least_leaf);
    const auto& v = star().spokes[std::size_t(k)];
    return translated(v[0], v[1], log_leaf - log_units);
  }

  /// The places of the window's boundary vertices, counterclockwise from its lower left corner: 8 to 47 of the
  /// collar.
  static std::array<Place, Collar::number_of_window_vertices> window_boundary() {
    std::array<Place, Collar::number_of_window_vertices> places;
    for (int k = 0; k < Collar::number_of_window_vertices; ++k) {
      const auto& v = collar().vertices[std::size_t(Collar::number_of_octagon_vertices + k)];
      places[std::size_t(k)] = {middle + window_step(v[0]), middle + window_step(v[1])};
    }
    return places;
  }

private:
  static constexpr int log_units = 10; // those of tables
  static_assert(Collar::units == 1 << log_units, "units of the tables");
  static constexpr int log_cell = log_grid - level_of_cells; // in grid units
  static constexpr std::uint64_t middle = std::uint64_t(2 * middle_cell + 1) << (log_cell - 1);

  Point center_ = Point();
  int exponent_ = 0;

  int log_unit() const { return exponent_ - log_cell; }

  static std::uint64_t window_step(std::int16_t v) {
    return static_cast<std::uint64_t>(std::int64_t(v) * (std::int64_t(1) << (log_cell - log_units)));
  }
  static std::int64_t steps_from_center(std::uint64_t x) { return static_cast<std::int64_t>(x - middle); }
  std::uint64_t place_on_axis(const Coordinate& c, const Coordinate& center) const {
    return middle + static_cast<std::uint64_t>(count_steps(c, center, log_unit()));
  }
  Point translated(std::int64_t x, std::int64_t y, int exponent) const {
    return {add_steps(center_.x, x, exponent), add_steps(center_.y, y, exponent)};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_FRAME_H
