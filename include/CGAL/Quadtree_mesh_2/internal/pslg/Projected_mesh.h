// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PROJECTED_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PROJECTED_MESH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Projected_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

// The mesh of a projected graph, on its way back to degrees.
//
// Free vertices go back by the inverse projection. New vertices on segments go to the place on the segment in degrees
// that has their parameter, whose image differs from where they were meshed: what that does to angles and orientations
// is looked for. The first vertices are the input's, then those that split segments before, then new ones on segments
// (this class sorts them so), then free ones.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Projected_mesh {
  using Graph = Projected_graph<Point>;
  using Place = typename Graph::Place;

public:
  /// \param graph has to outlive this.
  Projected_mesh(const Graph& graph, Indexed_mesh_2<Point> mesh)
      : graph_(graph), mesh_(std::move(mesh)), inputs_(graph.degrees().vertices.size()),
        first_new_(graph.pslg().vertices.size()) {
    sort_vertices();
    place_vertices();
  }

  struct Defects {
    std::vector<Place> places;              ///< where a split of a segment helps
    std::size_t inverted = 0;               ///< triangles that are not counterclockwise in degrees
    std::array<double, 2> first_inverted{}; ///< in degrees
    std::size_t bent = 0; ///< triangles that kept the angle where they were meshed, and no longer do
  };

  Defects find_defects(double min_angle) const {
    Defects defects;
    std::vector<bool> is_wanted(graph_.pslg().segments.size(), false);
    std::vector<std::size_t> inverted;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const bool is_inverted = !is_counterclockwise(t);
      const bool is_bent = !is_inverted && has_moved(t) && least_angle(t, images_) < min_angle &&
                           least_angle(t, mesh_.points) >= min_angle;
      if (is_inverted) inverted.push_back(t);
      if (is_bent) ++defects.bent;
      if (is_inverted || is_bent)
        for (const Vertex_index v : mesh_.triangles[t])
          if (is_on_segment(std::size_t(v)))
            is_wanted[std::size_t(mesh_.segment_of_vertex[std::size_t(v)])] = true;
    }
    for (std::size_t v = first_new_; v < first_free_; ++v)
      if (is_wanted[std::size_t(mesh_.segment_of_vertex[v])])
        defects.places.push_back(places_[v - first_new_]);
    defects.inverted = inverted.size();
    if (!inverted.empty()) add_inverted(inverted, defects);
    return defects;
  }

  /// The mesh where it was made.
  const Indexed_mesh_2<Point>& in_plane() const { return mesh_; }
  /// The images of its vertices in degrees.
  const std::vector<Point>& images() const { return images_; }

  /// The mesh of the graph in degrees.
  Indexed_mesh_2<Point> in_degrees() const {
    Indexed_mesh_2<Point> result;
    result.number_of_input_vertices = inputs_;
    const std::vector<Vertex_index> index = indices_without_unused();
    const auto add = [&](std::size_t v) {
      result.points.push_back(degrees_[v]);
      result.segment_of_vertex.push_back(segment_in_degrees(v));
      if (!mesh_.vertex_markers.empty()) result.vertex_markers.push_back(mesh_.vertex_markers[v]);
    };
    for (std::size_t v = 0; v < degrees_.size(); ++v)
      if (index[v].is_valid()) add(v);
    result.triangles = mesh_.triangles;
    for (auto& t : result.triangles)
      for (Vertex_index& v : t) v = index[std::size_t(v)];
    result.neighbors = mesh_.neighbors;
    result.region_of_triangle = mesh_.region_of_triangle;
    result.constrained_edges = mesh_.constrained_edges;
    for (auto& e : result.constrained_edges) {
      for (Vertex_index& v : e.vertices) v = index[std::size_t(v)];
      e.segment = graph_.segment_of(graph_.piece(e.segment).stretch);
      if (e.outer_vertex.is_valid() && std::size_t(e.outer_vertex) >= inputs_) e.outer_vertex = {};
    }
    return result;
  }

