// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The mesh of the user from one that parts hold, and that is finished: no part has all of it.
//
// Computes: what kernel_mesh_to_indexed_mesh.h, Mesh_renumberer.h and distribute_mesh.h make of the whole mesh in one
//           memory, byte for byte, and the same report at the first part.
// Bound:    O(k log k) time for the k triangles and vertices that a part holds or owns; some 100 bytes for each. The
//           first part sends the graph's vertices to all.
// Method:   vertices are sorted by place across parts, then triangles by their vertices, then edges. Each goes to its
//           owner, which asks for ghosts and foreign vertices in the end (Part_completer.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_CONVERSION_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_CONVERSION_OF_PARTS_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Part_completer.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/mesh_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Bound_reporter.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Stowable_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Triangles_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Vertices_of_parts.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What the first part knows of the input. Others have one that is empty.
template <class Point>
struct Input_of_parts {
  const Stowable_graph<Point>& graph;
  const Order& order; ///< the input vertex of each of the kernel
};

template <class Exchange, class Traits>
class Conversion_of_parts {
public:
  using Geometry = Mesher_geometry<Traits>;
  using Point_2 = typename Traits::Point_2;
  using Map = Coordinate_map<Traits, Geometry>;
  using Held = Held_mesh<Exchange, Geometry>;
  using Mesh = Distributed_mesh_2<Point_2>;

  Conversion_of_parts(Exchange& exchange, Meshing_state<Geometry>& state, Held& held, const Map& map,
                      const Input_of_parts<Point_2>& input)
      : exchange_(exchange), state_(state), held_(held), map_(map), input_(input),
        vertices_(exchange, state, held), triangles_(exchange, state, held, vertices_) {}

  /// This part's own triangles, vertices and edges; the mesh in the kernel's form is freed, and so is the graph. All
  /// parts call it.
  /// \param account of this part's triangles
  /// \param report is filled in at the first part
  Mesh run(const Triangle_account& account, Quality_mesh_report_2& report) {
    held_.unshare();
    vertices_.collect(input().vertex_markers, input_.order,
                      [this](const auto& p) { return map_.to_user(p); });
    state_.problem.forget_points(), held_.forget_known_points();
    vertices_.find_numbers();
    vertices_.ask_for_held();
    const std::int64_t used = number_of_own_used_vertices();
    const Suspects suspects = look_at(account.suspects);
    forget_places();
    triangles_.find_numbers();
    count(account, used, report);
    report_suspects(suspects, report);
    vertices_.offer(triangles_.find_edges(segment_markers()));
    state_.mesh.role_of = {};
    state_.problem.forget_graph();
    vertices_.ask_for(triangles_.outer_vertices());
    Mesh part = description();
    ship_outside_segments(part);
    triangles_.ship_edges(part);
    triangles_.ship(part);
    state_.mesh = Kernel_mesh<Geometry>();
    find_first_vertices(part);
    vertices_.ship(part);
    return part;
  }

private:
  /// What is told of a triangle that misses a bound.
  struct Unmet {
    Triangle_id handle;
    Quality_mesh_report_2::Unmet_triangle entry;
  };
  struct Exempt {
    Triangle_id handle;
    std::uint32_t number;
    Vertex_id corner;
  };
  struct Suspects {
    std::vector<Unmet> unmet;
    std::vector<Exempt> exempt;
  };

  Exchange& exchange_;
  Meshing_state<Geometry>& state_;
  Held& held_;
  const Map& map_;
  Input_of_parts<Point_2> input_;
  Vertices_of_parts<Exchange, Point_2, Geometry> vertices_;
  Triangles_of_parts<Exchange, Point_2, Geometry> triangles_;

  /// Perhaps without vertices and segments.
  const Pslg_2<Point_2>& input() const { return input_.graph.graph(); }

  bool is_first() const { return exchange_.rank() == 0; }

