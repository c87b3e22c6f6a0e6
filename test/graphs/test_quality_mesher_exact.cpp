// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes of graphs with exact coordinates: what is said about every mesh, decided in the kernel's exact numbers.

#include "catch.h"
#include "mesher_test_tools.h"
#include "random_pslg_shapes.h"
#include "tiny_blocks.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/indexed_mesh_to_triangulation_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace test_quality_mesher_exact {

namespace {

using mesher_test::Options;
using mesher_test::read;
using mesher_test::run_to_the_bound;
using pslg_test::error_of;
using pslg_test::has_text;
using pslg_test::Vertex_index;

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using FT = Exact::FT;
using Field = CGAL::Exact_rational;
using Exact_point = Exact::Point_2;
using Exact_pslg = CGAL::Pslg_2<Exact_point>;
using Exact_mesh = CGAL::Indexed_mesh_2<Exact_point>;
template <class Tag>
using Exact_mesher = CGAL::Quality_mesher_2<CGAL::Exact_quadtree_traits_2<>, Tag>;

struct Exact_run {
  Exact_mesh mesh;
  CGAL::Quality_mesh_report_2 report;
};

FT power_of_two(int k) { return FT(CGAL::Quadtree_mesh_2::internal::power_of_two<CGAL::Exact_rational>(k)); }

/// The graph with every point p at scale p + shift.
template <class Pslg>
Exact_pslg to_exact(const Pslg& pslg, const FT& scale = 1, const FT& shift = 0) {
  const auto map = [&](const auto& p) {
    const Exact_point q(FT(p.x()) * scale + shift, FT(p.y()) * scale + shift);
    CGAL::exact(q); // the arithmetic is done here, not in the mesher
    return q;
  };
  Exact_pslg result;
  for (const auto& p : pslg.vertices) result.add_vertex(map(p));
  result.segments = pslg.segments;
  for (const auto& p : pslg.holes) result.holes.push_back(map(p));
  for (const auto& r : pslg.regions) result.regions.push_back({map(r.point), r.attribute, r.max_area});
  return result;
}

Exact_pslg unit_square() { return to_exact(pslg_test::unit_square()); }

void add_segment(Exact_pslg& pslg, std::size_t a, std::size_t b) {
  pslg.add_segment(Vertex_index(a), Vertex_index(b));
}

FT doubled_area(const Exact_mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return 2 * CGAL::area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
}

/// Summed in numbers that are not lazy: a sum of many of those is an expression as deep.
FT area(const Exact_mesh& mesh) {
  Field sum(0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum += CGAL::exact(doubled_area(mesh, t));
  return FT(Field(sum / 2));
}

/// The squared sine of the least angle of a triangle, exactly.
FT sin2_of_least_angle(const Exact_mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  std::array<FT, 3> l;
  for (std::size_t k = 0; k < 3; ++k)
    l[k] = CGAL::squared_distance(mesh.point(v[(k + 1) % 3]), mesh.point(v[(k + 2) % 3]));
  std::sort(l.begin(), l.end());
  const FT d = doubled_area(mesh, t);
  return FT(CGAL::exact(d * d / (l[1] * l[2])));
}

bool is_on_segment(const Exact_pslg& pslg, pslg_test::Segment_index s, const Exact_point& p) {
  const auto& ends = pslg.segments[std::size_t(s)];
  return CGAL::collinear_are_ordered_along_line(pslg.point(ends[0]), p, pslg.point(ends[1]));
}

/// No loops with a CHECK for each vertex: there are many.
void check_input_is_kept(const Exact_mesh& mesh, const Exact_pslg& pslg) {
  CHECK(std::equal(pslg.vertices.begin(), pslg.vertices.end(), mesh.points.begin()));
  std::size_t beside = 0;
  for (std::size_t v = pslg.number_of_vertices(); v < mesh.points.size(); ++v)
    if (mesh.segment_of_vertex[v].is_valid() &&
        !is_on_segment(pslg, mesh.segment_of_vertex[v], mesh.points[v]))
      ++beside;
  for (const auto& e : mesh.constrained_edges)
    for (const Vertex_index v : e.vertices)
      if (!is_on_segment(pslg, e.segment, mesh.point(v))) ++beside;
  CHECK(beside == 0);
}

void check_angles(const Exact_run& run, double degrees) {
  const double sine = std::sin(degrees * CGAL_PI / 180);
  std::vector<char> is_exempt(run.mesh.triangles.size(), 0);
  for (const auto& e : run.report.exempt_triangles) is_exempt[std::size_t(e.triangle)] = 1;
  std::size_t clockwise = 0, sharp = 0;
  for (std::size_t t = 0; t < run.mesh.triangles.size(); ++t)
    if (doubled_area(run.mesh, t) <= 0)
      ++clockwise;
    else if (is_exempt[t] == 0 && sin2_of_least_angle(run.mesh, t) < FT(sine * sine))
      ++sharp;
  CHECK(clockwise == 0);
  CHECK(sharp == 0);
}

void check_triangulation(const Exact_mesh& mesh, const Exact_pslg& pslg) {
  using Tds = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Exact>,
                                                   CGAL::Delaunay_mesh_face_base_2<Exact>>;
  CGAL::Constrained_Delaunay_triangulation_2<Exact, Tds> cdt;
  CGAL::indexed_mesh_to_constrained_Delaunay_triangulation_2(mesh, pslg, cdt);
  CHECK(cdt.is_valid());
}

/// Meshes, and checks what must hold for every mesh.
template <class Tag = CGAL::Sequential_tag>
Exact_run run_exactly(const Exact_pslg& pslg, const Options& options = Options()) {
  Exact_mesher<Tag> mesher(options);
  Exact_run r;
  r.mesh = mesher(pslg);
  r.report = mesher.report();
  CHECK(r.report.is_met());
  check_input_is_kept(r.mesh, pslg);
  check_angles(r, options.min_angle());
  check_triangulation(r.mesh, pslg);
  return r;
}

/// The square, and a vertex in the middle of its first quarter with another one near it.
Exact_pslg two_vertices_apart(const FT& distance) {
  Exact_pslg pslg = unit_square();
  pslg.add_vertex(Exact_point(FT(1) / 3, FT(1) / 3));
  pslg.add_vertex(Exact_point(FT(1) / 3 + distance, FT(1) / 3));
  return pslg;
}

} // namespace

TEST_CASE("meshes of rational graphs are exact", "[mesher][exact]") {
  // a house with a hole, on a grid of 1/21
  Exact_pslg pslg;
  const auto add = [&](int x, int y) { pslg.add_vertex(Exact_point(FT(x) / 21, FT(y) / 21)); };
  add(1, 2), add(20, 1), add(19, 13), add(10, 20), add(2, 13);
  add(9, 8), add(11, 8), add(10, 10);
  for (const auto& [a, b] : std::vector<std::array<std::size_t, 2>>{
           {0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {5, 6}, {6, 7}, {7, 5}})
    add_segment(pslg, a, b);
  const Exact_pslg whole = pslg;
  pslg.holes.push_back(Exact_point(FT(10) / 21, FT(9) / 21));
  const FT hole = FT(2) / (21 * 21);
  for (const double angle : {0., 20.7, 30.}) {
    const Options options = Options().min_angle(angle).max_edge(is_full_run() ? 0.05 : 0.08);
    const FT area_of_whole = area(run_exactly(whole, options).mesh);
    CHECK(area(run_exactly(pslg, options).mesh) == area_of_whole - hole);
  }
}

namespace {

void mesh_vertices_apart(std::initializer_list<int> logarithms) {
  for (const int k : logarithms) {
    CAPTURE(k);
    CHECK(area(run_exactly(two_vertices_apart(power_of_two(-k))).mesh) == 1);
    Exact_pslg next_to_side = unit_square();
    next_to_side.add_vertex(Exact_point(FT(1) / 3, power_of_two(-k)));
    CHECK(area(run_exactly(next_to_side).mesh) == 1);
    Exact_pslg next_to_diagonal = unit_square();
    add_segment(next_to_diagonal, 0, 2);
    next_to_diagonal.add_vertex(Exact_point(FT(2) / 5, FT(2) / 5 + power_of_two(-k)));
    CHECK(area(run_exactly(next_to_diagonal).mesh) == 1);
    Exact_pslg short_leg = two_vertices_apart(power_of_two(-k));
    add_segment(short_leg, 4, 5);
    add_segment(short_leg, 4, 2);
    add_segment(short_leg, 1, 4);
    CHECK(area(run_exactly(short_leg).mesh) == 1);
  }
}

} // namespace

TEST_CASE("vertices at exact distances", "[mesher][exact]") {
  mesh_vertices_apart({20, 125});
  if (is_full_run()) mesh_vertices_apart({60, 400});
  // beyond the range of doubles
  CHECK(area(run_exactly(two_vertices_apart(power_of_two(-1200))).mesh) == 1);
  run_exactly(two_vertices_apart(FT(1) / FT(1e30)));
}

TEST_CASE("vertices at exact distances far below the range of doubles", "[mesher][exact][.slow]") {
  mesh_vertices_apart({899, 2000});
  CHECK(area(run_exactly(two_vertices_apart(power_of_two(-5000))).mesh) == 1);
}

TEST_CASE("quadtrees refuse distances beyond doubles, with the input's vertices", "[mesher][exact]") {
  const Options options = Options().separate(Options::Separation::THEOREM_5);
  const std::string error = error_of([&] { run_exactly(two_vertices_apart(power_of_two(-130)), options); });
  CHECK(has_text(error, "vertex 4"));
  CHECK(has_text(error, "vertex 5"));
}

TEST_CASE("A graph of few vertices that asks for too many exact numbers is refused before it is meshed",
          "[mesher][exact]") {
  // Half as many as over doubles: they take more than twice the memory, and more time.
  const Exact_pslg legs = to_exact(read("hard_rosette_of_legs.poly"));
  const std::string error = error_of([&] { run_exactly(legs, Options().max_edge(0.0667)); });
  CHECK(has_text(error, "a graph of fewer than 1000 vertices is allowed 10"));
  CHECK(has_text(error, "meet at an angle of 2.09"));
}

TEST_CASE("Bounds of size whose squares doubles do not have are refused for exact numbers, too",
          "[mesher][exact]") {
  // areas of some of the triangles are no doubles, either
  const Exact_pslg pslg = to_exact(read("subnormal_beside_segment.poly"));
  const std::string error = error_of([&] { run_exactly(pslg, Options().max_edge(1e-200)); });
  CHECK(has_text(error, "for the bounds of size"));
}

namespace {

void mesh_spiral_to(int depth) {
  const int n = depth / 8; // vertices, each nearer to the middle by 2^8
  Exact_pslg pslg;
  for (int i = 0; i <= n; ++i) {
    const double turn = 0.8 * i;
    pslg.add_vertex(
        Exact_point(FT(std::cos(turn)) * power_of_two(-8 * i), FT(std::sin(turn)) * power_of_two(-8 * i)));
    if (i > 0) add_segment(pslg, std::size_t(i) - 1, std::size_t(i));
  }
  const std::size_t box = pslg.number_of_vertices();
  for (const auto& [x, y] : std::vector<std::array<int, 2>>{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}})
    pslg.add_vertex(Exact_point(x, y));
  for (std::size_t i = 0; i < 4; ++i) add_segment(pslg, box + i, box + (i + 1) % 4);
  CHECK(area(run_exactly(pslg).mesh) == 16);
}

} // namespace

TEST_CASE("A spiral to 2^-899 is meshed exactly", "[mesher][exact]") { mesh_spiral_to(899); }

TEST_CASE("A spiral to 2^-5000 is meshed exactly", "[mesher][exact][.slow]") { mesh_spiral_to(5000); }

TEST_CASE("corners of any sharpness leave valid meshes, and those that doubles can match are excused",
          "[mesher][exact]") {
  for (const int k : is_full_run() ? std::vector<int>{20, 40, 60, 200, 400} : std::vector<int>{20, 40, 200}) {
    CAPTURE(k);
    Exact_pslg pslg = unit_square();
    pslg.add_vertex(Exact_point(FT(1) / 3, FT(1) / 3));
    pslg.add_vertex(Exact_point(FT(2) / 3, FT(2) / 3));
    pslg.add_vertex(Exact_point(FT(2) / 3, FT(2) / 3 + power_of_two(-k)));
    add_segment(pslg, 4, 5);
    add_segment(pslg, 4, 6);
    Exact_mesher<CGAL::Sequential_tag> mesher;
    const Exact_run r{mesher(pslg), mesher.report()};
    check_input_is_kept(r.mesh, pslg);
    check_triangulation(r.mesh, pslg);
    CHECK(area(r.mesh) == 1);
    std::size_t clockwise = 0;
    for (std::size_t t = 0; t < r.mesh.triangles.size(); ++t)
      clockwise += doubled_area(r.mesh, t) <= 0 ? 1 : 0;
    CHECK(clockwise == 0);
    for (const auto& e : r.report.exempt_triangles) CHECK(e.corner == Vertex_index(4));
    if (k > 40) continue; // shells on the legs match to a share of 2^-50
    CHECK(r.report.is_met());
    check_angles(r, 20.7);
  }
}

TEST_CASE("vertices that are nearly or truly on segments and at one place", "[mesher][exact]") {
  Exact_pslg pslg = to_exact(pslg_test::unit_square(), FT(1) / 3);
  for (int i = 0; i < 3; ++i) pslg.add_vertex(Exact_point(FT(1) / 7, 0)); // on the first side, three times
  pslg.add_vertex(Exact_point(FT(1) / 9, FT(1) / 9));                     // on the diagonal
  pslg.add_vertex(Exact_point(FT(1) / 9, FT(1) / 9 + power_of_two(-90))); // not quite
  add_segment(pslg, 0, 2);
  add_segment(pslg, 2, 7); // overlaps it
  const Exact_run r = run_exactly(pslg);
  CHECK(area(r.mesh) == FT(1) / 9);
  CHECK(r.report.merged_vertices == 2);
  CHECK(r.report.vertices_on_segments >= 2);
}

TEST_CASE("an exact mesh does not depend on the unit, nor on where 0 is", "[mesher][exact]") {
  const Exact_pslg pslg = two_vertices_apart(power_of_two(-70));
  const Exact_mesh mesh = run_exactly(pslg).mesh;
  for (const int k :
       is_full_run() ? std::vector<int>{-3000, -700, 5, 700, 3000} : std::vector<int>{-700, 5, 3000}) {
    CAPTURE(k);
    const Exact_mesh scaled = run_exactly(to_exact(pslg, power_of_two(k))).mesh;
    CHECK(scaled.triangles == mesh.triangles);
    std::size_t different = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (scaled.points[v].x() != mesh.points[v].x() * power_of_two(k) ||
          scaled.points[v].y() != mesh.points[v].y() * power_of_two(k))
        ++different;
    CHECK(different == 0);
  }
  const std::size_t triangles = run_exactly(pslg, Options().max_edge(0.3)).mesh.triangles.size();
  for (const int k : is_full_run() ? std::vector<int>{-1000, -900, 900, 1000}
                                   : std::vector<int>{-1000, 900}) { // bounds of size are of the same unit
    CAPTURE(k);
    const Options options = Options().max_edge(std::ldexp(0.3, k));
    CHECK(run_exactly(to_exact(pslg, power_of_two(k)), options).mesh.triangles.size() == triangles);
  }
  CHECK(area(run_exactly(to_exact(pslg, 1, power_of_two(3000) / 7)).mesh) == 1);
  CHECK(area(run_exactly(to_exact(pslg, 1, -power_of_two(21))).mesh) == 1);
}

TEST_CASE("exact meshes are as small as those of doubles", "[mesher][exact]") {
  // One small mesh may have a fifth more or fewer, by the order in which its vertices come.
  double of_doubles = 0, of_exact = 0;
  for (const std::string name :
       {"syn_square.poly", "syn_sliver_1deg.poly", "syn_near_1e-06.poly", "syn_near_1e-12.poly",
        "syn_parallel_0.001.poly", "syn_wedge_0.01deg.poly", "syn_wedge_10deg.poly", "syn_wedge_1deg.poly",
        "syn_comb.poly", "syn_fan_1deg.poly", "hard_lattice_21260.poly", "hard_visibility_graph_11091.poly",
        "hard_visibility_graph_2608.poly", "hard_visibility_graph_3314.poly",
        "hard_visibility_graph_8327.poly", "hard_visibility_graph_8360.poly",
        "hard_visibility_graph_9113.poly"}) {
    CAPTURE(name);
    const auto pslg = read(name);
    const auto triangles = double(run_to_the_bound(pslg, Options()).mesh.triangles.size());
    of_doubles += triangles;
    const Exact_run same = run_exactly(to_exact(pslg)), third = run_exactly(to_exact(pslg, FT(1) / 3));
    of_exact += double(same.mesh.triangles.size() + third.mesh.triangles.size()) / 2;
    const CGAL::Mesh_quality_2 quality =
        CGAL::mesh_quality_2(same.mesh, to_exact(pslg), CGAL::Mesh_quality_options_2().min_angle(20.7));
    CHECK(quality.is_valid());
    CHECK(quality.unmet_triangles.empty());
    CHECK(quality.exempt_triangles == same.report.exempt_triangles.size());
  }
  CHECK(of_exact <= 1.03 * of_doubles);
}

TEST_CASE("exact meshes of random graphs", "[mesher][exact]") {
  const std::uint64_t seeds = is_full_run() ? 200 : 1;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      CAPTURE(family.name, seed);
      const Exact_pslg pslg = to_exact(family.make(seed), FT(1) / 3);
      const Exact_mesh mesh = run_exactly(pslg).mesh;
      // in blocks, whose seams are anywhere
      run_exactly<Tiny_blocks_tag>(pslg);
      CHECK(Exact_mesher<CGAL::Sequential_tag>()(pslg).points == mesh.points);
    }
}

