// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Makes one vertex of two neighbors, where there is a place for it at which its whole star meets the bounds.
//
// Computes: a mesh with fewer triangles. Guarded removal (Remover.h) needs a vertex that can go while all others
//           stay. Here its neighbor moves into the middle of both stars. A free vertex goes to a free neighbor, or to
//           one on an edge, which stays on the edge. Two vertices of an edge become one of the edge.
// Method:   the two stars are joined on paper, and relocation (Relocator.h) looks for a place in what they make.
//           Nothing is changed until a place is found, so there is nothing to undo.
// Gain:     where removal found nothing more, 9 percent of the triangles of a mesh that grows by powers of ten.
// Bound:    O(degree) for a pair. A pair is tried again after a merger next to it. Each merger takes a vertex, so
//           this ends.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_PAIR_MERGER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_PAIR_MERGER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Progress.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Relocator.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Star.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \pre as of `Star_thinner`
template <class Geometry>
class Pair_merger {
public:
  explicit Pair_merger(Meshing_state<Geometry>& state)
      : state_(state), mesh_(state.mesh), relocator_(state) {}

  /// Merges pairs until none can be merged, or `shall_go_on()`, which is asked now and then, says no.
  /// \returns the number of vertices that are gone
  template <class Continue>
  std::size_t run(Continue&& shall_go_on) {
    constexpr std::size_t steps_of_vertex = 8;
    is_done_.assign(mesh_.points.size(), 0);
    std::size_t merged = 0, step = 0;
    for (bool is_any = true; is_any;) {
      is_any = false;
      for (const Vertex_id v : mesh_.points.ids()) {
        if (mesh_.is_input(v) || !mesh_.is_used(v) || is_done_[v] != 0) continue;
        if (is_time_to_ask(step += steps_of_vertex) && !shall_go_on()) return merged;
        is_done_[v] = 1;
        if (!merge_with_a_neighbor(v)) continue;
        is_any = true, ++merged;
      }
    }
    return merged;
  }

private:
  static constexpr int largest_star = 12; // a vertex hardly has a place within two that are larger

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Relocator<Geometry> relocator_;
  Indexed_vector<Vertex_id, char> is_done_; // tried in vain, with nothing merged next to it since
  Star of_v_, of_u_, joined_;
  int u_in_link_ = 0, v_in_link_ = 0; // of the other star

  bool merge_with_a_neighbor(Vertex_id v) {
    if (!of_v_.collect(mesh_, v, largest_star) || (mesh_.is_free(v) && !of_v_.is_closed)) return false;
    for (u_in_link_ = 0; u_in_link_ < of_v_.number_of_link_vertices(); ++u_in_link_) {
      const Vertex_id u = of_v_.link[u_in_link_];
      if (!may_take_in(u, v) || !join_stars(u, v) || !find_place(u, v)) continue;
      replace(u, v);
      mesh_.for_each_triangle_at(u, [this](Triangle_id t, int) {
        for (const Vertex_id w : mesh_.triangle(t).v) is_done_[w] = 0;
      });
      return true;
    }
    return false;
  }

  /// Whether u may stand for its neighbor v, and that has not been tried from u.
  bool may_take_in(Vertex_id u, Vertex_id v) const {
    if (mesh_.is_input(u)) return false;
    if (!mesh_.is_free(v)) return mesh_.edge(u) == mesh_.edge(v) && is_constrained_spoke(u_in_link_);
    return !mesh_.is_free(u) || v < u || is_done_[u] == 0;
  }

  /// Whether the side from v to a link vertex is on an edge.
  bool is_constrained_spoke(int i) const {
    if (i == of_v_.size) return true; // the end of an open star
    const Side c = of_v_.corner[i];
    return mesh_.triangle(c.triangle()).side[previous_slot[c.slot()]].is_constrained();
  }

  /// Makes the star that u has when v is gone: the link of v takes the place of v in that of u.
  /// \returns false if there is none that is worth a trial
  bool join_stars(Vertex_id u, Vertex_id v) {
    if (!of_u_.collect(mesh_, u, largest_star) || (mesh_.is_free(u) && !of_u_.is_closed)) return false;
    const Vertex_id* const place = std::find(of_u_.link, of_u_.link + of_u_.number_of_link_vertices(), v);
    v_in_link_ = static_cast<int>(place - of_u_.link);
    const int n = of_u_.size, j = v_in_link_;
    joined_.size = 0, joined_.is_closed = of_u_.is_closed;
    if (of_u_.is_closed) {
      append(of_u_, j + 1, n - 2), append(of_v_, u_in_link_ + 1, of_v_.size - 2);
      joined_.link[joined_.size] = joined_.link[0];
    } else if (!of_v_.is_closed) {
      if (n < 2 || of_v_.size < 2) return false; // the triangle at both is all there is of one
      join_at_border();
    } else {
      if (j < 2 || j > n - 2) return false; // next to the border
      append(of_u_, 0, j - 1), append(of_v_, u_in_link_ + 1, of_v_.size - 2), append(of_u_, j + 1, n - j - 1);
      joined_.link[joined_.size] = of_u_.link[n];
    }
    return joined_.size >= (joined_.is_closed ? 3 : 2) && !has_link_vertex_twice();
  }

