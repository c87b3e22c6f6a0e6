// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A minimum spanning tree of a graph, and the components from which it grows.
//
// Computes: components in rounds, those of the first round being the vertices. In each round every component takes
//           its exit, the shortest edge that leaves it, and what exits join becomes a component of the next. Components
//           are the nodes of a tree. The exits make up the minimum spanning tree.
// Bound:    At most log_2 n rounds, as each leaves at most half of the components. O(m) work in O(1) steps for a round,
//           not counting what follows exits to roots: at most log_2 n + 1 passes over the components. Edges within
//           components are dropped. So the bound is O((n + m) log n) work and O(log^2 n) steps. Points in a plane take
//           some 10 rounds of 3 passes, and little more than O(n) work.
// Source:   Boruvka's algorithm; pointer jumping. Kruskal's needs all edges sorted, and links one after the other.
// Method:   Of two edges of one length, that with the lesser number is the shorter one. So exits make no cycles but
//           those of two components that have the same exit. The one with the lesser number is then the root of
//           what becomes one component. Edges get shorter on the way to it. What is taken does not depend on
//           threads: they only compare, each component having one shortest edge.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_COMPONENT_TREE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_COMPONENT_TREE_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/neighbor_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/assertions.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A component of some round. The first ones are the vertices, with their numbers.
using Component_id = Index<struct Component_tag>;

class Component_tree {
public:
  /// \pre the graph is connected
  template <class ConcurrencyTag>
  static Component_tree of(const Measured_graph& graph) {
    Component_tree result;
    Builder<ConcurrencyTag>(graph, result).run();
    return result;
  }

  std::size_t number_of_components() const { return parent_.size(); }
  /// The number of components before those of a round; for the round after the last that of all.
  std::size_t first_of_round(std::size_t round) const { return first_of_round_[round]; }
  /// How many rounds have components; the last has one.
  std::size_t number_of_rounds() const { return first_of_round_.size() - 1; }

  /// The component of the next round that this one becomes a part of; none for the last.
  Component_id parent(Component_id c) const { return parent_[c]; }
  bool is_last(Component_id c) const { return !parent(c).is_valid(); }
  /// The number of the shortest edge that leaves the component.
  /// \pre `!is_last(c)`
  std::uint32_t exit(Component_id c) const { return exit_[c]; }
  /// The component whose exit joins this one to others: itself, or for a root the other one with the same exit.
  /// \pre `!is_last(c)`
  Component_id joining(Component_id c) const { return joining_[c]; }
  bool is_root(Component_id c) const { return !is_last(c) && joining(c) != c; }

private:
  template <class ConcurrencyTag>
  class Builder;

  Uninitialized_indexed_vector<Component_id, Component_id> parent_, joining_;
  Uninitialized_indexed_vector<Component_id, std::uint32_t> exit_;
  std::vector<std::size_t> first_of_round_ = {0};
};

template <class ConcurrencyTag>
class Component_tree::Builder {
public:
  Builder(const Measured_graph& graph, Component_tree& result) : graph_(graph), result_(result) {}

  void run() {
    size_ = graph_.number_of_vertices();
    open_.resize(graph_.edges.size());
    for_each_index<ConcurrencyTag>(open_.size(), [&](std::size_t e) {
      const Measured_edge& edge = graph_.edges[e];
      open_[e] = {edge.length, {edge.a.value(), edge.b.value()}, static_cast<std::uint32_t>(e)};
    });
    while (size_ > 0) {
      begin_round();
      if (size_ == 1) return;
      find_exits();
      follow_exits();
      join();
    }
  }

private:
  /// An edge between components, by their numbers in the round.
  struct Open_edge {
    double length;
    std::array<std::uint32_t, 2> ends;
    std::uint32_t number;
  };

  static constexpr std::uint32_t none_ = std::uint32_t(-1);

  const Measured_graph& graph_;
  Component_tree& result_;
  std::size_t first_ = 0, size_ = 0;     // of the components of the round
  Uninitialized_vector<Open_edge> open_; // in the order of the graph
  Uninitialized_vector<std::uint32_t> hook_,
      root_; // by component of the round: where its exit leads, and at last

  Component_id component(std::size_t i) const { return Component_id(first_ + i); }

