// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The squares of all parts down to level 29, by p4est.
//
// p4est's z-order counts y before x, and the shuffle order x before y. So x here is y there, and p4est's order is ours.
// p4est prints what is wrong inside of it and ends the program. Its numbers of local squares have 31 bits.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_P4EST_FOREST_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_P4EST_FOREST_H

#include <CGAL/Quadtree_mesh_2/internal/distributed/Coarse_square.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_options.h>

#include <p4est_bits.h>
#include <p4est_communication.h>
#include <p4est_extended.h>
#include <p4est_ghost.h>
#include <p4est_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

static_assert(P4EST_MAXLEVEL == coarse_depth && P4EST_QMAXLEVEL == last_coarse_level,
              "p4est has other levels");

inline p4est_quadrant_t p4est_square(const Coarse_square& s) {
  p4est_quadrant_t q;
  P4EST_QUADRANT_INIT(&q);
  q.x = static_cast<p4est_qcoord_t>(even_bits(s.code));
  q.y = static_cast<p4est_qcoord_t>(even_bits(s.code >> 1));
  q.level = static_cast<std::int8_t>(s.level);
  return q;
}
inline Coarse_square coarse_square(const p4est_quadrant_t& q) {
  return {interleave(static_cast<std::uint32_t>(q.y), static_cast<std::uint32_t>(q.x)), q.level};
}

/// The library's messages but for errors are not printed, unless the program has set it up otherwise.
inline void set_up_p4est() {
  if (sc_package_id < 0) sc_init(sc_MPI_COMM_NULL, 0, 0, nullptr, SC_LP_ERROR);
  if (p4est_package_id < 0) p4est_init(nullptr, SC_LP_ERROR);
}

/// The local squares that a part has to tell another about.
struct Mirrors {
  int part;
  std::vector<std::size_t> squares; ///< by increasing number
};

/// The squares, see the head of this file.
class P4est_forest {
public:
  /// \param leaves those of this part, in order; those of all parts are the leaves of one quadtree
  P4est_forest(MPI_Comm comm, const std::vector<Coarse_square>& leaves, const Numbers& leaves_of_parts) {
    set_up_p4est();
    std::vector<p4est_gloidx_t> first(1, 0);
    for (const std::int64_t n : leaves_of_parts) first.push_back(first.back() + n);
    const p4est_gloidx_t of_tree[] = {0, first.back()};
    connectivity_.reset(p4est_connectivity_new_unitsquare());
    std::unique_ptr<sc_array_t, void (*)(sc_array_t*)> squares(sc_array_new(sizeof(p4est_qcoord_t)),
                                                               sc_array_destroy);
    sc_array_resize(squares.get(), 3 * leaves.size());
    p4est_qcoord_t* next = reinterpret_cast<p4est_qcoord_t*>(squares->array);
    for (const Coarse_square& s : leaves) {
      const p4est_quadrant_t q = p4est_square(s);
      *next++ = q.x, *next++ = q.y, *next++ = q.level;
    }
    forest_.reset(
        p4est_inflate(comm, connectivity_.get(), first.data(), of_tree, squares.get(), nullptr, nullptr));
  }

  const p4est_t* get() const { return forest_.get(); }

  std::size_t size() const { return static_cast<std::size_t>(forest_->local_num_quadrants); }
  Coarse_square square(std::size_t i) const {
    p4est_tree_t* const tree = p4est_tree_array_index(forest_->trees, 0);
    return coarse_square(*p4est_quadrant_array_index(&tree->quadrants, i));
  }

  /// Splits squares, also new ones, while `must_split(Coarse_square)` wants it.
  template <class Must_split>
  void refine(Must_split must_split) {
    forest_->user_pointer = &must_split;
    const auto ask = [](p4est_t* forest, p4est_topidx_t, p4est_quadrant_t* q) -> int {
      return (*static_cast<Must_split*>(forest->user_pointer))(coarse_square(*q)) ? 1 : 0;
    };
    p4est_refine_ext(forest_.get(), 1, last_coarse_level, ask, nullptr, nullptr);
    forest_->user_pointer = nullptr;
  }

  void balance(Balance balance) {
    if (balance == Balance::NONE) return;
    p4est_balance_ext(forest_.get(), balance == Balance::SIDES ? P4EST_CONNECT_FACE : P4EST_CONNECT_FULL,
                      nullptr, nullptr);
  }

  /// Gives parts runs of squares of about the same weights, `weight(Coarse_square)`.
  template <class Weight>
  void partition(Weight weight) {
    forest_->user_pointer = &weight;
    const auto ask = [](p4est_t* forest, p4est_topidx_t, p4est_quadrant_t* q) -> int {
      const std::size_t most = static_cast<std::size_t>(std::numeric_limits<int>::max());
      return static_cast<int>(
          std::min(most, (*static_cast<Weight*>(forest->user_pointer))(coarse_square(*q))));
    };
    p4est_partition_ext(forest_.get(), 0, ask);
    forest_->user_pointer = nullptr;
  }

  /// The part that has a place.
  int owner(Coarse_code code) const {
    const p4est_quadrant_t q = p4est_square(Coarse_square::around(code, last_coarse_level));
    return p4est_comm_find_owner(forest_.get(), 0, &q, forest_->mpirank);
  }

  /// What this part has next to squares of others, by sides and corners.
  std::vector<Mirrors> mirrors() const {
    const std::unique_ptr<p4est_ghost_t, void (*)(p4est_ghost_t*)> ghost(
        p4est_ghost_new(forest_.get(), P4EST_CONNECT_FULL), p4est_ghost_destroy);
    std::vector<Mirrors> result;
    for (int part = 0; part < forest_->mpisize; ++part) {
      const p4est_locidx_t begin = ghost->mirror_proc_offsets[part],
                           end = ghost->mirror_proc_offsets[part + 1];
      if (begin == end) continue;
      result.push_back({part, {}});
      for (p4est_locidx_t i = begin; i < end; ++i) {
        const auto number = static_cast<std::size_t>(ghost->mirror_proc_mirrors[i]);
        const p4est_quadrant_t* const q = p4est_quadrant_array_index(&ghost->mirrors, number);
        result.back().squares.push_back(static_cast<std::size_t>(q->p.piggy3.local_num));
      }
    }
    return result;
  }

private:
  struct Destroy {
    void operator()(p4est_connectivity_t* connectivity) const { p4est_connectivity_destroy(connectivity); }
    void operator()(p4est_t* forest) const { p4est_destroy(forest); }
  };
  std::unique_ptr<p4est_connectivity_t, Destroy> connectivity_; // outlives the forest
  std::unique_ptr<p4est_t, Destroy> forest_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_P4EST_FOREST_H
