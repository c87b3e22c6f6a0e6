// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_GIVEN_MESH_TYPES_H
#define CGAL_QUADTREE_MESH_2_GIVEN_MESH_TYPES_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <vector>

// The type of the arguments of pslg_from_mesh_2().

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// What `pslg_from_mesh_2()` is told about triangles.
struct Given_mesh_details_2 {
  /// Which vertices are input, so that `adapt_mesh_2()` leaves them.
  enum class Vertices {
    /// All, except for those inside of the straight sides of corners below 60 degrees: between edges in a row with one
    /// marker, within two units in the last place of the line between the ends of the side.
    /// `Indexed_mesh_2::input_index` tells which are input, if there are such sides.
    INPUT,
    /// Those on segments, except where two segments with the same marker make an exactly straight line. The others may
    /// be left out. `Indexed_mesh_2::input_index` tells which are input.
    FREE_INSIDE
  };

  /// Per triangle, an attribute; edges between triangles with different ones are segments. Empty: none.
  std::vector<double> attributes;
  /// Edges that are segments, besides. Those on the border may be among them.
  std::vector<std::array<Quadtree_mesh_2::Vertex_index, 2>> segments;
  /// Their markers, one each; empty: none. Other segments have 0.
  std::vector<int> segment_markers;
  Vertices vertices = Vertices::INPUT; ///< which of them are input
  /// Per vertex, whether it is input, in place of what `vertices` says. Those inside of segments, which may bend there
  /// by a rounding, and those on none may be free; all others are input in any case. Empty: as `vertices` says.
  std::vector<char> is_input;
  std::size_t first_number = 0; ///< what messages count from, and `Pslg_2::first_number` of the graph
};

} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_GIVEN_MESH_TYPES_H
