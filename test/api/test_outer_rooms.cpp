// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What faces the border of meshes from the outside, and which places of its vertices are clear of that.

#include "catch.h"
#include "mesher_test_tools.h"
#include "random_pslg_shapes.h"

#include <CGAL/Quadtree_mesh_2/internal/output/Outer_rooms.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Segment_chains.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_outer_rooms {

namespace {

using mesher_test::Mesh;
using mesher_test::read;
using pslg_test::Point;
using pslg_test::Pslg;
using pslg_test::Vertex_index;
using Chains = CGAL::Quadtree_mesh_2::internal::Segment_chains<Point>;
using Rooms = CGAL::Quadtree_mesh_2::internal::Outer_rooms<Point>;

bool is_left(const Point& p, const Point& q, const Point& r) {
  return CGAL::orientation(p, q, r) == CGAL::LEFT_TURN;
}
bool cross(const Point& p, const Point& q, const Point& a, const Point& b) {
  return CGAL::orientation(p, q, a) * CGAL::orientation(p, q, b) < 0 &&
         CGAL::orientation(a, b, p) * CGAL::orientation(a, b, q) < 0;
}

/// The sides of triangles with nothing across.
std::set<std::pair<Vertex_index, Vertex_index>> border_sides(const Mesh& mesh) {
  std::set<std::pair<Vertex_index, Vertex_index>> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (!mesh.neighbors[t][k].is_valid())
        sides.emplace(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]);
  return sides;
}

/// Whether the triangle a, b, c is one that no vertex is in and no segment passes through.
bool is_empty(const Pslg& pslg, const Point& a, const Point& b, const Point& c) {
  const bool has_vertex = std::any_of(pslg.vertices.begin(), pslg.vertices.end(), [&](const Point& p) {
    return is_left(a, b, p) && is_left(b, c, p) && is_left(c, a, p);
  });
  return !has_vertex && std::none_of(pslg.segments.begin(), pslg.segments.end(), [&](const auto& s) {
    const Point &p = pslg.point(s[0]), &q = pslg.point(s[1]);
    return cross(p, q, a, b) || cross(p, q, b, c) || cross(p, q, c, a);
  });
}

/// Returns how many edges something faces.
std::size_t check_what_faces_the_border(const Mesh& mesh, const Pslg& pslg) {
  const Chains chains(mesh);
  const Rooms rooms(mesh, chains);
  const auto sides = border_sides(mesh);
  std::size_t at_border = 0, faced = 0;
  for (std::size_t e = 0; e < mesh.constrained_edges.size(); ++e) {
    const auto& edge = mesh.constrained_edges[e];
    CHECK(rooms.number_of_vertices_beyond(e) == 0); // meshes of doubles are in their rooms
    const bool is_at_border = sides.count({edge.vertices[0], edge.vertices[1]}) > 0;
    at_border += is_at_border ? 1 : 0;
    if (!edge.outer_vertex.is_valid()) continue;
    ++faced;
    CHECK(is_at_border);
    auto ends = chains.ends_of_chain(e);
    if (chains.ends_of_piece(e)[0] != edge.vertices[0]) std::swap(ends[0], ends[1]);
    const Point &a = mesh.point(ends[1]), &b = mesh.point(ends[0]), &c = mesh.point(edge.outer_vertex);
    CHECK(is_left(a, b, c));
    CHECK(is_empty(pslg, a, b, c));
  }
  CHECK(at_border == sides.size()); // with the domain on the left
  return faced;
}

/// A triangle below a side from (0, 0) to (8, 0), which a vertex divides, and an input vertex above the side.
struct Divided_side {
  Mesh mesh;
  static constexpr std::size_t left_piece = 0, right_piece = 1;

  Divided_side() {
    mesh.number_of_input_vertices = 4;
    for (const Point& p : {Point(0, 0), Point(8, 0), Point(4, -4), Point(4, 4), Point(4, 0)})
      mesh.points.push_back(p);
    const Vertex_index a(0), b(1), below(2), above(3), middle(4);
    mesh.triangles = {{a, below, middle}, {below, b, middle}};
    using Segment_index = Mesh::Segment_index;
    mesh.constrained_edges = {{{middle, a}, Segment_index(0), 0, above},
                              {{b, middle}, Segment_index(0), 0, above}};
    mesh.segment_of_vertex.assign(5, Segment_index());
    mesh.segment_of_vertex[4] = Segment_index(0);
  }

  bool is_in_room(const Point& p) {
    mesh.points[4] = p;
    const Chains chains(mesh);
    const Rooms rooms(mesh, chains);
    const std::size_t beyond = rooms.number_of_vertices_beyond(left_piece);
    CHECK(beyond == rooms.number_of_vertices_beyond(right_piece));
    return beyond == 0;
  }
};

} // namespace

TEST_CASE("what faces the border from the outside is a triangle in which nothing is", "[rooms]") {
  const std::uint64_t seeds = is_full_run() ? 50 : 1;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      CAPTURE(family.name, seed);
      const Pslg pslg = family.make(seed);
      check_what_faces_the_border(mesher_test::Mesher()(pslg), pslg);
    }
}

TEST_CASE("nothing faces the border of a convex domain, and something a gap", "[rooms]") {
  const Pslg square = read("syn_square.poly"), gap = read("hard_round_gap_outside.poly");
  CHECK(check_what_faces_the_border(mesher_test::Mesher()(square), square) == 0);
  CHECK(check_what_faces_the_border(mesher_test::Mesher()(gap), gap) > 0);
}

TEST_CASE("edges of the border that are nearly on a line have room outside", "[rooms]") {
  const Pslg pslg = read("hard_flat_gap_outside.poly");
  const auto run = mesher_test::run_to_the_bound(pslg, mesher_test::Options());
  check_what_faces_the_border(run.mesh, pslg);
}

TEST_CASE("a vertex of the border is on the inner side of its segment, or in its room", "[rooms]") {
  Divided_side side;
  for (const Point& p : {Point(4, 0), Point(1, 0), Point(4, -1), Point(1, -0.5), Point(4, 1), Point(1, 0.25)})
    CHECK(side.is_in_room(p));
  for (const Point& p : {Point(4, 2), Point(4, 4), Point(4, 9), Point(1, 1), Point(7.5, 0.5)})
    CHECK_FALSE(side.is_in_room(p));
  CHECK(side.is_in_room(Point(0, 0))); // as if merged with an end
}

TEST_CASE("rooms at all scales", "[rooms]") {
  for (const int exponent : {-1000, -500, 0, 500, 1000}) {
    CAPTURE(exponent);
    Divided_side side;
    for (Point& p : side.mesh.points) p = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent));
    CHECK(side.is_in_room(Point(std::ldexp(4.0, exponent), std::ldexp(1.0, exponent))));
    CHECK_FALSE(side.is_in_room(Point(std::ldexp(4.0, exponent), std::ldexp(2.0, exponent))));
  }
}

} // namespace test_outer_rooms
