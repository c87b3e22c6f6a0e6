// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Each kind of error, from inputs that have nothing else wrong, with the indices of what is to blame.

#include "catch.h"
#include "pslg_test_tools.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/read_WKT.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/refine_quality_mesh_2.h>
#include <CGAL/repair_pslg_2.h>
#include <CGAL/round_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_pslg_errors {

namespace {

using namespace pslg_test;
using CGAL::Pslg_error_2;
using CGAL::Pslg_parts_2;
using Kind = Pslg_error_2::Kind;
using Options = CGAL::Quality_mesh_options_2;
using Words = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
using Exact_traits = CGAL::Exact_quadtree_traits_2<>;

/// What `f` throws.
template <class Function>
Pslg_error_2 thrown_by(Function f) {
  try {
    f();
  } catch (const Pslg_error_2& error) {
    return error;
  }
  FAIL("no error");
  throw std::logic_error("not reached");
}

template <class Traits = CGAL::Filtered_quadtree_traits_2<>, class Graph>
Pslg_error_2 refusal(const Graph& pslg, const Options& options = {}) {
  return thrown_by([&] {
    CGAL::Quality_mesher_2<Traits> mesher(options);
    mesher(pslg);
  });
}

template <class Index>
std::vector<std::size_t> numbers(const std::vector<Index>& indices) {
  std::vector<std::size_t> result;
  for (const Index i : indices) result.push_back(std::size_t(i));
  return result;
}

/// The indices that an error has.
struct Parts {
  std::vector<std::size_t> vertices, segments, holes, regions, seeds;
};

void check(const Pslg_error_2& error, Kind kind, const Parts& parts = {}) {
  CAPTURE(error.what());
  CHECK(error.kind() == kind);
  CHECK(numbers(error.parts().vertices) == parts.vertices);
  CHECK(numbers(error.parts().segments) == parts.segments);
  CHECK(error.parts().holes == parts.holes);
  CHECK(error.parts().regions == parts.regions);
  CHECK(error.parts().seeds == parts.seeds);
}

Parts of_vertices(std::vector<std::size_t> vertices) { return {std::move(vertices), {}, {}, {}, {}}; }
Parts of_segments(std::vector<std::size_t> segments) { return {{}, std::move(segments), {}, {}, {}}; }
Parts of_holes(std::vector<std::size_t> holes) { return {{}, {}, std::move(holes), {}, {}}; }
Parts of_regions(std::vector<std::size_t> regions) { return {{}, {}, {}, std::move(regions), {}}; }

/// A triangle of words.
CGAL::Pslg_2<Words::Point_2> triangle(const std::vector<Words::Point_2>& corners) {
  CGAL::Pslg_2<Words::Point_2> pslg;
  pslg.vertices = corners;
  for (std::size_t i = 0; i < 3; ++i) pslg.add_segment(Vertex_index(i), Vertex_index((i + 1) % 3));
  return pslg;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("Errors of files have no parts, and name the line", "[pslg_errors]") {
  Pslg pslg;
  const auto read_poly = [&](const std::string& text) {
    std::istringstream in(text);
    return thrown_by([&] { CGAL::IO::read_triangle_poly(in, pslg); });
  };
  const auto read_wkt = [&](const std::string& text) {
    std::istringstream in(text);
    return thrown_by([&] { CGAL::IO::read_WKT(in, pslg); });
  };
  check(read_poly("3 2\n0 0 0\n1 1 x\n"), Kind::UNREADABLE_FILE);
  check(read_wkt("LINESTRING(1 2, 1 2)"), Kind::UNREADABLE_FILE);
  check(read_wkt("CIRCLE(1 2, 1 2)"), Kind::UNREADABLE_FILE);
  check(thrown_by([&] { CGAL::IO::read_triangle_poly(std::string("no/such/file.poly"), pslg); }),
        Kind::UNREADABLE_FILE);
}

TEST_CASE("Errors of arrays have no parts", "[pslg_errors]") {
  Pslg pslg = unit_square();
  pslg.vertex_markers = {1, 2, 3};
  check(refusal(pslg), Kind::ARRAY_LENGTH);
  pslg = unit_square();
  pslg.segment_markers = {1};
  check(refusal(pslg), Kind::ARRAY_LENGTH);
  pslg = unit_square();
  pslg.number_of_vertex_attributes = 2;
  check(refusal(pslg), Kind::ARRAY_LENGTH);
}

TEST_CASE("A segment without an end is named by its index", "[pslg_errors]") {
  Pslg pslg = unit_square();
  pslg.add_segment(Vertex_index(0), Vertex_index(4));
  check(refusal(pslg), Kind::NO_SUCH_VERTEX, of_segments({4}));
}

TEST_CASE("What is not finite is named by its index", "[pslg_errors]") {
  Pslg pslg = unit_square();
  SECTION("vertex") {
    pslg.vertices[2] = Point(1, std::nan(""));
    check(refusal(pslg), Kind::NOT_FINITE, of_vertices({2}));
  }
  SECTION("hole") {
    pslg.holes = {Point(0.5, 0.5), Point(infinity, 0)};
    check(refusal(pslg), Kind::NOT_FINITE, of_holes({1}));
  }
  SECTION("region") {
    pslg.regions = {{Point(0.5, 0.5), 0, 0}, {Point(0.5, -infinity), 0, 0}};
    check(refusal(pslg), Kind::NOT_FINITE, of_regions({1}));
    pslg.regions = {{Point(0.5, 0.5), 0, infinity}};
    check(refusal(pslg), Kind::NOT_FINITE, of_regions({0}));
  }
}

TEST_CASE("Coordinates beyond the limits of the arithmetic are named with the limit", "[pslg_errors]") {
  SECTION("doubles") {
    const auto error = refusal(make_pslg<double>({{0, 0}, {0x1p1000, 0}, {0, 1}}, {{0, 1}, {1, 2}, {2, 0}}));
    check(error, Kind::OUT_OF_RANGE, of_vertices({1}));
    CHECK(
        std::string(error.what()) ==
        "vertex 1 (1.0715086071862673e+301, 0) has a coordinate that is too large for the grid; it has to be "
        "below 2^1000 in magnitude");
  }
  SECTION("words") {
    constexpr std::uint64_t end = std::uint64_t(1) << 62;
    const auto error = refusal<Words>(triangle({{0, 0}, {1, 0}, {0, end}}));
    check(error, Kind::OUT_OF_RANGE, of_vertices({2}));
    CHECK(has_text(error.what(), "vertex 2 (0, 4611686018427387904) "));
    CHECK(has_text(error.what(), "below 2^62"));
  }
  SECTION("words that are too far apart") {
    constexpr std::uint64_t end = std::uint64_t(1) << 62;
    const auto error = refusal<Words>(triangle({{7, 4}, {7, end - 1}, {9, 3}}));
    check(error, Kind::OUT_OF_RANGE, of_vertices({2, 1}));
    CHECK(has_text(error.what(), "2^61"));
  }
  SECTION("doubles next to 0, beside a large extent") {
    Pslg pslg = make_pslg<double>({{0, 0}, {0x1p900, 0}, {0, 0x1p900}, {0x1p899, 0x1p-1074}},
                                  {{0, 1}, {1, 2}, {2, 0}});
    check(refusal(pslg), Kind::OUT_OF_RANGE, of_vertices({3}));
    pslg.vertices.pop_back();
    pslg.holes = {Point(0x1p900, 0x1p900), Point(0x1p-1074, 0x1p800)};
    check(refusal(pslg), Kind::OUT_OF_RANGE, of_holes({1}));
    pslg.holes.clear();
    pslg.regions = {{Point(0x1p-1074, 0x1p800), 0, 0}};
    check(refusal(pslg), Kind::OUT_OF_RANGE, of_regions({0}));
  }
}

TEST_CASE("Graphs without area have up to two vertices in their errors", "[pslg_errors]") {
  check(refusal(Pslg()), Kind::NO_AREA);
  check(refusal(make_pslg<double>({{1, 2}})), Kind::NO_AREA, of_vertices({0}));
  check(refusal(make_pslg<double>({{1, 2}, {1, 2}})), Kind::NO_AREA, of_vertices({0}));
  check(refusal(make_pslg<double>({{1, 2}, {1, 2}, {2, 3}, {3, 4}})), Kind::NO_AREA, of_vertices({0, 2}));
}

TEST_CASE("A segment of length zero has its ends in its error", "[pslg_errors]") {
  Pslg pslg = unit_square();
  pslg.add_segment(Vertex_index(1), pslg.add_vertex(Point(1, 0)));
  check(thrown_by([&] { CGAL::validate_pslg_2(pslg); }), Kind::ZERO_LENGTH, {{1, 4}, {4}, {}, {}, {}});
}

TEST_CASE("Both segments of a crossing are in its error", "[pslg_errors]") {
  Pslg pslg = unit_square();
  pslg.add_segment(Vertex_index(0), Vertex_index(2));
  pslg.add_segment(Vertex_index(1), Vertex_index(3));
  for (const Pslg_error_2& error : {refusal(pslg), thrown_by([&] { CGAL::repair_pslg_2(pslg); })}) {
    CHECK(error.kind() == Kind::CROSSING);
    std::vector<std::size_t> segments = numbers(error.parts().segments);
    std::sort(segments.begin(), segments.end());
    CHECK(segments == std::vector<std::size_t>{4, 5});
    CHECK(error.parts().vertices.empty());
  }
  CHECK_THROWS_AS(CGAL::repair_pslg_2(pslg), CGAL::Pslg_crossing_error_2);
  CHECK_THROWS_AS(CGAL::Quality_mesher_2<>()(pslg), CGAL::Pslg_crossing_error_2);
}

TEST_CASE("Vertices that are too near to each other are in the error", "[pslg_errors]") {
  const auto check_near = [](const Pslg_error_2& error) {
    CAPTURE(error.what());
    CHECK(error.kind() == Kind::TOO_NEAR);
    const std::vector<std::size_t> vertices = numbers(error.parts().vertices);
    CHECK(std::count(vertices.begin(), vertices.end(), 0) == 1);
    CHECK(std::count(vertices.begin(), vertices.end(), 4) == 1);
    CHECK(vertices.size() <= 3);
    for (const std::size_t v : vertices) CHECK(has_text(error.what(), "vertex " + std::to_string(v) + " ("));
  };
  const auto square_with = [](double x, double y) {
    Pslg pslg = make_pslg<double>({{0, 0}, {1, -1}, {2, 0}, {1, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    pslg.add_vertex(Point(x, y));
    return pslg;
  };
  const auto by_trees = Options().separate(Options::Separation::THEOREM_5);
  check_near(refusal(square_with(0x1p-440, 0)));
  check_near(refusal(square_with(0x1p-70, 0), by_trees));
  CGAL::Pslg_2<Exact_traits::Point_2> exact;
  const Pslg pslg = square_with(0x1p-140, 0);
  for (const Point& p : pslg.vertices) exact.add_vertex({p.x(), p.y()});
  exact.segments = pslg.segments;
  check_near(refusal<Exact_traits>(exact, by_trees));
}

TEST_CASE("A seed on the border of components is in the error, with what it is on", "[pslg_errors]") {
  Pslg pslg = unit_square();
  pslg.add_segment(Vertex_index(0), Vertex_index(2));
  pslg.holes = {Point(0.5, 0.25), Point(0.5, 0.5)};
  check(refusal(pslg), Kind::AMBIGUOUS_SEED, {{}, {4}, {1}, {}, {}});
  pslg.holes.clear();
  pslg.regions = {{Point(1, 1), 0, 0}};
  const Pslg_error_2 on_vertex = refusal(pslg);
  check(on_vertex, Kind::AMBIGUOUS_SEED, {{2}, {}, {}, {0}, {}});

  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Tds = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                                   CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds> cdt;
  for (const auto& s : pslg.segments) cdt.insert_constraint(pslg.point(s[0]), pslg.point(s[1]));
  const std::vector<Point> seeds{Point(0.5, 0.25), Point(0.5, 0.5)};
  check(thrown_by([&] { CGAL::refine_quality_mesh_2(cdt, seeds); }), Kind::AMBIGUOUS_SEED,
        {{}, {}, {}, {}, {1}});
}

TEST_CASE("Errors for want of a domain name where the border is open", "[pslg_errors]") {
  const auto marked = Options().mesh_domain(Options::Domain::MARKED);
  Pslg pslg = unit_square();
  check(refusal(pslg, marked), Kind::NO_DOMAIN); // nothing is open, nothing marked
  pslg.holes = {Point(0.5, 0.5)};
  check(refusal(pslg), Kind::NO_DOMAIN);
  pslg.segments.pop_back();
  check(refusal(pslg), Kind::NO_DOMAIN, of_vertices({0, 3}));
  check(refusal(pslg, marked), Kind::NO_DOMAIN, of_vertices({0, 3}));
  const auto exact = make_pslg<double, Exact_traits::Point_2>({{0, 0}, {1, 0}, {0, 1}}, {{0, 1}, {1, 2}});
  check(refusal<Exact_traits>(exact), Kind::NO_DOMAIN, of_vertices({0, 2}));
  auto words = triangle({{1, 1}, {1001, 1}, {1, 1001}});
  words.segments.pop_back();
  check(refusal<Words>(words), Kind::NO_DOMAIN, of_vertices({0, 2}));
  pslg.segments.clear();
  check(refusal(pslg), Kind::NO_DOMAIN);
  pslg.add_segment(Vertex_index(1), Vertex_index(1));
  check(refusal(pslg), Kind::NO_DOMAIN);
}

TEST_CASE("An open ring is named where it misses its beginning by little", "[pslg_errors]") {
  // A second open chain is farther away. A vertex lies on a segment, and one has a twin: neither is an end.
  Pslg ring = make_pslg<double>(
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 1e-6}, {5, 5}, {6, 6}, {1, 0.5}, {2, 0.5}, {1, 1}},
      {{0, 1}, {1, 2}, {9, 3}, {3, 4}, {7, 8}, {5, 6}});
  check(refusal(ring), Kind::NO_DOMAIN, of_vertices({0, 4}));
  ring.first_number = 1;
  CHECK(has_text(refusal(ring).what(),
                 "no ring of them is closed; vertex 1 (0, 0) is an end of one segment only, "
                 "the nearest other such end is vertex 5 (0, 1e-06)"));
  // A closed ring with a hole does not hide the open one.
  const Vertex_index a = ring.add_vertex(Point(10, 10)), b = ring.add_vertex(Point(12, 10)),
                     c = ring.add_vertex(Point(10, 12));
  ring.add_segment(a, b), ring.add_segment(b, c), ring.add_segment(c, a);
  ring.holes = {Point(10.5, 10.5)};
  check(refusal(ring), Kind::NO_DOMAIN, of_vertices({0, 4}));
}

TEST_CASE("The segments that ask for too many triangles are in the error", "[pslg_errors]") {
  const Pslg pslg = make_pslg<double>(
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.25, 0.5}, {0.75, 0.5}, {0.25, 0.5 + 1e-9}, {0.75, 0.5 + 1e-9}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {6, 7}});
  const Pslg_error_2 error = refusal(pslg, Options().max_vertices(1000));
  CHECK(error.kind() == Kind::TOO_MANY_TRIANGLES);
  std::vector<std::size_t> segments = numbers(error.parts().segments);
  std::sort(segments.begin(), segments.end());
  CHECK(segments == std::vector<std::size_t>{4, 5});
  check(refusal(unit_square(), Options().max_area(1e-9).max_vertices(1000)), Kind::TOO_MANY_TRIANGLES);
}

TEST_CASE("The vertices between which doubles have no room are in the error", "[pslg_errors]") {
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_2;
  CGAL::Indexed_mesh_2<Exact_point> mesh;
  const CGAL::Exact_predicates_exact_constructions_kernel::FT tiny(0x1p-60);
  mesh.points = {Exact_point(0, 0), Exact_point(2, 0), Exact_point(1 + tiny, tiny)};
  mesh.number_of_input_vertices = 3;
  mesh.triangles = {{Vertex_index(0), Vertex_index(1), Vertex_index(2)}};
  mesh.neighbors.resize(1);
  mesh.segment_of_vertex.resize(3);
  mesh.vertex_markers.resize(3);
  const std::vector<Point> rounded{Point(0, 0), Point(2, 0), Point(1, 0)};
  const auto error = thrown_by([&] { CGAL::round_mesh_2<Point>(mesh, rounded); });
  check(error, Kind::ROUNDING, of_vertices({0, 1, 2}));
  CHECK(has_text(error.what(), "vertex at (1, 0)"));
  CHECK_THROWS_AS(CGAL::round_mesh_2<Point>(mesh, rounded), CGAL::Mesh_rounding_error_2);
}

} // namespace test_pslg_errors
