// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which part keeps what all parts may ask about a handle, though they hold different ones: a directory.
//
// Handles come in runs of 4096, which parts have in turn. So each has its share of any longer run, and what is known of
// a handle is at a place that follows from it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_HANDLE_OWNERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_HANDLE_OWNERS_H

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Handle_owners {
public:
  /// How many handles of each part are on their way at a time. What is sent of them takes little memory, which is in
  /// the cache and is used again and again.
  static constexpr std::size_t at_a_time = std::size_t(1) << 14;

  explicit Handle_owners(int parts) : parts_(static_cast<std::size_t>(parts)) {}

  int owner(std::size_t handle) const { return static_cast<int>(handle / run % parts_); }
  /// The place of a handle at its owner.
  std::size_t place(std::size_t handle) const { return handle / run / parts_ * run + handle % run; }
  /// What is there. \param part the owner
  std::size_t handle(int part, std::size_t place) const {
    return (place / run * parts_ + static_cast<std::size_t>(part)) * run + place % run;
  }
  /// Places for handles below `end` are below this, at each part.
  std::size_t places(std::size_t end) const { return (end / run / parts_ + 1) * run; }

  /// Calls `f(begin, end)` for runs of the handles below `n`, one after the other. All parts do so with the same `n`.
  template <class Function>
  void for_each_run(std::size_t n, const Function& f) const {
    const std::size_t length = at_a_time * parts_;
    for (std::size_t begin = 0; begin < n; begin += length) f(begin, std::min(n, begin + length));
  }

private:
  static constexpr std::size_t run = 4096;
  std::size_t parts_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_HANDLE_OWNERS_H
