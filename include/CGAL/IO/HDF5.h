// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_HDF5_H
#define CGAL_IO_HDF5_H

/// \file
/// Graphs and meshes in files of HDF5, for which a program links its C library (`libhdf5-dev`).

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_file.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_mesh_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <filesystem>
#include <string>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Reads a planar straight-line graph from the group `/pslg` of a file of HDF5. Its arrays, for n vertices and m
/// segments:
/// - `vertices`, n x 2 numbers: x, y
/// - `segments`, m x 2 integers: indices of vertices, which count from 0
/// - `vertex_markers`, n integers; `segment_markers`, m integers, both of up to 32 bits
/// - `vertex_attributes`, n x k numbers
/// - `holes`, h x 2 numbers: points in holes
/// - `regions`, r x 4 numbers: x, y, attribute, largest area; the last, for which 0 or less means none, may be left out
///
/// All but `vertices` are optional. Numbers may have any size and order of bytes, and arrays may be chunked and
/// compressed: HDF5 converts. Arrays are read in slabs, so that only the graph is in memory. As for .poly files only
/// the indices of segments are checked. Linear time.
/// \throws Pslg_error_2 naming the file, the array and its row if there is no such file or array, or it is malformed;
/// `pslg` is then unchanged.
template <class Point>
void read_HDF5(const std::string& file_name, Pslg_2<Point>& pslg) {
  pslg = Quadtree_mesh_2::internal::Hdf5_graph_reader<Point>(file_name).read();
}

/// Writes a graph so that `read_HDF5()` gives it back, bit for bit if its coordinates are doubles.
/// \pre `check_pslg_structure(pslg)` passes
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written, as for all functions
/// here. An older file of that name is then unchanged.
template <class Point>
void write_HDF5(const std::string& file_name, const Pslg_2<Point>& pslg) {
  Quadtree_mesh_2::internal::Replaced_files files;
  files.add_by(file_name, [&](const std::string& temporary) {
    Quadtree_mesh_2::internal::Hdf5_writer out(temporary, file_name);
    Quadtree_mesh_2::internal::write_hdf5_graph(out, pslg);
    out.close();
  });
  files.commit();
}

/// Writes the mesh as a VTKHDF file, an unstructured grid of version 1.0, for ParaView 5.10 or later. Points, cells and
/// data are those of `write_VTU()`. Only some rows of an array are in memory besides the mesh. Linear time. The same
/// mesh gives the same bytes.
/// \param pslg the graph that the mesh was made from
/// \param fields more numbers for each triangle, see `Triangle_field_2`; in their names `/` becomes `_`
/// \throws std::invalid_argument if a field does not have a number for each triangle
template <class Point>
void write_VTKHDF(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                  const Triangle_fields_2& fields = {}) {
  Quadtree_mesh_2::internal::Replaced_files files;
  Quadtree_mesh_2::internal::add_vtkhdf_file(files, file_name, mesh, pslg, fields);
  files.commit();
}

/// Writes the mesh as two files of one stem: `.h5` with arrays, and `.xdmf`, which tells ParaView, FEniCSx and others
/// what they are (XDMF 3). If one cannot be written, none is.
///
/// The grid "mesh" has the triangles, /mesh/triangles, the grid "edges" the constrained edges, /mesh/edges. Both have
/// all vertices, /mesh/points, with two coordinates. Data are those of `write_VTU()`: of points in /mesh/point_data; of
/// triangles in /mesh/triangle_data; of edges the marker, in /mesh/edge_data. Segments outside of the mesh are left
/// out. Memory and time as for `write_VTKHDF()`.
/// \param file_name ends in `.xdmf` or `.h5`
template <class Point>
void write_XDMF(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                const Triangle_fields_2& fields = {}) {
  Quadtree_mesh_2::internal::Replaced_files files;
  const std::string stem = std::filesystem::path(file_name).replace_extension().string();
  Quadtree_mesh_2::internal::add_xdmf_files(files, stem, mesh, pslg, fields);
  files.commit();
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_HDF5_H
