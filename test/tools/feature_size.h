// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Ruppert's local feature size of a graph, by brute force, and how short the edges of a mesh are beside it.

#ifndef QUADTREE_MESH_2_TEST_FEATURE_SIZE_H
#define QUADTREE_MESH_2_TEST_FEATURE_SIZE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace feature_size {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;

/// A vertex (as both ends) or a segment, and how far it is from a point.
struct Feature {
  double distance;
  std::array<std::size_t, 2> ends;
};

inline bool are_incident(const Feature& f, const Feature& g) {
  return std::find_first_of(f.ends.begin(), f.ends.end(), g.ends.begin(), g.ends.end()) != f.ends.end();
}

/// The radius of the least disk around p that meets two features without a common vertex.
inline double local_feature_size(const Pslg& pslg, const Point& p) {
  std::vector<Feature> features;
  for (std::size_t v = 0; v < pslg.vertices.size(); ++v)
    features.push_back({std::sqrt(CGAL::squared_distance(p, pslg.vertices[v])), {v, v}});
  for (const auto& s : pslg.segments) {
    const std::size_t a(s[0]), b(s[1]);
    features.push_back(
        {std::sqrt(CGAL::squared_distance(p, Kernel::Segment_2(pslg.vertices[a], pslg.vertices[b]))),
         {a, b}});
  }
  std::sort(features.begin(), features.end(),
            [](const Feature& f, const Feature& g) { return f.distance < g.distance; });
  for (std::size_t i = 1; i < features.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!are_incident(features[i], features[j])) return features[i].distance;
  return std::numeric_limits<double>::infinity();
}

/// The least quotient of the length of an edge and the lesser of `size` and the local feature size at its ends.
inline double least_share_of_feature_size(const CGAL::Indexed_mesh_2<Point>& mesh, const Pslg& pslg,
                                          double size = std::numeric_limits<double>::infinity()) {
  std::vector<double> size_at(mesh.points.size());
  for (std::size_t v = 0; v < size_at.size(); ++v)
    size_at[v] = std::min(size, local_feature_size(pslg, mesh.points[v]));
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a(t[k]), b(t[(k + 1) % 3]);
      const double length = std::sqrt(CGAL::squared_distance(mesh.points[a], mesh.points[b]));
      least = std::min(least, length / std::min(size_at[a], size_at[b]));
    }
  return least;
}

} // namespace feature_size

#endif // QUADTREE_MESH_2_TEST_FEATURE_SIZE_H
