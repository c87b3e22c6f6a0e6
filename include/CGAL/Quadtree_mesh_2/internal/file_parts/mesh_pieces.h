// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_MESH_PIECES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_MESH_PIECES_H

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The triangles of a mesh cut into runs of the same length, or one more.
class Triangle_runs {
public:
  /// As many as are asked for, but none empty unless it is the only one.
  Triangle_runs(std::size_t triangles, std::size_t runs)
      : triangles_(triangles), runs_(std::min(runs, std::max<std::size_t>(triangles, 1))) {}

  std::size_t size() const { return runs_; }
  /// The first triangle of a run; with `size()` that behind the last one.
  std::size_t begin(std::size_t run) const {
    return triangles_ / runs_ * run + std::min(run, triangles_ % runs_);
  }
  std::size_t run_of(std::size_t triangle) const {
    const std::size_t length = triangles_ / runs_, longer = triangles_ % runs_;
    if (triangle < longer * (length + 1)) return triangle / (length + 1);
    return longer + (triangle - longer * (length + 1)) / length;
  }

private:
  std::size_t triangles_, runs_;
};

/// How many pieces a mesh is cut into if nobody says: such as an editor or a viewer likes to have in memory.
inline std::size_t usual_number_of_pieces(std::size_t triangles) {
  constexpr std::size_t longest = std::size_t(1) << 20;
  return std::max<std::size_t>(1, (triangles + longest - 1) / longest);
}

/// The name of a piece's file, counted from 1: "folder/mesh_1.vtu" for "folder/mesh.pvtu" and ".vtu".
inline std::string piece_file_name(const std::string& file_name, std::size_t piece,
                                   const std::string& ending) {
  return std::filesystem::path(file_name).replace_extension().string() + '_' + std::to_string(piece) + ending;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_MESH_PIECES_H
