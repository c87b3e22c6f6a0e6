// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The stages of the mesher, one after the other; nothing flows back (doc/guarantees.md).
//
//   shuffle order of the vertices (section 2 of the paper)
//   -> constrained Delaunay triangulation of the input, restricted to the domain
//   -> acute corners found, their legs cut, lopped sectors locked (section 6)
//   -> the bulk filled with squares, where bounds of size rule (Bulk_filler.h)
//   -> refinement on demand and guarded removal: in blocks, then what is left at their seams -> exact constrained
//      Delaunay flips
//   -> flat arrays in the user's coordinates and vertex order

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_PIPELINE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_PIPELINE_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Block_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/Bulk_filler.h>
#include <CGAL/Quadtree_mesh_2/internal/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/Phase_timer.h>
#include <CGAL/Quadtree_mesh_2/internal/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/Smoother.h>
#include <CGAL/Quadtree_mesh_2/internal/Thinner.h>
#include <CGAL/Quadtree_mesh_2/internal/Tree_construction.h>
#include <CGAL/Quadtree_mesh_2/internal/Tree_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/domain.h>
#include <CGAL/Quadtree_mesh_2/internal/find_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/kernel_mesh_to_indexed_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/nearest_hits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangle_budget.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/validate_pslg_2.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class Concurrency_tag>
class Mesh_pipeline {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  using Point_2 = typename Traits::Point_2;
  using Pslg = Pslg_2<Point_2>;

  /// \param find_hits by which model the construction by quadtrees finds neighbours of vertices; null: by the quadtree
  Mesh_pipeline(const Pslg& pslg, const Quality_mesh_options_2& options, const Traits& traits,
                Find_nearest_hits<Pslg> find_hits, Quality_mesh_report_2& report)
      : pslg_(pslg), options_(options), traits_(traits), find_hits_(find_hits), report_(report),
        map_(pslg.vertices) {
    if (options.coarsening == Quality_mesh_options_2::Coarsening::NONE) finishing_.removal = Removal::none;
    finishing_.smoothing_rounds = options.smoothing_rounds;
    finishing_.thinning_rounds = options.thinning_rounds;
  }

  Indexed_mesh_2<Point_2> run() {
    if (!map_.is_in_range())
      throw Pslg_error_2("the coordinates span more than 2^61: too much for 64-bit fixed point");
    report_.input_vertices = pslg_.number_of_vertices();
    report_.input_segments = pslg_.number_of_segments();
    sort_vertices();
    make_first_mesh();
    Splitter<Geometry> splitter(state_);
    Refiner<Geometry> refiner(state_, splitter);
    if (options_.separation == Quality_mesh_options_2::Separation::THEOREM_5 || !refine(refiner, splitter))
      construct_by_trees(refiner);
    coarsen();
    finish(refiner);
    report_.is_cancelled = is_cancelled_;
    return convert();
  }

private:
  using First = First_triangulation<Concurrency_tag, Geometry>;
  /// Quadtrees make four times the triangles that are needed: removal alone leaves half of those too many.
  static constexpr int rounds_after_construction_ = 2;
  static constexpr double degree = 3.14159265358979323846 / 180;

  const Pslg& pslg_;
  const Quality_mesh_options_2& options_;
  const Traits& traits_;
  Find_nearest_hits<Pslg> find_hits_;
  Quality_mesh_report_2& report_;
  Coordinate_map<Traits, Geometry> map_;
  Finishing finishing_;
  Meshing_problem<Geometry> problem_;
  Meshing_state<Geometry> state_{problem_};
  double share_done_ = 0;
  std::mutex callback_mutex_;
  std::atomic<bool> is_cancelled_{false};
  Order order_;                 // kernel vertex -> input vertex
  std::vector<char> is_merged_; // kernel vertices that another one stands for
  Domain_rule<Geometry> domain_;
  std::optional<Edge_sides> edge_sides_;

