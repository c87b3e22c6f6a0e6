// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Least angles of sectors at vertices amid equal leaves: proven by vertex_certificates.h for all sectors. That the
// certificate is about the rule as it is computed, and about the triangulation of the whole mesh, is looked at for
// random sectors.

#include "catch.h"
#include "vertex_certificates.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_window.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace test_vertex_certificate {

namespace {

using namespace vertex_certificates;

/// @{ Boxes

constexpr std::int64_t roots_along = grid / side_of_roots;

Certificate certify(const Sector_kind& kind, const std::array<std::int64_t, 4>& place,
                    const Angle_bound& bound = bound_of_sectors) {
  return certify(kind, root_box(place), thresholds_of_rule(), bound);
}

/// All roots of one kind, those with the same x and y at a time.
Certificate certify_all(const Sector_kind& kind) {
  std::vector<Certificate> of_place(roots_along * roots_along);
  for_each_index<CGAL::Parallel_tag>(
      of_place.size(),
      [&](std::size_t i) {
        const auto k = static_cast<std::int64_t>(i);
        for (std::int64_t m = 0; m < roots_along; ++m)
          for (std::int64_t n = 0; n < (kind.turn == Turn::FULL ? 1 : roots_along); ++n)
            of_place[i].add(certify(kind, {k / roots_along, k % roots_along, m, n}));
      },
      1);
  Certificate all;
  for (const Certificate& c : of_place) all.add(c);
  return all;
}

void check_all(std::size_t first, std::size_t last) {
  for (std::size_t k = first; k <= last; ++k) {
    const Sector_kind& kind = sector_kinds()[k];
    const Certificate c = certify_all(kind);
    CAPTURE(k, c.boxes, c.tests, c.depth);
    CHECK(c.is_proven);
    WARN("octants " << kind.octants.first << ", " << kind.octants.second << ": " << c.boxes << " boxes, "
                    << c.tests << " tests, divided at most " << c.depth << " times");
  }
}

/// A box of a 128th around parameters.
Deep_box box_around(const std::array<double, 4>& parameters) {
  constexpr std::int64_t side = grid / 128;
  Deep_box b{{}, 0};
  for (std::size_t d = 0; d < 4; ++d) {
    b.box.low[d] = static_cast<std::int64_t>(parameters[d] * double(grid)) / side * side;
    b.box.side[d] = side;
  }
  return b;
}

/// @}

/// @{ Single sectors

/// The vertex's place and the slopes are multiples of 1/`grid`.
struct Sector {
  Sector_kind kind;
  Sector_parameters point;

  Sector_box box() const { return {kind.octants, kind.turn, point}; }
  Window_point vertex() const { return {parameter(0), parameter(1)}; }
  Window_point direction(std::size_t edge) const {
    const Octant_direction d = direction_in(edge == 0 ? kind.octants.first : kind.octants.second);
    const double m = parameter(kind.turn == Turn::FULL ? 2 : 2 + edge);
    const double x = d.constant[0] + d.slope[0] * m, y = d.constant[1] + d.slope[1] * m;
    return {x / std::hypot(x, y), y / std::hypot(x, y)};
  }
  double parameter(std::size_t d) const { return double(point.low[d]) / double(grid); }
};

struct Random {
  std::mt19937_64 generator;
  std::int64_t below(std::int64_t n) {
    return static_cast<std::int64_t>(generator() % static_cast<std::uint64_t>(n));
  }

  Sector sector() {
    for (;;) {
      Sector s;
      s.kind = {{std::size_t(below(8)), std::size_t(below(8))}, Turn::LESS_THAN_HALF};
      if (s.kind.octants.first == s.kind.octants.second) s.kind.turn = Turn(below(3));
      // Every fourth with few digits, so that points are on lines and circles.
      const std::int64_t step = below(4) == 0 ? grid / 16 : 1;
      // A vertex is in a leaf without the leaf's greater sides. Along diagonals octants would be two.
      for (std::int64_t& value : s.point.low) value = step * below(grid / step);
      s.point.side = {};
      const Sector_box box = s.box();
      if (box.is_at_least(cotangent_of_least_sector) == Answer::YES &&
          box.is_other_side_at_least(cotangent_of_least_sector) == Answer::YES)
        return s;
    }
  }
};

/// @}

/// @{ The mesh of a sector, far beyond the region, by CGAL

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

class Whole_mesh {
public:
  Whole_mesh(const Sector& s, const Sector_thresholds& thresholds) {
    const Window_point v = s.vertex();
    const std::array<Window_point, 2> d{s.direction(0), s.direction(1)};
    Vertex_window window(v, d[0], d[1]);
    for (const Window_point& e : d) insert_edge(v, e);
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j) {
        const Window_point p{double(i), double(j)};
        if (window.is_in_sector(p) && window.is_kept(p, thresholds)) insert(p);
      }
    for (auto e = cdt_.finite_edges_begin(); e != cdt_.finite_edges_end(); ++e)
      sides_.insert(
          sorted(place(e->first->vertex(Cdt::cw(e->second))), place(e->first->vertex(Cdt::ccw(e->second)))));
  }

