// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The vertices of a mesh that parts hold, as they will be in the mesh of its user: numbers in the order of places,
// coordinates, markers, indices in the input.
//
// Computes: the numbers of the vertices that a part holds; then the rows of those that it owns in the end.
// Bound:    each part keeps a share of all vertices in a directory (Handle_owners.h), 32 bytes for each and 4 more
//           while they are numbered, and 4 bytes for the number of each that it holds or asks for. A vertex goes there
//           once, and from there to its owner.
// Method:   whoever speaks for a Steiner vertex tells the directory of it; the first part, which has the graph, tells
//           of those of the input. The directory's shares are sorted (Place_numbers.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_VERTICES_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_VERTICES_OF_PARTS_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Part_completer.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Place_numbers.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Handle_owners.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Held_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A marker that an edge has for one of its ends. Of several, the vertex takes that of the least side.
struct Offered_marker {
  std::uint32_t vertex, triangle, slot; ///< handles; sides of the border without a marker come last
  std::int32_t marker;

  friend bool operator<(const Offered_marker& a, const Offered_marker& b) {
    return std::tie(a.vertex, a.triangle, a.slot) < std::tie(b.vertex, b.triangle, b.slot);
  }
};

template <class Exchange, class Point, class Geometry>
class Vertices_of_parts {
public:
  using Held = Held_mesh<Exchange, Geometry>;
  using Mesh = Distributed_mesh_2<Point>;
  using Number = typename Mesh::Number;

  Vertices_of_parts(Exchange& exchange, const Meshing_state<Geometry>& state, const Held& held)
      : exchange_(exchange), state_(state), mesh_(state.mesh), held_(held), owners_(exchange.size()) {}

  // All parts call what follows, in this order.

  /// Fills the directory.
  /// \param markers, order count at the first part: of the graph's vertices, if they have some, and the input vertex of
  ///        each handle
  /// \param to_user from the kernel's coordinates to the user's
  /// \pre the problem has the graph's points
  template <class To_user>
  void collect(const std::vector<int>& markers, const Order& order, const To_user& to_user) {
    const std::size_t n = mesh_.number_of_vertices(), places = owners_.places(n);
    resize_with_pages(rows_, places);
    const auto inputs = static_cast<std::size_t>(exchange_.max(static_cast<std::int64_t>(order.size())));
    owners_.for_each_run(n, [&](std::size_t begin, std::size_t end) {
      Records_of_parts<Told_row> outbox;
      const auto tell = [&](std::size_t v, const Row& row) {
        outbox[owners_.owner(v)].push_back({static_cast<std::uint32_t>(v), row});
      };
      for (std::size_t v = begin; v < std::min(end, order.size()); ++v)
        tell(v, input_row(to_user(state_.problem.input_point(Vertex_id(v))), order[v], markers));
      for (const Vertex_id v : Id_range<Vertex_id>(std::max(begin, inputs), std::max(end, inputs)))
        if (held_.speaks_for(v)) tell(std::size_t(v), steiner_row(v, to_user(mesh_.point(v))));
      for (const Told_row& told : exchange_and_join(exchange_, std::move(outbox)))
        rows_[owners_.place(told.vertex)] = told.row;
    });
  }

  /// Numbers all vertices by their places.
  void find_numbers() {
    std::vector<std::uint32_t> used; // the places of rows with a vertex
    used.reserve(rows_.size());
    for (std::size_t p = 0; p < rows_.size(); ++p)
      if (rows_[p].number != none) used.push_back(static_cast<std::uint32_t>(p));
    const auto vertex_at = [&](std::size_t i) {
      const Row& row = rows_[used[i]];
      const std::int64_t index = row.input_index == none ? -1 : std::int64_t(row.input_index);
      return Placed_vertex<Point>{row.place, index, owners_.handle(exchange_.rank(), used[i])};
    };
    const std::vector<std::int64_t> numbers = numbers_by_place<Point>(exchange_, used.size(), vertex_at);
    for (std::size_t i = 0; i < used.size(); ++i)
      rows_[used[i]].number = static_cast<std::uint32_t>(numbers[i]);
    number_of_all_ = exchange_.sum(static_cast<std::int64_t>(numbers.size()));
  }

  /// How many vertices there are, used or not.
  Number number_of_all() const { return number_of_all_; }

