#include "projected_graph.h"

#include "degrees.h"

#include <CGAL/Pslg_error_2.h>
#include <CGAL/mesh_in_projection_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace projected_graph {

namespace {

bool is_in_degrees(const Pslg& graph, double west, double east) {
  return !graph.vertices.empty() &&
         std::all_of(graph.vertices.begin(), graph.vertices.end(),
                     [=](const Point& p) { return degrees::is_in_range(p, west, east); });
}

/// GeoJSON has longitudes and latitudes (RFC 7946, section 4) unless its author departs from the standard, which larger
/// numbers show.
bool is_known_to_be_in_degrees(const Pslg& graph, CGAL::Coordinate_system_2 coordinates,
                               const Command_line& line) {
  if (coordinates == CGAL::Coordinate_system_2::DEGREES) return true;
  return input_format(line.input) == Input_format::GEOJSON && is_in_degrees(graph, -360, 360);
}

CGAL::Conformal_projection_2 projection_of(const Pslg& graph, Command_line::Project wanted) {
  using Projection = CGAL::Conformal_projection_2;
  const Projection::Box box = CGAL::box_in_degrees(graph);
  const Projection result = wanted == Command_line::Project::MERCATOR  ? Projection::mercator(box)
                            : wanted == Command_line::Project::LAMBERT ? Projection::lambert(box)
                                                                       : Projection::for_box(box);
  if (std::abs(result.cone_constant()) * (box.high[0] - box.low[0]) >= 360)
    throw std::runtime_error("the graph goes around the pole, where its two ends would meet");
  return result;
}

} // namespace

bool may_be_in_degrees(const Pslg& graph) {
  const auto& all = graph.vertices;
  return !all.empty() &&
         std::all_of(all.begin(), all.end(), [](const Point& p) { return degrees::is_in_range(p); }) &&
         std::any_of(all.begin(), all.end(), [](const Point& p) { return degrees::is_far_from_equator(p); });
}

std::optional<Run> projection(const Pslg& graph, CGAL::Coordinate_system_2 coordinates,
                              const Command_line& line) try {
  using Project = Command_line::Project;
  if (line.project == Project::NONE ||
      (line.project == Project::BY_FORMAT && !is_known_to_be_in_degrees(graph, coordinates, line)))
    return std::nullopt;
  const CGAL::Conformal_projection_2 projection = projection_of(graph, line.project);
  const auto box = CGAL::box_in_degrees(graph);
  return Run{projection, projection.scale_range(box.low[1], box.high[1]), {}, {}, {}};
} catch (const std::exception& error) {
  throw std::runtime_error(
      std::string(error.what()) +
      "; if coordinates are not degrees, or are to be meshed as they are, use --project none");
}

Mesh mesh(const Pslg& graph, const std::function<Mesh(const Pslg&)>& mesher, const Options& options,
          Run& run) {
  double size = std::numeric_limits<double>::infinity();
  if (options.max_edge() > 0) size = options.max_edge();
  if (options.max_area() > 0) size = std::min(size, std::sqrt(options.max_area()));
  CGAL::Projected_mesh_2<Point> report;
  Mesh result =
      CGAL::mesh_in_projection_2(graph, run.projection, mesher, options.min_angle(), report, size * 1e-3);
  run.graph = std::move(report.graph);
  run.mesh = run.images = std::move(report.mesh);
  run.images.points = std::move(report.images);
  run.split_vertices = report.split_vertices;
  run.rounds = report.rounds;
  run.bent_triangles = report.bent_triangles;
  return result;
}

} // namespace projected_graph
