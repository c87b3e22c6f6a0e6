// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SECTOR_MESHES_H
#define QUADTREE_MESH_2_TEST_SECTOR_MESHES_H

// The mesh of a sector near its vertex, for all parameters in a box.
//
// What is triangulated is a region of leaves' squares, cut by the two edges. It ends at the last line of each edge, the
// fourth or the sixth ahead. It consists of
// - the 5 x 5 squares around the vertex, whose neighbors are in the 7 x 7 equal leaves;
// - beside each edge, squares up to those whose corners are certainly further from the edge than its thresholds;
// - where the edges are near each other, all squares between them up to the last lines.
// So all corners that are dropped because of the vertex are inside, and leaves of the region that lose a corner have
// neighbors of their size.
//
// The triangles are found at the center of the box, in doubles, which does not matter. They are a triangulation of the
// region for all parameters if they are counterclockwise for all, and this holds of their combinatorics:
// - sides with a triangle on one side only form one loop;
// - they are pieces of the edges, from the vertex to the last lines, pieces of the last lines between vertices that
//   follow each other, or sides of leaves outside of the region that keep all corners;
// - all vertices in the region, and on its boundary, are used.
// The loop is a simple polygon for all parameters. Counterclockwise triangles cover what it winds around once.

#include "sector_boxes.h"

#include <CGAL/Quadtree_mesh_2/internal/columns/Small_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace vertex_certificates {

/// Thresholds of the rule in 64ths.
struct Thresholds {
  std::int64_t of_vertex, of_edge;
};

inline std::vector<Thresholds> thresholds_of_rule() {
  std::vector<Thresholds> all;
  for (const Sector_thresholds& t : sector_thresholds)
    all.push_back({static_cast<std::int64_t>(threshold_units * t.clear_of_vertex),
                   static_cast<std::int64_t>(threshold_units * t.clear_of_edge)});
  return all;
}

constexpr std::int64_t far_threshold = static_cast<std::int64_t>(threshold_units * equal_leaves_threshold);

/// In hundredths: beyond line 4, edges at least 60 degrees apart do not drop corners in each other's strips, and beyond
/// line 6 edges 33 degrees apart do not.
constexpr std::int64_t cotangent_of_wide_sectors = 57;

/// A lattice corner or square, by its lower left corner.
using Lattice_point = std::array<std::int64_t, 2>;

/// The part of the plane that is triangulated here.
class Sector_region {
public:
  explicit Sector_region(const Sector_box& sector)
      : sector_(sector), last_line_(sector.is_at_least(cotangent_of_wide_sectors) == Answer::YES ? 4 : 6) {
    for (std::size_t e = 0; e < 2; ++e)
      for (std::int64_t t = -2; t <= last_line_ + 3; ++t) heights_[e].push_back(height_at(e, t));
  }

  std::int64_t last_line() const { return last_line_; }

  bool contains(const Lattice_point& square) const {
    return is_in_block(square, 2) || is_in_strip(0, square) || is_in_strip(1, square) || is_between(square);
  }
  /// Whether a leaf and those beside it are certainly equal.
  bool has_equal_neighbors(const Lattice_point& s) const {
    return has_equal_leaf(s) && has_equal_leaf({s[0] - 1, s[1]}) && has_equal_leaf({s[0] + 1, s[1]}) &&
           has_equal_leaf({s[0], s[1] - 1}) && has_equal_leaf({s[0], s[1] + 1});
  }
  /// Whether the leaf is certainly one of the equal ones.
  bool has_equal_leaf(const Lattice_point& square) const {
    if (is_in_block(square, 3)) return true;
    for (std::size_t e = 0; e < 2; ++e) {
      const std::int64_t column = column_ahead(e, square);
      if (column < 0 || column > last_line_) continue;
      const std::int64_t least = std::max(height(e, column).least, height(e, column + 1).least);
      if (bottom(e, square) * units < least + 3 * units && top(e, square) * units > least - 3 * units)
        return true;
    }
    return false;
  }
  /// Whether a corner is on the last line of an edge.
  bool is_on_last_line(std::size_t e, const Lattice_point& corner) const {
    const std::size_t a = sector_.direction(e).axis();
    return corner[a] == sector_.line_ahead(e, last_line_);
  }
  /// Whether a leaf behind the last line of an edge may lose corners to it.
  bool is_in_next_strip(std::size_t e, const Lattice_point& square) const {
    return column_ahead(e, square) == last_line_ && is_near_edge(e, square);
  }
  /// Whether a corner matters for what is in the region.
  bool is_near(const Lattice_point& corner) const {
    if (is_in_block(corner, 4) || is_between(corner)) return true;
    for (std::size_t e = 0; e < 2; ++e) {
      const std::int64_t column = column_ahead(e, corner);
      if (column < -1 || column > last_line_ + 1) continue;
      if (bottom(e, corner) * units < greatest_height(e, column) + 4 * units &&
          top(e, corner) * units > least_height(e, column) - units)
        return true;
    }
    return false;
  }

private:
  static bool is_in_block(const Lattice_point& square, std::int64_t reach) {
    return std::abs(square[0]) <= reach && std::abs(square[1]) <= reach;
  }
  std::int64_t column_ahead(std::size_t e, const Lattice_point& square) const {
    return sector_.direction(e).sign() * square[sector_.direction(e).axis()];
  }
  /// Which way into the sector is across the edge's axis.
  int up(std::size_t e) const {
    const Octant_direction& d = sector_.direction(e);
    const int left = d.axis() == 0 ? d.sign() : -d.sign();
    return e == 0 ? left : -left;
  }
  std::int64_t bottom(std::size_t e, const Lattice_point& square) const {
    const std::int64_t v = square[1 - sector_.direction(e).axis()];
    return up(e) > 0 ? v : -v - 1;
  }
  std::int64_t top(std::size_t e, const Lattice_point& square) const { return bottom(e, square) + 1; }

