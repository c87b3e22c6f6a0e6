// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The tree of the clusters of some points: nodes are sets of points, each inside its parent's.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_TREE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_TREE_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The bounding box of some points, by the indices of points on its sides.
struct Cluster_box {
  std::uint32_t left = 0, right = 0, bottom = 0, top = 0;
};

inline Cluster_box box_of_point(std::uint32_t i) { return {i, i, i, i}; }

template <class Point>
Cluster_box joined(const std::vector<Point>& points, const Cluster_box& a, const Cluster_box& b) {
  return {points[b.left].x < points[a.left].x ? b.left : a.left,
          points[a.right].x < points[b.right].x ? b.right : a.right,
          points[b.bottom].y < points[a.bottom].y ? b.bottom : a.bottom,
          points[a.top].y < points[b.top].y ? b.top : a.top};
}

/// The box of some points, of which there is one at least.
template <class ConcurrencyTag, class Point>
Cluster_box box_of_points(const std::vector<Point>& points) {
  return reduce<ConcurrencyTag>(
      points.size(), Cluster_box(),
      [&](std::size_t begin, std::size_t end) {
        Cluster_box box = box_of_point(static_cast<std::uint32_t>(begin));
        for (std::size_t i = begin + 1; i < end; ++i)
          box = joined(points, box, box_of_point(static_cast<std::uint32_t>(i)));
        return box;
      },
      [&](const Cluster_box& a, const Cluster_box& b) { return joined(points, a, b); });
}

/// The larger side of a box, rounded.
template <class Geometry>
double width_of(const std::vector<typename Geometry::Point>& points, const Cluster_box& box) {
  return std::max(Geometry::difference(points[box.right], points[box.left]).x,
                  Geometry::difference(points[box.top], points[box.bottom]).y);
}

/// A cluster without its place in the tree's order.
struct Found_cluster {
  std::int32_t parent = -1;
  Cluster_box box = Cluster_box();
  double width = 0;
  double distance = 0; ///< to the nearest point outside; infinite at the root
};

struct Cluster : Found_cluster {
  std::uint32_t least_point =
      std::uint32_t(-1); ///< the least index of a point, also of those in its clusters
  /// Its children are the clusters from `first_child` to `end_child - 1`.
  std::int32_t first_child = 0, end_child = 0;
  /// Its own points, those that are in none of its children, are `Cluster_tree::points` from `first_point` on.
  std::uint32_t first_point = 0, end_point = 0;
  std::int32_t source = 0; ///< the index among the found clusters

  std::size_t number_of_sites() const {
    return std::size_t(end_point - first_point) + std::size_t(end_child - first_child);
  }
};

struct Cluster_tree {
  /// The first is the root, the set of all points. Parents precede children, and those of one parent are together
  /// and in the order of their least points. None if there is no point.
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> points; ///< by cluster, and then in increasing order
  std::vector<double>
      nearest; ///< by point, the distance of the nearest other point; infinite if it is the only one

  /// One thread puts the clusters in order, in O(k log k) time for k of them; all do the rest.
  /// \param found the clusters; that without parent is the first.
  /// \param owners for each point the least cluster it is in.
  template <class ConcurrencyTag>
  static Cluster_tree of(const std::vector<Found_cluster>& found, const std::vector<std::int32_t>& owners) {
    Cluster_tree tree;
    // stable, so that the points of a cluster are in increasing order
    const auto sorted = sort_by_keys<ConcurrencyTag>(
        owners.size(), [&](std::size_t i) { return static_cast<std::uint64_t>(owners[i]); });
    const std::vector<std::uint32_t> begin = begin_of_clusters<ConcurrencyTag>(found.size(), sorted.keys);
    tree.add_clusters(found, least_points(found, sorted.order, begin), begin);
    tree.points.resize(owners.size());
    for_each_index<ConcurrencyTag>(owners.size(), [&](std::size_t i) {
      const std::size_t source = static_cast<std::size_t>(sorted.keys[i]);
      tree.points[tree.first_point_[source] + (i - begin[source])] = sorted.order[i];
    });
    return tree;
  }

private:
  std::vector<std::uint32_t> first_point_; // like `Cluster::first_point`, by found cluster

