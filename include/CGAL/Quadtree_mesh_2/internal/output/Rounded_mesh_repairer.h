// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Makes the triangles of a mesh with rounded vertices counterclockwise, and the pieces of its segments go
// ahead and keep clear of what is outside of the border (round_mesh_2.h says what for).
//
// Computes: a mesh without faults. It is a fault of a triangle to be flat or clockwise by the doubles of its
//           vertices, each side of it is one that goes back along its segment, and so is each end of a side that is
//           beyond the room outside of its segment (Outer_rooms.h). A triangle at fault is tried with, in this order:
//           1. merging a Steiner vertex of it with another vertex at the same place;
//           2. another diagonal;
//           3. other doubles for a Steiner vertex: on its segment or next to that, for which words are too coarse near
//              zero, or next to those nearest to its exact place;
//           4. merging a Steiner vertex with any neighbor.
//           A step is taken if it leaves fewer faults than were among the triangles it touches. The last kind is
//           also taken if it leaves as many, because it takes away a vertex. So this ends.
//           Sides and ends are counted, not the triangles that have them. No other diagonal mends a side, but it may
//           bring two into one triangle, of three vertices of one segment, which nothing mends. And where all
//           vertices of a segment are at fault, to move one must be a step ahead.
// Bound:    One predicate for each triangle and each piece of a segment, and up to seven more for pieces of the border,
//           if no triangle is at fault, as in nearly all meshes.
//
// Everything is decided by exact predicates on doubles. Sizes of angles only choose among steps of equal
// success.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_ROUNDED_MESH_REPAIRER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_ROUNDED_MESH_REPAIRER_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Outer_rooms.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Rounded_mesh_topology.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Segment_chains.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How well a change does among the triangles that it touches.
struct Rounding_success {
  std::size_t faults = 0; ///< as the head of this file says
  double quality = 1;     ///< a measure of the least angle among triangles without, from 0 to 1

  friend bool operator<(const Rounding_success& a, const Rounding_success& b) { // is worse
    return a.faults != b.faults ? a.faults > b.faults : a.quality < b.quality;
  }
};

template <class Point>
class Rounded_mesh_repairer {
public:
  /// \param mesh has its points at the nearest doubles
  explicit Rounded_mesh_repairer(Indexed_mesh_2<Point>& mesh)
      : mesh_(mesh), chains_(mesh), rooms_(mesh, chains_) {}

  /// Returns an invalid index, or a triangle that is at fault and has no cure.
  Triangle_index run() {
    std::vector<Triangle_index> at_fault = find_faults();
    if (at_fault.empty()) return {};
    home_ = mesh_.points;
    for (bool is_changed = true; is_changed && !at_fault.empty();) {
      is_changed = false;
      found_.clear();
      for (const Triangle_index t : at_fault) {
        if (!is_left(t)) continue;
        while (is_left(t) && cure(t)) is_changed = true;
        if (is_left(t)) found_.push_back(t);
      }
      std::sort(found_.begin(), found_.end());
      found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
      at_fault.clear();
      for (const Triangle_index t : found_)
        if (is_left(t)) at_fault.push_back(t);
    }
    return at_fault.empty() ? Triangle_index() : at_fault.front();
  }

  /// Takes out what was merged. Returns the new index of each triangle, invalid for those that are no more.
  std::vector<Triangle_index> compress() {
    if (topology_) return topology_->compress();
    std::vector<Triangle_index> same(mesh_.triangles.size());
    for (std::size_t t = 0; t < same.size(); ++t) same[t] = Triangle_index(t);
    return same;
  }

  /// To be asked before `compress()`.
  std::size_t number_of_moved() const {
    std::size_t n = 0;
    for (std::size_t v = 0; v < home_.size(); ++v)
      n += topology_->is_used(Vertex_index(v)) && mesh_.points[v] != home_[v] ? 1 : 0;
    return n;
  }
  std::size_t number_of_merged() const { return merged_; }
  std::size_t number_of_flipped() const { return flipped_; }

private:
  using Topology = Rounded_mesh_topology<Point>;
  using Bordered_triangle = typename Topology::Bordered_triangle;
  using Bordered_star = std::vector<Bordered_triangle>;
  using Corners = std::array<Vertex_index, 3>;
  using Predicates = Exact_predicates_inexact_constructions_kernel;
  static constexpr int reach_of_free_vertices = 3; // in units of the last place
  static constexpr int reach_on_segments = 1;

  Indexed_mesh_2<Point>& mesh_;
  Segment_chains<Point> chains_;
  Outer_rooms<Point> rooms_;
  std::optional<Topology> topology_;
  std::vector<Point> home_; // the nearest doubles of all vertices
  std::vector<Triangle_index> found_;
  std::size_t merged_ = 0, flipped_ = 0;

