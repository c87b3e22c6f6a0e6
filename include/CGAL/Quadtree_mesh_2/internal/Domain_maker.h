// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The first stages of the mesher of graphs: from vertices in shuffle order to the triangulation of the domain.
//
// Computes: the mesh of the domain, in which no edge is cut, and what the problem knows of the graph.
// Bound:    that of First_triangulation.h and Domain_rule.h.
// Method:   Memory is fullest while the domain is cut out of the first triangulation. So the table of the edges is made
//           after that.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DOMAIN_MAKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DOMAIN_MAKER_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/check_coordinates.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Input_words.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/kernel_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Rounds_runner.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/kept_edges.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class ConcurrencyTag>
class Domain_maker {
public:
  using Geometry = Mesher_geometry<Traits>;
  using Map = Coordinate_map<Traits, Geometry>;
  using Point_2 = typename Traits::Point_2;

  /// \param state whose mesh is empty, and whose problem knows the blocks of the vertices
  Domain_maker(const Pslg_2<Point_2>& pslg, const Order& order, const Map& map,
               const Input_words<Point_2>& words, Meshing_state<Geometry>& state)
      : pslg_(pslg), order_(order), map_(map), words_(words), mesh_(state.mesh), problem_(state.problem) {}

  /// Gives the mesh its points, and nothing else yet.
  /// \throws Pslg_error_2 if the kernel does not have one of the input's
  void place_points() {
    auto& points = mesh_.points;
    points.reserve(First::room_for(pslg_.number_of_vertices()));
    points.resize(pslg_.number_of_vertices());
    for_each_index<ConcurrencyTag>(points.size(), [&](std::size_t v) {
      points[static_cast<Vertex_id>(v)] = map_.to_kernel(pslg_.vertices[order_[v]]);
    });
    if constexpr (Map::may_lose_points) check_points_are_kept(pslg_, map_, words_);
  }

  /// Finds between which vertices the segments run. The graph's vertices and segments are not needed after that, except
  /// for errors.
  void place_segments() { made_.edges.segments = kernel_segments<ConcurrencyTag>(pslg_, order_); }

  /// \pre the points and segments are placed
  /// \param runner who may make the mesh in the place of this; or null
  /// \param between_steps called when much memory is free that was in small pieces
  /// \throws Pslg_error_2 if segments cross, if there is no domain, or none that the seeds tell
  template <class Between_steps>
  void run(const Quality_mesh_options_2& options, Quality_mesh_report_2& report,
           Rounds_runner<Geometry>* runner, const Between_steps& between_steps) {
    const Domain_rule<Geometry> rule = domain_rule(options);
    if (runner == nullptr || !runner->make_first_mesh(mesh_, problem_.vertex_blocks, rule, made_)) {
      triangulate();
      between_steps();
      keep_domain(options, rule);
    }
    report.merged_vertices = made_.merged_vertices;
    report.vertices_on_segments = made_.vertices_on_segments;
    list_edges(options);
    if (mesh_.triangles.empty()) throw words_.no_domain(options.mesh_domain(), problem_.edges);
    problem_.set_outside(std::exchange(made_.outer, {}));
    keep_boundary(options, mesh_, problem_.edges, problem_.kept_edges);
  }

private:
  using First = First_triangulation<ConcurrencyTag, Geometry>;

  const Pslg_2<Point_2>& pslg_;
  const Order& order_;
  const Map& map_;
  const Input_words<Point_2>& words_;
  Kernel_mesh<Geometry>& mesh_;
  Meshing_problem<Geometry>& problem_;
  First_mesh made_; // until they are in the first triangulation, its edges are the segments

  void triangulate() {
    First first(mesh_, std::move(problem_.vertex_blocks));
    if (const auto crossing = first.run(std::exchange(made_.edges.segments, {})))
      throw words_.crossing(first.edges(), *crossing);
    made_.merged_vertices = first.number_of_repeated_vertices();
    made_.vertices_on_segments = first.number_of_vertices_on_segments();
    problem_.vertex_blocks = first.take_vertex_blocks();
    made_.edges = first.take_edges(), made_.repeated_edges = first.take_repeated_edges();
  }

  Domain_rule<Geometry> domain_rule(const Quality_mesh_options_2& options) const {
    Domain_rule<Geometry> domain;
    domain.rule = options.mesh_domain();
    for (const Point_2& p : pslg_.holes) domain.holes.push_back(map_.to_kernel(p));
    for (const auto& region : pslg_.regions) domain.regions.push_back(map_.to_kernel(region.point));
    return domain;
  }

  void keep_domain(const Quality_mesh_options_2& options, const Domain_rule<Geometry>& rule) {
    try {
      made_.outer = rule.apply(mesh_, First::number_of_auxiliary_vertices);
    } catch (const Ambiguous_seed& seed) {
      list_edges(options);
      throw words_.ambiguous_seed(seed, problem_.edges);
    }
  }

  void list_edges(const Quality_mesh_options_2& options) {
    problem_.edges = Input_edges(std::exchange(made_.edges, {}), order_.size());
    problem_.kept_edges = kept_edges_of(options, pslg_, problem_.edges, made_.repeated_edges);
    problem_.edges.repeat(made_.repeated_edges);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DOMAIN_MAKER_H
