// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_SVG_OPTIONS_H
#define CGAL_QUADTREE_MESH_2_SVG_OPTIONS_H

#include <CGAL/Bbox_2.h>

#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Options of `write_SVG()`. Each option is set by the function of its name, which returns the options, so
/// that calls can be chained. Without an argument the function returns the value. A color is any color of
/// SVG; "none" omits the item.
class Svg_options_2 {
public:
  /// What determines the colors of areas.
  enum class Fill {
    PLAIN,         ///< all triangles in `fill_color()`
    LEAST_ANGLE,   ///< from red (small) through yellow to green and blue (60 degrees)
    LARGEST_ANGLE, ///< from blue (60 degrees) through green to yellow (90) and red (120 and more)
    REGION         ///< twelve colors for the regions in turn; `fill_color()` outside regions
  };
  /// The legend, which tells which angles or regions the colors stand for. A plain picture has none.
  enum class Legend {
    NONE, ///< no legend
    BELOW ///< a legend below the picture
  };

  /// Width of the picture in pixels, 800 by default; the height follows.
  Svg_options_2& width(int value) { return width_ = value, *this; }
  int width() const { return width_; } ///< the value set

  /// Pixels on all sides, 4 by default.
  Svg_options_2& margin(double value) { return margin_ = value, *this; }
  double margin() const { return margin_; } ///< the value set

  /// Width of edges in pixels, 0.4 by default.
  Svg_options_2& edge_width(double value) { return edge_width_ = value, *this; }
  double edge_width() const { return edge_width_; } ///< the value set

  /// Width of segments of the input in pixels, 1.2 by default.
  Svg_options_2& segment_width(double value) { return segment_width_ = value, *this; }
  double segment_width() const { return segment_width_; } ///< the value set

  /// Width of the lines of the quadtree in pixels, 0.3 by default.
  Svg_options_2& quadtree_width(double value) { return quadtree_width_ = value, *this; }
  double quadtree_width() const { return quadtree_width_; } ///< the value set

  /// What determines the colors of areas; PLAIN by default.
  Svg_options_2& fill_by(Fill value) { return fill_by_ = value, *this; }
  Fill fill_by() const { return fill_by_; } ///< the value set

  /// Whether there is a legend; NONE by default.
  Svg_options_2& legend(Legend value) { return legend_ = value, *this; }
  Legend legend() const { return legend_; } ///< the value set

  /// Color of edges, or none.
  Svg_options_2& edge_color(std::string value) { return edge_color_ = std::move(value), *this; }
  const std::string& edge_color() const { return edge_color_; } ///< the value set

  /// Color of segments of the input, or none.
  Svg_options_2& segment_color(std::string value) { return segment_color_ = std::move(value), *this; }
  const std::string& segment_color() const { return segment_color_; } ///< the value set

  /// Color of areas, or none.
  Svg_options_2& fill_color(std::string value) { return fill_color_ = std::move(value), *this; }
  const std::string& fill_color() const { return fill_color_; } ///< the value set

  /// Color of the quadtree, if one is drawn, between areas and edges; or none.
  Svg_options_2& quadtree_color(std::string value) { return quadtree_color_ = std::move(value), *this; }
  const std::string& quadtree_color() const { return quadtree_color_; } ///< the value set

  /// Color of the background, or none.
  Svg_options_2& background_color(std::string value) { return background_color_ = std::move(value), *this; }
  const std::string& background_color() const { return background_color_; } ///< the value set

  /// Shows this part of the plane only. By default it is all of the input and the mesh.
  Svg_options_2& clip_to(const Bbox_2& window) { return clip_to_ = window, *this; }
  const std::optional<Bbox_2>& clip_to() const { return clip_to_; } ///< the value set

private:
  int width_ = 800;
  double margin_ = 4;
  double edge_width_ = 0.4;
  double segment_width_ = 1.2;
  double quadtree_width_ = 0.3;
  Fill fill_by_ = Fill::PLAIN;
  Legend legend_ = Legend::NONE;
  std::string edge_color_ = "#4a6b8a";
  std::string segment_color_ = "#12263a";
  std::string fill_color_ = "#e8f1f8";
  std::string quadtree_color_ = "#c51b7d";
  std::string background_color_ = "#ffffff";
  std::optional<Bbox_2> clip_to_;
};

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_SVG_OPTIONS_H
