// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// How the mesher separates the features of a graph by quadtrees (Theorem 5).

#ifndef CGAL_TREE_SEPARATION_OPTIONS_2_H
#define CGAL_TREE_SEPARATION_OPTIONS_2_H

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Options of the construction by quadtrees of Bern, Eppstein and Teng, section 6. All lengths are in sides of
/// leaves. Each setter returns the object, so that calls can be chained.
struct Tree_separation_options_2 {
  /// What cuts edges into pieces; the pieces are the same.
  enum class Subdivision {
    WALKING,      ///< from leaf to leaf (Theorem 6)
    CENTROID_TREE ///< by accelerated centroid trees, in O(log n) rounds
  };
  /// Where the vertices are put in leaves that an edge or a vertex of the graph is near to.
  enum class Placement {
    /// Corners that a rule keeps, less those without which nearby triangles that miss the bound meet it. Leaves are
    /// split only where that does not help.
    CHOSEN,
    /// Corners that the rule keeps, and nothing else. Leaves along edges are split until the rule is certain to
    /// keep to the bound (doc/guarantees.md): many more triangles.
    BY_RULE
  };

  /// The leaf of a vertex has at most its distance to the nearest feature, divided by this.
  double vertex_distance = 0.7;
  /// Two edges in a leaf, or in one next to it, that see each other are at least so far apart.
  double edge_distance = 0.5;
  /// Nearer than this to the vertex that they share, edges may be nearer to each other.
  double vertex_window = 3;
  /// And where an acute corner between them is at most this wide: nothing is put between them there.
  double strip_width = 1.25;

  Subdivision subdivision = Subdivision::WALKING; ///< how edges are cut
  Placement placement = Placement::CHOSEN;        ///< where vertices are put

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

  /// The constant that the paper names as an example: no vertex or other edge passes an edge's square at less than
  /// three times its side.
  static Tree_separation_options_2 of_paper() { return Tree_separation_options_2().distances(3, 3); }
};

} // namespace CGAL

#endif // CGAL_TREE_SEPARATION_OPTIONS_2_H
