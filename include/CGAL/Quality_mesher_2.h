// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Everything that meshes graphs: the class Quality_mesher_2; and for programs that come from Mesh_2,
// refine_quality_mesh_2() and Quality_cdt_mesher_2.

#ifndef CGAL_QUALITY_MESHER_2_H
#define CGAL_QUALITY_MESHER_2_H

#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/refine_quality_mesh_2.h>

#endif // CGAL_QUALITY_MESHER_2_H
