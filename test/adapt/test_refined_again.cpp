// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Meshes in files that are refined again and again: what meets the bounds stays as it is, and sharp corners, of which a
// file knows only edges, do not ask for more.

#include "adapt_tools.h"
#include "pslg_inputs.h"
#include "scratch_folder.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/read_triangle_mesh.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Straight_legs.h>
#include <CGAL/pslg_from_mesh_2.h>
#include <CGAL/refine_mesh_2.h>
#include <CGAL/validate_pslg_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_refined_again {

namespace {

using namespace adapt_test;

/// A mesh as it comes from a file, and its graph.
struct Read_mesh {
  Mesh mesh;
  Pslg pslg;
};

/// The mesh written as the program does it, and read again.
Read_mesh written_and_read(Mesh mesh, const Pslg& pslg) {
  const Scratch_folder folder;
  mesh.input_index.clear();
  CGAL::IO::write_triangle_files(mesh, pslg, folder.file("m"));
  Read_mesh read;
  CGAL::IO::read_triangle_mesh(folder.file("m.ele"), read.mesh, read.pslg);
  return read;
}

bool are_same(const Mesh& a, const Mesh& b) {
  return a.points.size() == b.points.size() && have_same_bits(a, b);
}

Pslg read(const std::string& name) {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(std::string(QUADTREE_MESH_TEST_DATA_DIR "/") + name, pslg);
  return pslg;
}

/// Refines three times. From the first mesh on that meets the bounds nothing changes.
/// \returns whether the given mesh, or the first one, meets them
bool check_chain(Read_mesh last, const Options& options) {
  bool is_met = false, is_first_met = false;
  for (int step = 0; step < 3; ++step) {
    CAPTURE(step);
    CGAL::Adapted_mesh_2 made;
    try {
      made = CGAL::refine_mesh_2(last.mesh, last.pslg, options);
    } catch (const CGAL::Pslg_error_2& error) {
      CAPTURE(error.what());
      CHECK_FALSE(is_met);
      // Whether edges grow too fast the checker does not know.
      if (options.gradation() == 0)
        CHECK_FALSE(
            quality(
                last.mesh, last.pslg,
                CGAL::Mesh_quality_options_2().min_angle(options.min_angle()).max_angle(options.max_angle()))
                .is_met());
      return false;
    }
    check_valid(made.mesh, last.pslg);
    const bool is_growth_bounded = options.gradation() > 0; // sharp corners are then cut anew
    if (is_met && !is_growth_bounded) CHECK(are_same(made.mesh, last.mesh));
    is_met = made.report.is_met();
    is_first_met = is_first_met || (step == 0 && is_met);
    last = written_and_read(made.mesh, last.pslg);
  }
  return is_first_met;
}

/// Two sides that meet at (0, 0) at an angle, between them a mesh in layers whose vertices are rounded.
Read_mesh wedge(double degrees, double slope) {
  const double far[] = {slope, slope + degrees * CGAL_PI / 180};
  Pslg pslg;
  pslg.add_vertex(Point(0.1, 0.1));
  for (const double angle : far) pslg.add_vertex(Point(0.1 + 3 * std::cos(angle), 0.1 + 3 * std::sin(angle)));
  for (const auto& [a, b] : {std::pair<int, int>{0, 1}, {1, 2}, {2, 0}})
    pslg.add_segment(Vertex_index(a), Vertex_index(b));
  return written_and_read(fresh_mesh(pslg, Options()), pslg);
}

/// A regular polygon with so many spokes. Its rim comes first, so that spokes are not found by luck.
Pslg wheel(int spokes) {
  Pslg pslg;
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2 * CGAL_PI * i / spokes;
    pslg.add_vertex(Point(std::cos(angle), std::sin(angle)));
  }
  const Vertex_index hub = pslg.add_vertex(Point(0, 0));
  for (int i = 0; i < spokes; ++i) pslg.add_segment(Vertex_index(i), Vertex_index((i + 1) % spokes));
  for (int i = 0; i < spokes; ++i) pslg.add_segment(hub, Vertex_index(i));
  return pslg;
}

