// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "arrays.h"
#include "definitions.h"

#include <CGAL/IO/HTML.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

// Pages that show meshes in browsers. quadtree_mesh.results documents what goes in.

namespace quadtree_mesh_python {

namespace {

using Page_options = CGAL::IO::Html_options_2;
using Page_vertex = CGAL::Quadtree_mesh_2::Vertex_index;

/// Rows of indices, of vertices that there are: users may have changed the arrays of a mesh.
template <std::size_t columns>
std::vector<std::array<Page_vertex, columns>> rows_of_vertices(const py::object& array, std::size_t vertices,
                                                               const char* name) {
  const auto indices = array.cast<Input_array<std::int64_t>>();
  std::vector<std::array<Page_vertex, columns>> rows(rows_of(indices, columns, name));
  const std::int64_t* index = indices.data();
  for (auto& row : rows)
    for (Page_vertex& v : row) {
      if (*index < 0 || *index >= static_cast<std::int64_t>(vertices))
        throw std::invalid_argument(std::string(name) + " name vertex " + std::to_string(*index) + " of " +
                                    std::to_string(vertices));
      v = Page_vertex(static_cast<std::size_t>(*index++));
    }
  return rows;
}

CGAL::Indexed_mesh_2<Point> mesh_of_page(const py::dict& arrays) {
  CGAL::Indexed_mesh_2<Point> mesh;
  mesh.points = points_from(arrays["vertices"].cast<Input_array<double>>(), "vertices");
  mesh.triangles = rows_of_vertices<3>(arrays["triangles"], mesh.points.size(), "triangles");
  for (const auto& ends : rows_of_vertices<2>(arrays["segments"], mesh.points.size(), "segments"))
    mesh.constrained_edges.push_back({ends, {}});
  mesh.region_of_triangle = vector_from(arrays["regions"].cast<Input_array<int>>());
  if (!mesh.region_of_triangle.empty() && mesh.region_of_triangle.size() != mesh.triangles.size())
    throw std::invalid_argument("regions must have a number for each triangle");
  return mesh;
}

Page_options options_of_page(const py::dict& arrays, const std::string& title, const std::string& color) {
  using Color = Page_options::Color;
  const std::map<std::string, Color> colors{{"angle", Color::LEAST_ANGLE},
                                            {"largest_angle", Color::LARGEST_ANGLE},
                                            {"size", Color::SIZE},
                                            {"region", Color::REGION},
                                            {"none", Color::NONE}};
  const auto found = colors.find(color);
  if (found == colors.end())
    throw std::invalid_argument("color must be 'angle', 'largest_angle', 'size', 'region' or None, not '" +
                                color + "'");
  std::vector<Page_options::Triangle_index> unmet;
  for (const std::int64_t t : vector_from(arrays["unmet"].cast<Input_array<std::int64_t>>()))
    unmet.emplace_back(static_cast<std::size_t>(t));
  Page_options options;
  options.title(title).color_by(found->second).unmet_triangles(unmet);
  if (!arrays["coordinates"].is_none()) {
    std::vector<std::array<double, 2>> coordinates;
    for (const Point& p : points_from(arrays["coordinates"].cast<Input_array<double>>(), "vertices"))
      coordinates.push_back({p.x(), p.y()});
    options.coordinates(std::move(coordinates));
  }
  return options;
}

void write_html(const std::string& file, const py::dict& arrays, const std::string& title,
                const std::string& color) try {
  const auto mesh = mesh_of_page(arrays);
  const Page_options options = options_of_page(arrays, title, color);
  CGAL::Pslg_2<Point> graph;
  for (const double value : vector_from(arrays["region_values"].cast<Input_array<double>>()))
    graph.regions.push_back({Point(0, 0), value, 0});
  const py::gil_scoped_release unlock;
  CGAL::IO::write_HTML(file, mesh, graph, options);
} catch (const std::system_error& error) {
  PyErr_SetObject(PyExc_OSError, py::make_tuple(error.code().value(), error.what()).ptr());
  throw py::error_already_set();
}

} // namespace

void define_pages(py::module_& module) {
  module.def("write_html", &write_html, py::arg("file"), py::arg("arrays"), py::arg("title"),
             py::arg("color"));
}

} // namespace quadtree_mesh_python
