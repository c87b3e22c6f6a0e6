// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_coordinate_map.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>
#ifdef CGAL_USE_GMP
#include <CGAL/Gmpq.h>
#endif

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <tuple>
#include <type_traits>
#include <vector>

namespace test_exact_quadtree_traits_2 {

using namespace quadtree_test;
using CGAL::Quadtree_mesh_2::Point_error;
using CGAL::Quadtree_mesh_2::Point_index;
using CGAL::Quadtree_mesh_2::internal::Long_word;
namespace internal = CGAL::Quadtree_mesh_2::internal;

namespace {

using FT = CGAL::Epeck::FT;
using Point = CGAL::Epeck::Point_2;

template <class Number>
Number power(int base, int exponent) {
  Number result(1);
  for (int i = 0; i < exponent; ++i) result *= Number(base);
  return result;
}

// With assertions, CGAL's MP_Float checks itself by shifting negative numbers, which
// -fsanitize=undefined reports; so builds with assertions do without it.
#ifdef NDEBUG
using Field_without_integers = CGAL::Quotient<CGAL::MP_Float>;
#else
using Field_without_integers = CGAL::Exact_rational;
#endif

using Exact_kernels =
    std::tuple<CGAL::Epeck,
#ifdef CGAL_USE_GMP
               CGAL::Simple_cartesian<CGAL::Gmpq>, CGAL::Simple_cartesian<CGAL::Lazy_exact_nt<CGAL::Gmpq>>,
#endif
               CGAL::Simple_cartesian<CGAL::Exact_rational>, CGAL::Simple_cartesian<Field_without_integers>,
               CGAL::Simple_cartesian<CGAL::Quotient<Long_word>>>;

/// Multiplies by a power of two of any size.
template <class Number>
Number scaled(Number v, int exponent) {
  const Number factor = power<Number>(2, std::abs(exponent));
  return exponent < 0 ? Number(v / factor) : Number(v * factor);
}

/// Checks what the concept says of a grid, with the arithmetic of the kernel.
template <class Traits>
void check_grid(const typename Traits::Construct_grid_2& construct,
                const std::vector<typename Traits::Point_2>& points, int refinements = 1) {
  using Number = std::decay_t<decltype(points[0].x())>;
  auto grid = construct(points);
  const Long_word one = 1;
  for (int i = 0; i <= refinements; ++i) {
    const int depth = grid.depth();
    CAPTURE(depth);
    const Long_word side = one << depth, quarter = side / 4;
    const auto low = grid.point({0, 0}), high = grid.point({side, side}), first = grid.point({1, 1});
    REQUIRE((high.x() - low.x() == high.y() - low.y()));
    REQUIRE(grid.is_in_root(low));
    REQUIRE_FALSE(grid.is_in_root(high));
    const Number unit = first.x() - low.x();
    REQUIRE((scaled(unit, depth) == high.x() - low.x()));
    for (const auto& p : points) {
      REQUIRE(grid.is_in_root(p));
      const auto g = grid.grid_point(p);
      REQUIRE((quarter <= g.x && g.x <= 3 * quarter && quarter <= g.y && g.y <= 3 * quarter));
      const auto corner = grid.point(g);
      const auto upper = grid.point({g.x + 1, g.y + 1});
      REQUIRE((corner.x() <= p.x() && p.x() < upper.x()));
      REQUIRE((corner.y() <= p.y() && p.y() < upper.y()));
      REQUIRE((upper.x() - corner.x() == unit && upper.y() - corner.y() == unit));
      REQUIRE(grid.grid_point(corner) == g);
    }
    REQUIRE(grid.refine());
    REQUIRE(grid.depth() == 2 * depth);
    // The root stays where it is.
    REQUIRE(grid.point({0, 0}) == low);
    REQUIRE(grid.point({one << 2 * depth, one << 2 * depth}) == high);
  }
}

/// Refines the grid until two points are told apart; returns the depth.
template <class Grid, class Point_2>
int depth_that_separates(Grid grid, const Point_2& p, const Point_2& q) {
  while (grid.grid_point(p) == grid.grid_point(q)) REQUIRE(grid.refine());
  return grid.depth();
}

template <class Kernel>
std::vector<typename Kernel::Point_2> mixed_points() {
  using Number = typename Kernel::FT;
  std::mt19937 random(7);
  std::vector<typename Kernel::Point_2> points;
  const auto integer = [&] { return Number(static_cast<int>(random() % 2001) - 1000); };
  for (int i = 0; i < 30; ++i) {
    const Number divisor(static_cast<int>(random() % 100) + 1);
    // Doubles, quotients, and mixtures; below and above 0.
    points.emplace_back(i % 3 == 0 ? integer() : Number(integer() / divisor),
                        i % 2 == 0 ? integer() : Number(integer() / Number(i + 1)));
  }
  return points;
}

} // namespace

TEST_CASE("Operations on long words agree with those on short ones", "[traits]") {
  using Long = internal::Word_operations<Long_word>;
  using Short = internal::Word_operations<std::uint64_t>;
  std::mt19937_64 random(8);
  for (int trial = 0; trial < 1000; ++trial) {
    const std::uint64_t a = random() >> trial % 64;
    const std::uint64_t b = trial % 3 == 0 ? random() : a ^ random() >> random() % 64;
    const int i = static_cast<int>(random() % 64);
    const int shift = static_cast<int>(random() % 300);
    const Long_word common = Long_word(random()) << (shift + 64);
    const Long_word x = common + (Long_word(a) << shift), y = common + (Long_word(b) << shift);
    REQUIRE(Long::width_of_difference(a, b) == Short::width_of_difference(a, b));
    REQUIRE(Long::width_of_difference(x, y) == (a == b ? 0 : shift + Short::width_of_difference(a, b)));
    REQUIRE(Long::width_of_difference(x, 0) == static_cast<int>(msb(x)) + 1);
    REQUIRE(Long::bit(x, i + shift) == Short::bit(a, i));
    REQUIRE(Long::without_low_bits(x, i + shift) ==
            Long_word(common + (Long_word(Short::without_low_bits(a, i)) << shift)));
  }
  CHECK(Long::width_of_difference(0, 0) == 0);
  CHECK(Long::without_low_bits(5, 100) == 0);
  CHECK(Long::bit(5, 1000) == 0);
}

TEST_CASE("Doubles are rounded down to integers of any length", "[traits]") {
  for (double v : {0.0, 1.0, -1.0, 0.75, -0.75, 1e300, -1e300, 5e-324, -5e-324, 123456.789, -123456.789})
    for (int shift : {-2000, -1075, -300, -53, -10, -1, 0, 1, 9, 10, 11, 60, 1074, 2000}) {
      CAPTURE(v, shift);
      const CGAL::Exact_rational exact = scaled(CGAL::Exact_rational(v), shift);
      const Long_word floor = internal::floor_of_scaled(v, shift);
      CHECK(floor == internal::Floor_of_scaled<CGAL::Exact_rational>(shift)(CGAL::Exact_rational(v)));
      // The path for fields of which nothing more is known.
      CHECK(floor == internal::Floor_of_scaled<CGAL::Exact_rational, false>(shift)(CGAL::Exact_rational(v)));
      const CGAL::Exact_rational back = internal::Scaled_integer{floor, 0}.to_exact(CGAL::Exact_rational(1));
      CHECK((back <= exact && exact < back + 1));
    }
}

TEST_CASE("Integers of any length are rounded to the nearest double", "[traits]") {
  const auto nearest = [](const Long_word& integer, int exponent) {
    return internal::Scaled_integer{integer, exponent}.to_double();
  };
  const Long_word half = Long_word(1) << 200; // of the last bit of what follows
  const Long_word even = Long_word(1) << 253, odd = even + 2 * half;
  CHECK(nearest(even + half, -253) == 1);
  CHECK(nearest(even + half + 1, -253) == 1 + std::ldexp(1.0, -52));
  CHECK(nearest(odd + half - 1, -253) == 1 + std::ldexp(1.0, -52));
  CHECK(nearest(-odd - half, -253) == -1 - std::ldexp(1.0, -51));
  CHECK(nearest(3, -1075) == std::ldexp(3.0, -1075));
  CHECK(nearest(Long_word(5) << 2000, -2000) == 5);
  std::mt19937_64 random(9);
  for (int i = 0; i < 1000; ++i) {
    const double v = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 1000) - 500);
    CHECK(nearest(internal::floor_of_scaled(v, 600), -600) == v);
  }
}

