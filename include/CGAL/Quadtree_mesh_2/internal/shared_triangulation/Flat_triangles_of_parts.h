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

template <class Exchange, class Geometry>
class Flat_triangles_of_parts {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Part = Part_triangles<Geometry>;
  using Flipper = Flat_triangle_flipper<Geometry>;

  /// \param seams that tell which triangles of others are kept: not 0
  /// \param is_kept by place in the part
  Flat_triangles_of_parts(Exchange& exchange, const Part& part, const Seam_sides<Geometry>& seams,
                          const std::vector<char>& is_kept)
      : exchange_(exchange), part_(part), seams_(seams), is_kept_(is_kept) {}

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
    return exchange_.rank() == 0 ? flip(all, point_of, first_auxiliary) : std::vector<Outer_triangle>();
  }

private:
  struct Record {
    Triangle_id id;
    typename Mesh::Triangle triangle;
  };

  Exchange& exchange_;
  const Part& part_;
  const Seam_sides<Geometry>& seams_;
  const std::vector<char>& is_kept_;

  template <class Point_of>
  std::vector<std::size_t> flat_triangles(const Point_of& point_of) const {
    std::vector<std::size_t> flat;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      const auto& v = part_.triangles[i].v;
      if (is_kept_[i] == 0 && Flipper::is_flat(Mesh::shape(point_of(v[0]), point_of(v[1]), point_of(v[2]))))
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
    for (const Triangle_id t : exchange_and_join(exchange_, std::move(outbox))) found.push_back(part_.place(t));
    sort_and_drop_equal(found);
    return found;
  }

  template <class Point_of>
  static std::vector<Outer_triangle> flip(const std::vector<Record>& records, const Point_of& point_of,
                                          Vertex_id first_auxiliary) {
    std::vector<Vertex_id> vertices;
    for (const Record& r : records) vertices.insert(vertices.end(), r.triangle.v, r.triangle.v + 3);
    sort_and_drop_equal(vertices);
    const auto local = [](const auto& ids, const auto id, const auto& id_of) {
      return static_cast<std::size_t>(
          std::lower_bound(ids.begin(), ids.end(), id,
                           [&](const auto& x, const auto& y) { return id_of(x) < y; }) -
          ids.begin());
    };
    const auto local_vertex = [&](Vertex_id v) { return local(vertices, v, [](Vertex_id w) { return w; }); };
    const auto local_triangle = [&](Triangle_id t) {
      return local(records, t, [](const Record& r) { return r.id; });
    };
    Mesh mesh;
    for (const Vertex_id v : vertices) mesh.add_vertex(point_of(v), input_vertex(v));
    for (const Record& r : records) {
      const Triangle_id t = mesh.new_triangle();
      for (int k = 0; k < 3; ++k) {
        mesh.triangle(t).v[k] = Vertex_id(local_vertex(r.triangle.v[k]));
        const Side o = r.triangle.side[k];
        const std::size_t u = o.is_border() ? records.size() : local_triangle(o.triangle());
        const bool is_there = u < records.size() && records[u].id == o.triangle();
        mesh.triangle(t).side[k] = is_there ? o.renamed(Triangle_id(u)) : Side::border();
      }
    }
    const Indexed_vector<Triangle_id, char> none_is_kept(mesh.triangles.size(), 0);
    Flipper(mesh, none_is_kept, Vertex_id(local_vertex(first_auxiliary))).run();
    std::vector<Outer_triangle> seen;
    for (const Triangle_id t : mesh.triangles.ids())
      for (int k = 0; k < 3; ++k) {
        const Side s(t, k);
        if (mesh.across(s).is_border())
          seen.push_back({vertices[std::size_t(mesh.source(s))], vertices[std::size_t(mesh.target(s))],
                          vertices[std::size_t(mesh.opposite(s))]});
      }
    std::sort(seen.begin(), seen.end(), [](const Outer_triangle& s, const Outer_triangle& t) {
      return s.a < t.a || (s.a == t.a && s.b < t.b);
    });
    return seen;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_FLAT_TRIANGLES_OF_PARTS_H
