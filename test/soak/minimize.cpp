// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "minimize.h"

#include "judge.h"
#include "resources.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace soak {

namespace {

/// Without the vertices `is_gone` and the segments that end there.
Pslg without_vertices(const Pslg& graph, const std::vector<char>& is_gone) {
  using Vertex_index = Pslg::Vertex_index;
  Pslg result = graph;
  std::vector<std::size_t> number(graph.vertices.size());
  result.vertices.clear();
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    number[v] = result.vertices.size();
    if (is_gone[v] == 0) result.vertices.push_back(graph.vertices[v]);
  }
  result.segments.clear();
  for (const auto& [a, b] : graph.segments)
    if (is_gone[std::size_t(a)] == 0 && is_gone[std::size_t(b)] == 0)
      result.segments.push_back({Vertex_index(number[std::size_t(a)]), Vertex_index(number[std::size_t(b)])});
  return result;
}

/// A vertex on two segments goes, and one segment joins its neighbors.
Pslg with_vertex_skipped(const Pslg& graph, std::size_t v) {
  std::vector<std::size_t> at;
  for (std::size_t s = 0; s < graph.segments.size(); ++s)
    if (std::size_t(graph.segments[s][0]) == v || std::size_t(graph.segments[s][1]) == v) at.push_back(s);
  Pslg joined = graph;
  if (at.size() == 2) {
    const auto other = [&](std::size_t s) {
      const auto& [a, b] = graph.segments[s];
      return std::size_t(a) == v ? b : a;
    };
    joined.segments.push_back({other(at[0]), other(at[1])});
  }
  std::vector<char> is_gone(graph.vertices.size(), 0);
  is_gone[v] = 1;
  return without_vertices(joined, is_gone);
}

class Minimizer {
public:
  Minimizer(Soak_case c, std::string kind, const Limits& limits, double seconds)
      : best_(std::move(c)), kind_(std::move(kind)), limits_(limits), end_(wall_seconds() + seconds) {}

  Soak_case run() {
    drop_wishes();
    for (std::size_t last = 0; last != size() && has_time();) {
      last = size();
      drop(best_.graph.segments.size(),
           [](Pslg& g, std::size_t i, std::size_t j) { erase(g.segments, i, j); });
      drop(best_.graph.vertices.size(), [](Pslg& g, std::size_t i, std::size_t j) {
        std::vector<char> is_gone(g.vertices.size(), 0);
        std::fill(is_gone.begin() + std::ptrdiff_t(i), is_gone.begin() + std::ptrdiff_t(j), 1);
        g = without_vertices(g, is_gone);
      });
      skip_vertices();
      drop(best_.graph.holes.size(), [](Pslg& g, std::size_t i, std::size_t j) { erase(g.holes, i, j); });
      drop(best_.graph.regions.size(), [](Pslg& g, std::size_t i, std::size_t j) { erase(g.regions, i, j); });
    }
    return best_;
  }

private:
  Soak_case best_;
  std::string kind_;
  Limits limits_;
  double end_;

  bool has_time() const { return wall_seconds() < end_; }
  std::size_t size() const {
    const Pslg& g = best_.graph;
    return g.vertices.size() + g.segments.size() + g.holes.size() + g.regions.size();
  }
  template <class T>
  static void erase(std::vector<T>& all, std::size_t i, std::size_t j) {
    all.erase(all.begin() + std::ptrdiff_t(i), all.begin() + std::ptrdiff_t(j));
  }

  /// Takes `c` if it fails in the same way.
  bool take(const Soak_case& c) {
    if (!has_time()) return false;
    const Result result = run_alone(limits_, [&] { return judge(c); });
    if (result.verdict.outcome != Outcome::FAILED || result.verdict.kind != kind_) return false;
    best_ = c;
    return true;
  }

  void drop_wishes() {
    const auto attempt = [this](auto change) {
      Soak_case c = best_;
      change(c);
      if (arguments_of(c) != arguments_of(best_)) take(c);
    };
    const Wishes usual;
    attempt([](Soak_case& c) { c.threads = 1; });
    attempt([&](Soak_case& c) { c.wishes = usual; });
    attempt([&](Soak_case& c) { c.wishes.min_angle = usual.min_angle; });
    attempt([&](Soak_case& c) { c.wishes.max_area = 0, c.wishes.max_edge = 0, c.wishes.size = 0; });
    attempt([&](Soak_case& c) { c.wishes.min_edge = 0; });
    attempt([&](Soak_case& c) { c.wishes.smooth = 0, c.wishes.thin = 0; });
    attempt([&](Soak_case& c) { c.wishes.is_coarsened = true; });
    attempt([&](Soak_case& c) { c.wishes.domain = usual.domain; });
    attempt([&](Soak_case& c) { c.wishes.patience = usual.patience; });
    attempt([&](Soak_case& c) { c.wishes.has_centroid_trees = false, c.wishes.has_trapezoids = false; });
    attempt([&](Soak_case& c) {
      c.wishes.effort = usual.effort, c.wishes.is_square = false, c.wishes.is_tightest = false;
    });
  }

  /// Drops runs of `n` things: halves, then quarters, and so on.
  void drop(std::size_t n, const std::function<void(Pslg&, std::size_t, std::size_t)>& erase_range) {
    for (std::size_t length = (n + 1) / 2; length > 0 && has_time();
         length = length == 1 ? 0 : (length + 1) / 2)
      for (std::size_t i = 0; i < n && has_time();) {
        const std::size_t j = std::min(n, i + length);
        Soak_case c = best_;
        erase_range(c.graph, i, j);
        if (take(c))
          n -= j - i;
        else
          i = j;
      }
  }

  void skip_vertices() {
    for (std::size_t v = 0; v < best_.graph.vertices.size() && has_time();) {
      Soak_case c = best_;
      c.graph = with_vertex_skipped(best_.graph, v);
      if (!take(c)) ++v;
    }
  }
};

} // namespace

Soak_case minimized(Soak_case c, const std::string& kind, const Limits& limits, double seconds) {
  return Minimizer(std::move(c), kind, limits, seconds).run();
}

} // namespace soak
