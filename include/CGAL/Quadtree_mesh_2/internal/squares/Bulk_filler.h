// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Fills a mesh with the triangles of a balanced quadtree's squares where bounds of size determine most of it.
// A strip along the features is left to the refiner.
//
// 1. The bulk: squares as large as the bounds allow, wholly inside the domain and about a side away from
//    every constrained edge and input vertex (Bulk_squares.h).
// 2. The vertices on the border of the bulk are inserted into the mesh. The disk on each piece of the border
//    as its diameter holds no vertex, so the piece is an edge of the Delaunay triangulation.
// 3. The triangles within the border are replaced by those of the squares' templates (square_templates.h).
//
// The result is a constrained Delaunay triangulation again, in which the triangles of the bulk meet all
// bounds. So later stages need not know about it. It takes O(n) time if the bulk would be small. Otherwise it
// takes O(n log n), and O(1) for each triangle made.
//
// Source:   Bern, Eppstein, Gilbert, "Provably good mesh generation" (1994), for meshes made of a balanced
//           quadtree's squares.
// Deviates: Delaunay refinement makes the transition to the boundary, instead of warping.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_FILLER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_FILLER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Bulk_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Square_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Wanted_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Bulk_filler {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;

  explicit Bulk_filler(Meshing_state<Geometry>& state) : state_(state), mesh_(state.mesh) {}

  /// Fills the bulk, if there is enough of it to be worth it and the mesh then has at most `budget` vertices.
  void run(std::size_t budget) {
    const Bounds<Geometry>& bounds = state_.bounds;
    if (!bounds.is_size_bounded()) return;
    const double side = reference_side();
    if (!(side > 0 && side < std::numeric_limits<double>::infinity())) return;
    if (!bounds.is_local() && !is_worth_it(domain_area() / (side * side))) return;
    const auto [low, high] = box();
    const Square_grid<Geometry> grid(low, high, side);
    if (grid.finest_level() < 1) return;
    const Wanted_squares<Geometry> wanted(state_, grid, std::min(budget, largest_number_of_nodes));
    if (!wanted.is_complete() || !is_worth_it(wanted.number_of_inside_squares())) return;
    if (!bounds.is_local() && wanted.finest_level() < grid.given_level()) return;
    if (number_of_vertices_with(wanted.number_of_inside_squares()) > static_cast<double>(budget)) return;
    using Halved_sides = typename Squares::Halved_sides;
    const Squares squares(wanted, bounds.sin2 < sin2_of_halved_square ? Halved_sides::WITHOUT_CENTER
                                                                      : Halved_sides::WITH_CENTER);
    if (is_worth_it(static_cast<double>(squares.number_of_squares()))) fill(squares, wanted, grid);
  }

