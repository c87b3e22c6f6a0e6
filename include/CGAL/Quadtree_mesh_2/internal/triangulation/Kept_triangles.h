// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Drops the triangles of a mesh that are not kept, and gives the others the handles that their vertices determine.
//
// Computes: the mesh of the triangles kept. Each begins with its least vertex. They are in the order of that and of
//           their next vertex. A vertex knows the first triangle that begins with it, or the first at it if none does.
// Bound:    O(n) for n triangles, in parallel, and O(d log d) for the d triangles of a vertex.
// Method:   Triangles are copied in their new order. The memory of the old array is given back piece by piece, as soon
//           as all triangles of a piece are copied. Where the mesh was made in blocks, both orders follow the vertices,
//           and so there is memory for little more than one array at a time.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_TRIANGLES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_short_run.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/Run_counters.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Mesh>
class Kept_triangles {
public:
  /// \pre around each vertex the triangles of the mesh make one fan, of which some may be kept and others not
  Kept_triangles(Mesh& mesh, const Indexed_vector<Triangle_id, char>& is_kept)
      : mesh_(mesh), is_kept_(is_kept), new_side_(mesh.triangles.size()), runs_(mesh.points.size()) {
    group_by_least_vertex();
    for_each_index<Chosen_tag>(runs_.size(), [this](std::size_t v) { sort_run(v); });
  }

  /// Drops all other triangles, and the vertices from the given one on.
  void keep(Vertex_id end_of_vertices) {
    keep(end_of_vertices, [](const auto&) {});
  }
  /// \param rename called with a function that gives a side of a kept triangle its new name, while old ones are known
  template <class Rename>
  void keep(Vertex_id end_of_vertices, const Rename& rename) {
    rename([this](Side s) { return renamed(s); });
    mesh_.triangle_of.truncate(end_of_vertices);
    name_first_triangles();
    mesh_.points.truncate(end_of_vertices), mesh_.role_of.truncate(end_of_vertices);
    mesh_.is_dirty.truncate(end_of_vertices);
    decltype(mesh_.region_of) region_of(mesh_.region_of.empty() ? 0 : order_.size());
    for_each_index<Chosen_tag>(region_of.size(), [&](std::size_t i) {
      const Triangle_id t = static_cast<Triangle_id>(i);
      region_of[t] = mesh_.region(order_[t]);
    });
    mesh_.region_of = std::move(region_of);
    runs_ = Run_counters(0);
    mesh_.triangles = renamed_triangles();
  }

private:
  using Triangle = typename Mesh::Triangle;
  /// The triangles of a piece: whole pages, and so few that it is rare for one to be copied long after the others.
  static constexpr std::size_t piece_ = 1024;
  /// So many are copied before pieces are given back, in runs for many threads.
  static constexpr std::size_t batch_ = 64 * piece_, run_ = 2048;

  /// Of the old array.
  struct Piece {
    std::size_t first, last; ///< its first triangle, and the greatest new number of one in it
  };

  Mesh& mesh_;
  const Indexed_vector<Triangle_id, char>& is_kept_;
  Uninitialized_indexed_vector<Triangle_id, Triangle_id> order_; // the handles that there were
  // The side opposite the least vertex, with the new handle, of triangles that are kept.
  Uninitialized_indexed_vector<Triangle_id, Side> new_side_;
  Run_counters runs_; // of the triangles with one least vertex, in their order

  template <class Function>
  void for_each_kept(const Function& f) {
    for_each_index<Chosen_tag>(is_kept_.size(), [&](std::size_t i) {
      const Triangle_id t = static_cast<Triangle_id>(i);
      if (is_kept_[t] != 0) f(t, mesh_.triangle(t).v[Mesh::slot_of_least(mesh_.triangle(t))]);
    });
  }

  void group_by_least_vertex() {
    for_each_kept([this](Triangle_id, Vertex_id v) { runs_.count(std::size_t(v)); });
    order_.resize(runs_.begin_placing());
    for_each_kept(
        [this](Triangle_id t, Vertex_id v) { order_[Triangle_id(runs_.place(std::size_t(v)))] = t; });
  }