  /// Whether the user wants to go on; about `share` of the work is done. What the user is told never falls.
  bool shall_go_on(double share) {
    if (!options_.callback || is_cancelled_) return !is_cancelled_;
    const std::lock_guard<std::mutex> lock(callback_mutex_);
    share_done_ = std::max(share_done_, share);
    if (!is_cancelled_ && !options_.callback(share_done_)) is_cancelled_ = true;
    return !is_cancelled_;
  }

  void sort_vertices() {
    Phase_timer timer(report_.seconds.quadtree);
    const auto grid = traits_.construct_grid_2_object()(pslg_.vertices);
    std::vector<Grid_point_2<typename Traits::Word>> grid_points(pslg_.number_of_vertices());
    for_each_index<Concurrency_tag>(
        grid_points.size(), [&](std::size_t v) { grid_points[v] = grid.grid_point(pslg_.vertices[v]); });
    order_ = shuffle_order<Concurrency_tag>(grid_points);
  }

  void make_first_mesh() {
    Phase_timer timer(report_.seconds.first_mesh);
    const std::size_t n = pslg_.number_of_vertices();
    std::vector<typename Geometry::Point> points(n);
    for_each_index<Concurrency_tag>(
        n, [&](std::size_t v) { points[v] = map_.to_kernel(pslg_.vertices[order_[v]]); });
    First first(state_.mesh, points);
    if (const auto crossing = first.run(kernel_segments())) throw Pslg_error_2(describe(first, *crossing));
    is_merged_.resize(n);
    for (std::size_t v = 0; v < n; ++v) {
      is_merged_[v] = first.representative(static_cast<Vertex_id>(v)) != static_cast<Vertex_id>(v) ? 1 : 0;
      report_.merged_vertices += std::size_t(is_merged_[v]);
    }
    report_.vertices_on_segments = first.number_of_vertices_on_segments();
    problem_.edges = Input_edges(first.edges(), n);
    problem_.edges.repeat(first.repeated_edges());
    problem_.input_points = std::move(points);

    find_domain();
    edge_sides_.emplace(state_.mesh, problem_.edges);
    if constexpr (Geometry::has_unlimited_coordinates) check_distances();
    set_bounds();
    estimate_size();
    Corner_finder<Concurrency_tag, Geometry>(state_).run();
  }

  void find_domain() {
    domain_.rule = options_.domain;
    for (const Point_2& p : pslg_.holes) domain_.holes.push_back(map_.to_kernel(p));
    for (const auto& region : pslg_.regions) domain_.regions.push_back(map_.to_kernel(region.point));
    try {
      domain_.apply(state_.mesh, First::number_of_auxiliary_vertices);
    } catch (const Ambiguous_seed& seed) {
      throw seed_error(seed);
    }
    if (!state_.mesh.triangles.empty()) return;
    throw Pslg_error_2(pslg_.segments.empty() ? "there are no segments, so there is no domain to mesh"
                       : options_.domain == Quality_mesh_options_2::Domain::MARKED
                           ? "no domain: no region's point is in a component that segments enclose"
                       : pslg_.holes.empty()
                           ? "the segments enclose no domain: every face is connected to infinity"
                           : "no domain is left: what the segments enclose, holes take away");
  }

  Pslg_seed_error_2 seed_error(const Ambiguous_seed& seed) const {
    const auto kind = seed.of == Ambiguous_seed::Of::HOLE ? Pslg_seed_error_2::Kind::HOLE : Pslg_seed_error_2::Kind::REGION;
    if (seed.a == seed.b)
      return make_seed_error(pslg_, kind, seed.number, Vertex_index(order_[std::size_t(seed.a)]), Segment_index());
    const Edge_id e = problem_.edges.between(seed.a, seed.b);
    return make_seed_error(pslg_, kind, seed.number, Vertex_index(), Segment_index(problem_.edges[e].segment));
  }

