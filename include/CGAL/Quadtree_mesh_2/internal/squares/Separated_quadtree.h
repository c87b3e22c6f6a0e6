// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A balanced quadtree that separates points so well that a corner of each point's leaf can move to the point.
//
// Computes: the tree, from points in the middle half of the root. Consider the corner of a point's leaf that
//           is nearest to the point. The four leaves around it are the point's group. They have equal sizes,
//           no vertices in the middle of their sides, and are in the group of no other point.
// Bound:    O(n + k) work for k squares, in O(1) rounds. Each round makes a tree.
// Source:   Bern, Eppstein, Teng, section 5: points are annotated with the size of their leaf, in proportion
//           to the distance of a near neighbor. The tree is built again with these annotations.
// Deviates: annotations ask only for what is needed in any case. Where a group is not yet what it has to be,
//           leaves are split one level at a time. This makes a quarter of the squares that annotations alone
//           would need.
//
// Method. A round splits the larger leaves among the four around the corner of a point. It splits the leaf of
// the point itself if one of the four is split already, has a smaller leaf on one of its outer sides, or is
// in another point's group.
//
// Proof that rounds end. All distances are by the larger difference of coordinates, unless said otherwise.
// Let d be the distance of p to the nearest other point, and l the side of the leaf of p. We show that this
// leaf is split in a round only if 4 l > d.
//
// Each leaf is there because of one point q. Its square's parent was split for one of these reasons:
//   - It held q and another point.
//   - It held q and was too large for it.
//   - It held a leaf of the group of q in some round.
//   - It was out of balance: it touched a leaf less than half as large, which is there because of q.
// Let e be the side of the leaf of q now. Leaves of side s that are there because of q lie within R(s) of q.
// Squares of side s in a group, and their siblings, lie within 3 s. Squares of side 2 s that were split for
// balance touched a leaf of side s / 2, so their children lie within R(s / 2) + 2 s. So R(s) <= 4 s - e for s
// >= e, and there are no such leaves for s < e.
//
// The group of p lies within 3/2 l of it. Suppose that a leaf of side l / 2 or less is in the group or
// touches it. It is not there because of p, but because of a point q within 2 l of the leaf. So p and q are
// less than 4 l apart. If a leaf is in the groups of both p and q, these are at most 3 l apart.
//
// So leaves of points end up with sides above d / 8. For the Euclidean distance D of a near neighbor that is
// above D / 18.5, and they begin with sides of at most 2 D. A leaf larger than l around the corner is split
// once. By balance it then has side l. Hence the number of rounds is O(1).
//
// The beginning asks for no more than is needed: whatever is done, p is at least l / 2 inside its group, so d
// >= l / 2.
//
// Groups are inside the root, because leaves of points have at most an eighth of its side.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SEPARATED_QUADTREE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SEPARATED_QUADTREE_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/near_neighbors.h>
#include <CGAL/Quadtree_options.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A point is so near to another one that there are no squares between them.
class Separation_error : public std::invalid_argument {
public:
  explicit Separation_error(Point_index point)
      : std::invalid_argument("point " + std::to_string(point.value()) +
                              " is too near another one: there are no squares between them on the grid"),
        point_(point) {}
  Point_index point() const { return point_; }

private:
  Point_index point_;
};

/// The corner of a point's leaf nearest to it: whether it is a right one, and an upper one.
struct Nearest_corner {
  bool is_right, is_upper;

  int step_x() const { return is_right ? 1 : -1; }
  int step_y() const { return is_upper ? 1 : -1; }
  /// The directions from the leaf to the three others around the corner.
  std::array<Direction, 3> directions() const {
    return {direction(step_x(), 0), direction(step_x(), step_y()), direction(0, step_y())};
  }
};

template <class ConcurrencyTag>
class Separated_quadtree {
public:
  using Traits = Fixed_point_quadtree_traits_2<std::uint64_t>;
  using Point = Traits::Point_2;
  using Tree = Balanced_quadtree<Traits, ConcurrencyTag>;

  /// \pre points are in the middle half of the root: coordinates are in [2^60, 3 2^60)
  /// \throws Separation_error if distinct points are so near each other, less than 4 units of the grid, that no
  ///         squares fit between them.
  static Tree of(const std::vector<Point>& points) {
    CGAL_precondition(std::all_of(points.begin(), points.end(), is_in_middle_half));
    const Tree first(points);
    auto framework = first.framework();
    framework.annotate(greatest_sizes(first));
    Tree tree(std::move(framework));
    for (;;) {
      const std::vector<Leaf_index> wrong = leaves_to_split(tree);
      if (wrong.empty()) return tree;
      tree.refine(wrong);
    }
  }

  static Nearest_corner nearest_corner(const Tree& tree, Point_rank r) {
    const auto square = tree.square(tree.leaf(r));
    const auto p = tree.framework().grid_point(r);
    const std::uint64_t side = std::uint64_t(1) << (Traits::depth - square.level);
    return {2 * (p.x - square.x) >= side, 2 * (p.y - square.y) >= side};
  }

private:
  /// Leaves of points are no larger than this share of the root: 2^-3.
  static constexpr int least_level = 3;

