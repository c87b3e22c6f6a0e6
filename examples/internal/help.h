// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_HELP_H
#define QUADTREE_MESH_2_EXAMPLES_HELP_H

// What --help and --help-all print: the everyday options on one screen, or all of them.

#include "option_descriptions.h"

#include <ostream>

/// What both of them begin with.
inline void print_usage(std::ostream& out) {
  out << R"(usage: quality_mesh INPUT [-o OUTPUT]... [option]...

Meshes polygons, lines and points, or points alone, with triangles whose angles
meet a bound.
)";
}

/// The options most people need. One screen, written by hand: the descriptions of --help-all are longer.
inline void print_help(std::ostream& out) {
  print_usage(out);
  out << R"(
  quality_mesh lakes.geojson --max-edge 500 -o lakes.2dm    a map: sizes in meters
  quality_mesh plate.poly --min-angle 28 -o plate.msh -o plate.svg
  quality_mesh wells.csv --mode acute -o wells.svg          points: no obtuse angle

  INPUT              .poly (Triangle), .geojson, .wkt, .h5; points: .node, .csv, .xy;
                     with GDAL: .gpkg, .shp, .kml, .gml, .fgb, .dxf; to refine: .ele
  --layer NAME       of an input with several
  -o FILE            .vtu .msh .2dm .gr3 .14 .mesh .ele .off .svg ..., also several
  -                  standard input or output, with --input-format, --output-format
  --min-angle DEG    least angle, up to 34; if not given 20.7
  --max-edge H       longest edge
  --max-area A       largest area of a triangle
  --size-points FILE sizes at points, one 'x y size' a line
  --size-grid FILE   sizes on an ASCII grid of ESRI (.asc), or by GDAL (.tif ...)
  --size-from-features H G   sizes H + G times the distance from segments
  --gradation G      edges grow by at most G times the distance, such as 0.2
  --region-property NAME  number or name of features: attribute of regions
  --marker-property NAME  the same for markers of segments
  --repair           split segments where they cross, as polygons that overlap do
  --project P        map longitudes and latitudes: auto, mercator, lambert, none
  --mode M           points alone: points, bounded, acute, warped
  --threads N        number of threads; all if not given, the mesh is the same
  --report FILE.json figures of the mesh, and where a bound is missed
  --quiet            print nothing but errors
  --version          print the version
  --help-all         all options: domains, pictures, large meshes, comparisons, ...

Exit status: 0 all bounds are met; 1 written, but a bound is missed somewhere;
2 nothing is written, and a message says why.
)";
}

inline void print_all_options(std::ostream& out) {
  print_usage(out);
  out << R"(INPUT is .poly of Triangle, .geojson (or .json), .wkt, .h5 (HDF5), or what GDAL
reads: .gpkg, .shp, .shz, .kml, .kmz, .gml, .fgb, .dxf. Or points alone:
any of these without segments, .node, or a table, one 'x y', 'x,y' or 'x;y' a
line (.xy, .txt, .csv). Or .ele, a mesh to refine, with .node beside it. Any may be
compressed (.gz).
)" << command_line_internal::visible_options()
      << R"(
Exit status: 0 the mesh is valid and meets all bounds; 1 it is valid and written,
but a bound is unmet somewhere; 2 nothing is written: bad usage, bad input, no
valid mesh of it in this arithmetic, or too little memory or disk.
)";
}

#endif // QUADTREE_MESH_2_EXAMPLES_HELP_H
