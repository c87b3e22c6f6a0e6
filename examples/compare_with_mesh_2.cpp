// Meshes the Great Lakes, or any .poly file, with CGAL's Mesh_2 and with Quality_mesher_2, by the same bound.
// Prints what both made. Draws a part of both meshes side by side, and writes ours for ParaView:
// compare_with_mesh_2 lakes.poly.gz both.svg ours.vtu

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_criteria_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/SVG.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/VTU.h>
#include <CGAL/Quality_mesher_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Vb = CGAL::Triangulation_vertex_base_2<Kernel>;
using Fb = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb, Fb>>;

Mesh mesh_by_Mesh_2(const Pslg& pslg) {
  std::vector<std::pair<std::size_t, std::size_t>> segments;
  for (const auto& [a, b] : pslg.segments) segments.emplace_back(std::size_t(a), std::size_t(b));
  Cdt cdt;
  cdt.insert_constraints(pslg.vertices.begin(), pslg.vertices.end(), segments.begin(), segments.end());
  using Criteria = CGAL::Delaunay_mesh_criteria_2<Cdt>;
  const double sine = std::sin(20.7 * CGAL_PI / 180);
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt, Criteria(sine * sine));
  mesher.set_seeds(pslg.holes.begin(), pslg.holes.end());
  mesher.refine_mesh();

  Mesh mesh;
  std::map<Cdt::Vertex_handle, Mesh::Vertex_index> index;
  const auto number = [&](Cdt::Vertex_handle v) {
    const auto found = index.emplace(v, Mesh::Vertex_index(mesh.points.size()));
    if (found.second) mesh.points.push_back(v->point());
    return found.first->second;
  };
  for (auto f : cdt.finite_face_handles())
    if (f->is_in_domain())
      mesh.triangles.push_back({number(f->vertex(0)), number(f->vertex(1)), number(f->vertex(2))});
  return mesh;
}

double least_angle(const Mesh& mesh) {
  double least = 180;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = mesh.point(t[(i + 1) % 3]) - mesh.point(t[i]),
                 b = mesh.point(t[(i + 2) % 3]) - mesh.point(t[i]);
      least = std::min(least, std::atan2(CGAL::determinant(a, b), a * b) * 180 / CGAL_PI);
    }
  return least;
}

/// Makes a mesh, and prints what it took.
template <class Mesher>
Mesh make_and_print(const char* name, const Mesher& make) {
  const std::clock_t begin = std::clock();
  const Mesh mesh = make();
  const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
  std::cout << name << mesh.number_of_triangles() << " triangles, least angle " << least_angle(mesh) << ", "
            << seconds << " s\n";
  return mesh;
}

/// Both meshes in one picture.
void draw(const char* file_name, const Pslg& pslg, const Mesh& theirs, const Mesh& ours) {
  const CGAL::Bbox_2 window(540000, -165000, 690000, -15000); // the Thousand Islands
  CGAL::IO::Svg_options_2 options;
  options.width(400).fill_by(CGAL::IO::Svg_options_2::Fill::LEAST_ANGLE).clip_to(window);
  std::ofstream out(file_name);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"810\" height=\"400\">\n";
  CGAL::IO::write_SVG(out, theirs, pslg, options);
  out << "<g transform=\"translate(410)\">\n";
  CGAL::IO::write_SVG(out, ours, pslg, options);
  out << "</g>\n</svg>\n";
}

int main(int argc, char** argv) try {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(argc > 1 ? argv[1] : QUADTREE_MESH_EXAMPLE_DATA_DIR "/great_lakes.poly.gz",
                               pslg);
  CGAL::Quality_mesher_2<> mesher;
  const Mesh theirs = make_and_print("CGAL Mesh_2:      ", [&] { return mesh_by_Mesh_2(pslg); }),
             ours = make_and_print("Quality_mesher_2: ", [&] { return mesher(pslg); });
  std::cout << "No angle of ours is below 20.7 degrees, except in " << mesher.report().exempt_triangles.size()
            << " triangles in corners where the input is sharper.\n";
  if (argc > 2) draw(argv[2], pslg, theirs, ours);
  if (argc > 3) CGAL::IO::write_VTU(argv[3], ours, pslg);
  return mesher.report().is_met() && ours.number_of_triangles() < theirs.number_of_triangles() ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
