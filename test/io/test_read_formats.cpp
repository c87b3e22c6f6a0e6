// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "mesh_from_cdt.h"
#include "random_numbers.h"
#include "scratch_folder.h"

#include <CGAL/IO/read_GeoJSON.h>
#include <CGAL/IO/read_WKT.h>
#include <CGAL/IO/read_XY.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace test_read_formats {

using namespace test_meshes;
namespace IO = CGAL::IO;

namespace {

std::string data_file(const std::string& name) { return QUADTREE_MESH_TEST_DATA_DIR "/" + name; }

Pslg geojson(const std::string& text, const std::string& property = "") {
  std::istringstream in(text);
  Pslg pslg;
  IO::read_GeoJSON(in, pslg, property);
  return pslg;
}
Pslg wkt(const std::string& text) {
  std::istringstream in(text);
  Pslg pslg;
  IO::read_WKT(in, pslg);
  return pslg;
}

template <class Function>
std::string error_of(Function f) {
  try {
    f();
  } catch (const CGAL::Pslg_error_2& e) {
    return e.what();
  }
  return "";
}

/// The area of the domain by Triangle's rule.
double area(const Pslg& pslg) {
  double sum = 0;
  const Mesh mesh = mesh_of(pslg);
  for (const auto& t : mesh.triangles)
    sum += CGAL::to_double(CGAL::area(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])));
  return sum;
}

bool is_same(const Pslg& a, const Pslg& b) {
  return a.vertices == b.vertices && a.segments == b.segments && a.holes == b.holes;
}

using Ring = std::vector<std::array<double, 2>>;

/// Whether a place is behind an odd number of the polygon's rings.
bool is_inside(const std::vector<Ring>& polygon, double x, double y) {
  bool result = false;
  for (const Ring& ring : polygon)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if ((p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])) result = !result;
    }
  return result;
}

std::string text_of(const std::vector<std::vector<Ring>>& polygons) {
  std::ostringstream out;
  out.precision(17);
  for (const auto& polygon : polygons) {
    out << "POLYGON(";
    for (std::size_t r = 0; r < polygon.size(); ++r) {
      out << (r == 0 ? "(" : ", (");
      for (const auto& p : polygon[r]) out << p[0] << ' ' << p[1] << ", ";
      out << polygon[r][0][0] << ' ' << polygon[r][0][1] << ')';
    }
    out << ")\n";
  }
  return out.str();
}

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// That the hole points of a graph tell the domain that the polygons cover, on the squares of a grid.
void check_cover(const std::vector<std::vector<Ring>>& polygons, int n) {
  const Pslg pslg = wkt(text_of(polygons));
  const Cdt cdt = triangulate(pslg);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = i + 0.5 + 1e-3, y = j + 0.5 + 1e-4;
      const bool is_covered = std::any_of(polygons.begin(), polygons.end(),
                                          [&](const auto& polygon) { return is_inside(polygon, x, y); });
      CAPTURE(x, y, text_of(polygons));
      const auto face = cdt.locate(Point(x, y));
      CHECK((face != nullptr && !cdt.is_infinite(face) && face->is_in_domain()) == is_covered);
    }
}

} // namespace

TEST_CASE("polygons of GeoJSON and WKT become the graph that they cover", "[GeoJSON][WKT]") {
  Pslg from_json, from_wkt;
  IO::read_GeoJSON(data_file("island.geojson"), from_json);
  IO::read_WKT(data_file("island.wkt"), from_wkt);
  CHECK(is_same(from_json, from_wkt));
  CHECK(from_json.vertices.size() == 12 + 8 + 3 + 2 + 3 + 2); // the neighbor shares two, the enclave all
  CHECK(from_json.segments.size() == 12 + 8 + 3 + 3 + 2);
  CHECK(from_json.holes.size() == 2); // lake and pond, not the enclave
  CHECK(area(from_json) == Approx(96 - 30 + 4 - 1 + 0.5 + 24));
  CHECK(from_json.regions.empty());
}

TEST_CASE("a property of GeoJSON features becomes the attribute of regions", "[GeoJSON]") {
  Pslg pslg;
  IO::read_GeoJSON(data_file("island.geojson"), pslg, "depth");
  std::vector<double> attributes;
  for (const auto& r : pslg.regions) attributes.push_back(r.attribute);
  std::sort(attributes.begin(), attributes.end());
  CHECK(attributes == std::vector<double>{-1, 2.5, 4, 4});
  CHECK(error_of([&] { IO::read_GeoJSON(data_file("island.geojson"), pslg, "height"); }).find("height") !=
        std::string::npos);
  CHECK(pslg.regions.size() == 4); // as it was
}

