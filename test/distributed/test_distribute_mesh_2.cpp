// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes distributed to parts in one memory: what parts hold fits together and is the mesh; the files of parts are
// those of pieces that one machine writes; what does not fit together is found.

#include "catch.h"
#include "distributed_mesh_checks.h"
#include "parts_in_one_memory.h"
#include "scratch_folder.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_distribute_mesh_2 {

using namespace distributed_mesh_checks;
using parts_in_one_memory::wrong_at_parts;

std::string check_all(int parts, const Input& input) {
  const Scratch_folder folder;
  const std::filesystem::path together = folder.file("together"), alone = folder.file("alone");
  std::filesystem::create_directory(together), std::filesystem::create_directory(alone);
  return wrong_at_parts(parts, [&](In_memory_exchange& exchange) {
    Part part;
    const std::string wrong = check_distribution(exchange, input, part, 1000);
    return wrong + check_files(exchange, input, part, together, alone);
  });
}

TEST_CASE("parts of a mesh fit together, are the mesh, and write its pieces", "[distributed]") {
  static const std::vector<Input> inputs = small_inputs();
  const int parts = GENERATE(1, 2, 3, 4, 7, 16);
  for (const Input& input : inputs) {
    CAPTURE(parts, input.name);
    CHECK(check_all(parts, input) == "");
  }
}

TEST_CASE("parts of a map are the map", "[distributed]") {
  static const Input input = map("syn_holes_400.poly.gz");
  const int parts = GENERATE(1, 3, is_full_run() ? 50 : 20);
  CHECK(check_all(parts, input) == "");
}

TEST_CASE("a mesh that is not in the order of places is refused by all", "[distributed]") {
  Input input = fan(7);
  std::reverse(input.mesh.triangles.begin(), input.mesh.triangles.end());
  input.mesh.triangles.back() = {Vertex_index(1), Vertex_index(2), Vertex_index(3)};
  std::swap(input.mesh.triangles.front(), input.mesh.triangles.back());
  CHECK(wrong_at_parts(3, [&](In_memory_exchange& exchange) {
          try {
            distribute_mesh(exchange, input.mesh, input.pslg, 1);
            return std::string("not refused");
          } catch (const std::invalid_argument& error) {
            const bool names_it = std::string(error.what()).find("triangle 1 ") == 0;
            return names_it ? std::string() : error.what();
          }
        }) == "");
}

TEST_CASE("fields that ranks do not share are refused by all", "[distributed]") {
  const Input input = fan(7);
  const int wrong_part = GENERATE(0, 1, 2);
  const bool has_wrong_name = GENERATE(false, true);
  const Scratch_folder folder;
  CHECK(wrong_at_parts(3, [&](In_memory_exchange& exchange) {
          const Part part = distribute_mesh(exchange, input.mesh, input.pslg, 0);
          auto fields = fields_of(part);
          if (exchange.rank() == wrong_part && has_wrong_name) fields[1].name = "others";
          if (exchange.rank() == wrong_part && !has_wrong_name) fields[1].values.push_back(1);
          try {
            write_pvtu_together(exchange, folder.file("a.pvtu"), part, fields, CGAL::IO::BINARY);
            return std::string("not refused");
          } catch (const std::invalid_argument&) {
            return std::string();
          }
        }) == "");
  CHECK(folder.number_of_files() == 0);
}

TEST_CASE("what does not fit together is found, by all parts alike", "[distributed]") {
  const Input input = with_all();
  const std::vector<std::pair<const char*, std::function<void(Part&)>>> defects = {
      {"copy", [](Part& p) { p.points.back() = Point(77, 77); }},
      {"copy", [](Part& p) { p.vertex_markers.back() += 1; }},
      {"foreign", [](Part& p) { p.foreign_vertices.back() += 1; }},
      {"ghost", [](Part& p) { std::swap(p.triangles.back()[0], p.triangles.back()[1]); }},
      {"ghost",
       [](Part& p) {
         p.triangles.pop_back(), p.ghost_triangles.pop_back(), p.region_of_triangle.pop_back();
       }},
      {"ghost", [](Part& p) { p.region_of_triangle.back() += 1; }},
      {"neighbor", [](Part& p) { std::swap(p.neighbors[0][0], p.neighbors[0][1]); }},
      {"constrained edge", [](Part& p) { p.constrained_edges.pop_back(); }},
      {"constrained edge", [](Part& p) { std::swap(p.constrained_edges[0], p.constrained_edges[1]); }},
      {"whole", [](Part& p) { p.number_of_constrained_edges += 1; }},
      {"whole", [](Part& p) { p.legend.region_names.clear(); }},
      {"length", [](Part& p) { p.vertex_markers.push_back(1); }},
      {"rank 0", [](Part& p) { p.rank = 0; }},
      {"outside", [](Part& p) { p.outside_segments.push_back(p.outside_segments[0]); }}};
  for (const auto& [word, spoil] : defects) {
    std::string first;
    const std::string wrong =
        wrong_at_parts(3, [&, &word = word, &spoil = spoil](In_memory_exchange& exchange) {
          Part part = distribute_mesh(exchange, input.mesh, input.pslg, 0);
          if (exchange.rank() == 2) spoil(part);
          const std::string defect = Mesh_defects<In_memory_exchange, Point>(exchange, part).find();
          if (exchange.rank() == 0) first = defect;
          return defect.find(word) == std::string::npos ? "not found: " + defect : std::string();
        });
    CAPTURE(word, first);
    CHECK(wrong == "");
  }
}

} // namespace test_distribute_mesh_2
