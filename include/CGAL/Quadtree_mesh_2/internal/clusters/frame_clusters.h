// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Frames for the clusters of some points, and the changes to their tree that give each of them a frame.
//
// * A cluster's cells get the least side that its width allows and for which coordinates can hold what is
//   made of the cluster (Cluster_frame.h).
// * The leaf in a cluster's place has to be 64 times as large. If it cannot be, the cluster is dissolved: its
//   points and clusters become its parent's. With gaps of at least `least_cluster_gap`, this happens only to
//   clusters of about the size of the coordinates' last bits.
// * The leaf may be so large that its vertices around the octagon are not coordinates. Then more cells go
//   between, a bridge. A bridge is a cluster whose only site is the cluster, or another bridge. It stands for
//   a factor of 2^43 or more. So doubles need at most 50 bridges for a gap, and mostly none. Other
//   coordinates need none. Let D be the distance of the cluster. The center of a bridge with cells sigma <=
//   D/448 is at most sqrt(2)/16 sigma < D/5000 from the middle of its box. This is within the bounds of
//   find_clusters.h.
//
// O(n).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_FRAME_CLUSTERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_FRAME_CLUSTERS_H

#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/dyadic_steps.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Clusters with their frames. The distance of a cluster that is alone in its parent is infinite.
template <class Geometry>
struct Framed_clusters {
  Cluster_tree tree;
  std::vector<Cluster_frame<Geometry>> frames; ///< by cluster
};

template <class ConcurrencyTag, class Geometry>
class Cluster_framer {
public:
  using Point = typename Geometry::Point;
  using Frame = Cluster_frame<Geometry>;
  using Room = Dyadic_room<Geometry>;

  Cluster_framer(const std::vector<Point>& points, const Cluster_tree& tree) : points_(points), tree_(tree) {}

  Framed_clusters<Geometry> run() {
    Framed_clusters<Geometry> result;
    if (tree_.clusters.empty()) return result;
    for (const Cluster& c : tree_.clusters) add(c);
    std::vector<std::int32_t> owners(points_.size());
    for_each_index<ConcurrencyTag>(
        tree_.clusters.size(),
        [&](std::size_t k) {
          for (std::uint32_t i = tree_.clusters[k].first_point; i < tree_.clusters[k].end_point; ++i)
            owners[tree_.points[i]] = node_[k];
        },
        1);
    result.tree = Cluster_tree::of<ConcurrencyTag>(found_, owners);
    result.tree.nearest = tree_.nearest;
    for (const Cluster& c : result.tree.clusters)
      result.frames.push_back(Frame(points_, c.box, exponents_[std::size_t(c.source)]));
    return result;
  }

private:
  const std::vector<Point>& points_;
  const Cluster_tree& tree_;
  std::vector<std::int32_t> node_; // by cluster of the tree, that which has its sites now
  std::vector<Found_cluster> found_;
  std::vector<int> exponents_; // like `found_`

  /// Parents are added before.
  void add(const Cluster& c) {
    const int exponent = exponent_for(c);
    if (c.parent < 0) {
      node_.push_back(push(c, -1, c.distance, exponent));
      return;
    }
    const std::int32_t parent = node_[std::size_t(c.parent)];
    const int log_leaf =
        std::ilogb(Frame::distance_of_sites * c.distance * Frame::largest_leaf(Cluster_site::CLUSTER));
    node_.push_back(log_leaf - exponent < Frame::log_least_leaf ? parent
                                                                : add_bridged(c, parent, exponent, log_leaf));
  }

  /// Adds bridges from the outermost to the innermost, and the cluster.
  std::int32_t add_bridged(const Cluster& c, std::int32_t parent, int exponent, int log_leaf) {
    std::vector<int> bridges; // from inside
    for (int last = exponent; log_leaf - last > Room::bits_of_spokes; last = bridges.back())
      bridges.push_back(
          std::min(last + Room::bits_of_spokes + log_cells_in_leaf, log_leaf - Frame::log_least_leaf));
    double distance = c.distance;
    for (std::size_t k = bridges.size(); k-- > 0; distance = std::numeric_limits<double>::infinity())
      parent = push(c, parent, distance, bridges[k]);
    return push(c, parent, distance, exponent);
  }
  /// The leaf of the only site of a bridge has 2^-3 of the side of its cells.
  static constexpr int log_cells_in_leaf = Frame::least_level_of_site - Frame::level_of_cells;

  std::int32_t push(Found_cluster c, std::int32_t parent, double distance, int exponent) {
    c.parent = parent;
    c.distance = distance;
    found_.push_back(c);
    exponents_.push_back(exponent);
    return static_cast<std::int32_t>(found_.size()) - 1;
  }

  int exponent_for(const Cluster& c) const {
    const double largest = largest_coordinate(c.box);
    const int least = Room::least_exponent(largest);
    // a point by itself has no width: any size will do
    const int wanted = c.width > 0   ? Frame::exponent_for_width(c.width)
                       : largest > 0 ? std::ilogb(largest)
                                     : 0;
    return std::max(wanted, least);
  }

  double largest_coordinate(const Cluster_box& box) const {
    double largest = 0;
    for (std::uint32_t i : {box.left, box.right, box.bottom, box.top}) {
      const Vector v = Geometry::difference(points_[i], Point());
      largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
    }
    return largest;
  }
};

/// Gives each cluster its frame.
/// \pre integer coordinates are below 2^56
template <class ConcurrencyTag, class Geometry>
Framed_clusters<Geometry> frame_clusters(const std::vector<typename Geometry::Point>& points,
                                         const Cluster_tree& tree) {
  return Cluster_framer<ConcurrencyTag, Geometry>(points, tree).run();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_FRAME_CLUSTERS_H
