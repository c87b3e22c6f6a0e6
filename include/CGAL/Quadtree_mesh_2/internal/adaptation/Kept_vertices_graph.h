// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The graph that a given mesh is meshed again from.
//
// Computes: the graph of the vertices that are kept, in their order: so the mesher keeps them, bit for bit. Its
//           segments are the constrained edges; those on both sides of a vertex that is not kept become one. A place
//           in each component tells the domain, and has the attribute and the bound of the region there.
// Bound:    O(k) time for k triangles.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_KEPT_VERTICES_GRAPH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_KEPT_VERTICES_GRAPH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Kept_vertices_graph {
public:
  using Point = Triangle_tree::Point;
  using Mesh = Indexed_mesh_2<Point>;
  using Pslg = Pslg_2<Point>;

  /// \param components of the mesh
  /// \param keeps for each vertex, whether it is kept; all that are no inner vertices of segments' chains or of
  /// components are
  Kept_vertices_graph(const Mesh& mesh, const Pslg& pslg,
                      const std::vector<Given_mesh::Component>& components, const std::vector<char>& keeps) {
    add_vertices(mesh, keeps);
    add_segments(mesh, pslg, keeps);
    add_regions(mesh, pslg, components);
    graph_.first_number = pslg.first_number;
  }

  const Pslg& graph() const { return graph_; }
  /// Per vertex of the graph, that of the mesh.
  const std::vector<Vertex_index>& old_vertex() const { return old_vertex_; }
  /// Per segment of the graph, that of the mesh's own graph.
  const std::vector<Segment_index>& old_segment() const { return old_segment_; }
  /// Per constrained edge of the mesh, the segment of the graph that it is part of.
  const std::vector<Segment_index>& segment_of_edge() const { return segment_of_edge_; }
  /// Per region of the graph, that of the mesh's own graph; -1 for none.
  const std::vector<int>& old_region() const { return old_region_; }

private:
  Pslg graph_;
  std::vector<Vertex_index> new_vertex_, old_vertex_;
  std::vector<Segment_index> old_segment_, segment_of_edge_;
  std::vector<int> old_region_;

  void add_vertices(const Mesh& mesh, const std::vector<char>& keeps) {
    new_vertex_.resize(mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (keeps[v] == 0) continue;
      new_vertex_[v] = graph_.add_vertex(mesh.points[v]);
      old_vertex_.push_back(Vertex_index(v));
      if (!mesh.vertex_markers.empty()) graph_.vertex_markers.push_back(mesh.vertex_markers[v]);
    }
  }

  /// From each kept end of an edge along the vertices that are not kept; each such chain once.
  void add_segments(const Mesh& mesh, const Pslg& pslg, const std::vector<char>& keeps) {
    constexpr std::size_t none = std::size_t(-1);
    std::vector<std::array<std::size_t, 2>> edges_at(mesh.points.size(), {none, none}); // of those not kept
    const auto& edges = mesh.constrained_edges;
    segment_of_edge_.resize(edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (const Vertex_index v : edges[e].vertices)
        if (keeps[std::size_t(v)] == 0)
          edges_at[std::size_t(v)][edges_at[std::size_t(v)][0] == none ? 0 : 1] = e;
    for (std::size_t first = 0; first < edges.size(); ++first)
      for (std::size_t end = 0; end < 2; ++end) {
        const Vertex_index from = edges[first].vertices[end];
        if (keeps[std::size_t(from)] == 0) continue;
        if (segment_of_edge_[first].is_valid()) continue; // added from its other end
        const Segment_index own(graph_.segments.size());
        segment_of_edge_[first] = own;
        std::size_t e = first;
        Vertex_index to = edges[e].vertices[1 - end];
        while (keeps[std::size_t(to)] == 0) {
          const auto& [a, b] = edges_at[std::size_t(to)];
          e = a == e ? b : a;
          segment_of_edge_[e] = own;
          to = edges[e].vertices[edges[e].vertices[0] == to ? 1 : 0];
        }
        graph_.add_segment(new_vertex_[std::size_t(from)], new_vertex_[std::size_t(to)]);
        old_segment_.push_back(edges[first].segment);
        if (!pslg.segment_markers.empty()) graph_.segment_markers.push_back(edges[first].marker);
      }
  }

  void add_regions(const Mesh& mesh, const Pslg& pslg, const std::vector<Given_mesh::Component>& components) {
    for (const Given_mesh::Component& component : components) {
      const int old =
          mesh.region_of_triangle.empty() ? -1 : mesh.region_of_triangle[component.first_triangle];
      typename Pslg::Region region{component.inside, 0, 0};
      if (old >= 0) region.attribute = pslg.regions[std::size_t(old)].attribute;
      if (old >= 0) region.max_area = pslg.regions[std::size_t(old)].max_area;
      graph_.regions.push_back(region);
      old_region_.push_back(old);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_KEPT_VERTICES_GRAPH_H
