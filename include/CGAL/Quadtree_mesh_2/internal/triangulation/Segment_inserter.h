// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Makes segments chains of constrained edges of a triangulation, or of a block of one.
//
// A segment is recovered by flipping the edges that it crosses (Sloan, "A fast algorithm for generating
// constrained Delaunay triangulations", 1993). Then the flipped edges are made Delaunay again. A vertex on
// the segment splits it. Crossing a constrained edge is an error. Orientation is exact. O(1) for most
// segments of maps, which are edges already. O(k^2) flips in the worst case for k edges crossed.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_SEGMENT_INSERTER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_SEGMENT_INSERTER_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A piece of an input segment between two input vertices, by their numbers, with none in between.
struct Input_edge {
  Vertex_id a, b;
  Segment_index segment;
};
using Input_edge_list = Uninitialized_vector<Input_edge>;
/// The vertices at its ends.
using Segment_ends = std::array<Vertex_id, 2>;

/// The edges of the segments of a graph. Most segments are one edge each, and take no more room than they did.
struct Edges_of_segments {
  std::vector<Segment_ends> segments; ///< of those that are one edge; none for others
  Input_edge_list others;             ///< the edges of these

  /// Calls `f(edge)` for all, in parallel.
  template <class Function>
  void for_each(const Function& f) const {
    for_each_index<Chosen_tag>(segments.size(), [&](std::size_t s) {
      if (segments[s][0].is_valid()) f(Input_edge{segments[s][0], segments[s][1], Segment_index(s)});
    });
    for_each_index<Chosen_tag>(others.size(), [&](std::size_t i) { f(others[i]); });
  }

  /// A segment with an edge between two vertices. O(n)
  /// \pre there is one
  Segment_index find(Vertex_id a, Vertex_id b) const {
    for (std::size_t s = 0; s < segments.size(); ++s)
      if (segments[s] == Segment_ends{a, b} || segments[s] == Segment_ends{b, a}) return Segment_index(s);
    for (const Input_edge& e : others)
      if ((e.a == a && e.b == b) || (e.a == b && e.b == a)) return e.segment;
    return {};
  }

  /// Lists those between two vertices with the others. O(n)
  void list_between(Vertex_id a, Vertex_id b) {
    for (std::size_t s = 0; s < segments.size(); ++s) {
      if (segments[s] != Segment_ends{a, b} && segments[s] != Segment_ends{b, a}) continue;
      others.push_back({segments[s][0], segments[s][1], Segment_index(s)});
      segments[s] = {};
    }
  }
};

/// Two segments that cross; what the first triangulation cannot make.
struct Crossing {
  Segment_index segment;
  Vertex_id a, b; ///< input numbers of the ends of the constrained edge that is crossed
};

/// What came of segments.
struct Segments_made {
  std::vector<Input_edge> edges;
  std::vector<Input_edge> repeated_edges; ///< those that were there already, for an earlier segment
  std::size_t vertices_on_segments = 0;
};

template <class Geometry>
class Segment_inserter {
public:
  using Mesh = Kernel_mesh<Geometry>;

  explicit Segment_inserter(Mesh& mesh) : mesh_(mesh) {}

  /// What is not made of a segment: nothing if both ends are one.
  struct Rest {
    Vertex_id from, to;
    bool is_empty() const { return from == to; }
  };

  /// Makes the segment from a to b, vertices of the mesh, a chain of constrained edges. It is made from both ends,
  /// first where the way on is found earlier: the fan of the other may be that of a hub.
  /// \returns what is left because seams are in the way
  /// \throws Crossing if a constrained edge is in the way.
  Rest insert(Vertex_id a, Vertex_id b, Segment_index segment) {
    Rest rest{a, b};
    while (!rest.is_empty())
      if (!shorten(rest, segment)) break;
    return rest;
  }

