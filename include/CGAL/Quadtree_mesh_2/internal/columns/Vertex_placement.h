// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The corners of leaves near a vertex that are not vertices of the mesh, and the leaves that have to be split
// first.
//
// Computes: the corners that are dropped because of a vertex, sector by sector (Vertex_window.h); and where leaves
//           are not equal in the 7 x 7 squares around the leaf of a vertex.
// Bound:    O(1) for each sector; O(depth) for each vertex to look at leaves. All vertices at the same time.
// Source:   ours; see Vertex_window.h. Corners are dropped within 1.8 sides of the vertex, and near edges on the
//           grid lines that are not far from it. So leaves that lose a corner have their neighbors in the 7 x 7
//           squares, or in the band of an edge.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_VERTEX_PLACEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_VERTEX_PLACEMENT_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_window.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/leaves_in_order.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A vertex amid equal leaves.
template <class Word>
class Vertex_placement {
public:
  using Grid_point = Grid_point_2<Word>;

  /// \param side of the leaves
  Vertex_placement(const Grid_point& vertex, const Word& side) : vertex_(vertex), side_(side) {
    corner_ = {static_cast<Word>(vertex.x - vertex.x % side), static_cast<Word>(vertex.y - vertex.y % side)};
    place_ = {in_sides(static_cast<Word>(vertex.x - corner_.x)),
              in_sides(static_cast<Word>(vertex.y - corner_.y))};
  }

  /// The lower left corner of the vertex's leaf, and the side of that.
  const Grid_point& corner() const { return corner_; }
  const Word& side() const { return side_; }

  /// The points on an edge with this direction; distances in sides.
  Edge_start start_of_edge(const Window_point& direction, const Edge_axis& axis) const {
    return edge_start(place_, direction, axis);
  }

  /// Calls `f(point)` for corners on an edge or at the vertex, or so near that all thresholds drop them: no sector
  /// has the former.
  template <class F>
  void for_each_corner_on_edge(const Window_point& direction, const F& f) const {
    constexpr double near_edge = 0.1, near_vertex = 0.5;
    const Edge_axis axis = Edge_axis::of(direction);
    for_each_corner([&](const Window_point& p, const Grid_point& corner) {
      const double x = p.x - place_.x, y = p.y - place_.y;
      const bool is_near_edge = !axis.is_far(p) && x * direction.x + y * direction.y > 0 &&
                                std::abs(direction.x * y - direction.y * x) < near_edge;
      if (is_near_edge || std::hypot(x, y) < near_vertex) f(corner);
    });
  }

  /// Calls `f(point)` for corners that are dropped in a sector. Those on lines that are far along an edge are left to
  /// the rule for columns.
  /// \param first, second directions of length 1, the second one counterclockwise next
  template <class F>
  void for_each_dropped_corner(const Window_point& first, const Window_point& second, const F& f) const {
    Vertex_window window(place_, first, second);
    const Sector_thresholds t = sector_thresholds[window.best_of(sector_thresholds)];
    for_each_corner([&](const Window_point& p, const Grid_point& corner) {
      if (window.is_in_sector(p) && !window.is_kept_near(p, t)) f(corner);
    });
  }

  /// Calls `f(point)` for corners that are dropped at a vertex without edges.
  template <class F>
  void for_each_corner_at_lone_vertex(const F& f) const {
    constexpr double clear_of_vertex = 1.187;
    for_each_corner([&](const Window_point& p, const Grid_point& corner) {
      if (std::hypot(p.x - place_.x, p.y - place_.y) < clear_of_vertex) f(corner);
    });
  }

private:
  /// Corners further away are too far from edges, or on lines that are far along them.
  static constexpr int reach_ = 5;

  double in_sides(const Word& w) const { return static_cast<double>(w) / static_cast<double>(side_); }

  /// Calls `f(place, point)`, with the place in sides, for corners of the leaves around that of the vertex.
  template <class F>
  void for_each_corner(const F& f) const {
    for (int i = -reach_; i <= reach_ + 1; ++i)
      for (int j = -reach_; j <= reach_ + 1; ++j)
        if (has(corner_.x, i) && has(corner_.y, j))
          f(Window_point{double(i), double(j)}, Grid_point{at(corner_.x, i), at(corner_.y, j)});
  }
  Word at(const Word& w, int sides) const {
    return sides < 0 ? static_cast<Word>(w - static_cast<Word>(-sides) * side_)
                     : static_cast<Word>(w + static_cast<Word>(sides) * side_);
  }
  /// Whether there are words for a coordinate.
  bool has(const Word& w, int sides) const { return sides < 0 ? at(w, sides) < w : at(w, sides) >= w; }

  Grid_point vertex_, corner_;
  Word side_;
  Window_point place_; ///< relative to the corner of its leaf, in sides
};

/// Returns the leaves to be split so that all vertices are amid 7 x 7 equal leaves, in order. Squares outside the
/// root do not count.
/// \param vertices a random access range of `Vertex_index`, which are points of the tree
template <class ConcurrencyTag, class Tree, class Vertices>
std::vector<Leaf_index> leaves_to_split_for_vertices(const Tree& tree, const Vertices& vertices) {
  using Word = typename Tree::Word;
  constexpr int reach = 3;
  constexpr std::size_t block = 64;
  const int depth = tree.framework().grid().depth();
  std::vector<std::vector<Leaf_index>> of_block((vertices.size() + block - 1) / block);
  for_each_block<ConcurrencyTag>(
      vertices.size(), block, [&](std::size_t b, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const Leaf_index leaf = tree.leaf(Point_index(vertices[k].value()));
          const auto square = tree.square(leaf);
          const Word side = Word_operations<Word>::power_of_two(depth - square.level);
          const Word count = Word_operations<Word>::power_of_two(square.level);
          const Word column = square.x / side, row = square.y / side;
          const auto first = [&](const Word& w) { return w < Word(reach) ? Word(0) : Word(w - reach); };
          for (Word i = first(column); i <= column + reach && i < count; ++i)
            for (Word j = first(row); j <= row + reach && j < count; ++j) {
              const Leaf_index other = tree.locate(Grid_point_2<Word>{Word(i * side), Word(j * side)});
              if (tree.level(other) < square.level) of_block[b].push_back(other);
              if (tree.level(other) > square.level) of_block[b].push_back(leaf);
            }
        }
      });
  return in_order<ConcurrencyTag>(of_block, tree.number_of_leaves());
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_VERTEX_PLACEMENT_H
