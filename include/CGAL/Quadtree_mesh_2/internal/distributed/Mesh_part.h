// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What a rank has to write of a mesh, as a mesh of its own with 32 bits, which all writers take.
//
// Computes: own triangles and ghosts, constrained edges, and their vertices in the order of their numbers. The last
//           part with triangles also gets the vertices of which nobody has a triangle or edge: its file has them.
//           Fields get values at ghosts, as edges take the least value beside them.
// Bound:    O(k + f log f) for k triangles and vertices of the rank with f occurrences of foreign vertices. Each
//           foreign vertex and ghost is told once.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_PART_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_PART_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Mesh_numbers.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtk_grid.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// See the head of this file.
template <class Point>
class Mesh_part {
public:
  using Part = Distributed_mesh_2<Point>;
  using Number = typename Part::Number;

  /// All parts have to do this.
  template <class Exchange>
  Mesh_part(Exchange& exchange, const Part& part) : part_(part) {
    const std::vector<Unused> unused = unused_vertices(exchange);
    agree_on_work(exchange, [&] {
      add_vertices(unused);
      add_triangles();
      add_edges();
    });
  }

  const Indexed_mesh_2<Point>& mesh() const { return mesh_; }
  const std::vector<Outside_segment>& outside() const { return outside_; }
  /// Vertices that only the file of this part has, in their order.
  const std::vector<std::uint32_t>& unused() const { return unused_; }

  Mesh_numbers numbers() const {
    const auto n = [](Number i) { return static_cast<std::size_t>(i); };
    const Mesh_numbers::Counts counts{n(part_.number_of_vertices()), n(part_.number_of_triangles()),
                                      n(part_.number_of_constrained_edges),
                                      n(part_.number_of_outside_segments)};
    const std::size_t own_vertices = part_.number_of_own_vertices(),
                      own_triangles = part_.number_of_own_triangles();
    Mesh_numbers::List edges;
    edges.reserve(part_.constrained_edges.size());
    for (const auto& e : part_.constrained_edges) edges.push_back(static_cast<std::uint64_t>(e.number));
    const auto& ghosts = part_.ghost_triangles;
    return Mesh_numbers(part_.rank == 0 ? Mesh_numbers::Part::FIRST : Mesh_numbers::Part::OTHER, counts,
                        {first_own_, own_vertices, static_cast<std::uint64_t>(first_own_number()), others_},
                        {first_own_, first_own_ + own_vertices},
                        {0, own_triangles,
                         static_cast<std::uint64_t>(part_.first_triangle[std::size_t(part_.rank)]),
                         Mesh_numbers::List(ghosts.begin(), ghosts.end())},
                        own_triangles, std::move(edges));
  }

  /// Fields of own triangles with their values at ghosts. All parts have to do this, with the same fields.
  /// \throws std::invalid_argument if that is not so, or a field does not have a number for each own triangle
  template <class Exchange>
  IO::Triangle_fields_2 with_ghosts(Exchange& exchange, IO::Triangle_fields_2 fields) const {
    check_fields(exchange, fields);
    if (fields.empty()) return fields;
    Records_of_parts<Number> asked;
    for (const Number t : part_.ghost_triangles) asked[part_.owner_of_triangle(t)].push_back(t);
    Records_of_parts<double> answers;
    for (const auto& [rank, list] : exchange_records(exchange, std::move(asked)))
      for (const IO::Triangle_field_2& field : fields)
        for (const Number t : list)
          answers[rank].push_back(
              field.values[std::size_t(t - part_.first_triangle[std::size_t(part_.rank)])]);
    // Owners come in their order, and so do ghosts.
    for (const auto& [rank, values] : exchange_records(exchange, std::move(answers))) {
      const std::size_t n = values.size() / fields.size();
      for (std::size_t f = 0; f < fields.size(); ++f)
        fields[f].values.insert(fields[f].values.end(), values.begin() + static_cast<std::ptrdiff_t>(f * n),
                                values.begin() + static_cast<std::ptrdiff_t>((f + 1) * n));
    }
    return fields;
  }

private:
  /// A vertex of which nobody has a triangle or edge.
  struct Unused {
    Number number;
    Sent_coordinates<Point> place;
    Number input_index;
    std::int64_t marker;
  };

  template <class Exchange>
  std::vector<Unused> unused_vertices(Exchange& exchange) const {
    std::vector<char> is_used(part_.points.size(), 0);
    const auto use = [&](const auto& vertices) {
      for (const Number v : vertices) is_used[part_.index_of_vertex(v)] = 1;
    };
    for (const auto& t : part_.triangles) use(t);
    for (const auto& e : part_.constrained_edges) use(e.vertices);
    const std::size_t own = part_.number_of_own_vertices();
    Records_of_parts<Number> told;
    for (std::size_t v = own; v < is_used.size(); ++v)
      if (is_used[v] != 0)
        told[part_.owner_of_vertex(part_.number_of_vertex(v))].push_back(part_.number_of_vertex(v));
    for (const Number v : exchange_and_join(exchange, std::move(told))) is_used[part_.index_of_vertex(v)] = 1;
    Records_of_parts<Unused> unused;
    for (std::size_t v = 0; v < own; ++v)
      if (is_used[v] == 0)
        unused[part_.number_of_parts() - 1].push_back(
            {part_.number_of_vertex(v), coordinates_to_send(part_.points[v]),
             part_.has_input_index ? part_.input_index[v] : -1,
             part_.has_vertex_markers ? part_.vertex_markers[v] : 0});
    return exchange_and_join(exchange, std::move(unused));
  }

