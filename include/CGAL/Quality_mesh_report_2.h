// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUALITY_MESH_REPORT_2_H
#define CGAL_QUALITY_MESH_REPORT_2_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// What a construction by quadtrees did (Theorem 5); all 0 if there was none.
struct Tree_separation_report_2 {
  /// How the construction ended. Refinement on demand then takes up whatever is not done: without `rounds`, or at the
  /// end of a budget, all.
  enum class End {
    NONE,        ///< there was no construction
    DONE,        ///< no triangle is below the bound
    ROUNDS,      ///< the rounds wanted are made, and refinement cures what they missed
    COORDINATES, ///< triangles are left because coordinates have no room for smaller leaves
    BUDGET,      ///< trees or rounds take more than the budget
    CANCELLED,   ///< the callback stopped it
    FAILED       ///< vertices are too near each other for the grid of quadtrees; refinement went on
  };

  End end = End::NONE; ///< how it ended
  bool has_taken_over =
      false; ///< whether refinement on demand did not come to rest (`Quality_mesh_options_2::patience()`)
  /// So many components of the domain alone were constructed, because refinement came to rest in all others, or goes on
  /// there; 0 if the whole mesh was. All that follows is then about those constructed last.
  std::size_t islands = 0;
  std::size_t leaves_of_points = 0;   ///< leaves of T_B, the quadtree of the vertices; 0 if it was not needed
  std::size_t leaves_of_vertices = 0; ///< leaves of T_B', in which vertices are separated
  std::size_t leaves_of_pieces = 0;   ///< leaves of T_B'', in which edges within leaves are separated
  std::size_t leaves_of_edges = 0;    ///< leaves of T_B*, in which everything is separated
  std::size_t rounds = 0;             ///< rounds of placing vertices and splitting leaves
  std::size_t splits = 0;             ///< how many times all leaves that were too large were split at once
  std::size_t leaf_tests = 0;         ///< how many times the edges in or around a leaf were compared
  std::size_t leaves_made = 0;        ///< leaves of all trees: of T_B', and after each split
  std::size_t pieces_cut = 0;         ///< pieces into which edges were cut in all of these trees
  // With Subdivision::CENTROID_TREE:
  std::size_t subdivision_rounds = 0; ///< rounds of all subdivisions
  int centroid_height = 0;            ///< of the tallest centroid tree in the last subdivision
  std::size_t windows = 0; ///< vertices at which a rule is certain to meet the bound, after failures
  std::size_t failed_windows =
      0; ///< triangles that this rule missed there in any round: 0, if its proof is right
  // Of all rounds since the mesh was made; most of them change it where leaves were split:
  std::size_t missed_by_rule = 0; ///< triangles below the bound, before cures
  std::size_t left_out = 0;       ///< corners and crossings left out to cure these
  std::size_t relocated = 0;      ///< corners and crossings moved to cure others
  std::size_t added = 0;          ///< vertices that leaves did not place, which cure others
  std::size_t placed = 0; ///< vertices besides those of the input, whether they are still there or not
  std::size_t kept = 0;   ///< those of them in the mesh, where the work on it left them
  // Of the last round:
  std::size_t triangles = 0;   ///< of the mesh, before its cures
  std::size_t missed = 0;      ///< triangles below the bound that were not cured
  std::size_t handed_over = 0; ///< those of them at leaves that cannot become smaller
};

