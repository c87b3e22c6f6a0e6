// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Meshes by quadtrees over words and over exact coordinates.

#include "catch.h"
#include "island_graphs.h"
#include "meshers_in_words32.h"
#include "theorem_5_tools.h"

#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace test_theorem_5_traits {

namespace {

using namespace theorem_5_test;
using Exact_traits = CGAL::Exact_quadtree_traits_2<>;

/// Meshes by quadtrees, and checks the mesh.
/// \returns the report
template <class Traits>
CGAL::Quality_mesh_report_2 check_mesh(const CGAL::Pslg_2<typename Traits::Point_2>& pslg,
                                       const Options& options = by_quadtrees()) {
  CGAL::Quality_mesher_2<Traits> mesher(options);
  const auto mesh = mesher(pslg);
  CHECK(mesher.report().is_met());
  CHECK(mesher.report().trees.rounds > 0);
  CHECK(mesher.report().trees.missed == 0);
  const auto quality = CGAL::mesh_quality_2(mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
  for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(quality.unmet_triangles.empty());
  CHECK(quality.exempt_triangles == mesher.report().exempt_triangles.size());
  return mesher.report();
}

/// The same without patience, where one of several components is to be made by quadtrees.
template <class Traits>
void check_islands(const CGAL::Pslg_2<typename Traits::Point_2>& pslg) {
  CHECK(check_mesh<Traits>(pslg, Options().patience(0)).trees.islands == 1);
}

/// The graph with its coordinates times 3/4: doubles have the lattices of that exactly, so that the checker sees
/// vertices of segments on them.
CGAL::Pslg_2<Exact_traits::Point_2> three_quarters_of(const Pslg& pslg) {
  using FT = CGAL::Epeck::FT;
  const auto map = [](const auto& p) {
    const Exact_traits::Point_2 q(3 * FT(p.x()) / 4, 3 * FT(p.y()) / 4);
    CGAL::exact(q); // the arithmetic is done here, not in the mesher
    return q;
  };
  CGAL::Pslg_2<Exact_traits::Point_2> result;
  for (const auto& p : pslg.vertices) result.add_vertex(map(p));
  for (const auto& p : pslg.holes) result.holes.push_back(map(p));
  result.segments = pslg.segments;
  return result;
}

/// The graph as it is, in exact numbers.
CGAL::Pslg_2<Exact_traits::Point_2> exactly(const Pslg& pslg) {
  CGAL::Pslg_2<Exact_traits::Point_2> result;
  for (const auto& p : pslg.vertices) result.add_vertex({p.x(), p.y()});
  result.segments = pslg.segments;
  return result;
}

/// The doubled area of a mesh, exactly; each triangle is counterclockwise.
CGAL::Epeck::FT area2_of(const CGAL::Indexed_mesh_2<Exact_traits::Point_2>& mesh) {
  CGAL::Epeck::FT sum(0);
  for (const auto& t : mesh.triangles) {
    const auto area = CGAL::area(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
    CHECK(area > 0);
    sum += 2 * area;
    CGAL::exact(sum); // no history
  }
  return sum;
}

/// How many triangles have an angle below 20.7 degrees, by exact numbers.
std::size_t number_of_sharp(const CGAL::Indexed_mesh_2<Exact_traits::Point_2>& mesh) {
  const double sine = std::sin(20.7 * 3.14159265358979 / 180);
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
        const auto &p = mesh.point(t[0]), &q = mesh.point(t[1]), &r = mesh.point(t[2]);
        std::array<CGAL::Epeck::FT, 3> l{CGAL::squared_distance(p, q), CGAL::squared_distance(q, r),
                                         CGAL::squared_distance(r, p)};
        std::sort(l.begin(), l.end());
        const CGAL::Epeck::FT area2 = 2 * CGAL::area(p, q, r);
        return area2 * area2 < sine * sine * l[1] * l[2];
      }));
}

/// Meshes by quadtrees, and checks the mesh by exact numbers: the checker judges doubles.
void check_mesh_exactly(const CGAL::Pslg_2<Exact_traits::Point_2>& pslg) {
  CGAL::Quality_mesher_2<Exact_traits> mesher(by_quadtrees()), on_demand;
  const auto mesh = mesher(pslg);
  CHECK(mesher.report().is_met());
  // The grid tells vertices apart, not what is nearer to each other than these: that is left to refinement.
  const auto& trees = mesher.report().trees;
  CHECK((trees.end == End::DONE || trees.end == End::COORDINATES));
  CHECK(trees.missed == trees.handed_over);
  CHECK(trees.rounds < 10);
  CHECK(number_of_sharp(mesh) == mesher.report().exempt_triangles.size());
  CHECK(area2_of(mesh) == area2_of(on_demand(pslg)));
}

