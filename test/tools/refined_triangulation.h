// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_REFINED_TRIANGULATION_H
#define QUADTREE_MESH_2_TEST_REFINED_TRIANGULATION_H

// Inputs for meshing triangulations in place, and what every triangulation meshed in place has to fulfil.

#include "catch.h"
#include "mesh_from_cdt.h"

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/mesh_quality_2.h>

#include <cstddef>
#include <map>
#include <vector>

namespace test_meshes {

/// A square of side 8 with a vertex inside, a diamond in it with another square in that, and a segment inside that
/// touches nothing. The area of the diamond is 18, of the inner square 4.
inline Pslg nested() {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 4));
  add_polygon(pslg, {Point(3, 0), Point(0, 3), Point(-3, 0), Point(0, -3)});
  add_polygon(pslg, square(0, 0, 1));
  pslg.add_vertex(Point(3.3, 3.4));
  pslg.add_vertex(Point(-3.5, -3)), pslg.add_vertex(Point(-3, -3.5));
  add_segment(pslg, 13, 14);
  return pslg;
}

/// The vertices' handles are in the order of the graph.
template <class Triangulation>
std::vector<typename Triangulation::Vertex_handle> insert_graph(Triangulation& cdt, const Pslg& pslg) {
  std::vector<typename Triangulation::Vertex_handle> handles;
  for (const Point& p : pslg.vertices)
    handles.push_back(cdt.insert(typename Triangulation::Point(p.x(), p.y())));
  for (const auto& s : pslg.segments)
    cdt.insert_constraint(handles[std::size_t(s[0])], handles[std::size_t(s[1])]);
  return handles;
}

template <class Triangulation>
double area_in_domain(const Triangulation& cdt) {
  double sum = 0;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    if (f->is_in_domain()) sum += CGAL::to_double(cdt.triangle(f).area());
  return sum;
}

/// How many faces in the domain the criteria call bad.
template <class Triangulation, class Criteria>
std::size_t number_of_bad(const Triangulation& cdt, const Criteria& criteria) {
  const auto is_bad = criteria.is_bad_object();
  std::size_t n = 0;
  for (typename Triangulation::Face_handle f : cdt.finite_face_handles()) {
    typename Criteria::Quality quality;
    n += f->is_in_domain() && is_bad(f, quality) != CGAL::Mesh_2::NOT_BAD ? 1 : 0;
  }
  return n;
}

/// Checks the triangulation as such, and its domain against the graph, for which the graph's holes, or with
/// `marked_by_regions` its regions, tell the domain.
template <class Triangulation>
void require_mesh(
    const Triangulation& cdt, const Pslg& pslg, double least_angle,
    CGAL::Mesh_quality_options_2::Domain rule = CGAL::Mesh_quality_options_2::Domain::ENCLOSED_BY_SEGMENTS) {
  REQUIRE(cdt.is_valid());
  CGAL::Mesh_quality_options_2 options = CGAL::Mesh_quality_options_2().min_angle(least_angle);
  options.check_domain(rule);
  const auto quality = CGAL::mesh_quality_2(mesh_from_cdt(cdt, pslg), pslg, options);
  INFO(quality);
  CHECK(quality.is_valid());
  CHECK(quality.unmet_triangles.empty());
  CHECK(quality.triangles > 0);
}

} // namespace test_meshes

#endif // QUADTREE_MESH_2_TEST_REFINED_TRIANGULATION_H
