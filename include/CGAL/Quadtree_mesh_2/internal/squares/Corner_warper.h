// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Triangulations of points by warped quadtree squares, the classical way.
//
// Computes: a triangulation of the root square that has the given points, which lie in its middle half, as
//           vertices. All angles are between 22.47 and 112.63 degrees.
// Bound:    O(n + k) work for k triangles, not counting sorting. For any constant bound on the least angle, k
//           is within a constant factor of the least number of triangles.
// Source:   Bern, Eppstein, Gilbert, "Provably good mesh generation", 1994. Bern, Eppstein, Teng, section 5,
//           first paragraph, about the warping steps: "no angles smaller than about 20 degrees".
// Deviates: points are separated so well (Separated_quadtree.h) that warped squares have no vertices in the
//           middle of their sides. One comparison tells which diagonal a warped square gets.
//
// Method. The nearest corner of each point's leaf moves to the point. Four squares share this corner. They
// have equal sizes and whole sides, and none of their other corners moves. Let their side be 1, let the
// corner be the origin, and let the point's own square be the upper right one. The corner moves to (x, y), 0
// <= x, y <= 1/2. A diagonal cuts each square into two triangles:
//   - In the point's own square, it starts at the moved corner.
//   - In the opposite square, at the lower left, it does not.
//   - In the upper left square, it does if x <= 5/24. In the lower right one, it does if y <= 5/24.
// All other squares are cut by the templates of square_templates.h. Their angles are between atan(1/2) and 90
// degrees.
//
// The least angle is atan(12/29) > 22.47 degrees. It is at (-1, 1) for (x, y) = (5/24, 1/2). The largest
// angle, at (0, 1) for the same (x, y), is 90 degrees plus atan(5/12), which is less than 112.63. Proof: the
// angles of all triangles with a vertex at (x, y) are within these bounds if certain quadratics in x and y
// are not negative. The test of this header shows that with their Bernstein coefficients, in rational
// arithmetic, for the whole square of (x, y). So the bounds hold for the integer places of the mesh as they
// are, not just up to rounding. A point that is no such place is less than a unit from its own in each
// coordinate. The bounds have room for that where squares have 2^16 units or more to a side. Smaller squares'
// triangles at the point may miss them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_CORNER_WARPER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_CORNER_WARPER_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Separated_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>
#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A triangulation of the root of a quadtree.
struct Warped_mesh {
  Indexed_vector<Vertex_index, Grid_point_2<std::uint64_t>>
      places;                                         ///< of vertices; those of points are the points
  std::vector<std::array<Vertex_index, 3>> triangles; ///< counterclockwise
  std::vector<Vertex_index> vertex_of_point;          ///< by the points' order in the input
};

/// The bounds, in degrees.
constexpr double least_warped_angle = 22.47, largest_warped_angle = 112.63;

/// How a square without vertices on its sides is cut.
enum class Diagonal : std::uint8_t { FROM_LOWER_LEFT, FROM_LOWER_RIGHT };

/// Of the two squares beside a point's own, that share a side with it and the corner that is moved: whether it is cut
/// from that corner. `way` is how far the corner moves away from the square, across the side shared.
constexpr bool is_joined_beside(std::uint64_t way, std::uint64_t side) { return 24 * way <= 5 * side; }

template <class ConcurrencyTag>
class Corner_warper {
public:
  using Separated = Separated_quadtree<ConcurrencyTag>;
  using Point = typename Separated::Point;

  /// \pre as for `Separated_quadtree::of()`
  /// \throws std::invalid_argument as that does.
  /// \throws std::length_error if there are too many vertices for 32-bit indices.
  static Warped_mesh run(const std::vector<Point>& points) {
    Corner_warper warper(Separated::of(points));
    warper.number_vertices();
    warper.move_corners(points.size());
    warper.make_triangles();
    return std::move(warper.mesh_);
  }

private:
  using Tree = typename Separated::Tree;
  using Place = Grid_point_2<std::uint64_t>;

  Tree tree_;
  Warped_mesh mesh_;
  Indexed_vector<Leaf_index, std::array<Vertex_index, 4>>
      corners_; // counterclockwise from the lower left one
  Indexed_vector<Leaf_index, Diagonal> diagonal_;

  explicit Corner_warper(Tree tree) : tree_(std::move(tree)) {}

  static Place place_of_corner(const typename Tree::Square& s, int corner) {
    const std::uint64_t side = std::uint64_t(1) << (Separated::Traits::depth - s.level);
    return {s.x + (corner == 1 || corner == 2 ? side : 0), s.y + (corner >= 2 ? side : 0)};
  }

