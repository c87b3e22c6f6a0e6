// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_RENUMBER_MESH_2_H
#define CGAL_RENUMBER_MESH_2_H

/// \file
/// Numbers a mesh by the places of its vertices, and back.

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Mesh_renumberer.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Where vertices and triangles are after `renumber_by_place()`.
struct Mesh_renumbering_2 {
  std::vector<Quadtree_mesh_2::Vertex_index> new_vertex;     ///< per vertex before, its index now
  std::vector<Quadtree_mesh_2::Triangle_index> new_triangle; ///< per triangle before, its index now

  /// Renumbers the triangles in a mesher's report.
  void renumber(Quality_mesh_report_2& report) const {
    renumber_list(report.exempt_triangles);
    renumber_list(report.unmet_triangles);
  }
  /// The same for a mesh of points.
  void renumber(Point_set_mesh_report_2& report) const { renumber_list(report.unmet_triangles); }

private:
  template <class Entry>
  void renumber_list(std::vector<Entry>& list) const {
    for (Entry& entry : list) entry.triangle = new_triangle[std::size_t(entry.triangle)];
  }
};

/// \ingroup PkgQuadtreeMesh2Data
/// Puts a mesh into an order of places: what is near in the plane is near in the arrays, and in files.
///
/// Vertices come in the shuffle order (Morton order) of their places, those of the input among the others;
/// `Indexed_mesh_2::input_index` then has their indices in the input. Triangles begin at their least vertex and come in
/// the order of that, then of their second one. Constrained edges come in the order of their lesser end, then of the
/// other; they keep their direction. The result depends on the mesh alone and not on its numbers before, except that
/// vertices at one place come in the order of the input.
///
/// O(n) work. Copies one array at a time, besides 24 bytes for each vertex or 20 for each triangle while sorting. If
/// long arrays are in a `Scratch_memory`, these are, too.
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the order is the same for any number of threads
/// \pre Coordinates are finite.
/// Source: the shuffle order of Bern, Eppstein, Teng, "Parallel Construction of Quadtrees and Quality Triangulations".
template <class ConcurrencyTag = Sequential_tag, class Point>
Mesh_renumbering_2 renumber_by_place(Indexed_mesh_2<Point>& mesh) {
  Quadtree_mesh_2::internal::Mesh_renumberer<ConcurrencyTag, Point> renumberer(mesh);
  renumberer.by_place();
  return {renumberer.take_new_vertex(), renumberer.take_new_triangle()};
}

/// \ingroup PkgQuadtreeMesh2Data
/// Puts the vertices of the input in front again, in their order, and the others behind them as they come. Triangles
/// and edges keep their order. `Indexed_mesh_2::input_index` becomes empty. Does nothing to a mesh that is in this
/// order. O(n).
/// \returns per vertex before, its index now; empty if nothing was done
template <class ConcurrencyTag = Sequential_tag, class Point>
std::vector<Quadtree_mesh_2::Vertex_index> renumber_by_input(Indexed_mesh_2<Point>& mesh) {
  Quadtree_mesh_2::internal::Mesh_renumberer<ConcurrencyTag, Point> renumberer(mesh);
  renumberer.by_input();
  return renumberer.take_new_vertex();
}

} // namespace CGAL

#endif // CGAL_RENUMBER_MESH_2_H
