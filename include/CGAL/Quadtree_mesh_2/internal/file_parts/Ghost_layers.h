// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_GHOST_LAYERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_GHOST_LAYERS_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/mesh_pieces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// For each run of triangles the triangles of other runs that have a vertex with it in common: what a solver needs to
/// make all rows of its own vertices. O(T + b log b) for T triangles, of which b are at vertices of several runs.
template <class Point>
class Ghost_layers {
public:
  Ghost_layers(const Indexed_mesh_2<Point>& mesh, const Triangle_runs& runs) {
    Indexed_vector<Vertex_index, char> is_shared = shared_vertices(mesh, runs);
    std::vector<std::pair<Vertex_index, std::size_t>> corners; // at shared vertices, with their triangles
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const Vertex_index v : mesh.triangles[t])
        if (is_shared[v] != 0) corners.push_back({v, t});
    std::sort(corners.begin(), corners.end());
    std::vector<std::vector<std::size_t>> layers(runs.size());
    for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
      while (end < corners.size() && corners[end].first == corners[begin].first) ++end;
      add_around_vertex(corners.data() + begin, corners.data() + end, runs, layers);
    }
    for (auto& layer : layers) {
      std::sort(layer.begin(), layer.end());
      layer.erase(std::unique(layer.begin(), layer.end()), layer.end());
    }
    layers_ = std::move(layers);
  }

  /// In their order.
  const std::vector<std::size_t>& of_run(std::size_t run) const { return layers_[run]; }

private:
  static Indexed_vector<Vertex_index, char> shared_vertices(const Indexed_mesh_2<Point>& mesh,
                                                            const Triangle_runs& runs) {
    constexpr auto none = static_cast<std::uint32_t>(-1);
    Indexed_vector<Vertex_index, std::uint32_t> first_run(mesh.points.size(), none);
    Indexed_vector<Vertex_index, char> is_shared(mesh.points.size(), 0);
    for (std::uint32_t run = 0; run < runs.size(); ++run)
      for (std::size_t t = runs.begin(run); t < runs.begin(run + 1); ++t)
        for (const Vertex_index v : mesh.triangles[t]) {
          if (first_run[v] == none) first_run[v] = run;
          if (first_run[v] != run) is_shared[v] = 1;
        }
    return is_shared;
  }

  /// Triangles come in their order, so those of a run are together.
  static void add_around_vertex(const std::pair<Vertex_index, std::size_t>* begin,
                                const std::pair<Vertex_index, std::size_t>* end, const Triangle_runs& runs,
                                std::vector<std::vector<std::size_t>>& layers) {
    std::vector<std::size_t> runs_here;
    for (auto corner = begin; corner != end; ++corner) {
      const std::size_t run = runs.run_of(corner->second);
      if (runs_here.empty() || runs_here.back() != run) runs_here.push_back(run);
    }
    for (auto corner = begin; corner != end; ++corner)
      for (const std::size_t run : runs_here)
        if (run != runs.run_of(corner->second)) layers[run].push_back(corner->second);
  }

  std::vector<std::vector<std::size_t>> layers_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_GHOST_LAYERS_H
