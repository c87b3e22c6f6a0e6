// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The edges from which minimum spanning trees of points are made, with their lengths.
//
// Computes: edges among which are those of all minimum spanning trees, and those from points to their nearest
//           neighbors. They are those of the Delaunay triangulation but the longest sides of triangles.
// Bound:    O(n) edges; that of First_triangulation.h, after O(n) work to sort. In parallel.
// Source:   G. Toussaint, "The relative neighbourhood graph of a finite planar set" (1980), for what is left out.
// Deviates: points on a line are sorted along it. A triangulation would only make long fans.
//
// Why. Let pq be a shortest edge between two parts of the points, and r another point. If r is nearer to both p and q
// than they are to each other, one of pr and qr is a shorter edge between the parts. So no r is, in particular none in
// the closed disk with the diameter pq. So pq is an edge of every Delaunay triangulation, and in no triangle the
// longest side alone. The three auxiliary vertices around the triangulation change nothing. They are at least as far
// from the middle of an edge as the larger side of the points' box is long, and the radius is at most 0.71 of that.
//
// The triangulation is exact, also where points are on a circle but for rounding. An edge is left out if the two others
// are certainly shorter, and then their lengths are in doubles, too. Lengths are correct up to a relative 2^-51.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_NEIGHBOR_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_NEIGHBOR_EDGES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/order_of_places.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Canonical_flipper.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The length of a vector, also where its square is beyond the range of doubles; the same on every machine.
inline double length_of(Vector v) {
  const double largest = std::max(std::fabs(v.x), std::fabs(v.y));
  if (!(largest > 0)) return 0;
  const int exponent = std::ilogb(largest);
  const Vector scaled{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
  return std::ldexp(std::sqrt(squared_length(scaled)), exponent);
}

/// An edge between two vertices.
struct Measured_edge {
  double length;
  Vertex_id a, b;
};

/// The edges between points. These are numbered, as vertices, in an order in which neighbors are near each other.
struct Measured_graph {
  Order order; ///< vertex -> point
  Uninitialized_vector<Measured_edge> edges;

  std::size_t number_of_vertices() const { return order.size(); }
  std::uint32_t point(Vertex_id v) const { return order[v.value()]; }
};

template <class ConcurrencyTag, class Geometry>
class Neighbor_edges {
public:
  using Point = typename Geometry::Point;

  explicit Neighbor_edges(const std::vector<Point>& points) : points_(points) {}

  Measured_graph run() {
    if (is_on_line()) return along_line();
    Measured_graph graph;
    graph.order = order_of_places<ConcurrencyTag, Geometry>(points_);
    triangulate(graph.order);
    take_edges(graph.edges);
    return graph;
  }

private:
  const std::vector<Point>& points_;
  Kernel_mesh<Geometry> mesh_;

  bool is_on_line() const {
    return reduce<ConcurrencyTag>(
        points_.size(), true,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = std::max<std::size_t>(begin, 2); i < end; ++i)
            if (Geometry::orientation(points_[0], points_[1], points_[i]) != 0) return false;
          return true;
        },
        [](bool a, bool b) { return a && b; });
  }

  Measured_graph along_line() const {
    const std::size_t n = points_.size();
    Measured_graph graph;
    graph.order.resize(n);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { graph.order[i] = static_cast<std::uint32_t>(i); });
    sort<ConcurrencyTag>(graph.order.begin(), graph.order.end(), [&](std::uint32_t i, std::uint32_t j) {
      const Point &p = points_[i], &q = points_[j];
      return p.x == q.x ? p.y < q.y : p.x < q.x;
    });
    graph.edges.resize(std::max<std::size_t>(n, 1) - 1);
    for_each_index<ConcurrencyTag>(graph.edges.size(), [&](std::size_t i) {
      const Point &p = points_[graph.order[i]], &q = points_[graph.order[i + 1]];
      graph.edges[i] = {length_of(Geometry::difference(q, p)), Vertex_id(i), Vertex_id(i + 1)};
    });
    return graph;
  }

  void triangulate(const Order& order) {
    const std::size_t n = order.size();
    std::vector<Point> sorted(n);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { sorted[i] = points_[order[i]]; });
    Vertex_blocks blocks = blocks_by_number(n, Block_sizes<ConcurrencyTag>::vertices);
    const bool has_blocks = blocks.size() >= 2;
    First_triangulation<ConcurrencyTag, Geometry>(mesh_, sorted, std::move(blocks)).run({});
    // that of blocks leaves nothing to be flipped
    if (!has_blocks) Canonical_flipper<ConcurrencyTag, Geometry>(mesh_).run();
  }

  void take_edges(Uninitialized_vector<Measured_edge>& edges) const {
    using Edges = std::vector<Measured_edge>;
    const std::size_t n = mesh_.triangles.size();
    std::vector<Edges> found((n + default_block - 1) / default_block);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      found[b].reserve(end - begin); // mostly one of a triangle, or fewer
      mesh_.for_each_alive({begin, end}, [&](Triangle_id t) {
        for (int k = 0; k < 3; ++k) add_edge(Side(t, k), found[b]);
      });
    });
    append_all<ConcurrencyTag>(edges, found, [](const Edges& e) -> const Edges& { return e; });
  }

  /// Adds the edge at a side unless it is left out, or the triangle beyond adds it.
  void add_edge(Side s, std::vector<Measured_edge>& edges) const {
    const Side o = mesh_.across(s);
    if (o.is_border() || o.triangle() < s.triangle()) return;
    const Vertex_id a = mesh_.source(s), b = mesh_.target(s);
    if (std::max(std::size_t(a), std::size_t(b)) >= points_.size()) return; // an auxiliary vertex
    const Point &p = mesh_.point(a), &q = mesh_.point(b);
    if (is_certainly_longest(p, q, mesh_.point(mesh_.opposite(s))) ||
        is_certainly_longest(p, q, mesh_.point(mesh_.opposite(o))))
      return;
    edges.push_back({length_of(Geometry::difference(q, p)), std::min(a, b), std::max(a, b)});
  }

  /// Whether pq is longer than pr and qr; false where rounding leaves a doubt.
  static bool is_certainly_longest(const Point& p, const Point& q, const Point& r) {
    constexpr double error = 1e-14, least_product = 1e-280; // of products that underflow
    const double others =
        std::max(squared_length(Geometry::difference(r, p)), squared_length(Geometry::difference(r, q)));
    return others < (1 - error) * squared_length(Geometry::difference(q, p)) - least_product;
  }
};

/// \pre the points are distinct, and integers span at most 2^61
template <class ConcurrencyTag, class Geometry>
Measured_graph neighbor_edges(const std::vector<typename Geometry::Point>& points) {
  return Neighbor_edges<ConcurrencyTag, Geometry>(points).run();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_NEIGHBOR_EDGES_H
