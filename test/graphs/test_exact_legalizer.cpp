// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The last flips, from triangulations whose edges were flipped at random: every edge is Delaunay, and the account names
// what the mesh has.

#include "catch.h"
#include "flipped_meshes.h"

#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>

#include <cstddef>
#include <vector>

namespace test_exact_legalizer {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using namespace flipped_meshes;
using internal::Triangle_id;

std::size_t number_of_sides_that_are_not_Delaunay(const Mesh& mesh) {
  const auto point = [&](auto v) { return CGAL::Epick::Point_2(mesh.point(v).x, mesh.point(v).y); };
  std::size_t number = 0;
  for (const auto& r : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      if (r.side[k].is_constrained()) continue;
      number += CGAL::side_of_oriented_circle(point(r.v[0]), point(r.v[1]), point(r.v[2]),
                                              point(mesh.opposite(r.side[k]))) == CGAL::ON_POSITIVE_SIDE
                    ? 1
                    : 0;
    }
  return number;
}

} // namespace

TEST_CASE("The last flips leave a Delaunay mesh and an account of it", "[mesher][exact_legalizer]") {
  const Places places = GENERATE(Places::RANDOM, Places::LATTICE, Places::NEEDLES);
  Random random(7);
  for (int run = 0; run < 10; ++run) {
    internal::Meshing_problem<Geometry> problem;
    problem.bounds = internal::Bounds<Geometry>(20.7 * CGAL_PI / 180, 0, 0);
    internal::Meshing_state<Geometry> state(problem);
    state.mesh = triangulation(points(places, 12, random));
    flip_at_random(state.mesh, 2 * state.mesh.triangles.size(), random);
    if (places != Places::LATTICE) CHECK(number_of_sides_that_are_not_Delaunay(state.mesh) > 0);

    const auto account = internal::Exact_legalizer<CGAL::Sequential_tag, Geometry>(state).run();

    CHECK(number_of_sides_that_are_not_Delaunay(state.mesh) == 0);
    internal::Angle_histogram angles;
    std::vector<Triangle_id> suspects;
    for (const Triangle_id t : state.mesh.triangles.ids()) {
      angles.add(state.mesh.shape(state.mesh.triangle(t)));
      if (state.is_suspect(t)) suspects.push_back(t);
    }
    CHECK(histograms_of(account.angles) == histograms_of(angles));
    CHECK(account.suspects == suspects);
  }
}

TEST_CASE("Halves of squares, however they lie, have angles of 45 and 90 degrees", "[exact_legalizer]") {
  const double side = GENERATE(1.0, 3.0, 0x1p-100, 0.7);
  const Geometry::Point corners[4] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  internal::Angle_histogram angles;
  for (std::size_t i = 0; i < 4; ++i)
    angles.add(
        internal::Kernel_mesh<Geometry>::shape(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]));
  const auto [least, largest] = histograms_of(angles);
  CHECK(least[45] == 4);
  CHECK(largest[30] == 4); // from 60 degrees on
}

} // namespace test_exact_legalizer
