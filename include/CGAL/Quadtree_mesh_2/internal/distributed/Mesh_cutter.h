// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Cuts a mesh into what ranks hold of it.
//
// Computes: runs of triangles in the order of the mesh, all of the same length or one more, as pieces and parts of
//           files are cut (file_parts/mesh_pieces.h). A vertex belongs to the first run with a triangle that begins at
//           it, so a rank owns a run of vertices, too: those behind the greatest least vertex of the triangles before.
// Bound:    O(T + e log e + b log b) for T triangles, e constrained edges, and b triangles at vertices of several
//           ranks; then O(k log k) for a part of k triangles and vertices.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_CUTTER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_CUTTER_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/Ghost_layers.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/mesh_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtk_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/io/triangles_at_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Mesh_cutter {
public:
  using Part = Distributed_mesh_2<Point>;
  using Number = typename Part::Number;

  /// Keeps references.
  /// \throws std::invalid_argument if triangles are not in the order of their least vertices
  Mesh_cutter(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, int ranks)
      : mesh_(mesh), runs_(mesh.triangles.size(), static_cast<std::size_t>(ranks)) {
    check_order();
    ghosts_ = std::make_unique<Ghost_layers<Point>>(mesh, runs_);
    outside_ = outside_segments(mesh, pslg);
    describe_whole(pslg, static_cast<std::size_t>(ranks));
    edges_of_run_.resize(runs_.size());
    const auto triangles = triangles_at_edges(mesh);
    for (std::size_t e = 0; e < triangles.size(); ++e)
      edges_of_run_[triangles[e][0] == no_triangle ? runs_.size() - 1 : runs_.run_of(triangles[e][0])]
          .push_back(e);
  }

  /// What a rank holds.
  Part part(int rank) const {
    Part part = whole_;
    part.rank = rank;
    const auto run = static_cast<std::size_t>(rank);
    if (run >= runs_.size()) return part;
    const std::size_t own = runs_.begin(run + 1) - runs_.begin(run);
    const std::vector<std::size_t>& ghosts = ghosts_->of_run(run);
    part.triangles.reserve(own + ghosts.size());
    if (whole_.has_regions) part.region_of_triangle.reserve(own + ghosts.size());
    for (std::size_t t = runs_.begin(run); t < runs_.begin(run + 1); ++t) add_triangle(part, t);
    if (whole_.has_neighbors) {
      part.neighbors.reserve(own);
      for (std::size_t t = runs_.begin(run); t < runs_.begin(run + 1); ++t)
        part.neighbors.push_back(numbers_of(mesh_.neighbors[t]));
    }
    for (const std::size_t t : ghosts) {
      part.ghost_triangles.push_back(static_cast<Number>(t));
      add_triangle(part, t);
    }
    part.constrained_edges.reserve(edges_of_run_[run].size());
    for (const std::size_t e : edges_of_run_[run]) part.constrained_edges.push_back(edge(e));
    if (run + 1 == runs_.size())
      for (const Outside_segment& s : outside_)
        part.outside_segments.push_back({numbers_of(s.ends), static_cast<Number>(s.segment), s.marker});
    find_foreign_vertices(part);
    reserve_vertices(part);
    for (Number v = part.first_vertex[run]; v < part.first_vertex[run + 1]; ++v) add_vertex(part, v);
    for (const Number v : part.foreign_vertices) add_vertex(part, v);
    return part;
  }

