// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_MESHES_BY_ALL_PARTS_H
#define QUADTREE_MESH_2_TEST_MESHES_BY_ALL_PARTS_H

// Graphs meshed by all parts, compared with meshes of one memory. What is wrong is told as a text, so that no part ends
// before the others.

#include "distributed_mesh_checks.h"
#include "tiny_blocks.h"

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/mesh_by_all_parts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <tuple>

namespace meshes_by_all_parts {

using namespace distributed_mesh_checks;
using Options = CGAL::Quality_mesh_options_2;
using Report = CGAL::Quality_mesh_report_2;
using Traits = Mesher::Geom_traits;
template <class Tag>
using Mesher_with = CGAL::Quality_mesher_2<Traits, Tag>;

/// A mesh and its report.
struct Result {
  Mesh mesh;
  Report report;
};

/// Whether a mesh in the order of places is valid.
inline bool is_valid(Mesh mesh, const Pslg& pslg) {
  CGAL::renumber_by_input(mesh);
  return CGAL::mesh_quality_2(mesh, pslg).is_valid();
}

/// Made in one memory, and in the order of places.
template <class Tag>
Result in_one_memory(const Pslg& pslg, const Options& options) {
  Mesher_with<Tag> mesher(options);
  Result result{mesher(pslg), {}};
  result.report = mesher.report();
  CGAL::renumber_by_place(result.mesh).renumber(result.report);
  return result;
}

/// Whether two reports tell the same, but for times.
inline bool is_same(const Report& a, const Report& b) {
  const auto counts = [](const Report& r) {
    return std::array{r.input_vertices,  r.input_segments,       r.vertices,     r.triangles,
                      r.merged_vertices, r.vertices_on_segments, r.rounds,       r.encroached_edges,
                      r.trees.kept,      r.trees.rounds,         r.trees.placed, std::size_t(r.is_cancelled)};
  };
  const auto is_same_exempt = [](const auto& s, const auto& t) {
    return s.triangle == t.triangle && s.corner == t.corner;
  };
  const auto is_same_unmet = [](const auto& s, const auto& t) {
    return std::tie(s.triangle, s.centroid, s.least_angle, s.reason, s.segment) ==
           std::tie(t.triangle, t.centroid, t.least_angle, t.reason, t.segment);
  };
  return counts(a) == counts(b) && a.estimated_triangles == b.estimated_triangles &&
         a.least_angle_histogram == b.least_angle_histogram &&
         std::equal(a.exempt_triangles.begin(), a.exempt_triangles.end(), b.exempt_triangles.begin(),
                    b.exempt_triangles.end(), is_same_exempt) &&
         std::equal(a.unmet_triangles.begin(), a.unmet_triangles.end(), b.unmet_triangles.begin(),
                    b.unmet_triangles.end(), is_same_unmet);
}

/// Meshes by all parts, and puts the mesh together at the first one. \returns what is wrong there, or at any part
template <class Tag, class Exchange>
std::string check_mesh_of_all(Exchange& exchange, const Result& expected, const Pslg& pslg,
                              const Options& options) {
  const bool is_first = exchange.rank() == 0;
  Mesher_with<Tag> mesher(options);
  Report report;
  const Part part = mesh_by_all_parts(exchange, mesher, is_first ? pslg : Pslg(), report);
  std::string wrong = Mesh_defects<Exchange, Point>(exchange, part).find();
  if (!is_same(report, expected.report)) wrong += "the report is another one; ";
  const Part right =
      distribute_mesh(exchange, is_first ? expected.mesh : Mesh(), is_first ? pslg : Pslg(), 0);
  if (bytes_of_mesh(part) != bytes_of_mesh(right)) wrong += "the part is another one; ";
  const Mesh mesh = gather_mesh(exchange, part, 0);
  if (is_first && !distributed_mesh_checks::is_same(mesh, expected.mesh))
    wrong += "the mesh is another one; ";
  return wrong;
}

/// The text of an error, and the parts of the graph that it names.
inline std::string said_by(const std::exception& error) {
  std::string text = error.what();
  const auto* const of_graph = dynamic_cast<const CGAL::Pslg_error_2*>(&error);
  if (of_graph == nullptr) return text;
  for (const auto v : of_graph->parts().vertices) text += " v" + std::to_string(std::size_t(v));
  for (const auto s : of_graph->parts().segments) text += " s" + std::to_string(std::size_t(s));
  for (const std::size_t h : of_graph->parts().holes) text += " h" + std::to_string(h);
  for (const std::size_t r : of_graph->parts().regions) text += " r" + std::to_string(r);
  return text;
}

/// What a mesher of all parts throws at this one; empty if nothing.
template <class Tag, class Exchange>
std::string error_of_all(Exchange& exchange, const Pslg& pslg, const Options& options) {
  Mesher_with<Tag> mesher(options);
  Report report;
  try {
    mesh_by_all_parts(exchange, mesher, exchange.rank() == 0 ? pslg : Pslg(), report);
  } catch (const std::exception& error) {
    return said_by(error);
  }
  return {};
}

/// Half as long in the right half of the box as in the left one.
inline Options sizes_in_halves(const Pslg& pslg) {
  const auto [low, high] = std::minmax_element(pslg.vertices.begin(), pslg.vertices.end(),
                                               [](const Point& p, const Point& q) { return p.x() < q.x(); });
  const double middle = (low->x() + high->x()) / 2, extent = high->x() - low->x();
  return Options().size([=](double x, double) { return extent / (x < middle ? 60 : 120); });
}

/// A size field that fails in one place, here at the right end of the box.
inline Options sizes_that_fail(const Pslg& pslg) {
  const auto [low, high] = std::minmax_element(pslg.vertices.begin(), pslg.vertices.end(),
                                               [](const Point& p, const Point& q) { return p.x() < q.x(); });
  const double last = high->x() - (high->x() - low->x()) / 16, extent = high->x() - low->x();
  return Options().size([=](double x, double) {
    if (x > last) throw std::runtime_error("no size is known here");
    return extent / 60;
  });
}

} // namespace meshes_by_all_parts

#endif // QUADTREE_MESH_2_TEST_MESHES_BY_ALL_PARTS_H
