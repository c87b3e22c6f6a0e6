// Shows the progress of meshing, and stops it halfway. The mesh so far is a valid triangulation. The report tells
// which triangles miss the bound, and why.

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <cmath>
#include <iostream>

using Mesher = CGAL::Quality_mesher_2<>;
using Point = Mesher::Point_2;

/// A star with thin teeth: much to refine.
Mesher::Pslg star(int teeth) {
  Mesher::Pslg graph;
  for (int i = 0; i < 2 * teeth; ++i) {
    const double angle = CGAL_PI * i / teeth, radius = i % 2 == 0 ? 1 : 0.3;
    graph.add_vertex(Point(radius * std::cos(angle), radius * std::sin(angle)));
  }
  const auto n = graph.number_of_vertices();
  for (std::size_t i = 0; i < n; ++i)
    graph.add_segment(Mesher::Pslg::Vertex_index(i), Mesher::Pslg::Vertex_index((i + 1) % n));
  return graph;
}

int main() {
  double next = 0;
  const auto show = [&](double share) {
    for (; next <= share; next += 0.25) std::cout << int(100 * next) << " % " << std::flush;
    return true;
  };
  const auto stop_at_half = [&](double share) { return share < 0.5; };

  const Mesher::Pslg graph = star(500);
  const CGAL::Quality_mesh_options_2 options = CGAL::Quality_mesh_options_2().max_area(1e-4);
  Mesher patient{CGAL::Quality_mesh_options_2(options).progress(show)};
  const Mesher::Mesh mesh = patient(graph);
  std::cout << mesh.number_of_triangles() << " triangles\n";

  Mesher hasty{CGAL::Quality_mesh_options_2(options).progress(stop_at_half)};
  const Mesher::Mesh part = hasty(graph);
  std::size_t cancelled = 0;
  for (const auto& unmet : hasty.report().unmet_triangles)
    cancelled += unmet.reason == CGAL::Quality_mesh_report_2::Reason::CANCELLED ? 1 : 0;
  const bool is_valid = CGAL::mesh_quality_2(part, graph).is_valid();
  std::cout << "stopped at half: " << part.number_of_triangles() << " triangles, " << cancelled
            << " of them miss a bound; the mesh is " << (is_valid ? "valid" : "invalid") << '\n';
  return patient.report().is_met() && hasty.report().is_cancelled && is_valid ? 0 : 1;
}
