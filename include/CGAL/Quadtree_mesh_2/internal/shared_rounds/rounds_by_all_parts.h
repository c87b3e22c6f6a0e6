// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The first mesh and the rounds of blocks of a mesher at the first part, made and run by all parts.
//
// The first part meshes. Others wait until it has work for all, or nothing more to do. For the first mesh it tells all
// of the graph, and they make it (First_mesh_of_parts.h); the first part gets it. For rounds it tells all of the
// problem, and they run them (Rounds_of_parts.h). If nothing is left then, they finish the mesh, too (Tail_of_parts.h),
// and make that of the user from it (Conversion_of_parts.h). Otherwise the first part gets the mesh back.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_BY_ALL_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_BY_ALL_PARTS_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Stowable_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_rounds.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Rounds_runner.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Conversion_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Rounds_job.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Rounds_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Tail_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/state_bytes.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/First_mesh_of_parts.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The mesh of the user, if its parts are made where the rounds were run: each part has what it owns of it.
template <class Point>
using Mesh_in_parts = std::optional<Distributed_mesh_2<Point>>;

/// What the first part has for all.
enum class Work_of_all : std::int32_t { FIRST_MESH, ROUNDS };

/// Rounds, and what follows on them if it is wanted and nothing is left by them.
template <class Traits, class ConcurrencyTag, class Exchange>
class Rounds_and_tail {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  using Point_2 = typename Traits::Point_2;

  Rounds_and_tail(Exchange& exchange, Rounds_job<Geometry>& job, const Graph_frame<Point_2>& frame)
      : exchange_(exchange), job_(job), map_(frame.graph().vertices) {}

  /// All parts call it, with the same problem. If the mesh is not in parts in the end, the first part has it.
  template <class Continue>
  Rounds_end run(Block_rounds& rounds, const Continue& shall_go_on, const Input_of_parts<Point_2>& input,
                 Quality_mesh_report_2& report, Mesh_in_parts<Point_2>& part) {
    Rounds parts(exchange_, job_.state, job_.finishing, job_.vertex_budget, rounds);
    const auto is_wanted = [&] { return shall_go_on(parts.share_done()); };
    if (!parts.run(is_wanted)) return Rounds_end::NO_BLOCKS;
    if (!job_.is_tail_wanted || !rounds.waiting.empty() || exchange_.min(is_wanted() ? 1 : 0) == 0)
      return parts.gather(), Rounds_end::WHOLE_MESH;
    Tail tail(exchange_, parts.held(), parts.corners(), job_.state);
    if (!tail.is_possible(parts.number_of_triangles())) return parts.gather(), Rounds_end::WHOLE_MESH;
    tail.run(job_.finishing.removal);
    if (tail.leaves_bad()) return parts.gather(), Rounds_end::TAIL_DONE;
    Conversion_of_parts<Exchange, Traits> conversion(exchange_, job_.state, parts.held(), map_, input);
    part = conversion.run(tail.account(), report);
    return Rounds_end::IN_PARTS;
  }

  const Coordinate_map<Traits, Geometry>& map() const { return map_; }

private:
  using Rounds = Rounds_of_parts<ConcurrencyTag, Exchange, Geometry>;
  using Tail = Tail_of_parts<ConcurrencyTag, Exchange, Geometry>;

  Exchange& exchange_;
  Rounds_job<Geometry>& job_;
  Coordinate_map<Traits, Geometry> map_;
};

template <class Exchange, class Traits, class ConcurrencyTag>
class Rounds_by_all_parts final : public Rounds_runner<typename Traits::Meshing_geometry_2> {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  using Point_2 = typename Traits::Point_2;
  using Kernel_points = typename Rounds_runner<Geometry>::Kernel_points;

  /// \param graph to be meshed, which has to outlive this
  Rounds_by_all_parts(Exchange& exchange, Stowable_graph<Point_2>& graph)
      : exchange_(exchange), graph_(graph) {}

  void stow_graph() override {
    frame_ = Graph_frame<Point_2>(graph_.graph());
    graph_.stow();
    give_back_free_memory();
  }
  void take_out_graph(const Order& order, const Kernel_points& points) override {
    if (!graph_.is_stowed()) return;
    const Coordinate_map<Traits, Geometry> map(frame_.graph().vertices);
    graph_.take_out(order, [&](std::size_t v) { return map.to_user(points[static_cast<Vertex_id>(v)]); });
  }

  bool make_first_mesh(Kernel_mesh<Geometry>& mesh, const Vertex_blocks& vertex_blocks,
                       const Domain_rule<Geometry>& rule, First_mesh& made) override {
    if (vertex_blocks.size() < 2) return false; // too small
    made.merged_vertices = name_by_first(mesh.points, made.edges.segments);
    tell_all_of(Work_of_all::FIRST_MESH, mesh.points, made.edges.segments, rule.rule, rule.holes,
                rule.regions);
    const Kernel_graph<Geometry> graph{mesh.points, mesh.points.size(), made.edges.segments};
    const bool is_made = work_together([&] {
      First_mesh_of_parts<ConcurrencyTag, Exchange, Geometry> first(exchange_, graph, rule);
      if (!first.run()) return false;
      first.gather(mesh, made);
      return true;
    });
    are_all_at_work_ = false, are_points_known_ = true;
    return is_made;
  }

