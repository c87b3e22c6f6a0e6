// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// A geometry that a user writes: a model of MeshingGeometry_2 that has what the concept asks for and nothing else. Its
// coordinates are floats that cannot be taken for numbers, so what is derived from their spacing counts.

#include "catch.h"
#include "mesher_test_tools.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/check_coordinates.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Input_words.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace test_meshing_geometry_2 {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Options = CGAL::Quality_mesh_options_2;

/// A point of graphs and meshes, that is no point of any kernel.
class Site {
public:
  Site() = default;
  Site(float x, float y) : x_(x), y_(y) {}
  float x() const { return x_; }
  float y() const { return y_; }
  friend bool operator==(const Site& p, const Site& q) { return p.x_ == q.x_ && p.y_ == q.y_; }

private:
  float x_ = 0, y_ = 0;
};

struct Archetype {
  /// A number that has an order and nothing else.
  class Coordinate {
  public:
    Coordinate() = default;
    friend bool operator<(const Coordinate& a, const Coordinate& b) { return a.value_ < b.value_; }
    friend bool operator==(const Coordinate& a, const Coordinate& b) { return a.value_ == b.value_; }

  private:
    friend struct Archetype;
    explicit Coordinate(double value) : value_(static_cast<float>(value)) {}
    float value_ = 0;
  };
  struct Point {
    Coordinate x, y;
    friend bool operator==(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }
  };
  struct Vector {
    double x, y;
  };
  static constexpr double least_length = 0x1p-100;

  static int orientation(const Point& a, const Point& b, const Point& c) {
    return CGAL::orientation(in_kernel(a), in_kernel(b), in_kernel(c));
  }
  static int side_of_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    return CGAL::side_of_oriented_circle(in_kernel(a), in_kernel(b), in_kernel(c), in_kernel(d));
  }
  static double doubled_area(const Point& a, const Point& b, const Point& c) {
    using Exact = CGAL::Exact_rational;
    const Exact x(a.x.value_), y(a.y.value_);
    return CGAL::to_double(Exact((Exact(b.x.value_) - x) * (Exact(c.y.value_) - y) -
                                 (Exact(b.y.value_) - y) * (Exact(c.x.value_) - x)));
  }
  static Vector difference(const Point& p, const Point& q) {
    return {double(p.x.value_) - double(q.x.value_), double(p.y.value_) - double(q.y.value_)};
  }
  static Point translate(const Point& p, const Vector& v) {
    return {Coordinate(p.x.value_ + v.x), Coordinate(p.y.value_ + v.y)};
  }
  static Point nearest_corner(const Point& p, double side) {
    return {Coordinate(side * std::floor(p.x.value_ / side + 0.5)),
            Coordinate(side * std::floor(p.y.value_ / side + 0.5))};
  }
  static double spacing(const Coordinate& c) { return spacing_of(c.value_); }
  static double spacing_of(float c) {
    const float magnitude = std::fabs(c);
    return double(std::nextafter(magnitude, std::numeric_limits<float>::infinity())) - double(magnitude);
  }

  class Coordinate_map {
  public:
    explicit Coordinate_map(const std::vector<Site>& sites) { REQUIRE(!sites.empty()); }
    Point to_mesher(const Site& p) const { return {Coordinate(p.x()), Coordinate(p.y())}; }
    Site from_mesher(const Point& p) const { return {p.x.value_, p.y.value_}; }
    double scale() const { return 1; }
  };

private:
  static Kernel::Point_2 in_kernel(const Point& p) { return {p.x.value_, p.y.value_}; }
};

/// Traits that name a geometry over sites, with the grid of doubles.
template <class Geometry>
struct Traits_with {
  using Doubles = CGAL::Filtered_quadtree_traits_2<Kernel>;
  using Point_2 = Site;
  using Word = std::uint64_t;
  using Grid_point = CGAL::Quadtree_mesh_2::Grid_point_2<Word>;
  using Meshing_geometry_2 = Geometry;

