// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The input edges by vertex. An input edge is a piece of an input segment between consecutive input vertices.
// Vertices are named by their input numbers, which are the same in every block.
//
// One array of (neighbor, edge) pairs, grouped by vertex and sorted by neighbor. It takes O(n) to make, and
// O(log degree) to look up.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_INPUT_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_INPUT_EDGES_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_short_run.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/Run_counters.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Segment_inserter.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Input_edges {
public:
  struct Incidence {
    Vertex_id neighbor;
    Edge_id edge;
    friend bool operator<(const Incidence& a, const Incidence& b) { return a.neighbor < b.neighbor; }
  };

  Input_edges() = default;

  /// Edges get their handles in the order of their lesser vertex, `a` from now on, and then of the other.
  Input_edges(const Input_edge_list& edges, std::size_t number_of_vertices)
      : edges_(edges.size()), first_(number_of_vertices + 1), incidences_(2 * edges.size()) {
    collect_incidences(edges, number_of_vertices);
    for_each_index<Chosen_tag>(number_of_vertices, [this](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      sort_short_run(begin(v), end(v), std::less<>());
    });
    name_edges(edges, number_of_vertices);
  }

  /// Writes or reads them (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(edges_, first_, incidences_);
  }

  /// Lets each of these edges belong to the first of the segments that run there.
  void repeat(const Input_edge_list& repeated) {
    for (const Input_edge& r : repeated) {
      Input_edge& e = edges_[between(r.a, r.b)];
      e.segment = std::min(e.segment, r.segment);
    }
  }

  Id_range<Edge_id> ids() const { return edges_.ids(); }
  Edge_id end_id() const { return edges_.end_id(); }
  std::size_t size() const { return edges_.size(); }
  const Input_edge& operator[](Edge_id e) const { return edges_[e]; }
  Vertex_id other_end(Edge_id e, Vertex_id v) const {
    return (*this)[e].a == v ? (*this)[e].b : (*this)[e].a;
  }

  const Incidence* begin(Vertex_id v) const { return incidences_.data() + first_[v]; }
  const Incidence* end(Vertex_id v) const { return incidences_.data() + first_[++v]; }

  /// The edge between two input vertices, if there is one.
  Edge_id between(Vertex_id a, Vertex_id b) const {
    const Incidence* i = std::lower_bound(begin(a), end(a), Incidence{b, {}});
    return i != end(a) && i->neighbor == b ? i->edge : Edge_id();
  }

  /// The input edge that carries the constrained mesh edge x-y; none if it is on none (then it is a chord across a
  /// corner).
  template <class Mesh>
  Edge_id carrying(const Mesh& mesh, Vertex_id x, Vertex_id y) const {
    if (mesh.is_input(x) && mesh.is_input(y)) return between(mesh.input_number(x), mesh.input_number(y));
    const Edge_id e = mesh.edge(x).is_valid() ? mesh.edge(x) : mesh.edge(y);
    return is_on(mesh, x, e) && is_on(mesh, y, e) ? e : Edge_id();
  }

  template <class Mesh>
  bool is_on(const Mesh& mesh, Vertex_id v, Edge_id e) const {
    if (!e.is_valid()) return false;
    if (!mesh.is_input(v)) return mesh.edge(v) == e;
    const Vertex_id number = mesh.input_number(v);
    return (*this)[e].a == number || (*this)[e].b == number;
  }

private:
  Uninitialized_indexed_vector<Edge_id, Input_edge> edges_;
  Uninitialized_indexed_vector<Vertex_id, std::uint32_t> first_; // and the end of the last one's
  Uninitialized_vector<Incidence> incidences_;

  Incidence* begin(Vertex_id v) { return incidences_.data() + first_[v]; }
  Incidence* end(Vertex_id v) { return incidences_.data() + first_[++v]; }

  /// Those of a vertex in any order.
  void collect_incidences(const Input_edge_list& edges, std::size_t number_of_vertices) {
    Run_counters at(number_of_vertices);
    for_each_index<Chosen_tag>(edges.size(), [&](std::size_t i) {
      at.count(std::size_t(edges[i].a)), at.count(std::size_t(edges[i].b));
    });
    at.begin_placing();
    for_each_index<Chosen_tag>(edges.size(), [&](std::size_t i) {
      const Input_edge& e = edges[i];
      incidences_[at.place(std::size_t(e.a))] = {e.b, static_cast<Edge_id>(i)};
      incidences_[at.place(std::size_t(e.b))] = {e.a, static_cast<Edge_id>(i)};
    });
    first_[Vertex_id(0)] = 0;
    for_each_index<Chosen_tag>(number_of_vertices, [&](std::size_t v) {
      first_[static_cast<Vertex_id>(v + 1)] = static_cast<std::uint32_t>(at.end(v));
    });
  }

  /// Where the edges begin of which v is the lesser vertex.
  Incidence* begin_of_lesser(Vertex_id v) {
    return std::lower_bound(begin(v), end(v), v,
                            [](const Incidence& i, Vertex_id w) { return i.neighbor < w; });
  }

  void name_edges(const Input_edge_list& edges, std::size_t number_of_vertices) {
    Uninitialized_indexed_vector<Edge_id, Edge_id> new_id(edges.size());
    count_allocate_and_place<Chosen_tag>(
        number_of_vertices,
        [&](std::size_t first, std::size_t last) {
          std::size_t count = 0;
          for (const Vertex_id v : Id_range<Vertex_id>(first, last))
            count += static_cast<std::size_t>(end(v) - begin_of_lesser(v));
          return count;
        },
        [](std::size_t) {},
        [&](std::size_t first, std::size_t last, std::size_t number) {
          for (const Vertex_id v : Id_range<Vertex_id>(first, last))
            for (const Incidence* i = begin_of_lesser(v); i != end(v); ++i, ++number) {
              const Edge_id e = static_cast<Edge_id>(number);
              edges_[e] = {v, i->neighbor, edges[std::size_t(i->edge)].segment};
              new_id[i->edge] = e;
            }
        });
    for_each_index<Chosen_tag>(incidences_.size(),
                               [&](std::size_t i) { incidences_[i].edge = new_id[incidences_[i].edge]; });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_INPUT_EDGES_H
