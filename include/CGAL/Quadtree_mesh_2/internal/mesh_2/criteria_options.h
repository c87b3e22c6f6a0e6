// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CRITERIA_OPTIONS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CRITERIA_OPTIONS_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Criteria, class = void>
struct Has_bound : std::false_type {};
template <class Criteria>
struct Has_bound<Criteria, std::void_t<decltype(std::declval<const Criteria&>().bound())>> : std::true_type {
};

template <class Criteria, class = void>
struct Has_size_bound : std::false_type {};
template <class Criteria>
struct Has_size_bound<Criteria, std::void_t<decltype(std::declval<const Criteria&>().size_bound())>>
    : std::true_type {};

template <class Criteria, class = void>
struct Has_local_size : std::false_type {};
template <class Criteria>
struct Has_local_size<Criteria, std::void_t<decltype(std::declval<const Criteria&>().is_local_size())>>
    : std::true_type {};

template <class Criteria, class = void>
struct Can_be_asked : std::false_type {};
template <class Criteria>
struct Can_be_asked<Criteria, std::void_t<typename Criteria::Quality,
                                          decltype(std::declval<const Criteria&>().is_bad_object())>>
    : std::true_type {};

/// Whether a class says what triangles should be like, as the criteria of Mesh_2 do.
template <class Criteria>
constexpr bool is_criteria = Has_bound<Criteria>::value || Can_be_asked<Criteria>::value;

/// The least angle, in degrees, at which the squared sine is 1/8, Mesh_2's default.
constexpr double default_angle_of_Mesh_2 = 20.704811054635429;

} // namespace internal
} // namespace Quadtree_mesh_2

/// The options that ask for the same as criteria of Mesh_2, as far as these tell.
/// \tparam Criteria may have `bound()`, the squared sine of the least angle, and `size_bound()`, the longest
/// edge (0: none), as `Delaunay_mesh_criteria_2` and `Delaunay_mesh_size_criteria_2` do. Mesh_2's default,
/// 1/8, is 20.7048 degrees. Bounds above 34 degrees become 34. A size that holds in some places only
/// (`is_local_size()`) does not become an option.
template <class Criteria>
Quality_mesh_options_2 quality_mesh_options_2(const Criteria& criteria) {
  Quality_mesh_options_2 options;
  if constexpr (Quadtree_mesh_2::internal::Has_bound<Criteria>::value) {
    constexpr double greatest = Quality_mesh_options_2::greatest_min_angle;
    const double bound = std::min(1.0, std::max(0.0, criteria.bound()));
    options.min_angle(
        std::min(greatest, std::asin(std::sqrt(bound)) * Quadtree_mesh_2::internal::degrees_per_radian));
  }
  if constexpr (Quadtree_mesh_2::internal::Has_size_bound<Criteria>::value) {
    bool is_local = false;
    if constexpr (Quadtree_mesh_2::internal::Has_local_size<Criteria>::value)
      is_local = criteria.is_local_size();
    if (!is_local) options.max_edge(criteria.size_bound());
  }
  return options;
}

} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CRITERIA_OPTIONS_H
