// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "graph_results.h"

#include "report_names.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace quadtree_mesh_python {

namespace {

py::dict seconds_of(const CGAL::Quality_mesh_report_2::Seconds& seconds) {
  return py::dict(py::arg("quadtree") = seconds.quadtree, py::arg("first_mesh") = seconds.first_mesh,
                  py::arg("trees") = seconds.trees, py::arg("construct") = seconds.construct,
                  py::arg("refine") = seconds.refine, py::arg("coarsen") = seconds.coarsen,
                  py::arg("convert") = seconds.convert);
}

} // namespace

py::dict arrays_of_mesh(CGAL::Indexed_mesh_2<Point> made) {
  using Mesh = CGAL::Indexed_mesh_2<Point>;
  using Constrained_edge = Mesh::Constrained_edge;
  const Shown_object<Mesh> mesh(std::move(made));
  const auto& edges = mesh->constrained_edges;
  const auto n = static_cast<py::ssize_t>(edges.size());
  constexpr py::ssize_t step = sizeof(Constrained_edge), word = sizeof(std::int32_t);
  const Constrained_edge none{}, &first = edges.empty() ? none : edges.front();
  if (mesh->vertex_markers.empty()) mesh->vertex_markers.resize(mesh->points.size());
  if (mesh->region_of_triangle.empty()) mesh->region_of_triangle.resize(mesh->triangles.size(), -1);
  py::dict result;
  result["number_of_input_vertices"] = mesh->number_of_input_vertices;
  result["vertices"] = mesh.show_rows<double>(mesh->points);
  result["triangles"] = mesh.show_rows<std::int32_t>(mesh->triangles);
  result["neighbors"] = mesh.show_rows<std::int32_t>(mesh->neighbors);
  result["regions"] = mesh.show_numbers<std::int32_t>(mesh->region_of_triangle);
  result["vertex_markers"] = mesh.show_numbers<std::int32_t>(mesh->vertex_markers);
  result["vertex_segments"] = mesh.show_numbers<std::int32_t>(mesh->segment_of_vertex);
  result["segments"] = mesh.show<std::int32_t>(&first.vertices, {n, 2}, {step, word});
  result["segment_origins"] = mesh.show<std::int32_t>(&first.segment, {n}, {step});
  result["segment_markers"] = mesh.show<std::int32_t>(&first.marker, {n}, {step});
  return result;
}

py::dict values_of_report(const CGAL::Quality_mesh_report_2& report) {
  py::list unmet, exempt;
  for (const auto& t : report.unmet_triangles)
    unmet.append(py::make_tuple(t.triangle.value(), t.centroid[0], t.centroid[1], t.least_angle,
                                report_words::name(t.reason),
                                t.segment.is_valid() ? int(t.segment.value()) : -1, t.greatest_angle));
  for (const auto& t : report.exempt_triangles)
    exempt.append(py::make_tuple(t.triangle.value(), t.corner.value()));
  py::dict result;
  result["is_met"] = report.is_met();
  result["encroached_edges"] = report.encroached_edges;
  result["is_cancelled"] = report.is_cancelled;
  result["is_budget_exhausted"] = report.is_budget_exhausted;
  result["vertices"] = report.vertices;
  result["triangles"] = report.triangles;
  result["merged_vertices"] = report.merged_vertices;
  result["vertices_on_segments"] = report.vertices_on_segments;
  result["estimated_triangles"] = report.estimated_triangles;
  result["has_used_quadtrees"] = report.trees.end != CGAL::Tree_separation_report_2::End::NONE;
  result["least_angle_histogram"] = array_of(
      std::vector<std::int64_t>(report.least_angle_histogram.begin(), report.least_angle_histogram.end()));
  result["largest_angle_histogram"] = array_of(std::vector<std::int64_t>(
      report.largest_angle_histogram.begin(), report.largest_angle_histogram.end()));
  result["unmet"] = unmet;
  result["exempt"] = exempt;
  result["seconds"] = seconds_of(report.seconds);
  result["wall_seconds"] = seconds_of(report.wall_seconds);
  return result;
}

} // namespace quadtree_mesh_python
