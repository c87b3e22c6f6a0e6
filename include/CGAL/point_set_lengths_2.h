// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_POINT_SET_LENGTHS_2_H
#define CGAL_POINT_SET_LENGTHS_2_H

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/mesh_quality_2.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Lengths by which meshes of a point set are judged.
struct Point_set_lengths_2 {
  double spanning_tree = 0; ///< of the minimum spanning tree by Euclidean lengths
  double delaunay = 0;      ///< of all edges of the Delaunay triangulation
  double hull = 0; ///< of the border of the convex hull; twice the distance of the ends for collinear points

  /// A lower bound on the length of any triangulation that has the points as vertices, whatever other
  /// vertices it has. Its edges connect the points, and no tree that does so is shorter than 0.824 times the
  /// spanning tree (Chung, Graham, "A new bound for Euclidean Steiner minimal trees", 1985). Its border
  /// encloses the points.
  double least_mesh() const { return (std::max)(0.824 * spanning_tree, hull); }
};

namespace Quadtree_mesh_2 {
namespace internal {

/// The Delaunay triangulation of a point set as a graph with lengths.
class Delaunay_graph {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Delaunay = Delaunay_triangulation_2<Kernel, Triangulation_data_structure_2<Vertex_base>>;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                      boost::property<boost::edge_weight_t, double>>;

public:
  explicit Delaunay_graph(const std::vector<Kernel::Point_2>& points)
      : delaunay_(points.begin(), points.end()) {
    std::size_t number = 0;
    for (const auto v : delaunay_.finite_vertex_handles()) v->info() = number++;
    graph_ = Graph(number);
    for (const auto& edge : delaunay_.finite_edges()) {
      const auto [p, q] = ends(edge);
      boost::add_edge(p->info(), q->info(), length_of(edge), graph_);
    }
  }

  double length() const {
    double sum = 0;
    for (const auto& edge : delaunay_.finite_edges()) sum += length_of(edge);
    return sum;
  }

  double hull_length() const {
    double sum = 0;
    for (const auto& edge : delaunay_.finite_edges()) {
      const auto f = edge.first;
      if (delaunay_.dimension() == 1)
        sum += 2 * length_of(edge);
      else if (delaunay_.is_infinite(f) || delaunay_.is_infinite(f->neighbor(edge.second)))
        sum += length_of(edge);
    }
    return sum;
  }

  /// By Kruskal's algorithm: the minimum spanning tree is part of the Delaunay triangulation.
  double spanning_tree_length() const {
    std::vector<boost::graph_traits<Graph>::edge_descriptor> tree;
    boost::kruskal_minimum_spanning_tree(graph_, std::back_inserter(tree));
    double sum = 0;
    for (const auto& edge : tree) sum += boost::get(boost::edge_weight, graph_, edge);
    return sum;
  }

private:
  Delaunay delaunay_;
  Graph graph_;

  std::pair<Delaunay::Vertex_handle, Delaunay::Vertex_handle> ends(const Delaunay::Edge& e) const {
    if (delaunay_.dimension() == 1) return {e.first->vertex(0), e.first->vertex(1)};
    return {e.first->vertex(Delaunay::cw(e.second)), e.first->vertex(Delaunay::ccw(e.second))};
  }

  double length_of(const Delaunay::Edge& e) const {
    const auto [v, w] = ends(e);
    return std::hypot(v->point().x() - w->point().x(), v->point().y() - w->point().y());
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Data
/// Returns the lengths for points whose coordinates are arithmetic or have a `CGAL::to_double()`. They are
/// rounded to the nearest doubles. Expected O(n log n) time.
template <class Point>
Point_set_lengths_2 point_set_lengths_2(const std::vector<Point>& points) {
  const Quadtree_mesh_2::internal::Delaunay_graph graph(Quadtree_mesh_2::internal::to_double_points(points));
  return {graph.spanning_tree_length(), graph.length(), graph.hull_length()};
}

/// \ingroup PkgQuadtreeMesh2Data
/// Returns the length of all edges of a mesh, each counted once. `mesh_quality_2()` gives the same number
/// besides others.
/// \pre `mesh.neighbors` is filled
template <class Point>
double total_edge_length_2(const Indexed_mesh_2<Point>& mesh) {
  using Quadtree_mesh_2::internal::to_nearest_double;
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto neighbor = mesh.neighbors[t][k];
      if (neighbor.is_valid() && std::size_t(neighbor) < t) continue;
      const Point& p = mesh.point(mesh.triangles[t][(k + 1) % 3]);
      const Point& q = mesh.point(mesh.triangles[t][(k + 2) % 3]);
      sum += std::hypot(to_nearest_double(p.x()) - to_nearest_double(q.x()),
                        to_nearest_double(p.y()) - to_nearest_double(q.y()));
    }
  return sum;
}

} // namespace CGAL

#endif // CGAL_POINT_SET_LENGTHS_2_H
