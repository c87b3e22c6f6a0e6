// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Graphs in files of HDF5: they come back as they are, as others write them, too; what is wrong is named.

#ifdef CGAL_LINKED_WITH_HDF5

#include "catch.h"
#include "mesh_from_cdt.h"
#include "scratch_folder.h"

#include <CGAL/IO/HDF5.h>
#include <CGAL/Pslg_error_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace test_hdf5 {

using namespace test_meshes;
using CGAL::Quadtree_mesh_2::internal::Hdf5_writer;

namespace {

bool are_equal(const Pslg& a, const Pslg& b) {
  const auto is_same_region = [](const auto& r, const auto& s) {
    return r.point == s.point && r.attribute == s.attribute && r.max_area == s.max_area;
  };
  return a.vertices == b.vertices && a.vertex_markers == b.vertex_markers &&
         a.number_of_vertex_attributes == b.number_of_vertex_attributes &&
         a.vertex_attributes == b.vertex_attributes && a.segments == b.segments &&
         a.segment_markers == b.segment_markers && a.holes == b.holes &&
         std::equal(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(), is_same_region);
}

/// With more rows than a slab has.
Pslg graph_with_all(std::size_t n) {
  Pslg pslg;
  std::mt19937 random(5);
  const auto number = [&] { return std::ldexp(double(random()), int(random() % 1000) - 500); };
  for (std::size_t i = 0; i < n; ++i) {
    pslg.add_vertex(Point(number(), -number()));
    pslg.vertex_markers.push_back(int(random()) - 5);
    for (int k = 0; k < 3; ++k) pslg.vertex_attributes.push_back(number());
    add_segment(pslg, random() % n, i);
    pslg.segment_markers.push_back(std::numeric_limits<int>::min() + int(i));
  }
  pslg.number_of_vertex_attributes = 3;
  pslg.holes = {Point(1e-300, 5e-324), Point(-0., 1)};
  pslg.regions = {{Point(1. / 3, 2), -7.5, 0}, {Point(0, 0), 0, 0.1}};
  return pslg;
}

Pslg read(const std::string& file_name) {
  Pslg pslg;
  CGAL::IO::read_HDF5(file_name, pslg);
  return pslg;
}

/// A file with some arrays, each of one number over and over.
struct Array {
  std::string path;
  std::size_t rows, columns;
  double value;
  bool is_whole = false;
};
std::string file_with(const Scratch_folder& folder, const std::vector<Array>& arrays) {
  Hdf5_writer out(folder.file("graph.h5"), "graph.h5");
  out.add_group("/pslg");
  for (const Array& a : arrays)
    if (a.is_whole)
      out.add_array(a.path, a.rows, a.columns,
                    [&](std::size_t, std::size_t) { return std::int64_t(a.value); });
    else
      out.add_array(a.path, a.rows, a.columns, [&](std::size_t, std::size_t) { return a.value; });
  out.close();
  return folder.file("graph.h5");
}

void check_refused(const std::string& file_name, const std::vector<std::string>& words) {
  Pslg pslg = graph_with_all(2);
  try {
    CGAL::IO::read_HDF5(file_name, pslg);
    FAIL("no exception");
  } catch (const CGAL::Pslg_error_2& error) {
    const std::string what = error.what();
    CAPTURE(what);
    CHECK(error.kind() == CGAL::Pslg_error_2::Kind::UNREADABLE_FILE);
    CHECK(what.rfind(file_name + ": ", 0) == 0);
    for (const std::string& word : words) CHECK(what.find(word) != std::string::npos);
  }
  CHECK(are_equal(pslg, graph_with_all(2)));
}

} // namespace

TEST_CASE("graphs in HDF5 come back bit for bit", "[HDF5]") {
  const Scratch_folder folder;
  Pslg points;
  points.vertices = {Point(1, 2), Point(3, 4)};
  for (const Pslg& pslg : {Pslg(), points, graph_with_all(3), graph_with_all(200000)}) {
    CGAL::IO::write_HDF5(folder.file("graph.h5"), pslg);
    CHECK(are_equal(read(folder.file("graph.h5")), pslg));
  }
  const std::string before = content(folder.file("graph.h5"));
  CGAL::IO::write_HDF5(folder.file("graph.h5"), graph_with_all(200000));
  CHECK(content(folder.file("graph.h5")) == before);
  CHECK(folder.number_of_files() == 1);
}

