// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Keeps the memory of the process below a limit, by a thread that lets go of the pages of a file of arrays.
//
// The mesher works on blocks, each for some milliseconds and on some megabytes. So what is in use comes back at once,
// and it does not pay to choose pages. The system still has their contents if it has room: then a page comes back for
// a tenth of a microsecond. The limit is soft: pages come as fast as the thread can look, a thousand times a second.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_RESIDENT_LIMIT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_RESIDENT_LIMIT_H

#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_file.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <thread>

#ifdef __linux__
#include <unistd.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How much memory this process has; 0 where that is not known.
class Resident_memory {
public:
  struct Bytes {
    std::size_t all = 0, in_files = 0;
  };

  Resident_memory() : file_(std::fopen("/proc/self/statm", "r")) {
    if (file_) std::setvbuf(file_, nullptr, _IONBF, 0);
  }
  Resident_memory(const Resident_memory&) = delete;
  Resident_memory& operator=(const Resident_memory&) = delete;
  ~Resident_memory() {
    if (file_) std::fclose(file_);
  }

  Bytes bytes() const {
#ifdef __linux__
    static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    std::size_t addresses = 0, pages = 0, in_files = 0;
    if (file_ && std::fseek(file_, 0, SEEK_SET) == 0 &&
        std::fscanf(file_, "%zu %zu %zu", &addresses, &pages, &in_files) == 3)
      return {pages * page, in_files * page};
#endif
    return {};
  }

private:
  std::FILE* file_;
};

class Resident_limit {
public:
  /// \param file has to outlive this
  Resident_limit(Scratch_file& file, std::size_t most_bytes)
      : file_(file), most_bytes_(most_bytes), thread_([this] { watch(); }) {
    if (most_bytes < least_for_long_pages) file.use_short_pages();
  }
  Resident_limit(const Resident_limit&) = delete;
  Resident_limit& operator=(const Resident_limit&) = delete;
  ~Resident_limit() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_over_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds between_looks{1};
  static constexpr std::chrono::seconds between_trims{1};
  /// Half a gigabyte of pages of megabytes may come between two looks.
  static constexpr std::size_t least_for_long_pages = std::size_t(1) << 30;
  /// As much of the file is always left alone: blocks in work need it.
  static constexpr std::size_t least_of_file = std::size_t(1) << 26;

  Scratch_file& file_;
  std::size_t most_bytes_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool is_over_ = false;
  Clock::time_point next_trim_{};
  std::thread thread_; // the last to begin, when all else is there

  void watch() {
    const Resident_memory memory;
    const std::size_t enough = most_bytes_ / 4; // what comes until the next look has to have room, too
    std::unique_lock<std::mutex> lock(mutex_);
    while (!wake_.wait_for(lock, between_looks, [this] { return is_over_; })) {
      lock.unlock();
      const Resident_memory::Bytes bytes = memory.bytes();
      if (bytes.all > enough && bytes.in_files > least_of_file) file_.let_go_of_pages();
      if (bytes.all - bytes.in_files > enough) let_go_of_freed_memory();
      lock.lock();
    }
  }

  /// Of what is not in the file. It takes a while, and is of use when much has been freed since the last time.
  void let_go_of_freed_memory() {
#ifdef __GLIBC__
    const Clock::time_point now = Clock::now();
    if (now < next_trim_) return;
    malloc_trim(0);
    next_trim_ = Clock::now() + between_trims;
#endif
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_RESIDENT_LIMIT_H
