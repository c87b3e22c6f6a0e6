// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The vertices of a mesh made from the leaves of a quadtree, and where they are.
//
// All vertices of the graph are there, unchanged. Vertices on edges are rounded so that they stay in the room
// of their edge (Edge_rooms.h), and left out if there is none. Corners of leaves are left out if coordinates
// have no room for the leaves, or if they are outside of the domain.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_VERTICES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_VERTICES_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Placement_scope.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_rooms.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A vertex on an edge.
template <class Geometry>
struct Edge_crossing {
  Edge_id edge;
  typename Geometry::Point point;
};

/// A point on the edge from a to b, worked out from the nearer end where coordinates may be finer there.
template <class Geometry>
struct Point_on_edge {
  using Point = typename Geometry::Point;

  double share, rest; ///< of the edge: what is before the point, and what is behind it
  Point point;

  /// With the x of a place, or its y if the edge is steep.
  /// \param side of the leaves there
  static Point_on_edge beside(const Point& place, const Point& a, const Point& b, bool is_steep,
                              double side) {
    const Vector d = Geometry::difference(b, a), from_a = Geometry::difference(place, a),
                 to_b = Geometry::difference(b, place);
    const double share = along(from_a, is_steep) / along(d, is_steep),
                 rest = along(to_b, is_steep) / along(d, is_steep);
    const bool is_finer_at_b =
        Geometry::has_unlimited_coordinates || Geometry::spacing(b) < Geometry::spacing(a);
    Point p = share <= 0.5 || !is_finer_at_b ? Geometry::between(a, b, share) : Geometry::between(b, a, rest);
    if constexpr (Geometry::has_unlimited_coordinates) bring_beside(place, a, b, is_steep, side, p);
    return {share, rest, p};
  }

private:
  static double along(Vector v, bool is_steep) { return is_steep ? v.y : v.x; }

  /// Shares are rounded to doubles, and leaves may be finer than that where they are far from both ends: adds shares
  /// of the rest of the way until the point is beside the place as leaves see it.
  static void bring_beside(const Point& place, const Point& a, const Point& b, bool is_steep, double side,
                           Point& p) {
    constexpr double tolerance = 0x1p-20; // in sides
    for (;;) {
      const double way = along(Geometry::difference(place, p), is_steep);
      if (std::fabs(way) <= tolerance * side) return;
      const double to_a = along(Geometry::difference(a, p), is_steep),
                   to_b = along(Geometry::difference(b, p), is_steep);
      const bool is_toward_b = (way > 0) == (to_b > 0);
      p = Geometry::between(p, is_toward_b ? b : a, way / (is_toward_b ? to_b : to_a));
    }
  }
};

template <class Geometry>
struct Placed_vertices {
  /// The vertices on an edge, from its first end to its second.
  struct Run {
    Edge_id edge;
    Vertex_id first;
    std::size_t size;

    Id_range<Vertex_id> vertices() const { return {first.value(), first.value() + size}; }
  };

  Uninitialized_indexed_vector<Vertex_id, typename Geometry::Point>
      points; ///< first the input's, then those on edges, then corners
  Uninitialized_indexed_vector<Vertex_id, Vertex_role> role_of;
  std::vector<Run> runs;                       ///< those on edges, by edge
  Vertex_id first_corner;                      ///< of a leaf
  std::vector<std::size_t> corners;            ///< their names (Tree_corners.h), in order
  std::vector<Triangle_id> triangle_of_corner; ///< that has the corner, for each from the first on
  std::vector<Edge_id> cramped_edges; ///< those without some of their vertices for want of room; in order

  explicit Placed_vertices(const Uninitialized_indexed_vector<Vertex_id, typename Geometry::Point>& input)
      : points(input), role_of(input.size()) {
    for (const Vertex_id v : role_of.ids()) role_of[v] = input_vertex(v);
  }

