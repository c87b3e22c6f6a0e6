// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_framework.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <vector>

namespace test_quadtree_traits_2 {

using namespace quadtree_test;
using CGAL::Quadtree_mesh_2::Point_error;
using CGAL::Quadtree_mesh_2::Point_index;

namespace {

/// The order of shuffles by the definition, bit by bit.
template <class Grid_point>
bool less_shuffle_by_bits(const Grid_point& p, const Grid_point& q) {
  for (int bit = std::numeric_limits<typename Grid_point::Word>::digits - 1; bit >= 0; --bit) {
    if ((p.x >> bit & 1) != (q.x >> bit & 1)) return (p.x >> bit & 1) < (q.x >> bit & 1);
    if ((p.y >> bit & 1) != (q.y >> bit & 1)) return (p.y >> bit & 1) < (q.y >> bit & 1);
  }
  return false;
}

template <class Word>
std::vector<CGAL::Quadtree_mesh_2::Grid_point_2<Word>> random_grid_points(std::size_t n, int kind) {
  constexpr int bits = std::numeric_limits<Word>::digits;
  std::mt19937_64 random(static_cast<unsigned>(n) + static_cast<unsigned>(kind));
  const auto coordinate = [&](int shift) { return static_cast<Word>(random() >> (64 - bits) >> shift); };
  std::vector<CGAL::Quadtree_mesh_2::Grid_point_2<Word>> points(n);
  for (auto& p : points) {
    const int shift = kind == 0 ? 0 : kind == 1 ? static_cast<int>(random() % std::uint64_t(bits)) : bits - 4;
    p = {coordinate(shift), coordinate(shift)};
  }
  return points;
}

/// A model of QuadtreeTraits_2 that provides what the concept asks for and nothing else.
struct Quadtree_traits_archetype_2 {
  class Point_2 {
  public:
    explicit Point_2(std::uint32_t i) : place_(i) {}
    friend bool operator==(const Point_2& p, const Point_2& q) { return p.place_ == q.place_; }

  private:
    friend struct Quadtree_traits_archetype_2;
    std::uint32_t place_;
  };
  using Word = std::uint32_t;
  static constexpr int depth = 20;
  using Grid_point = CGAL::Quadtree_mesh_2::Grid_point_2<Word>;
  struct Meshing_geometry_2;

  struct Grid_2 {
    int depth() const { return Quadtree_traits_archetype_2::depth; }
    bool refine() { return false; }
    bool is_in_root(const Point_2& p) const { return p.place_ < 1u << depth(); }
    Grid_point grid_point(const Point_2& p) const { return {p.place_, p.place_ / 3}; }
    Point_2 point(const Grid_point& g) const { return Point_2(g.x); }
  };
  struct Construct_grid_2 {
    template <class PointRange>
    Grid_2 operator()(const PointRange&) const {
      return {};
    }
  };
  Construct_grid_2 construct_grid_2_object() const { return {}; }
};

} // namespace

TEST_CASE("Quadtrees need no more than the concept", "[traits]") {
  std::vector<Quadtree_traits_archetype_2::Point_2> points;
  for (std::uint32_t i = 0; i < 100; ++i) points.emplace_back(i * i);
  const CGAL::Balanced_quadtree<Quadtree_traits_archetype_2> tree(points);
  CHECK(tree.is_valid());
  CHECK(tree.locate(points[7]) == tree.leaf(Point_index(7)));
  CHECK(tree.corners(tree.root())[0] == points[0]);
}

TEMPLATE_TEST_CASE("Shuffle order agrees with interleaved bits", "[traits]", std::uint32_t, std::uint64_t) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  for (int kind = 0; kind < 3; ++kind)
    for (std::size_t n : {0u, 1u, 2u, 100u, 5000u}) {
      const auto points = random_grid_points<TestType>(n, kind);
      internal::Order expected(n);
      for (std::size_t i = 0; i < n; ++i) expected[i] = static_cast<std::uint32_t>(i);
      std::stable_sort(expected.begin(), expected.end(), [&](std::uint32_t i, std::uint32_t j) {
        return less_shuffle_by_bits(points[i], points[j]);
      });
      CHECK(internal::shuffle_order(points) == expected);
      for (std::size_t i = 1; i < n; ++i)
        REQUIRE(internal::less_shuffle(points[i - 1], points[i]) ==
                less_shuffle_by_bits(points[i - 1], points[i]));
    }
}

