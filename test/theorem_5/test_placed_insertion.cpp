// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Placed vertices in the triangulation of the domain: which corners of leaves are in it, what gives way where vertices
// coincide, and that the mesh is constrained Delaunay.

#include "catch.h"
#include "random_pslg_shapes.h"
#include "separation_test_tools.h"
#include "tiny_blocks.h"

#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Corner_location.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_insertion.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Tree_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/triangulate_domain.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_placed_insertion {

namespace {

using namespace separation_test;
using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Prepared = Prepared_graph<Traits>;
using Geometry = Prepared::Geometry;
using Point = Geometry::Point;
using Placed = internal::Placed_vertices<Geometry>;
using Mesh = internal::Kernel_mesh<Geometry>;
using Triangles = internal::Edge_triangles<Geometry>;
using internal::Edge_id;
using internal::Side;
using internal::Triangle_id;
using internal::Vertex_id;

Triangles triangles_of(const Prepared& graph, const Mesh& domain) {
  return Triangles::of<CGAL::Sequential_tag>(domain, graph.problem().edges,
                                             graph.problem().input_points.size());
}

/// The area of the mesh in the graph's coordinates.
double area(const Prepared& graph, const Mesh& mesh) {
  const double unit = graph.map().length_to_kernel(1);
  double sum = 0;
  for (const Triangle_id t : mesh.triangles.ids())
    if (mesh.is_alive(t)) sum += mesh.shape(mesh.triangle(t)).area2 / 2 / (unit * unit);
  return sum;
}

bool has_place(const Mesh& mesh, Triangle_id t, const Point& p) {
  for (int k = 0; k < 3; ++k)
    if (internal::is_behind_side(mesh, mesh.triangle(t), k, p)) return false;
  return true;
}

/// Looks at all triangles.
bool is_in_domain(const Mesh& domain, const Point& p) {
  for (const Triangle_id t : domain.triangles.ids())
    if (has_place(domain, t, p)) return true;
  return false;
}

void check_that_corners_are_located(Prepared& graph) {
  const Tree_options options;
  const auto trees = graph.trees(options);
  const Mesh& domain = graph.state().mesh;
  const Triangles triangles = triangles_of(graph, domain);
  using Location = internal::Corner_location<Traits, CGAL::Sequential_tag>;
  const Location::Corners corners(trees.tree());
  const Location location(graph.problem(), trees, corners, triangles, internal::Placement_scope());
  std::size_t missed = 0, elsewhere = 0;
  for (std::size_t c = 0; c < corners.number_of_names(); ++c) {
    if (!corners.exists(c)) continue;
    const Point p = trees.kernel_point(corners.place(c));
    const Triangle_id t = location(c);
    const bool is_inside = is_in_domain(domain, p);
    missed += is_inside && !t.is_valid() ? 1 : 0;
    elsewhere += t.is_valid() && !has_place(domain, t, p) ? 1 : 0;
  }
  CHECK(missed == 0);
  CHECK(elsewhere == 0);
}

void check_that_all_are_inserted(const Prepared& graph, const Placed& placed, const Mesh& mesh) {
  for (const auto& run : placed.runs) {
    Vertex_id last = graph.problem().edges[run.edge].a;
    for (const Vertex_id v : run.vertices()) {
      REQUIRE(mesh.is_used(v));
      const Side s = mesh.find_side(last, v);
      REQUIRE_FALSE(s.is_border());
      CHECK(mesh.across(s).is_constrained());
      last = v;
    }
  }
  for (std::size_t v = placed.first_corner.value(); v < placed.points.size(); ++v)
    CHECK(mesh.is_used(Vertex_id(v)));
}

/// \returns the number of blocks
template <class Tag>
std::size_t check_insertion(Prepared& graph) {
  const Tree_options options = Tree_options().distances(0.7, 0.5);
  const auto trees = graph.trees(options);
  const Mesh domain = graph.state().mesh;
  const double area_of_domain = area(graph, domain);
  const Triangles triangles = triangles_of(graph, domain);
  const Placed placed = internal::Tree_placement<Traits, CGAL::Sequential_tag>(
                            graph.problem(), trees, triangles, internal::Placement_scope())
                            .run();
  auto& blocks = graph.state().problem.vertex_blocks;
  blocks =
      internal::blocks_by_number(graph.problem().input_points.size(), internal::Block_sizes<Tag>::vertices);
  internal::Placed_insertion<Tag, Geometry>(graph.state(), placed, triangles).run();
  const Mesh& mesh = graph.state().mesh;
  CHECK(mesh.number_of_vertices() == placed.points.size());
  CHECK(area(graph, mesh) == Approx(area_of_domain));
  CHECK_FALSE(flaws_of(mesh).is_any());
  check_that_all_are_inserted(graph, placed, mesh);
  return blocks.size();
}

/// The unit square with a segment in it, from vertex 4 to vertex 5.
Prepared::Pslg square_with_segment() {
  return pslg_test::make_pslg<double>({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {.25, .5}, {.75, .5}},
                                      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
}

/// A frame around a hole, which is a region with a label.
Prepared::Pslg frame() {
  auto pslg = pslg_test::make_pslg<double>(
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {.25, .25}, {.75, .25}, {.75, .75}, {.25, .75}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}});
  pslg.holes.push_back({.5, .5});
  return pslg;
}

} // namespace

