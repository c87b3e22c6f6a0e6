// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Borders left as they are: no vertices on kept segments, meshes of neighbors that fit, and what cannot meet a bound
// for it, with the segment that is in the way.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "numbers_of_threads.h"
#include "random_pslg.h"
#include "random_pslg_shapes.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_keep_borders {

using namespace test_meshes;
using Options = CGAL::Quality_mesh_options_2;
using Report = CGAL::Quality_mesh_report_2;
using Keep = Options::Keep_borders;
using Mesher = CGAL::Quality_mesher_2<>;

namespace {

/// The indices of the segments with new vertices on them.
std::set<std::size_t> segments_cut(const Mesh& mesh) {
  std::set<std::size_t> cut;
  for (std::size_t v = mesh.number_of_input_vertices; v < mesh.points.size(); ++v)
    if (mesh.segment_of_vertex[v].is_valid()) cut.insert(std::size_t(mesh.segment_of_vertex[v]));
  return cut;
}

/// How many edges of the mesh are on each segment.
std::vector<std::size_t> edges_on_segments(const Mesh& mesh, const Pslg& pslg) {
  std::vector<std::size_t> n(pslg.segments.size(), 0);
  for (const auto& e : mesh.constrained_edges) ++n[std::size_t(e.segment)];
  return n;
}

double distance(const Point& p, const Point& a, const Point& b) {
  return std::sqrt(CGAL::squared_distance(p, CGAL::Segment_2<Kernel>(a, b)));
}

/// That a segment named is within reach of its triangle: where a vertex would go to cure the triangle, so next to the
/// off-center of its shortest edge, or beside its circumcenter.
void check_reach(const Mesh& mesh, const Pslg& pslg, const Report::Unmet_triangle& unmet) {
  const auto& t = mesh.triangles[std::size_t(unmet.triangle)];
  const auto& s = pslg.segments[std::size_t(unmet.segment)];
  const Point &a = pslg.point(s[0]), &b = pslg.point(s[1]);
  double near = distance(mesh.point(t[0]), a, b), longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    near = std::min(near, distance(mesh.point(t[k]), a, b));
    longest =
        std::max(longest, std::sqrt(CGAL::squared_distance(mesh.point(t[k]), mesh.point(t[(k + 1) % 3]))));
  }
  // A vertex harms no segment that it is farther from than the segment is long.
  const double length = std::sqrt(CGAL::squared_distance(a, b));
  if (near > 3 * longest + length) FAIL_CHECK("the segment is far from the triangle");
}

struct Count {
  std::size_t triangles = 0, unmet = 0;
};

/// Meshes with borders kept, and checks what is promised.
/// \param is_kept says of a segment, by its index, whether it is kept
template <class Is_kept>
Count check_kept(const Pslg& pslg, const Options& options, const Is_kept& is_kept) {
  Mesher mesher(options);
  const Mesh mesh = mesher(pslg);
  const Report& report = mesher.report();
  for (const std::size_t s : segments_cut(mesh))
    if (is_kept(s)) FAIL_CHECK("a vertex is on segment " << s);
  const auto quality = CGAL::mesh_quality_2(
      mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(options.min_angle()).max_edge(options.max_edge()));
  CHECK(quality.is_valid());
  std::set<std::size_t> reported;
  for (const auto& unmet : report.unmet_triangles) {
    reported.insert(std::size_t(unmet.triangle));
    CHECK(unmet.segment.is_valid() == (unmet.reason == Report::Reason::KEPT_SEGMENT));
    if (unmet.reason != Report::Reason::KEPT_SEGMENT)
      FAIL_CHECK("another reason: " << int(unmet.reason));
    else if (!is_kept(std::size_t(unmet.segment)))
      FAIL_CHECK("the segment may get vertices");
    else
      check_reach(mesh, pslg, unmet);
  }
  // The checker excuses a little more, as it knows all segments a triangle is between, but nothing else.
  for (const auto& unmet : quality.unmet_triangles) CHECK(reported.count(std::size_t(unmet.triangle)) == 1);
  return {mesh.triangles.size(), report.unmet_triangles.size()};
}

/// Every second one of the segments.
bool is_even(std::size_t s) { return s % 2 == 0; }

/// The edges of a mesh that are on a segment with a marker, by the coordinates of their ends.
std::set<std::array<double, 4>> marked_edges(const Mesh& mesh, int marker) {
  std::set<std::array<double, 4>> edges;
  for (const auto& e : mesh.constrained_edges) {
    if (e.marker != marker) continue;
    Point p = mesh.point(e.vertices[0]), q = mesh.point(e.vertices[1]);
    if (q < p) std::swap(p, q);
    edges.insert({p.x(), p.y(), q.x(), q.y()});
  }
  return edges;
}

/// A chain of edges along an arc from (0, 0) to (0, 6), of different lengths.
std::vector<Point> coast() {
  std::vector<Point> chain{Point(0, 0)};
  random_pslg::Random random(7);
  for (double y = random.between(0.05, 0.3); y < 5.9; y += random.between(0.05, 0.3))
    chain.push_back(Point(0.8 * std::sin(y), y));
  chain.push_back(Point(0, 6));
  return chain;
}

