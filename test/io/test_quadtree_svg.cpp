// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_test_inputs.h"
#include "scratch_folder.h"

#include <CGAL/IO/quadtree_SVG.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace test_quadtree_svg {

using namespace quadtree_test;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Node_index;
namespace IO = CGAL::IO;
namespace fs = std::filesystem;

namespace {

using Options = IO::Quadtree_svg_options;
using Filtered_quadtree = CGAL::Balanced_quadtree<Filtered_traits>;

template <class Quadtree>
std::string svg(const Quadtree& tree, const Options& options = {}) {
  std::ostringstream out;
  IO::write_SVG(out, tree, options);
  return out.str();
}

/// An element of the picture: its name and attributes.
struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
};

/// Reads the XML that SVG writers here produce; anything that is not well formed fails the test.
std::vector<Element> elements_of(const std::string& text) {
  std::vector<Element> elements;
  std::vector<std::string> open;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '<') {
      REQUIRE(text[i] == '\n');
      ++i;
      continue;
    }
    const std::size_t end = text.find('>', i);
    REQUIRE(end != std::string::npos);
    std::string tag = text.substr(i + 1, end - i - 1);
    i = end + 1;
    if (tag[0] == '/') {
      REQUIRE_FALSE(open.empty());
      REQUIRE(open.back() == tag.substr(1));
      open.pop_back();
      continue;
    }
    REQUIRE((!open.empty() || elements.empty())); // one root
    const bool is_empty = tag.back() == '/';
    if (is_empty) tag.pop_back();
    std::size_t k = tag.find(' ');
    Element e{tag.substr(0, k), {}};
    while (k < tag.size()) {
      const std::size_t equals = tag.find("=\"", k), quote = tag.find('"', equals + 2);
      REQUIRE((equals != std::string::npos && quote != std::string::npos));
      REQUIRE(
          e.attributes.emplace(tag.substr(k + 1, equals - k - 1), tag.substr(equals + 2, quote - equals - 2))
              .second);
      k = quote + 1;
    }
    if (!is_empty) open.push_back(e.name);
    elements.push_back(e);
  }
  REQUIRE(open.empty());
  return elements;
}

/// A line between two points of the picture.
using Line = std::tuple<long, long, long, long>;

/// The lines of a path in the order in which they are drawn: m, l and z with relative numbers.
std::vector<Line> lines_of(const std::string& d) {
  std::vector<Line> lines;
  long x = 0, y = 0, x0 = 0, y0 = 0;
  char command = 0;
  for (const char* p = d.c_str(); *p != 0;) {
    if (*p == 'z') {
      lines.emplace_back(x, y, x0, y0);
      x = x0, y = y0;
      command = *p++;
      continue;
    }
    if (*p == 'm' || *p == 'l') command = *p++;
    char* end = nullptr;
    const long dx = std::strtol(p, &end, 10);
    REQUIRE(end != p);
    p = end;
    const long dy = std::strtol(p, &end, 10);
    REQUIRE(end != p);
    p = end;
    if (command == 'm') {
      x0 = x + dx, y0 = y + dy;
      command = 'l';
    } else {
      REQUIRE(command == 'l');
      lines.emplace_back(x, y, x + dx, y + dy);
    }
    x += dx, y += dy;
  }
  return lines;
}

/// The lines of all paths with the given stroke; none if there is no such path.
std::vector<Line> lines_with(const std::string& text, const std::string& stroke) {
  std::vector<Line> lines;
  for (const Element& e : elements_of(text))
    if (e.name == "path" && e.attributes.count("stroke") > 0 && e.attributes.at("stroke") == stroke)
      for (const Line& line : lines_of(e.attributes.at("d"))) lines.push_back(line);
  return lines;
}

std::vector<Line> edges_of(const std::string& text) { return lines_with(text, Options().edge_color()); }
std::size_t number_of_dots(const std::string& text) {
  return lines_with(text, Options().point_color()).size();
}

} // namespace

TEST_CASE("The picture of a quadtree of no points is its root", "[SVG][balanced]") {
  Options options;
  options.width(100).margin(0);
  const std::string text = svg(Filtered_quadtree(), options);
  CHECK(elements_of(text).front().attributes.at("viewBox") == "0 0 1000 1000");
  CHECK(edges_of(text) ==
        std::vector<Line>{{0, 0, 1000, 0}, {1000, 0, 1000, 1000}, {1000, 1000, 0, 1000}, {0, 1000, 0, 0}});
  CHECK(number_of_dots(text) == 0);
}

TEST_CASE("The picture of one point is a dot in the root", "[SVG][balanced]") {
  for (double x : {0., 7., -1e300, 5e-324, 1e-310}) {
    const Filtered_quadtree tree(std::vector<Filtered_traits::Point_2>{{x, 1.}});
    const std::string text = svg(tree);
    CHECK(edges_of(text).size() == 4);
    CHECK(number_of_dots(text) == 1);
  }
}

