// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Replaces `operator new` and `operator delete` of a program, so that its long `std::vector`s and strings are in the
// file of a `CGAL::Scratch_memory`, as long as there is one. To be included by one source file of the program.

#ifndef CGAL_QUADTREE_MESH_2_NEW_IN_SCRATCH_MEMORY_H
#define CGAL_QUADTREE_MESH_2_NEW_IN_SCRATCH_MEMORY_H

#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_arrays.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <cstddef>
#include <cstdlib>
#include <new>

// All forms but aligned ones, which vectors of the usual types do not use: sanitizers have their own of what is
// missing. Inlined they would make g++ warn of what it takes for memory on the stack.

BOOST_NOINLINE void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  using CGAL::Quadtree_mesh_2::internal::Scratch_arrays;
  try {
    if (void* const memory = Scratch_arrays::allocate(bytes)) return memory;
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
  return std::malloc(bytes > 0 ? bytes : 1);
}

BOOST_NOINLINE void* operator new(std::size_t bytes) {
  using CGAL::Quadtree_mesh_2::internal::Scratch_arrays;
  if (void* const memory = Scratch_arrays::allocate(bytes)) return memory;
  for (;;) {
    if (void* const memory = std::malloc(bytes > 0 ? bytes : 1)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

BOOST_NOINLINE void* operator new[](std::size_t bytes) { return operator new(bytes); }
BOOST_NOINLINE void* operator new[](std::size_t bytes, const std::nothrow_t& tag) noexcept {
  return operator new(bytes, tag);
}

BOOST_NOINLINE void operator delete(void* memory) noexcept {
  using CGAL::Quadtree_mesh_2::internal::Scratch_arrays;
  if (!Scratch_arrays::free(memory)) std::free(memory);
}

BOOST_NOINLINE void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
BOOST_NOINLINE void operator delete(void* memory, const std::nothrow_t&) noexcept { operator delete(memory); }
BOOST_NOINLINE void operator delete[](void* memory) noexcept { operator delete(memory); }
BOOST_NOINLINE void operator delete[](void* memory, std::size_t) noexcept { operator delete(memory); }
BOOST_NOINLINE void operator delete[](void* memory, const std::nothrow_t&) noexcept {
  operator delete(memory);
}

#endif // CGAL_QUADTREE_MESH_2_NEW_IN_SCRATCH_MEMORY_H
