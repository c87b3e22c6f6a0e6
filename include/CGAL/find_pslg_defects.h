// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_FIND_PSLG_DEFECTS_H
#define CGAL_FIND_PSLG_DEFECTS_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/arrange_pslg_2.h>
#include <CGAL/validate_pslg_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

// Lists everything that keeps a graph from being a planar straight-line graph, without changing it. If no
// segments cross, this costs one constrained Delaunay triangulation with exact predicates. Otherwise a second
// one with exact constructions finds every crossing.

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// The kinds of defects, and the fields of `Pslg_defect_2` that they use.
enum class Pslg_defect_kind_2 {
  DUPLICATE_VERTEX,     ///< `vertex` is at the place of the earlier `other_vertex`
  ZERO_LENGTH_SEGMENT,  ///< the ends of `segment` are at one place
  VERTEX_ON_SEGMENT,    ///< `vertex` lies inside `segment`
  OVERLAPPING_SEGMENTS, ///< `segment` and the earlier `other_segment` share a piece, or coincide
  CROSSING_SEGMENTS     ///< `segment` and the earlier `other_segment` cross at `point`, not at a vertex
};

/// \ingroup PkgQuadtreeMesh2Data
/// Something that a planar straight-line graph must not have. Fields that the kind does not use are invalid.
struct Pslg_defect_2 {
  Pslg_defect_kind_2 kind; ///< what is wrong
  std::array<double, 2>
      point; ///< where: the vertex, the crossing, the first end of the segment or of the shared piece
  Quadtree_mesh_2::Vertex_index vertex;         ///< the vertex at fault
  Quadtree_mesh_2::Vertex_index other_vertex;   ///< an earlier vertex
  Quadtree_mesh_2::Segment_index segment;       ///< the segment at fault
  Quadtree_mesh_2::Segment_index other_segment; ///< an earlier segment

  /// One line for human readers.
  std::string to_string() const;
};

namespace Quadtree_mesh_2 {
namespace internal {

/// Searches an arrangement for defects of the graph that it was made from.
template <class Point>
class Pslg_defect_finder {
public:
  Pslg_defect_finder(const Pslg_2<Point>& pslg, const Arranged_pslg_2& arranged)
      : pslg_(pslg), arranged_(arranged) {}

  std::vector<Pslg_defect_2> run() {
    find_duplicate_vertices();
    find_zero_length_segments();
    find_vertices_on_segments();
    find_overlaps();
    find_crossings();
    return std::move(defects_);
  }

private:
  using Kind = Pslg_defect_kind_2;

  std::array<double, 2> place(Vertex_index v) const {
    const std::size_t i(v), n = pslg_.vertices.size();
    if (i >= n) return arranged_.crossings[i - n];
    return {double(pslg_.vertices[i].x()), double(pslg_.vertices[i].y())};
  }
  bool is_crossing(Vertex_index v) const { return std::size_t(v) >= pslg_.vertices.size(); }

  Pslg_defect_2& add(Kind kind, Vertex_index where) {
    defects_.push_back({kind, place(where), {}, {}, {}, {}});
    return defects_.back();
  }

  void find_duplicate_vertices() {
    for (std::size_t v = 0; v < arranged_.first_at_place.size(); ++v) {
      const Vertex_index first = arranged_.first_at_place[v];
      if (first == Vertex_index(v)) continue;
      Pslg_defect_2& defect = add(Kind::DUPLICATE_VERTEX, first);
      defect.vertex = Vertex_index(v);
      defect.other_vertex = first;
    }
  }

  void find_zero_length_segments() {
    for (std::size_t s = 0; s < arranged_.chains.size(); ++s)
      if (arranged_.chains[s].empty())
        add(Kind::ZERO_LENGTH_SEGMENT, pslg_.segments[s][0]).segment = Segment_index(s);
  }

  void find_vertices_on_segments() {
    for (std::size_t s = 0; s < arranged_.chains.size(); ++s) {
      const std::vector<Vertex_index>& chain = arranged_.chains[s];
      for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
        if (is_crossing(chain[i])) continue;
        Pslg_defect_2& defect = add(Kind::VERTEX_ON_SEGMENT, chain[i]);
        defect.vertex = chain[i];
        defect.segment = Segment_index(s);
      }
    }
  }

