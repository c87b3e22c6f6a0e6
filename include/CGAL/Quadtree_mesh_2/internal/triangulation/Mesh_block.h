// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// One block of a mesh, taken out as a mesh of its own.
//
// Triangles keep their given order, and vertices are numbered as they occur. So the memory of a block is its
// own and small, and stays in the cache. The sides where the rest of the mesh continues become seams, which
// remember what they were. Once the block is written back, it keeps what is at seams alone. O(size of
// the block), not counting the sorting of vertices at seams.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_MESH_BLOCK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_MESH_BLOCK_H

#include <CGAL/Quadtree_mesh_2/internal/base/Sparse_values.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/reserve_in_parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Block_id = Index<struct Block_tag>;

/// Where the triangles and vertices of the whole mesh go. Once the blocks are put together, nothing is in any.
class Block_assignment {
public:
  struct Place {
    Block_id block; ///< or none
    Triangle_id triangle;
  };

  /// For any number of triangles, once they are covered.
  Block_assignment() = default;
  /// For few of the triangles of a mesh: one thread has to set each of them, and its vertices, before others do.
  template <class Mesh>
  static Block_assignment for_few(const Mesh& mesh) {
    Block_assignment assignment;
    assignment.is_for_few_ = true;
    assignment.of_few_triangles_ = Few_triangles(mesh.triangles.size());
    assignment.of_few_vertices_ = Few_vertices(mesh.number_of_vertices());
    return assignment;
  }

  Place operator[](Triangle_id t) const { return is_for_few_ ? of_few_triangles_[t] : of_triangle_[t]; }
  void set(Triangle_id t, Place place) { (is_for_few_ ? of_few_triangles_.at(t) : of_triangle_[t]) = place; }
  /// The handle of a vertex in the block of the triangle that the whole mesh knows at it; or in the block that inserts
  /// it, until the assignment goes. Written and read by that block alone.
  Vertex_id& vertex_in_block(Vertex_id v) { return is_for_few_ ? of_few_vertices_.at(v) : of_vertex_[v]; }
  /// Whether a block has made the triangle, one that is written already.
  bool is_new(Triangle_id t) const { return is_for_few_ ? !of_few_triangles_.has(t) : !of_triangle_.has(t); }

  void prefetch_place(Triangle_id t) const {
    if (!is_for_few_) prefetch(of_triangle_.data() + t.value());
  }
  void prefetch_place(Vertex_id v) const {
    if (!is_for_few_) prefetch(of_vertex_.data() + v.value());
  }

  /// Makes room for what a mesh has got since.
  template <class ConcurrencyTag, class Mesh>
  void cover(const Mesh& mesh) {
    append_none<ConcurrencyTag>(of_triangle_, mesh.triangles);
    append_none<ConcurrencyTag>(of_vertex_, mesh.points);
  }

private:
  using Few_triangles = Sparse_values<Triangle_id, Place>;
  using Few_vertices = Sparse_values<Vertex_id, Vertex_id>;

  Uninitialized_indexed_vector<Triangle_id, Place> of_triangle_;
  Uninitialized_indexed_vector<Vertex_id, Vertex_id> of_vertex_;
  bool is_for_few_ = false;
  Few_triangles of_few_triangles_;
  Few_vertices of_few_vertices_;

  template <class ConcurrencyTag, class Places, class Values>
  static void append_none(Places& places, const Values& values) {
    const std::size_t begin = places.size();
    reserve_in_parallel(places, values.capacity());
    places.resize(values.size());
    for_each_index<ConcurrencyTag>(values.size() - begin,
                                   [&](std::size_t i) { *(places.data() + begin + i) = {}; });
  }
};

/// A side beyond which the whole mesh goes on.
struct Seam {
  Side here, beyond; ///< of the whole mesh, as it was when the block was taken out
  Side now;          ///< of the whole mesh: where the side is in the end
};

template <class Geometry>
class Mesh_block {
public:
  using Mesh = Kernel_mesh<Geometry>;

  /// What the whole mesh will know at a vertex that other blocks may have, too; by its handles.
  struct Fan {
    Vertex_id vertex;
    Triangle_id triangle;
  };

  Mesh mesh;

