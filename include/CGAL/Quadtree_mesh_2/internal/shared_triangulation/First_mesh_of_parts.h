// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The triangulated domain of a graph, made by all parts and put together at part 0.
//
// Computes: what First_triangulation.h and Domain_rule.h make in one memory, with the same bits.
// Bound:    each part has the graph, its own part of the first triangulation, and what is around that. Part 0 gets the
//           triangles of the domain, without what is outside.
// Source:   ours.
//
// Where this is of no use, nothing is changed: segments that cross, or run through a vertex that is an end of neither;
// seeds on segments; vertices at one place that are not next to each other in the order, and vertices of which many are
// near one empty circle, as on smooth curves.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_FIRST_MESH_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_FIRST_MESH_OF_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Rounds_runner.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Domain_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Graph_boxes.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Own_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Triangulation_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Exchange, class Geometry>
class First_mesh_of_parts {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Graph = Kernel_graph<Geometry>;

  /// \param graph the same at all parts
  First_mesh_of_parts(Exchange& exchange, const Graph& graph, const Domain_rule<Geometry>& rule)
      : exchange_(exchange), graph_(graph), rule_(rule), triangulation_(exchange, graph),
        domain_(exchange, triangulation_.part(), triangulation_.first_auxiliary()) {}

  /// All parts call it.
  /// \returns false, at all parts, if it was of no use
  bool run() {
    return triangulation_.run(rule_.holes, rule_.regions) &&
           domain_.run(rule_.rule, triangulation_.holes(), triangulation_.regions(),
                       [this](Vertex_id v) { return triangulation_.point(v); });
  }

  /// Puts the mesh together. All parts call it.
  /// \param mesh gets the triangles and what vertices know, at part 0, where it has the points of the graph
  void gather(Mesh& mesh, First_mesh& made) {
    gather_triangles(mesh);
    made.outer = domain_.take_outer();
    gather_edges(made);
    if (exchange_.rank() != 0) return;
    mesh.resize(graph_.number_of_vertices, mesh.triangles.size());
    for_each_index<ConcurrencyTag>(graph_.number_of_vertices, [&](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      mesh.role_of[v] = input_vertex(v), mesh.triangle_of[v] = {}, mesh.is_dirty[v] = 1;
    });
    name_first_triangles(mesh);
  }

private:
  using Triangle = typename Mesh::Triangle;

  Exchange& exchange_;
  const Graph& graph_;
  const Domain_rule<Geometry>& rule_;
  Triangulation_of_parts<ConcurrencyTag, Exchange, Geometry> triangulation_;
  Domain_of_parts<Exchange, Geometry> domain_;

  /// So many are on their way to part 0 at a time, or at least so many of each part.
  static constexpr std::size_t at_a_time_ = 1u << 17, least_ = 1u << 12;

  void gather_triangles(Mesh& mesh) {
    auto& part = triangulation_.part();
    const bool has_regions = !rule_.regions.empty();
    if (exchange_.rank() == 0) {
      const std::size_t size = part.number_of_all();
      mesh.triangles.reserve(size + size / 8); // acute corners are cut soon
      mesh.triangles.resize(size);
      mesh.region_of.resize(has_regions ? size : 0);
    }
    const std::size_t of_each = std::max(least_, at_a_time_ / static_cast<std::size_t>(exchange_.size()));
    const auto most = static_cast<std::size_t>(exchange_.max(static_cast<std::int64_t>(part.size())));
    for (std::size_t begin = 0; begin < most; begin += of_each) {
      const std::size_t end = std::min(part.size(), begin + of_each);
      Parcels outbox;
      if (begin < end) {
        Bytes bytes;
        append_bytes(bytes, part.triangles.data() + begin, (end - begin) * sizeof(Triangle));
        if (has_regions)
          append_bytes(bytes, domain_.regions().data() + begin, (end - begin) * sizeof(Region_id));
        outbox.push_back({0, std::move(bytes)});
      }
      for (const Parcel& parcel : exchange_.exchange(std::move(outbox)))
        write(parcel.bytes, static_cast<std::size_t>(part.first[std::size_t(parcel.part)]) + begin, mesh);
    }
    part.triangles = {};
  }

  static void write(const Bytes& bytes, std::size_t first, Mesh& mesh) {
    const bool has_regions = !mesh.region_of.empty();
    const std::size_t number = bytes.size() / (sizeof(Triangle) + (has_regions ? sizeof(Region_id) : 0));
    std::memcpy(static_cast<void*>(mesh.triangles.data() + first), bytes.data(), number * sizeof(Triangle));
    if (has_regions)
      std::memcpy(static_cast<void*>(mesh.region_of.data() + first), bytes.data() + number * sizeof(Triangle),
                  number * sizeof(Region_id));
  }

  /// Each vertex knows the first triangle that begins with it, or the first at it if none does.
  static void name_first_triangles(Mesh& mesh) {
    const auto name = [&](Vertex_id v, Triangle_id t) {
      if (!mesh.triangle_of[v].is_valid()) mesh.triangle_of[v] = t;
    };
    for (const Triangle_id t : mesh.triangles.ids()) name(mesh.triangle(t).v[0], t);
    for (const Triangle_id t : mesh.triangles.ids())
      name(mesh.triangle(t).v[1], t), name(mesh.triangle(t).v[2], t);
  }

  /// Part 0 gets what does not follow from its segments.
  void gather_edges(First_mesh& made) {
    auto number = static_cast<std::size_t>(exchange_.sum(std::int64_t(triangulation_.number_of_pieces())));
    Records_of_parts<Told_edge> outbox;
    outbox[0] = triangulation_.pieces();
    const std::vector<Told_edge> pieces = exchange_and_join(exchange_, std::move(outbox));
    if (exchange_.rank() != 0) return;
    for (Segment_ends& ends : made.edges.segments)
      if (ends[0] == ends[1])
        ends = {}; // it has no edge
      else
        --number;
    made.vertices_on_segments = number; // which cut them
    for (const Told_edge& p : pieces) {
      made.edges.segments[std::size_t(p.segment)] = {};
      (p.is_repeated != 0 ? made.repeated_edges : made.edges.others).push_back({p.a, p.b, p.segment});
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_FIRST_MESH_OF_PARTS_H
