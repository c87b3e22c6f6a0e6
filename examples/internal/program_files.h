#ifndef QUADTREE_MESH_2_EXAMPLES_PROGRAM_FILES_H
#define QUADTREE_MESH_2_EXAMPLES_PROGRAM_FILES_H

// Which files a run of quality_mesh reads and writes, and that it destroys none: found out before the work.

#include "file_formats.h"
#include "standard_streams.h"

#include <CGAL/IO/read_triangle_files.h>

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

/// A file and what the command line calls it.
struct Named_file {
  std::string name; ///< "input 'x.poly'"
  std::filesystem::path path;
};
using Named_files = std::vector<Named_file>;

namespace program_files_internal {

namespace fs = std::filesystem;

/// Whether two names lead to one file, through links of any kind, or would if it were there.
inline bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  if (fs::equivalent(a, b, ignored)) return true;
  return fs::weakly_canonical(fs::absolute(a, ignored), ignored) ==
         fs::weakly_canonical(fs::absolute(b, ignored), ignored);
}

/// \throws Usage_error if the file, or one beside it that takes its place in the end, cannot be written
inline void check_writable(const fs::path& file) {
  const auto fail = [&](const std::string& why) {
    throw Usage_error("cannot write '" + file.string() + "': " + why);
  };
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) fail("it is a folder");
  if (fs::exists(status) && access(file.c_str(), W_OK) != 0) fail("it may not be written");
  if (fs::exists(status) && !fs::is_regular_file(status)) return;
  const fs::path target = fs::exists(status) ? fs::canonical(file, error) : file;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) fail("no folder '" + folder.string() + "'");
  if (access(folder.c_str(), W_OK) != 0)
    fail("nothing may be written in the folder '" + folder.string() + "'");
}

} // namespace program_files_internal

/// The .node file with the vertices of a .poly file that has none is an input, too. Looks into the .poly file only if
/// there is such a file and an output would overwrite it.
inline void add_node_file(const std::string& input, const Named_files& outputs, Named_files& inputs) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  if (is_standard_stream(input) || input_format(input) != Input_format::POLY) return;
  const std::string node_file = internal::find_node_file(input);
  if (node_file.empty()) return;
  for (const Named_file& output : outputs)
    if (program_files_internal::is_same_file(output.path, node_file) && internal::has_no_vertices(input))
      inputs.push_back({"'" + node_file + "', which has the vertices of the input", node_file});
}

/// The files beside the .ele file of a mesh are inputs, too.
inline void add_files_of_mesh(const std::string& input, Named_files& inputs) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  if (is_standard_stream(input) || input_format(input) != Input_format::ELE) return;
  for (const char* const ending : {".node", ".poly"}) {
    const std::string file =
        internal::existing_triangle_file(internal::stem_of_triangle_file(input) + ending);
    if (!file.empty()) inputs.push_back({"'" + file + "' of the input", file});
  }
}

/// An output of which there are pieces, whose number may not be known before there is a mesh.
struct Pieced_output {
  std::string name, ending;
};

/// \throws Usage_error if a file has the name of a piece
inline void check_pieces(const Named_files& files, const std::vector<Pieced_output>& outputs) {
  namespace fs = std::filesystem;
  for (const Pieced_output& output : outputs) {
    const std::string stem = fs::path(output.name).stem().string() + '_';
    for (const Named_file& file : files) {
      const std::string name = file.path.stem().string();
      std::error_code ignored;
      if (file.path.extension() != output.ending || name.size() <= stem.size() || name.rfind(stem, 0) != 0 ||
          name.find_first_not_of("0123456789", stem.size()) != std::string::npos ||
          !program_files_internal::is_same_file(fs::absolute(file.path, ignored).parent_path(),
                                                fs::absolute(output.name, ignored).parent_path()))
        continue;
      throw Usage_error("a piece of output '" + output.name + "' would overwrite " + file.name +
                        "; choose another name");
    }
  }
}

/// \throws Usage_error if an output is an input, two outputs are one file, or one cannot be written
inline void check_files(const Named_files& inputs, const Named_files& outputs) {
  using program_files_internal::is_same_file;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const Named_file& input : inputs)
      if (is_same_file(outputs[i].path, input.path))
        throw Usage_error(outputs[i].name + " would overwrite " + input.name + "; choose another name");
    for (std::size_t j = 0; j < i; ++j)
      if (is_same_file(outputs[i].path, outputs[j].path))
        throw Usage_error(outputs[i].name + " would overwrite " + outputs[j].name + "; choose another name");
    program_files_internal::check_writable(outputs[i].path);
  }
}

#endif // QUADTREE_MESH_2_EXAMPLES_PROGRAM_FILES_H
