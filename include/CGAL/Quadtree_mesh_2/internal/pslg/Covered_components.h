// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Computes: for each bounded component of the plane that segments bound, a place strictly inside it, and the
//           first polygon that covers it, if any does.
// Bound:    O(n log n) in practice.
// Method:   components are floods of a constrained Delaunay triangulation. Crossing an edge changes the
//           polygons that have the edge in their borders an odd number of times. A walk over a spanning tree
//           of the components, beginning at infinity, maintains the set of polygons that it is in. No place
//           is ever located: everything but the choice of places inside is combinatorial. Segments may cross.
//           Then the triangulation is made again with exact constructions, because the doubles next to a
//           crossing may be infinite.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_COVERED_COMPONENTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_COVERED_COMPONENTS_H

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Indexed_cdt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A segment in the border of a polygon. Twice in the border is the same as not at all.
struct Segment_of_polygon {
  std::uint32_t segment, polygon;
};

struct Covered_component {
  static constexpr std::uint32_t no_polygon = 0xffffffffu;
  std::array<double, 2> place; ///< strictly inside
  std::uint32_t polygon;       ///< the first one that covers it
};

/// The components of a graph, see the head of this file.
template <class Kernel>
class Component_finder {
  static constexpr std::uint32_t none_ = 0xffffffffu;
  struct Face_info {
    std::uint32_t component = none_;
    std::array<std::uint32_t, 3> piece{none_, none_, none_};
  };
  using Triangulation = Indexed_cdt<
      Kernel, Face_info,
      std::conditional_t<std::is_same_v<typename Kernel::FT, double>,
                         No_constraint_intersection_requiring_constructions_tag, Exact_predicates_tag>>;

public:
  using Point = typename Kernel::Point_2;

  template <class Segments>
  Component_finder(const std::vector<Point>& points, const Segments& segments)
      : cdt_(points, all_indices(points)) {
    for (const auto& s : segments) cdt_.count_segment(s[0].value(), s[1].value());
    for (const auto& s : segments) cdt_.insert_segment(s[0].value(), s[1].value());
  }
  /// Whether segments cross and the kernel rounds where they do: components cannot be found then.
  bool is_stopped_by_crossing() const { return cdt_.is_stopped_by_crossing(); }
  /// Those without a place inside that doubles can express are left out.
  template <class Segments>
  std::vector<Covered_component> find(const Segments& segments,
                                      const std::vector<Segment_of_polygon>& borders) {
    if (cdt_.cdt().dimension() < 2) return {};
    flood_components();
    find_changes(segments, borders);
    walk_components();
    std::vector<Covered_component> result;
    for (std::size_t c = 1; c < best_.size(); ++c) // 0 is the unbounded one
      if (best_[c].area > 0) result.push_back({best_[c].place, polygon_[c]});
    return result;
  }

private:
  using Cdt = typename Triangulation::Cdt;
  using Face_handle = typename Triangulation::Face_handle;

  /// The best place inside a component so far: the centroid of its largest triangle.
  struct Inner_place {
    double area = 0;
    std::array<double, 2> place{0, 0};
  };
  /// An edge between two components.
  struct Passage {
    std::uint32_t piece, to;
  };

  static std::vector<std::size_t> all_indices(const std::vector<Point>& points) {
    std::vector<std::size_t> result(points.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    return result;
  }

  void flood_components() {
    flood(cdt_.cdt().infinite_face());
    for (Face_handle f : cdt_.cdt().finite_face_handles())
      if (f->info().component == none_) flood(f);
  }

  void flood(Face_handle first) {
    const auto component = static_cast<std::uint32_t>(best_.size());
    best_.emplace_back();
    std::vector<Face_handle> stack{first};
    first->info().component = component;
    while (!stack.empty()) {
      const Face_handle f = stack.back();
      stack.pop_back();
      if (component > 0) try_centroid(f, best_[component]);
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        if (f->is_constrained(i) || g->info().component != none_) continue;
        g->info().component = component;
        stack.push_back(g);
      }
    }
  }

