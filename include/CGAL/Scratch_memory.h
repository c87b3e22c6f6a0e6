// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_SCRATCH_MEMORY_H
#define CGAL_SCRATCH_MEMORY_H

#include <CGAL/Quadtree_mesh_2/internal/base/Resident_limit.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_arrays.h>

#include <cstddef>
#include <string>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Lets meshes be larger than memory: as long as it lives, the long arrays of meshers and quadtrees are made in a file
/// on a disk, of which the system keeps in memory what is in use.
///
/// Meshes have the same bits with it and without it. The work goes block by block through arrays in the order of
/// places, so few pages are in use at a time. Arrays that are made meanwhile may outlive this. The file has no
/// name, and the system removes it when its last array is gone, however the process ends.
///
/// Long `std::vector`s, which are those of `Pslg_2`, of `Indexed_mesh_2` and of the program, are in the file only if
/// one source file of the program includes `CGAL/Quadtree_mesh_2/new_in_scratch_memory.h`.
///
/// Linux only. There can be one at a time. After `fork()` a child process shares the arrays with its parent: until
/// `exec()` or its end it must not write, make or free any.
class Scratch_memory {
public:
  /// From this size on arrays are long: 64 kilobytes.
  static constexpr std::size_t least_bytes_of_array = std::size_t(1) << 16;

  /// Begins to make long arrays in a file of this folder.
  /// \param folder on a disk with room for all: some 250 bytes for each triangle of a mesh
  /// \param most_bytes in memory, of all that this process has. What is not in long arrays, blocks that are being
  ///        worked on above all, takes some 50 megabytes and 20 for each thread, which cannot be less.
  /// \param least_bytes of arrays in the file, a page at least
  /// \throws std::system_error if the folder can have no such file
  /// \throws std::logic_error if there is another one
  Scratch_memory(const std::string& folder, std::size_t most_bytes,
                 std::size_t least_bytes = least_bytes_of_array)
      : file_{Arrays::start(folder, least_bytes)}, limit_(file_.file, most_bytes) {}
  /// Not copied: there is one at a time.
  Scratch_memory(const Scratch_memory&) = delete;
  /// Not assigned.
  Scratch_memory& operator=(const Scratch_memory&) = delete;

private:
  using Arrays = Quadtree_mesh_2::internal::Scratch_arrays;
  struct Current_file {
    Quadtree_mesh_2::internal::Scratch_file& file;
    ~Current_file() { Arrays::stop(); }
  };

  Current_file file_;
  Quadtree_mesh_2::internal::Resident_limit limit_; // ends before the file
};

} // namespace CGAL

#endif // CGAL_SCRATCH_MEMORY_H
