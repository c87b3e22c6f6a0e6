// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The parallel layer: the few primitives from which all parallel algorithms here are made.
//
// Computes: loops, reductions, scans and packing over blocks of an index range; sorting is in parallel_sort.h.
// Bound:    O(n) work; O(1) rounds, each as long as a block, besides the pass over block totals.
// Method:   A range is cut into blocks by its length alone, never by the number of threads, and block results
//           are combined in order. So results are the same bits for any number of threads, also sequentially.
//
// `ConcurrencyTag` is `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `Chosen_tag`. The second runs on TBB if the
// program links it (`CGAL_LINKED_WITH_TBB`) and on one thread otherwise. The third is what the meshers use inside: one
// of the other two, as the mesher in use says at run time, so that the compiler makes their code once for both. All
// primitives go through `Executor<ConcurrencyTag>`; its specialization for another tag runs them elsewhere, for example
// to count.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_PARALLEL_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_PARALLEL_H

#include <CGAL/tags.h>
#include <boost/config.hpp> // BOOST_NOINLINE

// How g++ and how clang++ tell of the thread sanitizer.
#ifdef __SANITIZE_THREAD__
#define CGAL_QUADTREE_MESH_2_WATCH_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CGAL_QUADTREE_MESH_2_WATCH_THREADS
#endif
#endif

#ifdef CGAL_LINKED_WITH_TBB
#ifdef CGAL_QUADTREE_MESH_2_WATCH_THREADS
#include <CGAL/Quadtree_mesh_2/internal/parallel/Thread_executor.h>
#else
#include <tbb/parallel_for.h>
#endif
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Sequential or parallel, as the `Concurrency_scope` says.
struct Chosen_tag {};

/// While it lives, loops by `Chosen_tag` that this thread begins run as its tag says.
class Concurrency_scope {
public:
  template <class Tag>
  explicit Concurrency_scope(Tag) : before_(current()) {
    if (!std::is_same<Tag, Chosen_tag>::value) current() = std::is_same<Tag, Parallel_tag>::value;
  }
  ~Concurrency_scope() { current() = before_; }
  Concurrency_scope(const Concurrency_scope&) = delete;
  Concurrency_scope& operator=(const Concurrency_scope&) = delete;

  static bool is_parallel() { return current(); }

private:
  static bool& current() {
    thread_local bool is_parallel = false;
    return is_parallel;
  }

  bool before_;
};

/// What meshers with a tag of the user use inside.
template <class Tag>
using Inner_tag =
    std::conditional_t<std::is_same<Tag, Sequential_tag>::value || std::is_same<Tag, Parallel_tag>::value,
                       Chosen_tag, Tag>;

/// Whether loops of this tag run on one thread, which saves what is done to share work.
template <class ConcurrencyTag>
bool is_sequential() {
  if (std::is_same<ConcurrencyTag, Chosen_tag>::value) return !Concurrency_scope::is_parallel();
  return std::is_same<ConcurrencyTag, Sequential_tag>::value;
}

/// Runs independent tasks. `run(n, f)` calls `f(i)` for all i below n and returns when all calls have.
/// Exceptions of tasks are passed on, one of them if there are several.
template <class ConcurrencyTag>
struct Executor {
  template <class F>
  static void run(std::size_t n, const F& f) {
    for (std::size_t i = 0; i < n; ++i) f(i);
  }
};

/// A loop's body by its address and the function that calls it. What runs loops is instantiated for this one type
/// instead of for every body, which is more than half of what the compiler would have to do.
/// \tparam Argument of the body, some unsigned numbers
template <class... Argument>
class Erased_body {
public:
  template <class F>
  explicit Erased_body(const F& f) : body_(&f), call_(&call<F>) {}

  void operator()(Argument... argument) const { call_(body_, argument...); }

private:
  // Not a lambda converted to a pointer: that is a class and three functions for each body.
  template <class F>
  static void call(const void* body, Argument... argument) {
    (*static_cast<const F*>(body))(argument...);
  }

  const void* body_;
  void (*call_)(const void*, Argument...);
};
using Erased_task = Erased_body<std::size_t>;

template <>
struct Executor<Chosen_tag> {
  template <class F>
  static void run(std::size_t n, const F& f) {
    run_erased(n, Erased_task(f));
  }

private:
  // Inlined, it would bring a second copy of every body along: the one that is called where there is one thread.
  BOOST_NOINLINE static void run_erased(std::size_t n, const Erased_task& task) {
#ifdef CGAL_LINKED_WITH_TBB
    if (n > 1 && Concurrency_scope::is_parallel()) return run_in_parallel(n, task);
#endif
    for (std::size_t i = 0; i < n; ++i) task(i);
  }

#ifdef CGAL_LINKED_WITH_TBB
  static void run_in_parallel(std::size_t n, const Erased_task& task) {
    const auto run_in_scope = [&task](std::size_t i) {
      const Concurrency_scope scope{Parallel_tag()}; // of the thread that runs it
      task(i);
    };
#ifdef CGAL_QUADTREE_MESH_2_WATCH_THREADS
    Thread_executor::run(n, run_in_scope);
#else
    // In a context of its own: an exception in one task must not end loops within others, whose results are read.
    tbb::task_group_context context(tbb::task_group_context::isolated);
    tbb::parallel_for(std::size_t(0), n, run_in_scope, context);
#endif
  }
#endif
};

template <>
struct Executor<Parallel_tag> {
  template <class F>
  static void run(std::size_t n, const F& f) {
    const Concurrency_scope scope{Parallel_tag()};
    Executor<Chosen_tag>::run(n, f);
  }
};

/// The length of blocks where the work for each index is a few nanoseconds.
constexpr std::size_t default_block = 8192;

