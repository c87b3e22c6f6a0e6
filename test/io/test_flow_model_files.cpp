// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Files of flow models: .2dm, .gr3 and .14, read line by line as their manuals have them, and the loops of borders in
// them, checked by brute force.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "scratch_folder.h"

#include <CGAL/IO/ADCIRC.h>
#include <CGAL/IO/SMS_2DM.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Border_loops.h>
#include <CGAL/renumber_mesh_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_flow_model_files {

using namespace test_meshes;
namespace IO = CGAL::IO;
using CGAL::Quadtree_mesh_2::internal::Border_loop;
using CGAL::Quadtree_mesh_2::internal::border_loops;
using CGAL::Quadtree_mesh_2::internal::Border_loops;

namespace {

using Side = std::pair<std::size_t, std::size_t>;
using Sides = std::multiset<Side>;

// --- meshes ---

/// Triangles of a grid of squares, each halved by a diagonal, that `is_kept(x, y, half)`. Vertices in any order.
template <class Is_kept>
Mesh grid_mesh(std::size_t n, unsigned seed, const Is_kept& is_kept) {
  std::mt19937 random(seed);
  std::vector<std::size_t> order((n + 1) * (n + 1));
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  Mesh mesh;
  mesh.points.resize(order.size());
  const auto vertex = [&](std::size_t x, std::size_t y) { return Vertex_index(order[y * (n + 1) + x]); };
  for (std::size_t y = 0; y <= n; ++y)
    for (std::size_t x = 0; x <= n; ++x) mesh.points[std::size_t(vertex(x, y))] = Point(double(x), double(y));
  for (std::size_t y = 0; y < n; ++y)
    for (std::size_t x = 0; x < n; ++x) {
      const auto a = vertex(x, y), b = vertex(x + 1, y), c = vertex(x + 1, y + 1), d = vertex(x, y + 1);
      if (is_kept(x, y, 0)) mesh.triangles.push_back({a, b, c});
      if (is_kept(x, y, 1)) mesh.triangles.push_back({c, d, a});
    }
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  return mesh;
}

/// A grid without some of its squares.
Mesh grid_without(std::size_t n, const std::set<Side>& squares) {
  return grid_mesh(n, 1, [&](std::size_t x, std::size_t y, int) { return squares.count({x, y}) == 0; });
}

Mesh one_triangle() {
  Mesh mesh;
  mesh.points = {Point(9, 9), Point(0, 0), Point(1. / 3, 0), Point(0.1, 0.7)};
  mesh.triangles.push_back({Vertex_index(1), Vertex_index(2), Vertex_index(3)});
  return mesh;
}

/// A square with a hole and another square, in regions, with a vertex that nothing uses.
Mesh mesh_with_regions() {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 2));
  add_polygon(pslg, square(0, 0, 1));
  pslg.add_vertex(Point(0.25, 0.125));
  add_polygon(pslg, square(5.1, 0, 1.1));
  pslg.holes.push_back(Point(0, 0));
  Mesh mesh = mesh_of(pslg, 0.5);
  for (const auto& t : mesh.triangles) {
    const Point& p = mesh.point(t[0]);
    mesh.region_of_triangle.push_back(p.x() > 3 ? 4 : p.y() > 0 ? 0 : -1);
  }
  return mesh;
}

// --- loops by brute force ---

Side side_of(const std::array<Vertex_index, 3>& t, std::size_t k) {
  return {std::size_t(t[k]), std::size_t(t[(k + 1) % 3])};
}

Sides border_sides(const Mesh& mesh) {
  Sides all, border;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) all.insert(side_of(t, k));
  for (const Side& s : all)
    if (all.count({s.second, s.first}) == 0) border.insert(s);
  return border;
}

std::size_t number_of_components(const Mesh& mesh) {
  std::map<Side, std::size_t> at;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) at[side_of(mesh.triangles[t], k)] = t;
  std::vector<char> is_seen(mesh.triangles.size(), 0);
  std::size_t components = 0;
  for (std::size_t first = 0; first < mesh.triangles.size(); ++first) {
    if (is_seen[first] != 0) continue;
    ++components;
    std::vector<std::size_t> waiting{first};
    is_seen[first] = 1;
    while (!waiting.empty()) {
      const std::size_t t = waiting.back();
      waiting.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const Side s = side_of(mesh.triangles[t], k);
        const auto found = at.find({s.second, s.first});
        if (found == at.end() || is_seen[found->second] != 0) continue;
        is_seen[found->second] = 1;
        waiting.push_back(found->second);
      }
    }
  }
  return components;
}