TEST_CASE("where polygons overlap the first one counts", "[GeoJSON]") {
  const std::string feature = R"({"type": "Feature", "properties": {"z": %}, "geometry":
    {"type": "Polygon", "coordinates": [[[%, 0], [4, 0], [4, 3], [%, 3], [%, 0]]]}})";
  const auto fill = [&](int z, int x) {
    std::string text = feature;
    text.replace(text.find('%'), 1, std::to_string(z));
    for (int i = 0; i < 3; ++i) text.replace(text.find('%'), 1, std::to_string(x));
    return text;
  };
  const Pslg pslg =
      geojson(R"({"type": "FeatureCollection", "features": [)" + fill(7, 2) + ", " + fill(9, 0) + "]}", "z");
  REQUIRE(pslg.regions.size() == 2);
  for (const auto& r : pslg.regions) CHECK(r.attribute == (r.point.x() < 2 ? 9 : 7));
  CHECK(pslg.holes.empty());
}

TEST_CASE("nested, touching and overlapping polygons cover what they should", "[WKT]") {
  // Islands in lakes on islands, seven deep, as one polygon each and as one multipolygon's rings.
  std::vector<std::vector<Ring>> nested;
  for (int i = 0; i < 4; ++i)
    nested.push_back(
        {box(2 * i, 2 * i, 16 - 2 * i, 16 - 2 * i), box(2 * i + 1, 2 * i + 1, 15 - 2 * i, 15 - 2 * i)});
  check_cover(nested, 16);
  check_cover({{box(0, 0, 8, 8), box(0, 2, 3, 5)}}, 8);                    // a hole on the border
  check_cover({{box(0, 0, 8, 8), {{0, 4}, {3, 2}, {3, 6}}}}, 8);           // a hole that touches it
  check_cover({{box(0, 0, 8, 8), box(1, 1, 4, 4), box(4, 4, 7, 7)}}, 8);   // holes that touch
  check_cover({{box(0, 0, 8, 8), box(1, 1, 5, 4), box(5, 2, 7, 6)}}, 8);   // holes that share a piece
  check_cover({{box(0, 0, 8, 8), box(2, 2, 6, 6)}, {box(2, 2, 6, 6)}}, 8); // a filled hole
  check_cover({{box(0, 0, 8, 8), box(2, 2, 6, 6)}, {box(2, 2, 4, 6)}}, 8); // one half filled
  check_cover({{box(0, 0, 5, 5)}, {box(3, 3, 8, 8)}}, 8);                  // crossing borders
  check_cover({{box(0, 0, 8, 2)}, {box(0, 6, 8, 8)}, {box(0, 0, 2, 8)}, {box(6, 0, 8, 8)}}, 8); // round a gap
  check_cover({{box(0, 0, 8, 8)}, {box(0, 0, 8, 8)}}, 8); // the same twice
  check_cover({{{{0, 0}, {8, 8}, {8, 0}, {0, 8}}}}, 8);   // a ring that crosses itself
}

TEST_CASE("random boxes cover what they should", "[WKT]") {
  Random_numbers random(5);
  const auto number = [&](int n) { return static_cast<int>(random() * n); };
  for (int round = 0; round < 40; ++round) {
    std::vector<std::vector<Ring>> polygons;
    for (int p = 0; p < 1 + round % 5; ++p) {
      std::vector<Ring> rings;
      for (int r = 0; r < 1 + number(4); ++r) {
        const int x = number(9), y = number(9);
        rings.push_back(box(x, y, x + 1 + number(3), y + 1 + number(3)));
      }
      polygons.push_back(rings);
    }
    check_cover(polygons, 12);
  }
}

