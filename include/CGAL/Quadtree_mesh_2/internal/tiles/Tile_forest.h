// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The meshes of tiles of all quadtrees of some points, joined to one.
//
// Computes: a mesh with a vertex for each point, not yet at its place. Other triangles have angles in [43.4,
//           72.7] degrees, around clusters in [17.3, 87.5], and less than 90 between an octagon and its
//           spokes.
// Bound:    O(n + k) work for k squares, not counting sorting. With clusters k = O(n), whatever the distances
//           are.
// Source:   Bern, Eppstein, Teng, section 5: one quadtree for all points (Theorem 3), or one for each
//           cluster, which a point represents in its parent's quadtree (Theorem 4).
//
// Trees are filled anew if some points turn out to need smaller leaves. A point that fails several times gets
// a block of leaves for itself. The block is so small that the warp of warp_table.h provably keeps [37.5,
// 78.6]. So this ends, at the latest when all points have such a block.
//
// If there is one tree with many leaves, it gives the mesh of one run of leaves after the other (Site_mesh_parts.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_FOREST_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_FOREST_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/cluster_collar.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/frame_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/Grid_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

inline void check_number_of_vertices(std::size_t n) {
  if (n >= std::size_t(std::numeric_limits<std::int32_t>::max()) / 2)
    throw std::length_error("meshes of point sets have at most 2^30 vertices");
}

/// Sizes of runs of leaves. Tests specialize it for tags of their own, to have runs in small meshes.
template <class ConcurrencyTag>
struct Tile_run_sizes {
  static constexpr std::size_t leaves = std::size_t(1) << 18;
};

/// A mesh of a run of leaves.
template <class Geometry>
struct Rim_mesh {
  Site_mesh<Geometry> mesh;
  std::vector<Tile_place> rim_places; ///< of the vertices on its rim
  std::size_t number_of_triangles;
};

template <class ConcurrencyTag, class Geometry>
class Tile_forest {
public:
  using Point = typename Geometry::Point;

  /// One quadtree for all points.
  Tile_forest(const std::vector<Point>& points, const Grid_frame<Geometry>& frame,
              const Tile_options& options)
      : points_(points), tree_of_point_(points.size(), 0), site_of_point_(points.size()),
        failures_(points.size(), 0), along_(direction_of_rows(frame)) {
    for (std::size_t i = 0; i < points.size(); ++i) site_of_point_[i] = static_cast<std::uint32_t>(i);
    trees_.emplace_back(frame, points, options);
    trees_.front().set_first_levels();
  }

  /// A quadtree for the points and clusters that are in no other cluster, in `frame`, and one for each cluster.
  /// \pre `frame` is parallel to the axes
  Tile_forest(const std::vector<Point>& points, const Grid_frame<Geometry>& frame,
              const Framed_clusters<Geometry>& clusters, const Tile_options& options)
      : points_(points), tree_of_point_(points.size()), site_of_point_(points.size()),
        failures_(points.size(), 0) {
    for (std::size_t c = 0; c < clusters.tree.clusters.size(); ++c) add_tree(c, frame, clusters, options);
    for_each_index<ConcurrencyTag>(
        trees_.size(), [&](std::size_t t) { trees_[t].set_first_levels(); }, 1);
  }

