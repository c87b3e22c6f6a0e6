#ifndef QUADTREE_MESH_2_EXAMPLES_COMMAND_LINE_TYPES_H
#define QUADTREE_MESH_2_EXAMPLES_COMMAND_LINE_TYPES_H

// What the command line of quality_mesh says.

#include "file_formats.h"
#include "standard_streams.h"

#include "mesh_graph.h"

#include <CGAL/Feature_properties_2.h>
#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_version.h>
#include <CGAL/Quadtree_mesh_2/mesh_dual_types.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

struct Command_line {
  enum class Task { MESH, PRINT_HELP, PRINT_ALL_OPTIONS, PRINT_VERSION };
  enum class Kernel { FILTERED, FIXED, EXACT };
  using Neighbors = mesh_graph::Neighbors;
  /// What is meshed, and which angles are wanted: a graph, or points alone.
  enum class Mode { PSLG, POINTS, BOUNDED, ACUTE, WARPED };

  /// What longitudes and latitudes are projected by.
  enum class Project { BY_FORMAT, NONE, AUTO, MERCATOR, LAMBERT };

  Task task = Task::MESH;
  Mode mode = Mode::PSLG;
  std::string input; ///< a file, or standard input (`is_standard_stream()`)
  std::vector<std::string> outputs;
  std::string report_file;      ///< empty: none
  std::string size_points_file; ///< empty: none
  std::string size_grid_file;   ///< empty: none
  std::string area_file;        ///< of the triangles of a mesh to refine; empty: none
  /// The longest edge at features, and how it grows with the distance from them.
  struct Feature_sizes {
    double size, gradation;
  };
  std::optional<Feature_sizes> feature_sizes;
  double gradation = 0; ///< of all these sizes; 0: no limit
  Kernel kernel = Kernel::FILTERED;
  CGAL::Quality_mesh_options_2 options;             ///< of Mode::PSLG
  Neighbors neighbors = Neighbors::TRAPEZOIDAL;     ///< of Mode::PSLG, by quadtrees
  CGAL::Point_set_mesh_options_2 point_set_options; ///< of all other modes
  std::optional<unsigned> threads;                  ///< none: not said
  bool is_comparison_wanted = false;
  bool are_lengths_wanted = false;
  Picture_colors colors = Picture_colors::NONE;
  Picture_colors page_colors = Picture_colors::ANGLE; ///< of .html at first
  bool is_quadtree_shown = false;
  bool is_renumbering_wanted = false;
  std::size_t pieces = 0; ///< of outputs that may have some; 0: not said
  CGAL::IO::Msh_version msh_version = CGAL::IO::Msh_version::V4_1;
  CGAL::Feature_properties_2 properties;
  std::string layer; ///< of files that GDAL reads; empty: the only one
  CGAL::IO::Element_order element_order = CGAL::IO::Element_order::FIRST;
  CGAL::Mesh_dual_2::Kind cells = CGAL::Mesh_dual_2::Kind::CIRCUMCENTRIC;
  bool is_hull_wanted = false;          ///< of Mode::PSLG
  bool is_repair_wanted = false;        ///< of Mode::PSLG
  Project project = Project::BY_FORMAT; ///< of Mode::PSLG
  bool is_projection_said = false;
  bool is_quiet = false;
  const Standard_output* standard_output = nullptr; ///< for the mesh, where it is an output
  std::size_t memory = 0;                           ///< bytes; 0: no limit
  std::string scratch_folder;                       ///< empty: none is needed
  bool is_scratch_folder_ours = false;              ///< nobody named it
  bool is_resumed = false;
};

inline constexpr const char* mode_names[] = {"pslg", "points", "bounded", "acute", "warped"};
inline const char* name(Command_line::Mode mode) { return mode_names[static_cast<std::size_t>(mode)]; }

#endif // QUADTREE_MESH_2_EXAMPLES_COMMAND_LINE_TYPES_H