  /// \param scope the edges that get vertices
  /// \param cut called as `cut(e, crossings)`, maybe for several edges at the same time; appends the vertices on
  ///        edge e, from its first end to its second
  template <class ConcurrencyTag, class Cut>
  void append_vertices_of_edges(const Input_edges& edges, const Placement_scope& scope,
                                const Edge_rooms<Geometry>& rooms, const Cut& cut) {
    constexpr std::size_t block = 256;
    const std::size_t n = scope.number_of_segments(edges.size());
    std::vector<std::vector<Edge_crossing<Geometry>>> found((n + block - 1) / block);
    std::vector<std::vector<Edge_id>> cramped(found.size());
    for_each_block<ConcurrencyTag>(n, block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Edge_id e(scope.segment(i).value());
        if (!rooms.has_rooms(e)) continue;
        const std::size_t first = found[b].size();
        cut(e, found[b]);
        if (!keep_in_room(edges[e], rooms, found[b], first)) cramped[b].push_back(e);
      }
    });
    for (const auto& list : cramped) cramped_edges.insert(cramped_edges.end(), list.begin(), list.end());
    for (const auto& crossings : found)
      for (const auto& c : crossings) append(c);
    first_corner = points.end_id();
  }

  /// Appends the corners of leaves that are kept, by name.
  /// \param location gives the triangle of the domain that has a corner, or none
  template <class ConcurrencyTag, class Trees, class Corners, class Location>
  void append_corners(const Trees& trees, const Corners& corners_of_tree, const std::vector<char>& is_kept,
                      const Location& location) {
    // Other leaves around a corner may be a level further down.
    const auto has_room = [&](std::size_t c) {
      return trees.has_room(trees.tree().level(Corners::leaf_of(c)) + 1,
                            trees.kernel_point(corners_of_tree.place(c)));
    };
    std::vector<Triangle_id> triangle(is_kept.size());
    for_each_index<ConcurrencyTag>(is_kept.size(), [&](std::size_t c) {
      if (is_kept[c] != 0 && has_room(c)) triangle[c] = location(c);
    });
    corners = pack_values<ConcurrencyTag, typename Corners::Name>(
        is_kept.size(), [&](std::size_t c) { return triangle[c].is_valid(); },
        [](std::size_t c) { return c; });
    const std::size_t first = points.size();
    points.resize(first + corners.size());
    role_of.resize(first + corners.size(), free_vertex);
    triangle_of_corner.resize(corners.size());
    for_each_index<ConcurrencyTag>(corners.size(), [&](std::size_t i) {
      points[static_cast<Vertex_id>(first + i)] = trees.kernel_point(corners_of_tree.place(corners[i]));
      triangle_of_corner[i] = triangle[corners[i]];
    });
  }

private:
  /// Keeps the vertices on an edge, from that at place `first` on, in its room.
  /// \returns false if one had to be left out for want of room
  bool keep_in_room(const Input_edge& edge, const Edge_rooms<Geometry>& rooms,
                    std::vector<Edge_crossing<Geometry>>& crossings, std::size_t first) const {
    bool are_all_in_room = true;
    auto kept = crossings.begin() + static_cast<std::ptrdiff_t>(first);
    const typename Geometry::Point* last = &points[edge.a];
    for (auto c = kept; c != crossings.end(); ++c) {
      if (!rooms.is_in_order(c->edge, *last, c->point)) continue;
      const auto place = rooms.place_next_to(c->edge, c->point);
      are_all_in_room = are_all_in_room && place;
      if (!place) continue;
      *kept = {c->edge, *place};
      last = &kept->point;
      ++kept;
    }
    crossings.erase(kept, crossings.end());
    return are_all_in_room;
  }

  void append(const Edge_crossing<Geometry>& c) {
    const Vertex_id v = points.add(c.point);
    role_of.push_back(c.edge);
    if (runs.empty() || runs.back().edge != c.edge) runs.push_back({c.edge, v, 0});
    ++runs.back().size;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_VERTICES_H
