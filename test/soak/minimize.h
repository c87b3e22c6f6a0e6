// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_MINIMIZE_H
#define QUADTREE_MESH_2_TEST_SOAK_MINIMIZE_H

// Makes an input that fails smaller, as long as it fails in the same way.

#include "Batch_runner.h"
#include "Soak_case.h"

namespace soak {

/// Drops segments, vertices, holes and wishes, in halves, quarters and so on, for so many seconds of the clock at most.
/// \param kind of failure that must stay
Soak_case minimized(Soak_case c, const std::string& kind, const Limits& limits, double seconds);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_MINIMIZE_H
