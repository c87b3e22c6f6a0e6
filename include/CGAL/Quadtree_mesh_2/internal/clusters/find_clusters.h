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
// Bound:    O(n log n) expected work. O(log n) rounds, besides those of the triangulation (neighbor_edges.h) and one
//           thread that puts the clusters found in order (Cluster_tree.h).
// Method:   Single linkage (Single_linkage.h), by the edges of the points' minimum spanning tree. The first edge to
//           leave what shorter edges link is as long as its distance to all other points. Each cluster is linked at
//           some length. As it is at least as wide as its longest edge in x or in y, few sets come into question.
//           Where there is one, boxes are joined along chains, one round of components after the other.
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

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Component_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Linkage_boxes.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Single_linkage.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/neighbor_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
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

template <class ConcurrencyTag, class Geometry>
class Cluster_finder {
public:
  using Point = typename Geometry::Point;

  Cluster_finder(const std::vector<Point>& points, double gap)
      : points_(points), gap_(gap), graph_(neighbor_edges<ConcurrencyTag, Geometry>(points)),
        linkage_(Single_linkage::of<ConcurrencyTag>(graph_)) {}

  Cluster_tree run() {
    if (points_.empty()) return Cluster_tree();
    find_links();
    std::vector<Found_cluster> found(links_.size() + 1);
    std::vector<std::int32_t> owners(points_.size(), 0);
    if (!links_.empty()) {
      find_places_of_components();
      for_each_index<ConcurrencyTag>(links_.size(),
                                     [&](std::size_t k) { found[k + 1] = cluster_of(links_[k]); });
      for_each_vertex([&](Vertex_id v) { owners[graph_.point(v)] = cluster_around_[component(v)]; });
    }
    found[0] = root();
    Cluster_tree tree = Cluster_tree::of<ConcurrencyTag>(found, owners);
    tree.nearest.assign(points_.size(), std::numeric_limits<double>::infinity());
    if (points_.size() > 1)
      for_each_vertex(
          [&](Vertex_id v) { tree.nearest[graph_.point(v)] = linkage_.length_of_exit(component(v)); });
    return tree;
  }

private:
  using Boxes = Linkage_boxes<ConcurrencyTag, Geometry>;

  const std::vector<Point>& points_;
  double gap_;
  Measured_graph graph_;
  Single_linkage linkage_;
  std::vector<std::uint32_t> links_; // those whose sets are clusters; cluster k + 1 is that of links_[k]
  Uninitialized_vector<std::uint32_t> links_before_; // by link, how many of links_ are before it
  Uninitialized_indexed_vector<Component_id, std::int32_t>
      cluster_around_;                                       // by component, the least that has it
  Uninitialized_indexed_vector<Link_id, Cluster_box> boxes_; // if there may be clusters

  static Component_id component(Vertex_id v) { return Component_id(v.value()); }

  template <class F>
  void for_each_vertex(const F& f) const {
    for_each_index<ConcurrencyTag>(points_.size(), [&](std::size_t i) { f(Vertex_id(i)); });
  }

  void find_links() {
    const std::size_t n = linkage_.number_of_links();
    const bool may_be_any = reduce<ConcurrencyTag>(
        n, false,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t f = begin; f < end; ++f)
            if (may_be_cluster(Link_id(f))) return true;
          return false;
        },
        [](bool a, bool b) { return a || b; });
    if (!may_be_any) return;
    boxes_ = Boxes(points_, linkage_).run();
    links_ = pack<ConcurrencyTag>(n, [&](std::size_t f) { return is_cluster(Link_id(f)); });
  }

  /// Whether a set is so far from others that it may be a cluster. Its width is at least sqrt(1/2) of its longest edge.
  bool may_be_cluster(Link_id f) const {
    constexpr double least_width = 0.707;
    const double distance = linkage_.distance(f);
    return distance >= gap_ * least_width * linkage_.length(f) &&
           distance < std::numeric_limits<double>::infinity();
  }
  bool is_cluster(Link_id f) const {
    return may_be_cluster(f) && linkage_.distance(f) >= gap_ * width_of<Geometry>(points_, boxes_[f]);
  }

  /// Finds the least cluster around each component and its exit, from the last component to the vertices.
  void find_places_of_components() {
    find_links_before();
    const Component_tree& components = linkage_.components();
    cluster_around_.resize(components.number_of_components());
    for (std::size_t round = components.number_of_rounds(); round-- > 0;) {
      const std::size_t first = components.first_of_round(round);
      for_each_index<ConcurrencyTag>(components.first_of_round(round + 1) - first, [&](std::size_t i) {
        const Component_id c(first + i);
        cluster_around_[c] = components.is_last(c) ? 0 : least_cluster_from(linkage_.exit(c));
      });
    }
  }

  void find_links_before() {
    const std::size_t n = linkage_.number_of_links();
    links_before_.resize(n + 1);
    for_each_index<ConcurrencyTag>(links_.size() + 1, [&](std::size_t k) {
      const std::size_t begin = k == 0 ? 0 : links_[k - 1] + std::size_t(1),
                        end = k == links_.size() ? n + 1 : links_[k] + std::size_t(1);
      for (std::size_t f = begin; f < end; ++f) links_before_[f] = static_cast<std::uint32_t>(k);
    });
  }

  /// The least cluster that has the set of a link: that of a link behind it in its chain, or around the chain's
  /// component.
  std::int32_t least_cluster_from(Link_id f) const {
    const std::uint32_t k = links_before_[f.value()];
    const bool is_in_chain = k < links_.size() && linkage_.chain(Link_id(links_[k])) == linkage_.chain(f);
    return is_in_chain ? static_cast<std::int32_t>(k) + 1 : cluster_around_[linkage_.chain(f)];
  }

  Found_cluster cluster_of(std::uint32_t link) const {
    const Link_id f(link);
    Found_cluster cluster;
    cluster.parent = linkage_.is_last_of_chain(f) ? cluster_around_[linkage_.chain(f)]
                                                  : least_cluster_from(Single_linkage::behind(f));
    cluster.box = boxes_[f];
    cluster.width = width_of<Geometry>(points_, cluster.box);
    cluster.distance = linkage_.distance(f);
    return cluster;
  }

  Found_cluster root() const {
    Found_cluster cluster;
    cluster.box = box_of_points<ConcurrencyTag>(points_);
    cluster.width = width_of<Geometry>(points_, cluster.box);
    cluster.distance = std::numeric_limits<double>::infinity();
    return cluster;
  }
};

/// Finds the clusters.
/// \param gap at least `least_cluster_gap` if the clusters are to be meshed.
/// \pre the points are distinct, and integers span at most 2^61
template <class ConcurrencyTag, class Geometry>
Cluster_tree find_clusters(const std::vector<typename Geometry::Point>& points, double gap) {
  CGAL_precondition(gap > 2);
  return Cluster_finder<ConcurrencyTag, Geometry>(points, gap).run();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_FIND_CLUSTERS_H
