// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The cells around the vertices of a mesh.
//
// Computes: the polygons, areas and lengths of `Mesh_dual_2`.
// Bound:    O(k) work for k triangles with neighbors, besides the ways to circumcenters (Circumcenters.h).
// Method:   The polygon of a fan of triangles goes around its vertex from one center to the next. At a wall it goes to
//           the midpoint of the wall and on from there. On the way to a circumcenter that is out of sight, it ends at
//           the wall that hides it, and goes on from where the way back comes out of the same wall.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DUAL_DUAL_BUILDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DUAL_DUAL_BUILDER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/dual/Circumcenters.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/Edge_finder.h>
#include <CGAL/Quadtree_mesh_2/mesh_dual_types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Point>
class Dual_builder {
public:
  /// Keeps a reference to the mesh.
  Dual_builder(const Indexed_mesh_2<Point>& mesh, Mesh_dual_2::Kind kind)
      : mesh_(mesh), finder_(mesh), edges_of_(finder_.edges_of_triangles()) {
    if (kind == Mesh_dual_2::Kind::CIRCUMCENTRIC)
      centers_.emplace(mesh, finder_.neighbors(), finder_.edges());
  }

  Mesh_dual_2 run() {
    place_centers();
    place_points_on_edges();
    find_fans();
    place_border_vertices();
    make_polygons();
    measure_edges();
    dual_.edges = finder_.take_edges();
    return std::move(dual_);
  }

private:
  using Centers = Circumcenters<ConcurrencyTag, Point>;
  using Side_number = typename Centers::Side_number;
  static constexpr Side_number in_sight = Centers::no_side;
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t next(std::size_t k) { return (k + 1) % 3; }
  static constexpr std::size_t previous(std::size_t k) { return (k + 2) % 3; }

  /// The corner `k` of a triangle, or the side opposite to it.
  struct Corner {
    Triangle_index triangle;
    std::size_t k;
  };
  /// What is on the bisector of an edge: its midpoint, and where the ways to the circumcenters of both triangles beside
  /// it end at walls that hide these.
  struct Points_on_edge {
    std::array<std::uint32_t, 2> cut{nowhere, nowhere};
    std::uint32_t middle = nowhere;
  };
  /// A center or a midpoint, and the wall that hides it.
  struct Stop {
    std::uint32_t point;
    Side_number wall;
    Triangle_index triangle; ///< the way to it is in sight of this one
  };

  const Indexed_mesh_2<Point>& mesh_;
  Edge_finder<ConcurrencyTag, Point> finder_;
  std::vector<std::array<std::uint32_t, 3>> edges_of_; // of triangles
  std::optional<Centers> centers_;                     // none: centroids
  std::vector<Points_on_edge> on_edge_;
  std::vector<std::uint32_t> border_vertex_; // the points of vertices on the border
  std::vector<Corner> fans_;                 // the first corner of each, in the order of vertices
  Mesh_dual_2 dual_;

  Dual_place place(Vertex_index v) const {
    return {as_double(mesh_.point(v).x()), as_double(mesh_.point(v).y())};
  }
  Dual_place middle_of(const Mesh_edge_2& e) const {
    const Dual_place a = place(e.vertices[0]), b = place(e.vertices[1]);
    return {0.5 * a[0] + 0.5 * b[0], 0.5 * a[1] + 0.5 * b[1]};
  }
  Triangle_index neighbor(const Corner& side) const {
    return finder_.neighbors()[std::size_t(side.triangle)][side.k];
  }
  std::size_t edge(const Corner& side) const { return edges_of_[std::size_t(side.triangle)][side.k]; }
  bool is_wall(std::size_t e) const {
    return centers_ ? centers_->is_wall(e) : finder_.edges()[e].is_on_border();
  }
  Side_number wall_before(Triangle_index t) const { return centers_ ? centers_->wall_before(t) : in_sight; }
  std::uint32_t center(Triangle_index t) const { return centers_ ? centers_->representative(t) : t.value(); }

  // --- Points ---

  void place_centers() {
    dual_.points.resize(mesh_.triangles.size());
    for_each_index<ConcurrencyTag>(mesh_.triangles.size(), [this](std::size_t t) {
      dual_.points[t] = centers_ ? centers_->center(Triangle_index(t)) : centroid(t);
    });
  }

  Dual_place centroid(std::size_t t) const {
    const auto& [u, v, w] = mesh_.triangles[t];
    const Dual_place a = place(u), b = place(v), c = place(w);
    return {a[0] / 3 + b[0] / 3 + c[0] / 3, a[1] / 3 + b[1] / 3 + c[1] / 3};
  }

  /// The wall at which the way from an edge to a center beside it ends.
  Side_number wall_on_way(const Mesh_edge_2& e, std::size_t beside, bool is_at_wall) const {
    const Triangle_index t = e.triangles[beside], u = e.triangles[1 - beside];
    if (!t.is_valid() || !centers_) return in_sight;
    const Side_number wall = wall_before(t);
    const Side_number behind = is_at_wall ? centers_->side_at(t, e) : wall_before(u);
    return wall == behind ? in_sight : wall;
  }

