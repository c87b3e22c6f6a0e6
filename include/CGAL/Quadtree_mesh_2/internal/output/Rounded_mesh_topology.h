// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Changes of a mesh in flat arrays that keep it conforming: other diagonals, and merging a Steiner vertex
// with a neighbor. This header says which changes are possible. The caller decides which are good
// (Rounded_mesh_repairer.h).
//
// Making the tables takes O(n). A change takes time in proportion to the degrees of its vertices. What
// merging takes away stays in the arrays until compress().

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_ROUNDED_MESH_TOPOLOGY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_ROUNDED_MESH_TOPOLOGY_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Segment_chains.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Rounded_mesh_topology {
public:
  using Corners = std::array<Vertex_index, 3>;
  using Star = std::vector<Triangle_index>;

  Rounded_mesh_topology(Indexed_mesh_2<Point>& mesh, Segment_chains<Point>& chains)
      : mesh_(mesh), chains_(chains), triangle_of_(mesh.points.size()), border_edges_(mesh.points.size(), 0),
        is_dead_(mesh.triangles.size(), 0), is_piece_dead_(mesh.constrained_edges.size(), 0) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        triangle_of_[mesh.triangles[t][k]] = Triangle_index(t);
        if (mesh.neighbors[t][k].is_valid()) continue;
        ++border_edges_[mesh.triangles[t][(k + 1) % 3]];
        ++border_edges_[mesh.triangles[t][(k + 2) % 3]];
      }
    piece_of_.reserve(mesh.constrained_edges.size());
    for (std::size_t e = 0; e < mesh.constrained_edges.size(); ++e) {
      const auto& ends = mesh.constrained_edges[e].vertices;
      piece_of_.emplace(key(ends[0], ends[1]), e);
    }
  }

  bool is_alive(Triangle_index t) const { return is_dead_[t] == 0; }
  bool is_used(Vertex_index v) const { return triangle_of_[v].is_valid(); }
  /// Whether a Steiner vertex is neither on a segment nor on the border.
  bool is_free(Vertex_index v) const { return border_edges_[v] == 0 && !is_on_segment(v); }
  bool is_on_segment(Vertex_index v) const { return segment(v).is_valid(); }

  /// The triangles at v, those of one fan if v is an input vertex where parts of the domain merely touch.
  Star star(Vertex_index v) const {
    Star result;
    const Triangle_index start = triangle_of_[v];
    for (Triangle_index t = start;;) {
      result.push_back(t);
      t = across(t, next(slot_of(t, v)));
      if (t == start) return result;
      if (!t.is_valid()) break;
    }
    for (Triangle_index t = across(start, previous(slot_of(start, v))); t.is_valid();
         t = across(t, previous(slot_of(t, v))))
      result.push_back(t);
    return result;
  }

  /// The triangles at a piece of a segment, of which an end is a Steiner vertex.
  Star triangles_at(std::size_t piece) const {
    const auto& ends = mesh_.constrained_edges[piece].vertices;
    const std::size_t slot = is_input(ends[0]) ? 1 : 0;
    Star result;
    for (const Triangle_index t : star(ends[slot]))
      if (has(t, ends[1 - slot])) result.push_back(t);
    return result;
  }

  static constexpr std::size_t no_piece = std::numeric_limits<std::size_t>::max();

  /// A triangle and, for each side from a corner to the next, the piece of a segment that it is.
  struct Bordered_triangle {
    Corners corners;
    std::array<std::size_t, 3> pieces;
  };

  Bordered_triangle bordered(const Corners& r) const {
    Bordered_triangle result{r, {no_piece, no_piece, no_piece}};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto piece = piece_of_.find(key(r[k], r[next(k)]));
      if (piece != piece_of_.end()) result.pieces[k] = piece->second;
    }
    return result;
  }
  std::vector<Bordered_triangle> bordered(const Star& star) const {
    std::vector<Bordered_triangle> result;
    result.reserve(star.size());
    for (const Triangle_index t : star) result.push_back(bordered(corners(t)));
    return result;
  }

  /// A piece of a segment that ends at v, if v is on a segment.
  std::optional<std::size_t> piece_at(Vertex_index v, const Star& star_of_v) const {
    for (const Triangle_index t : star_of_v)
      for (const Vertex_index w : corners(t)) {
        const auto piece = piece_of_.find(key(v, w));
        if (piece != piece_of_.end()) return piece->second;
      }
    return std::nullopt;
  }

  std::vector<Vertex_index> neighbors_in(const Star& star, Vertex_index v) const {
    std::vector<Vertex_index> result;
    for (const Triangle_index t : star)
      for (const Vertex_index w : corners(t))
        if (w != v) result.push_back(w);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// Whether the quadrilateral at side k of t may have its other diagonal. That must not be an edge already, which it
  /// may be where triangles are flat or clockwise.
  bool may_flip(Triangle_index t, int k) const {
    const auto slot = static_cast<std::size_t>(k);
    if (!across(t, slot).is_valid()) return false;
    const Quadrilateral q = quadrilateral(t, slot);
    return !is_constrained(q.b, q.c) && !may_be_edge(q.a, q.d);
  }

  /// The two triangles that come of the quadrilateral at side k of t.
  /// \pre may_flip(t, k)
  std::array<Corners, 2> flipped(Triangle_index t, int k) const {
    const Quadrilateral q = quadrilateral(t, std::size_t(k));
    return {Corners{q.a, q.b, q.d}, Corners{q.a, q.d, q.c}};
  }

  /// \pre may_flip(t, k)
  void flip(Triangle_index t, int k) {
    const Quadrilateral q = quadrilateral(t, std::size_t(k));
    const Triangle_index u = q.other;
    const Triangle_index bd = across_edge(u, q.b, q.d), dc = across_edge(u, q.d, q.c),
                         ca = across_edge(t, q.c, q.a), ab = across_edge(t, q.a, q.b);
    relink(bd, q.b, q.d, t), relink(ca, q.c, q.a, u);
    mesh_.triangles[t.value()] = {q.a, q.b, q.d}, mesh_.neighbors[t.value()] = {bd, u, ab};
    mesh_.triangles[u.value()] = {q.a, q.d, q.c}, mesh_.neighbors[u.value()] = {dc, ca, t};
    for (const Vertex_index v : {q.a, q.b, q.d}) triangle_of_[v] = t;
    triangle_of_[q.c] = u;
  }

  /// Whether Steiner vertex v can become its neighbor w: segments stay chains of edges, the border stays one, and
  /// no two triangles come to share two sides.
  bool may_merge(Vertex_index v, Vertex_index w, const Star& star_of_v) const {
    if (has_several_fans(w)) return false;
    if (segment(v).is_valid()) {
      if (!is_constrained(v, w)) return false;
      if (segment(w).is_valid() ? segment(w) != segment(v) : !is_input(w)) return false;
    } else if (border_edges_[v] > 0) {
      return false;
    }
    std::size_t shared = 0;
    for (const Triangle_index t : star_of_v) {
      if (!has(t, w)) continue;
      ++shared;
      if (is_constrained(v, apex(t, v, w))) return false;
    }
    const std::vector<Vertex_index> at_v = neighbors_in(star_of_v, v), at_w = neighbors_in(star(w), w);
    std::vector<Vertex_index> common;
    std::set_intersection(at_v.begin(), at_v.end(), at_w.begin(), at_w.end(), std::back_inserter(common));
    return common.size() == shared && star_of_v.size() > shared;
  }

  /// \pre may_merge(v, w, star_of_v)
  void merge(Vertex_index v, Vertex_index w, const Star& star_of_v) {
    for (const Triangle_index t : star_of_v)
      if (has(t, w)) close(t, v, w);
    Vertex_index other_end;
    for (const Triangle_index t : star_of_v) {
      for (const Vertex_index x : corners(t))
        if (x != v && x != w && is_constrained(v, x)) other_end = x;
      if (!is_alive(t)) continue;
      std::replace(mesh_.triangles[t.value()].begin(), mesh_.triangles[t.value()].end(), v, w);
      triangle_of_[w] = t;
    }
    if (other_end.is_valid()) join_pieces(v, w, other_end);
    triangle_of_[v] = Triangle_index();
  }

  /// Takes out dead triangles, pieces and Steiner vertices. Returns the new index of each triangle.
  std::vector<Triangle_index> compress() {
    Indexed_vector<Vertex_index, Vertex_index> new_vertex(mesh_.points.size());
    std::size_t kept = 0;
    for (const Vertex_index v : new_vertex.ids())
      if (is_input(v) || is_used(v)) {
        new_vertex[v] = Vertex_index(kept);
        mesh_.points[kept] = mesh_.point(v);
        mesh_.segment_of_vertex[kept] = segment(v);
        if (!mesh_.vertex_markers.empty()) mesh_.vertex_markers[kept] = mesh_.marker(v);
        ++kept;
      }
    mesh_.points.erase(mesh_.points.begin() + std::ptrdiff_t(kept), mesh_.points.end());
    mesh_.segment_of_vertex.resize(kept);
    if (!mesh_.vertex_markers.empty()) mesh_.vertex_markers.resize(kept);
    compress_pieces(new_vertex);
    return compress_triangles(new_vertex);
  }

private:
  struct Quadrilateral {
    Vertex_index a, b, d, c; // counterclockwise; the triangle is a, b, c
    Triangle_index other;
  };
  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  Indexed_mesh_2<Point>& mesh_;
  Segment_chains<Point>& chains_;
  Indexed_vector<Vertex_index, Triangle_index> triangle_of_;
  Indexed_vector<Vertex_index, std::uint32_t> border_edges_; // at each vertex
  Indexed_vector<Triangle_index, char> is_dead_;
  std::vector<char> is_piece_dead_;
  std::unordered_map<Ends, std::size_t, boost::hash<Ends>> piece_of_; // by the ends of constrained edges

  static std::size_t next(std::size_t slot) { return (slot + 1) % 3; }
  static std::size_t previous(std::size_t slot) { return (slot + 2) % 3; }
  static Ends key(Vertex_index v, Vertex_index w) {
    return {std::min(v.value(), w.value()), std::max(v.value(), w.value())};
  }

  const Corners& corners(Triangle_index t) const { return mesh_.triangles[t.value()]; }
  Triangle_index across(Triangle_index t, std::size_t slot) const { return mesh_.neighbors[t.value()][slot]; }
  Segment_index segment(Vertex_index v) const { return mesh_.segment_of_vertex[v.value()]; }
  bool is_input(Vertex_index v) const { return v.value() < mesh_.number_of_input_vertices; }
  bool is_constrained(Vertex_index v, Vertex_index w) const { return piece_of_.count(key(v, w)) > 0; }
  bool has_several_fans(Vertex_index v) const { return border_edges_[v] > 2; }
  /// Whether v and w are neighbors, or both of several fans, which star() does not all know.
  bool may_be_edge(Vertex_index v, Vertex_index w) const {
    if (has_several_fans(v)) std::swap(v, w);
    if (has_several_fans(v)) return true;
    const Star star_of_v = star(v);
    return std::any_of(star_of_v.begin(), star_of_v.end(), [&](Triangle_index t) { return has(t, w); });
  }
  bool has(Triangle_index t, Vertex_index v) const {
    return std::find(corners(t).begin(), corners(t).end(), v) != corners(t).end();
  }
  std::size_t slot_of(Triangle_index t, Vertex_index v) const {
    return static_cast<std::size_t>(std::find(corners(t).begin(), corners(t).end(), v) - corners(t).begin());
  }
  Vertex_index apex(Triangle_index t, Vertex_index v, Vertex_index w) const {
    return corners(t)[apex_slot(t, v, w)];
  }
  std::size_t apex_slot(Triangle_index t, Vertex_index v, Vertex_index w) const {
    std::size_t slot = 0;
    while (corners(t)[slot] == v || corners(t)[slot] == w) ++slot;
    return slot;
  }
  Triangle_index across_edge(Triangle_index t, Vertex_index v, Vertex_index w) const {
    return across(t, apex_slot(t, v, w));
  }

  /// Makes `other` what lies across the edge v, w of t, if there is a t.
  void relink(Triangle_index t, Vertex_index v, Vertex_index w, Triangle_index other) {
    if (t.is_valid()) mesh_.neighbors[t.value()][apex_slot(t, v, w)] = other;
  }

  Quadrilateral quadrilateral(Triangle_index t, std::size_t k) const {
    const Vertex_index a = corners(t)[k], b = corners(t)[next(k)], c = corners(t)[previous(k)];
    const Triangle_index u = across(t, k);
    return {a, b, apex(u, b, c), c, u};
  }

  /// Takes out t, whose sides at v and w become one.
  void close(Triangle_index t, Vertex_index v, Vertex_index w) {
    const Vertex_index a = apex(t, v, w);
    const Triangle_index at_v = across_edge(t, v, a), at_w = across_edge(t, w, a);
    relink(at_v, v, a, at_w), relink(at_w, w, a, at_v);
    triangle_of_[a] = at_v;
    is_dead_[t] = 1;
  }

  /// The pieces v-w and v-x of a segment become w-x.
  void join_pieces(Vertex_index v, Vertex_index w, Vertex_index x) {
    const auto gone = piece_of_.find(key(v, w)), kept = piece_of_.find(key(v, x));
    is_piece_dead_[gone->second] = 1;
    auto& ends = mesh_.constrained_edges[kept->second].vertices;
    std::replace(ends.begin(), ends.end(), v, w);
    chains_.replace_end(kept->second, v, w);
    piece_of_.emplace(key(w, x), kept->second);
    piece_of_.erase(key(v, w)), piece_of_.erase(key(v, x));
  }

  void compress_pieces(const Indexed_vector<Vertex_index, Vertex_index>& new_vertex) {
    auto& pieces = mesh_.constrained_edges;
    std::size_t kept = 0;
    for (std::size_t e = 0; e < pieces.size(); ++e) {
      if (is_piece_dead_[e] != 0) continue;
      for (Vertex_index& v : pieces[e].vertices) v = new_vertex[v];
      pieces[kept++] = pieces[e];
    }
    pieces.resize(kept);
  }

  std::vector<Triangle_index>
  compress_triangles(const Indexed_vector<Vertex_index, Vertex_index>& new_vertex) {
    std::vector<Triangle_index> new_triangle(mesh_.triangles.size());
    std::size_t kept = 0;
    for (std::size_t t = 0; t < new_triangle.size(); ++t)
      if (is_alive(Triangle_index(t))) new_triangle[t] = Triangle_index(kept++);
    for (std::size_t t = 0; t < new_triangle.size(); ++t) {
      if (!is_alive(Triangle_index(t))) continue;
      const std::size_t to(new_triangle[t]);
      for (std::size_t k = 0; k < 3; ++k) {
        mesh_.triangles[to][k] = new_vertex[mesh_.triangles[t][k]];
        const Triangle_index n = mesh_.neighbors[t][k];
        mesh_.neighbors[to][k] = n.is_valid() ? new_triangle[n.value()] : n;
      }
      if (!mesh_.region_of_triangle.empty()) mesh_.region_of_triangle[to] = mesh_.region_of_triangle[t];
    }
    mesh_.triangles.resize(kept), mesh_.neighbors.resize(kept);
    if (!mesh_.region_of_triangle.empty()) mesh_.region_of_triangle.resize(kept);
    return new_triangle;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_ROUNDED_MESH_TOPOLOGY_H
