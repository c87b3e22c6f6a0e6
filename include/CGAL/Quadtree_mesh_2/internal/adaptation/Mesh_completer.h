// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Triangles made a mesh with all arrays, and the graph that it is a mesh of. See `pslg_from_mesh_2()`.
//
// Computes: triangles that meet at whole sides (Conforming_triangles.h), neighbors, constrained edges (the border,
//           those between attributes and those named), regions, and the graph with a place in each hole.
// Bound:    O(k log k) time for k triangles, expected.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_MESH_COMPLETER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_MESH_COMPLETER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/given_mesh_types.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Conforming_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Hole_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Kept_vertices_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Straight_legs.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/edge_key.h>
#include <CGAL/Quadtree_mesh_2/internal/output/boundary_markers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Mesh_completer {
public:
  using Point = Triangle_tree::Point;
  using Mesh = Indexed_mesh_2<Point>;
  using Pslg = Pslg_2<Point>;

  Mesh_completer(Mesh& mesh, const Given_mesh_details_2& details) : mesh_(mesh), details_(details) {}

  Pslg complete() {
    check_lengths();
    made_.points = mesh_.points, made_.vertex_markers = mesh_.vertex_markers;
    std::optional<Given_mesh> checked(std::in_place, mesh_, details_.first_number);
    if (checked->touches().are_none()) {
      made_.triangles = mesh_.triangles;
    } else {
      conforming_.emplace(mesh_, checked->neighbors(), checked->touches());
      made_.triangles = conforming_->triangles();
      checked.emplace(made_, details_.first_number);
    }
    const Given_mesh& given = *checked;
    made_.neighbors = given.neighbors();
    find_constrained_edges();
    auto holes = Hole_finder(given).places();
    std::vector<int> component_of;
    std::vector<Given_mesh::Component> components;
    if (!details_.attributes.empty())
      components = given.components(
          [this](Vertex_index a, Vertex_index b) { return edge_of_.count(edge_key(a, b)) > 0; },
          component_of);
    Pslg pslg = name_input(components);
    pslg.holes = std::move(holes);
    pslg.first_number = details_.first_number;
    pslg.regions.clear();
    if (!details_.attributes.empty()) {
      for (const auto& c : components) pslg.regions.push_back({c.inside, attribute(c.first_triangle), 0});
      made_.region_of_triangle = std::move(component_of);
    }
    mesh_ = std::move(made_);
    return pslg;
  }

  /// Per triangle of the mesh that was made, the given one that it is a piece of.
  /// \pre `complete()` is done
  std::vector<Triangle_index> given_triangle() const {
    if (conforming_) return conforming_->origin();
    std::vector<Triangle_index> same;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) same.push_back(Triangle_index(t));
    return same;
  }

