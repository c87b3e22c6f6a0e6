// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_RUN_PROGRAM_H
#define QUADTREE_MESH_2_TEST_RUN_PROGRAM_H

#include "scratch_folder.h"

#include <sys/wait.h>

#include <cstdlib>
#include <string>

namespace program_test {

inline std::string test_data(const std::string& name) { return QUADTREE_MESH_TEST_DATA_DIR "/" + name; }

struct Run {
  int status;
  std::string out;
  std::string err;
};

/// Runs quality_mesh with arguments for the shell.
inline Run run(const std::string& arguments) {
  const Scratch_folder folder;
  const std::string command = "'" QUADTREE_MESH_PROGRAM "' " + arguments + " >'" + folder.file("out") +
                              "' 2>'" + folder.file("err") + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder.file("out")),
          content(folder.file("err"))};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace program_test

#endif // QUADTREE_MESH_2_TEST_RUN_PROGRAM_H
