// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The stages of the mesher of graphs, one after the other:
//
//   shuffle order of the vertices (section 2 of the paper)
//   -> constrained Delaunay triangulation of the input
//   -> the domain, and what coordinates can tell apart in it
//   -> bounds in the kernel's coordinates; an estimate of the size, refused if it is beyond the budget
//   -> acute corners found (section 6)
//   -> refinement on demand: legs cut, lopped sectors locked; the bulk filled with squares where bounds of size rule
//      (Bulk_filler.h); rounds of blocks (Block_refinement.h), then what they leave
//   -> guarded removal, smoothing; small meshes are refined a second time (thin_small_mesh.h); thinning
//   -> exact constrained Delaunay flips; where wanted, splits of edges until they are Delaunay, and edges graded
//   -> where wanted, wide angles cured
//   -> flat arrays in the user's coordinates and vertex order
//
// Quadtrees (Tree_construction.h) take the place of refinement on demand where that is wanted, or in islands where it
// does not come to rest (Island_takeover.h). Refinement cures their mesh, and makes it where they go beyond a budget.
//
// What flows back: thinning and the exact flips may leave triangles to refine again, within a budget of their own.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_PIPELINE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_PIPELINE_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/Bounds_maker.h>
#include <CGAL/Quadtree_mesh_2/internal/Domain_maker.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_checkpoints.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Phase_clock.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Progress.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/check_coordinates.h>
#include <CGAL/Quadtree_mesh_2/internal/check_distances.h>
#include <CGAL/Quadtree_mesh_2/internal/digest_of_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/islands/Island_construction.h>
#include <CGAL/Quadtree_mesh_2/internal/islands/Island_takeover.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/nearest_hits.h>
#include <CGAL/Quadtree_mesh_2/internal/output/kernel_mesh_to_indexed_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Input_words.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/kernel_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Corner_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_finisher.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Vertex_budgets.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/triangle_budget.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Rounds_runner.h>
#include <CGAL/Quadtree_mesh_2/internal/shaping/Wide_angle_curer.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Bulk_filler.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Tree_construction.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/cure_placed_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/triangulate_domain.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Second_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Thinner.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/thin_small_mesh.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class ConcurrencyTag, class Watch = Unwatched_rounds>
class Mesh_pipeline {
public:
  using Geometry = Mesher_geometry<Traits>;
  using Point_2 = typename Traits::Point_2;
  using Pslg = Pslg_2<Point_2>;

  /// \param find_hits by which model the construction by quadtrees finds neighbors of vertices; null: by the quadtree
  Mesh_pipeline(const Pslg& pslg, const Quality_mesh_options_2& options, const Traits& traits,
                Find_nearest_hits<Pslg> find_hits, Quality_mesh_report_2& report, Watch watch = {})
      : pslg_(pslg), options_(options), traits_(traits), find_hits_(find_hits), report_(report),
        map_(pslg.vertices, seeds_of(pslg)), watch_(std::move(watch)) {}

