// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// One block of a mesh, taken out as a mesh on its own.
//
// Triangles keep the order in which they are given, vertices are numbered as they occur, so a block's memory is
// its own and small: it stays in the cache while it is worked on. The sides where the rest of the mesh goes on
// become seams, which remember what they were. O(size of the block), besides sorting the vertices that are first
// known from other blocks.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_BLOCK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_BLOCK_H

#include <CGAL/Quadtree_mesh_2/internal/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Block_id = std::int32_t;

/// Where each triangle of the whole mesh went: its block (-1: none), and its place there.
struct Block_assignment {
  std::vector<Block_id> block;
  std::vector<Triangle_id> place;

  Block_id block_of(Triangle_id t) const { return block[std::size_t(t)]; }
  Triangle_id place_of(Triangle_id t) const { return place[std::size_t(t)]; }
};

template <class Geometry>
class Mesh_block {
public:
  using Mesh = Kernel_mesh<Geometry>;

  /// A side beyond which the whole mesh goes on.
  struct Seam {
    Side here, beyond; ///< of the whole mesh, as it was when the block was taken out
    Side now;          ///< the same side in the block, in the end; set by `write_triangles()`
  };

  Mesh mesh;

  Mesh_block(const Mesh& whole, const Block_assignment& assignment, Block_id id, const Triangle_id* begin,
             const Triangle_id* end)
      : whole_(&whole), assignment_(&assignment), id_(id), begin_(begin), end_(end) {
    collect_foreign_vertices();
    take_triangles();
    mark_shared_vertices();
  }

  Block_id id() const { return id_; }

  /// The handle in the block of a vertex of the whole mesh, -1 if it is not in the block. Only until blocks are put
  /// back.
  Vertex_id vertex_in_block(Vertex_id whole_vertex) const {
    const Triangle_id t = whole_->incident_triangle(whole_vertex);
    if (t < 0) return -1;
    if (assignment_->block_of(t) == id_) return own_[own_place(t, whole_vertex)];
    const auto i = std::lower_bound(foreign_.begin(), foreign_.end(), Foreign{whole_vertex, 0});
    return i != foreign_.end() && i->whole == whole_vertex ? i->here : -1;
  }

  /// Adds a vertex that the whole mesh has, but no triangle of it.
  Vertex_id add_known_vertex(Vertex_id whole_vertex) {
    const Vertex_id v = mesh.add_vertex(whole_->point(whole_vertex), whole_->edge(whole_vertex));
    whole_vertex_.resize(std::size_t(v) + 1, -1);
    whole_vertex_[std::size_t(v)] = whole_vertex;
    return v;
  }

  // ---- putting back

  /// How many triangles and vertices the whole mesh has to get for this block. Names its triangles and vertices.
  std::size_t number_of_new_triangles() const {
    return std::max(mesh.number_of_triangles(), taken()) - taken();
  }
  std::size_t number_of_new_vertices() const {
    std::size_t count = 0;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (is_new(v) && mesh.is_used(static_cast<Vertex_id>(v))) ++count;
    return count;
  }

  /// Names what is in the block: triangles by the places of those taken out and then by `first_triangle`, ...;
  /// new vertices by `first_vertex`, ...
  void name(Triangle_id first_triangle, Vertex_id first_vertex) {
    whole_triangle_.assign(mesh.triangles.size(), -1);
    std::size_t rank = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!mesh.is_alive(static_cast<Triangle_id>(t))) continue;
      whole_triangle_[t] =
          rank < taken() ? begin_[rank] : first_triangle + static_cast<Triangle_id>(rank - taken());
      ++rank;
    }
    whole_vertex_.resize(mesh.number_of_vertices(), -1);
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (is_new(v) && mesh.is_used(static_cast<Vertex_id>(v))) whole_vertex_[v] = first_vertex++;
  }
  Triangle_id whole_triangle(Triangle_id t) const { return whole_triangle_[std::size_t(t)]; }
  Vertex_id whole_vertex(Vertex_id v) const { return whole_vertex_[std::size_t(v)]; }

  /// Writes what only this block has. \pre it is named, and the whole mesh has room.
  void write(Mesh& whole) {
    write_triangles(whole);
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      const auto w = std::size_t(whole_vertex_[v]);
      if (whole_vertex_[v] < 0 || is_shared(v)) continue;
      whole.points[w] = mesh.points[v];
      whole.edge_of[w] = mesh.edge_of[v];
      whole.is_dirty[w] = mesh.is_dirty[v];
      whole.triangle_of[w] = mesh.triangle_of[v] < 0 ? -1 : whole_triangle(mesh.triangle_of[v]);
    }
  }

  /// Writes what other blocks may write too; for one block after the other.
  void write_shared(Mesh& whole) const {
    for (std::size_t v = 0; v < is_shared_.size(); ++v)
      if (is_shared(v) && mesh.triangle_of[v] >= 0)
        whole.triangle_of[std::size_t(whole_vertex_[v])] = whole_triangle(mesh.triangle_of[v]);
    for (std::size_t rank = mesh.number_of_triangles(); rank < taken(); ++rank) whole.kill(begin_[rank]);
  }

  const std::vector<Seam>& seams() const { return seams_; }

