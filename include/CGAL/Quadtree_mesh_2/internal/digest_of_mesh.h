// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DIGEST_OF_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DIGEST_OF_MESH_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Checkpoint_file.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Adds all options that change the mesh, but not the user's functions.
inline void add_options(Digest& digest, const Quality_mesh_options_2& options) {
  digest.add(std::array{options.min_angle(), options.max_area(), options.max_edge(), options.min_edge(),
                        options.patience(), options.patience_memory(), options.gradation(),
                        options.max_edge_ratio(), options.max_angle()});
  digest.add(std::array{int(options.mesh_domain()), int(options.coarsen()), options.smooth(), options.thin(),
                        int(options.separate()), options.size() ? 1 : 0, options.refine_where() ? 1 : 0});
  digest.add(options.max_vertices());
  digest.add(options.max_steiner_vertices().value_or(std::numeric_limits<std::size_t>::max()));
  digest.add(int(options.conform()));
  digest.add(int(options.keep_borders()));
}

/// Of the input and of all options that change the mesh, but not of the user's functions.
/// \param points the vertices in the kernel's coordinates, in `order`
template <class Point, class Map, class Points, class Order>
Digest digest_of_mesh(const Pslg_2<Point>& pslg, const Quality_mesh_options_2& options, const Map& map,
                      const Points& points, const Order& order) {
  Digest digest;
  const auto add_values = [&digest](const auto& values) {
    digest.add(values.data(), values.size() * sizeof(*values.data()));
  };
  add_values(points), add_values(order), add_values(pslg.segments);
  for (const Point& p : pslg.holes) digest.add(map.to_kernel(p));
  for (const auto& region : pslg.regions)
    digest.add(map.to_kernel(region.point)), digest.add(region.max_area);
  add_options(digest, options);
  if (options.keep_borders() == Quality_mesh_options_2::Keep_borders::MARKED)
    add_values(pslg.segment_markers);
  digest.add(options.checkpoint_key());
  digest.add(map.length_to_kernel(1.0)); // inputs may differ by their scale and origin alone
  if (points.size() > 0) digest.add(map.place(points.front())), digest.add(map.place(points.back()));
  return digest;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DIGEST_OF_MESH_H
