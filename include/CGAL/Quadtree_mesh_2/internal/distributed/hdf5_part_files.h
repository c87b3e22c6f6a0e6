// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Files of HDF5 that all ranks write: the first one makes them with room for all values, then each rank writes its own.
// The bytes are those that one machine writes.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_HDF5_PART_FILES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_HDF5_PART_FILES_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_part.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/mesh_part_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_file.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_mesh_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_rows_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtk_grid.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Adds a file that all ranks write. Only the first one has it among its files.
/// \param write called with a writer that makes room, then, by all ranks, with one that writes rows
template <class Exchange, class Write>
void add_hdf5_together(Exchange& exchange, Replaced_files& files, const std::string& file_name,
                       const Write& write) {
  Archive_writer told;
  agree_on_work(exchange, [&] {
    if (exchange.rank() != 0) return;
    const std::string temporary = files.add_empty(file_name);
    Hdf5_writer out(temporary, file_name, Hdf5_writer::Values::BY_OTHERS);
    write(out);
    out.close();
    told(std::vector<std::string>{temporary}), told(out.places());
  });
  exchange.broadcast(told.bytes, 0);
  agree_on_work(exchange, [&] {
    Archive_reader reader(told.bytes);
    std::vector<std::string> temporary;
    std::vector<std::uint64_t> places;
    reader(temporary), reader(places);
    Hdf5_rows_writer out(temporary.front(), file_name, places);
    write(out);
    out.close();
  });
}

/// See `IO::write_VTKHDF()`.
template <class Exchange, class Point>
void write_vtkhdf_together(Exchange& exchange, const std::string& file_name,
                           const Distributed_mesh_2<Point>& mesh, const IO::Triangle_fields_2& own_fields) {
  const Mesh_part<Point> part(exchange, mesh);
  const IO::Triangle_fields_2 fields = part.with_ghosts(exchange, own_fields);
  const Vtk_grid<Point> grid = grid_of_part(exchange, part, mesh, fields);
  Replaced_files files;
  add_hdf5_together(exchange, files, file_name, [&](auto& out) { write_vtkhdf(out, grid); });
  commit_together(exchange, files);
}

/// See `IO::write_XDMF()`.
template <class Exchange, class Point>
void write_xdmf_together(Exchange& exchange, const std::string& file_name,
                         const Distributed_mesh_2<Point>& mesh, const IO::Triangle_fields_2& own_fields) {
  const Mesh_part<Point> part(exchange, mesh);
  const IO::Triangle_fields_2 fields = part.with_ghosts(exchange, own_fields);
  const Vtk_grid<Point> grid = grid_of_part(exchange, part, mesh, fields);
  const std::string stem = std::filesystem::path(file_name).replace_extension().string();
  Replaced_files files;
  Xdmf_writer<Point> writer(grid, std::filesystem::path(stem + ".h5").filename().string());
  add_hdf5_together(exchange, files, stem + ".h5", [&](auto& out) { writer.write_heavy(out); });
  agree_on_work(exchange, [&] {
    if (exchange.rank() == 0) files.add(stem + ".xdmf", writer.text());
  });
  commit_together(exchange, files);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_HDF5_PART_FILES_H