TEMPLATE_TEST_CASE("Logarithms are rounded down", "[traits]", CGAL::Exact_rational, Field_without_integers) {
  for (int k : {-3000, -1075, -1074, -1, 0, 1, 52, 1023, 1024, 3000}) {
    const TestType v = scaled(TestType(1), k);
    CHECK(internal::power_of_two<TestType>(k) == v);
    CHECK(internal::floor_of_logarithm(v) == k);
    CHECK(internal::floor_of_logarithm(TestType(v * TestType(7) / TestType(4))) == k);
    CHECK(internal::floor_of_logarithm(TestType(v * TestType(2) / TestType(3))) == k - 1);
  }
}

TEMPLATE_LIST_TEST_CASE("Exact grids put points into the middle half of a power of two", "[traits]",
                        Exact_kernels) {
  using Traits = CGAL::Exact_quadtree_traits_2<TestType>;
  using Number = typename TestType::FT;
  const auto construct = Traits().construct_grid_2_object();
  const auto points = mixed_points<TestType>();
  check_grid<Traits>(construct, points, 2);
  // Of all sizes and far from 0, and with little between them.
  const Number third = Number(1) / Number(3);
  for (int scale : {-1200, -70, 1, 40, 1500})
    for (int shift : {-900, 0, 100, 2000}) {
      CAPTURE(scale, shift);
      std::vector<typename TestType::Point_2> moved;
      for (std::size_t i = 0; i < 5; ++i)
        moved.emplace_back(Number(scaled(points[i].x(), scale) + scaled(third, shift)),
                           Number(scaled(points[i].y(), scale) - scaled(Number(1), shift)));
      check_grid<Traits>(construct, moved);
    }
  check_grid<Traits>(construct, {});
  check_grid<Traits>(construct, {{third, scaled(third, 2000)}});
  check_grid<Traits>(construct, {{third, third}, {third, third}});
}

