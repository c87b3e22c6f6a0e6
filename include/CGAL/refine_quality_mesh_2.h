// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_REFINE_QUALITY_MESH_2_H
#define CGAL_REFINE_QUALITY_MESH_2_H

/// \file
/// Meshes a CGAL triangulation in place, as Mesh_2's `refine_Delaunay_mesh_2()` does.
///
/// For all functions here, `Cdt` is as for `Quality_cdt_mesher_2`, with the same guarantees: vertices and
/// constraints stay what they were, and vertex handles stay valid. If there is no domain, the report has no
/// triangles, and only the marks of faces change. All functions throw `Pslg_error_2` if the domain cannot be
/// meshed; the triangulation is then unchanged except for the marks. Expected O(n log n + k) time for k
/// triangles.

#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/compat.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Cdt_refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/criteria_options.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/mark_domain.h>
#include <CGAL/Quality_cdt_mesher_2.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/indexed_mesh_to_triangulation_2.h>

#if CGAL_QUADTREE_MESH_2_HAS_MESH_2_PARAMETERS
#include <CGAL/Named_function_parameters.h>
#endif

#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Meshes the marked faces by criteria, and asks the criteria if possible.
template <class Cdt, class Criteria>
Quality_mesh_report_2 refine_marked_domain(Cdt& cdt, const Criteria& criteria) {
  Cdt_refiner<Cdt> refiner(cdt);
  if constexpr (Can_be_asked<Criteria>::value)
    return refiner.refine(quality_mesh_options_2(criteria), criteria);
  else
    return refiner.refine(quality_mesh_options_2(criteria));
}

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Meshers
/// Meshes the domain given by the options and the seeds. With `Domain::MARKED` it is the components with a
/// seed. Otherwise it is the domain of the rule without the components that contain a seed.
/// \tparam Seeds a range of points.
template <class Cdt, class Seeds, class = decltype(std::begin(std::declval<const Seeds&>()))>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const Seeds& seeds,
                                            const Quality_mesh_options_2& options = {}) {
  Quadtree_mesh_2::internal::mark_by_rule(cdt, std::begin(seeds), std::end(seeds), options.mesh_domain());
  return Quadtree_mesh_2::internal::Cdt_refiner<Cdt>(cdt).refine(options);
}

/// \ingroup PkgQuadtreeMesh2Meshers
/// The same without seeds.
template <class Cdt>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const Quality_mesh_options_2& options) {
  return refine_quality_mesh_2(cdt, std::vector<typename Cdt::Point>(), options);
}

/// \ingroup PkgQuadtreeMesh2Meshers
/// Meshes everything that constrained edges separate from infinity. The least angle is Mesh_2's default,
/// 20.7048 degrees.
template <class Cdt>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt) {
  return refine_quality_mesh_2(
      cdt, Quality_mesh_options_2().min_angle(Quadtree_mesh_2::internal::default_angle_of_Mesh_2));
}

/// \ingroup PkgQuadtreeMesh2Meshers
/// Meshes everything that constrained edges separate from infinity, by criteria of Mesh_2. If
/// `domain_specified`, it meshes the faces with `is_in_domain()` instead.
/// \tparam Criteria a model of `MeshingCriteria_2`, as for `Quality_cdt_mesher_2`, or any class with `bound()`.
template <class Cdt, class Criteria,
          class = std::enable_if_t<Quadtree_mesh_2::internal::is_criteria<Criteria>>>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const Criteria& criteria = Criteria(),
                                            bool domain_specified = false) {
  using Quadtree_mesh_2::internal::mark_by_seeds;
  const typename Cdt::Point* no_seeds = nullptr;
  if (!domain_specified) mark_by_seeds(cdt, no_seeds, no_seeds, false);
  return Quadtree_mesh_2::internal::refine_marked_domain(cdt, criteria);
}

/// \ingroup PkgQuadtreeMesh2Meshers
/// The same with seeds. They are in the domain if `mark` is true, otherwise in holes.
template <class Cdt, class Criteria, class InputIterator,
          class = std::enable_if_t<Quadtree_mesh_2::internal::is_criteria<Criteria>>>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, InputIterator seeds_begin, InputIterator seeds_end,
                                            const Criteria& criteria = Criteria(), bool mark = false) {
  Quadtree_mesh_2::internal::mark_by_seeds(cdt, seeds_begin, seeds_end, mark);
  return Quadtree_mesh_2::internal::refine_marked_domain(cdt, criteria);
}

#if CGAL_QUADTREE_MESH_2_HAS_MESH_2_PARAMETERS
/// \ingroup PkgQuadtreeMesh2Meshers
/// The same with named parameters (\cgal 5.6 and later).
///
/// - `criteria`: a model of `MeshingCriteria_2`; by default `Delaunay_mesh_size_criteria_2<Cdt>()`
/// - `domain_is_initialized`: whether the domain is the faces with `is_in_domain()`, so that seeds are
///   ignored; by default false
/// - `seeds`: a range of points; by default empty
/// - `seeds_are_in_domain`: whether the domain is the components with a seed, or those without; by default
///   false
template <class Cdt, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const CGAL_NP_CLASS& np) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  using Default_criteria = Delaunay_mesh_size_criteria_2<Cdt>;
  using Default_seeds = std::vector<typename Cdt::Point>;
  using Seeds = typename internal_np::Lookup_named_param_def<internal_np::seeds_t, CGAL_NP_CLASS,
                                                             Default_seeds>::reference;
  if (!choose_parameter(get_parameter(np, internal_np::domain_is_initialized), false)) {
    Default_seeds no_seeds;
    Seeds seeds = choose_parameter(get_parameter_reference(np, internal_np::seeds), no_seeds);
    const bool mark = choose_parameter(get_parameter(np, internal_np::seeds_are_in_domain), false);
    Quadtree_mesh_2::internal::mark_by_seeds(cdt, std::begin(seeds), std::end(seeds), mark);
  }
  return Quadtree_mesh_2::internal::refine_marked_domain(
      cdt, choose_parameter<Default_criteria>(get_parameter_reference(np, internal_np::criteria)));
}
#endif

} // namespace CGAL

#endif // CGAL_REFINE_QUALITY_MESH_2_H
