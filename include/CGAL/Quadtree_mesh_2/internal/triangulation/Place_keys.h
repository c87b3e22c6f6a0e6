// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Keys that sort places into the shuffle order of the squares of a coarse grid.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_PLACE_KEYS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_PLACE_KEYS_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/place_box.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Place_keys {
public:
  using Point = typename Geometry::Point;

  /// The grid covers the box of the points, a vector, with 2^15 squares along its longer side.
  template <class Points>
  explicit Place_keys(const Points& points) {
    const auto box = place_box<Chosen_tag>(points);
    low_ = box.low;
    const Vector size = Geometry::difference(box.high, low_);
    scale_ = last_square / std::max(std::max(size.x, size.y), 1e-300);
  }

  /// The keys of a grid that is shifted by a third of the root. No square has a side in common with one of the other.
  Place_keys shifted() const {
    Place_keys keys = *this;
    keys.offset_ = 65536.0 / 3;
    return keys;
  }

  /// The key, of 32 bits, of a place; of those outside the box that of the square next to it.
  std::uint64_t operator()(const Point& p) const {
    const Vector d = Geometry::difference(p, low_);
    return interleave(coordinate(d.x), coordinate(d.y));
  }

private:
  static constexpr double last_square = 32767;

  Point low_;
  double offset_ = 0, scale_ = 0;

  std::uint32_t coordinate(double x) const {
    return static_cast<std::uint32_t>(std::min(std::max(scale_ * x, 0.0), last_square) + offset_);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_PLACE_KEYS_H