  /// Of the edge's line at a grid line, upwards.
  Range height_at(std::size_t e, std::int64_t t) const {
    const std::size_t a = sector_.direction(e).axis();
    const Moving_vertex p = sector_.on_edge(e, 0, 2, sector_.line_ahead(e, t));
    const Range r = range_of(a == 0 ? p.y : p.x);
    return up(e) > 0 ? r : Range{-r.greatest, -r.least};
  }
  const Range& height(std::size_t e, std::int64_t t) const {
    return heights_[e][static_cast<std::size_t>(t + 2)];
  }
  std::int64_t greatest_height(std::size_t e, std::int64_t column) const {
    return std::max(height(e, column).greatest, height(e, column + 1).greatest);
  }
  std::int64_t least_height(std::size_t e, std::int64_t column) const {
    return std::min(height(e, column).least, height(e, column + 1).least);
  }

  /// How far above the edge corners on the lines of a column may be dropped: sqrt(1 + m^2) <= 1 + 5 m / 12.
  std::int64_t greatest_clearance(std::size_t e, std::int64_t column) const {
    const std::int64_t threshold = column < first_far_line ? 55 : far_threshold + 1;
    return threshold * (units / threshold_units) * (12 * grid + 5 * range_of(sector_.slope(e)).greatest) /
           (12 * grid);
  }
  /// Ahead of both edges, where these are near each other.
  bool is_between(const Lattice_point& square) const {
    if (last_line_ == 4) return false;
    for (std::size_t e = 0; e < 2; ++e)
      if (column_ahead(e, square) < 0 || column_ahead(e, square) >= last_line_) return false;
    return true;
  }
  bool is_in_strip(std::size_t e, const Lattice_point& square) const {
    const std::int64_t column = column_ahead(e, square);
    return column >= 0 && column < last_line_ && is_near_edge(e, square);
  }
  bool is_near_edge(std::size_t e, const Lattice_point& square) const {
    const std::int64_t column = column_ahead(e, square);
    return bottom(e, square) * units < greatest_height(e, column) + greatest_clearance(e, column) &&
           top(e, square) * units > least_height(e, column);
  }

  const Sector_box& sector_;
  std::int64_t last_line_;
  std::array<std::vector<Range>, 2> heights_; // from line -2 on
};

/// The vertices of the mesh at the center of the box: all on edges, and those corners that are kept or may be.
class Sector_vertices {
public:
  struct Vertex {
    Moving_vertex place;
    Window_point center;
    unsigned edges = 0;     ///< bit e: on edge e
    std::size_t number = 0; ///< along its edge; 0 is the vertex
    Lattice_point corner{};
    bool is_corner() const { return edges == 0; }
  };

