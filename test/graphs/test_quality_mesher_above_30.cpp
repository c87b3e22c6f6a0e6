// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "feature_size.h"
#include "mesher_test_tools.h"
#include "random_plans.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace test_quality_mesher_above_30 {

namespace {

using namespace mesher_test;

/// No edge is shorter than this share of the local feature size, or of what bounds of size ask for if that is less.
constexpr double least_share = 1.0 / 32;

double size_of(const Options& options) {
  constexpr double none = std::numeric_limits<double>::infinity();
  return std::min(options.max_area() > 0 ? std::sqrt(options.max_area()) : none,
                  options.max_edge() > 0 ? options.max_edge() : none);
}

Run run_without_descent(const Pslg& pslg, const Options& options) {
  Run r = run_to_the_bound(pslg, options);
  CHECK(feature_size::least_share_of_feature_size(r.mesh, pslg, size_of(options)) >= least_share);
  return r;
}

/// An input and the bounds with which refinement once halved its triangles until coordinates had no room.
struct Descent {
  std::string file;
  double angle, max_area;
};

} // namespace

TEST_CASE("Above 30 degrees refinement does not descend into corners and edges", "[mesher]") {
  const Descent d =
      GENERATE(Descent{"hard_box.poly", 34, 0.3305091648759004},
               Descent{"hard_box_1_vertex.poly", 31, 1.4811652274870193},
               Descent{"hard_box_4_vertices.poly", 34, 0.42667515339033657},
               Descent{"hard_zigzag_in_box.poly", 33, 0.7300670694432428},
               Descent{"hard_vertex_in_3x4_box.poly", 34, 0}, Descent{"hard_stairs.poly", 34, 0});
  CAPTURE(d.file, d.angle);
  const Pslg pslg = read(d.file);
  const Run at_30 = run_without_descent(pslg, Options().min_angle(30).max_area(d.max_area));
  const Run r = run_without_descent(pslg, Options().min_angle(d.angle).max_area(d.max_area));
  CHECK(2 * r.report.triangles <= 3 * at_30.report.triangles);
}

TEST_CASE("Plain plans are meshed to bounds above 30 degrees without tiny triangles", "[mesher]") {
  const std::uint64_t seeds = is_full_run() ? 2000 : 32;
  for (const random_pslg::Family& family : random_pslg::plan_families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(family.name, seed);
      random_pslg::Random random(seed);
      constexpr double angles[] = {31, 32, 33, Options::greatest_min_angle};
      const double size = std::pow(10, random.between(-0.5, 1));
      const Options options = Options().min_angle(angles[seed % 4]);
      const std::uint64_t kind = seed / 4 % 3; // of bounds of size
      run_without_descent(family.make(seed), kind == 0   ? options
                                             : kind == 1 ? Options(options).max_area(size * size / 2)
                                                         : Options(options).max_edge(size));
    }
}

} // namespace test_quality_mesher_above_30
