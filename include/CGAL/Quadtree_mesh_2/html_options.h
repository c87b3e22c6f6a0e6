// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_HTML_OPTIONS_H
#define CGAL_QUADTREE_MESH_2_HTML_OPTIONS_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Options of `write_HTML()`. Each option is set by the function of its name, which returns the options, so
/// that calls can be chained. Without an argument the function returns the value.
class Html_options_2 {
public:
  /// What the colors of triangles stand for at first; the page has a menu of them.
  enum class Color {
    LEAST_ANGLE,   ///< from red (small) through yellow to green and blue (60 degrees)
    LARGEST_ANGLE, ///< from blue (60 degrees) through green to yellow (90) and red (120 and more)
    SIZE,          ///< by the longest edge, from blue (short) to yellow
    REGION,        ///< twelve colors for the regions in turn; if the mesh has none, as LEAST_ANGLE
    NONE           ///< all triangles have one color
  };
  using Triangle_index = Quadtree_mesh_2::Triangle_index; ///< the index of a triangle in the mesh

  /// What the page is called, in UTF-8; "mesh" by default.
  Html_options_2& title(std::string value) { return title_ = std::move(value), *this; }
  const std::string& title() const { return title_; } ///< the value set

  /// What the colors stand for; LEAST_ANGLE by default.
  Html_options_2& color_by(Color value) { return color_by_ = value, *this; }
  Color color_by() const { return color_by_; } ///< the value set

  /// Triangles that miss a bound, which the page marks, such as those in a mesher's report; none by default.
  Html_options_2& unmet_triangles(std::vector<Triangle_index> value) {
    return unmet_triangles_ = std::move(value), *this;
  }
  const std::vector<Triangle_index>& unmet_triangles() const { return unmet_triangles_; } ///< the value set

  /// For each vertex, the coordinates that the page names, if they are not those at which it is drawn. So a mesh
  /// in degrees is drawn in the plane of its projection, where angles are those on the ground. Empty by default.
  Html_options_2& coordinates(std::vector<std::array<double, 2>> value) {
    return coordinates_ = std::move(value), *this;
  }
  const std::vector<std::array<double, 2>>& coordinates() const { return coordinates_; } ///< the value set

private:
  std::string title_ = "mesh";
  Color color_by_ = Color::LEAST_ANGLE;
  std::vector<Triangle_index> unmet_triangles_;
  std::vector<std::array<double, 2>> coordinates_;
};

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_HTML_OPTIONS_H
