#include "refined_mesh.h"

#include <CGAL/refine_mesh_2.h>
#include <CGAL/tags.h>

#include <utility>

mesh_graph::Mesh refined_mesh(const mesh_graph::Mesh& mesh, const mesh_graph::Pslg& pslg,
                              const std::vector<double>& areas, const mesh_graph::Options& options,
                              mesh_graph::Report& report) {
  auto refined = areas.empty() ? CGAL::refine_mesh_2<CGAL::Parallel_tag>(mesh, pslg, options)
                               : CGAL::refine_mesh_2<CGAL::Parallel_tag>(mesh, pslg, areas, options);
  report = std::move(refined.report);
  return std::move(refined.mesh);
}
