// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Triangles whose border touches itself, made to meet at whole sides.
//
// Computes: the triangles over the first of the vertices at each place, cut where a vertex is in the middle of a side.
//           A piece of each keeps the number of the triangle, the others come last. What was the border is remembered,
//           as it may be within the domain now.
// Bound:    O((b + t) log(b + t)) time for b sides on the border and t vertices in the middle of sides, and linear
//           time in the size of the mesh.
// Source:   ours. A triangle is cut from the middle one of the vertices on a side to the corner opposite. So no piece
//           is flat, and a side with many vertices is halved again and again.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_CONFORMING_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_CONFORMING_TRIANGLES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Border_sweep.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/edge_key.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Conforming_triangles {
public:
  using Point = Triangle_tree::Point;
  using Mesh = Indexed_mesh_2<Point>;
  using Corners = std::array<Vertex_index, 3>;

  /// \param neighbors of each triangle, before
  /// \pre no triangles overlap
  Conforming_triangles(const Mesh& mesh, const std::vector<std::array<Triangle_index, 3>>& neighbors,
                       const Border_touches& touches)
      : points_(mesh.points), triangles_(mesh.triangles) {
    for (const auto& twin : touches.twins) kept_.emplace(twin.vertex, twin.kept);
    for (const auto& [side, vertex] : touches.hanging)
      inner_vertices_[edge_key(side.from, side.to)].push_back(vertex);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (!neighbors[t][k].is_valid())
          add_border(way_along(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      origin_.push_back(Triangle_index(t));
      for (Vertex_index& v : triangles_[t]) v = kept(v);
    }
    for (const std::size_t t : triangles_to_cut(touches)) cut(t, mesh.triangles[t]);
  }

  /// The triangles.
  const std::vector<Corners>& triangles() const { return triangles_; }
  /// Per triangle, the one before that it is a piece of.
  const std::vector<Triangle_index>& origin() const { return origin_; }
  /// Whether an edge now is part of the border as it was before.
  bool was_border(Vertex_index a, Vertex_index b) const { return border_.count(edge_key(a, b)) > 0; }

  /// The vertices now along a side before: its ends, and those in its middle.
  std::vector<Vertex_index> way_along(Vertex_index from, Vertex_index to) const {
    const auto found = inner_vertices_.find(edge_key(from, to));
    if (found == inner_vertices_.end()) return {kept(from), kept(to)};
    std::vector<Vertex_index> way{kept(from)};
    way.insert(way.end(), found->second.begin(), found->second.end());
    way.push_back(kept(to));
    // The line that finds them goes from left to right.
    const Point &p = point(way.front()), &q = point(way.back());
    if (q.x() < p.x() || (q.x() == p.x() && q.y() < p.y())) std::reverse(way.begin() + 1, way.end() - 1);
    return way;
  }

private:
  using Way = std::vector<Vertex_index>;

  const std::vector<Point>& points_;
  std::vector<Corners> triangles_;
  std::vector<Triangle_index> origin_;
  std::unordered_map<Vertex_index, Vertex_index> kept_; // of those at one place
  std::unordered_map<std::uint64_t, std::vector<Vertex_index>>
      inner_vertices_;                       // of sides, by their keys before
  std::unordered_set<std::uint64_t> border_; // edges, by their keys now

  const Point& point(Vertex_index v) const { return points_[std::size_t(v)]; }
  Vertex_index kept(Vertex_index v) const {
    const auto found = kept_.find(v);
    return found == kept_.end() ? v : found->second;
  }

  void add_border(const Way& way) {
    for (std::size_t i = 0; i + 1 < way.size(); ++i) border_.insert(edge_key(way[i], way[i + 1]));
  }

  static std::vector<std::size_t> triangles_to_cut(const Border_touches& touches) {
    std::vector<std::size_t> triangles;
    for (const auto& hanging : touches.hanging) triangles.push_back(hanging.side.triangle);
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
  }

  /// The pieces of a triangle before.
  void cut(std::size_t t, const Corners& before) {
    std::vector<std::array<Way, 3>> left; // what is left to cut, by its sides from each corner to the next
    left.push_back(
        {way_along(before[0], before[1]), way_along(before[1], before[2]), way_along(before[2], before[0])});
    bool is_first = true;
    while (!left.empty()) {
      const std::array<Way, 3> sides = std::move(left.back());
      left.pop_back();
      const auto longest = std::max_element(sides.begin(), sides.end(),
                                            [](const Way& a, const Way& b) { return a.size() < b.size(); });
      if (longest->size() > 2) {
        halve(sides, std::size_t(longest - sides.begin()), left);
        continue;
      }
      const Corners piece{sides[0][0], sides[1][0], sides[2][0]};
      if (is_first)
        triangles_[t] = piece;
      else
        triangles_.push_back(piece), origin_.push_back(Triangle_index(t));
      is_first = false;
    }
  }

  /// Cuts from the middle of side k to the corner opposite.
  static void halve(const std::array<Way, 3>& sides, std::size_t k, std::vector<std::array<Way, 3>>& halves) {
    const Way &side = sides[k], &next = sides[(k + 1) % 3], &last = sides[(k + 2) % 3];
    const auto middle = side.begin() + std::ptrdiff_t(side.size() / 2);
    halves.push_back({Way(middle, side.end()), next, Way{last.front(), *middle}});
    halves.push_back({Way(side.begin(), middle + 1), Way{*middle, last.front()}, last});
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_CONFORMING_TRIANGLES_H
