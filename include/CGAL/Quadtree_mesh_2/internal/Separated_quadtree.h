// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A balanced quadtree in which points are well separated: each is in the middle one of nine equal leaves that touch no
// smaller ones, and no leaf is among the nine of two points.
//
// Computes: the tree, from points in the middle half of the root.
// Bound:    O(n + k) work for k squares.
// Source:   Bern, Eppstein, Teng, section 5: points are annotated with the size of their leaf, in proportion to the
//           distance of a near neighbour, and the tree is built again with that.
// Deviates: the eight leaves around a point's leaf are made as small as that one in a second step.
//
// Let l be the side of the leaf of a point p, and d the largest-coordinate distance to the nearest other point; l is
// at most d / 4. (A near neighbour at Euclidean distance D is at most near_neighbor_factor times as far as the
// nearest, and that at most sqrt(2) d, so l is at most D / 9.2112.)
//
// Proof. Squares are split for the nine leaves of some point q, of side e, because they contain one of the nine, or
// for balance, because a leaf smaller than half of them would touch them. So every leaf is there because of one
// point. Leaves of side s that are there because of q lie within R(s) of q, in the largest-coordinate distance: R(e)
// is at most 3 e, because the nine reach as far as 2 e and siblings come with them; a square of side 2 s that is
// split because it contains one of the nine lies within e + 2 s; and one that is split because it touches a leaf of
// side s / 2, within R(s / 2) + 2 s. Hence R(s) <= 4 s - e. The nine leaves of p lie within 2 l of p. Leaves of side
// l / 2 or less are there because of another point q, and lie within less than 2 l of it; p and q are at least 4 l
// apart; so none touches the nine leaves of p, and these are not split. Two points with leaves of equal size have
// these at least four rows or columns apart, so the nine of each are different; and leaves of different sizes are not
// the same.
//
// The nine leaves of a point in the middle half are in the root if l is at most an eighth of its side.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SEPARATED_QUADTREE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SEPARATED_QUADTREE_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/near_neighbors.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel.h>
#include <CGAL/Quadtree_options.h>
#include <CGAL/assertions.h>

#include <algorithm>
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

template <class Concurrency_tag>
class Separated_quadtree {
public:
  using Traits = Fixed_point_quadtree_traits_2<std::uint64_t>;
  using Point = Traits::Point_2;
  using Tree = Balanced_quadtree<Traits, Concurrency_tag>;

  /// \pre points are in the middle half of the root: coordinates are in [2^60, 3 2^60)
  /// \throws std::invalid_argument if distinct points are nearer than 10 units of the grid.
  static Tree of(const std::vector<Point>& points) {
    CGAL_precondition(std::all_of(points.begin(), points.end(), is_in_middle_half));
    const Tree first(points);
    auto framework = first.framework();
    framework.annotate(levels(first));
    Tree tree(std::move(framework));
    tree.refine(larger_leaves_around_points(tree));
    return tree;
  }

private:
  /// Leaves are no larger than this share of the root: 2^-3.
  static constexpr int least_level = 3;
  /// 4 sqrt(2) near_neighbor_factor, rounded up.
  static constexpr double separation = 9.2112;

  static bool is_in_middle_half(const Point& p) {
    constexpr std::uint64_t quarter = std::uint64_t(1) << (Traits::depth - 2);
    return p.x() - quarter < 2 * quarter && p.y() - quarter < 2 * quarter;
  }

  /// The level of the leaf of each point, by rank.
  static std::vector<int> levels(const Tree& tree) {
    const auto& framework = tree.framework();
    std::vector<int> result(framework.number_of_points(), least_level);
    if (result.size() < 2) return result;
    const auto near = tree.near_neighbors();
    for_each_index<Concurrency_tag>(result.size(), [&](std::size_t i) {
      const Point_rank r(i);
      const double squared =
          static_cast<double>(squared_distance(framework.grid_point(r), framework.grid_point(near[i])));
      const int exponent = std::ilogb(std::sqrt(squared) / separation);
      if (exponent < 0) throw_for_near_points(framework, r, near[i]);
      result[i] = std::max(least_level, Traits::depth - exponent);
    });
    return result;
  }

  template <class Framework>
  [[noreturn]] static void throw_for_near_points(const Framework& framework, Point_rank p, Point_rank q) {
    throw std::invalid_argument("points " + std::to_string(framework.input_point(p).value()) + " and " +
                                std::to_string(framework.input_point(q).value()) +
                                " are too near each other: there are no squares between them on the grid");
  }

  /// In shuffle order of points; balance has seen to it that one split is enough.
  static std::vector<Leaf_index> larger_leaves_around_points(const Tree& tree) {
    const std::size_t n = tree.framework().number_of_points();
    std::vector<Leaf_index> result;
    const auto larger = [&](std::size_t i, Direction d) {
      const Node_index v = tree.node(tree.leaf(Point_rank(i))), w = tree.neighbor(v, d);
      return tree.level(w) < tree.level(v) ? tree.leaf(w) : Leaf_index();
    };
    count_allocate_and_place<Concurrency_tag>(
        n,
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t i = begin; i < end; ++i)
            for (const Direction d : all_directions()) sum += larger(i, d).is_valid() ? 1 : 0;
          return sum;
        },
        [&](std::size_t sum) { result.resize(sum); },
        [&](std::size_t begin, std::size_t end, std::size_t place) {
          for (std::size_t i = begin; i < end; ++i)
            for (const Direction d : all_directions())
              if (const Leaf_index l = larger(i, d); l.is_valid()) result[place++] = l;
        });
    return result;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SEPARATED_QUADTREE_H
