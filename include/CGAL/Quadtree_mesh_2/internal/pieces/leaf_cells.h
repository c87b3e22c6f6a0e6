// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The cells into which pieces of segments cut a leaf.
//
// Computes: for each cell of the arrangement of segments in a square, the segments on its boundary. The sides
//           of the square bound cells, too.
// Bound:    O(p log p) time for p segments, with divisions of products of two coordinates, not counting the
//           lengths of the cells' lists. A segment is listed in at most two cells, with two exceptions. One
//           is segments that are in no way connected to the sides. The other is segments with a single point,
//           on a side: these are listed in all cells at this point.
// Source:   Bern, Eppstein, Teng, section 6: "the arrangement of edges in a single square"; "each pair of
//           edge pieces that bound a common cell".
// Method:   The half-edges of a plane graph. Its vertices are the places where segments meet the sides of the
//           closed square, and the ends of segments inside. Around each vertex, edges are sorted by
//           direction. Faces are cycles of half-edges.
// Deviates: a group of segments inside may meet no side. The face that it lies in is not searched for.
//           Instead the group is listed as a cell with all segments. Squares with one vertex of the graph
//           have no such groups.
//
// Segments go between grid points and must not cross there. If rounding to the grid has made some cross,
// there still are faces, though maybe not those of the arrangement.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_LEAF_CELLS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_LEAF_CELLS_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Leaf_segments.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Finds the cells of segments in one square after the other; keeps its memory in between.
template <class Word>
class Leaf_cells {
public:
  using Coordinate = typename Signed_grid<Word>::Coordinate;
  using Product = typename Signed_grid<Word>::Product;
  using Ends = std::array<Grid_point_2<Word>, 2>;
  /// Segments by their places in the list, increasing.
  using Cell = std::vector<std::uint32_t>;

  /// Calls `f(cell)` for the cells that have segments on their boundaries.
  /// \param low the lower left corner of the square
  /// \param segments of `Ends`; all meet the closed square and none crosses another one
  template <class F>
  void for_each_cell(const Grid_point_2<Word>& low, const Word& side, const std::vector<Ends>& segments,
                     const F& f) {
    low_ = {{Coordinate(low.x), Coordinate(low.y)}};
    side_ = Coordinate(side);
    segments_ = segments.size();
    ends_.clear();
    for (std::uint32_t i = 0; i < segments_; ++i) add_ends(i, Line(segments[i]));
    link_ends();
    if (has_isolated_) {
      cell_.resize(segments_);
      for (std::uint32_t i = 0; i < segments_; ++i) cell_[i] = i;
      f(static_cast<const Cell&>(cell_));
    }
    for (std::uint32_t h = 0; h < clockwise_.size(); ++h)
      if (!is_done_[h] && collect_face(h)) f(static_cast<const Cell&>(cell_));
  }

  /// Calls `f(i, j)`, i < j, for pairs of segments on the boundary of a common cell, maybe more than once.
  template <class F>
  void for_each_pair(const Grid_point_2<Word>& low, const Word& side, const std::vector<Ends>& segments,
                     const F& f) {
    for_each_cell(low, side, segments, [&](const Cell& cell) {
      for (std::size_t j = 1; j < cell.size(); ++j)
        for (std::size_t i = 0; i < j; ++i) f(cell[i], cell[j]);
    });
  }

private:
  using Pair = std::array<Coordinate, 2>;
  static constexpr std::uint32_t none_ = 0xffffffffu;

  /// A segment with the extent of its coordinates, without their signs.
  struct Line {
    explicit Line(const Ends& e)
        : begin{{Coordinate(e[0].x), Coordinate(e[0].y)}}, step{{Coordinate(e[1].x) - begin[0],
                                                                 Coordinate(e[1].y) - begin[1]}},
          extent{
              {step[0] < 0 ? Coordinate(-step[0]) : step[0], step[1] < 0 ? Coordinate(-step[1]) : step[1]}} {}

    Pair begin, step, extent;
  };

  /// Where a line meets one of the grid's lines: at this distance from its first end along an axis. Without an
  /// axis, at one of its ends.
  struct Meeting {
    int axis;
    Coordinate offset;
  };

  /// A place on the sides, counterclockwise from the lower left corner, or inside.
  struct Place {
    int side;          ///< 0 to 3; 4 inside
    Coordinate at;     ///< from the side's first corner, rounded down; inside, the first coordinate
    Coordinate second; ///< inside only
    Product rest;      ///< of `at`, over `denominator`
    Coordinate denominator;
  };

  struct End {
    Place place;
    Pair direction;          ///< into the segment; on a side, turned as if that were the lower one
    std::uint32_t half_edge; ///< 2 i at the first place of segment i, 2 i + 1 at its last
    bool is_point;           ///< of a segment with one point only on the sides
  };