  static bool is_counterclockwise(const Point& a, const Point& b, const Point& c) {
    using P = Predicates::Point_2;
    return Predicates::Orientation_2()(P(a.x(), a.y()), P(b.x(), b.y()), P(c.x(), c.y())) == LEFT_TURN;
  }
  bool is_counterclockwise(const Corners& r) const {
    return is_counterclockwise(mesh_.point(r[0]), mesh_.point(r[1]), mesh_.point(r[2]));
  }
  std::size_t faults_of_piece(std::size_t piece) const {
    return (chains_.goes_ahead(piece) ? 0 : 1) + rooms_.number_of_vertices_beyond(piece);
  }
  std::size_t number_of_faults(const Bordered_triangle& r) const {
    std::size_t faults = is_counterclockwise(r.corners) ? 0 : 1;
    for (const std::size_t piece : r.pieces)
      if (piece != Topology::no_piece) faults += faults_of_piece(piece);
    return faults;
  }
  bool is_left(Triangle_index t) const {
    return topology_->is_alive(t) && number_of_faults(topology_->bordered(mesh_.triangles[t.value()])) > 0;
  }
  bool is_steiner(Vertex_index v) const { return v.value() >= mesh_.number_of_input_vertices; }

  /// All triangles at fault. The tables of the topology are made if there is one.
  std::vector<Triangle_index> find_faults() {
    std::vector<Triangle_index> at_fault;
    std::vector<std::size_t> out_of_place;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (!is_counterclockwise(mesh_.triangles[t])) at_fault.push_back(Triangle_index(t));
    for (std::size_t e = 0; e < mesh_.constrained_edges.size(); ++e)
      if (faults_of_piece(e) > 0) out_of_place.push_back(e);
    if (at_fault.empty() && out_of_place.empty()) return at_fault;
    topology_.emplace(mesh_, chains_);
    for (const std::size_t e : out_of_place)
      for (const Triangle_index t : topology_->triangles_at(e)) at_fault.push_back(t);
    std::sort(at_fault.begin(), at_fault.end());
    at_fault.erase(std::unique(at_fault.begin(), at_fault.end()), at_fault.end());
    return at_fault;
  }

  /// Twice the area over the square of the longest side, whatever the scale.
  static double quality(const Point& a, const Point& b, const Point& c) {
    double ux = b.x() - a.x(), uy = b.y() - a.y(), vx = c.x() - a.x(), vy = c.y() - a.y();
    const double largest = std::max({std::fabs(ux), std::fabs(uy), std::fabs(vx), std::fabs(vy)});
    if (!(largest > 0) || !std::isfinite(largest)) return 0;
    const int exponent = -std::ilogb(largest);
    for (double* d : {&ux, &uy, &vx, &vy}) *d = std::ldexp(*d, exponent);
    const double wx = vx - ux, wy = vy - uy;
    return std::fabs(ux * vy - uy * vx) / std::max({ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy});
  }

  void add(Rounding_success& sum, const Bordered_triangle& r) const {
    const std::size_t faults = number_of_faults(r);
    sum.faults += faults;
    if (faults > 0) return;
    const auto& [a, b, c] = r.corners;
    sum.quality = std::min(sum.quality, quality(mesh_.point(a), mesh_.point(b), mesh_.point(c)));
  }

  Rounding_success success_of(const Bordered_star& star) const {
    Rounding_success sum;
    for (const Bordered_triangle& r : star) add(sum, r);
    return sum;
  }

  /// Whether there is a step for t that leaves fewer faults; it is taken.
  bool cure(Triangle_index t) { return merge_at_one_place(t) || flip(t) || move_a_vertex(t) || merge(t); }

  void note(const std::vector<Triangle_index>& changed) {
    for (const Triangle_index t : changed)
      if (is_left(t)) found_.push_back(t);
  }

  bool merge_at_one_place(Triangle_index t) {
    const Corners r = mesh_.triangles[t.value()];
    for (const Vertex_index v : r)
      for (const Vertex_index w : r) {
        if (v == w || !(mesh_.point(v) == mesh_.point(w)) || !is_steiner(v)) continue;
        const std::vector<Triangle_index> star = topology_->star(v);
        if (!topology_->may_merge(v, w, star)) continue;
        merge(v, w, star);
        return true;
      }
    return false;
  }

  void merge(Vertex_index v, Vertex_index w, const std::vector<Triangle_index>& star) {
    topology_->merge(v, w, star);
    ++merged_;
    note(star);
  }

