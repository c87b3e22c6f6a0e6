// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_MEASUREMENT_H
#define QUADTREE_MESH_2_BENCHMARK_MEASUREMENT_H

#include "resources.h"

#include <algorithm>
#include <vector>

struct Seconds {
  double cpu = 0;
  double wall = 0;

  Seconds& operator+=(const Seconds& other) {
    cpu += other.cpu;
    wall += other.wall;
    return *this;
  }
};

/// Whether a mesh is looked at after the time is taken. One of several runs is enough where all are the same.
enum class Check { NO, YES };

/// Takes the time from its making on.
class Stopwatch {
public:
  Seconds seconds() const { return {cpu_seconds() - start_.cpu, wall_seconds() - start_.wall}; }

private:
  Seconds start_{cpu_seconds(), wall_seconds()};
};

/// Of values, of which there are some.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

#endif // QUADTREE_MESH_2_BENCHMARK_MEASUREMENT_H
