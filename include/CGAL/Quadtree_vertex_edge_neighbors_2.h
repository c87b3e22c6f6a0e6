// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertex-edge neighbors of a planar straight-line graph by walks in its quadtree.
//
// Computes: for each vertex and each of the four axis directions the first segment hit by the ray from the
//           vertex; the nearest of the four; and, for a sector between two segments at a vertex, the nearest
//           vertex or segment in it.
// Bound:    O(n + m + k + c) work, not counting sorting, for n vertices, m segments, k squares and c pairs of a leaf
//           and a segment that meets it. For each ray, also the leaves that it passes, with their segments. This
//           does not reach the paper's O(n log n) in the worst case: c and the leaves that rays pass may be in
//           proportion to m times the leaves along a segment. See below.
// Source:   Bern, Eppstein, Teng, section 6, Lemma 5.
// Deviates: rays walk through the quadtree; the paper shoots them by trapezoidal decomposition. On demand, leaves
//           that many long segments meet are split further.
//
// Lemma 5. Let D be the distance from a vertex v to the nearest segment e that is not incident to it, V the
// distance to the nearest other vertex, and H the distance to the nearest of the four hits (infinite if there are
// none). Then H >= D, and min(V, H) <= sqrt(2) D. So the distance f = min(V, D) to whatever is nearest is
// known within a factor sqrt(2):
//                                  f  <=  min(V, H)  <=  sqrt(2) f,
// If the distance to `Balanced_quadtree::near_neighbor()` takes the place of V, the factor is
// 1.6284 sqrt(2) < 2.303.
//
// Proof. Hits lie on segments not incident to v, so H >= D. If D = 0, v lies in the interior of e, which all
// four rays hit, and H = 0. Otherwise suppose no end of e is within sqrt(2) D. Then the point q of e that is
// nearest to v is not an end, so e is perpendicular to vq. Both ends are further than D from q, as otherwise
// they would be within sqrt(D^2 + D^2) of v. So e meets each ray from v that makes an angle of at most 45
// degrees with vq, and at most D / cos(45 degrees) = sqrt(2) D away. One of the four axis directions is among
// these. Its first hit is no further: H <= sqrt(2) D. If an end of e is within sqrt(2) D of v, then V <=
// sqrt(2) D. Finally, if f = V, then min(V, H) <= V = f; otherwise f = D.
//
// The nearest hit alone, H, does not approximate D: all four rays may miss a segment that ends next to v. That is
// why the lemma needs V.
//
// Sectors. Distances are Euclidean, and everything in the sector counts, whatever lies between. The mesher
// finds the radii of its rings (internal/refinement/Corner_finder.h) geodesically: by walks in the constrained
// Delaunay triangulation of the domain that stop at constraints. The nearest feature in a sector is never
// hidden, because anything that hides it is nearer. So the two differ only by what they leave out. The mesher
// ignores what is not in the domain. It also ignores segments that touch the far end of a leg, even if they
// come back nearer to the apex than that; a ring may then end close to such a segment, and refinement copes
// with it. The mesher also counts a vertex just beyond the ring that sees the ring's chord under a large
// angle. doc/guarantees.md says why it keeps its walks.

#ifndef CGAL_QUADTREE_VERTEX_EDGE_NEIGHBORS_2_H
#define CGAL_QUADTREE_VERTEX_EDGE_NEIGHBORS_2_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Axis_ray_caster.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Axis_rays.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Sector_searcher.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Leaf_segments.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/schedule_of_threads.h>
#include <CGAL/Quadtree_mesh_2/vertex_edge_neighbor_types.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Neighbors
/// Vertex-edge neighbors (Lemma 5) by walks in the balanced quadtree of the vertices.
///
/// The constructor finds all hits, in parallel over the vertices. Sectors are searched on request. The graph
/// need not be planar: segments may cross and overlap, vertices may lie on segments and be given repeatedly.
/// All answers are exact except for the rounding of distances. They are the same for any number of threads
/// and for all options.
///
/// <h3>Time</h3>
/// Usually a ray meets a few leaves, and a leaf a few segments. In the worst case a ray passes all leaves in
/// its row, and a leaf lists all segments. Many long segments with no vertex between them share large leaves,
/// and then the time is that of brute force. `Vertex_edge_neighbors_options_2` can split such leaves.
///
/// A segment may meet a constant share of all leaves, and each of m long segments may do so. The lists need 4 bytes
/// per pair of a leaf and a segment, and 24 while they are made.
/// \tparam Traits_ a model of `QuadtreeTraits_2`: any of those of this package.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`.
/// \cgalModels{VertexEdgeNeighbors_2}
template <class Traits_, class ConcurrencyTag = Sequential_tag>
class Quadtree_vertex_edge_neighbors_2 {
public:
  /// \name Types
  /// @{

