// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A few rings of vertices around a place that changes, and a way to undo the change.
//
// Everything that may fail works on a patch. Its members may move, and edges between them may be flipped.
// Whatever is written is saved first, so that undo() restores every bit. Only members of the patch's block
// are used. A vertex belongs to a block if all its neighbors are of that block, too, or of no block
// (Ring_blocks.h). So patches of different blocks may be processed at the same time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_PATCH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_PATCH_H

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// By vertex: the last operation of which the vertex was a member, in which its star is to be looked at (`active`),
/// in which its star changed, and in which it was saved. Operations of a block are numbered from 1.
struct Patch_marks {
  std::uint32_t member = 0, active = 0, changed = 0, saved = 0;
};

template <class Geometry>
class Ring_patch {
public:
  using Mesh = Ring_mesh<Geometry>;
  using Point = typename Geometry::Point;
  using Marks = Indexed_vector<Ring_vertex, Patch_marks>;

  Ring_patch(Mesh& mesh, Marks& marks, std::int32_t block) : mesh_(mesh), marks_(marks), block_(block) {}

  Mesh& mesh() { return mesh_; }
  const Mesh& mesh() const { return mesh_; }
  const std::vector<Ring_vertex>& members() const { return members_; }
  /// Whether vertices were left out because they belong to others.
  bool is_cut() const { return is_cut_; }
  std::int32_t block() const { return block_; }

  /// Begins an operation, with no members.
  void begin() {
    ++operation_;
    members_.clear();
    saved_.clear();
    is_cut_ = false;
  }

  bool is_ours(Ring_vertex v) const { return mesh_.ring(v).block == block_; }
  bool is_member(Ring_vertex v) const { return mark(v).member == operation_; }
  bool is_active(Ring_vertex v) const { return mark(v).active == operation_; }
  bool is_changed(Ring_vertex v) const { return mark(v).changed == operation_; }

  void add(Ring_vertex v) {
    if (!is_ours(v)) {
      is_cut_ = true;
      return;
    }
    if (is_member(v)) return;
    mark(v).member = operation_;
    members_.push_back(v);
  }

  /// Takes a member out of the patch again.
  void drop(Ring_vertex v) {
    if (!is_member(v)) return;
    mark(v).member = 0;
    members_.erase(std::find(members_.begin(), members_.end(), v));
  }

  /// Adds the neighbors of the members, and theirs, in all `rings` times.
  void grow(int rings) {
    std::size_t begin = 0;
    for (; rings > 0; --rings) {
      const std::size_t end = members_.size();
      for (; begin < end; ++begin) {
        const Ring& r = mesh_.ring(members_[begin]);
        for (int k = 0; k < r.size; ++k) add(r[k]);
      }
    }
  }

  /// The star of a member is to be looked at.
  void activate(Ring_vertex v) {
    Patch_marks& m = mark(v);
    if (m.member != operation_) return;
    m.active = m.changed = operation_;
  }
  void settle(Ring_vertex v) { mark(v).active = 0; }

  void move(Ring_vertex v, const Point& p) {
    save(v);
    mesh_.points[v] = p;
    activate(v);
    const Ring& r = mesh_.ring(v);
    for (int k = 0; k < r.size; ++k) activate(r[k]);
  }

  /// The ring of a vertex, to be changed. \pre is_ours(v)
  Ring& ring_to_change(Ring_vertex v) {
    save(v);
    activate(v);
    return mesh_.ring(v);
  }

  /// Takes v, which is no member, out of the mesh and puts in the given diagonals of its ring, pairs of positions.
  template <class Diagonals>
  void remove(Ring_vertex v, const Diagonals& diagonals) {
    save(v);
    const Ring hole = mesh_.ring(v);
    for (int i = 0; i < hole.size; ++i) replace_center(hole, i, v, diagonals);
    mesh_.ring(v).mobility = Mobility::REMOVED;
    mesh_.ring(v).size = 0;
  }