TEST_CASE("Corners of leaves are in the domain or not", "[theorem5]") {
  for (const auto& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < (is_full_run() ? 40 : 4); ++seed) {
      CAPTURE(family.name, seed);
      Prepared graph(family.make(seed));
      check_that_corners_are_located(graph);
    }
  for (std::uint64_t seed = 0; seed < (is_full_run() ? 100 : 10); ++seed) {
    CAPTURE(seed);
    Prepared graph(random_pslg::polygon(seed));
    check_that_corners_are_located(graph);
  }
  Prepared graph(frame());
  check_that_corners_are_located(graph);
}

TEST_CASE("A walk along a segment ends in the triangle with its end, or at the border", "[theorem5]") {
  for (std::uint64_t seed = 0; seed < (is_full_run() ? 200 : 20); ++seed) {
    CAPTURE(seed);
    Prepared graph(random_pslg::polygon(seed));
    const Mesh& domain = graph.state().mesh;
    random_pslg::Random random(seed);
    std::size_t wrong = 0;
    for (const Triangle_id t : domain.triangles.ids())
      for (const Vertex_id v : domain.triangle(t).v) {
        const Point q = graph.map().to_kernel({random.between(0, 1), random.between(0, 1)});
        const auto end = walk_along(domain, t, domain.point(v), q);
        const bool is_right =
            end.is_blocked()
                ? domain.triangle(end.triangle).side[end.blocked_slot].is_border() &&
                      internal::is_behind_side(domain, domain.triangle(end.triangle), end.blocked_slot, q)
                : has_place(domain, end.triangle, q);
        wrong += is_right ? 0 : 1;
      }
    CHECK(wrong == 0);
  }
}

TEST_CASE("Placed vertices make a constrained Delaunay triangulation of the domain", "[theorem5]") {
  std::size_t cut = 0;
  for (const auto& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < (is_full_run() ? 40 : 4); ++seed) {
      CAPTURE(family.name, seed);
      Prepared graph(family.make(seed)), in_blocks(family.make(seed));
      check_insertion<CGAL::Sequential_tag>(graph);
      if (check_insertion<Tiny_blocks_tag>(in_blocks) > 1) ++cut;
      CHECK(graph.state().mesh.number_of_triangles() == in_blocks.state().mesh.number_of_triangles());
    }
  CHECK(cut > 0);
}

TEST_CASE("Corners at the place of vertices, or on edges, are left out", "[theorem5]") {
  Prepared graph(square_with_segment());
  const Mesh domain = graph.state().mesh;
  const Triangles triangles = triangles_of(graph, domain);
  Placed placed(graph.problem().input_points);
  placed.first_corner = placed.points.end_id();
  for (const auto& p : {std::array{.25, .5}, {.5, .5}, {0., .5}, {.5, .25}, {.5, .25}}) {
    placed.points.push_back(graph.map().to_kernel({p[0], p[1]}));
    placed.role_of.push_back(internal::free_vertex);
    placed.triangle_of_corner.push_back(Triangle_id(0));
  }
  CHECK(internal::Placed_insertion<CGAL::Sequential_tag, Geometry>(graph.state(), placed, triangles)
            .run()
            .empty());
  const Mesh& mesh = graph.state().mesh;
  for (const int v : {0, 1, 2, 3, 4, 5}) CHECK(mesh.is_used(Vertex_id(v)));
  for (const int v : {6, 7, 8}) CHECK_FALSE(mesh.is_used(Vertex_id(v)));
  CHECK(mesh.is_used(Vertex_id(9)) != mesh.is_used(Vertex_id(10)));
  CHECK(area(graph, mesh) == Approx(1));
  CHECK_FALSE(flaws_of(mesh).is_any());
}

TEST_CASE("A vertex on an edge that turns triangles over is left out", "[theorem5]") {
  for (const double y : {-.5, 0.}) { // on or beyond the lower side of the square
    Prepared graph(square_with_segment());
    const Mesh domain = graph.state().mesh;
    const Triangles triangles = triangles_of(graph, domain);
    const Edge_id e = graph.problem().edges.between(Vertex_id(4), Vertex_id(5));
    Placed placed(graph.problem().input_points);
    placed.runs.push_back({e, placed.points.end_id(), 1});
    placed.points.push_back(graph.map().to_kernel({.5, y}));
    placed.role_of.push_back(e);
    placed.first_corner = placed.points.end_id();
    const auto cramped =
        internal::Placed_insertion<CGAL::Sequential_tag, Geometry>(graph.state(), placed, triangles).run();
    CHECK(cramped == std::vector<Edge_id>{e});
    CHECK_FALSE(graph.state().mesh.is_used(Vertex_id(6)));
    CHECK(graph.state().mesh.number_of_triangles() == domain.number_of_triangles());
  }
}

TEST_CASE("The domain is triangulated again as it was", "[theorem5]") {
  for (const auto& pslg : {frame(), square_with_segment(), random_pslg::polygon(3)}) {
    Prepared graph(pslg);
    const Mesh again = internal::triangulate_domain<CGAL::Sequential_tag>(
        graph.problem(), graph.problem().input_points.values(), graph.sides());
    CHECK(again.number_of_triangles() == graph.state().mesh.number_of_triangles());
    CHECK(area(graph, again) == Approx(area(graph, graph.state().mesh)));
  }
}

} // namespace test_placed_insertion