/// The consecutive blocks of `[0, n)` as tasks of a loop.
struct Block_task {
  std::size_t n, block_length;
  Erased_body<std::size_t, std::size_t, std::size_t> body;

  void operator()(std::size_t block) const {
    const std::size_t begin = block * block_length;
    body(block, begin, std::min(n, begin + block_length));
  }
};

/// Calls `f(block, begin, end)` for the consecutive blocks of `[0, n)`, all but the last of length
/// `block_length`.
template <class ConcurrencyTag, class F>
void for_each_block(std::size_t n, std::size_t block_length, const F& f) {
  const std::size_t blocks = (n + block_length - 1) / block_length;
  if (blocks == 0) return;
  Executor<ConcurrencyTag>::run(blocks, Block_task{n, block_length, decltype(Block_task::body)(f)});
}

/// Calls `f(i)` for all i below `n`.
template <class ConcurrencyTag, class F>
void for_each_index(std::size_t n, const F& f, std::size_t block_length = default_block) {
  for_each_block<ConcurrencyTag>(n, block_length, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) f(i);
  });
}

/// Returns `combine` of the values `of_range(begin, end)` of consecutive ranges that make up `[0, n)`, from
/// left to right, beginning with `identity`.
template <class ConcurrencyTag, class T, class Of_range, class Combine>
T reduce(std::size_t n, T identity, const Of_range& of_range, const Combine& combine,
         std::size_t block_length = default_block) {
  if (n == 0) return identity;
  if (n <= block_length) return combine(identity, of_range(std::size_t(0), n));
  struct Partial { // because the members of std::vector<bool> cannot be written independently
    T value;
  };
  std::vector<Partial> partial((n + block_length - 1) / block_length, Partial{identity});
  for_each_block<ConcurrencyTag>(n, block_length, [&](std::size_t b, std::size_t begin, std::size_t end) {
    partial[b].value = of_range(begin, end);
  });
  T result = identity;
  for (const Partial& p : partial) result = combine(result, p.value);
  return result;
}

/// Replaces each value by the sum of those before it, beginning with `first`; returns the sum of all and
/// `first`.
template <class T>
T scan_exclusively(T* values, std::size_t n, T first) {
  for (std::size_t i = 0; i < n; ++i) {
    const T value = values[i];
    values[i] = first;
    first = static_cast<T>(first + value);
  }
  return first;
}

/// Numbers what blocks hold: calls `count(begin, end)` for each block, once `allocate(sum)` with the sum of all
/// counts, then `place(begin, end, first)` for each block with the sum of the counts of the blocks before.
/// Returns the sum of all counts. Sums are of `std::size_t`, or of the type of the counts if that is wider.
template <class ConcurrencyTag, class Count, class Allocate, class Place>
auto count_allocate_and_place(std::size_t n, const Count& count, const Allocate& allocate, const Place& place,
                              std::size_t block_length = default_block) {
  using Number = std::decay_t<decltype(count(n, n))>;
  using Sum = std::conditional_t<(sizeof(Number) > sizeof(std::size_t)), Number, std::size_t>;
  std::vector<Sum> first((n + block_length - 1) / block_length);
  for_each_block<ConcurrencyTag>(n, block_length, [&](std::size_t b, std::size_t begin, std::size_t end) {
    first[b] = count(begin, end);
  });
  const Sum sum = scan_exclusively(first.data(), first.size(), Sum(0));
  allocate(sum);
  for_each_block<ConcurrencyTag>(n, block_length, [&](std::size_t b, std::size_t begin, std::size_t end) {
    place(begin, end, first[b]);
  });
  return sum;
}

/// Replaces each of `n` values by the sum of those before it and returns the sum of all.
template <class ConcurrencyTag, class T>
T exclusive_scan(T* values, std::size_t n) {
  static_assert(std::is_integral<T>::value, "block sums are kept as integers");
  return static_cast<T>(count_allocate_and_place<ConcurrencyTag>(
      n,
      [&](std::size_t begin, std::size_t end) {
        T sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum = static_cast<T>(sum + values[i]);
        return static_cast<std::size_t>(sum);
      },
      [](std::size_t) {},
      [&](std::size_t begin, std::size_t end, std::size_t first) {
        scan_exclusively(values + begin, end - begin, static_cast<T>(first));
      }));
}

/// Returns the values `value(i)` for the indices i below `n` with `is_kept(i)`, in order. `is_kept` is called
/// twice for each.
template <class ConcurrencyTag, class T, class Is_kept, class Value>
std::vector<T> pack_values(std::size_t n, const Is_kept& is_kept, const Value& value) {
  static_assert(!std::is_same<T, bool>::value, "the members of std::vector<bool> are not independent");
  std::vector<T> kept;
  count_allocate_and_place<ConcurrencyTag>(
      n,
      [&](std::size_t begin, std::size_t end) {
        std::size_t sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += is_kept(i) ? 1 : 0;
        return sum;
      },
      [&](std::size_t sum) { kept.resize(sum); },
      [&](std::size_t begin, std::size_t end, std::size_t first) {
        for (std::size_t i = begin; i < end; ++i)
          if (is_kept(i)) kept[first++] = value(i);
      });
  return kept;
}

/// Returns the indices i below `n` with `is_kept(i)`, in order.
/// \pre `n <= 2^32`
template <class ConcurrencyTag, class Is_kept>
std::vector<std::uint32_t> pack(std::size_t n, const Is_kept& is_kept) {
  return pack_values<ConcurrencyTag, std::uint32_t>(
      n, is_kept, [](std::size_t i) { return static_cast<std::uint32_t>(i); });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_PARALLEL_H
