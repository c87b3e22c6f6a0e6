// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_TRIANGULATION_WELDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_TRIANGULATION_WELDER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Outside_triangulation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Vertex, class = void>
struct Vertex_info_setter {
  static void set(Vertex&, std::uint32_t) {}
};
/// Stores the index of a vertex in its `info()`, where there is one that can hold an index.
template <class Vertex>
struct Vertex_info_setter<Vertex, std::void_t<decltype(std::declval<Vertex&>().info())>> {
  static void set(Vertex& v, std::uint32_t index) {
    using Info = std::decay_t<decltype(v.info())>;
    if constexpr (std::is_arithmetic_v<Info>)
      v.info() = static_cast<Info>(index);
    else if constexpr (std::is_constructible_v<Info, Vertex_index>)
      v.info() = Info(Vertex_index(index));
  }
};

/// Marks the faces of a mesh's domain, where faces can be marked.
template <class Face, class = void>
struct Domain_marker {
  static void set(Face&, bool) {}
};
template <class Face>
struct Domain_marker<Face, std::void_t<decltype(std::declval<Face&>().set_in_domain(true))>> {
  static void set(Face& f, bool is_in_domain) { f.set_in_domain(is_in_domain); }
};

/// Marks the edges that are constrained, where edges can be.
template <class Face, class = void>
struct Constraint_marker {
  static constexpr bool is_effective = false;
  static void set(Face&, int, bool) {}
};
template <class Face>
struct Constraint_marker<Face, std::void_t<decltype(std::declval<Face&>().set_constraint(0, true))>> {
  static constexpr bool is_effective = true;
  static void set(Face& f, int side, bool is_constrained) { f.set_constraint(side, is_constrained); }
};

/// Welds the triangles of a mesh and the faces around it into one triangulation data structure. Linear.
/// \tparam Cdt any triangulation of CGAL in the plane; constraints are marked in those that know them
/// \tparam Mesh_kernel that of the mesh's points
template <class Cdt, class Mesh_kernel = typename Cdt::Geom_traits>
class Triangulation_welder {
public:
  using Kernel = Mesh_kernel;
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;
  using Point = typename Kernel::Point_2;
  using Mesh = Indexed_mesh_2<Point>;
  using Outside = Outside_triangulation<Kernel>;

  /// \pre `outside.dimension() == 2`
  Triangulation_welder(const Mesh& mesh, Outside& outside, Cdt& cdt)
      : mesh_(mesh), outside_(outside), cdt_(cdt) {}

  void weld() {
    cdt_.clear();
    cdt_.tds().clear();
    cdt_.tds().set_dimension(2);
    create_vertices();
    weld_faces();
  }

  /// The same, where the triangulation has the mesh's vertices, and only these: they stay, only faces are made anew.
  /// \param vertices one for each vertex of the mesh
  void weld(std::vector<Vertex_handle> vertices) {
    vertices_ = std::move(vertices);
    cdt_.tds().faces().clear();
    cdt_.tds().set_dimension(2);
    weld_faces();
  }

  /// The faces of the mesh's triangles.
  const std::vector<Face_handle>& mesh_faces() const { return faces_; }

private:
  using Domain_of_face = Domain_marker<typename Cdt::Face>;
  using Constraint_of_face = Constraint_marker<typename Cdt::Face>;
  using Outside_face_handle = typename Outside::Face_handle;
  static constexpr std::uint32_t none_ = Outside::none;

  void weld_faces() {
    create_mesh_faces();
    create_outside_faces();
    link_mesh_faces();
    link_outside_faces();
    if constexpr (Constraint_of_face::is_effective) constrain_inner_edges();
  }

  Vertex_handle create_vertex(std::uint32_t index) {
    const Vertex_handle v = cdt_.tds().create_vertex();
    v->set_point(mesh_.points[index]);
    Vertex_info_setter<typename Cdt::Vertex>::set(*v, index);
    return v;
  }

  /// The infinite vertex first, as CGAL has it; then in the order of the mesh.
  void create_vertices() {
    cdt_.set_infinite_vertex(cdt_.tds().create_vertex());
    vertices_.resize(mesh_.points.size());
    std::vector<char> is_wanted(mesh_.points.size(), 0);
    for (std::uint32_t v = 0; v < mesh_.points.size(); ++v) is_wanted[v] = outside_.is_used(v);
    for (Outside_face_handle f : outside_.cdt().all_face_handles())
      for (int i = 0; i < 3 && !f->info().is_inside; ++i)
        if (!outside_.cdt().is_infinite(f->vertex(i))) is_wanted[outside_.index(f->vertex(i))] = 1;
    for (std::uint32_t v = 0; v < mesh_.points.size(); ++v)
      if (is_wanted[v] != 0) vertices_[v] = create_vertex(v);
  }

