// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The boxes around the sets of a single linkage.
//
// Computes: for each link the box around its set.
// Bound:    O(n) work in O(log n) rounds.
// Method:   A set is that of the link before it in its chain and what the link adds: all that shorter edges link to the
//           core of the component that joins, which is the set of the last link of that component's own chain. So
//           boxes are joined along chains, a prefix sum, after those of the chains of earlier rounds.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_LINKAGE_BOXES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_LINKAGE_BOXES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Component_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Single_linkage.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Linkage_boxes {
public:
  using Point = typename Geometry::Point;

  Linkage_boxes(const std::vector<Point>& points, const Single_linkage& linkage)
      : points_(points), linkage_(linkage), boxes_(linkage.number_of_links()) {}

  Uninitialized_indexed_vector<Link_id, Cluster_box> run() {
    const std::size_t rounds = linkage_.components().number_of_rounds();
    for (std::size_t round = 1; round < rounds; ++round)
      join_along_chains(std::size_t(linkage_.first_of_round(round)),
                        std::size_t(linkage_.first_of_round(round + 1)));
    return std::move(boxes_);
  }

private:
  const std::vector<Point>& points_;
  const Single_linkage& linkage_;
  Uninitialized_indexed_vector<Link_id, Cluster_box> boxes_;

  /// Finds the boxes of links `begin` to `end - 1`, which are whole chains: within blocks, and then for the chains that
  /// began in blocks before.
  void join_along_chains(std::size_t begin, std::size_t end) {
    const std::size_t n = end - begin, blocks = (n + default_block - 1) / default_block;
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t, std::size_t b, std::size_t e) {
      join_block(begin + b, begin + e);
    });
    std::vector<Cluster_box> before(blocks); // of what of a block's first chain is in blocks before
    const auto goes_on = [&](std::size_t b) {
      return b > 0 && !linkage_.is_first_of_chain(Link_id(begin + b * default_block));
    };
    for (std::size_t b = 1; b < blocks; ++b) {
      if (!goes_on(b)) continue;
      const Link_id first(begin + (b - 1) * default_block), last(begin + b * default_block - 1);
      const bool is_all_of_block = goes_on(b - 1) && linkage_.chain(first) == linkage_.chain(last);
      before[b] = is_all_of_block ? joined(points_, before[b - 1], boxes_[last]) : boxes_[last];
    }
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t first, std::size_t last) {
      if (!goes_on(b)) return;
      const Component_id chain = linkage_.chain(Link_id(begin + first));
      for (std::size_t i = first; i < last && linkage_.chain(Link_id(begin + i)) == chain; ++i)
        boxes_[Link_id(begin + i)] = joined(points_, before[b], boxes_[Link_id(begin + i)]);
    });
  }

  void join_block(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Link_id f(i);
      boxes_[f] = i == begin || linkage_.is_first_of_chain(f)
                      ? box_of_joining(f)
                      : joined(points_, boxes_[Single_linkage::before(f)], box_of_joining(f));
    }
  }

  Cluster_box box_of_joining(Link_id f) const {
    const Cluster_box box = box_of_chain(linkage_.joining(f));
    const Component_id root = linkage_.joined_root(f);
    return root.is_valid() ? joined(points_, box, box_of_chain(root)) : box;
  }

  Cluster_box box_of_chain(Component_id c) const {
    const Link_id last = linkage_.last_of_chain(c);
    return last.is_valid() ? boxes_[last] : box_of_point(linkage_.graph().point(Vertex_id(c.value())));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_LINKAGE_BOXES_H
