// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "arrays.h"
#include "definitions.h"
#include "graph_options.h"
#include "graph_results.h"
#include "report_names.h"
#include "watched_run.h"

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/mesh_in_projection_2.h>
#include <CGAL/repair_pslg_2.h>
#include <CGAL/tags.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Meshes of graphs. quadtree_mesh.meshing documents what goes in and out.

namespace quadtree_mesh_python {

namespace {

using Graph = CGAL::Pslg_2<Point>;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Mesher = CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
using Options = CGAL::Quality_mesh_options_2;
using Projection = CGAL::Conformal_projection_2;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Vertex_index;
static_assert(sizeof(Vertex_index) == sizeof(std::int32_t), "invalid indices are shown as -1");

// --- Graphs from arrays ---

/// Indices that are none would become other ones when they are cut to 32 bits.
void add_segments(Graph& graph, const Input_array<std::int64_t>& segments) {
  const std::size_t m = rows_of(segments, 2, "segments");
  const auto n = static_cast<std::int64_t>(graph.vertices.size());
  const std::int64_t* ends = segments.data();
  graph.segments.reserve(m);
  for (std::size_t s = 0; s < m; ++s, ends += 2) {
    for (int k = 0; k < 2; ++k)
      if (ends[k] < 0 || ends[k] >= n)
        throw CGAL::Pslg_error_2(CGAL::Pslg_error_2::Kind::NO_SUCH_VERTEX,
                                 "segment " + std::to_string(s) + " ends at vertex " +
                                     std::to_string(ends[k]) + ", but there are " + std::to_string(n) +
                                     " vertices",
                                 CGAL::Pslg_parts_2().segment(Segment_index(s)));
    graph.add_segment(Vertex_index(ends[0]), Vertex_index(ends[1]));
  }
}

Graph graph_from(const py::dict& arrays) {
  Graph graph;
  graph.vertices = points_from(arrays["vertices"].cast<Input_array<double>>(), "vertices");
  add_segments(graph, arrays["segments"].cast<Input_array<std::int64_t>>());
  graph.vertex_markers = vector_from(arrays["vertex_markers"].cast<Input_array<int>>());
  graph.segment_markers = vector_from(arrays["segment_markers"].cast<Input_array<int>>());
  graph.holes = points_from(arrays["holes"].cast<Input_array<double>>(), "holes");
  const auto regions = arrays["regions"].cast<Input_array<double>>();
  const std::size_t r = rows_of(regions, 4, "regions");
  const double* row = regions.data();
  for (std::size_t i = 0; i < r; ++i, row += 4)
    graph.regions.push_back({Point(row[0], row[1]), row[2], row[3]});
  return graph;
}

// --- Results ---

py::dict values_of(CGAL::Pslg_repair_report_2 report) {
  py::dict result;
  result["merged_vertices"] = report.merged_vertices;
  result["zero_length_segments"] = report.zero_length_segments;
  result["overlapping_segments"] = report.overlapping_segments;
  result["split_segments"] = report.split_segments;
  result["crossings"] = report.crossings;
  result["vertex_map"] = array_of_rows<std::int32_t>(std::move(report.vertex_map)).attr("ravel")();
  result["segment_origins"] = array_of_rows<std::int32_t>(std::move(report.segment_origin)).attr("ravel")();
  return result;
}

py::dict values_of(const Projection& projection, const CGAL::Projected_mesh_2<Point>& made) {
  py::dict result;
  result["name"] = report_words::name(projection.kind());
  result["central_longitude"] = projection.central_longitude();
  result["standard_parallels"] =
      py::make_tuple(projection.standard_parallels()[0], projection.standard_parallels()[1]);
  result["split_vertices"] = made.split_vertices;
  result["rounds"] = made.rounds;
  result["bent_triangles"] = made.bent_triangles;
  return result;
}

// --- Meshing ---

/// Meshes the graph. If segments cross and crossings may be split, meshes the repaired one.
class Graph_run {
public:
  /// \param options in the plane of the projection, if there is one
  /// \param min_angle the bound that is to hold in degrees then
  Graph_run(Graph graph, Options options, bool may_repair, const std::optional<Projection>& projection,
            double min_angle)
      : graph_(std::move(graph)), mesher_(std::move(options)), may_repair_(may_repair),
        projection_(projection), min_angle_(min_angle) {}

