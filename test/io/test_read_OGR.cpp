// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Files that GDAL itself has written are read as the graphs that our own readers make of the same geometries.

#ifdef CGAL_LINKED_WITH_GDAL

#include "catch.h"
#include "gdal_files.h"
#include "mesh_from_cdt.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <CGAL/IO/read_GeoJSON.h>
#include <CGAL/IO/read_OGR.h>
#include <CGAL/IO/read_WKT.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace test_read_OGR {

using namespace program_test;
using namespace test_meshes;
using gdal_files::Feature;
using gdal_files::write_layers;
namespace IO = CGAL::IO;
namespace fs = std::filesystem;

namespace {

std::string error_of(const std::string& file, const CGAL::Feature_properties_2& properties = {},
                     const std::string& layer = "") {
  Pslg pslg;
  pslg.vertices.push_back(Point(7, 7));
  try {
    IO::read_OGR(file, pslg, properties, layer);
  } catch (const CGAL::Pslg_error_2& error) {
    CHECK(error.kind() == CGAL::Pslg_error_2::Kind::UNREADABLE_FILE);
    CHECK(pslg.vertices.size() == 1);
    return error.what();
  }
  return "";
}

bool is_same(const Pslg& a, const Pslg& b) {
  const auto has_same_regions = [&] {
    return std::equal(
        a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(),
        [](const auto& r, const auto& s) { return r.point == s.point && r.attribute == s.attribute; });
  };
  return a.vertices == b.vertices && a.segments == b.segments && a.holes == b.holes &&
         a.segment_markers == b.segment_markers && has_same_regions();
}

/// Polygons with a hole, an island in it and a neighbor; with heights if asked for.
std::vector<Feature> lakes(const std::string& z = "") {
  const auto place = [&](const char* xy) { return xy + z; };
  const auto box = [&](const char* a, const char* b, const char* c, const char* d) {
    return "(" + place(a) + "," + place(b) + "," + place(c) + "," + place(d) + "," + place(a) + ")";
  };
  const std::string polygon = z.empty() ? "POLYGON(" : "POLYGON Z(";
  return {{polygon + box("0 0", "0 8", "12 8", "12 0") + "," + box("1 1", "6 1", "6 7", "1 7") + ")", "sand",
           3, 2.5},
          {polygon + box("2 2", "2 4", "4 4", "4 2") + ")", "clay", 4, 4},
          {polygon + box("12 0", "12 8", "15.1 8", "15.1 0") + ")", "sand", -5, -1e-3}};
}

Pslg graph_of(const std::vector<Feature>& features, const CGAL::Feature_properties_2& properties) {
  nlohmann::json root{{"type", "FeatureCollection"}, {"features", nlohmann::json::array()}};
  for (const Feature& f : features) root["features"].push_back(gdal_files::json_of(f));
  std::istringstream in(root.dump());
  Pslg pslg;
  IO::read_GeoJSON(in, pslg, properties);
  return pslg;
}

constexpr std::array<const char*, 2> formats[] = {
    {"ESRI Shapefile", "a.shp"}, {"GPKG", "a.gpkg"}, {"FlatGeobuf", "a.fgb"}, {"GML", "a.gml"}};

} // namespace

TEST_CASE("files of GDAL become the same graphs as GeoJSON", "[OGR]") {
  const Scratch_folder folder;
  std::vector<std::array<const char*, 2>> all(std::begin(formats), std::end(formats));
  all.push_back({"LIBKML", "a.kml"});
  for (const auto& [driver, name] : all)
    for (const char* const z : {"", " 17.5"}) {
      const std::string file = folder.file(z[0] == '\0' ? name : std::string("z_") + name);
      CAPTURE(file);
      write_layers(driver, file, {{"lakes", lakes(z)}});
      const CGAL::Feature_properties_2 by_name{"soil", "soil"}, by_number{"depth", "mark"};
      Pslg named, numbered, plain;
      IO::read_OGR(file, named, by_name);
      IO::read_OGR(file, numbered, by_number);
      IO::read_OGR(file, plain);
      CHECK(is_same(named, graph_of(lakes(), by_name)));
      CHECK(named.region_names == std::vector<std::string>{"sand", "clay"});
      CHECK(named.marker_names == named.region_names);
      CHECK(is_same(numbered, graph_of(lakes(), by_number)));
      CHECK(numbered.marker_names.empty());
      CHECK(numbered.regions.size() == 3);
      CHECK(plain.regions.empty());
      CHECK(plain.holes.size() == 1);
    }
}

