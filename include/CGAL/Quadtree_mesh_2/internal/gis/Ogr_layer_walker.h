// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GIS_OGR_LAYER_WALKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GIS_OGR_LAYER_WALKER_H

#include <CGAL/Feature_properties_2.h>
#include <CGAL/Quadtree_mesh_2/internal/gis/Gdal_dataset.h>
#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Feature_numbers.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Simple_features.h>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Adds the geometries of one layer to the features.
class Ogr_layer_walker {
public:
  /// \param layer its name; empty: the only one with geometries
  /// \throws Pslg_error_2 if there is none, or there are several
  Ogr_layer_walker(const Gdal_dataset& dataset, const std::string& layer,
                   const Feature_properties_2& properties, Simple_features& features)
      : dataset_(dataset), attributes_(properties.region, Feature_numbers::Kind::ANY),
        markers_(properties.marker, Feature_numbers::Kind::MARKER), features_(features) {
    layer_ = find_layer(layer);
    name_ = "layer " + in_quotes(OGR_L_GetName(layer_));
  }

  void walk() {
    const int attribute = field_of(attributes_), marker = field_of(markers_);
    OGR_L_ResetReading(layer_);
    CPLErrorReset();
    while (const Feature feature{OGR_L_GetNextFeature(layer_)}) {
      const std::string where = name_ + ", feature " + std::to_string(OGR_F_GetFID(feature.get()));
      features_.set_attribute(number_of(feature.get(), attribute, attributes_, where));
      features_.set_marker(static_cast<int>(number_of(feature.get(), marker, markers_, where).value_or(0)));
      if (const OGRGeometryH geometry = OGR_F_GetGeometryRef(feature.get())) add_geometry(geometry, where);
    }
    dataset_.check();
    for (const Feature_numbers* const numbers : {&attributes_, &markers_})
      if (!numbers->is_content())
        dataset_.fail(name_ + ": no feature has a value of the property " + in_quotes(numbers->property()));
  }

  /// Names of attributes and markers, once they are known.
  const std::vector<std::string>& region_names() const { return attributes_.names(); }
  const std::vector<std::string>& marker_names() const { return markers_.names(); }

  bool is_in_plane() const {
    const OGRSpatialReferenceH system = OGR_L_GetSpatialRef(layer_);
    return system != nullptr && (OSRIsProjected(system) || OSRIsLocal(system));
  }
  /// Whether the layer has longitudes and latitudes. Some old systems count in grads.
  bool is_in_degrees() const {
    const OGRSpatialReferenceH system = OGR_L_GetSpatialRef(layer_);
    constexpr double degree = 0.017453292519943295;
    return system != nullptr && OSRIsGeographic(system) &&
           std::abs(OSRGetAngularUnits(system, nullptr) - degree) < 1e-9;
  }

private:
  struct Destroyer {
    void operator()(OGRFeatureH feature) const { OGR_F_Destroy(feature); }
  };
  struct Geometry_destroyer {
    void operator()(OGRGeometryH geometry) const { OGR_G_DestroyGeometry(geometry); }
  };
  using Feature = std::unique_ptr<std::remove_pointer_t<OGRFeatureH>, Destroyer>;
  using Geometry = std::unique_ptr<std::remove_pointer_t<OGRGeometryH>, Geometry_destroyer>;

  OGRLayerH find_layer(const std::string& wanted) const {
    std::string all;
    OGRLayerH found = nullptr;
    int n = 0;
    for (int i = 0; i < GDALDatasetGetLayerCount(dataset_.handle()); ++i) {
      const OGRLayerH layer = GDALDatasetGetLayer(dataset_.handle(), i);
      if (layer == nullptr) dataset_.check();
      if (layer == nullptr || OGR_L_GetGeomType(layer) == wkbNone) continue; // a table
      const std::string name = OGR_L_GetName(layer);
      if (name == wanted) return layer;
      all += (all.empty() ? "" : ", ") + in_quotes(name);
      found = layer, ++n;
    }
    if (n == 0) dataset_.fail("there is no layer with geometries");
    if (!wanted.empty()) dataset_.fail("there is no layer " + in_quotes(wanted) + ", only " + all);
    if (n > 1) dataset_.fail("there are several layers, of which one has to be chosen: " + all);
    return found;
  }

