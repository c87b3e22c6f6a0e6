// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_ENTITIES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_ENTITIES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/io/triangles_at_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/Edge_finder.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// What files of Gmsh have in common, https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format: MSH as text. Version
// 4.1 has blocks of elements, which say their entity, so elements are sorted by entity; their numbers stay those of the
// mesh.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
struct Msh_box {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
  void add(const Point& p) {
    const double x = as_double(p.x()), y = as_double(p.y());
    x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
};
/// A surface or a curve, and at once the only member of its physical group.
template <class Point>
struct Msh_entity {
  std::string name;
  int tag, group;
  Msh_box<Point> box;
  std::vector<std::size_t> elements; ///< triangles or constrained edges, in their order
};

/// The regions of a mesh as surfaces, the markers of its constrained edges as curves. None is empty, but for the only
/// surface of a mesh without triangles.
template <class Point>
class Msh_entities {
public:
  using Entity = Msh_entity<Point>;

  Msh_entities(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               IO::Element_order order = IO::Element_order::FIRST)
      : mesh_(mesh), pslg_(pslg) {
    if (order == IO::Element_order::SECOND) add_nodes();
    find_surfaces();
    find_curves();
  }

  const std::vector<Entity>& surfaces() const { return surfaces_; }
  const std::vector<Entity>& curves() const { return curves_; }

  /// How a file of MSH 4.1 begins, up to its nodes or what says of partitions.
  void write_head(Line_writer& out) const {
    for (const char* line : {"$MeshFormat", "4.1 0 8", "$EndMeshFormat"}) (out << line).end_line();
    write_physical_names(out);
    write_entities(out);
  }

  void write_physical_names(Line_writer& out) const {
    (out << "$PhysicalNames").end_line();
    (out << curves_.size() + surfaces_.size()).end_line();
    for (const Entity& c : curves_) (out << 1 << c.group << '"' + c.name + '"').end_line();
    for (const Entity& s : surfaces_) (out << 2 << s.group << '"' + s.name + '"').end_line();
    (out << "$EndPhysicalNames").end_line();
  }

  /// The numbers of nodes and elements count from 1, those of edges before those of triangles.
  static std::size_t node(Vertex_index v) { return std::size_t(v) + 1; }
  std::size_t element_of_triangle(std::size_t t) const { return mesh_.constrained_edges.size() + t + 1; }
  /// Gmsh's numbers of the kinds of elements.
  int type_of_lines() const { return is_of_second_order() ? 8 : 1; }
  int type_of_triangles() const { return is_of_second_order() ? 9 : 2; }
  bool is_of_second_order() const { return !nodes_.points.empty(); }

  std::size_t number_of_nodes() const { return mesh_.points.size() + nodes_.points.size(); }
  /// The place of a node, as columns of a line.
  void write_place(Line_writer& out, std::size_t i) const {
    if (i < mesh_.points.size())
      out.write_point(mesh_.points[i]) << 0;
    else
      out << nodes_.points[i - mesh_.points.size()][0] << nodes_.points[i - mesh_.points.size()][1] << 0;
  }
  /// The nodes of elements, as columns of a line: their vertices, and those of second order after these, of which the
  /// first is between the first two vertices.
  void write_nodes_of_edge(Line_writer& out, std::size_t e) const {
    for (const Vertex_index v : mesh_.constrained_edges[e].vertices) out << node(v);
    if (is_of_second_order()) out << node(nodes_of_edges_[e]);
  }
  void write_nodes_of_triangle(Line_writer& out, std::size_t t) const {
    for (const Vertex_index v : mesh_.triangles[t]) out << node(v);
    if (!is_of_second_order()) return;
    const auto& [a, b, c] = nodes_.nodes_of_triangle[t]; // opposite the vertices
    out << node(c) << node(a) << node(b);
  }

  void write_edge(Line_writer& out, std::size_t e) const {
    write_nodes_of_edge(out << e + 1, e);
    out.end_line();
  }
  void write_triangle(Line_writer& out, std::size_t t) const {
    write_nodes_of_triangle(out << element_of_triangle(t), t);
    out.end_line();
  }

  /// A view of the input's indices at the nodes, if the mesh is renumbered.
  /// \param vertex_at returns a vertex, for the numbers below `n`
  template <class Vertex_at>
  void write_input_index(Line_writer& out, std::size_t n, const Vertex_at& vertex_at) const {
    if (mesh_.input_index.empty() || n == 0) return;
    for (const char* line : {"$NodeData", "1", "\"input_index\"", "1", "0", "3", "0", "1"})
      (out << line).end_line();
    (out << n).end_line();
    for (std::size_t i = 0; i < n; ++i) {
      const Vertex_index v = vertex_at(i), of_input = mesh_.input_index[std::size_t(v)];
      (out << node(v) << (of_input.is_valid() ? static_cast<long long>(of_input.value()) : -1)).end_line();
    }
    (out << "$EndNodeData").end_line();
  }

private:
  void add_nodes() {
    nodes_ = second_order_nodes<Sequential_tag>(mesh_);
    const auto triangles_at = triangles_at_edges(mesh_);
    for (std::size_t e = 0; e < mesh_.constrained_edges.size(); ++e) {
      const std::size_t t = triangles_at[e][0];
      nodes_of_edges_.push_back(
          nodes_.nodes_of_triangle[t][side_between(mesh_.triangles[t], mesh_.constrained_edges[e].vertices)]);
    }
  }

