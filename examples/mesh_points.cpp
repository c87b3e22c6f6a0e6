// Meshes random points with the fewest triangles: no angle below 20.7 degrees, in a box around the points.
// Draws the mesh to a file: mesh_points mesh.svg

#include <CGAL/IO/SVG.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/Random.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/point_generators_2.h>

#include <iostream>
#include <stdexcept>

using Mesher = CGAL::Point_set_mesher_2<>;
using Point = Mesher::Point_2;

int main(int argc, char** argv) {
  CGAL::Random random(1);
  CGAL::Random_points_in_disc_2<Point> in_disc(1.0, random);
  CGAL::Pslg_2<Point> graph; // its vertices are the points; there are no segments
  for (int i = 0; i < 500; ++i) graph.add_vertex(*in_disc++);

  Mesher mesher(CGAL::Point_set_mesh_options_2().least_angle());
  const Mesher::Mesh mesh = mesher(graph.vertices);
  std::cout << mesher.report().input_points << " points, " << mesher.report().triangles
            << " triangles with angles from " << mesher.report().least_angle << " to "
            << mesher.report().largest_angle << " degrees\n";

  using Check = CGAL::Mesh_quality_options_2;
  const auto quality =
      CGAL::mesh_quality_2(mesh, graph, Check().min_angle(20.7).check_domain(Check::Domain::ANY));
  std::cout << (quality.is_valid() && quality.is_met() ? "checked\n" : "the mesh is wrong\n");

  try {
    using Options = CGAL::IO::Svg_options_2;
    if (argc > 1)
      CGAL::IO::write_SVG(
          argv[1], mesh, graph,
          Options().width(480).fill_by(Options::Fill::LEAST_ANGLE).legend(Options::Legend::BELOW));
  } catch (const std::runtime_error& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
  return mesher.report().is_met() && quality.is_valid() && quality.is_met() ? 0 : 1;
}
