// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Checks that what ranks hold of a mesh fits together: the invariants of `Distributed_mesh_2`.
//
// Computes: nothing by the ways in which meshes are cut. Ghosts are found anew where they meet: the owner of a vertex
//           is told of others' triangles there, and tells each rank with one of them about those of others.
// Bound:    O(k log k) for k triangles and vertices of the rank. What is told lies at vertices that ranks share.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_DEFECTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_DEFECTS_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/mesh_pieces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// See the head of this file.
template <class Exchange, class Point>
class Mesh_defects {
public:
  using Part = Distributed_mesh_2<Point>;
  using Number = typename Part::Number;

  Mesh_defects(Exchange& exchange, const Part& part) : exchange_(exchange), part_(part) {}

  /// What is wrong, the same at all parts; empty if nothing is.
  std::string find() {
    try {
      agree_on_work(exchange_, [this] { check_sizes(); });
      check_whole();
      agree_on_work(exchange_, [this] { check_foreign_vertices(); });
      check_copies_of_vertices();
      check_ghosts();
      agree_on_work(exchange_, [this] { list_sides(), check_neighbors(); });
      check_edges();
    } catch (const std::logic_error& defect) { // the type in which parts agree on it
      return defect.what();
    }
    return std::string();
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::logic_error("rank " + std::to_string(exchange_.rank()) + ": " + what);
  }
  void check(bool is_right, const std::string& what) const {
    if (!is_right) fail(what);
  }
  static std::string name(const char* kind, Number i) { return kind + (' ' + std::to_string(i)); }

  void check_sizes() const {
    const auto ranks = static_cast<std::size_t>(exchange_.size());
    check(part_.rank == exchange_.rank(), "the mesh is that of rank " + std::to_string(part_.rank));
    for (const auto* first : {&part_.first_vertex, &part_.first_triangle})
      check(first->size() == ranks + 1 && first->front() == 0 && std::is_sorted(first->begin(), first->end()),
            "numbers of ranks do not begin at 0 or fall");
    const std::size_t vertices = part_.number_of_own_vertices() + part_.foreign_vertices.size(),
                      own = part_.number_of_own_triangles(), triangles = own + part_.ghost_triangles.size();
    const auto has = [](bool is_there, std::size_t n, std::size_t size) {
      return size == (is_there ? n : 0);
    };
    check(part_.points.size() == vertices &&
              has(part_.has_vertex_markers, vertices, part_.vertex_markers.size()) &&
              has(part_.has_input_index, vertices, part_.input_index.size()) &&
              has(part_.has_segment_of_vertex, vertices, part_.segment_of_vertex.size()),
          "an array of vertices has another length");
    check(part_.triangles.size() == triangles &&
              has(part_.has_regions, triangles, part_.region_of_triangle.size()) &&
              has(part_.has_neighbors, own, part_.neighbors.size()),
          "an array of triangles has another length");
  }

  /// What all parts know of the whole mesh.
  void check_whole() {
    Archive_writer own;
    own(part_.first_vertex), own(part_.first_triangle);
    own(part_.number_of_constrained_edges), own(part_.number_of_outside_segments);
    own(part_.number_of_input_vertices);
    own(std::array{part_.has_regions, part_.has_vertex_markers, part_.has_input_index, part_.has_neighbors,
                   part_.has_segment_of_vertex});
    write_legend(own, part_.legend);
    Bytes first = own.bytes;
    exchange_.broadcast(first, 0);
    agree_on_work(exchange_, [&] { check(first == own.bytes, "the whole mesh is another one at rank 0"); });
  }

  template <class F>
  void for_each_use(const F& f) const {
    for (const auto& t : part_.triangles)
      for (const Number v : t) f(v);
    for (const auto& e : part_.constrained_edges)
      for (const Number v : e.vertices) f(v);
    for (const auto& s : part_.outside_segments)
      for (const Number v : s.vertices) f(v);
  }

