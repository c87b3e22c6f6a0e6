// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_OPTION_DESCRIPTIONS_H
#define QUADTREE_MESH_2_EXAMPLES_OPTION_DESCRIPTIONS_H

// What --help-all says about the options of quality_mesh.

#include "option_values.h"

#include <boost/program_options.hpp>

#include <string>
#include <vector>
namespace command_line_internal {

// clang-format off
inline po::options_description common_options() {
  po::options_description options("Options");
  options.add_options()
    ("mode", po::value<std::string>()->value_name("M")->default_value("pslg"),
     "pslg: a graph, with a least angle; or points alone: points (least angle 20.7, fewest triangles), bounded "
     "(all angles in a range), acute (all below 90) or warped (corners of squares moved to the points)")
    ("output,o", po::value<std::vector<std::string>>()->value_name("FILE"),
     "where to write the mesh, more than once if you like: .vtu, .pvtu (in pieces), .vtkhdf, .xdmf (with .h5), .svg, "
     ".html (a page to look at), .off, .obj, .msh (Gmsh), .mesh (MEDIT), .2dm (SMS), .gr3 (SCHISM), .14 (ADCIRC), or "
     ".ele, which writes .node, .ele and .poly. Or a part: .edge and .neigh (Triangle's), .v.node (its Voronoi "
     "diagram), .cells.geojson and .cells.wkt (polygons around vertices). Or - for standard output, where nothing but "
     "the mesh goes then")
    ("cells", po::value<std::string>()->value_name("C"),
     "the polygons of .cells.geojson and .cells.wkt, which end at the border: voronoi, if not given, or median (with "
     "corners at barycenters)")
    ("second-order", "elements of .ele, .vtu and .msh have a node in the middle of each side, too")
    ("layer", po::value<std::string>()->value_name("NAME"), "of an input with several, such as .gpkg")
    ("input-format", po::value<std::string>()->value_name("F"),
     "of standard input, INPUT -: poly, if not given, geojson, json, wkt, node, xy, csv or txt")
    ("output-format", po::value<std::string>()->value_name("F"),
     "of standard output, -o -: vtu, svg, html, off, obj, msh, mesh, 2dm, gr3 or 14")
    ("msh-version", po::value<std::string>()->value_name("V"), "version of .msh: 4.1, if not given, or 2.2")
    ("renumber", "number vertices and triangles by their places, so that what is near is near in files, too; the "
     "input's numbers become data, input_index")
    ("pieces", po::value<double>()->value_name("N"),
     "number of the pieces of .pvtu, one for a million triangles if not given; with it .msh is written in parts for "
     "Gmsh, with ghosts")
    ("color", po::value<std::string>()->value_name("C"),
     "colors of .svg and .html: none, angle or region, or in .html size; if not given, angle in .html and in the modes "
     "for points, else none")
    ("show-quadtree", "draw the quadtree of the input in .svg and .html, and write its levels to .vtu, .pvtu, .vtkhdf "
     "and .xdmf")
    ("kernel", po::value<std::string>()->value_name("K")->default_value("filtered"),
     "arithmetic: filtered (doubles), fixed (64-bit integers) or exact")
    ("threads", po::value<double>()->value_name("N"),
     "number of threads, at most 256 or the number of processors, whichever is larger; all if not given. The mesh is "
     "the same for any number")
    ("compare", "mesh the input with CGAL Mesh_2, too, and with --mode pslg by our other separation, in a table")
    ("memory", po::value<std::string>()->value_name("SIZE"),
     "keep to about so much memory, such as 2G or 500M, with the rest in files of the scratch folder")
    ("scratch", po::value<std::string>()->value_name("FOLDER"),
     "the scratch folder, on a disk with room for some 250 bytes for each triangle; if not given, the first output's "
     "name and .scratch")
    ("resume", "go on from the state that an interrupted run with --memory or --resume left in the scratch folder")
    ("report", po::value<std::string>()->value_name("FILE.json"), "write the figures as JSON")
    ("quiet", "print nothing but errors")
    ("version", "print the version")
    ("help,h", "print the everyday options")
    ("help-all", "print this");
  return options;
}

inline po::options_description graph_options() {
  po::options_description options("Options of --mode pslg");
  options.add_options()
    ("min-angle", po::value<double>()->value_name("DEG")->default_value(20.7, "20.7"),
     "least angle in degrees, up to 34; where it is missed is reported")
    ("max-edge", po::value<double>()->value_name("H"), "longest edge")
    ("max-area", po::value<double>()->value_name("A"), "largest area of a triangle")
    ("area-file", po::value<std::string>()->value_name("FILE"),
     "of a mesh to refine, INPUT.ele: the largest area of a triangle in each of its triangles, an .area file of "
     "Triangle; no bound where it is not positive")
    ("min-edge", po::value<double>()->value_name("H"),
     "insert no vertex nearer than this to another; triangles that miss a bound for this reason are reported")
    ("region-property", po::value<std::string>()->value_name("NAME"),
     "the property of features that becomes the attribute of their regions: its numbers, or 1, 2, ... for "
     "names, which the report lists")
    ("marker-property", po::value<std::string>()->value_name("NAME"),
     "the property that becomes the marker of their lines and borders: whole numbers, or names in the same way")
    ("hull", "mesh the convex hull: its border is added where no segment lies on it. The input may have points alone")
    ("repair", "split segments where they cross, as borders of polygons that overlap do")
    ("project", po::value<std::string>()->value_name("P"),
     "the conformal projection in which longitudes and latitudes are meshed, so that angles are those on the ground "
     "and sizes are meters: auto (by the latitudes), mercator, lambert or none. The mesh is in degrees. If not given: "
     "auto for GeoJSON with coordinates of degrees, and where the file says that they are degrees; else none")
    ("size-points", po::value<std::string>()->value_name("FILE"),
     "points with sizes, one 'x y size' a line: the longest edge is size plus half the distance, the least over all")
    ("size-grid", po::value<std::string>()->value_name("FILE"),
     "longest edges on an ASCII grid of ESRI (.asc) or a raster that GDAL reads (.tif ...), bilinear between its "
     "places; no bound where it has no data")
    ("size-from-features", (new Two_numbers)->value_name("H G"),
     "the longest edge is H plus G times the distance from the nearest segment or vertex of the input")
    ("gradation", po::value<double>()->value_name("G"),
     "each edge is at most --max-edge-ratio times as long as any other one plus G times their distance, such as 0.2; "
     "the sizes of the three options above grow by at most G, too")
    ("max-edge-ratio", po::value<double>()->value_name("R"),
     "edges with a common end differ at most by this factor, at least 3; if not given 3 with --gradation, else no "
     "bound")
    ("max-angle", po::value<double>()->value_name("DEG"),
     "greatest angle wanted, from 105 on, but in acute corners of the input; what is left above it is reported")
    ("domain", po::value<std::string>()->value_name("D")->default_value("enclosed"),
     "what is meshed: enclosed, marked (components with a region's point) or parity (of nested borders)")
    ("separation", po::value<std::string>()->value_name("S")->default_value("on-demand"),
     "how features are kept apart: on-demand, or theorem-5 (by quadtrees, in parallel rounds)")
    ("neighbors", po::value<std::string>()->value_name("N")->default_value("trapezoidal"),
     "with theorem-5 and several rounds: what finds the edges next to vertices, trapezoidal or quadtree; the mesh is "
     "the same")
    ("subdivision", po::value<std::string>()->value_name("S")->default_value("walking"),
     "with theorem-5: what cuts edges into pieces, walking or centroid-tree; the mesh is the same")
    ("placement", po::value<std::string>()->value_name("P")->default_value("chosen"),
     "with theorem-5: chosen, or by-rule (many times the triangles before removal)")
    ("tree-rounds", po::value<double>()->value_name("N")->default_value(1),
     "with theorem-5: rounds of placing vertices at most; refinement cures what they miss. 0: until they miss nothing")
    ("smooth", po::value<double>()->value_name("N")->default_value(0),
     "rounds of smoothing, up to 1000: about a percent fewer triangles each, and better angles")
    ("thin", po::value<double>()->value_name("N")->default_value(0),
     "rounds of thinning, up to 1000: fewer triangles still, each takes about as long as refinement")
    ("max-vertices", po::value<double>()->value_name("N"),
     "stop refining at so many vertices, and report what is left; what surely needs four times as many is refused. If "
     "not given: what memory allows, and for graphs of fewer than 1000 vertices 2000000 triangles (exact: 1000000) "
     "besides what bounds of size ask for")
    ("max-steiner", po::value<double>()->value_name("N"),
     "stop refining at so many vertices that are not of the input, and report what is left; it may be 0")
    ("conforming", "split segments until all triangles are Delaunay, so that no circumcenter is outside")
    ("keep-borders", po::value<std::string>()->value_name("B"),
     "which segments get no vertices: none, boundary (with the domain on one side), marked (with a marker) or all; "
     "what misses a bound for this reason is reported")
    ("no-coarsening", "keep the vertices that are not needed in the end");
  return options;
}

inline po::options_description point_options() {
  po::options_description options("Options of the modes for points");
  options.add_options()
    ("angles", (new Two_numbers)->value_name("LO HI"),
     "bounded: the range of all angles, 36 80 if not given; LO from 0 to 37.5, HI from 78.6 to 89.5")
    ("square", "bounded: mesh a square parallel to the axes, not a row of squares along the points' diameter")
    ("effort", po::value<double>()->value_name("N")->default_value(2),
     "points, bounded, acute: the effort to remove vertices, from 0 (none) to 3")
    ("budget", po::value<double>()->value_name("N"),
     "bounded, acute: try to remove about so many vertices at most")
    ("lengths", "compare the length of all edges with the least that there can be");
  return options;
}
// clang-format on

inline po::options_description visible_options() {
  return po::options_description().add(common_options()).add(graph_options()).add(point_options());
}

} // namespace command_line_internal

#endif // QUADTREE_MESH_2_EXAMPLES_OPTION_DESCRIPTIONS_H
