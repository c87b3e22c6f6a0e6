// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "point_mesh_checks.h"
#include "point_sets.h"

#include <CGAL/Point_set_mesher_2.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace {

using point_mesh_test::Options;
using Domain = Options::Domain;
using Point_error = CGAL::Quadtree_mesh_2::Point_error;

/// Nearer to each other, points of the unit square may be refused, or have no room for angles between them.
constexpr double least_gap = 0x1p-40;

struct Tally {
  std::size_t sets = 0, points = 0, refused = 0, unmet = 0, triangles = 0;
};

/// With all that makes a difference: least gaps around clusters, too.
std::vector<std::pair<std::string, Options>> all_options() {
  return {{"acute", Options().acute()},
          {"acute, many clusters", Options().acute().clusters(2248)},
          {"row", Options().bounded_angles()},
          {"square", Options().bounded_angles().mesh_domain(Domain::SQUARE)}};
}

/// What is wrong with the mesh; empty if nothing is.
std::string fault_of_mesh(const point_sets::Points& points, const Options& options, bool is_near,
                          Tally& tally) try {
  CGAL::Point_set_mesher_2<> mesher(options);
  const auto mesh = mesher(points);
  tally.triangles += mesh.number_of_triangles();
  for (const std::string& fault : point_mesh_test::faults_of(mesh, points, options, mesher.report())) {
    const bool is_excused =
        is_near && !mesher.report().is_met() && fault.find("outside the range:") != std::string::npos;
    if (!is_excused) return fault;
    ++tally.unmet;
  }
  return {};
} catch (const Point_error& error) {
  if (!is_near) return std::string("refused: ") + error.what();
  ++tally.refused;
  return {};
} catch (const std::exception& error) {
  return std::string("exception: ") + error.what();
}

Tally check_seeds(std::uint64_t first, std::uint64_t last) {
  Tally tally;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const point_sets::Points points = point_sets::Random_small_set(seed)();
    const bool is_near = point_sets::least_distance(points) < least_gap;
    ++tally.sets;
    tally.points += points.size();
    for (const auto& [name, options] : all_options()) {
      CAPTURE(seed, name, points.size());
      const std::string fault = fault_of_mesh(points, options, is_near, tally);
      CHECK(fault.empty());
      if (!fault.empty()) WARN("seed " << seed << ", " << name << ": " << fault);
    }
  }
  return tally;
}

/// A number from the environment.
std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

} // namespace

TEST_CASE("Some random point sets are meshed as promised", "[point_set_mesher]") { check_seeds(0, 4); }

/// QUADTREE_MESH_SOAK says how many sets, QUADTREE_MESH_SOAK_FIRST where to begin.
TEST_CASE("Ten thousand random point sets are meshed as promised", "[point_set_mesher][soak][.slow]") {
  const std::uint64_t first = number_from_environment("QUADTREE_MESH_SOAK_FIRST", 0);
  const Tally tally = check_seeds(first, first + number_from_environment("QUADTREE_MESH_SOAK", 10000));
  WARN(tally.sets << " sets of " << tally.points << " points, " << tally.triangles
                  << " triangles; of meshes of points nearer than 2^-40, " << tally.refused
                  << " were refused and " << tally.unmet << " are outside the range somewhere");
}
