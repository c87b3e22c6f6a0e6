// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "mesh_from_cdt.h"
#include "scratch_folder.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/SVG.h>
#include <CGAL/IO/VTU.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

namespace test_svg_vtu {

using namespace test_meshes;
namespace IO = CGAL::IO;
namespace fs = std::filesystem;

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t i = text.find(what); i != std::string::npos; i = text.find(what, i + 1)) ++n;
  return n;
}

Pslg domain_with_outside() {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 2));
  add_polygon(pslg, square(0, 0, 1));
  pslg.holes.push_back(Point(0, 0));
  pslg.add_vertex(Point(5, 0));
  add_segment(pslg, 1, 8);
  return pslg;
}

std::string svg(const Mesh& mesh, const Pslg& pslg, const IO::Svg_options_2& options = {}) {
  std::ostringstream out;
  IO::write_SVG(out, mesh, pslg, options);
  return out.str();
}

void check_well_formed(const std::string& text) {
  std::istringstream in(text);
  boost::property_tree::ptree tree;
  CHECK_NOTHROW(boost::property_tree::read_xml(in, tree));
  CHECK(tree.size() == 1);
}

/// What the exception says; empty if there is none.
template <class Function>
std::string error_of(Function f) {
  try {
    f();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST_CASE("SVG of one triangle", "[SVG]") {
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(1, 0), Point(0, 1)});
  IO::Svg_options_2 options;
  options.width(100).margin(0);
  const std::string text = svg(mesh_of(pslg), pslg, options);
  CHECK(text.find("width=\"100\" height=\"100\" viewBox=\"0 0 1000 1000\"") != std::string::npos);
  CHECK(count(text, "<path") == 3);           // area, edges, segments
  CHECK(text.find('M') == std::string::npos); // pairs of numbers after it would be absolute
  CHECK(text.find("d=\"m0 1000 1000 0-1000-1000 0 1000\"") != std::string::npos);
}

TEST_CASE("SVG options", "[SVG]") {
  const Pslg pslg = domain_with_outside();
  const Mesh mesh = mesh_of(pslg, 0.2);
  const std::string plain = svg(mesh, pslg);
  CHECK(plain.find("<svg") == 0);
  CHECK(plain.find("</svg>\n") == plain.size() - 7);
  CHECK(plain.size() < 20 * mesh.triangles.size()); // compact
  CHECK(count(plain, "<path") == 4);                // area, edges, segments, segments outside
  const std::string colored =
      svg(mesh, pslg, IO::Svg_options_2().fill_by(IO::Svg_options_2::Fill::LEAST_ANGLE));
  CHECK(count(colored, "<path") > 5);
  const std::string by_largest = svg(mesh, pslg,
                                     IO::Svg_options_2()
                                         .fill_by(IO::Svg_options_2::Fill::LARGEST_ANGLE)
                                         .legend(IO::Svg_options_2::Legend::BELOW));
  CHECK(count(by_largest, "<path") > 5);
  CHECK(by_largest.find(">largest angle</text>") != std::string::npos);
  CHECK(count(by_largest, "<text") == 13);
  CHECK(count(svg(mesh, pslg, IO::Svg_options_2().legend(IO::Svg_options_2::Legend::BELOW)), "<text") == 0);
  const std::string part = svg(mesh, pslg, IO::Svg_options_2().clip_to(CGAL::Bbox_2(-2, -2, -1, -1.5)));
  CHECK(part.size() < plain.size() / 3);
  IO::Svg_options_2 bare;
  bare.background_color("none").fill_color("none").edge_color("none");
  CHECK(count(svg(mesh, pslg, bare), "<path") == 2);
}

TEST_CASE("SVG colors by angles", "[SVG]") {
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(1, 0), Point(0, 1)}); // 45 and 90 degrees
  const auto colored = [&](IO::Svg_options_2::Fill fill) {
    return svg(mesh_of(pslg), pslg, IO::Svg_options_2().fill_by(fill));
  };
  CHECK(colored(IO::Svg_options_2::Fill::LEAST_ANGLE).find("#66c2a5") != std::string::npos);
  CHECK(colored(IO::Svg_options_2::Fill::LARGEST_ANGLE).find("#d9ef8b") != std::string::npos);
}

