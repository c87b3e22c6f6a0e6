// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_TINY_BLOCKS_H
#define QUADTREE_MESH_2_TEST_TINY_BLOCKS_H

#include <CGAL/Quadtree_mesh_2/internal/Mesh_checkpoints.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_blocks.h>
#include <CGAL/tags.h>

#include <atomic>
#include <cstddef>

/// A concurrency tag that cuts small inputs into blocks, and saves a checkpoint after every round.
struct Tiny_blocks_tag {};
/// One for blocks that are not quite as small.
struct Small_blocks_tag {};

/// While it lives, loops of `Tiny_blocks_tag` that any thread begins have several threads.
class Threads_for_tiny_blocks {
public:
  Threads_for_tiny_blocks() { are_wanted() = true; }
  ~Threads_for_tiny_blocks() { are_wanted() = false; }
  Threads_for_tiny_blocks(const Threads_for_tiny_blocks&) = delete;
  Threads_for_tiny_blocks& operator=(const Threads_for_tiny_blocks&) = delete;

  static std::atomic<bool>& are_wanted() {
    static std::atomic<bool> are_wanted{false};
    return are_wanted;
  }
};

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <>
struct Block_sizes<Tiny_blocks_tag> {
  static constexpr std::size_t vertices = 24;
  static constexpr std::size_t triangles = 24;
};

template <>
struct Block_sizes<Small_blocks_tag> {
  static constexpr std::size_t vertices = 256;
  static constexpr std::size_t triangles = 256;
};

template <>
struct Executor<Tiny_blocks_tag> {
  template <class F>
  static void run(std::size_t n, const F& f) {
    if (Threads_for_tiny_blocks::are_wanted()) return Executor<Parallel_tag>::run(n, f);
    Executor<Sequential_tag>::run(n, f);
  }
};

template <>
struct Checkpoint_pace<Tiny_blocks_tag> {
  static constexpr int time_between = 0;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // QUADTREE_MESH_2_TEST_TINY_BLOCKS_H
