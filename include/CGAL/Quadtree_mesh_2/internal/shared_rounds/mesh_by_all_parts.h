// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A graph of the first part meshed by all parts: the mesh of one memory, renumbered by place, in parts.
//
// All parts make the first mesh, and the first part holds it before the rounds of blocks. After them nobody does,
// unless they leave something, or the options want more than Rounds_runner.h says.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_MESH_BY_ALL_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_MESH_BY_ALL_PARTS_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Checkpoint_file.h>
#include <CGAL/Quadtree_mesh_2/internal/digest_of_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Part_completer.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/distribute_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Stowable_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/rounds_by_all_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/state_bytes.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/renumber_mesh_2.h>

#include <cstdint>
#include <exception>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Throws if options differ, but for functions.
template <class Exchange>
void check_options_are_the_same(Exchange& exchange, const Quality_mesh_options_2& options) {
  Digest digest;
  add_options(digest, options);
  const auto value = static_cast<std::int64_t>(digest.value());
  if (exchange.min(value) != exchange.max(value))
    throw std::invalid_argument("ranks have different options for one mesh");
}

/// Gives all parts the report of the first one.
template <class Exchange>
void tell_report(Exchange& exchange, Quality_mesh_report_2& r) {
  const auto transfer = [&r](auto& archive) {
    archive(r.input_vertices, r.input_segments, r.vertices, r.triangles, r.merged_vertices,
            r.vertices_on_segments, r.exempt_triangles, r.unmet_triangles, r.encroached_edges,
            r.least_angle_histogram, r.largest_angle_histogram, r.estimated_triangles, r.rounds, r.trees,
            r.is_cancelled, r.is_budget_exhausted, r.seconds, r.wall_seconds);
  };
  State_writer writer;
  if (exchange.rank() == 0) transfer(writer);
  exchange.broadcast(writer.bytes, 0);
  State_reader reader(writer.bytes);
  if (exchange.rank() != 0) transfer(reader);
}

/// What the first part does, by the end of which others have nothing more to do.
template <class Exchange, class Traits, class ConcurrencyTag>
Indexed_mesh_2<typename Traits::Point_2>
lead(Exchange& exchange, Quality_mesher_2<Traits, ConcurrencyTag>& mesher,
     Stowable_graph<typename Traits::Point_2>& graph, Quality_mesh_report_2& report,
     Mesh_in_parts<typename Traits::Point_2>& part) {
  Rounds_by_all_parts<Exchange, Traits, Inner_tag<ConcurrencyTag>> runner(exchange, graph);
  Indexed_mesh_2<typename Traits::Point_2> mesh;
  std::exception_ptr error;
  if (exchange.size() > 1) Mesher_rounds::run_by(mesher, &runner);
  try {
    mesh = mesher(graph.graph());
  } catch (...) {
    error = std::current_exception();
  }
  Mesher_rounds::run_by(mesher, static_cast<decltype(&runner)>(nullptr));
  runner.end();
  if (error) std::rethrow_exception(error);
  report = mesher.report();
  part = runner.take_part();
  if (!part) renumber_by_place<ConcurrencyTag>(mesh).renumber(report);
  return mesh;
}

/// See `CGAL::Distributed_quality_mesher_2`.
/// \param mesher with the same options at all parts
/// \param graph counts at part 0 alone
/// \param report the same at all parts
template <class Exchange, class Traits, class ConcurrencyTag>
Distributed_mesh_2<typename Traits::Point_2>
mesh_by_all_parts(Exchange& exchange, Quality_mesher_2<Traits, ConcurrencyTag>& mesher,
                  Stowable_graph<typename Traits::Point_2> graph, Quality_mesh_report_2& report) {
  static_assert(is_kernel_geometry<typename Traits::Meshing_geometry_2>,
                "parts know no map of coordinates but those of the package's geometries");
  static_assert(!Traits::Meshing_geometry_2::has_unlimited_coordinates,
                "parts send each other coordinates of the machine, not exact numbers");
  check_options_are_the_same(exchange, mesher.options());
  if (!mesher.options().checkpoints().empty())
    throw std::invalid_argument("there are no checkpoints of meshes that several ranks make");
  Indexed_mesh_2<typename Traits::Point_2> mesh;
  Mesh_in_parts<typename Traits::Point_2> part;
  try {
    agree_on_work(exchange, [&] {
      const Concurrency_scope scope{ConcurrencyTag()};
      report = Quality_mesh_report_2();
      if (exchange.rank() == 0)
        mesh = lead(exchange, mesher, graph, report, part);
      else
        part = Helper_of_first_part<Traits, Inner_tag<ConcurrencyTag>, Exchange>(exchange, mesher.options())
                   .run();
    });
  } catch (const Lone_error& lone) {
    std::rethrow_exception(lone.error);
  }
  tell_report(exchange, report);
  if (!part) return distribute_mesh(exchange, mesh, graph.graph(), 0);
  complete_part(exchange, *part);
  return std::move(*part);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_MESH_BY_ALL_PARTS_H
