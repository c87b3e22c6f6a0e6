#ifndef QUADTREE_MESH_2_EXAMPLES_FILE_FORMATS_H
#define QUADTREE_MESH_2_EXAMPLES_FILE_FORMATS_H

// The formats that quality_mesh reads and writes, by the endings of file names.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The command line cannot be obeyed; `what()` says why.
class Usage_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

enum class Input_format { POLY, GEOJSON, WKT, NODE, TABLE };
enum class Output_format { TRIANGLE, VTU, SVG, OFF, OBJ, MSH, MEDIT };
/// What the colors of a picture stand for.
enum class Picture_colors { NONE, ANGLE, LARGEST_ANGLE, REGION };

/// By the ending, or by that before `.gz`; without any it is a .poly file, as from a pipe.
inline Input_format input_format(const std::string& file_name) {
  static const std::vector<std::pair<std::string, Input_format>> endings = {
      {"", Input_format::POLY},         {".poly", Input_format::POLY}, {".geojson", Input_format::GEOJSON},
      {".json", Input_format::GEOJSON}, {".wkt", Input_format::WKT},   {".node", Input_format::NODE},
      {".xy", Input_format::TABLE},     {".txt", Input_format::TABLE}, {".csv", Input_format::TABLE}};
  std::filesystem::path path(file_name);
  if (path.extension() == ".gz") path.replace_extension();
  for (const auto& [ending, format] : endings)
    if (path.extension() == ending) return format;
  throw Usage_error("cannot tell the format of input '" + file_name +
                    "': its ending has to be .poly, .geojson, .json, .wkt, .node, .xy, .txt or .csv");
}

inline Output_format output_format(const std::string& file_name) {
  static const std::vector<std::pair<std::string, Output_format>> endings = {
      {".ele", Output_format::TRIANGLE},  {".node", Output_format::TRIANGLE},
      {".poly", Output_format::TRIANGLE}, {".vtu", Output_format::VTU},
      {".svg", Output_format::SVG},       {".off", Output_format::OFF},
      {".obj", Output_format::OBJ},       {".msh", Output_format::MSH},
      {".mesh", Output_format::MEDIT}};
  for (const auto& [ending, format] : endings)
    if (std::filesystem::path(file_name).extension() == ending) return format;
  throw Usage_error("cannot tell the format of output '" + file_name +
                    "': its ending has to be .ele, .node, .poly, .vtu, .svg, .off, .obj, .msh or .mesh");
}

/// The files that an output consists of.
inline std::vector<std::filesystem::path> files_of_output(const std::string& file_name) {
  const std::filesystem::path path(file_name);
  if (output_format(file_name) != Output_format::TRIANGLE) return {path};
  std::vector<std::filesystem::path> files;
  for (const char* ending : {".node", ".ele", ".poly"})
    files.push_back(std::filesystem::path(path).replace_extension(ending));
  return files;
}

#endif // QUADTREE_MESH_2_EXAMPLES_FILE_FORMATS_H
