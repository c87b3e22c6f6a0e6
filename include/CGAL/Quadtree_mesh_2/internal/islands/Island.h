// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Connected components of a mesh, made a problem of their own.
//
// Computes: the part of the graph that they have, with its own numbers, its first triangulation, its acute corners and
//           the estimate of its size. In the end, the mesh of this problem takes the place of the components.
// Bound:    that of First_triangulation.h for the part, and O(c) for the c corners of the whole.
// Source:   ours.
//
// Nothing but the outside is beyond the border of a component, so what is done within changes no triangle of others.
// What others have beyond the outside is in the way of rounded points on the border all the same. It is known by the
// triangles outside (Meshing_problem.h), whose apexes are kept as points without edges, and are in no triangulation.
//
// Numbers of vertices and edges are in the order that they have in the whole. So the result is the same however the
// components were found.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Corner_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Size_estimate.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/triangulate_domain.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Island {
public:
  using State = Meshing_state<Geometry>;
  using Mesh = Kernel_mesh<Geometry>;

  /// \param triangles of the whole mesh: all those of some components
  Island(const State& whole, const Edge_sides& sides_of_whole, std::vector<Triangle_id> triangles)
      : triangles_(std::move(triangles)) {
    find_features(whole);
    set_problem(whole.problem);
    sides_ = Edge_sides(sides_of_whole, whole_edges_);
    triangulate();
  }
  Island(const Island&) = delete;
  Island& operator=(const Island&) = delete;

  /// The state begins with the first triangulation.
  State& state() { return state_; }
  const Meshing_problem<Geometry>& problem() const { return problem_; }
  const Edge_sides& sides() const { return sides_; }
  /// The handles in the whole of its vertices and edges.
  const std::vector<Vertex_id>& whole_vertices() const { return whole_vertices_; }
  const std::vector<Edge_id>& whole_edges() const { return whole_edges_; }
  std::size_t number_of_vertices() const { return whole_vertices_.size(); }
  /// The vertices that its mesh may be expected to have, and those of them that bounds of size ask for.
  double expected_vertices() const { return static_cast<double>(number_of_vertices()) + triangles_expected_; }
  double expected_of_sizes() const { return triangles_of_sizes_; }

  enum class Bad_triangles { ARE_LISTED, ARE_LEFT };

  /// Replaces its triangles in the whole mesh. Those that miss a bound go to the worklist there, or are left.
  /// \returns the handle of the first of its new vertices, which follow each other as in its mesh
  Vertex_id put_back(State& whole, Bad_triangles bad) const {
    drop_triangles(whole);
    const Vertex_id first_new = whole.mesh.points.end_id();
    const Indexed_vector<Vertex_id, Vertex_id> vertex = name_vertices(whole.mesh);
    const Indexed_vector<Triangle_id, Triangle_id> triangle = name_triangles(whole.mesh);
    for (const Triangle_id t : triangle.ids())
      if (triangle[t].is_valid()) write(whole.mesh, t, vertex, triangle);
    whole.corners.forget_cuts([this](Edge_id e) { return has_edge(e); });
    if (bad == Bad_triangles::ARE_LISTED)
      for (const Triangle_id t : triangle)
        if (t.is_valid() && whole.is_bad(t)) whole.push(t);
    return first_new;
  }

