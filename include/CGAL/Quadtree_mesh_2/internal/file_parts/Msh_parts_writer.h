// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_MSH_PARTS_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_MSH_PARTS_WRITER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/Ghost_layers.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/mesh_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_entities.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/triangles_at_edges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What the file of one part of a mesh has.
struct Msh_part {
  std::size_t part, parts;                                ///< which of how many
  std::size_t begin, end;                                 ///< its triangles
  std::vector<std::pair<std::size_t, std::size_t>> edges; ///< curves, and edges that are pieces of them
  std::vector<std::size_t> ghosts;                        ///< triangles of others, in their order
  std::vector<std::size_t> owners_of_ghosts;              ///< their parts
  std::vector<std::uint32_t> unused;                      ///< vertices that only the file has, in their order
};

/// One part of a mesh as a file of Gmsh, as Gmsh itself splits partitioned meshes. See `IO::write_MSH_parts()`.
///
/// Each curve and surface of the mesh is the parent of one in each part that has elements of it. Their tags, and those
/// of ghost surfaces, are different in all parts, so that files can be merged.
template <class Point>
class Msh_part_writer {
public:
  Msh_part_writer(const Indexed_mesh_2<Point>& mesh, const Msh_entities<Point>& entities,
                  const Msh_part& part)
      : mesh_(mesh), entities_(entities), part_(part) {}

  std::string text() {
    collect();
    entities_.write_head(out_);
    write_partitioned_entities();
    write_nodes();
    write_elements();
    write_ghosts();
    entities_.write_input_index(out_, vertices_.size(),
                                [this](std::size_t i) { return Vertex_index(vertices_[i]); });
    return out_.take();
  }

private:
  using Entity = Msh_entity;

  /// What a part has of a curve or surface of the mesh.
  struct Partition_entity {
    int tag;
    const Entity* parent;
    std::vector<std::size_t> elements;
    Msh_box box;
  };

  int surface_tag(std::size_t part, std::size_t i) const {
    return static_cast<int>((part + 1) * entities_.surfaces().size() + i) + 1;
  }
  int curve_tag(std::size_t part, std::size_t i) const {
    return static_cast<int>((part + 1) * entities_.curves().size() + i) + 1;
  }
  int ghost_tag() const { return surface_tag(part_.parts, 0) + static_cast<int>(part_.part); }

