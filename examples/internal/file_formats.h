#ifndef QUADTREE_MESH_2_EXAMPLES_FILE_FORMATS_H
#define QUADTREE_MESH_2_EXAMPLES_FILE_FORMATS_H

// The formats that quality_mesh reads and writes, by the endings of file names.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The command line cannot be obeyed; `what()` says why.
class Usage_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

enum class Input_format { POLY, GEOJSON, WKT, HDF5, NODE, ELE, TABLE, OGR };
enum class Output_format {
  TRIANGLE,
  VTU,
  PVTU,
  VTKHDF,
  XDMF,
  SVG,
  HTML,
  OFF,
  OBJ,
  MSH,
  MEDIT,
  SMS_2DM,
  GR3,
  ADCIRC,
  TRIANGLE_EDGE,
  TRIANGLE_NEIGH,
  TRIANGLE_VORONOI,
  CELLS_GEOJSON,
  CELLS_WKT
};
/// What the colors of a picture stand for.
enum class Picture_colors { NONE, ANGLE, LARGEST_ANGLE, REGION, SIZE };

/// \throws Usage_error if this program knows no files of HDF5
inline void check_has_hdf5(const std::string& file_name) {
#ifndef CGAL_LINKED_WITH_HDF5
  throw Usage_error("'" + file_name + "' is a file of HDF5, without which this program was built");
#else
  static_cast<void>(file_name);
#endif
}

/// \throws Usage_error if this program knows no files of GDAL
inline void check_has_gdal(const std::string& file_name) {
#ifndef QUADTREE_MESH_GDAL_MODULE
  throw Usage_error("'" + file_name + "' is read by GDAL, without which this program was built");
#else
  static_cast<void>(file_name);
#endif
}

/// The ending of a name says nothing.
struct Unknown_ending : Usage_error {
  Unknown_ending(const std::string& kind, const std::string& name, const std::string& endings)
      : Usage_error("cannot tell the format of " + kind + " '" + name + "': its ending has to be " + endings),
        file_name(name) {}

  std::string file_name;
};

/// By the ending, or by that before `.gz`; without any it is a .poly file, as from a pipe.
inline Input_format input_format(const std::string& file_name) {
  static const std::vector<std::pair<std::string, Input_format>> endings = {
      {"", Input_format::POLY},         {".poly", Input_format::POLY}, {".geojson", Input_format::GEOJSON},
      {".json", Input_format::GEOJSON}, {".wkt", Input_format::WKT},   {".h5", Input_format::HDF5},
      {".hdf5", Input_format::HDF5},    {".node", Input_format::NODE}, {".xy", Input_format::TABLE},
      {".txt", Input_format::TABLE},    {".csv", Input_format::TABLE}, {".shp", Input_format::OGR},
      {".shz", Input_format::OGR},      {".gpkg", Input_format::OGR},  {".kml", Input_format::OGR},
      {".kmz", Input_format::OGR},      {".gml", Input_format::OGR},   {".fgb", Input_format::OGR},
      {".dxf", Input_format::OGR},      {".ele", Input_format::ELE}};
  std::filesystem::path path(file_name);
  const bool is_compressed = path.extension() == ".gz";
  if (is_compressed) path.replace_extension();
  for (const auto& [ending, format] : endings)
    if (path.extension() == ending) {
      if (format == Input_format::HDF5) check_has_hdf5(file_name);
      if (format == Input_format::OGR) {
        check_has_gdal(file_name);
        if (is_compressed) throw Usage_error("'" + file_name + "' is read by GDAL: unpack it first");
      }
      return format;
    }
  throw Unknown_ending(
      "input", file_name,
      ".poly, .geojson, .json, .wkt, .h5, .hdf5, .node, .xy, .txt, .csv, .ele (a mesh to refine), or "
      ".shp, .shz, .gpkg, .kml, .kmz, .gml, .fgb, .dxf (by GDAL)");
}

enum class Grid_format { ESRI, GDAL };

