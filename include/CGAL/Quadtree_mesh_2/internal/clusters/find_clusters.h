// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The clusters of a set of points (section 5 of the paper, before Theorem 4).
//
// Computes: the tree of all clusters. A cluster is a set C of at least two points, but not all, with
//               distance(C, other points) >= gap * width(C),
//           where the width is the larger side of the bounding box. For a gap above sqrt(2), clusters are
//           disjoint or nested. So there are at most n - 1 of them. They are the nodes of a tree whose root
//           is the set of all points. A cluster becomes a quadtree of its own, in which a point stands for
//           each cluster inside it. That quadtree takes the place of one vertex of its parent's
//           (Cluster_frame.h).
// Bound:    O(n log n).
// Method:   Single linkage. Kruskal's algorithm makes the points' minimum spanning tree from the edges of
//           their Delaunay triangulation. When it is about to link a component by an edge, the length of the
//           edge is the component's distance to all other points. Each cluster is a component at some time.
// Deviates: the paper finds candidates in the framework tree. It then merges up to four candidates or points
//           near a common corner of their squares. Distances know nothing of squares, so nothing has to be
//           merged here. Exactly the sets of the definition are found.
//
// The least gap. Let d be the distance of a cluster to all other points, and w its width. Let R be the
// distance of two sites. Sites are points, and the centers p of clusters.
// * The cluster's cells have side sigma, a power of two, with 2.5 w <= sigma < 5 w (Cluster_frame.h says
//   why).
// * The center p is a multiple of sigma/8 next to the middle of the box. So it is at most sqrt(2) (w/2 +
//   sigma/16 + rounding) < 1.15 w from each point. The same holds for a site that is a cluster. Its width is
//   at most D/gap, if D is the distance of the two sets. So |R - D| <= 2 * 1.15 D/gap < D/512 for gap >=
//   1178. What follows uses (1 - 1/512) D instead of R.
// * The leaf in the place of the cluster has a side s, the greatest power of two with s <= (1 - 1/512) d/7.
//   The octagon replaces a vertex of this leaf. With its triangles, it fits into the vertex's star if 5 *
//   10.8125 sigma <= s. As both are powers of two, this means 64 sigma <= s. It holds if (1 - 1/512) d >= 7 *
//   64 sigma, hence if d >= 7 * 64 * 5/(1 - 1/512) w = 2244.4 w.
// A gap of 2248 leaves room for the rounding of lengths. So replacing the clusters inside a cluster by points
// never makes that cluster inadmissible, and none has to be dissolved for that reason.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_FIND_CLUSTERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_FIND_CLUSTERS_H

#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/delaunay_edges.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// With a smaller gap a cluster may not fit into the place of a vertex.
constexpr double least_cluster_gap = 2248;

/// Components of points that grow together, with their bounding boxes and the topmost clusters in them.
template <class Geometry>
class Linked_components {
public:
  using Point = typename Geometry::Point;

  Linked_components(const std::vector<Point>& points, double gap)
      : points_(points), gap_(gap), parents_(points.size()), sizes_(points.size(), 1), boxes_(points.size()),
        first_(points.size()), last_(points.size()), next_(points.size(), none), owners_(points.size(), 0),
        found_(1) {
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      parents_[i] = first_[i] = last_[i] = i;
      boxes_[i] = {i, i, i, i};
    }
  }

  std::uint32_t component(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  /// Links two components by an edge of the minimum spanning tree, next to be made.
  void link(std::uint32_t a, std::uint32_t b, double length) {
    close_if_cluster(a, length);
    close_if_cluster(b, length);
    if (sizes_[a] < sizes_[b]) std::swap(a, b);
    parents_[b] = a;
    sizes_[a] += sizes_[b];
    boxes_[a] = joined(points_, boxes_[a], boxes_[b]);
    next_[last_[a]] = first_[b];
    last_[a] = last_[b];
  }

  /// The clusters, when all points are in one component.
  Cluster_tree take_tree() {
    if (points_.empty()) return Cluster_tree();
    const std::uint32_t root = component(0);
    set_owner(root, 0);
    found_[0].box = boxes_[root];
    found_[0].width = width_of<Geometry>(points_, boxes_[root]);
    found_[0].distance = std::numeric_limits<double>::infinity();
    return Cluster_tree(std::move(found_), std::move(owners_));
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  const std::vector<Point>& points_;
  double gap_;
  std::vector<std::uint32_t> parents_, sizes_;
  std::vector<Cluster_box> boxes_;
  // By component the list of its items: points, and clusters with numbers behind those of points.
  std::vector<std::uint32_t> first_, last_, next_;
  std::vector<std::int32_t> owners_; // of points
  std::vector<Found_cluster> found_; // the first is the root

  void close_if_cluster(std::uint32_t c, double distance) {
    if (first_[c] == last_[c]) return; // one point, or a cluster that is closed already
    const double width = width_of<Geometry>(points_, boxes_[c]);
    if (!(distance >= gap_ * width)) return;
    const auto number = static_cast<std::int32_t>(found_.size());
    set_owner(c, number);
    Found_cluster cluster;
    cluster.box = boxes_[c];
    cluster.width = width;
    cluster.distance = distance;
    found_.push_back(cluster);
    first_[c] = last_[c] =
        static_cast<std::uint32_t>(points_.size()) + static_cast<std::uint32_t>(number) - 1;
    next_.push_back(none);
  }

  void set_owner(std::uint32_t c, std::int32_t owner) {
    for (std::uint32_t item = first_[c]; item != none; item = next_[item])
      if (item < points_.size())
        owners_[item] = owner;
      else
        found_[item - points_.size() + 1].parent = owner;
  }
};

/// Finds the clusters.
/// \param gap at least `least_cluster_gap` if the clusters are to be meshed.
/// \pre the points are distinct
template <class Geometry>
Cluster_tree find_clusters(const std::vector<typename Geometry::Point>& points, double gap) {
  CGAL_precondition(gap > 2);
  Linked_components<Geometry> components(points, gap);
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  for (const Measured_edge& edge : sorted_delaunay_edges<Geometry>(points)) {
    nearest[edge.a] = std::min(nearest[edge.a], edge.length);
    nearest[edge.b] = std::min(nearest[edge.b], edge.length);
    const std::uint32_t a = components.component(edge.a), b = components.component(edge.b);
    if (a != b) components.link(a, b, edge.length);
  }
  Cluster_tree tree = components.take_tree();
  tree.nearest = std::move(nearest);
  return tree;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_FIND_CLUSTERS_H
