// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Converts the kernel's mesh to flat arrays, in the user's coordinates and vertex order, and the account of its
// triangles to the report. O(n), in parallel.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_KERNEL_MESH_TO_INDEXED_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_KERNEL_MESH_TO_INDEXED_MESH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Id_set.h>
#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/base/prefetch.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Bound_reporter.h>
#include <CGAL/Quadtree_mesh_2/internal/output/boundary_markers.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class ConcurrencyTag>
class Kernel_mesh_converter {
public:
  using Geometry = Mesher_geometry<Traits>;
  using Point_2 = typename Traits::Point_2;
  using Map = Coordinate_map<Traits, Geometry>;
  using Mesh = Indexed_mesh_2<Point_2>;

  Kernel_mesh_converter(const Meshing_state<Geometry>& state, const Pslg_2<Point_2>& pslg, const Map& map,
                        const Order& order, Quality_mesh_report_2& report)
      : state_(state), mesh_(state.mesh), pslg_(pslg), map_(map), order_(order), report_(report) {}

  /// \param account of the mesh as it is
  /// \param refiner knows why it could not cure what is bad
  Mesh run(const Triangle_account& account, Refiner<Geometry>& refiner) {
    Mesh out;
    number_triangles();
    make_vertices(out);
    const std::size_t block = std::max(default_block, mesh_.triangles.size() / most_parts);
    std::vector<Part> parts((mesh_.triangles.size() + block - 1) / block);
    for_each_block<ConcurrencyTag>(mesh_.triangles.size(), block,
                                   [&](std::size_t b, std::size_t begin, std::size_t end) {
                                     make_triangles(out, begin, end, parts[b]);
                                   });
    append_all<ConcurrencyTag>(
        out.constrained_edges, parts, [](const Part& part) -> const auto& { return part.edges; });
    std::vector<Ends> border;
    append_all<ConcurrencyTag>(
        border, parts, [](const Part& part) -> const auto& { return part.border; });
    account.angles.add_to(report_.least_angle_histogram, report_.largest_angle_histogram);
    for (const Triangle_id t : account.suspects) report(t, refiner);
    set_boundary_markers(out, pslg_, border);
    report_.triangles = out.triangles.size();
    return out;
  }

private:
  using Ends = std::array<Vertex_index, 2>;
  /// In which triangles are made: enough for many threads, and few enough that each is a long array in a large mesh.
  static constexpr std::size_t most_parts = 512;
  /// What a run of triangles has besides triangles.
  struct Part {
    std::vector<typename Mesh::Constrained_edge> edges;
    std::vector<Ends> border;
  };

  const Meshing_state<Geometry>& state_;
  const Kernel_mesh<Geometry>& mesh_;
  const Pslg_2<Point_2>& pslg_;
  const Map& map_;
  const Order& order_;
  Quality_mesh_report_2& report_;
  Uninitialized_indexed_vector<Vertex_id, Vertex_index> new_vertex_;       // of those that are used
  Uninitialized_indexed_vector<Triangle_id, Triangle_index> new_triangle_; // of those that are alive
  std::size_t number_of_triangles_ = 0;

  /// Input vertices stay where they are, used or not; Steiner vertices that are used follow.
  void make_vertices(Mesh& out) {
    const std::size_t n = order_.size(), all = mesh_.number_of_vertices();
    out.number_of_input_vertices = n;
    new_vertex_.resize(all);
    for_each_index<ConcurrencyTag>(
        n, [&](std::size_t v) { new_vertex_[static_cast<Vertex_id>(v)] = Vertex_index(order_[v]); });
    const std::size_t steiner = count_allocate_and_place<ConcurrencyTag>(
        all - n,
        [&](std::size_t begin, std::size_t end) {
          return number_of_used({n + begin, n + end});
        },
        [&](std::size_t sum) { allocate(out, n + sum); },
        [&](std::size_t begin, std::size_t end, std::size_t first) {
          for (const Vertex_id v : Id_range<Vertex_id>(n + begin, n + end))
            if (mesh_.is_used(v)) make_steiner_vertex(out, v, n + first++);
        });
    for_each_index<ConcurrencyTag>(n, [&](std::size_t v) { out.points[v] = pslg_.vertices[v]; });
    report_.vertices = steiner + number_of_used({std::size_t(0), n});
  }

  /// Makes all arrays at the same time: a vector is filled with first values by one thread.
  void allocate(Mesh& out, std::size_t vertices) const {
    Executor<ConcurrencyTag>::run(6, [&](std::size_t i) {
      switch (i) {
      case 0:
        return resize_with_pages(out.triangles, number_of_triangles_);
      case 1:
        return resize_with_pages(out.neighbors, number_of_triangles_);
      case 2:
        return resize_with_pages(out.points, vertices);
      case 3:
        return resize_with_pages(out.segment_of_vertex, vertices);
      case 4:
        return resize_with_pages(out.vertex_markers, vertices);
      default:
        if (!mesh_.region_of.empty()) resize_with_pages(out.region_of_triangle, number_of_triangles_);
      }
    });
  }

