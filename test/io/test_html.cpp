// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What a page has of a mesh, read out of the file by Boost's base64 and nlohmann's JSON. What it shows in a browser is
// tested in test/browser.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "scratch_folder.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/HTML.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/renumber_mesh_2.h>

#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace test_html {

using namespace test_meshes;
namespace IO = CGAL::IO;

namespace {

/// The text of the element with an id, and that of its tag.
std::pair<std::string, std::string> element(const std::string& page, const std::string& id) {
  const std::size_t name = page.find(" id=\"" + id + '"');
  if (name == std::string::npos) return {};
  const std::size_t tag = page.rfind('<', name), begin = page.find('>', name) + 1;
  return {page.substr(begin, page.find("</", begin) - begin), page.substr(tag, begin - tag)};
}

template <class Number>
std::vector<Number> array(const std::string& page, const std::string& id, const std::string& type) {
  using namespace boost::archive::iterators;
  auto [text, tag] = element(page, id);
  CHECK(tag.find("data-type=\"" + type + '"') != std::string::npos);
  CHECK(text.size() % 4 == 0);
  const std::size_t filled = std::size_t(std::count(text.begin(), text.end(), '='));
  std::replace(text.begin(), text.end(), '=', 'A');
  using Bytes = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
  std::string bytes{Bytes(text.cbegin()), Bytes(text.cend())};
  bytes.resize(bytes.size() - filled);
  std::vector<Number> values(bytes.size() / sizeof(Number));
  CHECK(bytes.size() == values.size() * sizeof(Number));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

nlohmann::json head(const std::string& page) { return nlohmann::json::parse(element(page, "head").first); }

template <class... Arguments>
std::string page_of(const Arguments&... arguments) {
  std::ostringstream out;
  IO::write_HTML(out, arguments...);
  return out.str();
}

/// A frame with regions and a segment outside.
struct Frame {
  Pslg pslg;
  Mesh mesh;

  Frame() {
    add_polygon(pslg, square(0, 0, 2));
    add_polygon(pslg, square(0, 0, 1));
    pslg.holes.push_back(Point(0, 0));
    pslg.add_vertex(Point(5, 1. / 3));
    add_segment(pslg, 1, 8);
    pslg.regions = {{Point(1.5, 1.5), 0.1, 0}, {Point(-1.5, 0), -7, 0}};
    pslg.first_number = 1;
    mesh = mesh_from_cdt(triangulate(pslg, 0.4), pslg);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.region_of_triangle.push_back(int(t % 3) - 1);
  }
};

template <class Word>
void check_vertices(const std::string& page, const Mesh& mesh, const std::string& type) {
  std::vector<Word> triangles, edges;
  for (const auto& t : mesh.triangles)
    for (const Vertex_index v : t) triangles.push_back(static_cast<Word>(v.value()));
  for (const auto& e : mesh.constrained_edges)
    for (const Vertex_index v : e.vertices) edges.push_back(static_cast<Word>(v.value()));
  CHECK(array<Word>(page, "triangles", type) == triangles);
  CHECK(array<Word>(page, "edges", type) == edges);
}

template <class Kernel_of_points>
std::vector<double> coordinates(const CGAL::Indexed_mesh_2<typename Kernel_of_points::Point_2>& mesh) {
  std::vector<double> result;
  for (const auto& p : mesh.points)
    for (const auto& c : {p.x(), p.y()}) result.push_back(CGAL::to_double(c));
  return result;
}

} // namespace

TEST_CASE("a page has the mesh bit for bit", "[io][html]") {
  Frame frame;
  const bool is_renumbered = GENERATE(false, true);
  if (is_renumbered) CGAL::renumber_by_place(frame.mesh);
  const std::vector<Triangle_index> unmet{Triangle_index(3), Triangle_index(0)};
  using Options = IO::Html_options_2;
  const std::string page =
      page_of(frame.mesh, frame.pslg,
              Options().title("a < b & c").color_by(Options::Color::REGION).unmet_triangles(unmet));
  CHECK(array<double>(page, "points", "Float64") == coordinates<Kernel>(frame.mesh));
  check_vertices<std::uint16_t>(page, frame.mesh, "Uint16");
  CHECK(array<std::uint32_t>(page, "unmet", "Uint32") == std::vector<std::uint32_t>{3, 0});
  const auto regions = array<std::int8_t>(page, "regions", "Int8");
  CHECK(std::vector<int>(regions.begin(), regions.end()) == frame.mesh.region_of_triangle);
  const auto outside = array<std::uint16_t>(page, "outside", "Uint16");
  REQUIRE(outside.size() == 2);
  CHECK(frame.mesh.points[outside[0]] == frame.pslg.vertices[1]);
  CHECK(frame.mesh.points[outside[1]] == frame.pslg.vertices[8]);
  CHECK(head(page) ==
        nlohmann::json{{"first", 1}, {"color", "region"}, {"attributes", std::vector<double>{0.1, -7}}});
  CHECK(page.find("<title>a &lt; b &amp; c</title>") != std::string::npos);
  CHECK(page.find("<h1>a &lt; b &amp; c</h1>") != std::string::npos);
  for (const char* absent : {"quadtree", "coordinates"}) CHECK(element(page, absent).second.empty());
}

TEST_CASE("a page asks for nothing from elsewhere", "[io][html]") {
  const Frame frame;
  const std::string page = page_of(frame.mesh, frame.pslg);
  for (const char* request :
       {"http:", "https:", "src=", "@import", "url(", "fetch(", "XMLHttpRequest", "import("})
    CHECK(page.find(request) == std::string::npos);
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(head(page).at("color") == "least_angle");
}

TEST_CASE("a page has coordinates of any size, exact ones as the doubles next to them", "[io][html]") {
  using Limits = std::numeric_limits<double>;
  Mesh extreme;
  extreme.points = {Point(-Limits::max(), -5e-324), Point(Limits::max(), 0), Point(1e-310, Limits::max())};
  extreme.triangles = {{Vertex_index(0), Vertex_index(1), Vertex_index(2)}};
  CHECK(array<double>(page_of(extreme, Pslg()), "points", "Float64") == coordinates<Kernel>(extreme));

  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Indexed_mesh_2<Exact::Point_2> exact;
  exact.points = {{Exact::FT(1) / 3, 0}, {1, Exact::FT(2) / 7}, {0, 1}};
  exact.triangles = extreme.triangles;
  CHECK(array<double>(page_of(exact, CGAL::Pslg_2<Exact::Point_2>()), "points", "Float64") ==
        coordinates<Exact>(exact));

  using Float_kernel = CGAL::Simple_cartesian<float>;
  CGAL::Indexed_mesh_2<Float_kernel::Point_2> floats;
  floats.points = {{0.1f, 0}, {1, 0.3f}, {0, 1}};
  floats.triangles = extreme.triangles;
  CHECK(array<double>(page_of(floats, CGAL::Pslg_2<Float_kernel::Point_2>()), "points", "Float64") ==
        coordinates<Float_kernel>(floats));
}

TEST_CASE("a page with many vertices or regions has longer words, one without triangles none", "[io][html]") {
  Mesh mesh;
  for (int i = 0; i < 65537; ++i) mesh.points.emplace_back(i, i % 2);
  for (std::size_t v : {0u, 65534u})
    mesh.triangles.push_back({Vertex_index(v), Vertex_index(v + 2), Vertex_index(v + 1)});
  mesh.region_of_triangle = {-1, 128};
  const std::string page = page_of(mesh, Pslg());
  check_vertices<std::uint32_t>(page, mesh, "Uint32");
  CHECK(array<std::int16_t>(page, "regions", "Int16") == std::vector<std::int16_t>{-1, 128});
  mesh.region_of_triangle[1] = 32768;
  CHECK(array<std::int32_t>(page_of(mesh, Pslg()), "regions", "Int32") == mesh.region_of_triangle);

  const std::string empty = page_of(Mesh(), Pslg());
  for (const char* name : {"triangles", "edges", "outside"})
    CHECK(array<std::uint16_t>(empty, name, "Uint16").empty());
  CHECK(element(empty, "regions").second.empty());
}

TEST_CASE("a page has the leaves of a quadtree", "[io][html]") {
  using Quadtree = CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<>>;
  const Frame frame;
  const Quadtree tree(frame.pslg.vertices);
  const std::string page = page_of(frame.mesh, frame.pslg, tree);
  const auto bits = array<std::uint8_t>(page, "quadtree", "Uint8");
  // Leaves by their lower left corner and side, counted.
  using Square = std::array<double, 3>;
  std::map<Square, int> leaves;
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) {
    const auto corners = tree.corners(Quadtree::Leaf_index(l));
    ++leaves[{corners[0].x(), corners[0].y(), corners[2].x() - corners[0].x()}];
  }
  const auto root = head(page).at("quadtree");
  std::vector<Square> open{{root.at("x"), root.at("y"), root.at("side")}};
  std::size_t n = 0;
  for (; !open.empty(); ++n) {
    REQUIRE(n / 8 < bits.size());
    const auto [x, y, side] = open.back();
    open.pop_back();
    const double half = side / 2;
    if ((bits[n / 8] >> n % 8 & 1) == 0)
      --leaves[{x, y, side}];
    else // the southwest is the next
      for (const auto& [i, j] : {std::pair(1, 1), std::pair(1, 0), std::pair(0, 1), std::pair(0, 0)})
        open.push_back({x + i * half, y + j * half, half});
  }
  CHECK((n + 7) / 8 == bits.size());
  CHECK(std::all_of(leaves.begin(), leaves.end(), [](const auto& leaf) { return leaf.second == 0; }));
  CHECK(leaves.size() == tree.number_of_leaves());
}

