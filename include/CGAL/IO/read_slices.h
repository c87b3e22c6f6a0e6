// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_SLICES_H
#define CGAL_IO_READ_SLICES_H

#include <CGAL/Pslg_slice_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Poly_slice_reader.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/take_all_but_segments.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_graph.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <string>
#include <utility>

// Reads graphs on several ranks of MPI, each of which has a part of the graph and never all of it.

namespace CGAL {
namespace IO {

/// \ingroup PkgQuadtreeMesh2Distributed
/// Reads a slice of a `.poly` file of Triangle at each rank of a communicator. Collective.
///
/// Each rank reads about as many bytes as others, up to an end of a line. A file compressed by gzip, or one that is not
/// regular, is read by the first rank, which needs memory for all of it, and sent to the others. If the file has 0
/// vertices, they are taken from the `.node` file of the same stem. Takes linear time in the slice.
/// \param comm the communicator
/// \param file_name has to name the same file at all ranks
/// \param slice what this rank has read
/// \throws Pslg_error_2 at all ranks, as `read_triangle_poly()` does and with the same text; `slice` is then unchanged.
template <class Point>
void read_triangle_poly_slice(MPI_Comm comm, const std::string& file_name, Pslg_slice_2<Point>& slice) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::Mpi_exchange exchange(comm);
  slice = internal::Poly_slice_reader<Point, internal::Mpi_exchange>(exchange, file_name).read();
}

/// \ingroup PkgQuadtreeMesh2Distributed
/// Reads a slice of a graph from a file of HDF5 at each rank of a communicator: about as many rows of each array as
/// other ranks. Collective. See `read_HDF5()` for the arrays.
/// \param comm the communicator
/// \param file_name has to name the same file at all ranks
/// \param slice what this rank has read
/// \throws Pslg_error_2 at all ranks, as `read_HDF5()` does and with the same text; `slice` is then unchanged.
template <class Point>
void read_HDF5_slice(MPI_Comm comm, const std::string& file_name, Pslg_slice_2<Point>& slice) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::Mpi_exchange exchange(comm);
  const internal::Hdf5_slice own{static_cast<std::size_t>(exchange.rank()),
                                 static_cast<std::size_t>(exchange.size())};
  internal::Hdf5_graph_reader<Point> reader(file_name, own, std::numeric_limits<std::size_t>::max() / 4);
  Pslg_slice_2<Point> result;
  std::exception_ptr error;
  try {
    reader.read_rows([&](std::size_t n) { result.segments.reserve(n); },
                     [&](std::int64_t a, std::int64_t b) {
                       result.segments.push_back({{a, b}});
                     });
  } catch (...) {
    error = std::current_exception();
  }
  internal::agree_on_error(exchange, error, reader.arrays_begun());
  result.number_of_vertices = static_cast<std::int64_t>(reader.number_of_vertices());
  result.number_of_segments = static_cast<std::int64_t>(reader.number_of_segments());
  result.first_vertex = static_cast<std::int64_t>(own.begin(reader.number_of_vertices()));
  result.first_segment = static_cast<std::int64_t>(own.begin(reader.number_of_segments()));
  internal::take_all_but_segments(reader.graph(), result);
  slice = std::move(result);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_SLICES_H