  /// \returns the mesh; an empty one if who runs the rounds has it
  Indexed_mesh_2<Point_2> run() {
    report_.input_vertices = pslg_.number_of_vertices();
    report_.input_segments = pslg_.number_of_segments();
    const bool is_by_trees = options_.separate() == Quality_mesh_options_2::Separation::THEOREM_5;
    sort_vertices();
    if (!map_.is_in_range()) throw words_.too_wide("the 2^61 of 64-bit fixed point");
    Domain_maker<Traits, ConcurrencyTag> domain(pslg_, order_, map_, words_, state_);
    clock_.enter(&Seconds::first_mesh);
    domain.place_points();
    first_placed_ = order_.size();
    if (!has_gone_on_from_checkpoint()) {
      domain.place_segments();
      if (runner_ != nullptr) runner_->stow_graph();
      domain.run(options_, report_, runner_, [this] { let_go(); });
      too_near_for_trees_ = check_distances<Map>(state_, words_);
      set_bounds();
      Corner_finder<ConcurrencyTag, Geometry>(state_, estimate_size()).run();
      let_go();
      // Parts of a mesh have points once. In one memory, and where quadtrees put another mesh in its place, the
      // input's are apart.
      problem_.borrow_points(state_.mesh.points, order_.size());
      if (runner_ == nullptr || is_by_trees) problem_.keep_points_apart();
    }
    Second_refinement<Geometry> second(state_);
    Splitter<Geometry> splitter(state_);
    Refiner<Geometry> refiner(state_, splitter);
    if (!is_by_trees) second.keep_start();
    if (!rounds_.are_over) {
      if (!(is_by_trees && construct_by_trees(refiner)) &&
          refine(refiner, splitter) == Refinement_end::OUT_OF_BUDGET)
        take_over(refiner, splitter);
      if (rounds_end_ == Rounds_end::IN_PARTS) return {};
      if (rounds_end_ != Rounds_end::TAIL_DONE) coarsen(refiner, second);
    }
    const Triangle_account account = finish(refiner);
    report_.is_cancelled = progress_.is_cancelled();
    rounds_.are_over = true;
    if (rounds_.number > 0) save_checkpoint();
    report_.trees.kept = number_used<ConcurrencyTag>(state_.mesh, first_placed_, report_.trees.placed);
    return convert(account, refiner);
  }

  const Watch& watch() const { return watch_; }
  void run_rounds_by(Rounds_runner<Geometry>* runner) { runner_ = runner; } ///< with no checkpoints then

private:
  using Map = Coordinate_map<Traits, Geometry>;
  using Seconds = Quality_mesh_report_2::Seconds;
  /// Of a mesh by quadtrees that blocks have not thinned out.
  static constexpr int thinnings_of_mesh_ = 1;

  const Pslg& pslg_;
  const Quality_mesh_options_2& options_;
  const Traits& traits_;
  Find_nearest_hits<Pslg> find_hits_;
  Quality_mesh_report_2& report_;
  Phase_clock<Quality_mesh_report_2, ConcurrencyTag> clock_{report_};
  Map map_;
  Finishing finishing_{finishing_wanted(options_)};
  Meshing_problem<Geometry> problem_;
  Meshing_state<Geometry> state_{problem_};
  Progress progress_{options_.progress()};
  Order order_; // kernel vertex -> input vertex
  Input_words<Point_2> words_{pslg_, order_, [this] { take_out_graph(); }};
  Facing_pair worst_pair_;
  std::optional<Pslg_error_2> too_near_for_trees_; // the error for the first of them
  double triangles_of_sizes_ = 0;                  // what bounds of size ask for, as estimated
  std::size_t first_placed_ = 0;                   // of the vertices that quadtrees place
  Block_rounds rounds_;
  Watch watch_;                               // of the rounds
  Rounds_runner<Geometry>* runner_ = nullptr; // if somebody else runs them
  Rounds_end rounds_end_ = Rounds_end::NO_BLOCKS;
  Mesh_checkpoints checkpoints_{options_.checkpoints(), Checkpoint_pace<ConcurrencyTag>::time_between};
  bool has_gone_on_ = false; // from a checkpoint

  /// Where several work on one mesh, they may share a machine.
  void let_go() const {
    if (runner_ != nullptr) give_back_free_memory();
  }

  void take_out_graph() const {
    if (runner_ == nullptr) return;
    const bool are_apart = !problem_.input_points.empty();
    runner_->take_out_graph(order_, are_apart ? problem_.input_points : state_.mesh.points);
  }
  /// All of the input.
  const Pslg& pslg() const {
    take_out_graph();
    return pslg_;
  }

  void sort_vertices() {
    clock_.enter(&Seconds::quadtree);
    const auto grid = make_grid();
    Uninitialized_vector<Grid_point_2<typename Traits::Word>> grid_points(pslg_.number_of_vertices());
    for_each_index<ConcurrencyTag>(
        grid_points.size(), [&](std::size_t v) { grid_points[v] = grid.grid_point(pslg_.vertices[v]); });
    order_ = shuffle_order<ConcurrencyTag>(grid_points);
    problem_.vertex_blocks = blocks_by_squares(order_.size(), Block_sizes<ConcurrencyTag>::vertices,
                                               [&](std::size_t i) { return grid_points[order_[i]]; });
  }

