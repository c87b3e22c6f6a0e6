// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A mesh of one part given to all parts, and put together again at one of them.
//
// Bound: as for Mesh_cutter.h; the part that has the mesh also has up to 256 MB, or one other part, on its way. Its own
//        part comes last, when nothing is on its way.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_DISTRIBUTE_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_DISTRIBUTE_MESH_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_cutter.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// See `CGAL::distribute_mesh_2()`.
/// \param batch parts are sent together up to so many bytes, at least one part
template <class Exchange, class Point>
Distributed_mesh_2<Point> distribute_mesh(Exchange& exchange, const Indexed_mesh_2<Point>& mesh,
                                          const Pslg_2<Point>& pslg, int root,
                                          std::size_t batch = std::size_t(1) << 28) {
  const bool is_root = exchange.rank() == root;
  std::unique_ptr<Mesh_cutter<Point>> cutter;
  agree_on_work(exchange, [&] {
    if (is_root) cutter = std::make_unique<Mesh_cutter<Point>>(mesh, pslg, exchange.size());
  });
  Distributed_mesh_2<Point> part;
  for (int next = 0; exchange.max(is_root ? next : 0) < exchange.size();) {
    Parcels outbox;
    agree_on_work(exchange, [&] {
      for (std::size_t bytes = 0; is_root && next < exchange.size() && bytes < batch; ++next) {
        if (next == root) continue;
        outbox.push_back({next, bytes_of_mesh(cutter->part(next))});
        bytes += outbox.back().bytes.size();
      }
    });
    const Parcels inbox = exchange.exchange(std::move(outbox));
    agree_on_work(exchange, [&] {
      if (!inbox.empty()) part = mesh_of_bytes<Point>(inbox.front().bytes);
    });
  }
  agree_on_work(exchange, [&] {
    if (is_root) part = cutter->part(root);
  });
  return part;
}

/// Puts a mesh together from its parts.
template <class Point>
class Mesh_gatherer {
public:
  using Part = Distributed_mesh_2<Point>;
  using Number = typename Part::Number;

  /// Makes room for the whole mesh.
  explicit Mesh_gatherer(const Part& part) {
    const auto vertices = static_cast<std::size_t>(part.number_of_vertices()),
               triangles = static_cast<std::size_t>(part.number_of_triangles());
    mesh_.number_of_input_vertices = static_cast<std::size_t>(part.number_of_input_vertices);
    mesh_.points.reserve(vertices);
    mesh_.triangles.reserve(triangles);
    mesh_.constrained_edges.resize(static_cast<std::size_t>(part.number_of_constrained_edges));
  }

  /// \pre parts come in their order
  void add(const Part& part) {
    for (std::size_t v = 0; v < part.number_of_own_vertices(); ++v) {
      mesh_.points.push_back(part.points[v]);
      if (part.has_vertex_markers) mesh_.vertex_markers.push_back(part.vertex_markers[v]);
      if (part.has_input_index) mesh_.input_index.push_back(index<Vertex_index>(part.input_index[v]));
      if (part.has_segment_of_vertex)
        mesh_.segment_of_vertex.push_back(index<Segment_index>(part.segment_of_vertex[v]));
    }
    for (std::size_t t = 0; t < part.number_of_own_triangles(); ++t) {
      mesh_.triangles.push_back(indices<Vertex_index>(part.triangles[t]));
      if (part.has_neighbors) mesh_.neighbors.push_back(indices<Triangle_index>(part.neighbors[t]));
      if (part.has_regions) mesh_.region_of_triangle.push_back(part.region_of_triangle[t]);
    }
    for (const auto& e : part.constrained_edges)
      mesh_.constrained_edges[static_cast<std::size_t>(e.number)] = {
          indices<Vertex_index>(e.vertices), index<Segment_index>(e.segment), static_cast<int>(e.marker),
          index<Vertex_index>(e.outer_vertex)};
  }
  Indexed_mesh_2<Point> take() { return std::move(mesh_); }

private:
  template <class Id>
  static Id index(Number i) {
    return i < 0 ? Id() : Id(i);
  }
  template <class Id, std::size_t n>
  static std::array<Id, n> indices(const std::array<Number, n>& numbers) {
    std::array<Id, n> result;
    std::transform(numbers.begin(), numbers.end(), result.begin(), index<Id>);
    return result;
  }

  Indexed_mesh_2<Point> mesh_;
};

/// See `CGAL::gather_mesh_2()`. One part is on its way at a time.
template <class Exchange, class Point>
Indexed_mesh_2<Point> gather_mesh(Exchange& exchange, const Distributed_mesh_2<Point>& part, int root) {
  constexpr auto most = static_cast<std::int64_t>(std::numeric_limits<std::uint32_t>::max());
  const bool is_root = exchange.rank() == root;
  std::unique_ptr<Mesh_gatherer<Point>> gatherer;
  agree_on_work(exchange, [&] {
    if (part.number_of_vertices() >= most || part.number_of_triangles() >= most)
      throw std::length_error("a mesh of one rank has fewer than 2^32 - 1 vertices and triangles");
    if (is_root) gatherer = std::make_unique<Mesh_gatherer<Point>>(part);
  });
  for (int sender = 0; sender < exchange.size(); ++sender) {
    Parcels outbox;
    agree_on_work(exchange, [&] {
      if (exchange.rank() == sender) outbox.push_back({root, bytes_of_mesh(part)});
    });
    const Parcels inbox = exchange.exchange(std::move(outbox));
    agree_on_work(exchange, [&] {
      if (is_root) gatherer->add(mesh_of_bytes<Point>(inbox.front().bytes));
    });
  }
  return is_root ? gatherer->take() : Indexed_mesh_2<Point>();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_DISTRIBUTE_MESH_H
