// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_MESH_FROM_CDT_H
#define QUADTREE_MESH_2_TEST_MESH_FROM_CDT_H

// Meshes made by CGAL alone, so that the checker, the conversion and the writers are tested without the
// mesher.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace test_meshes {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Triangle_index;
using CGAL::Quadtree_mesh_2::Vertex_index;

using Face_base =
    CGAL::Delaunay_mesh_face_base_2<Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Vertex_base = CGAL::Triangulation_vertex_base_2<Kernel>;
using Tds = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds, CGAL::Exact_predicates_tag>;

using Info_vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Vertex_index, Kernel>;
using Info_tds = CGAL::Triangulation_data_structure_2<Info_vertex_base, Face_base>;
using Info_cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Info_tds, CGAL::Exact_predicates_tag>;

inline void add_segment(Pslg& pslg, std::size_t a, std::size_t b) {
  pslg.add_segment(Vertex_index(a), Vertex_index(b));
}

/// Adds a closed polygon.
inline void add_polygon(Pslg& pslg, const std::vector<Point>& points) {
  const std::size_t first = pslg.vertices.size(), n = points.size();
  for (const Point& p : points) pslg.add_vertex(p);
  for (std::size_t i = 0; i < n; ++i) add_segment(pslg, first + i, first + (i + 1) % n);
}

inline std::vector<Point> square(double x, double y, double half) {
  return {Point(x - half, y - half), Point(x + half, y - half), Point(x + half, y + half),
          Point(x - half, y + half)};
}

/// A constrained Delaunay triangulation of the input, refined by Mesh_2 if `size` is not 0 (`bound` is sin^2
/// of the least angle).
inline Cdt triangulate(const Pslg& pslg, double size = 0, double bound = 0.125) {
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles;
  for (const Point& p : pslg.vertices) handles.push_back(cdt.insert(p));
  for (const auto& s : pslg.segments) {
    const auto a = handles[std::size_t(s[0])], b = handles[std::size_t(s[1])];
    if (a != b) cdt.insert_constraint(a, b);
  }
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt, size > 0 ? Criteria(bound, size) : Criteria(0, 0));
  mesher.set_seeds(pslg.holes.begin(), pslg.holes.end(), false);
  if (size > 0)
    mesher.refine_mesh();
  else
    mesher.mark_facets();
  return cdt;
}

/// The constrained edges along an input segment, each as a pair of vertices: always on in the direction nearest to that
/// of the segment, as vertices are rounded.
inline std::vector<std::pair<std::size_t, std::size_t>>
edges_along(const std::vector<Point>& points, const std::vector<std::vector<std::size_t>>& adjacent,
            std::size_t a, std::size_t b) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  const double dx = points[b].x() - points[a].x(), dy = points[b].y() - points[a].y();
  for (std::size_t v = a; v != b;) {
    std::size_t best = v;
    double best_cosine = 0.99 * std::hypot(dx, dy);
    for (std::size_t w : adjacent[v]) {
      const double ux = points[w].x() - points[v].x(), uy = points[w].y() - points[v].y();
      const double cosine = (ux * dx + uy * dy) / std::hypot(ux, uy);
      if (cosine > best_cosine) best = w, best_cosine = cosine;
    }
    if (best == v) return result;
    result.emplace_back(v, best);
    v = best;
  }
  return result;
}

/// The faces in the domain, with all the arrays of a mesh. Coordinates that are not doubles are rounded.
template <class Triangulation>
Mesh mesh_from_cdt(const Triangulation& cdt, const Pslg& pslg) {
  Mesh mesh;
  mesh.points = pslg.vertices;
  mesh.number_of_input_vertices = pslg.vertices.size();
  std::map<Point, std::size_t> at;
  for (std::size_t v = pslg.vertices.size(); v-- > 0;) at[pslg.vertices[v]] = v;
  std::map<typename Triangulation::Face_handle, std::size_t> number;
  std::map<std::pair<std::size_t, std::size_t>, bool> is_edge;
  std::vector<std::vector<std::size_t>> adjacent(pslg.vertices.size());
  const auto index = [&](typename Triangulation::Vertex_handle v) {
    const Point p(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()));
    const auto found = at.insert({p, mesh.points.size()});
    if (found.second) mesh.points.push_back(p), adjacent.emplace_back();
    return found.first->second;
  };
  for (typename Triangulation::Face_handle f : cdt.finite_face_handles()) {
    if (!f->is_in_domain()) continue;
    number.insert({f, mesh.triangles.size()});
    mesh.triangles.push_back({Vertex_index(index(f->vertex(0))), Vertex_index(index(f->vertex(1))),
                              Vertex_index(index(f->vertex(2)))});
  }
  mesh.neighbors.resize(mesh.triangles.size());
  for (const auto& entry : number)
    for (int k = 0; k < 3; ++k) {
      const auto across = number.find(entry.first->neighbor(k));
      if (across != number.end())
        mesh.neighbors[entry.second][std::size_t(k)] = Triangle_index(across->second);
    }
  const std::size_t used = mesh.points.size(); // Mesh_2 can split segments outside the domain too
  for (auto e : cdt.constrained_edges()) {
    const std::size_t a = index(e.first->vertex(Triangulation::ccw(e.second))),
                      b = index(e.first->vertex(Triangulation::cw(e.second)));
    adjacent[a].push_back(b), adjacent[b].push_back(a);
    is_edge[std::minmax(a, b)] = number.count(e.first) != 0 || number.count(e.first->neighbor(e.second)) != 0;
  }
  mesh.segment_of_vertex.resize(mesh.points.size());
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const std::size_t a = at[pslg.point(pslg.segments[s][0])], b = at[pslg.point(pslg.segments[s][1])];
    for (auto e : edges_along(mesh.points, adjacent, a, b)) {
      bool& is_new = is_edge[std::minmax(e.first, e.second)];
      if (is_new)
        mesh.constrained_edges.push_back({{Vertex_index(e.first), Vertex_index(e.second)}, Segment_index(s)});
      is_new = false;
      for (std::size_t v : {e.first, e.second})
        if (v >= pslg.vertices.size() && !mesh.segment_of_vertex[v].is_valid())
          mesh.segment_of_vertex[v] = Segment_index(s);
    }
  }
  mesh.points.resize(used);
  mesh.segment_of_vertex.resize(used);
  return mesh;
}

inline Mesh mesh_of(const Pslg& pslg, double size = 0) {
  return mesh_from_cdt(triangulate(pslg, size), pslg);
}

} // namespace test_meshes

#endif // QUADTREE_MESH_2_TEST_MESH_FROM_CDT_H
