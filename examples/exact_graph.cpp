// Meshes a triangle with corners at thirds and sevenths, which doubles cannot express. With exact constructions,
// Steiner vertices on the sides of the triangle lie on them exactly.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Quality_mesher_2.h>

#include <cstddef>
#include <iostream>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using FT = Kernel::FT;
using Point = Kernel::Point_2;
using Mesher = CGAL::Quality_mesher_2<CGAL::Exact_quadtree_traits_2<Kernel>>;

int main() {
  Mesher::Pslg graph;
  const auto a = graph.add_vertex(Point(FT(1) / 3, FT(1) / 7)),
             b = graph.add_vertex(Point(FT(9) / 7, FT(1) / 3)),
             c = graph.add_vertex(Point(FT(2) / 3, FT(8) / 7));
  graph.add_segment(a, b), graph.add_segment(b, c), graph.add_segment(c, a);

  Mesher mesher(CGAL::Quality_mesh_options_2().max_area(0.001)); // options are doubles all the same
  const Mesher::Mesh mesh = mesher(graph);

  std::size_t on_segments = 0, exactly = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const auto s = mesh.segment_of_vertex[v];
    if (!s.is_valid()) continue;
    ++on_segments;
    const auto& [p, q] = graph.segments[std::size_t(s)];
    if (CGAL::collinear(graph.point(p), mesh.points[v], graph.point(q))) ++exactly;
  }
  FT area = 0;
  for (const auto& t : mesh.triangles)
    area += CGAL::area(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
  const bool is_area_exact = area == CGAL::area(graph.point(a), graph.point(b), graph.point(c));
  std::cout << mesh.number_of_triangles() << " triangles; " << exactly << " of " << on_segments
            << " Steiner vertices on sides lie on them exactly; the areas add up to " << area
            << (is_area_exact ? ", exactly that of the triangle\n" : ", not that of the triangle\n");
  return mesher.report().is_met() && exactly == on_segments && is_area_exact ? 0 : 1;
}
