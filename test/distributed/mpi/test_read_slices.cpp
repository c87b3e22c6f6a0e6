// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Graphs that ranks have read in slices are those that are read at once, and so are errors.

#include "catch.h"
#include "joined_slices.h"
#include "scratch_folder.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/HDF5.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/read_slices.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace test_read_slices {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Graph = CGAL::Pslg_2<Point_2>;
using Slice = CGAL::Pslg_slice_2<Point_2>;

const std::string data = QUADTREE_MESH_TEST_DATA_DIR "/";

/// A folder that all ranks see, as they run on one machine.
class Common_folder {
public:
  Common_folder() : exchange_(MPI_COMM_WORLD) {
    if (exchange_.rank() == 0) folder_ = std::make_unique<Scratch_folder>();
  }
  /// The first rank makes the file by `write(name)`.
  template <class Write>
  std::string file(const std::string& name, const Write& write) {
    Bytes path;
    if (exchange_.rank() == 0) {
      const std::string own = folder_->file(name);
      write(own);
      path.assign(own.begin(), own.end());
    }
    exchange_.broadcast(path, 0);
    return std::string(path.begin(), path.end());
  }

private:
  Mpi_exchange exchange_;
  std::unique_ptr<Scratch_folder> folder_;
};

template <class Read>
std::string error_of(const Read& read) {
  try {
    read();
  } catch (const CGAL::Pslg_error_2& error) {
    return error.what();
  }
  return std::string();
}

/// A polygon of n vertices and segments. The record with the number `bad` is no number, or names no vertex.
void write_polygon(const std::string& name, std::size_t n, std::size_t bad) {
  std::ofstream out(name);
  out << n << " 2 0 0\n";
  for (std::size_t i = 0; i < n; ++i) out << i << ' ' << i << (i == bad ? " x\n" : " 7\n");
  out << n << " 0\n";
  for (std::size_t i = 0; i < n; ++i)
    out << i << ' ' << i << ' ' << (n + i == bad ? n + 5 : (i + 1) % n) << '\n';
  out << "0\n";
}

/// The slices of all ranks, at all of them. \returns how much is wrong
int compare(const Slice& own, const Graph& expected) {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  int wrong = own.number_of_vertices != static_cast<std::int64_t>(expected.vertices.size()) ||
              own.number_of_segments != static_cast<std::int64_t>(expected.segments.size());
  wrong += own.first_vertex != exchange.exclusive_scan(static_cast<std::int64_t>(own.vertices.size()));
  wrong += own.first_segment != exchange.exclusive_scan(static_cast<std::int64_t>(own.segments.size()));
  wrong += own.number_of_vertex_attributes != expected.number_of_vertex_attributes;
  const auto is_slice = [&](const auto& part, const auto& whole) {
    const std::int64_t first = exchange.exclusive_scan(static_cast<std::int64_t>(part.size()));
    const std::int64_t all = exchange.sum(static_cast<std::int64_t>(part.size()));
    bool is_same = all == static_cast<std::int64_t>(whole.size());
    for (std::size_t i = 0; is_same && i < part.size(); ++i)
      is_same = part[i] == whole[static_cast<std::size_t>(first) + i];
    wrong += is_same ? 0 : 1;
  };
  is_slice(own.vertices, expected.vertices);
  is_slice(own.vertex_attributes, expected.vertex_attributes);
  is_slice(own.vertex_markers, expected.vertex_markers);
  is_slice(own.segment_markers, expected.segment_markers);
  is_slice(own.holes, expected.holes);
  std::vector<std::array<std::int64_t, 2>> segments;
  for (const auto& s : expected.segments) segments.push_back({{s[0].value(), s[1].value()}});
  is_slice(own.segments, segments);
  std::vector<double> regions, own_regions;
  for (const auto& r : expected.regions)
    joined_slices::append(regions, {r.point.x(), r.point.y(), r.attribute, r.max_area});
  for (const auto& r : own.regions)
    joined_slices::append(own_regions, {r.point.x(), r.point.y(), r.attribute, r.max_area});
  is_slice(own_regions, regions);
  return wrong;
}

} // namespace

TEST_CASE("ranks read slices of .poly files", "[distributed]") {
  for (const char* const name :
       {"syn_square.poly", "us_states_10m.poly.gz", "hole_on_vertex.poly", "absent.poly"}) {
    INFO(name);
    Graph expected;
    Slice slice;
    const std::string error = error_of([&] { CGAL::IO::read_triangle_poly(data + name, expected); });
    CHECK(error_of([&] { CGAL::IO::read_triangle_poly_slice(MPI_COMM_WORLD, data + name, slice); }) == error);
    CHECK(compare(slice, expected) == 0);
  }
}