/// An ASCII grid of ESRI, by the ending, or by that before `.gz`; all else is for GDAL.
inline Grid_format grid_format(const std::string& file_name) {
  std::filesystem::path path(file_name);
  if (path.extension() == ".gz") path.replace_extension();
  for (const char* const ending : {"", ".asc", ".txt"})
    if (path.extension() == ending) return Grid_format::ESRI;
  check_has_gdal(file_name);
  return Grid_format::GDAL;
}

/// Formats with two endings tell what of a mesh is written; nothing if the name has no such endings.
inline std::optional<Output_format> output_format_of_two_endings(const std::string& file_name) {
  static const std::vector<std::pair<std::string, Output_format>> endings = {
      {".v.node", Output_format::TRIANGLE_VORONOI},
      {".v.edge", Output_format::TRIANGLE_VORONOI},
      {".cells.geojson", Output_format::CELLS_GEOJSON},
      {".cells.wkt", Output_format::CELLS_WKT}};
  const std::filesystem::path path(file_name);
  for (const auto& [ending, format] : endings)
    if (path.stem().extension().string() + path.extension().string() == ending) return format;
  return std::nullopt;
}

inline Output_format output_format(const std::string& file_name) {
  if (const auto format = output_format_of_two_endings(file_name)) return *format;
  static const std::vector<std::pair<std::string, Output_format>> endings = {
      {".ele", Output_format::TRIANGLE},
      {".node", Output_format::TRIANGLE},
      {".poly", Output_format::TRIANGLE},
      {".vtu", Output_format::VTU},
      {".pvtu", Output_format::PVTU},
      {".vtkhdf", Output_format::VTKHDF},
      {".xdmf", Output_format::XDMF},
      {".h5", Output_format::XDMF},
      {".svg", Output_format::SVG},
      {".html", Output_format::HTML},
      {".off", Output_format::OFF},
      {".obj", Output_format::OBJ},
      {".msh", Output_format::MSH},
      {".mesh", Output_format::MEDIT},
      {".2dm", Output_format::SMS_2DM},
      {".gr3", Output_format::GR3},
      {".14", Output_format::ADCIRC},
      {".edge", Output_format::TRIANGLE_EDGE},
      {".neigh", Output_format::TRIANGLE_NEIGH}};
  for (const auto& [ending, format] : endings)
    if (std::filesystem::path(file_name).extension() == ending) {
      if (format == Output_format::VTKHDF || format == Output_format::XDMF) check_has_hdf5(file_name);
      return format;
    }
  throw Unknown_ending(
      "output", file_name,
      ".ele, .node, .poly, .vtu, .pvtu, .vtkhdf, .xdmf, .h5, .svg, .html, .off, .obj, .msh, .mesh, "
      ".2dm, .gr3, .14, .edge, .neigh, .v.node, .cells.geojson or .cells.wkt");
}

/// The files that an output consists of, besides its pieces.
inline std::vector<std::filesystem::path> files_of_output(const std::string& file_name) {
  const std::filesystem::path path(file_name);
  std::vector<const char*> endings;
  if (output_format(file_name) == Output_format::TRIANGLE) endings = {".node", ".ele", ".poly"};
  if (output_format(file_name) == Output_format::XDMF) endings = {".xdmf", ".h5"};
  if (output_format(file_name) == Output_format::TRIANGLE_VORONOI) endings = {".node", ".edge"};
  if (endings.empty()) return {path};
  std::vector<std::filesystem::path> files;
  for (const char* ending : endings) files.push_back(std::filesystem::path(path).replace_extension(ending));
  return files;
}

/// The ending of the pieces of an output, such as `mesh_1.vtu`; empty if it has none.
/// \param pieces that are wanted; 0 if nothing is said
inline std::string ending_of_pieces(const std::string& output, std::size_t pieces) {
  if (output_format(output) == Output_format::PVTU) return ".vtu";
  return output_format(output) == Output_format::MSH && pieces > 0 ? ".msh" : "";
}

#endif // QUADTREE_MESH_2_EXAMPLES_FILE_FORMATS_H
