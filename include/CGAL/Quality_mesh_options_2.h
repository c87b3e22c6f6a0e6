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
/// What `Quality_mesher_2` shall reach. Every field has its default; set fields directly or by chained calls:
/// `Quality_mesh_options_2().min_angle(25).max_area(0.1)`.
struct Quality_mesh_options_2 {
  /// Which of the components that the segments cut the plane into are meshed. Of two components that a
  /// segment separates each is judged by itself; the unbounded one is never meshed, and one with a point of
  /// `Pslg_2::holes` neither.
  enum class Domain {
    /// All bounded components: Triangle's rule, and that of `refine_Delaunay_mesh_2()` with seeds in holes.
    ENCLOSED,
    /// The components with a point of `Pslg_2::regions`, as with Mesh_2's seeds in the domain.
    MARKED,
    /// The components that one gets into from infinity by crossing an odd number of segments at least, as by
    /// `mark_domain_in_triangulation()`: borders in borders are holes, islands in holes are not.
    NESTING_PARITY
  };
  /// How the features of the input are separated.
  enum class Separation {
    ON_DEMAND, ///< where a triangle asks for it, a vertex at a time: fewer triangles in less time
    THEOREM_5  ///< by the quadtrees of Bern, Eppstein and Teng: `Tree_separation_options_2`
  };
  /// Whether Steiner vertices that are not needed are removed at the end.
  enum class Coarsening { NONE, GUARDED_REMOVAL };

  /// Least angle in degrees of every triangle that no acute input corner forces below it, in [0, 30].
  /// Up to 20.7 it was reached on all inputs of the soak (doc/soak.md); whatever is left is reported.
  double min_angle_in_degrees = 20.7;
  /// Longest edge, in the units of the input; 0 means no bound.
  double max_edge_length = 0;
  /// Largest area of a triangle, in squared units of the input; 0 means no bound.
  double max_triangle_area = 0;
  /// The longest edge wanted of a triangle with its centroid at (x, y), in the units of the input; positive.
  /// Empty: no such bound. It is called by several threads at once with `Parallel_tag`.
  std::function<double(double, double)> size_field;
  /// The corners of a triangle, (x, y) each, counterclockwise.
  using Corners = std::array<std::array<double, 2>, 3>;
  /// Whether a triangle shall be refined that meets all other bounds: what no bound of size can say. Empty: none. It is
  /// called by several threads at once with `Parallel_tag`, for triangles that come and go, and has to answer the same
  /// whenever it is asked. Where no triangle ever satisfies it, refinement stops with the vertex budget, or without
  /// one with twenty million vertices more than else.
  std::function<bool(const Corners&)> refined_where;
  /// Refinement inserts no vertex nearer than this to one in sight, in the units of the input; triangles that
  /// miss a bound for that are left, and reported with the reason LEAST_EDGE. 0 means no such rule.
  double min_edge_length = 0;
  Domain domain = Domain::ENCLOSED;                    ///< what is meshed
  Separation separation = Separation::ON_DEMAND;       ///< how features are kept apart
  Tree_separation_options_2 trees;                     ///< what the construction by quadtrees does
  Coarsening coarsening = Coarsening::GUARDED_REMOVAL; ///< whether vertices go that are not needed
  /// Rounds of smoothing, each followed by removal if that is wanted: a percent or two fewer triangles and better
  /// angles for about as much time as refinement takes.
  int smoothing_rounds = 0;
  /// Rounds in which vertices are removed although that makes angles below the bound, and these refined again: on
  /// maps 4 to 5 percent fewer triangles in the first and one in the second, each for about as much time as refinement
  /// takes. Meshes of up to 1000 triangles are thinned and smoothed in any case, unless `coarsening` is `NONE`.
  int thinning_rounds = 0;
  /// Where refinement on demand has not come to rest when the mesh has this many times the vertices expected (and two
  /// million more), the construction by quadtrees takes over, and `Quality_mesh_report_2::trees` says so. With 0 that is
  /// at once. For bounds above 20.7048 degrees (sin^2 = 1/8), and with a least edge or a rule of the user's, quadtrees
  /// cannot: this is not looked at then, refinement stops with 100 times the vertices expected, and what is left is
  /// reported. A vertex budget takes the place of all this.
  double refinement_patience = 100;
  /// Patience ends, too, when the mesh is so many bytes large, by an estimate of 256 bytes for a vertex (more over exact
  /// numbers), but not below 10 times the vertices expected and two million more.
  double memory_of_patience = 2e9;
  /// Refinement stops, with what is left reported, when the mesh has this many vertices; 0 means no bound but
  /// memory's.
  std::size_t vertex_budget = 0;
  /// Called now and then with the share of work done, in [0, 1]; returning false stops with the mesh so far. With
  /// `Parallel_tag` any thread may call it, one at a time.
  std::function<bool(double)> callback;

  /// \name Setters
  /// @{

  /// Each sets what its name says and returns the options, so that calls can be chained. `separate()` with the options
  /// of the construction by quadtrees chooses that, too.
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
