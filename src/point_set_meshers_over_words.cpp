// See CGAL/Quadtree_mesh_2/compiled_meshers.h.

#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/tags.h>

#include <cstdint>

namespace CGAL {
template class Point_set_mesher_2<Fixed_point_quadtree_traits_2<std::uint64_t>, Sequential_tag>;
template class Point_set_mesher_2<Fixed_point_quadtree_traits_2<std::uint64_t>, Parallel_tag>;
} // namespace CGAL
