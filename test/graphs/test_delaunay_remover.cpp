// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertices are inserted into a constrained Delaunay triangulation and removed again, in another order: the
// triangulation has as many triangles as before, at each time all of them are counterclockwise and Delaunay, and edges
// are whole.

#include "catch.h"
#include "random_pslg_shapes.h"
#include "separation_test_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/refinement/Delaunay_remover.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_delaunay_remover {

namespace {

using namespace separation_test;
using Prepared = Prepared_graph<CGAL::Filtered_quadtree_traits_2<>>;
using Geometry = Prepared::Geometry;
using Mesh = internal::Kernel_mesh<Geometry>;
using internal::Edge_id;
using internal::Side;
using internal::Triangle_id;
using internal::Vertex_id;

/// Whether sides know each other, and vertices a triangle.
bool is_linked(const Mesh& mesh) {
  for (const Triangle_id t : mesh.triangles.ids()) {
    if (!mesh.is_alive(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const Vertex_id v = mesh.triangle(t).v[k];
      const Side o = mesh.triangle(t).side[k];
      if (!o.is_border() && mesh.across(Side(o.triangle(), o.slot())).triangle() != t) return false;
      if (!mesh.is_used(v) || !mesh.is_alive(mesh.incident_triangle(v))) return false;
    }
  }
  return true;
}

bool is_constrained_Delaunay(const Mesh& mesh) { return is_linked(mesh) && !flaws_of(mesh).is_any(); }

/// Inserts points of a lattice: many are on circles and lines with each other.
std::vector<Vertex_id> insert_lattice(Prepared& graph, int size) {
  Mesh& mesh = graph.state().mesh;
  std::vector<Vertex_id> inserted;
  for (int i = 0; i <= size; ++i)
    for (int j = 0; j <= size; ++j) {
      const auto p = graph.map().to_kernel({double(i) / size, double(j) / size});
      for (const Triangle_id t : mesh.triangles.ids()) {
        if (!mesh.is_alive(t)) continue;
        const auto& r = mesh.triangle(t);
        const auto is_inside = [&](int k) {
          return Geometry::orientation(mesh.point(r.v[internal::next_slot[k]]),
                                       mesh.point(r.v[internal::previous_slot[k]]), p) > 0;
        };
        if (!is_inside(0) || !is_inside(1) || !is_inside(2)) continue;
        inserted.push_back(mesh.add_vertex(p, internal::free_vertex));
        mesh.insert_in_triangle(t, inserted.back());
        break;
      }
    }
  return inserted;
}

/// Inserts vertices on all edges, at places that rounding puts beside them.
void insert_on_edges(Prepared& graph, std::vector<Vertex_id>& inserted) {
  Mesh& mesh = graph.state().mesh;
  for (const Edge_id e : graph.problem().edges.ids()) {
    Vertex_id a = graph.problem().edges[e].a;
    const Vertex_id b = graph.problem().edges[e].b;
    for (const double share : {1. / 3, .5, .7}) { // of what is left
      const Side s = graph.state().side_between(a, b);
      if (s.is_border()) break; // outside of the domain
      const auto p = Geometry::between(mesh.point(a), mesh.point(b), share);
      const Side o = mesh.across(s);
      const auto has_room = [&](Side at) {
        const auto& apex = mesh.point(mesh.opposite(at));
        return Geometry::orientation(apex, mesh.point(mesh.source(at)), p) > 0 &&
               Geometry::orientation(apex, p, mesh.point(mesh.target(at))) > 0;
      };
      if (!has_room(s) || (!o.is_border() && !has_room(o))) break;
      const Vertex_id v = mesh.add_vertex(p, e);
      mesh.insert_on_side(s.triangle(), s.slot(), v);
      inserted.push_back(v);
      a = v;
    }
  }
}

/// \returns the number of vertices removed
std::size_t check_removal(const Prepared::Pslg& pslg, std::uint64_t seed) {
  Prepared graph(pslg);
  Mesh& mesh = graph.state().mesh;
  const std::size_t triangles = mesh.number_of_triangles();
  std::vector<Vertex_id> inserted = insert_lattice(graph, 8);
  insert_on_edges(graph, inserted);
  REQUIRE(is_constrained_Delaunay(mesh));
  std::shuffle(inserted.begin(), inserted.end(), std::mt19937_64(seed));
  internal::Delaunay_remover<Geometry> remover(mesh);
  const std::size_t step = is_full_run() ? 1 : 16; // of looks at all triangles
  for (std::size_t i = 0; i < inserted.size(); ++i) {
    REQUIRE(remover.remove(inserted[i]));
    REQUIRE_FALSE(mesh.is_used(inserted[i]));
    if (i % step == 0) REQUIRE(is_constrained_Delaunay(mesh));
  }
  CHECK(is_constrained_Delaunay(mesh));
  CHECK(mesh.number_of_triangles() == triangles);
  for (const Edge_id e : graph.problem().edges.ids()) {
    const auto& edge = graph.problem().edges[e];
    const Side s = mesh.is_used(edge.a) && mesh.is_used(edge.b) ? mesh.find_side(edge.a, edge.b) : Side();
    CHECK((s.is_border() || mesh.across(s).is_constrained()));
  }
  return inserted.size();
}

} // namespace

TEST_CASE("Vertices inserted into a triangulation are removed again", "[mesher]") {
  std::size_t removed = 0;
  for (const auto& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < (is_full_run() ? 20 : 2); ++seed) {
      CAPTURE(family.name, seed);
      removed += check_removal(family.make(seed), seed);
    }
  CHECK(removed > 100);
}

} // namespace test_delaunay_remover
