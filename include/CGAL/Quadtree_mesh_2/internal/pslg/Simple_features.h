// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Computes: a graph from points, lines and polygons, as in files of geographic data ("simple features").
//           Vertices at one place become one. A piece of border that two polygons share becomes one segment.
//           A component that segments enclose and no polygon covers is marked as a hole.
// Bound:    O(n log n) in practice, by one constrained Delaunay triangulation of the graph if there are
//           polygons.
// Rule:     a place is inside a polygon if it is behind an odd number of its rings, and in the domain if it
//           is inside any polygon. So an island in a lake is in the domain, whichever polygon it belongs to,
//           and so is an enclave that fills the hole of the polygon around it. Without polygons there are no
//           holes, and the domain is what lines enclose.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_SIMPLE_FEATURES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_SIMPLE_FEATURES_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Covered_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Collects features one after the other, then makes a graph from them.
class Simple_features {
public:
  using Place = std::array<double, 2>;
  using Line = std::vector<Place>;

  /// What follows belongs to a polygon, or several, whose region gets this attribute; no region if it has none.
  void set_attribute(std::optional<double> attribute) { attribute_ = attribute; }
  /// The segments that follow, of lines and of borders, have this marker. Of those with the same ends the first that
  /// is not 0 counts.
  void set_marker(int marker) { marker_ = marker; }

  void add_point(const Place& p) { add_vertex(p); }

  /// \param name a function without arguments that says which line it is
  /// \throws Pslg_error_2 if the line is a single place
  template <class Name>
  void add_line(const Line& line, const Name& name) {
    const std::uint32_t first = add_vertices(line, name);
    std::size_t segments = 0;
    for (std::uint32_t i = 1; i < line.size(); ++i)
      if (line[i - 1] != line[i]) {
        segments_.push_back({first + i - 1, first + i, no_polygon_, marker_});
        ++segments;
      }
    if (segments == 0)
      throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, name() + " has not two different places");
  }

  /// The rings added from now on are those of one new polygon.
  void begin_polygon() { attributes_.push_back(attribute_); }

  /// \param ring from the last place to the first it is closed, whether they are equal or not
  /// \param name a function without arguments that says which ring it is
  /// \throws Pslg_error_2 if the ring has not three different places
  template <class Name>
  void add_ring(const Line& ring, const Name& name) {
    const std::uint32_t first = add_vertices(ring, name);
    Line distinct = ring;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    if (distinct.size() < 3)
      throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, name() + " has not three different places");
    const auto polygon = static_cast<std::uint32_t>(attributes_.size() - 1);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t next = i + 1 < ring.size() ? i + 1 : 0;
      if (ring[i] != ring[next])
        segments_.push_back({first + static_cast<std::uint32_t>(i), first + static_cast<std::uint32_t>(next),
                             polygon, marker_});
    }
  }

  /// Vertices and segments in the order in which they came first.
  template <class Point>
  Pslg_2<Point> to_pslg() {
    merge_vertices();
    merge_segments();
    Pslg_2<Point> pslg;
    pslg.vertices.reserve(vertices_.size());
    for (const Place& p : vertices_) pslg.vertices.emplace_back(p[0], p[1]);
    pslg.segments.reserve(segments_.size());
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (i == 0 || !have_same_ends(segments_[i - 1], segments_[i]))
        pslg.add_segment(Vertex_index(segments_[i].a), Vertex_index(segments_[i].b));
    add_markers(pslg);
    if (!attributes_.empty()) mark_components(pslg);
    return pslg;
  }

private:
  /// An input segment, the polygon that it bounds, and its marker.
  struct Bounding_segment {
    std::uint32_t a, b, polygon;
    int marker;
  };
  static constexpr std::uint32_t no_polygon_ = Covered_component::no_polygon;

  static bool have_same_ends(const Bounding_segment& s, const Bounding_segment& t) {
    return std::minmax(s.a, s.b) == std::minmax(t.a, t.b);
  }

  template <class Name>
  std::uint32_t add_vertices(const Line& line, const Name& name) {
    if (vertices_.size() + line.size() >= std::numeric_limits<std::uint32_t>::max())
      throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE,
                         name() + ": more vertices than indices can name");
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const Place& p : line) add_vertex(p);
    return first;
  }
  /// Zero has two signs and is one place.
  void add_vertex(const Place& p) { vertices_.push_back({p[0] + 0., p[1] + 0.}); }

  void merge_vertices() {
    std::vector<std::uint32_t> order(vertices_.size()), place(vertices_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return vertices_[i] != vertices_[j] ? vertices_[i] < vertices_[j] : i < j;
    });
    for (std::size_t i = 0; i < order.size(); ++i) // the first at a place
      place[order[i]] =
          i > 0 && vertices_[order[i]] == vertices_[order[i - 1]] ? place[order[i - 1]] : order[i];
    std::vector<std::uint32_t> index(vertices_.size());
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
      index[i] = place[i] == i ? kept : index[place[i]];
      if (place[i] == i) vertices_[kept++] = vertices_[i];
    }
    vertices_.resize(kept);
    for (Bounding_segment& s : segments_) s = {index[s.a], index[s.b], s.polygon, s.marker};
  }

  /// Brings segments with the same ends together, behind the first of them.
  void merge_segments() {
    std::vector<std::uint32_t> order(segments_.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto ends = [&](std::uint32_t i) { return std::minmax(segments_[i].a, segments_[i].b); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      const std::pair<std::uint32_t, std::uint32_t> s = ends(i), t = ends(j);
      return s != t ? s < t : i < j;
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_first(
        order.size()); // first with these ends, itself
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool is_same = i > 0 && have_same_ends(segments_[order[i]], segments_[order[i - 1]]);
      by_first[i] = {is_same ? by_first[i - 1].first : order[i], order[i]};
    }
    std::sort(by_first.begin(), by_first.end());
    std::vector<Bounding_segment> sorted;
    sorted.reserve(by_first.size());
    for (const auto& [first, i] : by_first) sorted.push_back(segments_[i]);
    segments_ = std::move(sorted);
  }

  /// \pre segments are merged, and `pslg` has each once
  template <class Point>
  void add_markers(Pslg_2<Point>& pslg) const {
    const auto has_marker = [](const Bounding_segment& s) { return s.marker != 0; };
    if (std::none_of(segments_.begin(), segments_.end(), has_marker)) return;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (i == 0 || !have_same_ends(segments_[i - 1], segments_[i])) pslg.segment_markers.push_back(0);
      int& marker = pslg.segment_markers.back();
      if (marker == 0) marker = segments_[i].marker;
    }
  }

  /// \pre segments are merged, and `pslg` has each once
  template <class Point>
  void mark_components(Pslg_2<Point>& pslg) const {
    std::vector<Segment_of_polygon> borders;
    std::uint32_t segment = 0;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (i > 0 && !have_same_ends(segments_[i - 1], segments_[i])) ++segment;
      if (segments_[i].polygon != no_polygon_) borders.push_back({segment, segments_[i].polygon});
    }
    for (const Covered_component& c : covered_components(vertices_, pslg.segments, borders)) {
      const Point inside(c.place[0], c.place[1]);
      if (c.polygon == no_polygon_)
        pslg.holes.push_back(inside);
      else if (attributes_[c.polygon])
        pslg.regions.push_back({inside, *attributes_[c.polygon], 0});
    }
  }

  std::vector<Place> vertices_;
  std::vector<Bounding_segment> segments_;
  std::optional<double> attribute_;
  int marker_ = 0;
  std::vector<std::optional<double>> attributes_; // by polygon
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_SIMPLE_FEATURES_H
