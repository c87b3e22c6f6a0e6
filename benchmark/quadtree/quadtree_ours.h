// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Our quadtrees as the benchmark sees them. What it knows of their interface is here.

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_OURS_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_OURS_H

#include "quadtree_run.h"
#include "thread_limit.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_framework.h>
#include <CGAL/Quadtree_options.h>
#include <CGAL/tags.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadtree_ours {

using CGAL::Quadtree_mesh_2::Balance;
using CGAL::Quadtree_mesh_2::Balance_schedule;

using Filtered_traits = CGAL::Filtered_quadtree_traits_2<>;
using Exact_traits = CGAL::Exact_quadtree_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
using Exact_double_traits =
    CGAL::Exact_quadtree_traits_2<CGAL::Exact_predicates_inexact_constructions_kernel>;

inline const Points& points_for(const Filtered_traits&, const Points& points) { return points; }
inline const Points& points_for(const Exact_double_traits&, const Points& points) { return points; }

inline std::vector<Exact_traits::Point_2> points_for(const Exact_traits&, const Points& points) {
  std::vector<Exact_traits::Point_2> exact;
  exact.reserve(points.size());
  for (const Point_2& p : points) exact.emplace_back(p.x(), p.y());
  return exact;
}

/// Points that 32 bits do not tell apart become equal, and the tree merges them.
template <class Word>
std::vector<CGAL::Fixed_point_2<Word>> points_for(const CGAL::Fixed_point_quadtree_traits_2<Word>&,
                                                  const Points& points) {
  const auto scale = CGAL::Fixed_point_scale_2<Word>::of_points(points);
  std::vector<CGAL::Fixed_point_2<Word>> fixed;
  fixed.reserve(points.size());
  for (const Point_2& p : points) fixed.push_back(scale.to_fixed(p.x(), p.y()));
  return fixed;
}

template <class Traits, class ConcurrencyTag>
Run framework(const Points& input, unsigned threads) {
  const Thread_limit limit(threads);
  const auto& points = points_for(Traits(), input);
  Run_recorder recorder;
  const CGAL::Quadtree_framework<Traits, ConcurrencyTag> framework(points);
  recorder.stop();
  recorder.set_size(framework.number_of_nodes());
  return recorder.run();
}

template <class Traits, class ConcurrencyTag>
Run tree(const Points& input, unsigned threads, const CGAL::Quadtree_options& options) {
  const Thread_limit limit(threads);
  const auto& points = points_for(Traits(), input);
  Run_recorder recorder;
  const CGAL::Balanced_quadtree<Traits, ConcurrencyTag> tree(points, options);
  recorder.stop();
  recorder.set_size(tree.number_of_leaves());
  recorder.set_depth(tree.depth());
  return recorder.run();
}

inline Product product_of(Balance balance) {
  if (balance == Balance::NONE) return Product::UNBALANCED;
  return balance == Balance::SIDES ? Product::SIDES : Product::CORNERS;
}

template <class Traits, class ConcurrencyTag>
Method framework_method(const std::string& name, unsigned threads) {
  return {"ours, " + name,
          {{"framework", Product::FRAMEWORK}},
          [=](const Points& points) { return framework<Traits, ConcurrencyTag>(points, threads); },
          threads};
}

template <class Traits, class ConcurrencyTag>
Method tree_method(const std::string& name, unsigned threads, const CGAL::Quadtree_options& options) {
  return {"ours, " + name,
          {{"tree", product_of(options.balance())}},
          [=](const Points& points) { return tree<Traits, ConcurrencyTag>(points, threads, options); },
          threads};
}

/// All that is made of one kind of points by one number of threads.
template <class Traits, class ConcurrencyTag>
void append_methods(const std::string& name, unsigned threads, std::vector<Method>& methods) {
  using Options = CGAL::Quadtree_options;
  methods.push_back(framework_method<Traits, ConcurrencyTag>(name, threads));
  for (Balance balance : {Balance::NONE, Balance::SIDES, Balance::SIDES_AND_CORNERS})
    methods.push_back(tree_method<Traits, ConcurrencyTag>(name, threads, Options().balance(balance)));
  methods.push_back(tree_method<Traits, ConcurrencyTag>(name + ", spaced levels", threads,
                                                        Options().schedule(Balance_schedule::SPACED_LEVELS)));
}

template <class Traits>
void append_methods(const std::string& name, const std::vector<unsigned>& threads,
                    std::vector<Method>& methods) {
  append_methods<Traits, CGAL::Sequential_tag>(name, 0, methods);
  for (unsigned t : threads)
    append_methods<Traits, CGAL::Parallel_tag>(
        name + ", " + std::to_string(t) + (t == 1 ? " thread" : " threads"), t, methods);
}

/// Our methods for one of the traits: "filtered", "fixed32", "fixed64", "exact" or
/// "doubles".
/// \param threads numbers of threads to run on, besides running sequentially.
inline std::vector<Method> methods(const std::string& traits, const std::vector<unsigned>& threads) {
  std::vector<Method> result;
  if (traits == "filtered")
    append_methods<Filtered_traits>(traits, threads, result);
  else if (traits == "fixed32")
    append_methods<CGAL::Fixed_point_quadtree_traits_2<std::uint32_t>>(traits, threads, result);
  else if (traits == "fixed64")
    append_methods<CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>>(traits, threads, result);
  else if (traits == "exact")
    append_methods<Exact_traits>(traits, threads, result);
  else if (traits == "doubles")
    append_methods<Exact_double_traits>(traits, threads, result);
  else
    throw std::invalid_argument("there are no traits '" + traits + "'");
  return result;
}

} // namespace quadtree_ours

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_OURS_H
