#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_GRAPH_WITH_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_GRAPH_WITH_H

#include "mesh_graph.h"

#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>
#include <CGAL/tags.h>

namespace mesh_graph {

/// Meshes a graph over the points of `Traits`, with all threads.
template <class Traits>
auto mesh_graph_with(const CGAL::Pslg_2<typename Traits::Point_2>& pslg, const Options& options,
                     Neighbors neighbors, Report& report) {
  CGAL::Quality_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  if (neighbors == Neighbors::TRAPEZOIDAL)
    mesher
        .template find_neighbors_by<CGAL::Trapezoidal_vertex_edge_neighbors_2<Traits, CGAL::Parallel_tag>>();
  auto mesh = mesher(pslg);
  report = mesher.report();
  return mesh;
}

} // namespace mesh_graph

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_GRAPH_WITH_H
