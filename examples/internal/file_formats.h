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

enum class Input_format { poly, geojson, wkt, node, table };
enum class Output_format { triangle, vtu, svg, off, obj, msh, medit };
/// What the colors of a picture stand for.
enum class Picture_colors { none, angle, largest_angle, region };

/// By the ending, or by that before `.gz`; without any it is a .poly file, as from a pipe.
inline Input_format input_format(const std::string& file_name) {
  static const std::vector<std::pair<std::string, Input_format>> endings = {
      {"", Input_format::poly},         {".poly", Input_format::poly}, {".geojson", Input_format::geojson},
      {".json", Input_format::geojson}, {".wkt", Input_format::wkt},   {".node", Input_format::node},
      {".xy", Input_format::table},     {".txt", Input_format::table}, {".csv", Input_format::table}};
  std::filesystem::path path(file_name);
  if (path.extension() == ".gz") path.replace_extension();
  for (const auto& [ending, format] : endings)
    if (path.extension() == ending) return format;
  throw Usage_error("cannot tell the format of input '" + file_name +
                    "': its ending has to be .poly, .geojson, .json, .wkt, .node, .xy, .txt or .csv");
}

inline Output_format output_format(const std::string& file_name) {
  static const std::vector<std::pair<std::string, Output_format>> endings = {
      {".ele", Output_format::triangle},  {".node", Output_format::triangle},
      {".poly", Output_format::triangle}, {".vtu", Output_format::vtu},
      {".svg", Output_format::svg},       {".off", Output_format::off},
      {".obj", Output_format::obj},       {".msh", Output_format::msh},
      {".mesh", Output_format::medit}};
  for (const auto& [ending, format] : endings)
    if (std::filesystem::path(file_name).extension() == ending) return format;
  throw Usage_error("cannot tell the format of output '" + file_name +
                    "': its ending has to be .ele, .node, .poly, .vtu, .svg, .off, .obj, .msh or .mesh");
}

/// The files that an output consists of.
inline std::vector<std::filesystem::path> files_of_output(const std::string& file_name) {
  const std::filesystem::path path(file_name);
  if (output_format(file_name) != Output_format::triangle) return {path};
  std::vector<std::filesystem::path> files;
  for (const char* ending : {".node", ".ele", ".poly"})
    files.push_back(std::filesystem::path(path).replace_extension(ending));
  return files;
}

#endif // QUADTREE_MESH_2_EXAMPLES_FILE_FORMATS_H
