#include "mesh_graph.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/tags.h>

mesh_graph::Mesh mesh_graph::with_doubles(const Pslg& pslg, const Options& options, Report& report) {
  CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag> mesher(options);
  Mesh mesh = mesher(pslg);
  report = mesher.report();
  return mesh;
}
