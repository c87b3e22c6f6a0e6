// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_FILE_CASE_H
#define QUADTREE_MESH_2_TEST_SOAK_FILE_CASE_H

// The program quality_mesh, with a file that is damaged or not and options that are in range or not.

#include "judge.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soak {

struct File_case {
  std::uint64_t seed = 0;
  std::string ending;                 ///< of the input: what the program takes the format from
  std::string text;                   ///< of the input
  std::vector<std::string> arguments; ///< FOLDER stands for where files are
};

/// The case of a number: the same whenever it is made.
File_case make_file_case(std::uint64_t seed);

/// Runs the program and judges it by the contract of its exit status: 0 is a valid mesh that meets the bounds, 1 a
/// mesh, 2 a message and no file, and there is no other.
Verdict judge(const File_case& c, double cpu_seconds);

/// Without lines that it fails without in the same way.
File_case minimized(File_case c, const std::string& kind, double cpu_seconds, double seconds);

/// Writes the input, and beside it what to call.
std::string write_case(const std::string& stem, const File_case& c, const Verdict& verdict);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_FILE_CASE_H