  std::size_t number_of_trees() const { return trees_.size(); }
  std::size_t number_of_certified_points() const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
      n += trees_[std::size_t(tree_of_point_[i])].is_certified(site_of_point_[i]) ? 1 : 0;
    return n;
  }

  /// Finds the leaves of all trees, and vertices for all sites. A tree without clusters may have several runs of
  /// leaves.
  /// \throws Tile_level_error naming a point to which another one is so near that squares would be too small
  void find_leaves() {
    const std::size_t most_leaves =
        trees_.size() == 1 ? Tile_run_sizes<ConcurrencyTag>::leaves : std::numeric_limits<std::size_t>::max();
    for_each_index<ConcurrencyTag>(
        trees_.size(), [&](std::size_t t) { fill(t, most_leaves); }, 1);
  }

  /// \name Runs of leaves, if there are several
  /// @{

  std::size_t number_of_runs() const { return trees_.front().filler().number_of_runs(); }
  std::array<std::size_t, 2> state_of_run(std::size_t r) const {
    return trees_.front().filler().state_of_run(r);
  }
  /// By increasing number.
  const std::vector<std::uint32_t>& sites_of_run(std::size_t r) const {
    return trees_.front().filler().sites_of_run(r);
  }

  /// The mesh of a run.
  Rim_mesh<Geometry> part(std::size_t r) {
    Tree& tree = trees_.front();
    tree.fill_run(r);
    const Tile_mesh& tiles = tree.mesh();
    Rim_mesh<Geometry> part;
    Site_mesh<Geometry>& result = part.mesh;
    result.mesh.along = along_;
    result.mesh.points.resize(tiles.number_of_vertices());
    copy_points(tree, 0, result);
    const std::vector<std::uint32_t>& numbers = sites_of_run(r);
    for (const std::uint32_t i : numbers) result.sites.push_back(points_[i]);
    result.is_placed.assign(numbers.size(), 0);
    for (const std::int32_t v : tiles.vertex_of_site) result.vertex_of_site.push_back(Ring_vertex(v));
    const auto& is_frozen = tiles.is_frozen;
    for (std::size_t v = 0; v < is_frozen.size(); ++v) {
      if (is_frozen[v] == 0) continue;
      result.rim.push_back(Ring_vertex(v));
      part.rim_places.push_back(tiles.places[v]);
    }
    for (const auto& t : tiles.triangles)
      if (std::any_of(t.begin(), t.end(), [&](std::int32_t v) { return is_frozen[std::size_t(v)] != 0; }))
        result.rim_triangles.push_back({Ring_vertex(t[0]), Ring_vertex(t[1]), Ring_vertex(t[2])});
    part.number_of_triangles = tiles.number_of_triangles();
    std::vector<Mobility> mobilities(tiles.number_of_vertices());
    for (std::size_t v = 0; v < mobilities.size(); ++v) mobilities[v] = mobility_on(tiles.sides[v]);
    for (const Ring_vertex v : result.vertex_of_site) mobilities[v.value()] = Mobility::FIXED;
    result.mesh.set_triangles(tiles.triangles);
    tree.let_go_of_mesh();
    for (const Ring_vertex v : result.mesh.rings.ids()) result.mesh.ring(v).mobility = mobilities[v.value()];
    return part;
  }

  void let_go_of_leaves() { trees_.front().let_go_of_leaves(); }

  /// With all sites, and no vertex.
  Site_mesh<Geometry> empty_mesh() const {
    Site_mesh<Geometry> result;
    result.mesh.along = along_;
    result.sites = points_;
    result.is_placed.assign(points_.size(), 0);
    result.vertex_of_site.resize(points_.size());
    return result;
  }

  /// @}

  /// The mesh of all trees. \pre `find_leaves()`, and there is one run
  Site_mesh<Geometry> mesh() {
    Site_mesh<Geometry> result = empty_mesh();
    copy_trees(result);
    for (std::size_t t = 1; t < trees_.size(); ++t) put_into_parent(t, result);
    take_out_replaced_vertices(result);
    const Indexed_vector<Ring_vertex, Mobility> mobilities = mobilities_of(result);
    for (Tree& tree : trees_) tree.let_go_of_mesh();
    result.mesh.set_triangles(triangles_);
    free_arrays(triangles_);
    for (const Ring_vertex v : result.mesh.rings.ids())
      if (result.mesh.is_alive(v)) result.mesh.ring(v).mobility = mobilities[v];
    return result;
  }

  /// Wants smaller leaves for a point that failed: half as large, and when that did not help, its own block.
  void refine_for(std::size_t point) {
    constexpr int most_failures = 3;
    Tree& tree = trees_[std::size_t(tree_of_point_[point])];
    const std::size_t site = site_of_point_[point];
    if (++failures_[point] < most_failures)
      tree.split(site);
    else
      tree.certify(site);
  }
  bool is_certified(std::size_t point) const {
    return trees_[std::size_t(tree_of_point_[point])].is_certified(site_of_point_[point]);
  }