TEST_CASE("a page tells other coordinates than it draws, if there are any", "[io][html]") {
  const Frame frame;
  std::vector<std::array<double, 2>> told;
  std::vector<double> numbers;
  for (std::size_t v = 0; v < frame.mesh.points.size(); ++v) {
    told.push_back({double(v) / 3, -double(v)});
    numbers.insert(numbers.end(), told.back().begin(), told.back().end());
  }
  using Options = IO::Html_options_2;
  CHECK(array<double>(page_of(frame.mesh, frame.pslg, Options().coordinates(told)), "coordinates",
                      "Float64") == numbers);
  told.pop_back();
  CHECK_THROWS_AS(page_of(frame.mesh, frame.pslg, Options().coordinates(told)), std::invalid_argument);
  for (const Triangle_index t : {Triangle_index(frame.mesh.triangles.size()), Triangle_index()})
    CHECK_THROWS_AS(page_of(frame.mesh, frame.pslg, Options().unmet_triangles({t})), std::invalid_argument);
}

TEST_CASE("a page is written as a file, or not at all", "[io][html]") {
  const Frame frame;
  const Scratch_folder folder;
  IO::write_HTML(folder.file("mesh.html"), frame.mesh, frame.pslg);
  CHECK(content(folder.file("mesh.html")) == page_of(frame.mesh, frame.pslg));
  CHECK_THROWS_AS(IO::write_HTML(folder.file("none/mesh.html"), frame.mesh, frame.pslg), std::system_error);
  CHECK(folder.number_of_files() == 1);
}

} // namespace test_html
