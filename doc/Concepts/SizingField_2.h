// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

/// \ingroup PkgQuadtreeMesh2Concepts
/// \cgalConcept
///
/// The concept `SizingField_2` describes the argument of `CGAL::Quality_mesh_options_2::size()`: a function of a
/// place that gives the longest edge wanted there. Lambdas and functions are models.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Grid_sizing_field_2}
/// \cgalHasModels{CGAL::Points_sizing_field_2}
/// \cgalHasModelsEnd
class SizingField_2 {
public:
  /// Fields are copied.
  SizingField_2(const SizingField_2& other);

  /// The longest edge wanted of a triangle with its centroid at (x, y), in the unit of the input. It has to be
  /// positive. The mesher calls it only at places inside the domain. With `CGAL::Parallel_tag` several threads call
  /// it at once.
  double operator()(double x, double y) const;
};
