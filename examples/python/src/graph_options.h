// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_PYTHON_GRAPH_OPTIONS_H
#define QUADTREE_MESH_PYTHON_GRAPH_OPTIONS_H

#include "arrays.h"
#include "watched_run.h"

#include <CGAL/Conformal_projection_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

// Options of the mesher of graphs, by name.

namespace quadtree_mesh_python {

/// The projection that is wanted by name, of a graph in degrees.
std::optional<CGAL::Conformal_projection_2> projection_for(const CGAL::Pslg_2<Point>& graph,
                                                           const std::string& name);

/// \param projection in whose plane they are to hold; null: none
CGAL::Quality_mesh_options_2 options_from(const py::dict& values,
                                          const CGAL::Conformal_projection_2* projection);

/// The user's criterion in Python. The mesher's threads call it one after the other, each with Python's lock. After an
/// exception it is not called again.
class Refinement_criterion {
public:
  /// \param projection in whose plane triangles are, while the function gets degrees
  Refinement_criterion(py::object function, Run_state& state,
                       const std::optional<CGAL::Conformal_projection_2>& projection)
      : function_(std::move(function)), state_(state), projection_(projection) {}

  bool operator()(CGAL::Quality_mesh_options_2::Corners corners) {
    if (projection_)
      for (auto& corner : corners) corner = projection_->inverse(corner[0], corner[1]);
    const py::gil_scoped_acquire lock;
    if (error_ || state_.is_stopped()) return false;
    try {
      py::array_t<double> array({3, 2});
      std::copy(&corners[0][0], &corners[0][0] + 6, array.mutable_data());
      return py::bool_(function_(array));
    } catch (py::error_already_set& error) {
      error_.emplace(std::move(error));
      state_.stop();
      return false;
    }
  }
  void throw_error() {
    if (error_) throw py::error_already_set(std::move(*error_));
  }

private:
  py::object function_;
  Run_state& state_;
  std::optional<CGAL::Conformal_projection_2> projection_;
  std::optional<py::error_already_set> error_;
};

} // namespace quadtree_mesh_python

#endif // QUADTREE_MESH_PYTHON_GRAPH_OPTIONS_H
