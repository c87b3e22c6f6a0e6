// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The differences between the versions of CGAL that this package supports (5.5 to 6.1), in one place.
//
// CGAL 6 has the variants and optionals of std where CGAL 5 had those of boost. Mesh_2 has named parameters
// since 5.6.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_COMPAT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_COMPAT_H

#include <CGAL/version.h>

#if CGAL_VERSION_MAJOR >= 6
#include <optional>
#include <variant>
#else
#include <boost/optional.hpp>
#include <boost/variant.hpp>
#endif

/// Whether `CGAL::parameters` has `criteria`, `seeds`, `seeds_are_in_domain` and `domain_is_initialized`.
#if CGAL_VERSION_NR >= 1050600000
#define CGAL_QUADTREE_MESH_2_HAS_MESH_2_PARAMETERS 1
#else
#define CGAL_QUADTREE_MESH_2_HAS_MESH_2_PARAMETERS 0
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The variants and optionals of CGAL: those of arrangements and of intersections.
#if CGAL_VERSION_MAJOR >= 6
template <class... T>
using Cgal_variant = std::variant<T...>;
template <class T>
using Cgal_optional = std::optional<T>;
template <class T, class Variant>
const T* held_in(const Variant& v) {
  return std::get_if<T>(&v);
}
#else
template <class... T>
using Cgal_variant = boost::variant<T...>;
template <class T>
using Cgal_optional = boost::optional<T>;
template <class T, class Variant>
const T* held_in(const Variant& v) {
  return boost::get<T>(&v);
}
#endif

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_COMPAT_H
