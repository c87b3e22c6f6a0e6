// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Every format that is written is read back by a reader that is not ours, and has to be the same, bit for bit.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "scratch_folder.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#ifdef CGAL_LINKED_WITH_HDF5
#include <CGAL/IO/HDF5.h>
#endif
#include <CGAL/IO/MEDIT.h>
#include <CGAL/IO/MSH.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/OFF_and_OBJ.h>
#include <CGAL/IO/VTU.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/renumber_mesh_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_written_formats {

using namespace test_meshes;
namespace IO = CGAL::IO;

namespace {

struct Named_mesh {
  std::string name;
  Pslg pslg;
  Mesh mesh;
};

/// A square with a hole, a segment outside, and two regions, of which one is an attribute and the other no part.
Named_mesh mesh_with_all() {
  Named_mesh m{"all", {}, {}};
  add_polygon(m.pslg, square(0, 0, 2));
  add_polygon(m.pslg, square(0, 0, 1));
  add_polygon(m.pslg, square(5.1, 0, 1.1));
  add_polygon(m.pslg, square(5.1, 0, 0.1));
  m.pslg.holes.push_back(Point(0, 0));
  m.pslg.add_vertex(Point(9, 0.3));
  add_segment(m.pslg, 9, 16);
  m.pslg.regions = {{Point(5.1, 0), 0.1, 0}, {Point(1.5, 1.5), -7, 0}};
  m.mesh = mesh_of(m.pslg, 0.4);
  for (std::size_t s = 0; s < m.pslg.segments.size(); ++s)
    m.pslg.segment_markers.push_back(int(s % 4) * 3 - 3);
  for (auto& e : m.mesh.constrained_edges) e.marker = m.pslg.segment_markers[std::size_t(e.segment)];
  for (std::size_t v = 0; v < m.mesh.points.size(); ++v) m.mesh.vertex_markers.push_back(int(v % 5) - 2);
  for (const auto& t : m.mesh.triangles) {
    const Point c = CGAL::centroid(m.mesh.point(t[0]), m.mesh.point(t[1]), m.mesh.point(t[2]));
    const bool is_inner = std::abs(c.x() - 5.1) < 0.1 && std::abs(c.y()) < 0.1;
    m.mesh.region_of_triangle.push_back(c.x() < 3 ? 1 : is_inner ? 0 : -1);
  }
  return m;
}

Named_mesh plain_mesh() {
  Named_mesh m{"plain", {}, {}};
  add_polygon(m.pslg, {Point(0, 0), Point(1. / 3, 0), Point(0.1, 0.7)});
  m.mesh = mesh_of(m.pslg, 0.1);
  return m;
}

/// Coordinates near the ends of what doubles are.
Named_mesh extreme_mesh() {
  using Limits = std::numeric_limits<double>;
  Named_mesh m{"extreme", {}, {}};
  add_polygon(m.pslg,
              {Point(-Limits::max() / 3, -5e-324), Point(Limits::denorm_min(), -Limits::max() / 7),
               Point(1.2345678901234567e-310, Limits::min()), Point(1e300 / 3, 1.7976931348623157e308)});
  m.mesh.points = m.pslg.vertices;
  for (std::size_t v : {1u, 3u})
    m.mesh.triangles.push_back({Vertex_index(v - 1), Vertex_index(v), Vertex_index(2 * (v == 1))});
  m.mesh.triangles[1] = {Vertex_index(1), Vertex_index(3), Vertex_index(2)};
  for (std::size_t s = 0; s < 4; ++s)
    m.mesh.constrained_edges.push_back({m.pslg.segments[s], Segment_index(s), 2147483647 - int(s)});
  return m;
}

/// Two vertices and a segment outside the domain, which is empty.
Named_mesh mesh_without_triangles() {
  Named_mesh m{"bare", {}, {}};
  m.pslg.add_vertex(Point(0.5, 0.25));
  m.pslg.add_vertex(Point(1, 0));
  m.mesh.points = m.pslg.vertices;
  return m;
}

/// Input vertices among the others.
Named_mesh renumbered_mesh() {
  Named_mesh m = mesh_with_all();
  m.name = "renumbered";
  CGAL::renumber_by_place(m.mesh);
  return m;
}

/// The same with no vertex that no triangle uses.
Named_mesh mesh_of_used_vertices() {
  Named_mesh m = mesh_with_all();
  m.name = "used";
  std::vector<Vertex_index> moved_to(m.mesh.points.size());
  for (const auto& t : m.mesh.triangles)
    for (const Vertex_index v : t) moved_to[std::size_t(v)] = Vertex_index(0);
  std::vector<Point> points;
  for (std::size_t v = 0; v < moved_to.size(); ++v)
    if (moved_to[v].is_valid()) {
      moved_to[v] = Vertex_index(points.size());
      points.push_back(m.mesh.points[v]);
    }
  m.mesh.points = points;
  m.mesh.vertex_markers.clear();
  for (auto& t : m.mesh.triangles)
    for (Vertex_index& v : t) v = moved_to[std::size_t(v)];
  for (auto& e : m.mesh.constrained_edges)
    for (Vertex_index& v : e.vertices) v = moved_to[std::size_t(v)];
  return m;
}

std::vector<Named_mesh> meshes() {
  return {mesh_with_all(), plain_mesh(), extreme_mesh(), mesh_without_triangles(), renumbered_mesh()};
}

// --- readers of CGAL ---

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

void check_soup(const Mesh& mesh, const std::vector<Point_3>& points,
                const std::vector<std::vector<std::size_t>>& polygons) {
  REQUIRE(points.size() == mesh.points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    CHECK(points[v] == Point_3(mesh.points[v].x(), mesh.points[v].y(), 0));
  REQUIRE(polygons.size() == mesh.triangles.size());
  for (std::size_t t = 0; t < polygons.size(); ++t) {
    REQUIRE(polygons[t].size() == 3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(Vertex_index(polygons[t][k]) == mesh.triangles[t][k]);
  }
}

// --- readers of others ---

std::string bits(double x) {
  std::uint64_t word;
  std::memcpy(&word, &x, sizeof word);
  return std::to_string(word);
}

std::string text_of(const Vertex_index* begin, std::size_t n) {
  std::string text;
  for (std::size_t k = 0; k < n; ++k) text += ' ' + std::to_string(begin[k].value());
  return text;
}

void append_sorted(std::string& text, std::vector<std::string> lines) {
  std::sort(lines.begin(), lines.end());
  for (const std::string& line : lines) text += line + '\n';
}

/// The vertex of the mesh that is an input vertex.
Vertex_index vertex_of_input(const Mesh& mesh, Vertex_index input) {
  if (mesh.input_index.empty()) return input;
  return Vertex_index(std::find(mesh.input_index.begin(), mesh.input_index.end(), input) -
                      mesh.input_index.begin());
}

/// What read_back.py has to print.
enum class Vertex_markers { ABSENT, THERE };
std::string expected_text(const Named_mesh& m, const std::string& reader, const std::string& ending,
                          Vertex_markers markers, const IO::Triangle_fields_2& fields) {
  std::string text = "== " + reader + ' ' + ending + '\n';
  for (std::size_t v = 0; v < m.mesh.points.size(); ++v) {
    text += "p " + bits(m.mesh.points[v].x()) + ' ' + bits(m.mesh.points[v].y());
    if (markers == Vertex_markers::THERE) text += ' ' + std::to_string(m.mesh.marker(Vertex_index(v)));
    if (ending != "mesh" && !m.mesh.input_index.empty())
      text += m.mesh.input_index[v].is_valid() ? text_of(&m.mesh.input_index[v], 1) : " -1";
    text += '\n';
  }
  std::vector<std::string> lines;
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t)
    lines.push_back('t' + text_of(m.mesh.triangles[t].data(), 3) + ' ' +
                    std::to_string(m.mesh.region_of_triangle.empty() ? -1 : m.mesh.region_of_triangle[t]));
  append_sorted(text, lines);
  lines.clear();
  for (const auto& e : m.mesh.constrained_edges)
    lines.push_back('e' + text_of(e.vertices.data(), 2) + ' ' + std::to_string(e.marker));
  const bool has_all = m.name == "all" || m.name == "renumbered";
  if (has_all && (ending == "vtu" || ending == "pvtu" || ending == "vtkhdf")) { // the segment outside
    auto ends = m.pslg.segments.back();
    for (Vertex_index& v : ends) v = vertex_of_input(m.mesh, v);
    lines.push_back('e' + text_of(ends.data(), 2) + ' ' + std::to_string(m.pslg.segment_markers.back()));
  }
  append_sorted(text, lines);
  for (const auto& field : fields) {
    lines.clear();
    for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t)
      lines.push_back(field.name + text_of(m.mesh.triangles[t].data(), 3) + ' ' + bits(field.values[t]));
    append_sorted(text, lines);
  }
  return text;
}

#ifdef QUADTREE_MESH_PYTHON
std::string read_back(const Scratch_folder& folder, const std::string& arguments) {
  const std::string command = "'" QUADTREE_MESH_PYTHON "' '" QUADTREE_MESH_READ_BACK "' " + arguments +
                              " >'" + folder.file("out") + "' 2>'" + folder.file("err") + "'";
  const int status = std::system(command.c_str());
  CAPTURE(command, content(folder.file("err")).substr(0, 2000));
  REQUIRE(status == 0);
  return content(folder.file("out"));
}
#endif

} // namespace

