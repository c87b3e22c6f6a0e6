// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Memory for long arrays in a file without a name, mapped as a whole.
//
// An array gets the smallest place that is free, as malloc() would have it. Disk blocks are there before an array is,
// so a full disk is an exception and never a signal later. A long array that goes leaves a hole in the file. The file
// is gone with its last user, however the process ends. O(log k) and a call to the system for k arrays.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SCRATCH_FILE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SCRATCH_FILE_H

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <new>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#ifdef __linux__
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What keeps the places of a scratch file: `operator new` may be one that asks the file itself.
template <class T>
struct Malloc_allocator {
  using value_type = T;

  Malloc_allocator() = default;
  template <class U>
  Malloc_allocator(const Malloc_allocator<U>&) noexcept {}

  T* allocate(std::size_t n) {
    if (void* const memory = std::malloc(n * sizeof(T))) return static_cast<T*>(memory);
    throw std::bad_alloc();
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  friend bool operator==(Malloc_allocator, Malloc_allocator) { return true; }
  friend bool operator!=(Malloc_allocator, Malloc_allocator) { return false; }
};

class Scratch_file {
public:
  /// \throws std::system_error naming the folder if it can have no such file
  explicit Scratch_file(std::string folder) : folder_(std::move(folder)) { open(); }
  Scratch_file(const Scratch_file&) = delete;
  Scratch_file& operator=(const Scratch_file&) = delete;
  ~Scratch_file() { close(); }

  const std::string& folder() const { return folder_; }

  /// \returns memory aligned as pages are; null if there is no room on the disk
  void* allocate(std::size_t bytes) {
    if (bytes > address_space_) return nullptr;
    bytes = (bytes + granularity - 1) / granularity * granularity;
    const std::size_t offset = take(bytes);
    if (offset + bytes <= address_space_) {
      if (make_blocks(offset, bytes)) return begin_ + offset;
      drop_blocks(offset, bytes); // those that there was room for
    }
    give_back(offset);
    return nullptr;
  }

  void free(void* memory) {
    const std::size_t offset = offset_of(memory), bytes = size_at(offset);
    if (bytes >= least_hole) drop_blocks(offset, bytes);
    give_back(offset);
  }

  /// All of them, in arrays or not: the first, and the one behind the last.
  std::pair<std::uintptr_t, std::uintptr_t> addresses() const {
    const auto begin = reinterpret_cast<std::uintptr_t>(begin_);
    return {begin, begin + address_space_};
  }
  bool has(const void* memory) const { return offset_of(memory) < address_space_; }
  /// Who is about to allocate says so: the file counts as not empty until then.
  void begin_use() { ++users_; }
  void end_use() { --users_; }
  bool is_empty() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return users_ == 0 && taken_.empty();
  }

  /// Lets pages come one by one, and not as long as the system may have them, megabytes each. It takes more time.
  void use_short_pages() {
#ifdef __linux__
    madvise(begin_, address_space_, MADV_RANDOM);
#endif
  }

  /// Lets go of all pages that are in memory. Their contents stay: the system keeps them as long as it has room, and
  /// on the disk.
  void let_go_of_pages() {
#ifdef __linux__
    const std::size_t end = std::min(end_.load(), address_space_);
    if (end > 0) madvise(begin_, end, MADV_DONTNEED);
#endif
  }

private:
  using Places = std::map<std::size_t, std::size_t, std::less<>,
                          Malloc_allocator<std::pair<const std::size_t, std::size_t>>>; // offset -> bytes
  using Place = std::pair<std::size_t, std::size_t>;

  /// Of addresses, which cost nothing: enough for a billion triangles, or else what the system allows.
  static constexpr std::size_t most_address_space = std::size_t(1) << (sizeof(std::size_t) > 4 ? 41 : 30);
  static constexpr std::size_t least_address_space = std::size_t(1) << 30;
  static constexpr std::size_t granularity = std::size_t(1) << 14;
  /// What is shorter is soon used again, and its blocks are kept.
  static constexpr std::size_t least_hole = std::size_t(1) << 20;

