// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Graphs over doubles from files and families to meshes, with all that the options know; maps in blocks, on threads;
// a CGAL triangulation refined in place; and a mesh that exists refined and coarsened.

#include "end_to_end.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>
#include <CGAL/pslg_from_mesh_2.h>
#include <CGAL/refine_mesh_2.h>
#include <CGAL/refine_quality_mesh_2.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace test_end_to_end_doubles {

using namespace end_to_end;
using Traits = CGAL::Filtered_quadtree_traits_2<>;

TEST_CASE("Graphs of doubles are meshed", "[end_to_end]") {
  check_graphs<Traits>([](const Pslg& pslg) { return pslg; });
}

TEST_CASE("Graphs of doubles are meshed with each option", "[end_to_end]") {
  const Pslg pslg = mesher_test::read("syn_holes_400.poly.gz");
  check_graph<Traits>(pslg, Options().max_area(1e-3));
  check_graph<Traits>(pslg, Options().max_edge(0.1).coarsen(Options::Coarsening::NONE));
  check_graph<Traits>(pslg, Options().thin(1).smooth(1));
  check_graph<Traits>(pslg, Options().size([](double x, double y) { return 0.05 + std::hypot(x, y) / 8; }));
  check_graph<Traits>(pslg, Options().patience(0));
  using Tree_options = CGAL::Tree_separation_options_2;
  check_graph<Traits>(mesher_test::read("syn_wedge_10deg.poly"),
                      Options().separate(Tree_options::of_theorem().place(Tree_options::Placement::BY_RULE)));
}

TEST_CASE("A map is meshed in blocks", "[end_to_end][threads]") {
  const Pslg map = mesher_test::read("gshhg_aegean_h.poly.gz");
  check_graph<Traits>(map, Options());
  check_graph<Traits>(mesher_test::read("syn_square.poly"), Options().max_area(1e-5));
}

TEST_CASE("A triangulation is refined in place, end to end", "[end_to_end]") {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
      Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                                   CGAL::Delaunay_mesh_face_base_2<Kernel>>>;
  const Pslg pslg = mesher_test::read("syn_parallel_0.001.poly");
  Cdt cdt;
  for (const auto& [a, b] : pslg.segments) cdt.insert_constraint(pslg.point(a), pslg.point(b));
  const std::size_t before = cdt.number_of_vertices();
  CHECK(CGAL::refine_quality_mesh_2(cdt).is_met());
  CHECK(cdt.is_valid());
  CHECK(cdt.number_of_vertices() > before);
}

TEST_CASE("A mesh is refined, coarsened and read from triangles, end to end", "[end_to_end][threads]") {
  using Tag = CGAL::Parallel_tag;
  const Pslg pslg = mesher_test::read("syn_holes_400.poly.gz");
  const auto mesh = CGAL::Quality_mesher_2<>()(pslg);
  const std::vector<double> areas(mesh.triangles.size(), is_full_run() ? 0.02 : 0.05);
  const auto fine = CGAL::refine_mesh_2<Tag>(mesh, pslg, areas, Options());
  CHECK(fine.report.is_met());
  const auto coarse = CGAL::adapt_mesh_2<Tag>(fine.mesh, pslg, Options());
  CHECK(coarse.report.is_met());
  CHECK(coarse.mesh.triangles.size() < fine.mesh.triangles.size());
  auto given = coarse.mesh;
  CHECK(CGAL::mesh_quality_2(given, CGAL::pslg_from_mesh_2(given)).is_valid());
}

} // namespace test_end_to_end_doubles
