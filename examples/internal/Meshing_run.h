#ifndef QUADTREE_MESH_2_EXAMPLES_MESHING_RUN_H
#define QUADTREE_MESH_2_EXAMPLES_MESHING_RUN_H

// What a run of quality_mesh made, in words for people and in JSON for programs.

#include "Figures_table.h"
#include "degrees.h"
#include "mesh_figures.h"
#include "projected_graph.h"
#include "report_json.h"
#include "report_words.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/repair_pslg_2.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct Meshing_run {
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

  CGAL::Pslg_2<Point_2> pslg;                         ///< what is meshed: as read, or repaired
  std::optional<CGAL::Indexed_mesh_2<Point_2>> given; ///< a mesh of it, to be refined
  std::vector<double> areas;                          ///< bounds for its triangles; empty: none
  std::size_t kept_vertices = 0; ///< how many of the first vertices of the refined mesh are its
  std::optional<CGAL::Pslg_repair_report_2> repair;
  std::optional<projected_graph::Run> projected; ///< of a graph in degrees
  bool may_be_in_degrees = false; ///< the coordinates may be longitudes and latitudes, meshed as they are
  CGAL::Indexed_mesh_2<Point_2> mesh;
  CGAL::Quality_mesh_report_2 report;
  /// The angles and what is unmet, counted by the checker and not by the mesher.
  CGAL::Mesh_quality_2 quality;
  Mesh_figures ours;
  bool is_peer_asked = false;
  std::optional<Mesh_figures> peer; ///< Mesh_2 on the same input; nothing if it gave no mesh
  std::optional<Mesh_figures>
      other; ///< our other separation on it, if the peer is asked; nothing if it gave no mesh
  std::string why_no_other;

  unsigned threads = 1;
  Seconds read_seconds;
  Seconds write_seconds;
  double peak_memory_mb = 0;
};

/// Whether all bounds are met, so that the exit status is 0.
inline bool is_bound_met(const Meshing_run& run) {
  return run.report.is_met() && (!run.projected || run.projected->bent_triangles == 0) &&
         run.quality.is_met() && !run.report.is_budget_exhausted && !run.report.is_cancelled;
}

namespace meshing_run_internal {

using report_words::name;

inline void print_repair(const CGAL::Pslg_repair_report_2& repair) {
  std::printf("repaired: crossings: %zu, merged vertices: %zu; segments split: %zu, overlapping: %zu, of "
              "length 0: %zu\n",
              repair.crossings, repair.merged_vertices, repair.split_segments, repair.overlapping_segments,
              repair.zero_length_segments);
}

inline void print_projection(const projected_graph::Run& run) {
  const auto& projection = run.projection;
  std::printf("projection: %s, central longitude %.6g, ", name(projection.kind()),
              projection.central_longitude());
  const auto& parallels = projection.standard_parallels();
  if (projection.kind() == CGAL::Conformal_projection_2::Kind::LAMBERT)
    std::printf("standard parallels %.6g and %.6g", parallels[0], parallels[1]);
  else
    std::printf("true to scale at latitude %.6g", parallels[0]);
  std::printf(" (sphere);\n            scale from %.5f to %.5f; sizes in meters; vertices added to long "
              "segments: %zu; "
              "meshed %zu times;\n            triangles on their other side in degrees: 0\n",
              run.scale_range[0], run.scale_range[1], run.split_vertices, run.rounds);
}

/// What markers or attributes are called, the first of them.
inline void print_names(const char* what, const std::vector<std::string>& names) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  constexpr std::size_t most = 10;
  if (names.empty()) return;
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < most; ++i)
    list += (i > 0 ? ", " : "") + std::to_string(i + 1) + ' ' + internal::printable(names[i], 40);
  if (names.size() > most) list += ", and " + std::to_string(names.size() - most) + " more";
  std::printf("%s: %s\n", what, list.c_str());
}

/// One line of the table: ours and, if Mesh_2 gave a mesh, its figure.
template <class Number>
void print_line(const char* name, const char* format, Number ours, std::optional<Number> theirs) {
  std::printf("%-28s", name);
  std::printf(format, ours);
  if (theirs) std::printf(format, *theirs);
  std::printf("\n");
}

/// Time by the clock is another one where there are threads.
/// \tparam Run has `ours`, `peer` and `threads`
template <class Run>
void print_seconds(const Run& run) {
  const auto print = [&](const char* name, double Seconds::*kind) {
    print_line(name, "%14.3f", run.ours.seconds.*kind,
               run.peer ? std::optional<double>(run.peer->seconds.*kind) : std::nullopt);
  };
  print("processor seconds", &Seconds::cpu);
  if (run.threads > 1) print("seconds by the clock", &Seconds::wall);
}

