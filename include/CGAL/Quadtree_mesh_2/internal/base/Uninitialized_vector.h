// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_UNINITIALIZED_VECTOR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_UNINITIALIZED_VECTOR_H

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Constructs values without arguments by default-initialization: numbers are left as they are in memory.
template <class T>
class Default_init_allocator : public std::allocator<T> {
public:
  template <class U>
  struct rebind {
    using other = Default_init_allocator<U>;
  };

  Default_init_allocator() = default;
  template <class U>
  Default_init_allocator(const Default_init_allocator<U>&) noexcept {}

  template <class U>
  void construct(U* p) {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Arguments>
  void construct(U* p, Arguments&&... arguments) {
    ::new (static_cast<void*>(p)) U(std::forward<Arguments>(arguments)...);
  }
};

/// A vector whose `resize()` does not write. So one thread does not fill it before many threads do.
template <class T>
using Uninitialized_vector = std::vector<T, Default_init_allocator<T>>;

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_UNINITIALIZED_VECTOR_H
