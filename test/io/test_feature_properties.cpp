// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Properties of features: attributes of regions and markers of segments, from numbers and from names.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <CGAL/IO/MSH.h>
#include <CGAL/IO/read_GeoJSON.h>
#include <CGAL/repair_pslg_2.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_feature_properties {

using namespace program_test;
using namespace test_meshes;

namespace {

using Places = std::array<double, 4>; ///< of the ends, the lower one first

/// Two squares side by side, a line across both and one without properties.
std::string features(const std::string& west, const std::string& east, const std::string& line) {
  const auto feature = [](const std::string& kind, const std::string& geometry) {
    return R"({"type": "Feature", "properties": {)" + (kind.empty() ? kind : "\"kind\": " + kind) +
           "}, \"geometry\": " + geometry + "}";
  };
  return "{\"type\": \"FeatureCollection\", \"features\": [\n" +
         feature(west, R"({"type": "Polygon", "coordinates": [[[0,0],[2,0],[2,2],[0,2],[0,0]]]})") + ",\n" +
         feature(east, R"({"type": "Polygon", "coordinates": [[[2,0],[4,0],[4,2],[2,2],[2,0]]]})") + ",\n" +
         feature(line, R"({"type": "LineString", "coordinates": [[1,1],[2,2],[2,0]]})") + ",\n" +
         feature("", R"({"type": "LineString", "coordinates": [[3,1],[4,2]]})") + "]}";
}

Pslg read(const std::string& text, const CGAL::Feature_properties_2& properties) {
  std::istringstream in(text);
  Pslg pslg;
  CGAL::IO::read_GeoJSON(in, pslg, properties, "test");
  return pslg;
}

std::map<Places, int> markers(const Pslg& pslg) {
  std::map<Places, int> result;
  REQUIRE(pslg.segment_markers.size() == pslg.segments.size());
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    Point a = pslg.point(pslg.segments[s][0]), b = pslg.point(pslg.segments[s][1]);
    if (b < a) std::swap(a, b);
    result[{a.x(), a.y(), b.x(), b.y()}] = pslg.segment_markers[s];
  }
  return result;
}