private:
  struct Foreign {
    Vertex_id whole, here;
    friend bool operator<(const Foreign& a, const Foreign& b) { return a.whole < b.whole; }
  };

  const Mesh* whole_;
  const Block_assignment* assignment_;
  Block_id id_;
  const Triangle_id *begin_, *end_; // the triangles taken out
  std::vector<Seam> seams_;
  // Block handles of vertices: by a triangle and slot for those whose incident triangle in the whole mesh is in the
  // block, listed for the others, which lie at seams.
  std::vector<Vertex_id> own_;
  std::vector<Foreign> foreign_;
  std::vector<char> is_shared_; // of the vertices taken out: other blocks may have them too
  std::vector<Vertex_id> whole_vertex_;
  std::vector<Triangle_id> whole_triangle_;

  std::size_t taken() const { return static_cast<std::size_t>(end_ - begin_); }
  bool is_new(std::size_t v) const { return v >= whole_vertex_.size() || whole_vertex_[v] < 0; }
  bool is_shared(std::size_t v) const { return v < is_shared_.size() && is_shared_[v] != 0; }

  std::size_t own_place(Triangle_id t, Vertex_id whole_vertex) const {
    return 3 * std::size_t(assignment_->place_of(t)) +
           std::size_t(Mesh::slot_of(whole_->triangle(t), whole_vertex));
  }

  void collect_foreign_vertices() {
    for (const Triangle_id* t = begin_; t != end_; ++t)
      for (const Vertex_id v : whole_->triangle(*t).v)
        if (assignment_->block_of(whole_->incident_triangle(v)) != id_) foreign_.push_back({v, -1});
    std::sort(foreign_.begin(), foreign_.end());
    foreign_.erase(std::unique(foreign_.begin(), foreign_.end(),
                               [](const Foreign& a, const Foreign& b) { return a.whole == b.whole; }),
                   foreign_.end());
    own_.assign(3 * taken(), -1);
  }

  void take_triangles() {
    constexpr std::size_t growth = 3; // more is seldom needed
    mesh.triangles.reserve(growth * taken());
    mesh.points.reserve(growth * taken() / 2), mesh.edge_of.reserve(growth * taken() / 2);
    mesh.triangle_of.reserve(growth * taken() / 2), mesh.is_dirty.reserve(growth * taken() / 2);
    whole_vertex_.reserve(taken());
    mesh.triangles.resize(taken());
    if (!whole_->region_of.empty()) mesh.region_of.resize(taken());
    for (const Triangle_id* t = begin_; t != end_; ++t) take(*t, static_cast<Triangle_id>(t - begin_));
  }

  void take(Triangle_id t, Triangle_id here) {
    const auto& from = whole_->triangle(t);
    auto& to = mesh.triangle(here);
    mesh.set_region(here, whole_->region(t));
    for (int k = 0; k < 3; ++k) {
      to.v[k] = take_vertex(from.v[k]);
      mesh.triangle_of[std::size_t(to.v[k])] = here;
      const Side o = from.side[k];
      if (o.is_border()) {
        to.side[k] = o;
      } else if (assignment_->block_of(o.triangle()) == id_) {
        to.side[k] = Side(assignment_->place_of(o.triangle()), o.slot(), o.is_constrained());
      } else {
        to.side[k] = Side::seam(static_cast<std::int32_t>(seams_.size()));
        seams_.push_back({Side(t, k), o, Side::border()});
      }
    }
  }

  Vertex_id take_vertex(Vertex_id whole_vertex) {
    const Triangle_id t = whole_->incident_triangle(whole_vertex);
    Vertex_id& v = assignment_->block_of(t) == id_
                       ? own_[own_place(t, whole_vertex)]
                       : std::lower_bound(foreign_.begin(), foreign_.end(), Foreign{whole_vertex, 0})->here;
    if (v < 0) {
      v = add_known_vertex(whole_vertex);
      mesh.is_dirty[std::size_t(v)] = whole_->is_dirty[std::size_t(whole_vertex)];
    }
    return v;
  }

  /// Vertices at seams, and input vertices at the border, which may have fans in other blocks.
  void mark_shared_vertices() {
    is_shared_.assign(mesh.number_of_vertices(), 0);
    for (const auto& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        if (!t.side[k].is_border()) continue;
        for (const Vertex_id v : {t.v[next_slot[k]], t.v[previous_slot[k]]})
          if (t.side[k].is_seam() || mesh.is_input(v)) is_shared_[std::size_t(v)] = 1;
      }
  }

  void write_triangles(Mesh& whole) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle_id w = whole_triangle_[t];
      if (w < 0) continue;
      const auto& from = mesh.triangles[t];
      auto& to = whole.triangle(w);
      whole.set_region(w, mesh.region(static_cast<Triangle_id>(t)));
      for (int k = 0; k < 3; ++k) {
        to.v[k] = whole_vertex(from.v[k]);
        const Side o = from.side[k];
        to.side[k] =
            o.is_border() ? Side::border() : Side(whole_triangle(o.triangle()), o.slot(), o.is_constrained());
        if (o.is_seam()) seams_[std::size_t(o.seam_number())].now = Side(w, k);
      }
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_BLOCK_H
