// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Other meshers of points as the benchmark sees them: they refine the Delaunay triangulation of the points and a box
// around them, the same that our mode "points" fills.

#ifndef QUADTREE_MESH_2_BENCHMARK_POINTS_PEERS_H
#define QUADTREE_MESH_2_BENCHMARK_POINTS_PEERS_H

#include "points_run.h"
#include "pslg_mesh_2.h"
#include "pslg_triangle.h"

#include <optional>
#include <string>
#include <utility>

namespace points_peers {

/// A mesher of graphs with a bound on angles, in degrees, that meshes the box.
inline Points_method method(const std::string& name, Pslg_method mesher, double min_angle,
                            const std::string& rival) {
  const auto phases = mesher.phases;
  return {name, 0, phases, rival,
          [mesher = std::move(mesher), min_angle](const Points_task& task, Check check) {
            std::optional<Points_run> result;
            if (const auto run = mesher.run({task.box, 0, min_angle, task.limit_seconds}, check))
              result = Points_run{*run, 0, 0, 0};
            return result;
          }};
}

/// CGAL's Mesh_2 at the angle for which it is proven to end.
inline Points_method mesh_2() { return method("Mesh_2, 20.7", pslg_mesh_2::method(), 20.7, "points"); }

/// Shewchuk's Triangle at the same angle.
inline Points_method triangle(const std::string& program) {
  return method("Triangle, 20.7", pslg_triangle::method(program), 20.7, "points");
}

/// The same where it ends mostly, for want of another mesher that comes near to our bounds of angles.
inline Points_method triangle_at_33(const std::string& program) {
  return method("Triangle, 33", pslg_triangle::method(program), 33, "bounded");
}

} // namespace points_peers

#endif // QUADTREE_MESH_2_BENCHMARK_POINTS_PEERS_H
