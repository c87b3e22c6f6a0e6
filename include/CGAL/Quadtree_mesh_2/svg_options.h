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

namespace CGAL {
namespace IO {

/// Options of `write_SVG()`. A color is any color of SVG; "none" omits the item.
struct Svg_options_2 {
  /// What determines the colors of areas.
  enum class Fill {
    PLAIN,         ///< all triangles in `fill_color`
    LEAST_ANGLE,   ///< from red (small) through yellow to green and blue (60 degrees)
    LARGEST_ANGLE, ///< from blue (60 degrees) through green to yellow (90) and red (120 and more)
    REGION         ///< twelve colors for the regions in turn; `fill_color` outside regions
  };
  /// The legend, which tells which angles or regions the colors stand for. A plain picture has none.
  enum class Legend { NONE, BELOW };

  int width_in_pixels = 800;                ///< of the picture; the height follows
  double margin_in_pixels = 4;              ///< on all sides
  double edge_width = 0.4;                  ///< pixels, as all widths
  double segment_width = 1.2;               ///< of segments of the input
  Fill fill = Fill::PLAIN;                  ///< what determines the colors of areas
  Legend legend_place = Legend::NONE;       ///< whether there is a legend
  std::string edge_color = "#4a6b8a";       ///< of edges, or none
  std::string segment_color = "#12263a";    ///< of segments of the input, or none
  std::string fill_color = "#e8f1f8";       ///< of areas, or none
  std::string quadtree_color = "#c51b7d";   ///< of the quadtree, if one is drawn, between areas and edges
  double quadtree_width = 0.3;              ///< of its lines
  std::string background_color = "#ffffff"; ///< of the background, or none
  /// The part of the plane to show. If empty, all of the input and the mesh.
  std::optional<Bbox_2> clip;

  /// \name Setters
  /// @{

  /// Each sets what its name says and returns the options, so that calls can be chained.
  Svg_options_2& width(int pixels) { return width_in_pixels = pixels, *this; }
  Svg_options_2& fill_by(Fill f) { return fill = f, *this; }
  Svg_options_2& legend(Legend l) { return legend_place = l, *this; }
  Svg_options_2& clip_to(const Bbox_2& window) { return clip = window, *this; }
  /// @}
};

} // namespace IO
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_SVG_OPTIONS_H
