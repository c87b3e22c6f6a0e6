// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_REFINE_QUALITY_MESH_2_H
#define CGAL_REFINE_QUALITY_MESH_2_H

/// \file
/// Meshing a CGAL triangulation in place: what takes the place of Mesh_2's `refine_Delaunay_mesh_2()`.

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/indexed_mesh_to_triangulation_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Criteria, class = void>
struct Has_size_bound : std::false_type {};
template <class Criteria>
struct Has_size_bound<Criteria, std::void_t<decltype(std::declval<const Criteria&>().size_bound())>>
    : std::true_type {};

} // namespace internal
} // namespace Quadtree_mesh_2

/// The options that ask for what criteria of Mesh_2 ask for.
/// \tparam Criteria has `bound()`, the squared sine of the least angle, and maybe `size_bound()`, the longest
/// edge (0: none), as `Delaunay_mesh_criteria_2` and `Delaunay_mesh_size_criteria_2` have. Mesh_2's default,
/// 1/8, becomes 20.7 degrees, and what is above 30 degrees becomes 30.
template <class Criteria>
Quality_mesh_options_2 quality_mesh_options_2(const Criteria& criteria) {
  constexpr double degrees = 180 / 3.14159265358979323846, largest = 30, of_an_eighth = 20.7;
  const double bound = criteria.bound();
  const double angle = std::asin(std::sqrt(std::min(0.25, std::max(0.0, bound)))) * degrees;
  Quality_mesh_options_2 options;
  options.min_angle(std::min(bound <= 0.125 ? of_an_eighth : largest, angle));
  if constexpr (Quadtree_mesh_2::internal::Has_size_bound<Criteria>::value)
    options.max_edge(criteria.size_bound());
  return options;
}

/// Replaces a constrained triangulation by a quality mesh of its domain.
///
/// The domain is that of `options`. With `Domain::MARKED` the seeds tell which components are in it,
/// otherwise which are not. Afterwards `cdt` is a valid constrained Delaunay triangulation whose faces in the
/// domain, those with `is_in_domain()`, are the mesh; what is between them and the convex hull is filled with
/// faces that are not. Vertex and face handles from before are invalid.
/// \tparam Cdt a `Constrained_Delaunay_triangulation_2` over doubles whose faces model
/// `DelaunayMeshFaceBase_2`.
/// \tparam Seeds a range of points.
/// \throws Pslg_error_2 if there is no domain; `cdt` is then as it was.
template <class Cdt, class Seeds, class = decltype(std::begin(std::declval<const Seeds&>()))>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const Seeds& seeds,
                                            const Quality_mesh_options_2& options = {}) {
  using Kernel = typename Kernel_traits<typename Cdt::Point>::Kernel;
  auto pslg = pslg_from_triangulation_2(cdt, seeds);
  if (options.domain == Quality_mesh_options_2::Domain::MARKED) {
    for (const auto& seed : pslg.holes) pslg.regions.push_back({seed, 0, 0});
    pslg.holes.clear();
  }
  // on all cores if the program links TBB: the mesh is the same
  Quality_mesher_2<Filtered_quadtree_traits_2<Kernel>, Parallel_tag> mesher(options);
  indexed_mesh_to_constrained_Delaunay_triangulation_2(mesher(pslg), pslg, cdt);
  return mesher.report();
}

/// The same without seeds.
template <class Cdt>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const Quality_mesh_options_2& options = {}) {
  return refine_quality_mesh_2(cdt, std::vector<typename Cdt::Point>(), options);
}

/// The same by criteria of Mesh_2.
template <class Cdt, class Criteria, class = void, class = decltype(std::declval<const Criteria&>().bound())>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const Criteria& criteria) {
  return refine_quality_mesh_2(cdt, quality_mesh_options_2(criteria));
}

/// The same with the parameters of `refine_Delaunay_mesh_2()`: `mark` tells whether the seeds are in the
/// domain (true) or in holes.
template <class Cdt, class InputIterator, class Criteria>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, InputIterator seeds_begin, InputIterator seeds_end,
                                            const Criteria& criteria, bool mark = false) {
  Quality_mesh_options_2 options = quality_mesh_options_2(criteria);
  if (mark) options.mesh_domain(Quality_mesh_options_2::Domain::MARKED);
  return refine_quality_mesh_2(cdt, std::vector<typename Cdt::Point>(seeds_begin, seeds_end), options);
}

} // namespace CGAL

#endif // CGAL_REFINE_QUALITY_MESH_2_H
