// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where the vertices and segments of a graph are.
//
// Computes: a tree of boxes over runs of the vertices in shuffle order: a box of their places, and one of the segments
//           whose lesser end is in the run.
// Bound:    O(n) time, and some 8 bytes for each vertex and segment. As the order follows squares, boxes of different
//           runs hardly overlap but for long segments, and a small place meets O(log n) of them.
// Source:   a bounding volume hierarchy along a space-filling curve, as that of Lauterbach et al. (2009).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_GRAPH_BOXES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_GRAPH_BOXES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/place_box.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/Run_counters.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Segment_inserter.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A graph in the kernel's coordinates, its vertices in shuffle order.
template <class Geometry>
struct Kernel_graph {
  using Points = decltype(Kernel_mesh<Geometry>::points);

  const Points& points; ///< perhaps followed by others that are not of the graph
  std::size_t number_of_vertices;
  const std::vector<Segment_ends>& segments; ///< between vertices that are not repeated

  /// Whether a vertex is at the place of the one before it. Then it is on no segment.
  bool is_repeated(Vertex_id v) const {
    const std::size_t i = std::size_t(v);
    return i > 0 && points[v] == points[static_cast<Vertex_id>(i - 1)];
  }
};

/// Lets the ends of segments be vertices that are not repeated: the first ones of runs at one place.
/// \returns how many vertices are repeated
template <class Points>
std::size_t name_by_first(const Points& points, std::vector<Segment_ends>& segments) {
  std::size_t repeated = 0;
  Indexed_vector<Vertex_id, Vertex_id> first; // none while no vertex is repeated
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vertex_id v = static_cast<Vertex_id>(i), before = static_cast<Vertex_id>(i - 1);
    if (!(points[v] == points[before])) continue;
    if (++repeated == 1) {
      first.resize(points.size());
      for (const Vertex_id w : first.ids()) first[w] = w;
    }
    first[v] = first[before];
  }
  for (Segment_ends& ends : segments)
    if (repeated > 0) ends = {first[ends[0]], first[ends[1]]};
  return repeated;
}

template <class Geometry>
class Graph_boxes {
public:
  using Graph = Kernel_graph<Geometry>;
  using Box = Place_box<typename Geometry::Point>;

  /// What is in a run of vertices.
  struct Node {
    Box places = nothing(), segments = nothing();
  };

  /// \pre there is a vertex
  explicit Graph_boxes(const Graph& graph)
      : number_of_vertices_(graph.number_of_vertices), by_run_((number_of_vertices_ + run_ - 1) / run_) {
    sort_segments(graph);
    levels_.emplace_back(by_run_.size());
    for_each_index<Chosen_tag>(by_run_.size(),
                               [&](std::size_t run) { levels_[0][run] = node_of(graph, run); });
    while (levels_.back().size() > 1) add_level();
  }

  static bool is_empty(const Box& box) { return box.high.x < box.low.x; }

  std::size_t number_of_levels() const { return levels_.size(); }
  std::size_t number_of_nodes(std::size_t level) const { return levels_[level].size(); }
  const Node& node(std::size_t level, std::size_t i) const { return levels_[level][i]; }
  /// The nodes on the level below that are a node's parts.
  static std::size_t first_child(std::size_t i) { return i * children_; }
  std::size_t end_of_children(std::size_t level, std::size_t i) const {
    return std::min(first_child(i + 1), number_of_nodes(level - 1));
  }
  /// The vertices of each node on a level but the last one.
  static std::size_t length_of_node(std::size_t level) { return run_ << (2 * level); }
  /// The first vertex of a node; that of the one behind the last is the end of the vertices.
  std::size_t first_vertex(std::size_t level, std::size_t i) const {
    return std::min(i * length_of_node(level), number_of_vertices_);
  }

  /// Visits runs of vertices from the largest to the smallest, and what is in the smallest.
  /// \param wants `wants(begin, end, node, look)` tells whether to go into a run of vertices, and may leave out in
  ///        `look` what is not looked for there
  /// \param visit `visit(begin, end, segments, look)`, with the run of vertices and the segments of these
  template <class Look, class Wants, class Visit>
  void descend(const Look& look, const Wants& wants, const Visit& visit) const {
    descend(levels_.size() - 1, 0, look, wants, visit);
  }

private:
  static constexpr std::size_t run_ = 16, children_ = 4;

  std::size_t number_of_vertices_;
  Run_counters by_run_; // of segments
  Uninitialized_vector<Segment_index> segments_;
  std::vector<std::vector<Node>> levels_; // from the smallest runs on

  static Box nothing() {
    using Coordinate = decltype(Box::low.x);
    constexpr Coordinate most = std::numeric_limits<Coordinate>::max(),
                         least = std::numeric_limits<Coordinate>::lowest();
    return {{most, most}, {least, least}};
  }
  static void add(Box& box, const Box& other) {
    if (!is_empty(other)) box.add(other.low), box.add(other.high);
  }

  void sort_segments(const Graph& graph) {
    const auto run_of = [&](std::size_t s) {
      return std::size_t(std::min(graph.segments[s][0], graph.segments[s][1])) / run_;
    };
    const std::size_t n = graph.segments.size();
    for_each_index<Chosen_tag>(n, [&](std::size_t s) { by_run_.count(run_of(s)); });
    segments_.resize(by_run_.begin_placing());
    for_each_index<Chosen_tag>(
        n, [&](std::size_t s) { segments_[by_run_.place(run_of(s))] = Segment_index(s); });
  }

  Span<Segment_index> segments_of(std::size_t run) const {
    return {segments_.data() + by_run_.begin(run), segments_.data() + by_run_.end(run)};
  }

  Node node_of(const Graph& graph, std::size_t run) const {
    Node node;
    for (const Vertex_id v : Id_range<Vertex_id>(first_vertex(0, run), first_vertex(0, run + 1)))
      node.places.add(graph.points[v]);
    for (const Segment_index s : segments_of(run))
      for (const Vertex_id v : graph.segments[std::size_t(s)]) node.segments.add(graph.points[v]);
    return node;
  }

  void add_level() {
    const std::vector<Node>& below = levels_.back();
    std::vector<Node> level((below.size() + children_ - 1) / children_);
    for (std::size_t i = 0; i < below.size(); ++i) {
      add(level[i / children_].places, below[i].places);
      add(level[i / children_].segments, below[i].segments);
    }
    levels_.push_back(std::move(level));
  }

  template <class Look, class Wants, class Visit>
  void descend(std::size_t level, std::size_t i, Look look, const Wants& wants, const Visit& visit) const {
    const std::size_t begin = first_vertex(level, i), end = first_vertex(level, i + 1);
    if (!wants(begin, end, levels_[level][i], look)) return;
    if (level == 0) return visit(begin, end, segments_of(i), look);
    const std::size_t last = end_of_children(level, i);
    for (std::size_t child = first_child(i); child < last; ++child)
      descend(level - 1, child, look, wants, visit);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_GRAPH_BOXES_H