  /// Coordinates are unlimited, the doubles in which angles are compared are not.
  /// \throws Pslg_error_2 if vertices are nearer to each other, or to segments, than these can tell. Such pairs are
  /// sides and heights of triangles.
  void check_distances() const {
    constexpr double least = Geometry::least_length * Geometry::least_length;
    for (const auto& r : state_.mesh.triangles) {
      if (r.v[0] < 0) continue;
      const Shape s = state_.mesh.shape(r);
      if (s.shortest() >= least && s.area2 * s.area2 >= least * s.longest()) continue;
      std::string names;
      for (const Vertex_id v : r.v)
        names += (names.empty() ? "" : ", ") + name_of_vertex(order_[std::size_t(v)]);
      throw Pslg_error_2(names + ": nearer to each other, or to being on a line, than 2^-128 of the extent");
    }
  }

  void set_bounds() {
    const double scale = map_.length_to_kernel(1.0);
    Bounds<Geometry>& bounds = problem_.bounds;
    bounds = Bounds<Geometry>(options_.min_angle_in_degrees * degree,
                              options_.max_triangle_area * scale * scale, scale * options_.max_edge_length);
    bounds.least_squared_length = scale * scale * options_.min_edge_length * options_.min_edge_length;
    if (std::any_of(pslg_.regions.begin(), pslg_.regions.end(),
                    [](const auto& region) { return region.max_area > 0; }))
      set_region_bounds(scale * scale);
    if (options_.refined_where)
      bounds.is_refused = [this](const auto& a, const auto& b, const auto& c) {
        return options_.refined_where({map_.place(a), map_.place(b), map_.place(c)});
      };
    if (options_.size_field)
      bounds.squared_length_at = [this, scale](const typename Geometry::Point& p) {
        const auto [x, y] = map_.place(p);
        const double size = scale * options_.size_field(x, y);
        return size * size;
      };
  }

  /// \throws Pslg_error_2 if the mesh would surely be larger than the budget.
  void estimate_size() {
    const Size_estimate<Geometry> estimate(state_, Concurrency_tag());
    report_.estimated_triangles = estimate.triangles();
    const Triangle_budget budget(options_.vertex_budget);
    if (!budget.is_surely_exceeded_by(estimate.triangles())) return;
    std::string culprit = "for the bounds of size";
    if (estimate.worst_pair().triangles > estimate.triangles_of_sizes())
      culprit = Narrow_gap<Geometry>(state_, estimate.worst_pair())
                    .in_words([this](Vertex_id v) { return name_of_vertex(order_[std::size_t(v)]); },
                              map_.length_to_kernel(1.0));
    throw Pslg_error_2(budget.refusal_of(estimate.triangles()) + ' ' + culprit);
  }

  void set_region_bounds(double scale2) {
    std::vector<double>& bounds = problem_.bounds.area2_of_region;
    bounds.assign(pslg_.regions.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < bounds.size(); ++i)
      if (pslg_.regions[i].max_area > 0)
        bounds[i] = 2 * scale2 * pslg_.regions[i].max_area * (1 - Bounds<Geometry>::margin);
  }

  /// The segments in the kernel's numbering, which is the shuffle order.
  std::vector<typename First::Segment> kernel_segments() const {
    std::vector<Vertex_id> kernel_vertex(order_.size());
    for_each_index<Concurrency_tag>(
        order_.size(), [&](std::size_t i) { kernel_vertex[order_[i]] = static_cast<Vertex_id>(i); });
    std::vector<typename First::Segment> segments(pslg_.number_of_segments());
    for_each_index<Concurrency_tag>(segments.size(), [&](std::size_t s) {
      const auto& [a, b] = pslg_.segments[s];
      segments[s] = {kernel_vertex[std::size_t(a)], kernel_vertex[std::size_t(b)]};
    });
    return segments;
  }

  std::string describe(const First& first, const Crossing& crossing) const {
    std::ostringstream text;
    text << "segment " << crossing.segment << " (" << name_of_ends(crossing.segment) << ") crosses segment ";
    for (const Input_edge& e : first.edges()) {
      if ((e.a != crossing.a || e.b != crossing.b) && (e.a != crossing.b || e.b != crossing.a)) continue;
      text << e.segment << " (" << name_of_ends(e.segment) << ')';
      break;
    }
    return text.str();
  }

