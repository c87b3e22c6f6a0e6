// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_MESH_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_MESH_WRITER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_file.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Mesh_numbers.h>
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
#include <vector>

// Meshes in files of HDF5: VTK's own layout (https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html), and
// one that an XDMF 3 file describes (https://www.xdmf.org/index.php/XDMF_Model_and_Format).

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A name without the character that parts the names of HDF5.
inline std::string hdf5_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

/// The rows of arrays that a grid writes, which is a whole mesh or the part of one process.
template <class Point>
class Grid_rows {
public:
  explicit Grid_rows(const Vtk_grid<Point>& grid) : grid_(grid) {
    const Mesh_numbers& numbers = grid.numbers();
    const Mesh_numbers::Counts& whole = numbers.counts();
    const std::size_t own = numbers.number_of_own_triangles(), n = grid.number_of_triangles();
    const Mesh_numbers::Range& vertices = numbers.own_vertices();
    points.all = whole.vertices, triangles.all = whole.triangles, edges.all = whole.edges;
    cells.all = whole.triangles + whole.edges + whole.outside;
    connections.all = connections_before(cells.all);
    if (vertices.size() > 0)
      points.add(numbers.vertex(Vertex_index(vertices.begin)), vertices.begin, vertices.size());
    if (own > 0) triangles.add(numbers.triangle(0), 0, own), add_cells(0, own);
    for (std::size_t e = 0; e < grid.number_of_edges(); ++e) edges.add(numbers.edge(e), n + e, 1);
    add_cells(n, grid.number_of_cells());
    offsets.all = cells.all + 1;
    offsets.runs = cells.runs;
    if (numbers.is_first()) offsets.add(cells.all, grid.number_of_cells(), 1); // where the cells end
  }

  /// Of cells before one of the whole mesh.
  std::size_t connections_before(std::size_t cell) const { return 2 * cell + std::min(cell, triangles.all); }

  Array_rows points, cells, connections, offsets;
  Array_rows triangles, edges; ///< of arrays with a row for each; called what the grid calls the cells

private:
  void add_cells(std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      const std::size_t number = grid_.number_of_cell(cell);
      cells.add(number, cell, 1);
      connections.add(connections_before(number), grid_.number_of_vertices_before(cell), grid_.size(cell));
    }
  }

  const Vtk_grid<Point>& grid_;
};

/// See `IO::write_VTKHDF()`.
/// \tparam Out `Hdf5_writer`, or `Hdf5_rows_writer` for a part
template <class Out, class Point>
void write_vtkhdf(Out& out, const Vtk_grid<Point>& grid) {
  const Grid_rows<Point> rows(grid);
  const Array_rows one = grid.numbers().is_first() ? Array_rows::whole(1) : Array_rows{1, {}};
  const auto add_number = [&](const char* path, std::size_t n) {
    out.add_array(path, one, 0, [n](std::size_t, std::size_t) { return static_cast<std::int64_t>(n); });
  };
  const auto add_arrays = [&out](const std::string& group, const Array_rows& n, const auto& for_each_array) {
    out.add_group(group);
    for_each_array([&](const std::string& name, const auto& value_at) {
      out.add_array(group + '/' + hdf5_name(name), n, 0,
                    [&value_at](std::size_t i, std::size_t) { return value_at(i); });
    });
  };
  out.add_group("/VTKHDF");
  out.add_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
  out.add_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  add_number("/VTKHDF/NumberOfPoints", rows.points.all);
  add_number("/VTKHDF/NumberOfCells", rows.cells.all);
  add_number("/VTKHDF/NumberOfConnectivityIds", rows.connections.all);
  out.add_array("/VTKHDF/Points", rows.points, 3,
                [&](std::size_t v, std::size_t k) { return grid.coordinate(v, k); });
  out.add_array("/VTKHDF/Connectivity", rows.connections, 0, [&](std::size_t i, std::size_t) {
    const auto [cell, k] = grid.place_of_connection(i);
    return static_cast<std::int64_t>(grid.numbers().vertex(grid.vertex(cell, k)));
  });
  out.add_array("/VTKHDF/Offsets", rows.offsets, 0, [&](std::size_t c, std::size_t) {
    const std::size_t number = c == grid.number_of_cells() ? rows.cells.all : grid.number_of_cell(c);
    return static_cast<std::int64_t>(rows.connections_before(number));
  });
  out.add_array("/VTKHDF/Types", rows.cells, 0, [&](std::size_t c, std::size_t) { return grid.type(c); });
  add_arrays("/VTKHDF/PointData", rows.points, [&](const auto& f) { grid.for_each_point_array(f); });
  add_arrays("/VTKHDF/CellData", rows.cells, [&](const auto& f) { grid.for_each_cell_array(f); });
}

/// The text of XDMF, which says what is in the file of HDF5, while that is written.
template <class Point>
class Xdmf_writer {
public:
  /// \param heavy_name what the text calls the file of HDF5
  Xdmf_writer(const Vtk_grid<Point>& grid, std::string heavy_name)
      : grid_(grid), heavy_name_(Vtu_text::escaped(heavy_name)) {}

