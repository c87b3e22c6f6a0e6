// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "definitions.h"

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>

#include <exception>
#include <string>
#include <vector>

// Errors of the meshers become exceptions of quadtree_mesh.errors, which derive from ValueError and have the indices of
// what is at fault.

namespace py = pybind11;

namespace quadtree_mesh_python {

namespace {

using Pslg_kind = CGAL::Pslg_error_2::Kind;
using Point_error = CGAL::Quadtree_mesh_2::Point_error;

const char* name_of(Pslg_kind kind) {
  switch (kind) {
  case Pslg_kind::UNREADABLE_FILE:
    return "unreadable"; // a file or a geometry
  case Pslg_kind::ARRAY_LENGTH:
    return "array_length";
  case Pslg_kind::NO_SUCH_VERTEX:
    return "no_such_vertex";
  case Pslg_kind::NOT_FINITE:
    return "not_finite";
  case Pslg_kind::OUT_OF_RANGE:
    return "out_of_range";
  case Pslg_kind::NO_AREA:
    return "no_area";
  case Pslg_kind::ZERO_LENGTH:
    return "zero_length";
  case Pslg_kind::CROSSING:
    return "crossing";
  case Pslg_kind::TOO_NEAR:
    return "too_near";
  case Pslg_kind::AMBIGUOUS_SEED:
    return "ambiguous_seed";
  case Pslg_kind::NO_DOMAIN:
    return "no_domain";
  case Pslg_kind::TOO_MANY_TRIANGLES:
    return "too_many_triangles";
  case Pslg_kind::INVALID_MESH:
    return "invalid_mesh";
  case Pslg_kind::ROUNDING:
    break;
  }
  return "rounding";
}

const char* name_of(Point_error::Kind kind) {
  switch (kind) {
  case Point_error::Kind::NOT_FINITE:
    return "not_finite";
  case Point_error::Kind::OUT_OF_RANGE:
    return "out_of_range";
  case Point_error::Kind::INDISTINGUISHABLE:
    return "indistinguishable";
  case Point_error::Kind::TOO_NEAR:
    break;
  }
  return "too_near";
}

template <class Indices>
py::list list_of(const Indices& indices) {
  py::list list;
  for (const auto i : indices) list.append(static_cast<std::size_t>(i));
  return list;
}

void raise(const char* type_name, const py::object& exception) {
  const py::object type = py::module_::import("quadtree_mesh.errors").attr(type_name);
  PyErr_SetObject(type.ptr(), exception.ptr());
}

void raise(const CGAL::Pslg_error_2& error) {
  const CGAL::Pslg_parts_2& parts = error.parts();
  raise("GraphError", py::module_::import("quadtree_mesh.errors")
                          .attr("GraphError")(error.what(), name_of(error.kind()), list_of(parts.vertices),
                                              list_of(parts.segments), list_of(parts.holes),
                                              list_of(parts.regions), list_of(parts.triangles)));
}

void raise(const Point_error& error) {
  py::list points;
  points.append(std::size_t(error.point()));
  if (error.other().is_valid()) points.append(std::size_t(error.other()));
  raise("PointError", py::module_::import("quadtree_mesh.errors")
                          .attr("PointError")(error.what(), name_of(error.kind()), points));
}

} // namespace

void define_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const CGAL::Pslg_error_2& error) {
      raise(error);
    } catch (const Point_error& error) {
      raise(error);
    }
  });
}

} // namespace quadtree_mesh_python
