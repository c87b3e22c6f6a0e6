// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether given triangles are a mesh.
//
// Computes: where their border touches itself, or an error that names the first triangles at fault.
// Bound:    O(k log k) time for k triangles.
// Source:   ours. Triangles have to be counterclockwise, and each side may be that of one triangle in each
//           direction. So the number of triangles above a place changes only across border edges, at which overlaps are
//           looked for (Border_sweep.h). All of this is decided exactly.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_GIVEN_MESH_CHECKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_GIVEN_MESH_CHECKER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Border_sweep.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Given_mesh_checker {
public:
  using Point = Triangle_tree::Point;
  using Mesh = Indexed_mesh_2<Point>;

  /// \param first_number what messages count from
  Given_mesh_checker(const Mesh& mesh, std::size_t first_number) : mesh_(mesh), first_number_(first_number) {}

  /// \throws Pslg_error_2 naming the triangles or the vertex at fault
  void check() const {
    if (mesh_.triangles.empty()) throw Pslg_error_2(Kind::INVALID_MESH, "the mesh has no triangles");
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (!std::isfinite(mesh_.points[v].x()) || !std::isfinite(mesh_.points[v].y()))
        throw Pslg_error_2(Kind::NOT_FINITE,
                           "vertex " + number(v) +
                               " of the mesh has a coordinate that is not a finite number",
                           Pslg_parts_2().vertex(Vertex_index(v)));
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) check_triangle(t);
    check_sides();
  }

  /// \pre `check()` passed
  /// \param neighbors of each triangle
  /// \throws Pslg_error_2 naming two triangles that overlap
  Border_touches touches(const Triangle_tree& tree,
                         const std::vector<std::array<Triangle_index, 3>>& neighbors) const {
    std::vector<Border_side> sides;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (!neighbors[t][k].is_valid())
          sides.push_back({t, k, mesh_.triangles[t][(k + 1) % 3], mesh_.triangles[t][(k + 2) % 3]});
    const Border_sweep sweep(mesh_.points, std::move(sides));
    if (sweep.overlap()) name_overlap(tree, *sweep.overlap());
    return sweep.touches();
  }

  /// For a mesh that has to be one of its graph.
  /// \throws Pslg_error_2 naming what touches
  void refuse(const Border_touches& touches) const {
    if (!touches.twins.empty()) {
      const auto& [vertex, kept] = touches.twins.front();
      throw Pslg_error_2(Kind::INVALID_MESH,
                         "vertices " + number(std::size_t(kept)) + " and " + number(std::size_t(vertex)) +
                             " of the mesh are at one place",
                         Pslg_parts_2().vertex(kept).vertex(vertex));
    }
    if (!touches.hanging.empty()) {
      const auto& [side, vertex] = touches.hanging.front();
      throw Pslg_error_2(Kind::INVALID_MESH,
                         text(side.triangle) + " has vertex " + number(std::size_t(vertex)) +
                             " in the middle of a side",
                         Pslg_parts_2().triangle(Triangle_index(side.triangle)).vertex(vertex));
    }
  }

  /// What messages call a triangle.
  std::string text(std::size_t t) const {
    const auto& v = mesh_.triangles[t];
    return "triangle " + number(t) + " (" + number(std::size_t(v[0])) + ' ' + number(std::size_t(v[1])) +
           ' ' + number(std::size_t(v[2])) + ')';
  }

private:
  using Kind = Pslg_error_2::Kind;

  const Mesh& mesh_;
  std::size_t first_number_;

  std::string number(std::size_t i) const { return std::to_string(first_number_ + i); }

  /// "triangle 3 (0 1 2)"
  [[noreturn]] void fail(std::size_t t, const std::string& what) const {
    throw Pslg_error_2(Kind::INVALID_MESH, text(t) + what, Pslg_parts_2().triangle(Triangle_index(t)));
  }

  Triangle_tree::Corners corners(std::size_t t) const {
    const auto& v = mesh_.triangles[t];
    return {mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2])};
  }

  void check_triangle(std::size_t t) const {
    for (const Vertex_index v : mesh_.triangles[t])
      if (std::size_t(v) >= mesh_.points.size())
        fail(t, " names vertex " + number(std::size_t(v)) + ", but there are " +
                    std::to_string(mesh_.points.size()) + " vertices");
    const auto p = corners(t);
    const Orientation turn = Triangle_tree::Kernel().orientation_2_object()(p[0], p[1], p[2]);
    if (turn == RIGHT_TURN) fail(t, " is clockwise");
    if (turn == COLLINEAR) fail(t, " has its vertices on a line");
  }

  /// No side is that of two triangles in one direction.
  void check_sides() const {
    std::vector<std::tuple<Vertex_index, Vertex_index, std::size_t>> sides; // from, to, triangle
    sides.reserve(3 * mesh_.triangles.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        sides.emplace_back(mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3], t);
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const auto& [from, to, second] = sides[i];
      const auto& [other_from, other_to, first] = sides[i - 1];
      if (from == other_from && to == other_to)
        throw Pslg_error_2(Kind::INVALID_MESH,
                           text(first) + " and " + text(second) +
                               " are on the same side of the edge from vertex " + number(std::size_t(from)) +
                               " to vertex " + number(std::size_t(to)),
                           Pslg_parts_2().triangle(Triangle_index(first)).triangle(Triangle_index(second)));
    }
  }

  /// \pre the triangle of the side overlaps another one at the side
  [[noreturn]] void name_overlap(const Triangle_tree& tree, const Border_side& side) const {
    const Triangle_tree::Corners own = corners(side.triangle);
    const Point &a = mesh_.point(side.from), &b = mesh_.point(side.to);
    std::size_t first = mesh_.triangles.size();
    tree.for_each_meeting(Triangle_tree::box_of({a, b, b}), [&](const auto& other, Triangle_index n) {
      if (std::size_t(n) != side.triangle && !are_apart(own, other) && !are_apart(other, own))
        first = std::min(first, std::size_t(n));
    });
    CGAL_assertion(first < mesh_.triangles.size());
    const auto [t, u] = std::minmax(first, side.triangle);
    throw Pslg_error_2(Kind::INVALID_MESH, text(t) + " and " + text(u) + " overlap",
                       Pslg_parts_2().triangle(Triangle_index(t)).triangle(Triangle_index(u)));
  }

  /// Whether a side of `a` has all of `b` on its right, or on it.
  static bool are_apart(const Triangle_tree::Corners& a, const Triangle_tree::Corners& b) {
    const auto turn = Triangle_tree::Kernel().orientation_2_object();
    for (std::size_t k = 0; k < 3; ++k)
      if (std::all_of(b.begin(), b.end(),
                      [&](const auto& p) { return turn(a[k], a[(k + 1) % 3], p) != LEFT_TURN; }))
        return true;
    return false;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_GIVEN_MESH_CHECKER_H
