// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SCRATCH_FOLDER_H
#define QUADTREE_MESH_2_TEST_SCRATCH_FOLDER_H

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

/// A folder that is empty at first and gone at the end.
class Scratch_folder {
public:
  Scratch_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "quadtree_mesh_2_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path_ = name;
  }
  Scratch_folder(const Scratch_folder&) = delete;
  Scratch_folder& operator=(const Scratch_folder&) = delete;
  ~Scratch_folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file and returns its name.
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
    return file(name);
  }
  std::size_t number_of_files() const {
    using std::filesystem::directory_iterator;
    return std::size_t(std::distance(directory_iterator(path_), directory_iterator()));
  }

private:
  std::filesystem::path path_;
};

/// All bytes of a file.
inline std::string content(const std::string& file_name) {
  std::ostringstream bytes;
  bytes << std::ifstream(file_name, std::ios::binary).rdbuf();
  return bytes.str();
}

#endif // QUADTREE_MESH_2_TEST_SCRATCH_FOLDER_H
