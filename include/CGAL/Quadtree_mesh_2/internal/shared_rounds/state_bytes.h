// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The state of long work as bytes in memory, by the same functions as in files (Checkpoint_file.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_STATE_BYTES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_STATE_BYTES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Checkpoint_file.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <cstddef>
#include <cstring>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class State_writer : public Checkpoint_archive<State_writer> {
public:
  static constexpr bool is_reading = false;

  Bytes bytes;

  // For the archive.
  void transfer_bytes(const void* begin, std::size_t size) {
    const char* const first = static_cast<const char*>(begin);
    bytes.insert(bytes.end(), first, first + size);
  }
  template <class Vector>
  static void make_room(const Vector&, std::size_t) {}
};

/// \pre the bytes were written by the same sequence of calls
class State_reader : public Checkpoint_archive<State_reader> {
public:
  static constexpr bool is_reading = true;

  explicit State_reader(const Bytes& bytes) : next_(bytes.data()) {}

  // For the archive.
  void transfer_bytes(void* begin, std::size_t size) {
    if (size > 0) std::memcpy(begin, next_, size);
    next_ += size;
  }
  template <class Vector>
  static void make_room(Vector& values, std::size_t size) {
    values.resize(size);
  }

private:
  const char* next_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_STATE_BYTES_H