  bool has_side(const Window_point& p, const Window_point& q) const {
    return sides_.count(sorted(rounded(p), rounded(q))) > 0;
  }

private:
  using Place = std::array<std::int64_t, 2>;
  static constexpr int reach = 12;

  void insert_edge(const Window_point& v, const Window_point& e) {
    const Edge_axis axis = Edge_axis::of(e);
    const Edge_start start = edge_start(v, e, axis);
    std::vector<double> distances{0, start.distances[0], start.distances[1]};
    for (double t = start.first_crossing; t < reach; t += 1 / std::abs(axis.along(e))) distances.push_back(t);
    Cdt::Vertex_handle last;
    for (const double t : distances) {
      const auto next = insert({v.x + t * e.x, v.y + t * e.y});
      if (t > 0) cdt_.insert_constraint(last, next);
      last = next;
    }
  }
  Cdt::Vertex_handle insert(const Window_point& p) { return cdt_.insert(Kernel::Point_2(p.x, p.y)); }

  static Place place(Cdt::Vertex_handle v) { return rounded({v->point().x(), v->point().y()}); }
  static Place rounded(const Window_point& p) {
    return {std::llround(p.x * double(units)), std::llround(p.y * double(units))};
  }
  static std::array<Place, 2> sorted(const Place& p, const Place& q) {
    return p < q ? std::array<Place, 2>{p, q} : std::array<Place, 2>{q, p};
  }

  Cdt cdt_;
  std::set<std::array<Place, 2>> sides_;
};

/// @}

Thresholds in_64ths(const Sector_thresholds& t) {
  return {std::llround(threshold_units * t.clear_of_vertex), std::llround(threshold_units * t.clear_of_edge)};
}

} // namespace

TEST_CASE("Bounds of certificates are on the safe side", "[columns]") {
  const auto degrees = [](double cotangent) { return std::atan(1 / cotangent) * 180 / CGAL_PI; };
  CHECK(degrees(double(bound_of_sectors.cotangent) / double(Angle_bound::units)) > least_angle_of_sectors);
  CHECK(degrees(double(cotangent_of_least_sector) / 100) < least_sector);
  for (const Sector_thresholds& t : sector_thresholds) {
    CHECK(double(in_64ths(t).of_vertex) == threshold_units * t.clear_of_vertex);
    CHECK(double(in_64ths(t).of_edge) == threshold_units * t.clear_of_edge);
  }
  CHECK(far_threshold == threshold_units * equal_leaves_threshold);
}

TEST_CASE("Kinds of sectors are all, but for symmetry", "[columns]") {
  // By quarters of a turn, and by the mirror that exchanges x and y and so both edges.
  std::set<std::array<std::size_t, 2>> found;
  for (const Sector_kind& k : sector_kinds()) {
    if (k.turn != Turn::LESS_THAN_HALF) continue;
    for (std::size_t quarter = 0; quarter < 8; quarter += 2) {
      const std::size_t a = (k.octants.first + quarter) % 8, b = (k.octants.second + quarter) % 8;
      found.insert({a, b});
      found.insert({(9 - b) % 8, (9 - a) % 8});
    }
  }
  CHECK(found.size() == 64);
}

