#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_EXACTLY_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_EXACTLY_H

// A graph over doubles meshed with exact constructions; only the result is rounded.

#include "mesh_with_doubles.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>
#include <CGAL/validate_pslg_2.h>

/// \throws CGAL::Pslg_error_2 as the mesher does.
template <class Point>
CGAL::Indexed_mesh_2<Point> mesh_exactly(const CGAL::Pslg_2<Point>& pslg,
                                         const CGAL::Quality_mesh_options_2& options,
                                         CGAL::Quality_mesh_report_2& report) {
  using Traits = CGAL::Exact_quadtree_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Exact_point = typename Traits::Point_2;
  CGAL::check_pslg_structure(pslg); // exact numbers are finite
  const auto exact = [](const Point& p) { return Exact_point(p.x(), p.y()); };
  CGAL::Pslg_2<Exact_point> graph;
  graph.vertices.reserve(pslg.vertices.size());
  for (const Point& p : pslg.vertices) graph.vertices.push_back(exact(p));
  graph.vertex_markers = pslg.vertex_markers;
  graph.segments = pslg.segments;
  graph.segment_markers = pslg.segment_markers;
  for (const Point& p : pslg.holes) graph.holes.push_back(exact(p));
  for (const auto& region : pslg.regions)
    graph.regions.push_back({exact(region.point), region.attribute, region.max_area});

  CGAL::Quality_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  auto mesh = mesher(graph);
  report = mesher.report();
  return mesh_with_doubles(std::move(mesh), pslg.vertices, [](const Exact_point& p) {
    return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  });
}

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_EXACTLY_H
