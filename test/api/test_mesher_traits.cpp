// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Traits that a user writes: models of QuadtreeTraits_2 and QuadtreeGrid_2 that have what the concepts ask for and
// nothing else. The meshers make of them the meshes that they make with the traits of the package.

#include "catch.h"

#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace test_mesher_traits {

namespace {

/// A place that is no point of any kernel.
template <class Coordinate>
class Place {
public:
  Place() = default;
  Place(Coordinate x, Coordinate y) : x_(x), y_(y) {}
  Coordinate x() const { return x_; }
  Coordinate y() const { return y_; }
  friend bool operator==(const Place& p, const Place& q) { return p.x_ == q.x_ && p.y_ == q.y_; }

private:
  Coordinate x_ = 0, y_ = 0;
};

using Double_place = Place<double>;
using Grid_point = CGAL::Quadtree_mesh_2::Grid_point_2<std::uint64_t>;

/// The grid of 2^48 units to a side, for coordinates that are multiples of 2^-40 of the extent: then nothing is
/// rounded.
class Double_grid {
public:
  Double_grid() = default;
  explicit Double_grid(const std::vector<Double_place>& points) {
    double high[2] = {0, 0}, low[2] = {0, 0};
    for (const Double_place& p : points) {
      const double c[2] = {p.x(), p.y()};
      for (int i = 0; i < 2; ++i) {
        low[i] = &p == points.data() ? c[i] : std::min(low[i], c[i]);
        high[i] = &p == points.data() ? c[i] : std::max(high[i], c[i]);
      }
    }
    double side = 1;
    while (side < 4 * std::max(high[0] - low[0], high[1] - low[1])) side *= 2;
    unit_ = std::ldexp(side, -bits);
    for (int i = 0; i < 2; ++i) origin_[i] = (std::floor(low[i] / (side / 4)) - 1) * (side / 4);
  }

  int depth() const { return bits; }
  bool refine() { return false; }
  bool is_in_root(const Double_place& p) const { return is_in_root(p.x(), 0) && is_in_root(p.y(), 1); }
  Grid_point grid_point(const Double_place& p) const { return {to_grid(p.x(), 0), to_grid(p.y(), 1)}; }
  Double_place point(const Grid_point& g) const {
    return {origin_[0] + static_cast<double>(g.x) * unit_, origin_[1] + static_cast<double>(g.y) * unit_};
  }

private:
  static constexpr int bits = 48;
  double unit_ = 1, origin_[2] = {0, 0};

  bool is_in_root(double c, int i) const {
    return c >= origin_[i] && (c - origin_[i]) / unit_ < std::ldexp(1.0, bits);
  }
  std::uint64_t to_grid(double c, int i) const {
    return static_cast<std::uint64_t>((c - origin_[i]) / unit_);
  }
};

struct Double_traits {
  using Point_2 = Double_place;
  using Word = std::uint64_t;
  using Grid_point = test_mesher_traits::Grid_point;
  using Grid_2 = Double_grid;
  using Meshing_geometry_2 = CGAL::Filtered_quadtree_traits_2<>::Meshing_geometry_2;

  struct Construct_grid_2 {
    template <class PointRange>
    Grid_2 operator()(const PointRange& points) const {
      return Grid_2(std::vector<Point_2>(points.begin(), points.end()));
    }
  };
  Construct_grid_2 construct_grid_2_object() const { return {}; }
};

struct Word_traits {
  using Word = std::uint64_t;
  using Point_2 = Place<Word>;
  using Grid_point = test_mesher_traits::Grid_point;
  using Meshing_geometry_2 = CGAL::Fixed_point_quadtree_traits_2<Word>::Meshing_geometry_2;

