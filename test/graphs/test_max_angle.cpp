// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The bound on the greatest angle: each triangle keeps it, or the report lists it, as is judged by exact arithmetic.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "numbers_of_threads.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"
#include "random_pslg_shapes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>

namespace test_max_angle {

using namespace test_meshes;
using Options = CGAL::Quality_mesh_options_2;
using Report = CGAL::Quality_mesh_report_2;
using Mesher = CGAL::Quality_mesher_2<>;
using Exact = CGAL::Exact_rational;

namespace {

constexpr double pi = 3.14159265358979323846;

/// Whether the angle at a of the triangle a, b, c is above the bound, an obtuse angle, of that squared cosine.
bool is_angle_above(const Point& a, const Point& b, const Point& c, const Exact& cosine2) {
  const Exact ux = Exact(b.x()) - Exact(a.x()), uy = Exact(b.y()) - Exact(a.y());
  const Exact vx = Exact(c.x()) - Exact(a.x()), vy = Exact(c.y()) - Exact(a.y());
  const Exact dot = ux * vx + uy * vy;
  return dot < 0 && dot * dot > cosine2 * (ux * ux + uy * uy) * (vx * vx + vy * vy);
}

/// The triangles with an angle above a bound in degrees.
std::set<std::size_t> wide_triangles(const Mesh& mesh, double degrees) {
  const double cosine = std::cos(degrees * pi / 180);
  const Exact cosine2 = Exact(cosine * cosine * (1 + 1e-12)); // correct to 1e-15
  std::set<std::size_t> wide;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (is_angle_above(mesh.point(mesh.triangles[t][k]), mesh.point(mesh.triangles[t][(k + 1) % 3]),
                         mesh.point(mesh.triangles[t][(k + 2) % 3]), cosine2))
        wide.insert(t);
  return wide;
}

/// Asserts all that is promised of a mesh, and that triangles reported for this bound alone are above it.
/// \returns the number of triangles that miss it and are not exempt
std::size_t check_mesh(const Pslg& pslg, const Mesh& mesh, const Report& report, const Options& options) {
  const auto quality = CGAL::mesh_quality_2(
      mesh, pslg,
      CGAL::Mesh_quality_options_2().min_angle(options.min_angle()).max_angle(options.max_angle()));
  CHECK(quality.number_of_errors == 0);
  std::set<std::size_t> exempt, unmet, unmet_for_this;
  for (const auto& t : report.exempt_triangles) exempt.insert(std::size_t(t.triangle));
  for (const auto& t : report.unmet_triangles) {
    unmet.insert(std::size_t(t.triangle));
    if (t.reason != Report::Reason::GREATEST_ANGLE) continue;
    unmet_for_this.insert(std::size_t(t.triangle));
    CHECK(t.greatest_angle > options.max_angle() * (1 - 1e-8));
    CHECK(t.least_angle >= options.min_angle() * (1 - 1e-12));
  }
  std::size_t missed = 0;
  const auto wide = wide_triangles(mesh, options.max_angle());
  for (const std::size_t t : wide) {
    CHECK(exempt.count(t) + unmet.count(t) == 1);
    missed += unmet.count(t);
  }
  // the bound is tightened by less than this
  const auto nearly_wide = wide_triangles(mesh, options.max_angle() * (1 - 1e-8));
  for (const std::size_t t : unmet_for_this) CHECK(nearly_wide.count(t) == 1);
  return missed;
}

Pslg square_with_pair() {
  Pslg pslg;
  add_polygon(pslg, {Point(-3, -3), Point(3, -3), Point(3, 3), Point(-3, 3)});
  pslg.add_vertex(Point(1, 1)), pslg.add_vertex(Point(1.01, 1.002));
  return pslg;
}

} // namespace

TEST_CASE("bounds on the greatest angle out of range are refused", "[max_angle]") {
  for (const double angle :
       {-1., 1., 90., 104.9, 180., 200., std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(Mesher(Options().max_angle(angle)), std::invalid_argument);
  CHECK_NOTHROW(Mesher(Options().max_angle(105)));
  CHECK_NOTHROW(Mesher(Options().max_angle(179)));
}

TEST_CASE("no angle of a graph without acute corners is above the bound", "[max_angle]") {
  const Pslg pslg = square_with_pair();
  CHECK_FALSE(wide_triangles(Mesher()(pslg), 120).empty()); // the option does something
  for (const double bound : {130., 120., 115.}) {
    Mesher mesher(Options().max_angle(bound));
    const Mesh mesh = mesher(pslg);
    CAPTURE(bound, mesh.triangles.size());
    CHECK(check_mesh(pslg, mesh, mesher.report(), mesher.options()) == 0);
    CHECK(mesher.report().is_met());
  }
}

TEST_CASE("a bound that all angles keep changes nothing", "[max_angle]") {
  const Pslg pslg = square_with_pair();
  CHECK(Mesher(Options().max_angle(150))(pslg).points == Mesher()(pslg).points);
}

TEST_CASE("all kinds of graphs keep the bound, or the report says where not", "[max_angle]") {
  std::size_t graphs = 0, triangles = 0, missed = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= (is_full_run() ? 20u : 2u); ++seed) {
      const Pslg pslg = family.make(seed);
      if (pslg.vertices.size() > 200) continue;
      Mesher mesher(Options().max_angle(seed % 2 == 0 ? 120 : 105).max_vertices(20000));
      const Mesh mesh = mesher(pslg);
      CAPTURE(family.name, seed, mesh.triangles.size());
      const std::size_t n = check_mesh(pslg, mesh, mesher.report(), mesher.options());
      for (const auto& t : mesher.report().unmet_triangles)
        if (!mesher.report().is_budget_exhausted) CHECK(t.reason == Report::Reason::GREATEST_ANGLE);
      ++graphs;
      if (seed % 2 == 0) triangles += mesh.triangles.size(), missed += n;
    }
  CHECK(graphs > 10);
  CHECK(missed * 50 < triangles); // at 120 degrees
}

TEST_CASE("in sharp corners the least angle goes before the greatest", "[max_angle]") {
  for (const char* const name : {"wedge_3e-14deg.poly", "syn_wedge_0.01deg.poly", "syn_wedge_1deg.poly",
                                 "syn_fan_1deg.poly", "star_of_72_spikes.poly"}) {
    Pslg pslg;
    CGAL::IO::read_triangle_poly(pslg_test::data_file(name), pslg);
    Mesher mesher(Options().max_angle(120));
    const Mesh mesh = mesher(pslg);
    CAPTURE(name, mesh.triangles.size());
    check_mesh(pslg, mesh, mesher.report(), mesher.options());
    for (const auto& t : mesher.report().unmet_triangles) CHECK(t.reason == Report::Reason::GREATEST_ANGLE);
  }
}

TEST_CASE("the greatest angle goes with all other options", "[max_angle]") {
  const Pslg pslg = square_with_pair();
  const Options all[] = {Options().keep_borders(Options::Keep_borders::BOUNDARY),
                         Options().gradation(0.3),
                         Options().max_edge_ratio(4),
                         Options().thin(1).smooth(1),
                         Options().separate(Options::Separation::THEOREM_5),
                         Options().conform(Options::Conforming::DELAUNAY),
                         Options().min_angle(30),
                         Options().min_edge(0.01),
                         Options().max_edge(0.5),
                         Options().max_vertices(20),
                         Options().coarsen(Options::Coarsening::NONE)};
  for (Options options : all) {
    Mesher mesher(options.max_angle(120));
    const Mesh mesh = mesher(pslg);
    CAPTURE(mesh.triangles.size());
    const std::size_t missed = check_mesh(pslg, mesh, mesher.report(), mesher.options());
    const bool is_free = options.max_vertices() == 0 && options.min_edge() == 0 &&
                         options.keep_borders() == Options::Keep_borders::NONE;
    if (is_free) CHECK(missed * 50 <= mesh.triangles.size());
    if (options.max_vertices() > 0) CHECK(mesh.points.size() <= options.max_vertices());
  }
}

TEST_CASE("the greatest angle gives the same bits for any number of threads", "[max_angle][parallel]") {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(pslg_test::data_file("us_states_10m.poly.gz"), pslg);
  const Options options = Options().max_angle(120);
  Mesher mesher(options);
  const Mesh mesh = mesher(pslg);
  CHECK(check_mesh(pslg, mesh, mesher.report(), options) == 0);
  for_numbers_of_threads([&] {
    CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag> parallel(options);
    const Mesh by_all = parallel(pslg);
    CHECK(by_all.points == mesh.points);
    CHECK(by_all.triangles == mesh.triangles);
  });
}

} // namespace test_max_angle
