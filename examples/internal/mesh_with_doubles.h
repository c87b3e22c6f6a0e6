#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_WITH_DOUBLES_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_WITH_DOUBLES_H

// A mesh made with other coordinates, brought back to doubles.

#include <CGAL/Indexed_mesh_2.h>

#include <cstddef>
#include <utility>
#include <vector>

/// The same mesh over doubles; the vertices of the input get the doubles they came with, the others `to_double(p)`.
template <class Point, class Other_point, class To_double>
CGAL::Indexed_mesh_2<Point> mesh_with_doubles(CGAL::Indexed_mesh_2<Other_point>&& other,
                                              const std::vector<Point>& input, const To_double& to_double) {
  CGAL::Indexed_mesh_2<Point> mesh;
  mesh.number_of_input_vertices = other.number_of_input_vertices;
  mesh.points = input;
  mesh.points.reserve(other.points.size());
  for (std::size_t v = mesh.points.size(); v < other.points.size(); ++v)
    mesh.points.push_back(to_double(other.points[v]));
  mesh.triangles = std::move(other.triangles);
  mesh.neighbors = std::move(other.neighbors);
  mesh.constrained_edges.reserve(other.constrained_edges.size());
  for (const auto& e : other.constrained_edges)
    mesh.constrained_edges.push_back({e.vertices, e.segment, e.marker});
  mesh.region_of_triangle = std::move(other.region_of_triangle);
  mesh.segment_of_vertex = std::move(other.segment_of_vertex);
  mesh.vertex_markers = std::move(other.vertex_markers);
  return mesh;
}

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_WITH_DOUBLES_H