TEST_CASE("what is wrong in the slice of one rank is the same error at all ranks, which then go on",
          "[distributed]") {
  Common_folder folder;
  const std::size_t n = 400; // lines of vertices, then of segments
  const std::string good =
      folder.file("good.poly", [&](const std::string& at) { write_polygon(at, n, 2 * n); });
  Graph expected;
  CGAL::IO::read_triangle_poly(good, expected);
  for (const std::size_t line : {std::size_t(0), n / 4, n / 2, n - 1, n + 1, 3 * n / 2, 2 * n - 1}) {
    INFO("record " << line);
    const std::string bad =
        folder.file("bad.poly", [&](const std::string& at) { write_polygon(at, n, line); });
    Graph graph;
    Slice slice;
    const std::string error = error_of([&] { CGAL::IO::read_triangle_poly(bad, graph); });
    CHECK(!error.empty());
    CHECK(error_of([&] { CGAL::IO::read_triangle_poly_slice(MPI_COMM_WORLD, bad, slice); }) == error);
    CHECK(slice.vertices.empty());
    CGAL::IO::read_triangle_poly_slice(MPI_COMM_WORLD, good, slice);
    CHECK(compare(slice, expected) == 0);
  }
}

TEST_CASE("a file that one rank cannot open is the same error at all ranks", "[distributed]") {
  Common_folder folder;
  Mpi_exchange exchange(MPI_COMM_WORLD);
  Graph graph;
  CGAL::IO::read_triangle_poly(data + "syn_square.poly", graph);
  const std::string poly = data + "syn_square.poly", absent = data + "absent";
  const std::string hdf5 =
      folder.file("good.h5", [&](const std::string& at) { CGAL::IO::write_HDF5(at, graph); });
  for (int at = 0; at < exchange.size(); ++at) {
    INFO("rank " << at);
    const auto name = [&](const std::string& good) { return exchange.rank() == at ? absent : good; };
    Slice slice;
    CHECK(error_of([&] {
            CGAL::IO::read_triangle_poly_slice(MPI_COMM_WORLD, name(poly), slice);
          }).rfind(absent + ": cannot be opened", 0) == 0);
    CHECK(error_of([&] { CGAL::IO::read_HDF5_slice(MPI_COMM_WORLD, name(hdf5), slice); }).rfind(absent, 0) ==
          0);
    CGAL::IO::read_HDF5_slice(MPI_COMM_WORLD, hdf5, slice);
    CHECK(compare(slice, graph) == 0);
  }
}

TEST_CASE("ranks read slices of files of HDF5", "[distributed]") {
  Common_folder folder;
  for (const char* const name : {"syn_square.poly", "us_states_10m.poly.gz", "hole_on_vertex.poly"}) {
    INFO(name);
    Graph graph, expected;
    CGAL::IO::read_triangle_poly(data + name, graph);
    graph.number_of_vertex_attributes = 2;
    for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
      joined_slices::append(graph.vertex_attributes, {static_cast<double>(v), 0.5});
      if (graph.vertex_markers.size() < graph.vertices.size())
        graph.vertex_markers.push_back(static_cast<int>(v) % 7);
    }
    graph.regions.push_back({graph.vertices[0], 3, 0.5});
    graph.regions.push_back({graph.vertices[1], 4, 0});
    const std::string file =
        folder.file("graph.h5", [&](const std::string& at) { CGAL::IO::write_HDF5(at, graph); });
    CGAL::IO::read_HDF5(file, expected);
    Slice slice;
    CGAL::IO::read_HDF5_slice(MPI_COMM_WORLD, file, slice);
    CHECK(compare(slice, expected) == 0);
  }
}

TEST_CASE("what is wrong with a file of HDF5 is the same error at all ranks", "[distributed]") {
  Common_folder folder;
  // Wrong rows at the end of vertex markers and at the beginning of segments: markers are read first.
  const int kind = GENERATE(0, 1, 2, 3, 4);
  const std::string file = folder.file("bad.h5", [&](const std::string& at) {
    if (kind == 0) return;
    Hdf5_writer out(at, at);
    out.add_group("/pslg");
    out.add_array("/pslg/vertices", 100, kind == 1 ? 3 : 2,
                  [](std::size_t i, std::size_t) { return double(i); });
    out.add_array("/pslg/vertex_markers", kind == 2 ? 99 : 100, 0, [&](std::size_t i, std::size_t) {
      return std::int64_t(kind == 3 && i == 98 ? std::int64_t(1) << 40 : 0);
    });
    out.add_array("/pslg/segments", 100, 2, [](std::size_t i, std::size_t k) {
      return std::int64_t(i == 7 || i == 93 ? 100 + i : i == 50 ? 0 : k);
    });
    out.close();
  });
  Graph graph;
  Slice slice;
  const std::string error = error_of([&] { CGAL::IO::read_HDF5(file, graph); });
  CHECK(!error.empty());
  CHECK(error_of([&] { CGAL::IO::read_HDF5_slice(MPI_COMM_WORLD, file, slice); }) == error);
}

} // namespace test_read_slices
