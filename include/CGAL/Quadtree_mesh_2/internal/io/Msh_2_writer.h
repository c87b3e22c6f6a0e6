// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_2_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_2_WRITER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_entities.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A mesh in MSH 2.2, as text. Each element says its group and its entity, so all are in the order of the mesh. See
/// `IO::write_MSH()` and https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format-version-2-_0028Legacy_0029.
template <class Point>
class Msh_2_writer {
public:
  Msh_2_writer(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, IO::Element_order order)
      : mesh_(mesh), entities_(mesh, pslg, order) {}

  std::string text() {
    out_.reserve(65 * mesh_.points.size() + 40 * mesh_.triangles.size() + 512);
    for (const char* line : {"$MeshFormat", "2.2 0 8", "$EndMeshFormat"}) (out_ << line).end_line();
    entities_.write_physical_names(out_);
    write_nodes();
    write_elements();
    entities_.write_input_index(out_, mesh_.points.size(), [](std::size_t v) { return Vertex_index(v); });
    return out_.take();
  }

private:
  using Entities = Msh_entities<Point>;
  using Entity = typename Entities::Entity;

  void write_nodes() {
    (out_ << "$Nodes").end_line();
    (out_ << entities_.number_of_nodes()).end_line();
    for (std::size_t v = 0; v < entities_.number_of_nodes(); ++v) {
      entities_.write_place(out_ << v + 1, v);
      out_.end_line();
    }
    (out_ << "$EndNodes").end_line();
  }

  void write_elements() {
    const std::size_t edges = mesh_.constrained_edges.size(), triangles = mesh_.triangles.size();
    const std::vector<const Entity*> curves = by_element(entities_.curves(), edges),
                                     surfaces = by_element(entities_.surfaces(), triangles);
    (out_ << "$Elements").end_line();
    (out_ << edges + triangles).end_line();
    for (std::size_t e = 0; e < edges; ++e) {
      begin_element(e + 1, entities_.type_of_lines(), *curves[e]);
      entities_.write_nodes_of_edge(out_, e);
      out_.end_line();
    }
    for (std::size_t t = 0; t < triangles; ++t) {
      begin_element(entities_.element_of_triangle(t), entities_.type_of_triangles(), *surfaces[t]);
      entities_.write_nodes_of_triangle(out_, t);
      out_.end_line();
    }
    (out_ << "$EndElements").end_line();
  }

  void begin_element(std::size_t number, int type, const Entity& entity) {
    constexpr int tags = 2;
    out_ << number << type << tags << entity.group << entity.tag;
  }

  static std::vector<const Entity*> by_element(const std::vector<Entity>& entities, std::size_t elements) {
    std::vector<const Entity*> result(elements);
    for (const Entity& entity : entities)
      for (const std::size_t i : entity.elements) result[i] = &entity;
    return result;
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Entities entities_;
  Line_writer out_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_2_WRITER_H
