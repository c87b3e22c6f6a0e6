// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which meshers the compiled library has (src/). A program that links the target QuadtreeMesh::compiled is compiled
// with CGAL_QUADTREE_MESH_2_COMPILED: the compiler then takes these meshers from there, and all others from the headers
// as ever. Included at the end of each header that defines a mesher or exact traits, which says so by a macro, and declares
// what is defined by then: hence no guard around the whole.

#ifdef CGAL_QUADTREE_MESH_2_COMPILED

#include <CGAL/tags.h>

#include <cstdint>

#ifdef CGAL_QUADTREE_MESH_2_HAS_QUALITY_MESHER
namespace CGAL {
extern template class Quality_mesher_2<Filtered_quadtree_traits_2<>, Sequential_tag>;
extern template class Quality_mesher_2<Filtered_quadtree_traits_2<>, Parallel_tag>;
extern template class Quality_mesher_2<Fixed_point_quadtree_traits_2<std::uint64_t>, Sequential_tag>;
extern template class Quality_mesher_2<Fixed_point_quadtree_traits_2<std::uint64_t>, Parallel_tag>;
#ifdef CGAL_QUADTREE_MESH_2_HAS_EXACT_TRAITS
extern template class Quality_mesher_2<Exact_quadtree_traits_2<>, Sequential_tag>;
extern template class Quality_mesher_2<Exact_quadtree_traits_2<>, Parallel_tag>;
#endif
} // namespace CGAL
#endif

#ifdef CGAL_QUADTREE_MESH_2_HAS_POINT_SET_MESHER
namespace CGAL {
extern template class Point_set_mesher_2<Filtered_quadtree_traits_2<>, Sequential_tag>;
extern template class Point_set_mesher_2<Filtered_quadtree_traits_2<>, Parallel_tag>;
extern template class Point_set_mesher_2<Fixed_point_quadtree_traits_2<std::uint64_t>, Sequential_tag>;
extern template class Point_set_mesher_2<Fixed_point_quadtree_traits_2<std::uint64_t>, Parallel_tag>;
#ifdef CGAL_QUADTREE_MESH_2_HAS_EXACT_TRAITS
extern template class Point_set_mesher_2<Exact_quadtree_traits_2<>, Sequential_tag>;
extern template class Point_set_mesher_2<Exact_quadtree_traits_2<>, Parallel_tag>;
#endif
} // namespace CGAL
#endif

#endif // CGAL_QUADTREE_MESH_2_COMPILED
