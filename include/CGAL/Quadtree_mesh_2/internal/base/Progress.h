// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PROGRESS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PROGRESS_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// About which share of the work is done where a pipeline asks whether to go on.
struct Progress_shares {
  // graphs: refinement goes on from the blocks' share
  // those refined in blocks have a first triangulation that takes longer
  static constexpr double first_mesh = 0.35, rounds_of_blocks = 0.55;
  static constexpr double blocks = 0.2, refinement = 0.6, quadtrees = 0.3, removal = 0.85, thinning = 0.9;
  // sets of points: coarsening goes on from the share of placing
  static constexpr double placing = 0.2, coarsening = 0.75;
};

/// Whether a loop of many short steps asks now if it should go on.
constexpr bool is_time_to_ask(std::size_t step) {
  constexpr std::size_t steps_between_questions = 4096;
  return step % steps_between_questions == 0;
}

/// Tells the user how far the work is, and asks whether to go on. Any thread may call. The user's function is
/// called by one thread at a time, and the share that it gets never falls.
class Progress {
public:
  using Callback = std::function<bool(double)>;

  /// \param callback empty: goes on always. It has to outlive this.
  explicit Progress(const Callback& callback) : callback_(callback) {}

  /// Whether the user wants to go on; about `share` of the work is done.
  bool shall_go_on(double share) {
    if (!callback_ || is_cancelled_) return !is_cancelled_;
    const std::lock_guard<std::mutex> lock(mutex_);
    share_done_ = std::max(share_done_, share);
    if (!is_cancelled_ && !callback_(share_done_)) is_cancelled_ = true;
    return !is_cancelled_;
  }
  bool is_cancelled() const { return is_cancelled_; }

  /// The question at a fixed share. What asks it is instantiated for this one type, not for a lambda of each stage.
  struct Question {
    Progress& progress;
    double share;

    bool operator()() const { return progress.shall_go_on(share); }
  };
  Question question_at(double share) { return {*this, share}; }

private:
  const Callback& callback_;
  std::mutex mutex_;
  double share_done_ = 0;
  std::atomic<bool> is_cancelled_{false};
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PROGRESS_H
