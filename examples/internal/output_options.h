#ifndef QUADTREE_MESH_2_EXAMPLES_OUTPUT_OPTIONS_H
#define QUADTREE_MESH_2_EXAMPLES_OUTPUT_OPTIONS_H

// The options of quality_mesh that say what its files have.

#include "command_line_types.h"
#include "file_formats.h"
#include "option_values.h"

#include <CGAL/Quadtree_mesh_2/internal/io/Msh_version.h>
#include <CGAL/Quadtree_mesh_2/mesh_dual_types.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace command_line_internal {

inline Picture_colors colors(const po::variables_map& given, Command_line::Mode mode,
                             Picture_colors if_not_given) {
  constexpr Picture_colors all[] = {Picture_colors::NONE, Picture_colors::ANGLE, Picture_colors::REGION,
                                    Picture_colors::SIZE};
  Picture_colors result = if_not_given;
  if (given.count("color") > 0) result = all[choice(given, "color", {"none", "angle", "region", "size"})];
  const bool is_by_largest = result == Picture_colors::ANGLE && mode == Command_line::Mode::ACUTE;
  return is_by_largest ? Picture_colors::LARGEST_ANGLE : result;
}

/// \throws Usage_error for options of pictures without a picture
inline void check_picture_options(const po::variables_map& given, const std::vector<std::string>& outputs) {
  const auto has_output = [&outputs](Output_format format) {
    return std::any_of(outputs.begin(), outputs.end(),
                       [format](const std::string& output) { return output_format(output) == format; });
  };
  if (given.count("color") > 0 && !has_output(Output_format::SVG) && !has_output(Output_format::HTML))
    throw Usage_error("--color needs an output .svg or .html (-o FILE.html)");
  if (text(given, "color") == "size" && has_output(Output_format::SVG))
    throw Usage_error("--color size has a meaning for .html only, not for .svg");
  constexpr Output_format with_fields[] = {Output_format::SVG,  Output_format::HTML,   Output_format::VTU,
                                           Output_format::PVTU, Output_format::VTKHDF, Output_format::XDMF};
  if (given.count("show-quadtree") > 0 &&
      std::none_of(std::begin(with_fields), std::end(with_fields), has_output))
    throw Usage_error(
        "--show-quadtree needs an output .svg, .html, .vtu, .pvtu, .vtkhdf or .xdmf (-o FILE.html)");
}

/// \throws Usage_error if no output may have pieces
inline std::size_t pieces(const po::variables_map& given, const std::vector<std::string>& outputs) {
  if (given.count("pieces") == 0) return 0;
  const auto has_pieces = [](const std::string& output) { return !ending_of_pieces(output, 1).empty(); };
  if (std::none_of(outputs.begin(), outputs.end(), has_pieces))
    throw Usage_error("--pieces needs an output .pvtu or .msh (-o FILE.pvtu)");
  return static_cast<std::size_t>(whole_number(given, "pieces", {1, 65536}));
}

/// \throws Usage_error if there is no output in this format, or it has parts, which are in 4.1
inline CGAL::IO::Msh_version msh_version(const po::variables_map& given, const Command_line& line) {
  using CGAL::IO::Msh_version;
  constexpr Msh_version versions[] = {Msh_version::V4_1, Msh_version::V2_2};
  if (given.count("msh-version") == 0) return Msh_version::V4_1;
  const auto is_msh = [](const std::string& output) { return output_format(output) == Output_format::MSH; };
  if (std::none_of(line.outputs.begin(), line.outputs.end(), is_msh))
    throw Usage_error("--msh-version needs an output .msh (-o FILE.msh)");
  const Msh_version version = versions[choice(given, "msh-version", {"4.1", "2.2"})];
  if (version == Msh_version::V2_2 && line.pieces > 0)
    throw Usage_error("--pieces writes .msh in version 4.1 only, not by --msh-version 2.2");
  return version;
}

inline bool has_output_of(const Command_line& line, const std::vector<Output_format>& formats) {
  return std::any_of(line.outputs.begin(), line.outputs.end(), [&formats](const std::string& output) {
    return std::find(formats.begin(), formats.end(), output_format(output)) != formats.end();
  });
}

/// \throws Usage_error if no output has elements of second order, or parts would have some
inline CGAL::IO::Element_order element_order(const po::variables_map& given, const Command_line& line) {
  if (given.count("second-order") == 0) return CGAL::IO::Element_order::FIRST;
  if (!has_output_of(line, {Output_format::TRIANGLE, Output_format::VTU, Output_format::MSH}))
    throw Usage_error("--second-order needs an output .ele, .vtu or .msh (-o FILE.vtu)");
  if (line.pieces > 0 && has_output_of(line, {Output_format::MSH}))
    throw Usage_error("--second-order has no meaning for .msh in parts (--pieces)");
  return CGAL::IO::Element_order::SECOND;
}

/// \throws Usage_error if no output has cells
inline CGAL::Mesh_dual_2::Kind cells(const po::variables_map& given, const Command_line& line) {
  using Kind = CGAL::Mesh_dual_2::Kind;
  constexpr Kind kinds[] = {Kind::CIRCUMCENTRIC, Kind::BARYCENTRIC};
  if (given.count("cells") == 0) return Kind::CIRCUMCENTRIC;
  if (!has_output_of(line, {Output_format::CELLS_GEOJSON, Output_format::CELLS_WKT}))
    throw Usage_error("--cells needs an output .cells.geojson or .cells.wkt (-o FILE.cells.geojson)");
  return kinds[choice(given, "cells", {"voronoi", "median"})];
}

} // namespace command_line_internal

#endif // QUADTREE_MESH_2_EXAMPLES_OUTPUT_OPTIONS_H