  struct Grid_2 {
    int depth() const { return 62; }
    bool refine() { return false; }
    bool is_in_root(const Point_2& p) const { return (p.x() | p.y()) >> 62 == 0; }
    Grid_point grid_point(const Point_2& p) const { return {p.x(), p.y()}; }
    Point_2 point(const Grid_point& g) const { return {g.x, g.y}; }
  };
  struct Construct_grid_2 {
    template <class PointRange>
    Grid_2 operator()(const PointRange&) const {
      return {};
    }
  };
  Construct_grid_2 construct_grid_2_object() const { return {}; }
};

/// A star between random points in a box, in integers below 2^20 around the middle of words.
template <class Point>
CGAL::Pslg_2<Point> star() {
  using Coordinate = decltype(Point().x());
  constexpr auto middle = Coordinate(std::int64_t(1) << 40);
  CGAL::Pslg_2<Point> graph;
  std::mt19937 random(1);
  const auto add = [&](double x, double y) {
    return graph.add_vertex(
        Point{middle + Coordinate(std::llround(x)), middle + Coordinate(std::llround(y))});
  };
  for (int i = 0; i < 100; ++i) {
    const double x = static_cast<double>(random() % 1000000), y = static_cast<double>(random() % 1000000);
    add(x, y);
  }
  const auto first = add(0, 0), second = add(1000000, 0), third = add(1000000, 1000000),
             fourth = add(0, 1000000);
  graph.add_segment(first, second), graph.add_segment(second, third);
  graph.add_segment(third, fourth), graph.add_segment(fourth, first);
  const auto center = add(500000, 500000);
  for (int i = 0; i < 7; ++i)
    graph.add_segment(center, add(500000 + 400000 * std::cos(i), 500000 + 400000 * std::sin(i)));
  return graph;
}

/// The same with points of the package.
template <class Traits, class Mesh>
CGAL::Indexed_mesh_2<typename Traits::Point_2> with_points_of(const Mesh& mesh) {
  CGAL::Indexed_mesh_2<typename Traits::Point_2> result;
  result.number_of_input_vertices = mesh.number_of_input_vertices;
  for (const auto& p : mesh.points) result.points.push_back({p.x(), p.y()});
  result.triangles = mesh.triangles;
  return result;
}

template <class Users_traits, class Traits>
void check_graph(const CGAL::Quality_mesh_options_2& options) {
  using Point = typename Traits::Point_2;
  CGAL::Quality_mesher_2<Users_traits> mesher(options);
  const auto mesh = with_points_of<Traits>(mesher(star<typename Users_traits::Point_2>()));
  CHECK(mesher.report().is_met());
  const auto quality =
      CGAL::mesh_quality_2(mesh, star<Point>(),
                           CGAL::Mesh_quality_options_2()
                               .min_angle(options.min_angle())
                               .check_arrays(CGAL::Mesh_quality_options_2::Arrays::POINTS_AND_TRIANGLES));
  for (const auto& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(quality.unmet_triangles.empty());
}

} // namespace

TEST_CASE("Graphs are meshed with a user's traits over doubles", "[traits]") {
  using Options = CGAL::Quality_mesh_options_2;
  using Traits = CGAL::Filtered_quadtree_traits_2<>;
  check_graph<Double_traits, Traits>(Options());
  check_graph<Double_traits, Traits>(Options().separate(Options::Separation::THEOREM_5));
}

TEST_CASE("Graphs are meshed with a user's traits over words", "[traits]") {
  using Options = CGAL::Quality_mesh_options_2;
  using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
  check_graph<Word_traits, Traits>(Options());
  check_graph<Word_traits, Traits>(Options().separate(Options::Separation::THEOREM_5));
}

TEST_CASE("A user's traits over words give the mesh of the package's", "[traits]") {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
  CGAL::Quality_mesher_2<Word_traits> users;
  CGAL::Quality_mesher_2<Traits> mesher;
  const auto mesh = mesher(star<Traits::Point_2>());
  const auto users_mesh = with_points_of<Traits>(users(star<Word_traits::Point_2>()));
  CHECK(users_mesh.points == mesh.points);
  CHECK(users_mesh.triangles == mesh.triangles);
}

TEST_CASE("Points are meshed with a user's traits", "[traits]") {
  CGAL::Point_set_mesher_2<Double_traits> mesher;
  const auto mesh = with_points_of<CGAL::Filtered_quadtree_traits_2<>>(mesher(star<Double_place>().vertices));
  CHECK(mesher.report().is_met());
  CGAL::Pslg_2<CGAL::Filtered_quadtree_traits_2<>::Point_2> points;
  points.vertices = star<CGAL::Filtered_quadtree_traits_2<>::Point_2>().vertices;
  using Checks = CGAL::Mesh_quality_options_2;
  const auto quality = CGAL::mesh_quality_2(mesh, points,
                                            Checks()
                                                .min_angle(36)
                                                .check_domain(Checks::Domain::ANY)
                                                .check_arrays(Checks::Arrays::POINTS_AND_TRIANGLES));
  for (const auto& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(quality.unmet_triangles.empty());
}

} // namespace test_mesher_traits