  /// The same for a whole segment. If it becomes one edge, this is not listed, and the segment's ends are its ends from
  /// now on; else it has none, also where it crosses another.
  Rest insert_whole(Vertex_id a, Vertex_id b, Segment_index segment, Segment_ends& ends) {
    const std::size_t edges = result_.edges.size(), repeated = result_.repeated_edges.size();
    ends = {};
    const Rest rest = insert(a, b, segment);
    if (!rest.is_empty() || result_.edges.size() != edges + 1 || result_.repeated_edges.size() != repeated)
      return rest;
    ends = {result_.edges.back().a, result_.edges.back().b};
    result_.edges.pop_back();
    return rest;
  }

  /// Hands over what was made; it starts anew.
  Segments_made take() { return std::exchange(result_, {}); }

private:
  /// How a segment leaves its first vertex.
  struct Exit {
    Side along = Side::border(); ///< an edge on the segment, ending at `vertex`
    Vertex_id vertex;
    Side crossed = Side::border(); ///< else the first edge it crosses
  };

  Mesh& mesh_;
  Segments_made result_;
  std::vector<std::array<Vertex_id, 2>> crossed_, made_;
  std::vector<Side> doubtful_;

  /// Whether the segment a-b leaves a along the edge a-p.
  bool is_along(Vertex_id a, Vertex_id p, Vertex_id b, int orientation_apb) const {
    return orientation_apb == 0 && dot(Geometry::scaled_difference(mesh_.point(p), mesh_.point(a)),
                                       Geometry::scaled_difference(mesh_.point(b), mesh_.point(a))) > 0;
  }

  /// Looks for the exit in triangle t, which has a at slot i.
  bool find_exit(Triangle_id t, int i, Vertex_id a, Vertex_id b, Exit& exit) const {
    const auto& r = mesh_.triangle(t);
    const Vertex_id p = r.v[next_slot[i]], q = r.v[previous_slot[i]];
    const int op = mesh_.orientation(a, p, b);
    if (p == b || is_along(a, p, b, op)) {
      exit = {Side(t, previous_slot[i]), p, Side::border()};
      return true;
    }
    if (r.side[next_slot[i]].is_border() && // then this is the only triangle to look at the edge
        (q == b || is_along(a, q, b, mesh_.orientation(a, q, b)))) {
      exit = {Side(t, next_slot[i]), q, Side::border()};
      return true;
    }
    if (op <= 0 || mesh_.orientation(a, q, b) >= 0) return false;
    exit = {Side::border(), {}, Side(t, i)};
    return true;
  }

  /// How a segment leaves one of its ends.
  struct Way {
    Exit exit;
    bool is_from_first_end;
  };

  /// Goes around both ends in step, until it is found how the segment leaves one of them; nothing if that is beyond
  /// seams for both.
  std::optional<Way> way_between(Vertex_id a, Vertex_id b) const {
    Fan_walk<Mesh> at_a(mesh_, a), at_b(mesh_, b);
    Exit exit;
    for (bool is_a_open = true, is_b_open = true; is_a_open || is_b_open;
         is_a_open = is_a_open && at_a.advance(), is_b_open = is_b_open && at_b.advance()) {
      if (is_a_open && find_exit(at_a.triangle(), at_a.slot(), a, b, exit)) return Way{exit, true};
      if (is_b_open && find_exit(at_b.triangle(), at_b.slot(), b, a, exit)) return Way{exit, false};
    }
    return std::nullopt;
  }

  /// Makes a piece, at either end of what is left of a segment, up to the first vertex on it. \returns false if seams
  /// are in the way
  bool shorten(Rest& rest, Segment_index segment) {
    const auto [from, to] = rest;
    const Side edge = mesh_.find_side(from, to); // no orientation is asked: most segments of maps are edges
    if (!edge.is_border()) {
      if (!constrain(edge, from, to, segment)) return false;
      rest.from = to;
      return true;
    }
    const std::optional<Way> way = way_between(from, to);
    if (!way) return false;
    const bool is_from_first_end = way->is_from_first_end;
    const Vertex_id end = is_from_first_end ? make_piece(from, to, way->exit, segment)
                                            : make_piece(to, from, way->exit, segment);
    if (!end.is_valid()) return false;
    if (end != (is_from_first_end ? to : from)) ++result_.vertices_on_segments;
    (is_from_first_end ? rest.from : rest.to) = end;
    return true;
  }

