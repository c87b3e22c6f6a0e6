// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The vertices and segments of a graph in slabs, for rays along one axis, and what the rays hit.
//
// Computes: lists of the segments in each slab; what each place sees (Slab_decomposition.h); and from that
//           the first segments hit upward and downward from each place, if none has the place in its
//           interior.
// Bound:    O((n + m + c) log n) work, not counting sorting, for n vertices, m segments and c crossings.
//           Slabs have a thousand places, or enough more that the lists are only a quarter longer than one of
//           all segments.
//
// Slabs keep memory near the processor, and serve several processors. They are cut by numbers of places
// alone.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SLABS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SLABS_H

#include <CGAL/Quadtree_mesh_2/internal/neighbors/Ranked_places.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Slab_decomposition.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Slabs {
public:
  using Places = Ranked_places<Point>;
  /// The segments hit upwards and downwards.
  using Hits = std::array<Segment_index, 2>;

  /// Lists what is in each slab, of at least `least_size` places.
  Slabs(Places places, std::size_t number_of_segments, std::size_t least_size)
      : places_(std::move(places)), sights_(places_.size()) {
    for (std::size_t s = 0; s < number_of_segments; ++s)
      (places_.is_along_rays(Segment_index(s)) ? along_rays_ : across_).push_back(Segment_index(s));
    std::sort(across_.begin(), across_.end(), [&](Segment_index s, Segment_index t) {
      const auto &a = places_.ends(s), &b = places_.ends(t);
      return a < b || (a == b && s < t);
    });
    slab_size_ = least_size;
    while (number_of_listed() > across_.size() + across_.size() / 4 && slab_size_ < places_.size())
      slab_size_ *= 2;
    list_segments();
  }

  std::size_t size() const { return (places_.size() + slab_size_ - 1) / slab_size_; }

  /// Finds what the places of a slab see. Slabs may be decomposed by several threads at once.
  void decompose(std::size_t slab) {
    struct List {
      const Segment_index *first, *last;
      const Segment_index* begin() const { return first; }
      const Segment_index* end() const { return last; }
    };
    const std::size_t begin = slab * slab_size_;
    Slab_decomposition<Point>(places_, begin, std::min(begin + slab_size_, places_.size()), sights_)
        .run(List{listed_.data() + first_listed_[slab], listed_.data() + first_listed_[slab + 1]});
  }

  /// Finds the hits of all places.
  /// \pre all slabs have been decomposed
  void find_hits() {
    hits_.resize(places_.size());
    Lines_ends ends(places_.size());
    for (const Segment_index s : along_rays_) {
      const auto& places = places_.ends(s);
      Segment_index &lower = ends[places[0].value()][0], &upper = ends[places[1].value()][1];
      lower = first_of(lower, s);
      upper = first_of(upper, s);
    }
    Ahead ahead;
    for (std::size_t i = places_.size(); i-- > 0;) {
      const bool is_on_line = i + 1 < places_.size() && is_on_same_line(i, i + 1);
      hits_[i][0] = ahead.move(is_on_line ? &sights_[i + 1] : nullptr, is_on_line ? ends[i + 1][0] : none,
                               sights_[i].above);
    }
    ahead = Ahead();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const bool is_on_line = i > 0 && is_on_same_line(i - 1, i);
      hits_[i][1] = ahead.move(is_on_line ? &sights_[i - 1] : nullptr, is_on_line ? ends[i - 1][1] : none,
                               sights_[i].below);
    }
  }

  const Hits& hits(Vertex_index v) const { return hits_[places_.place(v).value()]; }
  /// The first segment, not along the rays, with a vertex in its interior.
  Segment_index through(Vertex_index v) const { return sights_[places_.place(v).value()].through; }

private:
  /// For each place the first segment along the rays whose lower end, and whose upper one, is there.
  using Lines_ends = std::vector<std::array<Segment_index, 2>>;

  static constexpr Segment_index none = Segment_index();

  /// What is ahead of a place on its line while these are gone through against the rays. Segments along them
  /// that a place is not in the interior of are hit at their nearer ends, and not if that is the place itself;
  /// all others at a place ahead, if not before it.
  class Ahead {
  public:
    /// Moves on to a place. `next` is what the next place ahead of it on the line sees, if there is one,
    /// `end_at_next` the segment along the rays with its nearer end there, `before_next` what is seen before.
    /// Returns the segment that is hit.
    Segment_index move(const Place_sights* next, Segment_index end_at_next, Segment_index before_next) {
      if (next == nullptr)
        along_ = across_ = At();
      else {
        update(along_, end_at_next);
        update(across_, next->touching);
      }
      if (before_next.is_valid()) across_ = {before_next, 0};
      if (!along_.segment.is_valid() || across_.steps < along_.steps) return across_.segment;
      return across_.steps > along_.steps ? along_.segment : first_of(along_.segment, across_.segment);
    }

  private:
    /// A segment, and how far ahead it is hit: 0 before the next place, 1 there, 2 before that after it.
    struct At {
      Segment_index segment;
      std::size_t steps = std::size_t(-1);
    };

    static void update(At& at, Segment_index here) {
      if (here.is_valid())
        at = {here, 1};
      else if (at.segment.is_valid())
        at.steps += 2;
    }

    At along_, across_;
  };

  bool is_on_same_line(std::size_t i, std::size_t j) const {
    return places_.line(Place(i)) == places_.line(Place(j));
  }

  /// The slabs that a segment is listed in: where it has an end, or passes, or ends at the place next to it.
  std::pair<std::size_t, std::size_t> slabs_of(Segment_index s) const {
    const auto& ends = places_.ends(s);
    const std::size_t l(ends[0]), r(ends[1]);
    return {l == 0 ? 0 : (l - 1) / slab_size_, std::min((r + 1) / slab_size_, size() - 1)};
  }

  std::size_t number_of_listed() const {
    std::size_t n = 0;
    for (const Segment_index s : across_) {
      const auto slabs = slabs_of(s);
      n += slabs.second - slabs.first + 1;
    }
    return n;
  }

  void list_segments() {
    first_listed_.assign(size() + 1, 0);
    for (const Segment_index s : across_) {
      const auto slabs = slabs_of(s);
      for (std::size_t i = slabs.first; i <= slabs.second; ++i) ++first_listed_[i + 1];
    }
    for (std::size_t i = 0; i < size(); ++i) first_listed_[i + 1] += first_listed_[i];
    listed_.resize(first_listed_[size()]);
    std::vector<std::size_t> next(first_listed_);
    for (const Segment_index s : across_) {
      const auto slabs = slabs_of(s);
      for (std::size_t i = slabs.first; i <= slabs.second; ++i) listed_[next[i]++] = s;
    }
  }

  Places places_;
  std::vector<Segment_index> along_rays_, across_;
  std::size_t slab_size_;
  std::vector<std::size_t> first_listed_;
  std::vector<Segment_index> listed_;
  std::vector<Place_sights> sights_;
  std::vector<Hits> hits_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SLABS_H