/// \ingroup PkgQuadtreeMesh2Meshers
/// What `Quality_mesher_2` reached, what it did not, and where.
struct Quality_mesh_report_2 {
  /// What kept refinement from meeting a bound in a triangle.
  enum class Reason {
    BUDGET,       ///< the vertex budget was used up
    CANCELLED,    ///< the callback stopped refinement
    LEAST_EDGE,   ///< a vertex would have come nearer to another than `Quality_mesh_options_2::min_edge()`
    KEPT_SEGMENT, ///< a segment that gets no vertices is in the way (`Quality_mesh_options_2::keep_borders()`)
    CORNER,       ///< above 20.7 degrees: the legs of an acute corner are split no nearer to its apex
    /// `Quality_mesh_options_2::max_angle()` is tried alone, and nothing that is tried helped.
    GREATEST_ANGLE,
    COORDINATES, ///< there is no room for a vertex between representable coordinates
    CRITERIA     ///< the user's criteria call it bad
  };
  /// A triangle that misses a bound, not excused by an acute input corner.
  struct Unmet_triangle {
    Quadtree_mesh_2::Triangle_index triangle; ///< its index in the mesh
    std::array<double, 2> centroid;           ///< where it is
    double least_angle;                       ///< degrees
    Reason reason;                            ///< what kept refinement from curing it
    /// With the reason KEPT_SEGMENT, the index of the segment in the input; else none.
    Quadtree_mesh_2::Segment_index segment = {};
    double greatest_angle = 0; ///< in degrees, too
  };
  /// A triangle with an angle below the least or above the greatest one that an acute input corner excuses.
  struct Exempt_triangle {
    Quadtree_mesh_2::Triangle_index triangle; ///< its index in the mesh
    Quadtree_mesh_2::Vertex_index corner;     ///< the input vertex in which the two segments meet
  };
  /// Seconds by phase.
  struct Seconds {
    double quadtree = 0;   ///< shuffle order
    double first_mesh = 0; ///< constrained Delaunay triangulation of the input, domain, corners
    double trees = 0;      ///< the quadtrees of Theorem 5
    double construct = 0;  ///< rounds of placing vertices by them
    double refine = 0;     ///< including the removal that large meshes do in blocks, and islands by quadtrees
    double coarsen = 0;    ///< removal, smoothing and thinning
    double convert = 0;    ///< to Indexed_mesh_2
  };

  std::size_t input_vertices = 0;       ///< the number of vertices of the graph
  std::size_t input_segments = 0;       ///< the number of segments of the graph
  std::size_t vertices = 0;             ///< vertices that a triangle uses
  std::size_t triangles = 0;            ///< of the mesh
  std::size_t merged_vertices = 0;      ///< input vertices at the place of an earlier one
  std::size_t vertices_on_segments = 0; ///< input vertices found in the interior of an input segment
  /// Triangles inside a wedge of two input segments with an angle below the bound, never under 0.9 of the wedge's; and,
  /// where there is a bound on the greatest angle, those with an angle above it.
  std::vector<Exempt_triangle> exempt_triangles;
  /// All other triangles that miss a bound, with the reason.
  std::vector<Unmet_triangle> unmet_triangles;
  /// With `Quality_mesh_options_2::Conforming::DELAUNAY`, the edges on segments that are not Delaunay all the same: a
  /// budget, the callback, the least edge or the precision of the coordinates kept them from being split.
  std::size_t encroached_edges = 0;
  /// `least_angle_histogram[i]` triangles have their least angle in [i, i + 1) degrees, up to 60.
  std::array<std::size_t, 60> least_angle_histogram{};
  /// `largest_angle_histogram[i]` triangles have their largest angle in [60 + i, 61 + i) degrees, up to 180.
  std::array<std::size_t, 120> largest_angle_histogram{};
  /// The number of triangles needed, estimated before refinement from the triangulation of the input. For
  /// most inputs it is within a factor of 4.
  double estimated_triangles = 0;
  std::size_t rounds = 0;           ///< rounds of refinement and what follows it
  Tree_separation_report_2 trees;   ///< what the construction by quadtrees did
  bool is_cancelled = false;        ///< whether the callback stopped refinement
  bool is_budget_exhausted = false; ///< whether the bound on the number of vertices stopped it
  Seconds seconds;                  ///< of processors
  Seconds wall_seconds;             ///< by the clock

  /// Whether every triangle meets all bounds or is exempt, and edges are Delaunay where that is wanted.
  bool is_met() const { return unmet_triangles.empty() && encroached_edges == 0; }
};

} // namespace CGAL

#endif // CGAL_QUALITY_MESH_REPORT_2_H
