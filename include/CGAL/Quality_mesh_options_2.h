// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUALITY_MESH_OPTIONS_2_H
#define CGAL_QUALITY_MESH_OPTIONS_2_H

#include <CGAL/Tree_separation_options_2.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Options of `Quality_mesher_2`. Every field has a default. Set fields directly or by chained calls:
/// `Quality_mesh_options_2().min_angle(25).max_area(0.1)`.
struct Quality_mesh_options_2 {
  /// Which components of the plane are meshed; segments separate components. Each component is judged by
  /// itself. The unbounded one is never meshed, nor is one with a point of `Pslg_2::holes`.
  enum class Domain {
    /// All bounded components, as by Triangle, and by `refine_Delaunay_mesh_2()` with seeds in holes.
    ENCLOSED,
    /// The components with a point of `Pslg_2::regions`, as by Mesh_2 with seeds in the domain.
    MARKED,
    /// The components that a path from infinity reaches only by crossing an odd number of segments or more,
    /// as by `mark_domain_in_triangulation()`: borders in borders are holes, islands in holes are not.
    NESTING_PARITY
  };
  /// How the features of the input are separated.
  enum class Separation {
    ON_DEMAND, ///< by constrained Delaunay refinement, a vertex at a time: fewer triangles in less time
    THEOREM_5  ///< by the quadtrees of Bern, Eppstein and Teng: `Tree_separation_options_2`
  };
  /// Whether superfluous Steiner vertices are removed at the end.
  enum class Coarsening { NONE, GUARDED_REMOVAL };

  /// Least angle in degrees of every triangle, in [0, 34], unless an acute input corner forces a smaller one.
  /// The soak (doc/soak.md) counts how often bounds up to 20.7 are met, and doc/guarantees.md those above, which
  /// are tried. The report lists what is left.
  double min_angle_in_degrees = 20.7;
  /// The greatest bound that is tried.
  static constexpr double greatest_min_angle_in_degrees = 34;
  /// Longest edge, in the units of the input; 0 means no bound.
  double max_edge_length = 0;
  /// Largest area of a triangle, in squared units of the input; 0 means no bound.
  double max_triangle_area = 0;
  /// The longest edge wanted of a triangle with its centroid at (x, y), in the units of the input; positive.
  /// An empty function means no such bound. With `Parallel_tag` several threads call it at once.
  std::function<double(double, double)> size_field;
  /// The corners of a triangle, (x, y) each, counterclockwise.
  using Corners = std::array<std::array<double, 2>, 3>;
  /// Whether to refine a triangle that meets all other bounds, for wishes that no bound of size can express.
  /// An empty function means none. With `Parallel_tag` several threads call it at once, for triangles that
  /// come and go. It must give the same answer whenever it is asked. If no triangle ever satisfies it,
  /// refinement stops at the vertex budget. Without a budget it stops at twenty million vertices more than
  /// without this function.
  std::function<bool(const Corners&)> refined_where;
  /// Refinement inserts no vertex nearer than this to another one in sight, in the units of the input.
  /// Triangles that miss a bound for this reason are left, and reported with the reason LEAST_EDGE. 0 means
  /// no such rule.
  double min_edge_length = 0;
  Domain domain = Domain::ENCLOSED;                    ///< what is meshed
  Separation separation = Separation::ON_DEMAND;       ///< how features are kept apart
  Tree_separation_options_2 trees;                     ///< options of the construction by quadtrees
  Coarsening coarsening = Coarsening::GUARDED_REMOVAL; ///< whether superfluous vertices are removed
  /// Rounds of smoothing, each followed by removal if that is chosen. A round gives a percent or two fewer
  /// triangles and better angles, for about the time of refinement.
  int smoothing_rounds = 0;
  /// Rounds of thinning. A round removes vertices even if angles then miss the bound, and refines these
  /// again. On maps the first round gives 4 to 5 percent fewer triangles and the second one percent, each for
  /// about the time of refinement.
  /// Meshes of up to 1000 triangles are thinned and smoothed in any case, unless `coarsening` is `NONE`.
  int thinning_rounds = 0;
  /// When the construction by quadtrees takes over because refinement on demand does not come to rest: when
  /// the mesh has this many times the expected vertices, and two million more. `Quality_mesh_report_2::trees`
  /// then says so. 0: use quadtrees immediately.
  ///
  /// Quadtrees cannot take over for bounds above 20.7048 degrees (sin^2 = 1/8), with a least edge, or with
  /// `refined_where`. The field is then ignored: refinement stops at 100 times the expected vertices, and
  /// what is left is reported. A vertex budget replaces all this.
  double refinement_patience = 100;
  /// Patience also ends when the mesh takes this many bytes, by an estimate of 256 bytes per vertex (more
  /// over exact numbers). But it does not end below 10 times the expected vertices and two million more.
  double memory_of_patience = 2e9;
  /// Refinement stops when the mesh has this many vertices, and what is left is reported. 0 means no bound
  /// but that of memory; for graphs of fewer than 1000 vertices without bounds of size it means two million.
  std::size_t vertex_budget = 0;
  /// Called now and then with the share of work done, in [0, 1]. Returning false stops with the mesh so far.
  /// With `Parallel_tag` any thread may call it, one at a time.
  std::function<bool(double)> callback;

  /// \name Setters
  /// @{

  /// Each sets what its name says and returns the options, so that calls can be chained. `separate()` with
  /// the options of the construction by quadtrees also chooses that construction.
  Quality_mesh_options_2& min_angle(double degrees) { return min_angle_in_degrees = degrees, *this; }
  Quality_mesh_options_2& max_edge(double length) { return max_edge_length = length, *this; }
  Quality_mesh_options_2& max_area(double area) { return max_triangle_area = area, *this; }
  Quality_mesh_options_2& size(std::function<double(double, double)> f) {
    return size_field = std::move(f), *this;
  }
  Quality_mesh_options_2& refine_where(std::function<bool(const Corners&)> f) {
    return refined_where = std::move(f), *this;
  }
  Quality_mesh_options_2& min_edge(double length) { return min_edge_length = length, *this; }
  Quality_mesh_options_2& mesh_domain(Domain d) { return domain = d, *this; }
  Quality_mesh_options_2& coarsen(Coarsening c) { return coarsening = c, *this; }
  Quality_mesh_options_2& smooth(int rounds) { return smoothing_rounds = rounds, *this; }
  Quality_mesh_options_2& thin(int rounds) { return thinning_rounds = rounds, *this; }
  Quality_mesh_options_2& separate(Separation s) { return separation = s, *this; }
  Quality_mesh_options_2& separate(const Tree_separation_options_2& t) {
    trees = t;
    return separate(Separation::THEOREM_5);
  }
  Quality_mesh_options_2& patience(double times) { return refinement_patience = times, *this; }
  Quality_mesh_options_2& patience_memory(double bytes) { return memory_of_patience = bytes, *this; }
  Quality_mesh_options_2& max_vertices(std::size_t n) { return vertex_budget = n, *this; }
  Quality_mesh_options_2& progress(std::function<bool(double)> f) { return callback = std::move(f), *this; }
  /// @}
};

} // namespace CGAL

#endif // CGAL_QUALITY_MESH_OPTIONS_2_H
