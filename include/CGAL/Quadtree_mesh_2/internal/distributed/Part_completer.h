// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Completes a rank of a distributed mesh that has only what it owns.
//
// Computes: ghosts and foreign vertices, the same as Mesh_cutter.h cuts from a whole mesh. Each rank tells the owner of
//           a vertex that it has triangles there. The owner tells each of these ranks about the others. Each of them
//           sends its triangles there to the others, once each. Then owners are asked for what is known of vertices.
// Bound:    O(k log k) time and O(k) memory for k triangles and vertices of the rank, ghosts and foreign ones included,
//           besides what P ranks need to know each other's numbers. An owner sends O(r^2) numbers for a vertex at which
//           r ranks have triangles; r is at most the number of triangles there, which is bounded in meshes of quality.
//           Messages go to ranks that own a vertex used here, use a vertex owned here, or get a triangle as a ghost.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PART_COMPLETER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PART_COMPLETER_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The vertices of each owner. \pre `vertices` is sorted
template <class Point>
Records_of_parts<std::int64_t> vertices_by_owner(const Distributed_mesh_2<Point>& part,
                                                 const std::vector<std::int64_t>& vertices) {
  Records_of_parts<std::int64_t> lists;
  for (auto begin = vertices.begin(); begin != vertices.end();) {
    const int owner = part.owner_of_vertex(*begin);
    const auto end =
        std::lower_bound(begin, vertices.end(), part.first_vertex[static_cast<std::size_t>(owner) + 1]);
    lists[owner].assign(begin, end);
    begin = end;
  }
  return lists;
}

/// See the head of this file.
template <class Exchange, class Point>
class Part_completer {
public:
  using Part = Distributed_mesh_2<Point>;
  using Number = typename Part::Number;

  Part_completer(Exchange& exchange, Part& part) : exchange_(exchange), part_(part) {}

  void run() {
    add_ghosts(exchange_records(exchange_, triangles_to_send(others_at_vertices())));
    find_foreign_vertices();
    add_foreign_vertices();
  }

private:
  /// A rank with triangles at a vertex.
  struct User {
    Number vertex, rank;
    bool operator<(const User& other) const {
      return std::pair(vertex, rank) < std::pair(other.vertex, other.rank);
    }
  };

  struct Sent_triangle {
    Number number;
    std::array<Number, 3> vertices;
    std::int64_t region;
  };

  /// Foreign vertices among others, sorted and without equal ones.
  class Foreign_list {
  public:
    explicit Foreign_list(const Part& part)
        : first_own_(part.first_vertex[static_cast<std::size_t>(part.rank)]),
          end_of_own_(part.first_vertex[static_cast<std::size_t>(part.rank) + 1]) {}

    template <std::size_t n>
    void add(const std::array<Number, n>& vertices) {
      for (const Number v : vertices)
        if (v < first_own_ || v >= end_of_own_) list_.push_back(v);
    }
    std::vector<Number> take() {
      std::sort(list_.begin(), list_.end());
      list_.erase(std::unique(list_.begin(), list_.end()), list_.end());
      list_.shrink_to_fit(); // there were as many as triangles at each of them
      return std::move(list_);
    }

  private:
    Number first_own_, end_of_own_;
    std::vector<Number> list_;
  };

  /// The other ranks at own vertices, sorted.
  std::vector<User> others_at_own_vertices() {
    Foreign_list foreign(part_);
    for (const auto& t : part_.triangles) foreign.add(t);
    std::vector<User> users;
    for (const auto& [rank, vertices] : exchange_records(exchange_, vertices_by_owner(part_, foreign.take())))
      for (const Number v : vertices) users.push_back({v, rank});
    std::sort(users.begin(), users.end());
    return users;
  }

  /// The other ranks at the vertices of own triangles, sorted.
  std::vector<User> others_at_vertices() {
    const std::vector<User> users = others_at_own_vertices();
    std::vector<char> is_used_here(part_.number_of_own_vertices(), 0);
    for (const auto& t : part_.triangles)
      for (const Number v : t)
        if (part_.is_own_vertex(v)) is_used_here[part_.index_of_vertex(v)] = 1;
    Records_of_parts<User> told;
    std::vector<int> ranks; // at one vertex
    for (std::size_t begin = 0, end = 0; begin < users.size(); begin = end) {
      const Number v = users[begin].vertex;
      ranks.clear();
      for (; end < users.size() && users[end].vertex == v; ++end)
        ranks.push_back(static_cast<int>(users[end].rank));
      if (is_used_here[part_.index_of_vertex(v)] != 0) ranks.push_back(part_.rank);
      for (const int rank : ranks)
        for (const int other : ranks)
          if (other != rank) told[rank].push_back({v, other});
    }
    // Owners come in their order, and so do their vertices.
    return exchange_and_join(exchange_, std::move(told));
  }