TEST_CASE("OFF and OBJ are read back equal by CGAL", "[OFF][OBJ]") {
  const Scratch_folder folder;
  for (const Named_mesh& m : meshes()) {
    CAPTURE(m.name);
    std::vector<Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
    IO::write_OFF(folder.file("mesh.off"), m.mesh);
    REQUIRE(IO::read_OFF(folder.file("mesh.off"), points, polygons));
    check_soup(m.mesh, points, polygons);
    points.clear(), polygons.clear();
    IO::write_OBJ(folder.file("mesh.obj"), m.mesh);
    // CGAL takes a file without a face for a failure.
    CHECK(IO::read_OBJ(folder.file("mesh.obj"), points, polygons) == !m.mesh.triangles.empty());
    check_soup(m.mesh, points, polygons);
  }
}

#ifdef QUADTREE_MESH_PYTHON
TEST_CASE("MSH 2.2 is read back equal by meshio and gmsh", "[MSH]") {
  const Scratch_folder folder;
  std::string arguments, expected;
  for (const Named_mesh& m :
       {mesh_with_all(), plain_mesh(), extreme_mesh(), renumbered_mesh(), mesh_of_used_vertices()}) {
    const std::string file = folder.file(m.name + ".msh");
    IO::write_MSH(file, m.mesh, m.pslg, IO::Msh_version::V2_2);
    CHECK(content(file).rfind("$MeshFormat\n2.2 0 8\n", 0) == 0);
    for (const char* reader : {"meshio", "gmsh"}) {
      const bool has_unused = m.name == "all" || m.name == "renumbered"; // which gmsh forgets in this version
      if (has_unused && reader == std::string("gmsh")) continue;
      arguments += std::string(" ") + reader + " '" + file + '\'';
      expected += expected_text(m, reader, "msh", Vertex_markers::ABSENT, {});
    }
  }
  const std::string found = read_back(folder, arguments);
  CHECK((found == expected));
}

