// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_GDAL_MODULE_H
#define QUADTREE_MESH_2_EXAMPLES_GDAL_MODULE_H

// What quality_mesh reads by GDAL. GDAL brings a hundred libraries, which take 50 ms and 30 MB to load. So it is in a
// module, which is loaded when a file asks for it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Feature_properties_2.h>
#include <CGAL/Grid_sizing_field_2.h>
#include <CGAL/Pslg_2.h>

#include <optional>
#include <string>

namespace gdal_module {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

struct Graph_request {
  std::string file_name, layer; ///< an empty layer: the only one
  CGAL::Feature_properties_2 properties;
  CGAL::Pslg_2<Point>* graph; ///< where it is read to
  CGAL::Coordinate_system_2 coordinates = CGAL::Coordinate_system_2::UNKNOWN;
};
using Read_graph = void (*)(Graph_request&);
inline constexpr const char* read_graph_name = "quality_mesh_read_graph_by_gdal";

struct Grid_request {
  std::string file_name;
  std::optional<CGAL::Grid_sizing_field_2> sizes = {};
};
using Read_grid = void (*)(Grid_request&);
inline constexpr const char* read_grid_name = "quality_mesh_read_grid_by_gdal";

/// The function of this name in the module, which stays loaded.
/// \throws std::runtime_error if there is no module
void* function(const char* name);

} // namespace gdal_module

#endif // QUADTREE_MESH_2_EXAMPLES_GDAL_MODULE_H
