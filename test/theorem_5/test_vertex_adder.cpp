// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertices that are added where placed vertices miss the bound: each cures its triangle and makes no other one miss it.

#include "catch.h"
#include "random_pslg_shapes.h"
#include "separation_test_tools.h"

#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Local_cures.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_insertion.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Tree_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Vertex_adder.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_vertex_adder {

namespace {

using namespace separation_test;
using internal::Triangle_id;
using internal::Vertex_id;

template <class Geometry>
std::vector<Triangle_id> missed_in(const internal::Meshing_state<Geometry>& state) {
  return internal::missed_triangles<CGAL::Sequential_tag>(state);
}

/// What adding vertices did to the mesh of a graph.
struct Count {
  std::size_t missed = 0, added = 0, on_edges = 0;
};

/// Places the vertices of a graph, and adds others for all triangles below the bound.
template <class Traits>
Count check_additions(const typename Prepared_graph<Traits>::Pslg& pslg) {
  using Geometry = typename Prepared_graph<Traits>::Geometry;
  Prepared_graph<Traits> graph(pslg);
  auto& state = graph.state();
  const Tree_options options = Tree_options::of_theorem();
  const auto trees = graph.trees(options);
  const auto domain = state.mesh;
  const auto triangles = internal::Edge_triangles<Geometry>::template of<CGAL::Sequential_tag>(
      domain, graph.problem().edges, graph.problem().input_points.size());
  const auto placed = internal::Tree_placement<Traits, CGAL::Sequential_tag>(
                          graph.problem(), trees, triangles, internal::Placement_scope())
                          .run();
  internal::Placed_insertion<CGAL::Sequential_tag, Geometry>(state, placed, triangles).run();

  internal::Vertex_adder<Geometry> adder(state);
  const auto missed = missed_in(state);
  Count count{missed.size(), 0, 0};
  std::size_t left = missed.size();
  for (const Triangle_id t : missed) {
    if (!internal::is_missed(state, t)) continue;
    const std::size_t vertices = state.mesh.number_of_vertices();
    if (!adder.insert_for(t)) {
      CHECK(state.mesh.number_of_vertices() == vertices);
      CHECK(internal::is_missed(state, t));
      continue;
    }
    ++count.added;
    const Vertex_id v(vertices);
    REQUIRE(state.mesh.number_of_vertices() == vertices + 1);
    REQUIRE(state.mesh.is_used(v));
    count.on_edges += state.mesh.is_free(v) ? 0 : 1;
    state.mesh.for_each_triangle_at(v, [&](Triangle_id u, int) {
      CHECK_FALSE(state.bounds.is_sharp(state.mesh.shape(state.mesh.triangle(u))));
    });
    const std::size_t now = missed_in(state).size();
    CHECK(now < left);
    left = now;
  }
  CHECK_FALSE(flaws_of(state.mesh).is_any());
  return count;
}

template <class Traits>
typename Prepared_graph<Traits>::Pslg converted(const random_pslg::Pslg& pslg) {
  typename Prepared_graph<Traits>::Pslg other;
  for (const auto& p : pslg.vertices) other.add_vertex({p.x(), p.y()});
  other.segments = pslg.segments;
  other.holes.clear();
  for (const auto& p : pslg.holes) other.holes.push_back({p.x(), p.y()});
  return other;
}

} // namespace

TEST_CASE("Vertices that are added cure triangles and harm none", "[theorem5]") {
  Count all;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      CAPTURE(family.name, seed);
      const Count count = check_additions<CGAL::Filtered_quadtree_traits_2<>>(family.make(seed));
      all.missed += count.missed, all.added += count.added, all.on_edges += count.on_edges;
    }
  CAPTURE(all.missed, all.added, all.on_edges);
  CHECK(all.added > 100);
  CHECK(all.on_edges > 10);
}

TEST_CASE("Vertices that are added do so with exact coordinates", "[theorem5]") {
  using Traits = CGAL::Exact_quadtree_traits_2<>;
  std::size_t added = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 0; seed < 1; ++seed) {
      CAPTURE(family.name, seed);
      added += check_additions<Traits>(converted<Traits>(family.make(seed))).added;
    }
  CHECK(added > 0);
}

} // namespace test_vertex_adder
