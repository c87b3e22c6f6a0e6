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

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class State_writer : public Checkpoint_archive<State_writer> {
public:
  static constexpr bool is_reading = false;

  Bytes bytes;

  // For the archive.
  void transfer_bytes(const void* begin, std::size_t size) { append_bytes(bytes, begin, size); }
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

/// Tells all other parts values, a piece at a time, so that not all bytes are in memory at once.
template <class Exchange>
class State_teller : public Checkpoint_archive<State_teller<Exchange>> {
public:
  static constexpr bool is_reading = false;

  explicit State_teller(Exchange& exchange) : exchange_(exchange) {}

  /// To be called at last.
  void finish() {
    if (!bytes_.empty()) exchange_.broadcast(bytes_, exchange_.rank());
    bytes_.clear();
  }

  // For the archive.
  void transfer_bytes(const void* begin, std::size_t size) {
    const char* first = static_cast<const char*>(begin);
    while (size > 0) {
      const std::size_t n = std::min(size, piece - bytes_.size());
      append_bytes(bytes_, first, n);
      first += n, size -= n;
      if (bytes_.size() == piece) finish();
    }
  }
  template <class Vector>
  static void make_room(const Vector&, std::size_t) {}

private:
  static constexpr std::size_t piece = std::size_t(1) << 20;

  Exchange& exchange_;
  Bytes bytes_;
};

/// What others do meanwhile.
/// \pre the values are written by the same sequence of calls
template <class Exchange>
class State_listener : public Checkpoint_archive<State_listener<Exchange>> {
public:
  static constexpr bool is_reading = true;

  /// \param first the first piece, as it was broadcast by part 0
  State_listener(Exchange& exchange, Bytes first) : exchange_(exchange), bytes_(std::move(first)) {}

  // For the archive.
  void transfer_bytes(void* begin, std::size_t size) {
    char* to = static_cast<char*>(begin);
    while (size > 0) {
      if (next_ == bytes_.size()) exchange_.broadcast(bytes_, 0), next_ = 0;
      const std::size_t n = std::min(size, bytes_.size() - next_);
      std::memcpy(to, bytes_.data() + next_, n);
      to += n, size -= n, next_ += n;
    }
  }
  template <class Vector>
  static void make_room(Vector& values, std::size_t size) {
    values.resize(size);
  }

private:
  Exchange& exchange_;
  Bytes bytes_;
  std::size_t next_ = 0;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_STATE_BYTES_H