  /// Whether a wall has its midpoint between cells, on one side at least, and it is no center.
  bool has_middle(const Mesh_edge_2& e) const {
    if (!centers_) return true;
    const Dual_place middle = middle_of(e);
    for (const Triangle_index t : e.triangles)
      if (t.is_valid() && centers_->is_center(middle, t)) return false;
    return true;
  }

  void place_points_on_edges() {
    const auto& edges = finder_.edges();
    on_edge_.resize(edges.size());
    const auto count = [&](std::size_t e) {
      const bool is_at_wall = is_wall(e);
      std::size_t n = (!centers_ || is_at_wall) && has_middle(edges[e]) ? 1 : 0;
      for (std::size_t k = 0; k < 2; ++k) n += wall_on_way(edges[e], k, is_at_wall) != in_sight ? 1 : 0;
      return n;
    };
    count_allocate_and_place<ConcurrencyTag>(
        edges.size(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t n = 0;
          for (std::size_t e = begin; e < end; ++e) n += count(e);
          return n;
        },
        [this](std::size_t n) { dual_.points.resize(dual_.points.size() + n); },
        [&](std::size_t begin, std::size_t end, std::size_t first) {
          std::size_t number = mesh_.triangles.size() + first;
          for (std::size_t e = begin; e < end; ++e) place_points_on_edge(e, number);
        });
  }

  void place_points_on_edge(std::size_t e, std::size_t& number) {
    const Mesh_edge_2& edge = finder_.edges()[e];
    const bool is_at_wall = is_wall(e);
    const auto place_next = [&](const Dual_place& p) {
      dual_.points[number] = p;
      return static_cast<std::uint32_t>(number++);
    };
    for (std::size_t k = 0; k < 2; ++k) {
      const Side_number wall = wall_on_way(edge, k, is_at_wall);
      if (wall != in_sight) on_edge_[e].cut[k] = place_next(crossing(edge, wall));
    }
    if (centers_ && !is_at_wall) return;
    if (has_middle(edge))
      on_edge_[e].middle = place_next(middle_of(edge));
    else
      for (const Triangle_index t : edge.triangles)
        if (t.is_valid() && centers_->is_center(middle_of(edge), t)) on_edge_[e].middle = center(t);
  }

  /// Where the bisector of an edge meets a wall.
  Dual_place crossing(const Mesh_edge_2& e, Side_number wall) const {
    const Dual_place p = place(e.vertices[0]), q = place(e.vertices[1]), m = middle_of(e);
    const auto [a, b] = centers_->ends(wall);
    const double nx = q[0] - p[0], ny = q[1] - p[1], wx = b[0] - a[0], wy = b[1] - a[1];
    const double share = ((m[0] - a[0]) * nx + (m[1] - a[1]) * ny) / (wx * nx + wy * ny);
    const double inside = share > 0 ? std::min(share, 1.) : 0; // also if there is none up to rounding
    return {a[0] + inside * wx, a[1] + inside * wy};
  }

  void place_border_vertices() {
    border_vertex_.assign(mesh_.points.size(), nowhere);
    for (const Mesh_edge_2& e : finder_.edges())
      if (e.is_on_border())
        for (const Vertex_index v : e.vertices) border_vertex_[std::size_t(v)] = 0;
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (border_vertex_[v] != nowhere) {
        border_vertex_[v] = static_cast<std::uint32_t>(dual_.points.size());
        dual_.points.push_back(place(Vertex_index(v)));
      }
  }

  // --- Polygons ---

  /// The fan of a vertex inside begins anywhere, others behind a border.
  void find_fans() {
    const std::size_t n = mesh_.points.size();
    std::vector<Corner> any(n);
    auto& first = dual_.first_polygon;
    first.assign(n + 1, 0);
    const auto is_first = [this](const Corner& c) {
      return !neighbor({c.triangle, previous(c.k)}).is_valid();
    };
    const auto for_each_corner = [this](const auto& f) {
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
          f(Corner{Triangle_index(t), k}, std::size_t(mesh_.triangles[t][k]));
    };
    for_each_corner([&](const Corner& c, std::size_t v) {
      any[v] = c;
      if (is_first(c)) ++first[v];
    });
    for (std::size_t v = 0; v < n; ++v)
      if (first[v] == 0 && any[v].triangle.is_valid()) first[v] = 1;
    fans_.resize(scan_exclusively(first.data(), n + 1, std::size_t(0)));
    for (std::size_t v = 0; v < n; ++v)
      if (first[v] < first[v + 1]) fans_[first[v]] = any[v];
    std::vector<std::size_t> end(first.begin(), first.end() - 1);
    for_each_corner([&](const Corner& c, std::size_t v) {
      if (is_first(c)) fans_[end[v]++] = c;
    });
  }

