// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "pslg_test_tools.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/intersections.h>
#include <CGAL/repair_pslg_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

// Graphs whose vertices and segments are units in the last place apart are repaired: nothing crosses, nothing
// moves by more than some of these units, and there are no more vertices than crossings ask for.

namespace test_repair_near_degenerate {

using namespace pslg_test;
using Segment = CGAL::Exact_predicates_inexact_constructions_kernel::Segment_2;

namespace {

const auto splitting = CGAL::Pslg_repair_options_2().crossings(CGAL::Pslg_crossing_rule_2::SPLIT);
constexpr double unit = std::numeric_limits<double>::epsilon();
/// What segments bend by at most, in units of the largest coordinate.
constexpr double most_bend = 64 * unit;

// --- What holds for a repaired graph, by looking at all pairs
// -----------------------------------------------------------------

Segment segment(const Pslg& pslg, std::size_t s) {
  return {pslg.point(pslg.segments[s][0]), pslg.point(pslg.segments[s][1])};
}

bool is_inside(const Point& p, const Segment& s) { return s.has_on(p) && p != s.source() && p != s.target(); }

/// Whether two segments have a point in common that is not an end of both.
bool do_overlap_or_cross(const Segment& s, const Segment& t) {
  if (s == t || s == t.opposite()) return true;
  if (!CGAL::do_intersect(s, t)) return false;
  const bool have_common_end = s.source() == t.source() || s.source() == t.target() ||
                               s.target() == t.source() || s.target() == t.target();
  return !have_common_end || is_inside(s.source(), t) || is_inside(s.target(), t) ||
         is_inside(t.source(), s) || is_inside(t.target(), s);
}

std::size_t count_faulty_pairs(const Pslg& pslg) {
  std::size_t faults = 0;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment own = segment(pslg, s);
    faults += own.is_degenerate();
    const CGAL::Bbox_2 box = own.bbox();
    for (std::size_t t = 0; t < s; ++t) {
      const Segment other = segment(pslg, t);
      if (CGAL::do_overlap(box, other.bbox())) faults += do_overlap_or_cross(own, other);
    }
    for (const Point& p : pslg.vertices) faults += CGAL::do_overlap(box, p.bbox()) && is_inside(p, own);
  }
  std::vector<Point> places = pslg.vertices;
  std::sort(places.begin(), places.end());
  faults += std::size_t(places.end() - std::unique(places.begin(), places.end()));
  return faults;
}

double largest_coordinate(const Pslg& pslg) {
  double largest = 0;
  for (const Point& p : pslg.vertices) largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y())});
  return largest;
}

double distance(const Point& p, const Segment& s) {
  const double dx = s.target().x() - s.source().x(), dy = s.target().y() - s.source().y();
  const double x = p.x() - s.source().x(), y = p.y() - s.source().y();
  const double length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(x, y);
  const double along = (x * dx + y * dy) / length;
  return std::hypot((x * dy - y * dx) / length, (std::max)({0., -along, along - length}));
}

/// Whether pieces next to a segment lead from one of its ends to the other.
bool is_covered(const Segment& s, const Pslg& output, Vertex_index from, Vertex_index to) {
  const double bend = most_bend * largest_coordinate(output);
  std::vector<bool> is_reached(output.vertices.size(), false);
  is_reached[from.value()] = true;
  const auto is_near = [&](Vertex_index v) { return distance(output.point(v), s) <= bend; };
  for (bool goes_on = true; goes_on && !is_reached[to.value()];) {
    goes_on = false;
    for (const auto& piece : output.segments) {
      if (is_reached[piece[0].value()] == is_reached[piece[1].value()]) continue;
      if (!is_near(piece[0]) || !is_near(piece[1])) continue;
      is_reached[piece[0].value()] = is_reached[piece[1].value()] = goes_on = true;
    }
  }
  return is_reached[to.value()];
}

