// Finds a near neighbor of each of many points by their quadtree, all at once. Compares it with the nearest
// neighbor, by CGAL's Delaunay triangulation: the near one is at most 1.6284 times as far.

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Random.h>
#include <CGAL/point_generators_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Quadtree =
    CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<Kernel>, CGAL::Parallel_if_available_tag>;

int main() {
  CGAL::Random random(1);
  CGAL::Random_points_in_disc_2<Point> in_disc(1.0, random);
  std::vector<Point> points;
  for (int i = 0; i < 10000; ++i) points.push_back(*in_disc++);

  const Quadtree tree(points);
  const auto& framework = tree.framework();
  const std::vector<Quadtree::Point_rank> near =
      tree.near_neighbors(); // by rank, in the order of the quadtree

  const CGAL::Delaunay_triangulation_2<Kernel> delaunay(points.begin(), points.end());
  std::size_t nearest_found = 0;
  double worst = 1, sum = 0;
  for (auto v : delaunay.finite_vertex_handles()) {
    double least = std::numeric_limits<double>::infinity();
    auto around = v->incident_vertices();
    const auto end = around;
    do
      if (!delaunay.is_infinite(around))
        least = std::min(least, CGAL::squared_distance(v->point(), around->point()));
    while (++around != end);
    // The leaf of a point holds that point alone.
    const auto rank = tree.points(tree.locate(v->point())).begin;
    const Point& neighbor = points[std::size_t(framework.input_point(near[std::size_t(rank)]))];
    const double ratio = std::sqrt(CGAL::squared_distance(v->point(), neighbor) / least);
    worst = std::max(worst, ratio);
    sum += ratio;
    if (ratio == 1) ++nearest_found;
  }
  const double n = static_cast<double>(near.size());
  std::cout << near.size() << " points; the near neighbor is the nearest of "
            << 100 * double(nearest_found) / n << " %, " << sum / n
            << " times as far as that on average, and at most " << worst << " times\n";
  return worst < 1.6284 ? 0 : 1;
}
