// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SCRATCH_ARRAYS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SCRATCH_ARRAYS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_file.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// The disk of the scratch folder is full.
class Scratch_full : public std::bad_alloc {
public:
  explicit Scratch_full(const std::string& folder)
      : text_(std::make_shared<const std::string>("the disk of the scratch folder '" + folder +
                                                  "' has no more room")) {}
  const char* what() const noexcept override { return text_->c_str(); }

private:
  std::shared_ptr<const std::string> text_; // an exception's copies must not throw
};

namespace internal {

/// Where the long arrays of the process are, if they are in scratch files. One file gets new arrays at a time; files
/// stay as long as there are arrays in them. Any thread may call anything.
class Scratch_arrays {
public:
  /// Lets new arrays of at least so many bytes be in a file, until `stop()`.
  /// \throws std::logic_error if they are in one already
  static Scratch_file& start(const std::string& folder, std::size_t least_bytes) {
    const auto file = std::make_shared<Scratch_file>(folder);
    State& s = state();
    const std::lock_guard<std::recursive_mutex> lock(s.mutex);
    if (s.current) throw std::logic_error("there is a scratch memory already");
    s.files.push_back(file);
    s.current = file;
    widen(*file);
    constexpr std::size_t page = 4096; // shorter ones would cost more than they take
    least_bytes_ = std::max(least_bytes, page);
    return *file;
  }

  static void stop() {
    least_bytes_ = SIZE_MAX;
    {
      State& s = state();
      const std::lock_guard<std::recursive_mutex> lock(s.mutex);
      s.current = nullptr;
    }
    drop_empty_files();
  }

  static bool is_active() { return least_bytes_ != SIZE_MAX; }
  /// The folder in use, if any is.
  static std::string folder() {
    State& s = state();
    const std::lock_guard<std::recursive_mutex> lock(s.mutex);
    return s.current ? s.current->folder() : std::string();
  }

  /// Memory in the file; null if there is none, or for a short array.
  /// \throws Scratch_full if there is no room on the disk
  static void* allocate(std::size_t bytes) {
    if (bytes < least_bytes_) return nullptr;
    const std::shared_ptr<Scratch_file> file = current_in_use();
    if (!file) return nullptr;
    void* const memory = file->allocate(bytes);
    file->end_use();
    if (!memory) throw Scratch_full(file->folder());
    return memory;
  }

  static bool has(const void* memory) { return may_have(memory) && find(memory); }

  /// \returns false if the memory is in no file
  static bool free(void* memory) {
    if (!may_have(memory)) return false;
    const std::shared_ptr<Scratch_file> file = find(memory);
    if (!file) return false;
    file->free(memory);
    if (file != current()) drop_empty_files();
    return true;
  }

private:
  struct State {
    std::recursive_mutex mutex;                       // what is freed under it is asked about, too
    std::vector<std::shared_ptr<Scratch_file>> files; // that have arrays, and the current one
    std::shared_ptr<Scratch_file> current;
  };

  // The addresses of all files there have been: most memory is outside, which is quickly told.
  inline static std::atomic<std::uintptr_t> low_{0}, high_{0};
  inline static std::atomic<std::size_t> least_bytes_{SIZE_MAX};

  /// Never destroyed: arrays may outlive what is.
  static State& state() {
    static State& s = *new State;
    return s;
  }

  static void widen(const Scratch_file& file) {
    const auto [begin, end] = file.addresses();
    low_ = high_ == 0 ? begin : std::min(low_.load(), begin);
    high_ = std::max(high_.load(), end);
  }

  static bool may_have(const void* memory) {
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    return address - low_ < high_ - low_;
  }

  static std::shared_ptr<Scratch_file> current() {
    State& s = state();
    const std::lock_guard<std::recursive_mutex> lock(s.mutex);
    return s.current;
  }

  /// So that it does not go before an array is made in it.
  static std::shared_ptr<Scratch_file> current_in_use() {
    State& s = state();
    const std::lock_guard<std::recursive_mutex> lock(s.mutex);
    if (s.current) s.current->begin_use();
    return s.current;
  }

  static std::shared_ptr<Scratch_file> find(const void* memory) {
    State& s = state();
    const std::lock_guard<std::recursive_mutex> lock(s.mutex);
    for (const auto& file : s.files)
      if (file->has(memory)) return file;
    return nullptr;
  }

  static void drop_empty_files() {
    std::vector<std::shared_ptr<Scratch_file>> empty; // freed without the lock
    State& s = state();
    {
      const std::lock_guard<std::recursive_mutex> lock(s.mutex);
      const auto first = std::partition(s.files.begin(), s.files.end(), [&s](const auto& file) {
        return file == s.current || !file->is_empty();
      });
      empty.reserve(s.files.size());
      std::move(first, s.files.end(), std::back_inserter(empty));
      s.files.erase(first, s.files.end());
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SCRATCH_ARRAYS_H
