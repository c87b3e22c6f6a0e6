// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The work on one block of a mesh of points. Vertices move to their sites, and the mesh around them is
// relaxed and repaired. Later, vertices that are not needed are removed.
//
// Removal visits the vertices from the shortest edges to the longest, in several passes. Patches get wider
// from pass to pass, because most vertices can be removed with one ring, which is cheap. A vertex is tried
// again only after something near it has changed. If patches may have one ring at most, there are just two
// passes with one ring, and one with two rings over the first vertices. That removes more than further passes
// with one ring would in that time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_BLOCK_WORKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_BLOCK_WORKER_H

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Triangle_repairer.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Vertex_remover.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How far removal goes.
struct Coarsening_effort {
  int most_rings = 3;        ///< of the widest patches; 0 for no removal, 1 for mostly one
  double least_share = 0.01; ///< a pass with the widest patches that removes less of the vertices is the last
  /// Bounds the number of tries in a block, by the number of its vertices, in each pass of blocks; 0 for no bound.
  double tries_per_vertex = 0;
};

/// How many rings around the vertices of sites move when these are placed. Farther away the mesh may have been
/// coarsened, so that there is no room: there each sweep would lower the energy, but leave the range.
constexpr int rings_of_placing = 4;

template <class Geometry>
class Block_worker {
public:
  using Mesh = Ring_mesh<Geometry>;
  using Point = typename Geometry::Point;

  Block_worker(Mesh& mesh, typename Ring_patch<Geometry>::Marks& marks, const Ring_block& block,
               const Angle_range& range)
      : mesh_(mesh), patch_(mesh, marks, block.number), relaxer_(patch_, range), remover_(patch_, relaxer_),
        repairer_(patch_, relaxer_, remover_, spare_) {
    for (const Ring_vertex v : Id_range<Ring_vertex>(block.begin, block.end))
      if (patch_.is_ours(v)) own_.push_back(v);
    for (const Ring_vertex v : Id_range<Ring_vertex>(block.end, block.spare_end)) spare_.push_back(v);
    std::reverse(spare_.begin(), spare_.end()); // the first one is taken first
  }

  /// Whether everything within a few rings of v is the block's.
  bool is_well_inside(Ring_vertex v) {
    constexpr int rings = 3;
    patch_.begin();
    patch_.add(v);
    patch_.grow(rings);
    return !patch_.is_cut();
  }

  /// Moves vertices, pairs of a fixed vertex and a place, and relaxes what is near them.
  void move_and_relax(const std::vector<std::pair<Ring_vertex, Point>>& moves) {
    if (moves.empty()) return;
    constexpr int sweeps = 24, sweeps_between_flips = 4;
    begin_near(moves);
    for (const auto& [v, place] : moves) patch_.move(v, place);
    for (int s = 1; s <= sweeps && relaxer_.sweep() > 0; ++s)
      if (s % sweeps_between_flips == 0) relaxer_.flip_all();
  }

  /// Repairs what is outside the range of angles.
  void repair() { repairer_.repair_all(own_); }

  void coarsen(const Coarsening_effort& effort) {
    tries_left_ = effort.tries_per_vertex > 0
                      ? static_cast<std::size_t>(effort.tries_per_vertex * static_cast<double>(own_.size()))
                      : std::size_t(-1);
    if (effort.most_rings == 1) return coarsen_mostly_with_one_ring();
    for (int pass = 1; effort.most_rings > 0; ++pass) {
      const int rings = std::min(pass, effort.most_rings);
      const std::vector<Ring_vertex> candidates = removable(rings);
      const double removed = static_cast<double>(remove(candidates, candidates.size(), rings)),
                   all = static_cast<double>(candidates.size());
      if (tries_left_ == 0 || (rings == effort.most_rings && removed <= effort.least_share * all)) return;
    }
  }

private:
  static constexpr int stages = 9;

  Mesh& mesh_;
  Ring_patch<Geometry> patch_;
  Star_relaxer<Geometry> relaxer_;
  Vertex_remover<Geometry> remover_;
  std::vector<Ring_vertex> spare_, own_;
  Triangle_repairer<Geometry> repairer_;

  std::size_t tries_left_ = 0;

  /// Begins an operation on the vertices near those that move, in shuffle order.
  void begin_near(const std::vector<std::pair<Ring_vertex, Point>>& moves) {
    patch_.begin();
    for (const auto& move : moves) patch_.add(move.first);
    patch_.grow(rings_of_placing);
    std::vector<Ring_vertex> near = patch_.members();
    std::sort(near.begin(), near.end());
    patch_.begin();
    for (const Ring_vertex v : near) patch_.add(v);
  }

  void coarsen_mostly_with_one_ring() {
    for (const int rings : {1, 1, 2}) {
      const std::vector<Ring_vertex> candidates = removable(rings);
      remove(candidates, rings == 1 ? candidates.size() : candidates.size() / 4, rings);
    }
  }

  /// Tries the first `count` candidates. Returns how many are removed.
  std::size_t remove(const std::vector<Ring_vertex>& candidates, std::size_t count, int rings) {
    std::size_t removed = 0;
    for (std::size_t i = 0; i < count && tries_left_ > 0; ++i) {
      if (!is_removable(candidates[i], rings)) continue;
      --tries_left_;
      if (remover_.remove(candidates[i], rings, stages)) ++removed;
    }
    return removed;
  }

  bool is_removable(Ring_vertex v, int rings) const {
    const Ring& r = mesh_.ring(v);
    return is_movable(r.mobility) && r.tried_rings < rings;
  }

  /// By increasing mean length of their edges.
  std::vector<Ring_vertex> removable(int rings) const {
    std::vector<std::pair<double, Ring_vertex>> keys;
    for (const Ring_vertex v : own_) {
      if (!is_removable(v, rings)) continue;
      const Ring& r = mesh_.ring(v);
      double sum = 0;
      for (int k = 0; k < r.size; ++k)
        sum += std::sqrt(squared_length(Geometry::difference(mesh_.point(r[k]), mesh_.point(v))));
      keys.push_back({sum / r.size, v});
    }
    std::sort(keys.begin(), keys.end());
    std::vector<Ring_vertex> result;
    for (const auto& key : keys) result.push_back(key.second);
    return result;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_BLOCK_WORKER_H
