// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_VTK_GRID_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_VTK_GRID_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Mesh_numbers.h>
#include <CGAL/Quadtree_mesh_2/internal/io/triangles_at_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/Edge_finder.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A segment of the input of which nothing is in the mesh.
struct Outside_segment {
  std::array<Vertex_index, 2> ends; ///< vertices of the mesh
  std::size_t segment;              ///< of the input
  int marker;                       ///< of the segment; 0 for none
};

/// All of them, in the order of the input. Takes linear time.
template <class Point>
std::vector<Outside_segment> outside_segments(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg) {
  std::vector<Outside_segment> outside;
  Indexed_vector<Segment_index, char> is_in_mesh(pslg.segments.size(), 0);
  for (const auto& e : mesh.constrained_edges)
    if (is_in_mesh.has(e.segment)) is_in_mesh[e.segment] = 1;
  for (const Segment_index s : is_in_mesh.ids())
    if (is_in_mesh[s] == 0)
      outside.push_back({pslg.segment(s), std::size_t(s),
                         pslg.segment_markers.empty() ? 0 : pslg.segment_markers[std::size_t(s)]});
  if (outside.empty() || mesh.input_index.empty()) return outside;
  Indexed_vector<Vertex_index, Vertex_index> vertex_of_input(pslg.vertices.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (vertex_of_input.has(mesh.input_index[v])) vertex_of_input[mesh.input_index[v]] = Vertex_index(v);
  for (Outside_segment& s : outside)
    for (Vertex_index& v : s.ends) v = vertex_of_input[v];
  return outside;
}

/// A mesh as an unstructured grid of VTK: what all files for ParaView have. See `IO::write_VTU()`.
///
/// Cells are the triangles, then the constrained edges, then the segments of which nothing is in the mesh. Values are
/// made when they are asked for, so that nothing of the mesh is copied: the grid itself takes memory for edges alone.
/// The mesh may be a part of another one, with numbers of its own; see `Mesh_numbers`.
template <class Point>
class Vtk_grid {
public:
  /// Keeps references.
  /// \throws std::invalid_argument if a field does not have a number for each triangle
  Vtk_grid(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, const IO::Triangle_fields_2& fields,
           IO::Element_order order = IO::Element_order::FIRST)
      : Vtk_grid(mesh, pslg, fields, outside_segments(mesh, pslg)) {
    if (order == IO::Element_order::SECOND) nodes_ = second_order_nodes<Sequential_tag>(mesh);
  }
  /// A part of a mesh, of first order.
  /// \param pslg of which the regions count
  Vtk_grid(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, std::vector<Outside_segment> outside,
           const IO::Triangle_fields_2& fields, Mesh_numbers numbers)
      : mesh_(mesh), pslg_(pslg), fields_(fields), outside_(std::move(outside)),
        numbers_(std::move(numbers)) {
    for (const IO::Triangle_field_2& field : fields)
      if (field.values.size() != mesh.triangles.size())
        throw std::invalid_argument("the field '" + field.name + "' has " +
                                    std::to_string(field.values.size()) + " numbers for " +
                                    std::to_string(mesh.triangles.size()) + " triangles");
    triangles_at_ = triangles_at_edges(mesh);
  }

  const Mesh_numbers& numbers() const { return numbers_; }
  std::size_t number_of_points() const { return mesh_.points.size() + nodes_.points.size(); }
  std::size_t number_of_triangles() const { return mesh_.triangles.size(); }
  std::size_t number_of_edges() const { return mesh_.constrained_edges.size(); }
  std::size_t number_of_cells() const { return number_of_triangles() + number_of_edges() + outside_.size(); }

  /// What a cell is called in the whole mesh.
  std::size_t number_of_cell(std::size_t cell) const {
    if (is_triangle(cell)) return numbers_.triangle(cell);
    const Mesh_numbers::Counts& whole = numbers_.counts();
    const std::size_t e = cell - number_of_triangles();
    return whole.triangles + (is_edge(cell) ? numbers_.edge(e) : whole.edges + e - number_of_edges());
  }
  bool is_triangle(std::size_t cell) const { return cell < number_of_triangles(); }
  bool is_of_second_order() const { return !nodes_.points.empty(); }
  /// How many vertices and nodes a cell has. What is outside has no nodes.
  std::size_t size(std::size_t cell) const {
    if (is_triangle(cell)) return is_of_second_order() ? 6 : 3;
    return is_edge(cell) && is_of_second_order() ? 3 : 2;
  }
  /// Nodes come after vertices; the first one of a triangle is between its first two vertices.
  Vertex_index vertex(std::size_t cell, std::size_t k) const {
    if (is_triangle(cell))
      return k < 3 ? mesh_.triangles[cell][k] : nodes_.nodes_of_triangle[cell][(k + 2) % 3];
    if (is_edge(cell)) {
      const std::size_t e = cell - number_of_triangles();
      return k < 2 ? mesh_.constrained_edges[e].vertices[k] : node_of_edge(e);
    }
    return outside_[cell - number_of_triangles() - number_of_edges()].ends[k];
  }
  /// Of all cells before.
  /// \pre the grid is of first order; this holds for the next function, too
  std::size_t number_of_vertices_before(std::size_t cell) const {
    return 2 * cell + std::min(cell, number_of_triangles());
  }
  /// The cell and its corner of vertex `i` in the list of the vertices of all cells.
  std::pair<std::size_t, std::size_t> place_of_connection(std::size_t i) const {
    const std::size_t of_triangles = 3 * number_of_triangles();
    if (i < of_triangles) return {i / 3, i % 3};
    return {number_of_triangles() + (i - of_triangles) / 2, (i - of_triangles) % 2};
  }
  /// VTK's number of the kind of cell.
  std::uint8_t type(std::size_t cell) const {
    constexpr std::uint8_t line = 3, triangle = 5, quadratic_line = 21, quadratic_triangle = 22;
    if (is_triangle(cell)) return is_of_second_order() ? quadratic_triangle : triangle;
    return size(cell) == 3 ? quadratic_line : line;
  }
  /// The triangle to whose piece of the mesh a cell belongs; `no_triangle` for none.
  std::size_t triangle_of(std::size_t cell) const {
    if (is_triangle(cell)) return cell;
    return is_edge(cell) ? triangles_at_[cell - number_of_triangles()][0] : no_triangle;
  }

  /// `x`, `y` and 0 of a point.
  double coordinate(std::size_t point, std::size_t k) const {
    if (point >= mesh_.points.size()) return k == 2 ? 0. : nodes_.points[point - mesh_.points.size()][k];
    const Point& p = mesh_.points[point];
    return k == 0 ? as_double(p.x()) : k == 1 ? as_double(p.y()) : 0.;
  }

  /// Calls `f(name, value_at)` for each array of the points; `value_at(point)` returns a number.
  template <class F>
  void for_each_point_array(const F& f) const {
    if (!mesh_.vertex_markers.empty())
      f("marker", [this](std::size_t v) { return static_cast<std::int32_t>(marker_of_point(v)); });
    if (!mesh_.input_index.empty())
      f("input_index", [this](std::size_t v) {
        const Vertex_index i = v < mesh_.points.size() ? mesh_.input_index[v] : Vertex_index();
        return i.is_valid() ? static_cast<std::int64_t>(i.value()) : -1;
      });
  }

  /// Calls `f(name, value_at)` for each array of the cells; `value_at(cell)` returns a number.
  template <class F>
  void for_each_cell_array(const F& f) const {
    f("region", [this](std::size_t c) { return static_cast<std::int32_t>(is_triangle(c) ? region(c) : -1); });
    f("marker", [this](std::size_t c) { return static_cast<std::int32_t>(marker(c)); });
    for_each_triangle_array(
        [this, &f](const std::string& name, const auto& value) { this->add_for_all(f, name, value); });
  }

  /// Of a part of a mesh: puts `f(least)` in place of the least value of the part's triangles, for each array that has
  /// one, in their order. Infinity stands for the least value of no triangles, on both sides.
  template <class F>
  void replace_least_values(const F& f) {
    for_each_triangle_array([this, &f](const std::string& name, const auto& value) {
      const double least = f(number_of_triangles() == 0 ? infinity_ : least_of(name, value));
      least_[name] = least == infinity_ ? 0 : least;
    });
  }

private:
  Vtk_grid(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, const IO::Triangle_fields_2& fields,
           std::vector<Outside_segment> outside)
      : Vtk_grid(mesh, pslg, outside, fields, Mesh_numbers(mesh, outside.size())) {}

  bool is_edge(std::size_t cell) const {
    return !is_triangle(cell) && cell < number_of_triangles() + number_of_edges();
  }

  int marker_of_point(std::size_t v) const {
    return v < mesh_.points.size() ? mesh_.vertex_markers[v] : nodes_.edges[v - mesh_.points.size()].marker;
  }
  /// Of a constrained edge: that of the side of a triangle there.
  Vertex_index node_of_edge(std::size_t e) const {
    const std::size_t t = triangles_at_[e][0];
    return nodes_.nodes_of_triangle[t][side_between(mesh_.triangles[t], mesh_.constrained_edges[e].vertices)];
  }

  int region(std::size_t t) const {
    return t < mesh_.region_of_triangle.size() ? mesh_.region_of_triangle[t] : -1;
  }
  double attribute(std::size_t t) const {
    const auto r = static_cast<std::size_t>(region(t)); // -1 becomes too large
    return r < pslg_.regions.size() ? pslg_.regions[r].attribute : 0;
  }
  int marker(std::size_t cell) const {
    if (is_triangle(cell)) return 0;
    if (is_edge(cell)) return mesh_.constrained_edges[cell - number_of_triangles()].marker;
    return outside_[cell - number_of_triangles() - number_of_edges()].marker;
  }

  /// Calls `f(name, value)` for each array that triangles have by themselves; `value(t)` returns a number.
  template <class F>
  void for_each_triangle_array(const F& f) const {
    f("least_angle", [this](std::size_t t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      return Scaled_triangle(mesh_.point(a), mesh_.point(b), mesh_.point(c)).least_angle();
    });
    if (!pslg_.regions.empty()) f("attribute", [this](std::size_t t) { return attribute(t); });
    for (const IO::Triangle_field_2& field : fields_)
      f(field.name, [&field](std::size_t t) { return field.values[t]; });
  }

  /// Passes an array on that triangles have, with values for edges: the least of the triangles beside them, or of all.
  template <class F, class Value_of_triangle>
  void add_for_all(const F& f, const std::string& name, const Value_of_triangle& value) const {
    f(name, [this, &value, &name](std::size_t cell) -> double {
      if (is_triangle(cell)) return value(cell);
      if (!is_edge(cell)) return least_of(name, value);
      const auto [t, u] = triangles_at_[cell - number_of_triangles()];
      if (t == no_triangle) return least_of(name, value);
      return u == no_triangle ? value(t) : std::min<double>(value(t), value(u));
    });
  }
  /// Found once for each array.
  template <class Value_of_triangle>
  double least_of(const std::string& name, const Value_of_triangle& value) const {
    const auto [found, is_new] = least_.try_emplace(name, 0.);
    if (!is_new || number_of_triangles() == 0) return found->second;
    double least = value(0);
    for (std::size_t t = 1; t < number_of_triangles(); ++t) least = std::min<double>(least, value(t));
    return found->second = least;
  }

  static constexpr double infinity_ = std::numeric_limits<double>::infinity();

  const Indexed_mesh_2<Point>& mesh_;
  const Pslg_2<Point>& pslg_;
  const IO::Triangle_fields_2& fields_;
  Second_order_nodes_2 nodes_; // none: of first order
  std::vector<Outside_segment> outside_;
  Mesh_numbers numbers_;
  std::vector<std::array<std::size_t, 2>> triangles_at_; // per constrained edge
  mutable std::map<std::string, double> least_;          // of arrays
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_VTK_GRID_H
