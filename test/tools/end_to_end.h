// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_END_TO_END_H
#define QUADTREE_MESH_2_TEST_END_TO_END_H

// Small runs of everything that a mesher does, over any traits, with what is promised for every mesh checked. They are
// what the reduced suite, which is compiled with sanitizers, consists of.

#include "catch.h"
#include "mesher_test_tools.h"
#include "random_pslg_shapes.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/tags.h>

#include <string>
#include <utility>
#include <vector>

namespace end_to_end {

using mesher_test::Options;
using pslg_test::Pslg;

/// Meshes in parallel, and checks that the mesh is valid and every bound met.
template <class Traits>
void check_graph(const CGAL::Pslg_2<typename Traits::Point_2>& pslg, const Options& options) {
  CGAL::Quality_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  const auto mesh = mesher(pslg);
  const auto quality = CGAL::mesh_quality_2(mesh, pslg,
                                            CGAL::Mesh_quality_options_2()
                                                .min_angle(options.min_angle())
                                                .max_edge(options.max_edge())
                                                .max_area(options.max_area()));
  for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(quality.unmet_triangles.empty());
  CHECK(mesher.report().is_met());
  CHECK(mesher.report().exempt_triangles.size() == quality.exempt_triangles);
}

/// Graphs with holes, acute corners, near features, and whatever a seed of each random family makes.
inline std::vector<std::pair<std::string, Pslg>> graphs() {
  std::vector<std::pair<std::string, Pslg>> all;
  for (const char* name : {"syn_near_1e-06.poly", "syn_wedge_1deg.poly", "hard_visibility_graph_2608.poly"})
    all.emplace_back(name, mesher_test::read(name));
  for (const random_pslg::Family& family : random_pslg::all_families())
    all.emplace_back(family.name, family.make(1));
  return all;
}

/// All graphs, with features separated in both ways.
/// \param convert makes a graph over the traits' points of one over doubles
template <class Traits, class Convert>
void check_graphs(const Convert& convert) {
  for (const auto& [name, pslg] : graphs()) {
    CAPTURE(name);
    const auto graph = convert(pslg);
    check_graph<Traits>(graph, Options());
    check_graph<Traits>(graph, Options().separate(Options::Separation::THEOREM_5));
  }
}

} // namespace end_to_end

#endif // QUADTREE_MESH_2_TEST_END_TO_END_H
