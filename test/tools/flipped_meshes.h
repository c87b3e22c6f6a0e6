// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Triangulations whose edges were flipped at random, for tests of what makes them Delaunay.

#ifndef QUADTREE_MESH_2_TEST_FLIPPED_MESHES_H
#define QUADTREE_MESH_2_TEST_FLIPPED_MESHES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Angle_histogram.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace flipped_meshes {

using Geometry =
    CGAL::Quadtree_mesh_2::internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Mesh = CGAL::Quadtree_mesh_2::internal::Kernel_mesh<Geometry>;
using Random = std::mt19937_64;

inline double uniform(Random& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

/// At random; on a lattice, so that many are on one circle; or in rows so near to each other that triangles are
/// needles.
enum class Places { RANDOM, LATTICE, NEEDLES };

/// n * n of them.
inline std::vector<Geometry::Point> points(Places places, int n, Random& random) {
  std::vector<Geometry::Point> result;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (places == Places::RANDOM) result.push_back({uniform(random), uniform(random)});
      if (places == Places::LATTICE) result.push_back({double(i), double(j)});
      if (places == Places::NEEDLES)
        result.push_back({i + 1e-3 * uniform(random), std::ldexp(j + 0.5 * uniform(random), -40)});
    }
  return result;
}

inline Mesh triangulation(const std::vector<Geometry::Point>& points) {
  Mesh mesh;
  CGAL::Quadtree_mesh_2::internal::First_triangulation<CGAL::Sequential_tag, Geometry>(mesh, points).run({});
  return mesh;
}

inline bool is_convex_around(const Mesh& mesh, CGAL::Quadtree_mesh_2::internal::Side s) {
  const auto a = mesh.opposite(s), d = mesh.opposite(mesh.across(s));
  return mesh.orientation(a, mesh.source(s), d) > 0 && mesh.orientation(a, d, mesh.target(s)) > 0;
}

/// Tries so many flips.
inline void flip_at_random(Mesh& mesh, std::size_t tries, Random& random) {
  using CGAL::Quadtree_mesh_2::internal::Side;
  using CGAL::Quadtree_mesh_2::internal::Triangle_id;
  for (std::size_t i = 0; i < tries; ++i) {
    const Side s(static_cast<Triangle_id>(random() % mesh.triangles.size()), static_cast<int>(random() % 3));
    if (!mesh.across(s).is_constrained() && is_convex_around(mesh, s)) mesh.flip(s.triangle(), s.slot());
  }
}

using Histograms = std::pair<std::array<std::size_t, 60>, std::array<std::size_t, 120>>;
inline Histograms histograms_of(const CGAL::Quadtree_mesh_2::internal::Angle_histogram& angles) {
  Histograms result{};
  angles.add_to(result.first, result.second);
  return result;
}

} // namespace flipped_meshes

#endif // QUADTREE_MESH_2_TEST_FLIPPED_MESHES_H