private:
  using Tree = Tile_tree<ConcurrencyTag, Geometry>;

  const std::vector<Point>& points_;
  std::vector<std::int32_t> tree_of_point_;
  std::vector<std::uint32_t> site_of_point_;
  std::vector<std::uint8_t> failures_;
  Vector along_{1, 0};
  std::vector<Tree> trees_; ///< parents before children
  // While the trees are put together: where the vertices of trees begin; triangles; vertices that must not move, and
  // vertices in whose places there are clusters.
  std::vector<std::int32_t> first_vertex_;
  std::vector<Indexed_triangle> triangles_;
  std::vector<std::int32_t> rigid_, replaced_;

  void fill(std::size_t t, std::size_t most_leaves) try {
    trees_[t].fill(most_leaves);
  } catch (const Tile_level_error& e) {
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (tree_of_point_[i] == static_cast<std::int32_t>(t) && site_of_point_[i] == e.site())
        throw Tile_level_error(i);
    throw; // a cluster, which its frame keeps from coming so near to others
  }

  static Vector direction_of_rows(const Grid_frame<Geometry>& frame) {
    const auto z = frame.rotation();
    const Vector v{static_cast<double>(z.a), static_cast<double>(z.b)};
    return (1 / std::sqrt(squared_length(v))) * v;
  }

  void add_tree(std::size_t c, const Grid_frame<Geometry>& frame, const Framed_clusters<Geometry>& clusters,
                const Tile_options& options) {
    const Cluster& cluster = clusters.tree.clusters[c];
    std::vector<Point> sites;
    for (std::uint32_t i = cluster.first_point; i < cluster.end_point; ++i) {
      const std::uint32_t p = clusters.tree.points[i];
      tree_of_point_[p] = static_cast<std::int32_t>(c);
      site_of_point_[p] = static_cast<std::uint32_t>(sites.size());
      sites.push_back(points_[p]);
    }
    std::vector<typename Tree::Child_cluster> children;
    for (std::int32_t k = cluster.first_child; k < cluster.end_child; ++k) {
      sites.push_back(clusters.frames[std::size_t(k)].center());
      children.push_back(
          {static_cast<std::uint32_t>(sites.size() - 1), clusters.tree.clusters[std::size_t(k)].distance});
    }
    if (c == 0)
      trees_.emplace_back(frame, sites, options);
    else
      trees_.emplace_back(clusters.frames[c], sites, options, cluster.parent,
                          static_cast<std::uint32_t>(number_in_parent(clusters.tree, c)));
    trees_.back().set_clusters(children);
  }

  /// Which of the sites of its parent a cluster is.
  static std::size_t number_in_parent(const Cluster_tree& tree, std::size_t c) {
    const Cluster& parent = tree.clusters[std::size_t(tree.clusters[c].parent)];
    return parent.end_point - parent.first_point + c - std::size_t(parent.first_child);
  }

  void copy_trees(Site_mesh<Geometry>& result) {
    first_vertex_.clear();
    std::size_t vertices = 0, triangles = 0;
    for (const Tree& tree : trees_) {
      first_vertex_.push_back(static_cast<std::int32_t>(vertices));
      vertices += tree.mesh().number_of_vertices();
      triangles += tree.mesh().number_of_triangles();
    }
    check_number_of_vertices(vertices);
    result.mesh.points.resize(vertices);
    triangles_.resize(triangles);
    std::size_t first_triangle = 0;
    for (std::size_t t = 0; t < trees_.size(); ++t) {
      const Tile_mesh& tiles = trees_[t].mesh();
      const std::int32_t first = first_vertex_[t];
      copy_points(trees_[t], std::size_t(first), result);
      for_each_index<ConcurrencyTag>(tiles.number_of_triangles(), [&](std::size_t i) {
        for (std::size_t k = 0; k < 3; ++k) triangles_[first_triangle + i][k] = first + tiles.triangles[i][k];
      });
      first_triangle += tiles.number_of_triangles();
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      result.vertex_of_site[i] = Ring_vertex(vertex(tree_of_point_[i], site_of_point_[i]));
  }

  static void copy_points(const Tree& tree, std::size_t first, Site_mesh<Geometry>& result) {
    const Tile_mesh& tiles = tree.mesh();
    for_each_index<ConcurrencyTag>(
        tiles.number_of_vertices(),
        [&](std::size_t v) { result.mesh.points[Ring_vertex(first + v)] = tree.point_at(tiles.places[v]); },
        default_block / 8);
  }

  std::int32_t vertex(std::int32_t tree, std::uint32_t site) const {
    return first_vertex_[std::size_t(tree)] + trees_[std::size_t(tree)].mesh().vertex_of_site[site];
  }

  /// Puts the octagon and the collar of a cluster around its window, and takes the vertex in its place away.
  void put_into_parent(std::size_t t, Site_mesh<Geometry>& result) {
    const Tree &tree = trees_[t], &parent = trees_[std::size_t(tree.parent())];
    const std::int32_t center = vertex(tree.parent(), tree.site_in_parent());
    const std::array<std::int32_t, 8> spokes =
        parent.spokes(tree.site_in_parent(), first_vertex_[std::size_t(tree.parent())]);
    const int log_leaf = parent.log_side_of_leaf(tree.site_in_parent());
    std::vector<Point>& points = result.mesh.points.values();
    for (int k = 0; k < 8; ++k) {
      points[std::size_t(spokes[std::size_t(k)])] = tree.cluster_frame().spoke(k, log_leaf);
      rigid_.push_back(spokes[std::size_t(k)]);
    }
    replaced_.push_back(center);
    const Octagon_vertices octagon = append_octagon(tree.cluster_frame(), points);
    rigid_.insert(rigid_.end(), octagon.begin(), octagon.end());
    for (const Indexed_triangle& triangle : octagon_triangles(octagon, spokes))
      triangles_.push_back(triangle);
    append_collar(tree.cluster_frame(), octagon, tree.window_vertices(first_vertex_[t]), points, triangles_);
  }

  void take_out_replaced_vertices(const Site_mesh<Geometry>& result) {
    if (replaced_.empty()) return;
    std::vector<std::uint8_t> is_replaced(result.mesh.points.size(), 0);
    for (const std::int32_t v : replaced_) is_replaced[std::size_t(v)] = 1;
    replaced_.clear();
    triangles_.erase(std::remove_if(triangles_.begin(), triangles_.end(),
                                    [&](const Indexed_triangle& t) {
                                      return std::any_of(t.begin(), t.end(), [&](std::int32_t v) {
                                        return is_replaced[std::size_t(v)] != 0;
                                      });
                                    }),
                     triangles_.end());
  }

  /// What vertices may do, as far as they are in a triangle.
  Indexed_vector<Ring_vertex, Mobility> mobilities_of(const Site_mesh<Geometry>& mesh) {
    Indexed_vector<Ring_vertex, Mobility> result(mesh.mesh.points.size(), Mobility::FREE);
    for (std::size_t t = 0; t < trees_.size(); ++t) {
      const Tile_mesh& tiles = trees_[t].mesh();
      if (t > 0 && !trees_[t].has_blocks()) continue; // nothing to set
      for (std::size_t v = 0; v < tiles.number_of_vertices(); ++v) {
        const std::size_t first = static_cast<std::size_t>(first_vertex_[t]);
        Mobility& mobility = result[Ring_vertex(first + v)];
        if (t == 0) mobility = mobility_on(tiles.sides[v]);
        if (tiles.is_frozen[v] == 0 || mobility != Mobility::FREE) continue;
        mobility = Mobility::HELD;
      }
    }
    // fixed from the beginning, lest one is removed that waits to be moved
    for (const Ring_vertex v : mesh.vertex_of_site) result[v] = Mobility::FIXED;
    for (const std::int32_t v : rigid_) result[Ring_vertex(v)] = Mobility::RIGID;
    rigid_.clear();
    return result;
  }

  static Mobility mobility_on(std::uint8_t sides) {
    const bool is_across = (sides & (left_side | right_side)) != 0,
               is_along = (sides & (bottom_side | top_side)) != 0;
    return is_across && is_along ? Mobility::FIXED
           : is_across           ? Mobility::SLIDES_ACROSS
           : is_along            ? Mobility::SLIDES_ALONG
                                 : Mobility::FREE;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_FOREST_H
