// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// A segment on the grid, as a path from its first end to its second, and where squares begin and end on it.
//
// Computes: the part of a path in a half-open square, as an interval between two cuts, and the order of cuts.
// Bound:    O(1) operations on integers, with products of two coordinates at most. No points are constructed.
// Method:   A cut is where the path crosses a grid line, so the line identifies it. The point on the line
//           belongs to the squares above or to the right of it. A path that ascends in the line's coordinate
//           is cut before this point, one that descends is cut behind it. All squares of a quadtree cut a
//           path into intervals, each with a first and a last cut. An interval may have a single point but is
//           never empty. So sides, corners and axis-parallel segments are no special cases. A coordinate that
//           does not change counts as ascending.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_GRID_PATH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_GRID_PATH_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Leaf_segments.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A place on a path between two of its points, or between a point and nothing.
template <class Coordinate>
struct Path_cut {
  /// Before the point, or behind it.
  enum class Position : std::uint8_t { BEFORE, BEHIND };

  Coordinate offset; ///< of the point from the first end, along `axis`, in the direction of the path
  std::uint8_t axis;
  Position position;
};

/// The points of a path between two cuts.
template <class Coordinate>
struct Path_interval {
  Path_cut<Coordinate> first;
  Path_cut<Coordinate> last;
};

/// A segment from one grid point to another.
template <class Word>
class Grid_path {
public:
  using Coordinate = typename Signed_grid<Word>::Coordinate;
  using Product = typename Signed_grid<Word>::Product;
  using Cut = Path_cut<Coordinate>;
  using Interval = Path_interval<Coordinate>;

  /// Not a path yet.
  Grid_path() = default;
  Grid_path(const Grid_point_2<Word>& a, const Grid_point_2<Word>& b)
      : begin_{{Coordinate(a.x), Coordinate(a.y)}}, extent_{{Coordinate(b.x) - Coordinate(a.x),
                                                             Coordinate(b.y) - Coordinate(a.y)}} {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      is_ascending_[axis] = extent_[axis] >= 0;
      if (!is_ascending_[axis]) extent_[axis] = -extent_[axis];
    }
  }

  /// The coordinate of the first end.
  const Coordinate& begin(std::size_t axis) const { return begin_[axis]; }
  /// How far the ends are apart along an axis.
  const Coordinate& extent(std::size_t axis) const { return extent_[axis]; }
  bool is_ascending(std::size_t axis) const { return is_ascending_[axis]; }
  /// 1 or -1.
  int step(std::size_t axis) const { return is_ascending_[axis] ? 1 : -1; }

  /// The cut at the line on which the coordinate of `axis` is `at`.
  Cut cut(std::size_t axis, const Coordinate& at) const {
    return {is_ascending_[axis] ? Coordinate(at - begin_[axis]) : Coordinate(begin_[axis] - at),
            static_cast<std::uint8_t>(axis),
            is_ascending_[axis] ? Cut::Position::BEFORE : Cut::Position::BEHIND};
  }
  /// The cut where the path leaves a column (`axis` 0) or row of squares.
  Cut exit(std::size_t axis, const Coordinate& low, const Coordinate& side) const {
    return cut(axis, is_ascending_[axis] ? Coordinate(low + side) : low);
  }
  /// The cut where the path enters a column or row of squares.
  Cut entry(std::size_t axis, const Coordinate& low, const Coordinate& side) const {
    return cut(axis, is_ascending_[axis] ? low : Coordinate(low + side));
  }

  /// Returns a number less than, equal to or greater than 0 if `c` is before, at or behind `d`.
  /// \pre not both are lines that are parallel to the path
  int compare(const Cut& c, const Cut& d) const {
    if (c.axis == d.axis) {
      if (c.offset != d.offset) return c.offset < d.offset ? -1 : 1;
    } else {
      const Product of_c = Product(c.offset) * extent_[d.axis], of_d = Product(d.offset) * extent_[c.axis];
      if (of_c != of_d) return of_c < of_d ? -1 : 1;
    }
    return static_cast<int>(c.position) - static_cast<int>(d.position);
  }
  bool is_before(const Cut& c, const Cut& d) const { return compare(c, d) < 0; }

  /// All points.
  Interval whole() const {
    const std::uint8_t axis = extent_[0] < extent_[1] ? 1 : 0; // not one that is parallel to the lines
    return {{Coordinate(0), axis, Cut::Position::BEFORE}, {extent_[axis], axis, Cut::Position::BEHIND}};
  }

  bool is_empty(const Interval& i) const { return !is_before(i.first, i.last); }

  /// The points of `i` before `cut`.
  Interval before(const Interval& i, const Cut& cut) const {
    return {i.first, is_before(cut, i.last) ? cut : i.last};
  }
  /// The points of `i` behind `cut`.
  Interval behind(const Interval& i, const Cut& cut) const {
    return {is_before(i.first, cut) ? cut : i.first, i.last};
  }

  /// What of an interval is in a half-open square.
  Interval inside(Interval i, const Grid_point_2<Word>& corner, const Coordinate& side) const {
    const Interval nothing{i.first, i.first};
    const std::array<Coordinate, 2> low{{Coordinate(corner.x), Coordinate(corner.y)}};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Cut in = entry(axis, low[axis], side), out = exit(axis, low[axis], side);
      // Most squares are far from the path or around it, which is told without products.
      if (in.offset > extent_[axis] || out.offset < 0) return nothing;
      if (extent_[axis] == 0) {
        if (out.offset == 0) return nothing;
        continue;
      }
      if (in.offset >= 0) i = behind(i, in);
      if (out.offset <= extent_[axis]) i = before(i, out);
    }
    return i;
  }

private:
  std::array<Coordinate, 2> begin_, extent_;
  std::array<bool, 2> is_ascending_;
};

/// The path of a segment, given by its two vertices, which are points of a tree.
template <class Tree, class Segment>
Grid_path<typename Tree::Word> path_of_segment(const Tree& tree, const Segment& ends) {
  const auto& framework = tree.framework();
  return {framework.grid_point(framework.rank(Point_index(ends[0].value()))),
          framework.grid_point(framework.rank(Point_index(ends[1].value())))};
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_GRID_PATH_H
