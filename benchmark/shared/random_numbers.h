// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_RANDOM_NUMBERS_H
#define QUADTREE_MESH_2_BENCHMARK_RANDOM_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <random>

/// Numbers of [0, 1) that are the same with every standard library: its distributions are not.
class Random_numbers {
public:
  explicit Random_numbers(std::uint64_t seed) : engine_(seed) {}

  double operator()() { return double(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * (*this)(); }

private:
  std::mt19937_64 engine_;
};

#endif // QUADTREE_MESH_2_BENCHMARK_RANDOM_NUMBERS_H
