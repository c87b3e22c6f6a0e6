// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Ranks that have only what they own get their ghosts and foreign vertices back, byte by byte, however the mesh is cut;
// they talk to those beside them alone.

#include "catch.h"
#include "distributed_mesh_checks.h"
#include "parts_in_one_memory.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_cutter.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Part_completer.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_part_completer {

using namespace distributed_mesh_checks;
using parts_in_one_memory::wrong_at_parts;

/// Squares of two triangles, column by column, with all arrays but `neighbors`.
Input grid(std::size_t columns, std::size_t rows) {
  Input input{"grid", {}, {}};
  Mesh& mesh = input.mesh;
  for (std::size_t x = 0; x <= columns; ++x)
    for (std::size_t y = 0; y <= rows; ++y) {
      mesh.points.push_back(Point(double(x), double(y) / 3));
      mesh.vertex_markers.push_back(int(x * y % 5) - 1);
      mesh.input_index.push_back(x % 2 == 0 ? Vertex_index(mesh.points.size() - 1) : Vertex_index());
      mesh.segment_of_vertex.push_back(x % 2 == 0 ? Segment_index() : Segment_index(y));
    }
  for (std::size_t x = 0; x < columns; ++x)
    for (std::size_t y = 0; y < rows; ++y) {
      const Vertex_index a(x * (rows + 1) + y), b(a.value() + rows + 1), c(b.value() + 1), d(a.value() + 1);
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
      mesh.region_of_triangle.insert(mesh.region_of_triangle.end(), {int(x % 3) - 1, int(y)});
    }
  return input;
}

/// With an edge that is at no triangle, from the first vertex to the last one.
Input with_lone_edge(Input input) {
  const Vertex_index first(0), last(input.mesh.points.size() - 1);
  input.mesh.constrained_edges.push_back({{first, last}, Segment_index(0), 7, Vertex_index()});
  return input;
}

/// Of `with_all()`, the arrays that the bits tell.
Input with_some(unsigned bits) {
  static const Input all = with_all();
  Input input = all;
  input.name += " but " + std::to_string(31 - bits);
  if ((bits & 1) == 0) input.mesh.region_of_triangle.clear();
  if ((bits & 2) == 0) input.mesh.vertex_markers.clear();
  if ((bits & 4) == 0) input.mesh.input_index.clear();
  if ((bits & 8) == 0) input.mesh.neighbors.clear();
  if ((bits & 16) == 0) input.mesh.segment_of_vertex.clear();
  return input;
}

/// What remains of a part without all that others own.
Part only_own(Part part) {
  const std::size_t vertices = part.number_of_own_vertices(), triangles = part.number_of_own_triangles();
  part.foreign_vertices.clear(), part.ghost_triangles.clear();
  part.points.resize(vertices), part.triangles.resize(triangles);
  if (part.has_vertex_markers) part.vertex_markers.resize(vertices);
  if (part.has_input_index) part.input_index.resize(vertices);
  if (part.has_segment_of_vertex) part.segment_of_vertex.resize(vertices);
  if (part.has_regions) part.region_of_triangle.resize(triangles);
  return part;
}

/// What is wrong with the completed parts of a mesh.
std::string check_completion(In_memory_exchange& exchange, const Input& input) {
  const Part expected = distribute_mesh(exchange, input.mesh, input.pslg, 0);
  Part part = only_own(expected);
  complete_part(exchange, part);
  std::string wrong = Mesh_defects<In_memory_exchange, Point>(exchange, part).find();
  if (bytes_of_mesh(part) != bytes_of_mesh(expected)) wrong += "another part; ";
  return wrong;
}

TEST_CASE("parts with only what they own become those that are cut from the mesh", "[distributed]") {
  static const std::vector<Input> inputs = [] {
    std::vector<Input> list = small_inputs();
    list.push_back(grid(1, 1)), list.push_back(with_lone_edge(grid(9, 4))), list.push_back(grid(2, 40));
    list.push_back(map("syn_holes_400.poly.gz")), list.push_back(map("hard_box.poly"));
    return list;
  }();
  const int parts = GENERATE(1, 2, 3, 4, 5, 6, 7);
  for (const Input& input : inputs) {
    CAPTURE(parts, input.name);
    CHECK(wrong_at_parts(parts, [&](auto& exchange) { return check_completion(exchange, input); }) == "");
  }
}

TEST_CASE("parts are completed whatever arrays the mesh has", "[distributed]") {
  for (unsigned bits = 0; bits < 32; ++bits) {
    const Input input = with_some(bits);
    CAPTURE(input.name);
    CHECK(wrong_at_parts(3, [&](auto& exchange) { return check_completion(exchange, input); }) == "");
  }
}

template <class T>
void append(std::vector<T>& list, const std::vector<T>& other, std::size_t n) {
  list.insert(list.end(), other.begin(), other.begin() + std::ptrdiff_t(std::min(n, other.size())));
}