  /// The index of a property among the fields; -1 if none is wanted.
  int field_of(const Feature_numbers& numbers) const {
    if (!numbers.is_wanted()) return -1;
    const OGRFeatureDefnH definition = OGR_L_GetLayerDefn(layer_);
    const int field = OGR_FD_GetFieldIndex(definition, numbers.property().c_str());
    if (field >= 0) return field;
    std::string all;
    for (int i = 0; i < OGR_FD_GetFieldCount(definition); ++i)
      all += (i == 0 ? ", only " : ", ") + in_quotes(OGR_Fld_GetNameRef(OGR_FD_GetFieldDefn(definition, i)));
    dataset_.fail(name_ + ": features have no property " + in_quotes(numbers.property()) + all);
  }

  std::optional<double> number_of(OGRFeatureH feature, int field, Feature_numbers& numbers,
                                  const std::string& where) const {
    if (field < 0 || !OGR_F_IsFieldSetAndNotNull(feature, field)) return std::nullopt;
    const OGRFieldType type = OGR_Fld_GetType(OGR_F_GetFieldDefnRef(feature, field));
    try {
      if (type == OFTInteger || type == OFTInteger64 || type == OFTReal)
        return numbers.of_number(OGR_F_GetFieldAsDouble(feature, field));
      return numbers.of_name(in_utf_8(OGR_F_GetFieldAsString(feature, field)));
    } catch (const std::invalid_argument& error) {
      dataset_.fail(where + ": " + error.what());
    }
  }
  /// Drivers promise it; files may break the promise.
  static std::string in_utf_8(const char* text) {
    if (CPLIsUTF8(text, -1)) return text;
    char* const ascii = CPLForceToASCII(text, -1, '?');
    std::string result = ascii;
    CPLFree(ascii);
    return result;
  }

  void add_geometry(OGRGeometryH geometry, const std::string& where) {
    if (OGR_G_IsEmpty(geometry)) return;
    if (OGR_G_HasCurveGeometry(geometry, FALSE)) {
      constexpr double default_step = 0; // 4 degrees
      const Geometry linear(OGR_G_GetLinearGeometry(geometry, default_step, nullptr));
      if (!linear) dataset_.fail(where + ": its curves cannot be read");
      return add_geometry(linear.get(), where);
    }
    switch (OGR_GT_Flatten(OGR_G_GetGeometryType(geometry))) {
    case wkbPoint:
      return features_.add_point(places(geometry, where).front());
    case wkbLineString:
      return features_.add_line(places(geometry, where), [&] { return dataset_.name_of(where); });
    case wkbPolygon:
    case wkbTriangle:
      return add_polygon(geometry, where);
    case wkbMultiPoint:
      return add_parts(geometry, where + ", point ");
    case wkbMultiLineString:
      return add_parts(geometry, where + ", line ");
    case wkbMultiPolygon:
    case wkbPolyhedralSurface:
    case wkbTIN:
      return add_parts(geometry, where + ", polygon ");
    case wkbGeometryCollection:
      return add_parts(geometry, where + ", geometry ");
    default:
      dataset_.fail(where + ": is a " + in_quotes(OGR_G_GetGeometryName(geometry)) +
                    ", which is neither a point nor a line nor a polygon");
    }
  }

  void add_parts(OGRGeometryH geometry, const std::string& name) {
    for (int i = 0; i < OGR_G_GetGeometryCount(geometry); ++i)
      add_geometry(OGR_G_GetGeometryRef(geometry, i), name + std::to_string(i));
  }

  void add_polygon(OGRGeometryH polygon, const std::string& where) {
    features_.begin_polygon();
    for (int i = 0; i < OGR_G_GetGeometryCount(polygon); ++i) {
      const std::string ring = where + ", ring " + std::to_string(i);
      const Simple_features::Line line = places(OGR_G_GetGeometryRef(polygon, i), ring);
      if (!line.empty()) features_.add_ring(line, [&] { return dataset_.name_of(ring); });
    }
  }

  /// Without heights and measures.
  Simple_features::Line places(OGRGeometryH geometry, const std::string& where) const {
    const int n = OGR_G_GetPointCount(geometry);
    Simple_features::Line line(static_cast<std::size_t>(n));
    if (n == 0) return line;
    constexpr int stride = sizeof(Simple_features::Place);
    OGR_G_GetPoints(geometry, &line.front()[0], stride, &line.front()[1], stride, nullptr, 0);
    for (std::size_t i = 0; i < line.size(); ++i)
      if (!std::isfinite(line[i][0]) || !std::isfinite(line[i][1]))
        dataset_.fail(where + ": place " + std::to_string(i) + " is not finite");
    return line;
  }

  const Gdal_dataset& dataset_;
  Feature_numbers attributes_, markers_;
  Simple_features& features_;
  OGRLayerH layer_ = nullptr;
  std::string name_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GIS_OGR_LAYER_WALKER_H
