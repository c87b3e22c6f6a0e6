// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SPARSE_BYTES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SPARSE_BYTES_H

#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Bytes that are 0 until they are written, and take no memory before, by pages.
class Sparse_bytes {
public:
  char operator[](std::size_t i) const { return bytes_.get()[i]; }
  char& operator[](std::size_t i) { return bytes_.get()[i]; }
  std::size_t size() const { return size_; }

  /// Makes room for so many.
  void grow(std::size_t size) {
    if (size <= size_) return;
    std::unique_ptr<char, Free> larger(static_cast<char*>(std::calloc(size, 1)));
    if (!larger) throw std::bad_alloc();
    ask_for_small_pages(larger.get(), size);
    for (std::size_t i = 0; i < size_; ++i)
      if (bytes_.get()[i] != 0) larger.get()[i] = bytes_.get()[i];
    bytes_ = std::move(larger);
    size_ = size;
  }

private:
  struct Free {
    void operator()(char* bytes) const { std::free(bytes); }
  };

  std::unique_ptr<char, Free> bytes_;
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SPARSE_BYTES_H
