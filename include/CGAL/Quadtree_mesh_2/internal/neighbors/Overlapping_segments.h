// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Segments that overlap: groups of them, cut into pieces that do not overlap.
//
// Computes: the groups of segments on one line that overlap, one after the other; and pieces that cover the
//           same and overlap nowhere, each with the first segment on it. Also, for places on them, the first
//           segment that has the place in its interior. The pieces do not tell that where one segment ends
//           and another goes on.
// Bound:    O(k log k) for k segments and places.
// Method:   Slopes and offsets of lines are enclosed by intervals and sorted. Only segments whose intervals
//           and ranges of places overlap those of others are sorted exactly by their lines. Hardly any but
//           overlapping segments remain for that.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_OVERLAPPING_SEGMENTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_OVERLAPPING_SEGMENTS_H

#include <CGAL/Quadtree_mesh_2/internal/neighbors/Piece_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Ranked_places.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Overlapping_segments {
public:
  using Geometry = Piece_geometry<Point>;
  using Incidence = std::pair<Place, Segment_index>;

  /// Finds the groups among some segments, none of which is along the rays.
  template <class Range>
  Overlapping_segments(const Geometry& geometry, const Range& segments) : geometry_(geometry) {
    std::vector<Line> lines = enclosed_lines(segments);
    // Ever fewer lines are left for the next sort.
    for_each_run(
        lines.begin(), lines.end(), [](const Line& l) { return l.slope.inf(); },
        [](const Line& l, double end) { return l.slope.inf() > end; },
        [](const Line& l) { return l.slope.sup(); },
        [&](Iterator b, Iterator e) {
          for_each_run(
              b, e, [](const Line& l) { return l.offset.inf(); },
              [](const Line& l, double end) { return l.offset.inf() > end; },
              [](const Line& l) { return l.offset.sup(); },
              [&](Iterator c, Iterator f) {
                for_each_run(
                    c, f, [](const Line& l) { return l.left; },
                    [](const Line& l, Place end) { return !(l.left < end); },
                    [](const Line& l) { return l.right; }, [&](Iterator d, Iterator g) { group(d, g); });
              });
        });
    std::sort(members_.begin(), members_.end());
  }

  bool empty() const { return members_.empty(); }
  bool contains(Segment_index s) const { return group_of(s) != members_.end(); }

  /// Calls `offer(piece)` for pieces that cover what the groups cover.
  template <class Offer>
  void offer_pieces(const Offer& offer) const {
    Place last;
    for_each_event({}, [&](const Event& e, const std::set<Segment_index>& on) {
      if (!on.empty() && last != e.place) offer(Segment_piece{last, e.place, *on.begin()});
      last = e.place;
    });
  }

  /// Calls `offer(p, s)` for each place with the first segment of a group through it, if there is one.
  /// \param incidences places, each with a segment that it lies on, in a group or not.
  template <class Offer>
  void offer_passing(const std::vector<Incidence>& incidences, const Offer& offer) const {
    for_each_event(incidences, [&](const Event& e, const std::set<Segment_index>& on) {
      if (e.kind == Kind::ASK && !on.empty()) offer(e.place, *on.begin());
    });
  }

private:
  /// A segment and its line, as intervals.
  struct Line {
    Interval slope, offset;
    Place left, right;
    Segment_index segment;
  };
  using Iterator = typename std::vector<Line>::iterator;
  using Member = std::pair<Segment_index, std::size_t>; ///< with the number of its group

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

  template <class Range>
  std::vector<Line> enclosed_lines(const Range& segments) const {
    std::vector<Line> lines;
    lines.reserve(std::size_t(std::distance(segments.begin(), segments.end())));
    const Interval::Protector protector;
    for (const Segment_index s : segments) {
      const auto& ends = geometry_.places().ends(s);
      Line line{Interval::largest(), Interval::largest(), ends[0], ends[1], s};
      const Interval across = geometry_.enclosed_difference(ends[0], ends[1], 0);
      if (across.inf() > 0) {
        line.slope = geometry_.enclosed_difference(ends[0], ends[1], 1) / across;
        line.offset = geometry_.enclosed_coordinate(ends[0], 1) -
                      line.slope * geometry_.enclosed_coordinate(ends[0], 0);
      }
      lines.push_back(line);
    }
    return lines;
  }

  /// Sorts lines by where something of them begins, and calls `run(first, last)` for those of which each begins
  /// before the end of one before it; not for single ones.
  template <class Begin, class Is_beyond, class End, class Run>
  static void for_each_run(Iterator first, Iterator last, const Begin& begin, const Is_beyond& is_beyond,
                           const End& end, const Run& run) {
    std::sort(first, last, [&](const Line& a, const Line& b) {
      return std::make_tuple(begin(a), a.segment) < std::make_tuple(begin(b), b.segment);
    });
    while (first != last) {
      Iterator next = first + 1;
      for (auto reach = end(*first); next != last && !is_beyond(*next, reach); ++next)
        reach = std::max(reach, end(*next));
      if (next - first > 1) run(first, next);
      first = next;
    }
  }

  /// Makes groups of those that overlap, exactly.
  void group(Iterator first, Iterator last) {
    std::sort(first, last, [&](const Line& a, const Line& b) {
      const int c = geometry_.compare_supporting_lines(a.segment, b.segment);
      return c < 0 || (c == 0 && std::tie(a.left, a.segment) < std::tie(b.left, b.segment));
    });
    while (first != last) {
      Iterator next = first + 1;
      for (Place reach = first->right; next != last && next->left < reach &&
                                       geometry_.compare_supporting_lines(first->segment, next->segment) == 0;
           ++next)
        reach = std::max(reach, next->right);
      if (next - first > 1) {
        for (Iterator i = first; i != next; ++i) members_.emplace_back(i->segment, groups_);
        ++groups_;
      }
      first = next;
    }
  }

  typename std::vector<Member>::const_iterator group_of(Segment_index s) const {
    const auto found = std::lower_bound(members_.begin(), members_.end(), Member(s, 0));
    return found != members_.end() && found->first == s ? found : members_.end();
  }

  /// Goes along all groups, and calls `f(event, on)` for each end of a segment and each incidence, with the
  /// segments before it that do not end there.
  template <class F>
  void for_each_event(const std::vector<Incidence>& incidences, const F& f) const {
    std::vector<Event> events;
    for (const Member& member : members_) {
      const auto& ends = geometry_.places().ends(member.first);
      events.push_back({member.second, ends[0], Kind::BEGIN, member.first});
      events.push_back({member.second, ends[1], Kind::END, member.first});
    }
    for (const Incidence& incidence : incidences) {
      const auto member = group_of(incidence.second);
      if (member == members_.end()) continue;
      events.push_back({member->second, incidence.first, Kind::ASK, Segment_index()});
    }
    std::sort(events.begin(), events.end());
    std::set<Segment_index> on; // empty again where a group ends
    for (const Event& e : events) {
      f(e, on);
      if (e.kind == Kind::END) on.erase(e.segment);
      if (e.kind == Kind::BEGIN) on.insert(e.segment);
    }
  }

  const Geometry& geometry_;
  std::vector<Member> members_;
  std::size_t groups_ = 0;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_OVERLAPPING_SEGMENTS_H
