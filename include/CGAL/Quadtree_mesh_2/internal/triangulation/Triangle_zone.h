// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_TRIANGLE_ZONE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_TRIANGLE_ZONE_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A set of triangles that grows ring by ring. O(size) work, and a byte for each triangle of the mesh. Which triangles
/// it has does not depend on threads; in which order it has them does.
template <class ConcurrencyTag, class Geometry>
class Triangle_zone {
public:
  explicit Triangle_zone(const Kernel_mesh<Geometry>& mesh) : mesh_(mesh), is_in_(mesh.triangles.size()) {}

  const std::vector<Triangle_id>& triangles() const { return triangles_; }

  bool has(Triangle_id t) const { return is_in_[t.value()].load(std::memory_order_relaxed); }

  /// How many rings there are, of which the first is what was added.
  std::size_t number_of_rings() const { return first_of_ring_.size(); }
  Span<Triangle_id> ring(std::size_t r) const {
    const std::size_t end = r + 1 < first_of_ring_.size() ? first_of_ring_[r + 1] : triangles_.size();
    return {triangles_.data() + first_of_ring_[r], triangles_.data() + end};
  }

  /// Adds those of the triangles, a vector, that are alive.
  template <class Triangles>
  void add(const Triangles& seeds) {
    append(seeds.size(), [&](std::size_t i, std::vector<Triangle_id>& found) {
      if (mesh_.is_alive(seeds[i]) && is_new(seeds[i])) found.push_back(seeds[i]);
    });
  }

  /// Adds the triangles with a side in common with those of the ring before, as often as is said. Once only.
  void grow(int rings) {
    grow(rings, [](Span<Triangle_id>) {});
  }
  /// The same, with `before_look(triangles)` before the neighbors of a ring's triangles are read.
  template <class Before_look>
  void grow(int rings, const Before_look& before_look) {
    for (std::size_t begin = 0; rings > 0; --rings) {
      const std::size_t end = triangles_.size();
      before_look({triangles_.data() + begin, triangles_.data() + end});
      first_of_ring_.push_back(end);
      append(end - begin, [&](std::size_t i, std::vector<Triangle_id>& found) {
        for (const Side o : mesh_.triangle(triangles_[begin + i]).side)
          if (!o.is_border() && is_new(o.triangle())) found.push_back(o.triangle());
      });
      begin = end;
    }
  }

private:
  const Kernel_mesh<Geometry>& mesh_;
  std::vector<std::atomic<bool>> is_in_;
  std::vector<Triangle_id> triangles_;
  std::vector<std::size_t> first_of_ring_{0};

  bool is_new(Triangle_id t) {
    auto& is_in = is_in_[t.value()];
    return !is_in.load(std::memory_order_relaxed) && !is_in.exchange(true, std::memory_order_relaxed);
  }

  /// Appends what `find(i, found)` finds for the indices i below n.
  template <class Find>
  void append(std::size_t n, const Find& find) {
    using Found = std::vector<Triangle_id>;
    constexpr std::size_t block_length = 1024;
    std::vector<Found> found((n + block_length - 1) / block_length);
    for_each_block<ConcurrencyTag>(n, block_length, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) find(i, found[b]);
    });
    append_all<ConcurrencyTag>(triangles_, found, [](const Found& f) -> const Found& { return f; });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_TRIANGLE_ZONE_H
