#ifndef QUADTREE_MESH_2_EXAMPLES_REPORT_JSON_H
#define QUADTREE_MESH_2_EXAMPLES_REPORT_JSON_H

// What programs read of a mesher's report: parts of the JSON that --report writes.

#include "report_names.h"

#include <CGAL/Quality_mesh_report_2.h>

#include <nlohmann/json.hpp>

#include <cstddef>

/// What the quadtrees of Theorem 5 did; null if there was no such construction.
inline nlohmann::ordered_json trees_json(const CGAL::Tree_separation_report_2& trees) {
  if (trees.end == CGAL::Tree_separation_report_2::End::NONE) return nullptr;
  return {{"end", report_words::name(trees.end)},
          {"has_taken_over", trees.has_taken_over},
          {"islands", trees.islands},
          {"leaves_of_points", trees.leaves_of_points},
          {"leaves_of_vertices", trees.leaves_of_vertices},
          {"leaves_of_pieces", trees.leaves_of_pieces},
          {"leaves_of_edges", trees.leaves_of_edges},
          {"splits", trees.splits},
          {"rounds", trees.rounds},
          {"windows", trees.windows},
          {"failed_windows", trees.failed_windows},
          {"triangles", trees.triangles},
          {"missed_by_rule", trees.missed_by_rule},
          {"left_out", trees.left_out},
          {"relocated", trees.relocated},
          {"added", trees.added},
          {"missed", trees.missed},
          {"handed_over", trees.handed_over},
          {"placed", trees.placed},
          {"kept", trees.kept}};
}

/// Of reading, of each phase of the mesher, of writing, of the mesher as a whole, and of all.
inline nlohmann::ordered_json seconds_json(double read, const CGAL::Quality_mesh_report_2::Seconds& phases,
                                           double mesh, double write) {
  return {{"read", read},
          {"quadtree", phases.quadtree},
          {"first_mesh", phases.first_mesh},
          {"trees", phases.trees},
          {"construct", phases.construct},
          {"refine", phases.refine},
          {"coarsen", phases.coarsen},
          {"convert", phases.convert},
          {"write", write},
          {"mesh", mesh},
          {"total", read + mesh + write}};
}

/// Adds what the mesher has left, if there is something.
/// \param first_number from which vertices, segments and triangles are counted
inline void add_left(nlohmann::ordered_json& json, const CGAL::Quality_mesh_report_2& report,
                     std::size_t first_number) {
  for (const auto& unmet : report.unmet_triangles) {
    json["left"].push_back({{"triangle", first_number + std::size_t(unmet.triangle)},
                            {"x", unmet.centroid[0]},
                            {"y", unmet.centroid[1]},
                            {"least_angle", unmet.least_angle},
                            {"greatest_angle", unmet.greatest_angle},
                            {"reason", report_words::name(unmet.reason)}});
    if (unmet.segment.is_valid()) json["left"].back()["segment"] = first_number + std::size_t(unmet.segment);
  }
}

#endif // QUADTREE_MESH_2_EXAMPLES_REPORT_JSON_H
