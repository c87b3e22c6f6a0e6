#ifndef QUADTREE_MESH_2_EXAMPLES_SCRATCH_FOLDER_H
#define QUADTREE_MESH_2_EXAMPLES_SCRATCH_FOLDER_H

#include "command_line_types.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

/// The scratch folder of a command line. It goes, with those that were made for it, when nothing is left in it and
/// nobody else has use for it.
class Scratch_folder {
public:
  /// Makes it if need be.
  /// \throws std::runtime_error naming it if it cannot be made
  explicit Scratch_folder(const Command_line& line) : name_(line.scratch_folder) {
    if (name_.empty()) return;
    std::error_code error;
    std::vector<std::filesystem::path> missing; // it, the one that it is in, ...
    for (std::filesystem::path folder = name_; !folder.empty() && !std::filesystem::exists(folder, error);
         folder = folder.parent_path())
      missing.push_back(folder);
    std::filesystem::create_directories(name_, error);
    if (error || !std::filesystem::is_directory(name_))
      throw std::runtime_error("the scratch folder '" + name_ +
                               "' cannot be made: name another one by --scratch");
    ours_ = std::move(missing);
    if (ours_.empty() && line.is_scratch_folder_ours) ours_.emplace_back(name_);
  }
  Scratch_folder(const Scratch_folder&) = delete;
  Scratch_folder& operator=(const Scratch_folder&) = delete;
  ~Scratch_folder() {
    std::error_code ignored; // what others have put something into stays
    for (const std::filesystem::path& folder : ours_) std::filesystem::remove(folder, ignored);
  }

  const std::string& name() const { return name_; }

private:
  std::string name_;                        // empty: none
  std::vector<std::filesystem::path> ours_; // those that it has made, the innermost first
};

#endif // QUADTREE_MESH_2_EXAMPLES_SCRATCH_FOLDER_H
