#ifndef QUADTREE_MESH_2_EXAMPLES_POINT_SET_PROGRAM_H
#define QUADTREE_MESH_2_EXAMPLES_POINT_SET_PROGRAM_H

#include "command_line.h"
#include "program_steps.h"

/// Does what the command line asks for in the modes for points.
/// \throws std::exception for bad input and what else stops it.
Exit_status execute_point_set(const Command_line& line);

#endif // QUADTREE_MESH_2_EXAMPLES_POINT_SET_PROGRAM_H