private:
  using Squares = Bulk_squares<ConcurrencyTag, Geometry>;

  /// Fewer squares than this, or than input vertices, are not worth the time that it takes to find them.
  static constexpr double least_number_of_squares = 500;
  static constexpr std::size_t largest_number_of_nodes = std::size_t(1) << 26;

  /// A vertex on the border of the bulk, and its neighbors there: two, or four where the bulk touches
  /// itself.
  struct Border_vertex {
    Vertex_id vertex = -1;
    Leaf_index square;
    std::array<std::int32_t, 4> neighbor{{-1, -1, -1, -1}};

    void add_neighbor(std::int32_t v) { *std::find(neighbor.begin(), neighbor.end() - 1, -1) = v; }
  };
  struct Border_edge {
    std::int32_t source, target; ///< among the border vertices; the bulk lies on the left
    Side outer;                  ///< the side of the triangle on the right
  };

  Meshing_state<Geometry>& state_;
  Mesh& mesh_;
  std::vector<Vertex_id> vertex_named_;        // by name; -1: none yet
  std::vector<Triangle_id> first_triangle_of_; // by square
  std::vector<Border_vertex> vertices_;
  std::vector<Border_edge> edges_;

  bool is_worth_it(double number_of_squares) const {
    return number_of_squares >= least_number_of_squares &&
           number_of_squares >= static_cast<double>(mesh_.number_of_vertices()) / 4;
  }

  /// About one vertex for each square, and one more where it has a center.
  double number_of_vertices_with(double number_of_squares) const {
    return static_cast<double>(mesh_.number_of_vertices()) + 1.5 * number_of_squares;
  }

  double domain_area() const {
    double area2 = 0;
    for (const auto& r : mesh_.triangles)
      if (r.v[0] >= 0) area2 += ratio(mesh_.shape(r).area2, 1);
    return area2 / 2;
  }

  /// The side of squares that just meet the bounds: the uniform ones, or those of one place.
  double reference_side() const {
    const Bounds<Geometry>& bounds = state_.bounds;
    double area2 = std::min(bounds.area2, 0.5 * bounds.squared_length);
    for (const double a : bounds.area2_of_region)
      if (a > 0) area2 = std::min(area2, a);
    if (bounds.squared_length_at) area2 = std::min(area2, 0.5 * bounds.squared_length_at(some_place()));
    return std::sqrt(area2 * (1 - Bounds<Geometry>::margin));
  }

  /// The centroid of a triangle.
  Point some_place() const {
    std::size_t t = 0;
    while (!mesh_.is_alive(static_cast<Triangle_id>(t))) ++t;
    const auto& r = mesh_.triangles[t];
    const Point& a = mesh_.point(r.v[0]);
    return Geometry::translate(a, (1.0 / 3) * (Geometry::difference(mesh_.point(r.v[1]), a) +
                                               Geometry::difference(mesh_.point(r.v[2]), a)));
  }

  std::array<Point, 2> box() const {
    std::array<Point, 2> ends;
    bool is_first = true;
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v) {
      if (!mesh_.is_used(static_cast<Vertex_id>(v))) continue;
      const Point& p = mesh_.points[v];
      if (is_first) ends = {p, p};
      is_first = false;
      ends[0].x = std::min(ends[0].x, p.x), ends[0].y = std::min(ends[0].y, p.y);
      ends[1].x = std::max(ends[1].x, p.x), ends[1].y = std::max(ends[1].y, p.y);
    }
    return ends;
  }

  void fill(const Squares& squares, const Wanted_squares<Geometry>& wanted,
            const Square_grid<Geometry>& grid) {
    vertex_named_.assign(3 * squares.number_of_leaves(), -1);
    reserve(squares);
    state_.bulk.has_border = true;
    collect_border(squares, grid);
    insert_border(squares, wanted);
    if (!find_border_edges()) return; // the mesh is valid all the same, and has no bulk
    clear_inside();
    make_triangles(squares, wanted, grid);
    link_squares(squares);
    link_border(squares);
    push_where_sizes_vary();
  }

  /// Room for the bulk, and for what the refiner will add along its border and the features.
  void reserve(const Squares& squares) {
    const std::size_t growth = 8 * mesh_.number_of_vertices() + 4 * squares.border().size();
    const std::size_t vertices = mesh_.number_of_vertices() + squares.number_of_triangles() + growth;
    mesh_.points.reserve(vertices), mesh_.edge_of.reserve(vertices), mesh_.triangle_of.reserve(vertices);
    mesh_.is_dirty.reserve(vertices);
    mesh_.triangles.reserve(mesh_.triangles.size() + squares.number_of_triangles() + 2 * growth);
  }

  // ---- the border

  static Point place(const Square_grid<Geometry>& grid, const Grid_square& s, int i) {
    const std::uint32_t side = s.side(), half = side / 2;
    const std::uint32_t dx[] = {0, side, side, 0, half, side, half, 0, half};
    const std::uint32_t dy[] = {0, 0, side, side, 0, half, side, half, half};
    return grid.point(s.x + dx[i], s.y + dy[i]);
  }

  /// Adds the border's vertices to the mesh's points, without triangles.
  void collect_border(const Squares& squares, const Square_grid<Geometry>& grid) {
    const Vertex_id first = static_cast<Vertex_id>(mesh_.number_of_vertices());
    for (const Square_piece& p : squares.border()) {
      const Square_template& form = square_template(squares.form(p.square));
      const auto corner = form.side_of_piece[std::size_t(p.piece)];
      const auto& t = form.triangle[std::size_t(corner.triangle)];
      std::int32_t ends[2];
      for (int i = 0; i < 2; ++i) {
        const int vertex = t[std::size_t(i == 0 ? next_slot[corner.slot] : previous_slot[corner.slot])];
        Vertex_id& v = vertex_named_[squares.name(p.square, vertex)];
        if (v < 0) {
          v = mesh_.add_vertex(place(grid, squares.square(p.square), vertex), free_vertex);
          vertices_.emplace_back();
          vertices_.back().vertex = v, vertices_.back().square = p.square;
        }
        ends[i] = v - first;
      }
      vertices_[std::size_t(ends[0])].add_neighbor(ends[1]);
      vertices_[std::size_t(ends[1])].add_neighbor(ends[0]);
      edges_.push_back({ends[0], ends[1], Side::border()});
    }
  }

  /// Inserts the vertices loop by loop, each located from the one before it.
  void insert_border(const Squares& squares, const Wanted_squares<Geometry>& wanted) {
    std::vector<std::int32_t> stack;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (mesh_.is_used(vertices_[i].vertex)) continue;
      insert(vertices_[i].vertex, squares.triangle_near(wanted, vertices_[i].square));
      stack.push_back(static_cast<std::int32_t>(i));
      while (!stack.empty()) {
        const Border_vertex& from = vertices_[std::size_t(stack.back())];
        stack.pop_back();
        for (const std::int32_t n : from.neighbor) {
          if (n < 0 || mesh_.is_used(vertices_[std::size_t(n)].vertex)) continue;
          insert(vertices_[std::size_t(n)].vertex, mesh_.incident_triangle(from.vertex));
          stack.push_back(n);
        }
      }
    }
  }

  void insert(Vertex_id v, Triangle_id hint) {
    const Point p = mesh_.point(v);
    const Triangle_id t = locate(hint, p);
    const auto& r = mesh_.triangle(t);
    for (int k = 0; k < 3; ++k)
      if (turn(r, k, p) == 0) return mesh_.insert_on_side(t, k, v);
    mesh_.insert_in_triangle(t, v);
  }

  /// On which side of side k of the triangle p lies: 1 inside, 0 on the line.
  int turn(const typename Mesh::Triangle& r, int k, const Point& p) const {
    return Geometry::orientation(mesh_.point(r.v[next_slot[k]]), mesh_.point(r.v[previous_slot[k]]), p);
  }

  /// The triangle that holds p: by a walk in sight, or, if that leads nowhere, by looking everywhere.
  Triangle_id locate(Triangle_id t, const Point& p) const {
    constexpr unsigned longest_walk = 1000;
    for (unsigned step = 0; step < longest_walk; ++step) {
      const auto& r = mesh_.triangle(t);
      int exit = -1;
      bool is_inside = true;
      for (unsigned j = 0; j < 3; ++j) {
        const int k = static_cast<int>((j + step) % 3u);
        if (turn(r, k, p) >= 0) continue;
        is_inside = false;
        if (!r.side[k].is_constrained()) exit = k;
      }
      if (is_inside) return t;
      if (exit < 0) break;
      t = r.side[exit].triangle();
    }
    for (std::size_t i = 0;; ++i) {
      const auto& r = mesh_.triangles[i];
      if (r.v[0] >= 0 && turn(r, 0, p) >= 0 && turn(r, 1, p) >= 0 && turn(r, 2, p) >= 0)
        return static_cast<Triangle_id>(i);
    }
  }

  /// Finds the sides on the border's right. Whether all of its pieces are edges of the mesh, as they should
  /// be.
  bool find_border_edges() {
    for (Border_edge& e : edges_) {
      const Vertex_id a = vertices_[std::size_t(e.source)].vertex,
                      b = vertices_[std::size_t(e.target)].vertex;
      const Side s = mesh_.find_side(a, b);
      if (s.is_border()) return false;
      e.outer = mesh_.source(s) == a ? mesh_.across(s) : s;
      if (e.outer.is_constrained()) return false;
    }
    return true;
  }

  /// Takes out the triangles within the border.
  void clear_inside() {
    std::vector<char> is_marked(mesh_.triangles.size(), 0);
    std::vector<Triangle_id> inside;
    for (const Border_edge& e : edges_) mesh_.constrain(e.outer);
    for (const Border_edge& e : edges_) {
      const Triangle_id t = mesh_.across(e.outer).triangle();
      if (is_marked[std::size_t(t)] != 0) continue;
      is_marked[std::size_t(t)] = 1;
      inside.push_back(t);
    }
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (const Side o : mesh_.triangle(inside[i]).side) {
        if (o.is_constrained() || is_marked[std::size_t(o.triangle())] != 0) continue;
        is_marked[std::size_t(o.triangle())] = 1;
        inside.push_back(o.triangle());
      }
    for (const Triangle_id t : inside) mesh_.kill(t);
  }

  // ---- the squares

  void make_triangles(const Squares& squares, const Wanted_squares<Geometry>& wanted,
                      const Square_grid<Geometry>& grid) {
    first_triangle_of_.resize(squares.number_of_leaves());
    auto& bulk = state_.bulk;
    bulk.first_vertex = static_cast<Vertex_id>(mesh_.number_of_vertices());
    bulk.first_triangle = static_cast<Triangle_id>(mesh_.triangles.size());
    for (std::size_t i = 0; i < squares.number_of_leaves(); ++i) {
      const Leaf_index l(i);
      if (!squares.is_bulk(l)) continue;
      make_triangles_of(squares, grid, l);
      if (mesh_.region_of.empty()) continue;
      mesh_.region_of.resize(mesh_.triangles.size(), mesh_.region(squares.triangle_near(wanted, l)));
    }
    bulk.end_of_vertices = static_cast<Vertex_id>(mesh_.number_of_vertices());
    bulk.end_of_triangles = static_cast<Triangle_id>(mesh_.triangles.size());
    // none of them can be spared
    std::fill(mesh_.is_dirty.begin() + bulk.first_vertex, mesh_.is_dirty.end(), char(0));
  }

  void make_triangles_of(const Squares& squares, const Square_grid<Geometry>& grid, Leaf_index l) {
    const Grid_square square = squares.square(l);
    const Square_form form_of_square = squares.form(l);
    const Square_template& form = square_template(form_of_square);
    Vertex_id v[Square_template::number_of_vertices];
    for (int i = 0; i < Square_template::center; ++i) {
      if (!form_of_square.has_vertex(i)) continue;
      Vertex_id& named = vertex_named_[squares.name(l, i)];
      if (named < 0) named = mesh_.add_vertex(place(grid, square, i), free_vertex);
      v[i] = named;
    }
    if (form_of_square.has_center())
      v[Square_template::center] =
          mesh_.add_vertex(place(grid, square, Square_template::center), free_vertex);
    const Triangle_id first = static_cast<Triangle_id>(mesh_.triangles.size());
    first_triangle_of_[std::size_t(l)] = first;
    for (std::size_t t = 0; t < std::size_t(form.size); ++t) {
      typename Mesh::Triangle r;
      for (std::size_t k = 0; k < 3; ++k) {
        r.v[k] = v[form.triangle[t][k]];
        mesh_.triangle_of[std::size_t(r.v[k])] = first + static_cast<Triangle_id>(t);
        if (form.piece[t][k] < 0)
          r.side[k] = Side(first + form.across[t][k].triangle, form.across[t][k].slot);
      }
      mesh_.triangles.push_back(r);
    }
  }

  Side side_of(const Squares& squares, Square_piece p) const {
    const auto c = square_template(squares.form(p.square)).side_of_piece[std::size_t(p.piece)];
    return Side(first_triangle_of_[std::size_t(p.square)] + c.triangle, c.slot);
  }

  void link_squares(const Squares& squares) {
    for (std::size_t i = 0; i < squares.number_of_leaves(); ++i)
      if (squares.is_bulk(Leaf_index(i)))
        squares.for_each_pair_before(Leaf_index(i), [&](Square_piece own, Square_piece other) {
          const Side s = side_of(squares, own);
          mesh_.link(s.triangle(), s.slot(), side_of(squares, other));
        });
  }

  /// Sizes were looked up at some places only; what they missed is left to the refiner.
  void push_where_sizes_vary() {
    if (!state_.bounds.is_local()) return;
    for (Triangle_id t = state_.bulk.first_triangle; t < state_.bulk.end_of_triangles; ++t)
      state_.push_if_suspect(t);
  }

  void link_border(const Squares& squares) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Side s = side_of(squares, squares.border()[i]);
      Side outer = edges_[i].outer;
      outer.release();
      mesh_.link(s.triangle(), s.slot(), outer);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_FILLER_H
