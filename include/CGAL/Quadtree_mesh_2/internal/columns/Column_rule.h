// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Which points of an edge, and which corners of leaves beside it, are vertices of the mesh.
//
// Computes: the vertices along an edge with |dy| <= |dx| (otherwise exchange x and y). Leaves of a 2:1
//           balanced quadtree meet the edge in columns: their sizes depend on the abscissa only. Points on
//           the edge are its crossings with the grid lines between columns, all of them and no others. A
//           corner is dropped if it is nearer to the edge than a threshold. The threshold depends only on the
//           corner's place relative to the next change of sizes. The mesh is the constrained Delaunay
//           triangulation of the rest.
// Bound:    O(1) for each corner. For every direction and offset of the edge no angle is less than
//           - 31.6 degrees where the edge passes through equal leaves,
//           - 21.5 degrees at a change of sizes with `one_rule`,
//           - 26.3 degrees with the better of `rule_b` and `rule_c`, chosen for each change and each side of
//             the edge (Column_window.h evaluates them). A leaf with a hanging node alone has 26.57.
//           test_column_rule.cpp proves it by branch and bound in integers. In sectors of at least 33 degrees at a
//           vertex amid equal leaves, no angle is less than 20.7 degrees with the best of `sector_thresholds`:
//           test_vertex_certificate.cpp (Vertex_window.h).
// Source:   Bern, Eppstein, Teng, section 6 (Theorem 5), asks for a placement with 18.43 degrees. The
//           crossings and the thresholds are ours. A search found the vectors with the best certificate.
// Deviates: the paper warps corners to the edge and shows the bound by cases. Here nothing moves, and no
//           choice depends on another one further along the edge.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_RULE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_RULE_H

#include <array>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Between equal columns a corner is kept if its distance to the edge is at least this times their width.
constexpr double equal_leaves_threshold = 0.625;

/// Of two least angles in degrees, the second is the larger one if it leads by this: more than rounding errors are.
constexpr double least_lead = 1e-9;

/// Least distances of kept corners to the edge at a change of sizes, in widths of the coarse columns. Let u be
/// the signed distance of a corner from the line between the columns, positive on the fine side.
struct Transition_thresholds {
  double before;  ///< u = -1
  double coarse;  ///< u = 0, corner of a coarse leaf
  double hanging; ///< u = 0, in the middle of a side of a coarse leaf
  double half;    ///< u = 1/2
  double one;     ///< u = 1
  double
      middle; ///< as `hanging`, if not both corners of the opposite side are kept on the same side of the edge
};

/// Good at every change of sizes.
constexpr Transition_thresholds one_rule{.444, .403, .368, .757, .461, 1.639};
/// Of these two, one is better than `one_rule` at every change of sizes.
constexpr Transition_thresholds rule_b{.519, .310, .613, .616, .366, 1.699};
constexpr Transition_thresholds rule_c{.545, 1.227, .463, .458, .384, .408};

/// Where a corner lies relative to the next change of sizes.
enum class Column_place { EQUAL_LEAVES, BEFORE, COARSE, HANGING, HALF, ONE };

/// Whether a corner belongs to a coarse leaf, or to fine ones only.
enum class Column_corner { OF_COARSE_LEAF, OF_FINE_LEAVES };

/// The place of a corner that is `fine_widths` widths of fine columns from the change, on the coarse side if
/// that is negative.
constexpr Column_place column_place(int fine_widths, Column_corner corner) {
  return fine_widths == -2 ? Column_place::BEFORE
         : fine_widths == 0
             ? (corner == Column_corner::OF_COARSE_LEAF ? Column_place::COARSE : Column_place::HANGING)
         : fine_widths == 1 ? Column_place::HALF
         : fine_widths == 2 ? Column_place::ONE
                            : Column_place::EQUAL_LEAVES;
}

/// The two corners of a coarse leaf opposite to a side with a hanging node.
enum class Opposite_corners {
  BOTH_KEPT, ///< on the hanging node's side of the edge
  NOT_BOTH_KEPT
};

/// The least distance to the edge of a kept corner; in widths of coarse columns, for `EQUAL_LEAVES` of the columns
/// beside it. `opposite` matters for `HANGING` only.
constexpr double least_distance(Column_place place, const Transition_thresholds& t,
                                Opposite_corners opposite) {
  switch (place) {
  case Column_place::BEFORE:
    return t.before;
  case Column_place::COARSE:
    return t.coarse;
  case Column_place::HANGING:
    return opposite == Opposite_corners::NOT_BOTH_KEPT && t.middle > t.hanging ? t.middle : t.hanging;
  case Column_place::HALF:
    return t.half;
  case Column_place::ONE:
    return t.one;
  default:
    return equal_leaves_threshold;
  }
}

/// Whether a corner is a vertex of the mesh.
/// \param distance to the edge, perpendicular, in the unit of `least_distance()`
constexpr bool is_kept(double distance, Column_place place, const Transition_thresholds& t,
                       Opposite_corners opposite = Opposite_corners::BOTH_KEPT) {
  return distance >= least_distance(place, t, opposite);
}

/// The points on all edges of a vertex amid equal leaves, in their sides. Distances are measured along the axis that
/// the edge follows more. Halfway between the two there is another point.
struct Vertex_ring {
  double radius;         ///< each edge has a point at this distance
  double least_crossing; ///< crossings with grid lines are used from this distance on
};
constexpr Vertex_ring vertex_ring{76. / 64, 176. / 64};

/// Which corners in a sector between two edges of a vertex are dropped, in sides of leaves.
struct Sector_thresholds {
  double clear_of_vertex; ///< those nearer to the vertex
  double clear_of_edge;   ///< those nearer to one of the two edges, on grid lines that are not far along it
};
/// In the order in which they are tried.
constexpr std::array<Sector_thresholds, 3> sector_thresholds{
    {{55. / 64, 54. / 64}, {74. / 64, 34. / 64}, {115. / 64, 14. / 64}}};

/// Where leaves are not equal (Tree_placement.h), feet of corners so many sides of leaves from a vertex are near it.
constexpr double vertex_reach = 3;

/// Grid lines that an edge crosses are far from its vertex if they are so many sides or more from the greater sides of
/// the vertex's leaf, less one, along the edge's axis. On them `equal_leaves_threshold` counts.
constexpr int first_far_line = 3;

/// Sectors of at least this many degrees have, by the best of the thresholds, angles of at least
/// `least_angle_of_sectors` degrees: test_vertex_certificate.cpp.
constexpr double least_sector = 33;
constexpr double least_angle_of_sectors = 20.7;

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_RULE_H