TEMPLATE_TEST_CASE("Grids of long words exist for doubles too", "[traits]", CGAL::Epick,
                   CGAL::Simple_cartesian<double>) {
  using Traits = CGAL::Exact_quadtree_traits_2<TestType>;
  using Double_point = typename TestType::Point_2;
  const auto construct = Traits().construct_grid_2_object();
  // The grid is that of the same points in an exact kernel.
  std::mt19937_64 random(10);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Double_point> doubles;
    std::vector<Point> exact;
    for (int i = 0; i < 20; ++i) {
      const auto coordinate = [&] {
        return std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 20) * (trial - 25));
      };
      const double x = coordinate(), y = -coordinate();
      doubles.emplace_back(x, y);
      exact.emplace_back(x, y);
    }
    auto grid = construct(doubles);
    auto exact_grid = Exact_traits().construct_grid_2_object()(exact);
    for (int i = 0; i < 3; ++i, grid.refine(), exact_grid.refine())
      for (std::size_t j = 0; j < doubles.size(); ++j) {
        REQUIRE(grid.is_in_root(doubles[j]));
        REQUIRE(grid.grid_point(doubles[j]) == exact_grid.grid_point(exact[j]));
      }
  }
  const std::vector<Double_point> points{{1, 1}, {1e-300, 0}, {-5e-324, 0}, {2e-300, 0}};
  auto grid = construct(points);
  for (const Double_point& p : points) CHECK(grid.is_in_root(p));
  CHECK(depth_that_separates(grid, points[1], points[3]) == 62 * 32);
  CHECK(depth_that_separates(grid, points[2], Double_point(0, 0)) == 62);
  CHECK(grid.refine());
  CHECK(grid.point(grid.grid_point(Double_point(0.3, 0.7))) == Double_point(0.3, 0.7));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_FALSE(grid.is_in_root(Double_point(infinity, 0)));
  const auto kind_for = [&](const std::vector<Double_point>& bad) {
    try {
      construct(bad);
    } catch (const Point_error& error) {
      CHECK(error.point() == Point_index(1));
      return error.kind();
    }
    return Point_error::Kind::INDISTINGUISHABLE;
  };
  CHECK(kind_for({{0, 0}, {0, std::nan("")}}) == Point_error::Kind::NOT_FINITE);
  CHECK(kind_for({{0, 0}, {-infinity, 0}}) == Point_error::Kind::NOT_FINITE);
  CHECK(kind_for({{0, 0}, {1e305, 0}}) == Point_error::Kind::OUT_OF_RANGE);
}

