// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/Gaussian_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Corner_warper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_corner_warper {

namespace {

using namespace quadtree_test;
namespace internal = CGAL::Quadtree_mesh_2::internal;
using CGAL::Parallel_tag;
using CGAL::Sequential_tag;
using internal::Warped_mesh;
using internal::Wide_integer;
using Point = Fixed_64_traits::Point_2;
using Rational = CGAL::Exact_rational;

constexpr std::uint64_t root = std::uint64_t(1) << 62;

/// Points in the middle half of the root, 2^9 units or more apart in a coordinate.
std::vector<Point> inner_points(const Input& input) {
  std::vector<Point> points;
  for (const Raw_point& p : input.points)
    points.push_back({root / 4 + (p.x >> 10 << 9), root / 4 + (p.y >> 10 << 9)});
  return points;
}

/// Angles are at least atan(12/29) and at most a right angle and atan(5/12): neither is negative then.
template <class Number>
std::array<Number, 2> slacks_of_angle(const Number& ux, const Number& uy, const Number& vx,
                                      const Number& vy) {
  const Number dot = ux * vx + uy * vy, cross = ux * vy - uy * vx;
  return {Number(29 * cross - 12 * dot), Number(12 * dot + 5 * cross)};
}

template <class Number, class Place>
bool has_good_angles(const std::array<Place, 3>& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Place &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
    for (const Number& slack : slacks_of_angle<Number>(Number(b.x) - Number(a.x), Number(b.y) - Number(a.y),
                                                       Number(c.x) - Number(a.x), Number(c.y) - Number(a.y)))
      if (slack < 0) return false;
  }
  return true;
}

/// Triangles are counterclockwise, meet at whole sides, and fill the root.
void check_conformity(const Warped_mesh& mesh) {
  struct Edge {
    std::uint64_t a_and_b; // a < b
    int turn;
    std::size_t a() const { return static_cast<std::size_t>(a_and_b >> 32); }
    std::size_t b() const { return static_cast<std::size_t>(a_and_b & 0xffffffff); }
    bool operator<(const Edge& e) const { return a_and_b < e.a_and_b; }
  };
  std::vector<Edge> edges;
  Wide_integer doubled_area = 0;
  std::size_t inverted = 0;
  for (const auto& t : mesh.triangles) {
    const auto &a = mesh.places[t[0]], &b = mesh.places[t[1]], &c = mesh.places[t[2]];
    const auto ux = std::int64_t(b.x - a.x), uy = std::int64_t(b.y - a.y);
    const auto vx = std::int64_t(c.x - a.x), vy = std::int64_t(c.y - a.y);
    const Wide_integer cross = Wide_integer(ux) * vy - Wide_integer(uy) * vx;
    inverted += cross <= 0;
    doubled_area += cross;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t p = t[k].value(), q = t[(k + 1) % 3].value();
      edges.push_back(p < q ? Edge{p << 32 | q, 1} : Edge{q << 32 | p, -1});
    }
  }
  CHECK(inverted == 0);
  CHECK((doubled_area == Wide_integer(root) * root * 2));
  std::sort(edges.begin(), edges.end());
  std::size_t wrong = 0;
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    int sum = edges[i].turn;
    for (j = i + 1; j < edges.size() && !(edges[i] < edges[j]); ++j) sum += edges[j].turn;
    const auto &p = mesh.places.values()[edges[i].a()], &q = mesh.places.values()[edges[i].b()];
    const bool is_border =
        (p.x == q.x && (p.x == 0 || p.x == root)) || (p.y == q.y && (p.y == 0 || p.y == root));
    wrong += is_border ? j - i != 1 : j - i != 2 || sum != 0;
  }
  CHECK(wrong == 0);
}

void check_mesh(const Warped_mesh& mesh, const std::vector<Point>& points) {
  check_conformity(mesh);
  REQUIRE(mesh.vertex_of_point.size() == points.size());
  std::size_t lost = 0, bad = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& place = mesh.places[mesh.vertex_of_point[i]];
    lost += place.x != points[i].x() || place.y != points[i].y();
  }
  CHECK(lost == 0);
  if (points.empty()) return; // two halves of the root, whose products would be too long here
  struct Place {
    std::int64_t x, y;
  };
  for (const auto& t : mesh.triangles) {
    std::array<Place, 3> places;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& g = mesh.places[t[k]];
      places[k] = {std::int64_t(g.x), std::int64_t(g.y)};
    }
    bad += !has_good_angles<Wide_integer>(places);
  }
  CHECK(bad == 0);
}

