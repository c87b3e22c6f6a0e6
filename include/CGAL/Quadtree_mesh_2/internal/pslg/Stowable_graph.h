// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A graph whose vertices and segments take little memory while nobody reads them.
//
// Computes: the same graph again, bit for bit.
// Bound:    O(n). A stowed segment takes 2 bytes where one begins at the end of the one before it and ends at the next
//           vertex, as in chains, and 10 bytes at most. Vertices take none.
// Method:   whoever works on the graph has the places of vertices in an order of his own, from which they are taken.
//           Segments are kept as differences of vertex numbers, in as many bytes as each needs.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_STOWABLE_GRAPH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_STOWABLE_GRAPH_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Stowable_graph {
public:
  using Pslg = Pslg_2<Point>;
  using Segment = typename Pslg::Segment;

  /// A graph owned by the caller, which has to outlive this. It is never stowed.
  Stowable_graph(const Pslg& graph) : of_other_(&graph) {}
  /// A graph that may be stowed.
  Stowable_graph(Pslg&& graph) : own_(std::move(graph)) {}

  /// The graph; without vertices and segments while it is stowed.
  const Pslg& graph() const { return own_ ? *own_ : *of_other_; }
  bool is_stowed() const { return number_of_segments_.has_value(); }
  /// How many segments there are, stowed or not.
  std::size_t number_of_segments() const { return number_of_segments_.value_or(graph().segments.size()); }
  /// The segments, stowed or not.
  std::vector<Segment> segments() const { return is_stowed() ? stowed_segments() : graph().segments; }

  /// Lets go of vertices and segments, if it may.
  void stow() {
    if (!own_ || is_stowed()) return;
    bytes_.clear();
    bytes_.reserve(2 * own_->segments.size());
    std::int64_t before = 0;
    for (const Segment& segment : own_->segments)
      for (const auto v : segment) {
        const auto number = static_cast<std::int64_t>(std::size_t(v));
        append(number - std::exchange(before, number));
      }
    bytes_.shrink_to_fit();
    number_of_segments_ = own_->segments.size();
    free_arrays(own_->segments, own_->vertices);
  }

  /// Has vertices and segments again, if they are stowed.
  /// \param order the number in the graph of each vertex of whoever has the places
  /// \param place_of called with the index of a vertex there
  template <class Order, class Place_of>
  void take_out(const Order& order, const Place_of& place_of) {
    if (!is_stowed()) return;
    own_->vertices.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) own_->vertices[order[i]] = place_of(i);
    own_->segments = stowed_segments();
    free_arrays(bytes_);
    number_of_segments_.reset();
  }

private:
  using Vertex_index = typename Pslg::Vertex_index;

  std::optional<Pslg> own_;
  const Pslg* of_other_ = nullptr;
  std::optional<std::size_t> number_of_segments_; // while they are stowed
  /// Numbers in groups of 7 bits, the least significant first; an eighth bit says that another group follows.
  std::vector<unsigned char> bytes_;

  /// Small differences become small numbers: the lowest bit is the sign.
  void append(std::int64_t difference) {
    auto left = static_cast<std::uint64_t>(difference < 0 ? -(difference + 1) : difference) << 1 |
                static_cast<std::uint64_t>(difference < 0);
    for (; left > 127; left >>= 7) bytes_.push_back(static_cast<unsigned char>(left | 128));
    bytes_.push_back(static_cast<unsigned char>(left));
  }

  std::vector<Segment> stowed_segments() const {
    std::vector<Segment> segments;
    segments.reserve(*number_of_segments_);
    std::int64_t number = 0;
    auto next = bytes_.begin();
    const auto next_vertex = [&] {
      std::uint64_t read = 0;
      for (int shift = 0;; shift += 7) {
        const std::uint64_t byte = *next++;
        read |= (byte & 127) << shift;
        if (byte < 128) break;
      }
      const auto magnitude = static_cast<std::int64_t>(read >> 1);
      number += (read & 1) != 0 ? -magnitude - 1 : magnitude;
      return Vertex_index(static_cast<std::size_t>(number));
    };
    while (segments.size() < *number_of_segments_) {
      const Vertex_index a = next_vertex(), b = next_vertex();
      segments.push_back({a, b});
    }
    return segments;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_STOWABLE_GRAPH_H