TEST_CASE("MSH, MEDIT, VTU and HDF5 are read back equal by meshio, gmsh and h5py",
          "[MSH][MEDIT][VTU][HDF5]") {
  const Scratch_folder folder;
  std::string arguments, expected;
  for (const Named_mesh& m : meshes()) {
    const std::string stem = folder.file(m.name);
    const auto expect = [&](const std::string& reader, const std::string& suffix, Vertex_markers markers,
                            const IO::Triangle_fields_2& fields = {}) {
      arguments += ' ' + reader + " '" + stem + suffix + '\'';
      expected += expected_text(m, reader, suffix.substr(suffix.rfind('.') + 1), markers, fields);
    };
    IO::write_MSH(stem + ".msh", m.mesh, m.pslg);
    expect("gmsh", ".msh", Vertex_markers::ABSENT);
    IO::write_MSH_parts(stem + "_in_3.msh", m.mesh, m.pslg, 3);
    expect("gmsh", "_in_3.msh", Vertex_markers::ABSENT);
    IO::write_MEDIT(stem + ".mesh", m.mesh);
    IO::write_VTU(stem + "_text.vtu", m.mesh, m.pslg, IO::ASCII);
    // meshio cannot do with files without cells.
    if (m.mesh.triangles.empty()) continue;
    expect("meshio", ".msh", Vertex_markers::ABSENT);
    expect("meshio", ".mesh", Vertex_markers::THERE);

    IO::Triangle_fields_2 fields{
        IO::field_at_centroids("x & <y>", m.mesh, [](double x, double y) { return x / 3 + y; })};
    const CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<>> tree(plain_mesh().pslg.vertices);
    fields.push_back(IO::quadtree_level_field(m.mesh, tree));
    IO::Triangle_fields_2 all;
    IO::Triangle_field_2 angles{"least_angle", {}}, attributes{"attribute", {}};
    for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = m.mesh.triangles[t];
      angles.values.push_back(
          CGAL::Quadtree_mesh_2::internal::Scaled_triangle(m.mesh.point(a), m.mesh.point(b), m.mesh.point(c))
              .least_angle());
      const int r = m.mesh.region_of_triangle.empty() ? -1 : m.mesh.region_of_triangle[t];
      attributes.values.push_back(r < 0 ? 0 : m.pslg.regions[std::size_t(r)].attribute);
    }
    all.push_back(angles);
    if (!m.mesh.region_of_triangle.empty()) all.push_back(attributes);
    all.insert(all.end(), fields.begin(), fields.end());
    const auto markers = m.mesh.vertex_markers.empty() ? Vertex_markers::ABSENT : Vertex_markers::THERE;
    IO::write_VTU(stem + "_text.vtu", m.mesh, m.pslg, fields, IO::ASCII);
    expect("meshio", "_text.vtu", markers, all);
    IO::write_VTU(stem + "_bytes.vtu", m.mesh, m.pslg, fields);
    expect("meshio", "_bytes.vtu", markers, all);
    for (const std::size_t pieces : {0u, 1u, 4u, 1000u}) { // meshio cannot do with the bytes of tiny arrays
      const std::string suffix = "_in_" + std::to_string(pieces) + ".pvtu";
      IO::write_PVTU(stem + suffix, m.mesh, m.pslg, pieces, fields, pieces > 4 ? IO::ASCII : IO::BINARY);
      expect("meshio", suffix, markers, all);
    }
#ifdef QUADTREE_MESH_H5PY
    IO::write_VTKHDF(stem + ".vtkhdf", m.mesh, m.pslg, fields);
    expect("h5py", ".vtkhdf", markers, all);
    IO::write_XDMF(stem + ".xdmf", m.mesh, m.pslg, fields);
    expect("h5py", ".xdmf", markers, all);
#endif
  }
  const std::string found = read_back(folder, arguments);
  std::istringstream found_lines(found), expected_lines(expected);
  std::string found_line, expected_line, section;
  while (std::getline(expected_lines, expected_line)) {
    if (expected_line.rfind("==", 0) == 0) section += '\n' + expected_line;
    std::getline(found_lines, found_line);
    CAPTURE(section);
    REQUIRE(found_line == expected_line);
  }
  CHECK(!std::getline(found_lines, found_line));
}
#endif

