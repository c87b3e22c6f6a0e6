// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_INDEXED_MESH_TO_FACE_GRAPH_H
#define CGAL_INDEXED_MESH_TO_FACE_GRAPH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

// Converts a mesh in flat arrays to a `Surface_mesh` or another model of BGL's concepts.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A point of the graph: the same point, one with two coordinates, or one with z = 0.
template <class Graph_point, class Point>
Graph_point graph_point(const Point& p) {
  if constexpr (std::is_same_v<Graph_point, Point>)
    return p;
  else if constexpr (std::is_constructible_v<Graph_point, double, double, double>)
    return Graph_point(as_double(p.x()), as_double(p.y()), 0.);
  else
    return Graph_point(as_double(p.x()), as_double(p.y()));
}

/// Makes a vertex of the graph for each vertex that a triangle uses. If triangles touch only in that vertex,
/// it makes one for each fan of them.
///
/// Such a vertex is not manifold, and face graphs cannot express it. The first fan in the order of triangles
/// gets the first copy.
class Fan_finder {
public:
  template <class Point>
  explicit Fan_finder(const Indexed_mesh_2<Point>& mesh) : corner_vertex(mesh.triangles.size()) {
    std::vector<std::size_t> first_corner(mesh.points.size() + 1, 0), corners(3 * mesh.triangles.size());
    for (const auto& t : mesh.triangles)
      for (const Vertex_index v : t) ++first_corner[std::size_t(v) + 1];
    for (std::size_t v = 0; v < mesh.points.size(); ++v) first_corner[v + 1] += first_corner[v];
    std::vector<std::size_t> fill(first_corner.begin(), first_corner.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c)
      corners[fill[std::size_t(mesh.triangles[c / 3][c % 3])]++] = c;
    for (auto& t : corner_vertex) t.fill(none);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      number_fans(mesh, Vertex_index(v),
                  {corners.begin() + std::ptrdiff_t(first_corner[v]),
                   corners.begin() + std::ptrdiff_t(first_corner[v + 1])});
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::array<std::size_t, 3>> corner_vertex; ///< per triangle, the copies that are its corners
  std::vector<Vertex_index> vertex_of_copy;

private:
  /// The end of a side at the vertex, and the corner with that side to its right or to its left.
  using Side = std::pair<Vertex_index, std::size_t>;

  /// Gives each fan around `v` a copy of it.
  /// \param corners the corners at `v`, numbered over all triangles
  template <class Point>
  void number_fans(const Indexed_mesh_2<Point>& mesh, Vertex_index v,
                   const std::vector<std::size_t>& corners) {
    std::array<std::vector<Side>, 2> sides;
    const auto end_of_side = [&](std::size_t c, std::size_t k) {
      return mesh.triangles[c / 3][(c % 3 + k + 1) % 3];
    };
    for (std::size_t k = 0; k < 2; ++k) {
      for (const std::size_t c : corners) sides[k].emplace_back(end_of_side(c, k), c);
      std::sort(sides[k].begin(), sides[k].end());
    }
    for (const std::size_t first : corners) {
      if (copy_at(first) != none) continue;
      for (const std::size_t k : {0u, 1u}) // turn one way, then the other
        for (std::size_t c = first; c != none;) {
          copy_at(c) = vertex_of_copy.size();
          const auto next =
              std::lower_bound(sides[k].begin(), sides[k].end(), Side(end_of_side(c, 1 - k), 0));
          const bool has_next = next != sides[k].end() && next->first == end_of_side(c, 1 - k);
          c = has_next && copy_at(next->second) == none ? next->second : none;
        }
      vertex_of_copy.push_back(v);
    }
  }
  std::size_t& copy_at(std::size_t corner) { return corner_vertex[corner / 3][corner % 3]; }
};

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Data
/// Appends the triangles of a mesh, and the points they use, to a face graph.
///
/// Points with three coordinates get z = 0. Faces come in the order of triangles. Triangles of a domain may
/// touch only in a point. Because the graph has to be a manifold, it then gets a vertex for each fan of them.
/// Takes linear time, except for sorting the triangles at each vertex.
/// \tparam Graph a model of `MutableFaceGraph` with an internal point map, usually a `Surface_mesh`
/// \param vertex_output gets a pair for each vertex, in the order of indices: the index in the mesh, and the
/// vertex
/// \param face_output gets a pair for each triangle, in their order: its index, and the face
/// \pre the triangles of `mesh` are counterclockwise and meet as in a mesh; `graph` may have vertices and
/// faces already
template <class Point, class Graph, class Vertex_output, class Face_output>
void indexed_mesh_to_face_graph(const Indexed_mesh_2<Point>& mesh, Graph& graph, Vertex_output vertex_output,
                                Face_output face_output) {
  namespace internal = Quadtree_mesh_2::internal;
  using Traits = boost::graph_traits<Graph>;
  auto points = get(CGAL::vertex_point, graph);
  using Graph_point = typename boost::property_traits<decltype(points)>::value_type;
  const internal::Fan_finder fans(mesh);
  std::vector<typename Traits::vertex_descriptor> vertices;
  vertices.reserve(fans.vertex_of_copy.size());
  for (const Quadtree_mesh_2::Vertex_index v : fans.vertex_of_copy) {
    vertices.push_back(add_vertex(graph));
    put(points, vertices.back(), internal::graph_point<Graph_point>(mesh.point(v)));
    *vertex_output++ = std::make_pair(v, vertices.back());
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = fans.corner_vertex[t];
    const std::array<typename Traits::vertex_descriptor, 3> corners{vertices[a], vertices[b], vertices[c]};
    *face_output++ = std::make_pair(Quadtree_mesh_2::Triangle_index(t), Euler::add_face(corners, graph));
  }
}

/// \ingroup PkgQuadtreeMesh2Data
/// Appends a mesh to a face graph.
template <class Point, class Graph>
void indexed_mesh_to_face_graph(const Indexed_mesh_2<Point>& mesh, Graph& graph) {
  indexed_mesh_to_face_graph(mesh, graph, Emptyset_iterator(), Emptyset_iterator());
}

} // namespace CGAL

#endif // CGAL_INDEXED_MESH_TO_FACE_GRAPH_H
