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

/// How `write_SVG()` draws. Colours are whatever SVG takes for one; "none" leaves a thing out.
struct Svg_options_2 {
  /// What areas are coloured by.
  enum class Fill {
    PLAIN,         ///< all triangles in `fill_color`
    LEAST_ANGLE,   ///< from red (small) through yellow to green and blue (60 degrees)
    LARGEST_ANGLE, ///< from blue (60 degrees) through green to yellow (90) and red (120 and more)
    REGION         ///< twelve colours for the regions, one after the other; `fill_color` where there is none
  };
  /// What tells which angles or regions the colours stand for; a plain picture has none.
  enum class Legend { NONE, BELOW };

  int width_in_pixels = 800;                ///< of the picture; the height follows
  double margin_in_pixels = 4;              ///< on all sides
  double edge_width = 0.4;                  ///< pixels, as all widths
  double segment_width = 1.2;               ///< of segments of the input
  Fill fill = Fill::PLAIN;                  ///< what areas are coloured by
  Legend legend_place = Legend::NONE;       ///< whether there is a legend
  std::string edge_color = "#4a6b8a";       ///< of edges, or none
  std::string segment_color = "#12263a";    ///< of segments of the input, or none
  std::string fill_color = "#e8f1f8";       ///< of areas, or none
  std::string quadtree_color = "#c51b7d";   ///< of the quadtree, if one is drawn, between areas and edges
  double quadtree_width = 0.3;              ///< of its lines
  std::string background_color = "#ffffff"; ///< of the rest, or none
  /// The part of the plane that is shown; all of the input and the mesh if empty.
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