  void check_foreign_vertices() const {
    std::set<Number> used;
    for_each_use([&](Number v) {
      check(v >= 0 && v < part_.number_of_vertices(), "there is no " + name("vertex", v));
      if (!part_.is_own_vertex(v)) used.insert(v);
    });
    check(std::equal(used.begin(), used.end(), part_.foreign_vertices.begin(), part_.foreign_vertices.end()),
          "foreign vertices are not those that are used, in their order");
  }

  /// What is known of a vertex.
  struct Vertex {
    Number number;
    Sent_coordinates<Point> place;
    Number input_index, segment;
    std::int64_t marker;
  };
  Vertex vertex(std::size_t i) const {
    return {part_.number_of_vertex(i), coordinates_to_send(part_.points[i]),
            part_.has_input_index ? part_.input_index[i] : -1,
            part_.has_segment_of_vertex ? part_.segment_of_vertex[i] : -1,
            part_.has_vertex_markers ? part_.vertex_markers[i] : 0};
  }

  void check_copies_of_vertices() {
    Records_of_parts<Vertex> told;
    for (std::size_t i = part_.number_of_own_vertices(); i < part_.points.size(); ++i)
      told[part_.owner_of_vertex(part_.number_of_vertex(i))].push_back(vertex(i));
    const auto copies = exchange_and_join(exchange_, std::move(told));
    agree_on_work(exchange_, [&] {
      for (const Vertex& copy : copies) {
        const Vertex own = vertex(part_.index_of_vertex(copy.number));
        check(std::memcmp(&own.place, &copy.place, sizeof own.place) == 0 &&
                  own.input_index == copy.input_index && own.segment == copy.segment &&
                  own.marker == copy.marker,
              "a copy of " + name("vertex", copy.number) + " is another one");
      }
    });
  }

  /// A triangle at a vertex.
  struct Corner {
    Number vertex, triangle;
    std::array<Number, 3> vertices;
    std::int64_t region;
    bool operator<(const Corner& other) const {
      return std::pair(vertex, triangle) < std::pair(other.vertex, other.triangle);
    }
  };
  Corner corner(Number v, std::size_t t) const {
    return {v, part_.number_of_triangle(t), part_.triangles[t],
            part_.has_regions ? part_.region_of_triangle[t] : -1};
  }

  /// The triangles at own vertices that others have triangles at, too: those of others and own ones, sorted.
  std::vector<Corner> corners_at_shared_vertices() {
    Records_of_parts<Corner> told;
    const auto for_each_corner = [this](const auto& f) {
      for (std::size_t t = 0; t < part_.number_of_own_triangles(); ++t)
        for (const Number v : part_.triangles[t]) f(v, t);
    };
    for_each_corner([&](Number v, std::size_t t) {
      if (!part_.is_own_vertex(v)) told[part_.owner_of_vertex(v)].push_back(corner(v, t));
    });
    std::vector<Corner> corners = exchange_and_join(exchange_, std::move(told));
    std::vector<char> is_shared(part_.number_of_own_vertices(), false);
    for (const Corner& c : corners) is_shared[part_.index_of_vertex(c.vertex)] = true;
    for_each_corner([&](Number v, std::size_t t) {
      if (part_.is_own_vertex(v) && is_shared[part_.index_of_vertex(v)]) corners.push_back(corner(v, t));
    });
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  void check_ghosts() {
    const std::vector<Corner> corners = corners_at_shared_vertices();
    Records_of_parts<Corner> answers;
    for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
      std::set<int> owners;
      for (; end < corners.size() && corners[end].vertex == corners[begin].vertex; ++end)
        owners.insert(part_.owner_of_triangle(corners[end].triangle));
      for (std::size_t i = begin; i < end; ++i)
        for (const int rank : owners)
          if (rank != part_.owner_of_triangle(corners[i].triangle)) answers[rank].push_back(corners[i]);
    }
    std::map<Number, Corner> ghosts;
    for (const Corner& c : exchange_and_join(exchange_, std::move(answers))) ghosts[c.triangle] = c;
    agree_on_work(exchange_, [&] {
      check(ghosts.size() == part_.ghost_triangles.size(), "there are other ghosts");
      std::size_t t = part_.number_of_own_triangles();
      for (const auto& [number, ghost] : ghosts) {
        const Corner here = corner(0, t++);
        check(here.triangle == number && here.vertices == ghost.vertices && here.region == ghost.region,
              "a ghost is not " + name("triangle", number));
      }
    });
  }