/// A strip with so many sharp spikes on it.
Pslg saw(int spikes) {
  Pslg pslg;
  pslg.add_vertex(Point(0, 0));
  for (int i = 0; i < spikes; ++i)
    for (const auto& [x, y] : {std::pair(0.5, 0.), {0.55, 0.1}, {0.6, 0.}}) pslg.add_vertex(Point(i + x, y));
  for (const auto& [x, y] : {std::pair(spikes, 0), {spikes, -1}, {0, -1}}) pslg.add_vertex(Point(x, y));
  const auto n = pslg.vertices.size();
  for (std::size_t v = 0; v < n; ++v) pslg.add_segment(Vertex_index(v), Vertex_index((v + 1) % n));
  return pslg;
}

} // namespace

TEST_CASE("Sharp corners of a mesh from a file are excused, and the mesh stays as it is", "[adapt]") {
  for (const double degrees : {30., 5., 1., 0.3, 0.01, 1e-6})
    for (const double slope : {0.1, 0.7, 2.5, -1.}) {
      CAPTURE(degrees, slope);
      const Read_mesh given = wedge(degrees, slope);
      const auto made = CGAL::refine_mesh_2(given.mesh, given.pslg, Options());
      CHECK(are_same(made.mesh, given.mesh));
      CHECK(made.report.is_met());
      check_transfer(made, given.mesh);
      check_valid(made.mesh, given.pslg);
      CHECK(quality(made.mesh, given.pslg, CGAL::Mesh_quality_options_2().min_angle(20.7)).is_met());
    }
}

TEST_CASE("Sharp corners are excused at any scale", "[adapt]") {
  for (const double scale : {1., 0x1p510, 0x1p-550}) {
    CAPTURE(scale);
    Pslg pslg;
    for (const auto& [x, y] : {std::pair(0., 0.), {20., 2.}, {20., 0.}, {20., -1.4}, {10., 40.}, {10., -40.}})
      pslg.add_vertex(Point(scale * x, scale * y));
    for (const auto& [a, b] :
         {std::pair<int, int>{0, 1}, {0, 2}, {0, 3}, {0, 4}, {4, 1}, {1, 2}, {2, 3}, {3, 5}, {5, 0}})
      pslg.add_segment(Vertex_index(a), Vertex_index(b));
    const Options options = Options().max_edge(1.5 * scale);
    const Read_mesh given = written_and_read(fresh_mesh(pslg, options), pslg);
    const auto made = CGAL::refine_mesh_2(given.mesh, given.pslg, options);
    CHECK(made.report.is_met());
    CHECK(made.report.exempt_triangles.size() > 10);
    CHECK(are_same(made.mesh, given.mesh));
  }
}

TEST_CASE("A vertex of no triangle that is in the domain is put into the mesh", "[adapt]") {
  for (const Point& p : {Point(1, 1), Point(2, 0), Point(2, 2)}) { // inside, on the border, on an inner edge
    CAPTURE(p);
    Mesh mesh;
    mesh.points = {Point(0, 0), Point(4, 0), Point(4, 4), Point(0, 4), p};
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}})
      mesh.triangles.push_back({Vertex_index(a), Vertex_index(b), Vertex_index(c)});
    const Pslg pslg = CGAL::pslg_from_mesh_2(mesh);
    const auto made = CGAL::refine_mesh_2(mesh, pslg, Options());
    check_valid(made.mesh, pslg);
    CHECK(made.report.is_met());
    CHECK(made.mesh.triangles.size() > 2);
  }
}