/// What our separations are called beside each other.
inline const char* name_of_way(CGAL::Quality_mesh_options_2::Separation way) {
  return way == CGAL::Quality_mesh_options_2::Separation::ON_DEMAND ? "on demand" : "by quadtrees";
}
inline CGAL::Quality_mesh_options_2::Separation other_way(CGAL::Quality_mesh_options_2::Separation way) {
  using Separation = CGAL::Quality_mesh_options_2::Separation;
  return way == Separation::ON_DEMAND ? Separation::THEOREM_5 : Separation::ON_DEMAND;
}

inline void print_figures(const Meshing_run& run, const CGAL::Quality_mesh_options_2& options) {
  std::vector<Figures_table::Column> columns{{name_of_way(options.separate()), run.ours}};
  if (run.is_peer_asked) {
    columns.push_back({name_of_way(other_way(options.separate())), run.other});
    columns.push_back({"CGAL Mesh_2", run.peer});
  }
  const Figures_table table(std::move(columns));
  table.print_names();
  table.print_count("vertices", &Mesh_figures::vertices);
  table.print_count("triangles", &Mesh_figures::triangles);
  table.print_angle("least angle", &Mesh_figures::min_angle);
  table.print_angle("largest angle", &Mesh_figures::max_angle);
  table.print_count("triangles below the bound", &Mesh_figures::below_bound);
  if (options.max_angle() > 0) table.print_count("triangles above the bound", &Mesh_figures::above_bound);
  print_line("  in acute input corners", "%14zu", run.quality.exempt_triangles, std::optional<std::size_t>());
  table.print_angle("least angle above the bound", &Mesh_figures::min_angle_of_others);
  table.print_seconds("processor seconds", &Seconds::cpu);
  if (run.threads > 1) table.print_seconds("seconds by the clock", &Seconds::wall);
}

inline void print_trees(const CGAL::Tree_separation_report_2& trees) {
  using End = CGAL::Tree_separation_report_2::End;
  if (trees.end == End::NONE) return;
  if (trees.has_taken_over) std::printf("quadtrees took over, as refinement did not come to rest\n");
  if (trees.islands > 0) std::printf("in %zu components of the domain, and nowhere else\n", trees.islands);
  if (trees.end == End::BUDGET)
    std::printf("quadtrees took more than their budget: refined on demand %s\n",
                trees.has_taken_over && trees.rounds > 0 ? "from there on" : "instead");
  print_line("construction by quadtrees", "%14s", name(trees.end), std::optional<const char*>());
  const auto print = [](const char* name, std::size_t n) {
    print_line(name, "%14zu", n, std::optional<std::size_t>());
  };
  print("leaves of T_B (points)", trees.leaves_of_points);
  print("leaves of T_B' (vertices)", trees.leaves_of_vertices);
  print("leaves of T_B'' (pieces)", trees.leaves_of_pieces);
  print("leaves of T_B* (edges)", trees.leaves_of_edges);
  print("rounds of placing", trees.rounds);
  print("triangles by quadtrees", trees.triangles);
  print("  below the bound", trees.missed_by_rule);
  print("  corners left out", trees.left_out);
  print("  corners moved", trees.relocated);
  print("  corners added", trees.added);
  print("  left to refinement", trees.missed);
  print("  left for want of room", trees.handed_over);
  print("windows at vertices", trees.windows);
  print("vertices placed", trees.placed);
  print("  in the mesh", trees.kept);
}

} // namespace meshing_run_internal

inline nlohmann::ordered_json peer_json(const Mesh_figures& peer) {
  return {{"vertices", peer.vertices},
          {"triangles", peer.triangles},
          {"min_angle", peer.min_angle},
          {"max_angle", peer.max_angle},
          {"triangles_below_bound", peer.below_bound},
          {"seconds", {{"mesh", peer.seconds.cpu}}},
          {"wall_seconds", {{"mesh", peer.seconds.wall}}}};
}

/// Names with their numbers; null if there are none.
inline nlohmann::ordered_json names_json(const std::vector<std::string>& names) {
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < names.size(); ++i) json[names[i]] = i + 1;
  return json;
}

/// What was cured before meshing; null if that was not asked for.
inline nlohmann::ordered_json repair_json(const std::optional<CGAL::Pslg_repair_report_2>& repair) {
  if (!repair) return nullptr;
  return {{"crossings", repair->crossings},
          {"merged_vertices", repair->merged_vertices},
          {"split_segments", repair->split_segments},
          {"overlapping_segments", repair->overlapping_segments},
          {"zero_length_segments", repair->zero_length_segments}};
}