TEST_CASE("exact meshes are the same in parallel", "[mesher][exact][parallel]") {
  const auto states = read("us_states_10m.poly.gz");
  Exact_pslg pslg; // maps side by side: enough for several blocks
  for (int i = 0; i < (is_full_run() ? 3 : 2); ++i) {
    const Exact_pslg map = to_exact(states, FT(1) / 3, FT(1e9 * i));
    const std::size_t first = pslg.number_of_vertices();
    pslg.vertices.insert(pslg.vertices.end(), map.vertices.begin(), map.vertices.end());
    for (const auto& s : map.segments)
      add_segment(pslg, first + std::size_t(s[0]), first + std::size_t(s[1]));
  }
  Exact_mesher<CGAL::Sequential_tag> sequential;
  Exact_mesher<CGAL::Parallel_tag> parallel;
  const Exact_mesh mesh = sequential(pslg), other = parallel(pslg);
  CHECK(other.points == mesh.points);
  CHECK(other.triangles == mesh.triangles);
  check_input_is_kept(mesh, pslg);
}

TEST_CASE("regions and size fields with exact coordinates", "[mesher][exact]") {
  Exact_pslg pslg = two_vertices_apart(FT(1) / 3);
  add_segment(pslg, 4, 5);
  pslg.regions.push_back({Exact_point(FT(1) / 7, FT(1) / 7), 1, 0.001});
  const auto size = [](double x, double y) { return 0.02 + 0.2 * std::hypot(x, y); };
  const Exact_run r = run_exactly(pslg, Options().size(size));
  std::size_t large = 0;
  for (std::size_t t = 0; t < r.mesh.triangles.size(); ++t)
    if (doubled_area(r.mesh, t) > FT(0.002)) ++large;
  CHECK(large == 0);
  CHECK(r.mesh.triangles.size() > 1000);
  const Exact_run least = run_exactly(unit_square(), Options().max_edge(0.1).min_angle(0).min_edge(0.01));
  CHECK(least.report.is_met());
}

