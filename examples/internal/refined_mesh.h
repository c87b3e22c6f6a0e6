// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_REFINED_MESH_H
#define QUADTREE_MESH_2_EXAMPLES_REFINED_MESH_H

// A mesh that is given, refined.

#include "mesh_graph.h"

#include <cstddef>
#include <vector>

/// \param areas bounds for the triangles of the mesh; empty: none
/// \param[out] kept_vertices how many of its first vertices are those of the given mesh
mesh_graph::Mesh refined_mesh(const mesh_graph::Mesh& mesh, const mesh_graph::Pslg& pslg,
                              const std::vector<double>& areas, const mesh_graph::Options& options,
                              mesh_graph::Report& report, std::size_t& kept_vertices);

#endif // QUADTREE_MESH_2_EXAMPLES_REFINED_MESH_H
