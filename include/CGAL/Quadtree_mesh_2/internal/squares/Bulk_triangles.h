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
// border, which is there already.) So squares count what is theirs, and sums of the counts are the first handles. From
// these follow the handles of all that is around a square. So all squares write at once, each its own vertices, and its
// triangles with the sides of other squares across. Two rounds, O(1) for each triangle, which is written once.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_TRIANGLES_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Bulk_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Named_border.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Square_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Wanted_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>

#include <array>
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

  Bulk_triangles(Meshing_state<Geometry>& state, const Squares& squares, const Named_border& border)
      : state_(state), mesh_(state.mesh), squares_(squares), border_(border),
        first_triangle_of_(squares.number_of_leaves()), first_vertex_of_(squares.number_of_leaves()) {}

  /// Appends the triangles and the vertices within to the mesh, and links the squares to each other. Nothing lies
  /// across the pieces of the border yet.
  void make(const Wanted_squares<Geometry>& wanted, const Square_grid<Geometry>& grid) {
    number_all();
    for_each_index<ConcurrencyTag>(squares_.number_of_leaves(), [&](std::size_t i) {
      const Leaf_index l(i);
      if (!squares_.is_bulk(l)) return;
      const auto around = squares_.surroundings(l);
      const Vertices v = vertices(around);
      make_own_vertices(grid, l, v);
      make_triangles(around, v);
      if (!mesh_.region_of.empty()) set_regions(l, mesh_.region(squares_.triangle_near(wanted, l)));
    });
  }

  /// The side of a triangle of the bulk that is a piece of a square.
  Side side_of(Square_piece p) const {
    const auto c = square_template(squares_.form(p.square)).side_of_piece[std::size_t(p.piece)];
    return Side(after(first_triangle_of_[p.square], c.triangle), c.slot);
  }

private:
  using Vertices = std::array<Vertex_id, Square_template::number_of_vertices>;

  Meshing_state<Geometry>& state_;
  Mesh& mesh_;
  const Squares& squares_;
  const Named_border& border_;
  Uninitialized_indexed_vector<Leaf_index, std::uint32_t> first_triangle_of_, first_vertex_of_;

  /// The places of a bulk square with vertices of its own.
  Square_places own_places(Leaf_index l) const {
    return squares_.form(l).places().without(border_.places(l));
  }

  /// Handles are below 2^32, so one sum counts both.
  struct Counts {
    std::uint64_t value = 0;
    static constexpr int shift = 32;

    std::uint32_t triangles() const { return static_cast<std::uint32_t>(value >> shift); }
    std::uint32_t vertices() const { return static_cast<std::uint32_t>(value); }
  };

  Counts counts(Leaf_index l) const {
    const Square_form form = squares_.form(l);
    return {(std::uint64_t(square_template(form).size) << Counts::shift) + (form.has_center() ? 1U : 0U) +
            std::uint64_t(own_places(l).size())};
  }

  void number_all() {
    const Counts all{count_allocate_and_place<ConcurrencyTag>(
        squares_.number_of_leaves(),
        [&](std::size_t begin, std::size_t end) {
          std::uint64_t sum = 0;
          for (const Leaf_index l : Id_range<Leaf_index>(begin, end))
            if (squares_.is_bulk(l)) sum += counts(l).value;
          return sum;
        },
        [](std::uint64_t) {},
        [&](std::size_t begin, std::size_t end, std::uint64_t first) {
          for (const Leaf_index l : Id_range<Leaf_index>(begin, end)) {
            if (!squares_.is_bulk(l)) continue;
            first_triangle_of_[l] = Counts{first}.triangles(), first_vertex_of_[l] = Counts{first}.vertices();
            first += counts(l).value;
          }
        })};
    auto& bulk = state_.bulk;
    bulk.first_vertex = mesh_.points.end_id(), bulk.first_triangle = mesh_.triangles.end_id();
    mesh_.resize(mesh_.number_of_vertices() + all.vertices(), mesh_.triangles.size() + all.triangles());
    bulk.end_of_vertices = mesh_.points.end_id(), bulk.end_of_triangles = mesh_.triangles.end_id();
  }

  /// The vertices of a square, those that its form has.
  Vertices vertices(const typename Squares::Surroundings& around) const {
    const Square_form form = squares_.form(around.leaf);
    Vertices v;
    const auto corners = squares_.names_of_corners(around);
    for (std::size_t i = 0; i < corners.size(); ++i) v[i] = vertex(corners[i]);
    if (form.is_any_halved())
      for (int side = 0; side < 4; ++side)
        if (form.is_halved(side)) v[std::size_t(4 + side)] = vertex(squares_.name_of_middle(around, side));
    v[Square_template::center] = first_vertex_of(around.leaf); // if it has one
    return v;
  }

  Vertex_id vertex(Corner_name name) const {
    if (border_.has(name)) return border_.vertex(name);
    const std::uint32_t first =
        first_vertex_of(name.leaf).value() + (squares_.form(name.leaf).has_center() ? 1 : 0);
    if (name.place == Square_place::LOWER_LEFT) return Vertex_id(first); // most
    return Vertex_id(first + own_places(name.leaf).before(name.place).size());
  }

  void make_own_vertices(const Square_grid<Geometry>& grid, Leaf_index l, const Vertices& v) {
    const Square_template& form = square_template(squares_.form(l));
    const Grid_square square = squares_.square(l);
    const auto make = [&](int i) {
      const Vertex_id own = v[std::size_t(i)];
      mesh_.points[own] = place_in_square(grid, square, i);
      mesh_.role_of[own] = free_vertex;
      mesh_.is_dirty[own] = 0; // it cannot be spared
      mesh_.triangle_of[own] = after(first_triangle_of_[l], form.triangle_at[std::size_t(i)]);
    };
    if (squares_.form(l).has_center()) make(Square_template::center);
    const Square_places own = own_places(l);
    for (const Square_place place : all_square_places)
      if (own.has(place)) make(vertex_at(place));
  }

  void make_triangles(const typename Squares::Surroundings& around, const Vertices& v) {
    const Square_template& form = square_template(squares_.form(around.leaf));
    std::array<Side, Square_template::number_of_pieces> across; // of each piece
    squares_.for_each_piece_across(
        around, [&](int piece, Square_piece other) { across[std::size_t(piece)] = side_of(other); });
    const std::uint32_t first = first_triangle_of_[around.leaf];
    for (std::size_t t = 0; t < std::size_t(form.size); ++t) {
      typename Mesh::Triangle r;
      for (std::size_t k = 0; k < 3; ++k) {
        r.v[k] = v[std::size_t(form.triangle[t][k])];
        const int piece = form.piece[t][k];
        r.side[k] = piece >= 0 ? across[std::size_t(piece)]
                               : Side(after(first, form.across[t][k].triangle), form.across[t][k].slot);
      }
      mesh_.triangle(after(first, t)) = r;
    }
  }

  void set_regions(Leaf_index l, Region_id region) {
    for (int t = 0; t < square_template(squares_.form(l)).size; ++t)
      mesh_.set_region(after(first_triangle_of_[l], t), region);
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