  /// The traits.
  using Traits = Traits_;
  /// A point of the graph.
  using Point_2 = typename Traits::Point_2;
  /// A graph of these points.
  using Pslg = Pslg_2<Point_2>;
  /// The quadtree of the vertices.
  using Quadtree = Balanced_quadtree<Traits, ConcurrencyTag>;
  /// The direction of a ray.
  using Direction = Quadtree_mesh_2::Direction;
  /// Names a vertex of the graph.
  using Vertex_index = Quadtree_mesh_2::Vertex_index;
  /// Names a segment of the graph.
  using Segment_index = Quadtree_mesh_2::Segment_index;
  /// How the quadtree is made.
  using Options = Vertex_edge_neighbors_options_2;
  /// @}

  /// Finds the hits of all vertices.
  /// \param pslg is not copied, so it has to stay where and as it is. Its segments join existing vertices.
  /// \throws Quadtree_mesh_2::Point_error for a vertex that the traits cannot map.
  /// \throws std::length_error if there are too many points, squares or members of lists for 32-bit indices.
  explicit Quadtree_vertex_edge_neighbors_2(const Pslg& pslg, const Options& options = Options(),
                                            const Traits& traits = Traits())
      : pslg_(&pslg),
        tree_(pslg.vertices,
              Quadtree_options().schedule(Quadtree_mesh_2::internal::schedule_of_threads<ConcurrencyTag>()),
              traits) {
    lists_ = Lists::template of<ConcurrencyTag>(tree_, pslg.segments);
    for (int i = 0; i < options.max_refinements(); ++i)
      if (!split_long_lists(options.max_segments_per_leaf())) break;
    find_hits();
  }

  /// Not for temporary graphs, because the object keeps references to the graph.
  explicit Quadtree_vertex_edge_neighbors_2(const Pslg&& pslg, const Options& options = Options(),
                                            const Traits& traits = Traits()) = delete;

  /// The first segment, not incident to `v`, that the ray from `v` in direction `d` hits. Takes O(1) time.
  ///
  /// A segment is incident if it has an end at the place of `v`: `v` itself or another vertex. Rays begin in
  /// `v`, and segments contain their ends. A segment with `v` in its interior is hit at distance 0 in all
  /// directions. An end on the ray is a hit, and so is the nearer end of a segment that lies on the ray. Of
  /// several segments hit at the same distance, the one with the lowest index counts.
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

  /// The vertex or segment nearest to `apex` in the open sector at `apex`, counterclockwise from segment
  /// `right` to segment `left`. It has points in the sector that are nearest to `apex`, or points arbitrarily
  /// near to such a place. At equal distances, a vertex comes before segments, and lower indices before
  /// higher ones. Segments at `apex` within the sector are at distance 0.
  ///
  /// Takes O(1) time for each leaf that meets the sector within about three times the distance, for each
  /// point and segment listed there, and for each level up to squares of that size.
  /// \param at_most features further away are not found. For the radius of a ring, this is the length of the
  /// shorter leg.
  /// \pre `right` and `left` are incident to `apex`, with a counterclockwise angle of more than 0 and less
  /// than 180 degrees from `right` to `left`
  Sector_neighbor_2 nearest_in_sector(Vertex_index apex, Segment_index right, Segment_index left,
                                      double at_most = std::numeric_limits<double>::infinity()) const {
    const Vertex_index r = far_end(apex, right), l = far_end(apex, left);
    CGAL_precondition(Quadtree_mesh_2::internal::Point_arithmetic<Point_2>::orientation(
                          pslg_->point(apex), pslg_->point(r), pslg_->point(l)) > 0);
    return Quadtree_mesh_2::internal::Sector_searcher<Quadtree, Pslg>(tree_, lists_, *pslg_, apex, r, l,
                                                                      at_most)
        .find();
  }

