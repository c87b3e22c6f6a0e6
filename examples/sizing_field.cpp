// Meshes a square by a size field: triangles are small near a circle and grow with the distance from it. Any function
// of a place will do; CGAL/Grid_sizing_field_2.h and CGAL/Points_sizing_field_2.h make one from data.
// Draws the mesh to a file: sizing_field mesh.svg

#include <CGAL/IO/SVG.h>
#include <CGAL/Quality_mesher_2.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>

using Mesher = CGAL::Quality_mesher_2<>;
using Point = Mesher::Point_2;

/// The longest edge that a triangle with its centroid at (x, y) may have.
double size(double x, double y) { return 0.02 + 0.3 * std::fabs(std::hypot(x, y) - 0.6); }

double length(const Point& a, const Point& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

int main(int argc, char** argv) {
  Mesher::Pslg square;
  const auto a = square.add_vertex({-1, -1}), b = square.add_vertex({1, -1}), c = square.add_vertex({1, 1}),
             d = square.add_vertex({-1, 1});
  square.add_segment(a, b), square.add_segment(b, c), square.add_segment(c, d), square.add_segment(d, a);

  Mesher mesher(CGAL::Quality_mesh_options_2().size(size));
  const Mesher::Mesh mesh = mesher(square);

  double worst = 0; // how much of the size wanted the longest edge of a triangle takes at most
  for (const auto& t : mesh.triangles) {
    const Point &p = mesh.point(t[0]), &q = mesh.point(t[1]), &r = mesh.point(t[2]);
    const double longest = std::max({length(p, q), length(q, r), length(r, p)});
    worst = std::max(worst, longest / size((p.x() + q.x() + r.x()) / 3, (p.y() + q.y() + r.y()) / 3));
  }
  std::cout << mesh.number_of_triangles() << " triangles, with edges up to " << worst
            << " of the size wanted\n";

  try {
    if (argc > 1) CGAL::IO::write_SVG(argv[1], mesh, square, CGAL::IO::Svg_options_2().width(480));
  } catch (const std::runtime_error& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
  return mesher.report().is_met() && worst <= 1 ? 0 : 1;
}