TEST_CASE("Exact grids hold spirals of any depth", "[traits]") {
  for (int depth : {61, 900, 5000}) {
    CAPTURE(depth);
    std::vector<Point> points;
    FT r(1);
    for (int i = 0; i <= depth; ++i, r /= 2) {
      if (depth > 1000 && i % 500 != 0) continue;
      CGAL::exact(r);
      points.emplace_back(i % 2 == 0 ? r : -r, i % 4 < 2 ? r : -r);
    }
    auto grid = Exact_traits().construct_grid_2_object()(points);
    const Point zero(0, 0);
    CHECK(depth_that_separates(grid, points.back(), zero) >= depth);
    CHECK(depth_that_separates(grid, points.back(), zero) < 2 * depth + 62);
    while (grid.depth() < depth + 3) REQUIRE(grid.refine());
    // All coordinates are multiples of the unit.
    for (const Point& p : points) REQUIRE(grid.point(grid.grid_point(p)) == p);
  }
}

TEST_CASE("Exact grids tell all rationals apart", "[traits]") {
  const FT third = FT(1) / FT(3), near_third = third + FT(1) / power<FT>(10, 400);
  const FT huge = power<FT>(10, 400);
  const auto construct = Exact_traits().construct_grid_2_object();

  std::vector<Point> points{{third, -third}, {near_third, -third}, {0, 0}, {1, 1}};
  CHECK(depth_that_separates(construct(points), points[0], points[1]) == 62 * 32); // 2^-1329
  check_grid<Exact_traits>(construct, points, 6);

  // From numbers that no double is near to.
  points = {{huge, -huge}, {huge + third, huge}, {huge + near_third, -huge}, {-third, 0}, {-near_third, 0}};
  check_grid<Exact_traits>(construct, points, 6);
  CHECK(depth_that_separates(construct(points), points[0], points[2]) > 1328);
  CHECK(depth_that_separates(construct(points), points[3], points[4]) > 2657);

  // The least difference either side of a grid line.
  const FT tiny = scaled(FT(1), -5000);
  points = {{-1, -1}, {1, 1}, {0, 0}, {-tiny, tiny}, {-tiny / 3, tiny / 3}};
  auto grid = construct(points);
  const auto zero = grid.grid_point(points[2]), left = grid.grid_point(points[3]);
  CHECK((left.x == zero.x - 1 && left.y == zero.y));
  CHECK(left == grid.grid_point(points[4]));
  CHECK(depth_that_separates(grid, points[3], points[4]) > 5000);
}

TEST_CASE("Grid points have the same places in the meshing kernel by integers and by the numbers of theirs",
          "[traits]") {
  using Traits = CGAL::Exact_quadtree_traits_2<CGAL::Epeck>;
  using Geometry = Traits::Meshing_geometry_2;
  std::mt19937_64 random(7);
  for (const int offset : {-1, 0, 60}) // the logarithm of how far away; the map moves what is very far
    for (int refinements = 0; refinements <= 2; ++refinements) {
      const FT far = offset < 0 ? FT(0) : power<FT>(2, offset) + FT(1) / FT(3);
      const std::vector<Point> points{{far, -far}, {far + 1, FT(1) / 7 - far}};
      const internal::Coordinate_map<Traits, Geometry> map(points);
      auto grid = Traits().construct_grid_2_object()(points);
      for (int i = 0; i < refinements; ++i) grid.refine();
      for (int i = 0; i < 50; ++i) {
        // multiples of large and of small powers of two: doubles, sums of doubles, and longer ones
        const int zeros = static_cast<int>(random() % static_cast<unsigned>(grid.depth()));
        const auto word = [&] {
          return Long_word(((Long_word(random()) << grid.depth()) + random()) %
                           (Long_word(1) << (grid.depth() - zeros)))
                 << zeros;
        };
        const Traits::Grid_point g{word(), word()};
        const Geometry::Point by_integers = map.to_kernel(grid, g), by_numbers = map.to_kernel(grid.point(g));
        CHECK(by_integers == by_numbers);
        CHECK(by_integers.x.high() == by_numbers.x.high());
        CHECK(by_integers.is_double() == by_numbers.is_double());
      }
    }
}

