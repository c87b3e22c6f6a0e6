// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_REPAIRED_GRAPH_H
#define QUADTREE_MESH_2_EXAMPLES_REPAIRED_GRAPH_H

// A graph over doubles made planar. Compiled by itself: the triangulations take the compiler a while.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/repair_pslg_2.h>

using Graph = CGAL::Pslg_2<CGAL::Exact_predicates_inexact_constructions_kernel::Point_2>;

/// Splits segments where they cross; what else `repair_pslg_2()` cures is cured, too.
Graph repaired_graph(const Graph& graph, CGAL::Pslg_repair_report_2& report);

#endif // QUADTREE_MESH_2_EXAMPLES_REPAIRED_GRAPH_H
