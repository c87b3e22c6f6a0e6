// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_SMS_2DM_H
#define CGAL_IO_SMS_2DM_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Border_loops.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>

// Writes .2dm files of SMS, which MDAL (QGIS) and many flow models read, by cards as in
// https://www.xmswiki.com/wiki/SMS:2D_Mesh_Files_*.2dm. Takes the time of finding the border.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A loop as a node string: closed by its first node, whose number is negative at the end; ten nodes on a line.
inline void write_node_string(Line_writer& out, const Border_loop& loop) {
  constexpr std::size_t longest = 10;
  for (std::size_t i = 0; i <= loop.size(); ++i) {
    if (i % longest == 0) out << "NS";
    const long long node = static_cast<long long>(loop[i % loop.size()].value()) + 1;
    out << (i < loop.size() ? node : -node);
    if (i % longest == longest - 1 || i == loop.size()) out.end_line();
  }
}

template <class Point>
std::string sms_2dm_text(const Indexed_mesh_2<Point>& mesh) {
  const auto from_1 = [](Vertex_index v) { return std::size_t(v) + 1; };
  int regions = 0;
  for (const int r : mesh.region_of_triangle) regions = std::max(regions, r + 1);
  Line_writer out;
  out.reserve(55 * mesh.points.size() + 36 * mesh.triangles.size() + 128);
  (out << "MESH2D").end_line();
  (out << "NUM_MATERIALS_PER_ELEM" << 1).end_line();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const int region = mesh.region_of_triangle.empty() ? -1 : mesh.region_of_triangle[t];
    (out << "E3T" << t + 1 << from_1(a) << from_1(b) << from_1(c) << (region < 0 ? regions : region) + 1)
        .end_line();
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    ((out << "ND" << v + 1).write_point(mesh.points[v]) << 0).end_line();
  const Border_loops loops = border_loops(mesh);
  for (const auto* some : {&loops.outer, &loops.islands})
    for (const Border_loop& loop : *some) write_node_string(out, loop);
  return out.take();
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes a mesh as a `.2dm` file of SMS: the cards `MESH2D`, `NUM_MATERIALS_PER_ELEM`, `E3T`, `ND` and `NS`.
///
/// The file has all points in their order, used or not, with elevation 0. The material of a triangle is the number of
/// its region, counted from 1; triangles in no region have the number after the largest. Each loop of the border is a
/// node string, the outer ones first: the domain is on its left, and its first node is repeated at the end. Where loops
/// touch, each is simple. O(T log d) for T triangles and at most d of them at a vertex.
/// \pre triangles are counterclockwise, and sides are between at most two
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
template <class Point>
void write_SMS_2DM(std::ostream& out, const Indexed_mesh_2<Point>& mesh) {
  out << Quadtree_mesh_2::internal::sms_2dm_text(mesh);
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_SMS_2DM(const std::string& file_name, const Indexed_mesh_2<Point>& mesh) {
  Quadtree_mesh_2::internal::replace_file(file_name, Quadtree_mesh_2::internal::sms_2dm_text(mesh));
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_SMS_2DM_H
