// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Makes the mesh constrained Delaunay, decided exactly, and accounts for its triangles on the way.
//
// Computes: the constrained Delaunay triangulation of the mesh's vertices, its histogram of angles, and the
//           triangles that may miss a bound. Cocircular vertices may be joined either way.
// Bound:    O(n) for n triangles, in parallel, and the flips, one after the other. They are few after
//           refinement. They end, because each lowers the surface lifted to the paraboloid.
// Source:   Lawson (1977): flips of sides that are not locally Delaunay.
// Method:   A side that is not Delaunay is seen under an obtuse angle from at least one of its triangles. So
//           each triangle is looked at once, and only its side opposite an angle that is not certainly acute
//           is tested in exact arithmetic. The same look puts the triangle into the account. Flips correct it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EXACT_LEGALIZER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EXACT_LEGALIZER_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Angle_histogram.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The triangles of a mesh by their angles, and those that miss a bound, excused or not, by their handles.
struct Triangle_account {
  Angle_histogram angles;
  std::vector<Triangle_id> suspects;
};

/// Allows every flip. Others that watch flips (`Exact_legalizer::flip_from()`) have the same functions.
struct Any_flips {
  /// Asked before the triangles on both sides of a side are read.
  bool may_look(Side) { return true; }
  /// Called before a side is flipped.
  void will_flip(Side) {}
  /// Asked of a triangle that a flip has made.
  template <class Shape>
  bool may_make(Triangle_id, const Shape&) {
    return true;
  }
};

template <class ConcurrencyTag, class Geometry>
class Exact_legalizer {
public:
  explicit Exact_legalizer(Meshing_state<Geometry>& state) : state_(state), mesh_(state.mesh) {}

  /// What a look at triangles finds.
  struct Findings {
    Triangle_account account;
    std::vector<Side> doubtful; ///< to be flipped
  };

  /// Makes the mesh constrained Delaunay. Triangles that flips make suspect go to the worklist.
  Triangle_account run() {
    Findings found = find([](Triangle_id) { return true; });
    Any_flips any;
    for (const Side s : found.doubtful) flip_from(s, found.account, any);
    drop_cured(found.account.suspects);
    return std::move(found.account);
  }

  /// Looks at the triangles alive of which `is_wanted(t)`; others are not read.
  template <class Is_wanted>
  Findings find(const Is_wanted& is_wanted) const {
    const std::size_t n = mesh_.triangles.size();
    std::vector<Findings> parts((n + default_block - 1) / default_block);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      mesh_.for_each_alive({begin, end}, is_wanted, [&](Triangle_id t) { look_at(t, parts[b]); });
    });
    Findings all;
    for (const Findings& part : parts) {
      all.account.angles.add(part.account.angles);
      append(all.account.suspects, part.account.suspects);
      append(all.doubtful, part.doubtful);
    }
    return all;
  }

  /// Flips a side, and what becomes doubtful by that. Triangles that this makes suspect go to the worklist.
  /// \param account becomes that of the mesh then, but with suspects that are cured, or named twice
  /// \param watch may stop this (Any_flips)
  /// \returns false if it was stopped, half done
  template <class Watch>
  bool flip_from(Side side, Triangle_account& account, Watch& watch) {
    doubtful_.assign(1, side);
    while (!doubtful_.empty()) {
      const Side s = doubtful_.back();
      doubtful_.pop_back();
      if (!watch.may_look(s)) return false;
      const Triangle_id t = s.triangle();
      const Side o = mesh_.across(s);
      if (o.is_constrained() || !is_not_Delaunay(s)) continue;
      watch.will_flip(s);
      for (const Triangle_id n : {t, o.triangle()}) account.angles.take(mesh_.shape(mesh_.triangle(n)));
      mesh_.flip(t, s.slot());
      const Shape shapes[] = {mesh_.shape(mesh_.triangle(t)), mesh_.shape(mesh_.triangle(o.triangle()))};
      for (const Shape& shape : shapes) account.angles.add(shape);
      for (const Triangle_id n : {t, o.triangle()}) {
        const Shape& shape = shapes[n == t ? 0 : 1];
        if (!watch.may_make(n, shape)) return false;
        for (const int k : {0, n == t ? 2 : 1}) doubtful_.push_back(Side(n, k));
        if (state_.misses_bound(n, shape)) account.suspects.push_back(n);
        if (state_.is_suspect(n, shape)) state_.push(n, shape);
      }
    }
    return true;
  }

  /// Drops suspects that miss no bound now, and those that are named before. The others are in order then.
  void drop_cured(std::vector<Triangle_id>& suspects) const {
    sort_and_drop_equal(suspects);
    suspects.erase(std::remove_if(suspects.begin(), suspects.end(),
                                  [this](Triangle_id t) { return !state_.misses_bound(t); }),
                   suspects.end());
  }

private:
  using Shape = typename Kernel_mesh<Geometry>::Shape;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  std::vector<Side> doubtful_;

  template <class Id>
  static void append(std::vector<Id>& all, const std::vector<Id>& some) {
    all.insert(all.end(), some.begin(), some.end());
  }

  void look_at(Triangle_id t, Findings& part) const {
    const auto& r = mesh_.triangle(t);
    const Shape s = mesh_.shape(r);
    part.account.angles.add(s);
    if (state_.misses_bound(t, s)) part.account.suspects.push_back(t);
    for (int k = 0; k < 3; ++k)
      if (!s.is_certainly_acute(k) && !r.side[k].is_constrained() && !is_settled(t, s, k) &&
          is_not_Delaunay(Side(t, k)))
        part.doubtful.push_back(Side(t, k));
  }

  /// Whether a side opposite an angle that may be right, as those on the diagonals of squares, need not be looked at:
  /// it is a diagonal of a rectangle, or opposite another such angle beyond, and one look is enough.
  bool is_settled(Triangle_id t, const Shape& s, int k) const {
    if (s.is_certainly_obtuse(k)) return false;
    const auto& r = mesh_.triangle(t);
    const Side o = r.side[k];
    return are_corners_of_rectangle(mesh_.point(r.v[0]), mesh_.point(r.v[1]), mesh_.point(r.v[2]),
                                    mesh_.point(mesh_.opposite(o))) ||
           (o.triangle() < t && !mesh_.shape(mesh_.triangle(o.triangle())).is_certainly_acute(o.slot()));
  }

  /// Whether the vertex opposite a free side lies in the circle of the side's triangle; exact.
  bool is_not_Delaunay(Side s) const {
    const auto& r = mesh_.triangle(s.triangle());
    return Geometry::is_in_circle(mesh_.point(r.v[0]), mesh_.point(r.v[1]), mesh_.point(r.v[2]),
                                  mesh_.point(mesh_.opposite(mesh_.across(s))));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EXACT_LEGALIZER_H
