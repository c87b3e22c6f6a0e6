// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// One quadtree with its tiles, and its place: the outermost one in a frame for all points, or that of a
// cluster.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_TREE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_TREE_H

#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/cluster_collar.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/Grid_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/fill_tiles.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Tile_tree {
public:
  using Point = typename Geometry::Point;
  using Cluster_frame_2 = Cluster_frame<Geometry>;

  /// A site in whose place there will be a cluster, and the distance of that from all other points.
  struct Child_cluster {
    std::uint32_t site;
    double distance;
  };

  Tile_tree(const Grid_frame<Geometry>& frame, const std::vector<Point>& sites, const Tile_options& options)
      : frame_(frame), filler_(tile_sites(sites), options) {}

  /// Of a cluster, which is a site of another tree.
  Tile_tree(const Cluster_frame_2& frame, const std::vector<Point>& sites, const Tile_options& options,
            std::int32_t parent, std::uint32_t site_in_parent)
      : frame_(frame), parent_(parent), site_in_parent_(site_in_parent), filler_(tile_sites(sites), options) {
  }

  std::int32_t parent() const { return parent_; }
  std::uint32_t site_in_parent() const { return site_in_parent_; }
  const Cluster_frame_2& cluster_frame() const { return std::get<Cluster_frame_2>(frame_); }
  const Tile_mesh& mesh() const { return filler_.filling().mesh; }

  /// Gives clusters blocks of leaves as large as other points allow. They are never smaller.
  void set_clusters(const std::vector<Child_cluster>& clusters) {
    for (const Child_cluster& c : clusters) filler_.reserve_star(c.site, level_of_cluster(c.distance));
  }
  void set_first_levels() {
    filler_.set_first_levels(is_of_cluster() ? Cluster_frame_2::least_level_of_site : 0);
  }
  void fill(std::size_t most_tiles) { filler_.fill(most_tiles); }
  const Tile_filler<ConcurrencyTag>& filler() const { return filler_; }
  void fill_run(std::size_t r) { filler_.fill_run(r); }
  void let_go_of_leaves() { filler_.let_go_of_leaves(); }
  /// To be called when the mesh is copied: it has several times the memory of the tree.
  void let_go_of_mesh() { filler_.let_go_of_mesh(); }
  bool has_blocks() const { return !filler_.filling().sites.kinds.empty(); }
  void split(std::size_t site) { filler_.split(site); }
  void certify(std::size_t site) { filler_.certify(site); }
  bool is_certified(std::size_t site) const { return filler_.is_certified(site); }

  Point point_at(const Tile_place& place) const {
    return std::visit([&](const auto& frame) { return point_in(frame, place); }, frame_);
  }

  /// The logarithm of the side of the leaf of a site, in the units of the plane.
  int log_side_of_leaf(std::uint32_t site) const {
    return log_side_of_root() - mesh().leaves[std::size_t(mesh().leaf_of_site[site])].level;
  }

  /// The vertices around that of a cluster, counterclockwise from the east.
  std::array<std::int32_t, 8> spokes(std::uint32_t site, std::int32_t first) const {
    const auto& stars = mesh().stars;
    const auto star = std::lower_bound(stars.begin(), stars.end(), site,
                                       [](const Star_spokes& s, std::uint32_t i) { return s.site < i; });
    CGAL_assertion(star != stars.end() && star->site == site);
    std::array<std::int32_t, 8> result = star->vertices;
    for (std::int32_t& v : result) v += first;
    return result;
  }

  /// The vertices on the border of the window of a cluster, counterclockwise from its lower left corner.
  Window_vertices window_vertices(std::int32_t first) const {
    Window_vertices result;
    for (std::size_t v = 0; v < mesh().number_of_vertices(); ++v) {
      if (mesh().sides[v] == 0) continue;
      const int k = position_in_window_boundary(mesh().places[v]);
      CGAL_assertion(k >= 0);
      result[std::size_t(k)] = first + static_cast<std::int32_t>(v);
    }
    return result;
  }

private:
  std::variant<Grid_frame<Geometry>, Cluster_frame_2> frame_;
  std::int32_t parent_ = -1;
  std::uint32_t site_in_parent_ = 0;
  Tile_filler<ConcurrencyTag> filler_;

  bool is_of_cluster() const { return parent_ >= 0; }

  static Point point_in(const Grid_frame<Geometry>& frame, const Tile_place& place) {
    return frame.to_point(place);
  }
  static Point point_in(const Cluster_frame_2& frame, const Tile_place& place) {
    return frame.point_at(place);
  }
  static Tile_site place_in(const Grid_frame<Geometry>& frame, const Point& p) {
    const auto g = frame.to_grid(p);
    return {g.x, g.y};
  }
  static Tile_site place_in(const Cluster_frame_2& frame, const Point& p) {
    const auto g = frame.place_of(p);
    return {g.x, g.y};
  }

  Tile_sites tile_sites(const std::vector<Point>& sites) const {
    Tile_sites result;
    result.places.resize(sites.size());
    for_each_index<ConcurrencyTag>(sites.size(), [&](std::size_t i) {
      result.places[i] = std::visit([&](const auto& frame) { return place_in(frame, sites[i]); }, frame_);
    });
    if (const auto* frame = std::get_if<Grid_frame<Geometry>>(&frame_)) {
      const Grid_window& w = frame->window();
      result.window = {w.level, w.x0, w.x1, w.y0, w.y1};
    } else {
      constexpr auto begin = std::uint64_t(Cluster_frame_2::window_begin),
                     end = std::uint64_t(Cluster_frame_2::window_end);
      result.window = {Cluster_frame_2::level_of_cells, begin, end, begin, end};
    }
    result.max_level = max_level();
    return result;
  }

  /// Vertices of tiles that are rounded to coordinates have to keep their angles: leaves have 2^7 units or more.
  int max_level() const {
    using Coordinate = typename Geometry::Coordinate;
    constexpr int log_units = 7;
    if constexpr (std::is_integral<Coordinate>::value) {
      return std::min(max_tile_level, log_side_of_root() - log_units);
    } else if constexpr (std::is_floating_point<Coordinate>::value) {
      constexpr std::uint64_t side = std::uint64_t(1) << Tile_traits::depth;
      double largest = 0;
      for (const Tile_place& corner :
           {Tile_place{0, 0}, Tile_place{side, 0}, Tile_place{side, side}, Tile_place{0, side}}) {
        const Point p = point_at(corner);
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
      }
      constexpr int digits = std::numeric_limits<Coordinate>::digits - 1;
      return std::min(max_tile_level, log_side_of_root() - (std::ilogb(largest) - digits) - log_units);
    } else {
      return max_tile_level;
    }
  }

  /// Rounded down, for roots that are turned: those parallel to the axes have powers of two as sides.
  int log_side_of_root() const {
    if (is_of_cluster()) return cluster_frame().log_side(0);
    constexpr std::uint64_t side = std::uint64_t(1) << Tile_traits::depth;
    const Vector v = Geometry::difference(point_at({side, 0}), point_at({0, 0}));
    return std::ilogb(std::max(std::fabs(v.x), std::sqrt(squared_length(v))));
  }

  int level_of_cluster(double distance) const {
    if (is_of_cluster()) return cluster_frame().level_of_site(distance, Cluster_site::CLUSTER);
    const double leaf =
        Cluster_frame_2::distance_of_sites * distance * Cluster_frame_2::largest_leaf(Cluster_site::CLUSTER);
    // at least four leaves have to fit between a cluster and the border
    constexpr int least_level = 4;
    return std::max(least_level, log_side_of_root() - std::ilogb(leaf));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_TREE_H
