#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_FILES_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_FILES_H

// Reads and writes the files of quality_mesh, each in the format that its ending tells. Compiled by itself: the formats
// take the compiler a while.

#include "file_formats.h"

#include <CGAL/Conformal_projection_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Feature_properties_2.h>
#include <CGAL/Grid_sizing_field_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Points_sizing_field_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_version.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/mesh_dual_types.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mesh_files {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Pslg = CGAL::Pslg_2<Point>;

// All throw std::runtime_error naming the file, and the line or feature that is to blame.

/// A graph, and what the file says its coordinates are.
struct Input {
  Pslg graph;
  std::optional<Mesh> mesh; ///< of the graph, to be refined, if the file has one
  /// Per triangle of the mesh, that of the file that it is a piece of.
  std::vector<CGAL::Quadtree_mesh_2::Triangle_index> given_triangle;
  CGAL::Coordinate_system_2 coordinates = CGAL::Coordinate_system_2::UNKNOWN;
};
/// What to read of features.
struct Selection {
  CGAL::Feature_properties_2 properties;
  std::string layer; ///< empty: the only one
};
/// Whether a graph may be one of points alone.
enum class Points_alone { REFUSED, ALLOWED };
/// \throws Usage_error if the format is one of points alone and these are refused
Input read_graph(const std::string& file_name, const Selection& selection, Points_alone points_alone);
/// \throws std::runtime_error if there are segments, or no points, too
Pslg read_points(const std::string& file_name, const Selection& selection);
/// Bounds of area by triangle, of an .area file of Triangle.
std::vector<double> read_areas(const std::string& file_name, const Input& input);
/// Points with the sizes of triangles there: the first three columns of a table, or `x`, `y` and `size`.
/// \param projection of the places, if they are degrees; sizes are meters then. Null: none
/// \param gradation by how much sizes grow over a unit of length
CGAL::Points_sizing_field_2 read_sized_points(const std::string& file_name,
                                              const CGAL::Conformal_projection_2* projection,
                                              double gradation);
/// Sizes on an ASCII grid of ESRI, or on a raster that GDAL reads.
/// \param gradation by how much they may grow over a unit of length; 0: no limit
CGAL::Grid_sizing_field_2 read_size_grid(const std::string& file_name, double gradation);

/// What pictures show besides the mesh.
struct Picture {
  Picture_colors colors = Picture_colors::NONE;
  bool is_quadtree_shown = false;                           ///< that of the graph's vertices
  Picture_colors page_colors = Picture_colors::ANGLE;       ///< of a page at first
  std::string title;                                        ///< of a page
  std::vector<CGAL::Quadtree_mesh_2::Triangle_index> unmet; ///< triangles that a page marks
  const CGAL::Conformal_projection_2* projection = nullptr; ///< in whose plane a page shows a mesh in degrees
};
/// What is written of a mesh besides vertices and triangles.
struct Details {
  std::size_t pieces = 0; ///< of formats that may have some; 0 if nothing is said
  CGAL::IO::Msh_version msh_version = CGAL::IO::Msh_version::V4_1;
  CGAL::IO::Element_order order = CGAL::IO::Element_order::FIRST; ///< in formats that know others
  CGAL::Mesh_dual_2::Kind cells = CGAL::Mesh_dual_2::Kind::CIRCUMCENTRIC;
  /// The plane in which there are cells, of a mesh in degrees; null: that of the coordinates.
  const CGAL::Conformal_projection_2* projection = nullptr;
};
using Files = CGAL::Quadtree_mesh_2::internal::Replaced_files;
/// \param pslg what the mesh was made from
void add(Files& files, const std::string& file_name, const Mesh& mesh, const Pslg& pslg,
         const Picture& picture, const Details& details);

} // namespace mesh_files

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_FILES_H
