// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Inputs of the benchmarks of meshers as their command lines name them: files, or families with a size.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_FILES_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_FILES_H

#include "pslg_inputs.h"

#include <CGAL/IO/Triangle_files.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace pslg_files {

inline pslg_inputs::Input input_of(const std::string& name) {
  if (pslg_inputs::is_name(name)) return pslg_inputs::by_name(name);
  pslg_inputs::Input input;
  CGAL::IO::read_triangle_poly(name, input.pslg);
  return input;
}

/// \throws std::invalid_argument if there is no such file, and the name is none of a family with a size.
inline void check(const std::string& name) {
  if (pslg_inputs::is_name(name))
    pslg_inputs::size_of(name);
  else if (!std::filesystem::exists(name))
    throw std::invalid_argument("there is no input '" + name + "'");
}

/// A synthetic input keeps its name, a file that without folder and ending.
inline std::string short_name(const std::string& input) {
  if (pslg_inputs::is_name(input)) return input;
  const std::string name = std::filesystem::path(input).filename().string();
  return name.substr(0, name.find(".poly"));
}

inline bool is_input(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return path.extension() == ".poly" ||
         (name.size() > 8 && name.compare(name.size() - 8, 8, ".poly.gz") == 0);
}

/// The inputs of the examples and of the tests.
inline std::vector<std::string> all_of_project() {
  std::vector<std::string> inputs;
  for (const char* folder : {"/examples/data", "/test/data"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(QUADTREE_MESH_SOURCE_DIR) + folder))
      if (is_input(entry.path())) inputs.push_back(entry.path().string());
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

} // namespace pslg_files

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_FILES_H