TEST_CASE("all kinds of geometries are read from a file", "[OGR]") {
  const Scratch_folder folder;
  const std::vector<std::string> geometries{
      "POINT M(1 2 3)",
      "MULTIPOINT((20 20),(21 21))",
      "LINESTRING ZM(10 0 5 1,11 0 5 2,11 1 6 3)",
      "MULTILINESTRING((40 40,41 41),(42 40,43 41,43 42))",
      "MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0)),((6 0,9 0,6 3,6 0)))",
      "GEOMETRYCOLLECTION(POINT(30 30),POLYGON((50 50,52 50,50 52,50 50)))",
      "POLYGON EMPTY"};
  std::vector<Feature> features;
  std::string all;
  for (const std::string& geometry : geometries)
    features.push_back({geometry, "x", 1, 1}), all += geometry + '\n';
  write_layers("GPKG", folder.file("a.gpkg"), {{"all", features}});
  Pslg pslg, wanted;
  IO::read_OGR(folder.file("a.gpkg"), pslg);
  std::istringstream in(all);
  IO::read_WKT(in, wanted);
  CHECK(is_same(pslg, wanted));

  // A circle of radius 5 around (5, 0): its chords have no vertex off it.
  write_layers("GPKG", folder.file("b.gpkg"),
               {{"round", {{"CURVEPOLYGON(CIRCULARSTRING(0 0,5 5,10 0,5 -5,0 0))", "x", 1, 1}}}});
  IO::read_OGR(folder.file("b.gpkg"), pslg);
  CHECK(pslg.vertices.size() > 60);
  CHECK(pslg.segments.size() == pslg.vertices.size());
  for (const Point& p : pslg.vertices) CHECK(std::abs(std::hypot(p.x() - 5, p.y()) - 5) < 1e-12);
}

TEST_CASE("a layer is chosen by its name", "[OGR]") {
  const Scratch_folder folder;
  const std::string file = folder.file("a.gpkg");
  write_layers("GPKG", file, {{"coast", lakes()}, {"wells", {{"POINT(1 2)", "x", 1, 1}}}});
  Pslg coast, wells;
  IO::read_OGR(file, coast, {}, "coast");
  IO::read_OGR(file, wells, {}, "wells");
  CHECK(coast.vertices.size() == 14);
  CHECK(wells.vertices.size() == 1);
  CHECK(contains(error_of(file), "several layers, of which one has to be chosen: 'coast', 'wells'"));
  CHECK(contains(error_of(file, {}, "roads"), "no layer 'roads', only 'coast', 'wells'"));
}

TEST_CASE("files say what their coordinates are", "[OGR]") {
  const Scratch_folder folder;
  using System = CGAL::Coordinate_system_2;
  const auto read = [&](const char* epsg, const char* driver, const char* name) {
    Pslg pslg;
    const std::string file = folder.file(std::string(epsg) + name);
    write_layers(driver, file, {{"lakes", lakes()}}, epsg);
    const System system = IO::read_OGR(file, pslg);
    CHECK(pslg.vertices ==
          graph_of(lakes(), {}).vertices); // x is the longitude, whatever the system's axes are
    return system;
  };
  for (const auto& [driver, name] : formats) {
    CAPTURE(driver);
    CHECK(read("EPSG:4326", driver, name) == System::DEGREES);
    CHECK(read("EPSG:32633", driver, name) == System::PLANE);
  }
  CHECK(read("", "ESRI Shapefile", "a.shp") == System::UNKNOWN);
  CHECK(read("EPSG:4807", "GPKG", "a.gpkg") == System::UNKNOWN); // in grads
}

