// Meshes a spiral by the parallel construction by quadtrees of Bern, Eppstein and Teng (Theorem 5). Prints what the
// quadtrees did, and how many triangles are left after superfluous vertices are removed, beside the mesher's default.
// Draws the mesh that the quadtrees make to a file: theorem_5 mesh.svg

#include <CGAL/IO/SVG.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Tree_separation_options_2.h>
#include <CGAL/mesh_quality_2.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>

using Mesher = CGAL::Quality_mesher_2<>;
using Point = Mesher::Point_2;
using Options = CGAL::Quality_mesh_options_2;

/// A spiral in a square: features of all sizes.
Mesher::Pslg spiral() {
  using Vertex = Mesher::Pslg::Vertex_index;
  Mesher::Pslg graph;
  for (const Point& corner : {Point(-1, -1), Point(1, -1), Point(1, 1), Point(-1, 1)})
    graph.add_vertex(corner);
  for (std::size_t i = 0; i < 4; ++i) graph.add_segment(Vertex(i), Vertex((i + 1) % 4));
  double radius = 0.9;
  for (int i = 0; i < 60; ++i, radius *= 0.93) {
    const double angle = 0.35 * i;
    const Vertex v = graph.add_vertex(Point(radius * std::cos(angle), radius * std::sin(angle)));
    if (i > 0) graph.add_segment(Vertex(std::size_t(v) - 1), v);
  }
  return graph;
}

int main(int argc, char** argv) {
  const Mesher::Pslg graph = spiral();
  const Options by_quadtrees_alone = Options().separate(CGAL::Tree_separation_options_2::of_theorem());
  Mesher mesher(Options(by_quadtrees_alone).coarsen(Options::Coarsening::NONE));
  const Mesher::Mesh mesh = mesher(graph);
  const auto& trees = mesher.report().trees;
  std::cout << "leaves of T_B " << trees.leaves_of_points << ", T_B' " << trees.leaves_of_vertices
            << ", T_B'' " << trees.leaves_of_pieces << ", T_B* " << trees.leaves_of_edges << "; "
            << trees.rounds << " rounds of placing vertices\n"
            << mesh.number_of_triangles() << " triangles by quadtrees\n";

  Mesher coarse(Options().separate(Options::Separation::THEOREM_5)), on_demand;
  std::cout << coarse(graph).number_of_triangles() << " in one round, refined and without those not needed, "
            << on_demand(graph).number_of_triangles() << " on demand\n";

  const auto quality = CGAL::mesh_quality_2(mesh, graph, CGAL::Mesh_quality_options_2().min_angle(20.7));
  try {
    if (argc > 1) CGAL::IO::write_SVG(argv[1], mesh, graph, CGAL::IO::Svg_options_2().width(480));
  } catch (const std::runtime_error& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
  return mesher.report().is_met() && coarse.report().is_met() && quality.is_valid() && quality.is_met() ? 0
                                                                                                        : 1;
}
