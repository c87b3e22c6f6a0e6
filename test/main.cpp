// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Catch2 v2 makes its main() in the one file that asks for it, this one, so that it is compiled once; v3
// brings its own.
#define CATCH_CONFIG_MAIN
#include "catch.h"
