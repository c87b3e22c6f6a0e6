// Meshes points in clusters so that all triangles are acute. The number of triangles depends on the number of
// points, not on how near these are to each other. Draws the mesh to a file: acute_points mesh.svg

#include <CGAL/IO/SVG.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/Random.h>
#include <CGAL/point_generators_2.h>

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <vector>

using Mesher = CGAL::Point_set_mesher_2<>;
using Point = Mesher::Point_2;

int main(int argc, char** argv) {
  // Ten clusters, each ten times smaller than the one before.
  CGAL::Random random(1);
  CGAL::Random_points_in_disc_2<Point> in_disc(1.0, random);
  CGAL::Pslg_2<Point> graph;
  for (int cluster = 0; cluster < 10; ++cluster) {
    const Point center = *in_disc++;
    const double size = std::pow(10.0, -cluster);
    for (int i = 0; i < 30; ++i, ++in_disc)
      graph.add_vertex(Point(center.x() + size * in_disc->x(), center.y() + size * in_disc->y()));
  }

  Mesher mesher(CGAL::Point_set_mesh_options_2().acute());
  const Mesher::Mesh mesh = mesher(graph.vertices);
  const CGAL::Point_set_mesh_report_2& report = mesher.report();
  std::cout << report.input_points << " points in " << report.clusters << " clusters apart from the rest\n"
            << report.triangles << " triangles, " << report.triangles_before_coarsening
            << " before vertices were removed\nlargest angle: " << report.largest_angle << " degrees\n";

  if (argc < 2) return report.is_met() ? 0 : 1;
  try {
    using Options = CGAL::IO::Svg_options_2;
    CGAL::IO::write_SVG(argv[1], mesh, graph,
                        Options().fill_by(Options::Fill::LARGEST_ANGLE).legend(Options::Legend::BELOW));
  } catch (const std::runtime_error& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
