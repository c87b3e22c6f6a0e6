// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_TRIANGLE_FILES_H
#define CGAL_IO_TRIANGLE_FILES_H

// Reads and writes the files of Jonathan Shewchuk's Triangle: .poly, .node, .ele, .edge, .neigh and
// .v.node.

#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/IO/write_triangle_dual_files.h>
#include <CGAL/IO/write_triangle_files.h>

#endif // CGAL_IO_TRIANGLE_FILES_H
