// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_GEOJSON_H
#define CGAL_IO_READ_GEOJSON_H

#include <CGAL/Feature_properties_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Json_lines.h>
#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>
#include <CGAL/Quadtree_mesh_2/internal/io/read_whole_file.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Feature_numbers.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Simple_features.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Reads GeoJSON (RFC 7946) by nlohmann-json. Programs that include this header need that library.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Adds the geometries of a GeoJSON object to the features.
class Geojson_walker {
public:
  using Json = nlohmann::json;

  /// \param root the object parsed from `text`
  Geojson_walker(const Json& root, const std::string& text, const std::string& file_name,
                 const Feature_properties_2& properties, Simple_features& features)
      : root_(root), text_(text), file_name_(file_name),
        attributes_(properties.region, Feature_numbers::Kind::ANY),
        markers_(properties.marker, Feature_numbers::Kind::MARKER), features_(features) {}

  void walk() {
    const std::string type = type_of(root_, "");
    if (type == "FeatureCollection") {
      const Json& list = array_in(root_, "features", "the collection");
      for (std::size_t i = 0; i < list.size(); ++i) add_feature(list[i], "feature " + std::to_string(i));
    } else if (type == "Feature") {
      add_feature(root_, "the feature");
    } else {
      add_geometry(root_, "the geometry", 0);
    }
    for (const Feature_numbers* const numbers : {&attributes_, &markers_})
      if (!numbers->is_content()) fail(root_, "no feature has a property " + in_quotes(numbers->property()));
  }

  /// Names of attributes and markers, once they are known.
  const std::vector<std::string>& region_names() const { return attributes_.names(); }
  const std::vector<std::string>& marker_names() const { return markers_.names(); }

private:
  static constexpr int max_depth_ = 100; // of collections in collections

  [[noreturn]] void fail(const Json& culprit, const std::string& what) const {
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, line_of(culprit) + what);
  }
  /// The line of a value, for the beginning of messages.
  std::string line_of(const Json& value) const {
    return file_name_ + ':' + std::to_string(line_in_json(text_, path_to(root_, value))) + ": ";
  }

  std::string type_of(const Json& json, const std::string& where) const {
    const std::string prefix = where.empty() ? where : where + ": ";
    if (!json.is_object()) fail(json, prefix + "an object is expected");
    const auto type = json.find("type");
    if (type == json.end() || !type->is_string()) fail(json, prefix + "there is no \"type\"");
    return type->get<std::string>();
  }

  const Json& array_in(const Json& json, const char* key, const std::string& where) const {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array()) fail(json, where + ": there is no array \"" + key + '"');
    return *found;
  }

  void add_feature(const Json& feature, const std::string& where) {
    const std::string type = type_of(feature, where);
    if (type != "Feature") fail(feature, where + ": is a " + in_quotes(type) + " instead of a Feature");
    features_.set_attribute(number_of(feature, where, attributes_));
    features_.set_marker(static_cast<int>(number_of(feature, where, markers_).value_or(0)));
    const auto geometry = feature.find("geometry");
    if (geometry == feature.end()) fail(feature, where + ": there is no \"geometry\"");
    if (!geometry->is_null()) add_geometry(*geometry, where, 0); // null is a feature without a place
  }

  /// The number of the feature's property; nothing if it has none.
  std::optional<double> number_of(const Json& feature, const std::string& where,
                                  Feature_numbers& numbers) const {
    if (!numbers.is_wanted()) return std::nullopt;
    const auto properties = feature.find("properties");
    if (properties == feature.end() || !properties->is_object()) return std::nullopt;
    const auto property = properties->find(numbers.property());
    if (property == properties->end() || property->is_null()) return std::nullopt;
    try {
      if (property->is_number()) return numbers.of_number(property->get<double>());
      if (property->is_string()) return numbers.of_name(property->get<std::string>());
      numbers.fail("is neither a number nor a name");
    } catch (const std::invalid_argument& error) {
      fail(*property, where + ": " + error.what());
    }
  }

  void add_geometry(const Json& geometry, const std::string& where, int depth) {
    const std::string type = type_of(geometry, where);
    if (type == "GeometryCollection") {
      if (depth == max_depth_) fail(geometry, where + ": collections are nested too deep");
      const Json& parts = array_in(geometry, "geometries", where);
      for (std::size_t i = 0; i < parts.size(); ++i)
        add_geometry(parts[i], where + ", geometry " + std::to_string(i), depth + 1);
      return;
    }
    constexpr const char* types[] = {"Point",           "MultiPoint", "LineString",
                                     "MultiLineString", "Polygon",    "MultiPolygon"};
    if (std::find(std::begin(types), std::end(types), type) == std::end(types))
      fail(geometry, where + ": the type " + in_quotes(type) + " is unknown");
    const Json& coordinates = array_in(geometry, "coordinates", where);
    if (type == "Point")
      add_point(coordinates, where);
    else if (type == "MultiPoint")
      for_each_part(coordinates, where, "point", [this](auto&... part) { add_point(part...); });
    else if (type == "LineString")
      add_line(coordinates, where);
    else if (type == "MultiLineString")
      for_each_part(coordinates, where, "line", [this](auto&... part) { add_line(part...); });
    else if (type == "Polygon")
      add_polygon(coordinates, where);
    else
      for_each_part(coordinates, where, "polygon", [this](auto&... part) { add_polygon(part...); });
  }

  /// \tparam Add called with the part and with words for its place
  template <class Add>
  void for_each_part(const Json& parts, const std::string& where, const char* name, const Add& add) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string part = where + ", " + name + ' ' + std::to_string(i);
      if (!parts[i].is_array()) fail(parts[i], part + ": an array is expected");
      add(parts[i], part);
    }
  }

  void add_point(const Json& position, const std::string& where) {
    if (!position.empty()) features_.add_point(place(position, where)); // an empty geometry is allowed
  }

  void add_line(const Json& positions, const std::string& where) {
    if (positions.empty()) return;
    features_.add_line(line(positions, where), [&] { return line_of(positions) + where; });
  }

  void add_polygon(const Json& rings, const std::string& where) {
    features_.begin_polygon();
    for_each_part(rings, where, "ring", [this](const Json& positions, const std::string& name) {
      Simple_features::Line ring = line(positions, name);
      if (ring.size() < 4 || ring.front() != ring.back())
        fail(positions, name + " is not closed: its first place and its last have to be the same, with three "
                               "or more in all");
      features_.add_ring(ring, [&] { return line_of(positions) + name; });
    });
  }

  Simple_features::Line line(const Json& positions, const std::string& where) const {
    Simple_features::Line result;
    result.reserve(positions.size());
    for (const Json& position : positions) {
      if (is_place(position))
        result.push_back({position[0].get<double>(), position[1].get<double>()});
      else
        place(position, where + ", place " + std::to_string(result.size()));
    }
    return result;
  }

  /// Drops further numbers, usually a height and a measure.
  static bool is_place(const Json& position) {
    constexpr std::size_t most = 4;
    return position.is_array() && position.size() >= 2 && position.size() <= most &&
           std::all_of(position.begin(), position.end(),
                       [](const Json& number) { return number.is_number(); });
  }
  Simple_features::Place place(const Json& position, const std::string& where) const {
    if (!is_place(position)) fail(position, where + ": two to four numbers are expected");
    return {position[0].get<double>(), position[1].get<double>()};
  }

  const Json& root_;
  const std::string& text_;
  const std::string& file_name_;
  Feature_numbers attributes_, markers_;
  Simple_features& features_;
};