/// \param kind of time, that of `phases`
inline nlohmann::ordered_json seconds_json(const Meshing_run& run,
                                           const CGAL::Quality_mesh_report_2::Seconds& phases,
                                           double Seconds::*kind) {
  return seconds_json(run.read_seconds.*kind, phases, run.ours.seconds.*kind, run.write_seconds.*kind);
}

/// How a graph in degrees was meshed; null if it was meshed as it is.
inline nlohmann::ordered_json projection_json(const std::optional<projected_graph::Run>& run) {
  if (!run) return nullptr;
  const auto& projection = run->projection;
  return {{"name", report_words::name(projection.kind())},
          {"central_longitude", projection.central_longitude()},
          {"standard_parallels", projection.standard_parallels()},
          {"cone_constant", projection.cone_constant()},
          {"earth_radius", projection.radius},
          {"scale_range", run->scale_range},
          {"split_vertices", run->split_vertices},
          {"rounds", run->rounds},
          {"bent_triangles", run->bent_triangles},
          {"inverted_triangles", 0}};
}

inline nlohmann::ordered_json run_json(const Meshing_run& run) {
  nlohmann::ordered_json json = {{"input_vertices", run.pslg.number_of_vertices()},
                                 {"input_segments", run.pslg.number_of_segments()},
                                 {"merged_vertices", run.report.merged_vertices},
                                 {"vertices_on_segments", run.report.vertices_on_segments},
                                 {"vertices", run.quality.vertices},
                                 {"triangles", run.quality.triangles},
                                 {"min_angle", run.quality.min_angle},
                                 {"max_angle", run.quality.max_angle},
                                 {"min_new_angle", run.quality.min_new_angle},
                                 {"exempt_triangles", run.quality.exempt_triangles},
                                 {"unmet_triangles", run.quality.unmet_triangles.size()},
                                 {"encroached_edges", run.report.encroached_edges},
                                 {"estimated_triangles", run.report.estimated_triangles},
                                 {"least_angle_histogram", run.report.least_angle_histogram},
                                 {"largest_angle_histogram", run.report.largest_angle_histogram},
                                 {"rounds", run.report.rounds},
                                 {"repair", repair_json(run.repair)},
                                 {"projection", projection_json(run.projected)},
                                 {"may_be_in_degrees", run.may_be_in_degrees},
                                 {"region_names", names_json(run.pslg.region_names)},
                                 {"marker_names", names_json(run.pslg.marker_names)},
                                 {"trees", trees_json(run.report.trees)},
                                 {"threads", run.threads},
                                 {"seconds", seconds_json(run, run.report.seconds, &Seconds::cpu)},
                                 {"wall_seconds", seconds_json(run, run.report.wall_seconds, &Seconds::wall)},
                                 {"peak_memory_mb", run.peak_memory_mb}};
  for (const auto& unmet : run.quality.unmet_triangles)
    json["unmet"].push_back({{"bound", report_words::name(unmet.bound)},
                             {"x", unmet.centroid[0]},
                             {"y", unmet.centroid[1]},
                             {"least_angle", unmet.least_angle},
                             {"greatest_angle", unmet.greatest_angle}});
  add_left(json, run.report, run.pslg.first_number);
  if (run.is_peer_asked) {
    json["other_separation"] = run.other ? peer_json(*run.other) : nlohmann::ordered_json(nullptr);
    json["mesh_2"] = run.peer ? peer_json(*run.peer) : nlohmann::ordered_json(nullptr);
  }
  return json;
}

inline void print_run(const Meshing_run& run, const CGAL::Quality_mesh_options_2& options) {
  using namespace meshing_run_internal;
  std::printf("input: %zu vertices, %zu segments, holes: %zu; bound: %g degrees\n",
              run.pslg.number_of_vertices(), run.pslg.number_of_segments(), run.pslg.holes.size(),
              options.min_angle());
  print_names("attributes of regions", run.pslg.region_names);
  print_names("markers", run.pslg.marker_names);
  if (run.repair) print_repair(*run.repair);
  if (run.projected) print_projection(*run.projected);
  if (run.may_be_in_degrees) degrees::print_warning("");
  print_figures(run, options);
  print_trees(run.report.trees);
  if (!run.why_no_other.empty())
    std::printf("no mesh %s: %s\n", name_of_way(other_way(options.separate())), run.why_no_other.c_str());
  if (run.is_peer_asked && !run.peer) std::printf("CGAL Mesh_2 gave no mesh\n");
  report_words::print_places(run.quality.unmet_triangles, [](const auto& unmet) {
    return report_words::words(unmet.bound) + std::string(" of ");
  });
  report_words::print_reasons(run.report, options);
}

#endif // QUADTREE_MESH_2_EXAMPLES_MESHING_RUN_H