bool are_same(const Warped_mesh& a, const Warped_mesh& b) {
  return a.places == b.places && a.triangles == b.triangles && a.vertex_of_point == b.vertex_of_point;
}

/// A place that depends on that of the corner that is moved.
struct Moving_place {
  int x, y;
  bool is_corner;
};
struct Rational_place {
  Rational x, y;
};
struct Cell {
  Rational x0, x1, y0, y1;
};

/// The slacks of all angles of a triangle with the corner at (x, y).
std::array<Rational, 6> slacks(const std::array<Moving_place, 3>& t, const Rational& x, const Rational& y) {
  std::array<Rational_place, 3> p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = t[k].is_corner ? Rational_place{x, y} : Rational_place{Rational(t[k].x), Rational(t[k].y)};
  std::array<Rational, 6> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3];
    const auto two = slacks_of_angle<Rational>(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
    result[2 * k] = two[0], result[2 * k + 1] = two[1];
  }
  return result;
}

/// Whether the Bernstein coefficients of all slacks are not negative in a cell. Slacks have degree two at most in x
/// and in y: they are given by their values at the ends and in the middle.
bool is_certainly_good(const std::array<Moving_place, 3>& t, const Cell& c) {
  const std::array<Rational, 3> x{c.x0, Rational((c.x0 + c.x1) / 2), c.x1},
      y{c.y0, Rational((c.y0 + c.y1) / 2), c.y1};
  std::array<std::array<std::array<Rational, 6>, 3>, 3> value;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) value[i][j] = slacks(t, x[i], y[j]);
  const auto middle = [](const Rational& a, const Rational& m, const Rational& b) {
    return Rational(2 * m - (a + b) / 2);
  };
  for (std::size_t s = 0; s < 6; ++s) {
    for (auto& row : value) row[1][s] = middle(row[0][s], row[1][s], row[2][s]);
    for (std::size_t j = 0; j < 3; ++j)
      value[1][j][s] = middle(value[0][j][s], value[1][j][s], value[2][j][s]);
    for (const auto& row : value)
      for (const auto& coefficients : row)
        if (coefficients[s] < 0) return false;
  }
  return true;
}

bool is_proved(const std::array<Moving_place, 3>& t, const Cell& c, int depth) {
  if (is_certainly_good(t, c)) return true;
  if (depth == 0) return false;
  const Rational x = (c.x0 + c.x1) / 2, y = (c.y0 + c.y1) / 2;
  return is_proved(t, {c.x0, x, c.y0, y}, depth - 1) && is_proved(t, {x, c.x1, c.y0, y}, depth - 1) &&
         is_proved(t, {c.x0, x, y, c.y1}, depth - 1) && is_proved(t, {x, c.x1, y, c.y1}, depth - 1);
}

/// Both triangles of the square with the moved corner and the three other corners, counterclockwise.
bool is_proved(const std::array<Moving_place, 3>& others, bool is_cut_from_corner, const Cell& cell) {
  const Moving_place p{0, 0, true};
  const auto& [a, b, c] = others;
  constexpr int depth = 8;
  return is_cut_from_corner ? is_proved({p, a, b}, cell, depth) && is_proved({p, b, c}, cell, depth)
                            : is_proved({p, a, c}, cell, depth) && is_proved({a, b, c}, cell, depth);
}

} // namespace

TEST_CASE("Angles of warped squares are proved to keep the bounds", "[corner_warper]") {
  const Rational none(0), cut = Rational(5) / 24, half = Rational(1) / 2;
  const Cell all{none, half, none, half}, low{none, cut, none, half}, high{cut, half, none, half};
  CHECK(is_proved({{{1, 0, false}, {1, 1, false}, {0, 1, false}}}, true, all));
  CHECK(is_proved({{{-1, 0, false}, {-1, -1, false}, {0, -1, false}}}, false, all));
  CHECK(is_proved({{{0, 1, false}, {-1, 1, false}, {-1, 0, false}}}, true, low));
  CHECK(is_proved({{{0, 1, false}, {-1, 1, false}, {-1, 0, false}}}, false, high));
  // No more than that.
  CHECK(!is_proved({{{-1, 0, false}, {-1, -1, false}, {0, -1, false}}}, true, all));
  CHECK(!is_proved({{{0, 1, false}, {-1, 1, false}, {-1, 0, false}}}, true,
                   {none, cut + Rational(1) / 999, none, half}));
  CHECK(internal::is_joined_beside(5, 24));
  CHECK(!internal::is_joined_beside(6, 24));
}