private:
  void check_order() const {
    for (std::size_t t = 1; t < mesh_.triangles.size(); ++t)
      if (least_vertex(t) < least_vertex(t - 1))
        throw std::invalid_argument("triangle " + std::to_string(t) +
                                    " is not in the order of least vertices; renumber_by_place() makes it");
  }
  Vertex_index least_vertex(std::size_t t) const {
    return *std::min_element(mesh_.triangles[t].begin(), mesh_.triangles[t].end());
  }

  void describe_whole(const Pslg_2<Point>& pslg, std::size_t ranks) {
    whole_.first_vertex.assign(ranks + 1, static_cast<Number>(mesh_.points.size()));
    whole_.first_triangle.assign(ranks + 1, static_cast<Number>(mesh_.triangles.size()));
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      const std::size_t begin = runs_.begin(run);
      whole_.first_triangle[run] = static_cast<Number>(begin);
      whole_.first_vertex[run] = begin == 0 ? 0 : number_of(least_vertex(begin - 1)) + 1;
    }
    whole_.number_of_constrained_edges = static_cast<Number>(mesh_.constrained_edges.size());
    whole_.number_of_outside_segments = static_cast<Number>(outside_.size());
    whole_.number_of_input_vertices = static_cast<Number>(mesh_.number_of_input_vertices);
    whole_.has_regions = !mesh_.region_of_triangle.empty();
    whole_.has_vertex_markers = !mesh_.vertex_markers.empty();
    whole_.has_input_index = !mesh_.input_index.empty();
    whole_.has_neighbors = !mesh_.neighbors.empty();
    whole_.has_segment_of_vertex = !mesh_.segment_of_vertex.empty();
    whole_.legend.regions = pslg.regions;
    whole_.legend.region_names = pslg.region_names, whole_.legend.marker_names = pslg.marker_names;
  }

  template <class Tag>
  static Number number_of(Index<Tag> i) {
    return i.is_valid() ? static_cast<Number>(i.value()) : -1;
  }
  template <class Tag, std::size_t n>
  static std::array<Number, n> numbers_of(const std::array<Index<Tag>, n>& list) {
    std::array<Number, n> numbers;
    std::transform(list.begin(), list.end(), numbers.begin(), [](Index<Tag> i) { return number_of(i); });
    return numbers;
  }

  void reserve_vertices(Part& part) const {
    const std::size_t n = part.number_of_own_vertices() + part.foreign_vertices.size();
    part.points.reserve(n);
    if (whole_.has_vertex_markers) part.vertex_markers.reserve(n);
    if (whole_.has_input_index) part.input_index.reserve(n);
    if (whole_.has_segment_of_vertex) part.segment_of_vertex.reserve(n);
  }
  void add_triangle(Part& part, std::size_t t) const {
    part.triangles.push_back(numbers_of(mesh_.triangles[t]));
    if (whole_.has_regions) part.region_of_triangle.push_back(mesh_.region_of_triangle[t]);
  }
  void add_vertex(Part& part, Number number) const {
    const auto v = static_cast<std::size_t>(number);
    part.points.push_back(mesh_.points[v]);
    if (whole_.has_vertex_markers) part.vertex_markers.push_back(mesh_.vertex_markers[v]);
    if (whole_.has_input_index) part.input_index.push_back(number_of(mesh_.input_index[v]));
    if (whole_.has_segment_of_vertex) part.segment_of_vertex.push_back(number_of(mesh_.segment_of_vertex[v]));
  }
  typename Part::Constrained_edge edge(std::size_t e) const {
    const auto& edge = mesh_.constrained_edges[e];
    return {static_cast<Number>(e), numbers_of(edge.vertices), number_of(edge.segment),
            number_of(edge.outer_vertex), edge.marker};
  }

  static void find_foreign_vertices(Part& part) {
    std::vector<Number>& foreign = part.foreign_vertices;
    const auto add = [&](const auto& vertices) {
      for (const Number v : vertices)
        if (!part.is_own_vertex(v)) foreign.push_back(v);
    };
    for (const auto& t : part.triangles) add(t);
    for (const auto& e : part.constrained_edges) add(e.vertices);
    for (const auto& s : part.outside_segments) add(s.vertices);
    std::sort(foreign.begin(), foreign.end());
    foreign.erase(std::unique(foreign.begin(), foreign.end()), foreign.end());
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Triangle_runs runs_;
  std::unique_ptr<Ghost_layers<Point>> ghosts_;
  std::vector<Outside_segment> outside_;
  std::vector<std::vector<std::size_t>> edges_of_run_;
  Part whole_; // what all parts have
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_CUTTER_H
