// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "arrays.h"
#include "definitions.h"
#include "watched_run.h"

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Meshes of point sets. quadtree_mesh.meshing documents what goes in and out.

namespace quadtree_mesh_python {

namespace {

using Mesh = CGAL::Indexed_mesh_2<Point>;
using Mesher = CGAL::Point_set_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
using Options = CGAL::Point_set_mesh_options_2;
using Report = CGAL::Point_set_mesh_report_2;

void choose_mode(Options& options, const std::string& mode, double least, double largest) {
  if (mode == "bounded")
    options.bounded_angles(least, largest);
  else if (mode == "acute")
    options.acute();
  else if (mode == "least")
    options.least_angle();
  else if (mode == "warped")
    options.warped_squares();
  else
    throw std::invalid_argument("angles must be (least, largest), 'acute', 'least' or 'warped', not '" +
                                mode + "'");
}

Options options_from(const py::dict& values) {
  Options options;
  choose_mode(options, values["mode"].cast<std::string>(), values["least"].cast<double>(),
              values["largest"].cast<double>());
  const std::string domain = values["domain"].cast<std::string>();
  if (domain != "row" && domain != "square")
    throw std::invalid_argument("domain must be 'row' or 'square', not '" + domain + "'");
  return options.mesh_domain(domain == "row" ? Options::Domain::ROW : Options::Domain::SQUARE)
      .effort(values["effort"].cast<int>());
}

py::dict arrays_of(Mesh made) {
  const Shown_object<Mesh> mesh(std::move(made));
  py::dict result;
  result["number_of_input_vertices"] = mesh->number_of_input_vertices;
  result["vertices"] = mesh.show_rows<double>(mesh->points);
  result["triangles"] = mesh.show_rows<std::int32_t>(mesh->triangles);
  result["neighbors"] = mesh.show_rows<std::int32_t>(mesh->neighbors);
  return result;
}

py::dict seconds_of(const Report::Seconds& seconds) {
  return py::dict(py::arg("quadtree") = seconds.quadtree, py::arg("separate") = seconds.separate,
                  py::arg("coarsen") = seconds.coarsen, py::arg("convert") = seconds.convert);
}

py::dict values_of(const Report& report) {
  py::list unmet;
  for (const auto& t : report.unmet_triangles)
    unmet.append(py::make_tuple(t.triangle.value(), t.centroid[0], t.centroid[1]));
  py::dict result;
  result["is_met"] = report.is_met();
  result["is_cancelled"] = report.is_cancelled;
  result["vertices"] = report.vertices;
  result["triangles"] = report.triangles;
  result["merged_points"] = report.merged_points;
  result["triangles_before_coarsening"] = report.triangles_before_coarsening;
  result["clusters"] = report.clusters;
  result["thin_triangles"] = report.thin_triangles;
  result["least_angle"] = report.least_angle;
  result["largest_angle"] = report.largest_angle;
  result["unmet"] = unmet;
  result["seconds"] = seconds_of(report.seconds);
  result["wall_seconds"] = seconds_of(report.wall_seconds);
  return result;
}

py::dict mesh_points(const Input_array<double>& array, const py::dict& values) {
  Run_state state;
  const std::vector<Point> points = points_from(array, "points");
  Mesher mesher(options_from(values).progress(std::ref(state)));
  const Thread_bound bound(values["threads"].cast<std::size_t>());
  Mesh mesh;
  run_watched(state, values["progress"], [&] { mesh = mesher(points); });
  py::dict result = arrays_of(std::move(mesh));
  result["report"] = values_of(mesher.report());
  return result;
}

} // namespace

void define_point_sets(py::module_& module) {
  module.def("mesh_points", &mesh_points, py::arg("points"), py::arg("options"));
}

} // namespace quadtree_mesh_python
