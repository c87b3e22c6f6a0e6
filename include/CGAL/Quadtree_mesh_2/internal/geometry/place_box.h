// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_PLACE_BOX_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_PLACE_BOX_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The least box with sides along the axes that holds some places of a kernel.
template <class Point>
struct Place_box {
  Point low, high;

  void add(const Point& p) {
    low.x = std::min(low.x, p.x), low.y = std::min(low.y, p.y);
    high.x = std::max(high.x, p.x), high.y = std::max(high.y, p.y);
  }
};

/// The box of a range of places, which is not empty. O(n), in parallel.
template <class ConcurrencyTag, class Places>
auto place_box(const Places& places) {
  using Box = Place_box<typename Places::value_type>;
  return reduce<ConcurrencyTag>(
      places.size(), Box{places[0], places[0]},
      [&](std::size_t begin, std::size_t end) {
        Box box{places[begin], places[begin]};
        for (std::size_t i = begin + 1; i < end; ++i) box.add(places[i]);
        return box;
      },
      [](Box a, const Box& b) {
        a.add(b.low), a.add(b.high);
        return a;
      });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_PLACE_BOX_H
