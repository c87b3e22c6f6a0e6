// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_DISTRIBUTE_MESH_2_H
#define CGAL_DISTRIBUTE_MESH_2_H

/// \file
/// A mesh of one rank of MPI given to all ranks, and put together again. A program links MPI.

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_defects.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/distribute_mesh.h>

#include <mpi.h>

#include <string>

namespace CGAL {

/// \addtogroup PkgQuadtreeMesh2Distributed
/// @{

/// Cuts a mesh of one rank into runs of triangles, one for each rank, all of the same length or one more. They are
/// those of the files of `IO::write_PVTU()` and `IO::write_MSH_parts()` with as many pieces. In a mesh of fewer
/// triangles than ranks, the last ranks get nothing.
///
/// All ranks of `comm` call this, as all functions here. What one of them throws, all throw.
///
/// O(n log n) for a mesh of n triangles at `root`; messages are shorter than 2^31 bytes. `root` needs memory for the
/// whole mesh and one part, or 256 MB of parts.
/// \param mesh counts at `root` alone, in the order that `renumber_by_place()` makes, so that parts are compact
/// \param pslg the graph that the mesh was made from, or an empty one; counts at `root` alone
/// \throws std::invalid_argument if the mesh is in another order
template <class Point>
Distributed_mesh_2<Point> distribute_mesh_2(MPI_Comm comm, const Indexed_mesh_2<Point>& mesh,
                                            const Pslg_2<Point>& pslg, int root = 0) {
  Quadtree_mesh_2::internal::Mpi_exchange exchange(comm);
  return Quadtree_mesh_2::internal::distribute_mesh(exchange, mesh, pslg, root);
}

/// Puts a mesh together at one rank: the one that was distributed, bit for bit. The others get an empty mesh. Linear
/// time; `root` needs memory for the whole mesh and one part.
/// \throws std::length_error if there are too many vertices or triangles for the indices of `Indexed_mesh_2`
template <class Point>
Indexed_mesh_2<Point> gather_mesh_2(MPI_Comm comm, const Distributed_mesh_2<Point>& mesh, int root = 0) {
  Quadtree_mesh_2::internal::Mpi_exchange exchange(comm);
  return Quadtree_mesh_2::internal::gather_mesh(exchange, mesh, root);
}

/// Says which of the invariants of `Distributed_mesh_2` does not hold, and at which rank. All ranks get the same text,
/// which is empty for a valid mesh. O(k log k) for k triangles and vertices of a rank.
template <class Point>
std::string defect_of_distributed_mesh_2(MPI_Comm comm, const Distributed_mesh_2<Point>& mesh) {
  using namespace Quadtree_mesh_2::internal;
  Mpi_exchange exchange(comm);
  return Mesh_defects<Mpi_exchange, Point>(exchange, mesh).find();
}

/// @}

} // namespace CGAL

#endif // CGAL_DISTRIBUTE_MESH_2_H
