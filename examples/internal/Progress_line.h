#ifndef QUADTREE_MESH_2_EXAMPLES_PROGRESS_LINE_H
#define QUADTREE_MESH_2_EXAMPLES_PROGRESS_LINE_H

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

/// The share of work done, and about how long the rest will take, in one line of the terminal, for work that takes
/// longer than a second.
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
    std::fprintf(stderr, "\rmeshing: %3.0f %%%s\033[K", 100 * most_, time_left(now).c_str());
    std::fflush(stderr);
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now(), next_ = begin_ + std::chrono::seconds(1);
  bool is_shown_ = false;
  double most_ = 0;

  /// Once there is something to tell it from.
  std::string time_left(Clock::time_point now) const {
    constexpr double least_seconds = 5, least_share = 0.1;
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    if (seconds < least_seconds || most_ < least_share) return "";
    const double left = seconds * (1 - most_) / most_;
    const bool is_long = left >= 90;
    char text[32];
    std::snprintf(text, sizeof text, is_long ? ", about %.0f min left" : ", about %.0f s left",
                  is_long ? left / 60 : left);
    return text;
  }
};

#endif // QUADTREE_MESH_2_EXAMPLES_PROGRESS_LINE_H