  static std::array<Number, 2> side(const std::array<Number, 3>& t, std::size_t k) {
    const Number a = t[(k + 1) % 3], b = t[(k + 2) % 3];
    return {std::min(a, b), std::max(a, b)};
  }

  /// A side of a triangle.
  struct Triangle_side {
    std::array<Number, 2> vertices;
    Number triangle;
    bool operator<(const Triangle_side& other) const {
      return std::tie(vertices, triangle) < std::tie(other.vertices, other.triangle);
    }
  };

  void list_sides() {
    sides_.clear(), sides_.reserve(3 * part_.triangles.size());
    for (std::size_t t = 0; t < part_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        sides_.push_back({side(part_.triangles[t], k), part_.number_of_triangle(t)});
    std::sort(sides_.begin(), sides_.end());
  }

  void check_neighbors() const {
    for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      while (end < sides_.size() && sides_[end].vertices == sides_[begin].vertices) ++end;
      for (std::size_t i = begin; i < end; ++i) {
        const Number number = sides_[i].triangle, t = number - part_.number_of_triangle(0);
        if (t < 0 || t >= static_cast<Number>(part_.number_of_own_triangles())) continue; // a ghost
        if (end - begin > 2) fail(name("triangle", number) + " has a side with two others");
        if (!part_.has_neighbors) continue;
        const Number across = end - begin == 1 ? -1 : sides_[i == begin ? begin + 1 : begin].triangle;
        for (std::size_t k = 0; k < 3; ++k)
          if (side(part_.triangles[std::size_t(t)], k) == sides_[i].vertices &&
              part_.neighbors[std::size_t(t)][k] != across)
            fail(name("triangle", number) + " has another neighbor");
      }
    }
  }

  void check_edges() {
    const Triangle_runs numbers(static_cast<std::size_t>(part_.number_of_constrained_edges),
                                static_cast<std::size_t>(exchange_.size()));
    Records_of_parts<Number> told;
    agree_on_work(exchange_, [&] {
      Number before = -1;
      for (const auto& e : part_.constrained_edges) {
        check(e.number > before && e.number < part_.number_of_constrained_edges,
              "constrained edges are not in the order of their numbers");
        const auto vertices = side({-1, e.vertices[0], e.vertices[1]}, 0);
        const auto first = std::lower_bound(sides_.begin(), sides_.end(), Triangle_side{vertices, -1});
        const int owner = first == sides_.end() || first->vertices != vertices
                              ? part_.number_of_parts() - 1
                              : part_.owner_of_triangle(first->triangle);
        check(owner == part_.rank, name("constrained edge", e.number) + " is another rank's");
        told[static_cast<int>(numbers.run_of(static_cast<std::size_t>(e.number)))].push_back(e.number);
        before = e.number;
      }
      check(part_.outside_segments.empty() || part_.rank + 1 == part_.number_of_parts(),
            "segments outside are at the last rank with triangles");
    });
    std::vector<Number> found = exchange_and_join(exchange_, std::move(told));
    std::sort(found.begin(), found.end());
    const std::int64_t outside = exchange_.sum(static_cast<std::int64_t>(part_.outside_segments.size()));
    agree_on_work(exchange_, [&] {
      const auto rank = static_cast<std::size_t>(exchange_.rank());
      const std::size_t n = rank < numbers.size() ? numbers.begin(rank + 1) - numbers.begin(rank) : 0;
      check(found.size() == n && std::adjacent_find(found.begin(), found.end()) == found.end(),
            "not each constrained edge is at one rank");
      check(outside == part_.number_of_outside_segments, "there are other segments outside");
    });
  }

  Exchange& exchange_;
  const Part& part_;
  std::vector<Triangle_side> sides_; // of all triangles that are here, sorted
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_DEFECTS_H
