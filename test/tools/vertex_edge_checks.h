// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What the tests of all models of VertexEdgeNeighbors_2 share: inputs, points of all traits, and answers held
// against brute force.

#ifndef QUADTREE_MESH_2_TEST_VERTEX_EDGE_CHECKS_H
#define QUADTREE_MESH_2_TEST_VERTEX_EDGE_CHECKS_H

#include "catch.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"
#include "vertex_edge_brute_force.h"

#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/Quadtree_mesh_2/vertex_edge_neighbor_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace vertex_edge_test {

using Filtered_traits = CGAL::Filtered_quadtree_traits_2<>;
using Exact_traits = CGAL::Exact_quadtree_traits_2<>;
using Fixed_32_traits = CGAL::Fixed_point_quadtree_traits_2<std::uint32_t>;
using Fixed_64_traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;

/// The same graph with points of other traits: rounded to words, or divided by 3.
template <class Traits>
CGAL::Pslg_2<typename Traits::Point_2> converted(const random_pslg::Pslg& from) {
  using Point = typename Traits::Point_2;
  CGAL::Pslg_2<Point> to;
  to.segments = from.segments;
  if constexpr (std::is_same<Point, random_pslg::Point>::value) {
    to.vertices = from.vertices;
  } else if constexpr (std::is_same<Point, EP>::value) {
    for (const auto& p : from.vertices) to.add_vertex(EP(FT(p.x()) / 3, FT(p.y()) / 3));
  } else if (!from.vertices.empty()) {
    const auto scale = CGAL::Fixed_point_scale_2<typename Traits::Word>::of_points(from.vertices);
    for (const auto& p : from.vertices) to.add_vertex(scale.to_fixed(p.x(), p.y()));
  }
  return to;
}

inline void check_distance(double found, const Nearest& expected) {
  const double d = expected.distance();
  if (std::isinf(d) || d == 0)
    REQUIRE(found == d);
  else
    REQUIRE(std::fabs(found - d) <= 1e-12 * d);
}

/// At most `n` vertices, spread evenly.
template <class Pslg>
std::vector<Vertex_index> sample(const Pslg& pslg, std::size_t n) {
  const std::size_t step = std::max<std::size_t>(1, pslg.number_of_vertices() / n);
  std::vector<Vertex_index> result;
  for (std::size_t i = 0; i < pslg.number_of_vertices(); i += step) result.push_back(Vertex_index(i));
  return result;
}

template <class Neighbors>
void check_rays(const Neighbors& neighbors, const Brute_force& brute_force, Vertex_index v) {
  CAPTURE(v.value());
  for (const Direction d : axis_directions) {
    const CGAL::Vertex_edge_neighbor_2 hit = neighbors.first_hit(v, d);
    const Nearest expected = brute_force.first_hit(v, d);
    CAPTURE(static_cast<int>(d), hit.distance, expected.distance());
    REQUIRE(hit.segment == expected.segment);
    check_distance(hit.distance, expected);
  }
  const Nearest expected = brute_force.nearest_hit(v);
  REQUIRE(neighbors.nearest_hit(v).segment == expected.segment);
  check_distance(neighbors.nearest_hit(v).distance, expected);
}

/// f <= min(V, H) <= sqrt(2) f.
template <class Neighbors>
void check_lemma_5(const Neighbors& neighbors, const Brute_force& brute_force, Vertex_index v) {
  const double to_vertex = brute_force.nearest_vertex(v).distance();
  const double to_segment = brute_force.nearest_segment(v).distance();
  const double hit = neighbors.nearest_hit(v).distance;
  const double f = std::min(to_vertex, to_segment), found = std::min(to_vertex, hit);
  REQUIRE(hit >= to_segment * (1 - 1e-12));
  REQUIRE(f * (1 - 1e-12) <= found);
  REQUIRE((std::isinf(f) || found <= std::sqrt(2.0) * f * (1 + 1e-12)));
}