  /// \tparam Out as above
  template <class Out>
  void write_heavy(Out& out) {
    const Grid_rows<Point> rows(grid_);
    for (const char* group : {"/mesh", "/mesh/point_data", "/mesh/triangle_data", "/mesh/edge_data"})
      out.add_group(group);
    const std::string geometry = "<Geometry GeometryType=\"XY\">\n" +
                                 item(out, "/mesh/points", rows.points, 2,
                                      [&](std::size_t v, std::size_t k) { return grid_.coordinate(v, k); }) +
                                 "</Geometry>\n";
    std::string point_data, triangle_data, edge_data;
    const auto vertex_at = [this](std::size_t cell, std::size_t k) {
      return static_cast<std::int64_t>(grid_.numbers().vertex(grid_.vertex(cell, k)));
    };
    const std::string triangle_cells = item(out, "/mesh/triangles", rows.triangles, 3, vertex_at),
                      edge_cells = item(out, "/mesh/edges", rows.edges, 2, vertex_at);
    grid_.for_each_point_array([&](const std::string& name, const auto& value_at) {
      point_data += attribute(out, "Node", name, "/mesh/point_data/", rows.points, value_at);
    });
    grid_.for_each_cell_array([&](const std::string& name, const auto& value_at) {
      if (name == "marker")
        edge_data += attribute(out, "Cell", name, "/mesh/edge_data/", rows.edges, value_at);
      else
        triangle_data += attribute(out, "Cell", name, "/mesh/triangle_data/", rows.triangles, value_at);
    });
    text_ = opening() + "<Grid Name=\"mesh\" GridType=\"Uniform\">\n" + geometry +
            topology("\"Triangle\"", rows.triangles.all, triangle_cells) + point_data + triangle_data +
            "</Grid>\n";
    if (rows.edges.all > 0)
      text_ += "<Grid Name=\"edges\" GridType=\"Uniform\">\n" + geometry +
               topology("\"Polyline\" NodesPerElement=\"2\"", rows.edges.all, edge_cells) + edge_data +
               "</Grid>\n";
    text_ += "</Domain>\n</Xdmf>\n";
  }

  const std::string& text() const { return text_; }

private:
  static std::string opening() {
    return "<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf "
           "Version=\"3.0\">\n<Domain>\n";
  }
  static std::string topology(const std::string& type, std::size_t n, const std::string& cells) {
    return "<Topology TopologyType=" + type + " NumberOfElements=\"" + std::to_string(n) + "\">\n" + cells +
           "</Topology>\n";
  }

  template <class Out, class Value_at>
  std::string attribute(Out& out, const char* center, const std::string& name, const std::string& folder,
                        const Array_rows& rows, const Value_at& value_at) {
    return "<Attribute Name=\"" + Vtu_text::escaped(name) + "\" AttributeType=\"Scalar\" Center=\"" + center +
           "\">\n" +
           item(out, folder + hdf5_name(name), rows, 0,
                [&](std::size_t i, std::size_t) { return value_at(i); }) +
           "</Attribute>\n";
  }

  /// Writes an array. \returns what refers to it
  template <class Out, class Value_at>
  std::string item(Out& out, const std::string& path, const Array_rows& rows, std::size_t columns,
                   const Value_at& value_at) {
    using Number = std::decay_t<decltype(value_at(columns, columns))>;
    out.add_array(path, rows, columns, value_at);
    return "<DataItem Dimensions=\"" + std::to_string(rows.all) +
           (columns > 0 ? ' ' + std::to_string(columns) : "") + "\" NumberType=\"" +
           (std::is_floating_point_v<Number> ? "Float" : "Int") + "\" Precision=\"" +
           std::to_string(sizeof(Number)) + "\" Format=\"HDF\">" + heavy_name_ + ':' +
           Vtu_text::escaped(path) + "</DataItem>\n";
  }

  const Vtk_grid<Point>& grid_;
  std::string heavy_name_, text_;
};

template <class Point>
void add_vtkhdf_file(Replaced_files& files, const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                     const Pslg_2<Point>& pslg, const IO::Triangle_fields_2& fields) {
  const Vtk_grid<Point> grid(mesh, pslg, fields);
  files.add_by(file_name, [&](const std::string& temporary) {
    Hdf5_writer out(temporary, file_name);
    write_vtkhdf(out, grid);
    out.close();
  });
}

/// \param stem of both files
template <class Point>
void add_xdmf_files(Replaced_files& files, const std::string& stem, const Indexed_mesh_2<Point>& mesh,
                    const Pslg_2<Point>& pslg, const IO::Triangle_fields_2& fields) {
  const Vtk_grid<Point> grid(mesh, pslg, fields);
  const std::string heavy = stem + ".h5";
  Xdmf_writer<Point> writer(grid, std::filesystem::path(heavy).filename().string());
  files.add_by(heavy, [&](const std::string& temporary) {
    Hdf5_writer out(temporary, heavy);
    writer.write_heavy(out);
    out.close();
  });
  files.add(stem + ".xdmf", writer.text());
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_MESH_WRITER_H
