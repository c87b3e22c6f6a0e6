// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The last flips, from triangulations whose edges were flipped at random: every edge is Delaunay, and the account names
// what the mesh has.

#include "catch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace test_exact_legalizer {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Geometry = internal::Double_geometry_2<Kernel>;
using Point = Geometry::Point;
using Mesh = internal::Kernel_mesh<Geometry>;
using internal::Side;
using internal::Triangle_id;
using Random = std::mt19937_64;

double uniform(Random& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

/// At random; on a lattice, so that many are on one circle; or in rows so near to each other that triangles are
/// needles.
enum class Places { RANDOM, LATTICE, NEEDLES };

std::vector<Point> points(Places places, Random& random) {
  std::vector<Point> result;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      if (places == Places::RANDOM) result.push_back({uniform(random), uniform(random)});
      if (places == Places::LATTICE) result.push_back({double(i), double(j)});
      if (places == Places::NEEDLES)
        result.push_back({i + 1e-3 * uniform(random), std::ldexp(j + 0.5 * uniform(random), -40)});
    }
  return result;
}

bool is_convex_around(const Mesh& mesh, Side s) {
  const auto a = mesh.opposite(s), d = mesh.opposite(mesh.across(s));
  return mesh.orientation(a, mesh.source(s), d) > 0 && mesh.orientation(a, d, mesh.target(s)) > 0;
}

void flip_at_random(Mesh& mesh, Random& random) {
  for (std::size_t i = 0; i < 2 * mesh.triangles.size(); ++i) {
    const Side s(static_cast<Triangle_id>(random() % mesh.triangles.size()), static_cast<int>(random() % 3));
    if (!mesh.across(s).is_constrained() && is_convex_around(mesh, s)) mesh.flip(s.triangle(), s.slot());
  }
}

std::size_t number_of_sides_that_are_not_Delaunay(const Mesh& mesh) {
  const auto point = [&](auto v) { return Kernel::Point_2(mesh.point(v).x, mesh.point(v).y); };
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

using Histograms = std::pair<std::array<std::size_t, 60>, std::array<std::size_t, 120>>;
Histograms histograms_of(const internal::Angle_histogram& angles) {
  Histograms result{};
  angles.add_to(result.first, result.second);
  return result;
}

} // namespace

TEST_CASE("The last flips leave a Delaunay mesh and an account of it", "[mesher][exact_legalizer]") {
  const Places places = GENERATE(Places::RANDOM, Places::LATTICE, Places::NEEDLES);
  Random random(7);
  for (int run = 0; run < 10; ++run) {
    internal::Meshing_problem<Geometry> problem;
    problem.bounds = internal::Bounds<Geometry>(20.7 * CGAL_PI / 180, 0, 0);
    internal::Meshing_state<Geometry> state(problem);
    internal::First_triangulation<CGAL::Sequential_tag, Geometry>(state.mesh, points(places, random)).run({});
    flip_at_random(state.mesh, random);
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