private:
  using Kind = Pslg_error_2::Kind;
  using Ends = std::array<Vertex_index, 2>;

  Mesh& mesh_;
  const Given_mesh_details_2& details_;
  Mesh made_;
  std::optional<Conforming_triangles> conforming_; // if the given ones are not
  std::vector<Ends> border_;
  std::unordered_map<std::uint64_t, std::size_t> edge_of_; // constrained edges by their keys

  std::string number(std::size_t i) const { return std::to_string(details_.first_number + i); }

  void check_lengths() const {
    const auto check = [](std::size_t length, std::size_t wanted, const char* of, const char* for_what) {
      if (length != 0 && length != wanted)
        throw Pslg_error_2(Kind::ARRAY_LENGTH,
                           "there are " + std::to_string(length) + of + std::to_string(wanted) + for_what);
    };
    check(details_.attributes.size(), mesh_.triangles.size(), " attributes for ", " triangles");
    check(details_.segment_markers.size(), details_.segments.size(), " markers for ", " segments");
    check(mesh_.vertex_markers.size(), mesh_.points.size(), " markers for ", " vertices");
    check(details_.is_input.size(), mesh_.points.size(), " marks of input for ", " vertices");
    for (std::size_t t = 0; t < details_.attributes.size(); ++t)
      if (!std::isfinite(details_.attributes[t]))
        throw Pslg_error_2(Kind::NOT_FINITE,
                           "the attribute of triangle " + number(t) + " is not a finite number",
                           Pslg_parts_2().triangle(Triangle_index(t)));
  }

  /// The edges on the border now or before, between attributes, and those named.
  void find_constrained_edges() {
    std::unordered_map<std::uint64_t, std::size_t> named; // the first segment on an edge
    for (std::size_t s = 0; s < details_.segments.size(); ++s)
      for_each_edge_of_segment(s, [&](std::uint64_t key) { named.emplace(key, s); });
    for (std::size_t t = 0; t < made_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle_index n = made_.neighbors[t][k];
        if (n.is_valid() && std::size_t(n) < t) continue;
        const Ends ends{made_.triangles[t][(k + 1) % 3], made_.triangles[t][(k + 2) % 3]};
        const auto segment = named.find(edge_key(ends[0], ends[1]));
        if (!n.is_valid()) border_.push_back(ends);
        if (n.is_valid() && segment == named.end() && !was_border(ends) &&
            !is_between_attributes(t, std::size_t(n)))
          continue;
        edge_of_.emplace(edge_key(ends[0], ends[1]), made_.constrained_edges.size());
        int marker = 0;
        if (segment != named.end() && !details_.segment_markers.empty())
          marker = details_.segment_markers[segment->second];
        made_.constrained_edges.push_back({ends, Segment_index(made_.constrained_edges.size()), marker});
      }
    for (std::size_t s = 0; s < details_.segments.size(); ++s)
      for_each_edge_of_segment(s, [&](std::uint64_t key) {
        if (edge_of_.count(key) == 0) refuse_segment(s);
      });
  }

  [[noreturn]] void refuse_segment(std::size_t s) const {
    const auto& [a, b] = details_.segments[s];
    throw Pslg_error_2(Kind::INVALID_MESH,
                       "segment " + number(s) + " from vertex " + number(std::size_t(a)) + " to vertex " +
                           number(std::size_t(b)) + " is not an edge of a triangle",
                       Pslg_parts_2().segment(Segment_index(s)));
  }

  /// Calls `f(key)` for the edges of the mesh along a segment that the details name.
  template <class F>
  void for_each_edge_of_segment(std::size_t s, const F& f) const {
    const auto& [a, b] = details_.segments[s];
    if (!conforming_) return f(edge_key(a, b));
    const std::vector<Vertex_index> way = conforming_->way_along(a, b);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) f(edge_key(way[i], way[i + 1]));
  }

  bool was_border(const Ends& ends) const { return conforming_ && conforming_->was_border(ends[0], ends[1]); }

  double attribute(std::size_t t) const {
    return details_.attributes[conforming_ ? std::size_t(conforming_->origin()[t]) : t];
  }
  bool is_between_attributes(std::size_t t, std::size_t n) const {
    return !details_.attributes.empty() && attribute(t) != attribute(n);
  }

  /// The graph's vertices and segments; tells the mesh their numbers.
  Pslg name_input(const std::vector<Given_mesh::Component>& components) {
    Pslg edges; // each edge a segment
    edges.segments.resize(made_.constrained_edges.size());
    if (!details_.segment_markers.empty()) edges.segment_markers.resize(edges.segments.size());
    const std::vector<char> is_input = input_vertices();
    const Kept_vertices_graph kept(made_, edges, components, is_input);
    made_.segment_of_vertex.resize(made_.points.size());
    for (std::size_t e = 0; e < made_.constrained_edges.size(); ++e) {
      auto& edge = made_.constrained_edges[e];
      edge.segment = kept.segment_of_edge()[e];
      for (const Vertex_index v : edge.vertices)
        if (is_input[std::size_t(v)] == 0) made_.segment_of_vertex[std::size_t(v)] = edge.segment;
    }
    const auto& old_vertex = kept.old_vertex();
    made_.number_of_input_vertices = old_vertex.size();
    if (old_vertex.size() < made_.points.size()) {
      made_.input_index.resize(made_.points.size());
      for (std::size_t i = 0; i < old_vertex.size(); ++i)
        made_.input_index[std::size_t(old_vertex[i])] = Vertex_index(i);
    }
    Pslg pslg = kept.graph();
    set_markers(pslg);
    return pslg;
  }

  /// By Triangle's rule, where the mesh has none.
  void set_markers(const Pslg& pslg) {
    if (!made_.vertex_markers.empty()) return;
    Pslg without_vertices;
    without_vertices.segment_markers = pslg.segment_markers;
    set_boundary_markers(made_, without_vertices, border_);
  }

  std::vector<char> input_vertices() const {
    if (details_.is_input.empty() && details_.vertices == Given_mesh_details_2::Vertices::INPUT)
      return all_but_inner_vertices_of_legs();
    std::vector<char> is_input(made_.points.size(), 1);
    constexpr std::size_t none = std::size_t(-1);
    std::vector<std::array<std::size_t, 3>> edges_at(made_.points.size(),
                                                     {none, none, none}); // the first three
    for (std::size_t e = 0; e < made_.constrained_edges.size(); ++e)
      for (const Vertex_index v : made_.constrained_edges[e].vertices) {
        auto& at = edges_at[std::size_t(v)];
        at[at[0] == none ? 0 : at[1] == none ? 1 : 2] = e;
      }
    const std::set<std::array<double, 2>> unused = unused_places();
    for (const auto& t : made_.triangles)
      for (const Vertex_index v : t) {
        const auto& at = edges_at[std::size_t(v)];
        const bool is_inside =
            at[0] == none || (at[1] != none && at[2] == none && is_inside_segment(v, at[0], at[1]));
        const bool is_named = !details_.is_input.empty() && details_.is_input[std::size_t(v)] != 0;
        is_input[std::size_t(v)] = !is_inside || is_named || unused.count(place(v)) > 0;
      }
    return is_input;
  }

  std::vector<char> all_but_inner_vertices_of_legs() const {
    std::vector<char> may_be_inside(made_.points.size(), 1);
    const std::set<std::array<double, 2>> unused = unused_places();
    for (std::size_t v = 0; v < may_be_inside.size() && !unused.empty(); ++v)
      may_be_inside[v] = unused.count(place(Vertex_index(v))) == 0;
    std::vector<char> is_input = Straight_legs(made_, std::move(may_be_inside)).inner_vertices();
    for (char& is : is_input) is = is == 0 ? 1 : 0;
    return is_input;
  }

  std::array<double, 2> place(Vertex_index v) const { return {made_.point(v).x(), made_.point(v).y()}; }

  /// Of vertices that no triangle uses, which are input. So is what is at the same place.
  std::set<std::array<double, 2>> unused_places() const {
    std::vector<char> is_used(made_.points.size(), 0);
    for (const auto& t : made_.triangles)
      for (const Vertex_index v : t) is_used[std::size_t(v)] = 1;
    std::set<std::array<double, 2>> places;
    for (std::size_t v = 0; v < is_used.size(); ++v)
      if (is_used[v] == 0) places.insert(place(Vertex_index(v)));
    return places;
  }

  /// Whether two edges that end at a vertex have one marker and, unless the user knows better, are one straight line.
  bool is_inside_segment(Vertex_index v, std::size_t e, std::size_t f) const {
    const auto& a = made_.constrained_edges[e];
    const auto& b = made_.constrained_edges[f];
    const auto other = [&](const Ends& ends) { return made_.point(ends[ends[0] == v ? 1 : 0]); };
    const Triangle_tree::Kernel kernel;
    if (!details_.is_input.empty()) return a.marker == b.marker;
    return a.marker == b.marker &&
           kernel.collinear_2_object()(other(a.vertices), made_.point(v), other(b.vertices)) &&
           kernel.are_strictly_ordered_along_line_2_object()(other(a.vertices), made_.point(v),
                                                             other(b.vertices));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_MESH_COMPLETER_H