  auto make_grid() const try {
    return traits_.construct_grid_2_object()(pslg_.vertices);
  } catch (const Point_error& error) {
    throw words_.out_of_range(error);
  }

  void set_bounds() { problem_.bounds = Bounds_maker<Traits>(options_, map_).run(pslg_); }

  /// \returns where acute sectors may begin, which is found on the way
  /// \throws Pslg_error_2 if the mesh would surely be larger than the budget.
  Acute_starts estimate_size() {
    Size_estimate<Geometry> estimate(state_, ConcurrencyTag());
    report_.estimated_triangles = estimate.triangles();
    triangles_of_sizes_ = estimate.triangles_of_sizes();
    worst_pair_ = estimate.worst_pair();
    const Triangle_budget budget = budgets().of_triangles();
    if (options_.max_steiner_vertices() || !budget.is_surely_exceeded_by(estimate.triangles()))
      return estimate.take_acute_starts();
    const std::string refusal = budget.refusal_of(estimate.triangles());
    if (worst_pair_.triangles <= estimate.triangles_of_sizes())
      throw Pslg_error_2(Pslg_error_2::Kind::TOO_MANY_TRIANGLES, refusal + " for the bounds of size");
    throw gap_error(refusal);
  }

  /// To be asked once the size is estimated.
  Vertex_budgets<Geometry> budgets() const {
    return {options_, problem_.bounds, order_.size(),
            static_cast<double>(order_.size()) + report_.estimated_triangles, triangles_of_sizes_};
  }

  /// All that a checkpoint has; the rest follows from input and options.
  template <class Archive>
  void transfer(Archive& archive) {
    archive(state_, problem_, rounds_, worst_pair_, triangles_of_sizes_, report_.merged_vertices,
            report_.vertices_on_segments, report_.estimated_triangles, report_.rounds, report_.trees,
            report_.is_budget_exhausted, first_placed_);
  }

  /// Whether there was a checkpoint of this input and these options. The state is as it was then.
  bool has_gone_on_from_checkpoint() {
    if (!checkpoints_.are_wanted() || options_.separate() != Quality_mesh_options_2::Separation::ON_DEMAND)
      return false;
    if constexpr (Geometry::has_unlimited_coordinates) {
      throw std::invalid_argument("there are no checkpoints of meshes over exact numbers");
    } else {
      checkpoints_.set_origin(digest_of_mesh(pslg_, options_, map_, state_.mesh.points.values(), order_));
      if (!checkpoints_.has_state()) return false;
      problem_.input_points = std::move(state_.mesh.points);
      checkpoints_.load([this](auto& archive) { this->transfer(archive); });
      set_bounds();
      return has_gone_on_ = true;
    }
  }

  /// \pre the mesh is refined in blocks
  void save_checkpoint() {
    if constexpr (!Geometry::has_unlimited_coordinates) {
      const bool is_by_trees = options_.separate() != Quality_mesh_options_2::Separation::ON_DEMAND;
      if (progress_.is_cancelled() || is_by_trees || state_.is_small_mesh()) return; // which needs its start
      checkpoints_.save_if_due([this](auto& archive) { this->transfer(archive); });
    }
  }

