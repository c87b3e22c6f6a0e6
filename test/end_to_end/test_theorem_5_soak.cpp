// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Some inputs of every family whose features quadtrees separate: each mesh valid, and the bound met before refinement.
// test/soak.sh has them without end.

#include "catch.h"
#include "random_pslg_shapes.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <cstdint>
#include <exception>
#include <string>
#include <vector>

namespace test_theorem_5_soak {

namespace {

using random_pslg::Family;
using random_pslg::Pslg;

/// What is wrong with the mesh of `pslg`; empty if nothing is.
std::string fault_of_mesh(const Pslg& pslg, double min_angle) try {
  CGAL::Quality_mesher_2<> mesher(CGAL::Quality_mesh_options_2().min_angle(min_angle).separate(
      CGAL::Tree_separation_options_2::of_theorem()));
  const auto mesh = mesher(pslg);
  const auto& report = mesher.report();
  const auto quality = CGAL::mesh_quality_2(mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(min_angle));
  if (!quality.is_valid()) return "invalid: " + quality.errors.front();
  if (!quality.is_met()) return "unmet triangles: " + std::to_string(quality.unmet_triangles.size());
  if (!report.is_met()) return "unmet triangles in the report alone";
  if (report.exempt_triangles.size() != quality.exempt_triangles) return "exempt triangles miscounted";
  if (report.trees.rounds == 0) return "no quadtrees";
  if (report.trees.end != CGAL::Tree_separation_report_2::End::DONE)
    return "ended otherwise: " + std::to_string(int(report.trees.end));
  if (report.trees.missed > 0) return "missed by quadtrees: " + std::to_string(report.trees.missed);
  return {};
} catch (const std::exception& error) {
  return std::string("exception: ") + error.what();
}

void check_seeds(std::uint64_t first, std::uint64_t last) {
  const std::vector<Family> families = random_pslg::all_families();
  for (std::uint64_t i = first; i < last; ++i) {
    const Family& family = families[i % families.size()];
    const std::uint64_t seed = i / families.size();
    const double min_angle = seed % 2 == 0 ? 20.7 : 18.43;
    const std::string name = family.name;
    CAPTURE(name, seed, min_angle);
    const std::string fault = fault_of_mesh(family.make(seed), min_angle);
    CHECK(fault.empty());
    if (!fault.empty()) WARN(name << ", seed " << seed << ", " << min_angle << " degrees: " << fault);
  }
}

} // namespace

TEST_CASE("Some random inputs of every family are meshed by quadtrees to the bound", "[mesher][theorem5]") {
  check_seeds(0, 4 * random_pslg::all_families().size());
}

} // namespace test_theorem_5_soak
