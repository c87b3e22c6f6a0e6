// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_OGR_H
#define CGAL_IO_READ_OGR_H

/// \file
/// Graphs from shapefiles, GeoPackages and all else that GDAL reads. Programs that include this header link GDAL
/// (`libgdal-dev`).

#include <CGAL/Feature_properties_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/gis/Gdal_dataset.h>
#include <CGAL/Quadtree_mesh_2/internal/gis/Ogr_layer_walker.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Simple_features.h>

#include <ogr_api.h>

#include <string>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Reads a graph from a layer of points, lines and polygons, in any format that GDAL reads: shapefile, GeoPackage,
/// KML, FlatGeobuf, GML, DXF and others.
///
/// Its features become a graph, with holes, as in `read_GeoJSON()`. Heights and measures are dropped. Curves become
/// chains of segments, 4 degrees of a circle each.
/// \param properties those of features that become attributes of regions and markers of segments, as in
///        `read_GeoJSON()`; fields that are neither integers nor reals have names
/// \param layer its name; empty: the only one with geometries
/// \throws Pslg_error_2 with the file, and the layer and the number of the feature, if the file is missing, damaged or
///         of no format that is known, if there is no such layer, or several to choose from, which it lists, if a
///         field is missing or has numbers and names, if a coordinate is not finite, or a line or ring has too few
///         places; `pslg` is then unchanged.
/// \returns what the coordinates are.
/// \tparam Point can be made from two doubles.
template <class Point>
Coordinate_system_2 read_OGR(const std::string& file_name, Pslg_2<Point>& pslg,
                             const Feature_properties_2& properties = Feature_properties_2(),
                             const std::string& layer = "") {
  namespace internal = Quadtree_mesh_2::internal;
  const internal::Gdal_dataset dataset(file_name, GDAL_OF_VECTOR);
  internal::Simple_features features;
  internal::Ogr_layer_walker walker(dataset, layer, properties, features);
  walker.walk();
  pslg = features.to_pslg<Point>();
  pslg.region_names = walker.region_names(), pslg.marker_names = walker.marker_names();
  if (walker.is_in_degrees()) return Coordinate_system_2::DEGREES;
  return walker.is_in_plane() ? Coordinate_system_2::PLANE : Coordinate_system_2::UNKNOWN;
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_OGR_H