TEST_CASE("other kernels for exact meshes", "[mesher][exact]") {
  using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  CGAL::Pslg_2<Rational::Point_2> rational;
  const CGAL::Exact_rational third = CGAL::Exact_rational(1) / 3;
  for (const auto& p : pslg_test::unit_square().vertices)
    rational.add_vertex(Rational::Point_2(third * p.x(), third * p.y()));
  rational.segments = pslg_test::unit_square().segments;
  rational.add_vertex(Rational::Point_2(third / 2, third / 1000));
  CGAL::Quality_mesher_2<CGAL::Exact_quadtree_traits_2<Rational>> mesher;
  const auto mesh = mesher(rational);
  CHECK(mesher.report().is_met());
  CHECK(mesh.triangles.size() > 10);

  // over doubles these are the meshes of the filtered traits
  using Doubles = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Quality_mesher_2<CGAL::Exact_quadtree_traits_2<Doubles>> of_doubles;
  const auto pslg = read("syn_comb.poly");
  CHECK(of_doubles(pslg).triangles == run_to_the_bound(pslg, Options()).mesh.triangles);
}

TEST_CASE("exact coordinates", "[mesher][exact]") {
  using Coordinate = CGAL::Quadtree_mesh_2::internal::Exact_coordinate<Field>;
  const auto power = [](int k) { return CGAL::Quadtree_mesh_2::internal::power_of_two<Field>(k); };
  std::vector<Field> numbers{Field(0), Field(1)};
  for (const Field& n : std::vector<Field>{Field(1) / 3, Field(1), Field(0.1)})
    for (const int k : {20, 53, 54, 60, 75, 89, 91, 105, 107, 120, 300, 2000})
      for (const int sign : {-1, 1})
        numbers.push_back(n + sign * power(-k)), numbers.push_back(-n + power(-k) / 3);
  // half a unit in the last place, and a little; below the range of doubles it is 0
  const auto is_nearly_rounded = [&](double rounded, const Field& d) {
    const Field error = Field(rounded) < d ? Field(d - Field(rounded)) : Field(Field(rounded) - d);
    return error <= Field(d < 0 ? Field(-d) : d) * power(-53) * (1 + power(-10)) + power(-1074);
  };
  for (const Field& a : numbers) {
    const Coordinate x(a);
    CHECK(x.exact() == a);
    CHECK(x.is_double() == (Field(x.high()) == a));
    for (const Field& b : numbers) {
      const Coordinate y(b);
      CHECK((x == y) == (a == b));
      CHECK((x < y) == (a < b));
      const Field d = a - b;
      const Field magnitude = d < 0 ? Field(-d) : d;
      CHECK(is_nearly_rounded(Coordinate::difference(x, y), d));
      const Field scaled = Coordinate::scaled_difference(x, y).exact<Field>(); // correct there, too
      CHECK((scaled < d ? Field(d - scaled) : Field(scaled - d)) <= magnitude * power(-51));
      for (const double share : {0.5, 0.1, 1e-20, 1.0}) {
        const Coordinate between = Coordinate::between(x, y, share);
        const Field way = Field(share) * (b - a);
        CHECK(between.exact() == a + way);
        CHECK(is_nearly_rounded(Coordinate::difference(between, x), way));
      }
    }
    for (const int k : {0, -20, -60, -110, -200})
      for (const double v : {0., 0.3, -1e-25}) {
        const Field n = Coordinate::nearest_multiple(x, v, k).exact() * power(-k);
        CHECK(CGAL::Quadtree_mesh_2::internal::Floor_of_scaled<Field>(0)(n) ==
              -CGAL::Quadtree_mesh_2::internal::Floor_of_scaled<Field>(0)(-n)); // an integer
        const Field off = n * power(k) - a - Field(v);
        CHECK((off < 0 ? -off : off) <= power(k) * 17 / 32);
      }
  }
}

} // namespace test_quality_mesher_exact
