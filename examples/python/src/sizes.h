// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_PYTHON_SIZES_H
#define QUADTREE_MESH_PYTHON_SIZES_H

#include <CGAL/Conformal_projection_2.h>
#include <CGAL/Grid_sizing_field_2.h>
#include <CGAL/Points_sizing_field_2.h>
#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace quadtree_mesh_python {

/// Sizes that change from place to place. Copies are shallow.
template <class Field>
struct Size_field {
  std::shared_ptr<const Field> field;

  double operator()(double x, double y) const { return (*field)(x, y); }
};
using Size_grid = Size_field<CGAL::Grid_sizing_field_2>;

/// Knows its points, too, which a projection moves.
struct Size_points : Size_field<CGAL::Points_sizing_field_2> {
  using Points = std::vector<CGAL::Points_sizing_field_2::Sized_point>;
  std::shared_ptr<const Points> points;
  double gradation = 0;

  static Size_points of(Points points, double gradation) {
    return {{std::make_shared<CGAL::Points_sizing_field_2>(points, gradation)},
            std::make_shared<const Points>(std::move(points)),
            gradation};
  }
};

/// The least of several sizes; empty if there are none.
/// \param sizes a list of numbers, grids and points
/// \param projection in whose plane sizes are asked for, while places of grids and points are in degrees; null: none
std::function<double(double, double)> least_size(const pybind11::list& sizes,
                                                 const CGAL::Conformal_projection_2* projection);

} // namespace quadtree_mesh_python

#endif // QUADTREE_MESH_PYTHON_SIZES_H