TEST_CASE("what is wrong with a graph in HDF5 is named", "[HDF5]") {
  const Scratch_folder folder;
  const Array vertices{"/pslg/vertices", 3, 2, 0.5}, segments{"/pslg/segments", 2, 2, 1, true};
  CHECK(read(file_with(folder, {vertices, segments})).segments.size() == 2);
  check_refused(file_with(folder, {}), {"there is no /pslg/vertices"});
  check_refused(file_with(folder, {segments}), {"there is no /pslg/vertices"});
  check_refused(file_with(folder, {{"/pslg/vertices", 3, 3, 0}}),
                {"/pslg/vertices", "3 columns", "2 columns"});
  check_refused(file_with(folder, {{"/pslg/vertices", 3, 0, 0}}), {"/pslg/vertices", "one dimension"});
  check_refused(file_with(folder, {vertices, {"/pslg/segments", 2, 2, 1}}), {"/pslg/segments", "not whole"});
  check_refused(file_with(folder, {vertices, {"/pslg/segments", 2, 2, 3, true}}),
                {"/pslg/segments: row 0: there is no vertex 3, the vertices are 0 to 2"});
  check_refused(file_with(folder, {vertices, {"/pslg/segments", 1, 2, -1, true}}), {"there is no vertex -1"});
  check_refused(file_with(folder, {{"/pslg/vertices", 0, 2, 0}, segments}), {"there is no vertex 1"});
  check_refused(file_with(folder, {vertices, {"/pslg/vertex_markers", 2, 0, 1, true}}),
                {"/pslg/vertex_markers has 2 rows for 3 vertices"});
  check_refused(file_with(folder, {vertices, {"/pslg/vertex_markers", 3, 0, 1e10, true}}),
                {"/pslg/vertex_markers: row 0: 10000000000"});
  check_refused(file_with(folder, {vertices, segments, {"/pslg/segment_markers", 1, 0, 1, true}}),
                {"/pslg/segment_markers has 1 rows for 2 segments"});
  check_refused(file_with(folder, {vertices, {"/pslg/vertex_attributes", 1, 4, 0}}),
                {"/pslg/vertex_attributes has 1 rows for 3 vertices"});
  check_refused(file_with(folder, {vertices, {"/pslg/holes", 1, 1, 0}}), {"/pslg/holes", "1 column,"});
  check_refused(file_with(folder, {vertices, {"/pslg/regions", 1, 5, 0}}), {"/pslg/regions", "5 columns"});
  CHECK(read(file_with(folder, {vertices, {"/pslg/regions", 1, 3, -2}})).regions.front().max_area == 0);
  CHECK(read(file_with(folder, {vertices, {"/pslg/regions", 1, 4, -2}})).regions.front().max_area == 0);

  Hdf5_writer group(folder.file("group.h5"), "group.h5");
  group.add_group("/pslg"), group.add_group("/pslg/vertices");
  group.close();
  check_refused(folder.file("group.h5"), {"/pslg/vertices is no array"});
  check_refused(folder.file("missing.h5"), {"No such file"});
  check_refused(folder.write("text.h5", "4 2 0 0\n"), {"no file of HDF5"});
  check_refused(folder.write("empty.h5", ""), {"no file of HDF5"});
  std::filesystem::create_directory(folder.file("folder.h5"));
  check_refused(folder.file("folder.h5"), {});
}

TEST_CASE("no damaged file of HDF5 makes more than an error", "[HDF5]") {
  const Scratch_folder folder;
  CGAL::IO::write_HDF5(folder.file("whole.h5"), graph_with_all(40));
  const std::string whole = content(folder.file("whole.h5"));
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    std::string text = whole;
    if (i % 3 == 0)
      text.resize(random() % text.size());
    else
      for (int k = 0; k < 1 + i % 7; ++k)
        text[random() % std::min<std::size_t>(text.size(), 4096)] = char(random());
    try {
      const Pslg pslg = read(folder.write("damaged.h5", text));
      for (const auto& s : pslg.segments)
        for (const Vertex_index v : s) REQUIRE(std::size_t(v) < pslg.vertices.size());
    } catch (const CGAL::Pslg_error_2& error) {
      CHECK(std::string(error.what()).find("damaged.h5") != std::string::npos);
    }
  }
}

TEST_CASE("files of HDF5 that cannot be written leave the older ones", "[HDF5]") {
  const Scratch_folder folder;
  const Pslg pslg = graph_with_all(3);
  const Mesh mesh;
  folder.write("old.h5", "old");
  for (const std::string& name : {folder.file("missing/x.h5"), folder.file("")}) {
    CHECK_THROWS_AS(CGAL::IO::write_HDF5(name, pslg), std::system_error);
    CHECK_THROWS_AS(CGAL::IO::write_VTKHDF(name, mesh, pslg), std::system_error);
  }
  std::filesystem::create_directory(folder.file("old.xdmf")); // so the other file is not replaced, either
  CHECK_THROWS_AS(CGAL::IO::write_XDMF(folder.file("old.xdmf"), mesh, pslg), std::system_error);
  CHECK(content(folder.file("old.h5")) == "old");
  const CGAL::IO::Triangle_fields_2 wrong{{"short", {1, 2}}};
  CHECK_THROWS_AS(CGAL::IO::write_VTKHDF(folder.file("old.h5"), mesh, pslg, wrong), std::invalid_argument);
  CHECK(content(folder.file("old.h5")) == "old");
  CHECK(folder.number_of_files() == 2);
}

#ifdef QUADTREE_MESH_H5PY
TEST_CASE("graphs are read as h5py writes them", "[HDF5]") {
  const Scratch_folder folder;
  const std::string script = R"(
import sys, h5py, numpy
with h5py.File(sys.argv[1], "w") as f:
    g = f.create_group("pslg")
    g.create_dataset("vertices", data=numpy.array([[0, 0], [4, 0], [4, 3]], ">f4"), chunks=(2, 1), compression="gzip")
    g["segments"] = numpy.array([[0, 1], [1, 2], [2, 0]], ">u2")
    g["segment_markers"] = numpy.array([[1], [2], [3]], "i1")
    g["holes"] = numpy.array([[1, 2]])
    g["regions"] = [[1, 1, 5, 0.5]]
)";
  folder.write("write.py", script);
  const std::string command =
      "'" QUADTREE_MESH_PYTHON "' '" + folder.file("write.py") + "' '" + folder.file("graph.h5") + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  Pslg expected;
  expected.vertices = {Point(0, 0), Point(4, 0), Point(4, 3)};
  for (std::size_t s = 0; s < 3; ++s) add_segment(expected, s, (s + 1) % 3);
  expected.segment_markers = {1, 2, 3};
  expected.holes = {Point(1, 2)};
  expected.regions = {{Point(1, 1), 5, 0.5}};
  CHECK(are_equal(read(folder.file("graph.h5")), expected));
}
#endif

} // namespace test_hdf5

#endif // CGAL_LINKED_WITH_HDF5
