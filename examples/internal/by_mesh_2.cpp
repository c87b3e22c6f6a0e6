#include "by_mesh_2.h"

#include "mesh_2_peer.h"

Mesh_figures figures_by_Mesh_2(const mesh_files::Pslg& pslg, double min_angle_in_degrees,
                               double max_edge_length) {
  return mesh_by_Mesh_2(pslg, min_angle_in_degrees, max_edge_length);
}
