// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_PYTHON_WATCHED_RUN_H
#define QUADTREE_MESH_PYTHON_WATCHED_RUN_H

#include <pybind11/pybind11.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <atomic>
#include <chrono>
#include <cstddef>
#include <future>
#include <optional>
#include <utility>

// Runs a mesher on a thread of its own. The caller's thread meanwhile lets other Python threads run, looks for Ctrl-C
// and calls Python's progress function, 20 times a second. Python hears of signals on its main thread only, and the
// mesher may ask whether to go on from any of its own.

namespace py = pybind11;

namespace quadtree_mesh_python {

/// What the mesher and the caller's thread tell each other.
class Run_state {
public:
  /// The mesher's question whether to go on.
  bool operator()(double share) {
    share_ = share;
    return !is_stopped_;
  }
  double share() const { return share_; }
  bool is_stopped() const { return is_stopped_; }
  void stop() { is_stopped_ = true; }

private:
  std::atomic<double> share_{0};
  std::atomic<bool> is_stopped_{false};
};

/// At most so many threads while it lives; 0: as many as there are.
class Thread_bound {
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_bound(std::size_t threads) {
    if (threads > 0) control_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

private:
  std::optional<tbb::global_control> control_;
#else
  explicit Thread_bound(std::size_t) {}
#endif
};

/// Calls `work`, which asks `state` whether to go on, and returns when it is done.
/// \param progress None, or a function of the share of work done; `False` from it stops the work
template <class Work>
void run_watched(Run_state& state, const py::object& progress, Work work) {
  std::future<void> done = std::async(std::launch::async, std::move(work));
  std::optional<py::error_already_set> error;
  const auto is_done = [&] {
    const py::gil_scoped_release release;
    return done.wait_for(std::chrono::milliseconds(50)) == std::future_status::ready;
  };
  const auto tell = [&](double share) {
    if (!progress.is_none() && progress(share).is(py::bool_(false))) state.stop();
  };
  while (!is_done()) {
    if (error) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!state.is_stopped()) tell(state.share());
    } catch (py::error_already_set& thrown) {
      error.emplace(std::move(thrown));
      state.stop();
    }
  }
  if (error) throw py::error_already_set(std::move(*error));
  done.get();
  if (!state.is_stopped()) tell(1);
}

} // namespace quadtree_mesh_python

#endif // QUADTREE_MESH_PYTHON_WATCHED_RUN_H
