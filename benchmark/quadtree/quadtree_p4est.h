// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// p4est, if CMake found it; its methods are none otherwise.

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_P4EST_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_P4EST_H

#include "quadtree_run.h"

#include <vector>

#ifdef QUADTREE_BENCHMARK_WITH_P4EST

#include "quadtree_floors.h"

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <p4est_bits.h>
#include <p4est_extended.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace quadtree_p4est {

/// Starts MPI and silences p4est; a process does so once. Without the settings MPI would look for networks
/// and start a daemon, which takes a third of a second.
inline void begin_process() {
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_pml", "ob1", 0);
  setenv("OMPI_MCA_btl", "self", 0);
  if (sc_MPI_Init(nullptr, nullptr) != sc_MPI_SUCCESS) throw std::runtime_error("MPI does not start");
  sc_init(sc_MPI_COMM_SELF, 0, 0, nullptr, SC_LP_SILENT);
  p4est_init(nullptr, SC_LP_SILENT);
}

using quadtree_floors::Key_64;

/// Decides on splitting, by points in shuffle order. The quadrants come in the same order, each before its
/// children, so that one pass over the points serves all.
class Splitter {
public:
  explicit Splitter(const std::vector<Key_64>& keys) : keys_(keys) {}

  static int split(p4est_t* forest, p4est_topidx_t, p4est_quadrant_t* quadrant) {
    return static_cast<Splitter*>(forest->user_pointer)->has_several_points(*quadrant) ? 1 : 0;
  }

private:
  bool has_several_points(const p4est_quadrant_t& quadrant) {
    const std::uint64_t begin =
        CGAL::Quadtree_mesh_2::internal::interleave(std::uint32_t(quadrant.y), std::uint32_t(quadrant.x));
    const std::uint64_t size = std::uint64_t(1) << 2 * (P4EST_MAXLEVEL - quadrant.level);
    if (begin < last_begin_) throw std::logic_error("p4est does not go through quadrants in order");
    last_begin_ = begin;
    while (next_ < keys_.size() && keys_[next_] < begin) ++next_;
    return next_ + 1 < keys_.size() && keys_[next_ + 1] - begin < size;
  }

  const std::vector<Key_64>& keys_;
  std::size_t next_ = 0; ///< the first point that is not before the quadrant
  std::uint64_t last_begin_ = 0;
};

/// The shuffles of the points in the grid of our trees, so that squares are the same; p4est counts y before
/// x.
inline std::vector<Key_64> keys_of(const Points& points) {
  using Traits = quadtree_floors::Traits;
  const Traits::Grid_2 grid = Traits().construct_grid_2_object()(points);
  std::vector<Key_64> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Traits::Grid_point p = grid.grid_point(points[i]);
    keys[i] = quadtree_floors::short_key<P4EST_MAXLEVEL>({p.y, p.x});
  }
  return keys;
}

/// Quadrants of the last level that hold several points.
inline std::size_t crowded_leaves(const std::vector<Key_64>& keys) {
  const auto leaf = [&keys](std::size_t i) { return keys[i] >> 2 * (P4EST_MAXLEVEL - P4EST_QMAXLEVEL); };
  std::size_t crowded = 0;
  for (std::size_t i = 1; i < keys.size(); ++i)
    crowded += leaf(i) == leaf(i - 1) && (i == 1 || leaf(i) != leaf(i - 2)) ? 1 : 0;
  return crowded;
}

inline int depth_of(const p4est_t* forest) { return p4est_tree_array_index(forest->trees, 0)->maxlevel; }

/// From points to sorted keys to a tree to a balanced tree; without the points' indices.
inline Run run(const Points& points, p4est_connect_type_t balance) {
  begin_process();
  Run_recorder recorder;
  std::vector<Key_64> keys = keys_of(points);
  quadtree_floors::sort(keys);
  recorder.stop();

  recorder.start();
  p4est_connectivity_t* const square = p4est_connectivity_new_unitsquare();
  Splitter splitter(keys);
  p4est_t* const forest = p4est_new(sc_MPI_COMM_SELF, square, 0, nullptr, &splitter);
  p4est_refine_ext(forest, 1, P4EST_QMAXLEVEL, Splitter::split, nullptr, nullptr);
  recorder.stop();
  recorder.set_size(std::size_t(forest->local_num_quadrants));
  recorder.set_crowded_leaves(crowded_leaves(keys));

  recorder.start();
  p4est_balance_ext(forest, balance, nullptr, nullptr);
  recorder.stop();
  recorder.set_size(std::size_t(forest->local_num_quadrants));
  recorder.set_depth(depth_of(forest));
  p4est_destroy(forest);
  p4est_connectivity_destroy(square);
  return recorder.run();
}

inline std::vector<Method> methods() {
  return {{"p4est",
           {{"sort", Product::NOTHING}, {"refine", Product::UNBALANCED}, {"balance", Product::CORNERS}},
           [](const Points& points) { return run(points, P4EST_CONNECT_FULL); }},
          {"p4est by sides",
           {{"sort", Product::NOTHING}, {"refine", Product::NOTHING}, {"balance", Product::SIDES}},
           [](const Points& points) { return run(points, P4EST_CONNECT_FACE); }}};
}

} // namespace quadtree_p4est

#else

namespace quadtree_p4est {

inline std::vector<Method> methods() { return {}; }

} // namespace quadtree_p4est

#endif // QUADTREE_BENCHMARK_WITH_P4EST

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_P4EST_H
