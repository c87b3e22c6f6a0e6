// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_GDAL_FILES_H
#define QUADTREE_MESH_2_TEST_GDAL_FILES_H

// Files of geographic data for tests, written by GDAL.

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gdal_files {

/// A geometry in WKT, and its properties: soil, mark and depth.
struct Feature {
  std::string geometry, soil;
  int mark;
  double depth;
};
/// A name, and features.
using Layer = std::pair<std::string, std::vector<Feature>>;

inline void require(bool is_good) {
  if (!is_good) throw std::runtime_error(std::string("GDAL: ") + CPLGetLastErrorMsg());
}

inline OGRGeometryH parse(const std::string& wkt) {
  std::vector<char> text(wkt.begin(), wkt.end());
  text.push_back('\0');
  char* begin = text.data();
  OGRGeometryH geometry = nullptr;
  require(OGR_G_CreateFromWkt(&begin, nullptr, &geometry) == OGRERR_NONE);
  return geometry;
}

inline nlohmann::json json_of(const Feature& feature) {
  const OGRGeometryH geometry = parse(feature.geometry);
  char* const text = OGR_G_ExportToJson(geometry);
  const auto json = nlohmann::json::parse(text);
  CPLFree(text);
  OGR_G_DestroyGeometry(geometry);
  return {{"type", "Feature"},
          {"properties", {{"soil", feature.soil}, {"mark", feature.mark}, {"depth", feature.depth}}},
          {"geometry", json}};
}

inline void add(OGRLayerH layer, const Feature& feature) {
  const OGRFeatureH f = OGR_F_Create(OGR_L_GetLayerDefn(layer));
  OGR_F_SetFieldString(f, OGR_F_GetFieldIndex(f, "soil"), feature.soil.c_str());
  OGR_F_SetFieldInteger(f, OGR_F_GetFieldIndex(f, "mark"), feature.mark);
  OGR_F_SetFieldDouble(f, OGR_F_GetFieldIndex(f, "depth"), feature.depth);
  require(OGR_F_SetGeometryDirectly(f, parse(feature.geometry)) == OGRERR_NONE);
  require(OGR_L_CreateFeature(layer, f) == OGRERR_NONE);
  OGR_F_Destroy(f);
}

/// \param system of reference, such as "EPSG:4326"; empty: none
inline void write_layers(const std::string& driver, const std::string& file, const std::vector<Layer>& layers,
                         const std::string& system = "") {
  GDALAllRegister();
  const GDALDriverH d = GDALGetDriverByName(driver.c_str());
  require(d != nullptr);
  const GDALDatasetH dataset = GDALCreate(d, file.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  require(dataset != nullptr);
  OGRSpatialReferenceH reference = system.empty() ? nullptr : OSRNewSpatialReference(nullptr);
  if (reference != nullptr) {
    require(OSRSetFromUserInput(reference, system.c_str()) == OGRERR_NONE);
    OSRSetAxisMappingStrategy(reference, OAMS_TRADITIONAL_GIS_ORDER);
  }
  for (const auto& [name, features] : layers) {
    const OGRGeometryH first = parse(features.front().geometry);
    // Layers of one type, as shapefiles have them.
    const OGRwkbGeometryType type = features.size() > 3 ? wkbUnknown : OGR_G_GetGeometryType(first);
    OGR_G_DestroyGeometry(first);
    char in_order[] = "SPATIAL_INDEX=NO"; // or FlatGeobuf sorts features
    char* const options[] = {driver == "FlatGeobuf" ? in_order : nullptr, nullptr};
    const OGRLayerH layer = GDALDatasetCreateLayer(dataset, name.c_str(), reference, type, options);
    require(layer != nullptr);
    const std::pair<const char*, OGRFieldType> fields[] = {
        {"soil", OFTString}, {"mark", OFTInteger}, {"depth", OFTReal}};
    for (const auto& [field, field_type] : fields) {
      const OGRFieldDefnH definition = OGR_Fld_Create(field, field_type);
      require(OGR_L_CreateField(layer, definition, TRUE) == OGRERR_NONE);
      OGR_Fld_Destroy(definition);
    }
    for (const Feature& feature : features) add(layer, feature);
  }
  GDALClose(dataset);
  if (reference != nullptr) OSRRelease(reference);
}

} // namespace gdal_files

#endif // QUADTREE_MESH_2_TEST_GDAL_FILES_H