  Face_handle create_face(Vertex_handle a, Vertex_handle b, Vertex_handle c) {
    const Face_handle f = cdt_.tds().create_face(a, b, c);
    a->set_face(f);
    b->set_face(f);
    c->set_face(f);
    return f;
  }

  void create_mesh_faces() {
    faces_.reserve(mesh_.triangles.size());
    for (const auto& t : mesh_.triangles) {
      const Face_handle f =
          create_face(vertices_[t[0].value()], vertices_[t[1].value()], vertices_[t[2].value()]);
      Domain_of_face::set(*f, true);
      faces_.push_back(f);
    }
  }

  void create_outside_faces() {
    const auto vertex = [&](Outside_face_handle f, int i) {
      const auto v = f->vertex(i);
      return outside_.cdt().is_infinite(v) ? cdt_.infinite_vertex() : vertices_[outside_.index(v)];
    };
    for (Outside_face_handle f : outside_.cdt().all_face_handles()) {
      if (f->info().is_inside) continue;
      f->info().number = static_cast<std::uint32_t>(outside_faces_.size());
      outside_faces_.push_back(create_face(vertex(f, 0), vertex(f, 1), vertex(f, 2)));
      Domain_of_face::set(*outside_faces_.back(), false);
    }
  }

  void link_mesh_faces() {
    for (std::size_t t = 0; t < faces_.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Triangle_index n = mesh_.neighbors[t][std::size_t(k)];
        if (n.is_valid()) faces_[t]->set_neighbor(k, faces_[n.value()]);
      }
  }

  void link_outside_faces() {
    for (Outside_face_handle f : outside_.cdt().all_face_handles()) {
      if (f->info().is_inside) continue;
      const Face_handle face = outside_faces_[f->info().number];
      for (int i = 0; i < 3; ++i) {
        Constraint_of_face::set(*face, i, f->is_constrained(i));
        const std::uint32_t side = f->info().mesh_side[std::size_t(i)];
        if (side == none_) {
          face->set_neighbor(i, outside_faces_[f->neighbor(i)->info().number]);
        } else {
          const Face_handle across = faces_[side / 3];
          face->set_neighbor(i, across);
          across->set_neighbor(static_cast<int>(side % 3), face);
          Constraint_of_face::set(*across, static_cast<int>(side % 3), true);
        }
      }
    }
  }

  /// Input segments inside the domain. Where all constrained edges are on the border there is nothing to look
  /// for; elsewhere only between vertices that are on constrained edges.
  void constrain_inner_edges() {
    if (mesh_.constrained_edges.size() == outside_.number_of_border_sides()) return;
    using Key = std::pair<Vertex_index, Vertex_index>;
    std::vector<Key> constrained;
    Indexed_vector<Vertex_index, char> is_on_segment(mesh_.points.size(), 0);
    constrained.reserve(mesh_.constrained_edges.size());
    for (const auto& e : mesh_.constrained_edges) {
      constrained.push_back(std::minmax(e.vertices[0], e.vertices[1]));
      is_on_segment[e.vertices[0]] = is_on_segment[e.vertices[1]] = 1;
    }
    std::sort(constrained.begin(), constrained.end());
    for (std::size_t t = 0; t < faces_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex_index a = mesh_.triangles[t][(k + 1) % 3], b = mesh_.triangles[t][(k + 2) % 3];
        if (!mesh_.neighbors[t][k].is_valid() || is_on_segment[a] == 0 || is_on_segment[b] == 0) continue;
        if (std::binary_search(constrained.begin(), constrained.end(), Key(std::min(a, b), std::max(a, b))))
          Constraint_of_face::set(*faces_[t], static_cast<int>(k), true);
      }
  }

  const Mesh& mesh_;
  Outside& outside_;
  Cdt& cdt_;
  std::vector<Vertex_handle> vertices_;
  std::vector<Face_handle> faces_, outside_faces_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_TRIANGULATION_WELDER_H
