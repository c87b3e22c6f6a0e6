#include "mesh_points.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/round_mesh_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using mesh_points::Point;

double magnitude(const Point& p) { return (std::max)(std::fabs(p.x()), std::fabs(p.y())); }

/// Exact numbers have no largest one, but the mesh is written in doubles, and it reaches further than the points: by
/// four times their extent at most.
/// \throws CGAL::Quadtree_mesh_2::Point_error for the point with the coordinate of the largest magnitude
void check_reach(const std::vector<Point>& points) {
  if (points.empty()) return;
  const auto [west, east] = std::minmax_element(points.begin(), points.end(),
                                                [](const Point& p, const Point& q) { return p.x() < q.x(); });
  const auto [south, north] = std::minmax_element(
      points.begin(), points.end(), [](const Point& p, const Point& q) { return p.y() < q.y(); });
  const double extent = (std::max)(east->x() - west->x(), north->y() - south->y());
  const auto farthest = std::max_element(points.begin(), points.end(), [](const Point& p, const Point& q) {
    return magnitude(p) < magnitude(q);
  });
  if (std::isfinite(magnitude(*farthest) + 4 * extent)) return;
  throw CGAL::Quadtree_mesh_2::Point_error(
      CGAL::Quadtree_mesh_2::Point_index(static_cast<std::size_t>(farthest - points.begin())),
      "below 2^1024 in magnitude for doubles, with four times the extent of the points added");
}

} // namespace

mesh_points::Mesh mesh_points::exactly(const std::vector<Point>& points, const Options& options,
                                       Report& report) {
  using Traits = CGAL::Exact_quadtree_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Exact_point = Traits::Point_2;
  check_reach(points);
  std::vector<Exact_point> exact;
  exact.reserve(points.size());
  for (const Point& p : points) exact.emplace_back(p.x(), p.y());
  CGAL::Point_set_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  auto rounded = CGAL::round_mesh_2<Point>(mesher(exact), points);
  report = mesher.report();
  rounded.renumber(report);
  return std::move(rounded.mesh);
}
