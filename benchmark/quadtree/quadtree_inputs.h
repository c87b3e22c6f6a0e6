// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_INPUTS_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_INPUTS_H

#include "random_numbers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Points = std::vector<Point_2>;

namespace quadtree_inputs {

inline Points uniform(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  points.reserve(n);
  while (points.size() < n) {
    const double x = random(), y = random();
    points.emplace_back(x, y);
  }
  return points;
}

inline Point_2 polar(double r, double angle) { return {r * std::cos(angle), r * std::sin(angle)}; }

/// A cluster of stars by Plummer's law, seen from far away.
inline Points plummer(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  points.reserve(n);
  while (points.size() < n) {
    const double mass = random(), cosine = 2 * random() - 1, angle = 2 * CGAL_PI * random();
    const double r = 1 / std::sqrt(std::pow(mass, -2.0 / 3) - 1);
    if (r < 100) points.push_back(polar(r * std::sqrt(1 - cosine * cosine), angle)); // few are farther away
  }
  return points;
}

/// Kuzmin's disc, with the same law as in the problem based benchmark suite: dense in the middle, sparse and
/// wide outside.
inline Points kuzmin(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  points.reserve(n);
  while (points.size() < n) {
    const double u = random(), angle = 2 * CGAL_PI * random();
    const double r = std::sqrt(1 / ((1 - u) * (1 - u)) - 1);
    if (r < 1e6) points.push_back(polar(r, angle));
  }
  return points;
}

/// All points of a grid, row by row.
inline Points grid(std::size_t n, std::uint64_t) {
  const std::size_t side = std::size_t(std::ceil(std::sqrt(double(n))));
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(double(i % side), double(i / side));
  return points;
}

/// Points at random places of a line that is not straight in binary: with slope 1/3 and a little more.
inline Points line(std::size_t n, std::uint64_t seed) {
  const double slope = 1.0 / 3 + std::sqrt(2.0) / 1000;
  Random_numbers random(seed);
  Points points;
  points.reserve(n);
  while (points.size() < n) {
    const double x = random();
    points.emplace_back(x, slope * x);
  }
  return points;
}

/// A spiral whose radius is halved with every turn, from the outside in: the more points, the fewer turns, so
/// that neighbors in the middle are 2^-bits apart up to a small factor.
inline Points spiral_of(std::size_t n, double bits) {
  const double turns = std::floor(bits - std::log2(double(n)));
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = turns * double(i) / double(n);
    const Point_2 p = polar(0.5 * std::exp2(-turn), 2 * CGAL_PI * turn);
    points.emplace_back(0.5 + p.x(), 0.5 + p.y());
  }
  return points;
}

/// Until neighbors are a few units in the last place apart. Half of the turns are too small for trees of 29
/// levels, and the innermost ones for meshes.
inline Points spiral(std::size_t n, std::uint64_t) { return spiral_of(n, 58); }

/// As far in as meshes of tiles can go, and a bit less: until neighbors are 2^-40 apart or so.
inline Points short_spiral(std::size_t n, std::uint64_t) { return spiral_of(n, 46); }

/// Clusters of about as many points as there are clusters, the widest a thousand times as wide as the narrowest.
inline Points clusters(std::size_t n, std::uint64_t seed) {
  const std::size_t size = std::size_t(std::ceil(std::sqrt(double(n))));
  Random_numbers random(seed);
  Points points;
  points.reserve(n);
  while (points.size() < n) {
    const double x = random(), y = random(), width = std::pow(10, -random.between(1.5, 4.5));
    for (std::size_t i = 0; i < size && points.size() < n; ++i) {
      const double r = width * std::sqrt(-std::log(1 - random())), angle = 2 * CGAL_PI * random();
      const Point_2 p = polar(r, angle);
      points.emplace_back(x + p.x(), y + p.y());
    }
  }
  return points;
}

/// Points uniform in a square with a partner each, so much nearer than all others that any n give the same
/// picture: at 1e-8 of the square's side if they are 300.
inline Points close_pairs(std::size_t n, std::uint64_t seed) {
  const double distance = 1e-8 * std::sqrt(300 / double(n));
  Random_numbers random(seed);
  Points points;
  points.reserve(n);
  while (points.size() < n) {
    const double x = random(), y = random();
    const Point_2 p = polar(distance, 2 * CGAL_PI * random());
    points.emplace_back(x, y);
    if (points.size() < n) points.emplace_back(x + p.x(), y + p.y());
  }
  return points;
}

/// Five clusters around the origin, one in the other, of as many points each: every one is 2^-30 times as wide
/// as the next. No tree without clusters can be so deep.
inline Points nested(std::size_t n, std::uint64_t seed) {
  constexpr std::size_t depth = 5;
  Random_numbers random(seed);
  Points points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int exponent = -30 * int(i * depth / n);
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    points.emplace_back(std::ldexp(x, exponent), std::ldexp(y, exponent));
  }
  return points;
}

struct Input {
  std::string name;
  Points (*make)(std::size_t n, std::uint64_t seed);
};

inline const std::vector<Input>& all() {
  static const std::vector<Input> inputs{{"uniform", uniform},   {"plummer", plummer},
                                         {"kuzmin", kuzmin},     {"grid", grid},
                                         {"line", line},         {"spiral", spiral},
                                         {"clusters", clusters}, {"close-pairs", close_pairs},
                                         {"nested", nested},     {"short-spiral", short_spiral}};
  return inputs;
}

inline const Input& by_name(const std::string& name) {
  for (const Input& input : all())
    if (input.name == name) return input;
  throw std::invalid_argument("there is no input '" + name + "'");
}

} // namespace quadtree_inputs

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_INPUTS_H
