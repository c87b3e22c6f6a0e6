// A program that comes from CGAL's Mesh_2. CGAL/Quality_mesher_2.h and refine_quality_mesh_2() replace
// CGAL/Delaunay_mesher_2.h and refine_Delaunay_mesh_2(), with the same triangulation, criteria and seeds. The
// returned report tells which bounds were met.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quality_mesher_2.h>

#include <cstddef>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vb = CGAL::Triangulation_vertex_base_2<Kernel>;
using Fb = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
using Point = Cdt::Point;

int main() {
  Cdt cdt;
  for (const double r : {4.0, 1.0}) { // a square with a square hole
    const std::vector<Point> corners{{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    cdt.insert_constraint(corners.begin(), corners.end(), true);
  }
  const std::vector<Point> holes{{0, 0}};
  const Criteria criteria(0.125, 1); // sin^2 of the least angle, longest edge

  const CGAL::Quality_mesh_report_2 report =
      CGAL::refine_quality_mesh_2(cdt, holes.begin(), holes.end(), criteria);

  std::size_t triangles = 0;
  for (auto f : cdt.finite_face_handles()) triangles += f->is_in_domain() ? 1 : 0;
  std::cout << cdt.number_of_vertices() << " vertices, " << triangles << " triangles in the domain, "
            << report.unmet_triangles.size() << " below a bound\n";
  return report.is_met() && cdt.is_valid() ? 0 : 1;
}
