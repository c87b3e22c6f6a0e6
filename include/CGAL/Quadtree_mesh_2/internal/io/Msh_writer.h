// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_WRITER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Gmsh's MSH 4.1 as text, https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format. What the elements of an entity are
// is said by blocks of elements, so these are sorted by entity; their numbers stay those of the mesh.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Msh_writer {
public:
  Msh_writer(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg) : mesh_(mesh), pslg_(pslg) {
    find_surfaces();
    find_curves();
  }

  std::string text() {
    out_.reserve(65 * mesh_.points.size() + 32 * mesh_.triangles.size() + 512);
    for (const char* line : {"$MeshFormat", "4.1 0 8", "$EndMeshFormat"}) (out_ << line).end_line();
    write_physical_names();
    write_entities();
    write_nodes();
    write_elements();
    return out_.take();
  }

private:
  struct Box {
    double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
    void add(const Point& p) {
      const double x = as_double(p.x()), y = as_double(p.y());
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
  };
  /// A surface or a curve, and at once the only member of its physical group.
  struct Entity {
    std::string name;
    int tag, group;
    Box box;
    std::vector<std::size_t> elements; ///< triangles or constrained edges
  };

  void find_surfaces() {
    int regions = 0;
    for (const int r : mesh_.region_of_triangle) regions = std::max(regions, r + 1);
    const bool has_regions = !mesh_.region_of_triangle.empty();
    std::vector<Entity> all;
    for (int r = 0; r < regions; ++r) all.push_back({region_name(r), r + 1, r + 1, Box(), {}});
    all.push_back({has_regions ? "no region" : "domain", regions + 1, regions + 1, Box(), {}});
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
    name += ", attribute ";
    append_number(name, pslg_.regions[static_cast<std::size_t>(r)].attribute);
    return name;
  }

  void find_curves() {
    std::vector<int> markers;
    for (const auto& e : mesh_.constrained_edges) markers.push_back(e.marker);
    std::sort(markers.begin(), markers.end());
    markers.erase(std::unique(markers.begin(), markers.end()), markers.end());
    int group = markers.empty() ? 0 : std::max(0, markers.back());
    for (const int m : markers)
      curves_.push_back({"marker " + std::to_string(m),
                         static_cast<int>(curves_.size()) + 1,
                         m > 0 ? m : ++group,
                         Box(),
                         {}});
    for (std::size_t e = 0; e < mesh_.constrained_edges.size(); ++e) {
      const auto& edge = mesh_.constrained_edges[e];
      const auto found = std::lower_bound(markers.begin(), markers.end(), edge.marker);
      Entity& curve = curves_[static_cast<std::size_t>(found - markers.begin())];
      curve.elements.push_back(e);
      for (const Vertex_index v : edge.vertices) curve.box.add(mesh_.point(v));
    }
  }

  void write_physical_names() {
    (out_ << "$PhysicalNames").end_line();
    (out_ << curves_.size() + surfaces_.size()).end_line();
    for (const Entity& c : curves_) (out_ << 1 << c.group << '"' + c.name + '"').end_line();
    for (const Entity& s : surfaces_) (out_ << 2 << s.group << '"' + s.name + '"').end_line();
    (out_ << "$EndPhysicalNames").end_line();
  }

  /// Without topology: which curves bound which surface is not told.
  void write_entities() {
    (out_ << "$Entities").end_line();
    (out_ << 0 << curves_.size() << surfaces_.size() << 0).end_line();
    for (const std::vector<Entity>* entities : {&curves_, &surfaces_})
      for (const Entity& e : *entities)
        (out_ << e.tag << e.box.x0 << e.box.y0 << 0 << e.box.x1 << e.box.y1 << 0 << 1 << e.group << 0)
            .end_line();
    (out_ << "$EndEntities").end_line();
  }

  void write_nodes() {
    const std::size_t n = mesh_.points.size();
    (out_ << "$Nodes").end_line();
    (out_ << (n > 0 ? 1 : 0) << n << (n > 0 ? 1 : 0) << n).end_line();
    if (n > 0) (out_ << 2 << surfaces_.front().tag << 0 << n).end_line();
    for (std::size_t v = 0; v < n; ++v) (out_ << v + 1).end_line();
    for (const Point& p : mesh_.points) (out_.write_point(p) << 0).end_line();
    (out_ << "$EndNodes").end_line();
  }

  void write_elements() {
    const std::size_t edges = mesh_.constrained_edges.size(), n = edges + mesh_.triangles.size();
    const std::size_t surfaces = mesh_.triangles.empty() ? 0 : surfaces_.size();
    constexpr int line_of_2_nodes = 1, triangle_of_3_nodes = 2;
    const auto from_1 = [](Vertex_index v) { return std::size_t(v) + 1; };
    (out_ << "$Elements").end_line();
    (out_ << curves_.size() + surfaces << n << (n > 0 ? 1 : 0) << n).end_line();
    for (const Entity& c : curves_) {
      (out_ << 1 << c.tag << line_of_2_nodes << c.elements.size()).end_line();
      for (const std::size_t e : c.elements) {
        const auto& ends = mesh_.constrained_edges[e].vertices;
        (out_ << e + 1 << from_1(ends[0]) << from_1(ends[1])).end_line();
      }
    }
    for (std::size_t i = 0; i < surfaces; ++i) {
      const Entity& s = surfaces_[i];
      (out_ << 2 << s.tag << triangle_of_3_nodes << s.elements.size()).end_line();
      for (const std::size_t t : s.elements) {
        const auto& [a, b, c] = mesh_.triangles[t];
        (out_ << edges + t + 1 << from_1(a) << from_1(b) << from_1(c)).end_line();
      }
    }
    (out_ << "$EndElements").end_line();
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Pslg_2<Point>& pslg_;
  std::vector<Entity> curves_, surfaces_; // none empty, but for the only surface of a mesh without triangles
  Line_writer out_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_WRITER_H
