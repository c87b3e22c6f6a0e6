// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Graphs in the format .poly, and whether two are the same to the last bit.

#ifndef QUADTREE_MESH_2_TEST_TRIANGLE_FILES_TOOLS_H
#define QUADTREE_MESH_2_TEST_TRIANGLE_FILES_TOOLS_H

#include "pslg_test_tools.h"

#include <CGAL/IO/Triangle_files.h>

#include <algorithm>
#include <cstring>
#include <sstream>
#include <string>

namespace triangle_files_test {

using namespace pslg_test;

inline Pslg parse(const std::string& text) {
  Pslg pslg;
  std::istringstream in(text);
  CGAL::IO::read_triangle_poly(in, pslg, "test.poly");
  return pslg;
}

inline std::string parse_error(const std::string& text) {
  return error_of([&] { parse(text); });
}

inline bool have_same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

inline bool have_same_bits(const Pslg& a, const Pslg& b) {
  const auto same_points = [](const Point& p, const Point& q) {
    return have_same_bits(p.x(), q.x()) && have_same_bits(p.y(), q.y());
  };
  const auto same_numbers = [](double x, double y) { return have_same_bits(x, y); };
  const auto same_regions = [&](const Pslg::Region& r, const Pslg::Region& s) {
    return same_points(r.point, s.point) && r.attribute == s.attribute && r.max_area == s.max_area;
  };
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    same_points) &&
         a.vertex_markers == b.vertex_markers &&
         a.number_of_vertex_attributes == b.number_of_vertex_attributes &&
         std::equal(a.vertex_attributes.begin(), a.vertex_attributes.end(), b.vertex_attributes.begin(),
                    b.vertex_attributes.end(), same_numbers) &&
         a.segments == b.segments && a.segment_markers == b.segment_markers &&
         std::equal(a.holes.begin(), a.holes.end(), b.holes.begin(), b.holes.end(), same_points) &&
         std::equal(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(), same_regions);
}

constexpr const char* full_example = R"(# A box with everything.
5 2 2 1   # vertices, dimension, attributes, markers

 # numbered from 1
1 +0 0 0.5 1e2 7
2	4 0	1.5 2e2 8 # a comment behind numbers
3 4. 4 2.5 3e2 9

4 0 4e0 3.5 -4E+2 -10
5 1 .5 4.5 5e-2 0
4 1
1 1 2 11
2 2 3 12
3 3 4 13
4 4 1 0
2 # holes
1 1 1
2 2.5 +2.5
2 # regions
1 3 3 17 0.25
2 0.5 0.5 -18
)";

} // namespace triangle_files_test

#endif // QUADTREE_MESH_2_TEST_TRIANGLE_FILES_TOOLS_H
