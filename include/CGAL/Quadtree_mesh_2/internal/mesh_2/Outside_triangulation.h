// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_OUTSIDE_TRIANGULATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_OUTSIDE_TRIANGULATION_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Indexed_cdt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What lies around a mesh: a constrained Delaunay triangulation of the mesh's border, the input vertices
/// outside and the segments outside, up to the convex hull.
///
/// The border is taken as it is, edge by edge: a vertex on it can lie an ulp off the straight line. Faces on
/// the mesh's side of the border are marked inside. O(b log b) in practice for b border edges and outside
/// vertices and segments; O(n log n) in the size of the input as well if some input segment is not in the
/// mesh from end to end.
template <class Kernel>
class Outside_triangulation {
public:
  using Point = typename Kernel::Point_2;
  static constexpr std::uint32_t none = 0xffffffffu;

  struct Face_info {
    bool is_inside = false;
    std::uint32_t number = none; ///< for the use of the caller
    /// Per side, the side `3 t + k` of mesh triangle `t` that is this edge.
    std::array<std::uint32_t, 3> mesh_side{none, none, none};
  };
  using Triangulation = Indexed_cdt<Kernel, Face_info>;
  using Face_handle = typename Triangulation::Face_handle;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Cdt = typename Triangulation::Cdt;

  using Segments = std::vector<std::array<std::uint32_t, 2>>;

  /// \pre `mesh.neighbors` is complete.
  /// \throws Pslg_error_2 if border edges, outside segments and outside vertices meet where they should not.
  Outside_triangulation(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg)
      : Outside_triangulation(mesh, pslg.vertices.size()) {
    find_outside_pieces(pslg);
    build();
  }

  /// The same where it is known which segments are outside; no vertex lies on one of them.
  Outside_triangulation(const Indexed_mesh_2<Point>& mesh, std::size_t number_of_input_vertices,
                        const Segments& outside_segments)
      : Outside_triangulation(mesh, number_of_input_vertices) {
    outside_pieces_ = outside_segments;
    build();
  }
  int dimension() const { return cdt_.cdt().dimension(); }
  Cdt& cdt() { return cdt_.cdt(); }
  bool is_used(std::uint32_t v) const { return is_used_[v] != 0; }
  std::size_t number_of_border_sides() const { return border_.size(); }
  /// The index of a vertex of `cdt()`; one that the mesh uses if there is one at this place.
  std::uint32_t index(Vertex_handle v) const {
    const std::uint32_t place = v->info();
    return used_at_[place] == none ? place : used_at_[place];
  }

private:
  Outside_triangulation(const Indexed_mesh_2<Point>& mesh, std::size_t number_of_input_vertices)
      : mesh_(mesh), number_of_input_vertices_(number_of_input_vertices), is_used_(mesh.points.size(), 0),
        is_chosen_(mesh.points.size(), 0), cdt_(mesh.points, choose_vertices()),
        used_at_(mesh.points.size(), none) {
    for (std::uint32_t side : border_) used_at_[cdt_.place(origin(side))] = origin(side);
  }

  void build() {
    insert_segments();
    if (cdt_.has_crossings())
      throw Pslg_error_2(Pslg_error_2::Kind::ROUNDING,
                         "border edges of the mesh and input segments outside it cross after rounding");
    if (dimension() == 2) mark_inside();
  }

  std::uint32_t vertex(std::uint32_t side, std::uint32_t offset) const {
    return mesh_.triangles[side / 3][(side % 3 + offset) % 3].value();
  }
  std::uint32_t origin(std::uint32_t side) const { return vertex(side, 1); }
  std::uint32_t target(std::uint32_t side) const { return vertex(side, 2); }