  std::string folder_;
  int file_ = -1;
  char* begin_ = nullptr;
  std::size_t address_space_ = most_address_space;
  mutable std::mutex mutex_;
  Places taken_, free_;                                           // no two free places are neighbors
  std::set<Place, std::less<>, Malloc_allocator<Place>> by_size_; // (bytes, offset) of the free ones
  std::atomic<int> users_{0};
  std::atomic<std::size_t> end_{0}; // nothing beyond it is taken or free

  /// Beyond `address_space_` for what is not in the file.
  std::size_t offset_of(const void* memory) const {
    return static_cast<std::size_t>(static_cast<const char*>(memory) - begin_);
  }

  // The calls to the system, which may take long, are made without the lock: a place has one owner.

  std::size_t size_at(std::size_t offset) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return taken_.at(offset);
  }

  /// \returns the offset of a place, the smallest that is free
  std::size_t take(std::size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto place = by_size_.lower_bound(Place(bytes, 0));
    std::size_t offset = end_;
    if (place == by_size_.end()) {
      end_ = offset + bytes;
    } else {
      const auto [size, begin] = *place;
      offset = begin;
      forget_free(free_.find(begin));
      if (size > bytes) add_free(begin + bytes, size - bytes);
    }
    taken_.emplace(offset, bytes);
    return offset;
  }

  void give_back(std::size_t offset) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto taken = taken_.find(offset);
    std::size_t bytes = taken->second;
    taken_.erase(taken);
    const auto next = free_.find(offset + bytes);
    if (next != free_.end()) {
      bytes += next->second;
      forget_free(next);
    }
    const auto behind = free_.lower_bound(offset);
    if (behind != free_.begin()) {
      const auto before = std::prev(behind);
      if (before->first + before->second == offset) {
        offset = before->first, bytes += before->second;
        forget_free(before);
      }
    }
    if (offset + bytes == end_)
      end_ = offset;
    else
      add_free(offset, bytes);
  }

  void add_free(std::size_t offset, std::size_t bytes) {
    free_.emplace(offset, bytes);
    by_size_.emplace(bytes, offset);
  }
  void forget_free(Places::iterator place) {
    by_size_.erase(Place(place->second, place->first));
    free_.erase(place);
  }

  [[noreturn]] void fail(const char* what) const {
    throw std::system_error(errno, std::generic_category(), what + (" '" + folder_) + '\'');
  }

#ifdef __linux__
  void open() {
    file_ = ::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (file_ < 0) open_by_name();
    void* memory = MAP_FAILED;
    for (; memory == MAP_FAILED && address_space_ >= least_address_space; address_space_ /= 2)
      memory = mmap(nullptr, address_space_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_NORESERVE, file_, 0);
    if (memory == MAP_FAILED) {
      ::close(file_);
      fail("no addresses for the file in the scratch folder");
    }
    address_space_ *= 2;
    begin_ = static_cast<char*>(memory);
  }

  /// For file systems whose files all have names.
  void open_by_name() {
    std::string name = folder_ + "/scratch-XXXXXX";
    file_ = mkostemp(name.data(), O_CLOEXEC);
    if (file_ < 0) fail("no file can be made in the scratch folder");
    unlink(name.c_str());
  }

  void close() {
    munmap(begin_, address_space_);
    ::close(file_);
  }

  bool make_blocks(std::size_t offset, std::size_t bytes) const {
    return posix_fallocate(file_, static_cast<off_t>(offset), static_cast<off_t>(bytes)) == 0;
  }

  void drop_blocks(std::size_t offset, std::size_t bytes) const {
    // Only asks: a file system without holes keeps the blocks.
    static_cast<void>(fallocate(file_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(offset),
                                static_cast<off_t>(bytes)));
  }
#else
  void open() {
    errno = ENOSYS;
    fail("only Linux is known to keep arrays well in the scratch folder");
  }
  void close() {}
  bool make_blocks(std::size_t, std::size_t) const { return false; }
  void drop_blocks(std::size_t, std::size_t) const {}
#endif
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SCRATCH_FILE_H