  /// \param triangles those of the whole mesh that are taken out
  /// \param spare a mesh without triangles, whose memory is used
  Mesh_block(const Mesh& whole, Block_assignment& assignment, Block_id id, Span<Triangle_id> triangles,
             Mesh spare)
      : mesh(std::move(spare)), whole_(&whole), assignment_(&assignment), id_(id), taken_(triangles) {
    reserve();
    mesh.triangles.resize(taken_.size());
    if (!whole.region_of.empty()) mesh.region_of.resize(taken_.size());
    visit_with_foresight(
        mesh.triangles.ids(), [this](Triangle_id here) { prefetch_places(taken_[here.value()]); },
        [this](Triangle_id here) { take(taken_[here.value()], here); });
    own_vertices_ = whole_vertex_.size();
    settle_foreign_vertices();
    mark_shared_vertices();
  }

  Block_id id() const { return id_; }

  /// The handle in the block of a vertex of the whole mesh, none if it is not in the block. Only until the block is
  /// written.
  Vertex_id vertex_in_block(Vertex_id whole_vertex) const {
    const Triangle_id t = whole_->incident_triangle(whole_vertex);
    if (!t.is_valid() || assignment_->is_new(t)) return {};
    if ((*assignment_)[t].block == id_) return assignment_->vertex_in_block(whole_vertex);
    const auto i = std::lower_bound(foreign_.begin(), foreign_.end(), whole_vertex,
                                    [](const Foreign& f, Vertex_id v) { return f.whole < v; });
    return i != foreign_.end() && i->whole == whole_vertex ? i->here : Vertex_id();
  }

  /// Adds a vertex that the whole mesh has, but no triangle of it. \pre no new vertex has been added
  Vertex_id add_known_vertex(Vertex_id whole_vertex) {
    whole_vertex_.push_back(whole_vertex);
    const Vertex_id v = mesh.add_vertex(whole_->point(whole_vertex), whole_->role(whole_vertex));
    mesh.is_dirty.back() = whole_->is_dirty[whole_vertex];
    return v;
  }

  // ---- putting back

  /// How many triangles and vertices the whole mesh has to get for this block: what came and went does not count.
  std::size_t number_of_new_triangles() const {
    std::size_t number = 0;
    for (const Triangle_id t : new_triangles()) number += mesh.is_alive(t) ? 1 : 0;
    return number;
  }
  std::size_t number_of_new_vertices() const {
    std::size_t number = 0;
    for (const Vertex_id v : new_vertices()) number += is_to_be_named(v) ? 1 : 0;
    return number;
  }

  /// Gives these triangles the first new handles, which follow each other. So a part that holds only these of the block
  /// touches few pages of memory (Held_mesh.h).
  /// \param triangles some that are alive, each of them once, by handles of the block
  void name_first(std::vector<Triangle_id> triangles) { named_first_ = std::move(triangles); }

  /// The handles in the whole mesh: those taken out keep theirs, new ones get the next from these on, in their order.
  /// A triangle that is named first gives up its old handle to a new triangle.
  void name_new(Triangle_id first_triangle, Vertex_id first_vertex) {
    first_new_triangle_ = first_triangle;
    name_triangles();
    name_vertices(first_vertex);
    free_arrays(named_first_);
  }
  Triangle_id first_new_triangle() const { return first_new_triangle_; }
  /// None for what came and went.
  Triangle_id whole_triangle(Triangle_id t) const { return whole_triangle_[t]; }
  Vertex_id whole_vertex(Vertex_id v) const { return whole_vertex_[v]; }

  /// Writes what only this block has. \pre new things are named, and the whole mesh has room.
  void write(Mesh& whole) {
    write_triangles(whole);
    fans_.reserve(shared_.size());
    for (const Vertex_id v : shared_)
      fans_.push_back({whole_vertex(v), whole_triangle(mesh.incident_triangle(v))});
    for (const Vertex_id v : mesh.points.ids()) {
      const Vertex_id w = whole_vertex(v);
      if (is_shared(v) || !w.is_valid()) continue;
      whole.points[w] = mesh.point(v);
      whole.role_of[w] = mesh.role(v);
      whole.is_dirty[w] = mesh.is_dirty[v];
      whole.triangle_of[w] = mesh.is_used(v) ? whole_triangle(mesh.incident_triangle(v)) : Triangle_id();
    }
  }

