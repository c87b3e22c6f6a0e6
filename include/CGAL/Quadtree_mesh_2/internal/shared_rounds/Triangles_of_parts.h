// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The triangles of a mesh that parts hold, and its constrained edges, as they will be in the mesh of its user: in the
// order of their least vertices.
//
// Computes: the numbers of triangles and edges, and for each part those that it owns in the end: a run of triangles,
//           and the edges that have their first triangle in it.
// Bound:    O(t) time and memory for the t triangles that a part holds or owns. A triangle's key is sent once to find
//           its number (Key_ranker.h), and its row once to its owner; 36 and 28 bytes for a triangle and an edge.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_TRIANGLES_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_TRIANGLES_OF_PARTS_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Part_completer.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/tell_all.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/mesh_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Handle_owners.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Held_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Key_ranker.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Vertices_of_parts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Exchange, class Point, class Geometry>
class Triangles_of_parts {
public:
  using Held = Held_mesh<Exchange, Geometry>;
  using Vertices = Vertices_of_parts<Exchange, Point, Geometry>;
  using Mesh = Distributed_mesh_2<Point>;
  using Number = typename Mesh::Number;

  Triangles_of_parts(Exchange& exchange, const Meshing_state<Geometry>& state, Held& held, Vertices& vertices)
      : exchange_(exchange), state_(state), mesh_(state.mesh), held_(held), vertices_(vertices) {}

  // All parts call what follows, in this order.

  /// Finds the numbers of the triangles that this part speaks for, and of those next to them.
  /// \pre those of their vertices are known
  void find_numbers() {
    Uninitialized_vector<std::uint64_t> keys;
    keys.reserve(held_.number_held());
    for_each_own([&](Triangle_id t) { keys.push_back(key_of(t)); });
    const Key_positions positions = ranker().positions_of(keys);
    number_of_all_ = exchange_.sum(static_cast<std::int64_t>(keys.size()));
    free_arrays(keys);
    numbers_.reserve(mesh_.triangles.size());
    ask_for_small_pages(numbers_.data(), mesh_.triangles.size() * sizeof numbers_[0]);
    numbers_.resize(mesh_.triangles.size());
    std::size_t next = 0;
    for_each_own([&](Triangle_id t) { numbers_[t.value()] = positions[next++]; });
    ask_for_neighbors();
  }

  Number number_of_all() const { return number_of_all_; }
  /// \pre it has been found
  std::uint32_t number(Triangle_id t) const { return numbers_[t.value()]; }

  /// Finds the constrained edges, and what they say of their ends' markers.
  /// \param segment_markers of the graph; empty if segments have none
  std::vector<Offered_marker> find_edges(const std::vector<int>& segment_markers) {
    std::vector<Offered_marker> offered;
    std::size_t number = 0;
    for_each_edge([&](Side) { ++number; });
    edges_.reserve(number);
    for_each_edge([&](Side s) { add_edge(s, segment_markers, offered); });
    return offered;
  }

  /// The input vertices outside that edges name, whose numbers have to be asked for.
  std::vector<Vertex_id> outer_vertices() const {
    std::vector<Vertex_id> found;
    for (const Edge& e : edges_)
      if (e.outer.is_valid()) found.push_back(e.outer);
    return found;
  }

  /// Which segments this part knows edges of: bits of bytes, by segment.
  Bytes segments_with_edges() const {
    Bytes bits;
    for (const Edge& e : edges_) {
      const std::uint32_t s = e.row.segment;
      if (s / 8 >= bits.size()) bits.resize(s / 8 + 1, 0);
      bits[s / 8] = static_cast<char>(bits[s / 8] | 1 << s % 8);
    }
    return bits;
  }

  /// Gives each part the triangles that it owns, which are no more in the kernel's form then.
  /// \pre the numbers of all parts are known to `part`
  void ship(Mesh& part) {
    const std::size_t own = part.number_of_own_triangles(), more = room_for_others(own);
    resize_with_pages(part.triangles, own, more), resize_with_pages(part.neighbors, own);
    if (part.has_regions) resize_with_pages(part.region_of_triangle, own, more);
    Handle_owners(exchange_.size())
        .for_each_run(mesh_.triangles.size(), [&](std::size_t begin, std::size_t end) {
          Records_of_parts<Row> outbox;
          for (const Triangle_id t : Id_range<Triangle_id>(begin, end))
            if (held_.speaks_for(t)) outbox[part.owner_of_triangle(number(t))].push_back(row(t));
          for (const Row& r : exchange_and_join(exchange_, std::move(outbox))) write(part, r);
          held_.give_back(begin, end);
        });
  }

  /// Gives each part the edges that it owns. \pre the numbers of outer vertices have been asked for
  void ship_edges(Mesh& part) {
    Uninitialized_vector<std::uint64_t> keys;
    keys.reserve(edges_.size());
    for (const Edge& e : edges_)
      keys.push_back(key(std::min(e.row.ends[0], e.row.ends[1]), std::max(e.row.ends[0], e.row.ends[1])));
    const Key_positions positions = ranker().positions_of(keys);
    part.number_of_constrained_edges = exchange_.sum(static_cast<std::int64_t>(keys.size()));
    Records_of_parts<Edge_row> outbox;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      Edge& e = edges_[i];
      e.row.number = positions[i];
      if (e.outer.is_valid()) e.row.outer = vertices_.number(e.outer);
      outbox[part.owner_of_triangle(e.home)].push_back(e.row);
    }
    free_arrays(edges_);
    std::vector<Edge_row> rows = exchange_and_join(exchange_, std::move(outbox));
    std::sort(rows.begin(), rows.end(),
              [](const Edge_row& e, const Edge_row& f) { return e.number < f.number; });
    part.constrained_edges.reserve(rows.size());
    for (const Edge_row& e : rows)
      part.constrained_edges.push_back(
          {e.number, {e.ends[0], e.ends[1]}, index(e.segment), index(e.outer), std::int64_t(e.marker)});
  }