  /// Refines on demand. Where it runs out of budget, the mesh is as it was left.
  Refinement_end refine(Refiner<Geometry>& refiner, Splitter<Geometry>& splitter) {
    clock_.enter(&Seconds::refine);
    const Mesh_limit limit = budgets().of_refinement(may_construct_instead());
    if (!has_gone_on_) {
      const std::size_t least = state_.mesh.number_of_vertices() + problem_.corners.legs.size();
      if (!budgets().is_of_user() || least <= limit.vertices) splitter.cut_rings();
      Bulk_filler<ConcurrencyTag, Geometry>(state_, splitter).run(limit.vertices);
    }
    const Rounds_tail tail{order_, report_};
    rounds_end_ = work_off_in_blocks(limit, Progress_shares::first_mesh, is_tail_plain() ? &tail : nullptr);
    if (rounds_end_ == Rounds_end::TAIL_DONE || rounds_end_ == Rounds_end::IN_PARTS)
      return ++report_.rounds, Refinement_end::DONE;
    if (rounds_end_ == Rounds_end::WHOLE_MESH)
      finishing_.smoothing_rounds = 0; // done, and removal is left only at seams
    else
      refiner.push_all();
    const Refinement_end end = run(refiner, limit);
    if (end != Refinement_end::OUT_OF_BUDGET) finish_refinement(splitter);
    return end;
  }

  /// Whether nothing follows on the rounds but what a `Rounds_runner` may do.
  bool is_tail_plain() const {
    if constexpr (Map::may_lose_points)
      if (map_.may_round_mesh()) return false;
    return finishing_.thinning_rounds == 0 && !problem_.keeps_edges() && !problem_.bounds.has_widest() &&
           options_.conform() == Quality_mesh_options_2::Conforming::NONE && !growth_wanted(options_);
  }

  /// \param share_before of the work, as is told to the user
  /// \param tail null: not wanted
  Rounds_end work_off_in_blocks(Mesh_limit limit, double share_before, const Rounds_tail* tail) {
    const auto shall_go_on = [this, share_before](double share) {
      return progress_.shall_go_on(share_before + Progress_shares::rounds_of_blocks * share);
    };
    if (runner_ != nullptr) {
      const Rounds_end end = runner_->run(state_, finishing_, limit.vertices, rounds_, shall_go_on, tail);
      if (end != Rounds_end::IN_PARTS) problem_.keep_points_apart();
      return end;
    }
    Block_refinement<ConcurrencyTag, Geometry, Watch> blocks(state_, finishing_, limit.vertices, rounds_,
                                                             watch_);
    // A state goes on with refinement, which is not what quadtrees are followed by.
    const auto between_rounds = [this] {
      if (report_.trees.rounds == 0) save_checkpoint();
    };
    const bool has_blocks = blocks.run([&] { return shall_go_on(blocks.share_done()); }, between_rounds);
    return has_blocks ? Rounds_end::WHOLE_MESH : Rounds_end::NO_BLOCKS;
  }

  void finish_refinement(Splitter<Geometry>& splitter) {
    splitter.unlock_all();
    state_.legalize();
  }

  /// Whether quadtrees may take the place of refinement. Above the bounds established for it, triangles left over are
  /// no sign that quadtrees do better. Quadtrees know no least edge, no user's rule, no kept edge, and are asked once.
  bool may_construct_instead() const {
    return !budgets().is_of_user() && options_.min_edge() == 0 && !options_.refine_where() &&
           !problem_.keeps_edges() && !too_near_for_trees_ && problem_.bounds.is_established() &&
           report_.trees.end == Tree_separation_report_2::End::NONE && budgets().allows_quadtrees();
  }

  /// Has quadtrees make what refinement did not, if they may and can: islands of the mesh, or all of it if it is one.
  void take_over(Refiner<Geometry>& refiner, Splitter<Geometry>& splitter) {
    report_.trees.has_taken_over = may_construct_instead();
    Island_takeover<Traits, ConcurrencyTag> islands(state_, {pslg(), order_, map_, traits_, find_hits_},
                                                    options_, budgets(), report_);
    const auto end = islands.run([&](Mesh_limit limit) { return run(refiner, limit); },
                                 progress_.question_at(Progress_shares::quadtrees));
    first_placed_ = std::size_t(islands.first_placed());
    if (end == Takeover_end::WHOLE_MESH && construct_by_trees(refiner)) return;
    // Where quadtrees gave no mesh, the user's patience with refinement was in vain: it has the usual one.
    if (end != Takeover_end::DONE) run_to_the_end(refiner, islands.limit_of_rest());
    finish_refinement(splitter);
  }

