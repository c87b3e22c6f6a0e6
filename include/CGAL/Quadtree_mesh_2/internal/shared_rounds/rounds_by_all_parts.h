// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Rounds of blocks of a mesher at the first part, run by all parts.
//
// The first part meshes. Others wait until it has rounds to run, or nothing more to do. For rounds it tells all of the
// problem, they run them (Rounds_of_parts.h), and it gets the mesh back.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_BY_ALL_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_BY_ALL_PARTS_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_rounds.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Rounds_runner.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Rounds_job.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Rounds_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/state_bytes.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <cstddef>
#include <functional>
#include <optional>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// All parts call it, with the same problem. \returns whether there were blocks; the first part has the mesh then, too
template <class ConcurrencyTag, class Exchange, class Geometry, class Continue>
bool run_rounds_and_gather(Exchange& exchange, Rounds_job<Geometry>& job, Block_rounds& rounds,
                           const Continue& shall_go_on) {
  return work_together([&] {
    Rounds_of_parts<ConcurrencyTag, Exchange, Geometry> parts(exchange, job.state, job.finishing,
                                                              job.vertex_budget, rounds);
    const bool has_blocks = parts.run([&] { return shall_go_on(parts.share_done()); });
    if (has_blocks) parts.gather();
    return has_blocks;
  });
}

/// The first part's runner.
template <class Exchange, class Traits, class ConcurrencyTag>
class Rounds_by_all_parts final : public Rounds_runner<typename Traits::Meshing_geometry_2> {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  using Point_2 = typename Traits::Point_2;

  /// \param pslg the graph to be meshed, which has to outlive this
  Rounds_by_all_parts(Exchange& exchange, const Pslg_2<Point_2>& pslg) : exchange_(exchange), pslg_(pslg) {}

  bool run(Meshing_state<Geometry>& state, const Finishing& finishing, std::size_t vertex_budget,
           Block_rounds& rounds, const std::function<bool(double)>& shall_go_on) override {
    Rounds_job<Geometry> job{state, finishing, vertex_budget};
    Graph_frame<Point_2> frame(pslg_);
    State_writer writer;
    writer(frame, job);
    are_all_in_rounds_ = true;
    exchange_.broadcast(writer.bytes, 0);
    Bytes().swap(writer.bytes);
    agree_on_work(exchange_, [] {}); // others read the job
    const bool has_blocks = run_rounds_and_gather<ConcurrencyTag>(exchange_, job, rounds, shall_go_on);
    are_all_in_rounds_ = false;
    if (has_blocks)
      for (const Triangle_id t : rounds.waiting) state.push(t);
    return has_blocks;
  }

  /// Tells others that there are no more rounds. To be called at last, be there an error or not.
  void end() {
    if (are_all_in_rounds_) return; // an error in rounds, which has ended them for all
    Bytes nothing;
    exchange_.broadcast(nothing, 0);
  }

private:
  Exchange& exchange_;
  const Pslg_2<Point_2>& pslg_;
  bool are_all_in_rounds_ = false;
};

/// What other parts do until the first one calls `end()`.
/// \param options the same as at the first part
template <class Traits, class ConcurrencyTag, class Exchange>
void help_with_rounds(Exchange& exchange, const Quality_mesh_options_2& options) {
  using Geometry = typename Traits::Meshing_geometry_2;
  for (;;) {
    Bytes bytes;
    work_together([&] { exchange.broadcast(bytes, 0); });
    if (bytes.empty()) return;
    Graph_frame<typename Traits::Point_2> frame;
    Meshing_problem<Geometry> problem;
    Meshing_state<Geometry> state(problem);
    Rounds_job<Geometry> job{state};
    std::optional<Coordinate_map<Traits, Geometry>> map;
    agree_on_work(exchange, [&] {
      State_reader reader(bytes);
      reader(frame, job);
      Bytes().swap(bytes);
      map.emplace(frame.graph().vertices);
      problem.bounds = bounds_in_frame<Traits>(frame, options, *map);
    });
    Block_rounds rounds;
    run_rounds_and_gather<ConcurrencyTag>(exchange, job, rounds, [](double) { return true; });
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_BY_ALL_PARTS_H
