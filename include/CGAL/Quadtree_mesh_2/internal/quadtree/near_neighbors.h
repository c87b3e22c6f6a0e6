// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Near neighbors of the points of a balanced quadtree.
//
// Computes: for each point another one, at most sqrt(7 + sqrt(13)) / 2 < 1.6284 times as far away as its
//           nearest neighbor. The factor is sharp for this method.
// Bound:    at most 456 squares for each point, whatever the depth, if squares are split only for balance or
//           because they hold more points than a leaf may (about 16 for random points). If annotations of
//           points or a size ask for smaller leaves, at most 168 squares for each level from the point's leaf
//           up to the squares as large as the nearest neighbor is far. The factor is the same.
// Source:   Bern, Eppstein, Teng, section 5: examine the O(1) squares around the square of a point.
// Deviates: the paper takes any point in a neighboring square, and none if all are empty. Here the points in
//           quarters of these squares are told apart, and up to two levels above are looked at. So there
//           always is a result.
//
// Method. Let s be the leaf of p. The squares around p, up to the root, are s = A(0), A(1), ..., with sides
// a(0), a(1), .... Window j is the square of side 3 a(j) around A(j). Round j looks at the squares of the
// size of A(j) around it, up to eight, by the cross pointers. It also looks at their children and
// grandchildren. Of those that are leaves, or lie in larger leaves, it looks at all points. Of each square of
// side a(j) / 4 that is split, it looks at the first point. Rounds are made for j = 0, 1, .... They end when
// |pr|^2 <= 5/2 a(j)^2, where r is the nearest point seen so far, or with the child of the root. If s may
// hold several points, the other points in s are looked at first.
//
// Proof of the factor c. Let q be the nearest neighbor of p, and d = |pq|. Points outside window j are
// farther from p than a(j). If rounds end after round j with q outside window j, then |pr| <= sqrt(5/2) a(j)
// < sqrt(5/2) d. (After the last possible round nothing is outside.) Otherwise let i be the least number of a
// window that has q. So i <= j. If q was looked at, r is as near. If not, q is in a split square u of side b
// = a(i) / 4, of which another point r' was looked at. The parent of u is a square w of side 2 b. Along one
// of the axes p is at least 2 b from w, and so from u:
//  - For i > 0, w is not in window i - 1. That window consists of squares of the size of w. It reaches as far
//    as the side of w, a(i - 1) = 2 b, around A(i - 1).
//  - For i = 0, w would otherwise touch s and have half its size. As w is split, a leaf with at most a
//    quarter of the side of s would touch s. The tree would not be balanced across sides and corners.
// Let h >= 2 b and v <= h be the distances from p to u along the axes. The quotient of the distances is
// greatest if q is in the corner of u nearest to p and r' in the farthest one:
//
//     |pr'|^2 / d^2 <= ((h + b)^2 + (v + b)^2) / (h^2 + v^2)
//
// While v <= h, this decreases in h, because its derivative has the sign of -(h^2 + 2 h b + 2 h v - v^2). If
// v > 2 b, it is therefore at most its value for h = v, (1 + b / v)^2 < 9/4. If v <= 2 b, it is at most its
// value for h = 2 b. In units of b, this is 1 + (6 + 2 v) / (4 + v^2). It is greatest for v = sqrt(13) - 3,
// where it is (7 + sqrt(13)) / 4 = c^2.
//
// The factor is reached in round 1. There s = [0, 1)^2 is in A(1) = [0, 2)^2, and u = [-3/2, -1) x [0, 1/2)
// has r' in its lower left corner and q next to its upper right one. The point p is (0, 1/2 + (sqrt(13) - 3)
// / 2).
//
// Proof of the bound. If the parent A(1) is split because it holds more points than a leaf may, one of them
// is in a sibling of s. Round 0 finds one. If A(1) is split for balance, by either schedule, the cause is a
// square of its own size next to it that is split for its points (forcing.h). Round 1 finds one of these.
// What is found in round i is nearer than sqrt(8) a(i) = sqrt(2) a(i + 1), so round i + 1 is the last one.
// Hence there are at most three rounds. Round 0 looks at 8 squares, 32 children, and 80 grandchildren,
// because 12 children touch s and are not split. Each of the others looks at 8 + 32 + 128.
//
// Grid points. The traits may map points to the grid squares that contain them. All of the above holds for
// the points as well as for their grid points, except for comparisons. These are made on grid points,
// exactly. The distances of points differ from those by less than sqrt(2) units. So for points the result is
// nearer than c d + sqrt(2) (1 + c) < c d + 3.72, in units of the grid. For integers, nothing is added.
// Nothing is added either for doubles that are multiples of the unit. All doubles are whose magnitude is at
// least 2^-10 times the root's side.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_NEAR_NEIGHBORS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_NEAR_NEIGHBORS_H

