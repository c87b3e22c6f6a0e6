// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "arrays.h"
#include "definitions.h"
#include "graph_options.h"
#include "graph_results.h"
#include "watched_run.h"

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Mesh_sizing_field_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/pslg_from_mesh_2.h>
#include <CGAL/refine_mesh_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

// Meshes that exist. quadtree_mesh.adaptation documents what goes in and out.

namespace quadtree_mesh_python {

namespace {

using Graph = CGAL::Pslg_2<Point>;
using Given_mesh = CGAL::Indexed_mesh_2<Point>;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Triangle_index;
using CGAL::Quadtree_mesh_2::Vertex_index;

Vertex_index vertex_from(std::int64_t i) {
  return i >= 0 && i < std::int64_t(std::numeric_limits<std::uint32_t>::max()) ? Vertex_index(i)
                                                                               : Vertex_index();
}

/// A mesh that is given, and what it is a mesh of.
struct Given_arrays {
  Given_mesh mesh;
  Graph graph;
  std::vector<Triangle_index> given_triangle; // per triangle, the user's that it is a piece of
  std::map<std::uint32_t, std::int32_t>
      origins; // per segment of the graph, that of the user's; none if it is not there

  explicit Given_arrays(const py::dict& arrays) {
    mesh.points = points_from(arrays["vertices"].cast<Input_array<double>>(), "vertices");
    const auto triangles = arrays["triangles"].cast<Input_array<std::int64_t>>();
    const std::size_t t = rows_of(triangles, 3, "triangles");
    for (std::size_t i = 0; i < t; ++i)
      mesh.triangles.push_back({vertex_from(triangles.at(i, 0)), vertex_from(triangles.at(i, 1)),
                                vertex_from(triangles.at(i, 2))});
    mesh.vertex_markers = vector_from(arrays["vertex_markers"].cast<Input_array<int>>());
    CGAL::Given_mesh_details_2 details;
    const auto segments = arrays["segments"].cast<Input_array<std::int64_t>>();
    const std::size_t s = rows_of(segments, 2, "segments");
    for (std::size_t i = 0; i < s; ++i)
      details.segments.push_back({vertex_from(segments.at(i, 0)), vertex_from(segments.at(i, 1))});
    details.segment_markers = vector_from(arrays["segment_markers"].cast<Input_array<int>>());
    details.attributes = vector_from(arrays["attributes"].cast<Input_array<double>>());
    if (arrays["vertices_may_go"].cast<bool>())
      details.vertices = CGAL::Given_mesh_details_2::Vertices::FREE_INSIDE;
    details.is_input = vector_from(arrays["is_input"].cast<Input_array<char>>());
    graph = CGAL::pslg_from_mesh_2(mesh, details, given_triangle);
    name_origins(details, vector_from(arrays["segment_origins"].cast<Input_array<std::int32_t>>()));
  }

  /// In place of the numbers of the graph, which the user does not know.
  Segment_index origin(Segment_index s) const {
    const auto found = s.is_valid() ? origins.find(s.value()) : origins.end();
    return found == origins.end() ? Segment_index() : Segment_index(found->second);
  }