TEST_CASE("streams get what files get, and errors name the file", "[OFF][OBJ][MSH][MEDIT][VTU]") {
  const Scratch_folder folder;
  const Named_mesh m = mesh_with_all();
  const auto check = [&](const char* name, auto write) {
    CAPTURE(name);
    std::ostringstream out;
    write(out);
    write(folder.file(name));
    CHECK(content(folder.file(name)) == out.str());
    CHECK(out.str().size() > 1000);
    try {
      write(folder.file("missing/") + name);
      FAIL("no exception");
    } catch (const std::runtime_error& error) {
      CHECK(std::string(error.what()).find(name) != std::string::npos);
    }
  };
  check("a.off", [&](auto&& out) { IO::write_OFF(out, m.mesh); });
  check("a.obj", [&](auto&& out) { IO::write_OBJ(out, m.mesh); });
  check("a.mesh", [&](auto&& out) { IO::write_MEDIT(out, m.mesh); });
  check("a.msh", [&](auto&& out) { IO::write_MSH(out, m.mesh, m.pslg); });
  check("c.msh", [&](auto&& out) { IO::write_MSH(out, m.mesh, m.pslg, IO::Msh_version::V2_2); });
  check("b.msh", [&](auto&& out) { IO::write_MSH(out, m.mesh); });
  check("a.vtu", [&](auto&& out) { IO::write_VTU(out, m.mesh, m.pslg, IO::Triangle_fields_2()); });
  const IO::Triangle_fields_2 wrong{{"short", {1, 2}}};
  CHECK_THROWS_AS(IO::write_VTU(folder.file("c.vtu"), m.mesh, m.pslg, wrong), std::invalid_argument);
  CHECK_THROWS_AS(IO::write_PVTU(folder.file("c.pvtu"), m.mesh, m.pslg, 2, wrong), std::invalid_argument);
  CHECK_FALSE(std::filesystem::exists(folder.file("c_1.vtu")));
}

