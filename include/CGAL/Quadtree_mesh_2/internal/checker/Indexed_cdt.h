// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_INDEXED_CDT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_INDEXED_CDT_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A CGAL constrained Delaunay triangulation of indexed points and segments.
///
/// Points go in along a space-filling curve: O(n log n) in practice. Points at one place share a vertex,
/// whose `info()` is the least of their indices (their *place*). Segments may overlap and pass through
/// vertices; if they cross, `has_crossings()` is `true`.
/// \tparam Crossing_tag CGAL's: with `Exact_predicates_tag` the triangulation gets a vertex where segments cross, with
/// `No_constraint_intersection_requiring_constructions_tag` nothing is constructed, and it is of no use then.
template <class Kernel, class FaceInfo, class Crossing_tag = Exact_predicates_tag>
class Indexed_cdt {
public:
  using Point = typename Kernel::Point_2;
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using Face_base =
      Triangulation_face_base_with_info_2<FaceInfo, Kernel, Constrained_triangulation_face_base_2<Kernel>>;
  using Tds = Triangulation_data_structure_2<Vertex_base, Face_base>;
  using Cdt = Constrained_Delaunay_triangulation_2<Kernel, Tds, Crossing_tag>;
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;

  /// \param points all points;
  /// \param chosen the indices of those that become vertices.
  Indexed_cdt(const std::vector<Point>& points,
              std::vector<std::size_t> chosen) // CGAL's sort takes no other index type
      : handles_(points.size()), degrees_(points.size(), 0) {
    using Map = typename Pointer_property_map<Point>::const_type;
    using Sort_traits = Spatial_sort_traits_adapter_2<Kernel, Map>;
    spatial_sort(chosen.begin(), chosen.end(), Sort_traits(make_property_map(points.data())));
    begin_with_a_triangle(points, chosen);
    Face_handle hint;
    for (std::size_t i : chosen) {
      const auto before = cdt_.number_of_vertices();
      const Vertex_handle v = cdt_.insert(points[i], hint);
      const auto index = static_cast<std::uint32_t>(i);
      v->info() = cdt_.number_of_vertices() > before ? index : std::min(index, v->info());
      handles_[i] = v;
      hint = v->face();
    }
    distinct_ = cdt_.number_of_vertices();
  }

  /// Announces the segment, so that insert_segment() can start at the end with fewer segments: CGAL looks at
  /// all neighbors of the vertex it starts from, which makes a fan of n segments cost O(n^2) from its hub.
  void count_segment(std::uint32_t a, std::uint32_t b) {
    ++degrees_[place(a)];
    ++degrees_[place(b)];
  }
  void insert_segment(std::uint32_t a, std::uint32_t b) {
    if (is_reversed(a, b)) std::swap(a, b);
    if (handles_[a] == handles_[b]) return;
    try {
      cdt_.insert_constraint(handles_[a], handles_[b]);
    } catch (const typename Cdt::Intersection_of_constraints_exception&) {
      is_stopped_by_crossing_ = true;
    }
  }

  /// Calls `visit(f, i, forward)` for the edges along the segment, in the order from `b` to `a` if
  /// `is_reversed(a, b)`; `forward` is `true` where face `f` is on the left of the edge directed as the walk.
  /// \return `false` if the walk gets stuck, which only segments that cross can cause.
  template <class Visitor>
  bool walk_segment(std::uint32_t a, std::uint32_t b, Visitor visit) const {
    if (is_reversed(a, b)) std::swap(a, b);
    Vertex_handle v = handles_[a];
    while (v != handles_[b]) {
      Vertex_handle next;
      Face_handle f;
      int i = 0;
      if (!cdt_.includes_edge(v, handles_[b], next, f, i)) return false;
      visit(f, i, f->vertex(Cdt::ccw(i)) == v);
      v = next;
    }
    return true;
  }

  bool is_reversed(std::uint32_t a, std::uint32_t b) const { return degrees_[place(b)] < degrees_[place(a)]; }
  std::uint32_t place(std::uint32_t i) const { return handles_[i]->info(); }
  /// Whether segments cross and the tag keeps that from being constructed: some segments are missing then.
  bool is_stopped_by_crossing() const { return is_stopped_by_crossing_; }
  bool has_crossings() const { return is_stopped_by_crossing_ || cdt_.number_of_vertices() > distinct_; }
  Cdt& cdt() { return cdt_; }
  const Cdt& cdt() const { return cdt_; }

private:
  /// Moves a point off the line of the first ones to the front: CGAL locates points in O(n) each as long as all are
  /// collinear.
  static void begin_with_a_triangle(const std::vector<Point>& points, std::vector<std::size_t>& chosen) {
    const auto begin = chosen.begin(), end = chosen.end();
    const auto is_elsewhere = [&](std::size_t i) { return points[i] != points[chosen.front()]; };
    const auto second = std::find_if(begin, end, is_elsewhere);
    if (second == end) return;
    const auto off = std::find_if(second, end, [&](std::size_t i) {
      return orientation(points[chosen.front()], points[*second], points[i]) != COLLINEAR;
    });
    if (off == end) return;
    std::swap(*std::next(begin), *second);
    std::rotate(begin, off, std::next(off));
  }

  Cdt cdt_;
  std::vector<Vertex_handle> handles_;
  std::vector<std::uint32_t> degrees_; // segments at each place
  typename Cdt::size_type distinct_ = 0;
  bool is_stopped_by_crossing_ = false;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_INDEXED_CDT_H
