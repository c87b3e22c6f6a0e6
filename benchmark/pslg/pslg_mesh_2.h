// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// CGAL's Mesh_2 as the benchmark of meshers sees it.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_MESH_2_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_MESH_2_H

#include "in_child.h"
#include "mesh_2_peer.h"
#include "pslg_run.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <utility>

namespace pslg_mesh_2 {

using Peer = Mesh_2_peer<Pslg_point>;
using CGAL::Quadtree_mesh_2::Vertex_index;

/// The faces in the domain, with the vertices of the input first, as the checker wants them.
inline Indexed_mesh indexed_mesh_of(const Peer::Cdt& cdt, const Pslg& pslg) {
  Indexed_mesh mesh;
  mesh.number_of_input_vertices = pslg.number_of_vertices();
  mesh.points = pslg.vertices;
  std::map<std::pair<double, double>, std::size_t> place; // of equal points the first
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    place.emplace(std::pair(mesh.points[i].x(), mesh.points[i].y()), i);
  std::unordered_map<const Peer::Cdt::Vertex*, Vertex_index> index;
  const auto index_of = [&](const Peer::Cdt::Vertex& v) {
    const auto [entry, is_new] = index.emplace(&v, Vertex_index(mesh.points.size()));
    if (!is_new) return entry->second;
    const auto input = place.find({v.point().x(), v.point().y()});
    if (input == place.end())
      mesh.points.push_back(v.point());
    else
      entry->second = Vertex_index(input->second);
    return entry->second;
  };
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    if (!f->is_in_domain()) continue;
    std::array<Vertex_index, 3> triangle;
    for (int k = 0; k < 3; ++k) triangle[std::size_t(k)] = index_of(*f->vertex(k));
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// Mesh_2 bounds no areas; an edge of this length bounds them, as no triangle with shorter edges is larger
/// than the equilateral one.
inline double edge_for_area(double area) { return std::sqrt(4 * area / std::sqrt(3.0)); }

inline Pslg_run mesh(const Pslg_task& task, Check check) {
  Pslg_run run;
  Peer peer(task.pslg);
  peer.refine(task.pslg.holes, task.min_angle, edge_for_area(task.max_area));
  run.mesh = peer.insertion();
  run.mesh += peer.refinement();
  run.phases = {peer.insertion().cpu, peer.refinement().cpu};
  run.peak_memory_mb = peak_memory_mb();

  run.vertices = peer.cdt().number_of_vertices();
  for (auto f = peer.cdt().finite_faces_begin(); f != peer.cdt().finite_faces_end(); ++f)
    run.triangles += f->is_in_domain();
  if (check == Check::YES)
    check_mesh(indexed_mesh_of(peer.cdt(), task.pslg), task,
               CGAL::Mesh_quality_options_2::Arrays::POINTS_AND_TRIANGLES, run);
  return run;
}

inline Pslg_method method() {
  return {"Mesh_2", 0, {"insert", "refine"}, [](const Pslg_task& task, Check check) {
            return in_child([&] { return mesh(task, check); }, task.limit_seconds).result;
          }};
}

} // namespace pslg_mesh_2

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_MESH_2_H
