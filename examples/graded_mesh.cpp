// Bounds how fast edges grow, and counts what that takes: meshes of the Great Lakes, or of a .poly file, without such a
// bound, with one on edges that have a common end, and with gradations.

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <vector>

using Mesher = CGAL::Quality_mesher_2<>;
using Options = CGAL::Quality_mesh_options_2;
using Point = Mesher::Point_2;

double length(const Point& a, const Point& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

/// The greatest factor by which edges with a common end differ, outside of corners of the input below the angle bound.
double greatest_ratio(const Mesher::Mesh& mesh, const CGAL::Quality_mesh_report_2& report) {
  std::vector<double> shortest(mesh.points.size(), 0), longest(mesh.points.size(), 0);
  std::vector<char> is_exempt(mesh.triangles.size(), 0);
  for (const auto& t : report.exempt_triangles) is_exempt[std::size_t(t.triangle)] = 1;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      const double edge = length(mesh.point(a), mesh.point(b));
      for (const auto v : {std::size_t(a), std::size_t(b)}) {
        shortest[v] = shortest[v] > 0 ? std::min(shortest[v], edge) : edge;
        longest[v] = is_exempt[t] != 0 ? HUGE_VAL : std::max(longest[v], edge);
      }
    }
  double ratio = 1;
  for (std::size_t v = 0; v < shortest.size(); ++v)
    if (longest[v] > 0 && longest[v] < HUGE_VAL) ratio = std::max(ratio, longest[v] / shortest[v]);
  return ratio;
}

int main(int argc, char** argv) try {
  Mesher::Pslg graph;
  CGAL::IO::read_triangle_poly(argc > 1 ? argv[1] : QUADTREE_MESH_EXAMPLE_DATA_DIR "/great_lakes.poly.gz",
                               graph);
  struct Bound {
    const char* name;
    Options options;
  };
  const Bound bounds[] = {{"none", Options()},
                          {"ratio 3", Options().max_edge_ratio(3)},
                          {"gradation 0.3", Options().gradation(0.3)},
                          {"gradation 0.2", Options().gradation(0.2)},
                          {"gradation 0.2, ratio 5", Options().gradation(0.2).max_edge_ratio(5)}};
  std::size_t free = 0;
  bool is_met = true;
  for (const Bound& bound : bounds) {
    Mesher mesher(bound.options);
    const Mesher::Mesh mesh = mesher(graph);
    if (free == 0) free = mesh.triangles.size();
    std::cout << bound.name << ": " << mesh.triangles.size() << " triangles, "
              << double(mesh.triangles.size()) / double(free)
              << " times those without; edges with a common end differ by a factor of up to "
              << greatest_ratio(mesh, mesher.report()) << '\n';
    is_met = is_met && mesher.report().is_met();
  }
  return is_met ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
