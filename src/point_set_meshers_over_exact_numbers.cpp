// See CGAL/Quadtree_mesh_2/compiled_meshers.h.

#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/tags.h>

namespace CGAL {
template class Point_set_mesher_2<Exact_quadtree_traits_2<>, Sequential_tag>;
template class Point_set_mesher_2<Exact_quadtree_traits_2<>, Parallel_tag>;
} // namespace CGAL