TEST_CASE("A vertex of no triangle outside of the domain changes nothing, at any scale", "[adapt]") {
  for (const double scale : {1., 0x1p-540, 0x1p-900, 0x1p540, 0x1p900}) {
    CAPTURE(scale);
    for (const auto& [x, y, is_inside] :
         {std::tuple(6, 2, false), {2, 5, false}, {-1, -1, false}, {1, 2, true}}) {
      CAPTURE(x, y);
      Mesh mesh;
      for (const auto& [px, py] : {std::pair(0, 0), {4, 0}, {4, 4}, {0, 4}, {x, y}})
        mesh.points.emplace_back(scale * px, scale * py);
      for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}})
        mesh.triangles.push_back({Vertex_index(a), Vertex_index(b), Vertex_index(c)});
      const Pslg pslg = CGAL::pslg_from_mesh_2(mesh);
      const auto made = CGAL::refine_mesh_2(mesh, pslg, Options());
      CHECK(are_same(made.mesh, mesh) == !is_inside);
      CHECK(made.report.is_met());
    }
  }
}

TEST_CASE("Meshes in files whose triangles meet without common vertices are refined", "[adapt]") {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(QUADTREE_MESH_TEST_DATA_DIR)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".ele" || name.rfind("touching_", 0) != 0) continue;
    CAPTURE(name);
    ++files;
    Read_mesh given;
    CGAL::IO::read_triangle_mesh(entry.path().string(), given.mesh, given.pslg);
    check_valid(given.mesh, given.pslg);
    const auto made = CGAL::refine_mesh_2(given.mesh, given.pslg, Options());
    check_valid(made.mesh, given.pslg);
    CHECK(made.report.is_met());
    double before = 0, after = 0;
    for (std::size_t t = 0; t < given.mesh.triangles.size(); ++t) before += area(given.mesh, t);
    for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) after += area(made.mesh, t);
    CHECK(after == Approx(before).epsilon(1e-12));
    const Read_mesh again = written_and_read(made.mesh, given.pslg);
    CHECK(are_same(CGAL::refine_mesh_2(again.mesh, again.pslg, Options()).mesh, again.mesh));
  }
  CHECK(files == 8);
}

TEST_CASE("Sides of a corner within rounding of each other are straight together", "[adapt]") {
  // Rounded vertices of each side are beyond the line of the other one.
  const Pslg pslg = read("hard_legs_at_2e-63.poly");
  for (const Options& options : {Options(), Options().min_angle(30)}) {
    const Read_mesh given = written_and_read(fresh_mesh(pslg, options), pslg);
    CHECK(given.pslg.vertices.size() < given.mesh.points.size());
    const auto made = CGAL::refine_mesh_2(given.mesh, given.pslg, options);
    CHECK(are_same(made.mesh, given.mesh));
    CHECK(made.report.is_met());
    check_valid(made.mesh, given.pslg);
  }
}

TEST_CASE("Between edges without room the mesh is as it was, or has no room for more", "[adapt]") {
  const auto check = [](Read_mesh& given) {
    const auto made = CGAL::refine_mesh_2(given.mesh, given.pslg, Options());
    check_valid(made.mesh, given.pslg);
    check_transfer(made, given.mesh);
    CHECK_FALSE(made.report.is_met());
    CHECK_FALSE(made.report.is_budget_exhausted);
    for (const auto& unmet : made.report.unmet_triangles)
      CHECK(unmet.reason == CGAL::Quality_mesh_report_2::Reason::COORDINATES);
    given = written_and_read(made.mesh, given.pslg);
  };
  Pslg pslg = read("hard_overlap_on_border.poly");
  Read_mesh given = written_and_read(fresh_mesh(pslg, Options()), pslg);
  const Mesh first = given.mesh;
  for (int step = 0; step < 3; ++step) check(given);
  CHECK(are_same(given.mesh, first));
  if (!is_full_run()) return;
  pslg = read("hard_legs_units_apart_beside_gaps.poly");
  given = written_and_read(fresh_mesh(pslg, Options()), pslg);
  check(given);
  CHECK_NOTHROW(CGAL::validate_pslg_2(given.pslg)); // no side of a corner crosses another one
}