TEMPLATE_TEST_CASE("Grids contain their points and map corners back", "[traits]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  for (const Input& input : all_inputs()) {
    CAPTURE(input.name);
    const auto points = make_points<TestType>(input);
    const auto grid = TestType().construct_grid_2_object()(points);
    const int depth = grid.depth();
    const typename TestType::Word end = typename TestType::Word(1) << depth;
    for (const auto& p : points) {
      REQUIRE(grid.is_in_root(p));
      const auto g = grid.grid_point(p);
      REQUIRE((0 <= g.x && g.x < end && 0 <= g.y && g.y < end));
      // Corners of the square of level 30 that contains p are exact.
      const auto corner = internal::corner_of_square(g, 30, depth);
      CHECK(grid.grid_point(grid.point(corner)) == corner);
    }
    // The sides of the root: the lower one belongs to it, the upper one does not.
    CHECK(grid.is_in_root(grid.point({0, 0})));
    CHECK_FALSE(grid.is_in_root(grid.point({end, end})));
    // A finer grid divides the squares of the first.
    auto finer = grid;
    const bool is_refined = finer.refine();
    CHECK(is_refined == (finer.depth() > depth));
    for (const auto& p : points) {
      const auto g = finer.grid_point(p);
      CHECK(typename TestType::Word(g.x >> (finer.depth() - depth)) == grid.grid_point(p).x);
      CHECK(typename TestType::Word(g.y >> (finer.depth() - depth)) == grid.grid_point(p).y);
    }
  }
}

TEST_CASE("The filtered grid puts points into the middle half of a power of two", "[traits]") {
  using Point = Filtered_traits::Point_2;
  const std::uint64_t quarter = std::uint64_t(1) << 60;
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    // Boxes of all sizes, at the origin and far from it.
    const double size = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
    const double far = trial % 3 == 0 ? 0 : std::ldexp(size, static_cast<int>(random() % 60));
    std::uniform_real_distribution<double> coordinate(-far - size, -far + size);
    std::vector<Point> points;
    for (int i = 0; i < 20; ++i) {
      const double x = coordinate(random), y = coordinate(random);
      points.emplace_back(x, trial % 2 == 0 ? y : -y);
    }
    CAPTURE(size, far);
    const auto grid = Filtered_traits().construct_grid_2_object()(points);
    for (const Point& p : points) {
      REQUIRE(grid.is_in_root(p));
      const auto g = grid.grid_point(p);
      CHECK((quarter <= g.x && g.x <= 3 * quarter && quarter <= g.y && g.y <= 3 * quarter));
      // Doubles of such size are multiples of the unit unless they are near 0; all keep their order.
      for (const Point& q : points) {
        REQUIRE((g.x < grid.grid_point(q).x) <= (p.x() < q.x()));
        REQUIRE((g.y < grid.grid_point(q).y) <= (p.y() < q.y()));
      }
    }
    const std::uint64_t side = std::uint64_t(1) << 62;
    const Point low = grid.point({0, 0}), high = grid.point({side, side});
    int exponent = 0;
    CHECK(std::frexp(high.x() - low.x(), &exponent) == 0.5);
    CHECK(high.x() - low.x() == high.y() - low.y());
    CHECK(grid.is_in_root(low));
    CHECK_FALSE(grid.is_in_root(high));
  }
}

TEST_CASE("The filtered grid is exact for doubles of very different size", "[traits]") {
  using Point = Filtered_traits::Point_2;
  std::vector<Point> points;
  for (int i = 0; i < 59; ++i) points.emplace_back(std::ldexp(1.0, -i), -std::ldexp(3.0, -i - 2));
  const auto grid = Filtered_traits().construct_grid_2_object()(points);
  for (const Point& p : points) CHECK(grid.point(grid.grid_point(p)) == p);
  // Below the unit, points are in the unit square that contains them: above or below 0.
  const auto zero = grid.grid_point(Point(0, 0));
  CHECK(grid.grid_point(Point(1e-300, 1e-300)) == zero);
  const auto below = grid.grid_point(Point(-5e-324, -5e-324));
  CHECK((below.x == zero.x - 1 && below.y == zero.y - 1));
}

TEST_CASE("The filtered grid exists for tiny and huge coordinates", "[traits]") {
  using Point = Filtered_traits::Point_2;
  for (double s : {5e-324, 1e-300, 1.0, 1e300}) {
    CAPTURE(s);
    const std::vector<Point> points{{-s, s}, {s, 0}, {0, -s}};
    const auto grid = Filtered_traits().construct_grid_2_object()(points);
    for (const Point& p : points) REQUIRE(grid.is_in_root(p));
    CHECK(std::isfinite(grid.point({std::uint64_t(1) << 62, 0}).x()));
  }
  const std::vector<Point> one{{1e17, -3e-20}};
  CHECK(Filtered_traits().construct_grid_2_object()(one).is_in_root(one[0]));
}