TEST_CASE("errors of files of GDAL", "[OGR]") {
  const Scratch_folder folder;
  CHECK(contains(error_of(folder.file("none.gpkg")), folder.file("none.gpkg") + ": cannot be opened: "));
  CHECK(contains(error_of(folder.write("text.shp", "no shapes")), "text.shp: cannot be opened"));
  const std::string file = folder.file("a.gpkg");
  write_layers("GPKG", file, {{"lakes", lakes()}});
  CHECK(contains(error_of(file, "height"),
                 "layer 'lakes': features have no property 'height', only 'soil', 'mark', 'depth'"));
  CHECK(contains(error_of(file, {"", "depth"}),
                 "layer 'lakes', feature 1: the property 'depth' is no whole number"));
  write_layers("GPKG", folder.file("b.gpkg"), {{"bad", {{"POLYGON((0 0,1 1,0 0,1 1,0 0))", "x", 1, 1}}}});
  CHECK(contains(error_of(folder.file("b.gpkg")),
                 "layer 'bad', feature 1, ring 0 has not three different places"));

  // What is cut off is noticed, wherever it is.
  write_layers("ESRI Shapefile", folder.file("whole.shp"), {{"whole", lakes()}});
  const std::string shapes = content(folder.file("whole.shp"));
  for (const double share : {0.2, 0.5, 0.9}) {
    folder.write("whole.shp", shapes.substr(0, static_cast<std::size_t>(share * double(shapes.size()))));
    CAPTURE(share);
    CHECK(contains(error_of(folder.file("whole.shp")), "whole.shp"));
  }
  const std::string package = content(file);
  folder.write("a.gpkg", package.substr(0, package.size() / 2));
  CHECK(contains(error_of(file), "a.gpkg"));
}

#if defined(QUADTREE_MESH_PROGRAM)
TEST_CASE("the program reads files of GDAL", "[OGR][program]") {
  const Scratch_folder folder;
  const auto report = [&](const std::string& arguments) {
    const Run r = run(arguments + " --quiet --report " + folder.file("r.json"));
    CAPTURE(arguments, r.err);
    CHECK(r.status == 0);
    return nlohmann::json::parse(content(folder.file("r.json")));
  };
  write_layers("GPKG", folder.file("plane.gpkg"), {{"lakes", lakes()}}, "EPSG:32633");
  const auto plane = report(folder.file("plane.gpkg") + " --region-property soil --marker-property mark -o " +
                            folder.file("m.msh"));
  CHECK(plane.at("projection").is_null());
  CHECK(plane.at("may_be_in_degrees") == false);
  CHECK(plane.at("region_names") == nlohmann::json({{"sand", 1}, {"clay", 2}}));
  CHECK(contains(content(folder.file("m.msh")), "region 0, sand"));

  std::vector<Feature> north{{"POLYGON((10 60,11 60,11 60.5,10 60.5,10 60))", "x", 1, 1}};
  write_layers("GPKG", folder.file("north.gpkg"), {{"a", north}, {"b", lakes()}}, "EPSG:4326");
  const auto degrees = report(folder.file("north.gpkg") + " --layer a --max-edge 5000");
  CHECK(degrees.at("projection").at("name") == "lambert");
  CHECK(degrees.at("triangles") > 100); // of 3000 square kilometers
  CHECK(report(folder.file("north.gpkg") + " --layer a --project none").at("projection").is_null());
  write_layers("ESRI Shapefile", folder.file("north.shp"), {{"north", north}});
  CHECK(report(folder.file("north.shp")).at("may_be_in_degrees") == true);
  write_layers("GPKG", folder.file("wells.gpkg"),
               {{"wells", {{"MULTIPOINT((1 2),(3 1),(2 5))", "x", 1, 1}}}});
  CHECK(report(folder.file("wells.gpkg") + " --mode acute").at("input_points") == 3);

  const auto error = [](const std::string& arguments) {
    const Run r = run(arguments);
    CHECK(r.status == 2);
    return r.err;
  };
  CHECK(contains(error(folder.file("north.gpkg")), "one has to be chosen: 'a', 'b'"));
  CHECK(contains(error(test_data("island.wkt") + " --layer a"), "--layer"));
  CHECK(contains(error(folder.file("none.kml")), "none.kml: cannot be opened"));
  CHECK(contains(error(folder.file("none.gpkg.gz")), "unpack it first"));
}
#endif

} // namespace test_read_OGR

#endif // CGAL_LINKED_WITH_GDAL
