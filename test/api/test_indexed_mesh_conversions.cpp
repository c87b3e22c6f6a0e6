// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "mesh_from_cdt.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/indexed_mesh_to_face_graph.h>

#include <CGAL/boost/graph/helpers.h>

#if __has_include(<Eigen/Core>)
#include <CGAL/indexed_mesh_to_matrices.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace test_indexed_mesh_conversions {

using namespace test_meshes;

namespace {

/// A square with a hole that touches its border in a vertex, and a triangle that touches it from outside, in another.
Pslg pinched() {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 2));
  add_polygon(pslg, {Point(-2, -2), Point(1, -1), Point(-1, 1)});
  add_polygon(pslg, {Point(2, 2), Point(4, 3), Point(3, 4)});
  pslg.holes.push_back(Point(-0.5, -0.5));
  return pslg;
}

/// That a graph has the triangles of a mesh, in order, with their places.
template <class Graph>
void check_graph(const Mesh& mesh, const Graph& graph) {
  REQUIRE(CGAL::is_triangle_mesh(graph));
  REQUIRE(num_faces(graph) == mesh.triangles.size());
  std::size_t t = 0;
  for (const auto f : faces(graph)) {
    std::vector<std::pair<double, double>> found, expected;
    for (const auto v : vertices_around_face(halfedge(f, graph), graph)) {
      const auto& p = get(CGAL::vertex_point, graph, v);
      found.emplace_back(p.x(), p.y());
    }
    for (const Vertex_index v : mesh.triangles[t])
      expected.emplace_back(mesh.point(v).x(), mesh.point(v).y());
    std::rotate(found.begin(), std::find(found.begin(), found.end(), expected[0]), found.end());
    CHECK(found == expected);
    ++t;
  }
}

} // namespace

TEST_CASE("a mesh becomes a Surface_mesh", "[face graph]") {
  const Pslg pslg = pinched();
  for (const Mesh& mesh : {mesh_of(pslg), mesh_of(pslg, 0.3), Mesh()}) {
    CGAL::Surface_mesh<Kernel::Point_3> surface;
    std::vector<std::pair<Vertex_index, CGAL::SM_Vertex_index>> vertices;
    std::vector<std::pair<Triangle_index, CGAL::SM_Face_index>> faces;
    CGAL::indexed_mesh_to_face_graph(mesh, surface, std::back_inserter(vertices), std::back_inserter(faces));
    check_graph(mesh, surface);
    CHECK(surface.is_valid(true));
    REQUIRE(faces.size() == mesh.triangles.size());
    for (std::size_t t = 0; t < faces.size(); ++t) {
      CHECK(faces[t].first == Triangle_index(t));
      CHECK(faces[t].second == CGAL::SM_Face_index(static_cast<unsigned>(t)));
    }
    CHECK(vertices.size() == surface.number_of_vertices());
    std::vector<int> copies(mesh.points.size(), 0);
    for (const auto& [v, copy] : vertices) {
      CHECK(surface.point(copy) == Kernel::Point_3(mesh.point(v).x(), mesh.point(v).y(), 0));
      ++copies[std::size_t(v)];
    }
    std::size_t doubles = 0;
    for (const int c : copies) doubles += c == 2;
    CHECK(doubles == (mesh.triangles.empty() ? 0 : 2)); // where the hole and the triangle touch the square
    if (mesh.triangles.empty()) continue;

    CGAL::Surface_mesh<Point> flat; // in the plane, behind what is there
    CGAL::indexed_mesh_to_face_graph(mesh, flat);
    check_graph(mesh, flat);
    CGAL::indexed_mesh_to_face_graph(mesh, flat);
    CHECK(flat.number_of_faces() == 2 * mesh.triangles.size());
  }
}

#if __has_include(<Eigen/Core>)
TEST_CASE("meshes and graphs go into and out of matrices", "[Eigen]") {
  Pslg pslg = pinched();
  Mesh mesh = mesh_of(pslg, 0.3);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.region_of_triangle.push_back(int(t % 3) - 1);
  for (auto& e : mesh.constrained_edges) e.marker = int(std::size_t(e.segment));
  Eigen::MatrixXd v;
  Eigen::MatrixXi f, e;
  Eigen::VectorXi markers, regions;
  CGAL::indexed_mesh_to_matrices(mesh, v, f, e, markers, regions);
  REQUIRE(v.rows() == Eigen::Index(mesh.points.size()));
  REQUIRE(v.cols() == 2);
  REQUIRE(f.rows() == Eigen::Index(mesh.triangles.size()));
  REQUIRE(f.cols() == 3);
  for (Eigen::Index i = 0; i < v.rows(); ++i) CHECK(Point(v(i, 0), v(i, 1)) == mesh.points[std::size_t(i)]);
  for (Eigen::Index t = 0; t < f.rows(); ++t) {
    for (Eigen::Index k = 0; k < 3; ++k)
      CHECK(Vertex_index(std::size_t(f(t, k))) == mesh.triangles[std::size_t(t)][std::size_t(k)]);
    CHECK(regions(t) == mesh.region_of_triangle[std::size_t(t)]);
  }
  REQUIRE(e.rows() == Eigen::Index(mesh.constrained_edges.size()));
  for (Eigen::Index i = 0; i < e.rows(); ++i) {
    CHECK(Vertex_index(std::size_t(e(i, 0))) == mesh.constrained_edges[std::size_t(i)].vertices[0]);
    CHECK(Vertex_index(std::size_t(e(i, 1))) == mesh.constrained_edges[std::size_t(i)].vertices[1]);
    CHECK(markers(i) == mesh.constrained_edges[std::size_t(i)].marker);
  }

  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> in_space;
  Eigen::Matrix<std::int64_t, Eigen::Dynamic, 3> wide;
  CGAL::indexed_mesh_to_matrices(mesh, in_space, wide);
  CHECK(in_space.leftCols(2) == v);
  CHECK(in_space.col(2).isZero());
  CHECK(wide.cast<int>() == f);

  Pslg back;
  Eigen::MatrixXd holes(1, 2);
  holes << -0.5, -0.5;
  Eigen::MatrixXi segments(pslg.segments.size(), 2);
  for (std::size_t s = 0; s < pslg.segments.size(); ++s)
    segments.row(Eigen::Index(s)) << int(pslg.segments[s][0].value()), int(pslg.segments[s][1].value());
  CGAL::matrices_to_pslg(v.topRows(Eigen::Index(pslg.vertices.size())), segments, holes, back);
  CHECK(back.vertices == pslg.vertices);
  CHECK(back.segments == pslg.segments);
  CHECK(back.holes == pslg.holes);
  CGAL::matrices_to_pslg(Eigen::MatrixXd(v), segments, back);
  CHECK(back.holes.empty());
  CGAL::matrices_to_pslg(Eigen::MatrixXd(), Eigen::MatrixXi(), back);
  CHECK(back.vertices.empty());

  const auto error_of = [&](const auto& vertices, const auto& indices) {
    try {
      CGAL::matrices_to_pslg(vertices, indices, back);
    } catch (const CGAL::Pslg_error_2& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  segments(3, 1) = -1;
  CHECK(error_of(v, segments).find("segment 3") != std::string::npos);
  segments(3, 1) = int(v.rows());
  CHECK(error_of(v, segments).find("segment 3") != std::string::npos);
  CHECK(error_of(in_space, segments).find("columns") != std::string::npos);
  CHECK(back.vertices.empty());
}
#endif

} // namespace test_indexed_mesh_conversions
