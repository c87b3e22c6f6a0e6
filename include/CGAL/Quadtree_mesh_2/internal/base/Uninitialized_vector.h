// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_UNINITIALIZED_VECTOR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_UNINITIALIZED_VECTOR_H

#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Leaves values that are constructed without arguments as they are in memory, if they can be copied as bytes. So the
/// pages of a large array are touched by those who write it. Long arrays lie in huge pages.
template <class T>
class Uninitialized_allocator : public std::allocator<T> {
public:
  template <class U>
  struct rebind {
    using other = Uninitialized_allocator<U>;
  };

  Uninitialized_allocator() = default;
  template <class U>
  Uninitialized_allocator(const Uninitialized_allocator<U>&) noexcept {}

  T* allocate(std::size_t n) {
    return is_long(n) ? static_cast<T*>(allocate_in_huge_pages(n * sizeof(T)))
                      : std::allocator<T>::allocate(n);
  }
  void deallocate(T* values, std::size_t n) {
    if (is_long(n))
      free_in_huge_pages(values);
    else
      std::allocator<T>::deallocate(values, n);
  }

  template <class U>
  void construct(U* p) {
    if constexpr (!std::is_trivially_copyable_v<U> || !std::is_trivially_destructible_v<U>)
      ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Arguments>
  void construct(U* p, Arguments&&... arguments) {
    ::new (static_cast<void*>(p)) U(std::forward<Arguments>(arguments)...);
  }

private:
  static bool is_long(std::size_t n) {
    return n >= least_in_huge_pages / sizeof(T) && n <= std::size_t(-1) / 2 / sizeof(T);
  }
};

/// A vector whose `resize()` does not write. So one thread does not fill it before many threads do.
template <class T>
using Uninitialized_vector = std::vector<T, Uninitialized_allocator<T>>;

/// Gives such a vector a size, all of which is about to be written. If it is not in huge pages, its pages are there at
/// once.
template <class Vector>
void resize_to_write(Vector& values, std::size_t size) {
  values.resize(size);
  const std::size_t bytes = size * sizeof(typename Vector::value_type);
  if (bytes < least_in_huge_pages) ask_for_pages(values.data(), bytes);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_UNINITIALIZED_VECTOR_H
