#ifndef QUADTREE_MESH_2_EXAMPLES_REPORT_WORDS_H
#define QUADTREE_MESH_2_EXAMPLES_REPORT_WORDS_H

// What people read for the enumerations of reports; report_names.h has what programs read.

#include "report_names.h"

#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace report_words {

/// A bound in words for people.
inline const char* words(CGAL::Mesh_quality_2::Bound bound) {
  switch (bound) {
  case CGAL::Mesh_quality_2::Bound::ANGLE:
    return "angle";
  case CGAL::Mesh_quality_2::Bound::EDGE_LENGTH:
    return "edge length";
  case CGAL::Mesh_quality_2::Bound::AREA:
    return "area";
  case CGAL::Mesh_quality_2::Bound::GREATEST_ANGLE:
    return "greatest angle";
  }
  return "";
}

/// What has used up the budget of vertices, which two options set.
inline const char* explanation_of_budget(const CGAL::Quality_mesh_options_2& options) {
  if (!options.max_steiner_vertices())
    return "the budget of vertices is used up; --max-vertices sets another";
  return options.max_vertices() > 0
             ? "the budget of vertices is used up; --max-vertices and --max-steiner set another"
             : "the budget of new vertices is used up; --max-steiner sets another";
}

/// The reason in words for people, with the option of the program that has to do with it.
/// \param options that were given
inline const char* explanation(CGAL::Quality_mesh_report_2::Reason reason,
                               const CGAL::Quality_mesh_options_2& options) {
  using Reason = CGAL::Quality_mesh_report_2::Reason;
  switch (reason) {
  case Reason::BUDGET:
    return explanation_of_budget(options);
  case Reason::CANCELLED:
    return "the run was stopped";
  case Reason::LEAST_EDGE:
    return "a vertex would be nearer to another than --min-edge allows";
  case Reason::KEPT_SEGMENT:
    return "a segment is in the way that --keep-borders leaves as it is";
  case Reason::CORNER:
    return "they are in a corner of the input, whose legs are not cut without end for a bound above 20.7 "
           "degrees";
  case Reason::GREATEST_ANGLE:
    return "--max-angle is tried, but not guaranteed";
  case Reason::COORDINATES:
    return "the coordinates have no room for a vertex";
  case Reason::CRITERIA:
    return "the criteria ask for more";
  }
  return "";
}

/// The places where a bound is unmet, the first of them.
/// \param bound_of what bound of a triangle, in words: empty, or "BOUND of "
template <class Unmet, class Bound_of>
void print_places(const std::vector<Unmet>& triangles, const Bound_of& bound_of) {
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < std::min(triangles.size(), most); ++i) {
    const Unmet& unmet = triangles[i];
    std::printf("unmet: %sthe triangle at (%.17g, %.17g), angles from %.2f to %.2f\n",
                std::string(bound_of(unmet)).c_str(), unmet.centroid[0], unmet.centroid[1], unmet.least_angle,
                unmet.greatest_angle);
  }
  if (triangles.size() > most) std::printf("unmet: %zu more\n", triangles.size() - most);
}

/// Why bounds are unmet, as the mesher reports it, and in how many triangles for each reason.
inline void print_reasons(const CGAL::Quality_mesh_report_2& report,
                          const CGAL::Quality_mesh_options_2& options) {
  std::map<CGAL::Quality_mesh_report_2::Reason, std::size_t> triangles;
  for (const auto& unmet : report.unmet_triangles) ++triangles[unmet.reason];
  for (const auto& [reason, n] : triangles)
    std::printf("unmet: reason for %zu: %s\n", n, explanation(reason, options));
  if (report.encroached_edges > 0)
    std::printf("unmet: edges on segments that are not Delaunay: %zu\n", report.encroached_edges);
}

} // namespace report_words

#endif // QUADTREE_MESH_2_EXAMPLES_REPORT_WORDS_H
