// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Processes a mesh of rings in blocks, at the same time.
//
// Computes: the effect of a function on each block of vertices, in a few passes with different blocks.
// Bound:    O(n) work for each pass, not counting that function and sorting.
// Method:   Vertices are sorted in shuffle order and cut into runs of equal length. A block consists of the
//           vertices whose neighbors are all in their run; the others are not written. Vertices next to seams
//           wait for the next pass. It sorts in the order of a quadtree shifted by a third of the root: of
//           three such orders one has no seam near (T. M. Chan, "Approximate nearest neighbor queries
//           revisited"). Vertices are renumbered for each pass, so a block is one stretch of memory, with the
//           vertices that it may add at its end.
//
// Blocks depend on the mesh alone, so results have the same bits for any number of threads.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_BLOCKS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_BLOCKS_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_patch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The vertices of a block, and those that it may put into the mesh.
struct Ring_block {
  std::int32_t number;
  Ring_vertex begin, end;
  Ring_vertex spare_end; ///< the unused ones are those from `end` on
};

/// Sizes of blocks. Tests specialize it for tags of their own, to have seams in small meshes.
template <class ConcurrencyTag>
struct Ring_block_sizes {
  static constexpr std::size_t vertices = 8192;
};

template <class ConcurrencyTag, class Geometry>
class Ring_blocks {
public:
  using Mesh = Ring_mesh<Geometry>;

  static constexpr int number_of_passes = 3;

  explicit Ring_blocks(Mesh& mesh) : mesh_(mesh) {}

  /// Vertices are renumbered by each pass; what is kept by vertex elsewhere has to follow.
  Ring_vertex new_number(Ring_vertex old) const { return new_number_[old]; }
  bool is_whole() const { return blocks_.size() == 1; }
  std::size_t number_of_blocks() const { return blocks_.size(); }

  /// Cuts the mesh into blocks for pass number `pass`.
  void cut(int pass) { cut(pass, Ring_block_sizes<ConcurrencyTag>::vertices); }
  /// Makes the whole mesh one block.
  void join() { cut(0, std::size_t(-1)); }

  /// Calls f(block, marks), for several blocks at the same time.
  template <class F>
  void for_each_block(const F& f) {
    Indexed_vector<Ring_vertex, Patch_marks> marks(mesh_.number_of_vertices());
    Executor<ConcurrencyTag>::run(blocks_.size(), [&](std::size_t b) { f(blocks_[b], marks); });
  }

private:
  using Place = Grid_point_2<std::uint64_t>;

  Mesh& mesh_;
  std::vector<Ring_block> blocks_;
  Indexed_vector<Ring_vertex, Ring_vertex> new_number_;

  void cut(int pass, std::size_t length) {
    const std::vector<std::uint32_t> order = sorted_vertices(pass);
    set_blocks(order.size(), length);
    renumber(order);
    for_each_index<ConcurrencyTag>(
        blocks_.size(), [&](std::size_t b) { set_owners(blocks_[b]); }, 1);
  }

  /// The vertices in use, in shuffle order.
  std::vector<std::uint32_t> sorted_vertices(int pass) const {
    std::vector<std::uint32_t> used = pack<ConcurrencyTag>(
        mesh_.number_of_vertices(), [&](std::size_t v) { return mesh_.is_alive(Ring_vertex(v)); });
    Uninitialized_vector<Place> places(used.size());
    const auto& origin = mesh_.point(Ring_vertex(used.front()));
    const Extent e = reduce<ConcurrencyTag>(
        used.size(), Extent(),
        [&](std::size_t begin, std::size_t end) {
          Extent part;
          for (std::size_t i = begin; i < end; ++i)
            part.add(Geometry::difference(mesh_.point(Ring_vertex(used[i])), origin));
          return part;
        },
        [](const Extent& a, const Extent& b) { return a.joined(b); });
    // the points fill a third of the root, which is shifted by another third with each pass
    const double root = std::ldexp(1.0, 60),
                 side = std::max({e.high.x - e.low.x, e.high.y - e.low.y, 1e-300});
    const double shift = root / 3 * pass;
    for_each_index<ConcurrencyTag>(used.size(), [&](std::size_t i) {
      const Vector d = Geometry::difference(mesh_.point(Ring_vertex(used[i])), origin) - e.low;
      places[i] = {static_cast<std::uint64_t>(d.x / side * (root / 3) + shift),
                   static_cast<std::uint64_t>(d.y / side * (root / 3) + shift)};
    });
    const Order order = shuffle_order<ConcurrencyTag>(places);
    std::vector<std::uint32_t> sorted(used.size());
    for_each_index<ConcurrencyTag>(used.size(), [&](std::size_t i) { sorted[i] = used[order[i]]; });
    return sorted;
  }

