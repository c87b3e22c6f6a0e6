#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_POINTS_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_POINTS_H

// Points over doubles meshed with any arithmetic; the mesh is one over doubles, too. Each arithmetic is compiled by
// itself: the mesher takes the compiler a while.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Point_set_mesh_report_2.h>

#include <vector>

namespace mesh_points {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Options = CGAL::Point_set_mesh_options_2;
using Report = CGAL::Point_set_mesh_report_2;

// All throw CGAL::Quadtree_mesh_2::Point_error for points that the arithmetic cannot hold or tell apart.

Mesh with_doubles(const std::vector<Point>& points, const Options& options, Report& report);
/// Scaled to 64-bit words, meshed there, mapped back.
Mesh in_words(const std::vector<Point>& points, const Options& options, Report& report);
/// With exact constructions; only the result is rounded.
Mesh exactly(const std::vector<Point>& points, const Options& options, Report& report);

} // namespace mesh_points

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_POINTS_H
