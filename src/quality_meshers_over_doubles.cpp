// See CGAL/Quadtree_mesh_2/compiled_meshers.h.

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/tags.h>

namespace CGAL {
template class Quality_mesher_2<Filtered_quadtree_traits_2<>, Sequential_tag>;
template class Quality_mesher_2<Filtered_quadtree_traits_2<>, Parallel_tag>;
} // namespace CGAL