  Rounds_end run(Meshing_state<Geometry>& state, const Finishing& finishing, std::size_t vertex_budget,
                 Block_rounds& rounds, const std::function<bool(double)>& shall_go_on,
                 const Rounds_tail* tail) override {
    Rounds_job<Geometry> job{state, finishing, vertex_budget, tail != nullptr,
                             std::exchange(are_points_known_, false)};
    tell_all_of(Work_of_all::ROUNDS, frame_, job);
    agree_on_work(exchange_, [] {}); // others make bounds
    Quality_mesh_report_2 nobody_reads;
    const Order no_order;
    const Rounds_end end = work_together([&] {
      return Rounds_and_tail<Traits, ConcurrencyTag, Exchange>(exchange_, job, frame_)
          .run(rounds, shall_go_on, {graph_, tail != nullptr ? tail->order : no_order},
               tail != nullptr ? tail->report : nobody_reads, part_);
    });
    are_all_at_work_ = false;
    if (end == Rounds_end::WHOLE_MESH)
      for (const Triangle_id t : rounds.waiting) state.push(t);
    return end;
  }

  /// Tells others that there is nothing more to do. To be called at last, be there an error or not.
  void end() {
    if (are_all_at_work_) return; // an error there, which has ended it for all
    Bytes nothing;
    exchange_.broadcast(nothing, 0);
  }

  /// What the first part owns, if rounds have ended with the mesh in parts.
  Mesh_in_parts<Point_2> take_part() { return std::move(part_); }

private:
  Exchange& exchange_;
  Stowable_graph<Point_2>& graph_;
  Graph_frame<Point_2> frame_; // once the graph may be stowed
  bool are_all_at_work_ = false;
  bool are_points_known_ = false; // to all, until rounds have used them up
  Mesh_in_parts<Point_2> part_;

  template <class... T>
  void tell_all_of(Work_of_all work, T&... told) {
    are_all_at_work_ = true;
    work_together([&] {
      State_teller<Exchange> teller(exchange_);
      teller(work, told...);
      teller.finish();
    });
  }
};

/// What other parts do until the first one calls `end()`.
template <class Traits, class ConcurrencyTag, class Exchange>
class Helper_of_first_part {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  using Point_2 = typename Traits::Point_2;

  /// \param options the same as at the first part
  Helper_of_first_part(Exchange& exchange, const Quality_mesh_options_2& options)
      : exchange_(exchange), options_(options) {}

  /// \returns the part of the mesh that this one has made, if it has
  Mesh_in_parts<Point_2> run() {
    for (;;) {
      Bytes bytes;
      work_together([&] { exchange_.broadcast(bytes, 0); });
      if (bytes.empty()) return std::move(part_);
      State_listener<Exchange> listener(exchange_, std::move(bytes));
      Work_of_all work;
      listener(work);
      if (work == Work_of_all::FIRST_MESH)
        make_first_mesh(listener);
      else
        run_rounds(listener);
    }
  }

private:
  using Listener = State_listener<Exchange>;

  Exchange& exchange_;
  const Quality_mesh_options_2& options_;
  typename Kernel_graph<Geometry>::Points points_; // of the input, once they are told
  Mesh_in_parts<Point_2> part_;

  void make_first_mesh(Listener& listener) {
    std::vector<Segment_ends> segments;
    Domain_rule<Geometry> rule;
    work_together([&] { listener(points_, segments, rule.rule, rule.holes, rule.regions); });
    const Kernel_graph<Geometry> graph{points_, points_.size(), segments};
    work_together([&] {
      First_mesh_of_parts<ConcurrencyTag, Exchange, Geometry> first(exchange_, graph, rule);
      if (!first.run()) return;
      Kernel_mesh<Geometry> nowhere;
      First_mesh nothing;
      first.gather(nowhere, nothing);
    });
    give_back_free_memory();
  }

  void run_rounds(Listener& listener) {
    Graph_frame<Point_2> frame;
    Meshing_problem<Geometry> problem;
    problem.input_points = std::move(points_);
    Meshing_state<Geometry> state(problem);
    Rounds_job<Geometry> job{state};
    std::optional<Rounds_and_tail<Traits, ConcurrencyTag, Exchange>> rounds_and_tail;
    work_together([&] { listener(frame, job); });
    agree_on_work(exchange_, [&] {
      rounds_and_tail.emplace(exchange_, job, frame);
      problem.bounds = bounds_in_frame<Traits>(frame, options_, rounds_and_tail->map());
    });
    Block_rounds rounds;
    const Pslg_2<Point_2> nothing;
    const Stowable_graph<Point_2> no_graph(nothing);
    const Order no_order;
    Quality_mesh_report_2 nobody_reads;
    work_together([&] {
      const auto always = [](double) { return true; };
      rounds_and_tail->run(rounds, always, {no_graph, no_order}, nobody_reads, part_);
    });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_BY_ALL_PARTS_H
