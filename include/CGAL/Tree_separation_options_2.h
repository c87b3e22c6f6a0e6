// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Options of the quadtrees that separate the features of a graph (Theorem 5).

#ifndef CGAL_TREE_SEPARATION_OPTIONS_2_H
#define CGAL_TREE_SEPARATION_OPTIONS_2_H

#include <cstddef>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Options of the construction by quadtrees of Bern, Eppstein and Teng, section 6. All lengths are in sides
/// of leaves. Each option is set by the function of its name, which returns the options, so that calls can be
/// chained. Without an argument the function returns the value.
class Tree_separation_options_2 {
public:
  /// By what the distance of a vertex to the nearest vertex or edge is found.
  enum class Distances {
    /// The constrained Delaunay triangulation of the domain. Features beyond a gap outside the domain do not count.
    TRIANGULATION,
    /// The quadtree of the vertices, T_B, and the first edges that axis-parallel rays hit (Lemma 5).
    AXIS_RAYS
  };
  /// How edges are cut into pieces. The pieces are the same.
  enum class Subdivision {
    WALKING,      ///< from leaf to leaf (Theorem 6)
    CENTROID_TREE ///< by accelerated centroid trees, in O(log n) rounds
  };
  /// Where vertices are placed in leaves near an edge or a vertex of the graph.
  enum class Placement {
    /// Corners that a rule keeps. Where triangles miss the bound, corners are left out or moved if that cures them.
    /// Leaves are split only where it does not help.
    CHOSEN,
    /// Corners that the rule keeps, and nothing else. Leaves along edges are split until the rule is certain
    /// to meet the bound (doc/guarantees.md). This makes many more triangles.
    BY_RULE
  };

  /// By what distances of vertices are found; TRIANGULATION by default, which takes far less time.
  Tree_separation_options_2& find_distances_by(Distances value) { return find_distances_by_ = value, *this; }
  Distances find_distances_by() const { return find_distances_by_; } ///< the value set

  /// The side of a vertex's leaf is at most the distance to the nearest feature divided by this; 0.07 by
  /// default.
  Tree_separation_options_2& vertex_distance(double value) { return vertex_distance_ = value, *this; }
  double vertex_distance() const { return vertex_distance_; } ///< the value set

  /// So many vertices may be in one leaf of T_B', at least 1; 8 by default. With several, leaves between vertices are
  /// as large as the distance to features asks for, and not as small as it takes to tell vertices apart: placing
  /// starts from far fewer leaves, and triangles along edges that are shorter than leaves are left to refinement.
  Tree_separation_options_2& max_vertices_per_leaf(std::size_t value) {
    return max_vertices_per_leaf_ = value, *this;
  }
  std::size_t max_vertices_per_leaf() const { return max_vertices_per_leaf_; } ///< the value set

  /// Two edges in a leaf, or in adjacent leaves, that see each other are at least this far apart; 0.07 by
  /// default. Above 0.5, pieces of edges are this far from all vertices and edges that they see, in whatever leaves
  /// these are, and vertices are `vertex_distance()` from them.
  Tree_separation_options_2& edge_distance(double value) { return edge_distance_ = value, *this; }
  double edge_distance() const { return edge_distance_; } ///< the value set

  /// Sets both distances.
  Tree_separation_options_2& distances(double of_vertices, double of_edges) {
    return vertex_distance(of_vertices).edge_distance(of_edges);
  }

  /// Edges that share a vertex may be nearer to each other within this distance from it; 3 by default.
  Tree_separation_options_2& vertex_window(double value) { return vertex_window_ = value, *this; }
  double vertex_window() const { return vertex_window_; } ///< the value set

  /// Edges of an acute corner may also be nearer where the corner is at most this wide; 1.25 by default. No
  /// vertex is placed between them there.
  Tree_separation_options_2& strip_width(double value) { return strip_width_ = value, *this; }
  double strip_width() const { return strip_width_; } ///< the value set

  /// How edges are cut; WALKING by default.
  Tree_separation_options_2& subdivide(Subdivision value) { return subdivide_ = value, *this; }
  Subdivision subdivide() const { return subdivide_; } ///< the value set

  /// Where vertices are placed; CHOSEN by default.
  Tree_separation_options_2& place(Placement value) { return place_ = value, *this; }
  Placement place() const { return place_; } ///< the value set

  /// How many times vertices are placed at most. After each time but the last, leaves are split around the triangles
  /// that miss the bound. What the last one misses is left to refinement. 0 stands for as many as are needed: no
  /// triangle is missed then, but for those without room. 1 by default, as more make more triangles and take longer.
  Tree_separation_options_2& rounds(std::size_t value) { return rounds_ = value, *this; }
  std::size_t rounds() const { return rounds_; } ///< the value set

  /// With several rounds: a vertex gets a window, in which its leaves are equal and a rule is certain to meet the bound
  /// (doc/guarantees.md), when triangles near it are left in more rounds than this; 2 by default. Each window takes
  /// some 200 leaves.
  Tree_separation_options_2& failures_before_window(std::size_t value) {
    return failures_before_window_ = value, *this;
  }
  std::size_t failures_before_window() const { return failures_before_window_; } ///< the value set

  /// With these, quadtrees alone meet the bound wherever coordinates have room: distances of 0.7 and 0.5 mostly
  /// suffice, they are found by axis-parallel rays, each vertex has a leaf of its own, and there are as many rounds as
  /// are needed.
  static Tree_separation_options_2 of_theorem() {
    return Tree_separation_options_2()
        .find_distances_by(Distances::AXIS_RAYS)
        .distances(0.7, 0.5)
        .max_vertices_per_leaf(1)
        .rounds(0);
  }

  /// The same with the constant that the paper names as an example. Vertices, and pieces of edges, are at least three
  /// sides of their leaves away from any vertex and other edge that they see in the domain, with these exceptions:
  /// edges and their own ends; edges at a common vertex up to 4 sides from it; the legs of an acute corner up to where
  /// it is 3.5 sides wide; leaves as small as coordinates allow. The paper cuts acute corners off. With windows that
  /// are narrower than this, a leaf that is too large for a corner would be split without an end: its children would
  /// be too large as well.
  static Tree_separation_options_2 of_paper() {
    return of_theorem().distances(3, 3).vertex_window(4).strip_width(3.5);
  }

private:
  Distances find_distances_by_ = Distances::TRIANGULATION;
  double vertex_distance_ = 0.07;
  double edge_distance_ = 0.07;
  std::size_t max_vertices_per_leaf_ = 8;
  double vertex_window_ = 3;
  double strip_width_ = 1.25;
  Subdivision subdivide_ = Subdivision::WALKING;
  Placement place_ = Placement::CHOSEN;
  std::size_t rounds_ = 1;
  std::size_t failures_before_window_ = 2;
};

} // namespace CGAL

#endif // CGAL_TREE_SEPARATION_OPTIONS_2_H
