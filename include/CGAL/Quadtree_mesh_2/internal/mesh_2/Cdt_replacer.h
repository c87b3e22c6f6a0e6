// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Replaces a constrained triangulation by its mesh.
//
// The vertices of the triangulation stay, with their handles and everything that users store in them. Faces
// are made anew. If the triangulation keeps a hierarchy of constraints (`Constrained_triangulation_plus_2`),
// the pieces of a subconstraint replace it in every constraint that it is part of. Takes time linear in the
// mesh.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_REPLACER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_REPLACER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Cdt_input.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Outside_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Triangulation_welder.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Cdt>
class Cdt_replacer {
public:
  using Input = Cdt_input<Cdt>;
  using Flat = typename Input::Flat;
  using Mesh = Indexed_mesh_2<typename Flat::Point>;
  using Face_handle = typename Cdt::Face_handle;
  using Vertex_handle = typename Cdt::Vertex_handle;

  Cdt_replacer(Cdt& cdt, const Flat& flat, const Input& input) : cdt_(cdt), flat_(flat), input_(input) {}

  /// Replaces the triangulation, or the mesh put there before. Returns the faces of the mesh's triangles.
  /// \throws Pslg_error_2 if rounding made the border of the mesh cross itself or a segment outside; the
  /// triangulation is then unchanged.
  std::vector<Face_handle> put(const Mesh& mesh) {
    using Welder = Triangulation_welder<Cdt, typename Flat::Kernel>;
    typename Welder::Outside outside(mesh, input_.vertices().size(), input_.outside_segments());
    const auto lifted = lifted_points(mesh);
    for (const Vertex_handle v : steiner_) cdt_.tds().delete_vertex(v);
    steiner_.clear();
    for (const auto& p : lifted) {
      steiner_.push_back(cdt_.tds().create_vertex());
      steiner_.back()->set_point(p);
    }
    std::vector<Vertex_handle> vertices = input_.vertices();
    vertices.insert(vertices.end(), steiner_.begin(), steiner_.end());
    Welder welder(mesh, outside, cdt_);
    welder.weld(vertices);
    return welder.mesh_faces();
  }

  /// Tells the hierarchy of constraints, if there is one, of the vertices that the mesh has on them. To be
  /// called once.
  void split_constraints(const Mesh& mesh) {
    if constexpr (std::is_convertible_v<typename Cdt::Constraint_hierarchy_tag, Tag_true>) {
      link_constrained_vertices(mesh);
      std::vector<char> is_split(input_.pslg().number_of_segments(), 0);
      for (const auto& e : mesh.constrained_edges) {
        const auto& ends = input_.pslg().segments[e.segment];
        for (std::size_t i = 0; i < 2; ++i)
          if (e.vertices[i] == ends[0] && e.vertices[1 - i] != ends[1] && is_split[e.segment] == 0) {
            is_split[e.segment] = 1;
            split_constraint(ends[0].value(), e.vertices[1 - i].value(), ends[1].value());
          }
      }
    }
  }

private:
  static constexpr std::uint32_t none_ = 0xffffffffu;

  Cdt& cdt_;
  const Flat& flat_;
  const Input& input_;
  std::vector<Vertex_handle> steiner_;              // of the mesh put last
  std::vector<std::array<std::uint32_t, 2>> links_; // of vertices on constraints, to those beside them

  std::vector<typename Cdt::Point> lifted_points(const Mesh& mesh) const {
    std::vector<typename Cdt::Point> points;
    points.reserve(mesh.points.size() - input_.vertices().size());
    for (std::size_t v = input_.vertices().size(); v < mesh.points.size(); ++v) {
      const Segment_index s = mesh.segment_of_vertex[v];
      if (!s.is_valid()) {
        points.push_back(flat_.lift(mesh.points[v]));
        continue;
      }
      const auto& ends = input_.pslg().segments[s];
      points.push_back(flat_.lift_to_segment(mesh.points[v], input_.vertices()[ends[0]]->point(),
                                             input_.vertices()[ends[1]]->point()));
    }
    return points;
  }

  Vertex_handle vertex(std::uint32_t v) const {
    const std::size_t n = input_.vertices().size();
    return v < n ? input_.vertices()[v] : steiner_[v - n];
  }

  void link_constrained_vertices(const Mesh& mesh) {
    const std::size_t n = input_.vertices().size();
    links_.assign(steiner_.size(), {none_, none_});
    for (const auto& e : mesh.constrained_edges)
      for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t v = e.vertices[i].value();
        if (v >= n) links_[v - n][links_[v - n][0] == none_ ? 0 : 1] = e.vertices[1 - i].value();
      }
  }

  /// Walks from the segment's first end by way of the vertex next to it to its last.
  void split_constraint(std::uint32_t first, std::uint32_t next, std::uint32_t last) {
    const std::size_t n = input_.vertices().size();
    for (std::uint32_t v = first; next != last;) {
      cdt_.split_constraint(vertex(v), vertex(last), vertex(next));
      const auto& links = links_[next - n];
      const std::uint32_t after = links[0] == v ? links[1] : links[0];
      v = next, next = after;
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_REPLACER_H
