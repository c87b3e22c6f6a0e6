// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILE_FOREST_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILE_FOREST_H

#include <CGAL/Quadtree_mesh_2/internal/Grid_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/fill_tiles.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Concurrency_tag, class Geometry>
class Tile_forest {
public:
  using Point = typename Geometry::Point;

  Tile_forest(const std::vector<Point>& points, Grid_frame<Geometry> frame, const Tile_options& options)
      : points_(points), frame_(std::move(frame)), filler_(sites(), options) {
    filler_.set_first_levels();
  }

  Site_mesh<Geometry> fill() {
    filler_.fill();
    const Tile_mesh& tiles = filler_.filling().mesh;
    Site_mesh<Geometry> result;
    result.mesh.points.resize(tiles.number_of_vertices());
    for_each_index<Concurrency_tag>(
        tiles.number_of_vertices(),
        [&](std::size_t v) { result.mesh.points[v] = frame_.to_point(tiles.places[v]); }, default_block / 8);
    result.mesh.set_triangles(tiles.triangles);
    for_each_index<Concurrency_tag>(tiles.number_of_vertices(), [&](std::size_t v) {
      result.mesh.rings[v].mobility = mobility(tiles.sides[v]);
    });
    result.sites = points_;
    result.vertex_of_site.assign(tiles.vertex_of_site.begin(), tiles.vertex_of_site.end());
    result.is_placed.assign(points_.size(), 0);
    // fixed from the beginning, lest one is removed that waits to be moved
    for (const Ring_vertex v : result.vertex_of_site) result.mesh.ring(v).mobility = Mobility::fixed;
    return result;
  }

  void split(std::size_t site) { filler_.split(site); }

private:
  const std::vector<Point>& points_;
  Grid_frame<Geometry> frame_;
  Tile_filler<Concurrency_tag> filler_;

  Tile_sites sites() const {
    Tile_sites result;
    result.places.resize(points_.size());
    for_each_index<Concurrency_tag>(points_.size(), [&](std::size_t i) {
      const auto g = frame_.to_grid(points_[i]);
      result.places[i] = {g.x, g.y};
    });
    const Grid_window& w = frame_.window();
    result.window.level = w.level;
    result.window.x0 = w.x0, result.window.x1 = w.x1, result.window.y0 = w.y0, result.window.y1 = w.y1;
    return result;
  }

  static Mobility mobility(std::uint8_t sides) {
    const bool is_across = (sides & (left_side | right_side)) != 0, is_along = (sides & (bottom_side | top_side)) != 0;
    return is_across && is_along ? Mobility::fixed
           : is_across           ? Mobility::slides_across
           : is_along            ? Mobility::slides_along
                                 : Mobility::free;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILE_FOREST_H