  void begin_round() {
    first_ = result_.first_of_round_.back();
    const std::size_t end = first_ + size_;
    result_.first_of_round_.push_back(end);
    result_.parent_.resize(end), result_.joining_.resize(end), result_.exit_.resize(end);
    if (size_ == 1) result_.parent_[component(0)] = result_.joining_[component(0)] = Component_id();
  }

  /// Finds the exits, and what is at their other ends.
  void find_exits() {
    std::vector<std::atomic<std::uint32_t>> shortest(size_); // the place in `open_`
    for_each_index<ConcurrencyTag>(
        size_, [&](std::size_t i) { shortest[i].store(none_, std::memory_order_relaxed); });
    for_each_index<ConcurrencyTag>(open_.size(), [&](std::size_t e) {
      for (const std::uint32_t end : open_[e].ends) offer(shortest[end], static_cast<std::uint32_t>(e));
    });
    hook_.resize(size_);
    for_each_index<ConcurrencyTag>(size_, [&](std::size_t i) {
      const std::uint32_t e = shortest[i].load(std::memory_order_relaxed);
      CGAL_assertion(e != none_); // the graph is connected
      const auto& ends = open_[e].ends;
      result_.exit_[component(i)] = open_[e].number;
      hook_[i] = ends[0] == i ? ends[1] : ends[0];
    });
  }

  /// Makes an edge the shortest if it is.
  void offer(std::atomic<std::uint32_t>& shortest, std::uint32_t e) const {
    std::uint32_t least = shortest.load(std::memory_order_relaxed);
    while (is_shorter(e, least) && !shortest.compare_exchange_weak(least, e, std::memory_order_relaxed)) {
    }
  }
  bool is_shorter(std::uint32_t e, std::uint32_t f) const {
    return f == none_ || open_[e].length < open_[f].length || (open_[e].length == open_[f].length && e < f);
  }

  /// Finds the roots to which exits lead.
  void follow_exits() {
    root_.resize(size_);
    for_each_index<ConcurrencyTag>(size_, [&](std::size_t i) {
      const std::uint32_t other = hook_[i];
      const bool is_root = hook_[other] == i && i < other;
      root_[i] = is_root ? static_cast<std::uint32_t>(i) : other;
      result_.joining_[component(i)] = component(is_root ? other : i);
    });
    Uninitialized_vector<std::uint32_t> farther(size_);
    for (bool is_on_the_way = true; is_on_the_way;) {
      is_on_the_way = reduce<ConcurrencyTag>(
          size_, false,
          [&](std::size_t begin, std::size_t end) {
            bool is_any = false;
            for (std::size_t i = begin; i < end; ++i) {
              farther[i] = root_[root_[i]];
              is_any = is_any || farther[i] != root_[i];
            }
            return is_any;
          },
          [](bool a, bool b) { return a || b; });
      root_.swap(farther);
    }
  }

  /// Makes a component of the next round for each root, and takes the edges that remain between them.
  void join() {
    const std::vector<std::uint32_t> roots =
        pack<ConcurrencyTag>(size_, [&](std::size_t i) { return root_[i] == i; });
    Uninitialized_vector<std::uint32_t>& number = hook_; // of a root
    for_each_index<ConcurrencyTag>(roots.size(),
                                   [&](std::size_t k) { number[roots[k]] = static_cast<std::uint32_t>(k); });
    for_each_index<ConcurrencyTag>(size_, [&](std::size_t i) {
      root_[i] = number[root_[i]];
      result_.parent_[component(i)] = Component_id(first_ + size_ + root_[i]);
    });
    take_edges_between();
    size_ = roots.size();
  }

  void take_edges_between() {
    const auto is_between = [&](const Open_edge& e) { return root_[e.ends[0]] != root_[e.ends[1]]; };
    Uninitialized_vector<Open_edge> left;
    count_allocate_and_place<ConcurrencyTag>(
        open_.size(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t count = 0;
          for (std::size_t e = begin; e < end; ++e) count += is_between(open_[e]) ? 1 : 0;
          return count;
        },
        [&](std::size_t count) { left.resize(count); },
        [&](std::size_t begin, std::size_t end, std::size_t place) {
          for (std::size_t e = begin; e < end; ++e)
            if (is_between(open_[e]))
              left[place++] = {
                  open_[e].length, {root_[open_[e].ends[0]], root_[open_[e].ends[1]]}, open_[e].number};
        });
    open_ = std::move(left);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_COMPONENT_TREE_H
