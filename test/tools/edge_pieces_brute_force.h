// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The pieces of segments in leaves by rational arithmetic: every leaf against every segment.

#ifndef QUADTREE_MESH_2_TEST_EDGE_PIECES_BRUTE_FORCE_H
#define QUADTREE_MESH_2_TEST_EDGE_PIECES_BRUTE_FORCE_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Edge_pieces.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edge_pieces_test {

using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Point_index;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::internal::Edge_pieces;
using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

/// A point of the grid.
using Place = std::array<Integer, 2>;
using Segment_places = std::array<Place, 2>;

template <class Tree, class Segment>
Segment_places places(const Tree& tree, const Segment& ends) {
  Segment_places result;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto p = tree.framework().grid_point(tree.framework().rank(Point_index(ends[i].value())));
    result[i] = {{Integer(p.x), Integer(p.y)}};
  }
  return result;
}

/// Numbers between two bounds, of which each belongs to them or not.
struct Parameters {
  Rational low = 0, high = 1;
  bool is_low_open = false, is_high_open = false;

  void bound_below(const Rational& t, bool is_open) {
    if (t > low || (t == low && is_open)) low = t, is_low_open = is_open;
  }
  void bound_above(const Rational& t, bool is_open) {
    if (t < high || (t == high && is_open)) high = t, is_high_open = is_open;
  }
  bool is_empty() const { return low > high || (low == high && (is_low_open || is_high_open)); }
  /// \pre disjoint and not empty
  bool precedes(const Parameters& other) const {
    return low < other.low || (low == other.low && !is_low_open && other.is_low_open);
  }
};

/// The parameters, from 0 to 1, of a segment's points in a half-open square.
inline Parameters parameters_inside(const Segment_places& s, const Place& corner, const Integer& side) {
  Parameters result;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Integer d = s[1][axis] - s[0][axis], low = corner[axis] - s[0][axis], high = low + side;
    if (d == 0) {
      if (low > 0 || high <= 0) result.bound_above(0, true);
    } else if (d > 0) {
      result.bound_below(Rational(low, d), false);
      result.bound_above(Rational(high, d), true);
    } else {
      result.bound_above(Rational(-low, -d), false);
      result.bound_below(Rational(-high, -d), true);
    }
  }
  return result;
}

template <class Tree, class Segments>
Edge_pieces pieces_by_brute_force(const Tree& tree, const Segments& segments) {
  struct Piece {
    Parameters parameters;
    Leaf_index leaf;
  };
  std::vector<std::uint32_t> begin(1);
  std::vector<Leaf_index> leaves;
  for (const auto& ends : segments) {
    const Segment_places segment = places(tree, ends);
    std::vector<Piece> pieces;
    for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) {
      const auto square = tree.square(Leaf_index(l));
      const Place corner{{Integer(square.x), Integer(square.y)}};
      const Integer side = Integer(1) << (tree.framework().grid().depth() - square.level);
      const Parameters t = parameters_inside(segment, corner, side);
      if (!t.is_empty()) pieces.push_back({t, Leaf_index(l)});
    }
    std::sort(pieces.begin(), pieces.end(),
              [](const Piece& a, const Piece& b) { return a.parameters.precedes(b.parameters); });
    for (const Piece& p : pieces) leaves.push_back(p.leaf);
    begin.push_back(static_cast<std::uint32_t>(leaves.size()));
  }
  return Edge_pieces(begin, leaves);
}

} // namespace edge_pieces_test

#endif // QUADTREE_MESH_2_TEST_EDGE_PIECES_BRUTE_FORCE_H