#include <CGAL/Quadtree_framework.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Wide_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_options.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A near neighbor is at most this many times as far as the nearest one: half the square root of 7 +
/// sqrt(13), rounded up.
constexpr double near_neighbor_factor = 1.62830829;

/// Squared distances of grid points, exactly. With the grid's 2^62 units to a side they are below 2^125, and
/// below 2^63 with 2^31 units.
template <class Word>
struct Squared_distance {
  using type = Word; // of unlimited length
};
template <>
struct Squared_distance<std::uint32_t> {
  using type = std::uint64_t;
};
template <>
struct Squared_distance<std::uint64_t> {
  using type = Wide_integer;
};

template <class Word>
typename Squared_distance<Word>::type squared_distance(const Grid_point_2<Word>& p,
                                                       const Grid_point_2<Word>& q) {
  using Square = typename Squared_distance<Word>::type;
  // Words have no sign.
  const Square x = static_cast<Word>(p.x < q.x ? q.x - p.x : p.x - q.x);
  const Square y = static_cast<Word>(p.y < q.y ? q.y - p.y : p.y - q.y);
  return static_cast<Square>(x * x + y * y);
}

/// The search for a near neighbor of one point; see the head of this file.
template <class Quadtree>
class Near_neighbor_search {
public:
  Near_neighbor_search(const Quadtree& tree, Point_rank r)
      : tree_(tree), rank_(r), point_(tree.framework().grid_point(r)) {}

  Point_rank find() {
    Node_index v = tree_.node(tree_.leaf(rank_));
    look_at_points(v);
    for (; v != tree_.root(); v = tree_.parent(v)) {
      for (Direction d : all_directions()) {
        const Node_index n = tree_.neighbor(v, d);
        if (n.is_valid()) look_at(n, 2);
      }
      if (is_near_enough(v)) break;
    }
    return nearest_;
  }

  /// How many squares were looked at.
  std::size_t number_of_squares() const { return number_of_squares_; }

private:
  using Word = typename Quadtree::Word;
  using Square = typename Squared_distance<Word>::type;

  /// Looks at the points of leaves and the first point of squares that are split `splits` levels down.
  void look_at(Node_index v, int splits) {
    ++number_of_squares_;
    if (tree_.is_leaf(v)) return look_at_points(v);
    if (splits > 0) {
      for (int q = 0; q < 4; ++q) look_at(tree_.child(v, q), splits - 1);
      return;
    }
    const Rank_interval inside = tree_.points(v);
    if (inside.size() > 0) look_at(inside.begin);
  }

  void look_at_points(Node_index leaf) {
    const Rank_interval inside = tree_.points(leaf);
    for (Point_rank r = inside.begin; r < inside.end; ++r) look_at(r);
  }

  /// Of points equally near the first one counts, in whatever order they are seen.
  void look_at(Point_rank r) {
    if (r == rank_) return;
    const Square distance = squared_distance(point_, tree_.framework().grid_point(r));
    if (nearest_.is_valid() && (distance > distance_ || (distance == distance_ && !(r < nearest_)))) return;
    nearest_ = r;
    distance_ = distance;
  }

  /// Whether no point outside the window around `v`, which is not the root, can be too much nearer.
  bool is_near_enough(Node_index v) const {
    if (!nearest_.is_valid()) return false;
    const Square side = static_cast<Square>(Square(1) << (tree_.framework().grid().depth() - tree_.level(v)));
    return 2 * distance_ <= 5 * side * side; // the side is at most half the root's: no overflow
  }

  const Quadtree& tree_;
  Point_rank rank_;
  Grid_point_2<Word> point_;
  Point_rank nearest_;
  Square distance_ = 0;
  std::size_t number_of_squares_ = 0;
};

/// Returns a point that is at most `near_neighbor_factor` times as far from the point of rank `r` as the
/// nearest one, up to the rounding of points to the grid; invalid if there is only one point.
/// \pre the tree is balanced across sides and corners
template <class Quadtree>
Point_rank near_neighbor(const Quadtree& tree, Point_rank r) {
  CGAL_precondition(tree.options().balance() == Balance::SIDES_AND_CORNERS);
  return Near_neighbor_search<Quadtree>(tree, r).find();
}

/// Returns a near neighbor of each point, by rank.
/// \pre the tree is balanced across sides and corners
template <class ConcurrencyTag, class Quadtree>
std::vector<Point_rank> near_neighbors(const Quadtree& tree) {
  std::vector<Point_rank> result(tree.framework().number_of_points());
  for_each_index<ConcurrencyTag>(
      result.size(), [&](std::size_t i) { result[i] = near_neighbor(tree, Point_rank(i)); },
      default_block / 8);
  return result;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_NEAR_NEIGHBORS_H
