// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_DISTRIBUTED_MESH_FILES_H
#define CGAL_IO_DISTRIBUTED_MESH_FILES_H

/// \file
/// Files of distributed meshes, written by all ranks. A program links MPI and HDF5's C library, that for MPI or that
/// for one process.

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/IO/io.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/hdf5_part_files.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/mesh_part_files.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <mpi.h>

#include <string>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2Distributed
/// @{

/// Writes the mesh in pieces, one for each rank with triangles: the same bytes as `write_PVTU()` of the whole mesh with
/// as many pieces. The first rank writes the file that names them.
///
/// All ranks of `comm` call this, as all functions here. All files appear under their names, or none: if one rank
/// cannot write, all ranks throw the same, and older files are unchanged. A rank needs memory for its part of the mesh
/// once more, and for its file unless that is HDF5. O(k log k) for k triangles and vertices of a rank.
/// \param file_name ends in `.pvtu`; the same at all ranks
/// \param fields more numbers for each own triangle, of the same names at all ranks
/// \throws std::runtime_error naming the file that cannot be written
/// \throws std::invalid_argument if ranks have other fields, or one does not have a number for each own triangle
template <class Point>
void write_PVTU(MPI_Comm comm, const std::string& file_name, const Distributed_mesh_2<Point>& mesh,
                const Triangle_fields_2& fields = {}, Mode mode = BINARY) {
  Quadtree_mesh_2::internal::Mpi_exchange exchange(comm);
  Quadtree_mesh_2::internal::write_pvtu_together(exchange, file_name, mesh, fields, mode);
}

/// Writes the mesh in parts for Gmsh, one for each rank with triangles: the same bytes as `write_MSH_parts()` of the
/// whole mesh with as many parts.
/// \param file_name ends in `.msh`
/// \throws std::runtime_error as above
template <class Point>
void write_MSH_parts(MPI_Comm comm, const std::string& file_name, const Distributed_mesh_2<Point>& mesh) {
  Quadtree_mesh_2::internal::Mpi_exchange exchange(comm);
  Quadtree_mesh_2::internal::write_msh_together(exchange, file_name, mesh);
}

/// Writes the mesh as one VTKHDF file: the same bytes as `write_VTKHDF()` of the whole mesh. The first rank makes the
/// file, and each writes the values that it owns, some rows at a time. Ranks have to see one file system.
/// \throws std::runtime_error, std::invalid_argument as above
template <class Point>
void write_VTKHDF(MPI_Comm comm, const std::string& file_name, const Distributed_mesh_2<Point>& mesh,
                  const Triangle_fields_2& fields = {}) {
  Quadtree_mesh_2::internal::Mpi_exchange exchange(comm);
  Quadtree_mesh_2::internal::write_vtkhdf_together(exchange, file_name, mesh, fields);
}

/// Writes the mesh as two files of one stem, as `write_XDMF()` does with the whole mesh: `.h5` as above, and
/// `.xdmf` by the first rank.
/// \param file_name ends in `.xdmf` or `.h5`
/// \throws std::runtime_error, std::invalid_argument as above
template <class Point>
void write_XDMF(MPI_Comm comm, const std::string& file_name, const Distributed_mesh_2<Point>& mesh,
                const Triangle_fields_2& fields = {}) {
  Quadtree_mesh_2::internal::Mpi_exchange exchange(comm);
  Quadtree_mesh_2::internal::write_xdmf_together(exchange, file_name, mesh, fields);
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_DISTRIBUTED_MESH_FILES_H
