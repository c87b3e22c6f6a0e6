// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_PYTHON_GRAPH_RESULTS_H
#define QUADTREE_MESH_PYTHON_GRAPH_RESULTS_H

#include "arrays.h"

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quality_mesh_report_2.h>

// Meshes of graphs, and what is reported of them, for Python.

namespace quadtree_mesh_python {

/// The arrays of a mesh, which they keep.
py::dict arrays_of_mesh(CGAL::Indexed_mesh_2<Point> made);

py::dict values_of_report(const CGAL::Quality_mesh_report_2& report);

} // namespace quadtree_mesh_python

#endif // QUADTREE_MESH_PYTHON_GRAPH_RESULTS_H
