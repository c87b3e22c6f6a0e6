// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Files about edges, neighbors, second-order nodes and cells: each is what Triangle's manual says
// (https://www.cs.cmu.edu/~quake/triangle.html), or is read back by readers that are not ours.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "scratch_folder.h"

#include <CGAL/IO/MSH.h>
#include <CGAL/IO/Mesh_cells.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/VTU.h>
#include <CGAL/IO/WKT.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/dual_of_mesh_2.h>
#include <CGAL/edges_of_mesh_2.h>
#include <CGAL/renumber_mesh_2.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_edges_and_cells_files {

using namespace test_meshes;
namespace IO = CGAL::IO;

namespace {

struct Marked_mesh {
  Pslg pslg;
  Mesh mesh;
};

/// A square with a hole, a segment within, and a vertex that nothing uses; sides with the markers 0, 5, -2 and 0.
Marked_mesh marked_mesh() {
  Marked_mesh m;
  add_polygon(m.pslg, square(0, 0, 2));
  add_polygon(m.pslg, square(0, 0.1, 0.5));
  m.pslg.add_vertex(Point(1, -1.5));
  m.pslg.add_vertex(Point(1.7, 1.1));
  m.pslg.add_vertex(Point(9, 9));
  add_segment(m.pslg, 8, 9);
  m.pslg.holes.push_back(Point(0, 0.1));
  m.pslg.segment_markers = {0, 5, -2, 0, 0, 0, 0, 8, 7};
  m.pslg.first_number = 1;
  m.mesh = mesh_of(m.pslg, 0.5);
  for (auto& e : m.mesh.constrained_edges) e.marker = m.pslg.segment_markers[std::size_t(e.segment)];
  m.mesh.vertex_markers.assign(m.mesh.points.size(), 0);
  m.mesh.vertex_markers[2] = 77;
  return m;
}

using Rows = std::vector<std::vector<double>>;

/// The numbers of a file, line by line.
Rows rows_of(const std::string& file_name) {
  Rows rows;
  std::ifstream in(file_name);
  for (std::string line; std::getline(in, line);) {
    std::istringstream numbers(line);
    rows.emplace_back();
    for (double x; numbers >> x;) rows.back().push_back(x);
    CHECK(numbers.eof());
  }
  return rows;
}

std::pair<std::size_t, std::size_t> ordered(std::size_t a, std::size_t b) { return std::minmax(a, b); }

/// How many triangles have a side.
std::map<std::pair<std::size_t, std::size_t>, int> sides_of(const Mesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[ordered(std::size_t(t[k]), std::size_t(t[(k + 1) % 3]))];
  return sides;
}

#ifdef QUADTREE_MESH_PYTHON
std::string bits(double x) {
  std::uint64_t word;
  std::memcpy(&word, &x, sizeof word);
  return std::to_string(word);
}
#endif

} // namespace

TEST_CASE("an .edge file has each edge once, with a marker by Triangle's rule", "[triangle_files]") {
  const Scratch_folder folder;
  const Marked_mesh m = marked_mesh();
  IO::write_triangle_edge(folder.file("x.edge"), m.mesh, 1);
  const Rows rows = rows_of(folder.file("x.edge"));
  const auto sides = sides_of(m.mesh);
  REQUIRE(rows.size() == sides.size() + 1);
  CHECK(rows[0] == std::vector<double>{double(sides.size()), 1});
  std::map<std::pair<std::size_t, std::size_t>, int> markers;
  for (const auto& e : m.mesh.constrained_edges)
    markers[ordered(std::size_t(e.vertices[0]), std::size_t(e.vertices[1]))] = e.marker;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    REQUIRE(rows[i].size() == 4);
    CHECK(rows[i][0] == double(i));
    const auto side = ordered(std::size_t(rows[i][1]) - 1, std::size_t(rows[i][2]) - 1);
    CHECK(seen.insert(side).second);
    REQUIRE(sides.count(side) == 1);
    const bool has_marker = markers.count(side) > 0 && markers[side] != 0;
    CHECK(rows[i][3] == (has_marker ? markers[side] : sides.at(side) == 1 ? 1 : 0));
  }
}

