#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_GRAPH_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_GRAPH_H

// A graph over doubles meshed with any arithmetic; the mesh is one over doubles, too. Each arithmetic is compiled by
// itself: the mesher takes the compiler a while.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>

namespace mesh_graph {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Pslg = CGAL::Pslg_2<Point>;
using Options = CGAL::Quality_mesh_options_2;
using Report = CGAL::Quality_mesh_report_2;

/// What finds the edges next to vertices in the construction by quadtrees; the mesh is the same.
enum class Neighbors { TRAPEZOIDAL, QUADTREE };

// All throw std::exception for what cannot be meshed, or what the arithmetic cannot hold.

Mesh with_doubles(const Pslg& pslg, const Options& options, Neighbors neighbors, Report& report);
/// Scaled to 64-bit words, meshed there, mapped back.
Mesh in_words(const Pslg& pslg, const Options& options, Neighbors neighbors, Report& report);
/// The unit that words have for a graph, in its coordinates.
double unit_of_words(const Pslg& pslg);
/// With exact constructions; only the result is rounded.
Mesh exactly(const Pslg& pslg, const Options& options, Neighbors neighbors, Report& report);

} // namespace mesh_graph

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_GRAPH_H
