#include "mesh_graph_with.h"

#include <CGAL/Filtered_quadtree_traits_2.h>

mesh_graph::Mesh mesh_graph::with_doubles(const Pslg& pslg, const Options& options, Neighbors neighbors,
                                          Report& report) {
  return mesh_graph_with<CGAL::Filtered_quadtree_traits_2<>>(pslg, options, neighbors, report);
}