  /// A few leaves.
  struct Leaves {
    std::array<Leaf_index, 3> leaf{};
    std::size_t size = 0;

    void add(Leaf_index l) { leaf[size++] = l; }
  };

  static bool is_in_middle_half(const Point& p) {
    constexpr std::uint64_t quarter = std::uint64_t(1) << (Traits::depth - 2);
    return p.x() - quarter < 2 * quarter && p.y() - quarter < 2 * quarter;
  }

  /// The level of the largest leaf that a point can have, by rank.
  static std::vector<int> greatest_sizes(const Tree& tree) {
    const auto& framework = tree.framework();
    std::vector<int> result(framework.number_of_points(), least_level);
    if (result.size() < 2) return result;
    const auto near = tree.near_neighbors();
    for_each_index<ConcurrencyTag>(result.size(), [&](std::size_t i) {
      const double squared = static_cast<double>(
          squared_distance(framework.grid_point(Point_rank(i)), framework.grid_point(near[i])));
      result[i] = std::max(least_level, Traits::depth - std::ilogb(2 * std::sqrt(squared)));
    });
    return result;
  }

  /// By shuffle order of points; there may be repetitions.
  static std::vector<Leaf_index> leaves_to_split(const Tree& tree) {
    std::vector<Leaf_index> result;
    count_allocate_and_place<ConcurrencyTag>(
        tree.framework().number_of_points(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t i = begin; i < end; ++i) sum += leaves_to_split(tree, Point_rank(i)).size;
          return sum;
        },
        [&](std::size_t sum) { result.resize(sum); },
        [&](std::size_t begin, std::size_t end, std::size_t place) {
          for (std::size_t i = begin; i < end; ++i) {
            const Leaves leaves = leaves_to_split(tree, Point_rank(i));
            for (std::size_t k = 0; k < leaves.size; ++k) result[place++] = leaves.leaf[k];
          }
        },
        default_block / 8);
    return result;
  }

  /// Those that keep the group of a point from being what it has to be.
  static Leaves leaves_to_split(const Tree& tree, Point_rank r) {
    const Node_index own = tree.node(tree.leaf(r));
    const Nearest_corner corner = nearest_corner(tree, r);
    Leaves larger, itself;
    itself.add(tree.leaf(r));
    std::array<Node_index, 4> group{own};
    for (std::size_t i = 0; i < 3; ++i) {
      const Node_index v = group[i + 1] = tree.neighbor(own, corner.directions()[i]);
      if (!tree.is_leaf(v)) return splittable(tree, itself, r);
      if (tree.level(v) < tree.level(own)) larger.add(tree.leaf(v));
    }
    if (larger.size > 0) return larger;
    if (are_sides_whole(tree, group, corner) && !is_shared(tree, group, r)) return {};
    return splittable(tree, itself, r);
  }

  static const Leaves& splittable(const Tree& tree, const Leaves& leaves, Point_rank r) {
    if (tree.level(leaves.leaf[0]) < Traits::depth) return leaves;
    throw Separation_error(tree.framework().input_point(r));
  }

  /// \param group the point's own leaf and those beside, across and above or below
  static bool are_sides_whole(const Tree& tree, const std::array<Node_index, 4>& group,
                              Nearest_corner corner) {
    const Direction out_x = direction(corner.step_x(), 0), out_y = direction(0, corner.step_y());
    const std::array<std::array<Direction, 2>, 4> outer{{{opposite(out_x), opposite(out_y)},
                                                         {out_x, opposite(out_y)},
                                                         {out_x, out_y},
                                                         {opposite(out_x), out_y}}};
    for (std::size_t i = 0; i < 4; ++i)
      for (const Direction d : outer[i]) {
        const Node_index v = tree.neighbor(group[i], d);
        if (v.is_valid() && !tree.is_leaf(v)) return false;
      }
    return true;
  }

  /// Whether one of the leaves is in the group of another point, too.
  static bool is_shared(const Tree& tree, const std::array<Node_index, 4>& group, Point_rank r) {
    for (const Node_index v : group) {
      if (is_in_group_of_point_in(tree, v, v, r)) return true;
      for (const Direction d : all_directions())
        if (is_in_group_of_point_in(tree, v, tree.neighbor(v, d), r)) return true;
    }
    return false;
  }

  /// Whether v is in the group of a point, not that of rank r, in u.
  static bool is_in_group_of_point_in(const Tree& tree, Node_index v, Node_index u, Point_rank r) {
    if (!u.is_valid() || !tree.is_leaf(u) || tree.level(u) != tree.level(v)) return false;
    const Rank_interval inside = tree.points(u);
    if (inside.size() == 0 || inside.begin == r) return false;
    if (u == v) return true;
    for (const Direction d : nearest_corner(tree, inside.begin).directions())
      if (tree.neighbor(u, d) == v) return true;
    return false;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SEPARATED_QUADTREE_H