/// Twice the area, exact for small integers.
double area(const Mesh& mesh, const std::vector<Vertex_index>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = mesh.point(polygon[i]), &q = mesh.point(polygon[(i + 1) % polygon.size()]);
    sum += p.x() * q.y() - q.x() * p.y();
  }
  return sum;
}

void check_loops(const Mesh& mesh) {
  const Border_loops loops = border_loops(mesh);
  Sides sides;
  double sum = 0, wanted = 0;
  for (const auto* some : {&loops.outer, &loops.islands}) {
    CHECK(std::is_sorted(some->begin(), some->end()));
    for (const Border_loop& loop : *some) {
      REQUIRE(loop.size() >= 3);
      CHECK(std::set<Vertex_index>(loop.begin(), loop.end()).size() == loop.size()); // simple
      CHECK(*std::min_element(loop.begin(), loop.end()) == loop.front());
      for (std::size_t i = 0; i < loop.size(); ++i)
        sides.insert({std::size_t(loop[i]), std::size_t(loop[(i + 1) % loop.size()])});
      const double of_loop = area(mesh, loop);
      CHECK((some == &loops.outer ? of_loop > 0 : of_loop < 0));
      sum += of_loop;
    }
  }
  CHECK(sides == border_sides(mesh));
  CHECK(loops.outer.size() == number_of_components(mesh));
  for (const auto& t : mesh.triangles) wanted += area(mesh, {t[0], t[1], t[2]});
  CHECK(sum == Approx(wanted));
}

void check_numbers_of_loops(const Mesh& mesh, std::size_t outer, std::size_t islands) {
  check_loops(mesh);
  CHECK(border_loops(mesh).outer.size() == outer);
  CHECK(border_loops(mesh).islands.size() == islands);
}

// --- files ---

std::vector<Mesh> meshes() {
  Mesh renumbered = mesh_with_regions();
  CGAL::renumber_by_place(renumbered);
  std::vector<Mesh> result{Mesh(), one_triangle(), mesh_with_regions(), renumbered};
  result.push_back(grid_without(4, {{1, 1}, {2, 2}, {0, 3}}));
  for (unsigned seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    result.push_back(grid_mesh(6, seed, [&](std::size_t, std::size_t, int) { return random() % 3 > 0; }));
  }
  Mesh points;
  points.points = {Point(0, 0), Point(1, 0)};
  result.push_back(points);
  return result;
}

std::size_t material(const Mesh& mesh, std::size_t t) {
  if (mesh.region_of_triangle.empty()) return 1;
  const int last = *std::max_element(mesh.region_of_triangle.begin(), mesh.region_of_triangle.end());
  const int r = mesh.region_of_triangle[t];
  return std::size_t(r < 0 ? last + 2 : r + 1);
}

/// The node strings of a .2dm file; checks all else.
std::vector<std::vector<std::size_t>> checked_node_strings(const Mesh& mesh, const std::string& text) {
  std::istringstream lines(text);
  std::string line, card;
  std::size_t triangles = 0, points = 0;
  std::vector<std::vector<std::size_t>> strings;
  bool is_open = false;
  REQUIRE((std::getline(lines, line) && line == "MESH2D"));
  REQUIRE((std::getline(lines, line) && line == "NUM_MATERIALS_PER_ELEM 1"));
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    words >> card;
    std::size_t number;
    if (card == "E3T") {
      std::size_t a, b, c, region;
      REQUIRE((words >> number >> a >> b >> c >> region && number == triangles + 1));
      const auto& t = mesh.triangles.at(triangles);
      CHECK((a == std::size_t(t[0]) + 1 && b == std::size_t(t[1]) + 1 && c == std::size_t(t[2]) + 1));
      CHECK(region == material(mesh, triangles++));
    } else if (card == "ND") {
      std::string x, y, z;
      REQUIRE((words >> number >> x >> y >> z && number == points + 1 && z == "0"));
      CHECK(Point(std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr)) ==
            mesh.points.at(points++));
    } else {
      REQUIRE(card == "NS");
      if (!is_open) strings.emplace_back();
      is_open = true;
      std::size_t on_line = 0;
      for (long long node; words >> node; ++on_line) {
        REQUIRE(is_open);
        strings.back().push_back(std::size_t(std::abs(node)) - 1);
        is_open = node > 0;
      }
      CHECK((on_line >= 1 && on_line <= 10));
    }
    CHECK(words.eof());
  }
  CHECK_FALSE(is_open);
  CHECK((triangles == mesh.triangles.size() && points == mesh.points.size()));
  return strings;
}

