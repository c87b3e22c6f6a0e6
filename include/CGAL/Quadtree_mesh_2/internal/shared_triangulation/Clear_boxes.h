// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where no vertices and segments of a graph are but those of a run of vertices.
//
// Computes: for each vertex of the run the largest box of a part of the run, with the vertex in it, that meets no box
//           of other parts of the graph (Graph_boxes.h); none if there is none.
// Bound:    O(log n) time for each part of the run at its seams, and a pointer for 64 vertices.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_CLEAR_BOXES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_CLEAR_BOXES_H

#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Graph_boxes.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Triangle_reach.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Vertices with consecutive numbers.
struct Vertex_run {
  std::size_t begin, end;

  bool has(Vertex_id v) const { return begin <= std::size_t(v) && std::size_t(v) < end; }
  bool has(const Vertex_run& other) const { return begin <= other.begin && other.end <= end; }
  bool meets(const Vertex_run& other) const { return begin < other.end && other.begin < end; }
};

template <class Geometry>
class Clear_boxes {
public:
  using Boxes = Graph_boxes<Geometry>;
  using Box = typename Boxes::Box;

  Clear_boxes(const Kernel_graph<Geometry>& graph, const Boxes& boxes, Vertex_run own)
      : graph_(graph), boxes_(boxes), own_(own) {
    if (boxes.number_of_levels() <= level_) return;
    clear_.resize(boxes.number_of_nodes(level_));
    for (std::size_t i = 0; i < boxes.number_of_nodes(boxes.number_of_levels() - 1); ++i)
      look_into(boxes.number_of_levels() - 1, i);
  }

  /// \returns null if there is none
  const Box* around(Vertex_id v) const {
    return clear_.empty() ? nullptr : clear_[std::size_t(v) / boxes_.length_of_node(level_)];
  }

private:
  static constexpr std::size_t level_ = 1; // of the smallest parts of the run

  const Kernel_graph<Geometry>& graph_;
  const Boxes& boxes_;
  Vertex_run own_;
  std::vector<const Box*> clear_;

  Vertex_run run_of(std::size_t level, std::size_t i) const {
    return {boxes_.first_vertex(level, i), boxes_.first_vertex(level, i + 1)};
  }

  void look_into(std::size_t level, std::size_t i) {
    const Vertex_run run = run_of(level, i);
    if (!own_.meets(run)) return;
    const Box& box = boxes_.node(level, i).places;
    if (own_.has(run) && is_clear(box)) {
      const std::size_t length = boxes_.length_of_node(level_);
      for (std::size_t v = run.begin; v < run.end; v += length) clear_[v / length] = &box;
    } else if (level > level_) {
      for (std::size_t child = boxes_.first_child(i); child < boxes_.end_of_children(level, i); ++child)
        look_into(level - 1, child);
    }
  }

  bool is_clear(const Box& box) const {
    struct Nothing {};
    bool is_met = false;
    boxes_.descend(
        Nothing(),
        [&](std::size_t begin, std::size_t end, const auto& node, Nothing) {
          return !is_met && !own_.has(Vertex_run{begin, end}) &&
                 (do_meet(box, node.places) ||
                  (!Boxes::is_empty(node.segments) && do_meet(box, node.segments)));
        },
        [&](std::size_t begin, std::size_t end, Span<Segment_index> segments, Nothing) {
          for (const Vertex_id v : Id_range<Vertex_id>(begin, end))
            is_met = is_met || do_meet(box, {graph_.points[v], graph_.points[v]});
          for (const Segment_index s : segments) {
            const auto& [a, b] = graph_.segments[std::size_t(s)];
            is_met = is_met || may_meet<Geometry>(box, graph_.points[a], graph_.points[b]);
          }
        });
    return !is_met;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_CLEAR_BOXES_H
