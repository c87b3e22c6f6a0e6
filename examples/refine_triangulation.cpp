// From CGAL's Mesh_2: where the program had Delaunay_mesher_2.h and refine_Delaunay_mesh_2(cdt, criteria), it
// has this.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/refine_quality_mesh_2.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vb = CGAL::Triangulation_vertex_base_2<Kernel>;
using Fb = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
using Point = Cdt::Point;

int main() {
  Cdt cdt;
  for (const double r : {4.0, 1.0}) { // a square with a square hole
    const std::vector<Point> corners{{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    cdt.insert_constraint(corners.begin(), corners.end(), true);
  }
  const std::vector<Point> seeds{{0, 0}};

  const auto report =
      CGAL::refine_quality_mesh_2(cdt, seeds, CGAL::Quality_mesh_options_2().min_angle(25).max_edge(1));

  std::size_t faces = 0;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    faces += f->is_in_domain() ? 1 : 0;
  std::cout << cdt.number_of_vertices() << " vertices, " << faces << " triangles in the domain, "
            << report.unmet_triangles.size() << " below the bound\n";
  return report.is_met() ? 0 : 1;
}
