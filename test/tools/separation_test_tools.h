// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SEPARATION_TEST_TOOLS_H
#define QUADTREE_MESH_2_TEST_SEPARATION_TEST_TOOLS_H

// The quadtrees that separate a graph, without the mesher around them.

#include "pslg_test_tools.h"

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/Tree_separation_options_2.h>

#include <CGAL/Quadtree_mesh_2/internal/refinement/Corner_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Geodesic_distance.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quality_mesher_2.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

namespace separation_test {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Point_index;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Vertex_index;
using Tree_options = CGAL::Tree_separation_options_2;

/// A graph as the mesher prepares it: in the order of its vertices, segments cut where vertices lie on them, the
/// outside found, acute corners found.
/// \pre no two vertices are at one place
template <class Traits, class ConcurrencyTag = CGAL::Sequential_tag>
class Prepared_graph {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  using Point_2 = typename Traits::Point_2;
  using Pslg = CGAL::Pslg_2<Point_2>;
  using Trees = internal::Separation_trees<Traits, ConcurrencyTag>;
  using Map = typename Trees::Map;

  explicit Prepared_graph(const Pslg& pslg) : map_(pslg.vertices) {
    using First = internal::First_triangulation<ConcurrencyTag, Geometry>;
    std::vector<typename Geometry::Point> points;
    for (const Point_2& p : pslg.vertices) points.push_back(map_.to_kernel(p));
    std::vector<typename First::Segment> segments;
    for (const auto& s : pslg.segments)
      segments.push_back(
          {static_cast<internal::Vertex_id>(s[0].value()), static_cast<internal::Vertex_id>(s[1].value())});
    First first(state_.mesh, points);
    if (first.run(segments)) throw std::invalid_argument("segments cross");
    problem_.edges = internal::Input_edges(first.edges(), points.size());
    problem_.edges.list_by_vertices();
    problem_.input_points.assign(points.begin(), points.end());
    internal::Domain_rule<Geometry> domain;
    for (const Point_2& p : pslg.holes) domain.holes.push_back(map_.to_kernel(p));
    problem_.set_outside(domain.apply(state_.mesh, First::number_of_auxiliary_vertices));
    sides_.emplace(state_.mesh, problem_.edges);
    problem_.bounds = internal::Bounds<Geometry>(20.7 * CGAL_PI / 180, 0, 0);
    internal::Size_estimate<Geometry> estimate(state_, ConcurrencyTag());
    internal::Corner_finder<ConcurrencyTag, Geometry>(state_, estimate.take_acute_starts()).run();
    graph_.vertices = pslg.vertices;
    for (std::size_t e = 0; e < problem_.edges.size(); ++e) {
      const auto& edge = problem_.edges[static_cast<internal::Edge_id>(e)];
      graph_.add_segment(Vertex_index(std::size_t(edge.a)), Vertex_index(std::size_t(edge.b)));
    }
  }
  Prepared_graph(const Prepared_graph&) = delete;
  Prepared_graph& operator=(const Prepared_graph&) = delete;

  /// \param options are kept by reference
  /// \param find_hits null: by the quadtree
  Trees trees(const Tree_options& options, internal::Find_nearest_hits<Pslg> find_hits = nullptr) {
    constexpr std::size_t most_leaves = 100000000;
    report = CGAL::Tree_separation_report_2();
    return Trees(problem_, *sides_, graph_, map_, options, Traits(), state_.mesh, find_hits, most_leaves,
                 report);
  }

  std::vector<double> geodesic_distances() const {
    const internal::Geodesic_distance<Geometry> distance(state_.mesh);
    std::vector<double> distances;
    for (std::size_t v = 0; v < graph_.number_of_vertices(); ++v)
      distances.push_back(distance(internal::Vertex_id(v)));
    return distances;
  }

  const internal::Meshing_problem<Geometry>& problem() const { return problem_; }
  internal::Meshing_state<Geometry>& state() { return state_; }
  const internal::Edge_sides& sides() const { return *sides_; }
  const Pslg& graph() const { return graph_; }
  const Map& map() const { return map_; }

  CGAL::Tree_separation_report_2 report; ///< of the last trees

private:
  Map map_;
  internal::Meshing_problem<Geometry> problem_;
  internal::Meshing_state<Geometry> state_{problem_};
  std::optional<internal::Edge_sides> sides_;
  Pslg graph_;
};

/// What keeps a mesh from being a constrained Delaunay triangulation.
struct Mesh_flaws {
  std::size_t clockwise = 0; ///< triangles, or without area
  std::size_t not_Delaunay =
      0; ///< sides, as seen from both of their triangles: rounding is another one from there

  bool is_any() const { return clockwise + not_Delaunay > 0; }
};

template <class Geometry>
Mesh_flaws flaws_of(const internal::Kernel_mesh<Geometry>& mesh) {
  Mesh_flaws flaws;
  for (const internal::Triangle_id t : mesh.triangles.ids()) {
    if (!mesh.is_alive(t)) continue;
    const auto& r = mesh.triangle(t);
    flaws.clockwise += mesh.orientation(r.v[0], r.v[1], r.v[2]) > 0 ? 0 : 1;
    for (int k = 0; k < 3; ++k) {
      const internal::Side o = r.side[k];
      flaws.not_Delaunay += !o.is_constrained() && mesh.is_certainly_not_Delaunay(t, k) &&
                                    mesh.is_certainly_not_Delaunay(o.triangle(), o.slot())
                                ? 1
                                : 0;
    }
  }
  return flaws;
}

/// The squares of the leaves, which tell all of a tree.
template <class Tree>
auto leaves_of(const Tree& tree) {
  std::vector<typename Tree::Square> squares;
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) squares.push_back(tree.square(Leaf_index(l)));
  return squares;
}

} // namespace separation_test

#endif // QUADTREE_MESH_2_TEST_SEPARATION_TEST_TOOLS_H
