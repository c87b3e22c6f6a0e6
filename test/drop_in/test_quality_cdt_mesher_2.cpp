// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "refined_triangulation.h"

#include <CGAL/Quality_cdt_mesher_2.h>

#include <iterator>
#include <set>
#include <vector>

namespace test_quality_cdt_mesher_2 {

using namespace test_meshes;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
using Mesher = CGAL::Quality_cdt_mesher_2<Cdt, Criteria>;

namespace {

std::set<Point> points(const Cdt& cdt) {
  std::set<Point> result;
  for (Cdt::Vertex_handle v : cdt.finite_vertex_handles()) result.insert(v->point());
  return result;
}

} // namespace

TEST_CASE("the mesher of triangulations is used as Mesh_2's", "[quality_cdt_mesher_2]") {
  Pslg pslg = nested();
  pslg.holes = {Point(0.1, 0.2)};
  Cdt cdt;
  insert_graph(cdt, pslg);
  Mesher mesher(cdt);
  CHECK(mesher.get_criteria().bound() == 0.125);
  CHECK(mesher.seeds_begin() == mesher.seeds_end());
  mesher.set_seeds(pslg.holes.begin(), pslg.holes.end());
  CHECK(std::distance(mesher.seeds_begin(), mesher.seeds_end()) == 1);
  CHECK(mesher.is_refinement_done()); // as in Mesh_2: nothing is known to be bad
  SECTION("at once") {
    CHECK(mesher.refine_mesh().is_met());
    require_mesh(cdt, pslg, 20.7048);
  }
  SECTION("in steps, of which there is one") {
    mesher.init();
    CHECK(area_in_domain(cdt) == Approx(60));
    CHECK_FALSE(mesher.is_refinement_done());
    CHECK(mesher.step_by_step_refine_mesh());
    CHECK_FALSE(mesher.step_by_step_refine_mesh());
    CHECK_FALSE(mesher.try_one_step_refine_mesh());
    CHECK(number_of_bad(cdt, Criteria()) == 0);
  }
  CHECK(mesher.is_refinement_done());
  CHECK(mesher.report().is_met());
  CHECK(&mesher.triangulation() == &cdt);
}

TEST_CASE("meshing again goes on from the mesh", "[quality_cdt_mesher_2]") {
  const Pslg pslg = nested();
  Cdt cdt;
  insert_graph(cdt, pslg);
  Mesher mesher(cdt);
  mesher.refine_mesh();
  std::set<Point> before = points(cdt);
  for (const double size : {1.0, 0.4, 0.4, 0.7}) {
    mesher.set_criteria(Criteria(0.125, size));
    mesher.refine_mesh();
    CHECK(number_of_bad(cdt, mesher.get_criteria()) == 0);
    require_mesh(cdt, pslg, 20.7048);
    const std::set<Point> after = points(cdt);
    CHECK(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    before = after;
  }
  const std::size_t n = cdt.number_of_vertices();
  mesher.set_criteria(Criteria(0.125, 0.2), false);
  mesher.refine_mesh(); // knows of no bad faces
  CHECK(cdt.number_of_vertices() == n);
  const std::vector<Cdt::Face_handle> bad{cdt.finite_faces_begin()};
  mesher.set_bad_faces(bad.begin(), bad.end());
  mesher.refine_mesh();
  CHECK(cdt.number_of_vertices() > 2 * n);
  CHECK(number_of_bad(cdt, Criteria(0.125, 0.2)) == 0);
}

TEST_CASE("seeds and marks of the mesher of triangulations", "[quality_cdt_mesher_2]") {
  const std::vector<Point> seeds{Point(2, 0.1)};
  Cdt cdt;
  insert_graph(cdt, nested());
  Mesher mesher(cdt, Criteria(0.125, 0.5));
  mesher.set_seeds(seeds.begin(), seeds.end(), true, true);
  CHECK(area_in_domain(cdt) == Approx(14));
  SECTION("set") {
    mesher.refine_mesh();
    CHECK(area_in_domain(cdt) == Approx(14));
  }
  SECTION("cleared") {
    mesher.clear_seeds();
    mesher.refine_mesh();
    CHECK(area_in_domain(cdt) == Approx(64));
  }
  SECTION("marked by hand") {
    Mesher::mark_facets(cdt, seeds.begin(), seeds.end());
    CHECK(area_in_domain(cdt) == Approx(50));
    mesher.init(true);
    mesher.refine_mesh();
    CHECK(area_in_domain(cdt) == Approx(50));
  }
  CHECK(cdt.is_valid());
  CHECK(number_of_bad(cdt, mesher.get_criteria()) == 0);
}

TEST_CASE("options besides criteria", "[quality_cdt_mesher_2]") {
  const Pslg pslg = nested();
  Cdt cdt;
  insert_graph(cdt, pslg);
  Mesher mesher(cdt, Criteria(0.125, 0.8));
  mesher.set_options(CGAL::Quality_mesh_options_2().min_angle(28).max_edge(2).max_area(0.05));
  mesher.refine_mesh();
  for (Cdt::Face_handle f : cdt.finite_face_handles())
    if (f->is_in_domain()) CHECK(cdt.triangle(f).area() <= 0.05);
  CHECK(number_of_bad(cdt, mesher.get_criteria()) == 0);
  require_mesh(cdt, pslg, 20.7048);
  mesher.set_options(CGAL::Quality_mesh_options_2().progress([](double) { return false; }).max_area(1e-4));
  mesher.refine_mesh();
  CHECK(mesher.report().is_cancelled);
  CHECK(cdt.is_valid());
}

} // namespace test_quality_cdt_mesher_2