TEST_CASE("Edges that face each other across a gap with little room are named", "[adapt]") {
  Mesh mesh;
  mesh.points = {Point(0, 0), Point(1, 0), Point(1, 1e-12), Point(0, 1e-12)};
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}})
    mesh.triangles.push_back({Vertex_index(a), Vertex_index(b), Vertex_index(c)});
  const Pslg pslg = CGAL::pslg_from_mesh_2(mesh);
  try {
    CGAL::refine_mesh_2(mesh, pslg, Options());
    FAIL("no exception");
  } catch (const CGAL::Pslg_gap_error_2& error) {
    CHECK(error.kind() == CGAL::Pslg_error_2::Kind::TOO_MANY_TRIANGLES);
    CHECK(error.parts().segments.size() == 2);
  }
}

TEST_CASE("Where a mesh with sharp corners is refined, the corners stay as coarse as they were", "[adapt]") {
  for (const double degrees : {5., 1., 0.01}) {
    CAPTURE(degrees);
    const Read_mesh given = wedge(degrees, 0.7);
    const double largest = area(given.mesh, 0) / 4;
    const auto fresh = fresh_mesh(given.pslg, Options().max_area(largest));
    const auto made = CGAL::refine_mesh_2(given.mesh, given.pslg, Options().max_area(largest));
    check_transfer(made, given.mesh);
    check_valid(made.mesh, given.pslg, CGAL::Mesh_quality_options_2().min_angle(20.7).max_area(largest));
    CHECK(made.report.is_met());
    CHECK(double(made.mesh.triangles.size()) < 2 * double(fresh.triangles.size()) + 20);
    const Read_mesh again = written_and_read(made.mesh, given.pslg);
    CHECK(
        are_same(CGAL::refine_mesh_2(again.mesh, again.pslg, Options().max_area(largest)).mesh, again.mesh));
  }
}

TEST_CASE("Inner vertices of straight sides are those within rounding, and nothing ends there", "[adapt]") {
  // From the corner 0 a side with vertices 1 and 2 inside, and one that bends by far more than rounding at 5.
  Mesh mesh;
  const double ulp = 0x1p-52;
  mesh.points = {Point(1, 1),
                 Point(1.25, 1.125 + ulp / 2),
                 Point(1.5, 1.25 - ulp / 2),
                 Point(2, 1.5),
                 Point(3, 1.5),
                 Point(1.5, 1.01),
                 Point(2, 1.03)};
  const auto add = [&mesh](int a, int b, int marker) {
    mesh.constrained_edges.push_back({{Vertex_index(a), Vertex_index(b)}, {}, marker});
  };
  add(0, 1, 1), add(2, 1, 1), add(2, 3, 1), add(3, 4, 1), add(0, 5, 1), add(5, 6, 1);
  const auto inner = [&mesh](std::vector<char> may_be = {}) {
    may_be.resize(mesh.points.size(), 1);
    return CGAL::Quadtree_mesh_2::internal::Straight_legs(mesh, may_be).inner_vertices();
  };
  CHECK(inner() == std::vector<char>{0, 1, 1, 0, 0, 0, 0});
  CHECK(inner({1, 0}) == std::vector<char>{0, 0, 0, 0, 0, 0, 0});
  mesh.constrained_edges[1].marker = 2;
  CHECK(inner() == std::vector<char>{0, 0, 0, 0, 0, 0, 0});
  mesh.constrained_edges[1].marker = 1;
  add(2, 6, 1);
  CHECK(inner() == std::vector<char>{0, 1, 0, 0, 0, 0, 0});
  mesh.constrained_edges.pop_back();
  mesh.points[2] = Point(1.5, 1.25 - 16 * ulp);
  CHECK(inner()[1] == 0);
  mesh.constrained_edges.erase(mesh.constrained_edges.begin() + 4); // no corner
  mesh.points[2] = Point(1.5, 1.25);
  CHECK(inner() == std::vector<char>(7, 0));
}