  class Grid_2 {
  public:
    Grid_2() = default;
    int depth() const { return grid_.depth(); }
    bool refine() { return false; }
    bool is_in_root(const Site& p) const { return grid_.is_in_root({p.x(), p.y()}); }
    Grid_point grid_point(const Site& p) const { return grid_.grid_point({p.x(), p.y()}); }
    Site point(const Grid_point& g) const {
      const Kernel::Point_2 p = grid_.point(g);
      return {static_cast<float>(p.x()), static_cast<float>(p.y())};
    }

  private:
    friend struct Traits_with;
    explicit Grid_2(Doubles::Grid_2 grid) : grid_(grid) {}
    Doubles::Grid_2 grid_;
  };
  struct Construct_grid_2 {
    template <class PointRange>
    Grid_2 operator()(const PointRange& sites) const {
      std::vector<Kernel::Point_2> points;
      for (const Site& p : sites) points.emplace_back(p.x(), p.y());
      return Grid_2(Doubles().construct_grid_2_object()(points));
    }
  };
  Construct_grid_2 construct_grid_2_object() const { return {}; }
};
using Traits = Traits_with<Archetype>;
using Graph = CGAL::Pslg_2<Site>;

Site in_floats(const Kernel::Point_2& p) { return {static_cast<float>(p.x()), static_cast<float>(p.y())}; }

/// The graph with its coordinates rounded, which may make segments cross.
Graph in_floats(const pslg_test::Pslg& pslg) {
  Graph graph;
  for (const auto& p : pslg.vertices) graph.vertices.push_back(in_floats(p));
  graph.segments = pslg.segments, graph.segment_markers = pslg.segment_markers;
  for (const auto& p : pslg.holes) graph.holes.push_back(in_floats(p));
  for (const auto& r : pslg.regions) graph.regions.push_back({in_floats(r.point), r.attribute, r.max_area});
  return graph;
}

double coordinate_unit(const Graph& graph) {
  float largest = 0;
  for (const Site& p : graph.vertices) largest = std::max({largest, std::fabs(p.x()), std::fabs(p.y())});
  return Archetype::spacing_of(largest);
}

/// Of the box around the graph.
double width(const Graph& graph) {
  const auto [low, high] = std::minmax_element(graph.vertices.begin(), graph.vertices.end(),
                                               [](const Site& p, const Site& q) { return p.x() < q.x(); });
  return double(high->x()) - double(low->x());
}

struct Run {
  CGAL::Indexed_mesh_2<Site> mesh;
  CGAL::Quality_mesh_report_2 report;
};

/// Meshes, and checks that the mesh is valid and that all that misses a bound is reported.
template <class ConcurrencyTag = CGAL::Sequential_tag>
Run run(const Graph& graph, const Options& options) {
  CGAL::Quality_mesher_2<Traits, ConcurrencyTag> mesher(options);
  Run r{mesher(graph), mesher.report()};
  const auto quality = CGAL::mesh_quality_2(r.mesh, graph,
                                            CGAL::Mesh_quality_options_2()
                                                .min_angle(options.min_angle())
                                                .max_area(options.max_area())
                                                .max_edge(options.max_edge())
                                                .coordinate_unit(coordinate_unit(graph)));
  for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(r.report.triangles == quality.triangles);
  CHECK(r.report.unmet_triangles.size() == quality.unmet_triangles.size());
  return r;
}

Run run_to_the_bound(const Graph& graph, const Options& options) {
  Run r = run(graph, options);
  CHECK(r.report.is_met());
  return r;
}

