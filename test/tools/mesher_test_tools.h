// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_MESHER_TEST_TOOLS_H
#define QUADTREE_MESH_2_TEST_MESHER_TEST_TOOLS_H

// Runs of the mesher with what must hold for every mesh checked.

#include "catch.h"
#include "pslg_test_tools.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <string>

namespace mesher_test {

using pslg_test::Pslg;
using Mesher = CGAL::Quality_mesher_2<>;
using Mesh = Mesher::Mesh;
using Options = CGAL::Quality_mesh_options_2;

struct Run {
  Mesh mesh;
  CGAL::Quality_mesh_report_2 report;
  CGAL::Mesh_quality_2 quality;
};

inline CGAL::Mesh_quality_options_2::Domain rule_to_check(Options::Domain domain) {
  using Rule = CGAL::Mesh_quality_options_2::Domain;
  switch (domain) {
  case Options::Domain::ENCLOSED:
    return Rule::ENCLOSED_BY_SEGMENTS;
  case Options::Domain::MARKED:
    return Rule::MARKED_BY_REGIONS;
  case Options::Domain::NESTING_PARITY:
    return Rule::NESTING_PARITY;
  }
  return Rule::ENCLOSED_BY_SEGMENTS;
}

/// Meshes, and checks what must hold for every mesh whatever stopped it: it is valid, and the report tells
/// the truth.
inline Run run(const Pslg& pslg, const Options& options) {
  Mesher mesher(options);
  Run r;
  r.mesh = mesher(pslg);
  r.report = mesher.report();
  r.quality = CGAL::mesh_quality_2(r.mesh, pslg,
                                   CGAL::Mesh_quality_options_2()
                                       .min_angle(options.min_angle())
                                       .max_edge(options.max_edge())
                                       .max_area(options.max_area())
                                       .check_domain(rule_to_check(options.mesh_domain())));
  for (const std::string& error : r.quality.errors) UNSCOPED_INFO(error);
  CHECK(r.quality.is_valid());
  CHECK(r.report.triangles == r.quality.triangles);
  CHECK(r.report.vertices == r.quality.vertices);
  return r;
}

/// And that every bound is met, as is promised up to 20.7 degrees.
inline Run run_to_the_bound(const Pslg& pslg, const Options& options) {
  Run r = run(pslg, options);
  CHECK(r.report.is_met());
  CHECK(r.quality.unmet_triangles.empty());
  CHECK(r.report.exempt_triangles.size() == r.quality.exempt_triangles);
  return r;
}

inline Pslg read(const std::string& name) {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(pslg_test::data_file(name), pslg);
  return pslg;
}

} // namespace mesher_test

#endif // QUADTREE_MESH_2_TEST_MESHER_TEST_TOOLS_H
