// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Declares what the compiled library (src/) has: the usual meshers, and what checks their meshes. Programs that
// link the target QuadtreeMesh::compiled define CGAL_QUADTREE_MESH_2_COMPILED. The compiler then takes these meshers
// from the library, and all others from the headers.
//
// Each header that defines a mesher or exact traits sets a macro and includes this file at its end. This file declares
// what is defined by then, so it has no include guard.

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

// The header of the trapezoidal neighbors does not include the traits; programs that name these include them.
#if defined(CGAL_QUADTREE_MESH_2_HAS_TRAPEZOIDAL_NEIGHBORS) && defined(CGAL_FILTERED_QUADTREE_TRAITS_2_H)
namespace CGAL {
extern template class Trapezoidal_vertex_edge_neighbors_2<Filtered_quadtree_traits_2<>, Sequential_tag>;
extern template class Trapezoidal_vertex_edge_neighbors_2<Filtered_quadtree_traits_2<>, Parallel_tag>;
} // namespace CGAL
#endif

#ifdef CGAL_QUADTREE_MESH_2_HAS_MESH_QUALITY
namespace CGAL {
extern template Mesh_quality_2 mesh_quality_2(const Indexed_mesh_2<Quadtree_mesh_2::internal::Double_point>&,
                                              const Pslg_2<Quadtree_mesh_2::internal::Double_point>&,
                                              const Mesh_quality_options_2&);
} // namespace CGAL
#endif

#endif // CGAL_QUADTREE_MESH_2_COMPILED