/// Ranks that own the vertices and the triangles of several small parts of a mesh, not the same ones. Rank i owns those
/// of the parts from `cuts[i]` to `cuts[i + 1]`.
class Other_cut {
public:
  Other_cut(const Input& input, std::size_t pieces, std::vector<std::size_t> cuts_of_vertices,
            std::vector<std::size_t> cuts_of_triangles)
      : cuts_of_vertices_(std::move(cuts_of_vertices)), cuts_of_triangles_(std::move(cuts_of_triangles)) {
    const Mesh_cutter<Point> cutter(input.mesh, input.pslg, int(pieces));
    for (std::size_t i = 0; i < pieces; ++i) pieces_.push_back(cutter.part(int(i)));
  }

  /// What a rank has on its own.
  Part part(int rank) const {
    Part part = whole();
    part.rank = rank;
    for_each_piece(cuts_of_vertices_, rank, [&](const Part& piece) {
      const std::size_t n = piece.number_of_own_vertices();
      append(part.points, piece.points, n), append(part.vertex_markers, piece.vertex_markers, n);
      append(part.input_index, piece.input_index, n);
      append(part.segment_of_vertex, piece.segment_of_vertex, n);
    });
    for_each_piece(cuts_of_triangles_, rank, [&](const Part& piece) {
      const std::size_t n = piece.number_of_own_triangles();
      append(part.triangles, piece.triangles, n), append(part.neighbors, piece.neighbors, n);
      append(part.region_of_triangle, piece.region_of_triangle, n);
      append(part.constrained_edges, piece.constrained_edges, piece.constrained_edges.size());
      append(part.outside_segments, piece.outside_segments, piece.outside_segments.size());
    });
    std::sort(part.constrained_edges.begin(), part.constrained_edges.end(),
              [](const auto& e, const auto& f) { return e.number < f.number; });
    return part;
  }

private:
  Part whole() const {
    Part part = pieces_.front();
    const auto firsts = [](const auto& first_of_pieces, const std::vector<std::size_t>& cuts) {
      std::vector<Part::Number> first;
      for (const std::size_t cut : cuts) first.push_back(first_of_pieces[cut]);
      return first;
    };
    part.first_vertex = firsts(pieces_.front().first_vertex, cuts_of_vertices_);
    part.first_triangle = firsts(pieces_.front().first_triangle, cuts_of_triangles_);
    part.foreign_vertices.clear(), part.ghost_triangles.clear();
    part.points.clear(), part.vertex_markers.clear(), part.input_index.clear(),
        part.segment_of_vertex.clear();
    part.triangles.clear(), part.region_of_triangle.clear(), part.neighbors.clear();
    part.constrained_edges.clear(), part.outside_segments.clear();
    return part;
  }
  template <class F>
  void for_each_piece(const std::vector<std::size_t>& cuts, int rank, const F& f) const {
    for (std::size_t i = cuts[std::size_t(rank)]; i < cuts[std::size_t(rank) + 1]; ++i) f(pieces_[i]);
  }

  std::vector<Part> pieces_;
  std::vector<std::size_t> cuts_of_vertices_, cuts_of_triangles_;
};

/// Numbers from 0 to n that do not fall, of which several may be the same.
std::vector<std::size_t> random_cuts(std::size_t n, int ranks, std::mt19937& random) {
  std::vector<std::size_t> cuts{0, n};
  for (int i = 1; i < ranks; ++i) cuts.push_back(random() % (n + 1));
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

TEST_CASE("parts are complete where vertices are far from their owners' triangles, or ranks own nothing",
          "[distributed]") {
  static const std::vector<Input> inputs = {fan(7), with_all(), with_lone_edge(grid(9, 4)), grid(2, 40)};
  constexpr std::size_t pieces = 6;
  std::mt19937 random(20);
  for (int trial = 0; trial < (is_full_run() ? 200 : 20); ++trial)
    for (const Input& input : inputs) {
      const int parts = 2 + int(random() % 6);
      const std::vector<std::size_t> vertices = random_cuts(pieces, parts, random),
                                     triangles = random_cuts(pieces, parts, random);
      const Other_cut cut(input, pieces, vertices, triangles);
      CAPTURE(trial, input.name, vertices, triangles);
      CHECK(wrong_at_parts(parts, [&](In_memory_exchange& exchange) {
              Part part = cut.part(exchange.rank());
              complete_part(exchange, part);
              const std::string wrong = Mesh_defects<In_memory_exchange, Point>(exchange, part).find();
              const Mesh mesh = gather_mesh(exchange, part, 0);
              const bool is_right = exchange.rank() != 0 || is_same(mesh, input.mesh);
              return is_right ? wrong : wrong + "the mesh is another one; ";
            }) == "");
    }
}

TEST_CASE("parts of a strip talk to those beside them about what lies there", "[distributed]") {
  constexpr int parts = 7;
  const std::size_t length = GENERATE(100, 1000);
  const Input input = grid(length, 2);
  const std::vector<Exchange_traffic> traffic = In_memory_exchange::run(parts, [&](auto& exchange) {
    const Mesh_cutter<Point> cutter(input.mesh, input.pslg, parts);
    Part part = only_own(cutter.part(exchange.rank()));
    complete_part(exchange, part);
  });
  for (const Exchange_traffic& of_part : traffic) {
    CHECK(of_part.messages <= 2 * of_part.exchanges);
    CHECK(of_part.bytes < 2000); // for strips of each length
    CHECK(of_part.collectives == 0);
  }
}

} // namespace test_part_completer