std::string text_of(const std::string& file) {
  std::ifstream in(QUADTREE_MESH_SOURCE_DIR "/" + file);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Models that lack a part each: it is hidden by what is none.
struct Without_point : Archetype {
  using Point = void;
};
struct Without_vector : Archetype {
  using Vector = double;
};
struct Without_order : Archetype {
  struct Coordinate {};
};
struct Without_least_length : Archetype {
  void least_length() const;
};
struct Without_orientation : Archetype {
  static void orientation(int);
};
struct Without_side_of_circle : Archetype {
  static int side_of_circle(Point, Point, Point);
};
struct Without_doubled_area : Archetype {
  static void doubled_area(Point, Point, Point);
};
struct Without_difference : Archetype {
  static double difference(Point, Point);
};
struct Without_translate : Archetype {
  static Point translate(Point, double);
};
struct Without_nearest_corner : Archetype {
  static Point nearest_corner(Point);
};
struct Without_spacing : Archetype {
  static double spacing(Point);
};
struct Without_map : Archetype {
  struct Coordinate_map {};
};

/// A geometry of integers, for sites that need not be such.
struct Of_integers : Archetype {
  struct Coordinate_map : Archetype::Coordinate_map {
    using Archetype::Coordinate_map::Coordinate_map;
    Point to_mesher(const Site& p) const {
      return Archetype::Coordinate_map::to_mesher({std::round(p.x()), std::round(p.y())});
    }
  };
};

} // namespace

TEST_CASE("Real and synthetic graphs are meshed over a user's geometry, as well as over doubles",
          "[traits]") {
  for (const char* name : {"syn_square.poly", "syn_sliver_1deg.poly", "syn_wedge_10deg.poly", "syn_comb.poly",
                           "syn_fan_1deg.poly", "syn_holes_400.poly.gz", "us_states_10m.poly.gz"}) {
    CAPTURE(name);
    const mesher_test::Pslg over_doubles = mesher_test::read(name);
    const Graph graph = in_floats(over_doubles);
    const std::size_t triangles = mesher_test::Mesher()(over_doubles).triangles.size();
    CHECK(double(run_to_the_bound(graph, Options()).report.triangles) <= 1.02 * double(triangles) + 10);
    run(graph, Options().min_angle(30));
  }
}

TEST_CASE("The mesh over a user's geometry is the same for any number of threads", "[traits]") {
  const Graph graph = in_floats(mesher_test::read("us_states_10m.poly.gz"));
  for (const Options& options : {Options(), Options().max_edge(width(graph) / (is_full_run() ? 200 : 120))}) {
    const Run one = run<CGAL::Sequential_tag>(graph, options), all = run<CGAL::Parallel_tag>(graph, options);
    CHECK(one.mesh.points == all.mesh.points);
    CHECK(one.mesh.triangles == all.mesh.triangles);
  }
}

TEST_CASE("Random graphs are meshed over a user's geometry, by refinement and by quadtrees", "[traits]") {
  const std::uint64_t seeds = is_full_run() ? 200 : 2;
  std::size_t meshed = 0, all = 0, met = 0;
  for (const random_pslg::Family& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed)
      for (const auto by : {Options::Separation::ON_DEMAND, Options::Separation::THEOREM_5}) {
        CAPTURE(family.name, seed, int(by));
        const Graph graph = in_floats(family.make(seed));
        ++all;
        try {
          met += run(graph, Options().separate(by)).report.is_met() ? 1 : 0;
          ++meshed;
        } catch (const CGAL::Pslg_error_2& error) {
          CAPTURE(error.what());
          CHECK(error.kind() == CGAL::Pslg_error_2::Kind::CROSSING); // by rounding to floats
        }
      }
  CHECK(10 * meshed >= 9 * all);
  CHECK(100 * met >= 98 * meshed);
}

TEST_CASE("All bounds are met over a user's geometry", "[traits]") {
  const Graph graph = in_floats(mesher_test::read("syn_holes_400.poly.gz"));
  const double length = width(graph) / 100;
  run_to_the_bound(graph, Options().max_area(length * length));
  run_to_the_bound(graph, Options().max_edge(length));
  run(graph, Options().gradation(0.3));
  run(graph, Options().max_angle(120));
  run(graph, Options().smooth(2).thin(1));
  run(graph, Options().conform(Options::Conforming::DELAUNAY));
  run(graph, Options().keep_borders(Options::Keep_borders::ALL));
}

