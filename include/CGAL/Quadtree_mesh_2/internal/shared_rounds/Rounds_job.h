// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What parts have to know to take part in rounds of blocks, besides the mesh: the problem, and how it is worked on.
//
// Bounds have functions of the user, and so follow from the options, which are the same at all parts, and from the
// frame of the input. O(n) memory for a graph of n vertices and segments.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_JOB_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_JOB_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Bounds_maker.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_problem.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/state_bytes.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Of a graph, what its coordinates are mapped by and what bounds there are: two opposite corners of its box, and its
/// regions.
template <class Point>
class Graph_frame {
public:
  Graph_frame() = default;
  /// \pre there is a vertex
  explicit Graph_frame(const Pslg_2<Point>& pslg) {
    using Coordinate = typename Sent_coordinates<Point>::value_type;
    const auto box = Coordinate_ranges<Coordinate>::of(pslg.vertices);
    corners_ = {{box.low_x, box.low_y}, {box.high_x, box.high_y}};
    for (const auto& r : pslg.regions)
      regions_.push_back({coordinates_to_send(r.point), r.attribute, r.max_area});
  }

  /// A graph with the same box and the same regions.
  Pslg_2<Point> graph() const {
    Pslg_2<Point> graph;
    for (const auto& p : corners_) graph.vertices.push_back(Point{p[0], p[1]});
    for (const Region& r : regions_)
      graph.regions.push_back({Point{r.place[0], r.place[1]}, r.attribute, r.max_area});
    return graph;
  }

  template <class Archive>
  void transfer(Archive& archive) {
    archive(corners_, regions_);
  }

private:
  struct Region {
    Sent_coordinates<Point> place;
    double attribute, max_area;
  };

  std::vector<Sent_coordinates<Point>> corners_;
  std::vector<Region> regions_;
};

/// What is the same at all parts while they run rounds.
template <class Geometry>
struct Rounds_job {
  Meshing_state<Geometry>& state; ///< of which the mesh is not part of the job
  Finishing finishing = {};
  std::size_t vertex_budget = 0;
  bool is_tail_wanted = false; ///< `Rounds_tail`
  /// Whether all parts have the points of the input already, in the problem.
  bool are_points_known = false;

  template <class Archive>
  void transfer(Archive& archive) {
    archive(are_points_known);
    if (!are_points_known) transfer_input_points(archive);
    archive(state.problem.vertex_blocks, state.problem, finishing, vertex_budget, is_tail_wanted);
    archive(state.leg_rule, state.refinement_rule, state.bulk, state.has_placed_vertices);
  }

private:
  template <class Archive>
  void transfer_input_points(Archive& archive) {
    auto& problem = state.problem;
    std::uint64_t number = problem.number_of_input_points();
    archive(number);
    const std::size_t bytes = static_cast<std::size_t>(number) * sizeof(typename Geometry::Point);
    if constexpr (Archive::is_reading) {
      problem.input_points.resize(static_cast<std::size_t>(number));
      archive.transfer_bytes(problem.input_points.data(), bytes);
    } else {
      archive.transfer_bytes(problem.input_places().begin(), bytes);
    }
  }
};

/// The bounds of a graph with a frame; map and options have to outlive them.
template <class Traits>
auto bounds_in_frame(const Graph_frame<typename Traits::Point_2>& frame,
                     const Quality_mesh_options_2& options,
                     const Coordinate_map<Traits, typename Traits::Meshing_geometry_2>& map) {
  return Bounds_maker<Traits>(options, map).run(frame.graph());
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_JOB_H