TEMPLATE_TEST_CASE("A picture has a cross for each split square, and no edge twice", "[SVG][balanced]",
                   Filtered_traits, Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  // Few enough points for all squares to be large enough to be seen.
  const auto points = make_points<TestType>(uniform(100, 1));
  const CGAL::Balanced_quadtree<TestType> tree(points);
  REQUIRE(tree.depth() < 12);
  Options options;
  options.margin(0);
  options.width(8192); // a power of two: nothing is rounded
  const std::string text = svg(tree, options);
  const std::vector<Line> edges = edges_of(text);
  const std::size_t split = tree.number_of_nodes() - tree.number_of_leaves();
  CHECK(tree.number_of_leaves() == 3 * split + 1);
  CHECK(edges.size() == 4 + 2 * split);
  CHECK(number_of_dots(text) == tree.framework().number_of_points());

  // Each unit of length of each line is drawn once: lines on one axis do not overlap.
  std::map<std::pair<bool, long>, std::vector<std::pair<long, long>>> intervals;
  long length = 0;
  for (const auto& [x0, y0, x1, y1] : edges) {
    REQUIRE((x0 == x1) != (y0 == y1));
    const bool is_upright = x0 == x1;
    const std::pair<long, long> interval = is_upright ? std::minmax({y0, y1}) : std::minmax({x0, x1});
    intervals[{is_upright, is_upright ? x0 : y0}].push_back(interval);
    length += interval.second - interval.first;
  }
  for (auto& [axis, on_axis] : intervals) {
    std::sort(on_axis.begin(), on_axis.end());
    for (std::size_t i = 1; i < on_axis.size(); ++i) REQUIRE(on_axis[i - 1].second <= on_axis[i].first);
  }
  // So together they are all sides of leaves, of which inner ones belong to two.
  long sides = 4 * 81920;
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) sides += 4 * (81920 >> tree.level(Leaf_index(l)));
  CHECK(2 * length == sides);
}

TEST_CASE("Leaves are colored by level", "[SVG][balanced]") {
  const Filtered_quadtree tree(make_points<Filtered_traits>(clusters(2)));
  const std::string text = svg(tree, Options().fill_by(Options::Fill::LEVEL).width(4096));
  std::set<std::string> colors;
  std::size_t areas = 0;
  for (const Element& e : elements_of(text))
    if (e.name == "path" && e.attributes.count("fill") > 0) {
      CHECK(colors.insert(e.attributes.at("fill")).second);
      areas += lines_of(e.attributes.at("d")).size() / 4;
    }
  CHECK(colors.count("#f8f6e3") == 1); // the largest
  CHECK(colors.count("#317a99") == 1); // the smallest
  // A plain fill has the same areas in one color.
  Options plain;
  plain.width(4096).fill_color("#eeeeee");
  CHECK(lines_with(svg(tree, plain), "#eeeeee").size() == 4 * areas);
}

TEST_CASE("Squares of the framework are emphasized where asked", "[SVG][balanced]") {
  const Filtered_quadtree tree(make_points<Filtered_traits>(uniform(50, 3)));
  REQUIRE(tree.depth() < 12);
  CHECK(lines_with(svg(tree, Options().width(8192)), "#12263a").empty());
  CHECK(lines_with(svg(tree, Options().width(8192).framework_color("#12263a")), "#12263a").size() ==
        4 * tree.framework().number_of_nodes());
}

TEST_CASE("What cannot be seen does not make a picture of a quadtree larger", "[SVG][balanced]") {
  const Filtered_quadtree large(make_points<Filtered_traits>(uniform(10000, 4)));
  const std::string text = svg(large);
  CHECK(edges_of(text).size() > 20000);
  CHECK(text.size() < 15 * large.number_of_leaves() + 15 * 10000);
  CHECK(number_of_dots(text) <= 10000);
  CHECK(number_of_dots(text) > 9900);
  const Filtered_quadtree deep(make_points<Filtered_traits>(spiral()));
  REQUIRE(deep.depth() > 40);
  CHECK(edges_of(svg(deep)).size() < 4 + 2 * 30 * 12); // twelve levels can be seen, of sixty
  CHECK(svg(large, Options().width(80)).size() < text.size() * 2 / 3);
  for (const Options& options : {Options().edge_color("none"), Options().point_color("none")}) {
    CHECK(elements_of(svg(large, options)).size() == elements_of(text).size() - 1);
  }
}

TEST_CASE("Pictures of quadtrees have a window", "[SVG][balanced]") {
  const Filtered_quadtree tree(make_points<Filtered_traits>(uniform(10000, 5)));
  const auto corners = tree.corners(tree.locate(tree.framework().grid().point({1ull << 61, 1ull << 61})));
  const CGAL::Bbox_2 window(corners[0].x(), corners[0].y(), corners[2].x(), corners[2].y());
  Options options;
  options.width(100).clip_to(window).margin(0);
  const std::string text = svg(tree, options);
  const Element picture = elements_of(text).front();
  CHECK(picture.attributes.at("width") == "100");
  CHECK(picture.attributes.at("height") == "100");
  CHECK(number_of_dots(text) <= 2); // in the leaf, or on its border
  CHECK(text.size() < 2000);
  options.clip_to(CGAL::Bbox_2(1e20, 1e20, 2e20, 2e20));
  CHECK(edges_of(svg(tree, options)).empty());
}

TEST_CASE("Picture files of quadtrees are replaced as a whole, and errors name them", "[SVG][balanced]") {
  const Scratch_folder folder;
  const Filtered_quadtree tree(make_points<Filtered_traits>(uniform(10, 6)));
  const std::string name = folder.file("tree.svg");
  std::ofstream(name) << "old";
  IO::write_SVG(name, tree);
  CHECK(content(name) == svg(tree));
  CHECK(folder.number_of_files() == 1);
  const std::string nowhere = folder.file("missing/tree.svg");
  std::string error;
  try {
    IO::write_SVG(nowhere, tree);
  } catch (const std::runtime_error& e) {
    error = e.what();
  }
  CHECK(error.find(nowhere) != std::string::npos);
  fs::create_directories(folder.file("folder.svg/x"));
  CHECK_THROWS_AS(IO::write_SVG(folder.file("folder.svg"), tree), std::runtime_error);
  CHECK(folder.number_of_files() == 2);
}

} // namespace test_quadtree_svg
