// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_PYTHON_DEFINITIONS_H
#define QUADTREE_MESH_PYTHON_DEFINITIONS_H

#include <pybind11/pybind11.h>

// The parts of the extension module, each in a file of its own.

namespace quadtree_mesh_python {

void define_errors(pybind11::module_& module);
void define_sizes(pybind11::module_& module);
void define_features(pybind11::module_& module);
void define_graphs(pybind11::module_& module);
void define_adaptation(pybind11::module_& module);
void define_point_sets(pybind11::module_& module);
void define_quadtrees(pybind11::module_& module);
void define_pages(pybind11::module_& module);

} // namespace quadtree_mesh_python

#endif // QUADTREE_MESH_PYTHON_DEFINITIONS_H
