// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A graph put together at one part from the slices of all.
//
// Bound:    linear time, and an exchange for each 4096 vertices, and segments, of the part with most. The first part
//           needs memory for the whole graph, for the markers and attributes of one slice, and for 4096 records of each
//           part.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_GATHER_SLICES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_GATHER_SLICES_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Pslg_slice_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>

#include <algorithm>
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

/// The bytes of a slice, but for vertices and segments.
template <class Point>
Bytes bytes_of_rest(const Pslg_slice_2<Point>& slice) {
  std::vector<Point> places;
  std::vector<std::array<double, 2>> values;
  for (const auto& r : slice.regions) places.push_back(r.point), values.push_back({r.attribute, r.max_area});
  Archive_writer archive;
  archive.points(slice.holes), archive.points(places);
  archive(values), archive(slice.vertex_attributes), archive(slice.vertex_markers);
  archive(slice.segment_markers);
  return std::move(archive.bytes);
}

/// Appends to a graph what `bytes_of_rest()` has of a slice.
template <class Point>
void append_rest(const Bytes& bytes, Pslg_2<Point>& graph) {
  std::vector<Point> holes, places;
  std::vector<std::array<double, 2>> values;
  std::vector<double> attributes;
  std::vector<int> vertex_markers, segment_markers;
  Archive_reader archive(bytes);
  archive.points(holes), archive.points(places);
  archive(values), archive(attributes), archive(vertex_markers), archive(segment_markers);
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  append(graph.holes, holes), append(graph.vertex_attributes, attributes);
  append(graph.vertex_markers, vertex_markers), append(graph.segment_markers, segment_markers);
  for (std::size_t i = 0; i < places.size(); ++i)
    graph.regions.push_back({places[i], values[i][0], values[i][1]});
}

/// Brings the records of all parts to the first one, some at a time.
/// \param own how many this part has
/// \param record gives one of them
/// \param write called at the first part with the place of each among all
template <class Record, class Exchange, class Get, class Write>
void gather_records(Exchange& exchange, std::size_t own, const Get& record, const Write& write) {
  // So few that parcels use the same memory again and again.
  constexpr std::size_t at_a_time = std::size_t(1) << 12;
  const Numbers numbers = exchange.gather(static_cast<std::int64_t>(own));
  std::vector<std::size_t> first{0};
  for (const std::int64_t n : numbers) first.push_back(first.back() + static_cast<std::size_t>(n));
  const auto most = static_cast<std::size_t>(*std::max_element(numbers.begin(), numbers.end()));
  const bool is_first = exchange.rank() == 0;
  for (std::size_t i = 0; is_first && i < own; ++i) write(i, record(i));
  if (exchange.size() == 1) return;
  for (std::size_t begin = 0; begin < most; begin += at_a_time) {
    Parcels outbox;
    if (!is_first && begin < own) {
      std::vector<Record> records;
      for (std::size_t i = begin; i < std::min(own, begin + at_a_time); ++i) records.push_back(record(i));
      outbox.push_back({0, bytes_of(records)});
    }
    for (const Parcel& parcel : exchange.exchange(std::move(outbox))) {
      std::size_t place = first[static_cast<std::size_t>(parcel.part)] + begin;
      for (const Record& r : records_of<Record>(parcel.bytes)) write(place++, r);
    }
  }
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
  agree_on_work(exchange, [&] {
    if (!is_first) return;
    graph.vertices.resize(static_cast<std::size_t>(sizes[0]));
    graph.segments.resize(static_cast<std::size_t>(sizes[1]));
  });
  using Place = Sent_coordinates<Point>;
  using Ends = std::array<std::uint32_t, 2>; // which are numbers of vertices, as has been checked
  gather_records<Place>(
      exchange, slice.vertices.size(), [&](std::size_t i) { return coordinates_to_send(slice.vertices[i]); },
      [&](std::size_t i, const Place& p) { graph.vertices[i] = Point(p[0], p[1]); });
  gather_records<Ends>(
      exchange, slice.segments.size(),
      [&](std::size_t i) {
        const auto& [a, b] = slice.segments[i];
        return Ends{{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}};
      },
      [&](std::size_t i, const Ends& ends) {
        graph.segments[i] = {Vertex_index(ends[0]), Vertex_index(ends[1])};
      });
  for (int sender = 0; sender < exchange.size(); ++sender) {
    Parcels outbox;
    agree_on_work(exchange, [&] {
      if (exchange.rank() == sender) outbox.push_back({0, bytes_of_rest(slice)});
    });
    const Parcels inbox = exchange.exchange(std::move(outbox));
    agree_on_work(exchange, [&] {
      if (is_first) append_rest(inbox.front().bytes, graph);
    });
  }
  return graph;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_GATHER_SLICES_H