TEST_CASE("a .neigh file has the triangle opposite each corner", "[triangle_files]") {
  const Scratch_folder folder;
  const Marked_mesh m = marked_mesh();
  IO::write_triangle_neigh(folder.file("x.neigh"), m.mesh, 1);
  const Rows rows = rows_of(folder.file("x.neigh"));
  REQUIRE(rows.size() == m.mesh.triangles.size() + 1);
  CHECK(rows[0] == std::vector<double>{double(m.mesh.triangles.size()), 3});
  const auto sides = sides_of(m.mesh);
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
    REQUIRE(rows[t + 1].size() == 4);
    CHECK(rows[t + 1][0] == double(t + 1));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& triangle = m.mesh.triangles[t];
      const Vertex_index a = triangle[(k + 1) % 3], b = triangle[(k + 2) % 3];
      const double number = rows[t + 1][k + 1];
      CHECK((number == -1) == (sides.at(ordered(std::size_t(a), std::size_t(b))) == 1));
      if (number == -1) continue;
      const auto& other = m.mesh.triangles[std::size_t(number) - 1];
      CHECK(std::size_t(number) != t + 1);
      CHECK(std::count(other.begin(), other.end(), a) + std::count(other.begin(), other.end(), b) == 2);
    }
  }
}

TEST_CASE("the files of a Voronoi diagram have circumcenters, edges between them, and rays outward",
          "[triangle_files]") {
  const Scratch_folder folder;
  const Marked_mesh m = marked_mesh();
  IO::write_triangle_voronoi(m.mesh, folder.file("x"), 1);
  const Rows nodes = rows_of(folder.file("x.v.node")), edges = rows_of(folder.file("x.v.edge"));
  REQUIRE(nodes.size() == m.mesh.triangles.size() + 1);
  CHECK(nodes[0] == std::vector<double>{double(m.mesh.triangles.size()), 2, 0, 0});
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
    REQUIRE(nodes[t + 1].size() == 3);
    CHECK(nodes[t + 1][0] == double(t + 1));
    const Point center(nodes[t + 1][1], nodes[t + 1][2]);
    const double radius = std::sqrt(CGAL::squared_distance(center, m.mesh.point(m.mesh.triangles[t][0])));
    for (const Vertex_index v : m.mesh.triangles[t])
      CHECK(std::sqrt(CGAL::squared_distance(center, m.mesh.point(v))) == Approx(radius).epsilon(1e-10));
  }
  const auto of_mesh = CGAL::edges_of_mesh_2(m.mesh); // in the order of the .edge file
  REQUIRE(edges.size() == of_mesh.size() + 1);
  CHECK(edges[0] == std::vector<double>{double(of_mesh.size()), 0});
  for (std::size_t i = 0; i < of_mesh.size(); ++i) {
    const auto& row = edges[i + 1];
    const auto& [t, u] = of_mesh[i].triangles;
    CHECK(row[0] == double(i + 1));
    CHECK(row[1] == double(t.value() + 1));
    if (u.is_valid()) {
      REQUIRE(row.size() == 3);
      CHECK(row[2] == double(u.value() + 1));
      continue;
    }
    REQUIRE(row.size() == 5);
    CHECK(row[2] == -1);
    const Kernel::Vector_2 ray(row[3], row[4]);
    const Point &a = m.mesh.point(of_mesh[i].vertices[0]), &b = m.mesh.point(of_mesh[i].vertices[1]);
    CHECK(ray * (b - a) == 0);
    for (const Vertex_index v : m.mesh.triangles[std::size_t(t)]) CHECK(ray * (m.mesh.point(v) - a) <= 0);
  }
}

