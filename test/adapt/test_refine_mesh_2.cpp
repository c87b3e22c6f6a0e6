// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "adapt_tools.h"
#include "numbers_of_threads.h"
#include "random_pslg_shapes.h"

#include <CGAL/Mesh_sizing_field_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>
#include <CGAL/pslg_from_mesh_2.h>
#include <CGAL/refine_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace test_refine_mesh_2 {

namespace {

using namespace adapt_test;
using CGAL::Quadtree_mesh_2::Segment_index;
using pslg_test::error_of;
using pslg_test::has_text;

double least_angle(const Mesh& mesh) {
  double least = 180;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto u = mesh.point(t[(k + 1) % 3]) - mesh.point(t[k]),
                 v = mesh.point(t[(k + 2) % 3]) - mesh.point(t[k]);
      least = std::min(least, std::atan2(u.x() * v.y() - u.y() * v.x(), u * v) * 180 / CGAL_PI);
    }
  return least;
}

/// All vertices of the old mesh are in the new one; those inside of segments may be missing between the sides of sharp
/// corners.
void check_keeps_all(const CGAL::Adapted_mesh_2& made, const Mesh& old) {
  check_transfer(made, old);
  std::vector<char> is_kept(old.points.size(), 0);
  for (const Vertex_index v : made.transfer.old_vertex)
    if (v.is_valid()) is_kept[std::size_t(v)] = 1;
  std::size_t missing = 0;
  for (std::size_t v = 0; v < is_kept.size(); ++v)
    if (is_kept[v] == 0 && (old.segment_of_vertex.empty() || !old.segment_of_vertex[v].is_valid())) ++missing;
  CHECK(missing == 0);
  if (least_angle(old) >= 20.7)
    CHECK(std::count(is_kept.begin(), is_kept.end(), 1) == std::ptrdiff_t(is_kept.size()));
}

/// The given triangles with a place in them.
std::vector<std::size_t> triangles_with(const Mesh& mesh, const Point& p) {
  std::vector<std::size_t> found;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    if (CGAL::Quadtree_mesh_2::internal::Triangle_tree::has_inside_or_on(
            {mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])}, p))
      found.push_back(t);
  }
  return found;
}

} // namespace

TEST_CASE("A mesh that meets the bounds stays as it is", "[adapt]") {
  for (const auto& family : random_pslg::all_families()) {
    const Pslg pslg = family.make(1);
    if (pslg.vertices.size() > 400) continue;
    CAPTURE(family.name);
    CGAL::Quality_mesher_2<> mesher{Options()};
    const Mesh mesh = mesher(pslg);
    if (!mesher.report().is_met() || !mesher.report().exempt_triangles.empty()) continue;
    const auto made = CGAL::refine_mesh_2(mesh, pslg, Options());
    CHECK(made.mesh.points.size() == mesh.points.size());
    CHECK(made.mesh.triangles.size() == mesh.triangles.size());
    check_keeps_all(made, mesh);
    check_valid(made.mesh, pslg);
  }
}

TEST_CASE("Refined meshes meet the bounds and keep all vertices", "[adapt]") {
  for (const auto& family : random_pslg::all_families()) {
    const Pslg pslg = family.make(2);
    if (pslg.vertices.size() > 400) continue;
    CAPTURE(family.name);
    const Mesh mesh = fresh_mesh(pslg, Options().min_angle(10));
    double area_of_all = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area_of_all += area(mesh, t);
    const double largest = area_of_all / 500;
    const auto made = CGAL::refine_mesh_2(mesh, pslg, Options().max_area(largest));
    check_keeps_all(made, mesh);
    check_valid(made.mesh, pslg);
    CHECK(made.report.is_met());
    for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) CHECK(area(made.mesh, t) <= largest);
  }
}

