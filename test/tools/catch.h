// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_CATCH_H
#define QUADTREE_MESH_2_TEST_CATCH_H

// Catch2 by either of its versions: v2 is one header, v3 a library with a header for everything.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#include <cstdlib>

/// Whether sweeps shall run in full size (`test/run.sh --full`); without it they stay small enough for every
/// commit. Test cases with no small size carry the tag `[.slow]`, which hides them unless the run is a full
/// one.
inline bool is_full_run() { return std::getenv("QUADTREE_MESH_FULL_TESTS") != nullptr; }

#endif // QUADTREE_MESH_2_TEST_CATCH_H