  /// Returns a number less than, equal to or greater than 0 if `p` is before, at or behind `q`.
  static int compare(const Place& p, const Place& q) {
    if (p.side != q.side) return p.side < q.side ? -1 : 1;
    if (p.at != q.at) return p.at < q.at ? -1 : 1;
    if (p.side == 4) return p.second < q.second ? -1 : p.second == q.second ? 0 : 1;
    const Product of_p = p.rest * q.denominator, of_q = q.rest * p.denominator;
    return of_p < of_q ? -1 : of_p == of_q ? 0 : 1;
  }

  /// Whether a direction is before another one, counterclockwise from that of the positive x-axis.
  static bool turns_before(const Pair& u, const Pair& w) {
    const auto is_lower = [](const Pair& d) { return d[1] < 0 || (d[1] == 0 && d[0] < 0); };
    if (is_lower(u) != is_lower(w)) return is_lower(w);
    return Product(u[0]) * w[1] > Product(u[1]) * w[0];
  }

  /// The place of a point with a coordinate `low + whole + rest / denominator` along the other axis, on a side.
  Place on_side(int side, Coordinate whole, Product rest, const Coordinate& denominator) const {
    if (side >= 2) { // against the axis
      whole = side_ - whole;
      if (rest != 0) {
        whole -= 1;
        rest = denominator - rest;
      }
    }
    if (whole == side_) return {(side + 1) % 4, 0, 0, 0, 1};
    return {side, whole, 0, rest, denominator};
  }

  Place place_of_point(const Pair& p) const {
    const Coordinate x = p[0] - low_[0], y = p[1] - low_[1];
    if (y == 0) return on_side(0, x, 0, 1);
    if (x == side_) return on_side(1, y, 0, 1);
    if (y == side_) return on_side(2, x, 0, 1);
    if (x == 0) return on_side(3, y, 0, 1);
    return {4, x, y, 0, 1};
  }

  Place place_of(const Line& line, const Meeting& m, bool is_first) const {
    if (m.axis < 0)
      return place_of_point(is_first ? line.begin
                                     : Pair{{line.begin[0] + line.step[0], line.begin[1] + line.step[1]}});
    const std::size_t axis = static_cast<std::size_t>(m.axis), other = 1 - axis;
    // The first side met across an axis is the lower one if the line ascends.
    const bool is_high = (line.step[axis] > 0) != is_first;
    const int side = axis == 0 ? (is_high ? 1 : 3) : (is_high ? 2 : 0);
    const Product product = Product(m.offset) * line.extent[other];
    Coordinate whole = Coordinate(product / line.extent[axis]);
    Product rest = product % line.extent[axis];
    if (line.step[other] < 0) {
      whole = -whole;
      if (rest != 0) {
        whole -= 1;
        rest = line.extent[axis] - rest;
      }
    }
    return on_side(side, line.begin[other] - low_[other] + whole, rest, line.extent[axis]);
  }

  /// Whether one meeting is before another one on the line.
  static bool is_before(const Line& line, const Meeting& m, const Meeting& n) {
    return Product(m.offset) * line.extent[static_cast<std::size_t>(1 - m.axis)] <
           Product(n.offset) * line.extent[static_cast<std::size_t>(1 - n.axis)];
  }

