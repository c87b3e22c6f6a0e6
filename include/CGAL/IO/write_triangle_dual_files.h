// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_WRITE_TRIANGLE_DUAL_FILES_H
#define CGAL_IO_WRITE_TRIANGLE_DUAL_FILES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/dual/Circumcenters.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/Edge_finder.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <string>

// Writes the files of Triangle that tell what is next to what: .edge, .neigh, and .v.node with .v.edge
// (https://www.cs.cmu.edu/~quake/triangle.html). Takes the time of finding the edges.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
std::string triangle_edge_text(const Indexed_mesh_2<Point>& mesh, std::size_t first_number) {
  const Edge_finder<Sequential_tag, Point> finder(mesh);
  Line_writer out;
  out.reserve(32 * finder.edges().size() + 32);
  (out << finder.edges().size() << 1).end_line();
  std::size_t number = first_number;
  for (const Mesh_edge_2& e : finder.edges()) {
    out << number++;
    for (const Vertex_index v : e.vertices) out << first_number + std::size_t(v);
    (out << e.marker).end_line();
  }
  return out.take();
}

template <class Point>
std::string triangle_neigh_text(const Indexed_mesh_2<Point>& mesh, std::size_t first_number) {
  const Edge_finder<Sequential_tag, Point> finder(mesh);
  Line_writer out;
  out.reserve(32 * mesh.triangles.size() + 32);
  (out << mesh.triangles.size() << 3).end_line();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    out << first_number + t;
    for (const Triangle_index u : finder.neighbors()[t])
      if (u.is_valid())
        out << first_number + std::size_t(u);
      else
        out << -1;
    out.end_line();
  }
  return out.take();
}

template <class Point>
class Triangle_voronoi_writer {
public:
  Triangle_voronoi_writer(const Indexed_mesh_2<Point>& mesh, std::size_t first_number)
      : mesh_(mesh), finder_(mesh), first_number_(first_number) {}

  /// The circumcenters of the triangles, in their order.
  std::string node_text() const {
    Line_writer out;
    out.reserve(48 * mesh_.triangles.size() + 32);
    (out << mesh_.triangles.size() << 2 << 0 << 0).end_line();
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const Dual_place center = circumcenter_of(place(a), place(b), place(c));
      (out << first_number_ + t << center[0] << center[1]).end_line();
    }
    return out.take();
  }

  /// The edges between them, in the order of the edges that they cross; on the border a ray, by its direction.
  std::string edge_text() const {
    Line_writer out;
    out.reserve(32 * finder_.edges().size() + 32);
    (out << finder_.edges().size() << 0).end_line();
    std::size_t number = first_number_;
    for (const Mesh_edge_2& e : finder_.edges()) {
      out << number++ << first_number_ + std::size_t(e.triangles[0]);
      if (e.is_on_border()) {
        const Dual_place a = place(e.vertices[0]), b = place(e.vertices[1]);
        out << -1 << b[1] - a[1] << a[0] - b[0];
      } else
        out << first_number_ + std::size_t(e.triangles[1]);
      out.end_line();
    }
    return out.take();
  }

private:
  const Indexed_mesh_2<Point>& mesh_;
  const Edge_finder<Sequential_tag, Point> finder_;
  std::size_t first_number_;

  Dual_place place(Vertex_index v) const {
    return {as_double(mesh_.point(v).x()), as_double(mesh_.point(v).y())};
  }
};

/// Adds `stem.v.node` and `stem.v.edge` to the files about to be replaced.
template <class Point>
void add_triangle_voronoi_files(Replaced_files& files, const Indexed_mesh_2<Point>& mesh,
                                const std::string& stem, std::size_t first_number) {
  const Triangle_voronoi_writer<Point> writer(mesh, first_number);
  files.add(stem + ".v.node", writer.node_text());
  files.add(stem + ".v.edge", writer.edge_text());
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes the edges of a mesh to an `.edge` file, as Triangle's `-e` does: each once, in the order of
/// `edges_of_mesh_2()`, with its marker.
/// \param first_number of vertices, triangles and edges: 0 or 1, the same as for the other files of the mesh; this
/// holds for all functions here.
/// \throws std::system_error that names the file if it cannot be written. An older file of that name is then
/// unchanged. This holds for all functions here.
template <class Point>
void write_triangle_edge(const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                         std::size_t first_number = 0) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::replace_file(file_name, internal::triangle_edge_text(mesh, first_number));
}

/// Writes the neighbors of triangles to a `.neigh` file, as Triangle's `-n` does: the first is opposite the first
/// vertex, and -1 stands for the border.
template <class Point>
void write_triangle_neigh(const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                          std::size_t first_number = 0) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::replace_file(file_name, internal::triangle_neigh_text(mesh, first_number));
}

/// Writes `stem.v.node` and `stem.v.edge`, as Triangle's `-v` does: the circumcenters of the triangles, and an edge of
/// the Voronoi diagram for each edge of the mesh, in the order of these. On the border it is a ray: the second end is
/// -1, and the direction follows.
///
/// As with Triangle, this is the Voronoi diagram of the vertices only if the mesh is their Delaunay triangulation;
/// `dual_of_mesh_2()` knows what borders are.
template <class Point>
void write_triangle_voronoi(const Indexed_mesh_2<Point>& mesh, const std::string& stem,
                            std::size_t first_number = 0) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::Replaced_files files;
  internal::add_triangle_voronoi_files(files, mesh, stem, first_number);
  files.commit();
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_TRIANGLE_DUAL_FILES_H