  Refinement_end run(Refiner<Geometry>& refiner, Mesh_limit limit) {
    ++report_.rounds;
    const std::size_t n = order_.size();
    return refiner.run(limit, [this, n] {
      const double made = static_cast<double>(state_.mesh.number_of_vertices() - n) + 1;
      return progress_.shall_go_on(Progress_shares::blocks +
                                   Progress_shares::refinement * made / (made + 3 * static_cast<double>(n)));
    });
  }

  Pslg_gap_error_2 gap_error(const std::string& refusal) const {
    return words_.gap(refusal, Narrow_gap<Geometry>(state_, worst_pair_), map_.length_to_kernel(1.0));
  }

  /// \throws Pslg_error_2 if it ends at the limit of graphs of few vertices: its user did not ask for a part of a mesh
  void run_to_the_end(Refiner<Geometry>& refiner, Mesh_limit limit_of_mesh) {
    if (run(refiner, limit_of_mesh) != Refinement_end::OUT_OF_BUDGET) return;
    report_.is_budget_exhausted = true;
    const auto limit = budgets().of_few_vertices();
    if (!limit || !limit->is_used_up_by(state_.mesh.number_of_triangles())) return;
    if (worst_pair_.triangles > 0) throw gap_error(limit->refusal_when_used_up());
    const auto& place = state_.mesh.point(state_.mesh.triangle(state_.worklist.pop()).v[0]);
    throw words_.endless(limit->refusal_when_used_up(), problem_.nearest_input_vertex(place));
  }

  /// Makes a mesh by quadtrees, and refines what is too large in it, or could not be cured.
  /// \returns false if there is none, or one that used up the budget where refinement has not been tried: it has fewer
  /// vertices from the start. The mesh is as it was then.
  bool construct_by_trees(Refiner<Geometry>& refiner) {
    using End = Tree_separation_report_2::End;
    if (too_near_for_trees_) throw *too_near_for_trees_;
    const bool is_first_choice = !report_.trees.has_taken_over;
    const Edge_sides sides(state_.mesh, problem_.edges);
    Kernel_mesh<Geometry> domain =
        is_first_choice ? std::move(state_.mesh)
                        : triangulate_domain<ConcurrencyTag>(problem_, problem_.input_points.values(), sides);
    report_.trees.end = make_mesh_by_trees(domain, sides);
    clock_.enter(&Seconds::refine);
    const bool is_given_up =
        report_.trees.rounds == 0 || (is_first_choice && report_.trees.end == End::BUDGET);
    if (!is_given_up) {
      cure(refiner);
    } else if (is_first_choice) {
      state_.mesh = std::move(domain);
      report_.trees.placed = 0;
      state_.clear_worklist();
    }
    return !is_given_up;
  }

  void cure(Refiner<Geometry>& refiner) {
    const Mesh_limit limit = budgets().of_repair(state_.mesh.number_of_vertices());
    rounds_ = Block_rounds(); // perhaps of refinement that did not come to rest
    refiner.forget_rest();    // of the mesh before
    const bool shall_thin = cure_placed_mesh(
        state_, finishing_,
        [&] {
          return work_off_in_blocks(limit, Progress_shares::quadtrees, nullptr) != Rounds_end::NO_BLOCKS;
        },
        [&](bool are_blocks) {
          if (are_blocks)
            finishing_.smoothing_rounds = 0; // done
          else
            refiner.push_all();
          run_to_the_end(refiner, limit);
        });
    if (shall_thin) finishing_.thinning_rounds = std::max(options_.thin(), thinnings_of_mesh_);
  }