  Vertex_id next_vertex(Triangle_id t) const {
    const Triangle& r = mesh_.triangle(t);
    return r.v[next_slot[Mesh::slot_of_least(r)]];
  }

  /// Sorts the triangles with one least vertex by their next vertex, and names them.
  void sort_run(std::size_t v) {
    const std::size_t first = runs_.begin(v), last = runs_.end(v);
    const auto is_before = [this](Triangle_id t, Triangle_id u) { return next_vertex(t) < next_vertex(u); };
    sort_short_run(order_.data() + first, order_.data() + last, is_before);
    for (std::size_t i = first; i < last; ++i) {
      const Triangle_id t = static_cast<Triangle_id>(i), before = order_[t];
      new_side_[before] = Side(t, Mesh::slot_of_least(mesh_.triangle(before)));
    }
  }

  Triangle_id new_handle(Triangle_id t) const {
    return is_kept_[t] != 0 ? new_side_[t].triangle() : Triangle_id();
  }

  /// The triangles that vertices know.
  void name_first_triangles() {
    for_each_index<Chosen_tag>(mesh_.triangle_of.size(), [&](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      Triangle_id first = runs_.begin(i) < runs_.end(i) ? Triangle_id(runs_.begin(i)) : Triangle_id();
      if (!first.is_valid() && mesh_.is_used(v))
        mesh_.for_each_triangle_at(v, [&](Triangle_id t, int) {
          first = std::min(first, new_handle(t)); // none is greater than any
        });
      mesh_.triangle_of[v] = first;
    });
  }

  /// Leaves nothing in the old array.
  auto renamed_triangles() {
    decltype(mesh_.triangles) triangles;
    triangles.reserve(order_.size() + order_.size() / 8); // acute corners are cut soon
    triangles.resize(order_.size());
    const std::vector<Piece> pieces = pieces_by_last();
    auto needless = pieces.begin();
    for (std::size_t begin = 0; begin < order_.size(); begin += batch_) {
      const std::size_t end = std::min(begin + batch_, order_.size());
      const auto copy = [&](std::size_t i) {
        const Triangle_id t = static_cast<Triangle_id>(begin + i);
        triangles[t] = renamed(mesh_.triangle(order_[t]));
      };
      for_each_index<Chosen_tag>(end - begin, copy, run_);
      for (; needless != pieces.end() && needless->last < end; ++needless)
        give_back_values(mesh_.triangles, needless->first,
                         std::min(needless->first + piece_, mesh_.triangles.size()));
    }
    return triangles;
  }

  /// The pieces of the old array, in the order in which they are needed no more.
  std::vector<Piece> pieces_by_last() const {
    std::vector<Piece> pieces((is_kept_.size() + piece_ - 1) / piece_);
    for_each_block<Chosen_tag>(
        is_kept_.size(), piece_, [&](std::size_t piece, std::size_t begin, std::size_t end) {
          pieces[piece] = {begin, 0};
          for (const Triangle_id t : Id_range<Triangle_id>(begin, end))
            if (is_kept_[t] != 0)
              pieces[piece].last = std::max(pieces[piece].last, std::size_t(new_side_[t].triangle()));
        });
    std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) { return p.last < q.last; });
    return pieces;
  }

  Triangle renamed(const Triangle& before) const {
    Triangle triangle;
    int from = Mesh::slot_of_least(before);
    for (int k = 0; k < 3; ++k, from = next_slot[from])
      triangle.v[k] = before.v[from], triangle.side[k] = renamed(before.side[from]);
    return triangle;
  }

  Side renamed(Side o) const {
    if (o.is_border() || is_kept_[o.triangle()] == 0) return Side::border();
    const Side first = new_side_[o.triangle()];
    const int slot = o.slot() - first.slot();
    return Side(first.triangle(), slot < 0 ? slot + 3 : slot, o.is_constrained());
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_TRIANGLES_H