  void operator()() {
    try {
      mesh();
    } catch (const CGAL::Pslg_error_2& error) {
      if (!may_repair_ || error.kind() != CGAL::Pslg_error_2::Kind::CROSSING) throw;
      repair_.emplace();
      graph_ = CGAL::repair_pslg_2(
          graph_, CGAL::Pslg_repair_options_2().crossings(CGAL::Pslg_crossing_rule_2::SPLIT), *repair_);
      mesh();
    }
  }

  py::dict result() {
    std::vector<Projection::Place> places;
    std::vector<double> scales;
    if (projection_)
      for (const Point& p : mesh_.points) {
        places.push_back(projection_->forward(p.x(), p.y()));
        scales.push_back(projection_->scale(p.y()));
      }
    py::dict result = arrays_of_mesh(std::move(mesh_));
    if (projection_) {
      result["places"] = array_of_rows<double>(std::move(places));
      result["scales"] = array_of(std::move(scales));
    }
    py::dict report = values_of_report(mesher_.report());
    report["projection"] = py::none();
    if (projection_) {
      report["projection"] = values_of(*projection_, projected_);
      report["is_met"] = mesher_.report().is_met() && projected_.bent_triangles == 0;
    }
    result["report"] = report;
    result["repair"] = repair_ ? py::object(values_of(std::move(*repair_))) : py::object(py::none());
    return result;
  }

private:
  Graph graph_;
  Mesher mesher_;
  bool may_repair_;
  std::optional<Projection> projection_;
  double min_angle_;
  CGAL::Projected_mesh_2<Point> projected_;
  Mesh mesh_;
  std::optional<CGAL::Pslg_repair_report_2> repair_;

  void mesh() {
    if (!projection_) {
      mesh_ = mesher_(graph_);
      return;
    }
    const Options& options = mesher_.options();
    double size = std::numeric_limits<double>::infinity();
    if (options.max_edge() > 0) size = options.max_edge();
    if (options.max_area() > 0) size = std::min(size, std::sqrt(options.max_area()));
    mesh_ = CGAL::mesh_in_projection_2(
        graph_, *projection_, [this](const Graph& meters) { return mesh_in_plane(meters); }, min_angle_,
        projected_, 1e-3 * size);
  }

  /// Indices of errors are those of vertices and pieces of segments in the plane.
  Mesh mesh_in_plane(const Graph& meters) try {
    return mesher_(meters);
  } catch (const CGAL::Pslg_error_2& error) {
    throw CGAL::Pslg_error_2(
        error.kind() == CGAL::Pslg_error_2::Kind::CROSSING ? CGAL::Pslg_error_2::Kind::TOO_NEAR
                                                           : error.kind(),
        "in meters of the projection, which project='none' leaves out: " + std::string(error.what()));
  }
};

/// \param values options of the mesher by name, and `repair`, `threads`, `progress`, `refine_where`
py::dict mesh_graph(const py::dict& arrays, const py::dict& values) {
  Run_state state;
  Graph graph = graph_from(arrays);
  const std::optional<Projection> projection = projection_for(graph, values["project"].cast<std::string>());
  Options options = options_from(values, projection ? &*projection : nullptr).progress(std::ref(state));
  std::optional<Refinement_criterion> criterion;
  if (!values["refine_where"].is_none()) {
    criterion.emplace(py::reinterpret_borrow<py::object>(values["refine_where"]), state, projection);
    options.refine_where(std::ref(*criterion));
  }
  Graph_run run(std::move(graph), std::move(options), values["repair"].cast<bool>(), projection,
                values["min_angle"].cast<double>());
  const Thread_bound bound(values["threads"].cast<std::size_t>());
  run_watched(state, values["progress"], std::ref(run));
  if (criterion) criterion->throw_error();
  return run.result();
}

/// The convex hull's corners, counterclockwise.
py::array_t<std::int32_t> convex_hull(const Input_array<double>& array) {
  const std::vector<Point> points = points_from(array, "points");
  std::map<std::array<double, 2>, std::int32_t> index;
  for (std::size_t i = points.size(); i-- > 0;)
    index[{points[i].x(), points[i].y()}] = static_cast<std::int32_t>(i);
  std::vector<Point> corners;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(corners));
  std::vector<std::int32_t> result;
  for (const Point& p : corners) result.push_back(index[{p.x(), p.y()}]);
  return array_of(std::move(result));
}

} // namespace

void define_graphs(py::module_& module) {
  module.def("mesh_graph", &mesh_graph, py::arg("arrays"), py::arg("options"));
  module.def("convex_hull", &convex_hull, py::arg("points"));
}

} // namespace quadtree_mesh_python
