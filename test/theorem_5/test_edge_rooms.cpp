// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Edges bent within their rooms: they cross nothing, and pass each vertex on the side on which they did.

#include "catch.h"
#include "random_pslg_shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_rooms.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_edge_rooms {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using Geometry = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Point = Geometry::Point;
using CGAL::Quadtree_mesh_2::Segment_index;
using internal::Edge_id;
using internal::Input_edge;
using internal::Input_edge_list;
using internal::Vertex_id;
using random_pslg::Random;

double moved(double x, int units) {
  for (; units > 0; --units) x = std::nextafter(x, 1e300);
  for (; units < 0; ++units) x = std::nextafter(x, -1e300);
  return x;
}

/// An edge, vertices a few units of the coordinates beside it, and edges from some of these.
struct Bundle {
  internal::Meshing_problem<Geometry> problem;

  Bundle(std::uint64_t seed, double offset) {
    Random random(seed);
    const auto place = [&] { return offset + random.between(0, 1); };
    const Point a{place(), place()}, b{place(), place()};
    Input_edge_list edges{{Vertex_id(0), Vertex_id(1), Segment_index(0)}};
    problem.input_points = {a, b};
    for (int i = random.integer(1, 4); i > 0; --i) {
      const double f = random.between(0, 1);
      const Vertex_id near = add({moved(a.x + f * (b.x - a.x), random.integer(-3, 3)),
                                  moved(a.y + f * (b.y - a.y), random.integer(-3, 3))});
      if (random.integer(0, 1) == 0) continue;
      edges.push_back({near, add({place(), place()}), Segment_index(edges.size())});
    }
    problem.edges = internal::Input_edges(edges, problem.input_points.size());
  }

  Vertex_id add(const Point& p) { return problem.input_points.add(p); }

  /// Triangulates it, if it is a graph: no edges cross, and no vertex lies on another one's edge.
  bool triangulate(internal::Kernel_mesh<Geometry>& mesh) const {
    internal::First_triangulation<CGAL::Sequential_tag, Geometry> first(mesh, problem.input_points.values());
    std::vector<std::array<Vertex_id, 2>> segments;
    for (const Edge_id e : problem.edges.ids()) segments.push_back({problem.edges[e].a, problem.edges[e].b});
    if (first.run(segments) || first.number_of_vertices_on_segments() > 0) return false;
    for (const Vertex_id v : problem.input_points.ids())
      if (first.representative(v) != v) return false;
    return true;
  }

  /// An edge with vertices wherever they fit among many places.
  std::vector<Point> bent(Edge_id e, const internal::Edge_rooms<Geometry>& rooms) const {
    const Point &a = problem.input_point(problem.edges[e].a), &b = problem.input_point(problem.edges[e].b);
    std::vector<Point> chain{a};
    for (double f = 0x1p-9; f < 1; f += 0x1p-9) {
      const Point p = Geometry::between(a, b, f);
      if (!rooms.is_in_order(e, chain.back(), p)) continue;
      const auto q = rooms.place_next_to(e, p);
      if (q) chain.push_back(*q);
    }
    chain.push_back(b);
    return chain;
  }
};

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
Exact::Point_2 exact(const Point& p) { return {p.x, p.y}; }

/// Whether the boxes of two segments meet.
bool do_boxes_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  return std::min(a.x, b.x) <= std::max(c.x, d.x) && std::min(c.x, d.x) <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= std::max(c.y, d.y) && std::min(c.y, d.y) <= std::max(a.y, b.y);
}

bool cross(const std::vector<Point>& chain, const std::vector<Point>& other) {
  for (std::size_t i = 1; i < chain.size(); ++i)
    for (std::size_t j = 1; j < other.size(); ++j)
      if (do_boxes_meet(chain[i - 1], chain[i], other[j - 1], other[j]) &&
          CGAL::do_intersect(Exact::Segment_2(exact(chain[i - 1]), exact(chain[i])),
                             Exact::Segment_2(exact(other[j - 1]), exact(other[j]))))
        return true;
  return false;
}

/// Whether p is as much between an edge and the chain that it became, or on the chain.
bool is_passed_over(const Point& p, const std::vector<Point>& chain) {
  const int side = Geometry::orientation(chain.front(), chain.back(), p);
  const bool is_steep =
      std::fabs(chain.back().y - chain.front().y) > std::fabs(chain.back().x - chain.front().x);
  const auto place = [&](const Point& q) { return is_steep ? q.y : q.x; };
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const double low = std::min(place(chain[i - 1]), place(chain[i])),
                 high = std::max(place(chain[i - 1]), place(chain[i]));
    if (place(p) >= low && place(p) <= high && Geometry::orientation(chain[i - 1], chain[i], p) != side)
      return true;
  }
  return false;
}

} // namespace

TEST_CASE("Edges bent within their rooms are the same graph", "[mesher][theorem5]") {
  std::size_t graphs = 0, vertices = 0;
  for (const double offset : {0., 10., 1e6})
    for (std::uint64_t seed = 0; seed < (is_full_run() ? 300u : 10u); ++seed) {
      const Bundle bundle(seed, offset);
      internal::Kernel_mesh<Geometry> mesh;
      if (!bundle.triangulate(mesh)) continue;
      CAPTURE(offset, seed);
      const auto triangles = internal::Edge_triangles<Geometry>::of<CGAL::Sequential_tag>(
          mesh, bundle.problem.edges, bundle.problem.input_points.size());
      const internal::Edge_rooms<Geometry> rooms(bundle.problem, triangles);
      std::vector<std::vector<Point>> chains;
      for (std::size_t e = 0; e < bundle.problem.edges.size(); ++e)
        chains.push_back(bundle.bent(Edge_id(e), rooms));
      ++graphs;
      for (std::size_t e = 0; e < chains.size(); ++e) {
        vertices += chains[e].size() - 2;
        for (std::size_t f = e + 1; f < chains.size(); ++f) CHECK_FALSE(cross(chains[e], chains[f]));
        for (const Vertex_id v : bundle.problem.input_points.ids()) {
          const Input_edge& edge = bundle.problem.edges[Edge_id(e)];
          if (v != edge.a && v != edge.b)
            CHECK_FALSE(is_passed_over(bundle.problem.input_point(v), chains[e]));
        }
      }
    }
  CHECK(graphs > 10);
  CHECK(vertices > 100 * graphs);
}

} // namespace test_edge_rooms