/// A box with a vertex at a distance from the middle of an edge.
CGAL::Pslg_2<Exact_traits::Point_2> vertex_beside_middle(int exponent) {
  CGAL::Pslg_2<Exact_traits::Point_2> result = exactly(pslg_test::unit_square());
  const CGAL::Epeck::FT distance(std::ldexp(1.0, exponent));
  const auto a = result.add_vertex({CGAL::Epeck::FT(1) / 4, CGAL::Epeck::FT(1) / 8}),
             b = result.add_vertex({CGAL::Epeck::FT(3) / 4, CGAL::Epeck::FT(5) / 8});
  result.add_segment(a, b);
  result.add_vertex({CGAL::Epeck::FT(1) / 2, CGAL::Epeck::FT(3) / 8 + distance});
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("Integers are meshed by quadtrees", "[mesher][theorem5]", std::uint32_t, std::uint64_t) {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<TestType>;
  const std::string name =
      GENERATE(as<std::string>(), "syn_holes_400.poly.gz", "syn_wedge_1deg.poly", "syn_comb.poly");
  CAPTURE(name);
  const Pslg pslg = read(name);
  const auto scale = CGAL::Fixed_point_scale_2<TestType>::of_points(pslg.vertices);
  CGAL::Pslg_2<typename Traits::Point_2> fixed;
  for (const auto& p : pslg.vertices) fixed.vertices.push_back(scale.to_fixed(p.x(), p.y()));
  for (const auto& p : pslg.holes) fixed.holes.push_back(scale.to_fixed(p.x(), p.y()));
  fixed.segments = pslg.segments;
  check_mesh<Traits>(fixed);
  if (name == "syn_wedge_1deg.poly")
    check_mesh<Traits>(
        fixed, Options().separate(Tree_options::of_theorem().place(Tree_options::Placement::BY_RULE)));
}

TEST_CASE("Integers beside a gap outside are meshed by quadtrees, which come to an end",
          "[mesher][theorem5]") {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
  const Pslg pslg = read("hard_gap_outside_for_rounds.poly");
  const auto scale = CGAL::Fixed_point_scale_2<std::uint64_t>::of_points(pslg.vertices);
  CGAL::Pslg_2<Traits::Point_2> fixed;
  for (const auto& p : pslg.vertices) fixed.vertices.push_back(scale.to_fixed(p.x(), p.y()));
  fixed.segments = pslg.segments;
  CGAL::Quality_mesher_2<Traits> mesher(by_quadtrees());
  CHECK(mesher(fixed).triangles.size() == 3);
  CHECK(mesher.report().trees.end == End::DONE); // the gap does not count
  CHECK(mesher.report().is_met());
}

TEST_CASE("Rational graphs are meshed by quadtrees", "[mesher][theorem5][exact]") {
  for (const std::string name : {"syn_square.poly", "syn_sliver_1deg.poly", "syn_near_1e-06.poly",
                                 "syn_near_1e-12.poly", "syn_wedge_0.01deg.poly", "syn_wedge_10deg.poly",
                                 "hard_lattice_21260.poly", "hard_visibility_graph_2608.poly"}) {
    CAPTURE(name);
    check_mesh<Exact_traits>(three_quarters_of(read(name)));
  }
}

TEST_CASE("Islands of rational graphs and of integers are made by quadtrees", "[mesher][theorem5][exact]") {
  Pslg pslg;
  island_graphs::add_square(pslg, 0, 0, 1);
  island_graphs::add_comb(pslg, 2, 0, 4, 0.25);
  check_islands<Exact_traits>(three_quarters_of(pslg));
  using Word_traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
  const auto scale = CGAL::Fixed_point_scale_2<std::uint64_t>::of_points(pslg.vertices);
  CGAL::Pslg_2<Word_traits::Point_2> fixed;
  for (const auto& p : pslg.vertices) fixed.vertices.push_back(scale.to_fixed(p.x(), p.y()));
  fixed.segments = pslg.segments;
  check_islands<Word_traits>(fixed);
}

TEST_CASE("Rational graphs are meshed by rule alone", "[mesher][theorem5][exact]") {
  for (const std::string name : {"syn_square.poly", "syn_wedge_10deg.poly"}) {
    CAPTURE(name);
    check_mesh<Exact_traits>(
        three_quarters_of(read(name)),
        Options().separate(Tree_options::of_theorem().place(Tree_options::Placement::BY_RULE)));
  }
}

TEST_CASE("Rational random graphs are meshed by quadtrees", "[mesher][theorem5][exact]") {
  const std::uint64_t seeds = is_full_run() ? 50 : 1;
  for (const random_pslg::Family& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Pslg pslg = family.make(seed);
      if (pslg.number_of_vertices() > (is_full_run() ? 150u : 50u)) continue;
      CAPTURE(family.name, seed);
      check_mesh<Exact_traits>(three_quarters_of(pslg));
    }
}

TEST_CASE("Vertices as near as may be to the middle of an edge are meshed by quadtrees",
          "[mesher][theorem5][exact]") {
  for (const int exponent : {-20, -50, -60, -90}) {
    CAPTURE(exponent);
    check_mesh_exactly(vertex_beside_middle(exponent));
  }
}

TEST_CASE("Leaves far below the length of the edges that pass them end", "[mesher][theorem5][exact]") {
  for (const std::string name : {"hard_legs_in_one_strip.poly", "hard_lattice_of_all_edges.poly"}) {
    CAPTURE(name);
    check_mesh_exactly(exactly(read(name)));
  }
}

} // namespace test_theorem_5_traits
