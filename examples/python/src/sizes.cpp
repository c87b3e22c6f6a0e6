// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "sizes.h"
#include "arrays.h"
#include "definitions.h"

#include <CGAL/IO/read_ESRI_grid.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadtree_mesh_python {

namespace {

using Size_function = std::function<double(double, double)>;

Size_grid make_size_grid(const Input_array<double>& sizes, const std::array<double, 2>& origin,
                         const std::array<double, 2>& spacing) {
  if (sizes.ndim() != 2) throw std::invalid_argument("sizes must be an array with rows and columns");
  return {std::make_shared<CGAL::Grid_sizing_field_2>(
      origin, spacing, static_cast<std::size_t>(sizes.shape(1)), static_cast<std::size_t>(sizes.shape(0)),
      vector_from(sizes))};
}

void require_gradation(double gradation) {
  if (!(gradation >= 0) || !std::isfinite(gradation))
    throw std::invalid_argument("gradation must be a finite number, and not negative");
}

Size_grid with_gradation(const Size_grid& grid, double gradation) {
  require_gradation(gradation);
  const py::gil_scoped_release released;
  CGAL::Grid_sizing_field_2 limited = *grid.field;
  limited.limit_gradient(gradation);
  return {std::make_shared<CGAL::Grid_sizing_field_2>(std::move(limited))};
}

Size_grid read_size_grid(const std::filesystem::path& file, const std::optional<double>& gradation) {
  if (gradation) require_gradation(*gradation); // before the file is read
  const py::gil_scoped_release released;
  CGAL::Grid_sizing_field_2 grid = CGAL::IO::read_ESRI_grid(file.string());
  if (gradation) grid.limit_gradient(*gradation);
  return {std::make_shared<CGAL::Grid_sizing_field_2>(std::move(grid))};
}

Size_points make_size_points(const Input_array<double>& points, const Input_array<double>& sizes,
                             double gradation) {
  const std::size_t n = rows_of(points, 2, "points");
  if (static_cast<std::size_t>(sizes.size()) != n)
    throw std::invalid_argument("there must be a size for each point");
  Size_points::Points places;
  places.reserve(n);
  const double *xy = points.data(), *size = sizes.data();
  for (std::size_t i = 0; i < n; ++i) places.push_back({xy[2 * i], xy[2 * i + 1], size[i]});
  return Size_points::of(std::move(places), gradation);
}

/// In the plane of a projection: sizes are lengths on the ground.
Size_function projected(const Size_grid& grid, const CGAL::Conformal_projection_2& projection) {
  return [grid, projection](double x, double y) {
    const auto place = projection.inverse(x, y);
    return grid(place[0], place[1]) * projection.scale(place[1]);
  };
}
Size_function projected(const Size_points& sizes, const CGAL::Conformal_projection_2& projection) {
  Size_points::Points places;
  places.reserve(sizes.points->size());
  for (const auto& p : *sizes.points) {
    if (!(std::abs(p.y) < 90))
      throw std::invalid_argument("point " + std::to_string(places.size()) +
                                  " of sizes is at a pole or beyond");
    const auto place = projection.forward(p.x, p.y);
    places.push_back({place[0], place[1], p.size * projection.scale(p.y)});
  }
  return Size_points::of(std::move(places), sizes.gradation);
}

template <class Field>
Size_function field_in_plane(const py::handle& size, const CGAL::Conformal_projection_2* projection) {
  const Field field = size.cast<Field>();
  return projection != nullptr ? projected(field, *projection) : Size_function(field);
}

Size_function size_function(const py::handle& size, const CGAL::Conformal_projection_2* projection) {
  if (py::isinstance<Size_grid>(size)) return field_in_plane<Size_grid>(size, projection);
  if (py::isinstance<Size_points>(size)) return field_in_plane<Size_points>(size, projection);
  const double number = size.cast<double>();
  if (!(number > 0) || !std::isfinite(number)) throw std::invalid_argument("a size must be positive");
  return [number](double, double) { return number; };
}

} // namespace

