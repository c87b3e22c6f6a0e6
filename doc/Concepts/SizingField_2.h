// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

/// \ingroup PkgQuadtreeMesh2Concepts
/// \cgalConcept
///
/// The concept `SizingField_2` describes what `CGAL::Quality_mesh_options_2::size()` takes: a function of a place that
/// tells how long the edges of triangles there may be. Lambdas and functions are models.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Grid_sizing_field_2}
/// \cgalHasModels{CGAL::Points_sizing_field_2}
/// \cgalHasModelsEnd
class SizingField_2 {
public:
  /// Fields are copied.
  SizingField_2(const SizingField_2& other);

  /// The longest edge wanted of a triangle with its centroid at (x, y), in the unit of the input; positive. It is called
  /// at places inside the domain only, and with `CGAL::Parallel_tag` by several threads at once.
  double operator()(double x, double y) const;
};
