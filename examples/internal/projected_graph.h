// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_PROJECTED_GRAPH_H
#define QUADTREE_MESH_2_EXAMPLES_PROJECTED_GRAPH_H

// Graphs in degrees: which projection --project means, and their meshes. Compiled by itself: the triangulations take
// the compiler a while.

#include "command_line.h"

#include <CGAL/Conformal_projection_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Feature_properties_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <cstddef>
#include <functional>
#include <optional>

namespace projected_graph {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Pslg = CGAL::Pslg_2<Point>;
using Options = CGAL::Quality_mesh_options_2;

/// What was done for a graph in degrees.
struct Run {
  CGAL::Conformal_projection_2 projection;
  CGAL::Conformal_projection_2::Place scale_range; ///< in the latitudes of the graph
  Pslg graph;                                      ///< in meters
  Mesh mesh;                                       ///< in meters, as it was made
  Mesh images; ///< the same with vertices at the images of those in degrees
  std::size_t split_vertices = 0, rounds = 0, bent_triangles = 0;
};

/// Whether coordinates may be longitudes and latitudes so far from the equator that angles on the ground are others.
bool may_be_in_degrees(const Pslg& graph);
/// Nothing where the graph is meshed as it is: if the command line says so, or it says nothing and neither the format
/// nor the file tells that coordinates are degrees.
/// \throws std::runtime_error if the graph has no such projection
std::optional<Run> projection(const Pslg& graph, CGAL::Coordinate_system_2 coordinates,
                              const Command_line& line);
/// The mesh in degrees.
Mesh mesh(const Pslg& graph, const std::function<Mesh(const Pslg&)>& mesher, const Options& options,
          Run& run);

} // namespace projected_graph

#endif // QUADTREE_MESH_2_EXAMPLES_PROJECTED_GRAPH_H