TEST_CASE("points of other kinds are written as numbers", "[OFF][OBJ][MSH][MEDIT][VTU]") {
  const auto texts = [](const auto& mesh) {
    std::ostringstream out;
    IO::write_OFF(out, mesh);
    IO::write_OBJ(out, mesh);
    IO::write_MSH(out, mesh);
    IO::write_MEDIT(out, mesh);
    IO::write_VTU(out, mesh, {}, {}, IO::ASCII);
    return out.str();
  };
  const auto triangle = [](auto mesh) {
    using Exact_or_word = typename decltype(mesh)::Point_2;
    mesh.points = {Exact_or_word(0, 0), Exact_or_word(1000003, 7), Exact_or_word(5, 4000000000.)};
    mesh.triangles.push_back({Vertex_index(0), Vertex_index(1), Vertex_index(2)});
    return mesh;
  };
  struct Word_point {
    std::uint32_t x_, y_;
    Word_point(double x, double y) : x_(static_cast<std::uint32_t>(x)), y_(static_cast<std::uint32_t>(y)) {}
    std::uint32_t x() const { return x_; }
    std::uint32_t y() const { return y_; }
  };
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::Point_2;
  const std::string words = texts(triangle(CGAL::Indexed_mesh_2<Word_point>()));
  CHECK(words.find("\n5 4000000000 0\n") != std::string::npos);
  const std::string exact = texts(triangle(CGAL::Indexed_mesh_2<Exact>()));
  CHECK(exact == texts(triangle(Mesh())));
  CHECK(exact.find("1000003 7") != std::string::npos);
}

TEST_CASE("meshes of nothing are files, too", "[OFF][OBJ][MSH][MEDIT][VTU]") {
  std::ostringstream off, obj, msh, medit, vtu;
  IO::write_OFF(off, Mesh());
  IO::write_OBJ(obj, Mesh());
  IO::write_MSH(msh, Mesh());
  IO::write_MEDIT(medit, Mesh());
  IO::write_VTU(vtu, Mesh(), Pslg(), {}, IO::ASCII);
  CHECK(off.str() == "OFF\n0 0 0\n");
  CHECK(obj.str().empty());
  CHECK(msh.str().find("$Nodes\n0 0 0 0\n$EndNodes\n$Elements\n0 0 0 0\n") != std::string::npos);
  CHECK(medit.str().find("Vertices\n0\n") != std::string::npos);
  std::ostringstream msh_2;
  IO::write_MSH(msh_2, Mesh(), Pslg(), IO::Msh_version::V2_2);
  CHECK(msh_2.str().find("$Nodes\n0\n$EndNodes\n$Elements\n0\n$EndElements\n") != std::string::npos);
  CHECK(vtu.str().find("NumberOfCells=\"0\"") != std::string::npos);
}

} // namespace test_written_formats
