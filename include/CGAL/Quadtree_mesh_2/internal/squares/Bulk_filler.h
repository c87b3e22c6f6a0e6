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
// 2. The vertices on the border of the bulk are inserted into the mesh, along its loops, in rounds
//    (for_each_in_rounds.h). The disk on each piece of the border as its diameter holds no vertex, so the piece is
//    an edge of the Delaunay triangulation.
//    Constrained edges much longer than their distance from the border are halved then. Otherwise the border's
//    triangles would make a fan at each end of such an edge, through which refinement would walk again and again,
//    and of which blocks could do nothing.
// 3. The triangles within the border are replaced by those of the squares' templates (Bulk_triangles.h).
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
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Bulk_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Bulk_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Named_border.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Square_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Wanted_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Delaunay_inserter.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/for_each_in_rounds.h>

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

  Bulk_filler(Meshing_state<Geometry>& state, Splitter<Geometry>& splitter)
      : state_(state), mesh_(state.mesh), splitter_(splitter) {}

  /// Fills the bulk, if there is enough of it to be worth it and the mesh then has at most `budget` vertices.
  void run(std::size_t budget) {
    const Bounds<Geometry>& bounds = state_.bounds;
    if (!bounds.is_size_bounded()) return;
    const double side = reference_side();
    if (!(side > 0 && side < std::numeric_limits<double>::infinity())) return;
    if (has_long_kept_edge()) return;
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
  using Triangles = Bulk_triangles<ConcurrencyTag, Geometry>;

  /// Fewer squares than this, or than input vertices, are not worth the time that it takes to find them.
  static constexpr double least_number_of_squares = 500;
  static constexpr std::size_t largest_number_of_nodes = std::size_t(1) << 26;
  /// Of the angle, 175 degrees, from which on an edge is too long for the border in front of it.
  static constexpr double cosine2_of_long_edge = 0.9924;

  struct Border_vertex {
    Vertex_id vertex;
    Leaf_index square; ///< that has it
  };
  using Loop = std::vector<std::uint32_t>; ///< border vertices
  struct Border_edge {
    std::uint32_t source, target; ///< among the border vertices; the bulk lies on the left
    Side outer;                   ///< the side of the triangle on the right
  };

  Meshing_state<Geometry>& state_;
  Mesh& mesh_;
  Splitter<Geometry>& splitter_;
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
      if (r.v[0].is_valid()) area2 += ratio(mesh_.shape(r).area2, 1);
    return area2 / 2;
  }

  /// The side of squares that just meet the bounds: the uniform ones, or those of one place.
  double reference_side() const {
    return std::sqrt(squared_side_at([this] { return some_place(); }) * (1 - Bounds<Geometry>::margin));
  }

  /// The square of that side, where bounds differ at a place.
  template <class Place>
  double squared_side_at(const Place& place) const {
    const Bounds<Geometry>& bounds = state_.bounds;
    double area2 = std::min(bounds.area2, 0.5 * bounds.squared_length);
    for (const double a : bounds.area2_of_region)
      if (a > 0) area2 = std::min(area2, a);
    return bounds.squared_length_at ? std::min(area2, 0.5 * bounds.squared_length_at(place())) : area2;
  }

  /// Whether an edge that gets no vertices is much longer than the squares beside it would be. Between both there has
  /// to be room for triangles of all lengths between.
  bool has_long_kept_edge() const {
    if (!state_.problem.keeps_edges()) return false;
    constexpr double most_squared_sides = 4;
    for (const Edge_id e : state_.edges.ids()) {
      if (!state_.problem.is_kept(e)) continue;
      const Point &a = state_.problem.input_point(state_.edges[e].a),
                  &b = state_.problem.input_point(state_.edges[e].b);
      const double side2 = squared_side_at([&] { return Geometry::between(a, b, 0.5); });
      if (squared_length(Geometry::scaled_difference(a, b)) > most_squared_sides * side2) return true;
    }
    return false;
  }

  /// The centroid of a triangle.
  Point some_place() const {
    Triangle_id t(0);
    while (!mesh_.is_alive(t)) ++t;
    const auto& r = mesh_.triangle(t);
    const Point& a = mesh_.point(r.v[0]);
    return Geometry::translate(a, (1.0 / 3) * (Geometry::difference(mesh_.point(r.v[1]), a) +
                                               Geometry::difference(mesh_.point(r.v[2]), a)));
  }

  std::array<Point, 2> box() const {
    std::array<Point, 2> ends;
    bool is_first = true;
    for (const Vertex_id v : mesh_.points.ids()) {
      if (!mesh_.is_used(v)) continue;
      const Point& p = mesh_.point(v);
      if (is_first) ends = {p, p};
      is_first = false;
      ends[0].x = std::min(ends[0].x, p.x), ends[0].y = std::min(ends[0].y, p.y);
      ends[1].x = std::max(ends[1].x, p.x), ends[1].y = std::max(ends[1].y, p.y);
    }
    return ends;
  }

  void fill(const Squares& squares, const Wanted_squares<Geometry>& wanted,
            const Square_grid<Geometry>& grid) {
    reserve(squares);
    state_.has_placed_vertices = true;
    const Named_border border = collect_border(squares, grid);
    insert_border(squares, wanted);
    split_long_edges();
    if (!find_border_edges()) return; // the mesh is valid all the same, and has no bulk
    clear_inside();
    Triangles triangles(state_, squares, border);
    triangles.make(wanted, grid);
    link_border(squares, triangles);
    push_where_sizes_vary();
  }

  /// Room for the bulk, and for what the refiner will add along its border and the features.
  void reserve(const Squares& squares) {
    const std::size_t growth = 8 * mesh_.number_of_vertices() + 4 * squares.border().size();
    const std::size_t vertices = mesh_.number_of_vertices() + squares.number_of_triangles() + growth;
    mesh_.reserve(vertices, mesh_.triangles.size() + squares.number_of_triangles() + 2 * growth);
  }

  // ---- the border

  /// Adds the border's vertices to the mesh's points, without triangles.
  Named_border collect_border(const Squares& squares, const Square_grid<Geometry>& grid) {
    Named_border border(squares.number_of_leaves());
    const Vertex_id first = mesh_.points.end_id();
    for (const Square_piece& p : squares.border()) {
      const auto around = squares.surroundings(p.square);
      const Square_template& form = square_template(squares.form(p.square));
      const auto corner = form.side_of_piece[std::size_t(p.piece)];
      const auto& t = form.triangle[std::size_t(corner.triangle)];
      std::uint32_t ends[2];
      for (int i = 0; i < 2; ++i) {
        const int vertex = t[std::size_t(i == 0 ? next_slot[corner.slot] : previous_slot[corner.slot])];
        const Corner_name name = squares.name(around, vertex);
        if (!border.has(name)) {
          const Point place = place_in_square(grid, squares.square(p.square), vertex);
          border.add(name, mesh_.add_vertex(place, free_vertex));
          vertices_.push_back({border.vertex(name), p.square});
        }
        ends[i] = border.vertex(name).value() - first.value();
      }
      edges_.push_back({ends[0], ends[1], Side::border()});
    }
    return border;
  }

  /// The border's pieces put end to end: per loop its vertices, in order; one where the bulk touches itself comes
  /// twice.
  std::vector<Loop> loops() const {
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> last(vertices_.size(), none),
        before(edges_.size(), none); // pieces that leave a vertex
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      before[e] = last[edges_[e].source];
      last[edges_[e].source] = static_cast<std::uint32_t>(e);
    }
    std::vector<Loop> loops;
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
      while (last[v] != none) {
        loops.emplace_back();
        for (std::uint32_t w = v; last[w] != none;) {
          loops.back().push_back(w);
          const std::uint32_t e = last[w];
          last[w] = before[e];
          w = edges_[e].target;
        }
      }
    return loops;
  }

  /// Inserts a vertex of each loop, then the loops.
  void insert_border(const Squares& squares, const Wanted_squares<Geometry>& wanted) {
    const std::vector<Loop> all = loops();
    Delaunay_inserter<Geometry> inserter(mesh_);
    for_each_in_rounds(all.size(), 1, [&](std::size_t l) {
      const Border_vertex& v = vertices_[all[l].front()];
      if (!mesh_.is_used(v.vertex))
        inserter.insert(v.vertex, locate(squares.triangle_near(wanted, v.square), v.vertex));
    });
    for (const auto& loop : all) insert_loop(loop, inserter);
  }

  /// Each vertex is located by a walk along the loop, which lies inside the domain, from one that is inserted.
  void insert_loop(const Loop& loop, Delaunay_inserter<Geometry>& inserter) {
    const auto vertex = [&](std::size_t i) { return vertices_[loop[i]].vertex; };
    std::size_t last = 0; // inserted
    for_each_in_rounds(loop.size(), 1, [&](std::size_t i) {
      if (!mesh_.is_used(vertex(i))) {
        Triangle_id t = mesh_.incident_triangle(vertex(last));
        for (std::size_t j = last + 1; j <= i; ++j) t = locate(t, vertex(j));
        inserter.insert(vertex(i), t);
      }
      last = i;
    });
  }

  /// The triangle that holds v: by a walk, or, if the border is in its way, by looking everywhere.
  Triangle_id locate(Triangle_id t, Vertex_id v) const {
    const Point& p = mesh_.point(v);
    const Walk_end end = locate_exactly(mesh_, t, p);
    if (!end.is_blocked()) return end.triangle;
    for (Triangle_id u(0);; ++u) {
      const auto& r = mesh_.triangle(u);
      const auto is_inside = [&](int k) {
        return Geometry::orientation(mesh_.point(r.v[next_slot[k]]), mesh_.point(r.v[previous_slot[k]]), p) >=
               0;
      };
      if (r.v[0].is_valid() && is_inside(0) && is_inside(1) && is_inside(2)) return u;
    }
  }

  /// Halves constrained edges until no vertex of the border sees one under nearly 180 degrees.
  void split_long_edges() {
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (Triangle_id t(0); mesh_.triangles.has(t); ++t) // splits make more
        for (int k = 0; k < 3; ++k) {
          if (mesh_.is_alive(t) && is_long(Side(t, k)) &&
              splitter_.split(t, k, nullptr, Asker::ORDINARY) == Outcome::CHANGED)
            is_changed = true;
        }
    }
  }

  bool is_long(Side s) const {
    const Vertex_id apex = mesh_.opposite(s);
    if (!mesh_.across(s).is_constrained() || apex < vertices_.front().vertex ||
        vertices_.back().vertex < apex)
      return false;
    const auto x = Geometry::scaled_difference(mesh_.point(mesh_.source(s)), mesh_.point(apex));
    const auto y = Geometry::scaled_difference(mesh_.point(mesh_.target(s)), mesh_.point(apex));
    const auto d = dot(x, y);
    return d < 0 && d * d > cosine2_of_long_edge * (squared_length(x) * squared_length(y));
  }

  /// Finds the sides on the border's right. Whether all of its pieces are edges of the mesh, as they should
  /// be.
  bool find_border_edges() {
    for (Border_edge& e : edges_) {
      const Vertex_id a = vertices_[e.source].vertex, b = vertices_[e.target].vertex;
      const Side s = mesh_.find_side(a, b);
      if (s.is_border()) return false;
      e.outer = mesh_.source(s) == a ? mesh_.across(s) : s;
      if (e.outer.is_constrained()) return false;
    }
    return true;
  }

  /// Takes out the triangles within the border.
  void clear_inside() {
    Indexed_vector<Triangle_id, char> is_marked(mesh_.triangles.size(), 0);
    std::vector<Triangle_id> inside;
    for (const Border_edge& e : edges_) mesh_.constrain(e.outer);
    for (const Border_edge& e : edges_) {
      const Triangle_id t = mesh_.across(e.outer).triangle();
      if (is_marked[t] != 0) continue;
      is_marked[t] = 1;
      inside.push_back(t);
    }
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (const Side o : mesh_.triangle(inside[i]).side) {
        if (o.is_constrained() || is_marked[o.triangle()] != 0) continue;
        is_marked[o.triangle()] = 1;
        inside.push_back(o.triangle());
      }
    for (const Triangle_id t : inside) mesh_.kill(t);
  }

  // ---- the squares

  /// Sizes were looked up at some places only; what they missed is left to the refiner.
  void push_where_sizes_vary() {
    if (!state_.bounds.is_local()) return;
    const std::size_t n = state_.bulk.number_of_triangles(), first = state_.bulk.first_triangle.value();
    std::vector<std::vector<Triangle_id>> suspects((n + default_block - 1) / default_block);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (const Triangle_id t : Id_range<Triangle_id>(first + begin, first + end))
        if (state_.is_suspect(t)) suspects[b].push_back(t);
    });
    for (const auto& some : suspects)
      for (const Triangle_id t : some) state_.push(t);
  }

  void link_border(const Squares& squares, const Triangles& triangles) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Side s = triangles.side_of(squares.border()[i]);
      Side outer = edges_[i].outer;
      outer.release();
      mesh_.link(s.triangle(), s.slot(), outer);
      mesh_.triangle_of[vertices_[edges_[i].source].vertex] = s.triangle();
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_FILLER_H
