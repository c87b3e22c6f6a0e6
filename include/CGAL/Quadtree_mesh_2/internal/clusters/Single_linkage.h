// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Single linkage: which sets of vertices the edges of a minimum spanning tree link, by increasing length.
//
// Computes: the links, which are the edges of the tree, in chains, one for each component of its growth
//           (Component_tree.h) but the vertices. The set of a link is what it and shorter edges link. The sets of a
//           chain's links hold each other. The first edge to leave such a set is the next link of the chain, and
//           behind the last one the exit of the chain's component.
// Bound:    O(n log n) work, O(n) not counting ways up the tree of components, which are mostly short, and one sort.
//           O(log n) rounds.
// Source:   ours. P. Sao, A. Prokopenko, D. Lebrun-Grandie, "PANDORA: A Parallel Dendrogram Construction Algorithm for
//           Single Linkage Clustering on GPU" (2024), find such chains by contracting the tree.
// Method:   A link is the exit of a component. From the component that it becomes a part of, go up to the first one
//           whose exit is longer. This one's chain has the link. Chains are sorted by length.
//
// Why chains are so. The core of a component is that of its root, and in the end a vertex.
// * Let an edge leave a component at p. Edges in the component that are no longer link p to the core. This is so in
//   the first round. In any other p lies in some part of the component. The way along exits from there leads to the
//   root, and its edges get shorter. Each of them leaves the parts at its two ends, which links it to both cores.
// * Let link f be in the chain of Z, and K its set. K has the core of Z: f leaves the two parts that it joins, and is
//   linked to their cores, from where shorter edges lead to the core of what they become a part of. On the way up to
//   Z exits are shorter than f, and the same holds. And K lies in Z, whose exit is longer than f.
// * So two sets of one chain hold each other. Let h be the first edge to leave K. If h is shorter than the exit of Z,
//   its chain is that of Z or of a component within Z. The latter would hold the set of h, hence K, and f would be in
//   its chain or in one within it. So the chain is that of Z. If h is not shorter, K is all that edges shorter than
//   the exit of Z link to its core. Then the exit leaves K, so it is h.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_SINGLE_LINKAGE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_SINGLE_LINKAGE_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Component_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/neighbor_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A link, by its place in the order of chains.
using Link_id = Index<struct Link_tag>;

class Single_linkage {
public:
  template <class ConcurrencyTag>
  static Single_linkage of(const Measured_graph& graph) {
    Single_linkage result(graph, Component_tree::of<ConcurrencyTag>(graph));
    result.sort_links<ConcurrencyTag>();
    return result;
  }

  const Measured_graph& graph() const { return graph_; }
  const Component_tree& components() const { return components_; }

  std::size_t number_of_links() const { return links_.size(); }
  /// The component whose chain has the link.
  Component_id chain(Link_id f) const { return links_[f].chain; }
  /// The component whose exit is the link.
  Component_id joining(Link_id f) const { return links_[f].joining; }
  /// The root that the link joins it to, if the link is the root's exit, too.
  Component_id joined_root(Link_id f) const { return links_[f].root; }
  double length(Link_id f) const { return links_[f].length; }
  bool is_first_of_chain(Link_id f) const { return f == Link_id(0) || chain(before(f)) != chain(f); }
  bool is_last_of_chain(Link_id f) const { return f == links_.last_id() || chain(behind(f)) != chain(f); }
  static Link_id before(Link_id f) { return Link_id(f.value() - 1); }
  static Link_id behind(Link_id f) { return Link_id(f.value() + 1); }

  /// The exit of a component. That of a vertex is the first link in whose set it is.
  /// \pre it is not the last component
  Link_id exit(Component_id c) const { return link_of_[components_.joining(c)]; }

  /// The last link of the chain of a component, whose set is all of it that shorter edges than its exit link to its
  /// core; none for vertices.
  Link_id last_of_chain(Component_id c) const {
    return c.value() < graph_.number_of_vertices() ? Link_id() : last_of_chain_[c];
  }

  /// The length of the shortest edge that leaves the set of a link; infinite if it has all vertices.
  double distance(Link_id f) const {
    if (!is_last_of_chain(f)) return length(behind(f));
    const Component_id c = chain(f);
    return components_.is_last(c) ? std::numeric_limits<double>::infinity() : length_of_exit(c);
  }
  /// \pre it is not the last component
  double length_of_exit(Component_id c) const { return graph_.edges[components_.exit(c)].length; }

  /// The first of the links in chains of components of a round, or of later ones.
  Link_id first_of_round(std::size_t round) const {
    const Component_id first(components_.first_of_round(round));
    return Link_id(
        std::partition_point(links_.begin(), links_.end(), [&](const Link& f) { return f.chain < first; }) -
        links_.begin());
  }

private:
  struct Link {
    double length;
    Component_id chain, joining, root;
  };

  const Measured_graph& graph_;
  Component_tree components_;
  Uninitialized_indexed_vector<Link_id, Link> links_;
  Uninitialized_indexed_vector<Component_id, Link_id> link_of_, last_of_chain_;

  Single_linkage(const Measured_graph& graph, Component_tree components)
      : graph_(graph), components_(std::move(components)) {}

  /// Whether an edge is shorter than the exit of a component, which has it.
  bool is_before_exit(std::uint32_t edge, Component_id c) const {
    if (components_.is_last(c)) return true;
    const std::uint32_t exit = components_.exit(c);
    const double l = graph_.edges[edge].length, other = graph_.edges[exit].length;
    return l < other || (l == other && edge < exit);
  }

  Component_id chain_of_exit(Component_id c) const {
    const std::uint32_t edge = components_.exit(c);
    do c = components_.parent(c);
    while (!is_before_exit(edge, c));
    return c;
  }

  template <class ConcurrencyTag>
  void sort_links() {
    const std::vector<std::uint32_t> joining =
        pack<ConcurrencyTag>(components_.number_of_components(), [&](std::size_t i) {
          const Component_id c(i);
          return !components_.is_last(c) && !components_.is_root(c);
        });
    const std::size_t n = joining.size();
    using Key = std::array<std::uint64_t, 2>; // the chain, and the bits of the length, which is not negative
    Uninitialized_vector<Key> keys(n);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      const Component_id c(joining[i]);
      const double length = length_of_exit(c);
      keys[i][0] = chain_of_exit(c).value();
      std::memcpy(&keys[i][1], &length, sizeof length);
    });
    const auto sorted = sort_by_keys<ConcurrencyTag>(n, [&](std::size_t i) { return keys[i]; });
    links_.resize(n);
    link_of_.resize(components_.number_of_components());
    last_of_chain_.resize(components_.number_of_components());
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      const Link_id f(i);
      const Component_id c(joining[sorted.order[i]]);
      links_[f] = {length_of_exit(c), Component_id(sorted.keys[i][0]), c, Component_id()};
      link_of_[c] = f;
      if (i + 1 == n || sorted.keys[i + 1][0] != sorted.keys[i][0]) last_of_chain_[chain(f)] = f;
    });
    for_each_index<ConcurrencyTag>(components_.number_of_components(), [&](std::size_t i) {
      const Component_id c(i);
      if (components_.is_root(c)) links_[exit(c)].root = c;
    });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_SINGLE_LINKAGE_H
