// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SLICED_POINTS_H
#define QUADTREE_MESH_2_TEST_SLICED_POINTS_H

// Points cut into slices, one for each part of a distributed computation.

#include "quadtree_test_inputs.h"

#include <CGAL/IO/Triangle_files.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace sliced_points {

using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Point_2 = Traits::Point_2;
using Points = std::vector<Point_2>;

struct Named_points {
  std::string name;
  Points points;
};

/// Squares of the whole grid's depth, in its middle, at its corner, and next to squares of all sizes.
inline Points deep_pairs(unsigned seed) {
  std::mt19937 random(seed);
  Points points;
  const auto next = [&] { return std::ldexp(static_cast<double>(random()), -32); };
  for (int i = 0; i < 12; ++i) {
    const double x = i % 3 == 0 ? 0.5 : next(), y = i % 4 == 0 ? 0.25 : next(),
                 gap = std::ldexp(1, -22 - 2 * i);
    points.emplace_back(x, y);
    points.emplace_back(x + gap, y + gap / 2);
    points.emplace_back(x, y - gap / 3);
  }
  return points;
}

/// More points than a square of level 29 may have, and others far away.
inline Points deep_cluster(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  Points points{{1, 1}, {-1, 0.5}, {0.75, -1}};
  for (std::size_t i = 0; i < n; ++i)
    points.emplace_back(std::ldexp(static_cast<double>(random()), -65),
                        std::ldexp(static_cast<double>(random()), -65));
  return points;
}

/// The same points in another order, in which no slice has neighbors.
inline Points shuffled(Points points, unsigned seed) {
  std::shuffle(points.begin(), points.end(), std::mt19937(seed));
  return points;
}

inline std::vector<Named_points> small_inputs() {
  std::vector<Named_points> inputs;
  const auto add = [&](const quadtree_test::Input& input) {
    inputs.push_back({input.name, shuffled(quadtree_test::make_points<Traits>(input), 5)});
  };
  for (const quadtree_test::Input& input : quadtree_test::all_inputs()) add(input);
  for (unsigned seed = 0; seed < 12; ++seed) add(quadtree_test::small_random(seed));
  add(quadtree_test::clusters(17));
  inputs.push_back({"deep pairs", shuffled(deep_pairs(3), 1)});
  inputs.push_back({"deep cluster", shuffled(deep_cluster(40, 4), 2)});
  inputs.push_back({"one place", Points(50, Point_2(3, 4))});
  return inputs;
}

inline Points vertices_of(const std::string& file_name) {
  CGAL::Pslg_2<Point_2> graph;
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_TEST_DATA_DIR "/" + file_name, graph);
  return std::move(graph.vertices);
}

/// Ways to cut.
enum class Cuts { EVEN, ALL_AT_THE_LAST, RANDOM };

inline Points slice(const Points& points, Cuts cuts, int part, int parts) {
  const auto cut = [&](int i) -> std::ptrdiff_t {
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    if (i == 0 || i == parts) return i == 0 ? 0 : n;
    if (cuts == Cuts::EVEN) return n * i / parts;
    if (cuts == Cuts::ALL_AT_THE_LAST) return 0;
    std::mt19937 random(static_cast<unsigned>(n));
    std::vector<std::ptrdiff_t> places;
    for (int k = 1; k < parts; ++k) places.push_back(static_cast<std::ptrdiff_t>(random()) % (n + 1));
    std::sort(places.begin(), places.end());
    return places[static_cast<std::size_t>(i - 1)];
  };
  return Points(points.begin() + cut(part), points.begin() + cut(part + 1));
}

} // namespace sliced_points

#endif // QUADTREE_MESH_2_TEST_SLICED_POINTS_H
