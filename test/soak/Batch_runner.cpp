// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "Batch_runner.h"

#include "resources.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>
#include <fstream>
#include <map>
#include <new>
#include <string>
#include <system_error>

namespace soak {

namespace {

/// What a child writes for its parent to read, in memory that they share.
struct Slot {
  enum class State { WAITING, RUNNING, DONE } state;
  Outcome outcome;
  double seconds, megabytes;
  char kind[96], detail[600];

  void set(const Verdict& verdict) {
    outcome = verdict.outcome;
    std::snprintf(kind, sizeof kind, "%s", verdict.kind.c_str());
    std::snprintf(detail, sizeof detail, "%s", verdict.detail.c_str());
  }
  Result result() const { return {{outcome, kind, detail}, seconds, megabytes}; }
};

class Shared_slots {
public:
  explicit Shared_slots(std::size_t n) : bytes_(std::max<std::size_t>(1, n) * sizeof(Slot)) {
    void* const memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
    slots_ = static_cast<Slot*>(memory); // all zeros: waiting
  }
  Shared_slots(const Shared_slots&) = delete;
  Shared_slots& operator=(const Shared_slots&) = delete;
  ~Shared_slots() { munmap(slots_, bytes_); }
  Slot& operator[](std::size_t i) { return slots_[i]; }

private:
  std::size_t bytes_;
  Slot* slots_;
};

/// Counts processor time of this process from now on, and ends it after so much.
void set_timer(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>((seconds - static_cast<double>(timer.it_value.tv_sec)) * 1e6);
  setitimer(ITIMER_PROF, &timer, nullptr);
}

/// The most memory since the last call, in megabytes.
double peak_since_last_call() {
  double megabytes = 0;
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("VmHWM:", 0) == 0) megabytes = std::stod(line.substr(6)) / 1024;
  std::ofstream("/proc/self/clear_refs") << 5; // Linux forgets the peak
  return megabytes;
}

/// Never returns.
[[noreturn]] void run_batch(Shared_slots& slots, std::size_t begin, std::size_t end, const Limits& limits,
                            const std::function<Verdict(std::size_t)>& run) {
  std::signal(SIGPROF, SIG_DFL);
  // Some more than the limit, as addresses are not memory, nor is what the process had before.
  limit_memory(limits.gigabytes + 1);
  for (std::size_t i = begin; i < end; ++i) {
    Slot& slot = slots[i];
    peak_since_last_call();
    slot.state = Slot::State::RUNNING;
    set_timer(limits.cpu_seconds);
    alarm(static_cast<unsigned>(15 * limits.cpu_seconds) +
          1); // one that waits forever takes no processor time
    const double start = cpu_seconds();
    Verdict verdict;
    try {
      verdict = run(i);
    } catch (const std::bad_alloc&) {
      verdict = failure("memory", "std::bad_alloc");
    } catch (const std::exception& error) {
      verdict = failure("exception", error.what());
    }
    slot.seconds = cpu_seconds() - start;
    slot.megabytes = peak_since_last_call();
    if (verdict.outcome != Outcome::FAILED && slot.megabytes > 1024 * limits.gigabytes)
      verdict = failure("memory", std::to_string(slot.megabytes) + " MB");
    slot.set(verdict);
    slot.state = Slot::State::DONE;
  }
  _exit(0);
}

/// What it means that a child ended within a case.
Verdict verdict_of_end(int status, const Limits& limits) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGPROF || signal == SIGALRM)
      return failure("time", "more than " + std::to_string(limits.cpu_seconds) + " seconds");
    return failure("crash", strsignal(signal));
  }
  return failure("crash", "exit status " + std::to_string(WEXITSTATUS(status)));
}

} // namespace

void run_in_batches(std::size_t n, unsigned workers, std::size_t batch, const Limits& limits,
                    const std::function<Verdict(std::size_t)>& run,
                    const std::function<void(std::size_t, const Result&)>& done,
                    const std::function<bool()>& shall_go_on) {
  struct Range {
    std::size_t begin, end;
  };
  Shared_slots slots(n);
  std::deque<Range> left;
  for (std::size_t i = 0; i < n; i += batch) left.push_back({i, std::min(n, i + batch)});
  std::map<pid_t, Range> children;
  std::size_t told = 0;

  const auto start = [&](const Range& range) {
    std::fflush(nullptr); // or the child would print what waits in the buffers once more
    const pid_t child = fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) run_batch(slots, range.begin, range.end, limits, run);
    children[child] = range;
  };
  const auto wait_for_one = [&] {
    int status = 0;
    const pid_t child = wait(&status);
    const auto at = children.find(child);
    if (at == children.end()) return;
    const Range range = at->second;
    children.erase(at);
    std::size_t i = range.begin;
    while (i < range.end && slots[i].state == Slot::State::DONE) ++i;
    if (i == range.end) return;
    Slot& slot = slots[i];
    slot.set(verdict_of_end(status, limits));
    slot.seconds = slot.seconds > 0 ? slot.seconds : limits.cpu_seconds;
    slot.state = Slot::State::DONE;
    if (i + 1 < range.end) left.push_front({i + 1, range.end});
  };

  for (;;) {
    while (children.size() < workers && !left.empty()) {
      if (!shall_go_on()) {
        left.clear();
        break;
      }
      const Range range = left.front();
      left.pop_front();
      start(range);
    }
    if (children.empty()) break;
    wait_for_one();
    for (; told < n && slots[told].state == Slot::State::DONE; ++told) done(told, slots[told].result());
  }
}

Result run_alone(const Limits& limits, const std::function<Verdict()>& run) {
  Result result;
  run_in_batches(
      1, 1, 1, limits, [&](std::size_t) { return run(); }, [&](std::size_t, const Result& r) { result = r; },
      [] { return true; });
  return result;
}

} // namespace soak