struct Land_boundary {
  int type;
  std::vector<std::size_t> nodes; // as vertices of the mesh
};

/// The boundaries of a .gr3 or .14 file; checks all else.
std::vector<Land_boundary> checked_boundaries(const Mesh& mesh, const std::string& text) {
  std::set<std::size_t> used;
  for (const auto& t : mesh.triangles)
    for (const Vertex_index v : t) used.insert(std::size_t(v));
  const std::vector<std::size_t> vertex(used.begin(), used.end());
  std::istringstream in(text);
  std::string line;
  const auto next = [&] {
    REQUIRE(std::getline(in, line));
    return std::istringstream(line);
  };
  CHECK(next().str().size() <= 24);
  std::size_t triangles, nodes, number, corners;
  next() >> triangles >> nodes;
  REQUIRE((triangles == mesh.triangles.size() && nodes == vertex.size()));
  for (std::size_t i = 0; i < nodes; ++i) {
    std::string x, y, depth;
    next() >> number >> x >> y >> depth;
    CHECK((number == i + 1 && depth == "0"));
    CHECK(Point(std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr)) == mesh.points[vertex[i]]);
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    std::array<std::size_t, 3> at;
    next() >> number >> corners >> at[0] >> at[1] >> at[2];
    CHECK((number == t + 1 && corners == 3));
    for (std::size_t k = 0; k < 3; ++k) CHECK(vertex.at(at[k] - 1) == std::size_t(mesh.triangles[t][k]));
  }
  std::size_t open, open_nodes, land, land_nodes, found_nodes = 0;
  next() >> open, next() >> open_nodes, next() >> land, next() >> land_nodes;
  CHECK((open == 0 && open_nodes == 0));
  std::vector<Land_boundary> boundaries(land);
  for (Land_boundary& b : boundaries) {
    std::size_t n;
    next() >> n >> b.type;
    for (std::size_t i = 0; i < n; ++i, b.nodes.push_back(vertex.at(number - 1))) next() >> number;
    found_nodes += n;
  }
  CHECK(found_nodes == land_nodes);
  CHECK_FALSE(std::getline(in, line));
  CHECK(std::is_sorted(boundaries.begin(), boundaries.end(),
                       [](const Land_boundary& a, const Land_boundary& b) { return a.type < b.type; }));
  return boundaries;
}

std::vector<std::size_t> closed(const Border_loop& loop) {
  std::vector<std::size_t> nodes(loop.begin(), loop.end());
  nodes.push_back(nodes.front());
  return nodes;
}

template <class Write>
std::string text_by(const Write& write) {
  std::ostringstream out;
  write(out);
  return out.str();
}

} // namespace

TEST_CASE("each border side is in one simple loop with the domain on its left", "[border_loops]") {
  check_numbers_of_loops(Mesh(), 0, 0);
  check_numbers_of_loops(one_triangle(), 1, 0);
  check_numbers_of_loops(grid_without(1, {}), 1, 0);
  check_numbers_of_loops(mesh_with_regions(), 2, 1);
  // two holes apart, touching in a vertex, and side by side
  check_numbers_of_loops(grid_without(5, {{1, 1}, {3, 3}}), 1, 2);
  check_numbers_of_loops(grid_without(5, {{1, 1}, {2, 2}}), 1, 2);
  check_numbers_of_loops(grid_without(5, {{1, 1}, {2, 1}}), 1, 1);
  // four holes around a square that touches the rest in vertices only
  check_numbers_of_loops(grid_without(5, {{2, 1}, {1, 2}, {3, 2}, {2, 3}}), 2, 1);
  // squares that touch in a vertex
  check_numbers_of_loops(grid_without(2, {{0, 1}, {1, 0}}), 2, 0);
  // a hole that touches the outer border in a vertex: a notch at the corner of which it is
  check_numbers_of_loops(grid_without(4, {{0, 1}, {1, 2}}), 1, 1);
  // a diagonal of holes from border to border, which parts the domain
  check_numbers_of_loops(grid_without(4, {{0, 0}, {1, 1}, {2, 2}, {3, 3}}), 2, 0);
  // a hole with an island in it, which has a hole
  check_numbers_of_loops(grid_mesh(7, 2,
                                   [](std::size_t x, std::size_t y, int) {
                                     const auto ring = std::min({x, y, 6 - x, 6 - y});
                                     return ring % 2 == 0;
                                   }),
                         2, 2);
}

