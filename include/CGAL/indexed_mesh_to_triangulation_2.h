// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_INDEXED_MESH_TO_TRIANGULATION_2_H
#define CGAL_INDEXED_MESH_TO_TRIANGULATION_2_H

/// \file
/// Converts a mesh in flat arrays to a CGAL triangulation, and a CGAL triangulation to an input graph.
///
/// The triangulation is built through its data structure. The mesh's triangles become faces as they are,
/// without a predicate. Only the surroundings of the mesh are triangulated, from the mesh's border.

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Outside_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Triangulation_welder.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {

namespace Quadtree_mesh_2 {
namespace internal {

/// For inputs without a triangle whose vertices are all collinear.
template <class Point, class Cdt>
void insert_collinear_input(const Pslg_2<Point>& pslg, Cdt& cdt) {
  cdt.clear();
  std::vector<typename Cdt::Vertex_handle> handles;
  for (std::size_t v = 0; v < pslg.vertices.size(); ++v) {
    const auto before = cdt.number_of_vertices();
    handles.push_back(cdt.insert(pslg.vertices[v]));
    if (cdt.number_of_vertices() > before)
      Vertex_info_setter<typename Cdt::Vertex>::set(*handles.back(), static_cast<std::uint32_t>(v));
  }
  for (const auto& s : pslg.segments) {
    const auto a = handles[std::size_t(s[0])], b = handles[std::size_t(s[1])];
    if (a != b) cdt.insert_constraint(a, b);
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Data
/// Builds `cdt` from a mesh. The former content of `cdt` is lost.
///
/// The mesh's triangles become faces with `is_in_domain()`, in their order and with their vertices in their
/// order. Constrained Delaunay triangles outside the domain fill holes and the pockets up to the convex hull,
/// as `Delaunay_mesher_2` leaves them. Input vertices and segments outside the domain are in the
/// triangulation, too. Of input vertices at one place there is one. The mesh's constrained edges, its border,
/// and the segments outside are constrained. If vertices have an `info()` of an arithmetic type, or one that
/// can be made from a `Vertex_index`, it becomes the vertex's index in the mesh.
///
/// Takes time linear in the mesh, plus a constrained Delaunay triangulation of the mesh's border. If some
/// input segment is not in the mesh from end to end, the input is triangulated as well.
///
/// \param mesh has all its arrays. It is constrained Delaunay, so that `cdt.is_valid()` holds afterward
/// (checked if `CGAL_CHECK_EXPENSIVE` is defined).
/// \param pslg the graph that the mesh was made from.
/// \param cdt a `Constrained_Delaunay_triangulation_2` whose faces have `set_in_domain()`, for example by
/// `Delaunay_mesh_face_base_2`, and whose points are those of the mesh.
/// \throws Pslg_error_2 if rounding made the border of the mesh cross itself or a segment outside; `cdt` is
/// then unchanged.
template <class Point, class Cdt>
void indexed_mesh_to_constrained_Delaunay_triangulation_2(const Indexed_mesh_2<Point>& mesh,
                                                          const Pslg_2<Point>& pslg, Cdt& cdt) {
  static_assert(std::is_same_v<Point, typename Cdt::Point>,
                "the mesh and the triangulation have the same points");
  CGAL_precondition(mesh.neighbors.size() == mesh.triangles.size());
  CGAL_precondition(mesh.points.size() >= pslg.vertices.size());
  using Welder = Quadtree_mesh_2::internal::Triangulation_welder<Cdt>;
  typename Welder::Outside outside(mesh, pslg);
  if (outside.dimension() < 2)
    Quadtree_mesh_2::internal::insert_collinear_input(pslg, cdt);
  else
    Welder(mesh, outside, cdt).weld();
  CGAL_expensive_postcondition(cdt.is_valid());
}

/// \ingroup PkgQuadtreeMesh2Data
/// Builds `triangulation` from a mesh of points, or from any mesh that fills its convex hull up to rounding.
/// The former content of `triangulation` is lost.
///
/// The mesh's triangles become faces, in their order and with their vertices in their order, before all other
/// faces. Vertices that no triangle uses, such as duplicate points, are left out. If vertices have an
/// `info()`, it becomes the vertex's index in the mesh as above.
///
/// CGAL's triangulations fill convex hulls exactly, but borders of meshes are straight only up to rounding.
/// The rows of squares of `Point_set_mesher_2` are usually slanted. Vertices on their sides are then off by
/// some last bits; with exact coordinates, by 2^-30 of an edge. The flat pockets between them and the hull
/// become faces, too, which come next. They are not triangles of the mesh, and their angles mean nothing. No
/// border edge faces the obtuse angle of such a face. So a mesh without obtuse angles remains Delaunay, as
/// those of BOUNDED_ANGLES and ACUTE do. Axis-parallel squares have no pockets.
///
/// Takes time linear in the mesh, plus a constrained Delaunay triangulation of its border.
///
/// \param mesh has all its triangles and neighbors
/// \param triangulation a `Triangulation_2`, or a `Delaunay_triangulation_2` if the mesh is Delaunay, whose
/// points are those of the mesh; `is_valid()` holds afterward (checked if `CGAL_CHECK_EXPENSIVE` is defined)
template <class Point, class Triangulation>
void indexed_mesh_to_triangulation_2(const Indexed_mesh_2<Point>& mesh, Triangulation& triangulation) {
  static_assert(std::is_same_v<Point, typename Triangulation::Point>,
                "the mesh and the triangulation have the same points");
  CGAL_precondition(mesh.neighbors.size() == mesh.triangles.size());
  triangulation.clear();
  if (mesh.triangles.empty()) return;
  using Welder = Quadtree_mesh_2::internal::Triangulation_welder<Triangulation>;
  const Pslg_2<Point> nothing_outside;
  typename Welder::Outside outside(mesh, nothing_outside);
  Welder(mesh, outside, triangulation).weld();
  CGAL_expensive_postcondition(triangulation.is_valid());
}

/// \ingroup PkgQuadtreeMesh2Data
/// The graph of a triangulation: its finite vertices and its constrained edges, both in the order of
/// iteration. Takes expected linear time.
/// \param seeds range of points, one in each hole.
template <class Cdt, class Seeds>
Pslg_2<typename Cdt::Point> pslg_from_triangulation_2(const Cdt& cdt, const Seeds& seeds) {
  Pslg_2<typename Cdt::Point> pslg;
  std::unordered_map<const typename Cdt::Vertex*, Quadtree_mesh_2::Vertex_index> index;
  index.reserve(cdt.number_of_vertices());
  for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v)
    index.emplace(&*v, pslg.add_vertex(v->point()));
  for (auto e = cdt.finite_edges_begin(); e != cdt.finite_edges_end(); ++e)
    if (cdt.is_constrained(*e))
      pslg.add_segment(index.at(&*e->first->vertex(Cdt::ccw(e->second))),
                       index.at(&*e->first->vertex(Cdt::cw(e->second))));
  pslg.holes.assign(seeds.begin(), seeds.end());
  return pslg;
}

/// \ingroup PkgQuadtreeMesh2Data
/// The graph of a triangulation without holes.
template <class Cdt>
Pslg_2<typename Cdt::Point> pslg_from_triangulation_2(const Cdt& cdt) {
  return pslg_from_triangulation_2(cdt, std::vector<typename Cdt::Point>());
}

} // namespace CGAL

#endif // CGAL_INDEXED_MESH_TO_TRIANGULATION_2_H