TEST_CASE("What a geometry lacks is named", "[traits]") {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  using internal::has_part;
  STATIC_REQUIRE(sizeof(internal::Model_requirements<Archetype>) > 0);
  STATIC_REQUIRE(internal::has_map<Archetype, Site>);
  STATIC_REQUIRE_FALSE(has_part<internal::Point_in, int>);
  STATIC_REQUIRE_FALSE(has_part<internal::Coordinates_in, Without_point>);
  STATIC_REQUIRE_FALSE(has_part<internal::Order_in, Without_order>);
  STATIC_REQUIRE_FALSE(has_part<internal::Vector_in, Without_vector>);
  STATIC_REQUIRE_FALSE(has_part<internal::Least_length_in, Without_least_length>);
  STATIC_REQUIRE_FALSE(has_part<internal::Orientation_in, Without_orientation>);
  STATIC_REQUIRE_FALSE(has_part<internal::Side_of_circle_in, Without_side_of_circle>);
  STATIC_REQUIRE_FALSE(has_part<internal::Doubled_area_in, Without_doubled_area>);
  STATIC_REQUIRE_FALSE(has_part<internal::Difference_in, Without_difference>);
  STATIC_REQUIRE_FALSE(has_part<internal::Translate_in, Without_translate>);
  STATIC_REQUIRE_FALSE(has_part<internal::Nearest_corner_in, Without_nearest_corner>);
  STATIC_REQUIRE_FALSE(has_part<internal::Spacing_in, Without_spacing>);
  STATIC_REQUIRE_FALSE(internal::has_map<Without_map, Site>);
  STATIC_REQUIRE_FALSE(internal::has_map<Archetype, int>);
}

TEST_CASE("A map that does not give points back is found out", "[traits]") {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  using Of_sites = Traits_with<Of_integers>;
  using Geometry = internal::Mesher_geometry<Of_sites>;
  using Map = internal::Coordinate_map<Of_sites, Geometry>;
  using Kind = CGAL::Pslg_error_2::Kind;
  const auto kind_of = [](const auto& f) {
    try {
      f();
    } catch (const CGAL::Pslg_error_2& error) {
      return error.kind();
    }
    return Kind::UNREADABLE_FILE;
  };
  Graph graph;
  graph.vertices = {{0, 0}, {4, 0}, {0, 4}};
  const internal::Order order{0, 1, 2};
  const internal::Input_words<Site> words(graph, order);
  const auto check_points = [&] { internal::check_points_are_kept(graph, Map(graph.vertices), words); };
  CHECK_NOTHROW(check_points());
  graph.vertices[1] = {4.5, 0};
  CHECK(kind_of(check_points) == Kind::OUT_OF_RANGE);
  CHECK(pslg_test::has_text(pslg_test::error_of(check_points), "vertex 1"));

  CGAL::Indexed_mesh_2<Site> mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 0.75}};
  mesh.triangles.push_back({CGAL::Quadtree_mesh_2::Vertex_index(0), CGAL::Quadtree_mesh_2::Vertex_index(1),
                            CGAL::Quadtree_mesh_2::Vertex_index(2)});
  const Map map(mesh.points);
  const auto check_mesh = [&] { internal::check_mesh_is_kept<Geometry>(mesh, map); };
  CHECK_NOTHROW(check_mesh());
  mesh.points[2] = {0, 0.25};
  CHECK(kind_of(check_mesh) == Kind::ROUNDING);
}

TEST_CASE("The manual shows the geometry of the example", "[traits]") {
  const std::string manual = text_of("doc/user_manual.md"), example = text_of("examples/own_geometry.cpp");
  const std::size_t begin = manual.find("struct Float_geometry {"), end = manual.find("```", begin);
  REQUIRE(end != std::string::npos);
  CHECK(pslg_test::has_text(example, manual.substr(begin, end - begin)));
}

} // namespace test_meshing_geometry_2
