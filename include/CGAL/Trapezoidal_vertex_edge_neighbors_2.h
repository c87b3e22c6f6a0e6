// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertex-edge neighbors of a planar straight-line graph by trapezoidal decompositions.
//
// Computes: for each vertex and each of the four axis directions the first segment hit by the ray from the
//           vertex, and the nearest of the four.
// Bound:    O((n + m + c) log n) work for n vertices, m segments and c crossings of segments.
// Source:   Bern, Eppstein, Teng, section 6, Lemma 5: the trapezoidal decompositions of the graph in both
//           axis directions. CGAL's Arrangement_2 and decompose() make them.
// Deviates: the paper uses a parallel algorithm for the decomposition. Here slabs of places are arranged and
//           decomposed side by side, with all segments that meet them. There is as much parallelism as there
//           are slabs, and none in the worst case, where most segments pass through all slabs.
//
// The proof of the lemma is in Quadtree_vertex_edge_neighbors_2.h.

#ifndef CGAL_TRAPEZOIDAL_VERTEX_EDGE_NEIGHBORS_2_H
#define CGAL_TRAPEZOIDAL_VERTEX_EDGE_NEIGHBORS_2_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Axis_rays.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Slabs.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/vertex_edge_neighbor_types.h>
#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Neighbors
/// Vertex-edge neighbors (Lemma 5) by trapezoidal decompositions of the graph.
///
/// The constructor finds all hits. The graph need not be planar: segments may cross and overlap, vertices may
/// lie on segments and be given repeatedly. All answers are exact except for the rounding of distances. They
/// are the same for any number of threads.
///
/// <h3>Time</h3>
/// O((n + m + c) log n) for n vertices, m segments and c crossings. It computes only orientations of
/// vertices, distances, and crossings if there are any. With `Parallel_tag`, slabs of a thousand or more
/// vertices are processed side by side.
/// \tparam Traits_ a model of `QuadtreeTraits_2`: any of those of this package.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`.
/// \cgalModels{VertexEdgeNeighbors_2}
template <class Traits_, class ConcurrencyTag = Sequential_tag>
class Trapezoidal_vertex_edge_neighbors_2 {
public:
  /// \name Types
  /// @{

  /// The traits.
  using Traits = Traits_;
  /// A point of the graph.
  using Point_2 = typename Traits::Point_2;
  /// A graph of these points.
  using Pslg = Pslg_2<Point_2>;
  /// The direction of a ray.
  using Direction = Quadtree_mesh_2::Direction;
  /// Names a vertex of the graph.
  using Vertex_index = Quadtree_mesh_2::Vertex_index;
  /// Names a segment of the graph.
  using Segment_index = Quadtree_mesh_2::Segment_index;
  /// @}

  /// Finds the hits of all vertices.
  /// \param pslg is not copied, so it has to stay where and as it is. Its segments join existing vertices.
  explicit Trapezoidal_vertex_edge_neighbors_2(const Pslg& pslg);

  /// Not for temporary graphs, because the object keeps a reference to the graph.
  explicit Trapezoidal_vertex_edge_neighbors_2(const Pslg&& pslg) = delete;

  /// The first segment, not incident to `v`, that the ray from `v` in direction `d` hits. Takes O(1) time.
  /// \pre `d` is `EAST`, `NORTH`, `WEST` or `SOUTH`
  const Vertex_edge_neighbor_2& first_hit(Vertex_index v, Direction d) const {
    CGAL_precondition(!is_diagonal(d));
    return hits_[std::size_t(v)].first[static_cast<std::size_t>(d) / 2];
  }

  /// The nearest of the four hits. If several are equally near, it is the segment with the lowest index.
  /// Takes O(1) time. By Lemma 5, this hit or the nearest vertex is within a factor sqrt(2) of the feature
  /// nearest to `v`.
  const Vertex_edge_neighbor_2& nearest_hit(Vertex_index v) const {
    const Hits& h = hits_[std::size_t(v)];
    return h.first[h.nearest];
  }

  /// The graph.
  const Pslg& pslg() const { return *pslg_; }

private:
  using Hits = Quadtree_mesh_2::internal::Vertex_edge_hits;
  using Axis_slabs = Quadtree_mesh_2::internal::Slabs<Point_2>;

  static constexpr std::size_t least_slab = 1024; ///< smaller slabs are no faster
  static constexpr std::size_t block_of_vertices = 1024;

  /// Measures the hits of the rays along x and of those along y.
  void collect_hits(const Axis_slabs& x, const Axis_slabs& y) {
    using namespace Quadtree_mesh_2::internal;
    const Axis_rays<Pslg> rays(*pslg_);
    hits_.resize(pslg_->number_of_vertices());
    for_each_index<ConcurrencyTag>(
        hits_.size(),
        [&](std::size_t i) {
          const Vertex_index v(i);
          typename Axis_rays<Pslg>::Hit at_vertex;
          at_vertex.segment = first_of(x.through(v), y.through(v));
          hits_[i] = vertex_edge_hits(rays, v, [&](const auto& ray) {
            if (at_vertex.segment.is_valid()) return at_vertex;
            return rays.hit_ahead(ray, (ray.axis() == 0 ? x : y).hits(v)[ray.sign() > 0 ? 0 : 1]);
          });
        },
        block_of_vertices);
  }

  const Pslg* pslg_;
  std::vector<Hits> hits_;
};

// Defined outside the class, so not inline: a compiled library spares the compiler the body.
template <class Traits_, class ConcurrencyTag>
Trapezoidal_vertex_edge_neighbors_2<Traits_, ConcurrencyTag>::Trapezoidal_vertex_edge_neighbors_2(
    const Pslg& pslg)
    : pslg_(&pslg) {
  using namespace Quadtree_mesh_2::internal;
  std::array<std::optional<Axis_slabs>, 2> axes;
  Executor<ConcurrencyTag>::run(2, [&](std::size_t axis) {
    axes[axis].emplace(Ranked_places<Point_2>::template of<ConcurrencyTag>(pslg, static_cast<int>(axis)),
                       pslg.number_of_segments(), least_slab);
  });
  const std::size_t slabs = axes[0]->size();
  Executor<ConcurrencyTag>::run(slabs + axes[1]->size(), [&](std::size_t i) {
    if (i < slabs)
      axes[0]->decompose(i);
    else
      axes[1]->decompose(i - slabs);
  });
  Executor<ConcurrencyTag>::run(2, [&](std::size_t axis) { axes[axis]->find_hits(); });
  collect_hits(*axes[0], *axes[1]);
}

} // namespace CGAL

#define CGAL_QUADTREE_MESH_2_HAS_TRAPEZOIDAL_NEIGHBORS
#include <CGAL/Quadtree_mesh_2/compiled_meshers.h>

#endif // CGAL_TRAPEZOIDAL_VERTEX_EDGE_NEIGHBORS_2_H
