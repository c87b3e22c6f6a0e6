#include "mesh_points.h"

#include "mesh_with_doubles.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

mesh_points::Mesh mesh_points::exactly(const std::vector<Point>& points, const Options& options,
                                       Report& report) {
  using Traits = CGAL::Exact_quadtree_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Exact_point = Traits::Point_2;
  std::vector<Exact_point> exact;
  exact.reserve(points.size());
  for (const Point& p : points) exact.emplace_back(p.x(), p.y());
  CGAL::Point_set_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  Mesh mesh = mesh_with_doubles(mesher(exact), points, [](const Exact_point& p) {
    return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  });
  report = mesher.report();
  return mesh;
}