std::string error_of(const std::string& text, const CGAL::Feature_properties_2& properties) {
  Pslg pslg;
  pslg.vertices.push_back(Point(7, 7));
  std::istringstream in(text);
  try {
    CGAL::IO::read_GeoJSON(in, pslg, properties, "test");
  } catch (const CGAL::Pslg_error_2& error) {
    CHECK(pslg.vertices.size() == 1);
    CHECK(pslg.marker_names.empty());
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a property of features becomes the marker of their segments", "[GeoJSON]") {
  const Pslg pslg = read(features("3", "-7", "5"), {"", "kind"});
  const std::map<Places, int> expected{
      {{0, 0, 2, 0}, 3},  {{0, 0, 0, 2}, 3},  {{0, 2, 2, 2}, 3},  {{2, 0, 2, 2}, 3}, // the first of three
      {{2, 0, 4, 0}, -7}, {{4, 0, 4, 2}, -7}, {{2, 2, 4, 2}, -7}, {{1, 1, 2, 2}, 5}, {{3, 1, 4, 2}, 0}};
  CHECK(markers(pslg) == expected);
  CHECK(pslg.marker_names.empty());
  CHECK(pslg.regions.empty());
  // Without a marker in the west, the neighbor's counts on the border of both.
  for (const char* const none : {"", "null", "0"})
    CHECK(markers(read(features(none, "-7", "5"), {"", "kind"})).at({2, 0, 2, 2}) == -7);
  CHECK(read(features("3", "-7", "5"), {}).segment_markers.empty());
}

TEST_CASE("names of features are numbered as they come", "[GeoJSON]") {
  const Pslg pslg = read(features("\"wall\"", "\"inlet \\u00e9\"", "\"wall\""), {"kind", "kind"});
  CHECK(pslg.marker_names == std::vector<std::string>{"wall", "inlet \xc3\xa9"});
  CHECK(pslg.region_names == pslg.marker_names);
  CHECK(markers(pslg).at({1, 1, 2, 2}) == 1);
  CHECK(markers(pslg).at({4, 0, 4, 2}) == 2);
  REQUIRE(pslg.regions.size() == 2);
  for (const auto& region : pslg.regions) CHECK(region.attribute == (region.point.x() < 2 ? 1 : 2));

  const Pslg repaired =
      CGAL::repair_pslg_2(pslg, CGAL::Pslg_repair_options_2().crossings(CGAL::Pslg_crossing_rule_2::SPLIT));
  CHECK(repaired.marker_names == pslg.marker_names);
  CHECK(repaired.region_names == pslg.region_names);
}

TEST_CASE("values that are no markers or no attributes are refused with their place", "[GeoJSON]") {
  const auto error = [](const char* west, const char* east) {
    const std::string by_marker = error_of(features(west, east, ""), {"", "kind"});
    CHECK(contains(by_marker, "test:3: feature 1: the property 'kind' "));
    return by_marker;
  };
  CHECK(contains(error("1", "2.5"), "no whole number"));
  CHECK(contains(error("1", "3e9"), "no whole number"));
  CHECK(contains(error("1", "true"), "neither a number nor a name"));
  CHECK(contains(error("1", "[2]"), "neither a number nor a name"));
  CHECK(contains(error("1", "\"wall\""), "is a name, and was a number before"));
  CHECK(contains(error("\"wall\"", "1"), "is a number, and was a name before"));
  CHECK(contains(error_of(features("1", "\"x\"", ""), "kind"), "is a name, and was a number before"));
  CHECK(contains(error_of(features("1", "2", ""), {"", "sort"}), "no feature has a property 'sort'"));
  CHECK(error_of(features("1.5", "2.5", ""), "kind").empty());
}

TEST_CASE("files of Gmsh have the names of features", "[GeoJSON][MSH]") {
  const Pslg pslg = read(features("\"wall\"", "\"in \\\"let\\\"\"", "\"wall\""), {"kind", "kind"});
  auto mesh = mesh_of(pslg);
  REQUIRE(mesh.constrained_edges.size() > 2);
  for (std::size_t e = 0; e < mesh.constrained_edges.size(); ++e)
    mesh.constrained_edges[e].marker = static_cast<int>(e % 3);
  mesh.region_of_triangle.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.region_of_triangle[t] = static_cast<int>(t % 2);
  std::ostringstream out;
  CGAL::IO::write_MSH(out, mesh, pslg);
  for (const char* const line : {"1 1 \"wall\"\n", "1 2 \"in _let_\"\n", "\"marker 0\"\n",
                                 "\"region 0, wall\"\n", "\"region 1, in _let_\"\n"})
    CHECK(contains(out.str(), line));
}

#ifdef QUADTREE_MESH_PROGRAM
TEST_CASE("the program marks segments by a property", "[program][GeoJSON]") {
  const Scratch_folder folder;
  folder.write("plan.geojson", features("\"wall\"", "\"inlet\"", "\"wall\""));
  const Run r =
      run(folder.file("plan.geojson") + " --project none --marker-property kind --region-property kind -o " +
          folder.file("m.msh") + " --report " + folder.file("r.json"));
  CAPTURE(r.out, r.err);
  CHECK(r.status == 0);
  CHECK(contains(r.out, "markers: 1 wall, 2 inlet\n"));
  CHECK(contains(content(folder.file("m.msh")), "1 2 \"inlet\"\n"));
  const auto json = nlohmann::json::parse(content(folder.file("r.json")));
  CHECK(json.at("marker_names") == nlohmann::json({{"wall", 1}, {"inlet", 2}}));
  CHECK(json.at("region_names") == json.at("marker_names"));
  CHECK(run(test_data("island.wkt") + " --marker-property kind").status == 2);
}
#endif

} // namespace test_feature_properties
