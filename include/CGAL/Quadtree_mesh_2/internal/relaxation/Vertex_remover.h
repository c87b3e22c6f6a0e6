// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Removes vertices under guard. The hole is triangulated with the least sum of energies, by dynamic
// programming over its ring. Triangles that are then outside the range of angles are relaxed in a patch of a
// few rings. A removal that does not succeed is undone to the last bit. O(degree^3) time and a bounded number
// of relaxation steps for each.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_VERTEX_REMOVER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_VERTEX_REMOVER_H

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Star_relaxer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The triangulation of a ring's polygon with the least energy. Its vertices are the members of the ring.
class Ring_triangulation {
public:
  static constexpr int max_size = 11;
  static constexpr float energy_of_impossible = 1e5f;
  using Diagonal = std::pair<int, int>;

  /// \pre the star's ring has at most `max_size` members
  Ring_triangulation(const Star_vectors& star, int size, const Angle_range& range) : size_(size) {
    for (int i = 0; i + 1 < size; ++i) least_[i][i + 1] = 0;
    for (int length = 2; length < size; ++length)
      for (int i = 0; i + length < size; ++i) find_apex(star, i, i + length, range);
    if (is_possible()) collect(0, size - 1);
  }

  /// Whether there is one without triangles turned over.
  bool is_possible() const { return energy() < energy_of_impossible; }
  /// With those of its edges that are sides of the ring's polygon in closed rings left out; in open rings the last
  /// side is an edge that the ring has not.
  const std::vector<Diagonal>& diagonals() const { return diagonals_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
  float energy() const { return least_[0][size_ - 1]; }

private:
  int size_;
  float least_[max_size][max_size];
  int apex_[max_size][max_size];
  std::vector<Diagonal> diagonals_;
  std::vector<std::array<int, 3>> triangles_;

  void find_apex(const Star_vectors& star, int i, int j, const Angle_range& range) {
    least_[i][j] = 1e30f;
    const float jx = star.x[j] - star.x[i], jy = star.y[j] - star.y[i];
    for (int first = i + 1; first < j; first += Float_lanes::size) {
      const Float_lanes kx = Float_lanes::load(star.x + first) - Float_lanes(star.x[i]),
                        ky = Float_lanes::load(star.y + first) - Float_lanes(star.y[i]);
      const Float_lanes energy = Range_lanes(Triangle_lanes(kx, ky, jx, jy), range).energy;
      for (int k = first; k < std::min(j, first + Float_lanes::size); ++k) {
        const float own = energy[k - first];
        const float e =
            least_[i][k] + least_[k][j] + (own >= 0.9f * Angle_range::energy_of_flat ? 1e6f : own);
        if (!(e < least_[i][j])) continue;
        least_[i][j] = e;
        apex_[i][j] = k;
      }
    }
  }

  void collect(int i, int j) {
    if (j - i < 2) return;
    const int k = apex_[i][j];
    triangles_.push_back({i, k, j});
    if (k - i > 1) diagonals_.push_back({i, k});
    if (j - k > 1) diagonals_.push_back({k, j});
    collect(i, k);
    collect(k, j);
  }
};

template <class Geometry>
class Vertex_remover {
public:
  Vertex_remover(Ring_patch<Geometry>& patch, Star_relaxer<Geometry>& relaxer)
      : patch_(patch), relaxer_(relaxer) {}

  /// Takes v out of the mesh, if the triangles that fill the hole have less than the given energy. Returns whether that
  /// could be done; nothing is undone. To be called within an operation of the patch.
  bool take_out(Ring_vertex v, float energy_bound = Ring_triangulation::energy_of_impossible) {
    const auto& mesh = patch_.mesh();
    const Ring& ring = mesh.ring(v);
    if (!is_movable(ring.mobility) || ring.size < 3 || ring.size > Ring_triangulation::max_size) return false;
    for (int k = 0; k < ring.size; ++k)
      if (!patch_.is_ours(ring[k])) return patch_.add(ring[k]), false; // remembers that the patch is cut
    const Star_vectors star(mesh, v);
    const Ring_triangulation filling(star, ring.size, relaxer_.range());
    if (!(filling.energy() < energy_bound) || has_rigid(ring, filling)) return false;
    std::vector<Ring_triangulation::Diagonal> edges = filling.diagonals();
    if (ring.is_open) edges.push_back({0, ring.size - 1});
    if (!have_room(ring, edges)) return false;
    for (int k = 0; k < ring.size; ++k) patch_.add(ring[k]);
    patch_.remove(v, edges);
    return true;
  }

  /// Removes v if the range of angles can be kept by relaxing what is at most `rings` rings away.
  bool remove(Ring_vertex v, int rings, int stages) {
    patch_.begin();
    if (take_out(v, greatest_hopeful_energy)) {
      patch_.grow(rings - 1);
      if (relaxer_.relax(stages, Patience::LITTLE)) {
        for (const Ring_vertex u : patch_.members()) patch_.mesh().ring(u).tried_rings = 0;
        return true;
      }
      patch_.undo();
    }
    if (!patch_.is_cut()) patch_.mesh().ring(v).tried_rings = static_cast<std::uint8_t>(rings);
    return false;
  }

private:
  /// Of the triangles that fill a hole. With more, relaxation has succeeded in one of 50 cases, and in fewer of those
  /// that have much more; skipping them, it finds better places to spend its time.
  static constexpr float greatest_hopeful_energy = 1.2f;

  Ring_patch<Geometry>& patch_;
  Star_relaxer<Geometry>& relaxer_;

  /// Whether there would be a new triangle of rigid vertices only, of which nothing would be asked.
  bool has_rigid(const Ring& ring, const Ring_triangulation& filling) const {
    const auto is_rigid = [&](int k) { return patch_.mesh().ring(ring[k]).mobility == Mobility::RIGID; };
    return std::any_of(filling.triangles().begin(), filling.triangles().end(),
                       [&](const auto& t) { return is_rigid(t[0]) && is_rigid(t[1]) && is_rigid(t[2]); });
  }

  /// Whether the members of the ring can take the new neighbors in; also those that lose one.
  bool have_room(const Ring& ring, const std::vector<Ring_triangulation::Diagonal>& edges) const {
    for (int i = 0; i < ring.size; ++i) {
      const Ring& r = patch_.mesh().ring(ring[i]);
      const auto gained = std::count_if(edges.begin(), edges.end(),
                                        [i](const auto& e) { return e.first == i || e.second == i; });
      const auto size = r.size - 1 + gained;
      if (size > Ring::max_size || size < (r.is_open ? 2 : 3)) return false;
      for (const auto& [a, b] : edges)
        if ((a == i && r.contains(ring[b])) || (b == i && r.contains(ring[a]))) return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_VERTEX_REMOVER_H