private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  struct Row {
    std::uint32_t number;
    std::array<std::uint32_t, 3> vertices, neighbors; ///< from the least vertex on
    std::int32_t region;
  };
  struct Edge_row {
    std::uint32_t number;
    std::array<std::uint32_t, 2> ends;
    std::uint32_t segment, outer;
    std::int32_t marker;
  };
  struct Edge {
    Edge_row row;
    Vertex_id outer;
    std::uint32_t home; ///< the number of the first triangle beside it
  };
  struct Numbered {
    Triangle_id triangle;
    std::uint32_t number;
  };

  Exchange& exchange_;
  const Meshing_state<Geometry>& state_;
  const Kernel_mesh<Geometry>& mesh_;
  Held& held_;
  Vertices& vertices_;
  Uninitialized_vector<std::uint32_t> numbers_; // by handle
  std::vector<Edge> edges_;
  Number number_of_all_ = 0;

  static Number index(std::uint32_t i) { return i == none ? Number(-1) : Number(i); }
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return std::uint64_t(a) << 32 | b; }

  Key_ranker<Exchange> ranker() {
    return Key_ranker<Exchange>(exchange_, static_cast<std::uint64_t>(vertices_.number_of_all()));
  }

  template <class Function>
  void for_each_own(const Function& f) const {
    for (const Triangle_id t : mesh_.triangles.ids())
      if (held_.speaks_for(t)) f(t);
  }

  /// Calls `f` for a side of each constrained edge and each chord, at one of all parts.
  template <class Function>
  void for_each_edge(const Function& f) const {
    for_each_own([&](Triangle_id t) {
      for (int k = 0; k < 3; ++k) {
        const Side o = mesh_.triangle(t).side[k];
        const bool is_noted_here = o.is_border() || !(o.triangle() < t);
        if (o.is_constrained() && is_noted_here) f(Side(t, k));
      }
    });
  }

  std::array<std::uint32_t, 3> numbers_of_vertices(Triangle_id t) const {
    const auto& v = mesh_.triangle(t).v;
    return {vertices_.number(v[0]), vertices_.number(v[1]), vertices_.number(v[2])};
  }
  static std::size_t slot_of_least(const std::array<std::uint32_t, 3>& v) {
    return static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
  }
  std::uint64_t key_of(Triangle_id t) const {
    const auto v = numbers_of_vertices(t);
    const std::size_t k = slot_of_least(v);
    return key(v[k], v[(k + 1) % 3]);
  }

  /// Those next to this part's own triangles.
  void ask_for_neighbors() {
    std::vector<Triangle_id> wanted;
    for_each_own([&](Triangle_id t) {
      for (const Side o : mesh_.triangle(t).side)
        if (!o.is_border() && !held_.speaks_for(o.triangle())) wanted.push_back(o.triangle());
    });
    sort_and_drop_equal(wanted);
    Records_of_parts<Numbered> answers;
    for (const Parcel& parcel : tell_all_bytes(exchange_, bytes_of(wanted)))
      for (const Triangle_id t : records_of<Triangle_id>(parcel.bytes))
        if (held_.speaks_for(t)) answers[parcel.part].push_back({t, number(t)});
    for (const Numbered& n : exchange_and_join(exchange_, std::move(answers)))
      numbers_[n.triangle.value()] = n.number;
  }

  void add_edge(Side s, const std::vector<int>& segment_markers, std::vector<Offered_marker>& offered) {
    const Vertex_id x = mesh_.source(s), y = mesh_.target(s);
    const Side o = mesh_.across(s);
    const Edge_id e = state_.edges.carrying(mesh_, x, y);
    std::int32_t marker = 0;
    if (e.is_valid()) {
      const Segment_index segment = state_.edges[e].segment;
      if (!segment_markers.empty()) marker = segment_markers[std::size_t(segment)];
      const std::uint32_t home =
          o.is_border() ? number(s.triangle()) : std::min(number(s.triangle()), number(o.triangle()));
      edges_.push_back({{0, {vertices_.number(x), vertices_.number(y)}, segment.value(), none, marker},
                        state_.problem.outer_vertex(e),
                        home});
    }
    for (const Vertex_id v : {x, y}) {
      const auto slot = static_cast<std::uint32_t>(s.slot());
      if (marker != 0) offered.push_back({v.value(), s.triangle().value(), slot, marker});
      if (o.is_border()) offered.push_back({v.value(), none, 0, 1});
    }
  }

  Row row(Triangle_id t) const {
    const auto v = numbers_of_vertices(t);
    const std::size_t first = slot_of_least(v);
    Row row{number(t), {}, {}, static_cast<std::int32_t>(mesh_.region(t).value())};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = (first + k) % 3;
      row.vertices[k] = v[from];
      // The side after a vertex is the k-th one in the user's mesh, as it is in the kernel's.
      const Side o = mesh_.triangle(t).side[from];
      row.neighbors[k] = o.is_border() ? none : number(o.triangle());
    }
    return row;
  }

  static void write(Mesh& part, const Row& row) {
    const std::size_t i =
        static_cast<std::size_t>(row.number - part.first_triangle[static_cast<std::size_t>(part.rank)]);
    for (std::size_t k = 0; k < 3; ++k)
      part.triangles[i][k] = row.vertices[k], part.neighbors[i][k] = index(row.neighbors[k]);
    if (part.has_regions) part.region_of_triangle[i] = row.region;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_TRIANGLES_OF_PARTS_H