  struct Extent {
    Vector low{1e300, 1e300}, high{-1e300, -1e300};

    void add(Vector p) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    Extent joined(const Extent& o) const {
      Extent e = *this;
      e.add(o.low);
      e.add(o.high);
      return e;
    }
  };

  /// Blocks of about equal length, with room for a sixteenth more.
  void set_blocks(std::size_t n, std::size_t length) {
    const std::size_t count = std::max<std::size_t>(1, n / length);
    blocks_.clear();
    std::size_t begin = 0;
    for (std::size_t b = 0; b < count; ++b) {
      const std::size_t size = n * (b + 1) / count - n * b / count, spare = 16 + size / 16;
      blocks_.push_back({static_cast<std::int32_t>(b), static_cast<Ring_vertex>(begin),
                         static_cast<Ring_vertex>(begin + size),
                         static_cast<Ring_vertex>(begin + size + spare)});
      begin += size + spare;
    }
  }

  void renumber(const std::vector<std::uint32_t>& order) {
    new_number_.assign(mesh_.number_of_vertices(), {});
    const std::size_t count = blocks_.size(), n = order.size();
    const auto first = [&](std::size_t b) { return n * b / count; };
    for_each_index<ConcurrencyTag>(
        count,
        [&](std::size_t b) {
          for (std::size_t i = first(b); i < first(b + 1); ++i)
            new_number_[Ring_vertex(order[i])] = Ring_vertex(blocks_[b].begin.value() + (i - first(b)));
        },
        1);
    // one after the other: there is no time when more memory is needed
    mesh_.points = moved(mesh_.points, order, typename Mesh::Point(), [](const auto& p) { return p; });
    Ring unused;
    unused.mobility = Mobility::REMOVED;
    mesh_.rings = moved(mesh_.rings, order, unused, [this](const Ring& old) {
      Ring r = old;
      for (int k = 0; k < r.size; ++k) r.neighbor[std::size_t(k)] = new_number(r[k]);
      return r;
    });
  }

  /// What vertices have, by their new numbers, with `renumbered(value)` for each; those not in use have `unused`.
  template <class T, class F>
  Indexed_vector<Ring_vertex, T> moved(const Indexed_vector<Ring_vertex, T>& values,
                                       const std::vector<std::uint32_t>& order, const T& unused,
                                       const F& renumbered) const {
    Indexed_vector<Ring_vertex, T> result(blocks_.back().spare_end.value(), unused);
    for_each_index<ConcurrencyTag>(order.size(), [&](std::size_t i) {
      const Ring_vertex before(order[i]);
      result[new_number(before)] = renumbered(values[before]);
    });
    return result;
  }

  /// Gives the block the vertices all of whose neighbors are in it.
  void set_owners(const Ring_block& block) {
    for (const Ring_vertex v : Id_range<Ring_vertex>(block.begin, block.end)) {
      Ring& r = mesh_.ring(v);
      if (r.block == Ring::sealed) continue;
      const bool is_inner = std::all_of(r.neighbor.begin(), r.neighbor.begin() + r.size,
                                        [&](Ring_vertex u) { return !(u < block.begin) && u < block.end; });
      r.block = is_inner ? block.number : -1;
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_BLOCKS_H