  /// Vertices are the places of corners of leaves, in shuffle order.
  void number_vertices() {
    const std::size_t leaves = tree_.number_of_leaves();
    if (leaves >= std::size_t(1) << 30) throw std::length_error("Corner_warper: too many squares");
    Uninitialized_vector<Place> places(4 * leaves);
    for_each_index<ConcurrencyTag>(leaves, [&](std::size_t i) {
      const auto square = tree_.square(Leaf_index(i));
      for (int c = 0; c < 4; ++c) places[4 * i + static_cast<unsigned>(c)] = place_of_corner(square, c);
    });
    const Sorted_keys<Place> sorted =
        shuffled<ConcurrencyTag>(places.size(), [&places](std::size_t i) { return places[i]; });
    const Order& order = sorted.order;
    const auto is_new = [&](std::size_t k) { return k == 0 || sorted.keys[k] != sorted.keys[k - 1]; };
    corners_.resize(leaves);
    count_allocate_and_place<ConcurrencyTag>(
        order.size(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t k = begin; k < end; ++k) sum += is_new(k) ? 1 : 0;
          return sum;
        },
        [&](std::size_t sum) { mesh_.places.resize(sum); },
        [&](std::size_t begin, std::size_t end, std::size_t next) {
          for (std::size_t k = begin; k < end; ++k) {
            if (is_new(k)) mesh_.places[Vertex_index(next++)] = sorted.keys[k];
            corners_[Leaf_index(order[k] / 4)][order[k] % 4] = Vertex_index(next - 1);
          }
        });
  }

  void move_corners(std::size_t number_of_input_points) {
    const auto& framework = tree_.framework();
    diagonal_.assign(tree_.number_of_leaves(), Diagonal::FROM_LOWER_LEFT);
    Indexed_vector<Point_rank, Vertex_index> vertex(framework.number_of_points());
    for_each_index<ConcurrencyTag>(
        vertex.size(), [&](std::size_t i) { vertex[Point_rank(i)] = move_corner(Point_rank(i)); });
    mesh_.vertex_of_point.resize(number_of_input_points);
    for_each_index<ConcurrencyTag>(number_of_input_points, [&](std::size_t i) {
      mesh_.vertex_of_point[i] = vertex[framework.rank(Point_index(i))];
    });
  }

  /// The squares that share a corner are those of one point, so points do not meet here.
  Vertex_index move_corner(Point_rank r) {
    const Leaf_index own = tree_.leaf(r);
    const Place p = tree_.framework().grid_point(r);
    const auto square = tree_.square(own);
    const std::uint64_t side = std::uint64_t(1) << (Separated::Traits::depth - square.level);
    const Nearest_corner nearest = Separated::nearest_corner(tree_, r);
    const std::uint64_t x = nearest.is_right ? side - (p.x - square.x) : p.x - square.x;
    const std::uint64_t y = nearest.is_upper ? side - (p.y - square.y) : p.y - square.y;
    const int corner = nearest.is_right ? (nearest.is_upper ? 2 : 1) : (nearest.is_upper ? 3 : 0);
    const auto [beside, across, above] = nearest.directions();

    // In the point's own square, the diagonal from the corner has the direction of the one from the lower
    // left if the corner is there or opposite. Squares on both sides of a line have corners of different
    // kinds at its ends.
    const bool is_even = corner % 2 == 0;
    set_diagonal(own, is_even);
    set_diagonal(neighbor(own, across), !is_even);
    set_diagonal(neighbor(own, beside), is_even != is_joined_beside(x, side));
    set_diagonal(neighbor(own, above), is_even != is_joined_beside(y, side));

    const Vertex_index v = corners_[own][std::size_t(corner)];
    mesh_.places[v] = p;
    return v;
  }

  Leaf_index neighbor(Leaf_index l, Direction d) const {
    return tree_.leaf(tree_.neighbor(tree_.node(l), d));
  }
  void set_diagonal(Leaf_index l, bool is_from_lower_left) {
    diagonal_[l] = is_from_lower_left ? Diagonal::FROM_LOWER_LEFT : Diagonal::FROM_LOWER_RIGHT;
  }

  /// The vertex in the middle of a side; invalid if the side is whole. Balance makes the children leaves.
  Vertex_index middle(Node_index v, int side) const {
    static constexpr Direction across[] = {Direction::SOUTH, Direction::EAST, Direction::NORTH,
                                           Direction::WEST};
    static constexpr int child[] = {1, 0, 0, 2}, corner[] = {2, 3, 1, 2};
    const Node_index n = tree_.neighbor(v, across[side]);
    if (!n.is_valid() || tree_.is_leaf(n)) return Vertex_index();
    return corners_[tree_.leaf(tree_.child(n, child[side]))][std::size_t(corner[side])];
  }

  /// Calls `on_triangle(a, b, c)`, counterclockwise.
  template <class On_triangle>
  void triangulate(Leaf_index l, const On_triangle& on_triangle) const {
    std::array<Vertex_index, 8> vertex;
    Square_form form;
    const Node_index v = tree_.node(l);
    for (int i = 0; i < 4; ++i) {
      vertex[std::size_t(i)] = corners_[l][std::size_t(i)];
      vertex[std::size_t(4 + i)] = middle(v, i);
      if (vertex[std::size_t(4 + i)].is_valid()) form.bits = static_cast<std::uint8_t>(form.bits | 1u << i);
    }
    if (diagonal_[l] == Diagonal::FROM_LOWER_RIGHT) {
      CGAL_assertion(form.bits == 0);
      on_triangle(vertex[0], vertex[1], vertex[3]);
      on_triangle(vertex[1], vertex[2], vertex[3]);
      return;
    }
    const Square_template& t = square_template(form);
    for (int i = 0; i < t.size; ++i) {
      const auto& [a, b, c] = t.triangle[std::size_t(i)];
      on_triangle(vertex[std::size_t(a)], vertex[std::size_t(b)], vertex[std::size_t(c)]);
    }
  }

  void make_triangles() {
    count_allocate_and_place<ConcurrencyTag>(
        tree_.number_of_leaves(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t i = begin; i < end; ++i)
            triangulate(Leaf_index(i), [&](Vertex_index, Vertex_index, Vertex_index) { ++sum; });
          return sum;
        },
        [&](std::size_t sum) { mesh_.triangles.resize(sum); },
        [&](std::size_t begin, std::size_t end, std::size_t next) {
          for (std::size_t i = begin; i < end; ++i)
            triangulate(Leaf_index(i), [&](Vertex_index a, Vertex_index b, Vertex_index c) {
              mesh_.triangles[next++] = {a, b, c};
            });
        },
        default_block / 8);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_CORNER_WARPER_H
