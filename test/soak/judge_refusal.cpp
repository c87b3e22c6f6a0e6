// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "exact_facts.h"
#include "judge.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <list>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace soak {

namespace {

using Kernel_2 = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The numbers that a message has behind a word: "segment 3", "vertices 5 and 7", "points 1 and 2".
std::vector<std::size_t> numbers_after(const std::string& message, const std::string& words) {
  std::vector<std::size_t> result;
  const std::regex name("\\b(?:" + words + ") (\\d+)(?: and (\\d+))?");
  for (std::sregex_iterator i(message.begin(), message.end(), name), end; i != end; ++i)
    for (const std::size_t group : {1, 2})
      if ((*i)[group].matched) result.push_back(std::stoul((*i)[group]));
  return result;
}

bool has(const std::string& message, const char* part) { return message.find(part) != std::string::npos; }

/// Whether segments enclose anything that holes leave, by a triangulation of CGAL's with exact predicates.
bool has_domain(const Pslg& graph) {
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel_2, CGAL::Default, CGAL::Exact_predicates_tag>;
  Cdt cdt;
  for (const auto& s : graph.segments)
    if (graph.point(s[0]) != graph.point(s[1])) cdt.insert_constraint(graph.point(s[0]), graph.point(s[1]));
  if (cdt.dimension() < 2) return false;
  std::set<Cdt::Face_handle> outside;
  const auto flood = [&](Cdt::Face_handle first) {
    std::vector<Cdt::Face_handle> stack{first};
    while (!stack.empty()) {
      const Cdt::Face_handle f = stack.back();
      stack.pop_back();
      if (!outside.insert(f).second) continue;
      for (int i = 0; i < 3; ++i)
        if (!f->is_constrained(i)) stack.push_back(f->neighbor(i));
    }
  };
  flood(cdt.infinite_face());
  for (const Point& p : graph.holes) flood(cdt.locate(p));
  for (const Cdt::Face_handle f : cdt.finite_face_handles())
    if (outside.count(f) == 0) return true;
  return false;
}

bool is_any_seed_on_a_segment(const Pslg& graph) {
  const auto is_on = [&](const Point& p) { return is_on_a_segment(graph, p); };
  return std::any_of(graph.holes.begin(), graph.holes.end(), is_on) ||
         std::any_of(graph.regions.begin(), graph.regions.end(), [&](const auto& r) { return is_on(r.point); });
}

Verdict judge_crossing(const Soak_case& c, const std::string& message) {
  const std::vector<std::size_t> segments = numbers_after(message, "segments?");
  if (segments.size() < 2 || segments[0] >= c.graph.segments.size() || segments[1] >= c.graph.segments.size())
    return failure("refused: crossing without numbers", message);
  if (!do_cross(c.graph, segments[0], segments[1])) return failure("refused: false crossing", message);
  return {Outcome::refused, "crossing", message};
}

Verdict judge_domain(const Soak_case& c, const std::string& message) {
  const bool is_marked = c.wishes.domain == CGAL::Quality_mesh_options_2::Domain::MARKED;
  if (is_marked && c.graph.regions.empty()) return {Outcome::refused, "no domain", message};
  if (is_any_seed_on_a_segment(c.graph)) return {Outcome::refused, "no domain", message};
  if (is_marked || !has_domain(c.graph)) return {Outcome::refused, "no domain", message};
  return failure("refused: there is a domain", message);
}

/// The graphs that a mesh of points is made for have no segments.
Verdict judge_distance(const Soak_case& c, const std::string& message) {
  const std::vector<std::size_t> vertices = numbers_after(message, "vertex|vertices|points?");
  Pslg graph = c.graph;
  if (c.mode != Mode::pslg) graph.segments.clear();
  const long double extent = extent_of(graph.vertices);
  if (vertices.empty()) return failure("refused: too near, without numbers", message);
  // Where a kernel says how near is too near.
  const long double share = c.mode != Mode::pslg ? 0x1p-40L : c.kernel == Kernel::exact ? 0x1p-128L : 0x1p-100L;
  for (const std::size_t v : vertices) {
    if (v >= graph.vertices.size()) return failure("refused: no such vertex", message);
    const Point& p = graph.vertices[v];
    const long double least = least_feature_distance(graph, p, 0);
    if (least <= 256 * Resolution(c).at(p) || least <= share * extent) continue;
    return failure("refused: not too near", message);
  }
  return {Outcome::refused, "too near", message};
}

/// Where a gap is so narrow for its length that no memory has room for the triangles.
Verdict judge_size(const std::string& message) {
  const std::vector<std::size_t> culprits = numbers_after(message, "segments?|vertex|vertices");
  std::smatch number;
  const bool has_number = std::regex_search(message, number, std::regex("about ([0-9.e+]+) triangles"));
  if (culprits.empty() || !has_number) return failure("refused: too large, without numbers", message);
  if (std::stod(number[1]) < 1e7) return failure("refused: not too large", message);
  return {Outcome::refused, "too large", message};
}

Verdict judge_seed(const Soak_case& c, const std::string& message) {
  for (const std::size_t h : numbers_after(message, "hole"))
    if (h < c.graph.holes.size() && is_on_a_segment(c.graph, c.graph.holes[h]))
      return {Outcome::refused, "seed on a segment", message};
  for (const std::size_t r : numbers_after(message, "region"))
    if (r < c.graph.regions.size() && is_on_a_segment(c.graph, c.graph.regions[r].point))
      return {Outcome::refused, "seed on a segment", message};
  return failure("refused: seed is on no segment", message);
}

} // namespace

Verdict judge_refusal(const Soak_case& c, const std::string& message) {
  if (has(message, "cross")) return judge_crossing(c, message);
  if (has(message, "no vertices") || has(message, "no points") || has(message, "one vertex") || has(message, "one point") ||
      has(message, "on the line"))
    return are_on_a_line(c.graph.vertices) ? Verdict{Outcome::refused, "on a line", message}
                                           : failure("refused: not on a line", message);
  if (has(message, "domain") || has(message, "no segments")) return judge_domain(c, message);
  if (has(message, "hole ") || has(message, "region ")) return judge_seed(c, message);
  if (has(message, "triangles")) return judge_size(message);
  if (has(message, "too large") || has(message, "span"))
    return extent_of(c.graph.vertices) > 1e290 ? Verdict{Outcome::refused, "too large", message}
                                               : failure("refused: coordinates are not too large", message);
  if (has(message, "near") || has(message, "close") || has(message, "grid point") || has(message, "room"))
    return judge_distance(c, message);
  return failure("refused: no reason that could be checked", message);
}

} // namespace soak
