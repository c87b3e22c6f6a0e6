#include "mesh_graph_with.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/round_mesh_2.h>
#include <CGAL/validate_pslg_2.h>

#include <utility>

mesh_graph::Mesh mesh_graph::exactly(const Pslg& pslg, const Options& options, Neighbors neighbors,
                                     Report& report) {
  using Traits = CGAL::Exact_quadtree_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Exact_point = Traits::Point_2;
  CGAL::check_pslg_structure(pslg); // exact numbers are finite
  const auto exact = [](const Point& p) { return Exact_point(p.x(), p.y()); };
  CGAL::Pslg_2<Exact_point> graph;
  graph.vertices.reserve(pslg.vertices.size());
  for (const Point& p : pslg.vertices) graph.vertices.push_back(exact(p));
  graph.vertex_markers = pslg.vertex_markers;
  graph.segments = pslg.segments;
  graph.first_number = pslg.first_number;
  graph.segment_markers = pslg.segment_markers;
  for (const Point& p : pslg.holes) graph.holes.push_back(exact(p));
  for (const auto& region : pslg.regions)
    graph.regions.push_back({exact(region.point), region.attribute, region.max_area});

  auto rounded =
      CGAL::round_mesh_2<Point>(mesh_graph_with<Traits>(graph, options, neighbors, report), pslg.vertices);
  rounded.renumber(report);
  return std::move(rounded.mesh);
}
