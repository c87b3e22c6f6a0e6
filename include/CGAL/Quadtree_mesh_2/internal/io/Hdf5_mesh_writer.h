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

/// See `IO::write_VTKHDF()`.
template <class Point>
void write_vtkhdf(Hdf5_writer& out, const Vtk_grid<Point>& grid) {
  const std::size_t points = grid.number_of_points(), cells = grid.number_of_cells(),
                    connections = grid.number_of_vertices_before(cells);
  const auto add_number = [&out](const char* path, std::size_t n) {
    out.add_array(path, 1, 0, [n](std::size_t, std::size_t) { return static_cast<std::int64_t>(n); });
  };
  const auto add_arrays = [&out](const std::string& group, std::size_t n, const auto& for_each_array) {
    out.add_group(group);
    for_each_array([&](const std::string& name, const auto& value_at) {
      out.add_array(group + '/' + hdf5_name(name), n, 0,
                    [&value_at](std::size_t i, std::size_t) { return value_at(i); });
    });
  };
  out.add_group("/VTKHDF");
  out.add_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
  out.add_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  add_number("/VTKHDF/NumberOfPoints", points);
  add_number("/VTKHDF/NumberOfCells", cells);
  add_number("/VTKHDF/NumberOfConnectivityIds", connections);
  out.add_array("/VTKHDF/Points", points, 3,
                [&](std::size_t v, std::size_t k) { return grid.coordinate(v, k); });
  out.add_array("/VTKHDF/Connectivity", connections, 0, [&](std::size_t i, std::size_t) {
    const auto [cell, k] = grid.place_of_connection(i);
    return static_cast<std::int64_t>(grid.vertex(cell, k).value());
  });
  out.add_array("/VTKHDF/Offsets", cells + 1, 0, [&](std::size_t c, std::size_t) {
    return static_cast<std::int64_t>(grid.number_of_vertices_before(c));
  });
  out.add_array("/VTKHDF/Types", cells, 0, [&](std::size_t c, std::size_t) { return grid.type(c); });
  add_arrays("/VTKHDF/PointData", points, [&](const auto& f) { grid.for_each_point_array(f); });
  add_arrays("/VTKHDF/CellData", cells, [&](const auto& f) { grid.for_each_cell_array(f); });
}

/// The text of XDMF, which says what is in the file of HDF5, while that is written.
template <class Point>
class Xdmf_writer {
public:
  /// \param heavy_name what the text calls the file of HDF5
  Xdmf_writer(const Vtk_grid<Point>& grid, std::string heavy_name)
      : grid_(grid), heavy_name_(Vtu_text::escaped(heavy_name)) {}

  void write_heavy(Hdf5_writer& out) {
    out_ = &out;
    const std::size_t points = grid_.number_of_points(), triangles = grid_.number_of_triangles(),
                      edges = grid_.number_of_edges();
    for (const char* group : {"/mesh", "/mesh/point_data", "/mesh/triangle_data", "/mesh/edge_data"})
      out.add_group(group);
    const std::string geometry = "<Geometry GeometryType=\"XY\">\n" +
                                 item("/mesh/points", points, 2,
                                      [&](std::size_t v, std::size_t k) { return grid_.coordinate(v, k); }) +
                                 "</Geometry>\n";
    std::string point_data, triangle_data, edge_data;
    const std::string triangle_cells = item("/mesh/triangles", triangles, 3, vertices_from(0)),
                      edge_cells = item("/mesh/edges", edges, 2, vertices_from(triangles));
    grid_.for_each_point_array([&](const std::string& name, const auto& value_at) {
      point_data += attribute("Node", name, "/mesh/point_data/", 0, points, value_at);
    });
    grid_.for_each_cell_array([&](const std::string& name, const auto& value_at) {
      if (name == "marker")
        edge_data += attribute("Cell", name, "/mesh/edge_data/", triangles, edges, value_at);
      else
        triangle_data += attribute("Cell", name, "/mesh/triangle_data/", 0, triangles, value_at);
    });
    text_ = opening() + "<Grid Name=\"mesh\" GridType=\"Uniform\">\n" + geometry +
            topology("\"Triangle\"", triangles, triangle_cells) + point_data + triangle_data + "</Grid>\n";
    if (edges > 0)
      text_ += "<Grid Name=\"edges\" GridType=\"Uniform\">\n" + geometry +
               topology("\"Polyline\" NodesPerElement=\"2\"", edges, edge_cells) + edge_data + "</Grid>\n";
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

  auto vertices_from(std::size_t first_cell) const {
    return [this, first_cell](std::size_t c, std::size_t k) {
      return static_cast<std::int64_t>(grid_.vertex(first_cell + c, k).value());
    };
  }

  template <class Value_at>
  std::string attribute(const char* center, const std::string& name, const std::string& folder,
                        std::size_t first, std::size_t n, const Value_at& value_at) {
    return "<Attribute Name=\"" + Vtu_text::escaped(name) + "\" AttributeType=\"Scalar\" Center=\"" + center +
           "\">\n" +
           item(folder + hdf5_name(name), n, 0,
                [&](std::size_t i, std::size_t) { return value_at(first + i); }) +
           "</Attribute>\n";
  }

  /// Writes an array. \returns what refers to it
  template <class Value_at>
  std::string item(const std::string& path, std::size_t n, std::size_t columns, const Value_at& value_at) {
    using Number = std::decay_t<decltype(value_at(n, n))>;
    out_->add_array(path, n, columns, value_at);
    return "<DataItem Dimensions=\"" + std::to_string(n) +
           (columns > 0 ? ' ' + std::to_string(columns) : "") + "\" NumberType=\"" +
           (std::is_floating_point_v<Number> ? "Float" : "Int") + "\" Precision=\"" +
           std::to_string(sizeof(Number)) + "\" Format=\"HDF\">" + heavy_name_ + ':' +
           Vtu_text::escaped(path) + "</DataItem>\n";
  }

  const Vtk_grid<Point>& grid_;
  std::string heavy_name_, text_;
  Hdf5_writer* out_ = nullptr;
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
