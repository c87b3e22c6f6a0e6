// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "pslg_test_tools.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/validate_pslg_2.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace test_pslg_2 {

using namespace pslg_test;

namespace {

std::string structure_error(const Pslg& pslg) {
  return error_of([&] { CGAL::check_pslg_structure(pslg); });
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("Pslg_2 hands out indices and points", "[pslg]") {
  Pslg pslg;
  const Vertex_index a = pslg.add_vertex(Point(1, 2)), b = pslg.add_vertex(Point(3, 4));
  const Segment_index s = pslg.add_segment(a, b);
  CHECK(a == Vertex_index(0));
  CHECK(b == Vertex_index(1));
  CHECK(s == Segment_index(0));
  CHECK(pslg.point(b) == Point(3, 4));
  CHECK(pslg.number_of_vertices() == 2);
  CHECK(pslg.number_of_segments() == 1);
}

TEST_CASE("a sound graph passes", "[pslg]") {
  Pslg pslg = unit_square();
  CHECK(structure_error(pslg).empty());
  pslg.vertex_markers = {1, 2, 3, 4};
  pslg.segment_markers = {1, 2, 3, 4};
  pslg.number_of_vertex_attributes = 2;
  pslg.vertex_attributes.assign(8, 0.5);
  pslg.holes = {Point(0.5, 0.5)};
  pslg.regions = {{Point(0.5, 0.5), 1, 0.1}};
  CHECK(structure_error(pslg).empty());
  CHECK_NOTHROW(CGAL::validate_pslg_2(pslg));
}

TEST_CASE("points alone are a sound graph", "[pslg]") {
  CHECK(structure_error(make_pslg<double>({{0, 0}, {1, 0}, {0, 1}})).empty());
}

TEST_CASE("arrays that do not fit together are named", "[pslg]") {
  Pslg pslg = unit_square();
  SECTION("vertex markers") {
    pslg.vertex_markers = {1};
    CHECK(structure_error(pslg) == "vertex_markers has 1 entries instead of 4");
  }
  SECTION("segment markers") {
    pslg.segment_markers = {1, 2, 3, 4, 5};
    CHECK(structure_error(pslg) == "segment_markers has 5 entries instead of 4");
  }
  SECTION("attributes") {
    pslg.number_of_vertex_attributes = 2;
    pslg.vertex_attributes.assign(7, 0.);
    CHECK(structure_error(pslg) == "vertex_attributes has 7 entries instead of 2 for each of 4 vertices");
  }
  SECTION("attributes nobody declared") {
    pslg.vertex_attributes.assign(4, 0.);
    CHECK(structure_error(pslg) == "vertex_attributes has 4 entries instead of 0");
  }
  SECTION("a number of attributes whose product with the vertices overflows to 0") {
    pslg.number_of_vertex_attributes = std::size_t(1) << 62;
    CHECK(has_text(structure_error(pslg), "vertex_attributes has 0 entries"));
  }
}

TEST_CASE("coordinates that are not finite are named", "[pslg]") {
  Pslg pslg = unit_square();
  SECTION("vertex, NaN") {
    pslg.vertices[2] = Point(not_a_number, 1);
    CHECK(structure_error(pslg) == "vertex 2 (nan, 1) is not finite");
  }
  SECTION("vertex, infinite") {
    pslg.vertices[3] = Point(0, -infinity);
    CHECK(structure_error(pslg) == "vertex 3 (0, -inf) is not finite");
  }
  SECTION("hole") {
    pslg.holes = {Point(0.5, 0.5), Point(infinity, 0.25)};
    CHECK(structure_error(pslg) == "hole 1 (inf, 0.25) is not finite");
  }
  SECTION("region") {
    pslg.regions = {{Point(0.5, not_a_number), 0, 0}};
    CHECK(structure_error(pslg) == "region 0 (0.5, nan) is not finite");
  }
  SECTION("area of a region") {
    pslg.regions = {{Point(0.5, 0.5), 0, infinity}};
    CHECK(has_text(structure_error(pslg), "region 0 (0.5, 0.5) has an attribute or an area bound"));
  }
}

TEST_CASE("segments that end nowhere are named", "[pslg]") {
  Pslg pslg = unit_square();
  pslg.add_segment(Vertex_index(0), Vertex_index(4));
  CHECK(structure_error(pslg) == "segment 4 ends at vertex 4, but the vertices are 0 to 3");
  pslg.segments.back()[1] = Vertex_index();
  CHECK(has_text(structure_error(pslg), "segment 4 ends at vertex 4294967295"));
  CHECK(structure_error(make_pslg<double>({}, {{0, 1}})) ==
        "segment 0 ends at vertex 0, but there are no vertices");
}

TEST_CASE("graphs without area are named", "[pslg]") {
  CHECK(structure_error(Pslg()) == "there are no vertices");
  CHECK(structure_error(make_pslg<double>({{0.5, 2}})) == "there is only one vertex, vertex 0 (0.5, 2)");
  CHECK(structure_error(make_pslg<double>({{0.5, 2}, {0.5, 2}, {0.5, 2}})) ==
        "all 3 vertices are one point, (0.5, 2)");
  CHECK(structure_error(make_pslg<double>({{0, 0}, {1, 1}}, {{0, 1}})) ==
        "all 2 vertices lie on the line through vertex 0 (0, 0) and vertex 1 (1, 1)");
  CHECK(structure_error(make_pslg<double>({{0, 0}, {0, 0}, {3, 1}, {6, 2}, {-3, -1}})) ==
        "all 5 vertices lie on the line through vertex 0 (0, 0) and vertex 2 (3, 1)");
}

TEST_CASE("whether vertices lie on a line is decided exactly", "[pslg]") {
  // In double arithmetic the determinant of the first three is 0, too.
  const double tiny = std::ldexp(1., -52);
  CHECK(structure_error(make_pslg<double>({{0.5, 0.5}, {12, 12}, {24, 24}, {0.5 + tiny, 0.5}})).empty());
  CHECK(
      has_text(structure_error(make_pslg<double>({{0.5, 0.5}, {12, 12}, {24, 24}, {0.5 + tiny, 0.5 + tiny}})),
               "line"));
}

TEST_CASE("the structure of graphs over other kernels is checked", "[pslg]") {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::Point_2;
  using Plain = CGAL::Simple_cartesian<double>::Point_2;
  CHECK_NOTHROW(CGAL::check_pslg_structure(make_pslg<double, Exact>({{0, 0}, {1, 0}, {0, 1}}, {{0, 1}})));
  CHECK_THROWS_AS(CGAL::check_pslg_structure(make_pslg<double, Exact>({{0, 0}, {1, 1}, {2, 2}})),
                  CGAL::Pslg_error_2);
  CHECK_NOTHROW(CGAL::check_pslg_structure(make_pslg<double, Plain>({{0, 0}, {1, 0}, {0, 1}})));
  CHECK_THROWS_AS(CGAL::check_pslg_structure(make_pslg<double, Plain>({{0, 0}, {1, not_a_number}, {2, 2}})),
                  CGAL::Pslg_error_2);
}

TEMPLATE_TEST_CASE("the structure of graphs over words is checked", "[pslg]", std::uint32_t, std::uint64_t) {
  using P = Word_point<TestType>;
  const TestType top = (std::numeric_limits<TestType>::max)();
  const auto error = [](const CGAL::Pslg_2<P>& pslg) {
    return error_of([&] { CGAL::check_pslg_structure(pslg); });
  };
  CHECK(error(make_pslg<TestType, P>({{0, 0}, {top, 0}, {0, top}}, {{0, 1}, {1, 2}})).empty());
  CHECK(error(make_pslg<TestType, P>({{0, 0}, {top, top}, {top, TestType(top - 1)}})).empty());
  CHECK(has_text(error(make_pslg<TestType, P>({{0, top}, {top, 0}, {1, TestType(top - 1)}})), "on the line"));
  CHECK(has_text(error(make_pslg<TestType, P>({{7, 9}, {7, 9}})), "one point, (7, 9)"));
  CHECK(has_text(error(make_pslg<TestType, P>({{0, 0}, {1, 0}, {0, 1}}, {{0, 3}})),
                 "segment 0 ends at vertex 3"));
}

TEST_CASE("collinearity of words agrees with wider arithmetic", "[pslg]") {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(0, 6);
  int collinear = 0;
  for (int i = 0; i < 20000; ++i) {
    long c[6];
    for (long& x : c) x = coordinate(random);
    const auto word = [](long x) { return static_cast<std::uint64_t>(x) << 61; }; // up to 3 * 2^62
    const auto point = [&](int k) { return Word_point<std::uint64_t>(word(c[2 * k]), word(c[2 * k + 1])); };
    const bool expected = (c[2] - c[0]) * (c[5] - c[1]) == (c[3] - c[1]) * (c[4] - c[0]);
    collinear += expected;
    REQUIRE(CGAL::Quadtree_mesh_2::internal::are_collinear(point(0), point(1), point(2)) == expected);
  }
  CHECK(collinear > 1000);
}

TEST_CASE("only the strict check refuses segments of length zero", "[pslg]") {
  Pslg pslg = unit_square();
  SECTION("one vertex twice") {
    pslg.add_segment(Vertex_index(1), Vertex_index(1));
    CHECK(error_of([&] { CGAL::validate_pslg_2(pslg); }) ==
          "segment 4 from vertex 1 (1, 0) to vertex 1 (1, 0) has length zero");
  }
  SECTION("two vertices at one place") {
    pslg.add_segment(Vertex_index(1), pslg.add_vertex(Point(1, 0)));
    CHECK(error_of([&] { CGAL::validate_pslg_2(pslg); }) ==
          "segment 4 from vertex 1 (1, 0) to vertex 4 (1, 0) has length zero");
  }
  CHECK(structure_error(pslg).empty());
}

} // namespace test_pslg_2
