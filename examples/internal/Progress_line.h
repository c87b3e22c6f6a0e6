#ifndef QUADTREE_MESH_2_EXAMPLES_PROGRESS_LINE_H
#define QUADTREE_MESH_2_EXAMPLES_PROGRESS_LINE_H

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

/// The share of work done, in one line of the terminal, for work that takes longer than a second.
class Progress_line {
public:
  Progress_line() = default;
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;
  ~Progress_line() {
    if (is_shown_) std::fputs("\r\033[K", stderr);
  }

  static bool is_possible() { return isatty(STDERR_FILENO) != 0; }

  void show(double share) {
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    is_shown_ = true;
    most_ = (std::max)(most_, share); // the mesher's guesses may fall, a bar that goes back only worries
    std::fprintf(stderr, "\rmeshing: %3.0f %%", 100 * most_);
    std::fflush(stderr);
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
  bool is_shown_ = false;
  double most_ = 0;
};

#endif // QUADTREE_MESH_2_EXAMPLES_PROGRESS_LINE_H