  /// All clusters, parents before children.
  /// \param is_less the order of siblings.
  template <class Less>
  static std::vector<std::int32_t> breadth_first(const std::vector<Found_cluster>& found,
                                                 const Less& is_less) {
    // children by parent: counted, then placed
    std::vector<std::size_t> ends(found.size() + 1, 0);
    for (std::size_t c = 1; c < found.size(); ++c) ++ends[std::size_t(found[c].parent) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::size_t> next(ends);
    std::vector<std::int32_t> children(found.size());
    for (std::size_t c = 1; c < found.size(); ++c)
      children[next[std::size_t(found[c].parent)]++] = static_cast<std::int32_t>(c);

    std::vector<std::int32_t> order{0};
    order.reserve(found.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      const auto c = static_cast<std::size_t>(order[k]);
      const auto begin = children.begin() + std::ptrdiff_t(ends[c]),
                 end = children.begin() + std::ptrdiff_t(ends[c + 1]);
      std::sort(begin, end, is_less);
      order.insert(order.end(), begin, end);
    }
    return order;
  }

  /// The places where the points of clusters begin, and their number.
  /// \param owners sorted
  template <class ConcurrencyTag>
  static std::vector<std::uint32_t> begin_of_clusters(std::size_t clusters,
                                                      const Uninitialized_vector<std::uint64_t>& owners) {
    std::vector<std::uint32_t> begin(clusters + 1);
    for_each_index<ConcurrencyTag>(clusters + 1, [&](std::size_t c) {
      begin[c] =
          static_cast<std::uint32_t>(std::lower_bound(owners.begin(), owners.end(), c) - owners.begin());
    });
    return begin;
  }

  static std::vector<std::uint32_t> least_points(const std::vector<Found_cluster>& found, const Order& points,
                                                 const std::vector<std::uint32_t>& begin) {
    std::vector<std::uint32_t> least(found.size(), std::uint32_t(-1));
    for (std::size_t c = 0; c < found.size(); ++c)
      if (begin[c] < begin[c + 1]) least[c] = points[begin[c]];
    const std::vector<std::int32_t> order = breadth_first(found, std::less<std::int32_t>());
    for (std::size_t k = order.size(); k-- > 1;) {
      const auto c = static_cast<std::size_t>(order[k]), parent = static_cast<std::size_t>(found[c].parent);
      least[parent] = std::min(least[parent], least[c]);
    }
    return least;
  }

  void add_clusters(const std::vector<Found_cluster>& found, const std::vector<std::uint32_t>& least,
                    const std::vector<std::uint32_t>& begin) {
    const std::vector<std::int32_t> order = breadth_first(
        found, [&](std::int32_t a, std::int32_t b) { return least[std::size_t(a)] < least[std::size_t(b)]; });
    std::vector<std::int32_t> place(found.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      place[std::size_t(order[k])] = static_cast<std::int32_t>(k);
    first_point_.resize(found.size());
    std::uint32_t points_before = 0;
    for (std::int32_t source : order) {
      const std::size_t s = static_cast<std::size_t>(source);
      add_cluster(found[s], source, least[s], place);
      clusters.back().first_point = first_point_[s] = points_before;
      clusters.back().end_point = points_before += begin[s + 1] - begin[s];
    }
  }

  void add_cluster(const Found_cluster& found, std::int32_t source, std::uint32_t least,
                   const std::vector<std::int32_t>& place) {
    const auto number = static_cast<std::int32_t>(clusters.size());
    Cluster c;
    static_cast<Found_cluster&>(c) = found;
    c.source = source;
    c.least_point = least;
    clusters.push_back(c);
    if (number == 0) return;
    const std::int32_t parent = place[std::size_t(found.parent)];
    clusters.back().parent = parent;
    Cluster& p = clusters[std::size_t(parent)];
    if (p.end_child == 0) p.first_child = number; // no child has the number 0
    p.end_child = number + 1;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_TREE_H