TEST_CASE("Triangles between the sides of sharp corners are excused as before", "[adapt]") {
  for (std::uint64_t seed = 1; seed < 6; ++seed)
    for (const auto make : {random_pslg::wedge, random_pslg::star, random_pslg::fan}) {
      const Pslg pslg = make(seed);
      CAPTURE(seed, pslg.vertices.size());
      const Mesh mesh = fresh_mesh(pslg, Options());
      const auto made = CGAL::refine_mesh_2(mesh, pslg, Options());
      check_keeps_all(made, mesh);
      check_valid(made.mesh, pslg);
      CHECK(made.report.is_met());
      CHECK(quality(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7)).is_met());
      CHECK(double(made.mesh.triangles.size()) < 1.2 * double(mesh.triangles.size()) + 20);
    }
}

TEST_CASE("The area of each given triangle bounds what lies in it", "[adapt]") {
  const Pslg pslg = frame();
  const Mesh mesh = fresh_mesh(pslg, Options().max_area(0.2));
  std::vector<double> areas(mesh.triangles.size(), -1);
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (t % 3 == 0) areas[t] = area(mesh, t) / double(2 + t % 7);
    if (t % 5 == 0) areas[t] = 0; // none, either
  }
  const auto made = CGAL::refine_mesh_2(mesh, pslg, areas, Options());
  check_keeps_all(made, mesh);
  check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
  CHECK(made.report.is_met());
  CHECK(made.mesh.triangles.size() > mesh.triangles.size());
  for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) {
    const auto in = triangles_with(mesh, centroid(made.mesh, t));
    if (in.size() == 1 && areas[in.front()] > 0) CHECK(area(made.mesh, t) <= areas[in.front()]);
  }

  const std::vector<double> none(mesh.triangles.size(), -1);
  CHECK(have_same_bits(CGAL::refine_mesh_2(mesh, pslg, none, Options()).mesh,
                       CGAL::refine_mesh_2(mesh, pslg, Options()).mesh));
  // Both kinds of bounds hold.
  const auto both = CGAL::refine_mesh_2(mesh, pslg, areas, Options().max_area(0.01));
  for (std::size_t t = 0; t < both.mesh.triangles.size(); ++t) CHECK(area(both.mesh, t) <= 0.01);
}

TEST_CASE("An error indicator refines where it says so, and hardly elsewhere", "[adapt]") {
  const Pslg pslg = frame();
  const Mesh mesh = fresh_mesh(pslg, Options().max_area(0.02));
  const auto is_refused = [](const Options::Corners& t) {
    const double x = (t[0][0] + t[1][0] + t[2][0]) / 3, y = (t[0][1] + t[1][1] + t[2][1]) / 3;
    const double twice =
        (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]);
    return std::hypot(x - 0.5, y - 0.5) < 0.25 && twice > 0.0004;
  };
  const auto made = CGAL::refine_mesh_2(mesh, pslg, Options().refine_where(is_refused));
  check_keeps_all(made, mesh);
  check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
  CHECK(made.report.is_met());
  for (std::size_t v = mesh.points.size(); v < made.mesh.points.size(); ++v)
    CHECK(std::hypot(made.mesh.points[v].x() - 0.5, made.mesh.points[v].y() - 0.5) < 0.8);
  for (const auto& t : made.mesh.triangles) {
    Options::Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {made.mesh.point(t[k]).x(), made.mesh.point(t[k]).y()};
    CHECK_FALSE(is_refused(corners));
  }
}

TEST_CASE("Refined meshes have the same bits for any number of threads", "[adapt][threads]") {
  const Pslg pslg = random_pslg::polygon(5);
  const Mesh mesh = fresh_mesh(pslg, Options());
  std::vector<double> areas;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    areas.push_back(t % 2 == 0 ? area(mesh, t) / (is_full_run() ? 300 : 80) : -1);
  const auto alone = CGAL::refine_mesh_2(mesh, pslg, areas, Options());
  for_numbers_of_threads([&] {
    const auto made = CGAL::refine_mesh_2<CGAL::Parallel_tag>(mesh, pslg, areas, Options());
    CHECK(have_same_bits(made.mesh, alone.mesh));
    CHECK(made.transfer.old_vertex == alone.transfer.old_vertex);
    std::size_t different = 0;
    for (std::size_t v = 0; v < alone.transfer.places.size(); ++v)
      different += made.transfer.places[v].weights == alone.transfer.places[v].weights ? 0 : 1;
    CHECK(different == 0);
  });
}

