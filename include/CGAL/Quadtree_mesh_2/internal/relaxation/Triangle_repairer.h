// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Repairs triangles that relaxation alone leaves outside the range of angles. It relaxes a patch around the
// triangle, with a new vertex at the middle of one of its sides or at its centroid, or without one of the
// vertices near it. It keeps the first change after which the whole patch is in the range. If there is none,
// it keeps the one that lowers the energy most, if that is by a third. A bounded number of relaxations for
// each triangle.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_TRIANGLE_REPAIRER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_TRIANGLE_REPAIRER_H

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Vertex_remover.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Triangle_repairer {
public:
  using Triangle = std::array<Ring_vertex, 3>;

  /// `spare` are vertices of the patch's block that are not in use; those that get used are taken from its end.
  Triangle_repairer(Ring_patch<Geometry>& patch, Star_relaxer<Geometry>& relaxer,
                    Vertex_remover<Geometry>& remover, std::vector<Ring_vertex>& spare)
      : patch_(patch), relaxer_(relaxer), remover_(remover), spare_(spare) {}

  /// The triangles at the given vertices that are not in the range and have one of these as their least vertex.
  template <class Vertices>
  std::vector<Triangle> violated(const Vertices& vertices) const {
    std::vector<Triangle> result;
    for (const Ring_vertex v : vertices) {
      const Ring& r = patch_.mesh().ring(v);
      if (r.mobility == Mobility::REMOVED || relaxer_.is_in_range(v)) continue;
      patch_.mesh().for_each_triangle_of(v, [&](Ring_vertex a, Ring_vertex b, Ring_vertex c) {
        if (!is_in_range({a, b, c}) && !is_rigid({a, b, c})) result.push_back({a, b, c});
      });
    }
    return result;
  }

  /// Repairs what is violated at the given vertices and the new ones, which are appended. Returns what is left.
  std::vector<Triangle> repair_all(std::vector<Ring_vertex>& vertices) {
    constexpr int most_rounds = 12;
    std::vector<Triangle> bad = violated(vertices);
    for (int round = 0, escalation = 0; round < most_rounds && !bad.empty(); ++round) {
      bool is_any_repaired = false;
      for (const Triangle& t : bad) {
        if (!exists(t) || is_in_range(t)) continue;
        is_any_repaired |= repair(t, std::min(4, 2 + escalation), 8 + 4 * escalation, vertices);
      }
      bad = violated(vertices);
      if (is_any_repaired && round % 3 != 2) continue;
      if (!is_any_repaired && escalation == 2) break;
      escalation = std::min(escalation + 1, 2);
    }
    return bad;
  }

private:
  enum class Kind { RELAX, FLIP_SIDE, SPLIT_SIDE, SPLIT_TRIANGLE, SPLIT_ALL_SIDES, REMOVE };
  struct Change {
    Kind kind;
    Ring_vertex vertex; ///< to be removed; or the one opposite the side
  };
  static constexpr double least_gain = 0.7;

  Ring_patch<Geometry>& patch_;
  Star_relaxer<Geometry>& relaxer_;
  Vertex_remover<Geometry>& remover_;
  std::vector<Ring_vertex>& spare_;
  std::size_t number_of_new_ = 0; ///< by the last change

  bool exists(const Triangle& t) const {
    const Ring& r = patch_.mesh().ring(t[0]);
    if (r.mobility == Mobility::REMOVED) return false;
    for (int k = 0; k < r.number_of_triangles(); ++k)
      if (r[k] == t[1] && r.next(k) == t[2]) return true;
    return false;
  }

  bool is_in_range(const Triangle& t) const {
    const auto& mesh = patch_.mesh();
    const Vector b = Geometry::difference(mesh.point(t[1]), mesh.point(t[0])),
                 c = Geometry::difference(mesh.point(t[2]), mesh.point(t[0]));
    const double scale = 1 / std::max({std::fabs(b.x), std::fabs(b.y), 1e-300});
    const auto lanes = [scale](double x) { return Float_lanes(static_cast<float>(scale * x)); };
    const Triangle_lanes triangle(lanes(b.x), lanes(b.y), lanes(c.x), lanes(c.y));
    return Range_lanes(triangle, relaxer_.range()).slack(triangle, relaxer_.range())[0] >= 0;
  }

  bool is_rigid(const Triangle& t) const {
    return std::all_of(t.begin(), t.end(),
                       [this](Ring_vertex v) { return patch_.mesh().ring(v).mobility == Mobility::RIGID; });
  }

  /// Returns whether something became better.
  bool repair(const Triangle& t, int rings, int stages, std::vector<Ring_vertex>& vertices) {
    const double energy_before = energy_of_patch(t, rings);
    double least = least_gain * energy_before;
    const Change* best = nullptr;
    const std::vector<Change> changes = possible_changes(t);
    for (const Change& change : changes) {
      const Outcome outcome = apply(change, t, rings, stages);
      if (outcome.is_valid) return keep(vertices), true;
      if (outcome.energy < least) least = outcome.energy, best = &change;
      patch_.undo();
    }
    if (best == nullptr) return false;
    apply(*best, t, rings, stages);
    keep(vertices);
    return true;
  }

  void keep(std::vector<Ring_vertex>& vertices) {
    for (const Ring_vertex v : patch_.members()) patch_.mesh().ring(v).tried_rings = 0;
    for (; number_of_new_ > 0; --number_of_new_) {
      vertices.push_back(spare_.back());
      spare_.pop_back();
    }
  }

  std::vector<Change> possible_changes(const Triangle& t) {
    std::vector<Change> changes{{Kind::RELAX, {}}};
    const auto& mesh = patch_.mesh();
    const auto length_opposite = [&](std::size_t i) {
      return squared_length(Geometry::difference(mesh.point(t[(i + 1) % 3]), mesh.point(t[(i + 2) % 3])));
    };
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (length_opposite(i) > length_opposite(longest)) longest = i;
    for (std::size_t i = 0; i < 3; ++i) changes.push_back({Kind::FLIP_SIDE, t[(longest + i) % 3]});
    for (std::size_t i = 0; i < 3; ++i) changes.push_back({Kind::SPLIT_SIDE, t[(longest + i) % 3]});
    changes.push_back({Kind::SPLIT_TRIANGLE, {}});
    changes.push_back({Kind::SPLIT_ALL_SIDES, {}});
    patch_.begin();
    for (const Ring_vertex v : t) patch_.add(v);
    patch_.grow(1);
    for (const Ring_vertex v : patch_.members())
      if (is_movable(mesh.ring(v).mobility)) changes.push_back({Kind::REMOVE, v});
    return changes;
  }

  struct Outcome {
    bool is_valid;
    double energy;
  };

  Outcome apply(const Change& change, const Triangle& t, int rings, int stages) {
    number_of_new_ = 0;
    begin_patch(t, rings, change.kind == Kind::REMOVE ? change.vertex : Ring_vertex());
    switch (change.kind) {
    case Kind::RELAX:
      break;
    case Kind::FLIP_SIDE:
      if (!flip_side_opposite(t, change.vertex)) return {false, 1e300};
      break;
    case Kind::SPLIT_SIDE:
      if (!split_side_opposite(t, change.vertex)) return {false, 1e300};
      break;
    case Kind::SPLIT_ALL_SIDES:
      if (!split_all_sides(t)) return {false, 1e300};
      break;
    case Kind::SPLIT_TRIANGLE:
      if (!split_triangle(t)) return {false, 1e300};
      break;
    case Kind::REMOVE:
      if (!remover_.take_out(change.vertex)) return {false, 1e300};
      break;
    }
    for (const Ring_vertex v : patch_.members()) patch_.activate(v);
    if (relaxer_.relax(stages, Patience::MUCH)) return {true, 0};
    return {false, energy_of_members()};
  }

  /// Begins an operation on the vertices at most `rings` rings away from t, without one of them.
  void begin_patch(const Triangle& t, int rings, Ring_vertex without) {
    patch_.begin();
    for (const Ring_vertex v : t) patch_.add(v);
    patch_.grow(rings);
    if (without.is_valid()) patch_.drop(without);
  }

  double energy_of_patch(const Triangle& t, int rings) {
    begin_patch(t, rings, {});
    return energy_of_members();
  }

  /// Of the triangles with a member, each once.
  double energy_of_members() const {
    double sum = 0;
    for (const Ring_vertex v : patch_.members()) {
      const Ring& r = patch_.mesh().ring(v);
      const Star_vectors star(patch_.mesh(), v);
      for (int first = 0; first < star.number_of_triangles; first += Float_lanes::size) {
        const Float_lanes e =
            star.demanded(first, Range_lanes(star.triangles(first, 0, 0), relaxer_.range()).energy);
        for (int k = first; k < std::min(star.number_of_triangles, first + Float_lanes::size); ++k)
          if (is_first_member(v, r[k]) && is_first_member(v, r.next(k)))
            sum += static_cast<double>(e[k - first]);
      }
    }
    return sum;
  }
  bool is_first_member(Ring_vertex v, Ring_vertex other) const {
    return v < other || !patch_.is_member(other);
  }

  bool can_take_one_more(Ring_vertex v) const {
    return patch_.is_ours(v) && patch_.mesh().ring(v).size < Ring::max_size;
  }

  bool is_sliding(Ring_vertex v) const {
    const Mobility m = patch_.mesh().ring(v).mobility;
    return m == Mobility::SLIDES_ALONG || m == Mobility::SLIDES_ACROSS;
  }

  static std::size_t slot_of(const Triangle& t, Ring_vertex v) {
    return static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin());
  }
  bool flip_side_opposite(const Triangle& t, Ring_vertex v) {
    const std::size_t i = slot_of(t, v);
    return relaxer_.flip_anyway(t[(i + 1) % 3], t[(i + 2) % 3], v);
  }
  bool split_side_opposite(const Triangle& t, Ring_vertex v) {
    const std::size_t i = slot_of(t, v);
    return split_edge(t[(i + 1) % 3], t[(i + 2) % 3]);
  }
  bool split_all_sides(const Triangle& t) {
    bool is_split = false;
    for (std::size_t i = 0; i < 3; ++i) is_split |= split_edge(t[i], t[(i + 1) % 3]);
    return is_split;
  }

  /// The vertex that the next insertion takes, if there is one left.
  Ring_vertex next_spare() const {
    return number_of_new_ < spare_.size() ? spare_[spare_.size() - 1 - number_of_new_] : Ring_vertex();
  }

  /// If there is still such an edge. \pre a is not removed
  bool split_edge(Ring_vertex a, Ring_vertex b) {
    auto& mesh = patch_.mesh();
    const Ring_vertex m = next_spare();
    if (!m.is_valid() || !patch_.is_ours(a) || !patch_.is_ours(b) || !mesh.ring(a).contains(b)) return false;
    if (mesh.ring(a).mobility == Mobility::RIGID && mesh.ring(b).mobility == Mobility::RIGID) return false;
    const int k = mesh.ring(a).position_of(b);
    if (k == mesh.ring(a).number_of_triangles()) return false; // nothing on its left
    const Ring_vertex left = mesh.ring(a).next(k), right = mesh.right_of(a, k);
    if (!can_take_one_more(left) || (right.is_valid() && !can_take_one_more(right))) return false;
    if (!right.is_valid() && !is_sliding(a) && !is_sliding(b)) return false; // a side from corner to corner
    const Mobility mobility = right.is_valid() ? Mobility::FREE
                              : is_sliding(a)  ? mesh.ring(a).mobility
                                               : mesh.ring(b).mobility;
    patch_.split_edge(m, Geometry::between(mesh.point(a), mesh.point(b), 0.5), a, b, left, right);
    mesh.ring(m).mobility = mobility;
    ++number_of_new_;
    relaxer_.flip_to_Delaunay(m);
    return true;
  }

  bool split_triangle(const Triangle& t) {
    const Ring_vertex m = next_spare();
    if (!m.is_valid() ||
        !std::all_of(t.begin(), t.end(), [this](Ring_vertex v) { return can_take_one_more(v); }))
      return false;
    const auto& mesh = patch_.mesh();
    const auto& origin = mesh.point(t[0]);
    const Vector sum =
        Geometry::difference(mesh.point(t[1]), origin) + Geometry::difference(mesh.point(t[2]), origin);
    patch_.split_triangle(m, Geometry::translate(origin, (1.0 / 3) * sum), t[0], t[1], t[2]);
    ++number_of_new_;
    relaxer_.flip_to_Delaunay(m);
    return true;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_TRIANGLE_REPAIRER_H
