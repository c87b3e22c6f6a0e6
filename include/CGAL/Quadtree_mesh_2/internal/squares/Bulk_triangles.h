// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Makes the triangles of the bulk's squares (Bulk_filler.h) by their templates.
//
// A vertex within the bulk belongs to the square that its name says, of which it is the lower left corner or the middle
// of the left or lower side; centers belong to their squares. (If that square is not of the bulk, the vertex is on the
// border, which is there already.) So squares count what is theirs, sums of the counts are the first handles, and all
// squares write at once. O(1) for each triangle, in a constant number of rounds.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_TRIANGLES_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Bulk_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Square_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Wanted_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The place of vertex i, as in `Square_template`, of a square.
template <class Geometry>
typename Geometry::Point place_in_square(const Square_grid<Geometry>& grid, const Grid_square& s, int i) {
  const std::uint32_t side = s.side(), half = side / 2;
  const std::uint32_t dx[] = {0, side, side, 0, half, side, half, 0, half};
  const std::uint32_t dy[] = {0, 0, side, side, 0, half, side, half, half};
  return grid.point(s.x + dx[i], s.y + dy[i]);
}

template <class ConcurrencyTag, class Geometry>
class Bulk_triangles {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Squares = Bulk_squares<ConcurrencyTag, Geometry>;
  using Named_vertices = Uninitialized_vector<Vertex_id>; ///< by name in `Bulk_squares`

  /// \param named has the vertices on the border
  Bulk_triangles(Meshing_state<Geometry>& state, const Squares& squares, Named_vertices& named)
      : state_(state), mesh_(state.mesh), squares_(squares), named_(named),
        first_triangle_of_(squares.number_of_leaves()), first_vertex_of_(squares.number_of_leaves()) {}

  /// Appends the triangles and the vertices within to the mesh, and links the squares to each other. Nothing lies
  /// across the pieces of the border yet.
  void make(const Wanted_squares<Geometry>& wanted, const Square_grid<Geometry>& grid) {
    number_all();
    for_each_square([&](Leaf_index l) { make_vertices(grid, l); });
    for_each_square([&](Leaf_index l) { make_triangles(wanted, l); });
    for_each_square([&](Leaf_index l) {
      squares_.for_each_pair_before(l, [&](Square_piece own, Square_piece other) {
        const Side s = side_of(own);
        mesh_.link(s.triangle(), s.slot(), side_of(other));
      });
    });
  }

  /// The side of a triangle of the bulk that is a piece of a square.
  Side side_of(Square_piece p) const {
    const auto c = square_template(squares_.form(p.square)).side_of_piece[std::size_t(p.piece)];
    return Side(after(first_triangle_of_[p.square], c.triangle), c.slot);
  }

private:
  /// The vertices that a square may own besides its center: those that have their names from it.
  static constexpr int lower_left = 0, on_lower_side = 4, on_left_side = 7;

  Meshing_state<Geometry>& state_;
  Mesh& mesh_;
  const Squares& squares_;
  Named_vertices& named_;
  Uninitialized_indexed_vector<Leaf_index, std::uint32_t> first_triangle_of_, first_vertex_of_;

  template <class Function>
  void for_each_square(const Function& f) const {
    for_each_index<ConcurrencyTag>(squares_.number_of_leaves(), [&](std::size_t i) {
      if (squares_.is_bulk(Leaf_index(i))) f(Leaf_index(i));
    });
  }

  /// Calls `f(i)` for the vertices with a name that a bulk square owns.
  template <class Function>
  void for_each_own_vertex(Leaf_index l, const Function& f) const {
    for (const int i : {lower_left, on_left_side, on_lower_side})
      if (squares_.form(l).has_vertex(i) && !named_[squares_.name(l, i)].is_valid()) f(i);
  }

  void number_all() {
    const std::size_t leaves = squares_.number_of_leaves();
    for_each_index<ConcurrencyTag>(leaves, [&](std::size_t i) {
      const Leaf_index l(i);
      first_triangle_of_[l] = first_vertex_of_[l] = 0;
      if (!squares_.is_bulk(l)) return;
      first_triangle_of_[l] = static_cast<std::uint32_t>(square_template(squares_.form(l)).size);
      first_vertex_of_[l] = squares_.form(l).has_center() ? 1 : 0;
      for_each_own_vertex(l, [&](int) { ++first_vertex_of_[l]; });
    });
    const std::size_t vertices = exclusive_scan<ConcurrencyTag>(first_vertex_of_.data(), leaves),
                      triangles = exclusive_scan<ConcurrencyTag>(first_triangle_of_.data(), leaves);
    auto& bulk = state_.bulk;
    bulk.first_vertex = mesh_.points.end_id(), bulk.first_triangle = mesh_.triangles.end_id();
    mesh_.resize(mesh_.number_of_vertices() + vertices, mesh_.triangles.size() + triangles);
    bulk.end_of_vertices = mesh_.points.end_id(), bulk.end_of_triangles = mesh_.triangles.end_id();
  }

  void make_vertices(const Square_grid<Geometry>& grid, Leaf_index l) {
    Vertex_id next = first_vertex_of(l);
    const auto make = [&](int i) {
      const Vertex_id v = next;
      ++next;
      mesh_.points[v] = place_in_square(grid, squares_.square(l), i);
      mesh_.role_of[v] = free_vertex;
      mesh_.is_dirty[v] = 0; // it cannot be spared
      return v;
    };
    if (squares_.form(l).has_center()) make(Square_template::center);
    for_each_own_vertex(l, [&](int i) { named_[squares_.name(l, i)] = make(i); });
  }

  void make_triangles(const Wanted_squares<Geometry>& wanted, Leaf_index l) {
    const Square_form form_of_square = squares_.form(l);
    const Square_template& form = square_template(form_of_square);
    Vertex_id v[Square_template::number_of_vertices];
    for (int i = 0; i < Square_template::center; ++i)
      if (form_of_square.has_vertex(i)) v[i] = named_[squares_.name(l, i)];
    v[Square_template::center] = first_vertex_of(l); // if it has one
    for (std::size_t t = 0; t < std::size_t(form.size); ++t) {
      const Triangle_id here = after(first_triangle_of_[l], t);
      typename Mesh::Triangle r;
      for (std::size_t k = 0; k < 3; ++k) {
        r.v[k] = v[form.triangle[t][k]];
        if (is_own(form.triangle[t][k], r.v[k])) mesh_.triangle_of[r.v[k]] = here;
        if (form.piece[t][k] < 0)
          r.side[k] = Side(after(first_triangle_of_[l], form.across[t][k].triangle), form.across[t][k].slot);
      }
      mesh_.triangle(here) = r;
      if (!mesh_.region_of.empty()) mesh_.set_region(here, mesh_.region(squares_.triangle_near(wanted, l)));
    }
  }

  /// Whether v, vertex i of a square, is the square's own.
  bool is_own(int i, Vertex_id v) const {
    return state_.bulk.has_within(v) &&
           (i == Square_template::center || i == lower_left || i == on_left_side || i == on_lower_side);
  }

  Vertex_id first_vertex_of(Leaf_index l) const {
    return Vertex_id(state_.bulk.first_vertex.value() + first_vertex_of_[l]);
  }
  /// Triangle number i of a square whose first is number `first` of the bulk.
  template <class Integer>
  Triangle_id after(std::uint32_t first, Integer i) const {
    return Triangle_id(state_.bulk.first_triangle.value() + first + static_cast<std::uint32_t>(i));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_TRIANGLES_H
