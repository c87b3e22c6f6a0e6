#ifndef QUADTREE_MESH_2_EXAMPLES_DEFERRED_SIGNALS_H
#define QUADTREE_MESH_2_EXAMPLES_DEFERRED_SIGNALS_H

#include <signal.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <stdexcept>

/// Something that a signal has stopped; whoever defers the signals lets them act.
class Interruption : public std::runtime_error {
public:
  Interruption() : std::runtime_error("interrupted") {}
};

/// While it lives, signals that would end the program are only noted: half-written files would stay behind. Then the
/// last of them acts as it would have. Calls of the system that wait, as for the reader of a pipe, end with an error.
///
/// A limit on the size of files is an error of writing, not a signal.
class Deferred_signals {
public:
  Deferred_signals() {
    last_ = 0;
    for (std::size_t i = 0; i < signals_.size(); ++i) {
      struct sigaction noted {};
      noted.sa_handler = signals_[i] == SIGXFSZ ? SIG_IGN : [](int signal) { last_ = signal; };
      sigaction(signals_[i], nullptr, &before_[i]);
      if (before_[i].sa_handler != SIG_IGN) sigaction(signals_[i], &noted, nullptr);
    }
  }
  Deferred_signals(const Deferred_signals&) = delete;
  Deferred_signals& operator=(const Deferred_signals&) = delete;
  ~Deferred_signals() {
    for (std::size_t i = 0; i < signals_.size(); ++i) sigaction(signals_[i], &before_[i], nullptr);
    if (const int signal = last_) raise(signal);
  }

  /// \throws Interruption if a signal has come
  void check() const {
    if (last_ != 0) throw Interruption();
  }

private:
  static constexpr std::array<int, 6> signals_{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ};
  static inline std::atomic<int> last_{0};
  static_assert(std::atomic<int>::is_always_lock_free, "a handler may have no other");
  std::array<struct sigaction, 6> before_{};
};

#endif // QUADTREE_MESH_2_EXAMPLES_DEFERRED_SIGNALS_H
