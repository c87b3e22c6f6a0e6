// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A constrained triangulation with marked faces as the mesher's input graph.
//
// The domain is given to the mesher by a point in each of its components. If it is everything that
// constrained edges separate from infinity, no point is needed. Takes expected linear time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_INPUT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_INPUT_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Flat_points.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/mark_domain.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Cdt>
class Cdt_input {
public:
  using Flat = Flat_points<Cdt>;
  using Point = typename Flat::Point;
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;

  /// Takes the faces' marks as the domain. What is connected to infinity loses its marks; other edges between
  /// faces in the domain and faces that are not are constrained from now on.
  /// \throws Pslg_error_2 if there is no room for a point in a component of the domain.
  Cdt_input(Cdt& cdt, const Flat& flat) : cdt_(cdt), flat_(flat) {
    if (cdt.dimension() < 2) return;
    const auto outside = mark_outside(cdt);
    constrain_border();
    add_vertices();
    add_segments();
    bool is_enclosed = true;
    for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
      if (f->is_in_domain())
        has_domain_ = true;
      else if (outside.count(&*f) == 0)
        is_enclosed = false;
    }
    if (has_domain_ && !is_enclosed) add_components();
  }

  bool has_domain() const { return has_domain_; }
  const Pslg_2<Point>& pslg() const { return pslg_; }
  /// Of the triangulation, in the order of the graph.
  const std::vector<Vertex_handle>& vertices() const { return vertices_; }
  /// Those without the domain on a side.
  const std::vector<std::array<std::uint32_t, 2>>& outside_segments() const { return outside_segments_; }
  Quality_mesh_options_2::Domain rule() const {
    return pslg_.regions.empty() ? Quality_mesh_options_2::Domain::ENCLOSED
                                 : Quality_mesh_options_2::Domain::MARKED;
  }

private:
  Cdt& cdt_;
  const Flat& flat_;
  Pslg_2<Point> pslg_;
  std::vector<Vertex_handle> vertices_;
  std::vector<std::array<std::uint32_t, 2>> outside_segments_;
  bool has_domain_ = false;

  /// Marks that the user set face by face need not follow constraints.
  void constrain_border() {
    std::vector<std::pair<Vertex_handle, Vertex_handle>> border;
    for (auto e = cdt_.finite_edges_begin(); e != cdt_.finite_edges_end(); ++e) {
      const Face_handle f = e->first, g = f->neighbor(e->second);
      if (!cdt_.is_constrained(*e) && f->is_in_domain() != g->is_in_domain())
        border.emplace_back(f->vertex(Cdt::ccw(e->second)), f->vertex(Cdt::cw(e->second)));
    }
    for (const auto& [a, b] : border) cdt_.insert_constraint(a, b);
  }

  void add_vertices() {
    const auto n = static_cast<std::size_t>(cdt_.number_of_vertices());
    vertices_.reserve(n), pslg_.vertices.reserve(n);
    for (auto v = cdt_.finite_vertices_begin(); v != cdt_.finite_vertices_end(); ++v) {
      vertices_.push_back(v);
      pslg_.add_vertex(flat_(v->point()));
    }
  }

  void add_segments() {
    std::unordered_map<const typename Cdt::Vertex*, Vertex_index> index;
    index.reserve(vertices_.size());
    for (std::size_t v = 0; v < vertices_.size(); ++v) index.emplace(&*vertices_[v], Vertex_index(v));
    for (auto e = cdt_.finite_edges_begin(); e != cdt_.finite_edges_end(); ++e) {
      if (!cdt_.is_constrained(*e)) continue;
      const Face_handle f = e->first;
      const Vertex_index a = index.at(&*f->vertex(Cdt::ccw(e->second))),
                         b = index.at(&*f->vertex(Cdt::cw(e->second)));
      pslg_.add_segment(a, b);
      if (!f->is_in_domain() && !f->neighbor(e->second)->is_in_domain())
        outside_segments_.push_back({a.value(), b.value()});
    }
  }

  /// A point for each component of the domain, in the order of the faces.
  void add_components() {
    std::unordered_set<const typename Cdt::Face*> reached;
    for (auto first = cdt_.finite_faces_begin(); first != cdt_.finite_faces_end(); ++first) {
      if (!first->is_in_domain() || reached.count(&*first) != 0) continue;
      bool has_point = false;
      Point inside;
      flood_component<Cdt>(
          first,
          [&](Face_handle f) {
            if (!reached.insert(&*f).second) return false;
            if (!has_point) has_point = find_point_inside(f, inside);
            return true;
          },
          [](Face_handle) {});
      if (!has_point)
        throw Pslg_error_2(
            Pslg_error_2::Kind::ROUNDING,
            "a component of the domain is too thin: the coordinates have no room for a point in it");
      pslg_.regions.push_back({inside, 0, 0});
    }
  }

  /// The centroid, if rounding leaves it inside.
  bool find_point_inside(Face_handle f, Point& inside) const {
    const std::array<Point, 3> p{flat_(f->vertex(0)->point()), flat_(f->vertex(1)->point()),
                                 flat_(f->vertex(2)->point())};
    inside = Point((p[0].x() + p[1].x() + p[2].x()) / 3, (p[0].y() + p[1].y() + p[2].y()) / 3);
    const auto turn = typename Flat::Kernel().orientation_2_object();
    return turn(p[0], p[1], inside) == LEFT_TURN && turn(p[1], p[2], inside) == LEFT_TURN &&
           turn(p[2], p[0], inside) == LEFT_TURN;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_INPUT_H
