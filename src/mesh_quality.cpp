// See CGAL/Quadtree_mesh_2/compiled_meshers.h.

#include <CGAL/mesh_quality_2.h>

namespace CGAL {
template Mesh_quality_2 mesh_quality_2(const Indexed_mesh_2<Quadtree_mesh_2::internal::Double_point>&,
                                       const Pslg_2<Quadtree_mesh_2::internal::Double_point>&,
                                       const Mesh_quality_options_2&);
} // namespace CGAL
