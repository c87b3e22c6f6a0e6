#include "mesh_points.h"

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/tags.h>

mesh_points::Mesh mesh_points::with_doubles(const std::vector<Point>& points, const Options& options,
                                            Report& report) {
  CGAL::Point_set_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag> mesher(options);
  Mesh mesh = mesher(points);
  report = mesher.report();
  return mesh;
}