TEST_CASE("A side is not straight where a vertex next to one inside of it is beyond the line", "[adapt]") {
  const double ulp = 0x1p-52;
  for (const bool is_beyond : {false, true}) {
    CAPTURE(is_beyond);
    Mesh mesh;
    // From the corner 0 a side over 1 to 2; below 1 are 3, 4 and 5; from the corner another side to 6.
    mesh.points = {Point(1, 1),
                   Point(1.25, 1.125 + ulp),
                   Point(2, 1.5),
                   Point(1.2, 1.05),
                   Point(1.25, is_beyond ? 1.125 : 1.125 - ulp),
                   Point(1.4, 1.125),
                   Point(2, 1.03)};
    for (const auto& [a, b, c] : {std::array{0, 3, 1}, {3, 4, 1}, {4, 5, 1}, {5, 2, 1}})
      mesh.triangles.push_back({Vertex_index(a), Vertex_index(b), Vertex_index(c)});
    for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {0, 6}})
      mesh.constrained_edges.push_back({{Vertex_index(a), Vertex_index(b)}, {}, 0});
    CHECK(CGAL::Quadtree_mesh_2::internal::Straight_legs(mesh, std::vector<char>(7, 1)).inner_vertices()[1] ==
          (is_beyond ? 0 : 1));
  }
}

TEST_CASE("A mesh in a file with huge degrees or many corners is refined again in no quadratic time",
          "[adapt]") {
  const std::string name = GENERATE(as<std::string>(), "wheel", "fan", "saw");
  CAPTURE(name);
  const Pslg pslg = name == "wheel" ? wheel(is_full_run() ? 200000 : 2000)
                    : name == "saw" ? saw(is_full_run() ? 30000 : 1000)
                                    : pslg_inputs::by_name(is_full_run() ? "fan:0.0018" : "fan:0.15").pslg;
  const Read_mesh made = written_and_read(fresh_mesh(pslg, Options()), pslg);
  const auto again = CGAL::refine_mesh_2(made.mesh, made.pslg, Options());
  CHECK(again.report.is_met());
  CHECK(are_same(again.mesh, made.mesh));
}

TEST_CASE("Refining a mesh in a file twice changes nothing", "[adapt]") {
  const std::vector<Options> all{Options(), Options().min_angle(30),
                                 Options().conform(Options::Conforming::DELAUNAY), Options().max_angle(120),
                                 Options().gradation(0.3)};
  std::size_t chains = 0, met = 0;
  for (const auto& entry : std::filesystem::directory_iterator(QUADTREE_MESH_TEST_DATA_DIR)) {
    if (entry.path().extension() != ".poly") continue;
    const std::string name = entry.path().filename().string();
    const Pslg pslg = read(name);
    // A graph for exact numbers: over doubles a vertex on one of its segments passes another vertex over.
    if (name == "hard_exact_rounding.poly" || pslg.vertices.size() > (is_full_run() ? 1000 : 20)) continue;
    for (std::size_t i = 0; i < (is_full_run() ? all.size() : 1 + chains % 2 * 4); ++i) {
      const Options options = Options(all[i]).max_vertices(is_full_run() ? 100000 : 2000);
      Read_mesh last;
      try {
        const Mesh mesh = fresh_mesh(pslg, options);
        if (mesh.triangles.size() > (is_full_run() ? 100000 : 400)) continue;
        last = written_and_read(mesh, pslg);
      } catch (const CGAL::Pslg_error_2&) {
        continue; // of bad input, which other tests are about
      }
      ++chains;
      CAPTURE(name, i);
      met += check_chain(std::move(last), options) ? 1 : 0;
    }
  }
  CHECK(chains > 30);
  CHECK(met > chains / 2);
}

} // namespace test_refined_again