TEST_CASE("Sectors have angles of at least 20.7 degrees: a sample of boxes", "[columns]") {
  Random random{std::mt19937_64(1)};
  std::size_t boxes = 0;
  for (const Sector_kind& kind : sector_kinds())
    for (int i = 0; i < (is_full_run() ? 2 : 1); ++i) {
      const std::array<std::int64_t, 4> place{random.below(roots_along), random.below(roots_along),
                                              random.below(roots_along), random.below(roots_along)};
      CAPTURE(kind.octants.first, kind.octants.second, place);
      const Certificate c = certify(kind, place);
      CHECK(c.is_proven);
      boxes += c.boxes;
    }
  CHECK(boxes > sector_kinds().size());
}

TEST_CASE("Narrow sectors have angles of at least 20.7 degrees", "[columns][.slow]") { check_all(0, 2); }
TEST_CASE("Sectors from 45 degrees have angles of at least 20.7 degrees", "[columns][.slow]") {
  check_all(3, 4);
}
TEST_CASE("Obtuse sectors have angles of at least 20.7 degrees", "[columns][.slow]") { check_all(5, 5); }
TEST_CASE("Sectors of about half a turn have angles of at least 20.7 degrees", "[columns][.slow]") {
  check_all(6, 7);
}
TEST_CASE("Sectors of more than half a turn have angles of at least 20.7 degrees", "[columns][.slow]") {
  check_all(8, 13);
}

TEST_CASE("Certificates of sectors fail where the bound or the rule is wrong", "[columns]") {
  // The worst sector that a search found, with 21.6 degrees.
  const Sector_kind kind{{3, 6}, Turn::LESS_THAN_HALF};
  const Deep_box box = box_around({.1563, .7489, .3768, .9908});
  const std::vector<Thresholds> all = thresholds_of_rule();
  CHECK(certify(kind, box, all, bound_of_sectors).is_proven);
  CHECK_FALSE(certify(kind, box, all, Angle_bound{120}).is_proven); // 21.8 degrees
  // Corners too near an edge, or none where they are needed.
  CHECK_FALSE(certify(kind, box, {{55, 1}}, bound_of_sectors).is_proven);
  CHECK_FALSE(certify(kind, box, {{160, 54}}, bound_of_sectors).is_proven);
}

TEST_CASE("No pair of thresholds is good for all sectors", "[columns]") {
  constexpr Turn less = Turn::LESS_THAN_HALF;
  struct Place {
    Sector_kind kind;
    std::array<double, 4> parameters;
  };
  // Found by a search for each pair: 19.2, 17.1 and 6.7 degrees.
  const std::array<Place, 3> places{{{{{4, 5}, less}, {.6340, .7553, .9678, .0198}},
                                     {{{3, 6}, less}, {.5990, .1538, .9987, .5766}},
                                     {{{6, 2}, less}, {.5232, .1677, .9998, .0740}}}};
  const std::vector<Thresholds> all = thresholds_of_rule();
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(i);
    const Deep_box box = box_around(places[i].parameters);
    CHECK_FALSE(certify(places[i].kind, box, {all[i]}, bound_of_sectors).is_proven);
    CHECK(certify(places[i].kind, box, all, bound_of_sectors).is_proven);
  }
}

TEST_CASE("Certificates are about the rule as it is computed", "[columns]") {
  Random random{std::mt19937_64(3)};
  const int n = is_full_run() ? 20000 : 200;
  for (int i = 0; i < n; ++i) {
    const Sector s = random.sector();
    CAPTURE(i, s.kind.octants.first, s.kind.octants.second, s.point.low);
    Vertex_window window(s.vertex(), s.direction(0), s.direction(1));
    const Sector_box box = s.box();
    const Sector_region region(box);
    const Sector_vertices vertices(box, region);
    for (std::size_t v = 0; v < vertices.all().size(); ++v) {
      const auto& vertex = vertices.all()[v];
      if (!vertex.is_corner()) continue;
      for (const Sector_thresholds& t : sector_thresholds) {
        const auto kept = vertices.is_kept(v, in_64ths(t));
        if (!kept || *kept == Answer::OPEN) continue;
        CHECK((*kept == Answer::YES) ==
              (window.is_in_sector(vertex.center) && window.is_kept(vertex.center, t)));
      }
    }
    for (std::size_t e = 0; e < (box.is_only_edge() ? 1 : 2); ++e) {
      const Window_point d = s.direction(e);
      const Edge_start start = edge_start(s.vertex(), d, Edge_axis::of(d));
      const std::array<double, 3> distances{start.distances[0], start.distances[1], start.first_crossing};
      for (const auto& vertex : vertices.all())
        if (vertex.edges == 1u << e && vertex.number <= 3) {
          const double t = distances[vertex.number - 1];
          CHECK(vertex.center.x == Approx(s.vertex().x + t * d.x).margin(1e-9));
          CHECK(vertex.center.y == Approx(s.vertex().y + t * d.y).margin(1e-9));
        }
    }
    // The choice that is made by a window is a good one.
    const Thresholds chosen = in_64ths(sector_thresholds[window.best_of(sector_thresholds)]);
    CHECK(Sector_certifier(box, bound_of_sectors).is_good(chosen));
  }
}

