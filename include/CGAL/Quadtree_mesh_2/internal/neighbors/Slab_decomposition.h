// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What vertices of a slab see along the rays, by the trapezoidal decomposition of the segments in it.
//
// Computes: for each place of a range, the first segment seen upward and downward before the next place on
//           the same line; and the first segments, not along the rays, that touch it and that go through it.
// Bound:    O((k + c) log k) for k segments and places in the slab and c crossings of these segments.
// Source:   Bern, Eppstein, Teng, section 6, Lemma 5; CGAL's Arrangement_2 and decompose().
//
// Segments along the rays are left out, because they bound no trapezoid. Segments in the slab are taken
// whole, because cutting them would need new points. All places in the range, and the ones before and after
// it, are vertices of the arrangement, isolated ones if no segment ends there. So a place sees the next one
// on its line if nothing is between them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SLAB_DECOMPOSITION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SLAB_DECOMPOSITION_H

#include <CGAL/Arr_vertical_decomposition_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Overlapping_segments.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Piece_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Piece_traits_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

inline Segment_index first_of(Segment_index a, Segment_index b) { return b < a ? b : a; }

/// Segments that are not along the rays, as seen from a place; invalid if there is none. Invalid indices are
/// the greatest.
struct Place_sights {
  Segment_index above, below; ///< before the next place on the line
  Segment_index touching;     ///< the first with an end or an interior point there
  Segment_index through;      ///< the first with an interior point there
};

template <class Point>
class Slab_decomposition {
  using Places = Ranked_places<Point>;
  using Traits = Piece_traits_2<Point>;
  using Arrangement = Arrangement_2<Traits>;
  using Vertex_handle = typename Arrangement::Vertex_const_handle;
  using Halfedge_handle = typename Arrangement::Halfedge_const_handle;

public:
  /// The sights of the places from `begin` to before `end` are written to `sights`, which has all places.
  Slab_decomposition(const Places& places, std::size_t begin, std::size_t end,
                     std::vector<Place_sights>& sights)
      : places_(places), geometry_(places), begin_(begin), end_(end), sights_(sights) {}

  /// \param segments all that are not along the rays, begin before or at place `end`, and end behind or at the
  /// place before `begin`.
  template <class Range>
  void run(const Range& segments) {
    using Curve = typename Traits::Curve_2;
    const Overlapping_segments<Point> overlapping(geometry_, segments);
    is_overlapping_ = !overlapping.empty();
    std::vector<Curve> curves;
    const std::size_t first = begin_ - (begin_ > 0 ? 1 : 0), last = std::min(end_ + 1, places_.size());
    std::vector<char> is_end(last - first);
    for (const Segment_index s : segments) {
      const auto& ends = places_.ends(s);
      if (!is_overlapping_ || !overlapping.contains(s)) curves.push_back(Curve({ends[0], ends[1], s}));
      for (const Place p : ends)
        if (p.value() - first < is_end.size()) is_end[p.value() - first] = 1;
    }
    overlapping.offer_pieces([&](const Segment_piece& piece) { curves.push_back(Curve(piece)); });
    for (std::size_t i = first; i < last; ++i)
      if (is_end[i - first] == 0) curves.push_back(Curve({Place(i), Place(i), Segment_index()}));
    const Traits traits(geometry_);
    Arrangement arrangement(&traits);
    CGAL::insert(arrangement, curves.begin(), curves.end());
    CGAL::decompose(arrangement, Receiver(*this));
    overlapping.offer_passing(incidences_, [&](Place p, Segment_index s) {
      Segment_index& through = sights_[p.value()].through;
      through = first_of(through, s);
    });
  }

private:
  /// An output iterator that takes what `decompose()` finds.
  class Receiver {
  public:
    using iterator_category = std::output_iterator_tag;
    using value_type = void;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = void;

    explicit Receiver(Slab_decomposition& slab) : slab_(&slab) {}
    Receiver& operator*() { return *this; }
    Receiver& operator++() { return *this; }
    Receiver operator++(int) { return *this; }
    template <class Cell>
    Receiver& operator=(const std::pair<Vertex_handle, std::pair<Cell, Cell>>& entry) {
      slab_->receive(entry.first, entry.second.first, entry.second.second);
      return *this;
    }

  private:
    Slab_decomposition* slab_;
  };

  template <class Cell>
  void receive(Vertex_handle v, const Cell& below, const Cell& above) {
    const Place p = v->point().place;
    if (p.value() < begin_ || p.value() >= end_) return; // of another slab, or a crossing
    Place_sights& sights = sights_[p.value()];
    sights.above = seen(above);
    sights.below = seen(below);
    for_each_segment(v, [&](Segment_index s) {
      sights.touching = first_of(sights.touching, s);
      const auto& ends = places_.ends(s);
      if (ends[0] != p && ends[1] != p) sights.through = first_of(sights.through, s);
      if (is_overlapping_) incidences_.emplace_back(p, s);
    });
  }

  /// The segment of an edge; the first one of those at a crossing; none for a place, and for what is
  /// unbounded.
  template <class Cell>
  Segment_index seen(const Cell& cell) const {
    if (!cell) return Segment_index();
    if (const auto* edge = held_in<Halfedge_handle>(*cell)) return (*edge)->curve().segment;
    const auto* vertex = held_in<Vertex_handle>(*cell);
    Segment_index first;
    if (vertex != nullptr && !geometry_.is_vertex((*vertex)->point().place))
      for_each_segment(*vertex, [&](Segment_index s) { first = first_of(first, s); });
    return first;
  }

  template <class F>
  static void for_each_segment(Vertex_handle v, const F& f) {
    if (v->is_isolated()) return;
    auto edge = v->incident_halfedges();
    const auto first = edge;
    do f(edge->curve().segment);
    while (++edge != first);
  }

  const Places& places_;
  Piece_geometry<Point> geometry_;
  std::size_t begin_, end_;
  std::vector<Place_sights>& sights_;
  bool is_overlapping_ = false;
  std::vector<std::pair<Place, Segment_index>> incidences_; ///< places and segments on them, if any overlap
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SLAB_DECOMPOSITION_H