  /// Numbers of the vertices with triangles that this part holds are known from now on.
  void ask_for_held() {
    numbers_.reserve(mesh_.number_of_vertices());
    ask_for_small_pages(numbers_.data(), mesh_.number_of_vertices() * sizeof numbers_[0]);
    numbers_.resize(mesh_.number_of_vertices());
    owners_.for_each_run(numbers_.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<Vertex_id> wanted;
      for (const Vertex_id v : Id_range<Vertex_id>(begin, end))
        if (held_.has(v) && mesh_.is_used(v)) wanted.push_back(v);
      ask_for(wanted);
    });
  }
  /// The same for some vertices.
  void ask_for(const std::vector<Vertex_id>& wanted) {
    Records_of_parts<Vertex_id> asked;
    for (const Vertex_id v : wanted) asked[owners_.owner(std::size_t(v))].push_back(v);
    const Records_of_parts<Vertex_id> sent = asked;
    Records_of_parts<std::uint32_t> answers;
    for (const auto& [part, vertices] : exchange_records(exchange_, std::move(asked)))
      for (const Vertex_id v : vertices) answers[part].push_back(rows_[owners_.place(std::size_t(v))].number);
    for (const auto& [part, found] : exchange_records(exchange_, std::move(answers)))
      for (std::size_t i = 0; i < found.size(); ++i) numbers_[sent.at(part)[i].value()] = found[i];
  }
  /// \pre it has been asked for
  std::uint32_t number(Vertex_id v) const { return numbers_[v.value()]; }

  /// Vertices that have no marker take one that is offered.
  void offer(const std::vector<Offered_marker>& offered) {
    Records_of_parts<Offered_marker> outbox;
    for (const Offered_marker& o : offered) outbox[owners_.owner(o.vertex)].push_back(o);
    std::vector<Offered_marker> all = exchange_and_join(exchange_, std::move(outbox));
    std::sort(all.begin(), all.end());
    for (const Offered_marker& o : all)
      if (std::int32_t& marker = rows_[owners_.place(o.vertex)].marker; marker == 0) marker = o.marker;
  }

  /// Gives each part the vertices that it owns.
  /// \pre their numbers and those of all parts are known to `part`
  void ship(Mesh& part) {
    const std::size_t own = part.number_of_own_vertices(), more = room_for_others(own);
    resize_with_pages(part.points, own, more), resize_with_pages(part.vertex_markers, own, more);
    resize_with_pages(part.input_index, own, more), resize_with_pages(part.segment_of_vertex, own, more);
    owners_.for_each_run(rows_.size() * static_cast<std::size_t>(exchange_.size()),
                         [&](std::size_t begin, std::size_t end) {
                           Records_of_parts<Row> outbox;
                           for_each_row_between(begin, end, [&](const Row& row) {
                             outbox[part.owner_of_vertex(row.number)].push_back(row);
                           });
                           for (const Row& row : exchange_and_join(exchange_, std::move(outbox)))
                             write(part, row);
                         });
    free_arrays(rows_);
  }

private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  /// What the directory knows of a vertex.
  struct Row {
    Sent_coordinates<Point> place;
    std::uint32_t input_index = none, segment = none;
    std::int32_t marker = 0;
    std::uint32_t number = none; ///< before it is known: 0 if there is such a vertex
  };
  struct Told_row {
    std::uint32_t vertex;
    Row row;
  };

  Exchange& exchange_;
  const Meshing_state<Geometry>& state_;
  const Kernel_mesh<Geometry>& mesh_;
  const Held& held_;
  Handle_owners owners_;
  std::vector<Row> rows_;                       // of the directory's share, by place
  Uninitialized_vector<std::uint32_t> numbers_; // by handle
  Number number_of_all_ = 0;

  static Row input_row(const Point& place, std::uint32_t index, const std::vector<int>& markers) {
    Row row;
    row.place = coordinates_to_send(place);
    row.input_index = index, row.number = 0;
    if (!markers.empty()) row.marker = markers[index];
    return row;
  }
  Row steiner_row(Vertex_id v, const Point& place) const {
    Row row;
    row.place = coordinates_to_send(place), row.number = 0;
    if (mesh_.edge(v).is_valid()) row.segment = state_.edges[mesh_.edge(v)].segment.value();
    return row;
  }

  /// Rows at places that are a share of those between these.
  template <class Function>
  void for_each_row_between(std::size_t begin, std::size_t end, const Function& f) const {
    const auto parts = static_cast<std::size_t>(exchange_.size());
    for (std::size_t p = begin / parts; p < std::min(rows_.size(), end / parts); ++p)
      if (rows_[p].number != none) f(rows_[p]);
  }

  static void write(Mesh& part, const Row& row) {
    const auto index = [](std::uint32_t i) { return i == none ? Number(-1) : Number(i); };
    const std::size_t i = part.index_of_vertex(row.number);
    part.points[i] = Point(row.place[0], row.place[1]);
    part.vertex_markers[i] = row.marker;
    part.input_index[i] = index(row.input_index), part.segment_of_vertex[i] = index(row.segment);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_VERTICES_OF_PARTS_H