  /// Where the line enters the closed square, and where it leaves it.
  std::array<Meeting, 2> meetings(const Line& line) const {
    std::array<Meeting, 2> result{{{-1, 0}, {-1, 0}}};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (line.step[axis] == 0) continue;
      const Coordinate low = line.step[axis] > 0 ? Coordinate(low_[axis] - line.begin[axis])
                                                 : Coordinate(line.begin[axis] - low_[axis] - side_);
      const Meeting entry{static_cast<int>(axis), low}, exit{static_cast<int>(axis), Coordinate(low + side_)};
      if (entry.offset > 0 && (result[0].axis < 0 || is_before(line, result[0], entry))) result[0] = entry;
      if (exit.offset < line.extent[axis] && (result[1].axis < 0 || is_before(line, exit, result[1])))
        result[1] = exit;
    }
    return result;
  }

  void add_ends(std::uint32_t segment, const Line& line) {
    const std::array<Meeting, 2> met = meetings(line);
    const std::array<Place, 2> places{{place_of(line, met[0], true), place_of(line, met[1], false)}};
    const bool is_point = compare(places[0], places[1]) == 0;
    ends_.push_back({places[0], turned(line.step, places[0].side), 2 * segment, is_point});
    if (is_point) return;
    const Pair back{{-line.step[0], -line.step[1]}};
    ends_.push_back({places[1], turned(back, places[1].side), 2 * segment + 1, false});
  }

  /// Turns a direction by as many right angles as turn a side into the lower one.
  static Pair turned(const Pair& d, int side) {
    switch (side) {
    case 1:
      return {{d[1], -d[0]}};
    case 2:
      return {{-d[0], -d[1]}};
    case 3:
      return {{-d[1], d[0]}};
    default:
      return d;
    }
  }

  /// Sorts ends around their places, and links half-edges to those that follow clockwise around their origin.
  /// The sides between places on them are half-edges behind those of the segments: of arc j, from place j to
  /// the next one, first the one with the square on its left.
  void link_ends() {
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      const int order = compare(a.place, b.place);
      if (order != 0) return order < 0;
      // Points may be without a direction.
      if (a.is_point || b.is_point) return a.is_point && (!b.is_point || a.half_edge < b.half_edge);
      if (turns_before(a.direction, b.direction)) return true;
      if (turns_before(b.direction, a.direction)) return false;
      return a.half_edge < b.half_edge;
    });
    std::uint32_t arcs = 0;
    group_.clear();
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (e > 0 && compare(ends_[e - 1].place, ends_[e].place) == 0) continue;
      group_.push_back(e);
      if (ends_[e].place.side < 4) ++arcs;
    }
    const std::size_t groups = group_.size();
    group_.push_back(ends_.size());
    clockwise_.assign(2 * segments_ + 2 * std::size_t(arcs), none_);
    origin_.assign(clockwise_.size(), none_);
    is_done_.assign(clockwise_.size(), true);
    for (std::uint32_t g = 0; g < groups; ++g) link_group(g, arcs);
    for (std::uint32_t j = 0; j < arcs; ++j) is_done_[first_arc() + 2 * j + 1] = true; // around the square
    find_isolated(groups, arcs);
  }

  std::uint32_t first_arc() const { return static_cast<std::uint32_t>(2 * segments_); }

  void link_group(std::uint32_t g, std::uint32_t arcs) {
    around_.clear();
    const bool is_on_side = g < arcs;
    if (is_on_side) around_.push_back(first_arc() + 2 * g);
    for (std::size_t e = group_[g]; e < group_[g + 1]; ++e)
      if (!ends_[e].is_point) around_.push_back(ends_[e].half_edge);
    if (is_on_side) around_.push_back(first_arc() + 2 * ((g + arcs - 1) % arcs) + 1);
    for (std::size_t i = 0; i < around_.size(); ++i) {
      const std::uint32_t h = around_[i];
      clockwise_[h] = around_[(i + around_.size() - 1) % around_.size()];
      origin_[h] = g;
      is_done_[h] = false;
    }
  }

  /// Finds out whether something is not connected to the sides, and leaves its faces out.
  void find_isolated(std::size_t groups, std::uint32_t arcs) {
    // Groups on sides are one.
    root_.resize(groups);
    for (std::uint32_t g = 0; g < groups; ++g) root_[g] = g < arcs ? 0 : g;
    for (std::uint32_t h = 0; h < first_arc(); h += 2)
      if (origin_[h] != none_) {
        const std::uint32_t a = root_of(origin_[h]), b = root_of(origin_[h + 1]);
        root_[std::max(a, b)] = std::min(a, b);
      }
    has_isolated_ = false;
    for (std::uint32_t g = 0; g < groups; ++g) has_isolated_ = has_isolated_ || is_isolated(g, arcs);
    for (std::uint32_t h = 0; h < first_arc(); ++h)
      if (origin_[h] != none_ && is_isolated(origin_[h], arcs)) is_done_[h] = true;
  }

  std::uint32_t root_of(std::uint32_t g) {
    while (root_[g] != g) g = root_[g] = root_[root_[g]];
    return g;
  }

  bool is_isolated(std::uint32_t g, std::uint32_t arcs) { return arcs == 0 || root_of(g) != 0; }

  /// Lists the segments of the face on the left of a half-edge. Returns whether there are some.
  bool collect_face(std::uint32_t h) {
    cell_.clear();
    for (; !is_done_[h]; h = clockwise_[h ^ 1u]) {
      is_done_[h] = true;
      if (h < first_arc()) cell_.push_back(h / 2);
      const std::uint32_t g = origin_[h];
      for (std::size_t e = group_[g]; e < group_[g + 1]; ++e)
        if (ends_[e].is_point) cell_.push_back(ends_[e].half_edge / 2);
    }
    std::sort(cell_.begin(), cell_.end());
    cell_.erase(std::unique(cell_.begin(), cell_.end()), cell_.end());
    return !cell_.empty();
  }

  // The square.
  Pair low_;
  Coordinate side_;

  std::size_t segments_ = 0;
  std::vector<End> ends_;
  std::vector<std::size_t> group_; ///< for each place its first end, places on sides first; and the end
  // By half-edge.
  std::vector<std::uint32_t> clockwise_, origin_;
  std::vector<bool> is_done_;
  std::vector<std::uint32_t> around_, root_;
  bool has_isolated_ = false;
  Cell cell_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_LEAF_CELLS_H
