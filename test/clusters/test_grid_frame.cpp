// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Quadtree_mesh_2/internal/frame/Grid_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/exact_axis_parallel_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace test_grid_frame {

namespace {

using namespace quadtree_test;
namespace internal = CGAL::Quadtree_mesh_2::internal;
using CGAL::Parallel_tag;
using CGAL::Sequential_tag;
using internal::Axis_parallel_grid;
using internal::Far_pair;
using internal::Gaussian_integer;
using internal::Grid_frame;
using internal::Vector;
using internal::Window_shape;

template <class Traits>
using Geometry_of = typename Traits::Meshing_geometry_2;

constexpr double root = 0x1p62;

/// The kernel's points of an input, within the middle half of the range of words.
template <class Traits>
std::vector<typename Geometry_of<Traits>::Point> kernel_points(const Input& input) {
  Input inner = input;
  for (Raw_point& p : inner.points)
    p = {p.x / 2 + (std::uint64_t(1) << 60), p.y / 2 + (std::uint64_t(1) << 60)};
  const auto points = make_points<Traits>(inner);
  std::vector<typename Geometry_of<Traits>::Point> result;
  if (points.empty()) return result;
  const internal::Coordinate_map<Traits, Geometry_of<Traits>> map(points);
  for (const auto& p : points) result.push_back(map.to_kernel(p));
  return result;
}

template <class Geometry>
double distance(const typename Geometry::Point& p, const typename Geometry::Point& q) {
  return std::sqrt(squared_length(Geometry::difference(p, q)));
}

template <class Geometry>
double diameter(const std::vector<typename Geometry::Point>& points) {
  double result = 0;
  for (const auto& p : points)
    for (const auto& q : points) result = std::max(result, distance<Geometry>(p, q));
  return result;
}

Vector difference(const internal::Wide_grid_point& p, const internal::Wide_grid_point& q) {
  return {double(std::int64_t(p.x) - std::int64_t(q.x)), double(std::int64_t(p.y) - std::int64_t(q.y))};
}

double angle_between_lines(Vector v, Vector w) { return std::atan(std::fabs(cross(v, w) / dot(v, w))); }

/// The points are in the middle half of the root, or of the row, and in its squares with a quarter to spare.
template <class Geometry>
void check_window(const Grid_frame<Geometry>& frame, const std::vector<typename Geometry::Point>& points,
                  Window_shape shape) {
  const auto& window = frame.window();
  const double side = std::ldexp(1.0, 62 - window.level);
  REQUIRE(window.x1 > window.x0);
  REQUIRE(window.y1 == window.y0 + 1);
  REQUIRE(window.x1 <= std::uint64_t(1) << window.level);
  REQUIRE(window.y1 <= std::uint64_t(1) << window.level);
  if (shape == Window_shape::ROOT) CHECK(window.level == 0);
  std::size_t outside = 0;
  double low = root, high = 0;
  for (const auto& p : points) {
    const auto g = frame.to_grid(p);
    const double x = double(g.x), y = double(g.y);
    outside += x < root / 4 || x > 3 * root / 4;
    outside += x < (double(window.x0) + 0.25) * side || x > (double(window.x1) - 0.25) * side;
    outside += y < (double(window.y0) + 0.25) * side || y > (double(window.y0) + 0.75) * side;
    low = std::min(low, y), high = std::max(high, y);
  }
  CHECK(outside == 0);
  if (shape == Window_shape::ROW && points.size() > 1) {
    const bool is_as_low_as_possible =
        high - low > 0.48 * side / 2 || side / 2 < root / double(points.size());
    CHECK((window.level == 62 || is_as_low_as_possible));
  }
}

/// The way there and back ends where it began, up to units of the grid and of the coordinates.
/// \param extent their diameter
template <class Geometry>
void check_way_back(const Grid_frame<Geometry>& frame, const std::vector<typename Geometry::Point>& points,
                    double extent) {
  if (extent == 0) return;
  double scale = 0; // grid units to a unit of length
  for (const auto& p : points) {
    const double d = distance<Geometry>(p, points[0]);
    if (d < extent / 4) continue;
    const Vector v = difference(frame.to_grid(p), frame.to_grid(points[0]));
    const double here = std::sqrt(squared_length(v)) / d;
    if (scale == 0) scale = here;
    CHECK(here == Approx(scale).epsilon(1e-8));
  }
  const double rounding = std::is_integral<typename Geometry::Coordinate>::value ? 2 : 0x1p-50;
  std::size_t far = 0;
  for (const auto& p : points)
    far += distance<Geometry>(frame.to_point(frame.to_grid(p)), p) > 3 / scale + rounding + extent * 0x1p-50;
  CHECK(far == 0);
}

template <class Geometry>
bool are_same(const Grid_frame<Geometry>& a, const Grid_frame<Geometry>& b,
              const std::vector<typename Geometry::Point>& points) {
  const auto &v = a.window(), &w = b.window();
  if (v.level != w.level || v.x0 != w.x0 || v.x1 != w.x1 || v.y0 != w.y0 || v.y1 != w.y1) return false;
  for (const auto& p : points) {
    const auto g = a.to_grid(p);
    if (g != b.to_grid(p) || !(a.to_point(g) == b.to_point(g))) return false;
  }
  return a.rotation() == b.rotation();
}

/// Some of them of several blocks.
std::vector<Input> inputs() {
  std::vector<Input> result = all_inputs();
  const std::uint64_t large = std::uint64_t(1) << 55;
  result.push_back(uniform(9000, 6));
  result.push_back(collinear(0, large));
  Input thin{"thin", {}};
  std::mt19937_64 random(8);
  for (int i = 0; i < 300; ++i) {
    const std::uint64_t t = random() >> 4;
    thin.points.push_back({t, (std::uint64_t(1) << 61) - t / 7 * 5 + (random() >> 15)});
  }
  result.push_back(thin);
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("The distance found is at least 0.995 of the diameter", "[grid_frame]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  using Geometry = Geometry_of<TestType>;
  std::vector<Input> all = all_inputs();
  for (unsigned seed = 0; seed < 30; ++seed) all.push_back(small_random(seed));
  for (const Input& input : all) {
    CAPTURE(input.name);
    const auto points = kernel_points<TestType>(input);
    const Far_pair pair = internal::approximate_diameter<Sequential_tag, Geometry>(points);
    if (points.empty()) continue;
    const double found = distance<Geometry>(points[pair.first], points[pair.second]);
    CHECK(found >= internal::diameter_factor * diameter<Geometry>(points));
    CHECK((pair.first == pair.second) == (found == 0));
  }
}

TEST_CASE("Two points are the diameter in every direction, and none is lost in blocks", "[grid_frame]") {
  using Geometry = Geometry_of<Filtered_traits>;
  std::vector<Geometry::Point> points(100000);
  std::mt19937_64 random(3);
  for (auto& p : points)
    p = {std::ldexp(double(random() >> 11), -60), std::ldexp(double(random() >> 11), -60)};
  for (int degree = 0; degree < 180; degree += is_full_run() ? 7 : 19) {
    const double x = std::cos(degree * CGAL_PI / 180), y = std::sin(degree * CGAL_PI / 180);
    auto with_far = points;
    with_far[70001] = {x, y};
    with_far[20] = {-x, -y};
    const Far_pair pair = internal::approximate_diameter<Sequential_tag, Geometry>(with_far);
    CHECK(std::min(pair.first, pair.second) == 20);
    CHECK(std::max(pair.first, pair.second) == 70001);
    const Far_pair parallel = internal::approximate_diameter<Parallel_tag, Geometry>(with_far);
    CHECK((parallel.first == pair.first && parallel.second == pair.second));
  }
}

TEST_CASE("Rotations are near the direction asked for, and of small numbers", "[grid_frame]") {
  std::mt19937_64 random(5);
  const auto coordinate = [&] {
    return double(std::int64_t(random())) * std::ldexp(1.0, -int(random() % 70));
  };
  std::vector<Vector> vectors = {{1, 0},  {0, 1}, {-1, 0},   {0, -1},  {1, 1},
                                 {-1, 1}, {3, 4}, {1, 1e-9}, {1e-9, 1}};
  for (int i = 0; i < 2000; ++i) vectors.push_back({coordinate(), coordinate()});
  for (const Vector v : vectors)
    for (const std::size_t n : {1u, 2u, 100u, 12345u, 4000000000u}) {
      const Gaussian_integer z = internal::rotation_near(v, n);
      const double steps = std::min(std::max(double(n), 16.0), 0x1p28);
      REQUIRE((z.a > 0 || (z.a == 0 && z.b == 1)));
      REQUIRE(std::gcd(z.a, z.b) == 1);
      REQUIRE(double(std::max(z.a, std::abs(z.b))) < steps);
      const Vector w{double(z.a), double(z.b)};
      if (dot(v, w) != 0) REQUIRE(angle_between_lines(v, w) <= 1.000001 / steps);
    }
  CHECK((internal::rotation_near({5, 0}, 100) == Gaussian_integer{1, 0}));
  CHECK((internal::rotation_near({0, 5}, 100) == Gaussian_integer{0, 1}));
  CHECK((internal::rotation_near({-3, 4}, 100) == Gaussian_integer{3, -4}));
  CHECK(internal::rotation_near({0, 0}, 100).is_one());
}

TEMPLATE_TEST_CASE("Frames hold the points in the middle of their windows", "[grid_frame]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  using Geometry = Geometry_of<TestType>;
  using Frame = Grid_frame<Geometry>;
  for (const Input& input : inputs()) {
    CAPTURE(input.name);
    const auto points = kernel_points<TestType>(input);
    const auto small = points.size() > 200 ? std::vector(points.begin(), points.begin() + 100) : points;
    const double extent = diameter<Geometry>(small);
    const Frame straight = Frame::template axis_parallel<Sequential_tag>(points);
    check_window(straight, points, Window_shape::ROOT);
    CHECK(
        are_same(straight, Frame::template rotated<Sequential_tag>(points, {}, Window_shape::ROOT), points));
    for (const Gaussian_integer z : {Gaussian_integer{1, 0}, {0, 1}, {-1, 0}, {3, -4}, {123456789, 987654}})
      for (const Window_shape shape : {Window_shape::ROOT, Window_shape::ROW}) {
        const Frame frame = Frame::template rotated<Sequential_tag>(points, z, shape);
        check_window(frame, points, shape);
        check_way_back(Frame::template rotated<Sequential_tag>(small, z, shape), small, extent);
        CHECK(are_same(frame, Frame::template rotated<Parallel_tag>(points, z, shape), points));
      }
    const Frame row = Frame::template along_diameter<Sequential_tag>(points);
    check_window(row, points, row.window().level > 0 ? Window_shape::ROW : Window_shape::ROOT);
    CHECK(are_same(row, Frame::template along_diameter<Parallel_tag>(points), points));
  }
}

TEMPLATE_TEST_CASE("Collinear points get the lowest row there is", "[grid_frame]", Filtered_traits,
                   Fixed_64_traits, Exact_traits) {
  using Geometry = Geometry_of<TestType>;
  const std::uint64_t large = std::uint64_t(1) << 55;
  for (const Input& input : {collinear(large, 0), collinear(0, large), collinear(large / 3, large / 5)}) {
    const auto points = kernel_points<TestType>(input);
    const auto frame = Grid_frame<Geometry>::template along_diameter<Sequential_tag>(points);
    CHECK(frame.window().level >= 4); // 60 points
    const Vector v = difference(frame.to_grid(points.back()), frame.to_grid(points.front()));
    CHECK(std::fabs(v.y) <= std::fabs(v.x) / 60);
  }
}

TEST_CASE("Axis-parallel frames give coordinates back exactly", "[grid_frame]") {
  using Geometry = Geometry_of<Filtered_traits>;
  using Frame = Grid_frame<Geometry>;
  std::mt19937_64 random(9);
  for (const double shift : {0.0, 0.3, -1e6, 1e9}) {
    std::vector<Geometry::Point> points;
    for (int i = 0; i < 1000; ++i)
      points.push_back(
          {shift + std::ldexp(double(random() >> 34), -30), std::ldexp(double(random() >> 34), -30)});
    const Frame frame = Frame::axis_parallel<Sequential_tag>(points);
    for (const auto& p : points) REQUIRE(frame.to_point(frame.to_grid(p)) == p);
  }
  using Words = Geometry_of<Fixed_64_traits>;
  std::vector<Words::Point> words;
  for (int i = 0; i < 1000; ++i) words.push_back({std::int64_t(random() >> 3), std::int64_t(random() >> 9)});
  const auto frame = Grid_frame<Words>::axis_parallel<Sequential_tag>(words);
  for (const auto& p : words) REQUIRE(frame.to_point(frame.to_grid(p)) == p);
}

TEST_CASE("The root of words in the middle half of the range is in the range", "[grid_frame]") {
  using Words = Geometry_of<Fixed_64_traits>;
  std::mt19937_64 random(10);
  const std::int64_t quarter = std::int64_t(1) << 60;
  for (int i = 0; i < 1000; ++i) {
    const auto coordinate = [&](int bits) {
      return std::int64_t(random() >> bits) % (2 * quarter) + quarter;
    };
    const std::int64_t x = coordinate(2), y = coordinate(2);
    const int bits = 3 + int(random() % 60);
    const std::vector<Words::Point> points = {
        {x, y}, {std::min(x + std::int64_t(random() >> bits), 3 * quarter - 1), y}};
    const auto frame = Grid_frame<Words>::axis_parallel<Sequential_tag>(points);
    const std::uint64_t end = std::uint64_t(1) << 62;
    const auto low = frame.to_point({0, 0}), high = frame.to_point({end, end});
    REQUIRE((low.x >= 0 && low.y >= 0 && high.x <= 4 * quarter && high.y <= 4 * quarter));
    check_window(frame, points, Window_shape::ROOT);
  }
}

TEST_CASE("Exact frames turn up to 2^-18 of a unit", "[grid_frame]") {
  using Geometry = Geometry_of<Exact_traits>;
  using Field = Geometry::Field;
  const auto points = kernel_points<Exact_traits>(uniform(50, 3));
  for (const Gaussian_integer z : {Gaussian_integer{1, 0}, {3, -4}, {123457, 98764}}) {
    const auto frame = Grid_frame<Geometry>::rotated<Sequential_tag>(points, z, Window_shape::ROW);
    const std::uint64_t x = (std::uint64_t(1) << 61) + 12345, y = 777, side = (std::uint64_t(1) << 33) + 1;
    const auto a = frame.to_point({x, y}), b = frame.to_point({x + side, y}),
               c = frame.to_point({x, y + side});
    const Field bx = b.x.exact() - a.x.exact(), by = b.y.exact() - a.y.exact();
    const Field allowed = (bx < 0 ? Field(-bx) : bx) * Field(std::ldexp(1.0, -33 - 18));
    const auto is_near = [&](const Field& p, const Field& q) { return p - q < allowed && q - p < allowed; };
    CHECK(is_near(c.x.exact() - a.x.exact(), -by));
    CHECK(is_near(c.y.exact() - a.y.exact(), bx));
    CHECK(is_near(bx * Field(double(z.b)) / Field(double(z.a)), by));
  }
}

} // namespace test_grid_frame
