// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_HUGE_PAGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_HUGE_PAGES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_arrays.h>

#include <cstddef>
#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

#if defined(__linux__) && defined(MADV_HUGEPAGE)
constexpr std::size_t huge_page = std::size_t(1) << 21;
/// From here on an array has huge pages of its own: at most half of their memory is in vain.
constexpr std::size_t least_in_huge_pages = huge_page / 2;
#else
constexpr std::size_t huge_page = alignof(std::max_align_t);
constexpr std::size_t least_in_huge_pages = SIZE_MAX;
#endif

/// Memory for a long array, which begins and ends where huge pages do: one page fault instead of 512. On virtual
/// machines a fault may take as long as it takes to write the page ten times. A scratch file has its own pages.
inline void* allocate_in_huge_pages(std::size_t bytes) {
  if (void* const memory = Scratch_arrays::allocate(bytes)) return memory;
  bytes = (bytes + huge_page - 1) / huge_page * huge_page;
  void* const memory = ::operator new(bytes, std::align_val_t(huge_page));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  madvise(memory, bytes, MADV_HUGEPAGE); // only asks, so nothing can fail
#endif
  return memory;
}
inline void free_in_huge_pages(void* memory) {
  if (!Scratch_arrays::free(memory)) ::operator delete(memory, std::align_val_t(huge_page));
}

/// Asks the system for the pages of an array that is about to be written whole: one call instead of many faults. A
/// scratch file may be longer than memory, so its pages come one by one.
inline void ask_for_pages(void* begin, std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE) && defined(MADV_POPULATE_WRITE)
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto first = reinterpret_cast<std::uintptr_t>(begin) & ~(page - 1);
  const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes + page - 1) & ~(page - 1);
  if (end - first < 16 * page || Scratch_arrays::has(begin)) return;
  if (bytes >= 2 * huge_page) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  madvise(reinterpret_cast<void*>(first), end - first, MADV_POPULATE_WRITE);
#else
  static_cast<void>(begin), static_cast<void>(bytes);
#endif
}

/// Asks for small pages in memory that is not written everywhere, so that what is not written takes none.
inline void ask_for_small_pages(void* begin, std::size_t bytes) {
#if defined(__linux__) && defined(MADV_NOHUGEPAGE)
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) & ~(page - 1);
  const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) & ~(page - 1);
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_NOHUGEPAGE);
#else
  static_cast<void>(begin), static_cast<void>(bytes);
#endif
}

/// Gives pages of an array back to the system, whose values nobody will read before they are written. A scratch file
/// keeps its own.
inline void give_back_pages(void* begin, std::size_t bytes) {
#ifdef __linux__
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) & ~(page - 1);
  const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) & ~(page - 1);
  if (first < end && !Scratch_arrays::has(begin))
    madvise(reinterpret_cast<void*>(first), end - first, MADV_DONTNEED);
#else
  static_cast<void>(begin), static_cast<void>(bytes);
#endif
}

/// The same for values of an array that may be empty.
template <class Values>
void give_back_values(Values& values, std::size_t begin, std::size_t end) {
  if (!values.empty()) give_back_pages(values.data() + begin, (end - begin) * sizeof(*values.data()));
}

/// Where the memory of arrays goes back to the system while they are read from the beginning: in large pieces, as each
/// time takes the system long.
class Pieces_given_back {
public:
  /// \param size of the arrays
  explicit Pieces_given_back(std::size_t size) : size_(size) {}

  /// What is before `end` is read. Calls `give_back(first, last)` if a piece is.
  template <class Give_back>
  void give_back_before(std::size_t end, const Give_back& give_back) {
    if (end < first_ + piece_ && end != size_) return;
    give_back(first_, end);
    first_ = end;
  }

private:
  static constexpr std::size_t piece_ = std::size_t(1) << 16;

  std::size_t size_, first_ = 0;
};

/// Makes `values`, which is empty, as long as `size`, with all of its pages at once.
/// \param more for so many values behind them there is room, without pages
template <class Vector>
void resize_with_pages(Vector& values, std::size_t size, std::size_t more = 0) {
  values.reserve(size + more);
  ask_for_pages(values.data(), size * sizeof(typename Vector::value_type));
  values.resize(size);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_HUGE_PAGES_H