TEST_CASE("The boundary of a certified region is in the triangulation of the whole mesh", "[columns]") {
  Random random{std::mt19937_64(4)};
  const int n = is_full_run() ? 5000 : 50;
  int looked_at = 0;
  for (int i = 0; i < n; ++i) {
    const Sector s = random.sector();
    const Sector_thresholds thresholds = sector_thresholds[std::size_t(random.below(3))];
    CAPTURE(i, s.kind.octants.first, s.kind.octants.second, s.point.low, thresholds.clear_of_vertex);
    const Sector_box box = s.box();
    const Sector_region region(box);
    const Sector_vertices vertices(box, region);
    std::vector<char> is_kept(vertices.all().size(), 1);
    bool is_open = false;
    for (std::size_t v = vertices.number_on_edges(); v < is_kept.size(); ++v) {
      const auto kept = vertices.is_kept(v, in_64ths(thresholds));
      is_open = is_open || !kept || *kept == Answer::OPEN;
      is_kept[v] = kept && *kept == Answer::YES ? 1 : 0;
    }
    Sector_mesh mesh(box, region, vertices);
    if (is_open || !mesh.triangulate(is_kept, is_kept)) continue;
    const Whole_mesh whole(s, thresholds);
    ++looked_at;
    const auto boundary = mesh.boundary();
    CHECK(boundary.size() > 10);
    for (const auto& side : boundary)
      CHECK(whole.has_side(vertices.all()[side.first].center, vertices.all()[side.second].center));
  }
  CHECK(looked_at > n / 2); // few have corners just at a threshold
}

TEST_CASE("Strips behind the region keep the corners that their edge keeps", "[columns]") {
  Random random{std::mt19937_64(5)};
  const int n = is_full_run() ? 100000 : 1000;
  for (int i = 0; i < n; ++i) {
    const Sector s = random.sector();
    CAPTURE(i, s.kind.octants.first, s.kind.octants.second, s.point.low);
    const std::int64_t last_line = Sector_region(s.box()).last_line();
    Vertex_window window(s.vertex(), s.direction(0), s.direction(1));
    for (std::size_t e = 0; e < 2; ++e) {
      const Window_point v = s.vertex(), d = s.direction(e);
      const Edge_axis axis = Edge_axis::of(d);
      const double slope = axis.is_steep ? d.x / d.y : d.y / d.x, length = std::hypot(1, slope);
      const double left = axis.is_steep == axis.is_ascending ? -1 : 1, up = e == 0 ? left : -left;
      for (int line = int(last_line); line < 12; ++line) {
        const auto height = [&](int k) {
          const double x = axis.line(k) - axis.along(v);
          return up * ((axis.is_steep ? v.x : v.y) + slope * x);
        };
        // No corner is dropped from here on, on the lines before and behind the strip.
        const double whole =
            std::ceil(std::max(height(line), height(line + 1)) + equal_leaves_threshold * length);
        for (const int k : {line, line + 1})
          for (double row = std::ceil(height(k)); row <= whole; ++row) {
            const double across = up * row, along = axis.line(k);
            const Window_point p = axis.is_steep ? Window_point{across, along} : Window_point{along, across};
            const double distance = (row - height(k)) / length;
            if (std::abs(distance - equal_leaves_threshold) < 1e-9 || distance < 1e-9) continue;
            for (const Sector_thresholds& t : sector_thresholds)
              CHECK((window.is_in_sector(p) && window.is_kept(p, t)) == (distance >= equal_leaves_threshold));
          }
      }
    }
  }
}

} // namespace test_vertex_certificate