  bool flip(Triangle_index t) {
    for (int k = 0; k < 3; ++k) {
      if (!topology_->may_flip(t, k)) continue;
      const Triangle_index u = mesh_.neighbors[t.value()][std::size_t(k)];
      Rounding_success after;
      for (const Corners& r : topology_->flipped(t, k)) add(after, topology_->bordered(r));
      if (after.faults >= success_of(topology_->bordered({t, u})).faults) continue;
      topology_->flip(t, k);
      ++flipped_;
      note({t, u});
      return true;
    }
    return false;
  }

  /// Tries doubles around the nearest ones, near ones first; among those equally near takes the best.
  bool move_a_vertex(Triangle_index t) {
    const Corners r = mesh_.triangles[t.value()];
    for (const Vertex_index v : r)
      if (is_steiner(v) && move_vertex(v)) return true;
    return false;
  }

  bool move_vertex(Vertex_index v) {
    const std::vector<Triangle_index> star = topology_->star(v);
    const Bordered_star triangles = topology_->bordered(star);
    const Point before = mesh_.point(v);
    const std::size_t faults_before = success_of(triangles).faults;
    const int reach = topology_->is_free(v) ? reach_of_free_vertices : reach_on_segments;
    const Point& home = home_[v.value()];
    const std::optional<std::size_t> piece = topology_->piece_at(v, star);
    Point best = before;
    Rounding_success best_success{faults_before, 2};
    const auto try_place = [&](const Point& p) {
      mesh_.points[v.value()] = p;
      const Rounding_success success = success_of(triangles);
      if (success.faults < faults_before && best_success < success) best_success = success, best = p;
    };
    const auto try_around = [&](const Point& center) {
      const Steps steps = steps_of(center, piece);
      for (int ring = 0; ring <= reach && best_success.faults > 0; ++ring)
        for_each_place_around(center, steps, ring, try_place);
    };
    if (piece) try_around(chains_.place_beside(*piece, home));
    try_around(home);
    mesh_.points[v.value()] = best;
    if (best_success.faults == faults_before) return false;
    note(star);
    return true;
  }

  /// How far apart the places are that are tried for a vertex, along each axis.
  struct Steps {
    std::array<double, 2> own, larger;
  };

  /// Its own units in the last place, and larger ones. A vertex on a segment takes those of the segment, so that it
  /// stays on the segment up to rounding; others take the unit of their larger coordinate.
  Steps steps_of(const Point& p, const std::optional<std::size_t>& piece) const {
    const std::array<double, 2> own{unit_in_last_place_of(p.x()), unit_in_last_place_of(p.y())};
    const double larger = std::max(own[0], own[1]);
    return {own, piece ? chains_.units(*piece) : std::array<double, 2>{larger, larger}};
  }

  /// Places so many steps away.
  template <class Function>
  static void for_each_place_around(const Point& p, const Steps& steps, int ring, const Function& f) {
    for (int i = -ring; i <= ring; ++i)
      for (int j = -ring; j <= ring; ++j) {
        if (std::max(std::abs(i), std::abs(j)) != ring) continue;
        f(Point(p.x() + i * steps.own[0], p.y() + j * steps.own[1]));
        if (steps.own != steps.larger) f(Point(p.x() + i * steps.larger[0], p.y() + j * steps.larger[1]));
      }
  }

  /// Merges a Steiner vertex of t with that neighbor with which it is best, even if there are as many faults afterward:
  /// there are fewer vertices then.
  bool merge(Triangle_index t) {
    const Corners r = mesh_.triangles[t.value()];
    Rounding_success best_success{std::numeric_limits<std::size_t>::max(), 0};
    Vertex_index best_v, best_w;
    for (const Vertex_index v : r) {
      if (!is_steiner(v)) continue;
      const std::vector<Triangle_index> star = topology_->star(v);
      const Bordered_star triangles = topology_->bordered(star);
      const std::size_t faults_before = success_of(triangles).faults;
      for (const Vertex_index w : topology_->neighbors_in(star, v)) {
        if (!topology_->may_merge(v, w, star)) continue;
        const Rounding_success success = success_of_merging(v, w, triangles);
        if (success.faults <= faults_before && best_success < success)
          best_success = success, best_v = v, best_w = w;
      }
    }
    if (!best_v.is_valid()) return false;
    merge(best_v, best_w, topology_->star(best_v));
    return true;
  }

  /// Merged vertices have no triangles in common any more, and the others are as if v were at the place of w.
  Rounding_success success_of_merging(Vertex_index v, Vertex_index w, const Bordered_star& star) {
    const Point before = mesh_.point(v);
    mesh_.points[v.value()] = mesh_.point(w);
    Rounding_success sum;
    for (const Bordered_triangle& r : star)
      if (std::find(r.corners.begin(), r.corners.end(), w) == r.corners.end()) add(sum, r);
    mesh_.points[v.value()] = before;
    return sum;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_ROUNDED_MESH_REPAIRER_H
