// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "arrays.h"
#include "definitions.h"
#include "report_names.h"
#include "sizes.h"
#include "watched_run.h"

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Mesh_sizing_field_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/mesh_in_projection_2.h>
#include <CGAL/pslg_from_mesh_2.h>
#include <CGAL/refine_mesh_2.h>
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
using Report = CGAL::Quality_mesh_report_2;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Triangle_index;
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

// --- Options ---

template <class Value>
Value named(const std::map<std::string, Value>& values, const std::string& name, const char* what) {
  const auto found = values.find(name);
  if (found != values.end()) return found->second;
  std::string text = std::string(what) + " must be one of";
  for (const auto& value : values) text += " '" + value.first + "'";
  throw std::invalid_argument(text + ", not '" + name + "'");
}

using Projection = CGAL::Conformal_projection_2;

/// The projection that is wanted by name, of a graph in degrees.
std::optional<Projection> projection_for(const Graph& graph, const std::string& name) {
  using Choice = Projection (*)(const Projection::Box&);
  const Choice choice =
      named<Choice>({{"none", nullptr},
                     {"auto", &Projection::for_box},
                     {"mercator", [](const Projection::Box& b) { return Projection::mercator(b); }},
                     {"lambert", [](const Projection::Box& b) { return Projection::lambert(b); }}},
                    name, "project");
  if (choice == nullptr) return std::nullopt;
  const Projection::Box box = CGAL::box_in_degrees(graph);
  const Projection projection = choice(box);
  if (std::abs(projection.cone_constant()) * (box.high[0] - box.low[0]) >= 360)
    throw std::invalid_argument(
        "the graph goes around the pole, where its two ends would meet in the projection");
  return projection;
}

/// \param projection in whose plane they are to hold; null: none
Options options_from(const py::dict& values, const Projection* projection) {
  Options options;
  options.min_angle(values["min_angle"].cast<double>())
      .max_area(values["max_area"].cast<double>())
      .max_edge(values["max_edge"].cast<double>())
      .min_edge(values["min_edge"].cast<double>())
      .gradation(values["gradation"].cast<double>())
      .max_edge_ratio(values["max_edge_ratio"].cast<double>())
      .max_angle(values["max_angle"].cast<double>())
      .size(least_size(values["size"].cast<py::list>(), projection))
      .smooth(values["smooth"].cast<int>())
      .thin(values["thin"].cast<int>())
      .max_vertices(values["max_vertices"].cast<std::size_t>());
  if (!values["max_steiner"].is_none())
    options.max_steiner_vertices(values["max_steiner"].cast<std::size_t>());
  if (values["conforming"].cast<bool>()) options.conform(Options::Conforming::DELAUNAY);
  options.keep_borders(named<Options::Keep_borders>({{"none", Options::Keep_borders::NONE},
                                                     {"boundary", Options::Keep_borders::BOUNDARY},
                                                     {"marked", Options::Keep_borders::MARKED},
                                                     {"all", Options::Keep_borders::ALL}},
                                                    values["keep_borders"].cast<std::string>(),
                                                    "keep_borders"));
  options.coarsen(values["coarsen"].cast<bool>() ? Options::Coarsening::GUARDED_REMOVAL
                                                 : Options::Coarsening::NONE);
  options.mesh_domain(named<Options::Domain>({{"enclosed", Options::Domain::ENCLOSED},
                                              {"marked", Options::Domain::MARKED},
                                              {"parity", Options::Domain::NESTING_PARITY}},
                                             values["domain"].cast<std::string>(), "domain"));
  options.separate(named<Options::Separation>(
      {{"on_demand", Options::Separation::ON_DEMAND}, {"theorem_5", Options::Separation::THEOREM_5}},
      values["separation"].cast<std::string>(), "separation"));
  return projection != nullptr ? CGAL::options_in_projection_2(std::move(options)) : options;
}

/// The user's criterion in Python. The mesher's threads call it one after the other, each with Python's lock. After an
/// exception it is not called again.
class Refinement_criterion {
public:
  /// \param projection in whose plane triangles are, while the function gets degrees
  Refinement_criterion(py::object function, Run_state& state, const std::optional<Projection>& projection)
      : function_(std::move(function)), state_(state), projection_(projection) {}

  bool operator()(Options::Corners corners) {
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
  std::optional<Projection> projection_;
  std::optional<py::error_already_set> error_;
};

// --- Results ---

py::dict arrays_of(Mesh made) {
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

py::dict seconds_of(const Report::Seconds& seconds) {
  return py::dict(py::arg("quadtree") = seconds.quadtree, py::arg("first_mesh") = seconds.first_mesh,
                  py::arg("trees") = seconds.trees, py::arg("construct") = seconds.construct,
                  py::arg("refine") = seconds.refine, py::arg("coarsen") = seconds.coarsen,
                  py::arg("convert") = seconds.convert);
}

py::dict values_of(const Report& report) {
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
    py::dict result = arrays_of(std::move(mesh_));
    if (projection_) {
      result["places"] = array_of_rows<double>(std::move(places));
      result["scales"] = array_of(std::move(scales));
    }
    py::dict report = values_of(mesher_.report());
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

// --- Meshes that exist ---

Vertex_index vertex_from(std::int64_t i) {
  return i >= 0 && i < std::int64_t(std::numeric_limits<std::uint32_t>::max()) ? Vertex_index(i)
                                                                               : Vertex_index();
}

/// A mesh that is given, and what it is a mesh of.
struct Given_arrays {
  Mesh mesh;
  Graph graph;
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
    graph = CGAL::pslg_from_mesh_2(mesh, details);
    name_origins(details, vector_from(arrays["segment_origins"].cast<Input_array<std::int32_t>>()));
  }

  /// In place of the numbers of the graph, which the user does not know.
  Segment_index origin(Segment_index s) const {
    const auto found = s.is_valid() ? origins.find(s.value()) : origins.end();
    return found == origins.end() ? Segment_index() : Segment_index(found->second);
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
void add_transfer(py::dict& result, const CGAL::Mesh_transfer_2& transfer, const Mesh& old) {
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
  Options options = options_from(values, nullptr).progress(std::ref(state));
  std::optional<Refinement_criterion> criterion;
  if (!values["refine_where"].is_none()) {
    criterion.emplace(py::reinterpret_borrow<py::object>(values["refine_where"]), state, std::nullopt);
    options.refine_where(std::ref(*criterion));
  }
  const auto areas = vector_from(arrays["areas"].cast<Input_array<double>>());
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
  py::dict result = arrays_of(std::move(made.mesh));
  if (!is_input.empty()) result["is_input"] = array_of(std::move(is_input)).attr("astype")("bool");
  add_transfer(result, made.transfer, given.mesh);
  result["report"] = values_of(made.report);
  result["report"]["projection"] = py::none();
  return result;
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
  module.def("adapt_mesh", &adapt_mesh, py::arg("arrays"), py::arg("options"));
  module.def("convex_hull", &convex_hull, py::arg("points"));
}

} // namespace quadtree_mesh_python
