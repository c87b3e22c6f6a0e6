// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Distances of vertices to what they see in the domain, beside exact distances of all pairs.

#include "catch.h"
#include "quadtree_test_inputs.h"
#include "random_pslg_shapes.h"
#include "separation_test_tools.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace test_geodesic_distance {

namespace {

using namespace separation_test;
using pslg_test::Point;
using pslg_test::Pslg;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Prepared = Prepared_graph<quadtree_test::Filtered_traits>;

Exact::Point_2 exact(const Point& p) { return {p.x(), p.y()}; }

/// All of a graph in exact numbers.
class All_pairs {
public:
  explicit All_pairs(const Pslg& graph) : graph_(graph) {
    for (const Point& p : graph.vertices) points_.push_back(exact(p));
  }

  /// To the nearest vertex that v sees; edges may touch the way at its ends.
  double to_vertex(std::size_t v) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t w = 0; w < points_.size(); ++w) {
      const double d = distance(points_[v], points_[w]);
      if (w != v && d < least && is_free(v, points_[w])) least = d;
    }
    return least;
  }

  /// To the nearest edge, of those that do not end at v, whether v sees it or not: the nearest is in sight.
  double to_edge(std::size_t v) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& s : graph_.segments)
      if (s[0].value() != v && s[1].value() != v)
        least = std::min(least, std::sqrt(CGAL::to_double(CGAL::squared_distance(points_[v], segment(s)))));
    return least;
  }

private:
  const Pslg& graph_;
  std::vector<Exact::Point_2> points_;

  static double distance(const Exact::Point_2& p, const Exact::Point_2& q) {
    return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
  }
  template <class Ends>
  Exact::Segment_2 segment(const Ends& s) const {
    return {points_[s[0].value()], points_[s[1].value()]};
  }

  /// Whether the way from v to a vertex is an edge, or meets edges at its ends only. No three vertices are on a line.
  bool is_free(std::size_t v, const Exact::Point_2& p) const {
    const Exact::Segment_2 way(points_[v], p);
    return std::all_of(graph_.segments.begin(), graph_.segments.end(), [&](const auto& s) {
      const Exact::Segment_2 edge = segment(s);
      return edge.has_on(way.source()) || edge.has_on(way.target()) || !CGAL::do_intersect(way, edge);
    });
  }
};

} // namespace

TEST_CASE("Vertices know the nearest vertex in sight, and no distance that is too short", "[separation]") {
  std::size_t of_edges = 0;
  for (std::uint64_t seed = 0; seed < (is_full_run() ? 40 : 6); ++seed) {
    CAPTURE(seed);
    const Prepared graph(random_pslg::segments(seed)); // in a box, all of which is the domain
    const std::vector<double> distances = graph.geodesic_distances();
    const All_pairs all(graph.graph());
    std::size_t too_long = 0, too_short = 0;
    for (std::size_t v = 0; v < distances.size(); ++v) {
      const double to_vertex = graph.map().length_to_kernel(all.to_vertex(v)),
                   to_edge = graph.map().length_to_kernel(all.to_edge(v));
      too_long += distances[v] > to_vertex * (1 + 1e-9) ? 1 : 0;
      too_short += distances[v] < std::min(to_vertex, to_edge) * (1 - 1e-9) ? 1 : 0;
      of_edges += distances[v] < to_vertex * (1 - 1e-9) ? 1 : 0;
    }
    CHECK(too_long == 0);
    CHECK(too_short == 0);
  }
  CHECK(of_edges > 0);
}

TEST_CASE("The nearest edge counts", "[separation]") {
  Pslg pslg = pslg_test::unit_square();
  pslg.add_vertex(Point(0.5, 0.125));
  const Prepared graph(pslg);
  CHECK(graph.geodesic_distances().back() == Approx(graph.map().length_to_kernel(0.125)));
}

TEST_CASE("What lies beyond a gap outside the domain is not near", "[separation]") {
  // Two squares, 2^-30 apart, and one within another one's hole, as near to its border.
  constexpr double gap = 0x1p-30;
  Pslg pslg;
  const auto add_square = [&](double low, double high) {
    const std::size_t first = pslg.number_of_vertices();
    for (const auto& p :
         {Point(low, 0.25), Point(high, 0.25), Point(high, 0.25 + high - low), Point(low, 0.25 + high - low)})
      pslg.add_vertex(p);
    for (std::size_t i = 0; i < 4; ++i)
      pslg.add_segment(Vertex_index(first + i), Vertex_index(first + (i + 1) % 4));
  };
  add_square(0, 1), add_square(1 + gap, 2 + gap);
  const Prepared graph(pslg);
  const double side = graph.map().length_to_kernel(1.0);
  for (const double distance : graph.geodesic_distances()) CHECK(distance == Approx(side));
}

} // namespace test_geodesic_distance
