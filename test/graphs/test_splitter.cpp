// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Shells on legs of acute corners: where they are needed, and only there.

#include "catch.h"
#include "feature_size.h"
#include "mesher_test_tools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace test_splitter {

using namespace mesher_test;

TEST_CASE("Shells next to a small feature stay out of wide sectors", "[splitter]") {
  // legs to (1, 0) and (1, -1e-6), and one 45 degrees away from them; a segment ends 1e-4 above the middle of the first
  const Pslg pslg = read("hard_shells_45_degrees.poly");
  const Run r = run_to_the_bound(pslg, Options().coarsen(Options::Coarsening::NONE));
  const auto is_near_third_leg = [](const auto& p) {
    return std::hypot(p.x() - 0.5 * std::sqrt(0.5), p.y() + 0.5 * std::sqrt(0.5)) < 0.2;
  };
  std::size_t edges = 0;
  for (const auto& t : r.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = r.mesh.point(t[k]), &b = r.mesh.point(t[(k + 1) % 3]);
      if (!is_near_third_leg(a) || !is_near_third_leg(b)) continue;
      ++edges;
      const double size =
          std::min(feature_size::local_feature_size(pslg, a), feature_size::local_feature_size(pslg, b));
      CHECK(std::sqrt(CGAL::squared_distance(a, b)) >= size / 64);
    }
  CHECK(edges > 0);
}

TEST_CASE("A leg is cut as often as a segment along it asks for", "[splitter]") {
  const Pslg pslg = read("hard_segment_along_wedge.poly"); // at 2e-4 of the leg, for 0.8 of its length
  const Run r = run_to_the_bound(pslg, Options());
  const auto triangles = static_cast<double>(r.report.triangles);
  CHECK(triangles > 0.8 / 2e-4);
  CHECK(triangles < 4 * 0.8 / 2e-4);
}

} // namespace test_splitter
