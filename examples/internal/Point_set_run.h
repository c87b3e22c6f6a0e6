#ifndef QUADTREE_MESH_2_EXAMPLES_POINT_SET_RUN_H
#define QUADTREE_MESH_2_EXAMPLES_POINT_SET_RUN_H

// What a run of quality_mesh made of points, in words for people and in JSON for programs.

#include "Meshing_run.h"
#include "command_line.h"
#include "mesh_figures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/point_set_lengths_2.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

/// Which angles a mesh may have, in degrees.
struct Angle_promise {
  double least = 0, largest = 180;
  bool is_acute = false; ///< all below 90, by an exact test
};

inline Angle_promise angle_promise(Command_line::Mode mode, const CGAL::Point_set_mesh_options_2& options) {
  switch (mode) {
  case Command_line::Mode::BOUNDED:
    return {options.least_angle_in_degrees(), options.largest_angle_in_degrees()};
  case Command_line::Mode::ACUTE:
    return {0, 90, true};
  case Command_line::Mode::WARPED:
    return {22.47, 112.63};
  case Command_line::Mode::POINTS:
  case Command_line::Mode::PSLG:
    break;
  }
  return {20.7, 180};
}

struct Point_set_run {
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  struct Unmet_triangle {
    std::size_t triangle;
    std::array<double, 2> centroid;
    double least_angle, largest_angle; ///< degrees
  };

  Command_line::Mode mode = Command_line::Mode::POINTS;
  const char* domain = "";
  Angle_promise promise;
  CGAL::Pslg_2<Point_2> input; ///< points alone
  CGAL::Indexed_mesh_2<Point_2> mesh;
  CGAL::Point_set_mesh_report_2 report;
  /// What the checker says, and the angles once more, counted by neither it nor the mesher.
  CGAL::Mesh_quality_2 quality;
  Mesh_figures ours;
  std::vector<Unmet_triangle> unmet_triangles;
  std::optional<CGAL::Point_set_lengths_2> lengths;
  bool is_peer_asked = false;
  std::optional<Mesh_figures> peer; ///< Mesh_2 in the same box; nothing if it gave no mesh

  unsigned threads = 1;
  Seconds read_seconds;
  Seconds write_seconds;
  double peak_memory_mb = 0;

  double triangles_per_point() const {
    return static_cast<double>(ours.triangles) /
           static_cast<double>(input.vertices.size() - report.merged_points); // there is a point
  }
};

/// Whether all angles are as promised, so that the exit status is 0.
inline bool is_bound_met(const Point_set_run& run) {
  return run.report.is_met() && run.unmet_triangles.empty() && !run.report.is_cancelled;
}

