// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "run_case.h"

#include "words32.h"

#include "mesh_graph.h"
#include "mesh_points.h"

#include <CGAL/Fixed_point_quadtree_traits_2.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace soak {

namespace {

/// A field that grows from the left border to twice that on the right.
struct Slope {
  double x, width, size;
  double operator()(double at, double) const {
    return size * (1 + std::min(1.0, std::max(0.0, (at - x) / width)));
  }
};

/// Meshers of small inputs have no time to wait until threads have started, as `Thread_limit` does.
class Allowed_threads {
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Allowed_threads(unsigned n) : control_(tbb::global_control::max_allowed_parallelism, n) {}

private:
  tbb::global_control control_;
#else
  explicit Allowed_threads(unsigned) {}
#endif
};

mesh_graph::Neighbors neighbors_of(const Soak_case& c) {
  return c.wishes.has_trapezoids ? mesh_graph::Neighbors::TRAPEZOIDAL : mesh_graph::Neighbors::QUADTREE;
}

} // namespace

CGAL::Quality_mesh_options_2 graph_options(const Soak_case& c) {
  using Options = CGAL::Quality_mesh_options_2;
  using Trees = CGAL::Tree_separation_options_2;
  const Wishes& w = c.wishes;
  const double extent = extent_of(c.graph.vertices);
  Options options;
  options.min_angle(w.min_angle)
      .max_area(w.max_area * extent * extent)
      .max_edge(w.max_edge * extent)
      .mesh_domain(w.domain)
      .smooth(w.smooth)
      .thin(w.thin)
      .patience(w.patience)
      .coarsen(w.is_coarsened ? Options::Coarsening::GUARDED_REMOVAL : Options::Coarsening::NONE);
  if (c.separation == Separation::THEOREM_5)
    options.separate(w.has_centroid_trees ? Trees::of_theorem().subdivide(Trees::Subdivision::CENTROID_TREE)
                                          : Trees());
  else
    options.min_edge(w.min_edge * extent);
  if (w.size > 0 && extent > 0 && std::isfinite(extent)) {
    double low = c.graph.vertices.front().x();
    for (const Point& p : c.graph.vertices) low = std::min(low, p.x());
    options.size(Slope{low, extent, w.size * extent});
  }
  return options;
}

CGAL::Point_set_mesh_options_2 points_options(const Soak_case& c) {
  CGAL::Point_set_mesh_options_2 options;
  options.effort(c.wishes.effort);
  switch (c.mode) {
  case Mode::BOUNDED:
    if (c.wishes.is_square) options.mesh_domain(CGAL::Point_set_mesh_options_2::Domain::SQUARE);
    return c.wishes.is_tightest ? options.bounded_angles(37.5, 78.6) : options.bounded_angles();
  case Mode::ACUTE:
    return options.acute();
  case Mode::WARPED:
    return options.warped_squares();
  case Mode::POINTS:
  case Mode::PSLG:
    break;
  }
  return options.least_angle();
}

CGAL::Mesh_quality_options_2 check_options(const Soak_case& c) {
  using Rule = CGAL::Mesh_quality_options_2::Domain;
  using Domain = CGAL::Quality_mesh_options_2::Domain;
  const CGAL::Quality_mesh_options_2 asked = graph_options(c);
  const Rule rule = asked.mesh_domain() == Domain::MARKED           ? Rule::MARKED_BY_REGIONS
                    : asked.mesh_domain() == Domain::NESTING_PARITY ? Rule::NESTING_PARITY
                                                                    : Rule::ENCLOSED_BY_SEGMENTS;
  CGAL::Mesh_quality_options_2 check = CGAL::Mesh_quality_options_2()
                                           .min_angle(asked.min_angle())
                                           .max_edge(asked.max_edge())
                                           .max_area(asked.max_area())
                                           .check_domain(rule);
  if (c.kernel == Kernel::FIXED32) check.coordinate_unit(1);
  if (c.kernel == Kernel::FIXED)
    check.coordinate_unit(CGAL::Fixed_point_scale_2<std::uint64_t>::of_points(c.graph.vertices).unit());
  return check;
}

Pslg graph_of_words32(const Pslg& graph, Mode mode) {
  double x0 = 0, y0 = 0;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    x0 = v == 0 ? graph.vertices[v].x() : std::min(x0, graph.vertices[v].x());
    y0 = v == 0 ? graph.vertices[v].y() : std::min(y0, graph.vertices[v].y());
  }
  const double extent = extent_of(graph.vertices);
  // To the second quarter of the root, 2^31 wide; for meshes of points to the middle of it, of which they need up to
  // nine times as much on each side.
  const double side = mode == Mode::PSLG ? 0x1p29 : 0x1p26;
  const double west = mode == Mode::PSLG ? 0x1p29 : 0x1p30 - side / 2;
  const auto word = [&](double v, double low) {
    if (!(extent > 0)) return west;
    const double share = std::clamp((v - low) / extent, -0.5, 1.5);
    return std::round(west + share * side);
  };
  Pslg result = graph;
  const auto map = [&](Point& p) { p = Point(word(p.x(), x0), word(p.y(), y0)); };
  for (Point& p : result.vertices) map(p);
  for (Point& p : result.holes) map(p);
  for (auto& r : result.regions) map(r.point), r.max_area = 0;
  return result;
}

Graph_mesh mesh_graph_of(const Soak_case& c, unsigned threads) {
  const Allowed_threads allowed(threads);
  const CGAL::Quality_mesh_options_2 options = graph_options(c);
  Graph_mesh result;
  switch (c.kernel) {
  case Kernel::FILTERED:
    result.mesh = mesh_graph::with_doubles(c.graph, options, neighbors_of(c), result.report);
    break;
  case Kernel::EXACT:
    result.mesh = mesh_graph::exactly(c.graph, options, neighbors_of(c), result.report);
    break;
  case Kernel::FIXED:
    result.mesh = mesh_graph::in_words(c.graph, options, neighbors_of(c), result.report);
    break;
  case Kernel::FIXED32:
    return mesh_graph_in_words32(c.graph, options);
  }
  return result;
}

Points_mesh mesh_points_of(const Soak_case& c, unsigned threads) {
  const Allowed_threads allowed(threads);
  const CGAL::Point_set_mesh_options_2 options = points_options(c);
  const std::vector<Point>& points = c.graph.vertices;
  Points_mesh result;
  switch (c.kernel) {
  case Kernel::FILTERED:
    result.mesh = mesh_points::with_doubles(points, options, result.report);
    break;
  case Kernel::EXACT:
    result.mesh = mesh_points::exactly(points, options, result.report);
    break;
  case Kernel::FIXED:
    result.mesh = mesh_points::in_words(points, options, result.report);
    break;
  case Kernel::FIXED32:
    return mesh_points_in_words32(points, options);
  }
  return result;
}

} // namespace soak
