// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The leaves that have to be split so that all edges pass through the tree in columns, as Column_rule.h
// requires.
//
// Computes: leaves where one of these conditions fails for some edge. If there are none, all conditions hold.
//           - All leaves over a column within 3 of its widths of the edge have the column's width as their
//             side. If one of the three columns before or behind it is twice as wide, this holds within 6.
//           - Adjacent columns differ in width by at most a factor of two.
//           - A run of columns of one width has at least 4 columns if those on both ends are narrower, 6 if
//             they are wider, and 5 if there is one of each. At the ends of the edge it has 9, and 12 if the
//             whole edge has one width.
//           - No other edge is over the columns near a change of widths, within 6 of the wider columns'
//             widths.
//           Split the leaves, balance, find the edges' leaves again, and repeat.
// Bound:    O(k log k) work for an edge of k leaves, not counting repetitions: each splits some column. One
//           parallel round. Repetitions end, because leaves are only split, and only to sizes of other
//           leaves.
// Source:   ours.
//
// test_column_rule.cpp proves that the band of 3 is wide enough. Windows of vertices end at the 6th grid line ahead
// (test_vertex_certificate.cpp), and windows of changes of widths begin 3 columns before these. A short run grows
// into a wider neighbor, and is split if it has none. A change of widths near another edge moves away, into the
// wider columns. So windows of different edges, and of vertices, are disjoint.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_CLOSURE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_CLOSURE_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Edge_columns.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/leaves_in_order.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

struct Column_closure_options {
  int band = 3; ///< in widths of columns, of the wider ones near a change of widths
  std::size_t columns_between_narrower = 4;
  std::size_t columns_between_both = 5;
  std::size_t columns_between_wider = 6;
  std::size_t columns_at_ends = 9;       ///< of edges; 0 or more
  std::size_t columns_between_ends = 12; ///< of edges of one width; 0 or more
  int separation = 6; ///< of changes of widths from other edges, in widths of the wider columns; 0: any
};

/// Which edge passes through each leaf.
class Edges_of_leaves {
public:
  static constexpr std::uint32_t none = 0xffffffffu, several = 0xfffffffeu;

  template <class Pieces>
  Edges_of_leaves(std::size_t number_of_leaves, const Pieces& pieces, std::size_t number_of_segments)
      : edge_(number_of_leaves, none) {
    for (std::size_t s = 0; s < number_of_segments; ++s)
      for (const Leaf_index l : pieces[Segment_index(s)]) {
        std::uint32_t& edge = edge_[l];
        edge = edge == none || edge == s ? static_cast<std::uint32_t>(s) : several;
      }
  }

  bool has_other_than(std::size_t s, Leaf_index l) const {
    const std::uint32_t edge = edge_[l];
    return edge != none && edge != s;
  }

private:
  Indexed_vector<Leaf_index, std::uint32_t> edge_;
};

/// The conditions for one edge.
template <class Tree>
class Column_closure {
public:
  using Word = typename Tree::Word;
  using Column = Edge_column<Word>;
  using Line = Edge_line<Word>;

  /// How many columns on each side of a change of widths are near it.
  static constexpr std::size_t columns_near_change = 3;

  /// \param segment the edge's number
  Column_closure(const Tree& tree, const Line& line, const Edges_of_leaves& edges, std::size_t segment,
                 const Column_closure_options& options)
      : tree_(tree), line_(line), edges_(edges), segment_(segment), options_(options), band_(tree, line) {}

  /// Appends the leaves that have to be split.
  /// \param leaves those of the edge
  template <class Leaves>
  void append_leaves_to_split(const Leaves& leaves, std::vector<Leaf_index>& to_split) {
    columns_ = columns_along(tree_, leaves, line_);
    do split_for_neighbors();
    while (split_where_leaves_are_smaller() || split_near_other_edges());
    for (std::size_t i = 0; i < columns_.size(); ++i)
      band_.visit_nodes(columns_[i], band_of(i), [&](Node_index v) {
        if (tree_.level(v) < columns_[i].level) to_split.push_back(tree_.leaf(v));
        return true;
      });
  }

private:
  /// Columns of one width that follow each other.
  struct Run {
    std::size_t begin, end;
  };

  /// The width of the band around the edge, in widths of the column.
  int band_of(std::size_t i) const {
    const std::size_t begin = i < columns_near_change ? 0 : i - columns_near_change;
    const std::size_t end = std::min(columns_.size(), i + columns_near_change + 1);
    for (std::size_t j = begin; j < end; ++j)
      if (columns_[j].level < columns_[i].level) return 2 * options_.band;
    return options_.band;
  }

  /// Splits columns over which there is a smaller leaf in the band. Returns whether there are some.
  bool split_where_leaves_are_smaller() {
    is_split_.assign(columns_.size(), 0);
    for (std::size_t i = 0; i < columns_.size(); ++i)
      band_.visit_nodes(columns_[i], band_of(i), [&](Node_index v) {
        is_split_[i] = tree_.is_leaf(v) ? 0 : 1;
        return is_split_[i] == 0;
      });
    return split_marked();
  }

  /// Splits wider columns at changes of widths near which there is another edge. Returns whether there are some.
  bool split_near_other_edges() {
    is_split_.assign(columns_.size(), 0);
    if (options_.separation == 0) return false;
    for (std::size_t i = 1; i < columns_.size(); ++i) {
      if (columns_[i - 1].level == columns_[i].level) continue;
      const std::size_t wider = columns_[i - 1].level < columns_[i].level ? i - 1 : i;
      const std::size_t begin = i < columns_near_change ? 0 : i - columns_near_change;
      for (std::size_t j = begin; j < std::min(columns_.size(), i + columns_near_change); ++j)
        if (is_near_other_edge(j, columns_[wider].level)) is_split_[wider] = 1;
    }
    return split_marked();
  }

