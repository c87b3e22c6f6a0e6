// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The box of the points of a quadtree, on its grid.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_GRID_BOX_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_GRID_BOX_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Grid_point>
struct Grid_box {
  Grid_point low, high;

  Grid_box united_with(const Grid_box& b) const {
    return {{std::min(low.x, b.low.x), std::min(low.y, b.low.y)},
            {std::max(high.x, b.high.x), std::max(high.y, b.high.y)}};
  }
  /// Sides included.
  bool contains(const Grid_point& p) const {
    return !(p.x < low.x) && !(high.x < p.x) && !(p.y < low.y) && !(high.y < p.y);
  }
};

/// Beyond it the domain has ended, and maybe the kernel's coordinates.
/// \pre there are points
template <class ConcurrencyTag, class Tree>
Grid_box<typename Tree::Grid_point> box_of_points(const Tree& tree) {
  using Box = Grid_box<typename Tree::Grid_point>;
  const auto& framework = tree.framework();
  const auto box_of = [&](std::size_t i) {
    const auto p = framework.grid_point(typename Tree::Point_rank(i));
    return Box{p, p};
  };
  return reduce<ConcurrencyTag>(
      framework.number_of_points(), box_of(0),
      [&](std::size_t begin, std::size_t end) {
        Box box = box_of(begin);
        for (std::size_t i = begin + 1; i < end; ++i) box = box.united_with(box_of(i));
        return box;
      },
      [](const Box& a, const Box& b) { return a.united_with(b); });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_GRID_BOX_H
