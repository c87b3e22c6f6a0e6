// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_FEATURE_PROPERTIES_2_H
#define CGAL_FEATURE_PROPERTIES_2_H

#include <string>
#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Which properties of features in files of geographic data mean something to a `Pslg_2`. An empty name stands
/// for none.
///
/// A property has numbers in all features, or names. Names are numbered from 1 on, in the order in which they come
/// first; `Pslg_2::region_names` and `Pslg_2::marker_names` keep them.
struct Feature_properties_2 {
  std::string region; ///< becomes the attribute of regions: those that polygons of the feature cover
  std::string
      marker; ///< becomes the marker of segments: lines and borders of polygons. Its numbers are whole

  /// No property.
  Feature_properties_2() = default;
  /// That of regions, and that of segments.
  Feature_properties_2(std::string region_property, std::string marker_property = "")
      : region(std::move(region_property)), marker(std::move(marker_property)) {}
  /// That of regions.
  Feature_properties_2(const char* region_property) : region(region_property) {}
};

/// \ingroup PkgQuadtreeMesh2Data
/// What the coordinates of geographic data are, as their file says.
enum class Coordinate_system_2 {
  UNKNOWN, ///< the file does not say
  PLANE,   ///< of a plane, as those of projected reference systems
  DEGREES  ///< longitudes and latitudes
};

} // namespace CGAL

#endif // CGAL_FEATURE_PROPERTIES_2_H
