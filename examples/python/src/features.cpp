// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "arrays.h"
#include "definitions.h"

#include <CGAL/Feature_properties_2.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/read_WKT.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Simple_features.h>

#if __has_include(<nlohmann/json.hpp>) // an optional library
#include <CGAL/IO/read_GeoJSON.h>
#define QUADTREE_MESH_PYTHON_READS_GEOJSON
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Graphs of points, lines and polygons, which quadtree_mesh.geometry takes from shapely, and of files.

namespace quadtree_mesh_python {

namespace {

using CGAL::Quadtree_mesh_2::internal::Simple_features;

/// What a row of the array of parts has.
enum class Part_kind : std::int64_t { POINT, LINE, OUTER_RING, INNER_RING };

std::string name_of(Part_kind kind) {
  return kind == Part_kind::POINT ? "point" : kind == Part_kind::LINE ? "line" : "ring";
}

void add_part(Simple_features& features, Part_kind kind, std::int64_t row, const double* xy, std::size_t n) {
  const auto name = [&] { return "geometry " + std::to_string(row) + ": a " + name_of(kind); };
  for (std::size_t i = 0; i < 2 * n; ++i)
    if (!std::isfinite(xy[i]))
      throw CGAL::Pslg_error_2(CGAL::Pslg_error_2::Kind::NOT_FINITE,
                               name() + " has a coordinate that is not a finite number");
  Simple_features::Line places(n);
  for (std::size_t i = 0; i < n; ++i) places[i] = {xy[2 * i], xy[2 * i + 1]};
  if (kind == Part_kind::POINT)
    for (const auto& place : places) features.add_point(place);
  if (kind == Part_kind::LINE) features.add_line(places, name);
  if (kind == Part_kind::OUTER_RING) {
    features.set_attribute(static_cast<double>(row));
    features.begin_polygon();
  }
  if (kind == Part_kind::OUTER_RING || kind == Part_kind::INNER_RING) features.add_ring(places, name);
}

py::dict arrays_of(const CGAL::Pslg_2<Point>& graph) {
  using Row = std::array<double, 4>;
  py::dict result;
  result["vertices"] = array_of_rows<double>(graph.vertices);
  result["segments"] = array_of_rows<std::int32_t>(graph.segments);
  result["holes"] = array_of_rows<double>(graph.holes);
  std::vector<Row> regions;
  for (const auto& r : graph.regions) regions.push_back({r.point.x(), r.point.y(), r.attribute, r.max_area});
  result["regions"] = array_of_rows<double>(std::move(regions));
  if (!graph.vertex_markers.empty()) result["vertex_markers"] = array_of(graph.vertex_markers);
  if (!graph.segment_markers.empty()) result["segment_markers"] = array_of(graph.segment_markers);
  return result;
}

/// \param parts rows of three: the kind, the number of the geometry, the end of the part's coordinates
py::dict graph_of_features(const Input_array<double>& coordinates, const Input_array<std::int64_t>& parts) {
  const std::size_t n = rows_of(coordinates, 2, "coordinates"), m = rows_of(parts, 3, "parts");
  const double* xy = coordinates.data();
  const std::int64_t* part = parts.data();
  CGAL::Pslg_2<Point> graph;
  {
    const py::gil_scoped_release release;
    Simple_features features;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < m; ++i, part += 3) {
      const auto end = static_cast<std::size_t>(part[2]);
      if (end < begin || end > n) throw std::invalid_argument("parts must end in order");
      add_part(features, static_cast<Part_kind>(part[0]), part[1], xy + 2 * begin, end - begin);
      begin = end;
    }
    graph = features.to_pslg<Point>();
  }
  return arrays_of(graph);
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && std::equal(end.rbegin(), end.rend(), text.rbegin());
}

/// Arrays of numbers have no place for names.
void refuse_names(const std::string& file, const std::string& property,
                  const std::vector<std::string>& names) {
  if (!names.empty())
    throw std::invalid_argument("'" + file + "': the property '" + property +
                                "' has names, not numbers; geopandas.read_file() reads these");
}

/// The format is that of the name's ending.
py::dict read_graph(const std::string& file, const CGAL::Feature_properties_2& properties) {
  CGAL::Pslg_2<Point> graph;
  if (ends_with(file, ".poly") || ends_with(file, ".poly.gz")) CGAL::IO::read_triangle_poly(file, graph);
#ifdef QUADTREE_MESH_PYTHON_READS_GEOJSON
  else if (ends_with(file, ".geojson") || ends_with(file, ".json"))
    CGAL::IO::read_GeoJSON(file, graph, properties);
#endif
  else if (ends_with(file, ".wkt"))
    CGAL::IO::read_WKT(file, graph);
  else
    throw std::invalid_argument("'" + file +
                                "': the formats known here are .poly, .poly.gz, .wkt and, where "
                                "nlohmann-json was found, .geojson and .json");
  refuse_names(file, properties.region, graph.region_names);
  refuse_names(file, properties.marker, graph.marker_names);
  return arrays_of(graph);
}

} // namespace

void define_features(py::module_& module) {
  const auto read = [](const std::string& file, const std::string& region, const std::string& marker) {
    return read_graph(file, {region, marker});
  };
  module.def("read_graph", read, py::arg("file"), py::arg("region_property"), py::arg("marker_property"));
  module.def("graph_of_features", &graph_of_features, py::arg("coordinates"), py::arg("parts"));
}

} // namespace quadtree_mesh_python