  /// Puts the edge c, d in the place of a, b, which has c on its left and d on its right.
  void flip(Ring_vertex a, Ring_vertex b, Ring_vertex c, Ring_vertex d) {
    Ring &ra = ring_to_change(a), &rb = ring_to_change(b), &rc = ring_to_change(c), &rd = ring_to_change(d);
    ra.erase(ra.position_of(b));
    rb.erase(rb.position_of(a));
    rc.insert(rc.position_of(a) + 1, d); // around c: a, then b
    rd.insert(rd.position_of(b) + 1, c); // around d: b, then a
  }

  /// Puts vertex `m`, which is not in use, on the edge a, b with c on its left and d on its right. There is no d if the
  /// edge is on the border.
  void split_edge(Ring_vertex m, const Point& p, Ring_vertex a, Ring_vertex b, Ring_vertex c, Ring_vertex d) {
    Ring &ra = ring_to_change(a), &rb = ring_to_change(b), &rc = ring_to_change(c);
    ra.neighbor[std::size_t(ra.position_of(b))] = m;
    rb.neighbor[std::size_t(rb.position_of(a))] = m;
    rc.insert(rc.position_of(a) + 1, m);
    Ring fresh;
    for (const Ring_vertex v : {b, c, a}) fresh.insert(fresh.size, v);
    fresh.is_open = !d.is_valid();
    if (d.is_valid()) {
      Ring& rd = ring_to_change(d);
      rd.insert(rd.position_of(b) + 1, m);
      fresh.insert(3, d);
    }
    put_in(m, p, fresh);
  }

  /// Puts vertex `m`, which is not in use, into the triangle a, b, c.
  void split_triangle(Ring_vertex m, const Point& p, Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    const std::array<Ring_vertex, 3> t{a, b, c};
    Ring fresh;
    for (std::size_t i = 0; i < 3; ++i) {
      Ring& r = ring_to_change(t[i]);
      r.insert(r.position_of(t[(i + 1) % 3]) + 1, m);
      fresh.insert(fresh.size, t[i]);
    }
    put_in(m, p, fresh);
  }

  /// Puts everything back to what it was when the operation began.
  void undo() {
    for (std::size_t i = saved_.size(); i-- > 0;) {
      mesh_.ring(saved_[i].vertex) = saved_[i].ring;
      mesh_.points[saved_[i].vertex] = saved_[i].point;
    }
  }

private:
  struct Saved {
    Ring ring;
    Ring_vertex vertex;
    Point point;
  };

  Mesh& mesh_;
  Marks& marks_;
  std::int32_t block_;
  std::uint32_t operation_ = 0;
  bool is_cut_ = false;
  std::vector<Ring_vertex> members_;
  std::vector<Saved> saved_;

  Patch_marks& mark(Ring_vertex v) { return marks_[v]; }
  const Patch_marks& mark(Ring_vertex v) const { return marks_[v]; }

  void save(Ring_vertex v) {
    if (mark(v).saved == operation_) return;
    mark(v).saved = operation_;
    saved_.push_back({mesh_.ring(v), v, mesh_.points[v]});
  }

  void put_in(Ring_vertex m, const Point& p, Ring& fresh) {
    save(m);
    fresh.block = block_;
    mesh_.ring(m) = fresh;
    mesh_.points[m] = p;
    add(m);
    activate(m);
  }

  /// In the ring of member i of a hole, the removed vertex gives way to the other ends of the diagonals at i. Around a
  /// member these follow each other as they do around the hole, from the one after i on.
  template <class Diagonals>
  void replace_center(const Ring& hole, int i, Ring_vertex center, const Diagonals& diagonals) {
    std::array<Ring_vertex, Ring::max_size> ends;
    int n = 0;
    for (int step = 1; step < hole.size; ++step) {
      const int j = (i + step) % hole.size;
      for (const auto& [a, b] : diagonals)
        if ((a == i && b == j) || (a == j && b == i)) ends[std::size_t(n++)] = hole[j];
    }
    Ring& r = ring_to_change(hole[i]);
    const int place = r.position_of(center);
    r.erase(place);
    for (int e = 0; e < n; ++e) r.insert(place + e, ends[std::size_t(e)]);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_PATCH_H
