#include "mesh_points.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/round_mesh_2.h>
#include <CGAL/tags.h>

#include <utility>
#include <vector>

mesh_points::Mesh mesh_points::exactly(const std::vector<Point>& points, const Options& options,
                                       Report& report) {
  using Traits = CGAL::Exact_quadtree_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Exact_point = Traits::Point_2;
  std::vector<Exact_point> exact;
  exact.reserve(points.size());
  for (const Point& p : points) exact.emplace_back(p.x(), p.y());
  CGAL::Point_set_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  auto rounded = CGAL::round_mesh_2<Point>(mesher(exact), points);
  report = mesher.report();
  rounded.renumber(report);
  return std::move(rounded.mesh);
}
