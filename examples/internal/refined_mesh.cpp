#include "refined_mesh.h"

#include <CGAL/refine_mesh_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

mesh_graph::Mesh refined_mesh(const mesh_graph::Mesh& mesh, const mesh_graph::Pslg& pslg,
                              const std::vector<double>& areas, const mesh_graph::Options& options,
                              mesh_graph::Report& report, std::size_t& kept_vertices) {
  auto refined = areas.empty() ? CGAL::refine_mesh_2<CGAL::Parallel_tag>(mesh, pslg, options)
                               : CGAL::refine_mesh_2<CGAL::Parallel_tag>(mesh, pslg, areas, options);
  report = std::move(refined.report);
  const auto& old = refined.transfer.old_vertex;
  kept_vertices =
      std::size_t(std::find_if(old.begin(), old.end(), [](auto v) { return !v.is_valid(); }) - old.begin());
  return std::move(refined.mesh);
}
