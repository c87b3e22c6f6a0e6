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

/// Whether a point is near a corner of the input below the angle bound, where edges may grow faster.
class Sharp_corners {
public:
  Sharp_corners(const Mesher::Mesh& mesh, const CGAL::Quality_mesh_report_2& report, double gradation) {
    for (const auto& exempt : report.exempt_triangles)
      for (const auto v : mesh.triangles[std::size_t(exempt.triangle)]) {
        const Point& corner = mesh.point(exempt.corner);
        disks_.push_back({corner, (2 + 2 / gradation) * length(corner, mesh.point(v))});
      }
  }
  bool are_near(const Point& p) const {
    return std::any_of(disks_.begin(), disks_.end(),
                       [&](const Disk& disk) { return length(p, disk.center) <= disk.radius; });
  }

private:
  struct Disk {
    Point center;
    double radius;
  };
  std::vector<Disk> disks_;
};

/// The greatest factor by which edges with a common end differ, but for triangles near sharp corners.
double greatest_ratio(const Mesher::Mesh& mesh, const Sharp_corners& corners) {
  std::vector<double> shortest(mesh.points.size(), HUGE_VAL), longest(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles) {
    const bool is_near =
        std::any_of(t.begin(), t.end(), [&](auto v) { return corners.are_near(mesh.point(v)); });
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      const double edge = length(mesh.point(a), mesh.point(b));
      for (const auto v : {std::size_t(a), std::size_t(b)}) {
        shortest[v] = std::min(shortest[v], edge);
        if (!is_near) longest[v] = std::max(longest[v], edge);
      }
    }
  }
  double ratio = 1;
  for (std::size_t v = 0; v < longest.size(); ++v) ratio = std::max(ratio, longest[v] / shortest[v]);
  return ratio;
}

int main(int argc, char** argv) try {
  Mesher::Pslg graph;
  CGAL::IO::read_triangle_poly(argc > 1 ? argv[1] : QUADTREE_MESH_EXAMPLE_DATA_DIR "/great_lakes.poly.gz",
                               graph);
  struct Bound {
    const char* name;
    Options options;
    double ratio; ///< of edges with a common end; 0: any
  };
  const Bound bounds[] = {{"none", Options(), 0},
                          {"ratio 3", Options().max_edge_ratio(3), 3},
                          {"gradation 0.3", Options().gradation(0.3), 3},
                          {"gradation 0.2", Options().gradation(0.2), 3},
                          {"gradation 0.2, ratio 5", Options().gradation(0.2).max_edge_ratio(5), 5}};
  std::size_t free = 0;
  bool is_met = true;
  for (const Bound& bound : bounds) {
    Mesher mesher(bound.options);
    const Mesher::Mesh mesh = mesher(graph);
    const double gradation = bound.options.gradation() > 0 ? bound.options.gradation() : 1;
    const double ratio = greatest_ratio(mesh, Sharp_corners(mesh, mesher.report(), gradation));
    if (free == 0) free = mesh.triangles.size();
    std::cout << bound.name << ": " << mesh.triangles.size() << " triangles, "
              << double(mesh.triangles.size()) / double(free)
              << " times those without; edges with a common end differ by a factor of up to " << ratio
              << '\n';
    is_met = is_met && mesher.report().is_met() && (bound.ratio == 0 || ratio <= bound.ratio);
  }
  return is_met ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