TEST_CASE("SVG colors by region, with a quadtree", "[SVG]") {
  Pslg pslg = domain_with_outside();
  Mesh mesh = mesh_of(pslg, 0.5);
  const IO::Svg_options_2 options =
      IO::Svg_options_2().fill_by(IO::Svg_options_2::Fill::REGION).legend(IO::Svg_options_2::Legend::BELOW);
  check_well_formed(svg(mesh, pslg, options)); // no regions
  pslg.regions = {{Point(1.5, 0), 5, 0}, {Point(-1.5, 0), 0.5, 0}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.region_of_triangle.push_back(int(t % 15) - 1);
  const std::string text = svg(mesh, pslg, options);
  check_well_formed(text);
  CHECK(count(text, "<path") == 13 + 3);
  CHECK(count(text, "<rect") == 13); // the background, and twelve colors
  CHECK(text.find(">1: 0.5</text>") != std::string::npos);

  using Quadtree = CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<>>;
  const Quadtree tree(pslg.vertices);
  std::ostringstream out;
  IO::write_SVG(out, mesh, pslg, tree, options);
  check_well_formed(out.str());
  const std::string path = out.str().substr(out.str().find("stroke=\"#c51b7d\""));
  // Those beyond the picture are left out.
  CHECK(count(path.substr(0, path.find("/>")), "z") > tree.number_of_leaves() / 4);
  CHECK(count(path.substr(0, path.find("/>")), "z") < tree.number_of_leaves());
  const Scratch_folder folder;
  IO::write_SVG(folder.file("mesh.svg"), mesh, pslg, tree, options);
  CHECK(content(folder.file("mesh.svg")) == out.str());
}

TEST_CASE("SVG and VTU are well-formed XML", "[SVG][VTU]") {
  const Pslg pslg = domain_with_outside();
  const Mesh mesh = mesh_of(pslg, 0.3);
  using Options = IO::Svg_options_2;
  for (const auto fill : {Options::Fill::PLAIN, Options::Fill::LEAST_ANGLE, Options::Fill::LARGEST_ANGLE})
    check_well_formed(svg(mesh, pslg, Options().fill_by(fill).legend(Options::Legend::BELOW)));
  std::ostringstream out;
  IO::write_VTU(out, mesh, pslg, {{"a < \"b\" & c", std::vector<double>(mesh.triangles.size(), 1)}},
                IO::ASCII);
  check_well_formed(out.str());
}

TEST_CASE("SVG of nothing, and of a level line", "[SVG]") {
  Pslg pslg;
  CHECK(count(svg(Mesh(), pslg), "</svg>") == 1);
  pslg.add_vertex(Point(0, 0));
  pslg.add_vertex(Point(1, 0));
  add_segment(pslg, 0, 1);
  Mesh mesh;
  mesh.points = pslg.vertices;
  CHECK(count(svg(mesh, pslg), "<path") == 1);
}

TEST_CASE("SVG of integer points", "[SVG]") {
  struct Integer_point {
    std::uint32_t x_, y_;
    std::uint32_t x() const { return x_; }
    std::uint32_t y() const { return y_; }
  };
  CGAL::Pslg_2<Integer_point> pslg;
  pslg.vertices = {{0, 0}, {7, 0}, {0, 4000000000u}};
  CGAL::Indexed_mesh_2<Integer_point> mesh;
  mesh.points = pslg.vertices;
  mesh.triangles.push_back({Vertex_index(0), Vertex_index(1), Vertex_index(2)});
  std::ostringstream out;
  IO::write_SVG(out, mesh, pslg);
  CHECK(count(out.str(), "<path") == 2);
}

TEST_CASE("files are replaced as a whole, and errors name them", "[SVG][VTU]") {
  const Scratch_folder folder;
  const Pslg pslg = domain_with_outside();
  const Mesh mesh = mesh_of(pslg);
  const std::string name = folder.file("mesh.svg");
  std::ofstream(name) << "old";
  IO::write_SVG(name, mesh, pslg);
  CHECK(content(name).find("<svg") == 0);
  CHECK(folder.number_of_files() == 1);
  const std::string nowhere = folder.file("missing/mesh.svg");
  CHECK(error_of([&] { IO::write_SVG(nowhere, mesh, pslg); }).find(nowhere) != std::string::npos);
  CHECK(error_of([&] { IO::write_VTU(nowhere, mesh, pslg); }).find(nowhere) != std::string::npos);
  fs::create_directories(folder.file("folder.svg/x"));
  CHECK_THROWS_AS(IO::write_SVG(folder.file("folder.svg"), mesh, pslg), std::runtime_error);
  CHECK(folder.number_of_files() == 2);
}

TEST_CASE("VTU has the triangles of the domain", "[VTU]") {
  const Scratch_folder folder;
  const Pslg pslg = domain_with_outside();
  const Mesh mesh = mesh_of(pslg, 0.5);
  const std::string name = folder.file("mesh.vtu");
  const std::size_t lines = mesh.constrained_edges.size();
  SECTION("with what is outside") {
    IO::write_VTU(name, mesh, pslg, IO::ASCII);
    const std::string text = content(name);
    CHECK(text.find("NumberOfPoints=\"" + std::to_string(mesh.points.size())) != std::string::npos);
    CHECK(text.find("NumberOfCells=\"" + std::to_string(mesh.triangles.size() + lines + 1)) !=
          std::string::npos);
    CHECK(count(text, "5 ") >= mesh.triangles.size());
  }
  SECTION("the mesh alone") {
    IO::write_VTU(name, mesh);
    const std::string text = content(name);
    CHECK(text.find("NumberOfPoints=\"" + std::to_string(mesh.points.size())) != std::string::npos);
    CHECK(text.find("NumberOfCells=\"" + std::to_string(mesh.triangles.size() + lines)) != std::string::npos);
    CHECK(text.find("AppendedData") != std::string::npos);
  }
}

} // namespace test_svg_vtu
