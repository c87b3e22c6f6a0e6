// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_FLOW_GRID_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_FLOW_GRID_WRITER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Border_loops.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Grids of ADCIRC and SCHISM, which have the same form and close boundaries in different ways:
// https://adcirc.org/home/documentation/users-manual-v53/input-file-descriptions/
// adcirc-grid-and-boundary-information-file-fort-14/ and
// https://schism-dev.github.io/schism/master/input-output/hgrid.html.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

enum class Flow_grid_kind { ADCIRC, SCHISM };

/// A mesh as one file. See `IO::write_ADCIRC()` and `IO::write_GR3()`.
template <class Point>
class Flow_grid_writer {
public:
  Flow_grid_writer(const Indexed_mesh_2<Point>& mesh, Flow_grid_kind kind)
      : mesh_(mesh), kind_(kind), node_(mesh.points.size(), 0) {
    number_nodes();
  }

  std::string text() {
    out_.reserve(55 * mesh_.points.size() + 32 * mesh_.triangles.size() + 512);
    (out_ << "quadtree_mesh_2").end_line(); // a name, of at most 24 characters
    (out_ << mesh_.triangles.size() << number_of_nodes_).end_line();
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (node_[Vertex_index(v)] > 0)
        ((out_ << node_[Vertex_index(v)]).write_point(mesh_.points[v]) << 0).end_line();
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      (out_ << t + 1 << 3 << node_[a] << node_[b] << node_[c]).end_line();
    }
    write_boundaries();
    return out_.take();
  }

private:
  enum Land_type { MAINLAND = 0, ISLAND = 1 };
  struct Land_boundary {
    Land_type type;
    Border_loop nodes;
  };

  /// From 1, those of triangles only.
  void number_nodes() {
    for (const auto& t : mesh_.triangles)
      for (const Vertex_index v : t) node_[v] = 1;
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (node_[Vertex_index(v)] > 0) node_[Vertex_index(v)] = ++number_of_nodes_;
  }

  void write_boundaries() {
    const std::vector<Land_boundary> boundaries = land_boundaries();
    std::size_t nodes = 0;
    for (const Land_boundary& b : boundaries) nodes += b.nodes.size();
    (out_ << 0 << "= Number of open boundaries").end_line();
    (out_ << 0 << "= Total number of open boundary nodes").end_line();
    (out_ << boundaries.size() << "= Number of land boundaries").end_line();
    (out_ << nodes << "= Total number of land boundary nodes").end_line();
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
      const Land_boundary& b = boundaries[i];
      (out_ << b.nodes.size() << static_cast<int>(b.type) << "= Number of nodes for land boundary" << i + 1)
          .end_line();
      for (const Vertex_index v : b.nodes) (out_ << node_[v]).end_line();
    }
  }

  /// All of the mainland first, as both models want it.
  std::vector<Land_boundary> land_boundaries() const {
    const bool is_repeated = kind_ == Flow_grid_kind::ADCIRC; // the first node of a loop
    std::vector<Land_boundary> result;
    Border_loops loops = border_loops(mesh_);
    for (Border_loop& loop : loops.outer) {
      loop.push_back(loop.front());
      const auto half = loop.begin() + static_cast<std::ptrdiff_t>(is_repeated ? 0 : loop.size() / 2);
      if (!is_repeated) result.push_back({MAINLAND, Border_loop(loop.begin(), half + 1)});
      result.push_back({MAINLAND, Border_loop(half, loop.end())});
    }
    for (Border_loop& loop : loops.islands) {
      if (is_repeated) loop.push_back(loop.front());
      result.push_back({ISLAND, std::move(loop)});
    }
    return result;
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Flow_grid_kind kind_;
  Indexed_vector<Vertex_index, std::size_t> node_; // 0: none
  std::size_t number_of_nodes_ = 0;
  Line_writer out_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_FLOW_GRID_WRITER_H