TEST_CASE("Triangles of any origin are refined, with their regions and segments", "[adapt]") {
  // A long thin triangle above a large one, of two regions, numbered against the order of places.
  Mesh mesh;
  mesh.points = {Point(0, 10), Point(10, 10.5), Point(0, 0), Point(10, 0)};
  mesh.triangles = {{Vertex_index(0), Vertex_index(2), Vertex_index(3)},
                    {Vertex_index(0), Vertex_index(3), Vertex_index(1)}};
  CGAL::Given_mesh_details_2 details;
  details.attributes = {7, 9};
  const Pslg pslg = CGAL::pslg_from_mesh_2(mesh, details);
  const auto made = CGAL::refine_mesh_2(mesh, pslg, Options().max_area(1));
  check_keeps_all(made, mesh);
  check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7).max_area(1));
  double of_first = 0;
  for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t)
    if (pslg.regions[std::size_t(made.mesh.region_of_triangle[t])].attribute == 7)
      of_first += area(made.mesh, t);
  CHECK(of_first == Approx(50));
}

TEST_CASE("Regions, markers and segments are those of the graph", "[adapt]") {
  Pslg pslg = frame();
  pslg.add_segment(Vertex_index(0), Vertex_index(4));
  pslg.add_segment(Vertex_index(2), Vertex_index(6));
  pslg.segment_markers = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  pslg.regions.push_back({Point(3.5, 0.5), 4, 0.05});
  const Mesh mesh = fresh_mesh(pslg, Options());
  const auto made = CGAL::refine_mesh_2(mesh, pslg, Options().max_area(0.1));
  check_keeps_all(made, mesh);
  check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7).max_area(0.1));
  for (const auto& edge : made.mesh.constrained_edges)
    CHECK(edge.marker == pslg.segment_markers[std::size_t(edge.segment)]);
  CHECK(made.report.input_segments == 10);
  const auto again = CGAL::refine_mesh_2(made.mesh, pslg, Options().max_area(0.03));
  check_keeps_all(again, made.mesh);
  check_valid(again.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7).max_area(0.03));
}

TEST_CASE("Segments that get no vertices are reported by their own numbers", "[adapt]") {
  const Pslg pslg = frame();
  const Mesh mesh = fresh_mesh(pslg, Options());
  const auto made =
      CGAL::refine_mesh_2(mesh, pslg, Options().max_area(0.001).keep_borders(Options::Keep_borders::ALL));
  check_valid(made.mesh, pslg);
  CHECK_FALSE(made.report.unmet_triangles.empty());
  for (const auto& unmet : made.report.unmet_triangles)
    if (unmet.segment.is_valid()) CHECK(std::size_t(unmet.segment) < pslg.segments.size());
}

TEST_CASE("Vertices of the old mesh do not count for the bound of new ones", "[adapt]") {
  const Pslg pslg = frame();
  const Mesh mesh = fresh_mesh(pslg, Options().max_area(0.05));
  const auto made = CGAL::refine_mesh_2(mesh, pslg, Options().max_area(0.001).max_steiner_vertices(10));
  check_valid(made.mesh, pslg);
  CHECK(made.mesh.points.size() <= mesh.points.size() + 10);
  CHECK(made.report.is_budget_exhausted);
}

