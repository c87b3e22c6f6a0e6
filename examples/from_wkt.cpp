// Meshes a multipolygon in WKT, with CGAL's own reader: rings become closed chains of segments, and inner rings are holes
// since the domain is what an odd number of borders separates from infinity.
// Reads a file if told which: from_wkt polygons.wkt

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/WKT.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Polygon = CGAL::Polygon_with_holes_2<Kernel>;

void add_ring(const CGAL::Polygon_2<Kernel>& ring, Pslg& graph) {
  const std::size_t first = graph.number_of_vertices(), n = ring.size();
  for (const Point& p : ring.vertices()) graph.add_vertex(p);
  for (std::size_t i = 0; i < n; ++i)
    graph.add_segment(Pslg::Vertex_index(first + i), Pslg::Vertex_index(first + (i + 1) % n));
}

int main(int argc, char** argv) {
  std::istringstream text(
      "MULTIPOLYGON(((0 0, 8 0, 8 6, 0 6, 0 0), (1 1, 3 1, 3 5, 1 5, 1 1), (5 2, 7 2, 6 4, 5 2)),"
      " ((10 0, 14 1, 12 5, 10 0)))\n");
  std::ifstream file(argc > 1 ? argv[1] : "");
  std::istream& in = argc > 1 ? static_cast<std::istream&>(file) : text;

  std::vector<Polygon> polygons;
  if (!in || !CGAL::IO::read_multi_polygon_WKT(in, polygons) || polygons.empty()) {
    std::cerr << "cannot read a multipolygon\n";
    return 1;
  }

  Pslg graph;
  for (const Polygon& polygon : polygons) {
    add_ring(polygon.outer_boundary(), graph);
    for (const auto& hole : polygon.holes()) add_ring(hole, graph);
  }
  using Options = CGAL::Quality_mesh_options_2;
  CGAL::Quality_mesher_2<> mesher(Options().min_angle(25).mesh_domain(Options::Domain::NESTING_PARITY));
  const auto mesh = mesher(graph);

  using Check = CGAL::Mesh_quality_options_2;
  const auto quality =
      CGAL::mesh_quality_2(mesh, graph, Check().min_angle(25).check_domain(Check::Domain::nesting_parity));
  std::cout << polygons.size() << " polygons, " << mesh.number_of_triangles() << " triangles, area "
            << quality.area << '\n';
  return mesher.report().is_met() && quality.is_valid() && quality.is_met() ? 0 : 1;
}
