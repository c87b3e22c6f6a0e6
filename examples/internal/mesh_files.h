#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_FILES_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_FILES_H

// Reads and writes the files of quality_mesh, each in the format that its ending tells. Compiled by itself: the formats
// take the compiler a while.

#include "file_formats.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Points_sizing_field_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>

#include <string>
#include <vector>

namespace mesh_files {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Pslg = CGAL::Pslg_2<Point>;

// All throw std::runtime_error naming the file, and the line or feature that is to blame.

/// \param region_property of GeoJSON's features; empty: none
/// \throws Usage_error if the format is one of points alone
Pslg read_graph(const std::string& file_name, const std::string& region_property);
/// \throws std::runtime_error if there are segments, or no points, too
Pslg read_points(const std::string& file_name);
/// Points with the sizes of triangles there: the first three columns of a table, or `x`, `y` and `size`.
CGAL::Points_sizing_field_2 read_sized_points(const std::string& file_name);

/// What pictures show besides the mesh.
struct Picture {
  Picture_colors colors = Picture_colors::NONE;
  bool is_quadtree_shown = false; ///< that of the graph's vertices
};
using Files = CGAL::Quadtree_mesh_2::internal::Replaced_files;
/// \param pslg what the mesh was made from
void add(Files& files, const std::string& file_name, const Mesh& mesh, const Pslg& pslg,
         const Picture& picture);

} // namespace mesh_files

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_FILES_H