TEST_CASE("lines alone enclose the domain, and points are vertices", "[GeoJSON][WKT]") {
  const Pslg pslg = wkt("LINESTRING(0 0, 4 0, 4 0, 4 4)\nLINESTRING(4 4, 0 4, 0 0); POINT(1 1) POINT(1 1)\n"
                        "multilinestring((0 0, -0.0 4), (1 2, 2 2))");
  CHECK(pslg.vertices.size() == 7);
  CHECK(pslg.segments.size() == 5);
  CHECK(pslg.holes.empty());
  CHECK(area(pslg) == 16);
  CHECK(geojson(R"({"type": "Point", "coordinates": [1e-300, 2]})").vertices.front() == Point(1e-300, 2));
  CHECK(geojson(R"({"type": "FeatureCollection", "features": []})").vertices.empty());
  CHECK(wkt("").vertices.empty());
  CHECK(wkt("POLYGON EMPTY\nMULTIPOLYGON EMPTY\nGEOMETRYCOLLECTION EMPTY\n").vertices.empty());
}

TEST_CASE("coordinates of GeoJSON, WKT and XY are the nearest doubles", "[GeoJSON][WKT][XY]") {
  const Scratch_folder folder;
  Random_numbers random(3);
  std::ostringstream json, text, xy;
  json.precision(17), text.precision(17), xy.precision(17);
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) {
    const double scale = std::pow(10., std::floor(600 * random()) - 300);
    points.emplace_back((random() - 0.5) * scale, i == 0   ? 5e-324
                                                  : i == 1 ? 1.7976931348623157e308
                                                           : random());
    const double x = points.back().x(), y = points.back().y();
    json << (i == 0 ? "[" : ", [") << x << ", " << y << ']';
    text << (i == 0 ? "" : ", ") << x << ' ' << y;
    xy << x << (i % 3 == 0 ? "," : i % 3 == 1 ? " ; " : "\t") << y << '\n';
  }
  CHECK(geojson(R"({"type": "MultiPoint", "coordinates": [)" + json.str() + "]}").vertices == points);
  CHECK(wkt("MULTIPOINT(" + text.str() + ")").vertices == points);
  std::vector<Point> read;
  IO::read_XY(folder.write("points.xy", xy.str()), read);
  CHECK(read == points);
}

TEST_CASE("huge and tiny polygons have their holes", "[WKT]") {
  for (const double scale : {1e-310, 1e-200, 1., 1e150, 1e307}) {
    CAPTURE(scale);
    std::vector<Ring> polygon{box(0, 0, 8, 8), box(1, 1, 3, 3)};
    for (Ring& ring : polygon)
      for (auto& p : ring) p[0] *= scale, p[1] *= scale;
    const Pslg pslg = wkt(text_of({polygon}));
    REQUIRE(pslg.holes.size() == 1);
    CHECK(pslg.holes[0].x() > scale);
    CHECK(pslg.holes[0].x() < 3 * scale);
    CHECK(pslg.holes[0].y() > scale);
    CHECK(pslg.holes[0].y() < 3 * scale);
  }
}

TEST_CASE("borders may cross where no double is near", "[WKT]") {
  const Pslg pslg = wkt(
      "POLYGON((-1.7e308 -1.7e308, 1.7e308 1.7e308, 1e308 1.7e308))\n"
      "POLYGON((-1.7e308 1.7e308, 1.7e308 -1.7e308, 1.7e308 -1e308))\nPOLYGON((8 2, 11 2, 1e308 5, 8 5))");
  CHECK(pslg.vertices.size() == 10);
  CHECK(pslg.segments.size() == 10);
}