TEST_CASE("borders of any sets of triangles are simple loops", "[border_loops]") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto kept = 1 + random() % 9;
    check_loops(grid_mesh(1 + random() % 8, seed,
                          [&](std::size_t, std::size_t, int) { return random() % 10 < kept; }));
  }
}

TEST_CASE(".2dm files have all vertices, triangles with materials, and borders as node strings",
          "[SMS_2DM]") {
  for (const Mesh& mesh : meshes()) {
    const auto strings =
        checked_node_strings(mesh, text_by([&](std::ostream& out) { IO::write_SMS_2DM(out, mesh); }));
    std::vector<std::vector<std::size_t>> wanted;
    const Border_loops loops = border_loops(mesh);
    for (const auto* some : {&loops.outer, &loops.islands})
      for (const Border_loop& loop : *some) wanted.push_back(closed(loop));
    CHECK(strings == wanted);
  }
}

TEST_CASE(".14 files have land boundaries closed by their first nodes", "[ADCIRC]") {
  for (const Mesh& mesh : meshes()) {
    const auto boundaries =
        checked_boundaries(mesh, text_by([&](std::ostream& out) { IO::write_ADCIRC(out, mesh); }));
    const Border_loops loops = border_loops(mesh);
    REQUIRE(boundaries.size() == loops.outer.size() + loops.islands.size());
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
      const bool is_island = i >= loops.outer.size();
      CHECK(boundaries[i].type == int(is_island));
      CHECK(boundaries[i].nodes ==
            closed(is_island ? loops.islands[i - loops.outer.size()] : loops.outer[i]));
    }
  }
}

TEST_CASE(".gr3 files have two linked land boundaries for an outer border, and open rings for islands",
          "[ADCIRC]") {
  for (const Mesh& mesh : meshes()) {
    const auto boundaries =
        checked_boundaries(mesh, text_by([&](std::ostream& out) { IO::write_GR3(out, mesh); }));
    const Border_loops loops = border_loops(mesh);
    REQUIRE(boundaries.size() == 2 * loops.outer.size() + loops.islands.size());
    for (std::size_t i = 0; i < loops.outer.size(); ++i) {
      const Land_boundary &a = boundaries[2 * i], &b = boundaries[2 * i + 1];
      CHECK((a.type == 0 && b.type == 0));
      REQUIRE((a.nodes.size() >= 2 && b.nodes.size() >= 2));
      CHECK(a.nodes.back() == b.nodes.front());
      std::vector<std::size_t> both = a.nodes;
      both.insert(both.end(), b.nodes.begin() + 1, b.nodes.end());
      CHECK(both == closed(loops.outer[i]));
    }
    for (std::size_t i = 0; i < loops.islands.size(); ++i) {
      const Land_boundary& island = boundaries[2 * loops.outer.size() + i];
      CHECK(island.type == 1);
      CHECK(island.nodes == std::vector<std::size_t>(loops.islands[i].begin(), loops.islands[i].end()));
    }
  }
}

TEST_CASE("files of flow models are written under their names, or errors name them", "[SMS_2DM][ADCIRC]") {
  const Scratch_folder folder;
  const Mesh mesh = mesh_with_regions();
  const auto check = [&](const char* name, auto write) {
    CAPTURE(name);
    write(folder.file(name));
    CHECK(content(folder.file(name)) == text_by(write));
    try {
      write(folder.file("missing/") + name);
      FAIL("no exception");
    } catch (const std::runtime_error& error) {
      CHECK(std::string(error.what()).find(name) != std::string::npos);
    }
  };
  check("a.2dm", [&](auto&& out) { IO::write_SMS_2DM(out, mesh); });
  check("a.14", [&](auto&& out) { IO::write_ADCIRC(out, mesh); });
  check("a.gr3", [&](auto&& out) { IO::write_GR3(out, mesh); });
}

} // namespace test_flow_model_files