  Sector_vertices(const Sector_box& sector, const Sector_region& region) : sector_(sector), region_(region) {
    append(sector.vertex(), 3, 0);
    for (std::size_t e = 0; e < (sector.is_only_edge() ? 1 : 2); ++e) {
      const unsigned edge = 1u << e;
      const std::int64_t first = sector.first_crossing(e);
      append(sector.on_edge(e, 2, 0, 0), edge, 1);
      append(sector.on_edge(e, 1, 1, sector.line_ahead(e, first)), edge, 2);
      std::size_t n = 3;
      for (std::int64_t t = first; t <= region.last_line() + 2; ++t, ++n) {
        if (t == region.last_line()) last_crossing_[e] = all_.size();
        append(sector.on_edge(e, 0, 2, sector.line_ahead(e, t)), edge, n);
      }
    }
    number_on_edges_ = all_.size();
    for (std::int64_t i = -10; i <= 11; ++i)
      for (std::int64_t j = -10; j <= 11; ++j)
        if (is_near(i, j)) append_corner({i, j});
  }

  const std::vector<Vertex>& all() const { return all_; }
  std::size_t number_on_edges() const { return number_on_edges_; }
  /// The crossing with the last line.
  std::size_t last_crossing(std::size_t e) const { return last_crossing_[e]; }
  std::optional<std::size_t> find(const Lattice_point& corner) const {
    const auto found = index_.find(corner);
    return found == index_.end() ? std::nullopt : std::optional<std::size_t>(found->second);
  }

  /// Whether a corner is kept by one of the rules; nothing if that is open and the corner is not certainly in the
  /// sector.
  std::optional<Answer> is_kept(std::size_t v, const Thresholds& t) const {
    const Lattice_point& c = all_[v].corner;
    bool is_open = false;
    const auto drops = [&](Answer is_clear) {
      is_open = is_open || is_clear == Answer::OPEN;
      return is_clear == Answer::NO;
    };
    if (drops(sector_.is_clear_of_vertex(c[0], c[1], t.of_vertex))) return Answer::NO;
    for (std::size_t e = 0; e < 2; ++e)
      if (drops(is_clear_of(e, c, t))) return Answer::NO;
    const Answer inside = inside_[v - number_on_edges_];
    if (inside == Answer::YES) return is_open ? Answer::OPEN : Answer::YES;
    return std::nullopt;
  }

private:
  bool is_near(std::int64_t i, std::int64_t j) const {
    return region_.is_near({i, j}) || region_.is_near({i - 1, j}) || region_.is_near({i, j - 1}) ||
           region_.is_near({i - 1, j - 1});
  }

  void append(const Moving_vertex& place, unsigned edges, std::size_t number) {
    Vertex v;
    v.place = place;
    v.edges = edges;
    v.number = number;
    // The center of the values is not the place at the center of the box, but between the edges' points on both sides.
    v.center = {mean(place.x), mean(place.y)};
    all_.push_back(v);
  }
  static double mean(const Multilinear& f) {
    double sum = 0;
    for (const std::int64_t value : f.at) sum += double(value);
    return sum / double(number_of_box_corners) / double(units);
  }
  void append_corner(const Lattice_point& corner) {
    const Answer inside = sector_.is_inside(corner[0], corner[1]);
    if (inside == Answer::NO) return;
    index_[corner] = all_.size();
    append(Sector_box::corner(corner[0], corner[1]), 0, 0);
    all_.back().corner = corner;
    inside_.push_back(inside);
  }

  Answer is_clear_of(std::size_t e, const Lattice_point& c, const Thresholds& t) const {
    const Range along = range_of(sector_.along(e, c[0], c[1]));
    if (along.greatest < 0) return Answer::YES;
    const std::size_t a = sector_.direction(e).axis();
    const std::int64_t line = sector_.direction(e).sign() > 0 ? c[a] : 1 - c[a];
    const Answer clear =
        sector_.is_clear_of_edge(e, c[0], c[1], line >= first_far_line ? far_threshold : t.of_edge);
    return clear == Answer::NO && along.least <= 0 ? Answer::OPEN : clear;
  }

  const Sector_box& sector_;
  const Sector_region& region_;
  std::vector<Vertex> all_;
  std::vector<Answer> inside_; // of corners
  std::map<Lattice_point, std::size_t> index_;
  std::array<std::size_t, 2> last_crossing_{};
  std::size_t number_on_edges_ = 0;
};

/// Triangles by their vertices, the least one first.
using Triangles = std::vector<std::array<std::size_t, 3>>;

/// What is found for one choice of corners.
class Sector_mesh {
public:
  using Vertex = Sector_vertices::Vertex;
  using Side = std::pair<std::size_t, std::size_t>;