private:
  std::vector<Triangle_id> triangles_;
  std::vector<Vertex_id> whole_vertices_; // sorted
  std::vector<Edge_id> whole_edges_;      // sorted
  Meshing_problem<Geometry> problem_;
  Edge_sides sides_;
  State state_{problem_};
  double triangles_expected_ = 0, triangles_of_sizes_ = 0;

  template <class Id>
  static void sort_out(std::vector<Id>& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }

  void find_features(const State& whole) {
    const Mesh& mesh = whole.mesh;
    for (const Triangle_id t : triangles_)
      for (int k = 0; k < 3; ++k) {
        const Vertex_id v = mesh.triangle(t).v[k];
        if (mesh.is_input(v)) whole_vertices_.push_back(mesh.input_number(v));
        const Side s(t, k);
        if (!mesh.across(s).is_constrained()) continue;
        const Edge_id e = whole.edges.carrying(mesh, mesh.source(s), mesh.target(s));
        if (e.is_valid()) whole_edges_.push_back(e); // else it is a chord across a corner
      }
    sort_out(whole_vertices_), sort_out(whole_edges_);
  }

  bool has_edge(Edge_id whole) const {
    return std::binary_search(whole_edges_.begin(), whole_edges_.end(), whole);
  }

  static std::size_t place_of(Vertex_id v, const std::vector<Vertex_id>& sorted) {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin());
  }

  void set_problem(const Meshing_problem<Geometry>& whole) {
    problem_.bounds = whole.bounds;
    problem_.least_share_of_leg = whole.least_share_of_leg;
    const std::vector<Vertex_id> beyond = apexes_beyond_border(whole);
    for (const Vertex_id v : whole_vertices_) problem_.input_points.push_back(whole.input_point(v));
    for (const Vertex_id v : beyond) problem_.input_points.push_back(whole.input_point(v));
    const auto number = [&](Vertex_id v) {
      const std::size_t i = place_of(v, whole_vertices_);
      return Vertex_id(i < number_of_vertices() && whole_vertices_[i] == v
                           ? i
                           : number_of_vertices() + place_of(v, beyond));
    };
    Input_edge_list edges;
    for (const Edge_id e : whole_edges_)
      edges.push_back({number(whole.edges[e].a), number(whole.edges[e].b), whole.edges[e].segment});
    problem_.edges = Input_edges(edges, problem_.input_points.size()); // which keeps their order
    problem_.edges.list_by_vertices();
    std::vector<Outer_triangle> outer;
    for (const Edge_id e : whole_edges_)
      if (const Outer_triangle t = whole.outer_triangle(e); t.apex.is_valid())
        outer.push_back({number(t.a), number(t.b), number(t.apex)});
    problem_.set_outside(outer);
  }

  /// The vertices of others that face its border from outside.
  std::vector<Vertex_id> apexes_beyond_border(const Meshing_problem<Geometry>& whole) const {
    std::vector<Vertex_id> apexes;
    for (const Edge_id e : whole_edges_) {
      const Vertex_id v = whole.outer_vertex(e);
      if (v.is_valid() && !std::binary_search(whole_vertices_.begin(), whole_vertices_.end(), v))
        apexes.push_back(v);
    }
    sort_out(apexes);
    return apexes;
  }

  void triangulate() {
    const std::vector<typename Geometry::Point> points(problem_.input_points.begin(),
                                                       problem_.input_points.begin() +
                                                           static_cast<std::ptrdiff_t>(number_of_vertices()));
    problem_.vertex_blocks = blocks_by_number(points.size(), Block_sizes<ConcurrencyTag>::vertices);
    state_.mesh = triangulate_domain<ConcurrencyTag>(problem_, points, sides_);
    Size_estimate<Geometry> estimate(state_, ConcurrencyTag());
    triangles_expected_ = estimate.triangles();
    triangles_of_sizes_ = estimate.triangles_of_sizes();
    Corner_finder<ConcurrencyTag, Geometry>(state_, estimate.take_acute_starts()).run();
  }

  // ---- putting back

  /// Input vertices may have a fan in another component, which the mesh may know.
  void drop_triangles(State& whole) const {
    Mesh& mesh = whole.mesh;
    std::vector<Vertex_id> vertices;
    for (const Triangle_id t : triangles_) {
      vertices.insert(vertices.end(), std::begin(mesh.triangle(t).v), std::end(mesh.triangle(t).v));
      if (whole.bulk.has(t)) whole.bulk = {}; // new triangles may get these handles
    }
    for (const Triangle_id t : triangles_) mesh.kill(t);
    for (const Vertex_id v : vertices)
      if (mesh.is_used(v) && !mesh.is_alive(mesh.incident_triangle(v))) mesh.triangle_of[v] = {};
  }

  Indexed_vector<Vertex_id, Vertex_id> name_vertices(Mesh& whole) const {
    const Mesh& mesh = state_.mesh;
    Indexed_vector<Vertex_id, Vertex_id> name(mesh.number_of_vertices());
    std::copy(whole_vertices_.begin(), whole_vertices_.end(), name.begin());
    for (const Vertex_id v : Id_range<Vertex_id>(problem_.input_points.size(), mesh.number_of_vertices())) {
      const Edge_id e = mesh.edge(v);
      name[v] = whole.add_vertex(mesh.point(v),
                                 e.is_valid() ? Vertex_role(whole_edges_[std::size_t(e)]) : free_vertex);
    }
    return name;
  }

  Indexed_vector<Triangle_id, Triangle_id> name_triangles(Mesh& whole) const {
    const Mesh& mesh = state_.mesh;
    Indexed_vector<Triangle_id, Triangle_id> name(mesh.triangles.size());
    for (const Triangle_id t : mesh.triangles.ids())
      if (mesh.is_alive(t)) name[t] = whole.new_triangle();
    return name;
  }

  void write(Mesh& whole, Triangle_id t, const Indexed_vector<Vertex_id, Vertex_id>& vertex,
             const Indexed_vector<Triangle_id, Triangle_id>& triangle) const {
    const auto& from = state_.mesh.triangle(t);
    auto& to = whole.triangle(triangle[t]);
    whole.set_region(triangle[t], state_.mesh.region(t));
    for (int k = 0; k < 3; ++k) {
      to.v[k] = vertex[from.v[k]];
      const Side o = from.side[k];
      to.side[k] = o.is_border() ? o : o.renamed(triangle[o.triangle()]);
      if (!whole.is_used(to.v[k])) whole.triangle_of[to.v[k]] = triangle[t];
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_H