  /// Frees all but what `write_shared()` and `seams()` need. \pre it is written
  /// \returns the mesh, emptied, whose memory another block may use
  Mesh release() {
    for (std::size_t v = 0; v < own_vertices_; ++v)
      assignment_->vertex_in_block(whole_vertex_[static_cast<Vertex_id>(v)]) = {};
    free_arrays(whole_triangle_, whole_vertex_, foreign_, is_shared_, shared_);
    mesh.clear();
    return std::exchange(mesh, Mesh());
  }

  /// Writes what other blocks may write too; for one block after the other.
  void write_shared(Mesh& whole) const {
    for (const Fan& f : fans_) whole.triangle_of[f.vertex] = f.triangle;
    for (const Triangle_id t : dead_) whole.kill(t);
  }

  /// With `now`, once it is written.
  const std::vector<Seam>& seams() const { return seams_; }
  /// What `write_shared()` writes.
  const std::vector<Fan>& fans() const { return fans_; }
  const std::vector<Triangle_id>& dead() const { return dead_; }

private:
  /// An occurrence of a vertex whose triangle in the whole mesh is in another block.
  struct Foreign {
    Vertex_id whole, here;
    Triangle_id triangle;
    int slot;
  };

  const Mesh* whole_;
  Block_assignment* assignment_;
  Block_id id_;
  Span<Triangle_id> taken_;      // the triangles taken out
  std::size_t own_vertices_ = 0; // the first of those taken out, which no other block assigns
  // handles in the whole mesh; of vertices that are not new, until new ones are named
  Indexed_vector<Triangle_id, Triangle_id> whole_triangle_;
  Indexed_vector<Vertex_id, Vertex_id> whole_vertex_;
  std::vector<Seam> seams_;
  std::vector<Foreign> foreign_;              // by handle in the whole mesh
  Indexed_vector<Vertex_id, char> is_shared_; // of the vertices taken out: other blocks may have them too
  std::vector<Vertex_id> shared_;
  std::vector<Fan> fans_; // of the shared ones
  std::vector<Triangle_id> dead_;
  std::vector<Triangle_id> named_first_;
  Triangle_id first_new_triangle_; // its handle in the whole mesh

  Id_range<Triangle_id> new_triangles() const { return {taken_.size(), mesh.triangles.size()}; }
  /// \pre they have no names yet
  Id_range<Vertex_id> new_vertices() const { return {whole_vertex_.size(), mesh.number_of_vertices()}; }

  /// Whether a new vertex gets a handle. Corners may know one on an edge after it is gone.
  bool is_to_be_named(Vertex_id v) const { return mesh.is_used(v) || !mesh.is_free(v); }

  void name_triangles() {
    whole_triangle_.resize(mesh.triangles.size());
    std::copy(taken_.begin(), taken_.end(), whole_triangle_.begin());
    Triangle_id next = first_new_triangle_;
    const Triangle_id end(next.value() + number_of_new_triangles());
    std::vector<Triangle_id> given_up;
    for (const Triangle_id t : named_first_) {
      if (next == end) break;
      if (whole_triangle_[t].is_valid()) given_up.push_back(whole_triangle_[t]);
      whole_triangle_[t] = next, ++next;
    }
    auto other = given_up.begin();
    for (const Triangle_id t : new_triangles()) {
      if (!mesh.is_alive(t) || whole_triangle_[t].is_valid()) continue;
      if (next < end)
        whole_triangle_[t] = next, ++next;
      else
        whole_triangle_[t] = *other, ++other;
    }
  }

  void name_vertices(Vertex_id next) {
    const Id_range<Vertex_id> vertices = new_vertices();
    whole_vertex_.resize(mesh.number_of_vertices());
    const auto name = [&](Vertex_id v) {
      if (!whole_vertex_[v].is_valid()) whole_vertex_[v] = next, ++next;
    };
    for (const Triangle_id t : named_first_)
      for (const Vertex_id v : mesh.triangle(t).v) name(v);
    for (const Vertex_id v : vertices)
      if (is_to_be_named(v)) name(v);
  }

