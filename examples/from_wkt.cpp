// Meshes polygons in WKT. Neighbors share their border, lakes are holes, and islands in lakes are meshed again.
// Reads a file if you name one: from_wkt polygons.wkt

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_WKT.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <iostream>
#include <sstream>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

int main(int argc, char** argv) {
  CGAL::Pslg_2<Point> graph;
  try {
    if (argc > 1) {
      CGAL::IO::read_WKT(argv[1], graph);
    } else {
      std::istringstream text(
          "POLYGON((0 0, 8 0, 8 6, 0 6, 0 0), (1 1, 3 1, 3 5, 1 5, 1 1), (5 2, 7 2, 6 4, 5 2))\n"
          "MULTIPOLYGON(((1.5 2, 2.5 2, 2 4, 1.5 2)), ((8 0, 12 1, 8 6, 8 0)))\n");
      CGAL::IO::read_WKT(text, graph);
    }
    CGAL::Quality_mesher_2<> mesher(CGAL::Quality_mesh_options_2().min_angle(25));
    const auto mesh = mesher(graph);

    const auto quality = CGAL::mesh_quality_2(mesh, graph, CGAL::Mesh_quality_options_2().min_angle(25));
    std::cout << graph.number_of_segments() << " segments, " << graph.holes.size() << " holes, "
              << mesh.number_of_triangles() << " triangles, area " << quality.area << '\n';
    return mesher.report().is_met() && quality.is_valid() && quality.is_met() ? 0 : 1;
  } catch (const CGAL::Pslg_error_2& error) { // says what is wrong, and where
    std::cerr << error.what() << '\n';
    return 1;
  }
}