  /// Names each segment once with each earlier one that was the first on a piece of it.
  void find_overlaps() {
    std::unordered_map<std::uint64_t, Segment_index> first_on_piece;
    for (std::size_t s = 0; s < arranged_.chains.size(); ++s) {
      const std::vector<Vertex_index>& chain = arranged_.chains[s];
      std::vector<Segment_index> named;
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        const std::uint64_t piece = unordered_pair_key(chain[i], chain[i + 1]);
        const Segment_index first = first_on_piece.emplace(piece, Segment_index(s)).first->second;
        if (first == Segment_index(s) || std::find(named.begin(), named.end(), first) != named.end())
          continue;
        named.push_back(first);
        Pslg_defect_2& defect = add(Kind::OVERLAPPING_SEGMENTS, chain[i]);
        defect.segment = Segment_index(s);
        defect.other_segment = first;
      }
    }
  }

  /// Names each of the segments through one crossing with the first one that it crosses there.
  void find_crossings() {
    std::vector<std::vector<Segment_index>> through(arranged_.crossings.size());
    for (std::size_t s = 0; s < arranged_.chains.size(); ++s)
      for (const Vertex_index v : arranged_.chains[s])
        if (is_crossing(v)) through[std::size_t(v) - pslg_.vertices.size()].push_back(Segment_index(s));
    for (std::size_t c = 0; c < through.size(); ++c)
      for (const Segment_index s : through[c])
        for (const Segment_index t : through[c])
          if (t < s && do_segments_cross(pslg_, t, s)) {
            Pslg_defect_2& defect = add(Kind::CROSSING_SEGMENTS, Vertex_index(pslg_.vertices.size() + c));
            defect.segment = s;
            defect.other_segment = t;
            break;
          }
  }

  const Pslg_2<Point>& pslg_;
  const Arranged_pslg_2& arranged_;
  std::vector<Pslg_defect_2> defects_;
};

template <class Triangulation, class Point>
std::vector<Pslg_defect_2> find_pslg_defects_with(const Pslg_2<Point>& pslg, bool& has_crossings) {
  Pslg_arranger_2<Triangulation> arranger(pslg);
  has_crossings = arranger.insert_segments(pslg).has_value();
  if (has_crossings) return {};
  const Arranged_pslg_2 arranged = arranger.result();
  return Pslg_defect_finder<Point>(pslg, arranged).run();
}

} // namespace internal
} // namespace Quadtree_mesh_2

inline std::string Pslg_defect_2::to_string() const {
  const std::string where = " at " + Quadtree_mesh_2::internal::place_text(point);
  const auto name = [](const char* what, auto index) { return what + (' ' + std::to_string(index.value())); };
  switch (kind) {
  case Pslg_defect_kind_2::DUPLICATE_VERTEX:
    return name("vertex", vertex) + " is at the place of " + name("vertex", other_vertex) + where;
  case Pslg_defect_kind_2::ZERO_LENGTH_SEGMENT:
    return name("segment", segment) + " has length zero" + where;
  case Pslg_defect_kind_2::VERTEX_ON_SEGMENT:
    return name("vertex", vertex) + " lies inside " + name("segment", segment) + where;
  case Pslg_defect_kind_2::OVERLAPPING_SEGMENTS:
    return name("segment", segment) + " overlaps " + name("segment", other_segment) + where;
  case Pslg_defect_kind_2::CROSSING_SEGMENTS:
    return name("segment", segment) + " crosses " + name("segment", other_segment) + where;
  }
  return std::string(); // not reached
}

/// \ingroup PkgQuadtreeMesh2Data
/// Lists the defects of a graph, kind by kind in the order of `Pslg_defect_kind_2`, each kind by index.
///
/// An empty list means a planar straight-line graph. All answers are exact; only the places of crossings are
/// rounded. Expected O(n log n) time for segments that do not cross, unless they are very long. c crossings
/// take O(c) more, in exact arithmetic.
/// \tparam Point has floating-point coordinates.
/// \throws Pslg_error_2 if `check_pslg_structure()` does.
template <class Point>
std::vector<Pslg_defect_2> find_pslg_defects(const Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  check_pslg_structure(pslg);
  bool has_crossings = false;
  std::vector<Pslg_defect_2> defects =
      internal::find_pslg_defects_with<internal::Crossing_free_triangulation_2>(pslg, has_crossings);
  if (!has_crossings) return defects;
  return internal::find_pslg_defects_with<internal::Exact_triangulation_2>(pslg, has_crossings);
}

} // namespace CGAL

#endif // CGAL_FIND_PSLG_DEFECTS_H
