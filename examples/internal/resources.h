// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_RESOURCES_H
#define QUADTREE_MESH_2_BENCHMARK_RESOURCES_H

#include <sys/resource.h>
#include <time.h>

/// Processor seconds that this process has used, on all its threads.
inline double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// Seconds by a clock that nobody sets.
inline double wall_seconds() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// The most memory a process has held, in megabytes (2^20 bytes), from its `rusage`; Linux counts kilobytes
/// there.
inline double peak_memory_mb(const rusage& usage) { return double(usage.ru_maxrss) / 1024; }

/// The same for this process.
inline double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return peak_memory_mb(usage);
}

/// Where a process stops that would not end.
struct Limits {
  unsigned seconds = 60;
  double gigabytes = 8;
};

/// Lets this process have no more memory.
inline void limit_memory(double gigabytes) {
  const rlimit limit{rlim_t(gigabytes * 0x1p30), RLIM_INFINITY};
  setrlimit(RLIMIT_AS, &limit);
}

#endif // QUADTREE_MESH_2_BENCHMARK_RESOURCES_H
