// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What the compiled library has: meshers over the usual traits, and the checker of meshes. A program that links the
// target QuadtreeMesh::compiled is compiled with CGAL_QUADTREE_MESH_2_COMPILED. The compiler then takes these from the
// library, and everything else from the headers.
//
// Each header that defines one of these classes, or exact traits, sets a macro and includes this file at its end. Each
// time this file declares what is defined by then. That is why there is no guard around the whole.

#include <CGAL/tags.h>

#include <cstdint>

#ifndef CGAL_QUADTREE_MESH_2_INSTANTIATE

/// PREFIX is `extern`, or empty in the library itself.
#define CGAL_QUADTREE_MESH_2_INSTANTIATE(PREFIX, CLASS, TRAITS)                                              \
  PREFIX template class CLASS<TRAITS, Sequential_tag>;                                                       \
  PREFIX template class CLASS<TRAITS, Parallel_tag>

#define CGAL_QUADTREE_MESH_2_INSTANTIATE_MESH_QUALITY(PREFIX, TAG)                                           \
  PREFIX template Mesh_quality_2 mesh_quality_2<TAG>(                                                        \
      const Indexed_mesh_2<Quadtree_mesh_2::internal::Double_point>&,                                        \
      const Pslg_2<Quadtree_mesh_2::internal::Double_point>&, const Mesh_quality_options_2&)

#endif // CGAL_QUADTREE_MESH_2_INSTANTIATE

#ifdef CGAL_QUADTREE_MESH_2_COMPILED

namespace CGAL {

#ifdef CGAL_QUADTREE_MESH_2_HAS_QUALITY_MESHER
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Quality_mesher_2, Filtered_quadtree_traits_2<>);
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Quality_mesher_2, Fixed_point_quadtree_traits_2<std::uint64_t>);
#ifdef CGAL_QUADTREE_MESH_2_HAS_EXACT_TRAITS
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Quality_mesher_2, Exact_quadtree_traits_2<>);
#endif
#endif

#ifdef CGAL_QUADTREE_MESH_2_HAS_POINT_SET_MESHER
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Point_set_mesher_2, Filtered_quadtree_traits_2<>);
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Point_set_mesher_2, Fixed_point_quadtree_traits_2<std::uint64_t>);
#ifdef CGAL_QUADTREE_MESH_2_HAS_EXACT_TRAITS
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Point_set_mesher_2, Exact_quadtree_traits_2<>);
#endif
#endif

// Their header does not include the traits: whoever names both includes them.
#if defined(CGAL_QUADTREE_MESH_2_HAS_TRAPEZOIDAL_NEIGHBORS) && defined(CGAL_FILTERED_QUADTREE_TRAITS_2_H)
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Trapezoidal_vertex_edge_neighbors_2, Filtered_quadtree_traits_2<>);
#endif

#ifdef CGAL_QUADTREE_MESH_2_HAS_MESH_QUALITY
CGAL_QUADTREE_MESH_2_INSTANTIATE_MESH_QUALITY(extern, Sequential_tag);
CGAL_QUADTREE_MESH_2_INSTANTIATE_MESH_QUALITY(extern, Parallel_tag);
#endif

} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_COMPILED
