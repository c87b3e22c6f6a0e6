// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_WRITER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_entities.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A mesh as one file of Gmsh. See `IO::write_MSH()`.
template <class Point>
class Msh_writer {
public:
  Msh_writer(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, IO::Element_order order)
      : mesh_(mesh), entities_(mesh, pslg, order) {}

  std::string text() {
    out_.reserve(65 * mesh_.points.size() + 32 * mesh_.triangles.size() + 512);
    entities_.write_head(out_);
    write_nodes();
    write_elements();
    entities_.write_input_index(out_, mesh_.points.size(), [](std::size_t v) { return Vertex_index(v); });
    return out_.take();
  }

private:
  void write_nodes() {
    const std::size_t n = entities_.number_of_nodes();
    (out_ << "$Nodes").end_line();
    (out_ << (n > 0 ? 1 : 0) << n << (n > 0 ? 1 : 0) << n).end_line();
    if (n > 0) (out_ << 2 << entities_.surfaces().front().tag << 0 << n).end_line();
    for (std::size_t v = 0; v < n; ++v) (out_ << v + 1).end_line();
    for (std::size_t v = 0; v < n; ++v) {
      entities_.write_place(out_, v);
      out_.end_line();
    }
    (out_ << "$EndNodes").end_line();
  }

  void write_elements() {
    const std::size_t n = mesh_.constrained_edges.size() + mesh_.triangles.size();
    const std::size_t surfaces = mesh_.triangles.empty() ? 0 : entities_.surfaces().size();
    (out_ << "$Elements").end_line();
    (out_ << entities_.curves().size() + surfaces << n << (n > 0 ? 1 : 0) << n).end_line();
    for (const auto& c : entities_.curves()) {
      (out_ << 1 << c.tag << entities_.type_of_lines() << c.elements.size()).end_line();
      for (const std::size_t e : c.elements) entities_.write_edge(out_, e);
    }
    for (std::size_t i = 0; i < surfaces; ++i) {
      const auto& s = entities_.surfaces()[i];
      (out_ << 2 << s.tag << entities_.type_of_triangles() << s.elements.size()).end_line();
      for (const std::size_t t : s.elements) entities_.write_triangle(out_, t);
    }
    (out_ << "$EndElements").end_line();
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Msh_entities<Point> entities_;
  Line_writer out_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_WRITER_H
