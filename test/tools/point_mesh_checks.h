// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_POINT_MESH_CHECKS_H
#define QUADTREE_MESH_2_TEST_POINT_MESH_CHECKS_H

// What must hold for every mesh of points, found out without the mesher's code.

#include <CGAL/Exact_rational.h>
#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace point_mesh_test {

using Options = CGAL::Point_set_mesh_options_2;
using Report = CGAL::Point_set_mesh_report_2;
using Mode = Options::Mode;
using Real = long double; // has room for the difference of any two coordinates of 62 bits

template <class Coordinate>
CGAL::Exact_rational to_rational(const Coordinate& c) {
  if constexpr (std::is_floating_point_v<Coordinate>)
    return CGAL::Exact_rational(c);
  else if constexpr (std::is_integral_v<Coordinate>)
    return CGAL::Exact_rational(static_cast<long>(c));
  else
    return CGAL::Exact_rational(c.exact());
}

/// Rounded once.
template <class Coordinate>
Real difference(const Coordinate& a, const Coordinate& b) {
  if constexpr (std::is_arithmetic_v<Coordinate>)
    return Real(a) - Real(b);
  else
    return Real(CGAL::to_double(CGAL::Exact_rational(to_rational(a) - to_rational(b))));
}

/// In degrees.
template <class Point>
Real angle_at(const Point& a, const Point& b, const Point& c) {
  const Real ux = difference(b.x(), a.x()), uy = difference(b.y(), a.y()), vx = difference(c.x(), a.x()),
             vy = difference(c.y(), a.y());
  return std::atan2(ux * vy - uy * vx, ux * vx + uy * vy) * 180 / 3.14159265358979323846264338L;
}

/// Whether the angle b, a, c is less than 90 degrees; exact.
template <class Point>
bool is_acute_at(const Point& a, const Point& b, const Point& c) {
  const Real x = difference(b.x(), a.x()) * difference(c.x(), a.x()),
             y = difference(b.y(), a.y()) * difference(c.y(), a.y());
  if (x + y > 1e-14L * (std::fabs(x) + std::fabs(y))) return true; // ten times what doubles lose
  const auto d = [](const auto& p, const auto& q) {
    return CGAL::Exact_rational(to_rational(p) - to_rational(q));
  };
  return d(b.x(), a.x()) * d(c.x(), a.x()) + d(b.y(), a.y()) * d(c.y(), a.y()) > 0;
}

template <class Point>
bool is_acute(const Point& a, const Point& b, const Point& c) {
  return is_acute_at(a, b, c) && is_acute_at(b, c, a) && is_acute_at(c, a, b);
}

/// By how many degrees an angle that the mesher measures in doubles may differ from the true one.
constexpr Real rounding = 1e-12L;

/// What is promised for the angles of a mesh, in degrees.
struct Promise {
  Real least = 0, largest = 180;
  bool is_acute = false;

  static Promise of(const Options& o) {
    switch (o.mode()) {
    case Mode::BOUNDED_ANGLES:
      return {o.least_angle_in_degrees(), o.largest_angle_in_degrees(), true};
    case Mode::ACUTE:
      return {0, 90, true};
    case Mode::LEAST_ANGLE:
      return {20.7L, 180, false};
    case Mode::WARPED_SQUARES:
      return {22.47L, 112.63L, false};
    }
    return {};
  }
  bool holds(Real least_angle, Real largest_angle) const {
    return least_angle >= least - rounding && largest_angle <= largest + rounding;
  }
};

/// What a mesh was made in, which tells how far from a straight border its vertices may be. A mesh over doubles may
/// have been made in other numbers: of words or exact ones.
enum class Made_in { COORDINATES, WORDS, EXACT_NUMBERS };

/// For a mesh that was not rounded.
template <class Point>
constexpr Made_in numbers_of() {
  using Coordinate = std::decay_t<decltype(std::declval<Point>().x())>;
  return std::is_integral_v<Coordinate>         ? Made_in::WORDS
         : std::is_floating_point_v<Coordinate> ? Made_in::COORDINATES
                                                : Made_in::EXACT_NUMBERS;
}

/// Collects what is wrong with a mesh.
template <class Mesh>
class Checker {
public:
  using Point = typename Mesh::Point_2;
  using Coordinate = std::decay_t<decltype(std::declval<Point>().x())>;

  Checker(const Mesh& mesh, const std::vector<Point>& points, const Options& options, const Report& report,
          Made_in made_in)
      : mesh_(mesh), points_(points), options_(options), report_(report), promise_(Promise::of(options)),
        made_in_(made_in) {}

  const std::vector<std::string>& run() {
    check_by_mesh_quality();
    check_input();
    if (!faults_.empty()) return faults_;
    check_angles();
    check_report();
    if (!mesh_.triangles.empty()) check_domain();
    return faults_;
  }

private:
  const Mesh& mesh_;
  const std::vector<Point>& points_;
  const Options& options_;
  const Report& report_;
  Promise promise_;
  Made_in made_in_;
  std::vector<std::string> faults_;
  CGAL::Mesh_quality_2 quality_;
  std::size_t places_ = 0; ///< of input points

