#ifndef QUADTREE_MESH_2_EXAMPLES_BY_MESH_2_H
#define QUADTREE_MESH_2_EXAMPLES_BY_MESH_2_H

// What quality_mesh compares with. Compiled by itself, as two parts of the program ask for it.

#include "mesh_figures.h"
#include "mesh_files.h"

/// What CGAL's Mesh_2 makes of a graph; 0 for no bound on edges.
Mesh_figures figures_by_Mesh_2(const mesh_files::Pslg& pslg, double min_angle_in_degrees,
                               double max_edge_length);

#endif // QUADTREE_MESH_2_EXAMPLES_BY_MESH_2_H
