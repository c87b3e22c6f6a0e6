// Meshes a square; the exit status tells whether all angles meet the bound.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quality_mesher_2.h>

int main() {
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  CGAL::Pslg_2<Point_2> graph;
  const auto a = graph.add_vertex(Point_2(0, 0)), b = graph.add_vertex(Point_2(1, 0)),
             c = graph.add_vertex(Point_2(1, 1)), d = graph.add_vertex(Point_2(0, 1));
  graph.add_segment(a, b), graph.add_segment(b, c), graph.add_segment(c, d), graph.add_segment(d, a);
  CGAL::Quality_mesher_2<> mesher(CGAL::Quality_mesh_options_2().max_area(0.01));
  const auto mesh = mesher(graph);
  return mesher.report().is_met() && mesh.triangles.size() >= 100 ? 0 : 1;
}
