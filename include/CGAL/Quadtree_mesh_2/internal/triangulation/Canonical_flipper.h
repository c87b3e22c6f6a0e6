// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Makes a triangulation the one that its vertices and constrained edges determine. What follows does not depend on the
// way it came about: on blocks, samples or the order of insertions.
//
// Computes: the constrained Delaunay triangulation, decided exactly, in which of vertices on one circle that with the
//           least number is joined to all others that it sees.
// Bound:    O(n) for n triangles, in parallel, and the flips, one after the other. They are few but where many vertices
//           are on circles, as in lattices.
// Source:   Lawson (1977), flips. They end: with vertices on one circle, a flip that joins the least of four to another
//           one lowers the lifted surface if lifted vertices are pulled down in the order of their numbers.
// Method:   A side that is not Delaunay, or on a circle with what is beyond, is seen under an angle that is not
//           certainly acute from at least one of its triangles. Only such sides are tested.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_CANONICAL_FLIPPER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_CANONICAL_FLIPPER_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Canonical_flipper {
public:
  explicit Canonical_flipper(Kernel_mesh<Geometry>& mesh) : mesh_(mesh) {}

  void run() {
    std::vector<Side> doubtful = sides_to_flip();
    run(doubtful);
  }
  /// The same of a mesh of which all other sides are as they should be. None is left in the list.
  void run(std::vector<Side>& doubtful) {
    while (!doubtful.empty()) {
      const Side s = doubtful.back();
      doubtful.pop_back();
      if (!has_to_be_flipped(s)) continue;
      const Triangle_id t = s.triangle(), u = mesh_.across(s).triangle();
      mesh_.flip(t, s.slot());
      for (const Side outer : {Side(t, 0), Side(u, 0), Side(t, 2), Side(u, 1)}) doubtful.push_back(outer);
    }
  }

private:
  Kernel_mesh<Geometry>& mesh_;

  std::vector<Side> sides_to_flip() const {
    using Sides = std::vector<Side>;
    const std::size_t n = mesh_.triangles.size();
    std::vector<Sides> found((n + default_block - 1) / default_block);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      mesh_.for_each_alive({begin, end}, [&](Triangle_id t) {
        const auto shape = mesh_.shape(mesh_.triangle(t));
        for (int k = 0; k < 3; ++k)
          if (!shape.is_certainly_acute(k) && has_to_be_flipped(Side(t, k))) found[b].push_back(Side(t, k));
      });
    });
    Sides sides;
    append_all<ConcurrencyTag>(sides, found, [](const Sides& s) -> const Sides& { return s; });
    return sides;
  }

  bool has_to_be_flipped(Side s) const {
    const Side o = mesh_.across(s);
    if (o.is_constrained()) return false;
    const Vertex_id a = mesh_.opposite(s), b = mesh_.source(s), c = mesh_.target(s), d = mesh_.opposite(o);
    const int side = Geometry::side_of_circle(mesh_.point(a), mesh_.point(b), mesh_.point(c), mesh_.point(d));
    const auto number = [this](Vertex_id v) { return mesh_.input_number(v); };
    return side > 0 || (side == 0 && std::min(number(a), number(d)) < std::min(number(b), number(c)));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_CANONICAL_FLIPPER_H