TEST_CASE("broken GeoJSON and WKT are refused with the place", "[GeoJSON][WKT]") {
  const auto ring = [](const std::string& places) {
    return R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry":
      {"type": "Polygon", "coordinates": [[)" +
           places + "]]}}]}";
  };
  struct Case {
    std::string text, culprit;
  };
  for (const Case& c : std::vector<Case>{
           {"", "input:1: column 1: syntax error"},
           {"{\"type\": \"Point\",\n \"coordinates\": [1, 2}", "input:2: column "},
           {"[1, 2]", "object"},
           {R"({"type": "Circle", "coordinates": []})", "Circle"},
           {R"({"type": "Point", "coordinates": [NaN, 0]})", "input:1: column "},
           {R"({"type": "Point", "coordinates": [1e999, 0]})", "input:1: number overflow parsing '1e999'"},
           {R"({"type": "Point", "coordinates": ["1", 0]})", "two to four numbers"},
           {R"({"type": "Point"})", "coordinates"},
           {R"({"type": "LineString", "coordinates": [[1, 1], [1, 1]]})", "two different"},
           {R"({"type": "LineString", "coordinates": [[1, 1], [1]]})", "place 1"},
           {R"({"type": "Feature", "properties": {}})", "geometry"},
           {R"({"type": "FeatureCollection", "features": [{"type": "Point", "coordinates": [1, 2]}]})",
            "feature 0"},
           {ring("[0, 0], [1, 0], [1, 1]"), "feature 0, ring 0 is not closed"},
           {ring("[0, 0], [1, 0], [0, 0]"), "ring 0"},
           {ring("[0, 0], [1, 0], [1, 0], [0, 0]"), "three different"},
           {ring("[0, 0], [1, 0], [1, 1], 7"), "place 3"}}) {
    CAPTURE(c.text);
    CHECK(error_of([&] { geojson(c.text); }).find(c.culprit) != std::string::npos);
  }
  for (const Case& c :
       std::vector<Case>{{"POLYGON((0 0, 1 0, 1 1)", "1: the file ends where ',' or ')' is expected"},
                         {"\nPOINT(1 nan)", "2: "},
                         {"POINT(1)\n", "1: "},
                         {"POINT(1 2 x)\n", "1: "},
                         {"POINT(1 1)\nCIRCLE(1 1)", "2: 'CIRCLE'"},
                         {"POINT(1 1)\n)", "2: "},
                         {"POINT\n", "1: "},
                         {"POINT  \n", "1: "},
                         {"POLYGON((0 0, 1 0, 0 0))", "1: the outer ring"},
                         {"GEOMETRYCOLLECTION(POINT(1 1), POINT(x 1))", "1: "},
                         {"1 2\n3 4\n", "1: "},
                         {"POINT(1e999 2)", "1: "}}) {
    CAPTURE(c.text);
    CHECK(error_of([&] { wkt(c.text); }).find("input:" + c.culprit) != std::string::npos);
  }
  const Scratch_folder folder;
  Pslg pslg;
  pslg.add_vertex(Point(1, 2));
  const std::string garbage = folder.write("garbage.gz", "\x1f\x8b garbage");
  CHECK(error_of([&] { IO::read_GeoJSON(garbage, pslg); }).find("gzip") != std::string::npos);
  CHECK(error_of([&] { IO::read_WKT(garbage, pslg); }).find("gzip") != std::string::npos);
  CHECK(error_of([&] { IO::read_WKT(folder.file("none"), pslg); }).find("none") != std::string::npos);
  CHECK(pslg.vertices.size() == 1);
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "GEOMETRYCOLLECTION(";
  CHECK(error_of([&] { wkt(deep + std::string(100000, ')')); }).find("deep") != std::string::npos);
}

TEST_CASE("heights and measures of WKT are not kept, and make no vertices", "[WKT]") {
  Pslg flat;
  IO::read_WKT(data_file("untagged_z.wkt"), flat);
  CHECK(flat.vertices ==
        std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {20, -20}, {40, -20}, {40, 20}, {20, 20}});
  CHECK(flat.segments.size() == 8);
  const std::vector<Point> expected{{1, 2}, {3, 4}};
  for (const char* const text :
       {"MULTIPOINT((1 2), (3 4))", "MULTIPOINT(1 2, 3 4)", "multipoint(1 2, (3\n4), EMPTY)",
        "MULTIPOINT(1 2 9, 3 4 8)", "MULTIPOINT Z (1 2 9, 3 4 8)", "MULTIPOINTZ(1 2 9,3 4 8)",
        "MultiPoint m(1 2 9, 3 4 8)", "MULTIPOINTZM((1 2 9 7), (3 4 8 7))",
        "MULTIPOINT zm (1 2 9 7, 3 4 8 7)", "SRID=4326;MULTIPOINT(1 2, 3 4)",
        "srid=4326; POINT(1 2)\nSRID=4326;\nPOINT(3 4)", "POINT(1 2) # 5 6\nPOINT(3 4) # 7 8",
        "POINT(+1 2.)POINT(3 4e0)", "GEOMETRYCOLLECTION Z (POINT Z (1 2 9), POLYGON EMPTY, POINT(3 4))",
        "\xef\xbb\xbfPOINT(1 2);POINT(3 4)", "POINT(1 2)\rPOINT(3 4)\r",
        "POINT\r\n(1\f2)\r\n;\v\tPOINT(3 4)"}) {
    CAPTURE(text);
    CHECK(wkt(text).vertices == expected);
  }
  const Pslg with_empty =
      wkt("MULTIPOLYGON(((0 0, 4 0, 4 4)), EMPTY, (EMPTY))\nMULTILINESTRING(EMPTY, (7 7, 8 8))");
  CHECK(with_empty.vertices.size() == 5);
  CHECK(with_empty.segments.size() == 4);
}

TEST_CASE("what WKT does not allow is refused with its line", "[WKT]") {
  struct Case {
    std::string text, culprit;
  };
  for (const Case& c : std::vector<Case>{
           {"LINESTRING(0 0, 1 0\n2 2, 3 3)", "2: place 1 has 4 numbers where others of the geometry have 2"},
           {"LINESTRING(0 0 1 1, 2 2 3 3)", "1: place 0 has four numbers and the geometry no tag ZM"},
           {"LINESTRING(0 0 1 1 2 2)", "1: place 0 has more numbers than x, y, z and m; is a comma missing?"},
           {"LINESTRING(0 0 1,\n1 1)", "2: place 1 has 2 numbers where others of the geometry have 3"},
           {"POINT Z (1 2)", "1: place 0 has 2 numbers where the tag Z asks for 3"},
           {"POINTZM(1 2 3)", "1: place 0 has 3 numbers where the tag ZM asks for 4"},
           {"POINT M (1 2 3 4)", "1: place 0 has 4 numbers"},
           {"POINT ZZ (1 2 3)", "1: '(' or EMPTY is expected before 'ZZ'"},
           {"POINT(1,5 2,5)", "1: y of place 0 is expected before ','"},
           {"POINT(0x10 2)", "1: x of place 0: '0x10' is not a number"},
           {"POINT(1\n1e999)", "2: y of place 0: '1e999' is too large"},
           {"POINT(inf 1)", "1: x of place 0: 'inf' is not finite"},
           {"POINT(1 2 NaN)", "1: a further number of place 0: 'NaN' is not finite"},
           {"POINT(1 2) text", "1: 'text' is no type"},
           {"POINT(1 2)\n, POINT(3 4)", "2: a type of geometry is expected before ','"},
           {"POINT(1 2, 3 4)", "1: a point has one place only"},
           {"POINT(1 2]", "1: y of place 0: '2]' is not a number"},
           {"POLYGON(0 0, 1 0, 1 1)", "1: '(' or EMPTY is expected before '0'"},
           {"POLYGON((0 0, 1 0, 1 1),)", "1: '(' or EMPTY is expected before ')'"},
           {"POLYGON((0 0, 1 0, 1 1)\n(0 0, 1 0, 1 1))", "2: ',' or ')' is expected before '('"},
           {"POLYGON(EMPTY, (0 0, 1 0, 1 1))", "1: a hole is in a polygon without an outer ring"},
           {"SRID=;POINT(1 2)", "1: a number is expected in 'SRID='"},
           {"SRID=1 POINT(1 2)", "1: ';' is expected before 'POINT'"},
           {"SRID=1;POINT(1 2)\nSRID=2;POINT(1 2)", "2: 'SRID=2' is another reference system"},
           {std::string("POINT(1 2)\n\0", 12), "2: '\\x00' is no type"},
           {std::string(1000, 'x') + "(1 2)", "1: '" + std::string(40, 'x') + "...' is no type"}}) {
    CAPTURE(c.text);
    CHECK(error_of([&] { wkt(c.text); }).find("input:" + c.culprit) == 0);
  }
}

TEST_CASE("errors of GeoJSON tell the line", "[GeoJSON]") {
  struct Case {
    std::string text, culprit;
  };
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  for (const Case& c : std::vector<Case>{
           {"", "1: "},
           {"{\"type\": \"Circle\"}", "1: the geometry: the type 'Circle' is unknown"},
           {"{\"type\": \"LineString\",\n\"coordinates\": [[1, 2],\n[3,\n\"4\"]]}",
            "3: the geometry, place 1"},
           {"{\"type\": \"LineString\",\n\"coordinates\": [[1, 2],\n[3, 1e999]]}", "3: "},
           {"{\"type\": \"Point\",\n\"coordinates\": [1, 2, 3, 4, 5]}",
            "2: the geometry: two to four numbers"},
           {"{\"type\": \"Point\",\n\"coordinates\": [1, 2, \"x\"]}", "2: the geometry: two to four numbers"},
           {"{\"type\": \"Point\", \"more\": " + deep + ",\n\"coordinates\": [1]}",
            "2: the geometry: two to four"},
           {"{\"type\": \"Point\",\n\"coordinates\": [1, 2]}\n7", "3: "},
           {"{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [9, 0], [9, 9], [0, 0]],\n[[1, 1], [2, 2], "
            "[1, 1], [1, 1]]]}",
            "2: the geometry, ring 1 has not three"},
           {"{\"type\": \"Point\",\n\"coordinates\": [1, 2],\n\"coordinates\": [3, 4]}",
            "3: the key 'coordinates' appears twice in one object"},
           {"{\"type\": \"Feature\", \"geometry\": {\"type\": \"Point\", \"coordinates\": [1, 2]},\n"
            "\"properties\": {\"a\": {\"a\": 1,\n\"b\": 2},\n\"b\": 3, \"a\": 4}}",
            "4: the key 'a' appears twice in one object"}}) {
    CAPTURE(c.text);
    CHECK(error_of([&] { geojson(c.text); }).find("input:" + c.culprit) == 0);
  }
  CHECK(geojson("\xef\xbb\xbf{\"type\": \"Point\", \"coordinates\": [1, 2, 3, 4]}").vertices.size() == 1);
}

TEST_CASE("points from text of many kinds", "[XY]") {
  const Scratch_folder folder;
  const auto read = [&](const std::string& text) {
    std::vector<Point> points;
    IO::read_XY(folder.write("points", text), points);
    return points;
  };
  const std::vector<Point> expected{Point(0, 0), Point(1.5, -0.2), Point(0.25, 3)};
  std::vector<Point> stations;
  IO::read_XY(data_file("stations.csv"), stations);
  CHECK(stations == expected);
  CHECK(read("0 0\n1.5 -.2\n\n.25 +3") == expected);
  CHECK(read("# x y\n0,0\r\n1.5, -0.2\r\n0.25 ,3,4,five\r\n") == expected);
  CHECK(read("lon,lat\n0,0\n1.5,-0.2\n0.25,3\n") == expected);
  CHECK(read("name,y,x\nA,0,0\nB,-0.2,1.5\n,3,0.25\n") == expected);
  CHECK(read("x y size\n0\t0 7\n1.5 -0.2 7 # not this\n0.25 3 7\n") == expected);
  CHECK(read("\xef\xbb\xbfx,y\n0,0\n1.5,-0.2\n0.25,3") == expected);
  CHECK(read("0 0\r1.5 -0.2\r0.25 3\r") == expected);
  CHECK(read("\"name, of it\",y,x\n\"A, b # 7\",0,0\nB,-0.2,1.5\n\"\",3,0.25 # \"\n") == expected);
  CHECK(read("").empty());
  CHECK(read("x,y\n").empty());
  for (const auto& [text, culprit] :
       std::vector<std::pair<std::string, std::string>>{{"1 2\n3\n", "2: "},
                                                        {"nan nan\n", "not finite"},
                                                        {"1,inf\n", "y"},
                                                        {"1,,2\n", "y"},
                                                        {"1,5;2,5\n", "'1,5' is not a number"},
                                                        {"x,y\nu,v\n", "2: x"},
                                                        {"x,y,x\n1,2,3\n", "1: two columns are called x"},
                                                        {"1 2\r1 x\r", "2: y: 'x'"},
                                                        {"\xff\xfe"
                                                         "1 2",
                                                         "1: is text in UTF-16"},
                                                        {"1 1e999\n", "too large"}}) {
    CAPTURE(text);
    CHECK(error_of([&, &t = text] { read(t); }).find(culprit) != std::string::npos);
  }

  std::vector<double> sizes;
  IO::read_XY(folder.write("sizes", "x,y,size\n1,2,0.5\n3,4,1\n"), stations, sizes);
  CHECK(stations == std::vector<Point>{Point(1, 2), Point(3, 4)});
  CHECK(sizes == std::vector<double>{0.5, 1});
  CHECK(error_of([&] {
          IO::read_XY(folder.write("sizes", "1 2 3\n1 2 0\n"), stations, sizes);
        }).find("2: ") != std::string::npos);
  CHECK(sizes.size() == 2);
}

} // namespace test_read_formats
