// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_ROUNDING_LOSS_H
#define QUADTREE_MESH_2_EXAMPLES_ROUNDING_LOSS_H

// Meshes that meet all bounds in finer arithmetic and not in the doubles that files have.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/part_names.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace rounding_loss_internal {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Graph = CGAL::Pslg_2<Point>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

inline Exact::Point_2 exact(const Point& p) { return {p.x(), p.y()}; }

/// The vertex or segment that is nearest to a point, of those that are not at the place of `except`.
struct Feature {
  bool is_segment;
  std::size_t number;
  Exact::FT squared_distance;
};

/// Also where its square is below all doubles.
inline double distance_of(const Feature& f) {
  constexpr int halvings = 1000;
  const Exact::FT scale(std::ldexp(1.0, halvings)), least(std::ldexp(1.0, -halvings));
  if (f.squared_distance >= least) return std::sqrt(CGAL::to_double(f.squared_distance));
  return std::ldexp(std::sqrt(CGAL::to_double(f.squared_distance * scale * scale)), -halvings);
}

inline std::optional<Feature> nearest_feature(const Graph& graph, const Exact::Point_2& p,
                                              const Point* except = nullptr) {
  std::optional<Feature> best;
  const auto offer = [&](bool is_segment, std::size_t number, const Exact::FT& squared_distance) {
    if (!best || squared_distance < best->squared_distance)
      best = Feature{is_segment, number, squared_distance};
  };
  for (std::size_t v = 0; v < graph.vertices.size(); ++v)
    if (except == nullptr || graph.vertices[v] != *except)
      offer(false, v, CGAL::squared_distance(p, exact(graph.vertices[v])));
  if (except == nullptr) return best;
  for (std::size_t s = 0; s < graph.segments.size(); ++s) {
    const Exact::Segment_2 segment(exact(graph.point(graph.segments[s][0])),
                                   exact(graph.point(graph.segments[s][1])));
    if (!segment.is_degenerate() && !segment.has_on(p)) offer(true, s, CGAL::squared_distance(p, segment));
  }
  return best;
}

inline std::string text_of(const Graph& graph, const Feature& f) {
  using namespace CGAL::Quadtree_mesh_2::internal;
  if (f.is_segment) return segment_text(graph, f.number);
  if (!graph.segments.empty()) return vertex_text(graph, f.number);
  return "point " + numbered_place(graph, f.number, graph.vertices[f.number]);
}

} // namespace rounding_loss_internal

/// Says what the user can do about a mesh whose angles rounding to doubles spoils, as only features do that are a few
/// units in the last place of the coordinates apart.
///
/// \param unmet entries with `centroid` and `least_angle`; there is one
/// \param arithmetic in which the mesh is right, in words
template <class Unmet_list>
[[noreturn]] void refuse_what_rounding_broke(const CGAL::Pslg_2<rounding_loss_internal::Point>& graph,
                                             const Unmet_list& unmet, const std::string& arithmetic) {
  using namespace rounding_loss_internal;
  const auto& worst = *std::min_element(
      unmet.begin(), unmet.end(), [](const auto& a, const auto& b) { return a.least_angle < b.least_angle; });
  const std::array<double, 2> place = worst.centroid;
  std::string message = "in " + arithmetic +
                        " the mesh meets all bounds, but in doubles, which files have, " +
                        std::to_string(unmet.size()) + " of its triangles do not, the worst at " +
                        CGAL::Quadtree_mesh_2::internal::place_text(place);
  if (const auto vertex = nearest_feature(graph, Exact::Point_2(place[0], place[1]))) {
    const Point& p = graph.vertices[vertex->number];
    message += ": next to it is " + text_of(graph, *vertex);
    if (const auto other = nearest_feature(graph, exact(p), &p)) {
      message += ", which is ";
      CGAL::Quadtree_mesh_2::internal::append_number(message, distance_of(*other));
      message += " from " + text_of(graph, *other);
    }
  }
  message += "; merge what is so near, or move the input nearer to the origin";
  if (!graph.segments.empty()) message += ", or use --kernel filtered, which meshes it as far as doubles go";
  throw std::runtime_error(message);
}

#endif // QUADTREE_MESH_2_EXAMPLES_ROUNDING_LOSS_H