/// Finds the angles of the mesh, and the triangles that break the promise.
inline void count_angles(Point_set_run& run) {
  constexpr double rounding = 1e-9;
  Mesh_figures_builder all(run.ours, run.promise.least);
  for (std::size_t t = 0; t < run.mesh.triangles.size(); ++t) {
    const auto& [u, v, w] = run.mesh.triangles[t];
    const auto &a = run.mesh.point(u), &b = run.mesh.point(v), &c = run.mesh.point(w);
    all.add_triangle(a, b, c);
    Mesh_figures one;
    Mesh_figures_builder(one, run.promise.least).add_triangle(a, b, c);
    const bool is_acute = CGAL::angle(a, b, c) == CGAL::ACUTE && CGAL::angle(b, c, a) == CGAL::ACUTE &&
                          CGAL::angle(c, a, b) == CGAL::ACUTE;
    if (one.below_bound > 0 || one.max_angle > run.promise.largest + rounding ||
        (run.promise.is_acute && !is_acute))
      run.unmet_triangles.push_back(
          {t, {(a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3}, one.min_angle, one.max_angle});
  }
}

namespace point_set_run_internal {

/// `a / b`; null in JSON, and a dash on the screen, where there is none.
inline std::optional<double> ratio(double a, double b) {
  return b > 0 ? std::optional<double>(a / b) : std::nullopt;
}

inline nlohmann::ordered_json json_of(std::optional<double> number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

inline nlohmann::ordered_json lengths_json(const Point_set_run& run) {
  const CGAL::Point_set_lengths_2& lengths = *run.lengths;
  return {{"mesh", run.quality.total_length},
          {"least", lengths.least_mesh()},
          {"ratio", json_of(ratio(run.quality.total_length, lengths.least_mesh()))},
          {"spanning_tree", lengths.spanning_tree},
          {"hull", lengths.hull},
          {"delaunay", lengths.delaunay}};
}

inline void print_lengths(const Point_set_run& run) {
  const CGAL::Point_set_lengths_2& lengths = *run.lengths;
  const auto print = [&](const char* name, double length) {
    const std::optional<double> times = ratio(run.quality.total_length, length);
    std::printf("%-28s%14.6g", name, length);
    if (times) std::printf("  (the mesh has %.3f times that)", *times);
    std::printf("\n");
  };
  std::printf("%-28s%14.6g\n", "length of all edges", run.quality.total_length);
  print("  least of any mesh", lengths.least_mesh());
  print("  minimum spanning tree", lengths.spanning_tree);
  print("  convex hull", lengths.hull);
  print("  Delaunay triangulation", lengths.delaunay);
}

inline void print_unmet(const Point_set_run& run) {
  constexpr std::size_t max_lines = 10;
  const auto& unmet = run.unmet_triangles;
  for (std::size_t i = 0; i < unmet.size() && i < max_lines; ++i)
    std::printf("unmet: angles from %.2f to %.2f in the triangle at (%.17g, %.17g)\n", unmet[i].least_angle,
                unmet[i].largest_angle, unmet[i].centroid[0], unmet[i].centroid[1]);
  if (unmet.size() > max_lines) std::printf("unmet: %zu more\n", unmet.size() - max_lines);
}

inline std::string words_for(const Angle_promise& promise) {
  if (promise.is_acute) return "all below 90 degrees";
  char text[64];
  if (promise.largest < 180)
    std::snprintf(text, sizeof text, "from %g to %g degrees", promise.least, promise.largest);
  else
    std::snprintf(text, sizeof text, "at least %g degrees", promise.least);
  return text;
}

} // namespace point_set_run_internal

/// \param kind of time, that of `phases`
inline nlohmann::ordered_json seconds_json(const Point_set_run& run,
                                           const CGAL::Point_set_mesh_report_2::Seconds& phases,
                                           double Seconds::*kind) {
  const double read = run.read_seconds.*kind, mesh = run.ours.seconds.*kind, write = run.write_seconds.*kind;
  return {{"read", read},
          {"quadtree", phases.quadtree},
          {"separate", phases.separate},
          {"coarsen", phases.coarsen},
          {"convert", phases.convert},
          {"write", write},
          {"mesh", mesh},
          {"total", read + mesh + write}};
}

inline nlohmann::ordered_json run_json(const Point_set_run& run) {
  using namespace point_set_run_internal;
  const CGAL::Point_set_mesh_report_2& report = run.report;
  nlohmann::ordered_json json = {{"mode", name(run.mode)},
                                 {"domain", run.domain},
                                 {"input_points", run.input.vertices.size()},
                                 {"merged_points", report.merged_points},
                                 {"vertices", run.quality.vertices},
                                 {"triangles", run.quality.triangles},
                                 {"triangles_per_point", run.triangles_per_point()},
                                 {"triangles_before_coarsening", report.triangles_before_coarsening},
                                 {"min_angle", run.ours.min_angle},
                                 {"max_angle", run.ours.max_angle},
                                 {"promised_angles", {run.promise.least, run.promise.largest}},
                                 {"unmet_triangles", run.unmet_triangles.size()},
                                 {"thin_triangles", report.thin_triangles},
                                 {"clusters", report.clusters},
                                 {"certified_points", report.certified_points},
                                 {"rounds", report.rounds},
                                 {"angle_histogram", run.quality.angle_histogram},
                                 {"threads", run.threads},
                                 {"seconds", seconds_json(run, report.seconds, &Seconds::cpu)},
                                 {"wall_seconds", seconds_json(run, report.wall_seconds, &Seconds::wall)},
                                 {"peak_memory_mb", run.peak_memory_mb}};
  for (const auto& unmet : run.unmet_triangles)
    json["unmet"].push_back({{"triangle", run.input.first_number + unmet.triangle},
                             {"x", unmet.centroid[0]},
                             {"y", unmet.centroid[1]},
                             {"least_angle", unmet.least_angle},
                             {"largest_angle", unmet.largest_angle}});
  if (run.lengths) json["lengths"] = lengths_json(run);
  if (run.is_peer_asked) json["mesh_2"] = run.peer ? peer_json(*run.peer) : nlohmann::ordered_json(nullptr);
  return json;
}

inline void print_run(const Point_set_run& run) {
  using meshing_run_internal::print_line;
  const auto theirs = [&run](auto member) {
    using Number = std::decay_t<decltype((*run.peer).*member)>;
    return run.peer ? std::optional<Number>((*run.peer).*member) : std::nullopt;
  };
  const auto print_ours = [](const char* name, std::size_t number) {
    print_line(name, "%14zu", number, std::optional<std::size_t>());
  };
  std::printf("input: %zu points, %zu merged; domain: %s; angles: %s\n", run.input.vertices.size(),
              run.report.merged_points, run.domain, point_set_run_internal::words_for(run.promise).c_str());
  if (run.peer) std::printf("%-28s%14s%14s\n", "", "quality_mesh", "CGAL Mesh_2");
  print_line("vertices", "%14zu", run.ours.vertices, theirs(&Mesh_figures::vertices));
  print_line("triangles", "%14zu", run.ours.triangles, theirs(&Mesh_figures::triangles));
  print_line("triangles per point", "%14.3f", run.triangles_per_point(), std::optional<double>());
  print_line("least angle", "%14.2f", run.ours.min_angle, theirs(&Mesh_figures::min_angle));
  print_line("largest angle", "%14.2f", run.ours.max_angle, theirs(&Mesh_figures::max_angle));
  print_ours("triangles out of range", run.unmet_triangles.size());
  if (run.mode == Command_line::Mode::ACUTE) print_ours("clusters", run.report.clusters);
  if (run.mode == Command_line::Mode::ACUTE || run.mode == Command_line::Mode::BOUNDED) {
    print_ours("certified points", run.report.certified_points);
    print_ours("rounds", run.report.rounds);
  }
  meshing_run_internal::print_seconds(run);
  const CGAL::Point_set_mesh_report_2::Seconds& seconds = run.report.seconds;
  std::printf("  quadtree %.3f, separate %.3f, coarsen %.3f, convert %.3f\n", seconds.quadtree,
              seconds.separate, seconds.coarsen, seconds.convert);
  if (run.is_peer_asked && !run.peer) std::printf("CGAL Mesh_2 gave no mesh\n");
  if (run.lengths) point_set_run_internal::print_lengths(run);
  point_set_run_internal::print_unmet(run);
}

#endif // QUADTREE_MESH_2_EXAMPLES_POINT_SET_RUN_H
