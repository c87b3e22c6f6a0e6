// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "words32.h"

#include "meshers_in_words32.h"

#include <CGAL/tags.h>

#include <cstdint>

namespace soak {

namespace {

using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint32_t>;
using Word_point = Traits::Point_2;

Word_point to_word(const Point& p) {
  return {static_cast<std::uint32_t>(p.x()), static_cast<std::uint32_t>(p.y())};
}

} // namespace

Graph_mesh mesh_graph_in_words32(const Pslg& graph, const CGAL::Quality_mesh_options_2& options) {
  CGAL::Pslg_2<Word_point> words;
  for (const Point& p : graph.vertices) words.vertices.push_back(to_word(p));
  words.segments = graph.segments;
  for (const Point& p : graph.holes) words.holes.push_back(to_word(p));
  for (const auto& r : graph.regions) words.regions.push_back({to_word(r.point), r.attribute, r.max_area});
  CGAL::Quality_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  const auto mesh = mesher(words);
  return {CGAL::convert_to_double_points(mesh), mesher.report()};
}

Points_mesh mesh_points_in_words32(const std::vector<Point>& points,
                                   const CGAL::Point_set_mesh_options_2& options) {
  std::vector<Word_point> words;
  for (const Point& p : points) words.push_back(to_word(p));
  CGAL::Point_set_mesher_2<Traits, CGAL::Parallel_tag> mesher(options);
  const auto mesh = mesher(words);
  return {CGAL::convert_to_double_points(mesh), mesher.report()};
}

} // namespace soak