  void collect() {
    vertices_ = part_.unused;
    for (std::size_t i = 0; i < entities_.surfaces().size(); ++i) {
      const Entity& parent = entities_.surfaces()[i];
      const auto first = std::lower_bound(parent.elements.begin(), parent.elements.end(), part_.begin),
                 last = std::lower_bound(first, parent.elements.end(), part_.end);
      add_entity(surfaces_, {surface_tag(part_.part, i), &parent, {first, last}, {}}, mesh_.triangles,
                 [](const auto& t) { return t; });
    }
    std::vector<std::vector<std::size_t>> edges(entities_.curves().size());
    for (const auto& [curve, e] : part_.edges) edges[curve].push_back(e);
    for (std::size_t i = 0; i < edges.size(); ++i)
      add_entity(curves_, {curve_tag(part_.part, i), &entities_.curves()[i], std::move(edges[i]), {}},
                 mesh_.constrained_edges, [](const auto& e) { return e.vertices; });
    for (const std::size_t t : part_.ghosts)
      for (const Vertex_index v : mesh_.triangles[t]) vertices_.push_back(v.value());
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  template <class Elements, class Vertices_of>
  void add_entity(std::vector<Partition_entity>& list, Partition_entity entity, const Elements& elements,
                  const Vertices_of& vertices_of) {
    if (entity.elements.empty()) return;
    for (const std::size_t i : entity.elements)
      for (const Vertex_index v : vertices_of(elements[i])) {
        vertices_.push_back(v.value());
        entity.box.add(mesh_.point(v));
      }
    list.push_back(std::move(entity));
  }

  void write_partitioned_entities() {
    const bool has_ghosts = !part_.ghosts.empty();
    (out_ << "$PartitionedEntities").end_line();
    (out_ << part_.parts).end_line();
    (out_ << int(has_ghosts)).end_line();
    if (has_ghosts) (out_ << ghost_tag() << part_.part + 1).end_line();
    (out_ << 0 << curves_.size() << surfaces_.size() << 0).end_line();
    for (const std::vector<Partition_entity>* list : {&curves_, &surfaces_})
      for (const Partition_entity& e : *list)
        (out_ << e.tag << (list == &curves_ ? 1 : 2) << e.parent->tag << 1 << part_.part + 1 << e.box.x0
              << e.box.y0 << 0 << e.box.x1 << e.box.y1 << 0 << 1 << e.parent->group << 0)
            .end_line();
    (out_ << "$EndPartitionedEntities").end_line();
  }

  void write_nodes() {
    const std::size_t n = vertices_.size();
    (out_ << "$Nodes").end_line();
    if (n > 0) {
      (out_ << 1 << n << node(vertices_.front()) << node(vertices_.back())).end_line();
      (out_ << 2 << (surfaces_.empty() ? entities_.surfaces().front().tag : surfaces_.front().tag) << 0 << n)
          .end_line();
    } else {
      (out_ << 0 << 0 << 0 << 0).end_line();
    }
    for (const std::uint32_t v : vertices_) (out_ << node(v)).end_line();
    for (const std::uint32_t v : vertices_) (out_.write_point(mesh_.points[v]) << 0).end_line();
    (out_ << "$EndNodes").end_line();
  }

  std::size_t node(std::uint32_t v) const { return entities_.node(Vertex_index(v)); }

  void write_elements() {
    const std::vector<std::size_t>& ghosts = part_.ghosts;
    std::size_t n = ghosts.size();
    for (const std::vector<Partition_entity>* list : {&curves_, &surfaces_})
      for (const Partition_entity& e : *list) n += e.elements.size();
    (out_ << "$Elements").end_line();
    // The numbers are those in the whole mesh; the range need not be tight.
    (out_ << curves_.size() + surfaces_.size() + (ghosts.empty() ? 0 : 1) << n << (n > 0 ? 1 : 0)
          << (n > 0 ? entities_.number_of_elements() : 0))
        .end_line();
    for (const Partition_entity& c : curves_) {
      (out_ << 1 << c.tag << entities_.type_of_lines() << c.elements.size()).end_line();
      for (const std::size_t e : c.elements) entities_.write_edge(out_, e);
    }
    for (const Partition_entity& s : surfaces_) {
      (out_ << 2 << s.tag << entities_.type_of_triangles() << s.elements.size()).end_line();
      for (const std::size_t t : s.elements) entities_.write_triangle(out_, t);
    }
    if (!ghosts.empty())
      (out_ << 2 << ghost_tag() << entities_.type_of_triangles() << ghosts.size()).end_line();
    for (const std::size_t t : ghosts) entities_.write_triangle(out_, t);
    (out_ << "$EndElements").end_line();
  }

  /// Each with the part that owns it, and the one part here for which it is a ghost.
  void write_ghosts() {
    const std::vector<std::size_t>& ghosts = part_.ghosts;
    if (ghosts.empty()) return;
    (out_ << "$GhostElements").end_line();
    (out_ << ghosts.size()).end_line();
    for (std::size_t i = 0; i < ghosts.size(); ++i)
      (out_ << entities_.element_of_triangle(ghosts[i]) << part_.owners_of_ghosts[i] + 1 << 1
            << part_.part + 1)
          .end_line();
    (out_ << "$EndGhostElements").end_line();
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Msh_entities<Point>& entities_;
  const Msh_part& part_;
  std::vector<Partition_entity> curves_, surfaces_;
  std::vector<std::uint32_t> vertices_; // in their order
  Line_writer out_;
};

/// All parts of a mesh. One is in memory at a time.
template <class Point>
class Msh_parts_writer {
public:
  Msh_parts_writer(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, std::size_t parts)
      : mesh_(mesh), entities_(mesh, pslg), runs_(mesh.triangles.size(), parts), ghosts_(mesh, runs_),
        edges_of_part_(runs_.size()) {
    const auto triangles = triangles_at_edges(mesh);
    for (std::size_t curve = 0; curve < entities_.curves().size(); ++curve)
      for (const std::size_t e : entities_.curves()[curve].elements) {
        const std::size_t t = triangles[e][0];
        edges_of_part_[t == no_triangle ? runs_.size() - 1 : runs_.run_of(t)].push_back({curve, e});
      }
  }

  void add_to(Replaced_files& files, const std::string& file_name) const {
    for (std::size_t p = 0; p < runs_.size(); ++p)
      files.add(piece_file_name(file_name, p + 1, ".msh"),
                Msh_part_writer<Point>(mesh_, entities_, part(p)).text());
  }

private:
  Msh_part part(std::size_t p) const {
    Msh_part part{
        p, runs_.size(), runs_.begin(p), runs_.begin(p + 1), edges_of_part_[p], ghosts_.of_run(p), {}, {}};
    for (const std::size_t t : part.ghosts) part.owners_of_ghosts.push_back(runs_.run_of(t));
    if (p + 1 == runs_.size()) part.unused = unused_vertices();
    return part;
  }

  std::vector<std::uint32_t> unused_vertices() const {
    std::vector<char> is_used(mesh_.points.size(), 0);
    for (const auto& t : mesh_.triangles)
      for (const Vertex_index v : t) is_used[std::size_t(v)] = 1;
    for (const auto& e : mesh_.constrained_edges)
      for (const Vertex_index v : e.vertices) is_used[std::size_t(v)] = 1;
    std::vector<std::uint32_t> unused;
    for (std::size_t v = 0; v < is_used.size(); ++v)
      if (is_used[v] == 0) unused.push_back(static_cast<std::uint32_t>(v));
    return unused;
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Msh_entities<Point> entities_;
  const Triangle_runs runs_;
  const Ghost_layers<Point> ghosts_;
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>>
      edges_of_part_; // with the curves that have them
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FILE_PARTS_MSH_PARTS_WRITER_H