  Sector_mesh(const Sector_box& sector, const Sector_region& region, const Sector_vertices& vertices)
      : sector_(sector), region_(region), vertices_(vertices) {
    const auto middle = [](const Multilinear& f) {
      return double(f.at[0] + f.at[number_of_box_corners - 1]);
    };
    for (std::size_t e = 0; e < 2; ++e)
      directions_[e] = {middle(sector.direction_along(e, 0)), middle(sector.direction_along(e, 1))};
    for (std::int64_t i = -10; i <= 10; ++i)
      for (std::int64_t j = -10; j <= 10; ++j)
        if (region.contains({i, j}) && !region.has_equal_neighbors({i, j}) && has_corner(i, j))
          lonely_squares_.push_back({i, j});
  }

  /// The triangles in the region, if they are a triangulation of it for all parameters in the box, provided that all of
  /// them are counterclockwise.
  /// \param is_kept for each vertex; \param is_certain: so for all choices
  std::optional<Triangles> triangulate(const std::vector<char>& is_kept,
                                       const std::vector<char>& is_certain) {
    std::vector<std::size_t> names;
    std::vector<Window_point> points;
    for (std::size_t v = 0; v < vertices_.all().size(); ++v)
      if (is_kept[v] != 0) {
        names.push_back(v);
        points.push_back(vertices_.all()[v].center);
      }
    // The vertices on edges are all kept, and come first.
    const bool is_more_than_half = sector_.eighths() > 4 && !sector_.is_only_edge();
    delaunay_.triangulate(points, vertices_.number_on_edges(), [&](const Small_triangulation::Triangle& t) {
      return is_more_than_half && !is_in_sector(center({names[t[0]], names[t[1]], names[t[2]]}));
    });
    Triangles triangles;
    delaunay_.for_each_triangle([&](const Small_triangulation::Triangle& t) {
      std::array<std::size_t, 3> v{names[t[0]], names[t[1]], names[t[2]]};
      std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
      if (is_in_region(v)) triangles.push_back(v);
    });
    std::sort(triangles.begin(), triangles.end());
    if (!has_right_boundary(triangles, is_certain) || !are_lonely_squares_whole(is_certain) ||
        !uses_all(triangles, is_kept))
      return std::nullopt;
    return triangles;
  }

  /// The sides of the last triangulation that have a triangle on one side only.
  std::vector<Side> boundary() const {
    std::vector<Side> sides;
    for (std::size_t v = 0; v < next_.size(); ++v)
      if (next_[v] != none) sides.push_back({v, next_[v]});
    return sides;
  }

  /// Whether a vertex is in the region or on its boundary.
  bool belongs_to_region(const Vertex& v) const {
    if (!v.is_corner())
      return v.edges == 3 || v.number <= vertex(vertices_.last_crossing(v.edges == 1 ? 0 : 1)).number;
    for (std::int64_t k = 0; k < 4; ++k)
      if (region_.contains({v.corner[0] - k % 2, v.corner[1] - k / 2})) return true;
    return false;
  }

private:
  const Vertex& vertex(std::size_t v) const { return vertices_.all()[v]; }
  bool has_corner(std::int64_t i, std::int64_t j) const {
    return vertices_.find({i, j}) || vertices_.find({i + 1, j}) || vertices_.find({i, j + 1}) ||
           vertices_.find({i + 1, j + 1});
  }

  bool is_in_region(const std::array<std::size_t, 3>& t) const {
    const Vertex &a = vertex(t[0]), &b = vertex(t[1]), &c = vertex(t[2]);
    if ((a.edges & b.edges & c.edges) != 0) return false;
    const Window_point p = center(t);
    const Lattice_point square{static_cast<std::int64_t>(std::floor(p.x)),
                               static_cast<std::int64_t>(std::floor(p.y))};
    return region_.contains(square) && is_in_sector(p);
  }
  Window_point center(const std::array<std::size_t, 3>& t) const {
    const Window_point &a = vertex(t[0]).center, &b = vertex(t[1]).center, &c = vertex(t[2]).center;
    return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
  }
  bool is_in_sector(const Window_point& p) const {
    if (sector_.is_only_edge()) return true;
    const Window_point& v = vertex(0).center;
    const auto left_of = [&](const Window_point& d) { return d.x * (p.y - v.y) - d.y * (p.x - v.x); };
    const auto& d = directions_;
    const bool is_convex =
        sector_.eighths() < 4 || (sector_.eighths() == 4 && d[0].x * d[1].y - d[0].y * d[1].x > 0);
    const bool is_left = left_of(d[0]) > 0, is_right = left_of(d[1]) < 0;
    return is_convex ? is_left && is_right : is_left || is_right;
  }

