// Meshes a plate of three materials, each with its own bound on the area of triangles. Counts the triangles of
// each. Only components with the point of a region are meshed; the fourth has none.
// Draws the mesh to a file: mesh_regions mesh.svg

#include <CGAL/IO/SVG.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <vector>

using Mesher = CGAL::Quality_mesher_2<>;
using Point = Mesher::Point_2;
using Options = CGAL::Quality_mesh_options_2;

int main(int argc, char** argv) {
  // A square that a cross cuts into four.
  Mesher::Pslg plate;
  for (const Point& p : {Point(-1, -1), Point(0, -1), Point(1, -1), Point(1, 0), Point(1, 1), Point(0, 1),
                         Point(-1, 1), Point(-1, 0), Point(0, 0)})
    plate.add_vertex(p);
  using Vertex = Mesher::Pslg::Vertex_index;
  for (unsigned i = 0; i < 8; ++i) plate.add_segment(Vertex(i), Vertex((i + 1) % 8));
  for (unsigned i = 1; i < 8; i += 2) plate.add_segment(Vertex(i), Vertex(8));

  // Place, attribute (free to use), largest area of a triangle (0: no bound of its own).
  plate.regions = {{Point(-.5, -.5), 1, 0.001}, {Point(.5, -.5), 2, 0.004}, {Point(.5, .5), 3, 0}};

  Mesher mesher(Options().max_area(0.02).mesh_domain(Options::Domain::MARKED));
  const Mesher::Mesh mesh = mesher(plate);

  std::vector<std::size_t> triangles(plate.regions.size());
  for (const int region : mesh.region_of_triangle) ++triangles[std::size_t(region)];
  for (std::size_t r = 0; r < triangles.size(); ++r)
    std::cout << "region with attribute " << plate.regions[r].attribute << ": " << triangles[r]
              << " triangles\n";

  using Check = CGAL::Mesh_quality_options_2; // it knows the regions' bounds
  const auto quality = CGAL::mesh_quality_2(
      mesh, plate, Check().min_angle(20.7).max_area(0.02).check_domain(Check::Domain::MARKED_BY_REGIONS));
  std::cout << (quality.is_valid() && quality.is_met() ? "checked\n" : "the mesh is wrong\n");

  try {
    using Svg = CGAL::IO::Svg_options_2;
    if (argc > 1) CGAL::IO::write_SVG(argv[1], mesh, plate, Svg().width(480).fill_by(Svg::Fill::REGION));
  } catch (const std::runtime_error& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
  return mesher.report().is_met() && quality.is_valid() && quality.is_met() ? 0 : 1;
}
