// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FOLDER_LOCK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FOLDER_LOCK_H

#include <cerrno>
#include <stdexcept>
#include <string>

#ifdef __linux__
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Keeps a folder for this process as long as it lives, on systems where that is known to work.
class Folder_lock {
public:
  /// \throws std::runtime_error if another process has it
  explicit Folder_lock(const std::string& folder) {
#ifdef __linux__
    file_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    close(file_);
    throw std::runtime_error(folder + ": another program is at work in this folder");
#else
    static_cast<void>(folder);
#endif
  }
  Folder_lock(const Folder_lock&) = delete;
  Folder_lock& operator=(const Folder_lock&) = delete;
  ~Folder_lock() {
#ifdef __linux__
    if (file_ >= 0) close(file_);
#endif
  }

private:
#ifdef __linux__
  int file_ = -1;
#endif
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FOLDER_LOCK_H