TEST_CASE("second-order files of Triangle have nodes opposite the corners", "[triangle_files]") {
  const Scratch_folder folder;
  Marked_mesh m = marked_mesh();
  SECTION("in the order of the input") {}
  SECTION("renumbered") { CGAL::renumber_by_place(m.mesh); }
  IO::write_triangle_files(m.mesh, m.pslg, folder.file("x"), IO::Element_order::SECOND);
  const Rows nodes = rows_of(folder.file("x.node")), triangles = rows_of(folder.file("x.ele"));
  const auto sides = sides_of(m.mesh);
  const std::size_t n = m.mesh.points.size(), all = n + sides.size();
  const std::size_t attributes = m.mesh.input_index.empty() ? 0 : 1;
  REQUIRE(nodes.size() == all + 1);
  CHECK(nodes[0] == std::vector<double>{double(all), 2, double(attributes), 1});
  for (std::size_t i = 0; i < all; ++i) {
    REQUIRE(nodes[i + 1].size() == 4 + attributes);
    CHECK(nodes[i + 1][0] == double(i + 1));
    if (attributes > 0 && i >= n) CHECK(nodes[i + 1][3] == -1);
  }
  REQUIRE(triangles.size() == m.mesh.triangles.size() + 1);
  CHECK(triangles[0] == std::vector<double>{double(m.mesh.triangles.size()), 6, 0});
  const auto edges = CGAL::edges_of_mesh_2(m.mesh);
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
    const auto& row = triangles[t + 1];
    REQUIRE(row.size() == 7);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t i) { return nodes[std::size_t(row[1 + (k + i) % 3])]; };
      const auto& middle = nodes[std::size_t(row[4 + k])];
      CHECK(std::size_t(row[1 + k]) == std::size_t(m.mesh.triangles[t][k]) + 1);
      CHECK(std::size_t(row[4 + k]) > n);
      for (const std::size_t x : {1u, 2u}) CHECK(middle[x] == Approx((corner(1)[x] + corner(2)[x]) / 2));
      CHECK(middle.back() == edges[std::size_t(row[4 + k]) - 1 - n].marker);
    }
  }
  // What reads three nodes says so.
  Mesh back;
  CHECK_THROWS_AS(IO::read_triangle_files(folder.file("x"), back), CGAL::Pslg_error_2);
}

TEST_CASE("cells are read back from GeoJSON and WKT", "[cells]") {
  Mesh mesh = marked_mesh().mesh;
  SECTION("of one polygon each") {}
  SECTION("of two where the border touches itself") {
    mesh = Mesh();
    mesh.points = {Point(0, 0), Point(2, -1), Point(2, 1), Point(-2, 1), Point(-2, -1)};
    mesh.triangles = {{Vertex_index(0), Vertex_index(1), Vertex_index(2)},
                      {Vertex_index(0), Vertex_index(3), Vertex_index(4)}};
  }
  const CGAL::Mesh_dual_2 dual = CGAL::dual_of_mesh_2(mesh);
  std::ostringstream geojson, wkt;
  IO::write_cells_GeoJSON(geojson, dual, mesh, 1);
  IO::write_cells_WKT(wkt, dual);

  // Per vertex, its polygons as rings that are closed.
  std::map<std::size_t, std::vector<std::vector<Point>>> expected, from_geojson, from_wkt;
  for (std::size_t v = 0; v < dual.number_of_cells(); ++v)
    dual.for_each_polygon(Vertex_index(v), [&](const std::uint32_t* begin, const std::uint32_t* end) {
      std::vector<Point> ring;
      for (; begin != end; ++begin) ring.emplace_back(dual.points[*begin][0], dual.points[*begin][1]);
      expected[v].push_back(ring);
    });

  const auto json = nlohmann::json::parse(geojson.str());
  CHECK(json["type"] == "FeatureCollection");
  for (const auto& feature : json["features"]) {
    CHECK(feature["type"] == "Feature");
    const std::size_t v = feature["properties"]["vertex"].get<std::size_t>() - 1;
    CHECK(feature["properties"]["area"].get<double>() == dual.areas[v]);
    CHECK(feature["properties"]["marker"].get<int>() == mesh.marker(Vertex_index(v)));
    const auto& geometry = feature["geometry"];
    const bool is_multi = geometry["type"] == "MultiPolygon";
    CHECK((is_multi || geometry["type"] == "Polygon"));
    const auto add = [&](const nlohmann::json& polygon) {
      REQUIRE(polygon.size() == 1); // ring
      std::vector<Point> ring;
      for (const auto& place : polygon[0]) ring.emplace_back(place[0].get<double>(), place[1].get<double>());
      CHECK(ring.front() == ring.back());
      ring.pop_back();
      from_geojson[v].push_back(ring);
    };
    if (!is_multi)
      add(geometry["coordinates"]);
    else
      for (const auto& polygon : geometry["coordinates"]) add(polygon);
  }
  CHECK(from_geojson == expected);

  std::istringstream lines(wkt.str());
  std::size_t v = 0;
  for (std::string line; std::getline(lines, line); ++v) {
    CHECK((line == "POLYGON EMPTY") == (expected.count(v) == 0));
    if (line == "POLYGON EMPTY") continue;
    std::istringstream in(line);
    std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons(1);
    if (line.rfind("MULTI", 0) == 0)
      CGAL::IO::read_multi_polygon_WKT(in, polygons);
    else
      CGAL::IO::read_polygon_WKT(in, polygons[0]);
    for (const auto& polygon : polygons)
      if (!polygon.outer_boundary().is_empty())
        from_wkt[v].emplace_back(polygon.outer_boundary().begin(), polygon.outer_boundary().end());
  }
  CHECK(v == mesh.points.size());
  CHECK(from_wkt == expected);
}