/// All answers about rays, as numbers.
template <class Neighbors>
std::vector<double> answers(const Neighbors& neighbors) {
  std::vector<double> result;
  for (std::size_t i = 0; i < neighbors.pslg().number_of_vertices(); ++i) {
    for (const Direction d : axis_directions) {
      const CGAL::Vertex_edge_neighbor_2& hit = neighbors.first_hit(Vertex_index(i), d);
      result.push_back(hit.segment.value());
      result.push_back(hit.distance);
    }
    result.push_back(neighbors.nearest_hit(Vertex_index(i)).segment.value());
  }
  return result;
}

inline random_pslg::Pslg read_map(const std::string& name) {
  random_pslg::Pslg pslg;
  CGAL::IO::read_triangle_poly(pslg_test::data_file(name), pslg);
  return pslg;
}

/// Segments between the points of a lattice, some crossing, some overlapping.
inline random_pslg::Pslg lattice_of_segments() {
  random_pslg::Pslg pslg;
  const std::size_t n = 9;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) pslg.add_vertex({static_cast<double>(i), static_cast<double>(j)});
  const auto vertex = [](std::size_t i, std::size_t j) { return Vertex_index(i * n + j); };
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t j = 0; j + 1 < n; ++j) {
      if ((i + j) % 3 == 0) pslg.add_segment(vertex(i, j), vertex(i, j + 1));
      if ((i * j) % 2 == 0) pslg.add_segment(vertex(i, j), vertex(i + 1, j));
      if ((i + 2 * j) % 5 < 2) pslg.add_segment(vertex(i + 1, j), vertex(i, j + 1));
      if ((i + 2 * j) % 7 == 0) pslg.add_segment(vertex(i, j), vertex(i + 1, j + 1)); // may cross
      if (i + 3 < n && j % 4 == 1) pslg.add_segment(vertex(i, j), vertex(i + 3, j));  // overlaps
    }
  return pslg;
}

/// Long segments that all but the parallel ones cross, and points between them.
inline random_pslg::Pslg long_crossing_segments() {
  random_pslg::Random random(5);
  random_pslg::Pslg pslg;
  for (int i = 0; i < 60; ++i) {
    pslg.add_vertex({random.between(-1, -0.99), random.between(-1, 1)});
    pslg.add_vertex({random.between(0.99, 1), random.between(-1, 1)});
    pslg.add_segment(Vertex_index(pslg.number_of_vertices() - 2),
                     Vertex_index(pslg.number_of_vertices() - 1));
    pslg.add_vertex({random.between(-1, 1), random.between(-1, 1)});
  }
  return pslg;
}

/// Wedges of sizes 1, 2^-300 and 2^-900 around a point that is no double.
inline CGAL::Pslg_2<EP> wedges_of_tiny_size() {
  CGAL::Pslg_2<EP> pslg;
  const FT third = FT(1) / FT(3);
  for (const FT& size : {FT(1), FT(std::ldexp(1.0, -300)), FT(std::ldexp(1.0, -900))}) {
    const std::size_t first = pslg.number_of_vertices();
    for (const auto& p : {EP(2, 1), EP(1, 2), EP(3, 3), EP(2, 5)})
      pslg.add_vertex(EP(third + size * p.x(), third + size * p.y()));
    for (std::size_t i = 0; i < 3; ++i) pslg.add_segment(Vertex_index(first), Vertex_index(first + i + 1));
    pslg.add_segment(Vertex_index(first + 1), Vertex_index(first + 2));
  }
  return pslg;
}

/// Near the axes doubles are finer than far from them: corners of leaves are rounded there.
inline random_pslg::Pslg points_finer_than_leaves() {
  random_pslg::Random random(3);
  random_pslg::Pslg pslg;
  for (int i = 0; i < 120; ++i) {
    const double tiny = std::ldexp(random.between(-1, 1), -50),
                 one = 1 + std::ldexp(random.integer(0, 40), -52);
    pslg.add_vertex(i % 2 == 0 ? random_pslg::Point(tiny, one) : random_pslg::Point(one, tiny));
    if (i % 3 > 0 && i >= 2) pslg.add_segment(Vertex_index(std::size_t(i - 2)), Vertex_index(std::size_t(i)));
  }
  return pslg;
}

} // namespace vertex_edge_test

#endif // QUADTREE_MESH_2_TEST_VERTEX_EDGE_CHECKS_H
