// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which way the constrained edges of a mesh in flat arrays go along their segments.
//
// Computes: chains. A chain is the pieces of a segment from one input vertex to the next. It is known by its
//           links, whatever the places of its vertices. Each piece gets the direction of its chain.
// Bound: O(n).
//
// Rounding may put the end of a piece behind its source although both triangles at it are counterclockwise.
// goes_ahead() is the exact predicate for that. The checker of meshes asks the same.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_SEGMENT_CHAINS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_SEGMENT_CHAINS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The unit in the last place of a double.
inline double unit_in_last_place_of(double x) {
  return std::nextafter(std::fabs(x), std::numeric_limits<double>::infinity()) - std::fabs(x);
}

/// Pieces are the mesh's constrained edges, by their numbers.
template <class Point>
class Segment_chains {
public:
  using Mesh = Indexed_mesh_2<Point>;

  explicit Segment_chains(const Mesh& mesh)
      : mesh_(mesh), pieces_(mesh.constrained_edges.size()),
        pieces_at_(mesh.points.size() - mesh.number_of_input_vertices, {none, none}) {
    for (std::uint32_t e = 0; e < pieces_.size(); ++e)
      for (const Vertex_index v : ends(e)) {
        if (is_input(v)) continue;
        std::array<std::uint32_t, 2>& at = pieces_at_[steiner_number(v)];
        (at[0] == none ? at[0] : at[1]) = e;
      }
    for (std::uint32_t e = 0; e < pieces_.size(); ++e)
      for (const Vertex_index v : ends(e))
        if (is_input(v) && pieces_[e].chain == none) walk(e, v);
  }

  /// Whether piece `e` goes ahead from an end of its chain to the other.
  bool goes_ahead(std::size_t e) const {
    const Piece& piece = pieces_[e];
    if (piece.chain == none) return true;
    const std::array<Vertex_index, 2>& chain = chains_[piece.chain];
    return Predicates::Angle_2()(place(chain[0]), place(chain[1]), place(piece.from), place(piece.to)) ==
           ACUTE;
  }

  /// The units in the last place of the larger coordinates of the ends of the chain of `e`.
  std::array<double, 2> units(std::size_t e) const {
    const Piece& piece = pieces_[e];
    if (piece.chain == none) return {0, 0};
    const Point &p = mesh_.point(chains_[piece.chain][0]), &q = mesh_.point(chains_[piece.chain][1]);
    return {unit_in_last_place_of(std::max(std::fabs(p.x()), std::fabs(q.x()))),
            unit_in_last_place_of(std::max(std::fabs(p.y()), std::fabs(q.y())))};
  }

  /// The place on the chain of `e`, up to rounding, that has the same x as `p`, or y where the chain is steep.
  Point place_beside(std::size_t e, const Point& p) const {
    const Piece& piece = pieces_[e];
    if (piece.chain == none) return p;
    const Point &a = mesh_.point(chains_[piece.chain][0]), &b = mesh_.point(chains_[piece.chain][1]);
    const double dx = b.x() - a.x(), dy = b.y() - a.y();
    const bool is_steep = std::fabs(dy) > std::fabs(dx);
    const double other = is_steep ? a.x() + (p.y() - a.y()) / dy * dx : a.y() + (p.x() - a.x()) / dx * dy;
    if (!std::isfinite(other)) return p;
    return is_steep ? Point(other, p.y()) : Point(p.x(), other);
  }

  /// The vertices from which and to which piece `e` goes.
  std::array<Vertex_index, 2> ends_of_piece(std::size_t e) const { return {pieces_[e].from, pieces_[e].to}; }
  /// Those of its chain, which are input vertices; invalid if `e` is in none.
  std::array<Vertex_index, 2> ends_of_chain(std::size_t e) const {
    return pieces_[e].chain == none ? std::array<Vertex_index, 2>() : chains_[pieces_[e].chain];
  }

  /// Vertex `v` of piece `e` becomes `w`.
  void replace_end(std::size_t e, Vertex_index v, Vertex_index w) {
    Piece& piece = pieces_[e];
    (piece.from == v ? piece.from : piece.to) = w;
  }

private:
  using Predicates = Exact_predicates_inexact_constructions_kernel;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Piece {
    Vertex_index from, to; // as its chain goes
    std::uint32_t chain = none;
  };

  const Mesh& mesh_;
  std::vector<Piece> pieces_;
  std::vector<std::array<Vertex_index, 2>> chains_;     // the ends of each
  std::vector<std::array<std::uint32_t, 2>> pieces_at_; // at each Steiner vertex

  const std::array<Vertex_index, 2>& ends(std::uint32_t e) const {
    return mesh_.constrained_edges[e].vertices;
  }
  bool is_input(Vertex_index v) const { return std::size_t(v) < mesh_.number_of_input_vertices; }
  std::size_t steiner_number(Vertex_index v) const { return std::size_t(v) - mesh_.number_of_input_vertices; }
  Predicates::Point_2 place(Vertex_index v) const {
    return Predicates::Point_2(mesh_.point(v).x(), mesh_.point(v).y());
  }

  /// From the input vertex `first` along `e` to the next input vertex.
  void walk(std::uint32_t e, Vertex_index first) {
    const auto chain = static_cast<std::uint32_t>(chains_.size());
    Vertex_index v = first;
    while (e != none && pieces_[e].chain == none) {
      const Vertex_index w = ends(e)[0] == v ? ends(e)[1] : ends(e)[0];
      pieces_[e] = {v, w, chain};
      v = w;
      if (is_input(v)) break;
      const std::array<std::uint32_t, 2>& at = pieces_at_[steiner_number(v)];
      e = at[0] == e ? at[1] : at[0];
    }
    chains_.push_back({first, v});
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_SEGMENT_CHAINS_H
