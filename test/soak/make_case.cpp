// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "make_case.h"

#include "run_case.h"

#include "random_pslg.h"

#include <cstddef>
#include <initializer_list>
#include <string>

namespace soak {

namespace {

using random_pslg::Random;

/// Mixes that make no more than some tens of thousands of triangles.
Wishes random_wishes(Random& random) {
  Wishes w;
  const double angles[] = {20.7, 20.7, 20.7, 20.7, 18.43, 15, 10, 5};
  w.min_angle = angles[random.integer(0, 7)];
  switch (random.integer(0, 11)) {
  case 0:
    w.max_area = 1.0 / random.integer(10, 2000);
    break;
  case 1:
    w.max_edge = 1.0 / random.integer(2, 40);
    break;
  case 2:
    w.size = 1.0 / random.integer(2, 40);
    break;
  case 3:
    w.min_edge = 1.0 / random.integer(10, 10000);
    break;
  case 4:
    w.smooth = random.integer(1, 2);
    break;
  case 5:
    w.thin = random.integer(1, 2);
    break;
  case 6:
    w.is_coarsened = false;
    break;
  case 7:
    w.patience = 0;
    break;
  case 8:
    w.domain = CGAL::Quality_mesh_options_2::Domain::NESTING_PARITY;
    break;
  case 9:
    w.min_angle = random.integer(22, 34);
    break;
  default:
    break;
  }
  w.has_centroid_trees = random.integer(0, 7) == 0;
  w.has_trapezoids = random.integer(0, 3) == 0;
  w.effort = random.integer(0, 3);
  w.is_square = random.integer(0, 3) == 0;
  w.is_tightest = random.integer(0, 3) == 0;
  return w;
}

/// The same on every machine (FNV-1a).
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char ch : text) hash = (hash ^ static_cast<unsigned char>(ch)) * 0x100000001b3u;
  return hash;
}

/// A choice by weights.
std::size_t weighted(Random& random, std::initializer_list<int> weights) {
  int sum = 0;
  for (const int w : weights) sum += w;
  int at = random.integer(0, sum - 1);
  std::size_t i = 0;
  for (const int w : weights) {
    if (at < w) return i;
    at -= w, ++i;
  }
  return 0;
}

} // namespace

void prepare(Soak_case& c) {
  if (c.kernel == Kernel::FIXED32) c.graph = graph_of_words32(c.graph, c.mode);
  if (c.mode == Mode::PSLG) return;
  c.graph.segments.clear();
  c.graph.holes.clear();
  c.graph.regions.clear();
}

Soak_case make_case(const Family& family, std::uint64_t seed, const Restriction& restriction) {
  Soak_case c;
  c.family = family.name;
  c.seed = seed;
  c.graph = family.make(seed);
  Random random(seed ^ hash_of(family.name));
  // All chances are taken, so that what is left to chance does not depend on what is not.
  const auto kernel = static_cast<Kernel>(weighted(random, {4, 2, 3, 1}));
  const auto separation = static_cast<Separation>(weighted(random, {3, 1}));
  const bool is_of_points = family.kind == Family::Kind::POINTS;
  const auto mode = static_cast<Mode>(is_of_points ? weighted(random, {0, 1, 1, 1, 1})
                                                   : weighted(random, {20, 1, 1, 1, 1}));
  constexpr unsigned thread_numbers[] = {1, 2, 4};
  const unsigned threads = thread_numbers[weighted(random, {6, 1, 1})];
  const Wishes wishes = random_wishes(random);
  c.kernel = restriction.kernel.value_or(kernel);
  c.separation = restriction.separation.value_or(separation);
  c.mode = restriction.mode.value_or(mode);
  c.threads = restriction.threads.value_or(threads);
  if (!restriction.is_plain) c.wishes = wishes;
  if (!c.graph.regions.empty() && random.integer(0, 1) == 0)
    c.wishes.domain = CGAL::Quality_mesh_options_2::Domain::MARKED;
  prepare(c);
  return c;
}

} // namespace soak
