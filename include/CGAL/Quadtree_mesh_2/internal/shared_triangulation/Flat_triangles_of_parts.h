// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Flips of flat triangles outside (Flat_triangle_flipper.h) of a triangulation in parts.
//
// Computes: what sees the sides of the border from outside once these flips are made, where they change it.
// Bound:    O(f log f) for the f flat triangles outside, all of them at part 0. Most maps have none, or few.
// Method:   A flip takes two triangles that were flat, or next to a flat one, or made by such flips, and leaves no flat
//           one. So flips are those of the flat triangles and of what is beside them, which part 0 gets from all.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_FLAT_TRIANGLES_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_FLAT_TRIANGLES_OF_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Part_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Flat_triangle_flipper.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Some triangles of a larger triangulation, with the handles that they have there.
template <class Geometry>
class Chosen_triangles {
public:
  using Mesh = Kernel_mesh<Geometry>;

  struct Record {
    Triangle_id id;
    typename Mesh::Triangle triangle;
  };

  /// \param records by handle
  /// \param point_of gives the places of vertices
  template <class Point_of>
  Chosen_triangles(const std::vector<Record>& records, const Point_of& point_of) {
    for (const Record& r : records) vertices_.insert(vertices_.end(), r.triangle.v, r.triangle.v + 3);
    sort_and_drop_equal(vertices_);
    for (const Vertex_id v : vertices_) mesh_.add_vertex(point_of(v), input_vertex(v));
    for (const Record& r : records) {
      const Triangle_id t = mesh_.new_triangle();
      for (int k = 0; k < 3; ++k) {
        mesh_.triangle(t).v[k] = local(r.triangle.v[k]);
        mesh_.triangle(t).side[k] = local(r.triangle.side[k], records);
      }
    }
  }

  /// The mesh of them: vertices have the order that they have there, and other triangles are beyond the border.
  Mesh& mesh() { return mesh_; }
  /// The first vertex that has this number there, or a greater one.
  Vertex_id local(Vertex_id v) const {
    return Vertex_id(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
  }

  /// What sees the border from within, by its ends in order.
  std::vector<Outer_triangle> at_border() const {
    std::vector<Outer_triangle> found;
    const auto number = [this](Vertex_id v) { return vertices_[std::size_t(v)]; };
    for (const Triangle_id t : mesh_.triangles.ids())
      for (int k = 0; k < 3; ++k) {
        const Side s(t, k);
        if (mesh_.across(s).is_border())
          found.push_back({number(mesh_.source(s)), number(mesh_.target(s)), number(mesh_.opposite(s))});
      }
    std::sort(found.begin(), found.end(), is_before);
    return found;
  }
  static bool is_before(const Outer_triangle& s, const Outer_triangle& t) {
    return s.a < t.a || (s.a == t.a && s.b < t.b);
  }

private:
  std::vector<Vertex_id> vertices_; // by local handle
  Mesh mesh_;

  static Side local(Side o, const std::vector<Record>& records) {
    if (o.is_border()) return o;
    const auto found = std::lower_bound(records.begin(), records.end(), o.triangle(),
                                        [](const Record& r, Triangle_id t) { return r.id < t; });
    if (found == records.end() || found->id != o.triangle()) return Side::border();
    return o.renamed(Triangle_id(found - records.begin()));
  }
};

template <class Exchange, class Geometry>
class Flat_triangles_of_parts {
public:
  using Part = Part_triangles<Geometry>;

  /// \param is_kept by place in the part
  Flat_triangles_of_parts(Exchange& exchange, const Part& part, const std::vector<char>& is_kept)
      : exchange_(exchange), part_(part), is_kept_(is_kept) {}

  /// All parts call it, and part 0 gets the result.
  /// \param point_of gives the places of vertices, at all parts
  /// \param first_auxiliary vertices from it on are no input
  /// \returns what sees sides, by their ends in order, of which some are not of the border
  template <class Point_of>
  std::vector<Outer_triangle> run(const Point_of& point_of, Vertex_id first_auxiliary) {
    const std::vector<std::size_t> flat = flat_triangles(point_of);
    if (exchange_.sum(static_cast<std::int64_t>(flat.size())) == 0) return {};
    Records_of_parts<Record> outbox;
    for (const std::size_t i : with_neighbors(flat))
      outbox[0].push_back({Triangle_id(part_.begin + i), part_.triangles[i]});
    const std::vector<Record> all = exchange_and_join(exchange_, std::move(outbox));
    if (exchange_.rank() != 0) return {};
    Chosen_triangles<Geometry> chosen(all, point_of);
    const Indexed_vector<Triangle_id, char> none_is_kept(all.size(), 0);
    Flipper(chosen.mesh(), none_is_kept, chosen.local(first_auxiliary)).run();
    return chosen.at_border();
  }

private:
  using Record = typename Chosen_triangles<Geometry>::Record;
  using Flipper = Flat_triangle_flipper<Geometry>;

  Exchange& exchange_;
  const Part& part_;
  const std::vector<char>& is_kept_;

  template <class Point_of>
  std::vector<std::size_t> flat_triangles(const Point_of& point_of) const {
    std::vector<std::size_t> flat;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      const auto& v = part_.triangles[i].v;
      if (is_kept_[i] == 0 &&
          Flipper::is_flat(Kernel_mesh<Geometry>::shape(point_of(v[0]), point_of(v[1]), point_of(v[2]))))
        flat.push_back(i);
    }
    return flat;
  }

  /// This part's triangles that are flat, or next to a flat one of any part, and not kept.
  std::vector<std::size_t> with_neighbors(const std::vector<std::size_t>& flat) {
    std::vector<std::size_t> found = flat;
    Records_of_parts<Triangle_id> outbox;
    for (const std::size_t i : flat)
      for (const Side o : part_.triangles[i].side) {
        if (o.is_border() || o.is_constrained()) continue;
        if (part_.has(o.triangle()))
          found.push_back(part_.place(o.triangle()));
        else
          outbox[part_.part_of(o.triangle())].push_back(o.triangle());
      }
    for (const Triangle_id t : exchange_and_join(exchange_, std::move(outbox)))
      found.push_back(part_.place(t));
    sort_and_drop_equal(found);
    return found;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_FLAT_TRIANGLES_OF_PARTS_H
