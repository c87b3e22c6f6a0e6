// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "meshers_in_words32.h"
#include "point_mesh_checks.h"
#include "point_sets.h"

#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/IO/read_XY.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/round_mesh_2.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_point_set_mesher_exact {

namespace {

using point_mesh_test::Mode;
using point_mesh_test::Options;
using Domain = Options::Domain;
using Words_32 = CGAL::Fixed_point_quadtree_traits_2<std::uint32_t>;
using Words_64 = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
using Exact = CGAL::Exact_quadtree_traits_2<>;

/// Points of the unit square or near it, moved to where the root has room around them. (Words of 64 bits up to 2^53,
/// which are doubles, too.)
template <class Word>
CGAL::Fixed_point_2<Word> make_point(const CGAL::Fixed_point_quadtree_traits_2<Word>&,
                                     const point_sets::Point& p) {
  const double middle = sizeof(Word) == 8 ? 512 : 7.5;
  const int bits = sizeof(Word) == 8 ? 42 : 27;
  const auto word = [&](double x) { return static_cast<Word>(std::floor(std::ldexp(x + middle, bits))); };
  return {word(p.x()), word(p.y())};
}
/// With coordinates that are no doubles.
Exact::Point_2 make_point(const Exact&, const point_sets::Point& p) {
  using FT = CGAL::Epeck::FT;
  return {FT(p.x()) / 3, FT(p.y()) / 3 + FT(1) / 7};
}

template <class Traits>
std::vector<typename Traits::Point_2> make_points(const point_sets::Points& points) {
  std::vector<typename Traits::Point_2> result;
  for (const auto& p : points) result.push_back(make_point(Traits(), p));
  return result;
}

/// Meshes, and checks all that must hold for every mesh.
template <class Traits>
void run(const std::vector<typename Traits::Point_2>& points, const Options& options) {
  CGAL::Point_set_mesher_2<Traits> mesher(options);
  const auto mesh = mesher(points);
  for (const std::string& fault : point_mesh_test::faults_of(mesh, points, options, mesher.report()))
    FAIL_CHECK(fault);
}

std::vector<std::pair<std::string, Options>> all_modes() {
  return {{"row", Options().bounded_angles()},
          {"square", Options().bounded_angles().mesh_domain(Domain::SQUARE)},
          {"acute", Options().acute()},
          {"least angle", Options().least_angle()},
          {"warped squares", Options().warped_squares()}};
}

std::vector<point_sets::Named_points> inputs(std::size_t n) {
  return {{"none", {}},
          {"one", {{0.3, 0.7}}},
          {"equal", {{0.3, 0.7}, {0.3, 0.7}}},
          {"two", {{0, 0}, {1, 0.25}}},
          {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
          {"uniform", quadtree_inputs::uniform(n, 1)},
          {"clustered", point_sets::clustered(n, 2)},
          {"horizontal line", point_sets::horizontal_line(n, 3)},
          {"slanted line", quadtree_inputs::line(n, 4)},
          {"lattice circle", point_sets::moved(point_sets::lattice_circle(), 0x1p-8, 0, 0)},
          {"circle", point_sets::circle(n)},
          {"duplicates", point_sets::moved(point_sets::duplicates(n, 5), 0x1p-3, 0, 0)},
          {"near pairs", point_sets::close_pairs(n, 0x1p-14, 6)}};
}

template <class Traits>
void run_all(std::size_t n) {
  for (const auto& [name, options] : all_modes())
    for (const auto& input : inputs(n)) {
      CAPTURE(name, input.name);
      run<Traits>(make_points<Traits>(input.points), options);
    }
}

} // namespace

TEST_CASE("Points with words as coordinates are meshed as promised", "[point_set_mesher]") {
  const std::size_t n = is_full_run() ? 100 : 4;
  SECTION("of 64 bits") { run_all<Words_64>(n); }
  SECTION("of 32 bits") { run_all<Words_32>(n); }
}

TEST_CASE("Points with exact coordinates are meshed as promised", "[point_set_mesher]") {
  run_all<Exact>(is_full_run() ? 60 : 4);
}

TEST_CASE("Exact acute meshes of points nearer than any word or double tells", "[point_set_mesher]") {
  const CGAL::Epeck::FT gap(0x1p-100);
  for (int kind = is_full_run() ? 0 : 2; kind < 3; ++kind) {
    std::vector<Exact::Point_2> points{{1, 0.5}, {-0.75, 0.25}, {0.125, -1}, {0, 0}};
    if (kind == 0) points.emplace_back(gap, gap / 3);
    if (kind == 1) points.emplace_back(-gap, 0);
    if (kind == 2)
      for (const int k : {1, 2, 3}) points.emplace_back(gap * k, gap * k * k / 3);
    run<Exact>(points, Options().acute());
  }
}

TEST_CASE("Exact meshes far from the origin that are rounded to doubles cover what they shall",
          "[point_set_mesher]") {
  point_sets::Points points;
  CGAL::IO::read_XY(QUADTREE_MESH_TEST_DATA_DIR "/hard_points_at_1e12.xy", points);
  std::vector<Exact::Point_2> exact;
  for (const point_sets::Point& p : points) exact.emplace_back(p.x(), p.y());
  for (const auto& [name, options] : all_modes()) {
    CAPTURE(name);
    CGAL::Point_set_mesher_2<Exact> mesher(options);
    const auto rounded = CGAL::round_mesh_2<point_sets::Point>(mesher(exact), points);
    for (const std::string& fault : point_mesh_test::faults_of(rounded.mesh, points, options, mesher.report(),
                                                               point_mesh_test::Made_in::EXACT_NUMBERS)) {
      const bool is_of_angles = fault.find(" reported") != std::string::npos || // before they were rounded
                                fault.find("outside the range:") != std::string::npos;
      if (!is_of_angles) FAIL_CHECK(fault);
    }
  }
}

TEST_CASE("Words are refused that have no room around them", "[point_set_mesher]") {
  const std::uint64_t end = std::uint64_t(1) << 62;
  using Words = std::vector<Words_64::Point_2>;
  for (const auto& [name, options] : all_modes()) {
    CAPTURE(name);
    CGAL::Point_set_mesher_2<Words_64> mesher(options);
    if (options.mode() == Mode::LEAST_ANGLE) continue; // its box may touch points
    CHECK_THROWS_AS(mesher(Words{{0, 0}, {end / 2, 5}}), std::invalid_argument);
    CHECK_THROWS_AS(mesher(Words{{end - 1, end / 2}, {end / 2, end - 1}}), std::invalid_argument);
  }
}

} // namespace test_point_set_mesher_exact
