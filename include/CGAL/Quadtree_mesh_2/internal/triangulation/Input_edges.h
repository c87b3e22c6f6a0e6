// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The input edges by vertex. An input edge is a piece of an input segment between consecutive input vertices.
// Vertices are named by their input numbers, which are the same in every block.
//
// The edges are sorted by their lesser vertex, and then by the other. A list of them by the greater one has the other
// edges of a vertex; it is made on request. It takes O(n) to make them, and O(log degree) to look up.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_INPUT_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_INPUT_EDGES_H

#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
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
  };

  /// The edges at a vertex, by their other end.
  class Incidences {
  public:
    class iterator {
    public:
      iterator(const Incidences& of, std::size_t i) : of_(&of), i_(i) {}
      Incidence operator*() const { return (*of_)[i_]; }
      iterator& operator++() {
        ++i_;
        return *this;
      }
      friend bool operator!=(iterator a, iterator b) { return a.i_ != b.i_; }

    private:
      const Incidences* of_;
      std::size_t i_;
    };

    Incidences(const Input_edges& edges, Vertex_id v)
        : edges_(edges), as_greater_(edges.first_as_greater_[v]), first_(edges.first_[v]) {
      const Vertex_id next(v.value() + 1);
      number_as_greater_ = edges.first_as_greater_[next] - as_greater_;
      size_ = number_as_greater_ + edges.first_[next] - first_;
    }

    std::size_t size() const { return size_; }
    iterator begin() const { return {*this, 0}; }
    iterator end() const { return {*this, size_}; }
    Incidence operator[](std::size_t i) const {
      if (i < number_as_greater_) {
        const Edge_id e = edges_.as_greater_[as_greater_ + i];
        return {edges_[e].a, e};
      }
      const Edge_id e(first_ + (i - number_as_greater_));
      return {edges_[e].b, e};
    }

  private:
    const Input_edges& edges_;
    std::size_t as_greater_, first_, number_as_greater_, size_;
  };

  Input_edges() = default;

  /// Edges get their handles in the order of their lesser vertex, `a` from now on, and then of the other.
  Input_edges(const Input_edge_list& edges, std::size_t number_of_vertices) {
    name_edges(number_of_vertices, [&edges](const auto& f) {
      for_each_index<Chosen_tag>(edges.size(), [&](std::size_t i) { f(edges[i]); });
    });
  }
  Input_edges(const Edges_of_segments& edges, std::size_t number_of_vertices) {
    name_edges(number_of_vertices, [&edges](const auto& f) { edges.for_each(f); });
  }

  /// Lists the edges by vertex, as `at()` needs it. O(n) time and memory; nothing if they are listed.
  void list_by_vertices() {
    if (first_as_greater_.empty() && !first_.empty()) list_by_greater_vertex(first_.size() - 1);
  }

  /// Writes or reads them (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(edges_, first_);
    if (Archive::is_reading) free_arrays(as_greater_, first_as_greater_);
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

  /// \pre edges are listed by vertices
  Incidences at(Vertex_id v) const { return {*this, v}; }

  /// The edge between two input vertices, if there is one.
  Edge_id between(Vertex_id a, Vertex_id b) const {
    if (b < a) std::swap(a, b);
    const Input_edge* const end = edges_.data() + first_[Vertex_id(a.value() + 1)];
    const Input_edge* const e = std::lower_bound(
        edges_.data() + first_[a], end, b, [](const Input_edge& edge, Vertex_id v) { return edge.b < v; });
    return e != end && e->b == b ? Edge_id(static_cast<std::size_t>(e - edges_.data())) : Edge_id();
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
  using Firsts = Uninitialized_indexed_vector<Vertex_id, std::uint32_t>;

  Uninitialized_indexed_vector<Edge_id, Input_edge> edges_;
  Firsts first_; // of the edges of which a vertex is the lesser end; and the end of the last one's
  // None until they are wanted:
  Uninitialized_vector<Edge_id> as_greater_; // by the greater end, and then by the lesser one
  Firsts first_as_greater_;

  /// Where the runs begin, and the last one ends.
  static Firsts firsts(const Run_counters& runs) {
    Firsts first(runs.size() + 1);
    first[Vertex_id(0)] = 0;
    for_each_index<Chosen_tag>(runs.size(), [&](std::size_t v) {
      first[static_cast<Vertex_id>(v + 1)] = static_cast<std::uint32_t>(runs.end(v));
    });
    return first;
  }

  /// Sorts the values of each vertex.
  template <class Value, class Less>
  static void sort_runs(Value* values, const Firsts& first, const Less& less) {
    for_each_index<Chosen_tag>(first.size() - 1, [&](std::size_t v) {
      sort_short_run(values + first[Vertex_id(v)], values + first[Vertex_id(v + 1)], less);
    });
  }

  /// \param for_each calls a function for each edge
  template <class For_each>
  void name_edges(std::size_t number_of_vertices, const For_each& for_each) {
    Run_counters at(number_of_vertices);
    const auto lesser = [](const Input_edge& e) { return std::size_t(std::min(e.a, e.b)); };
    for_each([&](const Input_edge& e) { at.count(lesser(e)); });
    edges_.resize(at.begin_placing());
    for_each([&](const Input_edge& e) {
      edges_[Edge_id(at.place(lesser(e)))] = {std::min(e.a, e.b), std::max(e.a, e.b), e.segment};
    });
    first_ = firsts(at);
    sort_runs(edges_.data(), first_, [](const Input_edge& e, const Input_edge& f) { return e.b < f.b; });
  }

  void list_by_greater_vertex(std::size_t number_of_vertices) {
    Run_counters at(number_of_vertices);
    for_each_index<Chosen_tag>(size(), [&](std::size_t i) { at.count(std::size_t(edges_[Edge_id(i)].b)); });
    as_greater_.resize(at.begin_placing());
    for_each_index<Chosen_tag>(size(), [&](std::size_t i) {
      as_greater_[at.place(std::size_t(edges_[Edge_id(i)].b))] = static_cast<Edge_id>(i);
    });
    first_as_greater_ = firsts(at);
    sort_runs(as_greater_.data(), first_as_greater_, std::less<>());
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_INPUT_EDGES_H
