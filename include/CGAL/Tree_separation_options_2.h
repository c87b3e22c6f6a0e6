// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Options of the quadtrees that separate the features of a graph (Theorem 5).

#ifndef CGAL_TREE_SEPARATION_OPTIONS_2_H
#define CGAL_TREE_SEPARATION_OPTIONS_2_H

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Options of the construction by quadtrees of Bern, Eppstein and Teng, section 6. All lengths are in sides of
/// leaves. Each setter returns the object, so that calls can be chained.
struct Tree_separation_options_2 {
  /// How edges are cut into pieces. The pieces are the same.
  enum class Subdivision {
    WALKING,      ///< from leaf to leaf (Theorem 6)
    CENTROID_TREE ///< by accelerated centroid trees, in O(log n) rounds
  };
  /// Where vertices are placed in leaves near an edge or a vertex of the graph.
  enum class Placement {
    /// Corners that a rule keeps. Corners are left out if nearby triangles that miss the bound meet it
    /// without them. Leaves are split only where that does not help.
    CHOSEN,
    /// Corners that the rule keeps, and nothing else. Leaves along edges are split until the rule is certain
    /// to meet the bound (doc/guarantees.md). This makes many more triangles.
    BY_RULE
  };

  /// The side of a vertex's leaf is at most the distance to the nearest feature divided by this.
  double vertex_distance = 0.7;
  /// Two edges in a leaf, or in adjacent leaves, that see each other are at least this far apart.
  double edge_distance = 0.5;
  /// Edges that share a vertex may be nearer to each other within this distance from it.
  double vertex_window = 3;
  /// Edges of an acute corner may also be nearer where the corner is at most this wide. No vertex is placed
  /// between them there.
  double strip_width = 1.25;

  Subdivision subdivision = Subdivision::WALKING; ///< how edges are cut
  Placement placement = Placement::CHOSEN;        ///< where vertices are placed

  /// \name Setters
  /// @{

  /// Each sets what its name says and returns the options, so that calls can be chained.
  Tree_separation_options_2& distances(double of_vertices, double of_edges) {
    vertex_distance = of_vertices, edge_distance = of_edges;
    return *this;
  }
  Tree_separation_options_2& subdivide(Subdivision s) { return subdivision = s, *this; }
  Tree_separation_options_2& place(Placement p) { return placement = p, *this; }
  /// @}

  /// The constant that the paper names as an example: a square of an edge is at least three times its side
  /// away from any vertex or other edge.
  static Tree_separation_options_2 of_paper() { return Tree_separation_options_2().distances(3, 3); }
};

} // namespace CGAL

#endif // CGAL_TREE_SEPARATION_OPTIONS_2_H