TEST_CASE("Squares without points, in balanced trees, keep the bounds", "[corner_warper]") {
  struct Place {
    int x, y;
  };
  static constexpr std::array<Place, 8> places{
      {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}};
  for (std::uint8_t bits = 0; bits < 16; ++bits) {
    const auto& t = internal::square_template(internal::Square_form{bits});
    for (std::size_t i = 0; i < std::size_t(t.size); ++i) {
      std::array<Place, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k) triangle[k] = places[std::size_t(t.triangle[i][k])];
      CHECK(has_good_angles<int>(triangle));
    }
  }
}

TEST_CASE("Corners are warped to points", "[corner_warper]") {
  std::vector<Input> inputs = all_inputs();
  for (unsigned seed = 0; seed < 40; ++seed) inputs.push_back(small_random(seed));
  inputs.push_back(uniform(3000, 5));
  for (const Input& input : inputs) {
    CAPTURE(input.name);
    const auto points = inner_points(input);
    const Warped_mesh mesh = internal::Corner_warper<Sequential_tag>::run(points);
    check_mesh(mesh, points);
    CHECK(are_same(mesh, internal::Corner_warper<Parallel_tag>::run(points)));
  }
}

TEST_CASE("Leaves of points are in proportion to the distance of their neighbors", "[corner_warper]") {
  using Separated = internal::Separated_quadtree<Sequential_tag>;
  std::vector<Input> inputs = all_inputs();
  for (unsigned seed = 0; seed < 40; ++seed) inputs.push_back(small_random(seed));
  for (const Input& input : inputs) {
    CAPTURE(input.name);
    const auto points = inner_points(input);
    const auto tree = Separated::of(points);
    CHECK(tree.is_valid());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double side = std::ldexp(1.0, 62 - tree.level(tree.leaf(CGAL::Quadtree_mesh_2::Point_index(i))));
      double nearest = double(root);
      for (const Point& q : points)
        if (q != points[i])
          nearest = std::min(nearest, std::max(std::fabs(double(q.x()) - double(points[i].x())),
                                               std::fabs(double(q.y()) - double(points[i].y()))));
      REQUIRE(side <= 2 * nearest);
      REQUIRE((side == double(root / 8) || 8 * side > nearest));
    }
  }
}

TEST_CASE("Points anywhere in their leaves", "[corner_warper]") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    std::vector<Point> points;
    const auto coordinate =
        [&] { // often in the middle of squares, on their sides, or where the diagonal changes
          const std::uint64_t unit = root >> (4 + random() % 5);
          static constexpr std::array<double, 6> places{0, 0.5, 5.0 / 24, 19.0 / 24, 1, 0.4999999};
          const std::uint64_t base = root / 4 + random() % (root / 2 / unit) * unit;
          const double place = random() % 2 == 0 ? places[random() % 6] : double(random() >> 11) * 0x1p-53;
          return std::min(base + std::uint64_t(place * double(unit)), 3 * (root / 4) - 1);
        };
    for (unsigned k = 0; k < 1 + unsigned(i) % 4; ++k) {
      const std::uint64_t x = coordinate();
      points.push_back({x, coordinate()});
    }
    check_mesh(internal::Corner_warper<Sequential_tag>::run(points), points);
  }
}

TEST_CASE("Points are refused that are too near each other for the grid", "[corner_warper]") {
  const auto run = [](std::uint64_t distance) {
    return internal::Corner_warper<Sequential_tag>::run(
        {{root / 2, root / 2}, {root / 2 + distance, root / 2}});
  };
  CHECK_THROWS_AS(run(1), std::invalid_argument);
  const std::vector<Point> points{{root / 2 - 3, root / 2 + 5}, {root / 2 + 1, root / 2 + 5}};
  check_mesh(internal::Corner_warper<Sequential_tag>::run(points), points);
}

} // namespace test_corner_warper
