#ifndef QUADTREE_MESH_2_EXAMPLES_SCRATCH_FOLDER_H
#define QUADTREE_MESH_2_EXAMPLES_SCRATCH_FOLDER_H

#include "command_line_types.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

/// The scratch folder of a command line, which goes when nothing is left in it and nobody else has use for it.
class Scratch_folder {
public:
  /// Makes it if need be.
  /// \throws std::runtime_error naming it if it cannot be made
  explicit Scratch_folder(const Command_line& line) : name_(line.scratch_folder) {
    if (name_.empty()) return;
    std::error_code error;
    const bool is_new = std::filesystem::create_directories(name_, error);
    if (error || !std::filesystem::is_directory(name_))
      throw std::runtime_error("the scratch folder '" + name_ +
                               "' cannot be made: name another one by --scratch");
    is_ours_ = is_new || line.is_scratch_folder_ours;
  }
  Scratch_folder(const Scratch_folder&) = delete;
  Scratch_folder& operator=(const Scratch_folder&) = delete;
  ~Scratch_folder() {
    std::error_code ignored;
    if (is_ours_) std::filesystem::remove(name_, ignored);
  }

  const std::string& name() const { return name_; }

private:
  std::string name_; // empty: none
  bool is_ours_ = false;
};

#endif // QUADTREE_MESH_2_EXAMPLES_SCRATCH_FOLDER_H
