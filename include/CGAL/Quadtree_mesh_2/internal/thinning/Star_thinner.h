// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Thins out a small mesh (of at most 1000 triangles), one star after the other.
//
// Thinner.h makes room everywhere at once and keeps the outcome only if the whole mesh is smaller: what one place gains
// another one loses. Here one Steiner vertex and its neighbors are removed with a bound of `star_share` of the given
// one. Triangles below the given bound that this makes are refined, and vertices around are removed under guard. If the
// mesh has fewer triangles then, the outcome is kept, else the mesh is as it was.
//
// Each vertex is tried again when something next to it has changed, until nothing helps. Each time that something does,
// the mesh has fewer triangles, so this ends. On small meshes 2 percent of the triangles go at 20.7 degrees, and 10 at
// 30. A trial is O(n) for n triangles, which are copied; nearly all of its time is that of the few that it changes.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_STAR_THINNER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_STAR_THINNER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Progress.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The share of the bound that removal keeps to.
constexpr double star_share = 0.4;

/// \pre refinement has come to rest, no sector is locked, and the rule of legs is `FREE`: no shells are made,
/// which would name vertices of a mesh that is gone
template <class Geometry>
class Star_thinner {
public:
  explicit Star_thinner(Meshing_state<Geometry>& state)
      : state_(state), mesh_(state.mesh), lowered_(state, state.bounds.with_share_of_angle(star_share)),
        guarded_(state) {}

  template <class Continue>
  void run(Continue&& shall_go_on) {
    make_Delaunay();
    state_.clear_worklist();
    std::fill(mesh_.is_dirty.begin(), mesh_.is_dirty.end(), char(0));
    keep();
    thin_everywhere(shall_go_on);
    state_.push_all_bad(); // refinement may have given up some, and the first flips may have made some
  }

private:
  static constexpr bool go_on() { return true; } // a trial is too short to be asked about

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Remover<Geometry> lowered_, guarded_;
  // the mesh before a trial
  Kernel_mesh<Geometry> mesh_before_;
  Indexed_vector<Vertex_id, char> is_done_; // tried in vain, with nothing changed around it since
  std::vector<Vertex_id> star_;             // a vertex and its neighbors

  template <class Continue>
  void thin_everywhere(Continue& shall_go_on) {
    constexpr std::size_t steps_of_trial = 64;
    std::size_t step = 0;
    for (bool is_any_thinner = true; is_any_thinner;) {
      is_any_thinner = false;
      for (const Vertex_id v : mesh_.points.ids()) { // those of now: new ones are for the next pass
        is_done_.make_room_for(v, 0);
        if (mesh_.is_input(v) || !mesh_.is_used(v) || is_done_[v] != 0) continue;
        if (is_time_to_ask(step += steps_of_trial) && !shall_go_on()) return;
        is_done_[v] = 1;
        is_any_thinner |= thin_at(v);
      }
    }
  }

  void keep() { mesh_before_ = mesh_; }

  void undo() {
    state_.clear_worklist();
    state_.doubtful_sides.clear();
    mesh_ = mesh_before_;
  }

  /// \returns whether the mesh has fewer triangles then; else it is as it was
  bool thin_at(Vertex_id v) {
    collect_star(v);
    if (!lowered_.remove(v)) return false;
    for (const Vertex_id w : star_) lowered_.remove(w);
    const bool is_thinner = refine_changed() && remove_changed();
    if (!is_thinner) {
      undo();
      return false;
    }
    for_each_changed([this](Triangle_id t) {
      for (const Vertex_id w : mesh_.triangle(t).v) is_done_.make_room_for(w, 0), is_done_[w] = 0;
    });
    keep();
    return true;
  }

  void collect_star(Vertex_id v) {
    star_.clear();
    mesh_.for_each_triangle_at(
        v, [this](Triangle_id t, int slot) { star_.push_back(mesh_.triangle(t).v[next_slot[slot]]); });
  }

  /// Whether what is changed meets the bounds in the end. No more triangles are made than there were.
  bool refine_changed() {
    const Mesh_limit limit{Mesh_limit::any, mesh_before_.number_of_triangles()};
    Splitter<Geometry> splitter(state_);
    Refiner<Geometry> refiner(state_, splitter);
    for_each_changed([this](Triangle_id t) { doubt_sides_of(t), state_.push_if_suspect(t); });
    state_.legalize();
    constexpr int most_rounds = 5;
    for (int round = 0; round < most_rounds; ++round) {
      if (refiner.run(limit, go_on) != Refinement_end::DONE) return false;
      state_.legalize(); // and what that makes bad is on the list again
      if (state_.worklist.is_empty()) return true;
    }
    return false;
  }

  /// Removes under guard what can be removed now. Whether the mesh then has fewer triangles than before, and what is
  /// changed meets the bounds: some triangles may not have been cured, or flips took apart what a corner excuses.
  bool remove_changed() {
    for_each_changed([this](Triangle_id t) {
      for (const Vertex_id v : mesh_.triangle(t).v) mesh_.is_dirty[v] = 1;
    });
    guarded_.run(go_on);
    if (mesh_.number_of_triangles() >= mesh_before_.number_of_triangles()) return false;
    legalize_changed();
    return !state_.has_bad_on_worklist() && !is_any_changed_bad();
  }

  void make_Delaunay() {
    for (const Triangle_id t : mesh_.triangles.ids())
      if (mesh_.is_alive(t)) doubt_sides_of(t);
    state_.legalize();
  }

  void legalize_changed() {
    for_each_changed([this](Triangle_id t) { doubt_sides_of(t); });
    state_.legalize();
  }

  void doubt_sides_of(Triangle_id t) {
    for (int k = 0; k < 3; ++k)
      if (!mesh_.triangle(t).side[k].is_constrained()) state_.doubtful_sides.push_back(Side(t, k));
  }

  template <class Function>
  void for_each_changed(const Function& f) const {
    constexpr std::size_t run = 16; // of triangles, compared as bytes: hardly any has changed
    const std::size_t end = mesh_.triangles.size(), end_before = mesh_before_.triangles.size();
    for (std::size_t first = 0; first < end; first += run) {
      if (first + run <= std::min(end, end_before) && is_as_before(first, run)) continue;
      for (const Triangle_id t : Id_range<Triangle_id>(first, std::min(first + run, end)))
        if (mesh_.is_alive(t) && is_changed(t)) f(t);
    }
  }

  bool is_as_before(std::size_t first, std::size_t number) const {
    const auto *now = mesh_.triangles.data() + first, *before = mesh_before_.triangles.data() + first;
    return std::memcmp(static_cast<const void*>(now), before, number * sizeof *now) == 0;
  }

  bool is_changed(Triangle_id t) const {
    if (!(t < mesh_before_.triangles.end_id())) return true;
    const auto &now = mesh_.triangle(t).v, &before = mesh_before_.triangle(t).v;
    return now[0] != before[0] || now[1] != before[1] || now[2] != before[2];
  }

  bool is_any_changed_bad() const {
    bool is_any = false;
    for_each_changed([&](Triangle_id t) { is_any |= state_.is_bad(t); });
    return is_any;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_STAR_THINNER_H