  /// \param unused of all parts, in the order of their numbers
  void add_vertices(const std::vector<Unused>& unused) {
    list_vertices(unused);
    const std::size_t vertices = part_.number_of_own_vertices() + others_.size();
    if (vertices >= std::numeric_limits<std::uint32_t>::max())
      throw std::length_error("a rank writes fewer than 2^32 - 1 vertices");
    mesh_.points.resize(vertices);
    // Empty arrays are those that the mesh has not.
    const std::size_t n = std::max<std::size_t>(vertices, 1);
    if (part_.has_vertex_markers) mesh_.vertex_markers.resize(n);
    if (part_.has_input_index) mesh_.input_index.resize(n);
    for (const Unused& v : unused) {
      set_vertex(v.number, Point(v.place[0], v.place[1]), static_cast<int>(v.marker), v.input_index);
      unused_.push_back(local(v.number).value());
    }
    for (std::size_t v = 0; v < part_.points.size(); ++v)
      set_vertex(part_.number_of_vertex(v), part_.points[v],
                 part_.has_vertex_markers ? part_.vertex_markers[v] : 0,
                 part_.has_input_index ? part_.input_index[v] : -1);
  }
  /// In the order of their numbers: own ones follow each other.
  void list_vertices(const std::vector<Unused>& unused) {
    others_.assign(part_.foreign_vertices.begin(), part_.foreign_vertices.end());
    for (const Unused& v : unused)
      if (!part_.is_own_vertex(v.number)) others_.push_back(static_cast<std::uint64_t>(v.number));
    if (!unused.empty()) sort_and_drop_equal(others_); // those of foreign vertices are sorted
    first_own_ = place_among_others(first_own_number());
  }
  void set_vertex(Number number, const Point& p, int marker, Number input_index) {
    const auto v = std::size_t(local(number));
    mesh_.points[v] = p;
    if (part_.has_vertex_markers) mesh_.vertex_markers[v] = marker;
    if (part_.has_input_index && input_index >= 0) mesh_.input_index[v] = Vertex_index(input_index);
  }

  void add_triangles() {
    mesh_.triangles.reserve(part_.triangles.size());
    for (const auto& [a, b, c] : part_.triangles) mesh_.triangles.push_back({local(a), local(b), local(c)});
    mesh_.region_of_triangle = part_.region_of_triangle;
  }
  void add_edges() {
    mesh_.constrained_edges.reserve(part_.constrained_edges.size());
    for (const auto& e : part_.constrained_edges)
      mesh_.constrained_edges.push_back({{local(e.vertices[0]), local(e.vertices[1])},
                                         Segment_index(),
                                         static_cast<int>(e.marker),
                                         Vertex_index()});
    for (const auto& s : part_.outside_segments)
      outside_.push_back({{local(s.vertices[0]), local(s.vertices[1])},
                          static_cast<std::size_t>(s.segment),
                          static_cast<int>(s.marker)});
  }

  Number first_own_number() const { return part_.first_vertex[std::size_t(part_.rank)]; }

  /// Of a vertex that is not own, or where it would be.
  std::size_t place_among_others(Number v) const {
    return static_cast<std::size_t>(
        std::lower_bound(others_.begin(), others_.end(), static_cast<std::uint64_t>(v)) - others_.begin());
  }
  Vertex_index local(Number v) const {
    if (part_.is_own_vertex(v)) return Vertex_index(first_own_ + std::size_t(v - first_own_number()));
    const std::size_t place = place_among_others(v);
    return Vertex_index(place < first_own_ ? place : place + part_.number_of_own_vertices());
  }

  template <class Exchange>
  void check_fields(Exchange& exchange, const IO::Triangle_fields_2& fields) const {
    Archive_writer names;
    for (const IO::Triangle_field_2& field : fields)
      names(std::vector<char>(field.name.begin(), field.name.end()));
    Bytes of_first = names.bytes;
    exchange.broadcast(of_first, 0);
    agree_on_work(exchange, [&] {
      if (names.bytes != of_first)
        throw std::invalid_argument("the fields of rank " + std::to_string(part_.rank) +
                                    " are not those of rank 0");
      for (const IO::Triangle_field_2& field : fields)
        if (field.values.size() != part_.number_of_own_triangles())
          throw std::invalid_argument("rank " + std::to_string(part_.rank) + ": the field '" + field.name +
                                      "' has " + std::to_string(field.values.size()) + " numbers for " +
                                      std::to_string(part_.number_of_own_triangles()) + " own triangles");
    });
  }

  const Part& part_;
  Indexed_mesh_2<Point> mesh_;
  std::vector<std::uint64_t> others_; // the numbers of vertices that are not own
  std::size_t first_own_ = 0;         // how many of them come before those that are
  std::vector<Outside_segment> outside_;
  std::vector<std::uint32_t> unused_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_PART_H