TEST_CASE("A mesh of another graph, or without its segments, is refused", "[adapt]") {
  const Pslg pslg = frame();
  const Mesh mesh = fresh_mesh(pslg, Options().max_area(0.2));
  const auto refusal = [&](const std::function<void(Mesh&, Pslg&)>& change) {
    Mesh other = mesh;
    Pslg graph = pslg;
    change(other, graph);
    return error_of([&] { CGAL::refine_mesh_2(other, graph, Options()); });
  };
  CHECK(refusal([](Mesh&, Pslg&) {}).empty());
  CHECK(refusal([](Mesh&, Pslg& g) { g.vertices[2] = Point(5, 5); }) ==
        "vertex 2 of the mesh is not vertex 2 of the graph");
  CHECK(refusal([](Mesh&, Pslg& g) { g.vertices.pop_back(); }) ==
        "the mesh has 8 input vertices instead of 7");
  CHECK(refusal([](Mesh& m, Pslg&) { m.region_of_triangle = {0}; }) ==
        "the mesh has 1 regions of triangles instead of " + std::to_string(mesh.triangles.size()));
  CHECK(refusal([](Mesh& m, Pslg&) { m.vertex_markers.pop_back(); }) ==
        "the mesh has " + std::to_string(mesh.points.size() - 1) + " markers of vertices instead of " +
            std::to_string(mesh.points.size()));
  CHECK(has_text(refusal([](Mesh& m, Pslg&) { m.constrained_edges.clear(); }),
                 "is on the border of the mesh, but on no segment"));
  CHECK(refusal([](Mesh& m, Pslg&) { m.constrained_edges[0].segment = Segment_index(77); }) ==
        "a constrained edge of the mesh is of segment 77, which does not exist");
  CHECK(refusal([](Mesh& m, Pslg&) {
          m.constrained_edges.push_back({{Vertex_index(0), Vertex_index(6)}, Segment_index(0)});
        }) == "1 constrained edges of the mesh are not edges of triangles");
  CHECK(has_text(refusal([](Mesh& m, Pslg&) { std::swap(m.triangles[3][0], m.triangles[3][1]); }),
                 "triangle 3 ("));
  CHECK(error_of([&] { CGAL::refine_mesh_2(mesh, pslg, std::vector<double>(3, 1), Options()); }) ==
        "there are 3 areas for " + std::to_string(mesh.triangles.size()) + " triangles");
  std::vector<double> areas(mesh.triangles.size(), 1);
  areas[2] = std::nan("");
  CHECK(error_of([&] { CGAL::refine_mesh_2(mesh, pslg, areas, Options()); }) ==
        "the area of triangle 2 is not a number");
}

TEST_CASE("A mesh that touches itself is none of its graph", "[adapt]") {
  Mesh mesh;
  mesh.points = {Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)};
  mesh.triangles = {{Vertex_index(0), Vertex_index(1), Vertex_index(2)},
                    {Vertex_index(0), Vertex_index(2), Vertex_index(3)}};
  const Pslg graph = CGAL::pslg_from_mesh_2(mesh);
  const auto refusal_of = [&graph](const Mesh& changed) {
    return error_of([&] { CGAL::refine_mesh_2(changed, graph, Options()); });
  };
  Mesh with_twins = mesh;
  with_twins.points.push_back(with_twins.points[2]);
  with_twins.triangles[1][1] = Vertex_index(4);
  CHECK(refusal_of(with_twins) == "vertices 2 and 4 of the mesh are at one place");
  Mesh with_hanging = mesh;
  with_hanging.points.emplace_back(0.5, 0.5);
  with_hanging.triangles[1] = {Vertex_index(0), Vertex_index(4), Vertex_index(3)};
  CHECK(refusal_of(with_hanging) == "triangle 0 (0 1 2) has vertex 4 in the middle of a side");
}

TEST_CASE("A component without room for a point is named by a triangle of it", "[adapt]") {
  const double next = 1 + std::numeric_limits<double>::epsilon();
  Mesh mesh;
  mesh.points = {Point(1, 1), Point(next, 1), Point(1, next)};
  mesh.triangles = {{Vertex_index(0), Vertex_index(1), Vertex_index(2)}};
  const std::string text = error_of([&] {
    const auto graph = CGAL::pslg_from_mesh_2(mesh);
    CGAL::refine_mesh_2(mesh, graph, Options().max_edge(1e-20));
  });
  CHECK(has_text(text, "the component of triangle 0 (0 1 2) of the mesh is too thin"));
}

} // namespace test_refine_mesh_2
