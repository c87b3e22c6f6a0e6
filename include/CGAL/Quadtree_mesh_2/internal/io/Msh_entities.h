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
#include <CGAL/Quadtree_mesh_2/internal/io/Mesh_numbers.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/io/triangles_at_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/Edge_finder.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

// What files of Gmsh have in common, https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format: MSH as text. Version
// 4.1 has blocks of elements, which say their entity, so elements are sorted by entity; their numbers stay those of the
// mesh.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

struct Msh_box {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
  template <class Point>
  void add(const Point& p) {
    const double x = as_double(p.x()), y = as_double(p.y());
    add(Msh_box{x, y, x, y});
  }
  void add(const Msh_box& box) {
    x0 = std::min(x0, box.x0), x1 = std::max(x1, box.x1);
    y0 = std::min(y0, box.y0), y1 = std::max(y1, box.y1);
  }
};
/// A surface or a curve, and at once the only member of its physical group.
struct Msh_entity {
  std::string name;
  int tag, group;
  Msh_box box;
  std::vector<std::size_t> elements; ///< triangles or constrained edges, in their order
};

/// Which regions and markers there are in a mesh, and where; the surveys of its parts together are that of the mesh.
struct Msh_survey {
  std::map<int, Msh_box> regions; ///< -1: triangles in no region
  std::map<int, Msh_box> markers;
  std::map<int, Msh_box> vertices; ///< one, of number 0, if there are any

  /// Triangles and vertices that others own do not count.
  template <class Point>
  static Msh_survey of(const Indexed_mesh_2<Point>& mesh, const Mesh_numbers& numbers) {
    Msh_survey survey;
    for (std::size_t t = 0; t < numbers.number_of_own_triangles(); ++t) {
      Msh_box& box = survey.regions[region_of(mesh, t)];
      for (const Vertex_index v : mesh.triangles[t]) box.add(mesh.point(v));
    }
    for (const auto& e : mesh.constrained_edges) {
      Msh_box& box = survey.markers[e.marker];
      for (const Vertex_index v : e.vertices) box.add(mesh.point(v));
    }
    for (std::size_t v = numbers.own_vertices().begin; v < numbers.own_vertices().end; ++v)
      survey.vertices[0].add(mesh.points[v]);
    return survey;
  }
  void add(const Msh_survey& other) {
    for (const auto member : {&Msh_survey::regions, &Msh_survey::markers, &Msh_survey::vertices})
      for (const auto& [key, box] : other.*member) (this->*member)[key].add(box);
  }

  template <class Point>
  static int region_of(const Indexed_mesh_2<Point>& mesh, std::size_t t) {
    return mesh.region_of_triangle.empty() ? -1 : std::max(mesh.region_of_triangle[t], -1);
  }
};

/// The regions of a mesh as surfaces, the markers of its constrained edges as curves. None is empty, but for the only
/// surface of a mesh without triangles; or of a part of a mesh, which has the surfaces and curves of all parts.
template <class Point>
class Msh_entities {
public:
  using Entity = Msh_entity;

  Msh_entities(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               IO::Element_order order = IO::Element_order::FIRST)
      : Msh_entities(mesh, pslg, Msh_survey::of(mesh, Mesh_numbers(mesh)), Mesh_numbers(mesh)) {
    if (order == IO::Element_order::SECOND) add_nodes();
  }
  /// Of a part.
  /// \param pslg of which regions and names count
  /// \param survey of all parts
  Msh_entities(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, const Msh_survey& survey,
               Mesh_numbers numbers)
      : mesh_(mesh), pslg_(pslg), numbers_(std::move(numbers)) {
    find_surfaces(survey);
    find_curves(survey);
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
  std::size_t node(Vertex_index v) const {
    return std::size_t(v) < mesh_.points.size() ? numbers_.vertex(v) + 1 : std::size_t(v) + 1;
  }
  std::size_t element_of_triangle(std::size_t t) const {
    return numbers_.counts().edges + numbers_.triangle(t) + 1;
  }
  std::size_t number_of_elements() const { return numbers_.counts().edges + numbers_.counts().triangles; }
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
    write_nodes_of_edge(out << numbers_.edge(e) + 1, e);
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

  void find_surfaces(const Msh_survey& survey) {
    const int regions = survey.regions.empty() ? 0 : survey.regions.rbegin()->first + 1;
    const std::string rest = mesh_.region_of_triangle.empty() ? "domain" : "no region";
    std::map<int, std::size_t> surface_of_region;
    const auto add = [&](int r, const Msh_box& box) {
      surface_of_region[r] = surfaces_.size();
      const int tag = (r < 0 ? regions : r) + 1;
      surfaces_.push_back({r < 0 ? rest : region_name(r), tag, tag, box, {}});
    };
    for (const auto& [r, box] : survey.regions)
      if (r >= 0) add(r, box);
    const auto in_none = survey.regions.find(-1);
    if (in_none != survey.regions.end()) add(-1, in_none->second);
    if (surfaces_.empty() && !survey.vertices.empty())
      add(-1, survey.vertices.begin()->second); // for the nodes
    for (std::size_t t = 0; t < numbers_.number_of_own_triangles(); ++t)
      surfaces_[surface_of_region.at(Msh_survey::region_of(mesh_, t))].elements.push_back(t);
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

  void find_curves(const Msh_survey& survey) {
    int group = survey.markers.empty() ? 0 : std::max(0, survey.markers.rbegin()->first);
    std::map<int, std::size_t> curve_of_marker;
    for (const auto& [m, box] : survey.markers) {
      curve_of_marker[m] = curves_.size();
      curves_.push_back({marker_name(m), static_cast<int>(curves_.size()) + 1, m > 0 ? m : ++group, box, {}});
    }
    for (std::size_t e = 0; e < mesh_.constrained_edges.size(); ++e)
      curves_[curve_of_marker.at(mesh_.constrained_edges[e].marker)].elements.push_back(e);
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
  Mesh_numbers numbers_;
  std::vector<Entity> curves_, surfaces_;
  Second_order_nodes_2 nodes_; // none: of first order
  std::vector<Vertex_index> nodes_of_edges_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_ENTITIES_H