  /// Values for the user's triangles, as those of the triangles here; empty if there are none.
  /// \pre there are as many as the user has triangles
  std::vector<double> by_triangle(const std::vector<double>& values) const {
    std::vector<double> result;
    for (std::size_t t = 0; t < given_triangle.size() && !values.empty(); ++t)
      result.push_back(values[std::size_t(given_triangle[t])]);
    return result;
  }

private:
  void name_origins(const CGAL::Given_mesh_details_2& details, const std::vector<std::int32_t>& all) {
    std::map<std::array<Vertex_index, 2>, std::int32_t> of_edge;
    const auto key = [](std::array<Vertex_index, 2> ends) {
      if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
      return ends;
    };
    for (std::size_t i = 0; i < std::min(all.size(), details.segments.size()); ++i)
      of_edge.emplace(key(details.segments[i]), all[i]);
    for (const auto& edge : mesh.constrained_edges)
      if (const auto found = of_edge.find(key(edge.vertices)); found != of_edge.end() && found->second >= 0)
        origins.emplace(edge.segment.value(), found->second);
  }
};

/// Per vertex of the new mesh, three of the old one and their weights.
void add_transfer(py::dict& result, const CGAL::Mesh_transfer_2& transfer, const Given_mesh& old) {
  std::vector<std::array<std::int32_t, 3>> sources;
  std::vector<std::array<double, 3>> weights;
  for (std::size_t v = 0; v < transfer.places.size(); ++v) {
    if (const Vertex_index before = transfer.old_vertex[v]; before.is_valid()) {
      const auto i = static_cast<std::int32_t>(before.value());
      sources.push_back({i, i, i}), weights.push_back({1, 0, 0});
      continue;
    }
    const auto& corners = old.triangles[std::size_t(transfer.places[v].triangle)];
    sources.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) sources.back()[k] = static_cast<std::int32_t>(corners[k].value());
    weights.push_back(transfer.places[v].weights);
  }
  result["old_vertices"] = array_of_rows<std::int32_t>(transfer.old_vertex).attr("ravel")();
  result["sources"] = array_of_rows<std::int32_t>(std::move(sources));
  result["weights"] = array_of_rows<double>(std::move(weights));
}

/// Refines a mesh, or adapts it to sizes.
/// \param arrays of the mesh; `areas` of triangles and `sizes` at vertices may be empty
/// \param values as for `mesh_graph()`, and `coarsens`
py::dict adapt_mesh(const py::dict& arrays, const py::dict& values) {
  Run_state state;
  const Given_arrays given(arrays);
  CGAL::Quality_mesh_options_2 options = options_from(values, nullptr).progress(std::ref(state));
  std::optional<Refinement_criterion> criterion;
  if (!values["refine_where"].is_none()) {
    criterion.emplace(py::reinterpret_borrow<py::object>(values["refine_where"]), state, std::nullopt);
    options.refine_where(std::ref(*criterion));
  }
  const auto areas = given.by_triangle(vector_from(arrays["areas"].cast<Input_array<double>>()));
  const auto sizes = vector_from(arrays["sizes"].cast<Input_array<double>>());
  if (!sizes.empty()) {
    const CGAL::Mesh_sizing_field_2 field(given.mesh, sizes);
    options.size([field, others = options.size()](double x, double y) {
      return others ? std::min(field(x, y), others(x, y)) : field(x, y);
    });
  }
  const bool coarsens = values["coarsens"].cast<bool>();
  const Thread_bound bound(values["threads"].cast<std::size_t>());
  CGAL::Adapted_mesh_2 made;
  run_watched(state, values["progress"], [&] {
    using Tag = CGAL::Parallel_tag;
    made = coarsens        ? CGAL::adapt_mesh_2<Tag>(given.mesh, given.graph, options)
           : areas.empty() ? CGAL::refine_mesh_2<Tag>(given.mesh, given.graph, options)
                           : CGAL::refine_mesh_2<Tag>(given.mesh, given.graph, areas, options);
  });
  if (criterion) criterion->throw_error();
  for (auto& edge : made.mesh.constrained_edges) edge.segment = given.origin(edge.segment);
  for (Segment_index& s : made.mesh.segment_of_vertex) s = given.origin(s);
  for (auto& unmet : made.report.unmet_triangles) unmet.segment = given.origin(unmet.segment);
  for (int& r : made.mesh.region_of_triangle)
    r = static_cast<int>(given.graph.regions[static_cast<std::size_t>(r)].attribute);
  std::vector<std::uint8_t> is_input;
  for (const Vertex_index i : made.mesh.input_index) is_input.push_back(i.is_valid() ? 1 : 0);
  py::dict result = arrays_of_mesh(std::move(made.mesh));
  if (!is_input.empty()) result["is_input"] = array_of(std::move(is_input)).attr("astype")("bool");
  add_transfer(result, made.transfer, given.mesh);
  result["report"] = values_of_report(made.report);
  result["report"]["projection"] = py::none();
  return result;
}

} // namespace

void define_adaptation(py::module_& module) {
  module.def("adapt_mesh", &adapt_mesh, py::arg("arrays"), py::arg("options"));
}

} // namespace quadtree_mesh_python