  /// Whether sides without a triangle on the other side make one loop, along the edges and around the region.
  bool has_right_boundary(const Triangles& triangles, const std::vector<char>& is_certain) {
    sides_.clear();
    for (const auto& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) sides_.push_back({t[i], t[(i + 1) % 3]});
    std::sort(sides_.begin(), sides_.end());
    if (std::adjacent_find(sides_.begin(), sides_.end()) != sides_.end()) return false;
    next_.assign(vertices_.all().size(), none);
    std::size_t number = 0;
    for (const Side& s : sides_) {
      if (std::binary_search(sides_.begin(), sides_.end(), Side{s.second, s.first})) continue;
      if (next_[s.first] != none || !is_on_boundary(s, is_certain)) return false;
      next_[s.first] = s.second;
      ++number;
    }
    const std::size_t start = vertices_.last_crossing(0);
    std::size_t v = start, length = 0;
    do {
      v = next_[v];
      if (v == none || ++length > number) return false;
    } while (v != start);
    return length == number;
  }

  bool is_on_boundary(const Side& s, const std::vector<char>& is_certain) const {
    const Vertex &a = vertex(s.first), &b = vertex(s.second);
    if ((a.edges & b.edges & 1u) != 0) return b.number == a.number + 1;
    if ((a.edges & b.edges & 2u) != 0) return a.number == b.number + 1;
    for (std::size_t e = 0; e < 2; ++e)
      if (is_on_last_line(e, a) && is_on_last_line(e, b) &&
          (!a.is_corner() || !b.is_corner() || region_.is_in_next_strip(e, right_of(a.corner, b.corner))))
        return true;
    return a.is_corner() && b.is_corner() && is_beside_whole_leaf(a.corner, b.corner, is_certain);
  }
  bool is_on_last_line(std::size_t e, const Vertex& v) const {
    return v.is_corner() ? region_.is_on_last_line(e, v.corner)
                         : v.edges == 1u << e && v.number == vertex(vertices_.last_crossing(e)).number;
  }
  /// The leaf to the right of its side.
  static Lattice_point right_of(const Lattice_point& a, const Lattice_point& b) {
    return {std::min(a[0], b[0]) - (b[1] < a[1] ? 1 : 0), std::min(a[1], b[1]) - (b[0] > a[0] ? 1 : 0)};
  }
  bool is_beside_whole_leaf(const Lattice_point& a, const Lattice_point& b,
                            const std::vector<char>& is_certain) const {
    if (std::abs(b[0] - a[0]) + std::abs(b[1] - a[1]) != 1) return false;
    const Lattice_point square = right_of(a, b);
    return !region_.contains(square) && is_whole(square, is_certain);
  }
  bool is_whole(const Lattice_point& square, const std::vector<char>& is_certain) const {
    for (std::int64_t k = 0; k < 4; ++k) {
      const auto v = vertices_.find({square[0] + k % 2, square[1] + k / 2});
      if (!v || is_certain[*v] == 0) return false;
    }
    return true;
  }
  bool are_lonely_squares_whole(const std::vector<char>& is_certain) const {
    return std::all_of(lonely_squares_.begin(), lonely_squares_.end(), [&](const Lattice_point& s) {
      if (!is_whole(s, is_certain)) return false;
      const std::array<Lattice_point, 4> corners{s, {s[0] + 1, s[1]}, {s[0] + 1, s[1] + 1}, {s[0], s[1] + 1}};
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t a = *vertices_.find(corners[i]), b = *vertices_.find(corners[(i + 1) % 4]);
        if (!std::binary_search(sides_.begin(), sides_.end(), Side{a, b})) return false;
      }
      return true;
    });
  }

  bool uses_all(const Triangles& triangles, const std::vector<char>& is_kept) {
    is_used_.assign(vertices_.all().size(), 0);
    for (const auto& t : triangles)
      for (const std::size_t v : t) is_used_[v] = 1;
    for (std::size_t v = 0; v < vertices_.all().size(); ++v)
      if (is_kept[v] != 0 && is_used_[v] == 0 && belongs_to_region(vertex(v))) return false;
    return true;
  }
  static constexpr std::size_t none = ~std::size_t(0);

  const Sector_box& sector_;
  const Sector_region& region_;
  const Sector_vertices& vertices_;
  std::array<Window_point, 2> directions_; // at the center of the box
  Small_triangulation delaunay_;
  std::vector<Lattice_point> lonely_squares_;
  std::vector<Side> sides_;
  std::vector<std::size_t> next_;
  std::vector<char> is_used_;
};

} // namespace vertex_certificates

#endif // QUADTREE_MESH_2_TEST_SECTOR_MESHES_H
