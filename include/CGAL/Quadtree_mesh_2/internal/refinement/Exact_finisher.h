// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The end of all work on a mesh: it becomes exactly constrained Delaunay or, on request, Delaunay along constrained
// edges, too. What that leaves below the bounds is refined again.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EXACT_FINISHER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EXACT_FINISHER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Conformer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Exact_finisher {
public:
  /// \param refine has a refiner work off what is on the list, within a budget
  /// \param is_stopped whether the user or a budget ends the work
  Exact_finisher(Meshing_state<Geometry>& state, std::function<void(Refiner<Geometry>&)> refine,
                 std::function<bool()> is_stopped)
      : state_(state), refine_(std::move(refine)), is_stopped_(std::move(is_stopped)) {}

  /// Makes the mesh exactly constrained Delaunay. Such flips never lower the least angle of a pair; should
  /// one take apart an exempt triangle all the same, what it leaves is refined again.
  Triangle_account run(Refiner<Geometry>& refiner) {
    constexpr int most_rounds = 5;
    Exact_legalizer<ConcurrencyTag, Geometry> legalizer(state_);
    for (int round = 0; round < most_rounds; ++round) {
      Triangle_account account = legalizer.run();
      if (!state_.has_bad_on_worklist() || is_stopped_()) return account;
      refine_(refiner);
    }
    return legalizer.run();
  }

  /// The same, and splits constrained edges until they are Delaunay, too.
  /// \param most_vertices at which no edge is split any more
  /// \param encroached_edges becomes the number of those left
  Triangle_account run_conforming(std::size_t most_vertices, std::size_t& encroached_edges) {
    state_.encroachment = Encroachment::CIRCLES;
    Splitter<Geometry> splitter(state_);
    Refiner<Geometry> refiner(state_, splitter);
    Conformer<ConcurrencyTag, Geometry> conformer(state_, splitter);
    state_.most_vertices = most_vertices;
    Triangle_account account = run(refiner);
    while (!is_stopped_() && conformer.split_encroached(most_vertices)) {
      refine_(refiner);
      account = run(refiner);
    }
    encroached_edges = conformer.number_of_encroached();
    return account;
  }

private:
  Meshing_state<Geometry>& state_;
  std::function<void(Refiner<Geometry>&)> refine_;
  std::function<bool()> is_stopped_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EXACT_FINISHER_H
