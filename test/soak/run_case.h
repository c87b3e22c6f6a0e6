// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_RUN_CASE_H
#define QUADTREE_MESH_2_TEST_SOAK_RUN_CASE_H

// Calls the meshers: those of the program quality_mesh, and one over 32-bit words.

#include "Soak_case.h"

#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/mesh_quality_2.h>

namespace soak {

struct Graph_mesh {
  Mesh mesh;
  CGAL::Quality_mesh_report_2 report;
};
struct Points_mesh {
  Mesh mesh;
  CGAL::Point_set_mesh_report_2 report;
};

/// With the lengths that the wishes come to.
CGAL::Quality_mesh_options_2 graph_options(const Soak_case& c);
CGAL::Point_set_mesh_options_2 points_options(const Soak_case& c);
/// The same for the checker.
CGAL::Mesh_quality_options_2 check_options(const Soak_case& c);

/// Words of 32 bits have no map from doubles in the package: their input is this one, a graph of integers.
Pslg graph_of_words32(const Pslg& graph, Mode mode);

// Both throw what the meshers throw.

Graph_mesh mesh_graph_of(const Soak_case& c, unsigned threads);
/// \pre `c.mode` is one of points
Points_mesh mesh_points_of(const Soak_case& c, unsigned threads);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_RUN_CASE_H
