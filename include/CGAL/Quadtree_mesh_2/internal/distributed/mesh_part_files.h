// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Files that each rank writes by itself: pieces of VTK's grids and parts of Gmsh's meshes, the same bytes as those of
// as many pieces of the whole mesh. All appear under their names, or none.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_PART_FILES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_PART_FILES_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/IO/io.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_part.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/Msh_parts_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/Pvtu_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/mesh_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_entities.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtk_grid.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The end of all writing: files of all parts replace older ones, or those of none do.
template <class Exchange>
void commit_together(Exchange& exchange, Replaced_files& files) {
  agree_on_work(exchange, [&] { files.put_in_place(); });
  files.keep();
}

/// The least of the numbers of all parts, none of which is NaN.
template <class Exchange>
double least_of_all(Exchange& exchange, double x) {
  // As integers doubles have the order of their sizes, and negative ones come the other way round.
  std::int64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  const auto in_order = [](std::int64_t i) {
    return i < 0 ? std::numeric_limits<std::int64_t>::min() - i : i;
  };
  bits = in_order(exchange.min(in_order(bits)));
  std::memcpy(&x, &bits, sizeof bits);
  return x;
}

/// The grid of a part, with the least values of the whole mesh.
template <class Exchange, class Point>
Vtk_grid<Point> grid_of_part(Exchange& exchange, const Mesh_part<Point>& part,
                             const Distributed_mesh_2<Point>& mesh, const IO::Triangle_fields_2& fields) {
  Vtk_grid<Point> grid(part.mesh(), mesh.legend, part.outside(), fields, part.numbers());
  grid.replace_least_values([&](double least) { return least_of_all(exchange, least); });
  return grid;
}

/// See `IO::write_PVTU()`.
template <class Exchange, class Point>
void write_pvtu_together(Exchange& exchange, const std::string& file_name,
                         const Distributed_mesh_2<Point>& mesh, const IO::Triangle_fields_2& own_fields,
                         IO::Mode mode) {
  const Mesh_part<Point> part(exchange, mesh);
  const IO::Triangle_fields_2 fields = part.with_ghosts(exchange, own_fields);
  const Vtk_grid<Point> grid = grid_of_part(exchange, part, mesh, fields);
  const auto rank = static_cast<std::size_t>(mesh.rank),
             pieces = static_cast<std::size_t>(mesh.number_of_parts());
  Replaced_files files;
  agree_on_work(exchange, [&] {
    if (rank < pieces) {
      std::vector<std::size_t> others;
      for (std::size_t cell = grid.number_of_triangles(); cell < grid.number_of_cells(); ++cell)
        others.push_back(cell);
      const Grid_piece<Point> piece(grid, 0, mesh.number_of_own_triangles(), others, part.unused());
      files.add(piece_file_name(file_name, rank + 1, ".vtu"),
                Vtu_writer<Point, Grid_piece<Point>>(grid, piece).text(mode));
    }
    if (rank == 0) files.add(file_name, Pvtu_text<Point>(grid).text(file_name, pieces));
  });
  commit_together(exchange, files);
}

/// The survey of all parts, for all.
template <class Exchange>
Msh_survey survey_of_all(Exchange& exchange, const Msh_survey& own) {
  struct Entry {
    std::int64_t member, key;
    Msh_box box;
  };
  constexpr std::map<int, Msh_box> Msh_survey::*members[] = {&Msh_survey::regions, &Msh_survey::markers,
                                                             &Msh_survey::vertices};
  const auto entries_of = [&](const Msh_survey& survey) {
    std::vector<Entry> entries;
    for (std::int64_t m = 0; m < 3; ++m)
      for (const auto& [key, box] : survey.*members[m]) entries.push_back({m, key, box});
    return entries;
  };
  const auto add = [&](Msh_survey& survey, const std::vector<Entry>& entries) {
    for (const Entry& e : entries) (survey.*members[e.member])[static_cast<int>(e.key)].add(e.box);
  };
  Msh_survey all;
  for (const auto& from_part : exchange_records(exchange, Records_of_parts<Entry>{{0, entries_of(own)}}))
    add(all, from_part.second);
  Bytes bytes = bytes_of(entries_of(all));
  exchange.broadcast(bytes, 0);
  Msh_survey result;
  add(result, records_of<Entry>(bytes));
  return result;
}

/// See `IO::write_MSH_parts()`.
template <class Exchange, class Point>
void write_msh_together(Exchange& exchange, const std::string& file_name,
                        const Distributed_mesh_2<Point>& mesh) {
  const Mesh_part<Point> part(exchange, mesh);
  const Mesh_numbers numbers = part.numbers();
  const Msh_survey survey = survey_of_all(exchange, Msh_survey::of(part.mesh(), numbers));
  const auto rank = static_cast<std::size_t>(mesh.rank),
             parts = static_cast<std::size_t>(mesh.number_of_parts());
  Replaced_files files;
  agree_on_work(exchange, [&] {
    if (rank >= parts) return;
    const Msh_entities<Point> entities(part.mesh(), mesh.legend, survey, numbers);
    const std::size_t own = mesh.number_of_own_triangles();
    Msh_part of_file{rank, parts, 0, own, {}, {}, {}, part.unused()};
    for (std::size_t curve = 0; curve < entities.curves().size(); ++curve)
      for (const std::size_t e : entities.curves()[curve].elements) of_file.edges.push_back({curve, e});
    for (std::size_t t = own; t < mesh.triangles.size(); ++t) {
      of_file.ghosts.push_back(t);
      of_file.owners_of_ghosts.push_back(
          static_cast<std::size_t>(mesh.owner_of_triangle(mesh.number_of_triangle(t))));
    }
    files.add(piece_file_name(file_name, rank + 1, ".msh"),
              Msh_part_writer<Point>(part.mesh(), entities, of_file).text());
  });
  commit_together(exchange, files);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_PART_FILES_H
