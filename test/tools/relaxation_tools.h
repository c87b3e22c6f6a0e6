// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Energies of triangles by trigonometry, a place to work on meshes of rings, and what is checked of that.

#ifndef QUADTREE_MESH_2_TEST_RELAXATION_TOOLS_H
#define QUADTREE_MESH_2_TEST_RELAXATION_TOOLS_H

#include "catch.h"
#include "random_numbers.h"
#include "ring_mesh_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Angle_range.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Star_relaxer.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Triangle_repairer.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Vertex_remover.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace relaxation_test {

using namespace ring_test;
using internal::Float_lanes;
using internal::Patch_marks;
using internal::Patience;
using internal::Range_lanes;
using internal::Ring_triangulation;
using internal::Star_energy;
using internal::Star_vectors;
using internal::Triangle_lanes;

using Mesh = Ring_mesh<Doubles>;
using Range = internal::Angle_range;
using Patch = internal::Ring_patch<Doubles>;
using Relaxer = internal::Star_relaxer<Doubles>;
using Remover = internal::Vertex_remover<Doubles>;
using Repairer = internal::Triangle_repairer<Doubles>;

const std::array<Bounds, 4> all_bounds{{{36, 80}, {30, 89.5}, {0, 89.5}, {20, 95}}};

inline Triangle_lanes lanes_of(Vector b, Vector c) {
  const auto all = [](double x) { return Float_lanes(static_cast<float>(x)); };
  return Triangle_lanes(all(b.x), all(b.y), all(c.x), all(c.y));
}

/// In degrees, of the triangle 0, b, c.
inline std::array<double, 3> angles_at(Vector b, Vector c) {
  const auto angle = [](Vector u, Vector v) { return std::atan2(cross(u, v), dot(u, v)) / degree; };
  return {angle(b, c), angle(c - b, Vector() - b), angle(Vector() - c, b - c)};
}

/// How far the angles are inside the range; negative outside.
inline double depth_in(const std::array<double, 3>& angles, const Bounds& bounds) {
  return std::min(*std::min_element(angles.begin(), angles.end()) - bounds.low,
                  bounds.high - *std::max_element(angles.begin(), angles.end()));
}

/// A patch of all vertices of a mesh, and what works on it.
struct Workplace {
  Workplace(Mesh& m, const Range& range, std::int32_t block = 0)
      : marks(m.number_of_vertices()), patch(m, marks, block), relaxer(patch, range), remover(patch, relaxer),
        repairer(patch, relaxer, remover, spare) {}

  void begin_with_all() {
    patch.begin();
    for (const Ring_vertex v : patch.mesh().rings.ids())
      if (patch.mesh().is_alive(v) && patch.is_ours(v)) patch.add(v);
    for (const Ring_vertex v : patch.members()) patch.activate(v);
  }

  internal::Indexed_vector<Ring_vertex, Patch_marks> marks;
  std::vector<Ring_vertex> spare;
  Patch patch;
  Relaxer relaxer;
  Remover remover;
  Repairer repairer;
};

inline void shake(Mesh& mesh, Random_numbers& random, double amount) {
  for (const Ring_vertex v : mesh.rings.ids()) {
    const Mobility m = mesh.rings[v].mobility;
    const double dx = random.between(-amount, amount), dy = random.between(-amount, amount);
    if (m == Mobility::FREE || m == Mobility::SLIDES_ALONG) mesh.points[v].x += dx;
    if (m == Mobility::FREE || m == Mobility::SLIDES_ACROSS) mesh.points[v].y += dy;
  }
}

/// Borders do not move but along themselves, and fixed vertices not at all.
inline void check_motion(const Mesh& before, const Mesh& after) {
  for (const Ring_vertex v : before.rings.ids()) {
    const Mobility m = before.rings[v].mobility;
    if (m == Mobility::FREE || m == Mobility::REMOVED) continue;
    if (after.rings[v].mobility == Mobility::REMOVED) {
      if (!internal::is_movable(m)) FAIL("a fixed vertex is gone");
      continue;
    }
    if (m != Mobility::SLIDES_ALONG && before.points[v].x != after.points[v].x) FAIL("moved in x");
    if (m != Mobility::SLIDES_ACROSS && before.points[v].y != after.points[v].y) FAIL("moved in y");
  }
}

/// Whether the triangles at the given vertices are in the range, by trigonometry, up to the rounding of that.
template <class Vertices>
bool are_in_range(const Mesh& mesh, const Vertices& vertices, const Bounds& bounds) {
  const std::set<Ring_vertex> asked(vertices.begin(), vertices.end());
  const Angle_extremes e = angle_extremes(mesh, [&](const Triangle& t) {
    return !are_rigid(mesh, t) && asked.count(t[0]) + asked.count(t[1]) + asked.count(t[2]) > 0;
  });
  return e.least >= bounds.low && e.greatest <= bounds.high;
}

} // namespace relaxation_test

#endif // QUADTREE_MESH_2_TEST_RELAXATION_TOOLS_H