  /// All parts have those of the graph.
  std::vector<int> segment_markers() {
    Bytes bytes;
    if (is_first()) bytes = bytes_of(input().segment_markers);
    exchange_.broadcast(bytes, 0);
    return records_of<int>(bytes);
  }

  // ---- the report

  std::int64_t number_of_own_used_vertices() const {
    std::int64_t used = 0;
    for (const Vertex_id v : state_.mesh.points.ids()) used += held_.speaks_for(v) ? 1 : 0;
    return used;
  }

  void count(const Triangle_account& account, std::int64_t used, Quality_mesh_report_2& report) {
    std::array<std::size_t, 60> least{};
    std::array<std::size_t, 120> largest{};
    account.angles.add_to(least, largest);
    Numbers numbers(least.begin(), least.end());
    numbers.insert(numbers.end(), largest.begin(), largest.end());
    numbers.push_back(used);
    exchange_.sum(numbers);
    // What flips take away may be more than the first part has: counts are right by modulus.
    const auto right = [&](std::size_t i) { return std::size_t(static_cast<std::uint32_t>(numbers[i])); };
    for (std::size_t i = 0; i < least.size(); ++i) report.least_angle_histogram[i] += right(i);
    for (std::size_t i = 0; i < largest.size(); ++i)
      report.largest_angle_histogram[i] += right(least.size() + i);
    report.vertices = static_cast<std::size_t>(numbers.back());
    report.triangles = static_cast<std::size_t>(triangles_.number_of_all());
  }

  /// Triangles that miss a bound, but for their numbers.
  Suspects look_at(const std::vector<Triangle_id>& triangles) const {
    const Bound_reporter<Traits> reporter(state_, map_, std::nullopt);
    Suspects suspects;
    for (const Triangle_id t : triangles)
      if (reporter.is_excused(t))
        suspects.exempt.push_back({t, 0, reporter.excusing_corner(t)});
      else
        suspects.unmet.push_back({t, reporter.unmet(t, Triangle_index(), Edge_id())});
    return suspects;
  }

  /// In the order of handles, as one memory lists them.
  void report_suspects(const Suspects& suspects, Quality_mesh_report_2& report) {
    Records_of_parts<Unmet> unmet;
    Records_of_parts<Exempt> exempt;
    for (Unmet u : suspects.unmet) {
      u.entry.triangle = Triangle_index(triangles_.number(u.handle));
      unmet[0].push_back(u);
    }
    for (Exempt e : suspects.exempt) {
      e.number = triangles_.number(e.handle);
      exempt[0].push_back(e);
    }
    for (const Exempt& e : in_order(exchange_and_join(exchange_, std::move(exempt))))
      report.exempt_triangles.push_back(
          {Triangle_index(e.number), Vertex_index(input_.order[e.corner.value()])});
    for (const Unmet& u : in_order(exchange_and_join(exchange_, std::move(unmet))))
      report.unmet_triangles.push_back(u.entry);
  }

  /// Of the mesh, only the names of triangles' vertices and edges are asked for from now on.
  void forget_places() {
    Kernel_mesh<Geometry>& mesh = state_.mesh;
    mesh.points = {}, mesh.triangle_of = {}, mesh.is_dirty = {};
  }

  template <class Record>
  static std::vector<Record> in_order(std::vector<Record> records) {
    std::sort(records.begin(), records.end(),
              [](const Record& a, const Record& b) { return a.handle < b.handle; });
    return records;
  }

  // ---- what all parts know

  /// All that is the same at all parts but for `first_vertex`.
  Mesh description() {
    Mesh part;
    if (is_first()) {
      part.number_of_input_vertices = static_cast<std::int64_t>(input_.order.size());
      part.has_regions = !state_.mesh.region_of.empty();
      part.legend.regions = input().regions;
      part.legend.region_names = input().region_names;
      part.legend.marker_names = input().marker_names;
    }
    Bytes bytes = bytes_of_mesh(part);
    exchange_.broadcast(bytes, 0);
    part = mesh_of_bytes<Point_2>(bytes);
    part.rank = exchange_.rank();
    part.has_vertex_markers = part.has_input_index = part.has_neighbors = part.has_segment_of_vertex = true;
    const Triangle_runs runs = this->runs();
    part.first_triangle.assign(static_cast<std::size_t>(exchange_.size()) + 1, triangles_.number_of_all());
    for (std::size_t run = 0; run < runs.size(); ++run)
      part.first_triangle[run] = static_cast<std::int64_t>(runs.begin(run));
    return part;
  }

