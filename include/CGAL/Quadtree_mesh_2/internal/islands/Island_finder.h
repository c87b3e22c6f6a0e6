// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where refinement on demand does not come to rest.
//
// Computes: the islands of a mesh that refinement left when its budget was spent. An island is a component of the
//           domain that has bad triangles, and more than its share of the vertices: more than the whole mesh has,
//           compared with what either was expected to have. Where no component is such, all with bad triangles are.
// Bound:    O(n) for the mesh, and the estimate of size (Size_estimate.h) for components that are worked on.
// Source:   ours. If all that is left has its share at most, something else has taken more than its own and come to
//           rest: it was estimated too low. Then nothing says which of those that are left would not come to rest.
//
// What is found depends on the mesh alone, so it is the same for any number of threads.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_FINDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_FINDER_H

#include <CGAL/Quadtree_mesh_2/internal/islands/Island.h>
#include <CGAL/Quadtree_mesh_2/internal/islands/Mesh_components.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Some components of a mesh, by their triangles.
struct Unsettled_islands {
  std::size_t number = 0;
  std::vector<Triangle_id> triangles;
};

template <class ConcurrencyTag, class Geometry>
class Island_finder {
public:
  using State = Meshing_state<Geometry>;

  /// \param share the vertices that a part may have, for each that it is expected to have; 0: any are too many
  Island_finder(const State& state, const Edge_sides& sides, double share)
      : state_(state), sides_(sides), share_(share), components_(state.mesh),
        inserted_(components_.size(), 0) {
    for (const Vertex_id v : state.mesh.points.ids())
      if (state.mesh.is_used(v) && !state.mesh.is_input(v))
        ++inserted_[components_.component_of(state.mesh.incident_triangle(v))];
  }

  /// \param is_done for each edge of the graph whether its component is none to be found
  Unsettled_islands run(const Indexed_vector<Edge_id, char>& is_done) const {
    std::vector<Mesh_component_id> unsettled, islands;
    for (const Mesh_component_id c : components_.ids())
      if (is_unsettled(c) && !has_any_edge(c, is_done)) unsettled.push_back(c);
    std::copy_if(unsettled.begin(), unsettled.end(), std::back_inserter(islands),
                 [this](Mesh_component_id c) { return has_more_than_its_share(c); });
    return triangles_of(islands.empty() ? unsettled : islands);
  }

private:
  const State& state_;
  const Edge_sides& sides_;
  double share_;
  Mesh_components components_;
  Indexed_vector<Mesh_component_id, std::size_t> inserted_; // vertices

  bool is_unsettled(Mesh_component_id c) const {
    const auto triangles = components_.triangles_of(c);
    return std::any_of(triangles.begin(), triangles.end(),
                       [this](Triangle_id t) { return state_.is_bad(t); });
  }

  bool has_any_edge(Mesh_component_id c, const Indexed_vector<Edge_id, char>& edges) const {
    const auto& mesh = state_.mesh;
    const auto triangles = components_.triangles_of(c);
    return std::any_of(triangles.begin(), triangles.end(), [&](Triangle_id t) {
      for (int k = 0; k < 3; ++k) {
        const Side s(t, k);
        if (!mesh.across(s).is_constrained()) continue;
        const Edge_id e = state_.edges.carrying(mesh, mesh.source(s), mesh.target(s));
        if (e.is_valid() && edges[e] != 0) return true;
      }
      return false;
    });
  }

  bool has_more_than_its_share(Mesh_component_id c) const {
    if (share_ == 0) return true;
    if (inserted_[c] == 0) return false;
    const Island<ConcurrencyTag, Geometry> island(state_, sides_, triangles_of({c}).triangles);
    return static_cast<double>(island.number_of_vertices() + inserted_[c]) >
           share_ * island.expected_vertices();
  }

  Unsettled_islands triangles_of(const std::vector<Mesh_component_id>& components) const {
    Unsettled_islands islands{components.size(), {}};
    for (const Mesh_component_id c : components) {
      const auto triangles = components_.triangles_of(c);
      islands.triangles.insert(islands.triangles.end(), triangles.begin(), triangles.end());
    }
    return islands;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_FINDER_H