  std::size_t number_of_used(Id_range<Vertex_id> vertices) const {
    std::size_t sum = 0;
    for (const Vertex_id v : vertices) sum += mesh_.is_used(v) ? 1 : 0;
    return sum;
  }

  void make_steiner_vertex(Mesh& out, Vertex_id v, std::size_t place) {
    new_vertex_[v] = Vertex_index(place);
    out.points[place] = map_.to_user(mesh_.point(v));
    if (mesh_.edge(v).is_valid()) out.segment_of_vertex[place] = state_.edges[mesh_.edge(v)].segment;
  }

  /// Those alive, in order. The dead are known, so nobody has to look at all triangles.
  void number_triangles() {
    const std::size_t slots = mesh_.triangles.size();
    Id_set<Triangle_id> dead(slots);
    for (const Triangle_id t : mesh_.dead_triangles()) dead.add(t);
    number_of_triangles_ = count_allocate_and_place<ConcurrencyTag>(
        slots,
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (const Triangle_id t : Id_range<Triangle_id>(begin, end)) sum += dead.has(t) ? 0 : 1;
          return sum;
        },
        [&](std::size_t) { new_triangle_.resize(slots); },
        [&](std::size_t begin, std::size_t end, std::size_t first) {
          for (const Triangle_id t : Id_range<Triangle_id>(begin, end)) {
            new_triangle_[t] = Triangle_index(first); // of no meaning for the dead
            first += dead.has(t) ? 0 : 1;
          }
        });
  }

  void prefetch_names(Triangle_id t) const {
    const auto& r = mesh_.triangle(t);
    for (const Vertex_id v : r.v)
      prefetch(new_vertex_.data() + v.value()), prefetch(mesh_.role_of.data() + v.value());
    for (const Side o : r.side)
      if (!o.is_border()) prefetch(new_triangle_.data() + o.triangle().value());
  }

  void make_triangles(Mesh& out, std::size_t begin, std::size_t end, Part& part) const {
    constexpr std::size_t most = 256; // at once
    Side constrained[3 * most];
    for (; begin < end; begin += most) {
      Side* next = constrained;
      visit_with_foresight(
          Id_range<Triangle_id>(begin, std::min(begin + most, end)),
          [this](Triangle_id t) { prefetch_names(t); },
          [&](Triangle_id t) {
            if (mesh_.is_alive(t)) next = make_triangle(out, t, next);
          });
      std::for_each(constrained, next, [&](Side s) { add_constrained_edge(part, s); });
    }
  }

  /// \param next where constrained sides are noted, each edge from one of its triangles; there is room for three
  /// \returns the place behind them
  Side* make_triangle(Mesh& out, Triangle_id t, Side* next) const {
    const auto& r = mesh_.triangle(t);
    const auto place = std::size_t(new_triangle_[t]);
    for (int k = 0; k < 3; ++k) { // no branches: they would be taken at random
      out.triangles[place][std::size_t(k)] = new_vertex_[r.v[k]];
      const Side o = r.side[k];
      const Triangle_id across = o.is_border() ? t : o.triangle();
      out.neighbors[place][std::size_t(k)] = o.is_border() ? Triangle_index() : new_triangle_[across];
      *next = Side(t, k);
      next += (o.is_constrained() ? 1 : 0) & (across < t ? 0 : 1);
    }
    if (!mesh_.region_of.empty()) out.region_of_triangle[place] = static_cast<int>(mesh_.region(t).value());
    return next;
  }

  void add_constrained_edge(Part& part, Side s) const {
    const Vertex_id x = mesh_.source(s), y = mesh_.target(s);
    const Ends ends{new_vertex_[x], new_vertex_[y]};
    if (mesh_.across(s).is_border()) part.border.push_back(ends);
    const Edge_id e = state_.edges.carrying(mesh_, x, y);
    if (!e.is_valid()) return;
    part.edges.push_back({ends, state_.edges[e].segment});
    const Vertex_id outer = state_.problem.outer_vertex(e);
    if (outer.is_valid()) part.edges.back().outer_vertex = new_vertex_[outer];
  }

  /// Reports a triangle that misses a bound.
  void report(Triangle_id t, Refiner<Geometry>& refiner) {
    const Bound_reporter<Traits> reporter(state_, map_, Bound_reporter<Traits>::end_of(report_));
    if (reporter.is_excused(t))
      report_.exempt_triangles.push_back({new_triangle_[t], new_vertex_[reporter.excusing_corner(t)]});
    else
      report_.unmet_triangles.push_back(reporter.unmet(t, new_triangle_[t], refiner.kept_edge_in_the_way(t)));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_KERNEL_MESH_TO_INDEXED_MESH_H