TEST_CASE("Points that cannot be mapped are named", "[traits]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto kind_for = [](const std::vector<Filtered_traits::Point_2>& points) {
    try {
      Filtered_traits().construct_grid_2_object()(points);
    } catch (const Point_error& error) {
      CHECK(error.point() == Point_index(1));
      CHECK_FALSE(error.other().is_valid());
      CHECK(std::string(error.what()).find("point 1 ") != std::string::npos);
      return error.kind();
    }
    FAIL("no exception");
    return Point_error::Kind::INDISTINGUISHABLE;
  };
  CHECK(kind_for({{0, 0}, {0, std::nan("")}}) == Point_error::Kind::NOT_FINITE);
  CHECK(kind_for({{0, 0}, {-infinity, 0}}) == Point_error::Kind::NOT_FINITE);
  CHECK(kind_for({{0, 0}, {1e305, 0}}) == Point_error::Kind::OUT_OF_RANGE);

  const std::vector<Fixed_32_traits::Point_2> points{{0, 0}, {1, std::uint32_t(1) << 31}};
  CHECK_THROWS_AS(Fixed_32_traits().construct_grid_2_object()(points), Point_error);
  const std::vector<Fixed_64_traits::Point_2> wide{{std::uint64_t(1) << 62, 0}};
  CHECK_THROWS_AS(Fixed_64_traits().construct_grid_2_object()(wide), Point_error);
}

TEST_CASE("Distinct points on one grid point are named", "[traits]") {
  const std::vector<Filtered_traits::Point_2> points{{1, 1}, {1e-300, 0}, {0.5, 0}, {2e-300, 0}};
  try {
    CGAL::Quadtree_framework<Filtered_traits> framework(points);
    FAIL("no exception");
  } catch (const Point_error& error) {
    CHECK(error.kind() == Point_error::Kind::INDISTINGUISHABLE);
    CHECK(error.point() == Point_index(1));
    CHECK(error.other() == Point_index(3));
    CHECK(std::string(error.what()).find("points 1 and 3") != std::string::npos);
  }
}

TEST_CASE("Fixed points compare and print", "[traits]") {
  using Point = CGAL::Fixed_point_2<std::uint32_t>;
  CHECK(Point{1, 2} == Point{1, 2});
  CHECK(Point{1, 2} != Point{2, 1});
  CHECK(Point{1, 2} < Point{2, 1});
  CHECK(Point{1, 1} < Point{1, 2});
  std::ostringstream out;
  out << Point{1, 2};
  CHECK(out.str() == "1 2");
}

TEMPLATE_TEST_CASE("The fixed-point scale is exact where doubles allow it", "[traits]", std::uint32_t,
                   std::uint64_t) {
  using Scale = CGAL::Fixed_point_scale_2<TestType>;
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 200; ++trial) {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
    const double far = trial % 3 == 0 ? 0 : std::ldexp(size, static_cast<int>(random() % 12));
    std::uniform_real_distribution<double> coordinate(far - size, far + size);
    CGAL::Bbox_2 box;
    std::vector<std::array<double, 2>> points;
    for (std::size_t i = 0; i < 20; ++i) {
      points.push_back({coordinate(random), -coordinate(random)});
      box += CGAL::Bbox_2(points[i][0], points[i][1], points[i][0], points[i][1]);
    }
    const Scale scale(box);
    const TestType quarter = TestType(1) << (Scale::depth - 2);
    for (const auto& p : points) {
      const auto fixed = scale.to_fixed(p[0], p[1]);
      CHECK((quarter <= fixed.x() && fixed.x() <= 3 * quarter));
      CHECK((quarter <= fixed.y() && fixed.y() <= 3 * quarter));
      const auto back = scale.to_double(fixed);
      CHECK(std::fabs(back[0] - p[0]) <= scale.unit() / 2);
      CHECK(std::fabs(back[1] - p[1]) <= scale.unit() / 2);
      CHECK(scale.is_exact(back[0], back[1]));
      CHECK(scale.is_exact(p[0], p[1]) == (back == p));
      if (far >= 4 * size && Scale::depth == 62) CHECK(back == p); // no coordinate is near 0
    }
    // The unit is the smallest: with half of it, the box would not fit.
    const double extent = std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    if (far == 0) CHECK(extent / (scale.unit() / 2) > std::ldexp(1.0, Scale::depth - 1) - 3);
  }
  const std::vector<Filtered_traits::Point_2> single{{0.1, -7}};
  CHECK(Scale::of_points(single).is_exact(0.1, -7));
  const std::vector<Filtered_traits::Point_2> origin{{0, 0}};
  CHECK(Scale::of_points(origin).unit() == 0x1p-8);
  if (Scale::depth == 62) { // small ordinates beside large ones
    const Scale far(CGAL::Bbox_2(-6378144, 0, -6378137, 20.1));
    CHECK(far.is_exact(-6378139.65968186, 8.598028402130454));
    CHECK(far.is_exact(-6378143.20592434, 20.062066271637725));
  }
  CHECK_THROWS_AS(Scale(CGAL::Bbox_2()), std::invalid_argument);
  CHECK_THROWS_AS(Scale(CGAL::Bbox_2(0, 0, std::numeric_limits<double>::infinity(), 1)),
                  std::invalid_argument);
}

} // namespace test_quadtree_traits_2