  /// Both stars are open, and the border goes on from one vertex to the other.
  void join_at_border() {
    const Star &first = is_u_first() ? of_u_ : of_v_, &second = is_u_first() ? of_v_ : of_u_;
    append(first, 0, first.size - 1), append(second, 1, second.size - 1);
    joined_.link[joined_.size] = second.link[second.size];
  }
  /// Whether the fan of u comes before that of v counterclockwise, where both are at the border.
  bool is_u_first() const { return u_in_link_ == 0; }

  /// Appends triangles of a star, from one on.
  void append(const Star& star, int first, int number) {
    for (int i = first; i < first + number; ++i) {
      const int k = i < star.size ? i : i - star.size;
      joined_.link[joined_.size] = star.link[k], joined_.corner[joined_.size++] = star.corner[k];
    }
  }

  /// So it is where u and v have more than two neighbors in common.
  bool has_link_vertex_twice() const {
    const Vertex_id* const end = joined_.link + joined_.number_of_link_vertices();
    for (const Vertex_id* w = joined_.link; w != end; ++w)
      if (std::find(w + 1, end, *w) != end) return true;
    return false;
  }

  /// Moves u to the place of the new vertex, if there is one; the search begins in the middle of a free pair.
  bool find_place(Vertex_id u, Vertex_id v) {
    const auto old = mesh_.point(u);
    if (mesh_.is_free(u))
      mesh_.points[u] = Geometry::translate(old, 0.5 * Geometry::scaled_difference(mesh_.point(v), old));
    if (relocator_.relocate_in(joined_, u)) return true;
    mesh_.points[u] = old;
    return false;
  }

  /// Gives u the joined star, and restores the Delaunay property around it.
  void replace(Vertex_id u, Vertex_id v) {
    for (int i = 0; i < of_v_.size; ++i)
      mesh_.triangle(of_v_.corner[i].triangle()).v[of_v_.corner[i].slot()] = u;
    if (!of_v_.is_closed) {
      const Star &first = is_u_first() ? of_u_ : of_v_, &second = is_u_first() ? of_v_ : of_u_;
      close_gap(first.corner[first.size - 2], second.corner[0], second.corner[1]);
    } else {
      close_gap(corner(of_u_, v_in_link_ - 2), corner(of_u_, v_in_link_ - 1), corner(of_v_, u_in_link_ + 1));
      close_gap(corner(of_v_, u_in_link_ - 2), corner(of_u_, v_in_link_), corner(of_u_, v_in_link_ + 1));
    }
    mesh_.triangle_of[v] = {};
    mesh_.triangle_of[u] = joined_.corner[0].triangle();
    for (int i = 0; i < joined_.size; ++i) {
      const Side c = joined_.corner[i];
      mesh_.triangle_of[joined_.link[i]] = mesh_.triangle_of[joined_.link[i + 1]] = c.triangle();
      state_.doubtful_sides.push_back(c),
          state_.doubtful_sides.push_back(Side(c.triangle(), next_slot[c.slot()]));
    }
    for (int i = 0; i < joined_.number_of_link_vertices(); ++i) mesh_.is_dirty[joined_.link[i]] = 1;
    mesh_.is_dirty[u] = 1;
    state_.legalize();
  }

  /// Triangle i of a star, counted around it.
  static Side corner(const Star& star, int i) { return star.corner[(i + star.size) % star.size]; }

  /// Links the triangles at u to the right and left of one that is gone. One of their sides may be on an edge.
  void close_gap(Side right, Side gone, Side left) {
    const Side r(right.triangle(), next_slot[right.slot()]), l(left.triangle(), previous_slot[left.slot()]);
    const bool is_constrained = mesh_.across(r).is_constrained() || mesh_.across(l).is_constrained();
    mesh_.link(r.triangle(), r.slot(), Side(l.triangle(), l.slot(), is_constrained));
    mesh_.kill(gone.triangle());
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_PAIR_MERGER_H