void check_is_repaired(const Pslg& input) {
  CGAL::Pslg_repair_report_2 report;
  const Pslg output = CGAL::repair_pslg_2(input, splitting, report);
  CHECK(count_faulty_pairs(output) == 0);
  REQUIRE(report.vertex_map.size() == input.vertices.size());
  for (std::size_t v = 0; v < input.vertices.size(); ++v)
    REQUIRE(output.point(report.vertex_map[v]) == input.vertices[v]);
  CHECK(output.vertices.size() == input.vertices.size() - report.merged_vertices + report.crossings);
  CHECK(report.crossings <= input.segments.size() * input.segments.size() / 2);
  for (std::size_t s = 0; s < input.segments.size(); ++s)
    CHECK(is_covered(segment(input, s), output, report.vertex_map[input.segments[s][0].value()],
                     report.vertex_map[input.segments[s][1].value()]));
  REQUIRE(report.segment_origin.size() == output.segments.size());
  CHECK(std::is_sorted(report.segment_origin.begin(), report.segment_origin.end()));
  const double bend = most_bend * largest_coordinate(output);
  for (std::size_t s = 0; s < output.segments.size(); ++s)
    for (const Vertex_index v : output.segments[s])
      CHECK(distance(output.point(v), segment(input, report.segment_origin[s].value())) <= bend);
}

// --- Graphs
// -----------------------------------------------------------------------------------------------------------------

/// Random graphs whose parts are a few steps of doubles apart.
class Steps_apart {
public:
  explicit Steps_apart(unsigned seed) : random_(seed) {}

  double coordinate() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }

  /// At most `steps` from x.
  double near(double x, int steps) {
    int way = whole(-steps, steps);
    for (; way > 0; --way) x = std::nextafter(x, 2.);
    for (; way < 0; ++way) x = std::nextafter(x, -2.);
    return x;
  }
  Point near(const Point& p, int steps) {
    const double x = near(p.x(), steps);
    return {x, near(p.y(), steps)};
  }
  Point place() {
    const double x = coordinate();
    return {x, coordinate()};
  }

  static void add(Pslg& pslg, const Point& a, const Point& b) {
    const Vertex_index v = pslg.add_vertex(a);
    pslg.add_segment(v, pslg.add_vertex(b));
  }

  Pslg segments_along_a_line(int segments) {
    Pslg pslg;
    const Point origin = place(), way = place();
    const auto end = [&] {
      const double t = coordinate();
      return near(Point(origin.x() + t * way.x(), origin.y() + t * way.y()), 3);
    };
    for (int i = 0; i < segments; ++i) {
      const Point a = end();
      add(pslg, a, end());
    }
    return pslg;
  }

  Pslg segments_between_clusters(int clusters, int size, int segments) {
    Pslg pslg;
    for (int i = 0; i < clusters; ++i) {
      const Point center = place();
      for (int j = 0; j < size; ++j) pslg.add_vertex(near(center, 3));
    }
    for (int i = 0; i < segments; ++i) {
      const std::size_t a(whole(0, clusters * size - 1)), b(whole(0, clusters * size - 1));
      pslg.add_segment(Vertex_index(a), Vertex_index(b));
    }
    return pslg;
  }

  Pslg segments_within_steps(int segments) {
    Pslg pslg = make_pslg<double>({{1.5, 0}, {1.5, 1}});
    const Point center = place();
    for (int i = 0; i < segments; ++i) {
      const Point a = near(center, 8);
      add(pslg, a, near(center, 8));
    }
    return pslg;
  }

  Pslg segments_through_a_point(int segments) {
    Pslg pslg;
    const Point center = place();
    for (int i = 0; i < segments; ++i) {
      const Point way = place();
      add(pslg, Point(center.x() + way.x(), center.y() + way.y()),
          Point(center.x() - way.x(), center.y() - way.y()));
    }
    return pslg;
  }

  /// Ever smaller triangles with two sides along two rays, from one of two vertices a step apart.
  Pslg nested_triangles(int triangles) {
    Pslg pslg;
    const Point apex = place();
    pslg.add_vertex(apex);
    pslg.add_vertex(near(apex, 1));
    const double angle = 3 * coordinate(), other_angle = angle + coordinate();
    const double ratio = 0.5 + 0.4 * coordinate();
    double size = 1;
    for (int i = 0; i < triangles; ++i, size *= ratio) {
      const auto corner = [&](double a) {
        return pslg.add_vertex(Point(apex.x() + size * std::cos(a), apex.y() + size * std::sin(a)));
      };
      const Vertex_index b = corner(angle), c = corner(other_angle);
      for (int twice = 0; twice < 2; ++twice) {
        const Vertex_index a(std::size_t(whole(0, 1)));
        pslg.add_segment(a, b);
        pslg.add_segment(b, c);
        pslg.add_segment(c, a);
      }
    }
    return pslg;
  }

