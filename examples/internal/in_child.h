// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_IN_CHILD_H
#define QUADTREE_MESH_2_BENCHMARK_IN_CHILD_H

#include "resources.h"

#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <system_error>
#include <type_traits>

template <class Result>
struct Child_outcome {
  std::optional<Result> result; ///< nothing if the child failed or used up its time
  double peak_memory_mb = 0;
};

namespace in_child_internal {

/// Calls `f` and sends its result through the pipe; never returns.
template <class F>
[[noreturn]] void run_and_exit(F& f, int pipe_end, unsigned limit_seconds) {
  // By the wall clock: a limit of processor time would make Linux read its processor clock in steps of
  // milliseconds.
  alarm(limit_seconds);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody waits for the result of a child that is alone
#endif
  try {
    const auto result = f();
    const bool is_sent = write(pipe_end, &result, sizeof result) == ssize_t(sizeof result);
    _exit(is_sent ? 0 : 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    _exit(1);
  }
}

} // namespace in_child_internal

/// Runs `f` in a forked child: its memory is its own, so that the peak tells of `f` alone, and a method that
/// does not end is stopped after `limit_seconds`. A child that a signal ends is named.
template <class F>
auto in_child(F f, unsigned limit_seconds) {
  using Result = decltype(f());
  static_assert(std::is_trivially_copyable_v<Result>, "the result goes through a pipe as it is");
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr); // or the child would print what waits in the buffers once more
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) in_child_internal::run_and_exit(f, ends[1], limit_seconds);

  close(ends[1]);
  Child_outcome<Result> outcome;
  Result result;
  if (read(ends[0], &result, sizeof result) == ssize_t(sizeof result)) outcome.result = result;
  close(ends[0]);
  rusage usage{};
  int status = 0;
  wait4(child, &status, 0, &usage);
  if (WIFSIGNALED(status)) std::fprintf(stderr, "no result: %s\n", strsignal(WTERMSIG(status)));
  outcome.peak_memory_mb = peak_memory_mb(usage);
  return outcome;
}

#endif // QUADTREE_MESH_2_BENCHMARK_IN_CHILD_H