  std::string name_of_ends(std::int32_t segment) const {
    std::ostringstream text;
    text.precision(17);
    const auto& ends = pslg_.segments[std::size_t(segment)];
    const Point_2 &p = pslg_.point(ends[0]), &q = pslg_.point(ends[1]);
    text << "vertices " << ends[0] << " at " << p.x() << ' ' << p.y() << " and " << ends[1] << " at " << q.x()
         << ' ' << q.y();
    return text.str();
  }

  std::string name_of_vertex(std::size_t v) const {
    std::ostringstream text;
    text.precision(17);
    text << "vertex " << v << " at " << pslg_.vertices[v].x() << ' ' << pslg_.vertices[v].y();
    return text.str();
  }

  std::size_t vertex_budget() const {
    if (options_.vertex_budget > 0) return options_.vertex_budget;
    // What 32-bit handles allow, and a large multiple of what is to be expected: no proof says that refinement ends.
    // What a rule of the user's asks for cannot be expected.
    const double patience = options_.refinement_patience, unexpected = options_.refined_where ? 2e7 : 2e6;
    return at_most_handles(patience * expected_vertices() + (patience > 0 ? unexpected : 0));
  }

  double expected_vertices() const {
    return static_cast<double>(pslg_.number_of_vertices()) + report_.estimated_triangles;
  }
  static std::size_t at_most_handles(double vertices) {
    return static_cast<std::size_t>(std::min(static_cast<double>(Triangle_budget::most_vertices), vertices));
  }

  /// Quadtrees make ten times the triangles needed, a hundred times with the placement by rule.
  std::size_t budget_of_construction() const {
    if (options_.vertex_budget > 0) return options_.vertex_budget;
    return at_most_handles(1000 * expected_vertices() + 1e7);
  }

  /// False if quadtrees have to take over.
  bool refine(Refiner<Geometry>& refiner, Splitter<Geometry>& splitter) {
    Phase_timer timer(report_.seconds.refine);
    splitter.cut_rings();
    Bulk_filler<Concurrency_tag, Geometry>(state_).run(vertex_budget());
    Block_refinement<Concurrency_tag, Geometry> blocks(state_, finishing_, vertex_budget());
    if (blocks.run([this] { return shall_go_on(0.2); }))
      finishing_.smoothing_rounds = 0; // done, and removal is left only at seams
    else
      refiner.push_all();
    if (run(refiner, vertex_budget()) == Refinement_end::out_of_budget) {
      if (may_construct_instead()) return false;
      report_.is_budget_exhausted = true;
    }
    splitter.unlock_all();
    state_.legalize();
    return true;
  }

  /// Above the bounds that are established for refinement, triangles left are no sign that quadtrees do better; and they
  /// know no least edge, nor rules of the user's.
  bool may_construct_instead() const {
    return options_.vertex_budget == 0 && options_.min_edge_length == 0 && !options_.refined_where &&
           problem_.bounds.is_established();
  }

  Refinement_end run(Refiner<Geometry>& refiner, std::size_t budget) {
    ++report_.rounds;
    const std::size_t n = pslg_.number_of_vertices();
    return refiner.run(budget, [this, n] {
      const double made = static_cast<double>(state_.mesh.number_of_vertices() - n) + 1;
      return shall_go_on(0.2 + 0.6 * made / (made + 3 * static_cast<double>(n)));
    });
  }

  void run_to_the_end(Refiner<Geometry>& refiner, std::size_t budget) {
    if (run(refiner, budget) == Refinement_end::out_of_budget) report_.is_budget_exhausted = true;
  }