  /// The greatest radius, up to `at_most`, of an open sector between two segments that holds no vertex and
  /// meets no segment. Arguments and time are as for `nearest_in_sector()`.
  double clear_radius(Vertex_index apex, Segment_index right, Segment_index left,
                      double at_most = std::numeric_limits<double>::infinity()) const {
    return std::min(at_most, nearest_in_sector(apex, right, left, at_most).distance);
  }

  /// The graph.
  const Pslg& pslg() const { return *pslg_; }
  /// The quadtree of the vertices. Where there are many segments, leaves may be smaller than vertices need.
  const Quadtree& quadtree() const { return tree_; }
  /// The number of pairs of a leaf and a segment listed in it.
  std::size_t number_of_listed_segments() const { return lists_.size(); }

private:
  using Lists = Quadtree_mesh_2::internal::Leaf_segments;
  using Leaf_index = Quadtree_mesh_2::Leaf_index;
  using Point_index = Quadtree_mesh_2::Point_index;
  using Point_rank = Quadtree_mesh_2::Point_rank;

  using Hits = Quadtree_mesh_2::internal::Vertex_edge_hits;

  static constexpr std::size_t block_of_vertices = 64;

  Point_rank rank(Vertex_index v) const { return tree_.framework().rank(Point_index(v.value())); }

  /// Splits leaves that too many segments pass through. Returns whether there were any.
  bool split_long_lists(std::size_t max_segments) {
    using namespace Quadtree_mesh_2::internal;
    const int depth = tree_.framework().grid().depth();
    const auto long_lists = pack_values<ConcurrencyTag, Leaf_index>(
        tree_.number_of_leaves(),
        [&](std::size_t i) {
          const Leaf_index l(i);
          return lists_[l].size() > max_segments && tree_.level(l) < depth &&
                 number_passing(l) > max_segments;
        },
        [](std::size_t i) { return Leaf_index(i); });
    if (long_lists.empty()) return false;
    tree_.refine(long_lists);
    lists_ = Lists::template of<ConcurrencyTag>(tree_, pslg_->segments);
    return true;
  }

  /// The number of segments listed for a leaf that do not end in it. Splitting cannot part segments at a
  /// vertex from it.
  std::size_t number_passing(Leaf_index l) const {
    const auto list = lists_[l];
    return static_cast<std::size_t>(std::count_if(list.begin(), list.end(), [&](Segment_index s) {
      const auto& ends = pslg_->segments[std::size_t(s)];
      return tree_.leaf(rank(ends[0])) != l && tree_.leaf(rank(ends[1])) != l;
    }));
  }

  /// In shuffle order, so that neighbors in the tree are neighbors in memory.
  void find_hits() {
    using namespace Quadtree_mesh_2::internal;
    const auto& framework = tree_.framework();
    hits_.resize(pslg_->number_of_vertices());
    const Axis_ray_caster<Quadtree, Pslg> caster(tree_, lists_, *pslg_);
    for_each_index<ConcurrencyTag>(
        framework.number_of_points(),
        [&](std::size_t r) {
          const Point_index i = framework.input_point(Point_rank(r));
          hits_[std::size_t(i)] = vertex_edge_hits(caster.rays(), Vertex_index(i.value()),
                                                   [&](const auto& ray) { return caster.first_hit(ray); });
        },
        block_of_vertices);
    for (const auto& d : framework.duplicates())
      hits_[std::size_t(d.duplicate)] =
          hits_[std::size_t(framework.input_point(framework.rank(d.duplicate)))];
  }

  /// The end of a segment that is not where `v` is.
  Vertex_index far_end(Vertex_index v, Segment_index s) const {
    const auto& ends = pslg_->segments[std::size_t(s)];
    const bool is_first = rank(ends[0]) == rank(v);
    CGAL_precondition(is_first || rank(ends[1]) == rank(v));
    return is_first ? ends[1] : ends[0];
  }

  const Pslg* pslg_;
  Quadtree tree_;
  Lists lists_;
  std::vector<Hits> hits_;
};

} // namespace CGAL

#endif // CGAL_QUADTREE_VERTEX_EDGE_NEIGHBORS_2_H
