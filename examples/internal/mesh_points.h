#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_POINTS_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_POINTS_H

// Points over doubles meshed with any arithmetic; the mesh is one over doubles, too.

#include "Word_map.h"
#include "command_line.h"
#include "mesh_with_doubles.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <utility>
#include <vector>

namespace mesh_points_internal {

using Options = CGAL::Point_set_mesh_options_2;
using Report = CGAL::Point_set_mesh_report_2;

template <class Traits, class Point>
auto mesh_with(const std::vector<Point>& points, const Options& options, Report& report) {
  CGAL::Point_set_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  auto mesh = mesher(points);
  report = mesher.report();
  return mesh;
}

template <class Point>
CGAL::Indexed_mesh_2<Point> mesh_points_in_words(const std::vector<Point>& points, const Options& options,
                                                 Report& report) {
  using namespace mesh_in_words_internal;
  const Word_map<Point> map(points);
  std::vector<Word_point> words;
  words.reserve(points.size());
  for (const Point& p : points) words.push_back(map.to_word(p));
  check_told_apart(points, words);
  auto mesh = mesh_with_doubles(mesh_with<Traits>(words, options, report), points,
                                [&map](const Word_point& p) { return map.to_double(p); });
  to_doubles(report, mesh);
  return mesh;
}

template <class Point>
CGAL::Indexed_mesh_2<Point> mesh_points_exactly(const std::vector<Point>& points, const Options& options,
                                                Report& report) {
  using Traits = CGAL::Exact_quadtree_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Exact_point = typename Traits::Point_2;
  std::vector<Exact_point> exact;
  exact.reserve(points.size());
  for (const Point& p : points) exact.emplace_back(p.x(), p.y());
  return mesh_with_doubles(mesh_with<Traits>(exact, options, report), points, [](const Exact_point& p) {
    return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  });
}

} // namespace mesh_points_internal

/// \throws std::exception for what the kernel cannot hold.
template <class Point>
CGAL::Indexed_mesh_2<Point> mesh_points(const std::vector<Point>& points,
                                        const CGAL::Point_set_mesh_options_2& options,
                                        Command_line::Kernel kernel, CGAL::Point_set_mesh_report_2& report) {
  using namespace mesh_points_internal;
  switch (kernel) {
  case Command_line::Kernel::fixed:
    return mesh_points_in_words(points, options, report);
  case Command_line::Kernel::exact:
    return mesh_points_exactly(points, options, report);
  case Command_line::Kernel::filtered:
    break;
  }
  return mesh_with<CGAL::Filtered_quadtree_traits_2<>>(points, options, report);
}

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_POINTS_H