/// The domain between the chain and a corner on its right or left; the chain has marker 5, the rest 0.
Pslg beside(const std::vector<Point>& chain, double x) {
  Pslg pslg;
  for (const Point& p : chain) pslg.add_vertex(p);
  pslg.add_vertex(Point(x, 6)), pslg.add_vertex(Point(x, 0));
  for (std::size_t v = 0; v < pslg.vertices.size(); ++v) {
    add_segment(pslg, v, (v + 1) % pslg.vertices.size());
    pslg.segment_markers.push_back(v + 1 < chain.size() ? 5 : 0);
  }
  return pslg;
}

} // namespace

TEST_CASE("random graphs with all borders kept", "[keep_borders]") {
  const std::uint64_t seeds = is_full_run() ? 70 : 3; // of 15 families
  const auto families = random_pslg::all_families();
  Count sum, of_free;
  for (const auto& family : families)
    for (std::uint64_t seed = 1000; seed < 1000 + seeds; ++seed) {
      CAPTURE(family.name, seed);
      const Pslg pslg = family.make(seed);
      const Count kept =
          check_kept(pslg, Options().keep_borders(Keep::ALL), [](std::size_t) { return true; });
      Mesher free;
      of_free.triangles += free(pslg).triangles.size();
      // Without vertices on segments there is less to refine.
      CHECK(double(kept.triangles) <= 4 * free.report().estimated_triangles + 100);
      sum.triangles += kept.triangles, sum.unmet += kept.unmet;
    }
  CHECK(sum.triangles < of_free.triangles);
  CHECK(sum.unmet < sum.triangles / 4);
}

TEST_CASE("random graphs with marked borders kept", "[keep_borders]") {
  const std::uint64_t seeds = is_full_run() ? 70 : 2;
  std::size_t others_cut = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 2000; seed < 2000 + seeds; ++seed) {
      CAPTURE(family.name, seed);
      Pslg pslg = family.make(seed);
      for (std::size_t s = 0; s < pslg.segments.size(); ++s)
        pslg.segment_markers.push_back(is_even(s) ? (s % 4 == 0 ? 7 : -1) : 0);
      check_kept(pslg, Options().keep_borders(Keep::MARKED), is_even);
      others_cut += segments_cut(Mesher(Options().keep_borders(Keep::MARKED))(pslg)).size();
    }
  CHECK(others_cut > 0);
}

TEST_CASE("no markers, or markers of 0, keep nothing", "[keep_borders]") {
  Pslg pslg = random_pslg::families()[0].make(3);
  const Mesh free = Mesher()(pslg);
  CHECK(Mesher(Options().keep_borders(Keep::MARKED))(pslg).triangles == free.triangles);
  pslg.segment_markers.assign(pslg.segments.size(), 0);
  CHECK(Mesher(Options().keep_borders(Keep::MARKED))(pslg).triangles == free.triangles);
}

TEST_CASE("along edges that several segments share, one that is kept keeps them", "[keep_borders]") {
  for (const bool is_first_kept : {true, false}) {
    Pslg pslg;
    add_polygon(pslg, square(0, 0, 2));
    for (const double x : {-1., 0., 1.}) pslg.add_vertex(Point(x, 0));
    pslg.add_vertex(Point(0.3, 0.02)); // asks for vertices on the segments
    add_segment(pslg, 4, 6), add_segment(pslg, 5, 6);
    pslg.segment_markers = {0, 0, 0, 0, is_first_kept ? 1 : 0, is_first_kept ? 0 : 1};
    const Mesh mesh = Mesher(Options().keep_borders(Keep::MARKED))(pslg);
    std::size_t between = 0;
    for (std::size_t v = mesh.number_of_input_vertices; v < mesh.points.size(); ++v)
      between += mesh.points[v].y() == 0 && mesh.points[v].x() > 0 && mesh.points[v].x() < 1 ? 1 : 0;
    CHECK(between == 0);
    CHECK(segments_cut(Mesher()(pslg)).size() > 0);
  }
}

TEST_CASE("the boundary alone is kept, with the domain on one side", "[keep_borders]") {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 4));
  add_polygon(pslg, square(2, 2, 0.5));
  pslg.holes.push_back(Point(2, 2));
  pslg.add_vertex(Point(-3, -3.5)), pslg.add_vertex(Point(3, -3)), pslg.add_vertex(Point(0, -3.2));
  add_segment(pslg, 8, 9);
  const Count n =
      check_kept(pslg, Options().keep_borders(Keep::BOUNDARY), [](std::size_t s) { return s < 8; });
  CHECK(n.triangles > 0);
  const Mesh mesh = Mesher(Options().keep_borders(Keep::BOUNDARY))(pslg);
  CHECK(segments_cut(mesh) == std::set<std::size_t>{8});
  CHECK(segments_cut(Mesher(Options().keep_borders(Keep::ALL))(pslg)).empty());
  const auto on = edges_on_segments(mesh, pslg);
  CHECK(std::count(on.begin(), on.begin() + 8, std::size_t(1)) == 8);
}

