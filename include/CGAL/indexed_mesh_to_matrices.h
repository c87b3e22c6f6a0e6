// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_INDEXED_MESH_TO_MATRICES_H
#define CGAL_INDEXED_MESH_TO_MATRICES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

// Converts graphs and meshes to and from matrices of Eigen, as in libigl: a row for each vertex, edge or
// triangle.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Matrix>
void resize_matrix(Eigen::PlainObjectBase<Matrix>& matrix, std::size_t rows, std::size_t columns) {
  static_assert(Matrix::RowsAtCompileTime == Eigen::Dynamic, "the number of rows is known at run time only");
  matrix.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
}

/// A row of indices.
template <class Matrix, class Indices>
void set_index_row(Eigen::PlainObjectBase<Matrix>& matrix, std::size_t row, const Indices& indices) {
  Eigen::Index column = 0;
  for (const Vertex_index v : indices)
    matrix(static_cast<Eigen::Index>(row), column++) = static_cast<typename Matrix::Scalar>(v.value());
}

/// \throws Pslg_error_2 if the matrix has another number of columns
template <class Derived>
void check_columns(const Eigen::DenseBase<Derived>& matrix, Eigen::Index columns, const std::string& name) {
  if (matrix.rows() > 0 && matrix.cols() != columns)
    throw Pslg_error_2(Pslg_error_2::Kind::ARRAY_LENGTH,
                       "the matrix of " + name + " has " + std::to_string(matrix.cols()) +
                           " columns instead of " + std::to_string(columns));
}

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Data
/// Converts a mesh to matrices. `vertices` gets a row `x y` for each point, used or not. `triangles` gets a
/// row of three indices for each triangle, counterclockwise.
/// \tparam Vertex_matrix, Triangle_matrix `Eigen::MatrixXd`, `Eigen::MatrixXi`, or others with any number of
/// rows. The number of columns is free, or 2 (or 3, with z = 0) and 3.
template <class Point, class Vertex_matrix, class Triangle_matrix>
void indexed_mesh_to_matrices(const Indexed_mesh_2<Point>& mesh,
                              Eigen::PlainObjectBase<Vertex_matrix>& vertices,
                              Eigen::PlainObjectBase<Triangle_matrix>& triangles) {
  namespace internal = Quadtree_mesh_2::internal;
  using Scalar = typename Vertex_matrix::Scalar;
  constexpr bool is_in_space = Vertex_matrix::ColsAtCompileTime == 3;
  internal::resize_matrix(vertices, mesh.points.size(), is_in_space ? 3 : 2);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto row = static_cast<Eigen::Index>(v);
    vertices(row, 0) = static_cast<Scalar>(internal::as_double(mesh.points[v].x()));
    vertices(row, 1) = static_cast<Scalar>(internal::as_double(mesh.points[v].y()));
    if constexpr (is_in_space) vertices(row, 2) = 0;
  }
  internal::resize_matrix(triangles, mesh.triangles.size(), 3);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    internal::set_index_row(triangles, t, mesh.triangles[t]);
}

/// \ingroup PkgQuadtreeMesh2Data
/// Converts the constrained edges, too: `edges` gets rows `a b`, and `edge_markers` their markers. `regions`
/// gets the regions of the triangles, -1 for none.
template <class Point, class Vertex_matrix, class Triangle_matrix, class Edge_matrix, class Marker_vector,
          class Region_vector>
void indexed_mesh_to_matrices(const Indexed_mesh_2<Point>& mesh,
                              Eigen::PlainObjectBase<Vertex_matrix>& vertices,
                              Eigen::PlainObjectBase<Triangle_matrix>& triangles,
                              Eigen::PlainObjectBase<Edge_matrix>& edges,
                              Eigen::PlainObjectBase<Marker_vector>& edge_markers,
                              Eigen::PlainObjectBase<Region_vector>& regions) {
  namespace internal = Quadtree_mesh_2::internal;
  indexed_mesh_to_matrices(mesh, vertices, triangles);
  internal::resize_matrix(edges, mesh.constrained_edges.size(), 2);
  internal::resize_matrix(edge_markers, mesh.constrained_edges.size(), 1);
  for (std::size_t e = 0; e < mesh.constrained_edges.size(); ++e) {
    internal::set_index_row(edges, e, mesh.constrained_edges[e].vertices);
    edge_markers(static_cast<Eigen::Index>(e)) =
        static_cast<typename Marker_vector::Scalar>(mesh.constrained_edges[e].marker);
  }
  internal::resize_matrix(regions, mesh.triangles.size(), 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    regions(static_cast<Eigen::Index>(t)) = static_cast<typename Region_vector::Scalar>(
        mesh.region_of_triangle.empty() ? -1 : mesh.region_of_triangle[t]);
}

/// \ingroup PkgQuadtreeMesh2Data
/// Makes a graph from matrices, as for `igl::triangle::triangulate()`: a row `x y` for each vertex, a row of
/// two indices for each segment, and a row `x y` for a point in each hole. Any of them may have no rows.
/// \tparam Point can be made from two doubles
/// \throws Pslg_error_2 if a matrix does not have two columns, or an index is not that of a vertex; `pslg` is
/// then unchanged
template <class Point, class Vertices, class Segments, class Holes>
void matrices_to_pslg(const Eigen::DenseBase<Vertices>& vertices, const Eigen::DenseBase<Segments>& segments,
                      const Eigen::DenseBase<Holes>& holes, Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  using Quadtree_mesh_2::Vertex_index;
  internal::check_columns(vertices, 2, "vertices");
  internal::check_columns(segments, 2, "segments");
  internal::check_columns(holes, 2, "holes");
  const auto place = [](const auto& matrix, Eigen::Index row) {
    return Point(static_cast<double>(matrix.derived()(row, 0)),
                 static_cast<double>(matrix.derived()(row, 1)));
  };
  Pslg_2<Point> result;
  result.vertices.reserve(static_cast<std::size_t>(vertices.rows()));
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) result.vertices.push_back(place(vertices, v));
  const auto index = [&](Eigen::Index row, Eigen::Index column) {
    const auto i = static_cast<std::int64_t>(segments.derived()(row, column));
    if (i < 0 || i >= vertices.rows())
      throw Pslg_error_2(Pslg_error_2::Kind::NO_SUCH_VERTEX,
                         "segment " + std::to_string(row) + ": there is no vertex " + std::to_string(i),
                         Pslg_parts_2().segment(Quadtree_mesh_2::Segment_index(std::size_t(row))));
    return Vertex_index(static_cast<std::size_t>(i));
  };
  result.segments.reserve(static_cast<std::size_t>(segments.rows()));
  for (Eigen::Index s = 0; s < segments.rows(); ++s) result.add_segment(index(s, 0), index(s, 1));
  for (Eigen::Index h = 0; h < holes.rows(); ++h) result.holes.push_back(place(holes, h));
  pslg = std::move(result);
}

/// \ingroup PkgQuadtreeMesh2Data
/// Makes a graph without holes.
template <class Point, class Vertices, class Segments>
void matrices_to_pslg(const Eigen::DenseBase<Vertices>& vertices, const Eigen::DenseBase<Segments>& segments,
                      Pslg_2<Point>& pslg) {
  matrices_to_pslg(vertices, segments, Eigen::Matrix<double, 0, 2>(), pslg);
}

} // namespace CGAL

#endif // CGAL_INDEXED_MESH_TO_MATRICES_H
