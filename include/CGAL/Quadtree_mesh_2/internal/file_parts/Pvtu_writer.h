// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_PVTU_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_PVTU_WRITER_H

#include <CGAL/IO/io.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/mesh_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtk_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtu_writer.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Some cells of a grid with copies of their points: a part for `Vtu_writer`.
template <class Point>
class Grid_piece {
public:
  /// \param begin,end the triangles
  /// \param others more cells
  /// \param points more points
  Grid_piece(const Vtk_grid<Point>& grid, std::size_t begin, std::size_t end,
             const std::vector<std::size_t>& others, std::vector<std::uint32_t> points)
      : points_(std::move(points)) {
    cells_.reserve(end - begin + others.size());
    for (std::size_t t = begin; t < end; ++t) cells_.push_back(t);
    cells_.insert(cells_.end(), others.begin(), others.end());
    points_.reserve(points_.size() + 3 * cells_.size());
    for (const std::size_t cell : cells_)
      for (std::size_t k = 0; k < grid.size(cell); ++k) points_.push_back(grid.vertex(cell, k).value());
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }

  std::size_t number_of_points() const { return points_.size(); }
  std::size_t number_of_cells() const { return cells_.size(); }
  std::size_t point(std::size_t i) const { return points_[i]; }
  std::size_t cell(std::size_t i) const { return cells_[i]; }
  std::int64_t number_of(Vertex_index v) const {
    return std::lower_bound(points_.begin(), points_.end(), v.value()) - points_.begin();
  }
  static constexpr bool has_global_numbers = true;

private:
  std::vector<std::uint32_t> points_; // in their order
  std::vector<std::size_t> cells_;
};

/// The text of the file that names the pieces of a grid.
template <class Point>
class Pvtu_text {
public:
  explicit Pvtu_text(const Vtk_grid<Point>& grid) : grid_(grid) {}

  std::string text(const std::string& file_name, std::size_t pieces) const {
    std::string text = Vtu_text::opening("PUnstructuredGrid") + "<PUnstructuredGrid GhostLevel=\"0\">\n";
    add_arrays(text, "PointData", [this](const auto& f) { grid_.for_each_point_array(f); });
    add_arrays(text, "CellData", [this](const auto& f) { grid_.for_each_cell_array(f); });
    text +=
        "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
    const std::string name = std::filesystem::path(file_name).filename().string();
    for (std::size_t p = 0; p < pieces; ++p)
      text += "<Piece Source=\"" + Vtu_text::escaped(piece_file_name(name, p + 1, ".vtu")) + "\"/>\n";
    return text += "</PUnstructuredGrid>\n</VTKFile>\n";
  }

private:
  template <class For_each_array>
  static void add_arrays(std::string& text, const std::string& data, const For_each_array& for_each_array) {
    const auto add = [&text](const std::string& name, const std::string& type) {
      text += "<PDataArray type=\"" + type + "\" Name=\"" + Vtu_text::escaped(name) + "\"/>\n";
    };
    text += vtu_data_tag('P' + data, data);
    for_each_array([&add](const std::string& name, const auto& value_at) {
      add(name, Vtu_text::type_name<std::decay_t<decltype(value_at(0))>>());
    });
    add(global_numbers_of(data), Vtu_text::type_name<std::int64_t>());
    text += "</P" + data + ">\n";
  }

  const Vtk_grid<Point>& grid_;
};

/// See `IO::write_PVTU()`. One piece is in memory at a time.
template <class Point>
class Pvtu_writer {
public:
  Pvtu_writer(const Vtk_grid<Point>& grid, std::size_t pieces)
      : grid_(grid), runs_(grid.number_of_triangles(), pieces), others_(runs_.size()) {
    for (std::size_t cell = grid.number_of_triangles(); cell < grid.number_of_cells(); ++cell) {
      const std::size_t t = grid.triangle_of(cell);
      others_[t == no_triangle ? runs_.size() - 1 : runs_.run_of(t)].push_back(cell);
    }
    find_unused_points();
  }

  void add_to(Replaced_files& files, const std::string& file_name, IO::Mode mode) {
    for (std::size_t p = 0; p < runs_.size(); ++p) {
      const bool is_last = p + 1 == runs_.size();
      const Grid_piece<Point> piece(grid_, runs_.begin(p), runs_.begin(p + 1), others_[p],
                                    is_last ? std::move(unused_) : std::vector<std::uint32_t>());
      files.add(piece_file_name(file_name, p + 1, ".vtu"),
                Vtu_writer<Point, Grid_piece<Point>>(grid_, piece).text(mode));
    }
    files.add(file_name, Pvtu_text<Point>(grid_).text(file_name, runs_.size()));
  }

private:
  void find_unused_points() {
    std::vector<char> is_used(grid_.number_of_points(), 0);
    for (std::size_t cell = 0; cell < grid_.number_of_cells(); ++cell)
      for (std::size_t k = 0; k < grid_.size(cell); ++k) is_used[std::size_t(grid_.vertex(cell, k))] = 1;
    for (std::size_t v = 0; v < is_used.size(); ++v)
      if (is_used[v] == 0) unused_.push_back(static_cast<std::uint32_t>(v));
  }

  const Vtk_grid<Point>& grid_;
  Triangle_runs runs_;
  std::vector<std::vector<std::size_t>> others_; // cells of each piece that are no triangles
  std::vector<std::uint32_t> unused_;            // points of no cell
};

/// \param pieces 0 for the usual number
template <class Point>
void add_pvtu_files(Replaced_files& files, const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                    const Pslg_2<Point>& pslg, const IO::Triangle_fields_2& fields, std::size_t pieces,
                    IO::Mode mode) {
  const Vtk_grid<Point> grid(mesh, pslg, fields);
  if (pieces == 0) pieces = usual_number_of_pieces(grid.number_of_triangles());
  Pvtu_writer<Point>(grid, pieces).add_to(files, file_name, mode);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_PVTU_WRITER_H
