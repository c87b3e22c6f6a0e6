// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_STANDARD_STREAMS_H
#define QUADTREE_MESH_2_EXAMPLES_STANDARD_STREAMS_H

// Standard input and output in place of files: `-`, with the ending of a format, such as `-.off`. What the user calls
// so, and is a file, gets another name (`name_of_file()`).

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

/// The name for a stream in a format.
/// \param format an ending without its dot; empty: none is known
inline std::string name_of_stream(const std::string& format) { return format.empty() ? "-" : "-." + format; }

inline bool is_standard_stream(const std::string& name) {
  const std::filesystem::path path(name);
  return name == "-" || (path.stem() == "-" && path.parent_path().empty());
}

/// The same file under a name that stands for no stream.
inline std::string name_of_file(const std::string& name) {
  return is_standard_stream(name) ? "./" + name : name;
}

/// Standard output, kept for the mesh alone: while it lives, all that is printed goes to standard error.
class Standard_output {
public:
  /// \throws std::system_error
  Standard_output() {
    std::fflush(stdout);
    const int descriptor = dup(STDOUT_FILENO);
    file_ = descriptor < 0 ? nullptr : fdopen(descriptor, "wb");
    if (file_ == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
      throw std::system_error(errno, std::generic_category(), "standard output");
  }
  Standard_output(const Standard_output&) = delete;
  Standard_output& operator=(const Standard_output&) = delete;
  ~Standard_output() {
    std::fflush(stdout);
    dup2(fileno(file_), STDOUT_FILENO);
    std::fclose(file_);
  }

  std::FILE* file() const { return file_; }

private:
  std::FILE* file_;
};

#endif // QUADTREE_MESH_2_EXAMPLES_STANDARD_STREAMS_H
