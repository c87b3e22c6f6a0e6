// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_FIRST_MESHES_H
#define QUADTREE_MESH_2_TEST_FIRST_MESHES_H

// Domains triangulated in one memory and by parts of a mesh, which have to come to the same.

#include "tiny_blocks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/kernel_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/First_mesh_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace first_meshes {

using namespace CGAL::Quadtree_mesh_2::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point_2>;
using Geometry = Double_geometry_2<Kernel>;
using Rule = CGAL::Quality_mesh_options_2::Domain;
using Points = Kernel_graph<Geometry>::Points;

/// A graph in shuffle order.
struct Sorted_graph {
  Points points;
  std::vector<Segment_ends> segments;
  Domain_rule<Geometry> rule;

  Sorted_graph(const Pslg& pslg, Rule domain) {
    const auto grid = CGAL::Filtered_quadtree_traits_2<Kernel>().construct_grid_2_object()(pslg.vertices);
    std::vector<CGAL::Quadtree_mesh_2::Grid_point_2<std::uint64_t>> places;
    for (const Point_2& p : pslg.vertices) places.push_back(grid.grid_point(p));
    const Order order = shuffle_order<CGAL::Sequential_tag>(places);
    for (const auto v : order) points.push_back({pslg.vertices[v].x(), pslg.vertices[v].y()});
    segments = kernel_segments<CGAL::Sequential_tag>(pslg, order);
    rule.rule = domain;
    for (const Point_2& p : pslg.holes) rule.holes.push_back({p.x(), p.y()});
    for (const auto& region : pslg.regions) rule.regions.push_back({region.point.x(), region.point.y()});
  }
};

/// The mesh of a domain, and what is known of the triangulation.
struct Domain_mesh {
  bool is_made = false;
  Kernel_mesh<Geometry> mesh;
  First_mesh made;
};

inline Domain_mesh in_one_memory(const Sorted_graph& graph, std::size_t block_size) {
  Domain_mesh result;
  First_triangulation<CGAL::Sequential_tag, Geometry> first(
      result.mesh, graph.points.values(), blocks_by_number(graph.points.size(), block_size));
  if (first.run(graph.segments)) return result;
  Canonical_flipper<CGAL::Sequential_tag, Geometry>(result.mesh)
      .run(); // also of what is too small for blocks
  result.made.merged_vertices = first.number_of_repeated_vertices();
  result.made.vertices_on_segments = first.number_of_vertices_on_segments();
  result.made.edges = first.take_edges(), result.made.repeated_edges = first.take_repeated_edges();
  try {
    result.made.outer = graph.rule.apply(result.mesh, first.number_of_auxiliary_vertices);
    result.is_made = true;
  } catch (const Ambiguous_seed&) {
  }
  return result;
}

template <class Tag>
Domain_mesh by_parts(const Sorted_graph& sorted, int parts) {
  Domain_mesh result;
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    Domain_mesh part;
    part.mesh.points = sorted.points;
    part.made.edges.segments = sorted.segments;
    part.made.merged_vertices = name_by_first(sorted.points, part.made.edges.segments);
    const Kernel_graph<Geometry> graph{part.mesh.points, sorted.points.size(), part.made.edges.segments};
    First_mesh_of_parts<Tag, In_memory_exchange, Geometry> first(exchange, graph, sorted.rule);
    part.is_made = first.run();
    if (part.is_made) first.gather(part.mesh, part.made);
    if (exchange.rank() == 0) result = std::move(part);
  });
  return result;
}

/// The edges, each with all segments along it, and the triangles outside, in an order of their own.
inline auto in_order(const First_mesh& made) {
  std::vector<std::array<std::uint32_t, 3>> edges, outer;
  const auto add = [&edges](const Input_edge& e) {
    edges.push_back({std::min(e.a, e.b).value(), std::max(e.a, e.b).value(), e.segment.value()});
  };
  for (std::size_t s = 0; s < made.edges.segments.size(); ++s)
    if (const auto& [a, b] = made.edges.segments[s]; a.is_valid())
      add({a, b, CGAL::Quadtree_mesh_2::Segment_index(s)});
  for (const Input_edge& e : made.edges.others) add(e);
  for (const Input_edge& e : made.repeated_edges) add(e);
  for (const Outer_triangle& o : made.outer) outer.push_back({o.a.value(), o.b.value(), o.apex.value()});
  std::sort(edges.begin(), edges.end()), std::sort(outer.begin(), outer.end());
  return std::tuple(std::move(edges), std::move(outer));
}

/// How many edges there are, not counting those of several segments more than once.
inline std::size_t number_of_edges(const First_mesh& made) {
  const auto& segments = made.edges.segments;
  return made.edges.others.size() +
         static_cast<std::size_t>(std::count_if(segments.begin(), segments.end(),
                                                [](const Segment_ends& ends) { return ends[0].is_valid(); }));
}

/// What differs; empty if nothing does.
inline std::string difference(const Domain_mesh& a, const Domain_mesh& b) {
  if (a.mesh.triangles.size() != b.mesh.triangles.size()) return "the number of triangles";
  for (const Triangle_id t : a.mesh.triangles.ids())
    for (int k = 0; k < 3; ++k) {
      const auto &r = a.mesh.triangle(t), &s = b.mesh.triangle(t);
      const Side o = r.side[k], p = s.side[k];
      if (r.v[k] != s.v[k]) return "a triangle";
      if (o.is_border() != p.is_border() || o.is_constrained() != p.is_constrained()) return "a side";
      if (!o.is_border() && (o.triangle() != p.triangle() || o.slot() != p.slot())) return "a neighbor";
    }
  if (!(a.mesh.region_of == b.mesh.region_of)) return "a region";
  if (!(a.mesh.triangle_of == b.mesh.triangle_of)) return "the triangle of a vertex";
  if (!(a.mesh.role_of == b.mesh.role_of && a.mesh.is_dirty == b.mesh.is_dirty)) return "a vertex";
  if (!(a.mesh.points == b.mesh.points)) return "a point";
  if (in_order(a.made) != in_order(b.made)) return "the edges, or the triangles outside";
  if (number_of_edges(a.made) != number_of_edges(b.made)) return "the number of edges";
  if (a.made.merged_vertices != b.made.merged_vertices) return "the number of merged vertices";
  if (a.made.vertices_on_segments != b.made.vertices_on_segments) return "the number of vertices on segments";
  return {};
}

} // namespace first_meshes

#endif // QUADTREE_MESH_2_TEST_FIRST_MESHES_H