Size_function least_size(const py::list& sizes, const CGAL::Conformal_projection_2* projection) {
  std::vector<Size_function> functions;
  for (const py::handle& size : sizes) functions.push_back(size_function(size, projection));
  if (functions.size() <= 1) return functions.empty() ? Size_function() : std::move(functions.front());
  return [functions = std::move(functions)](double x, double y) {
    double least = functions[0](x, y);
    for (std::size_t i = 1; i < functions.size(); ++i) least = std::min(least, functions[i](x, y));
    return least;
  };
}

void define_sizes(py::module_& module) {
  const auto evaluate = [](const auto& field) { return [field](double x, double y) { return field(x, y); }; };
  py::class_<Size_grid>(module, "SizeGrid", R"(Sizes on a regular grid, bilinear between its points.

Outside the grid the size is that of the nearest place in it. A call ``grid(x, y)`` gives the size at a place, or
an array of sizes for arrays of coordinates. O(1) time for each.

Parameters
----------
sizes : (rows, columns) array of float
    Lengths in the units of the coordinates, positive. ``sizes[j, i]`` is the size at
    ``(origin[0] + i * spacing[0], origin[1] + j * spacing[1])``: rows go from south to north.
origin : (float, float)
    The place of ``sizes[0, 0]``.
spacing : (float, float)
    The distances of neighbors in x and y, positive.

Raises
------
ValueError
    If a number violates these requirements.)")
      .def(py::init(&make_size_grid), py::arg("sizes"), py::arg("origin"), py::arg("spacing"))
      .def_static("read", &read_size_grid, R"(Reads sizes from an ASCII grid of ESRI (.asc).

Parameters
----------
file : str or os.PathLike
    As ArcGIS, QGIS, GRASS and GDAL write it, also compressed by gzip. A size holds at the center of its cell.
    Where there are no data, sizes have no bound: they are infinite.
gradation : float, optional
    By how much sizes grow at most over a unit of length; see `with_gradation()`.

Raises
------
GraphError
    If the file cannot be read or a size is not positive; the text has the file and the line.
ValueError
    If the gradation is negative or not finite.)",
                  py::arg("file"), py::kw_only(), py::arg("gradation") = py::none())
      .def("with_gradation", &with_gradation,
           R"(A grid of the largest sizes that grow slowly and exceed none of these.

Between any two points of the grid they grow by at most `gradation` over a unit of length, and between any two places by
at most the square root of 2 as much. Infinite sizes become finite, unless all are infinite. This grid stays as it is.
Takes O(n log n) time for n points where sizes grow no faster nearly everywhere.

Parameters
----------
gradation : float
    At least 0. A mesh follows up to about 1; 0.1 to 0.3 is usual for flow.

Raises
------
ValueError
    If the gradation is negative or not finite.)",
           py::arg("gradation"))
      .def(
          "__call__",
          [evaluate](const Size_grid& grid, const py::object& x, const py::object& y) {
            return py::object(py::vectorize(evaluate(grid))(x, y));
          },
          py::arg("x"), py::arg("y"));
  py::class_<Size_points>(module, "SizePoints", R"(Sizes at points, which grow with the distance.

The size at a place is the least of ``size + gradation * distance`` over all points. A call ``field(x, y)`` gives
the size at a place, or an array of sizes for arrays of coordinates, in O(log n) time for each where sizes grow no
faster than the gradation.

Parameters
----------
points : (n, 2) array of float
    At least one.
sizes : (n,) array of float
    Lengths in the units of the coordinates, positive.
gradation : float
    By how much the size grows over a unit of length, at least 0. A mesh follows up to about 1.

Raises
------
ValueError
    If a number violates these requirements.)")
      .def(py::init(&make_size_points), py::arg("points"), py::arg("sizes"), py::arg("gradation") = 0.5)
      .def(
          "__call__",
          [evaluate](const Size_points& points, const py::object& x, const py::object& y) {
            return py::object(py::vectorize(evaluate(points))(x, y));
          },
          py::arg("x"), py::arg("y"));
}

} // namespace quadtree_mesh_python
