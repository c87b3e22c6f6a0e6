// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Files of HDF5 that all ranks write together, by MPI-IO: each its own rows, in the layout that one machine writes.
// Only with an HDF5 that is built for MPI (Debian: libhdf5-openmpi-dev), which says so by H5_HAVE_PARALLEL.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_HDF5_TOGETHER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_HDF5_TOGETHER_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_part.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/mesh_part_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_file.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_mesh_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtk_grid.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <hdf5.h>
#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

#ifdef H5_HAVE_PARALLEL

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The ranks of an exchange as a team.
class Hdf5_ranks {
public:
  explicit Hdf5_ranks(Mpi_exchange& exchange)
      : exchange_(exchange), access_(H5Pcreate(H5P_FILE_ACCESS), H5Pclose),
        transfer_(H5Pcreate(H5P_DATASET_XFER), H5Pclose) {
    agree_on_work(exchange, [&] {
      if (H5Pset_fapl_mpio(access_.get(), exchange.communicator(), MPI_INFO_NULL) < 0 ||
          H5Pset_dxpl_mpio(transfer_.get(), H5FD_MPIO_COLLECTIVE) < 0)
        throw std::runtime_error("HDF5 does not write by MPI");
    });
  }

  Hdf5_team team() {
    Hdf5_team team;
    team.access = access_.get(), team.transfer = transfer_.get();
    team.agree = [this](const std::exception_ptr& error) { agree_on_error(exchange_, error); };
    team.greatest = [this](std::size_t n) {
      return static_cast<std::size_t>(exchange_.max(static_cast<std::int64_t>(n)));
    };
    return team;
  }

private:
  Mpi_exchange& exchange_;
  Hdf5_handle access_, transfer_;
};

/// Adds a file that all ranks write. Only the first one knows of its name for now.
/// \param write called with a writer, by all ranks
template <class Write>
void add_hdf5_together(Mpi_exchange& exchange, Replaced_files& files, const std::string& file_name,
                       const Write& write) {
  std::string temporary;
  agree_on_work(exchange, [&] {
    if (exchange.rank() == 0) temporary = files.add_empty(file_name);
  });
  Bytes bytes(temporary.begin(), temporary.end());
  exchange.broadcast(bytes, 0);
  temporary.assign(bytes.begin(), bytes.end());
  Hdf5_ranks ranks(exchange);
  Hdf5_writer out(temporary, file_name, ranks.team());
  write(out);
  out.close();
}

/// See `IO::write_VTKHDF()`.
template <class Point>
void write_vtkhdf_together(Mpi_exchange& exchange, const std::string& file_name,
                           const Distributed_mesh_2<Point>& mesh, const IO::Triangle_fields_2& own_fields) {
  const Mesh_part<Point> part(exchange, mesh);
  const IO::Triangle_fields_2 fields = part.with_ghosts(exchange, own_fields);
  const Vtk_grid<Point> grid = grid_of_part(exchange, part, mesh, fields);
  Replaced_files files;
  add_hdf5_together(exchange, files, file_name, [&](Hdf5_writer& out) { write_vtkhdf(out, grid); });
  commit_together(exchange, files);
}

/// See `IO::write_XDMF()`.
template <class Point>
void write_xdmf_together(Mpi_exchange& exchange, const std::string& file_name,
                         const Distributed_mesh_2<Point>& mesh, const IO::Triangle_fields_2& own_fields) {
  const Mesh_part<Point> part(exchange, mesh);
  const IO::Triangle_fields_2 fields = part.with_ghosts(exchange, own_fields);
  const Vtk_grid<Point> grid = grid_of_part(exchange, part, mesh, fields);
  const std::string stem = std::filesystem::path(file_name).replace_extension().string();
  Replaced_files files;
  Xdmf_writer<Point> writer(grid, std::filesystem::path(stem + ".h5").filename().string());
  add_hdf5_together(exchange, files, stem + ".h5", [&](Hdf5_writer& out) { writer.write_heavy(out); });
  agree_on_work(exchange, [&] {
    if (exchange.rank() == 0) files.add(stem + ".xdmf", writer.text());
  });
  commit_together(exchange, files);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // H5_HAVE_PARALLEL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_HDF5_TOGETHER_H
