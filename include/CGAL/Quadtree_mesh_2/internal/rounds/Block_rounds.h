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

/// What there is between two rounds, besides the mesh.
struct Block_rounds {
  int number = 0;                   ///< of rounds that are done
  int fruitless = 0;                ///< those at the end, of one block each, that left as much as there was
  std::vector<Triangle_id> waiting; ///< bad triangles
  Uninitialized_vector<Triangle_id> at_seams; ///< of the last round

  bool are_over = false; ///< and all that follows on them is done

  /// Rounds of one block each. As long as there are several blocks, less may wait after the next round.
  static constexpr int most_fruitless = 3;
  static constexpr int most = 40;

  /// Whether another round may be of use: the first two always are.
  bool may_go_on() const {
    return number < 2 || (!waiting.empty() && fruitless < most_fruitless && number < most);
  }

  /// Counts the round that is over, with so many waiting before and so many blocks.
  void note(std::size_t waiting_before, std::size_t blocks) {
    if (number > 2 && blocks == 1) fruitless = waiting.size() < waiting_before ? 0 : fruitless + 1;
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
