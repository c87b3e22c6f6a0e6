// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_ARRANGE_PSLG_2_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_ARRANGE_PSLG_2_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

// Where the vertices and segments of a graph that may be faulty meet: all segments become constraints of one
// constrained Delaunay triangulation whose hierarchy (Constrained_triangulation_plus_2) remembers through
// which vertices each one goes. Expected O(n log n) time for n vertices in any order, and what the segments
// cost to force.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A graph whose segments are cut at each vertex on them. Its vertices are those of the input, then the
/// crossings.
struct Arranged_pslg_2 {
  /// Per input vertex, the first input vertex at its place.
  std::vector<Vertex_index> first_at_place;
  /// Per input segment, the vertices it goes through from end to end, first at their places; empty if its
  /// length is zero.
  std::vector<std::vector<Vertex_index>> chains;
  /// Where segments cross that share no input vertex there; rounded to doubles.
  std::vector<std::array<double, 2>> crossings;
};

/// The same for an edge and its reverse.
inline std::uint64_t unordered_pair_key(Vertex_index a, Vertex_index b) {
  return b < a ? unordered_pair_key(b, a) : (std::uint64_t(a.value()) << 32) | b.value();
}

/// How a triangulation treats constraints that cross.
template <class Kernel, class Intersection_tag>
using Arranging_triangulation_2 = Constrained_triangulation_plus_2<Constrained_Delaunay_triangulation_2<
    Kernel,
    Triangulation_data_structure_2<Triangulation_vertex_base_with_info_2<Vertex_index, Kernel>,
                                   Constrained_triangulation_face_base_2<Kernel>>,
    Intersection_tag>>;

/// Stops at the first crossing; all that is found before is exact.
using Crossing_free_triangulation_2 =
    Arranging_triangulation_2<Exact_predicates_inexact_constructions_kernel,
                              No_constraint_intersection_requiring_constructions_tag>;
/// Cuts at exact crossings; some ten times slower.
using Exact_triangulation_2 =
    Arranging_triangulation_2<Exact_predicates_exact_constructions_kernel, Exact_intersections_tag>;

/// Arranges a graph in a triangulation of one of the three types above.
template <class Triangulation>
class Pslg_arranger_2 {
public:
  template <class Point>
  explicit Pslg_arranger_2(const Pslg_2<Point>& pslg) {
    static_assert(std::is_floating_point_v<Coordinate_t<Point>>,
                  "crossings are computed for points with floating-point coordinates only");
    insert_vertices(pslg);
    result_.chains.resize(pslg.segments.size());
    constraints_.reserve(pslg.segments.size());
  }

  /// Forces all segments in their order.
  /// \return the segment that crosses an earlier one, if the triangulation is one that stops there.
  template <class Point>
  std::optional<Segment_index> insert_segments(const Pslg_2<Point>& pslg) {
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      const Vertex_handle a = handles_[pslg.segments[s][0]];
      const Vertex_handle b = handles_[pslg.segments[s][1]];
      try {
        constraints_.emplace_back();
        if (a != b) constraints_.back() = triangulation_.insert_constraint(a, b);
      } catch (const typename Triangulation::Intersection_of_constraints_exception&) {
        return Segment_index(s);
      }
    }
    return std::nullopt;
  }

  /// \pre `insert_segments()` has returned nothing.
  Arranged_pslg_2 result() {
    for (std::size_t s = 0; s < constraints_.size(); ++s)
      if (constraints_[s])
        for (const Vertex_handle v : triangulation_.vertices_in_constraint(*constraints_[s]))
          result_.chains[s].push_back(index_of(v));
    return std::move(result_);
  }

private:
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;
  using Constraint_id = typename Triangulation::Constraint_id;
  using Kernel = typename Triangulation::Geom_traits;
  using Kernel_point = typename Triangulation::Point;

  /// Along a space-filling curve, where each place is found from the one before in constant expected time.
  template <class Point>
  void insert_vertices(const Pslg_2<Point>& pslg) {
    std::vector<Kernel_point> points;
    points.reserve(pslg.vertices.size());
    for (const Point& p : pslg.vertices) points.emplace_back(p.x(), p.y());
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto point_map = make_property_map(std::as_const(points));
    using Sort_traits = Spatial_sort_traits_adapter_2<Kernel, std::decay_t<decltype(point_map)>>;
    spatial_sort(order.begin(), order.end(), Sort_traits(point_map));
    handles_.resize(points.size());
    Face_handle hint;
    for (const std::size_t i : order) {
      handles_[i] = triangulation_.insert(points[i], hint);
      hint = handles_[i]->face();
    }
    result_.first_at_place.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!handles_[i]->info().is_valid()) handles_[i]->info() = Vertex_index(i);
      result_.first_at_place.push_back(handles_[i]->info());
    }
  }

  Vertex_index index_of(Vertex_handle v) {
    if (!v->info().is_valid()) {
      v->info() = Vertex_index(handles_.size() + result_.crossings.size());
      result_.crossings.push_back({CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y())});
    }
    return v->info();
  }

  Triangulation triangulation_;
  std::vector<Vertex_handle> handles_;
  std::vector<std::optional<Constraint_id>> constraints_; ///< nothing for segments of length zero
  Arranged_pslg_2 result_;
};

/// Where two lines meet, by exact arithmetic, rounded.
/// \pre Segments `s` and `t` are not parallel.
template <class Point>
std::array<double, 2> crossing_of_segments(const Pslg_2<Point>& pslg, Segment_index s, Segment_index t) {
  using Exact_kernel = Exact_predicates_exact_constructions_kernel;
  const auto exact = [&pslg](Segment_index i, std::size_t end) {
    const Point& p = pslg.point(pslg.segments[i][end]);
    return Exact_kernel::Point_2(p.x(), p.y());
  };
  const Exact_kernel::Point_2 a = exact(s, 0), c = exact(t, 0);
  const Exact_kernel::Vector_2 ab = exact(s, 1) - a, cd = exact(t, 1) - c, ac = c - a;
  const auto cross = [](const Exact_kernel::Vector_2& u, const Exact_kernel::Vector_2& v) {
    return Exact_kernel::FT(u.x() * v.y() - u.y() * v.x());
  };
  const Exact_kernel::FT ratio = cross(ac, cd) / cross(ab, cd);
  const Exact_kernel::Point_2 p = a + ratio * ab;
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

/// Do the insides of two segments meet in one point? Exact.
template <class Point>
bool do_segments_cross(const Pslg_2<Point>& pslg, Segment_index s, Segment_index t) {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  const auto end = [&pslg](Segment_index i, std::size_t k) {
    const Point& p = pslg.point(pslg.segments[i][k]);
    return Kernel::Point_2(p.x(), p.y());
  };
  const Kernel::Point_2 a = end(s, 0), b = end(s, 1), c = end(t, 0), d = end(t, 1);
  return CGAL::orientation(a, b, c) * CGAL::orientation(a, b, d) == NEGATIVE &&
         CGAL::orientation(c, d, a) * CGAL::orientation(c, d, b) == NEGATIVE;
}

/// The first segment before `s` that crosses it. Linear, for the one message about it.
template <class Point>
std::optional<Segment_index> find_crossed_segment(const Pslg_2<Point>& pslg, Segment_index s) {
  for (Segment_index t(0); t < s; ++t)
    if (do_segments_cross(pslg, t, s)) return t;
  return std::nullopt;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_ARRANGE_PSLG_2_H
