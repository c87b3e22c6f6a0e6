// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "definitions.h"

// The extension module. It has what needs C++; all else, the documented functions too, is in Python.

PYBIND11_MODULE(_core, module) {
  using namespace quadtree_mesh_python;
  module.doc() = "What quadtree_mesh does in C++. Use the package, not this module.";
  module.attr("version") = QUADTREE_MESH_VERSION;
  define_errors(module);
  define_sizes(module);
  define_features(module);
  define_graphs(module);
  define_adaptation(module);
  define_point_sets(module);
  define_quadtrees(module);
  define_pages(module);
}
