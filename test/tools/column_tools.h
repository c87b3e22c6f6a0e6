// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_COLUMN_TOOLS_H
#define QUADTREE_MESH_2_TEST_COLUMN_TOOLS_H

// Edges through random balanced quadtrees.

#include "catch.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_closure.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace column_test {

using namespace CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Vertex_index;

using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint32_t>;
using Tree = CGAL::Balanced_quadtree<Traits>;
using Point = Traits::Point_2;
using Grid_point = Traits::Grid_point;
using Line = Edge_line<std::uint32_t>;
using Columns = std::vector<Edge_column<std::uint32_t>>;
using Segments = std::vector<std::array<Vertex_index, 2>>;
using Pieces = std::map<Segment_index, std::vector<Leaf_index>>;

/// The largest leaves have a side of 2^26, the smallest an eighth of that.
constexpr int coarse_level = 5, fine_level = 8;
constexpr std::uint32_t unit = 1u << (Traits::depth - fine_level);
/// The side of the root, in units.
constexpr int extent = 1 << fine_level;

struct Random {
  std::mt19937_64 generator;
  double operator()() { return std::uniform_real_distribution<double>(0, 1)(generator); }
  int below(int n) { return static_cast<int>(generator() % static_cast<std::uint64_t>(n)); }
};

struct Case {
  std::vector<Point> points;
  Segments segments;
};

/// Leaves are split at random, more where squares are small already, and where `must_split_too(low, side)` says
/// so.
template <class Must_split>
Tree random_tree(Random& random, const std::vector<Point>& points, const Must_split& must_split_too) {
  const double r = random(), share = 0.01 + 0.25 * r * r;
  const std::uint64_t seed = random.generator();
  const auto chance = [=](const Point& p, std::uint32_t side) {
    return Random{std::mt19937_64(seed ^ (std::uint64_t(p.x()) << 32 | p.y()) ^ side)}();
  };
  const auto must_split = [=](const Point& low, const Point& high) {
    const std::uint32_t side = high.x() - low.x();
    const std::uint32_t coarse = 1u << (Traits::depth - coarse_level);
    return side > coarse || must_split_too(low, side) ||
           (side > unit && chance(low, side) < (side == coarse ? share : 0.45));
  };
  // Points do not count.
  CGAL::Quadtree_options options;
  options.max_points_per_leaf(points.size() + 1);
  return Tree(points, options, must_split);
}

/// By comparing with all leaves: a leaf is passed if the segment has a point in it, its upper sides excluded.
inline std::vector<Leaf_index> leaves_of(const Tree& tree, const Line& line) {
  std::vector<Leaf_index> leaves;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    const auto square = tree.square(Leaf_index(i));
    const std::int64_t side = std::int64_t(1) << (Traits::depth - square.level);
    const std::int64_t u = line.u({square.x, square.y}), v = line.v({square.x, square.y});
    const std::int64_t left = std::max(u, line.first_u()), right = std::min(u + side - 1, line.last_u());
    if (left > right) continue;
    if (std::max(line.ceiling_of_v(left), line.ceiling_of_v(right)) < v) continue;
    if (std::min(line.floor_of_v(left), line.floor_of_v(right)) < v + side) leaves.push_back(Leaf_index(i));
  }
  return leaves;
}

inline Pieces pieces_of(const Tree& tree, const Segments& segments) {
  Pieces pieces;
  for (std::size_t s = 0; s < segments.size(); ++s)
    pieces[Segment_index(s)] = leaves_of(tree, line_of_segment(tree, segments[s]));
  return pieces;
}

/// What `leaves_to_split_for_columns()` wants of pieces.
struct Pieces_view {
  const Pieces& pieces;
  const std::vector<Leaf_index>& operator[](Segment_index s) const { return pieces.at(s); }
};

template <class ConcurrencyTag>
std::vector<Leaf_index> to_split(const Tree& tree, const Segments& segments,
                                 const Column_closure_options& options) {
  const Pieces pieces = pieces_of(tree, segments);
  return leaves_to_split_for_columns<ConcurrencyTag>(tree, Pieces_view{pieces}, segments, options);
}

/// Splits until vertices are amid equal leaves, if they shall be, and edges in columns. Returns the number of
/// rounds.
inline int close(Tree& tree, const Segments& segments, const std::vector<Vertex_index>& vertices = {},
                 const Column_closure_options& options = {}) {
  for (int round = 0;; ++round) {
    REQUIRE(round < 100);
    std::vector<Leaf_index> leaves = leaves_to_split_for_vertices<CGAL::Sequential_tag>(tree, vertices);
    REQUIRE(leaves == leaves_to_split_for_vertices<CGAL::Parallel_tag>(tree, vertices));
    const std::vector<Leaf_index> more = to_split<CGAL::Sequential_tag>(tree, segments, options);
    REQUIRE(more == to_split<CGAL::Parallel_tag>(tree, segments, options));
    leaves.insert(leaves.end(), more.begin(), more.end());
    if (leaves.empty()) return round;
    tree.refine(leaves);
  }
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

inline std::set<std::pair<std::uint32_t, std::uint32_t>> corners_of_leaves(const Tree& tree) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> corners;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i)
    for (const Point& p : tree.corners(Leaf_index(i))) corners.insert({p.x(), p.y()});
  return corners;
}

/// Of triangles with centers at least so many units inside the root, in degrees.
inline double least_angle(const Cdt& cdt, double margin) {
  double least = 180;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    const auto center = CGAL::centroid(cdt.triangle(f));
    if (std::min({center.x(), center.y(), extent - center.x(), extent - center.y()}) < margin) continue;
    for (int i = 0; i < 3; ++i) {
      const auto u = f->vertex((i + 1) % 3)->point() - f->vertex(i)->point(),
                 v = f->vertex((i + 2) % 3)->point() - f->vertex(i)->point();
      least = std::min(least, std::acos(u * v / std::sqrt(u.squared_length() * v.squared_length())));
    }
  }
  return least * 180 / CGAL_PI;
}

} // namespace column_test

#endif // QUADTREE_MESH_2_TEST_COLUMN_TOOLS_H
