// Meshes a square with a square hole in it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quality_mesher_2.h>

#include <iostream>

int main() {
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  CGAL::Pslg_2<Point_2> graph;
  for (double radius : {5., 1.}) {
    const auto a = graph.add_vertex(Point_2(-radius, -radius)),
               b = graph.add_vertex(Point_2(radius, -radius)), c = graph.add_vertex(Point_2(radius, radius)),
               d = graph.add_vertex(Point_2(-radius, radius));
    graph.add_segment(a, b), graph.add_segment(b, c), graph.add_segment(c, d), graph.add_segment(d, a);
  }
  graph.holes.push_back(Point_2(0, 0));

  CGAL::Quality_mesher_2<> mesher(CGAL::Quality_mesh_options_2().min_angle(25).max_area(0.5));
  const auto mesh = mesher(graph);
  for (const auto& [a, b, c] : mesh.triangles)
    std::cout << mesh.point(a) << "  " << mesh.point(b) << "  " << mesh.point(c) << '\n';
  return mesher.report().is_met() ? 0 : 1;
}
