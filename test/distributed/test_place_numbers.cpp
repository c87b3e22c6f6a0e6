// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertices that parts have get the numbers that `renumber_by_place()` gives them in one mesh, whichever part has
// them, and in whatever order.

#include "catch.h"
#include "sliced_points.h"

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Place_numbers.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/renumber_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_place_numbers {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using sliced_points::Point_2;
using sliced_points::Points;
using Float_point = CGAL::Simple_cartesian<float>::Point_2;

template <class Point>
using Vertices = std::vector<Placed_vertex<Point>>;

/// The first so many points are the input's vertices; the others have handles in their order, with gaps.
template <class Point>
Vertices<Point> vertices_at(const std::vector<Point>& points, std::size_t inputs) {
  Vertices<Point> vertices;
  std::uint64_t handle = 5;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_input = i < inputs;
    const std::uint64_t any = (i * 7919) % 1000; // says nothing of vertices of the input
    vertices.push_back({coordinates_to_send(points[i]), is_input ? static_cast<std::int64_t>(i) : -1,
                        is_input ? any : handle});
    if (!is_input) handle += i % 3 == 0 ? std::uint64_t(1) << 40 : 1;
  }
  return vertices;
}

template <class Point>
std::vector<std::int64_t> numbers_in_one_mesh(const std::vector<Point>& points, std::size_t inputs) {
  CGAL::Indexed_mesh_2<Point> mesh;
  mesh.points = points;
  mesh.number_of_input_vertices = inputs;
  std::vector<std::int64_t> numbers;
  for (const auto v : CGAL::renumber_by_place(mesh).new_vertex) numbers.push_back(v.value());
  return numbers;
}

/// Which part has a vertex.
enum class Owners { RANDOM, RUNS, ALL_AT_ONE };

/// The vertices that each part has, by their indices.
using Dealt = std::vector<std::vector<std::size_t>>;

Dealt dealt(std::size_t n, int parts, Owners owners) {
  std::mt19937 random(static_cast<unsigned>(n));
  Dealt result(static_cast<std::size_t>(parts));
  for (std::size_t i = 0; i < n; ++i)
    result[owners == Owners::RANDOM ? random() % result.size()
           : owners == Owners::RUNS ? i * result.size() / n
                                    : result.size() / 2]
        .push_back(i);
  for (auto& own : result) std::shuffle(own.begin(), own.end(), random);
  return result;
}

struct Numbered {
  std::vector<std::int64_t> numbers;
  std::vector<Exchange_traffic> traffic;
};

/// \param at_a_time how many vertices of a part are on their way at once
template <class Point>
Numbered numbers_by_parts(const Vertices<Point>& vertices, const Dealt& owned, std::size_t at_a_time) {
  Numbered result{std::vector<std::int64_t>(vertices.size(), -1), {}};
  std::vector<int> is_complete(owned.size(), 0);
  result.traffic = In_memory_exchange::run(static_cast<int>(owned.size()), [&](In_memory_exchange& exchange) {
    const auto part = static_cast<std::size_t>(exchange.rank());
    Vertices<Point> own;
    for (const std::size_t i : owned[part]) own.push_back(vertices[i]);
    const std::vector<std::int64_t> numbers = numbers_by_place<Point>(
        exchange, own.size(), [&own](std::size_t i) { return own[i]; }, at_a_time);
    is_complete[part] = numbers.size() == own.size();
    if (is_complete[part] != 0)
      for (std::size_t k = 0; k < own.size(); ++k) result.numbers[owned[part][k]] = numbers[k];
  });
  CHECK(std::count(is_complete.begin(), is_complete.end(), 0) == 0);
  return result;
}

template <class Point>
void check_same(const std::vector<Point>& points, int parts, Owners owners) {
  for (const std::size_t inputs : {std::size_t(0), points.size() / 3, points.size()}) {
    const std::size_t at_a_time = 1 + points.size() / (1 + inputs % 7);
    CAPTURE(inputs, at_a_time);
    const Dealt owned = dealt(points.size(), parts, owners);
    CHECK(numbers_by_parts(vertices_at(points, inputs), owned, at_a_time).numbers ==
          numbers_in_one_mesh(points, inputs));
  }
}

/// By any number of parts, whichever have the vertices.
template <class Point>
void check_all(const std::vector<Point>& points) {
  for (const int parts : {1, 2, 3, 7})
    for (const Owners owners : {Owners::RANDOM, Owners::RUNS, Owners::ALL_AT_ONE}) {
      CAPTURE(parts, int(owners));
      check_same(points, parts, owners);
    }
}

double next(std::mt19937& random) { return std::ldexp(static_cast<double>(random()), -32); }

template <class Point>
std::vector<Point> uniform(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  using Coordinate = typename Sent_coordinates<Point>::value_type;
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const auto x = static_cast<Coordinate>(next(random)), y = static_cast<Coordinate>(next(random));
    points.emplace_back(x, y);
  }
  return points;
}