  Triangle_runs runs() const {
    return {static_cast<std::size_t>(triangles_.number_of_all()), static_cast<std::size_t>(exchange_.size())};
  }

  /// A part's first vertex is behind the least one of the last triangle before it, at which that one begins.
  void find_first_vertices(Mesh& part) {
    const Numbers behind_last = exchange_.gather(part.triangles.empty() ? 0 : part.triangles.back()[0] + 1);
    part.first_vertex.assign(static_cast<std::size_t>(exchange_.size()) + 1, vertices_.number_of_all());
    part.first_vertex[0] = 0;
    for (std::size_t run = 1; run < runs().size(); ++run) part.first_vertex[run] = behind_last[run - 1];
  }

  // ---- segments of which nothing is in the mesh

  /// The first part finds them, and the last one with triangles has them.
  void ship_outside_segments(Mesh& part) {
    Parcels outbox;
    outbox.push_back({0, triangles_.segments_with_edges()});
    std::vector<char> bits;
    for (const Parcel& parcel : exchange_.exchange(std::move(outbox))) {
      bits.resize(std::max(bits.size(), parcel.bytes.size()), 0);
      for (std::size_t i = 0; i < parcel.bytes.size(); ++i)
        bits[i] = static_cast<char>(bits[i] | parcel.bytes[i]);
    }
    using Outside = typename Mesh::Outside_segment;
    std::vector<Outside> outside;
    std::vector<Vertex_id> ends;
    if (is_first()) outside = outside_segments(bits, ends);
    vertices_.ask_for(ends);
    for (std::size_t i = 0; i < ends.size(); ++i) outside[i / 2].vertices[i % 2] = vertices_.number(ends[i]);
    part.number_of_outside_segments = exchange_.sum(static_cast<std::int64_t>(outside.size()));
    Records_of_parts<Outside> told;
    if (!outside.empty()) told[static_cast<int>(runs().size()) - 1] = std::move(outside);
    part.outside_segments = exchange_and_join(exchange_, std::move(told));
  }

  /// \param bits of the segments with edges
  /// \param ends become the kernel's vertices at their ends, two for each
  std::vector<typename Mesh::Outside_segment> outside_segments(const std::vector<char>& bits,
                                                               std::vector<Vertex_id>& ends) const {
    std::vector<typename Mesh::Outside_segment> outside;
    std::size_t with_edges = 0;
    for (const char byte : bits) with_edges += std::bitset<8>(static_cast<unsigned char>(byte)).count();
    if (with_edges == input_.graph.number_of_segments()) return outside;
    const std::vector<int>& markers = input().segment_markers;
    const auto segments = input_.graph.segments();
    for (std::size_t s = 0; s < segments.size(); ++s) {
      if (s / 8 < bits.size() && (bits[s / 8] >> s % 8 & 1) != 0) continue;
      const std::int64_t marker = markers.empty() ? 0 : markers[s];
      outside.push_back({{-1, -1}, static_cast<std::int64_t>(s), marker});
    }
    if (outside.empty()) return outside;
    std::vector<Vertex_id> vertex_of_input(input_.order.size());
    for (std::size_t v = 0; v < input_.order.size(); ++v) vertex_of_input[input_.order[v]] = Vertex_id(v);
    for (const auto& s : outside)
      for (const Vertex_index v : segments[static_cast<std::size_t>(s.segment)])
        ends.push_back(vertex_of_input[std::size_t(v)]);
    return outside;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_CONVERSION_OF_PARTS_H
