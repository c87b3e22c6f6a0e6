// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Segments that overlap: which of them pass through a place.
//
// Computes: for places on groups of overlapping segments, the first segment of the group that has the place
//           in its interior. Arrangements name one segment for each piece, which may end there while others
//           go on.
// Bound:    O(k log k) for k segments, pairs and places.
// Method:   Groups are the components that pairs link; their segments lie on one line, in the order of places.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OVERLAPPING_SEGMENTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OVERLAPPING_SEGMENTS_H

#include <CGAL/Quadtree_mesh_2/internal/Ranked_places.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Overlapping_segments {
public:
  /// \param pairs of segments that overlap.
  explicit Overlapping_segments(const std::vector<std::pair<Segment_index, Segment_index>>& pairs) {
    for (const auto& pair : pairs) {
      segments_.push_back(pair.first);
      segments_.push_back(pair.second);
    }
    std::sort(segments_.begin(), segments_.end());
    segments_.erase(std::unique(segments_.begin(), segments_.end()), segments_.end());
    for (std::size_t i = 0; i < segments_.size(); ++i) parents_.push_back(i);
    for (const auto& pair : pairs) parents_[root(number(pair.first))] = root(number(pair.second));
  }

  /// Calls `offer(p, s)` for each place with the first segment of a group through it, if there is one.
  /// \param incidences places, each with a segment that it lies on, in a group or not.
  template <class Places, class Offer>
  void offer_passing(const Places& places, const std::vector<std::pair<Place, Segment_index>>& incidences,
                     const Offer& offer) {
    std::vector<Event> events;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const auto& ends = places.ends(segments_[i]);
      events.push_back({root(i), ends[0], Kind::BEGIN, segments_[i]});
      events.push_back({root(i), ends[1], Kind::END, segments_[i]});
    }
    for (const auto& incidence : incidences)
      if (std::binary_search(segments_.begin(), segments_.end(), incidence.second))
        events.push_back({root(number(incidence.second)), incidence.first, Kind::ASK, Segment_index()});
    std::sort(events.begin(), events.end());
    std::set<Segment_index> passing; // empty again where a group ends
    for (const Event& e : events) {
      if (e.kind == Kind::END) passing.erase(e.segment);
      if (e.kind == Kind::ASK && !passing.empty()) offer(e.place, *passing.begin());
      if (e.kind == Kind::BEGIN) passing.insert(e.segment);
    }
  }

private:
  /// In the order in which they count at one place.
  enum class Kind { END, ASK, BEGIN };

  struct Event {
    std::size_t group;
    Place place;
    Kind kind;
    Segment_index segment;

    friend bool operator<(const Event& a, const Event& b) {
      return std::tie(a.group, a.place, a.kind) < std::tie(b.group, b.place, b.kind);
    }
  };

  std::size_t number(Segment_index s) const {
    return std::size_t(std::lower_bound(segments_.begin(), segments_.end(), s) - segments_.begin());
  }
  std::size_t root(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  std::vector<Segment_index> segments_;
  std::vector<std::size_t> parents_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OVERLAPPING_SEGMENTS_H