  /// Those on the border, and the input vertices that the mesh does not use.
  std::vector<std::size_t> choose_vertices() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        is_used_[mesh_.triangles[t][k].value()] = 1;
        if (mesh_.neighbors[t][k].is_valid()) continue;
        border_.push_back(3 * t + k);
        is_chosen_[origin(border_.back())] = 1;
      }
    std::vector<std::size_t> chosen;
    for (std::size_t v = 0; v < is_chosen_.size(); ++v) {
      if (v < number_of_input_vertices_ && is_used_[v] == 0) is_chosen_[v] = 1;
      if (is_chosen_[v] != 0) chosen.push_back(v);
    }
    return chosen;
  }

  static std::uint64_t mix(std::uint64_t x) { // a bijection without structure (splitmix64)
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  /// Finds the pieces of segments with the outside on both sides. Most inputs have none, and this is seen in
  /// linear time: the edges of a segment form a path from end to end, where every vertex but the ends occurs
  /// twice.
  void find_outside_pieces(const Pslg_2<Point>& pslg) {
    Indexed_vector<Segment_index, std::uint64_t> odd(pslg.segments.size(), 0);
    for (const auto& e : mesh_.constrained_edges)
      if (odd.has(e.segment)) // else `pslg` is not the mesh's, but an empty one
        odd[e.segment] ^= mix(e.vertices[0].value()) ^ mix(e.vertices[1].value());
    bool is_complete = true;
    for (const Segment_index s : odd.ids()) {
      odd[s] ^= mix(pslg.segment(s)[0].value()) ^ mix(pslg.segment(s)[1].value());
      is_complete = is_complete && odd[s] == 0;
    }
    if (is_complete) return;
    const std::vector<Piece> pieces = pieces_of(pslg);
    const auto spokes = spokes_of_mesh(odd);
    for (const Piece& piece : pieces)
      if (odd[Segment_index(piece.segment)] != 0 && is_chosen_[piece.ends[0]] != 0 &&
          is_chosen_[piece.ends[1]] != 0 && !has_spoke_along(spokes, piece))
        outside_pieces_.push_back(piece.ends);
  }

  /// An edge between places of input vertices, with none between them, on an input segment: the first of those that
  /// cover it.
  struct Piece {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t segment;
  };

  /// The pieces of all segments. Sets `input_place_`.
  std::vector<Piece> pieces_of(const Pslg_2<Point>& pslg) {
    struct Seen_sides {
      std::array<bool, 3> is_seen{};
    };
    using Input_cdt = Indexed_cdt<Kernel, Seen_sides, No_constraint_intersection_requiring_constructions_tag>;
    std::vector<std::size_t> all(pslg.vertices.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    Input_cdt input(pslg.vertices, std::move(all));
    for (const auto& s : pslg.segments) input.count_segment(s[0].value(), s[1].value());
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      input.insert_segment(pslg.segments[s][0].value(), pslg.segments[s][1].value());
      if (input.has_crossings())
        throw Pslg_error_2(Pslg_error_2::Kind::CROSSING,
                           "input segment " + std::to_string(s) + " crosses an earlier one",
                           Pslg_parts_2().segment(Segment_index(s)));
    }
    for (std::uint32_t v = 0; v < pslg.vertices.size(); ++v) input_place_.push_back(input.place(v));

    std::vector<Piece> pieces;
    for (std::uint32_t s = 0; s < pslg.segments.size(); ++s) {
      const auto& [a, b] = pslg.segments[s];
      input.walk_segment(a.value(), b.value(), [&](auto f, int i, bool) {
        if (f->info().is_seen[std::size_t(i)]) return;
        f->info().is_seen[std::size_t(i)] = true;
        if (input.cdt().dimension() == 2)
          f->neighbor(i)->info().is_seen[std::size_t(input.cdt().mirror_index(f, i))] = true;
        pieces.push_back({{f->vertex(Cdt::ccw(i))->info(), f->vertex(Cdt::cw(i))->info()}, s});
      });
    }
    return pieces;
  }

  /// An edge of the mesh on a segment, seen from an input vertex, or the place of one.
  struct Spoke {
    std::uint32_t segment, from, to;
    friend bool operator<(const Spoke& s, const Spoke& t) {
      return s.segment != t.segment ? s.segment < t.segment : s.from < t.from;
    }
  };

  /// Those on segments that are not in the mesh from end to end, sorted.
  std::vector<Spoke> spokes_of_mesh(const Indexed_vector<Segment_index, std::uint64_t>& odd) const {
    std::vector<Spoke> spokes;
    for (const auto& e : mesh_.constrained_edges) {
      if (!odd.has(e.segment) || odd[e.segment] == 0) continue;
      for (std::size_t i = 0; i < 2; ++i)
        if (e.vertices[i].value() < number_of_input_vertices_)
          spokes.push_back(
              {e.segment.value(), input_place_[e.vertices[i].value()], e.vertices[1 - i].value()});
    }
    std::sort(spokes.begin(), spokes.end());
    return spokes;
  }

  /// Whether the mesh has an edge that leaves an end of the piece along it: then it has the whole piece, by whatever
  /// rule its domain was chosen.
  bool has_spoke_along(const std::vector<Spoke>& spokes, const Piece& piece) const {
    const Point &p = mesh_.points[piece.ends[0]], &q = mesh_.points[piece.ends[1]];
    const auto [begin, end] =
        std::equal_range(spokes.begin(), spokes.end(), Spoke{piece.segment, piece.ends[0], 0});
    return std::any_of(begin, end, [&](const Spoke& s) {
      return typename Kernel::Angle_2()(mesh_.points[s.to], p, q) == ACUTE;
    });
  }

  void insert_segments() {
    for (std::uint32_t side : border_) cdt_.count_segment(origin(side), target(side));
    for (const auto& ends : outside_pieces_) cdt_.count_segment(ends[0], ends[1]);
    for (std::uint32_t side : border_) cdt_.insert_segment(origin(side), target(side));
    for (const auto& ends : outside_pieces_) cdt_.insert_segment(ends[0], ends[1]);
  }

  /// Marks the faces that a border edge has on its left, and from there all up to the border.
  void mark_inside() {
    std::vector<Face_handle> stack;
    for (std::uint32_t side : border_) {
      const std::uint32_t a = origin(side), b = target(side);
      std::size_t steps = 0;
      const bool is_path = cdt_.walk_segment(a, b, [&](Face_handle f, int i, bool is_left_of_walk) {
        ++steps;
        const Face_handle g = f->neighbor(i);
        const int j = cdt_.cdt().mirror_index(f, i);
        f->info().mesh_side[std::size_t(i)] = side;
        g->info().mesh_side[std::size_t(j)] = side;
        stack.push_back(is_left_of_walk != cdt_.is_reversed(a, b) ? f : g);
      });
      if (!is_path || steps != 1) throw border_is_hit(a, b);
    }
    while (!stack.empty()) {
      const Face_handle f = stack.back();
      stack.pop_back();
      if (f->info().is_inside) continue;
      f->info().is_inside = true;
      CGAL_assertion(!cdt_.cdt().is_infinite(f));
      for (int i = 0; i < 3; ++i)
        if (f->info().mesh_side[std::size_t(i)] == none) stack.push_back(f->neighbor(i));
    }
  }

  Pslg_error_2 border_is_hit(std::uint32_t a, std::uint32_t b) const {
    Pslg_parts_2 parts;
    for (const std::uint32_t v : {a, b})
      if (v < number_of_input_vertices_) parts.vertex(Vertex_index(v));
    return {Pslg_error_2::Kind::ROUNDING,
            "vertices outside the domain lie on edge " + std::to_string(a) + " " + std::to_string(b) +
                " of the mesh's border after rounding",
            std::move(parts)};
  }

  const Indexed_mesh_2<Point>& mesh_;
  std::size_t number_of_input_vertices_;
  std::vector<char> is_used_, is_chosen_;
  std::vector<std::uint32_t> border_; // sides without a neighbor
  Triangulation cdt_;
  std::vector<std::uint32_t> used_at_; // by place
  Segments outside_pieces_;
  std::vector<std::uint32_t> input_place_; // by input vertex
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_OUTSIDE_TRIANGULATION_H
