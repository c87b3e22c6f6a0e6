// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where the segments of a graph end without another one, for users whose border does not close.
//
// Vertices at one place count as one, and segments are cut at the vertices on them. An open end is a vertex with a
// single edge. Segments that close no ring are a forest; so they have open ends, unless all have length zero. Rings are
// found by union-find. O(n) for the ends, and almost O(n) for the rings.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_OPEN_ENDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_OPEN_ENDS_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/number_utils.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Whether any edges close a ring.
inline bool has_ring(const Input_edges& edges, std::size_t number_of_vertices) {
  boost::disjoint_sets_with_storage<> parts(number_of_vertices);
  for (std::size_t v = 0; v < number_of_vertices; ++v) parts.make_set(v);
  for (const Edge_id e : edges.ids()) {
    const std::size_t a = parts.find_set(std::size_t(edges[e].a)),
                      b = parts.find_set(std::size_t(edges[e].b));
    if (a == b) return true;
    parts.link(a, b);
  }
  return false;
}

/// The open ends, by their numbers in the input and in this order.
/// \param order the input vertex of each kernel vertex
inline std::vector<Vertex_index> open_ends(const Input_edges& edges, const Order& order) {
  std::vector<std::uint32_t> degree(order.size(), 0);
  for (const Edge_id e : edges.ids()) ++degree[std::size_t(edges[e].a)], ++degree[std::size_t(edges[e].b)];
  std::vector<Vertex_index> ends;
  for (std::size_t v = 0; v < order.size(); ++v)
    if (degree[v] == 1) ends.push_back(Vertex_index(order[v]));
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// The first open end, and the one nearest to it if there is another. The border's gap is there most of the time.
/// \param ends in the order of the input, at least one
template <class Point>
std::vector<Vertex_index> first_gap(const std::vector<Vertex_index>& ends, const std::vector<Point>& places) {
  const auto squared_distance = [&](Vertex_index v) {
    const auto difference = [](const auto& s, const auto& t) {
      if constexpr (std::is_arithmetic_v<std::decay_t<decltype(s)>>)
        return static_cast<double>(s) - static_cast<double>(t);
      else
        return CGAL::to_double(s - t);
    };
    const Point &p = places[std::size_t(ends.front())], &q = places[std::size_t(v)];
    const double x = difference(p.x(), q.x()), y = difference(p.y(), q.y());
    return x * x + y * y;
  };
  const auto nearest = std::min_element(ends.begin() + 1, ends.end(), [&](Vertex_index v, Vertex_index w) {
    return squared_distance(v) < squared_distance(w);
  });
  return nearest == ends.end() ? ends : std::vector<Vertex_index>{ends.front(), *nearest};
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_OPEN_ENDS_H