  /// Makes a mesh by quadtrees, and refines what is too large in it, or could not be cured.
  void construct_by_trees(Refiner<Geometry>& refiner) {
    if (make_mesh_by_trees() == Construction_end::out_of_budget) report_.is_budget_exhausted = true;
    Phase_timer timer(report_.seconds.refine);
    refiner.push_all();
    run_to_the_end(refiner, budget_of_repair());
    state_.legalize();
    if (options_.coarsening == Quality_mesh_options_2::Coarsening::NONE) return;
    finishing_.smoothing_rounds = std::max(options_.smoothing_rounds, rounds_after_construction_);
    finishing_.thinning_rounds = std::max(options_.thinning_rounds, rounds_after_construction_);
  }

  /// For what refinement has to do in a mesh that is made.
  std::size_t budget_of_repair() const {
    if (options_.vertex_budget > 0) return options_.vertex_budget;
    return at_most_handles(static_cast<double>(state_.mesh.number_of_vertices()) + 10 * expected_vertices() +
                           2e6);
  }

  Construction_end make_mesh_by_trees() {
    const Pslg graph = graph_of_edges();
    std::optional<Separation_trees<Traits, Concurrency_tag>> trees;
    {
      Phase_timer timer(report_.seconds.trees);
      trees.emplace(problem_, *edge_sides_, graph, map_, options_.trees, traits_, find_hits_, budget_of_construction(),
                    report_.trees);
    }
    Phase_timer timer(report_.seconds.construct);
    state_.corners.forget_cuts();
    Tree_construction<Traits, Concurrency_tag> construction(state_, *trees, map_, is_merged_, domain_,
                                                            report_.trees);
    return construction.run(options_.trees.placement, budget_of_construction(),
                            [this] { return shall_go_on(0.3); });
  }

  /// The input, in the kernel's order and with its edges: segments cut where vertices lie on them.
  Pslg graph_of_edges() const {
    Pslg graph;
    graph.vertices.reserve(order_.size());
    for (std::size_t v = 0; v < order_.size(); ++v) graph.vertices.push_back(pslg_.vertices[order_[v]]);
    for (std::size_t e = 0; e < problem_.edges.size(); ++e) {
      const Input_edge& edge = problem_.edges[static_cast<Edge_id>(e)];
      graph.add_segment(Vertex_index(std::size_t(edge.a)), Vertex_index(std::size_t(edge.b)));
    }
    return graph;
  }

  void coarsen() {
    Phase_timer timer(report_.seconds.coarsen);
    if (is_cancelled_) return;
    finish_mesh(state_, finishing_, [this] { return shall_go_on(0.85); });
    for (int round = 0; round < finishing_.thinning_rounds; ++round)
      if (!Thinner<Geometry>(state_).run(budget_of_repair(), [this] { return shall_go_on(0.9); })) return;
  }

  /// Makes the mesh exactly constrained Delaunay. Such flips never lower the least angle of a pair; should
  /// one take apart an exempt triangle all the same, what it leaves is refined again.
  void finish(Refiner<Geometry>& refiner) {
    Phase_timer timer(report_.seconds.refine);
    constexpr int most_rounds = 5;
    for (int round = 0; round < most_rounds; ++round) {
      state_.template make_Delaunay_exactly<Concurrency_tag>();
      if (!has_bad_on_worklist() || is_cancelled_ || report_.is_budget_exhausted) return;
      run_to_the_end(refiner, budget_of_repair());
    }
    state_.template make_Delaunay_exactly<Concurrency_tag>();
  }

  bool has_bad_on_worklist() {
    std::vector<Triangle_id> bad;
    while (!state_.worklist.is_empty()) {
      const Triangle_id t = state_.worklist.pop();
      if (state_.mesh.is_alive(t) && state_.is_bad(t)) bad.push_back(t);
    }
    for (const Triangle_id t : bad) state_.worklist.push(t);
    return !bad.empty();
  }

  Indexed_mesh_2<Point_2> convert() {
    Phase_timer timer(report_.seconds.convert);
    Kernel_mesh_converter<Traits, Concurrency_tag> converter(state_, pslg_, map_, order_, report_);
    return converter.run();
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_PIPELINE_H
