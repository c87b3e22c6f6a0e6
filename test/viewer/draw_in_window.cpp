// Draws a mesh of points, then the quadtree of its vertices, in two windows one after the other.

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/draw_balanced_quadtree.h>
#include <CGAL/draw_indexed_mesh_2.h>

#include <cmath>

int main() {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  using CGAL::Quadtree_mesh_2::Vertex_index;
  // A fan of triangles around the first point.
  constexpr int n = 12;
  CGAL::Indexed_mesh_2<Point> mesh;
  mesh.points.emplace_back(0, 0);
  for (int i = 0; i < n; ++i) mesh.points.emplace_back(std::cos(0.5 * i), std::sin(0.5 * i));
  for (int i = 1; i < n; ++i)
    mesh.triangles.push_back({Vertex_index(0), Vertex_index(i), Vertex_index(i + 1)});
  CGAL::draw(mesh, "A fan");
  CGAL::draw(CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<>>(mesh.points));
}