private:
  bool is_on_segment(std::size_t v) const { return first_new_ <= v && v < first_free_; }

  /// New vertices on segments before free ones.
  void sort_vertices() {
    std::vector<std::size_t> order;
    const auto is_free = [this](std::size_t v) { return !mesh_.segment_of_vertex[v].is_valid(); };
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (v < first_new_ || !is_free(v)) order.push_back(v);
    first_free_ = order.size();
    for (std::size_t v = first_new_; v < mesh_.points.size(); ++v)
      if (is_free(v)) order.push_back(v);
    std::vector<Vertex_index> index(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) index[order[i]] = Vertex_index(i);
    permute(order, mesh_.points), permute(order, mesh_.segment_of_vertex),
        permute(order, mesh_.vertex_markers);
    for (auto& t : mesh_.triangles)
      for (Vertex_index& v : t) v = index[std::size_t(v)];
    for (auto& e : mesh_.constrained_edges) {
      for (Vertex_index& v : e.vertices) v = index[std::size_t(v)];
      if (e.outer_vertex.is_valid()) e.outer_vertex = index[std::size_t(e.outer_vertex)];
    }
  }

  template <class T>
  static void permute(const std::vector<std::size_t>& order, std::vector<T>& values) {
    if (values.empty()) return;
    std::vector<T> result;
    result.reserve(values.size());
    for (const std::size_t i : order) result.push_back(values[i]);
    values = std::move(result);
  }

  void place_vertices() {
    degrees_ = graph_.degrees().vertices;
    for (std::size_t i = 0; i < graph_.number_of_splits(); ++i)
      degrees_.push_back(graph_.at(graph_.place(i)));
    images_.assign(mesh_.points.begin(), mesh_.points.begin() + std::ptrdiff_t(first_new_));
    for (std::size_t v = first_new_; v < first_free_; ++v) {
      places_.push_back(place_on_segment(v));
      degrees_.push_back(graph_.at(places_.back()));
      images_.push_back(graph_.forward(degrees_.back()));
    }
    for (std::size_t v = first_free_; v < mesh_.points.size(); ++v) {
      const auto p = graph_.projection().inverse(mesh_.points[v].x(), mesh_.points[v].y());
      degrees_.emplace_back(p[0], p[1]);
      images_.push_back(mesh_.points[v]);
    }
  }

  Place place_on_segment(std::size_t v) const {
    const Segment_index s = mesh_.segment_of_vertex[v];
    const auto& piece = graph_.piece(s);
    const auto& ends = graph_.pslg().segment(s);
    const Point &a = graph_.pslg().point(ends[0]), &b = graph_.pslg().point(ends[1]), &p = mesh_.points[v];
    const double x = b.x() - a.x(), y = b.y() - a.y();
    const double share = ((p.x() - a.x()) * x + (p.y() - a.y()) * y) / (x * x + y * y);
    return {piece.stretch, piece.begin + std::clamp(share, 0., 1.) * (piece.end - piece.begin)};
  }

  bool has_moved(std::size_t t) const {
    return std::any_of(mesh_.triangles[t].begin(), mesh_.triangles[t].end(),
                       [this](Vertex_index v) { return is_on_segment(std::size_t(v)); });
  }

  bool is_counterclockwise(std::size_t t) const {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const auto corner = [&](int k) {
      const Point& p = degrees_[std::size_t(mesh_.triangles[t][std::size_t(k)])];
      return Kernel::Point_2(p.x(), p.y());
    };
    return CGAL::orientation(corner(0), corner(1), corner(2)) == CGAL::LEFT_TURN;
  }

  /// In degrees.
  double least_angle(std::size_t t, const std::vector<Point>& points) const {
    double least = 180;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t i) -> const Point& {
        return points[std::size_t(mesh_.triangles[t][(k + i) % 3])];
      };
      const double ux = corner(1).x() - corner(0).x(), uy = corner(1).y() - corner(0).y();
      const double vx = corner(2).x() - corner(0).x(), vy = corner(2).y() - corner(0).y();
      least =
          std::min(least, std::atan2(ux * vy - uy * vx, ux * vx + uy * vy) * (180 / 3.14159265358979323846));
    }
    return least;
  }

  /// Halves the edges along segments of triangles that are on their other side.
  void add_inverted(const std::vector<std::size_t>& inverted, Defects& defects) const {
    std::unordered_map<std::uint64_t, Segment_index> segment_of;
    for (const auto& e : mesh_.constrained_edges)
      segment_of[unordered_pair_key(e.vertices[0], e.vertices[1])] = e.segment;
    for (const std::size_t t : inverted)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex_index a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
        const auto edge = segment_of.find(unordered_pair_key(a, b));
        if (edge == segment_of.end()) continue;
        const auto parameter = [&](Vertex_index v) {
          const auto& piece = graph_.piece(edge->second);
          if (is_on_segment(std::size_t(v))) return places_[std::size_t(v) - first_new_].parameter;
          return v == graph_.pslg().segment(edge->second)[0] ? piece.begin : piece.end;
        };
        defects.places.push_back({graph_.piece(edge->second).stretch, (parameter(a) + parameter(b)) / 2});
      }
    const Point& p = degrees_[std::size_t(mesh_.triangles[inverted.front()][0])];
    defects.first_inverted = {p.x(), p.y()};
  }

  /// Splits outside of the domain are no vertices of the mesh.
  std::vector<Vertex_index> indices_without_unused() const {
    std::vector<bool> is_used(degrees_.size(), false);
    for (const auto& t : mesh_.triangles)
      for (const Vertex_index v : t) is_used[std::size_t(v)] = true;
    std::vector<Vertex_index> index(degrees_.size());
    std::size_t n = 0;
    for (std::size_t v = 0; v < index.size(); ++v)
      if (v < inputs_ || is_used[v]) index[v] = Vertex_index(n++);
    return index;
  }

  Segment_index segment_in_degrees(std::size_t v) const {
    if (v < inputs_ || v >= first_free_) return {};
    const Place& place = v < first_new_ ? graph_.place(v - inputs_) : places_[v - first_new_];
    return graph_.segment_of(place.stretch);
  }

  const Graph& graph_;
  Indexed_mesh_2<Point> mesh_;
  std::size_t inputs_;         ///< vertices of the input, the first ones
  std::size_t first_new_;      ///< the first that the mesher made
  std::size_t first_free_ = 0; ///< the first that is on no segment
  std::vector<Place> places_;  ///< of new vertices on segments
  std::vector<Point> degrees_; ///< of all vertices
  std::vector<Point> images_;  ///< of these in the plane
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PROJECTED_MESH_H
