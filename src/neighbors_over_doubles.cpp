// See CGAL/Quadtree_mesh_2/compiled_meshers.h.

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>
#include <CGAL/tags.h>

namespace CGAL {
template class Trapezoidal_vertex_edge_neighbors_2<Filtered_quadtree_traits_2<>, Sequential_tag>;
template class Trapezoidal_vertex_edge_neighbors_2<Filtered_quadtree_traits_2<>, Parallel_tag>;
} // namespace CGAL