/// Around few places, at distances of all magnitudes; many share a square, or a coordinate.
Points clusters() {
  std::mt19937 random(3);
  Points points;
  for (int cluster = 0; cluster < 9; ++cluster) {
    const double x = cluster == 0 ? 0 : next(random), y = cluster == 1 ? 0 : next(random);
    for (int i = 0; i < 60; ++i) {
      const double dx = std::ldexp(next(random), -10 * cluster - int(random() % 4)),
                   dy = dx * int(random() % 3);
      points.emplace_back(x + dx, y + dy);
    }
  }
  return points;
}

/// Two points at each place that has two of the values as coordinates.
Points pairs_of(const std::vector<double>& values) {
  Points points;
  for (const double x : values)
    for (const double y : values) points.emplace_back(x, y), points.emplace_back(x, y);
  return sliced_points::shuffled(std::move(points), 11);
}

std::vector<sliced_points::Named_points> all_kinds() {
  using Limits = std::numeric_limits<double>;
  std::vector<sliced_points::Named_points> kinds;
  kinds.push_back({"none", {}});
  kinds.push_back({"one", {{3, 4}}});
  kinds.push_back({"uniform", uniform<Point_2>(2000, 1)});
  kinds.push_back({"clusters", clusters()});
  Points line, column, slope;
  for (int i = 0; i < 300; ++i) {
    const double t = i * 37 % 300;
    line.emplace_back(t, 1e6), column.emplace_back(-0.1, t / 7), slope.emplace_back(t / 3, 1 - t / 3);
  }
  kinds.push_back({"line", std::move(line)});
  kinds.push_back({"column", std::move(column)});
  kinds.push_back({"slope", std::move(slope)});
  kinds.push_back({"one place", Points(200, Point_2(3, 4))});
  Points two_places(150, Point_2(0, 0));
  two_places.insert(two_places.begin() + 40, 150, Point_2(1, 1));
  kinds.push_back({"two places", std::move(two_places)});
  kinds.push_back({"largest and least", pairs_of({-1.7e308, -1, -5e-324, 0, 5e-324, 1e-300, 1, 1.7e308})});
  kinds.push_back({"largest", pairs_of({-Limits::max(), Limits::max(), 1e308})});
  kinds.push_back({"denormal", pairs_of({-1e-310, -5e-324, 0, 5e-324, 1e-323, 2e-310})});
  kinds.push_back({"signed zeros", pairs_of({-0., 0.})});
  kinds.push_back({"signed zeros amid others", pairs_of({-1, -0., 0., 5e-324, 1})});
  kinds.push_back({"far from 0", pairs_of({1e15, 1e15 + 1, 1e15 + 2, 1e15 + 3.5})});
  kinds.push_back({"deep pairs", sliced_points::deep_pairs(3)});
  kinds.push_back({"deep cluster", sliced_points::deep_cluster(100, 4)});
  return kinds;
}

} // namespace

TEST_CASE("vertices of all parts get the numbers of one mesh", "[distributed][renumber]") {
  for (const sliced_points::Named_points& kind : all_kinds()) {
    INFO(kind.name);
    check_all(kind.points);
  }
}

TEST_CASE("vertices with coordinates in floats get the numbers of one mesh", "[distributed][renumber]") {
  check_all(uniform<Float_point>(1000, 2));
  std::vector<Float_point> points;
  for (const float x : {-3e38f, -0.f, 0.f, 1e-45f, 1.f, 3e38f})
    for (const float y : {-1e-45f, 0.f, 0.1f, 0.1f}) points.emplace_back(x, y);
  check_all(points);
}

TEST_CASE("vertices of a map get the numbers of one mesh", "[distributed][renumber]") {
  for (const int parts : {1, 3, 7})
    for (const Owners owners : {Owners::RANDOM, Owners::RUNS}) {
      CAPTURE(parts, int(owners));
      check_same(sliced_points::vertices_of("gshhg_aegean_h.poly.gz"), parts, owners);
    }
}

TEST_CASE("parts number about as many vertices each", "[distributed][renumber]") {
  const std::size_t n = 40000;
  auto points = uniform<Point_2>(n, 3);
  std::sort(points.begin(), points.end()); // so that parts may have strips
  const auto check_balance = [&](const Dealt& owned) {
    const auto numbered = numbers_by_parts(vertices_at(points, n / 2), owned, n);
    const std::size_t most_numbered = n / owned.size() + n / 64;
    for (std::size_t part = 0; part < owned.size(); ++part) {
      CAPTURE(owned.size(), part);
      CHECK(numbered.traffic[part].bytes <= 24 * owned[part].size() + 8 * most_numbered);
    }
  };
  for (const int parts : {2, 5, 7}) {
    for (const Owners owners : {Owners::RANDOM, Owners::RUNS, Owners::ALL_AT_ONE}) {
      CAPTURE(int(owners));
      check_balance(dealt(n, parts, owners));
    }
    Dealt most_at_first(static_cast<std::size_t>(parts));
    for (std::size_t i = 0; i < n; ++i)
      most_at_first[i < n / 10 * 9 ? 0 : 1 + i % (most_at_first.size() - 1)].push_back(i);
    check_balance(most_at_first);
  }
}

} // namespace test_place_numbers