  /// \param level of the wider columns, beside column `i`
  bool is_near_other_edge(std::size_t i, int level) const {
    const int widths = options_.separation << std::max(0, columns_[i].level - level);
    bool is_near = false;
    band_.visit_nodes(columns_[i], widths, [&](Node_index v) {
      const auto leaves = tree_.leaves(v);
      for (Leaf_index l = leaves.begin; l != leaves.end && !is_near; ++l)
        is_near = edges_.has_other_than(segment_, l);
      return !is_near;
    });
    return is_near;
  }

  /// Splits columns until widths follow each other as they have to.
  void split_for_neighbors() {
    for (;;) {
      mark_unbalanced();
      if (split_marked()) continue;
      mark_at_short_runs();
      if (!split_marked()) return;
    }
  }

  void mark_unbalanced() {
    is_split_.assign(columns_.size(), 0);
    for (std::size_t i = 0; i + 1 < columns_.size(); ++i) {
      const int difference = columns_[i + 1].level - columns_[i].level;
      if (difference > 1) is_split_[i] = 1;
      if (difference < -1) is_split_[i + 1] = 1;
    }
  }

  void mark_at_short_runs() {
    is_split_.assign(columns_.size(), 0);
    bool is_last_marked =
        false; // one after the other: a run may be long enough when its neighbor has changed
    for (Run run{0, 0}; run.begin < columns_.size(); run.begin = run.end) {
      while (run.end < columns_.size() && columns_[run.end].level == columns_[run.begin].level) ++run.end;
      is_last_marked = !is_last_marked && mark_at(run);
    }
  }

  /// Marks what has to be split if a run is too short. Returns whether it is.
  bool mark_at(const Run& run) {
    const int level = columns_[run.begin].level;
    const bool has_left = run.begin > 0, has_right = run.end < columns_.size();
    const bool is_left_wider = has_left && columns_[run.begin - 1].level < level;
    const bool is_right_wider = has_right && columns_[run.end].level < level;
    if (run.end - run.begin >= least_length(has_left, has_right, is_left_wider, is_right_wider)) return false;
    if (is_right_wider)
      is_split_[run.end] = 1;
    else if (is_left_wider)
      is_split_[run.begin - 1] = 1;
    else if (level == tree_.framework().grid().depth())
      return false; // there are no narrower ones
    else
      std::fill(is_split_.begin() + static_cast<std::ptrdiff_t>(run.begin),
                is_split_.begin() + static_cast<std::ptrdiff_t>(run.end), std::uint8_t(1));
    return true;
  }

  std::size_t least_length(bool has_left, bool has_right, bool is_left_wider, bool is_right_wider) const {
    if (!has_left && !has_right) return options_.columns_between_ends;
    if (!has_left || !has_right) return options_.columns_at_ends;
    return is_left_wider && is_right_wider   ? options_.columns_between_wider
           : is_left_wider || is_right_wider ? options_.columns_between_both
                                             : options_.columns_between_narrower;
  }

  bool split_marked() {
    if (std::find(is_split_.begin(), is_split_.end(), std::uint8_t(1)) == is_split_.end()) return false;
    std::vector<Column> halved;
    halved.reserve(columns_.size() + 8);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (is_split_[i] != 0)
        append_halves(tree_, line_, columns_[i], halved);
      else
        halved.push_back(columns_[i]);
    }
    columns_.swap(halved);
    return true;
  }

  const Tree& tree_;
  const Line& line_;
  const Edges_of_leaves& edges_;
  std::size_t segment_;
  const Column_closure_options& options_;
  Column_band<Tree> band_;
  std::vector<Column> columns_;
  std::vector<std::uint8_t> is_split_; // for each column
};

/// The line of a segment, given by its two vertices, which are points of the tree.
template <class Tree, class Segment>
Edge_line<typename Tree::Word> line_of_segment(const Tree& tree, const Segment& ends) {
  const auto& framework = tree.framework();
  return {framework.grid_point(framework.rank(Point_index(ends[0].value()))),
          framework.grid_point(framework.rank(Point_index(ends[1].value())))};
}

/// Returns the leaves to be split so that each segment passes the tree in columns, in order; none if all do.
/// \param pieces gives for a `Segment_index` the range of the leaves that the segment passes
/// \param segments a random access range of pairs of vertices, which are points of the tree
template <class ConcurrencyTag, class Tree, class Pieces, class Segments>
std::vector<Leaf_index> leaves_to_split_for_columns(const Tree& tree, const Pieces& pieces,
                                                    const Segments& segments,
                                                    const Column_closure_options& options) {
  constexpr std::size_t block = 64;
  const Edges_of_leaves edges(tree.number_of_leaves(), pieces, segments.size());
  std::vector<std::vector<Leaf_index>> of_block((segments.size() + block - 1) / block);
  for_each_block<ConcurrencyTag>(
      segments.size(), block, [&](std::size_t b, std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) {
          const auto line = line_of_segment(tree, segments[s]);
          Column_closure<Tree>(tree, line, edges, s, options)
              .append_leaves_to_split(pieces[Segment_index(s)], of_block[b]);
        }
        std::sort(of_block[b].begin(), of_block[b].end());
        of_block[b].erase(std::unique(of_block[b].begin(), of_block[b].end()), of_block[b].end());
      });
  return in_order<ConcurrencyTag>(of_block, tree.number_of_leaves());
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_CLOSURE_H