  /// Rounding may bring the centroid of a thin triangle out of it: exact predicates tell.
  static void try_centroid(Face_handle f, Inner_place& best) {
    std::array<double, 3> x, y;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = CGAL::to_double(f->vertex(int(k))->point().x());
      y[k] = CGAL::to_double(f->vertex(int(k))->point().y());
    }
    // Halves and thirds first: sums and products of large coordinates may overflow.
    const double scale = std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2]), std::abs(y[0]),
                                   std::abs(y[1]), std::abs(y[2]), 1e-300});
    const double area = std::abs((x[1] / scale - x[0] / scale) * (y[2] / scale - y[0] / scale) -
                                 (x[2] / scale - x[0] / scale) * (y[1] / scale - y[0] / scale)) *
                        scale;
    const double size = std::max(area, std::numeric_limits<double>::denorm_min()); // underflow is no reason
    if (!(size > best.area)) return;
    const std::array<double, 2> place{x[0] / 3 + x[1] / 3 + x[2] / 3, y[0] / 3 + y[1] / 3 + y[2] / 3};
    const Point p(place[0], place[1]);
    for (int k = 0; k < 3; ++k)
      if (CGAL::orientation(f->vertex(Cdt::ccw(k))->point(), f->vertex(Cdt::cw(k))->point(), p) != LEFT_TURN)
        return;
    best = {size, place};
  }

  /// Numbers the edges that segments go along, and lists for each the polygons that change across it.
  template <class Segments>
  void find_changes(const Segments& segments, const std::vector<Segment_of_polygon>& borders) {
    std::uint32_t pieces = 0;
    passages_.resize(best_.size());
    std::size_t border = 0;
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
      const std::size_t begin = border;
      while (border < borders.size() && borders[border].segment == s) ++border;
      cdt_.walk_segment(segments[s][0].value(), segments[s][1].value(), [&](Face_handle f, int i, bool) {
        std::uint32_t& piece = f->info().piece[std::size_t(i)];
        if (piece == none_) add_piece(f, i, piece = pieces++);
        for (std::size_t k = begin; k < border; ++k) changes_.emplace_back(piece, borders[k].polygon);
      });
    }
    std::sort(changes_.begin(), changes_.end());
    first_change_.assign(pieces + 1, 0);
    for (const auto& change : changes_) ++first_change_[change.first + 1];
    std::partial_sum(first_change_.begin(), first_change_.end(), first_change_.begin());
  }

  void add_piece(Face_handle f, int i, std::uint32_t piece) {
    const Face_handle g = f->neighbor(i);
    g->info().piece[std::size_t(cdt_.cdt().mirror_index(f, i))] = piece;
    const std::uint32_t a = f->info().component, b = g->info().component;
    if (a == b) return;
    passages_[a].push_back({piece, b});
    passages_[b].push_back({piece, a});
  }

  void cross(std::uint32_t piece) {
    for (std::size_t c = first_change_[piece]; c < first_change_[piece + 1]; ++c)
      if (!covering_.insert(changes_[c].second).second) covering_.erase(changes_[c].second);
  }

  /// Depth first; not by recursion, as components may nest deeper than the stack.
  void walk_components() {
    struct Step {
      std::uint32_t component, entered_by;
      std::size_t next = 0;
    };
    polygon_.assign(best_.size(), Covered_component::no_polygon);
    std::vector<char> is_reached(best_.size(), 0);
    is_reached[0] = 1;
    std::vector<Step> path{{0, none_}};
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next == passages_[step.component].size()) {
        if (step.entered_by != none_) cross(step.entered_by);
        path.pop_back();
        continue;
      }
      const Passage passage = passages_[step.component][step.next++];
      if (is_reached[passage.to] != 0) continue;
      is_reached[passage.to] = 1;
      cross(passage.piece);
      if (!covering_.empty()) polygon_[passage.to] = *covering_.begin();
      path.push_back({passage.to, passage.piece});
    }
  }

  Triangulation cdt_;
  std::vector<Inner_place> best_; // by component
  std::vector<std::vector<Passage>> passages_;
  std::vector<std::uint32_t> polygon_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> changes_; // piece, polygon
  std::vector<std::size_t> first_change_;                        // by piece
  std::set<std::uint32_t> covering_;                             // polygons around the walk's component
};

/// Nothing if segments cross and the kernel rounds where they do.
template <class Kernel, class Segments>
std::optional<std::vector<Covered_component>>
try_covered_components(const std::vector<std::array<double, 2>>& places, const Segments& segments,
                       const std::vector<Segment_of_polygon>& borders) {
  std::vector<typename Kernel::Point_2> points;
  points.reserve(places.size());
  for (const auto& p : places) points.emplace_back(p[0], p[1]);
  Component_finder<Kernel> finder(points, segments);
  if (finder.is_stopped_by_crossing()) return std::nullopt;
  return finder.find(segments, borders);
}

/// Components in the order of their first triangle.
/// \param places all different
/// \param segments pairs of indices of places, no pair twice
/// \param borders by segment
template <class Segments>
std::vector<Covered_component> covered_components(const std::vector<std::array<double, 2>>& places,
                                                  const Segments& segments,
                                                  const std::vector<Segment_of_polygon>& borders) {
  if (auto found =
          try_covered_components<Exact_predicates_inexact_constructions_kernel>(places, segments, borders))
    return std::move(*found);
  return *try_covered_components<Exact_predicates_exact_constructions_kernel>(places, segments, borders);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_COVERED_COMPONENTS_H
