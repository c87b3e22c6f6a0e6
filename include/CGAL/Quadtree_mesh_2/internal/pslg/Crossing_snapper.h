// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Crossings that need no vertex of their own, because there is a vertex next to them.
//
// Computes: from an arranged graph with rounded crossings another one with fewer vertices. A crossing within reach
//           of a vertex or of an earlier crossing becomes that. A segment that crossings cut is cut at each vertex
//           within reach of one of its pieces, too.
// Bound:    O((n + c) log(n + c)) time for n vertices and c crossings, and what Place_tree.h takes for the pieces.
// Source:   Hobby, Practical segment intersection with finite precision output, 1999; Halperin and Packer, Iterated
//           snap rounding, 2002.
// Deviates: Vertices of the input stay where they are, so there is no grid of pixels, and segments may still cross.
//           The caller looks, and comes again.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_CROSSING_SNAPPER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_CROSSING_SNAPPER_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Place_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/arrange_pslg_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Crossing_snapper {
public:
  /// \param units the reach, in units in the last place of the largest coordinate of a segment's ends
  Crossing_snapper(const Pslg_2<Point>& pslg, Arranged_pslg_2& arranged, double units)
      : pslg_(pslg), arranged_(arranged), units_(units), tree_(all_places()) {}

  void run() {
    snap_crossings();
    for (std::size_t s = 0; s < arranged_.chains.size(); ++s)
      if (has_crossing(s)) arranged_.chains[s] = without_loops(with_vertices_near(Segment_index(s)));
    renumber_crossings();
  }

private:
  using Chain = std::vector<Vertex_index>;

  std::vector<Place_2> all_places() const {
    std::vector<Place_2> places;
    for (const Point& p : pslg_.vertices) places.push_back({p.x(), p.y()});
    places.insert(places.end(), arranged_.crossings.begin(), arranged_.crossings.end());
    return places;
  }

  const Place_2& place(Vertex_index v) const { return tree_.place(std::size_t(v)); }
  bool is_crossing(Vertex_index v) const { return std::size_t(v) >= pslg_.vertices.size(); }

  bool has_crossing(std::size_t s) const {
    const Chain& chain = arranged_.chains[s];
    return std::any_of(chain.begin(), chain.end(), [this](Vertex_index v) { return is_crossing(v); });
  }

  /// How far rounding at the ends of a segment may move it, times the units wanted.
  double reach_of(Segment_index s) const {
    double largest = 0;
    for (const Vertex_index v : pslg_.segment(s))
      largest = (std::max)({largest, std::abs(place(v)[0]), std::abs(place(v)[1])});
    const double next = std::nextafter(largest, (std::numeric_limits<double>::max)());
    return units_ * (next - largest);
  }

  /// A crossing goes to the nearest vertex, or earlier crossing that stays, within reach of a segment through it.
  void snap_crossings() {
    std::vector<double> reach(arranged_.crossings.size(), 0);
    for (std::size_t s = 0; s < arranged_.chains.size(); ++s)
      for (const Vertex_index v : arranged_.chains[s])
        if (is_crossing(v)) {
          double& own = reach[std::size_t(v) - pslg_.vertices.size()];
          own = (std::max)(own, reach_of(Segment_index(s)));
        }
    stands_for_ = arranged_.first_at_place;
    for (std::size_t c = 0; c < reach.size(); ++c) {
      const Vertex_index v(stands_for_.size());
      stands_for_.push_back(nearest_before(v, reach[c]));
    }
  }

  Vertex_index nearest_before(Vertex_index v, double reach) const {
    Vertex_index nearest = v;
    tree_.for_each_near(place(v), place(v), reach, [&](std::size_t i) {
      const Vertex_index w(i);
      if (!(w < v) || stands_for_[i] != w) return;
      const double d = distance_of_places(place(v), place(w));
      const double least = distance_of_places(place(v), place(nearest));
      if (nearest == v || d < least || (d == least && w < nearest)) nearest = w;
    });
    return nearest;
  }

  Chain with_vertices_near(Segment_index s) const {
    Chain snapped;
    for (const Vertex_index v : arranged_.chains[std::size_t(s)]) {
      const Vertex_index w = stands_for_[std::size_t(v)];
      if (!snapped.empty() && snapped.back() != w)
        add_vertices_between(snapped.back(), w, reach_of(s), snapped);
      if (snapped.empty() || snapped.back() != w) snapped.push_back(w);
    }
    return snapped;
  }

  /// In their order along the piece from `a` to `b`. All are nearer to its ends than these are to each other, so
  /// that pieces become shorter each time, and the times end.
  void add_vertices_between(Vertex_index a, Vertex_index b, double reach, Chain& chain) const {
    std::vector<std::pair<double, Vertex_index>> between;
    tree_.for_each_near(place(a), place(b), reach, [&](std::size_t i) {
      const Place_beside_segment seen(place(a), place(b), tree_.place(i));
      if (stands_for_[i] == Vertex_index(i) && seen.is_between())
        between.emplace_back(seen.along(), Vertex_index(i));
    });
    std::sort(between.begin(), between.end());
    for (const auto& [along, v] : between) chain.push_back(v);
  }

  /// A chain that comes back to a vertex goes on from there.
  static Chain without_loops(const Chain& chain) {
    Chain result;
    std::unordered_map<std::size_t, std::size_t> position;
    for (const Vertex_index v : chain) {
      const auto [place, is_new] = position.emplace(std::size_t(v), result.size());
      if (is_new) {
        result.push_back(v);
        continue;
      }
      for (; result.size() > place->second + 1; result.pop_back()) position.erase(std::size_t(result.back()));
    }
    return result;
  }

  /// Crossings that no segment goes through any more are dropped.
  void renumber_crossings() {
    const std::size_t n = pslg_.vertices.size();
    std::vector<Vertex_index> new_index(arranged_.crossings.size());
    std::vector<Place_2> crossings;
    for (Chain& chain : arranged_.chains)
      for (Vertex_index& v : chain) {
        if (!is_crossing(v)) continue;
        Vertex_index& index = new_index[std::size_t(v) - n];
        if (!index.is_valid()) {
          index = Vertex_index(n + crossings.size());
          crossings.push_back(place(v));
        }
        v = index;
      }
    arranged_.crossings = std::move(crossings);
  }

  const Pslg_2<Point>& pslg_;
  Arranged_pslg_2& arranged_;
  double units_;
  Place_tree tree_;
  std::vector<Vertex_index> stands_for_; ///< per vertex, then per crossing, the one at whose place it is
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_CROSSING_SNAPPER_H