#ifdef QUADTREE_MESH_PYTHON
TEST_CASE("elements of second order are read back by meshio and gmsh", "[VTU][MSH]") {
  const Scratch_folder folder;
  Marked_mesh m = marked_mesh();
  m.mesh.points.pop_back(); // Gmsh forgets nodes that nothing uses
  m.pslg.vertices.pop_back();
  m.mesh = mesh_of(m.pslg, 0.5);
  for (auto& e : m.mesh.constrained_edges) e.marker = m.pslg.segment_markers[std::size_t(e.segment)];
  IO::write_VTU(folder.file("x.vtu"), m.mesh, m.pslg, {}, IO::BINARY, IO::Element_order::SECOND);
  IO::write_MSH(folder.file("4.msh"), m.mesh, m.pslg, IO::Msh_version::V4_1, IO::Element_order::SECOND);
  IO::write_MSH(folder.file("2.msh"), m.mesh, m.pslg, IO::Msh_version::V2_2, IO::Element_order::SECOND);
  const auto nodes = CGAL::second_order_nodes_2(m.mesh);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> node_of;
  for (std::size_t e = 0; e < nodes.edges.size(); ++e)
    node_of[ordered(std::size_t(nodes.edges[e].vertices[0]), std::size_t(nodes.edges[e].vertices[1]))] =
        nodes.first_node + e;
  std::string points;
  for (const Point& p : m.mesh.points) points += "p " + bits(p.x()) + ' ' + bits(p.y()) + '\n';
  for (const auto& p : nodes.points) points += "p " + bits(p[0]) + ' ' + bits(p[1]) + '\n';
  // Vertices, then the nodes between the first and the second, the second and the third, the third and the first.
  std::vector<std::string> triangles, edges;
  for (const auto& t : m.mesh.triangles) {
    std::string line = "t";
    for (const Vertex_index v : t) line += ' ' + std::to_string(v.value());
    for (std::size_t k = 0; k < 3; ++k)
      line += ' ' + std::to_string(node_of.at(ordered(std::size_t(t[k]), std::size_t(t[(k + 1) % 3]))));
    triangles.push_back(line);
  }
  for (const auto& e : m.mesh.constrained_edges) {
    const std::size_t a(e.vertices[0]), b(e.vertices[1]);
    edges.push_back("e " + std::to_string(a) + ' ' + std::to_string(b) + ' ' +
                    std::to_string(node_of.at(ordered(a, b))) + ' ' + std::to_string(e.marker));
  }
  std::sort(triangles.begin(), triangles.end()), std::sort(edges.begin(), edges.end());
  std::string body = points;
  for (const auto* list : {&triangles, &edges})
    for (const std::string& line : *list) body += line + '\n';
  std::string arguments, expected;
  for (const auto& [reader, file, ending] :
       {std::array{"meshio_2nd", "x.vtu", "vtu"}, std::array{"meshio_2nd", "4.msh", "msh"},
        std::array{"meshio_2nd", "2.msh", "msh"}, std::array{"gmsh_2nd", "4.msh", "msh"},
        std::array{"gmsh_2nd", "2.msh", "msh"}}) {
    arguments += std::string(" ") + reader + " '" + folder.file(file) + '\'';
    expected += std::string("== ") + reader + ' ' + ending + '\n' + body;
  }
  const std::string command = "'" QUADTREE_MESH_PYTHON "' '" QUADTREE_MESH_READ_BACK "' " + arguments +
                              " >'" + folder.file("out") + "' 2>'" + folder.file("err") + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  const std::string found = content(folder.file("out"));
  CHECK((found == expected));
}
#endif

} // namespace test_edges_and_cells_files
