// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Who makes the first mesh and runs rounds of blocks in the place of the pipeline, which does both in its own memory
// otherwise (First_triangulation.h, Block_refinement.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_ROUNDS_RUNNER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_ROUNDS_RUNNER_H

#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_rounds.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Where a mesh is after rounds that somebody else has run, and what has been done to it.
enum class Rounds_end {
  NO_BLOCKS,  ///< nothing: it is too small for blocks
  WHOLE_MESH, ///< the rounds; it is in the state
  TAIL_DONE, ///< also what follows on them, but that flips have made bad triangles, which are on the worklist
  IN_PARTS   ///< everything; it is converted, and not here. The report has its counts and lists
};

/// What is known of the first triangulation once its mesh is that of the domain.
struct First_mesh {
  Edges_of_segments edges;
  /// Edges of segments that overlap others, for each segment but the one in `edges`.
  Input_edge_list repeated_edges;
  std::vector<Outer_triangle> outer; ///< the triangles outside along the border
  std::size_t merged_vertices = 0, vertices_on_segments = 0;
};

/// What follows on rounds of which nothing is left, for who can do it: sectors unlocked, vertices at seams removed,
/// exact flips, the conversion to the mesh of the user, and what the report says of it.
struct Rounds_tail {
  const Order& order; ///< the input vertex of each of the kernel
  Quality_mesh_report_2& report;
};

template <class Geometry>
class Rounds_runner {
public:
  using Kernel_points = decltype(Kernel_mesh<Geometry>::points);

  Rounds_runner() = default;
  Rounds_runner(const Rounds_runner&) = delete;
  Rounds_runner& operator=(const Rounds_runner&) = delete;
  virtual ~Rounds_runner() = default;

  /// The graph is not needed until `take_out_graph()`, except for its markers and seeds.
  virtual void stow_graph() = 0;
  /// \param order the input vertex of each of the kernel
  /// \param points of the kernel, at least those of the graph
  virtual void take_out_graph(const Order& order, const Kernel_points& points) = 0;

  /// What `First_triangulation` and `Domain_rule` do, with the same bits, for a graph with points and nothing else in a
  /// mesh, which is that of the domain then.
  /// \param vertex_blocks those in which one memory would make it
  /// \param made has the segments as its edges: in the end it has the edges
  /// \returns false if it was of no use; then segments end at the first of vertices at one place, and all else is as it
  /// was
  virtual bool make_first_mesh(Kernel_mesh<Geometry>& mesh, const Vertex_blocks& vertex_blocks,
                               const Domain_rule<Geometry>& rule, First_mesh& made) = 0;

  /// What `Block_refinement` does, with the same bits: mesh, corners, rounds, and what is left on the worklist.
  /// \param shall_go_on told the share of the work that is done; may be called by several threads at once
  /// \param tail null: not wanted
  virtual Rounds_end run(Meshing_state<Geometry>& state, const Finishing& finishing,
                         std::size_t vertex_budget, Block_rounds& rounds,
                         const std::function<bool(double)>& shall_go_on, const Rounds_tail* tail) = 0;
};

/// Sets who runs a mesher's rounds of blocks; null: the mesher itself.
struct Mesher_rounds {
  template <class Mesher, class Runner>
  static void run_by(Mesher& mesher, Runner* runner) {
    mesher.rounds_runner_ = runner;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_ROUNDS_RUNNER_H
