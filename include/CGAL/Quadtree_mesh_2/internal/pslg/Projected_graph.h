// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PROJECTED_GRAPH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PROJECTED_GRAPH_H

#include <CGAL/Conformal_projection_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/arrange_pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/part_names.h>
#include <CGAL/find_pslg_defects.h>
#include <CGAL/repair_pslg_2.h>
#include <CGAL/validate_pslg_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

// A graph in degrees, cut into pieces that a conformal projection hardly bends.
//
// Segments are cut at the vertices on them first, while these are exactly there. What is between, a stretch, is cut by
// parameters in [0, 1] from its first to its second end, in degrees. Its pieces are straight segments in the plane of
// the projection. The graph there has to be crossed nowhere that the graph in degrees is not; where it is, the pieces
// at fault are halved, which makes them bend a quarter as much.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
Conformal_projection_2::Box checked_box_in_degrees(const Pslg_2<Point>& degrees) {
  using Kind = Pslg_error_2::Kind;
  check_pslg_structure(degrees);
  Conformal_projection_2::Box box{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  std::size_t west = 0, east = 0;
  for (std::size_t v = 0; v < degrees.vertices.size(); ++v) {
    const Point& p = degrees.vertices[v];
    if (!(std::abs(p.y()) < 90))
      throw Pslg_error_2(Kind::OUT_OF_RANGE,
                         vertex_text(degrees, v) +
                             " is at a pole or beyond, where no projection has a place for it",
                         Pslg_parts_2().vertex(Vertex_index(v)));
    if (p.x() < box.low[0]) west = v;
    if (p.x() > box.high[0]) east = v;
    box.low = {std::min(box.low[0], p.x()), std::min(box.low[1], p.y())};
    box.high = {std::max(box.high[0], p.x()), std::max(box.high[1], p.y())};
  }
  if (box.high[0] - box.low[0] > 360)
    throw Pslg_error_2(Kind::OUT_OF_RANGE,
                       vertex_text(degrees, west) + " and " + vertex_text(degrees, east) +
                           " are more than 360 degrees of longitude apart",
                       Pslg_parts_2().vertex(Vertex_index(west)).vertex(Vertex_index(east)));
  for (std::size_t s = 0; s < degrees.segments.size(); ++s) {
    const double a = degrees.point(degrees.segments[s][0]).x(), b = degrees.point(degrees.segments[s][1]).x();
    if (std::abs(b - a) > 180)
      throw Pslg_error_2(Kind::OUT_OF_RANGE,
                         segment_text(degrees, s) +
                             " spans more than 180 degrees of longitude: longitudes have to go "
                             "on beyond 180 where the border crosses the antimeridian",
                         Pslg_parts_2().segment(Segment_index(s)));
  }
  return box;
}

template <class Point>
class Projected_graph {
public:
  /// A part of an input segment that is straight in the plane of projection.
  struct Piece {
    std::size_t stretch;
    double begin, end; ///< parameters
  };
  /// A place on a stretch.
  struct Place {
    std::size_t stretch;
    double parameter;
  };

  /// \throws Pslg_error_2 if the graph is not one in degrees, or segments cross
  Projected_graph(const Pslg_2<Point>& degrees, const Conformal_projection_2& projection, double tolerance)
      : degrees_(degrees), projection_(projection), tolerance_(tolerance) {
    checked_box_in_degrees(degrees);
    make_stretches();
    for (std::size_t s = 0; s < stretches_.size(); ++s) {
      bisect(s, 0, 1, 0);
      stretches_[s].cuts.push_back(1);
    }
  }

  /// Cuts pieces until they cross nowhere and points of holes and regions are on their sides of them.
  /// \throws Pslg_error_2 if that cannot be
  void separate() {
    constexpr int most_passes = 40;
    for (int pass = 0; pass < most_passes; ++pass) {
      build();
      std::vector<Place> places;
      add_defects(places);
      for (const Point& p : degrees_.holes) add_passed(p, places);
      for (const auto& region : degrees_.regions) add_passed(region.point, places);
      if (places.empty()) return;
      if (pass + 1 == most_passes) fail(places.front());
      split(std::move(places));
    }
  }

  /// Adds vertices.
  void split(std::vector<Place> places) {
    std::vector<std::size_t> changed;
    for (const Place& place : places) {
      if (!(place.parameter > 0 && place.parameter < 1)) continue;
      stretches_[place.stretch].cuts.push_back(place.parameter);
      changed.push_back(place.stretch);
    }
    for (const std::size_t s : changed) {
      auto& cuts = stretches_[s].cuts;
      std::sort(cuts.begin(), cuts.end());
      cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    }
  }

  const Pslg_2<Point>& degrees() const { return degrees_; }
  const Pslg_2<Point>& pslg() const { return pslg_; } ///< in meters
  const Conformal_projection_2& projection() const { return projection_; }
  std::size_t number_of_splits() const { return places_.size(); }
  /// Where the vertices of the graph behind the input's are.
  const Place& place(std::size_t split) const { return places_[split]; }
  /// The piece that is a segment of the graph.
  const Piece& piece(Segment_index s) const { return pieces_[std::size_t(s)]; }
  Segment_index segment_of(std::size_t stretch) const { return stretches_[stretch].segment; }

  /// In degrees, on the input segment up to rounding.
  Point at(const Place& place) const {
    const Stretch& s = stretches_[place.stretch];
    const Point &a = degrees_.point(s.ends[0]), &b = degrees_.point(s.ends[1]);
    const double t = place.parameter;
    return t <= 0.5 ? Point(a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y()))
                    : Point(b.x() + (1 - t) * (a.x() - b.x()), b.y() + (1 - t) * (a.y() - b.y()));
  }
  Point forward(const Point& p) const {
    const auto place = projection_.forward(p.x(), p.y());
    return Point(place[0], place[1]);
  }

private:
  struct Stretch {
    Segment_index segment;
    std::array<Vertex_index, 2> ends;
    std::vector<double> cuts; ///< 0, increasing parameters, 1
  };

  /// A stretch that several segments cover belongs to the first one.
  void make_stretches() {
    Pslg_arranger_2<Crossing_free_triangulation_2> arranger(degrees_);
    if (const auto crossing = arranger.insert_segments(degrees_)) throw_crossing(degrees_, *crossing);
    const Arranged_pslg_2 arranged = arranger.result();
    first_at_place_ = arranged.first_at_place;
    std::unordered_set<std::uint64_t> known;
    for (std::size_t s = 0; s < arranged.chains.size(); ++s) {
      const auto& chain = arranged.chains[s];
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        if (known.insert(unordered_pair_key(chain[i], chain[i + 1])).second)
          stretches_.push_back({Segment_index(s), {chain[i], chain[i + 1]}, {0}});
    }
  }

  /// Appends the parameters in (begin, end) at which a stretch is cut so that it bends little.
  void bisect(std::size_t s, double begin, double end, int depth) {
    constexpr int most_depth = 20;
    const Point a = forward(at({s, begin})), b = forward(at({s, end}));
    const double length = std::hypot(b.x() - a.x(), b.y() - a.y());
    const double middle = (begin + end) / 2;
    const Point m = forward(at({s, middle}));
    const double bend = std::hypot(m.x() - (a.x() + b.x()) / 2, m.y() - (a.y() + b.y()) / 2);
    if (depth == most_depth || bend <= std::min(length * 1e-3, tolerance_)) return;
    bisect(s, begin, middle, depth + 1);
    stretches_[s].cuts.push_back(middle);
    bisect(s, middle, end, depth + 1);
  }

  void build() {
    pslg_ = {};
    places_.clear(), pieces_.clear();
    pslg_.first_number = degrees_.first_number;
    pslg_.marker_names = degrees_.marker_names;
    pslg_.region_names = degrees_.region_names;
    pslg_.vertex_markers = degrees_.vertex_markers;
    for (const Point& p : degrees_.vertices) pslg_.add_vertex(forward(p));
    for (std::size_t s = 0; s < stretches_.size(); ++s) add_stretch(s);
    if (!degrees_.vertex_markers.empty()) pslg_.vertex_markers.resize(pslg_.vertices.size(), 0);
    for (const Point& p : degrees_.holes) pslg_.holes.push_back(forward(p));
    for (const auto& r : degrees_.regions)
      pslg_.regions.push_back({forward(r.point), r.attribute, r.max_area});
  }

  void add_stretch(std::size_t s) {
    const Stretch& stretch = stretches_[s];
    Vertex_index last = stretch.ends[0];
    for (std::size_t i = 1; i < stretch.cuts.size(); ++i) {
      const bool is_end = i + 1 == stretch.cuts.size();
      const Place place{s, stretch.cuts[i]};
      const Vertex_index next = is_end ? stretch.ends[1] : pslg_.add_vertex(forward(at(place)));
      if (!is_end) places_.push_back(place);
      pslg_.add_segment(last, next);
      pieces_.push_back({s, stretch.cuts[i - 1], stretch.cuts[i]});
      if (!degrees_.segment_markers.empty())
        pslg_.segment_markers.push_back(degrees_.segment_markers[std::size_t(stretch.segment)]);
      last = next;
    }
  }

  void halve(Segment_index s, std::vector<Place>& places) const {
    const Piece& p = piece(s);
    places.push_back({p.stretch, (p.begin + p.end) / 2});
  }

  /// What is wrong in the plane, but not in degrees.
  void add_defects(std::vector<Place>& places) const {
    for (const Pslg_defect_2& defect : find_pslg_defects(pslg_)) {
      if (defect.kind == Pslg_defect_kind_2::DUPLICATE_VERTEX)
        check_is_merged(defect.vertex, defect.other_vertex);
      if (defect.segment.is_valid()) halve(defect.segment, places);
      if (defect.other_segment.is_valid()) halve(defect.other_segment, places);
    }
  }

  void check_is_merged(Vertex_index v, Vertex_index w) const {
    const std::size_t n = degrees_.vertices.size(), i(v), j(w);
    if (i < n && j < n && first_at_place_[i] == first_at_place_[j]) return;
    if (i >= n || j >= n) fail(places_[(i >= n ? i : j) - n]);
    throw Pslg_error_2(Pslg_error_2::Kind::TOO_NEAR,
                       "vertices " + std::to_string(degrees_.first_number + j) + " and " +
                           std::to_string(degrees_.first_number + i) +
                           " are so near to each other that the projection puts them at one place",
                       Pslg_parts_2().vertex(w).vertex(v));
  }

  /// Halves pieces that pass over a point in the projection: it is on their left in degrees and on their right there,
  /// or the other way around. Pieces bend by a thousandth of their length at most, so few are looked at.
  void add_passed(const Point& p, std::vector<Place>& places) const {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const Point q = forward(p);
    for (std::size_t s = 0; s < pieces_.size(); ++s) {
      const Point &c = pslg_.point(pslg_.segments[s][0]), &d = pslg_.point(pslg_.segments[s][1]);
      const double reach = 0.01 * (std::abs(d.x() - c.x()) + std::abs(d.y() - c.y()));
      if (q.x() < std::min(c.x(), d.x()) - reach || q.x() > std::max(c.x(), d.x()) + reach ||
          q.y() < std::min(c.y(), d.y()) - reach || q.y() > std::max(c.y(), d.y()) + reach)
        continue;
      const double along = (q.x() - c.x()) * (d.x() - c.x()) + (q.y() - c.y()) * (d.y() - c.y());
      const double whole = (d.x() - c.x()) * (d.x() - c.x()) + (d.y() - c.y()) * (d.y() - c.y());
      if (along < 0 || along > whole) continue;
      const Stretch& stretch = stretches_[pieces_[s].stretch];
      const Point &a = degrees_.point(stretch.ends[0]), &b = degrees_.point(stretch.ends[1]);
      const auto side = [](const Point& u, const Point& v, const Point& w) {
        return CGAL::orientation(Kernel::Point_2(u.x(), u.y()), Kernel::Point_2(v.x(), v.y()),
                                 Kernel::Point_2(w.x(), w.y()));
      };
      if (side(a, b, p) != CGAL::COLLINEAR && side(a, b, p) != side(c, d, q)) halve(Segment_index(s), places);
    }
  }

  [[noreturn]] void fail(const Place& place) const {
    const Segment_index s = segment_of(place.stretch);
    const Point p = at(place);
    throw Pslg_error_2(Pslg_error_2::Kind::ROUNDING,
                       "segment " + std::to_string(degrees_.first_number + std::size_t(s)) +
                           " is so near to others at " + place_text(std::array<double, 2>{p.x(), p.y()}) +
                           " that rounding in the projection puts it on them",
                       Pslg_parts_2().segment(s));
  }

  const Pslg_2<Point>& degrees_;
  Conformal_projection_2 projection_;
  double tolerance_;
  std::vector<Vertex_index> first_at_place_;
  std::vector<Stretch> stretches_;
  Pslg_2<Point> pslg_;
  std::vector<Place> places_; ///< of the vertices behind the input's
  std::vector<Piece> pieces_; ///< of the segments
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PROJECTED_GRAPH_H