TEST_CASE("Exact predicates of the meshing kernel are right at any size", "[traits]") {
  using Geometry = internal::Exact_geometry_2<CGAL::Simple_cartesian<CGAL::Exact_rational>>;
  using Number = CGAL::Exact_rational;
  const auto coordinate = [](const Number& v) { return Geometry::Coordinate(v); };
  std::mt19937_64 random(11);
  for (const int exponent : {0, -40, -300, -700, -2000}) { // products of doubles underflow from -512 on
    CAPTURE(exponent);
    const Number unit = scaled(Number(1), exponent);
    for (int i = 0; i < 200; ++i) {
      std::vector<std::array<Number, 2>> places;
      for (int k = 0; k < 4; ++k) // a small lattice: many ties
        places.push_back({Number(int(random() % 5)) * unit, Number(int(random() % 5)) * unit});
      if (i % 3 == 0) places[0] = {places[0][0] + Number(1), places[0][1] + Number(1)}; // far from the others
      std::vector<Geometry::Point> p;
      for (const auto& place : places) p.push_back({coordinate(place[0]), coordinate(place[1])});
      const Number area = (places[1][0] - places[0][0]) * (places[2][1] - places[0][1]) -
                          (places[1][1] - places[0][1]) * (places[2][0] - places[0][0]);
      CHECK(Geometry::orientation(p[0], p[1], p[2]) == static_cast<int>(CGAL::sign(area)));
      if (area > 0)
        CHECK(Geometry::is_in_circle(p[0], p[1], p[2], p[3]) ==
              (CGAL::side_of_oriented_circleC2(places[0][0], places[0][1], places[1][0], places[1][1],
                                               places[2][0], places[2][1], places[3][0],
                                               places[3][1]) == CGAL::ON_POSITIVE_SIDE));
    }
  }
}

TEST_CASE("Exact grids know what lies outside the root", "[traits]") {
  const std::vector<Point> points{{FT(1) / 3, 0}, {2, 1}};
  const auto grid = Exact_traits().construct_grid_2_object()(points);
  const FT huge = power<FT>(10, 400), tiny = FT(1) / huge;
  for (const FT& v : {huge, FT(-huge), FT(-1e300), FT(1e300), FT(huge / 3)}) {
    CHECK_FALSE(grid.is_in_root(Point(v, FT(1) / 3)));
    CHECK_FALSE(grid.is_in_root(Point(1, v)));
  }
  const Long_word side = Long_word(1) << grid.depth();
  const Point low = grid.point({0, 0}), high = grid.point({side, side});
  CHECK(grid.is_in_root(Point(low.x() + tiny, high.y() - tiny)));
  CHECK_FALSE(grid.is_in_root(Point(low.x() - tiny, low.y())));
  CHECK_FALSE(grid.is_in_root(Point(low.x(), high.y())));
}

TEST_CASE("Several threads may use one exact grid", "[traits]") {
  // All points share lazy numbers that no one has evaluated yet.
  FT x = FT(1) / 3, y = FT(1) / 7;
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i) {
    x = (x + FT(i)) / 3;
    y = y * FT(3) / 4 + x;
    points.emplace_back(x, y);
  }
  const std::vector<Point> ends{{-1000, -1000}, {1000, 1000}};
  const auto grid = Exact_traits().construct_grid_2_object()(ends);
  std::vector<std::vector<Exact_traits::Grid_point>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results)
    threads.emplace_back([&result, &points, &grid] {
      for (std::size_t i = points.size(); i-- > 0;) result.push_back(grid.grid_point(points[i]));
    });
  for (std::thread& t : threads) t.join();
  for (const auto& result : results) CHECK(result == results[0]);
}

} // namespace test_exact_quadtree_traits_2
