// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What there is between two rounds of blocks, and when there is another one.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_ROUNDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_ROUNDS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_handles.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What a round works on.
struct Round_extent {
  std::size_t blocks, triangles; ///< and triangles in them
  std::size_t slots;             ///< for triangles of the whole mesh

  /// Whether a round that hardly helps costs much: acute corners may reach through most of a large mesh, and no block
  /// has all of one.
  bool is_dear() const { return triangles > dear_number_of_triangles && 3 * triangles > slots; }

private:
  static constexpr std::size_t dear_number_of_triangles = std::size_t(1) << 17;
};

/// What there is between two rounds, besides the mesh.
struct Block_rounds {
  int number = 0;                             ///< of rounds that are done
  int fruitless = 0;                          ///< those at the end that did not help, though they should have
  std::vector<Triangle_id> waiting;           ///< bad triangles
  Uninitialized_vector<Triangle_id> at_seams; ///< of the last round

  bool are_over = false; ///< and all that follows on them is done

  static constexpr int most_fruitless = 3;
  static constexpr int most = 40;

  /// Whether another round may be of use: the first two always are.
  bool may_go_on() const {
    return number < 2 || (!waiting.empty() && fruitless < most_fruitless && number < most);
  }

  /// Counts the round that is over. After a dear one, an eighth less has to wait, and after one of a single block at
  /// least one triangle. Several blocks may help once they have grown.
  void note(std::size_t waiting_before, const Round_extent& extent) {
    if (number <= 2 || (extent.blocks != 1 && !extent.is_dear())) return;
    const std::size_t least_help = extent.is_dear() ? waiting_before / 8 : 0;
    fruitless = waiting.size() < waiting_before - least_help ? 0 : fruitless + 1;
  }

  /// Of the work of all rounds, most of which is in the first.
  /// \param of_round the share of the last round that is done
  double share_done(double of_round) const {
    constexpr double share_of_first = 0.8;
    double begin = 0, end = share_of_first;
    for (int round = 1; round < number; ++round) begin = end, end = (1 + end) / 2;
    return begin + (end - begin) * of_round;
  }

  /// Writes or reads it (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(number, fruitless, waiting, at_seams, are_over);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_ROUNDS_H
