// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Both trapezoidal decompositions of a graph as CGAL's manual has them: an arrangement of all segments for each
// axis, and what each vertex sees. What is hit beyond vertices and incident segments is not looked for.

#ifndef QUADTREE_MESH_2_BENCHMARK_NEIGHBORS_CGAL_H
#define QUADTREE_MESH_2_BENCHMARK_NEIGHBORS_CGAL_H

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arr_vertical_decomposition_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/compat.h>
#include <CGAL/version.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace neighbors_cgal {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Vertex = Arrangement::Vertex_const_handle;
using Halfedge = Arrangement::Halfedge_const_handle;
using Face = Arrangement::Face_const_handle;
using Cell = CGAL::Quadtree_mesh_2::internal::Cgal_optional<
    CGAL::Quadtree_mesh_2::internal::Cgal_variant<Vertex, Halfedge, Face>>;
using Entry = std::pair<Vertex, std::pair<Cell, Cell>>;

/// Returns how many vertices see something below or above them, for rays along y, or along x.
/// \pre segments meet in common ends only
inline std::size_t decompose(const CGAL::Pslg_2<Kernel::Point_2>& pslg, bool is_along_y) {
  const auto point = [&](CGAL::Quadtree_mesh_2::Vertex_index v) {
    const Kernel::Point_2& p = pslg.point(v);
    return is_along_y ? p : Kernel::Point_2(p.y(), p.x());
  };
  std::vector<Traits::X_monotone_curve_2> curves;
  curves.reserve(pslg.number_of_segments());
  for (const auto& s : pslg.segments) curves.emplace_back(point(s[0]), point(s[1]));
  Arrangement arrangement;
  CGAL::insert_non_intersecting_curves(arrangement, curves.begin(), curves.end());
  std::vector<Entry> entries;
  entries.reserve(arrangement.number_of_vertices());
  CGAL::decompose(arrangement, std::back_inserter(entries));
  std::size_t n = 0;
  for (const Entry& entry : entries) n += entry.second.first || entry.second.second ? 1 : 0;
  return n;
}

} // namespace neighbors_cgal

#endif // QUADTREE_MESH_2_BENCHMARK_NEIGHBORS_CGAL_H
