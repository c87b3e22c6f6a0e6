// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A graph put together at one part from the slices of all. Linear time; that part needs memory for the whole graph and
// one slice.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_GATHER_SLICES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_GATHER_SLICES_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Pslg_slice_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The bytes of a slice, but for its place among all.
template <class Point>
Bytes bytes_of_slice(const Pslg_slice_2<Point>& slice) {
  std::vector<Point> places;
  std::vector<std::array<double, 2>> values;
  for (const auto& r : slice.regions) places.push_back(r.point), values.push_back({r.attribute, r.max_area});
  Archive_writer archive;
  archive.points(slice.vertices), archive.points(slice.holes), archive.points(places);
  archive(values), archive(slice.vertex_attributes), archive(slice.vertex_markers);
  archive(slice.segments), archive(slice.segment_markers);
  return std::move(archive.bytes);
}

/// Appends a slice to a graph. \pre ends of segments are numbers of vertices
template <class Point>
void append_slice(const Bytes& bytes, Pslg_2<Point>& graph) {
  std::vector<Point> vertices, holes, places;
  std::vector<std::array<double, 2>> values;
  std::vector<double> attributes;
  std::vector<int> vertex_markers, segment_markers;
  std::vector<std::array<std::int64_t, 2>> segments;
  Archive_reader archive(bytes);
  archive.points(vertices), archive.points(holes), archive.points(places);
  archive(values), archive(attributes), archive(vertex_markers), archive(segments), archive(segment_markers);
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  append(graph.vertices, vertices), append(graph.holes, holes), append(graph.vertex_attributes, attributes);
  append(graph.vertex_markers, vertex_markers), append(graph.segment_markers, segment_markers);
  for (const auto& [a, b] : segments) graph.add_segment(Vertex_index(a), Vertex_index(b));
  for (std::size_t i = 0; i < places.size(); ++i)
    graph.regions.push_back({places[i], values[i][0], values[i][1]});
}

/// Throws, at all parts, the error of the first segment of all that ends where no vertex is.
template <class Exchange, class Point>
void check_ends_of_slices(Exchange& exchange, const Pslg_slice_2<Point>& slice, std::int64_t vertices) {
  const std::int64_t first_segment = exchange.exclusive_scan(std::int64_t(slice.segments.size()));
  const auto name = [&](std::int64_t i) { return std::to_string(i + std::int64_t(slice.first_number)); };
  std::exception_ptr error;
  std::int64_t culprit = first_segment;
  for (std::size_t s = 0; s < slice.segments.size() && !error; ++s)
    for (const std::int64_t v : slice.segments[s]) {
      if (error || (v >= 0 && v < vertices)) continue;
      culprit = first_segment + std::int64_t(s);
      error = std::make_exception_ptr(Pslg_error_2(
          Pslg_error_2::Kind::NO_SUCH_VERTEX,
          "segment " + name(culprit) + " ends at vertex " + name(v) +
              (vertices == 0 ? std::string(", but there are no vertices")
                             : ", but the vertices are " + name(0) + " to " + name(vertices - 1)),
          Pslg_parts_2().segment(static_cast<Segment_index>(static_cast<std::size_t>(culprit)))));
    }
  agree_on_error(exchange, error, culprit);
}

/// \returns the graph at part 0, and an empty one at others
/// \throws std::length_error if it has more vertices or segments than 32-bit indices can name, Pslg_error_2 if a
/// segment ends where no vertex is; at all parts
template <class Exchange, class Point>
Pslg_2<Point> gather_slices(Exchange& exchange, const Pslg_slice_2<Point>& slice) {
  Numbers sizes{std::int64_t(slice.vertices.size()), std::int64_t(slice.segments.size())};
  exchange.sum(sizes);
  constexpr auto limit = std::int64_t(std::numeric_limits<Vertex_index::size_type>::max());
  if (sizes[0] >= limit || sizes[1] >= limit)
    throw std::length_error("more vertices or segments than 32-bit indices can name");
  check_ends_of_slices(exchange, slice, sizes[0]);
  Pslg_2<Point> graph;
  const bool is_first = exchange.rank() == 0;
  if (is_first) {
    graph.number_of_vertex_attributes = slice.number_of_vertex_attributes;
    graph.first_number = slice.first_number;
  }
  for (int sender = 0; sender < exchange.size(); ++sender) {
    Parcels outbox;
    agree_on_work(exchange, [&] {
      if (exchange.rank() == sender) outbox.push_back({0, bytes_of_slice(slice)});
    });
    const Parcels inbox = exchange.exchange(std::move(outbox));
    agree_on_work(exchange, [&] {
      if (is_first) append_slice(inbox.front().bytes, graph);
    });
  }
  return graph;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_GATHER_SLICES_H
