// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Names of the places where vertices of the bulk are, and the vertices on its border by their names.
//
// The name of a corner of a leaf consists of the leaf whose half-open square holds it, and of its place there: the
// lower left corner, or the middle of the left or lower side. So each place has one name.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_NAMED_BORDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_NAMED_BORDER_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Id_set.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The one name of a place in the bulk.
struct Corner_name {
  Leaf_index leaf; ///< whose half-open square holds it
  Square_place place;
};

/// The vertices on the border of the bulk. They are few, so most leaves have none, as one bit tells.
class Named_border {
public:
  explicit Named_border(std::size_t number_of_leaves) : has_some_(number_of_leaves) {}

  bool has(Corner_name name) const { return has_some_.has(name.leaf) && vertex_.count(key(name)) != 0; }
  /// \pre it has one of the name
  Vertex_id vertex(Corner_name name) const { return vertex_.find(key(name))->second; }
  /// The places of a leaf with vertices on the border.
  Square_places places(Leaf_index l) const {
    Square_places places;
    if (has_some_.has(l))
      for (const Square_place place : all_square_places)
        if (has({l, place})) places.add(place);
    return places;
  }

  void add(Corner_name name, Vertex_id v) {
    has_some_.add(name.leaf);
    vertex_.emplace(key(name), v);
  }

private:
  Id_set<Leaf_index> has_some_;
  std::unordered_map<std::uint64_t, Vertex_id> vertex_;

  static std::uint64_t key(Corner_name name) {
    return std::uint64_t(name.leaf.value()) << 2 | static_cast<std::uint64_t>(name.place);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_NAMED_BORDER_H