  /// Own triangles for each other rank that has one with a vertex in common, in their order.
  /// \param others at the vertices of own triangles, in the order of vertices
  Records_of_parts<Sent_triangle> triangles_to_send(const std::vector<User>& others) const {
    std::vector<char> is_shared(part_.number_of_own_vertices(), 0);
    for (const User& user : others)
      if (part_.is_own_vertex(user.vertex)) is_shared[part_.index_of_vertex(user.vertex)] = 1;
    Records_of_parts<Sent_triangle> sent;
    std::vector<int> ranks; // that get one triangle
    for (std::size_t t = 0; t < part_.triangles.size(); ++t) {
      ranks.clear();
      for (const Number v : part_.triangles[t]) {
        if (part_.is_own_vertex(v) && is_shared[part_.index_of_vertex(v)] == 0) continue;
        for (auto user = std::lower_bound(others.begin(), others.end(), User{v, -1});
             user != others.end() && user->vertex == v; ++user)
          ranks.push_back(static_cast<int>(user->rank));
      }
      std::sort(ranks.begin(), ranks.end());
      ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
      for (const int rank : ranks)
        sent[rank].push_back({part_.number_of_triangle(t), part_.triangles[t],
                              part_.has_regions ? part_.region_of_triangle[t] : -1});
    }
    return sent;
  }

  /// \param received by sender, from each in their order: so all are in the order of their numbers
  void add_ghosts(Records_of_parts<Sent_triangle> received) {
    std::size_t n = 0;
    for (const auto& of_rank : received) n += of_rank.second.size();
    part_.ghost_triangles.reserve(n);
    part_.triangles.reserve(part_.triangles.size() + n);
    if (part_.has_regions) part_.region_of_triangle.reserve(part_.region_of_triangle.size() + n);
    for (auto& of_rank : received) {
      for (const Sent_triangle& t : of_rank.second) {
        part_.ghost_triangles.push_back(t.number);
        part_.triangles.push_back(t.vertices);
        if (part_.has_regions) part_.region_of_triangle.push_back(static_cast<int>(t.region));
      }
      std::vector<Sent_triangle>().swap(of_rank.second);
    }
  }

  void find_foreign_vertices() {
    Foreign_list foreign(part_);
    for (const auto& t : part_.triangles) foreign.add(t);
    for (const auto& e : part_.constrained_edges) foreign.add(e.vertices);
    for (const auto& s : part_.outside_segments) foreign.add(s.vertices);
    part_.foreign_vertices = foreign.take();
  }

  void add_foreign_vertices() {
    const auto asked = exchange_records(exchange_, vertices_by_owner(part_, part_.foreign_vertices));
    const auto copy = [](auto value) { return value; };
    add_from_owners(
        asked, part_.points, [](const Point& p) { return coordinates_to_send(p); },
        [](const Sent_coordinates<Point>& p) { return Point(p[0], p[1]); });
    if (part_.has_vertex_markers) add_from_owners(asked, part_.vertex_markers, copy, copy);
    if (part_.has_input_index) add_from_owners(asked, part_.input_index, copy, copy);
    if (part_.has_segment_of_vertex) add_from_owners(asked, part_.segment_of_vertex, copy, copy);
  }

  /// Answers what others ask about own vertices, and adds the answers about foreign ones.
  /// \param values of own vertices
  template <class Value, class To_sent, class From_sent>
  void add_from_owners(const Records_of_parts<Number>& asked, std::vector<Value>& values,
                       const To_sent& to_sent, const From_sent& from_sent) {
    using Sent = decltype(to_sent(values.front()));
    Records_of_parts<Sent> answers;
    for (const auto& [rank, vertices] : asked) {
      std::vector<Sent>& list = answers[rank];
      list.reserve(vertices.size());
      for (const Number v : vertices) list.push_back(to_sent(values[part_.index_of_vertex(v)]));
    }
    values.reserve(values.size() + part_.foreign_vertices.size());
    // Owners come in their order, and so do foreign vertices.
    for (const auto& of_rank : exchange_records(exchange_, std::move(answers)))
      for (const Sent& value : of_rank.second) values.push_back(from_sent(value));
  }

  Exchange& exchange_;
  Part& part_;
};

/// How many ghosts or foreign vertices arrays should have room for behind so many own ones. Most often that is enough,
/// and nothing is copied when they are added.
inline std::size_t room_for_others(std::size_t own) { return own / 64 + 1024; }

/// See the head of this file. All parts call it.
/// \pre The numbers of the whole mesh are set: all that is the same at all ranks.
/// \pre Of this rank, `triangles`, `region_of_triangle` and `neighbors` have the own triangles; `points`,
/// `vertex_markers`, `input_index` and `segment_of_vertex` the own vertices, where the mesh has them.
/// \pre `constrained_edges` and `outside_segments` are those of this rank.
/// \pre `foreign_vertices` and `ghost_triangles` are empty.
template <class Exchange, class Point>
void complete_part(Exchange& exchange, Distributed_mesh_2<Point>& part) {
  Part_completer<Exchange, Point>(exchange, part).run();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PART_COMPLETER_H