  void find_surfaces() {
    int regions = 0;
    for (const int r : mesh_.region_of_triangle) regions = std::max(regions, r + 1);
    const bool has_regions = !mesh_.region_of_triangle.empty();
    std::vector<Entity> all;
    for (int r = 0; r < regions; ++r) all.push_back({region_name(r), r + 1, r + 1, Msh_box<Point>(), {}});
    all.push_back({has_regions ? "no region" : "domain", regions + 1, regions + 1, Msh_box<Point>(), {}});
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const int r = has_regions ? mesh_.region_of_triangle[t] : -1;
      Entity& surface = all[static_cast<std::size_t>(r < 0 ? regions : r)];
      surface.elements.push_back(t);
      for (const Vertex_index v : mesh_.triangles[t]) surface.box.add(mesh_.point(v));
    }
    for (Entity& surface : all)
      if (!surface.elements.empty()) surfaces_.push_back(std::move(surface));
    if (!surfaces_.empty() || mesh_.points.empty()) return;
    surfaces_.push_back(std::move(all.back())); // for the nodes
    for (const Point& p : mesh_.points) surfaces_.back().box.add(p);
  }

  std::string region_name(int r) const {
    std::string name = "region " + std::to_string(r);
    if (static_cast<std::size_t>(r) >= pslg_.regions.size()) return name;
    const double attribute = pslg_.regions[static_cast<std::size_t>(r)].attribute;
    const std::string own = name_of(pslg_.region_names, attribute);
    if (!own.empty()) return name + ", " + own; // there may be several of that name
    name += ", attribute ";
    append_number(name, attribute);
    return name;
  }

  std::string marker_name(int marker) const {
    const std::string own = name_of(pslg_.marker_names, marker);
    return own.empty() ? "marker " + std::to_string(marker) : own;
  }

  /// What the numbers 1, 2, ... are called, without what ends a name in a file of Gmsh; empty if there is no name.
  static std::string name_of(const std::vector<std::string>& names, double number) {
    if (!(number >= 1 && number <= static_cast<double>(names.size()))) return std::string();
    const auto index = static_cast<std::size_t>(number) - 1;
    if (number != static_cast<double>(index + 1)) return std::string();
    std::string name = names[index];
    for (char& c : name)
      if (c == '"' || static_cast<unsigned char>(c) < 0x20) c = '_';
    return name;
  }

  void find_curves() {
    std::vector<int> markers;
    for (const auto& e : mesh_.constrained_edges) markers.push_back(e.marker);
    std::sort(markers.begin(), markers.end());
    markers.erase(std::unique(markers.begin(), markers.end()), markers.end());
    int group = markers.empty() ? 0 : std::max(0, markers.back());
    for (const int m : markers)
      curves_.push_back(
          {marker_name(m), static_cast<int>(curves_.size()) + 1, m > 0 ? m : ++group, Msh_box<Point>(), {}});
    for (std::size_t e = 0; e < mesh_.constrained_edges.size(); ++e) {
      const auto& edge = mesh_.constrained_edges[e];
      const auto found = std::lower_bound(markers.begin(), markers.end(), edge.marker);
      Entity& curve = curves_[static_cast<std::size_t>(found - markers.begin())];
      curve.elements.push_back(e);
      for (const Vertex_index v : edge.vertices) curve.box.add(mesh_.point(v));
    }
  }

  /// Without topology: which curves bound which surface is not told.
  void write_entities(Line_writer& out) const {
    (out << "$Entities").end_line();
    (out << 0 << curves_.size() << surfaces_.size() << 0).end_line();
    for (const std::vector<Entity>* entities : {&curves_, &surfaces_})
      for (const Entity& e : *entities)
        (out << e.tag << e.box.x0 << e.box.y0 << 0 << e.box.x1 << e.box.y1 << 0 << 1 << e.group << 0)
            .end_line();
    (out << "$EndEntities").end_line();
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Pslg_2<Point>& pslg_;
  std::vector<Entity> curves_, surfaces_;
  Second_order_nodes_2 nodes_; // none: of first order
  std::vector<Vertex_index> nodes_of_edges_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_ENTITIES_H
