// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_DISTRIBUTED_QUALITY_MESHER_2_H
#define CGAL_DISTRIBUTED_QUALITY_MESHER_2_H

/// \file
/// Graphs meshed by all ranks of MPI. A program links MPI.

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_slice_2.h>
#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/gather_slices.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/mesh_by_all_parts.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/tags.h>

#include <mpi.h>

#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Distributed
/// Triangulates the domain of a planar straight-line graph on all ranks of an MPI communicator.
///
/// The mesh is that of `Quality_mesher_2` with the same options, renumbered by `renumber_by_place()`, bit for bit, for
/// any number of ranks. Each rank gets its part of it, as `distribute_mesh_2()` would give it.
///
/// All ranks triangulate the domain, refine and coarsen together, in rounds of blocks, and finish the mesh. The first
/// rank has the triangles of the domain before the rounds, and finds the acute corners in them. A rank needs memory for
/// its share of the mesh, for the seams between blocks, and for the graph. If options ask for more than rounds do, such
/// as `thin()` or `conform()`, or rounds leave bad triangles, the first rank goes on with the whole mesh. If a graph is
/// too small for two blocks of some 12 000 vertices, the first rank does everything; if many of its vertices are along
/// smooth curves, or it is refused, that rank triangulates it.
///
/// All ranks have to call constructor and operators, and to give the same options. Functions of the user, such as a
/// size field, are called at all ranks, and have to return the same at each. The progress callback is called at the
/// first one. What an operator throws, it throws at all ranks; types derived from `Pslg_error_2` become that. An
/// error that is no fault of input, options or the user's functions, such as no memory left, may be thrown at one rank
/// alone, while others wait for it: end the program by `MPI_Abort()` then.
/// \tparam Traits `Filtered_quadtree_traits_2` over some kernel
/// \tparam ConcurrencyTag how each rank works: `Sequential_tag`, or `Parallel_tag` for several threads of each rank
template <class Traits = Filtered_quadtree_traits_2<>, class ConcurrencyTag = Sequential_tag>
class Distributed_quality_mesher_2 {
public:
  /// \name Types
  /// @{

  /// The traits.
  using Geom_traits = Traits;
  /// A point of the input and of the mesh.
  using Point_2 = typename Traits::Point_2;
  /// The input, at one rank.
  using Pslg = Pslg_2<Point_2>;
  /// The input, of one rank.
  using Pslg_slice = Pslg_slice_2<Point_2>;
  /// The result, of one rank.
  using Mesh = Distributed_mesh_2<Point_2>;
  /// @}

  /// A mesher with these options.
  /// \throws std::invalid_argument if an option is out of its range
  explicit Distributed_quality_mesher_2(MPI_Comm comm, Quality_mesh_options_2 options = {},
                                        const Traits& traits = Traits())
      : comm_(comm), mesher_(std::move(options), traits) {}

  /// Returns this rank's part of the mesh of the domain of a graph that the first rank has.
  /// \param pslg counts at the first rank alone
  /// \throws Pslg_error_2 for input that cannot be meshed, see its kinds
  /// \throws std::invalid_argument if ranks have different options, or there is a folder for checkpoints among them
  Mesh operator()(const Pslg& pslg) {
    Quadtree_mesh_2::internal::Mpi_exchange exchange(comm_);
    return Quadtree_mesh_2::internal::mesh_by_all_parts(exchange, mesher_, pslg, report_);
  }

  /// The same for a graph of which each rank has a slice. The first rank lets go of most of the graph while it meshes,
  /// which it does not of one that it is given whole.
  /// \throws std::length_error if there are more vertices or segments than the first rank's 32-bit indices can name
  Mesh operator()(const Pslg_slice& slice) {
    Quadtree_mesh_2::internal::Mpi_exchange exchange(comm_);
    Pslg pslg = Quadtree_mesh_2::internal::gather_slices(exchange, slice);
    return Quadtree_mesh_2::internal::mesh_by_all_parts(exchange, mesher_, std::move(pslg), report_);
  }
  /// The same; the slice is empty afterward, and its memory is free while the mesh is made. All ranks may call either.
  Mesh operator()(Pslg_slice&& slice) {
    Quadtree_mesh_2::internal::Mpi_exchange exchange(comm_);
    Pslg pslg = Quadtree_mesh_2::internal::gather_slices(exchange, slice);
    slice = Pslg_slice();
    return Quadtree_mesh_2::internal::mesh_by_all_parts(exchange, mesher_, std::move(pslg), report_);
  }

  /// Sets by which model the construction by quadtrees finds neighbors of vertices: see `Quality_mesher_2`.
  template <class Neighbors>
  Distributed_quality_mesher_2& find_neighbors_by() {
    mesher_.template find_neighbors_by<Neighbors>();
    return *this;
  }

  /// What the last run reached, the same at all ranks. Triangles are those of the whole mesh, by their numbers, and
  /// seconds those of the first rank.
  const Quality_mesh_report_2& report() const { return report_; }
  /// The options of this mesher.
  const Quality_mesh_options_2& options() const { return mesher_.options(); }

private:
  MPI_Comm comm_;
  Quality_mesher_2<Traits, ConcurrencyTag> mesher_;
  Quality_mesh_report_2 report_;
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_QUALITY_MESHER_2_H