  void expect(bool condition, const std::string& fault) {
    if (!condition) faults_.push_back(fault);
  }
  template <class Number>
  static std::string text(Number n) {
    return std::to_string(n);
  }

  void check_by_mesh_quality() {
    CGAL::Pslg_2<Point> pslg;
    pslg.vertices = points_;
    quality_ = CGAL::mesh_quality_2(
        mesh_, pslg, CGAL::Mesh_quality_options_2().check_domain(CGAL::Mesh_quality_options_2::Domain::ANY));
    for (const std::string& e : quality_.errors) faults_.push_back("invalid: " + e);
  }

  /// Points are there, and of those at a place exactly one is in use.
  void check_input() {
    const std::size_t n = points_.size();
    expect(mesh_.number_of_input_vertices == n, "the number of input vertices is wrong");
    if (mesh_.points.size() < n) return faults_.push_back("input points are missing");
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i) {
      order[i] = i;
      expect(mesh_.points[i].x() == points_[i].x() && mesh_.points[i].y() == points_[i].y(),
             "point " + text(i) + " has moved");
    }
    std::vector<char> is_used(mesh_.points.size(), 0);
    for (const auto& t : mesh_.triangles)
      for (const auto v : t) is_used[std::size_t(v)] = 1;
    const auto less = [this](std::size_t i, std::size_t j) {
      const Point &p = points_[i], &q = points_[j];
      return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
    };
    std::sort(order.begin(), order.end(), less);
    for (std::size_t begin = 0, end; begin < n; begin = end) {
      std::size_t uses = 0;
      for (end = begin; end < n && !less(order[begin], order[end]); ++end)
        uses += is_used[order[end]] != 0 ? 1 : 0;
      ++places_;
      expect(uses == 1, "of the points at that of " + text(order[begin]) + " " + text(uses) + " are in use");
    }
  }

  void check_angles() {
    Real least = 180, largest = 0;
    std::size_t unmet = 0, thin = 0, nearly_thin = 0;
    for (const auto& t : mesh_.triangles) {
      const Point &a = mesh_.point(t[0]), &b = mesh_.point(t[1]), &c = mesh_.point(t[2]);
      const Real angles[] = {angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)};
      const Real low = *std::min_element(angles, angles + 3), high = *std::max_element(angles, angles + 3);
      least = std::min(least, low), largest = std::max(largest, high);
      const bool is_good = promise_.holds(low, high) && (!promise_.is_acute || is_acute(a, b, c));
      unmet += is_good ? 0 : 1;
      thin += is_good && high > 89.5L + rounding ? 1 : 0;
      nearly_thin += is_good && high > 89.5L - rounding ? 1 : 0;
    }
    // A mesh of doubles is measured in doubles by the mesher.
    expect(mesh_.triangles.empty() || std::fabs(report_.least_angle - least) < 1e-11L,
           "least angle " + text(report_.least_angle) + " reported, not " + text(least));
    expect(mesh_.triangles.empty() || std::fabs(report_.largest_angle - largest) < 1e-11L,
           "largest angle " + text(report_.largest_angle) + " reported, not " + text(largest));
    expect(unmet == report_.unmet_triangles.size(), text(unmet) + " triangles outside the range, " +
                                                        text(report_.unmet_triangles.size()) + " reported");
    expect(unmet == 0,
           text(unmet) + " triangles outside the range: angles " + text(least) + " to " + text(largest));
    if (options_.mode() == Mode::ACUTE)
      expect(thin <= report_.thin_triangles && report_.thin_triangles <= nearly_thin,
             text(thin) + " thin triangles, " + text(report_.thin_triangles) + " reported");
    else
      expect(report_.thin_triangles == 0, "thin triangles reported");
  }

  void check_report() {
    expect(report_.input_points == points_.size(), "input points miscounted");
    expect(report_.merged_points == points_.size() - places_,
           text(report_.merged_points) + " merged points reported, not " + text(points_.size() - places_));
    expect(report_.vertices == quality_.vertices, "vertices miscounted");
    expect(report_.triangles == quality_.triangles, "triangles miscounted");
    expect(report_.triangles <= report_.triangles_before_coarsening, "coarsening made triangles");
    expect(report_.certified_points <= places_, "more certified points than points");
    expect(options_.mode() == Mode::ACUTE || report_.clusters == 0, "clusters where there can be none");
    expect(report_.clusters > 0 || report_.thin_triangles == 0, "thin triangles without clusters");
    expect(report_.is_met() == report_.unmet_triangles.empty(), "is_met() is wrong");
    for (const double s : {report_.seconds.quadtree, report_.seconds.separate, report_.seconds.coarsen,
                           report_.seconds.convert})
      expect(s >= 0, "negative time");
  }

  // --- the domain: a square, a row of squares or a rectangle, with the points inside ---

  struct Place {
    Real x, y;
  };
  static Real cross(Place a, Place b, Place c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  static Real distance(Place a, Place b) { return std::hypot(a.x - b.x, a.y - b.y); }

  /// The border, counterclockwise, relative to its first vertex. Empty if it is not one ring.
  std::vector<Place> border() {
    std::map<std::size_t, std::size_t> next;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (!mesh_.neighbors[t][k].is_valid())
          next[std::size_t(mesh_.triangles[t][(k + 1) % 3])] = std::size_t(mesh_.triangles[t][(k + 2) % 3]);
    std::vector<Place> ring;
    if (next.empty()) return ring;
    const std::size_t first = next.begin()->first;
    const Point& origin = mesh_.points[first];
    std::size_t v = first;
    do {
      if (next.count(v) == 0) return {};
      const Point& p = mesh_.points[v];
      ring.push_back({difference(p.x(), origin.x()), difference(p.y(), origin.y())});
      expect(v >= points_.size(), "input point " + text(v) + " is on the border");
      v = next[v];
    } while (v != first && ring.size() <= next.size());
    if (ring.size() != next.size()) ring.clear();
    return ring;
  }

  /// The corners of the rectangle that a ring is: ends of the longest diagonal, and what is farthest from it.
  static std::array<Place, 4> corners_of(const std::vector<Place>& ring) {
    const auto farthest = [&](auto measure) {
      return *std::max_element(ring.begin(), ring.end(),
                               [&](Place p, Place q) { return measure(p) < measure(q); });
    };
    Place a = ring[0], c = a;
    for (int i = 0; i < 2; ++i) {
      a = farthest([&](Place p) { return distance(p, c); });
      c = farthest([&](Place p) { return distance(p, a); });
    }
    return {a, farthest([&](Place p) { return -cross(a, c, p); }), c,
            farthest([&](Place p) { return cross(a, c, p); })};
  }

  /// What vertices of the border are rounded to, once for each time they were moved along it, and once more if the
  /// mesh was rounded to doubles.
  Real unit_of_border(Real length) const {
    switch (made_in_) {
    case Made_in::WORDS:
      return 1;
    case Made_in::EXACT_NUMBERS: // to a share of the way
      return length * 0x1p-30L + step_of_doubles();
    case Made_in::COORDINATES:
      break;
    }
    return step_of_doubles();
  }

  /// Between doubles at the vertex that is farthest from the origin; 0 if coordinates are no doubles.
  Real step_of_doubles() const {
    Real largest = 0;
    if constexpr (std::is_floating_point_v<Coordinate>)
      for (const Point& p : mesh_.points)
        largest = std::max({largest, std::fabs(Real(p.x())), std::fabs(Real(p.y()))});
    return largest * 0x1p-52L;
  }

  void check_domain() {
    const std::vector<Place> ring = border();
    if (ring.empty()) return faults_.push_back("the border is not one ring");
    const std::array<Place, 4> q = corners_of(ring);
    const Real length = distance(q[0], q[1]), width = distance(q[1], q[2]);
    const Real unit = unit_of_border(std::max(length, width)), slack = 16 * unit;
    expect(std::fabs(distance(q[0], q[2]) - distance(q[1], q[3])) <= 4 * slack &&
               std::fabs(length - distance(q[2], q[3])) <= 4 * slack &&
               std::fabs(width - distance(q[3], q[0])) <= 4 * slack,
           "the domain is no rectangle");
    Real farthest = 0;
    for (const Place& p : ring) {
      Real nearest = std::numeric_limits<Real>::infinity();
      for (std::size_t k = 0; k < 4; ++k)
        nearest =
            std::min(nearest, std::fabs(cross(q[k], q[(k + 1) % 4], p)) / distance(q[k], q[(k + 1) % 4]));
      farthest = std::max(farthest, nearest);
    }
    expect(farthest <= slack, "a vertex of the border is " + text(farthest / unit) + " units from all sides");
    Real area = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) area += cross(ring[0], ring[i], ring[i + 1]) / 2;
    expect(std::fabs(area - length * width) <= 4 * slack * (length + width), "the border goes around twice");
    check_shape(length, width, slack);
  }

  void check_shape(Real length, Real width, Real slack) {
    if (options_.mode() == Mode::LEAST_ANGLE) return;
    const bool is_row =
        options_.mode() == Mode::BOUNDED_ANGLES && options_.mesh_domain() == Options::Domain::ROW;
    const Real squares = std::max(length, width) / std::min(length, width);
    if (is_row)
      expect(std::fabs(squares - std::round(squares)) <= 4 * squares * slack / std::min(length, width),
             "the row is not one of squares");
    else
      expect(std::fabs(length - width) <= slack, "the domain is no square");
  }
};

template <class Mesh>
std::vector<std::string> faults_of(const Mesh& mesh, const std::vector<typename Mesh::Point_2>& points,
                                   const Options& options, const Report& report,
                                   Made_in made_in = numbers_of<typename Mesh::Point_2>()) {
  return Checker<Mesh>(mesh, points, options, report, made_in).run();
}

} // namespace point_mesh_test

#endif // QUADTREE_MESH_2_TEST_POINT_MESH_CHECKS_H