  void make_polygons() {
    const std::size_t n = fans_.size();
    auto& first = dual_.first_corner;
    first.assign(n + 1, 0);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { first[i] = polygon(fans_[i]).size(); });
    dual_.corners.resize(exclusive_scan<ConcurrencyTag>(first.data(), n + 1));
    dual_.areas.assign(mesh_.points.size(), 0);
    for_each_index<ConcurrencyTag>(mesh_.points.size(), [&](std::size_t v) {
      for (std::size_t i = dual_.first_polygon[v]; i < dual_.first_polygon[v + 1]; ++i) {
        const std::vector<std::uint32_t> corners = polygon(fans_[i]);
        std::copy(corners.begin(), corners.end(),
                  dual_.corners.begin() + static_cast<std::ptrdiff_t>(first[i]));
        dual_.areas[v] += area(corners, place(Vertex_index(v)));
      }
    });
  }

  double area(const std::vector<std::uint32_t>& corners, const Dual_place& origin) const {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      twice += cross_at(origin, dual_.points[corners[i]], dual_.points[corners[(i + 1) % corners.size()]]);
    return twice / 2;
  }

  Stop center_stop(Triangle_index t) const { return {center(t), wall_before(t), t}; }
  /// The midpoint of a wall, as a triangle beside it sees it. Out of sight if the center is beyond the wall: the third
  /// vertex has what is there.
  Stop middle_stop(std::size_t e, Triangle_index t) const {
    const Side_number wall = wall_before(t);
    const bool is_hidden = wall != in_sight && wall == centers_->side_at(t, finder_.edges()[e]);
    return {on_edge_[e].middle, is_hidden ? wall : in_sight, t};
  }

  /// The corners of the polygon of a fan.
  std::vector<std::uint32_t> polygon(const Corner& start) const {
    std::vector<std::uint32_t> corners;
    const Corner begin{start.triangle, previous(start.k)};
    const bool is_open = !neighbor(begin).is_valid();
    if (is_open) {
      const Vertex_index v = mesh_.triangles[std::size_t(start.triangle)][start.k];
      add(corners, border_vertex_[std::size_t(v)]);
      const Stop middle = middle_stop(edge(begin), start.triangle);
      if (middle.wall == in_sight) add(corners, middle.point);
      go(corners, middle, center_stop(start.triangle), edge(begin));
    }
    Corner c = start;
    do {
      const Corner side{c.triangle, next(c.k)};
      const Triangle_index u = neighbor(side);
      const std::size_t e = edge(side);
      if (!u.is_valid()) {
        go(corners, center_stop(c.triangle), middle_stop(e, c.triangle), e);
        break;
      }
      cross(corners, e, c.triangle, u);
      c = {u, next(corner_of_edge(u, e))};
    } while (c.triangle != start.triangle);
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    return corners;
  }

  std::size_t corner_of_edge(Triangle_index t, std::size_t e) const {
    const auto& edges = edges_of_[std::size_t(t)];
    return edges[0] == e ? 0 : edges[1] == e ? 1 : 2;
  }

  static void add(std::vector<std::uint32_t>& corners, std::uint32_t point) {
    if (corners.empty() || corners.back() != point) corners.push_back(point);
  }

  /// From the center of a triangle to that of the next one.
  void cross(std::vector<std::uint32_t>& corners, std::size_t e, Triangle_index from,
             Triangle_index to) const {
    if (!is_wall(e)) {
      if (!centers_) add(corners, on_edge_[e].middle);
      return go(corners, center_stop(from), center_stop(to), e);
    }
    go(corners, center_stop(from), middle_stop(e, from), e);
    const Stop middle = middle_stop(e, to);
    if (middle.wall == in_sight) add(corners, middle.point);
    go(corners, middle, center_stop(to), e);
  }

  /// Along the bisector of an edge.
  void go(std::vector<std::uint32_t>& corners, const Stop& from, const Stop& to, std::size_t e) const {
    if (from.wall != to.wall)
      for (const Stop* stop : {&from, &to})
        if (stop->wall != in_sight) add(corners, cut(e, stop->triangle));
    if (to.wall == in_sight) add(corners, to.point);
  }

  std::uint32_t cut(std::size_t e, Triangle_index t) const {
    return on_edge_[e].cut[finder_.edges()[e].triangles[0] == t ? 0 : 1];
  }

  // --- Edges ---

  void measure_edges() {
    dual_.lengths.resize(finder_.edges().size());
    for_each_index<ConcurrencyTag>(dual_.lengths.size(),
                                   [this](std::size_t e) { dual_.lengths[e] = length_between_cells(e); });
  }

  double length_between_cells(std::size_t e) const {
    const auto& [t, u] = finder_.edges()[e].triangles;
    if (centers_ && !is_wall(e)) {
      if (wall_before(t) != in_sight && wall_before(t) == wall_before(u)) return 0;
      return distance_between(end_in_sight(e, t), end_in_sight(e, u));
    }
    double sum = 0;
    for (const Triangle_index beside : {t, u})
      if (beside.is_valid() && middle_stop(e, beside).wall == in_sight)
        sum += distance_between(dual_.points[on_edge_[e].middle], end_in_sight(e, beside));
    return sum;
  }

  /// How far the way from an edge to the center of a triangle goes.
  const Dual_place& end_in_sight(std::size_t e, Triangle_index t) const {
    return dual_.points[wall_before(t) == in_sight ? center(t) : cut(e, t)];
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DUAL_DUAL_BUILDER_H