  bool is_shared(Vertex_id v) const { return is_shared_.has(v) && is_shared_[v] != 0; }

  void reserve() {
    constexpr std::size_t growth = 3; // more is seldom needed
    mesh.triangles.reserve(growth * taken_.size());
    const std::size_t vertices = growth * taken_.size() / 2;
    mesh.points.reserve(vertices), mesh.role_of.reserve(vertices);
    mesh.triangle_of.reserve(vertices), mesh.is_dirty.reserve(vertices);
    whole_vertex_.reserve(vertices);
  }

  void prefetch_places(Triangle_id t) const {
    const auto& r = whole_->triangle(t);
    for (const Vertex_id v : r.v)
      prefetch(whole_->triangle_of.data() + v.value()), assignment_->prefetch_place(v);
    for (const Side o : r.side)
      if (!o.is_border()) assignment_->prefetch_place(o.triangle());
  }

  void take(Triangle_id t, Triangle_id here) {
    const auto& from = whole_->triangle(t);
    auto& to = mesh.triangle(here);
    mesh.set_region(here, whole_->region(t));
    for (int k = 0; k < 3; ++k) {
      to.v[k] = take_vertex(from.v[k], here, k);
      const Side o = from.side[k];
      if (o.is_border()) {
        to.side[k] = o;
        continue;
      }
      const Block_assignment::Place place = (*assignment_)[o.triangle()];
      if (place.block == id_) {
        to.side[k] = o.renamed(place.triangle);
      } else {
        to.side[k] = Side::seam(static_cast<std::int32_t>(seams_.size()));
        seams_.push_back({Side(t, k), o, Side::border()});
      }
    }
  }

  Vertex_id take_vertex(Vertex_id whole_vertex, Triangle_id here, int slot) {
    if ((*assignment_)[whole_->incident_triangle(whole_vertex)].block != id_) {
      foreign_.push_back({whole_vertex, {}, here, slot});
      return {};
    }
    Vertex_id& v = assignment_->vertex_in_block(whole_vertex);
    if (!v.is_valid()) {
      v = add_known_vertex(whole_vertex);
      mesh.triangle_of[v] = here;
    }
    return v;
  }

  void settle_foreign_vertices() {
    std::stable_sort(foreign_.begin(), foreign_.end(),
                     [](const Foreign& a, const Foreign& b) { return a.whole < b.whole; });
    for (std::size_t i = 0; i < foreign_.size(); ++i) {
      Foreign& f = foreign_[i];
      if (i > 0 && foreign_[i - 1].whole == f.whole) {
        f.here = foreign_[i - 1].here;
      } else {
        f.here = add_known_vertex(f.whole);
        mesh.triangle_of[f.here] = f.triangle;
      }
      mesh.triangle(f.triangle).v[f.slot] = f.here;
    }
  }

  /// Vertices at seams, and input vertices at the border, which may have fans in other blocks.
  void mark_shared_vertices() {
    is_shared_.assign(mesh.number_of_vertices(), 0);
    for (const auto& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        if (!t.side[k].is_border()) continue;
        for (const Vertex_id v : {t.v[next_slot[k]], t.v[previous_slot[k]]}) {
          if (is_shared(v) || !(t.side[k].is_seam() || mesh.is_input(v))) continue;
          is_shared_[v] = 1;
          shared_.push_back(v);
        }
      }
  }

  void write_triangles(Mesh& whole) {
    for (const Triangle_id t : mesh.triangles.ids()) {
      const Triangle_id w = whole_triangle(t);
      if (!mesh.is_alive(t)) {
        if (!w.is_valid()) continue;
        whole.triangle(w) = {}; // passes over all triangles read it, ahead of asking whether it is alive
        dead_.push_back(w);
        continue;
      }
      const auto& from = mesh.triangle(t);
      auto& to = whole.triangle(w);
      whole.set_region(w, mesh.region(t));
      for (int k = 0; k < 3; ++k) {
        to.v[k] = whole_vertex(from.v[k]);
        const Side o = from.side[k];
        to.side[k] = o.is_border() ? Side::border() : o.renamed(whole_triangle(o.triangle()));
        if (o.is_seam()) seams_[std::size_t(o.seam_number())].now = Side(w, k);
      }
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_MESH_BLOCK_H