TEST_CASE("meshes of two neighboring domains fit edge by edge", "[keep_borders]") {
  const std::vector<Point> chain = coast();
  for (const double angle : {20.7, 30.}) {
    const Options options = Options().min_angle(angle).max_edge(0.4).keep_borders(Keep::MARKED);
    const Mesh left = Mesher(options)(beside(chain, -5)), right = Mesher(options)(beside(chain, 5));
    const auto border = marked_edges(left, 5);
    CHECK(border.size() == chain.size() - 1);
    CHECK(border == marked_edges(right, 5)); // bit for bit
    // Where nothing is kept, they do not fit.
    const Options free = Options().min_angle(angle).max_edge(0.1);
    CHECK(marked_edges(Mesher(free)(beside(chain, -5)), 5) !=
          marked_edges(Mesher(free)(beside(chain, 3)), 5));
    // With edges no longer than the bound, nearly all is met.
    for (const double x : {-5., 5.}) {
      Mesher mesher(options);
      mesher(beside(chain, x));
      CHECK(mesher.report().unmet_triangles.size() <= (angle > 21 ? 12 : 2));
    }
  }
}

TEST_CASE("kept segments longer than a bound of size are reported, and the rest is as fine as wanted",
          "[keep_borders]") {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 1));
  add_polygon(pslg, square(0.1, 0.2, 0.2));
  for (const double h : {0.2, 0.05, 0.02}) {
    CAPTURE(h);
    const Options options = Options().max_edge(h).keep_borders(Keep::ALL);
    const Count n = check_kept(pslg, options, [](std::size_t) { return true; });
    CHECK(n.unmet >= 8);
    CHECK(double(n.unmet) < 60 / h); // a few along each segment
    CHECK(n.triangles < std::size_t(4 * 2.5 / (h * h)));
    // Far from the segments, edges are as short as elsewhere.
    const Mesh mesh = Mesher(options)(pslg);
    double longest = 0;
    for (const auto& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &p = mesh.point(t[k]), &q = mesh.point(t[(k + 1) % 3]);
        if (std::abs(p.x() + 0.7) < 0.05 && std::abs(p.y()) < 0.2)
          longest = std::max(longest, std::sqrt(CGAL::squared_distance(p, q)));
      }
    if (h < 0.1) CHECK(longest <= h * (1 + 1e-9));
  }
}

TEST_CASE("kept borders and other options go together", "[keep_borders]") {
  using Separation = Options::Separation;
  CHECK_THROWS_AS(Mesher(Options().keep_borders(Keep::ALL).separate(Separation::THEOREM_5)),
                  std::invalid_argument);
  CHECK_NOTHROW(Mesher(Options().keep_borders(Keep::NONE).separate(Separation::THEOREM_5)));
  const auto all = [](std::size_t) { return true; };
  const Pslg pslg = random_pslg::families()[1].make(5);
  const Options kept = Options().keep_borders(Keep::ALL);
  check_kept(pslg, Options(kept).coarsen(Options::Coarsening::NONE), all);
  check_kept(pslg, Options(kept).smooth(2).thin(2), all);
  check_kept(pslg, Options(kept).conform(Options::Conforming::DELAUNAY), all);
  const Mesh few = Mesher(Options(kept).max_steiner_vertices(3))(pslg);
  CHECK(few.points.size() <= pslg.vertices.size() + 3);
}

TEST_CASE("kept borders in a mesh of blocks: the same for any number of threads", "[keep_borders][threads]") {
  Pslg pslg;
  random_pslg::Random random(11);
  add_polygon(pslg, square(0, 0, 70));
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      const Point p(1.2 * (i - 50) + random.between(-0.2, 0.2), 1.2 * (j - 50) + random.between(-0.2, 0.2));
      const double angle = random.between(0, 6.28);
      std::vector<Point> corners;
      for (int k = 0; k < 3; ++k)
        corners.push_back(random_pslg::polar(p, random.between(0.05, 0.35), angle + 2.1 * k));
      add_polygon(pslg, corners);
    }
  const Options options = Options().keep_borders(Keep::ALL);
  Mesh first;
  for_numbers_of_threads([&] {
    CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag> mesher(options);
    const Mesh mesh = mesher(pslg);
    CHECK(segments_cut(mesh).empty());
    if (first.triangles.empty()) first = mesh;
    CHECK(mesh.triangles == first.triangles);
    CHECK(mesh.points == first.points);
    for (const auto& unmet : mesher.report().unmet_triangles)
      CHECK(unmet.reason == Report::Reason::KEPT_SEGMENT);
    CHECK(CGAL::mesh_quality_2(mesh, pslg).is_valid());
  });
  CHECK(first.triangles.size() > 60000); // and as many before refinement, so there are blocks
}

} // namespace test_keep_borders
