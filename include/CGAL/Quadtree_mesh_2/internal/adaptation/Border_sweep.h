// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What the border of given triangles meets.
//
// Computes: an edge of the border where triangles overlap; or else the vertices of the border that are at one place,
//           and those in the middle of its edges.
// Bound:    O(b log b) time for b edges on the border. Without an overlap, at most two edges have a place inside.
// Source:   Shamos and Hoey (1976). A line sweeps over the plane from left to right, and knows the edges that it meets,
//           from below to above. Before two edges cross they are next to each other. An edge with a vertex inside is
//           cut there. So edges on one line that overlap become equal pieces, which are one for the line.
//           The number of triangles above a place changes only across the border. The line knows it above each edge,
//           and triangles overlap where it is 2. All of this is decided exactly.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_BORDER_SWEEP_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_BORDER_SWEEP_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A side of a triangle that is no side of another one: it faces the k-th vertex, and has the triangle on its left.
struct Border_side {
  std::size_t triangle, k;
  Vertex_index from, to;
};

/// Where the border of triangles touches itself.
struct Border_touches {
  /// Two vertices at one place.
  struct Twin {
    Vertex_index vertex, kept; ///< the first one there is kept
  };
  /// A vertex in the middle of a side, the first one at its place.
  struct Hanging_vertex {
    Border_side side;
    Vertex_index vertex;
  };

  std::vector<Twin> twins; ///< by places, then by their numbers
  std::vector<Hanging_vertex>
      hanging; ///< by their places: those of one side in a row along it, in either direction

  bool are_none() const { return twins.empty() && hanging.empty(); }
};

class Border_sweep {
public:
  using Point = Triangle_tree::Point;

  Border_sweep(const std::vector<Point>& points, std::vector<Border_side> sides)
      : points_(points), sides_(std::move(sides)), status_(Is_below{this}) {
    find_places();
    find_edges();
    for (std::size_t p = 0; p < places_.size() && !overlap_; ++p) pass(Place{p});
  }

  /// A side of a triangle that another one overlaps at the side; nothing if triangles do not overlap.
  const std::optional<Border_side>& overlap() const { return overlap_; }
  /// \pre there is no overlap
  const Border_touches& touches() const { return touches_; }

private:
  /// A number in the order of places from left to right, and from below to above where they have one x.
  struct Place {
    std::size_t rank;
    friend bool operator==(Place a, Place b) { return a.rank == b.rank; }
    friend bool operator!=(Place a, Place b) { return a.rank != b.rank; }
    friend bool operator<(Place a, Place b) { return a.rank < b.rank; }
  };
  /// What the line has not passed of a side.
  struct Edge {
    Place left, right;
    int step;         ///< by which the number of triangles grows across it, upwards: 1 or -1
    std::size_t side; ///< its index
  };
  /// Edges that begin at one place and go the same way, to the nearest of their ends.
  struct Bundle {
    Place left, right;
    std::vector<std::size_t> edges;
    int above; ///< the number of triangles there
  };
  struct Is_below {
    using is_transparent = void;
    const Border_sweep* sweep;

    bool operator()(const Bundle& a, Place p) const { return sweep->turn(a.left, a.right, p) == LEFT_TURN; }
    bool operator()(Place p, const Bundle& a) const { return sweep->turn(a.left, a.right, p) == RIGHT_TURN; }
    bool operator()(const Bundle& a, const Bundle& b) const {
      if (a.left == b.left) return (*this)(a, b.right);
      return a.left < b.left ? (*this)(a, b.left) : (*this)(a.left, b);
    }
  };
  using Status = std::set<Bundle, Is_below>;

  const std::vector<Point>& points_;
  std::vector<Border_side> sides_;
  std::vector<Vertex_index> places_; // the first vertex at each
  std::vector<Edge> edges_;          // by their left ends
  std::size_t next_ = 0;             // the first edge that the line has not reached
  Status status_;
  std::vector<std::size_t> starting_; // edges at the place where the line is
  Border_touches touches_;
  std::optional<Border_side> overlap_;

  const Point& point(Place p) const { return points_[std::size_t(places_[p.rank])]; }
  Orientation turn(Place p, Place q, Place r) const {
    if (p == r || q == r) return COLLINEAR; // which would take exact numbers to find
    return Triangle_tree::Kernel().orientation_2_object()(point(p), point(q), point(r));
  }
  static bool is_before(const Point& p, const Point& q) {
    return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
  }

