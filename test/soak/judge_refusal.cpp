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
#include <cstdlib>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace soak {

namespace {

using Kernel_2 = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The numbers that a message has behind a word: "segment 3", "vertices 5 (0, 0) and 7", "points 1 and 2".
std::vector<std::size_t> numbers_after(const std::string& message, const std::string& words) {
  std::vector<std::size_t> result;
  const std::regex name("\\b(?:" + words + ") (\\d+)(?:(?: \\([^)]*\\))? and (\\d+))?");
  for (std::sregex_iterator i(message.begin(), message.end(), name), end; i != end; ++i)
    for (const std::size_t group : {1u, 2u})
      if ((*i)[group].matched) result.push_back(std::stoul((*i)[group]));
  return result;
}

/// The places that a message has in parentheses.
std::vector<Point> places_in(const std::string& message) {
  std::vector<Point> result;
  const std::regex place("\\(([-+.0-9e]+), ([-+.0-9e]+)\\)");
  for (std::sregex_iterator i(message.begin(), message.end(), place), end; i != end; ++i)
    // not stod(), which has no numbers below the least normal one
    result.emplace_back(std::strtod((*i)[1].str().c_str(), nullptr),
                        std::strtod((*i)[2].str().c_str(), nullptr));
  return result;
}

bool has(const std::string& message, const char* part) { return message.find(part) != std::string::npos; }

/// Whether the rule and the holes leave anything of what segments enclose, by a triangulation of CGAL's with exact
/// predicates. Nested borders count by parity, or else are all inside.
bool has_domain(const Pslg& graph, bool is_by_parity) {
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel_2, CGAL::Default, CGAL::Exact_predicates_tag>;
  Cdt cdt;
  for (const auto& s : graph.segments)
    if (graph.point(s[0]) != graph.point(s[1])) cdt.insert_constraint(graph.point(s[0]), graph.point(s[1]));
  if (cdt.dimension() < 2) return false;
  using Faces = std::vector<Cdt::Face_handle>;
  // those that are reached without crossing a segment and were not before, and those across segments
  const auto flood = [](Faces stack, std::set<Cdt::Face_handle>& reached, Faces& across) {
    while (!stack.empty()) {
      const Cdt::Face_handle f = stack.back();
      stack.pop_back();
      if (!reached.insert(f).second) continue;
      for (int i = 0; i < 3; ++i) (f->is_constrained(i) ? across : stack).push_back(f->neighbor(i));
    }
  };
  std::set<Cdt::Face_handle> reached, outside;
  Faces level{cdt.infinite_face()}, next;
  for (bool is_outside = true; !level.empty(); is_outside = is_by_parity && !is_outside) {
    std::set<Cdt::Face_handle> before = reached;
    next.clear();
    flood(level, reached, next);
    for (const Cdt::Face_handle f : reached)
      if (is_outside && before.count(f) == 0) outside.insert(f);
    level.clear();
    for (const Cdt::Face_handle f : next)
      if (reached.count(f) == 0) level.push_back(f);
  }
  std::set<Cdt::Face_handle> of_holes;
  Faces holes;
  for (const Point& p : graph.holes) holes.push_back(cdt.locate(p));
  flood(holes, of_holes, next);
  for (const Cdt::Face_handle f : cdt.finite_face_handles())
    if (outside.count(f) == 0 && of_holes.count(f) == 0) return true;
  return false;
}

bool is_any_seed_on_a_segment(const Pslg& graph) {
  const auto is_on = [&](const Point& p) { return is_on_a_segment(graph, p); };
  return std::any_of(graph.holes.begin(), graph.holes.end(), is_on) ||
         std::any_of(graph.regions.begin(), graph.regions.end(),
                     [&](const auto& r) { return is_on(r.point); });
}

Verdict judge_crossing(const Soak_case& c, const std::string& message) {
  std::vector<std::size_t> segments;
  const std::regex number("segment (\\d+)");
  for (std::sregex_iterator i(message.begin(), message.end(), number), end; i != end; ++i)
    segments.push_back(std::stoul((*i)[1]));
  if (segments.size() < 2 || segments[0] >= c.graph.segments.size() || segments[1] >= c.graph.segments.size())
    return failure("refused: crossing without numbers", message);
  if (!do_cross(c.graph, segments[0], segments[1])) return failure("refused: false crossing", message);
  return {Outcome::REFUSED, "crossing", message};
}

Verdict judge_domain(const Soak_case& c, const std::string& message) {
  const bool is_marked = c.wishes.domain == CGAL::Quality_mesh_options_2::Domain::MARKED;
  if (is_marked && c.graph.regions.empty()) return {Outcome::REFUSED, "no domain", message};
  if (is_any_seed_on_a_segment(c.graph)) return {Outcome::REFUSED, "no domain", message};
  const bool is_by_parity = c.wishes.domain == CGAL::Quality_mesh_options_2::Domain::NESTING_PARITY;
  if (is_marked || !has_domain(c.graph, is_by_parity)) return {Outcome::REFUSED, "no domain", message};
  return failure("refused: there is a domain", message);
}

/// The vertices that a message names, or else the ends of its segments.
std::vector<std::size_t> named_vertices(const Pslg& graph, const std::string& message) {
  std::vector<std::size_t> vertices = numbers_after(message, "vertex|vertices|points?");
  if (vertices.empty())
    for (const std::size_t s : numbers_after(message, "segments?"))
      if (s < graph.segments.size())
        for (const auto v : graph.segments[s]) vertices.push_back(std::size_t(v));
  return vertices;
}

/// Features whose vertices or segments a message names.
Verdict judge_distance(const Soak_case& c, const std::string& message) {
  const Pslg& graph = c.graph;
  const std::vector<std::size_t> vertices = named_vertices(graph, message);
  if (vertices.empty()) return failure("refused: no reason that could be checked", message);
  // Where a kernel says how near is too near; the quadtrees' grid has 62 bits, but for exact numbers.
  const bool has_grid = c.separation == Separation::THEOREM_5 && c.kernel != Kernel::EXACT;
  const long double share = c.mode != Mode::PSLG           ? 0x1p-40L
                            : has_grid                     ? 0x1p-56L
                            : c.kernel == Kernel::EXACT    ? 0x1p-128L
                            : c.kernel == Kernel::FILTERED ? 0x1p-400L
                                                           : 0x1p-100L;
  const long double extent = extent_of(graph.vertices);
  for (const std::size_t v : vertices) {
    if (v >= graph.vertices.size()) return failure("refused: no such vertex", message);
    const Point& p = graph.vertices[v];
    const long double least = least_feature_distance(graph, p, 0);
    if (least <= share * extent || is_without_room(c, p, 0)) return {Outcome::REFUSED, "too near", message};
  }
  return failure("refused: not too near", message);
}

/// A triangle of the mesh that doubles cannot express, at the places that are named.
Verdict judge_places(const Soak_case& c, const std::string& message) {
  const std::vector<Point> places = places_in(message);
  if (places.empty()) return failure("refused: no place", message);
  double reach = 0;
  for (const Point& p : places) reach = std::max(reach, std::sqrt(CGAL::squared_distance(p, places.front())));
  for (const Point& p : places)
    if (is_without_room(c, p, 2 * reach)) return {Outcome::REFUSED, "no room", message};
  return failure("refused: there is room", message);
}

/// Whether a vertex is near to something else for the extent.
bool has_narrow_gap(const Pslg& graph, const std::vector<std::size_t>& vertices) {
  const long double narrow = 1e-3L * extent_of(graph.vertices);
  return std::any_of(vertices.begin(), vertices.end(), [&](std::size_t v) {
    return v < graph.vertices.size() && least_feature_distance(graph, graph.vertices[v], 0) <= narrow;
  });
}

/// What bounds of size ask for in the square around the input, and four times that. Areas are shares of that square.
long double most_for_sizes(const Soak_case& c) {
  const long double extent = extent_of(c.graph.vertices);
  std::vector<long double> areas{c.wishes.max_area};
  for (const long double side : {c.wishes.max_edge, c.wishes.size}) areas.push_back(0.43L * side * side);
  for (const auto& r : c.graph.regions) areas.push_back(r.max_area / (extent * extent));
  long double most = 0;
  for (const long double area : areas)
    if (area > 0) most = std::max(most, 8 / area); // triangles have half the area allowed
  return most;
}

/// Where a gap is so narrow for its length that there is no room for the triangles: in memory, or in what graphs of few
/// vertices have. The estimate has to be four times what there is, a mesh that was begun has to have used it up.
Verdict judge_size(const Soak_case& c, const std::string& message) {
  const std::vector<std::size_t> vertices = named_vertices(c.graph, message);
  const bool is_for_sizes = has(message, "for the bounds of size");
  std::smatch number;
  const std::regex words("(about|more than|not done with) ([0-9.e+]+) (triangles|vertices)");
  if ((vertices.empty() && !is_for_sizes) || !std::regex_search(message, number, words))
    return failure("refused: too large, without numbers", message);
  const double triangles = std::stod(number[2]) * (number[3] == "vertices" ? 2 : 1);
  if (is_for_sizes)
    return triangles <= most_for_sizes(c) ? Verdict{Outcome::REFUSED, "too large", message}
                                          : failure("refused: sizes ask for less", message);
  const double least = c.kernel == Kernel::EXACT ? 1e6 : 2e6;
  if (triangles < (number[1] == "not done with" ? least : 4 * least))
    return failure("refused: not too large", message);
  if (!has_narrow_gap(c.graph, vertices)) return failure("refused: no narrow gap", message);
  return {Outcome::REFUSED, "too large", message};
}

/// A hole's or region's point on a segment, or as near to it as words can tell.
Verdict judge_seed(const Soak_case& c, const std::string& message) {
  std::vector<Point> seeds;
  for (const std::size_t h : numbers_after(message, "hole"))
    if (h < c.graph.holes.size()) seeds.push_back(c.graph.holes[h]);
  for (const std::size_t r : numbers_after(message, "region"))
    if (r < c.graph.regions.size()) seeds.push_back(c.graph.regions[r].point);
  const bool is_of_words = c.kernel == Kernel::FIXED || c.kernel == Kernel::FIXED32;
  for (const Point& p : seeds)
    if (is_on_a_segment(c.graph, p) ||
        (is_of_words && distance_to_nearest_segment(c.graph, p) <= 4 * Resolution(c).at(p)))
      return {Outcome::REFUSED, "seed on a segment", message};
  return failure("refused: seed is on no segment", message);
}

} // namespace

Verdict judge_refusal(const Soak_case& c, const std::string& message) {
  if (has(message, "doubles cannot express")) return judge_places(c, message);
  if (has(message, " crosses ")) return judge_crossing(c, message);
  if (!numbers_after(message, "hole|region").empty()) return judge_seed(c, message);
  if (has(message, "no vertices") || has(message, "no points") || has(message, "one vertex") ||
      has(message, "one point") || has(message, "on the line"))
    return are_on_a_line(c.graph.vertices) ? Verdict{Outcome::REFUSED, "on a line", message}
                                           : failure("refused: not on a line", message);
  if (has(message, "domain") || has(message, "no segments")) return judge_domain(c, message);
  if (has(message, "triangles")) return judge_size(c, message);
  if (has(message, "too large") || has(message, "span"))
    return extent_of(c.graph.vertices) > 1e290 ? Verdict{Outcome::REFUSED, "too large", message}
                                               : failure("refused: coordinates are not too large", message);
  return judge_distance(c, message);
}

} // namespace soak
