// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "judge.h"

#include "exact_facts.h"
#include "point_mesh_checks.h"
#include "run_case.h"

#include "report_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <new>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>

namespace soak {

namespace {

using Reason = CGAL::Quality_mesh_report_2::Reason;

/// Bounds up to here are promised.
constexpr double promised_angle = 20.7;

/// A message without its numbers: the same for the same cause.
std::string kind_of(const std::string& message) {
  std::string kind;
  for (const char ch : message) {
    const bool is_of_number = std::isdigit(static_cast<unsigned char>(ch)) || ch == '.' || ch == '-';
    if (!is_of_number)
      kind += ch;
    else if (kind.empty() || kind.back() != '#')
      kind += '#';
  }
  return kind.substr(0, 60);
}

bool are_same(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.segment_of_vertex == b.segment_of_vertex && a.region_of_triangle == b.region_of_triangle;
}

/// What must hold for any mesh, by exact predicates of CGAL's alone.
std::optional<Verdict> find_fault(const Mesh& mesh, const std::vector<Point>& input) {
  if (mesh.triangles.empty()) return failure("no triangles", "");
  if (mesh.points.size() < input.size()) return failure("lost vertex", "fewer vertices than the input has");
  for (std::size_t v = 0; v < input.size(); ++v) {
    const Point &p = input[v], &q = mesh.points[v];
    const bool is_same =
        p == q && std::signbit(p.x()) == std::signbit(q.x()) && std::signbit(p.y()) == std::signbit(q.y());
    if (!is_same) return failure("moved vertex", "vertex " + std::to_string(v));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto turn = CGAL::orientation(mesh.point(a), mesh.point(b), mesh.point(c));
    if (turn != CGAL::LEFT_TURN)
      return failure(turn == CGAL::COLLINEAR ? "flat triangle" : "clockwise triangle",
                     "triangle " + std::to_string(t));
  }
  return {};
}

/// How far what matters to a triangle may be from its centroid: twice its longest side.
long double reach_of(const Mesh& mesh, std::size_t t) {
  long double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &p = mesh.point(mesh.triangles[t][k]), &q = mesh.point(mesh.triangles[t][(k + 1) % 3]);
    longest = std::max(longest, std::hypot(static_cast<long double>(p.x()) - q.x(),
                                           static_cast<long double>(p.y()) - q.y()));
  }
  return 2 * longest;
}

/// Whether the mesh was made and measured in other numbers than the doubles that are judged.
bool is_rounded(const Soak_case& c) { return c.kernel == Kernel::EXACT || c.kernel == Kernel::FIXED; }

/// The degrees by which an angle may be smaller after its vertices were rounded, or moved by a step, to doubles.
double lost_by_rounding(const Point& p, const Point& q, const Point& r) {
  double largest = 0, shortest = std::sqrt(CGAL::squared_distance(p, q));
  for (const Point& v : {p, q, r}) largest = std::max({largest, std::fabs(v.x()), std::fabs(v.y())});
  for (const Point& v : {p, q}) shortest = std::min(shortest, std::sqrt(CGAL::squared_distance(v, r)));
  const double step = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  return 180 / CGAL_PI * 4 * step / shortest;
}

/// Whether the reason for a triangle that misses a bound is true; a failure if it is not.
std::optional<Verdict> find_fault(const Soak_case& c, const Mesh& mesh,
                                  const CGAL::Quality_mesh_report_2::Unmet_triangle& unmet) {
  const std::string kind = std::string("unmet: ") + report_words::name(unmet.reason);
  std::ostringstream detail;
  detail.precision(17);
  detail << "triangle " << unmet.triangle.value() << " at (" << unmet.centroid[0] << ", " << unmet.centroid[1]
         << "), least angle " << unmet.least_angle;
  const bool is_promised = c.wishes.min_angle <= promised_angle;
  switch (unmet.reason) {
  case Reason::LEAST_EDGE:
    if (c.wishes.min_edge > 0) return {};
    break;
  case Reason::BUDGET:
  case Reason::CORNER:
    if (!is_promised) return {};
    break;
  case Reason::COORDINATES: {
    if (!is_promised) return {}; // refinement may descend to where there is no room, without need
    const auto& t = mesh.triangles[std::size_t(unmet.triangle)];
    const Point &p = mesh.point(t[0]), &q = mesh.point(t[1]), &r = mesh.point(t[2]);
    const Point centroid(p.x() / 3 + q.x() / 3 + r.x() / 3, p.y() / 3 + q.y() / 3 + r.y() / 3);
    if (is_without_room(c, centroid, reach_of(mesh, std::size_t(unmet.triangle)))) return {};
    if (is_within_needle(c, centroid) || do_sizes_lack_room(c, centroid)) return {};
    if (is_rounded(c) && unmet.least_angle + lost_by_rounding(p, q, r) >= c.wishes.min_angle) return {};
    break;
  }
  case Reason::CANCELLED:
  case Reason::CRITERIA:
  case Reason::KEPT_SEGMENT:
  case Reason::GREATEST_ANGLE: // not asked for
    break;
  }
  return failure(kind, detail.str());
}

Verdict judge_graph_mesh(const Soak_case& c, const Graph_mesh& run) {
  if (const auto crossing = find_crossing(c.graph))
    return failure("crossing accepted", "segments " + std::to_string(crossing->first) + " and " +
                                            std::to_string(crossing->second));
  if (const auto fault = find_fault(run.mesh, c.graph.vertices)) return *fault;
  const CGAL::Mesh_quality_2 quality = CGAL::mesh_quality_2(run.mesh, c.graph, check_options(c));
  if (!quality.is_valid())
    return failure("invalid: " + kind_of(quality.errors.front()), quality.errors.front());
  std::set<std::size_t> reported, unmet;
  for (const auto& u : run.report.unmet_triangles) reported.insert(std::size_t(u.triangle));
  if (is_rounded(c)) // what rounding broke is known to the checker alone, which the program asks, too
    for (const auto& u : quality.unmet_triangles) {
      if (!reported.insert(std::size_t(u.triangle)).second) continue;
      if (const auto fault =
              find_fault(c, run.mesh, {u.triangle, u.centroid, u.least_angle, Reason::COORDINATES}))
        return *fault;
    }
  for (const auto& u : quality.unmet_triangles) unmet.insert(std::size_t(u.triangle));
  if (!std::includes(reported.begin(), reported.end(), unmet.begin(), unmet.end()))
    return failure("unmet without a report",
                   std::to_string(unmet.size()) + " unmet, " + std::to_string(reported.size()) + " reported");
  for (const auto& u : run.report.unmet_triangles)
    if (const auto fault = find_fault(c, run.mesh, u)) return *fault;
  if (reported.empty() && (run.report.is_budget_exhausted || run.report.is_cancelled))
    return failure("budget exhausted without need", "");
  return {reported.empty() ? Outcome::MET : Outcome::UNMET, "", ""};
}

/// Whether points are so near to each other that angles outside the range have an excuse.
bool have_room(const Soak_case& c) {
  Pslg points;
  points.vertices = c.graph.vertices;
  const long double extent = extent_of(points.vertices);
  for (const Point& p : points.vertices) {
    const long double least = least_feature_distance(points, p, 0);
    if (least <= 0x1p-40L * extent || least <= 4096 * Resolution(c).at(p)) return false;
  }
  return true;
}

Verdict judge_points_mesh(const Soak_case& c, const Points_mesh& run) {
  // No points have no mesh, but for the box of least angles.
  if (c.graph.vertices.empty() && c.mode != Mode::POINTS && run.mesh.triangles.empty())
    return {Outcome::MET, "", ""};
  if (const auto fault = find_fault(run.mesh, c.graph.vertices)) return *fault;
  using point_mesh_test::Made_in;
  const Made_in made_in = c.kernel == Kernel::EXACT     ? Made_in::EXACT_NUMBERS
                          : c.kernel == Kernel::FIXED32 ? Made_in::WORDS
                                                        : Made_in::COORDINATES;
  bool is_unmet = false;
  for (const std::string& fault :
       point_mesh_test::faults_of(run.mesh, c.graph.vertices, points_options(c), run.report, made_in)) {
    if (is_rounded(c) && fault.find(" reported") != std::string::npos) continue;
    is_unmet =
        (is_rounded(c) || !run.report.is_met()) && fault.find("outside the range:") != std::string::npos;
    if (!is_unmet || have_room(c)) return failure("points: " + kind_of(fault), fault);
  }
  return {is_unmet ? Outcome::UNMET : Outcome::MET, "", ""};
}

template <class Run, class Judge_mesh>
Verdict judge_with(const Soak_case& c, Run run, Judge_mesh judge_mesh) {
  const auto first = run(c, 1);
  const Verdict verdict = judge_mesh(c, first);
  if (verdict.outcome == Outcome::FAILED || c.threads == 1) return verdict;
  const auto second = run(c, c.threads);
  if (!are_same(first.mesh, second.mesh))
    return failure("other bits with threads", std::to_string(c.threads));
  return verdict;
}

} // namespace

Verdict judge(const Soak_case& c) {
  try {
    if (c.mode == Mode::PSLG) return judge_with(c, mesh_graph_of, judge_graph_mesh);
    return judge_with(c, mesh_points_of, judge_points_mesh);
  } catch (const std::bad_alloc&) {
    return failure("memory", "std::bad_alloc");
  } catch (const std::exception& error) {
    return judge_refusal(c, error.what());
  }
}

} // namespace soak