  /// Makes the piece of the segment a-b that begins at a.
  /// \returns the vertex at which it ends, none if a seam is in the way
  Vertex_id make_piece(Vertex_id a, Vertex_id b, const Exit& exit, Segment_index segment) {
    if (exit.vertex.is_valid())
      return constrain(exit.along, a, exit.vertex, segment) ? exit.vertex : Vertex_id();
    const Vertex_id end = collect_crossed(a, b, exit.crossed, segment);
    if (!end.is_valid()) return {};
    const bool is_free = flip_crossed(a, end);
    const Side side = is_free ? mesh_.find_side(a, end) : Side::border();
    const bool is_made = !side.is_border() && constrain(side, a, end, segment);
    make_Delaunay();
    return is_made ? end : Vertex_id();
  }

  Input_edge named(Vertex_id a, Vertex_id b, Segment_index segment) const {
    return {mesh_.input_number(a), mesh_.input_number(b), segment};
  }

  /// \returns false at a seam, which keeps no constraint made now.
  bool constrain(Side s, Vertex_id a, Vertex_id b, Segment_index segment) {
    const Side o = mesh_.across(s);
    if (o.is_seam()) return false;
    if (o.is_constrained()) {
      result_.repeated_edges.push_back(named(a, b, segment));
      return true;
    }
    mesh_.constrain(s);
    result_.edges.push_back(named(a, b, segment));
    return true;
  }

  /// Lists the edges between a and the first vertex on the segment a-b; returns that vertex, none at a seam.
  Vertex_id collect_crossed(Vertex_id a, Vertex_id b, Side s, Segment_index segment) {
    crossed_.clear();
    for (;;) {
      const Vertex_id p = mesh_.source(s), q = mesh_.target(s); // p to the right of a-b, q to the left
      const Side o = mesh_.across(s);
      if (o.is_seam()) return {};
      if (o.is_constrained()) throw Crossing{segment, mesh_.input_number(p), mesh_.input_number(q)};
      crossed_.push_back({p, q});
      const Vertex_id d = mesh_.opposite(o);
      const int turn = d == b ? 0 : mesh_.orientation(a, b, d);
      if (turn == 0) return d;
      const auto& r = mesh_.triangle(o.triangle());
      s = Side(o.triangle(),
               Mesh::slot_of(r, turn > 0 ? q : p)); // leave across the edge that d shares with the other
    }
  }

  /// \returns false if a side could not be found, because of seams.
  bool flip_crossed(Vertex_id a, Vertex_id end) {
    made_.clear();
    for (std::size_t i = 0; i < crossed_.size(); ++i) {
      const auto [p, q] = crossed_[i];
      const Side s = mesh_.find_side(p, q);
      if (s.is_border()) return false;
      const Side o = mesh_.across(s);
      const Vertex_id A = mesh_.opposite(s), B = mesh_.source(s), C = mesh_.target(s), D = mesh_.opposite(o);
      if (mesh_.orientation(A, B, D) <= 0 || mesh_.orientation(A, D, C) <= 0) {
        crossed_.push_back({p, q}); // not convex yet: later
        continue;
      }
      mesh_.flip(s.triangle(), s.slot());
      if (is_crossing(a, end, A, D))
        crossed_.push_back({A, D});
      else
        made_.push_back({A, D});
    }
    return true;
  }

  bool is_crossing(Vertex_id a, Vertex_id b, Vertex_id c, Vertex_id d) const {
    if (c == a || c == b || d == a || d == b) return false;
    return mesh_.orientation(a, b, c) * mesh_.orientation(a, b, d) < 0;
  }

  void make_Delaunay() {
    for (const auto& [p, q] : made_) {
      const Side s = mesh_.find_side(p, q);
      if (s.is_border()) continue; // flipped away already
      doubtful_.push_back(s);
      mesh_.make_Delaunay(doubtful_);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_SEGMENT_INSERTER_H
