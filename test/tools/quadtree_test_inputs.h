// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Point sets on which quadtrees are compared with brute force, for all models of QuadtreeTraits_2.

#ifndef QUADTREE_MESH_2_TEST_QUADTREE_TEST_INPUTS_H
#define QUADTREE_MESH_2_TEST_QUADTREE_TEST_INPUTS_H

#include "catch.h"

#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace quadtree_test {

using Filtered_traits = CGAL::Filtered_quadtree_traits_2<>;
using Fixed_32_traits = CGAL::Fixed_point_quadtree_traits_2<std::uint32_t>;
using Fixed_64_traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
using Exact_traits = CGAL::Exact_quadtree_traits_2<>;

/// A point with coordinates below 2^62, before it is converted to a traits' point.
struct Raw_point {
  std::uint64_t x, y;
};

struct Input {
  std::string name;
  std::vector<Raw_point> points;
};

/// All inputs for doubles, and for other traits every third one, others for each; all in a full run.
template <class Traits>
std::vector<Input> in_turn(const std::vector<Input>& inputs) {
  if (std::is_same_v<Traits, Filtered_traits> || is_full_run()) return inputs;
  const std::size_t first = std::is_same_v<Traits, Fixed_32_traits>   ? 0
                            : std::is_same_v<Traits, Fixed_64_traits> ? 1
                                                                      : 2;
  std::vector<Input> some;
  for (std::size_t i = first; i < inputs.size(); i += 3) some.push_back(inputs[i]);
  return some;
}

/// Converts a raw point. Coarser types drop bits; points that become equal are duplicates then.
inline Fixed_64_traits::Point_2 make_point(const Fixed_64_traits&, Raw_point p) { return {p.x, p.y}; }
inline Fixed_32_traits::Point_2 make_point(const Fixed_32_traits&, Raw_point p) {
  return {static_cast<std::uint32_t>(p.x >> 31), static_cast<std::uint32_t>(p.y >> 31)};
}
inline Filtered_traits::Point_2 make_point(const Filtered_traits&, Raw_point p) {
  // The root's side is up to four times the extent, so two bits less than the grid has; one more for
  // roundings.
  const auto coordinate = [](std::uint64_t v) { return std::ldexp(static_cast<double>(v >> 3), -30) - 1000; };
  return {coordinate(p.x), coordinate(p.y)};
}
inline Exact_traits::Point_2 make_point(const Exact_traits&, Raw_point p) {
  // Integers and thirds, of more bits than a double has. Distinct ones differ by 1 or more in a coordinate
  // and the extent is less than 2^59, so the unit of the first grid, 2^62 to a side, is 1/2 or less: they
  // are told apart without refinement, and grid coordinates fit a 64-bit word.
  using FT = CGAL::Epeck::FT;
  const auto coordinate = [](std::uint64_t v) {
    return FT(static_cast<double>(v >> 35)) * FT(4294967296.0) + FT(static_cast<double>(v >> 3 & 0xffffffff));
  };
  return {coordinate(p.x) - 1000, coordinate(p.y) + FT(1) / FT(3)};
}

template <class Traits>
std::vector<typename Traits::Point_2> make_points(const Input& input) {
  std::vector<typename Traits::Point_2> points;
  for (const Raw_point& p : input.points) points.push_back(make_point(Traits(), p));
  return points;
}

inline Input uniform(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  Input input{"uniform", {}};
  for (std::size_t i = 0; i < n; ++i) input.points.push_back({random() >> 2, random() >> 2});
  return input;
}

inline Input clusters(unsigned seed) {
  std::mt19937_64 random(seed);
  Input input{"clusters", {}};
  for (int c = 0; c < 6; ++c) {
    const Raw_point center{random() >> 3, random() >> 3};
    for (int i = 0; i < 12; ++i)
      input.points.push_back({center.x + (random() >> (3 + 9 * c)), center.y + (random() >> (3 + 9 * c))});
  }
  return input;
}

/// Points that wind around the center of the root, each at half the distance of the one before.
inline Input spiral() {
  const std::uint64_t center = std::uint64_t(1) << 61;
  Input input{"spiral", {}};
  for (int i = 60; i >= 0; --i) {
    const std::uint64_t r = std::uint64_t(1) << i;
    const int turn = i % 4;
    input.points.push_back({turn % 2 == 0 ? center
                            : turn == 1   ? center + r
                                          : center - r,
                            turn % 2 == 1 ? center
                            : turn == 0   ? center + r
                                          : center - r});
  }
  return input;
}

/// Points that approach a corner of the root; the depth is that of the grid.
inline Input geometric_sequence() {
  Input input{"geometric sequence", {{0, 0}}};
  for (int i = 0; i < 62; ++i) input.points.push_back({std::uint64_t(1) << i, (std::uint64_t(1) << i) / 3});
  return input;
}

/// Points either side of the root's middle lines: small squares beside squares of every size.
inline Input straddling() {
  const std::uint64_t middle = std::uint64_t(1) << 61, small = std::uint64_t(1) << 34;
  return {"straddling",
          {{middle - small, middle - small},
           {middle + small, middle + small},
           {middle + 9 * small, small},
           {middle - 9 * small, small}}};
}

inline Input lattice(std::uint64_t spacing) {
  Input input{"lattice", {}};
  for (std::uint64_t i = 0; i < 9; ++i)
    for (std::uint64_t j = 0; j < 9; ++j) input.points.push_back({i * spacing, j * spacing});
  return input;
}

inline Input collinear(std::uint64_t dx, std::uint64_t dy) {
  Input input{"collinear", {}};
  for (std::uint64_t i = 0; i < 60; ++i)
    input.points.push_back({i * dx + 12345, i * dy + (dy == 0 ? 54321 : 0)});
  return input;
}

inline Input cocircular() {
  Input input{"cocircular", {}};
  for (int i = 0; i < 72; ++i) {
    const double angle = i * 0.0872664625997164788;
    const auto coordinate = [](double c) { return static_cast<std::uint64_t>(std::ldexp(2 + c, 59)); };
    input.points.push_back({coordinate(std::cos(angle)), coordinate(std::sin(angle))});
  }
  return input;
}

inline Input duplicates(unsigned seed) {
  std::mt19937_64 random(seed);
  Input input{"duplicates", {}};
  for (int i = 0; i < 100; ++i) input.points.push_back({random() % 8 << 40, random() % 8 << 40});
  return input;
}

/// Two to ten points at distances of very different size.
inline Input small_random(unsigned seed) {
  std::mt19937_64 random(seed);
  Input input{"small random", {}};
  for (unsigned i = 0; i < 2 + seed % 9; ++i) {
    const int shift = static_cast<int>(2 + random() % 40);
    input.points.push_back({random() >> shift, random() >> shift});
  }
  return input;
}

inline std::vector<Input> all_inputs() {
  const std::uint64_t large = std::uint64_t(1) << 56;
  return {{"none", {}},
          {"one", {{large, 3 * large}}},
          {"equal", {{large, large}, {large, large}, {large, large}}},
          {"two", {{large, large}, {large + 7 * (large >> 20), large}}},
          uniform(5, 1),
          uniform(150, 2),
          clusters(3),
          spiral(),
          geometric_sequence(),
          straddling(),
          lattice(large),
          lattice((std::uint64_t(1) << 41) + 987654321),
          collinear(large, 0),
          collinear(large / 3, large / 5),
          cocircular(),
          duplicates(4)};
}

} // namespace quadtree_test

#endif // QUADTREE_MESH_2_TEST_QUADTREE_TEST_INPUTS_H