private:
  std::mt19937_64 random_;
};

Pslg read(const char* name) {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(data_file(name), pslg);
  return pslg;
}

} // namespace

TEST_CASE("crossings that grew when rounded are split", "[repair]") {
  for (const char* name : {"hard_repair_grows.poly", "hard_repair_islands.poly"}) {
    CAPTURE(name);
    check_is_repaired(read(name));
  }
}

TEST_CASE("segments units apart are repaired without crossings", "[repair]") {
  const unsigned rounds = is_full_run() ? 1000 : 16;
  for (unsigned seed = 0; seed < rounds; ++seed) {
    CAPTURE(seed);
    Steps_apart random(seed);
    {
      INFO("along a line");
      check_is_repaired(random.segments_along_a_line(12));
    }
    {
      INFO("between clusters");
      check_is_repaired(random.segments_between_clusters(2 + int(seed % 3), 2 + int(seed % 4), 14));
    }
    {
      INFO("within steps");
      check_is_repaired(random.segments_within_steps(12));
    }
    {
      INFO("through a point");
      check_is_repaired(random.segments_through_a_point(10));
    }
    {
      INFO("nested triangles");
      check_is_repaired(random.nested_triangles(5));
    }
  }
}

TEST_CASE("what crosses at the end of the range of doubles is refused by name", "[repair]") {
  Pslg pslg;
  for (const Point& p : {Point(0, 0), Point(1.7e308, 0), Point(-1.7e308, 1.7e308), Point(1, -1.7e308)})
    pslg.add_vertex(p);
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(2, 3), std::pair(1, 2)})
    pslg.add_segment(Vertex_index(a), Vertex_index(b));
  try {
    CGAL::repair_pslg_2(pslg, splitting);
    FAIL("no error");
  } catch (const CGAL::Pslg_error_2& error) {
    CHECK(error.kind() == CGAL::Pslg_error_2::Kind::OUT_OF_RANGE);
    CHECK(error.parts().vertices == std::vector{Vertex_index(1)});
  }
}

TEST_CASE("segments whose crossings find no room are named with the place", "[repair]") {
  // No graph is known that is not repaired, so two pieces are made to cross.
  const Pslg input = make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1}, {0, 2}, {1, 3}});
  const Pslg pieces =
      make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {3, 3}}, {{0, 1}, {0, 4}, {4, 2}, {1, 3}});
  const std::vector<Segment_index> origin{Segment_index(0), Segment_index(1), Segment_index(1),
                                          Segment_index(2)};
  try {
    CGAL::Quadtree_mesh_2::internal::throw_no_room(input, pieces, origin, Segment_index(3));
  } catch (const CGAL::Pslg_error_2& error) {
    CHECK(error.kind() == CGAL::Pslg_error_2::Kind::ROUNDING);
    CHECK(error.parts().segments == std::vector<Segment_index>{Segment_index(1), Segment_index(2)});
    CHECK(std::string(error.what()) == "doubles are too coarse at (2, 2) to round the crossings of segment 1 "
                                       "from vertex 0 (0, 0) to vertex 2 "
                                       "(4, 4) and segment 2 from vertex 1 (4, 0) to vertex 3 (0, 4)");
  }
}

} // namespace test_repair_near_degenerate