/// \throws Pslg_error_2
template <class Point>
Pslg_2<Point> parse_geojson(const std::string& text, const std::string& name,
                            const Feature_properties_2& properties) {
  Simple_features features;
  std::vector<std::string> region_names, marker_names;
  std::size_t line = 1;
  const auto fail = [&](const std::string& what) {
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, name + ':' + std::to_string(line) + ": " + what);
  };
  try {
    const nlohmann::json root = parse_json(text, line);
    Geojson_walker walker(root, text, name, properties, features);
    walker.walk();
    region_names = walker.region_names(), marker_names = walker.marker_names();
  } catch (const Repeated_json_key& error) {
    fail(error.what());
  } catch (const nlohmann::json::exception& error) {
    fail(printable(json_error_text(error), 200));
  }
  Pslg_2<Point> pslg = features.to_pslg<Point>();
  pslg.region_names = std::move(region_names), pslg.marker_names = std::move(marker_names);
  return pslg;
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Reads a graph from a GeoJSON file, also from one compressed by gzip: polygons, lines and points, alone, in
/// collections or in features.
///
/// Borders of polygons and lines become segments, and points become vertices. Vertices at one place become
/// one, and so do segments with the same ends: neighbors share their border. If there are polygons, the
/// domain is what they cover. Each bounded component of the plane that no polygon covers gets a point in
/// `Pslg_2::holes`. A place is in a polygon if it is behind an odd number of its rings. So islands in lakes,
/// and enclaves, are covered by their own polygons. Without polygons the domain is what lines enclose. All
/// this is for the rule `Quality_mesh_options_2::Domain::ENCLOSED`, the default.
///
/// Coordinates are taken as coordinates of a plane. Heights are dropped. Segments may cross, as in the file;
/// see `repair_pslg_2()`. Takes linear time, except for the triangulation that finds the components.
/// \param properties those of features that become attributes of regions and markers of segments; a text stands for
/// that of regions. Each component that polygons of features with that property cover gets a region with its number;
/// where several features cover it, the first counts. Features without the property get no region. Segments of
/// features without the other one get the marker 0; of features that share a segment the first with a marker other
/// than 0 counts.
/// \throws Pslg_error_2 with the file, the line and the feature if the file is missing or malformed, a key
/// appears twice in an object, a ring is not closed, no feature has the property, or it is a number here and a name
/// there; `pslg` is then unchanged.
/// \tparam Point can be made from two doubles.
template <class Point>
void read_GeoJSON(const std::string& file_name, Pslg_2<Point>& pslg,
                  const Feature_properties_2& properties = Feature_properties_2()) {
  namespace internal = Quadtree_mesh_2::internal;
  pslg = internal::parse_geojson<Point>(internal::read_whole_file(file_name), file_name, properties);
}

/// The same from a stream.
/// \throws Pslg_error_2 as above, with `name` for the name of the file.
template <class Point>
void read_GeoJSON(std::istream& in, Pslg_2<Point>& pslg,
                  const Feature_properties_2& properties = Feature_properties_2(),
                  const std::string& name = "input") {
  namespace internal = Quadtree_mesh_2::internal;
  pslg = internal::parse_geojson<Point>(internal::read_whole_stream(in, name), name, properties);
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_GEOJSON_H