  void find_places() {
    std::vector<Vertex_index> vertices;
    vertices.reserve(sides_.size());
    for (const Border_side& s : sides_) vertices.push_back(s.from), vertices.push_back(s.to);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::stable_sort(vertices.begin(), vertices.end(), [this](Vertex_index v, Vertex_index w) {
      return is_before(points_[std::size_t(v)], points_[std::size_t(w)]);
    });
    for (const Vertex_index v : vertices)
      if (places_.empty() || is_before(points_[std::size_t(places_.back())], points_[std::size_t(v)]))
        places_.push_back(v);
      else
        touches_.twins.push_back({v, places_.back()});
  }

  Place place_of(Vertex_index v) const {
    const auto found =
        std::lower_bound(places_.begin(), places_.end(), v, [this](Vertex_index p, Vertex_index w) {
          return is_before(points_[std::size_t(p)], points_[std::size_t(w)]);
        });
    return {std::size_t(found - places_.begin())};
  }

  void find_edges() {
    edges_.reserve(sides_.size());
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      const Place from = place_of(sides_[s].from), to = place_of(sides_[s].to);
      edges_.push_back(from < to ? Edge{from, to, 1, s} : Edge{to, from, -1, s});
    }
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const Edge& a, const Edge& b) { return a.left < b.left; });
  }

  /// Ends what ends at the place, cuts what passes through it, and begins what begins there.
  void pass(Place p) {
    starting_.clear();
    const auto [first, last] = status_.equal_range(p);
    for (auto bundle = first; bundle != last; ++bundle)
      for (const std::size_t e : bundle->edges)
        if (edges_[e].right != p) cut(e, p);
    const auto above = status_.erase(first, last);
    for (; next_ < edges_.size() && edges_[next_].left == p; ++next_) starting_.push_back(next_);
    std::sort(starting_.begin(), starting_.end(), [&](std::size_t e, std::size_t f) {
      const Orientation from_e_to_f = turn(p, edges_[e].right, edges_[f].right);
      return from_e_to_f == COLLINEAR ? e < f : from_e_to_f == LEFT_TURN;
    });
    const bool has_below = above != status_.begin();
    const auto below = has_below ? std::prev(above) : above;
    int triangles = has_below ? below->above : 0;
    for (std::size_t begin = 0, end = 0; begin < starting_.size(); begin = end) {
      end = end_of_bundle(p, begin);
      triangles = add_bundle(p, begin, end, triangles, above);
    }
    if (has_below) check_crossing(below, std::next(below));
    if (!starting_.empty()) check_crossing(std::prev(above), above);
  }

  void cut(std::size_t e, Place p) {
    touches_.hanging.push_back({sides_[edges_[e].side], places_[p.rank]});
    edges_[e].left = p;
    starting_.push_back(e);
  }

  /// Behind the last edge that goes the same way as that at `begin`.
  std::size_t end_of_bundle(Place p, std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < starting_.size() &&
           turn(p, edges_[starting_[begin]].right, edges_[starting_[end]].right) == COLLINEAR)
      ++end;
    return end;
  }

  /// \returns the number of triangles above it
  int add_bundle(Place p, std::size_t begin, std::size_t end, int triangles_below, Status::iterator above) {
    Bundle bundle{p, edges_[starting_[begin]].right, {}, triangles_below};
    for (std::size_t i = begin; i < end; ++i) {
      const Edge& e = edges_[starting_[i]];
      bundle.edges.push_back(starting_[i]);
      bundle.right = std::min(bundle.right, e.right);
      bundle.above += e.step;
    }
    if (bundle.above > 1)
      for (const std::size_t e : bundle.edges)
        if (edges_[e].step > 0) overlap_ = sides_[edges_[e].side];
    return status_.insert(above, std::move(bundle))->above;
  }

  /// Notes an overlap if bundles next to each other cross inside of both.
  void check_crossing(Status::iterator a, Status::iterator b) {
    if (b == status_.end()) return;
    const auto are_apart = [this](const Bundle& edge, const Bundle& ends) {
      const Orientation of_left = turn(edge.left, edge.right, ends.left);
      return of_left == COLLINEAR || of_left != opposite(turn(edge.left, edge.right, ends.right));
    };
    if (!are_apart(*a, *b) && !are_apart(*b, *a)) overlap_ = sides_[edges_[a->edges.front()].side];
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_BORDER_SWEEP_H