  /// \throws Pslg_error_2 if the user wants quadtrees and their grid cannot tell two vertices apart
  /// \param domain the triangulation of the domain
  Tree_separation_report_2::End make_mesh_by_trees(const Kernel_mesh<Geometry>& domain,
                                                   const Edge_sides& sides) {
    problem_.edges.list_by_vertices();
    const Pslg graph = graph_of_edges(pslg(), order_, problem_.edges);
    const Tree_separation_options_2 tree_options =
        report_.trees.has_taken_over ? options_where_refinement_fails(options_.trees()) : options_.trees();
    std::optional<Separation_trees<Traits, ConcurrencyTag>> trees;
    try {
      clock_.enter(&Seconds::trees);
      trees.emplace(problem_, sides, graph, map_, tree_options, traits_, domain, find_hits_,
                    budgets().of_construction().leaves, report_.trees);
    } catch (const Point_error& error) {
      if (report_.trees.has_taken_over) return Tree_separation_report_2::End::FAILED;
      throw words_.too_near(std::array{static_cast<Vertex_id>(error.point().value()),
                                       static_cast<Vertex_id>(error.other().value())},
                            " are nearer to each other than the grid of the quadtrees can tell");
    }
    if (trees->is_exhausted()) return Tree_separation_report_2::End::BUDGET;
    clock_.enter(&Seconds::construct);
    Tree_construction construction(state_, *trees, domain, report_.trees);
    // Leaves can be split without end for a bound that their rule is not made for: refinement meets a higher one.
    const Bounds<Geometry> wanted = problem_.bounds;
    problem_.bounds.lower_to_established();
    const auto end = construction.run(tree_options, budgets().of_construction(),
                                      progress_.question_at(Progress_shares::quadtrees));
    problem_.bounds = wanted;
    return end;
  }

  void coarsen(Refiner<Geometry>& refiner, Second_refinement<Geometry>& second) {
    clock_.enter(&Seconds::coarsen);
    if (state_.mesh.number_of_vertices() == order_.size() || progress_.is_cancelled()) return;
    finish_mesh(state_, finishing_, progress_.question_at(Progress_shares::removal));
    auto shall_thin_on = progress_.question_at(Progress_shares::thinning);
    if (finishing_.removal == Removal::GUARDED && !report_.is_budget_exhausted &&
        thin_small_mesh(state_, second, shall_thin_on))
      refiner.forget_rest();
    for (int round = 0; round < finishing_.thinning_rounds; ++round)
      if (!Thinner<Geometry>(state_).run(budgets().of_repair(state_.mesh.number_of_vertices()),
                                         shall_thin_on))
        return;
  }

  Triangle_account finish(Refiner<Geometry>& refiner) {
    clock_.enter(&Seconds::refine);
    if (problem_.keeps_edges()) state_.push_all_bad(); // given up in blocks; all may be other triangles now
    const auto limit = [this] { return budgets().of_repair(state_.mesh.number_of_vertices()); };
    const auto refine = [this, limit](Refiner<Geometry>& r) { run_to_the_end(r, limit()); };
    const auto is_stopped = [this] { return progress_.is_cancelled() || report_.is_budget_exhausted; };
    Exact_finisher<ConcurrencyTag, Geometry> finisher(state_, refine, is_stopped);
    const auto finish_exactly = [&] {
      if (options_.conform() == Quality_mesh_options_2::Conforming::NONE) return finisher.run(refiner);
      return finisher.run_conforming(limit().vertices, report_.encroached_edges);
    };
    const auto finish_graded = [&] {
      return grade_edges<ConcurrencyTag>(state_, growth_wanted(options_), map_, is_stopped, finish_exactly,
                                         [&] { return refine(refiner), finish_exactly(); });
    };
    return cure_wide_angles(state_, refiner, limit().vertices, is_stopped, finish_graded, refine);
  }

  Indexed_mesh_2<Point_2> convert(const Triangle_account& account, Refiner<Geometry>& refiner) {
    clock_.enter(&Seconds::convert);
    Kernel_mesh_converter<Traits, ConcurrencyTag> converter(state_, pslg(), map_, order_, report_);
    Indexed_mesh_2<Point_2> mesh = converter.run(account, refiner);
    if constexpr (Map::may_lose_points) check_mesh_is_kept<Geometry>(mesh, map_);
    return mesh;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_PIPELINE_H
