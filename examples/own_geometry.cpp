// Meshes a lake in single precision: a geometry and traits of one's own, for coordinates that are floats. All vertices
// are floats, and all triangles are counterclockwise and meet the bound as they are.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A point of graphs and meshes.
class Float_point {
public:
  Float_point() = default;
  Float_point(float x, float y) : x_(x), y_(y) {}
  float x() const { return x_; }
  float y() const { return y_; }
  friend bool operator==(const Float_point& p, const Float_point& q) { return p.x_ == q.x_ && p.y_ == q.y_; }

private:
  float x_ = 0, y_ = 0;
};

// What the mesher has to know about floats: a model of MeshingGeometry_2.
struct Float_geometry {
  using Coordinate = float;
  struct Point {
    float x, y;
    friend bool operator==(Point p, Point q) { return p.x == q.x && p.y == q.y; }
  };
  struct Vector {
    double x, y;
  };
  static constexpr double least_length = 0x1p-100; // nearer vertices are refused

  static int orientation(Point a, Point b, Point c) {
    return CGAL::orientation(in_kernel(a), in_kernel(b), in_kernel(c));
  }
  static int side_of_circle(Point a, Point b, Point c, Point d) {
    return CGAL::side_of_oriented_circle(in_kernel(a), in_kernel(b), in_kernel(c), in_kernel(d));
  }
  static double doubled_area(Point a, Point b, Point c) {
    using Exact = CGAL::Exact_rational;
    const Exact area = (Exact(b.x) - Exact(a.x)) * (Exact(c.y) - Exact(a.y)) -
                       (Exact(b.y) - Exact(a.y)) * (Exact(c.x) - Exact(a.x));
    return CGAL::to_double(area);
  }

  static Vector difference(Point p, Point q) { return {double(p.x) - q.x, double(p.y) - q.y}; }
  static Point translate(Point p, Vector v) { return {float(p.x + v.x), float(p.y + v.y)}; }
  static Point nearest_corner(Point p, double side) {
    return {float(side * std::floor(p.x / side + 0.5)), float(side * std::floor(p.y / side + 0.5))};
  }
  static double spacing(float x) {
    return std::nextafter(std::fabs(x), std::numeric_limits<float>::infinity()) - std::fabs(x);
  }

  struct Coordinate_map {
    explicit Coordinate_map(const std::vector<Float_point>&) {}
    Point to_mesher(const Float_point& p) const { return {p.x(), p.y()}; }
    Float_point from_mesher(Point p) const { return {p.x, p.y}; }
    double scale() const { return 1; }
  };

private:
  static Kernel::Point_2 in_kernel(Point p) { return {p.x, p.y}; }
};

// The grid of quadtrees is that of doubles: a model of QuadtreeTraits_2.
struct Float_traits {
  using Doubles = CGAL::Filtered_quadtree_traits_2<Kernel>;
  using Point_2 = Float_point;
  using Word = Doubles::Word;
  using Grid_point = Doubles::Grid_point;
  using Meshing_geometry_2 = Float_geometry;

  struct Grid_2 {
    int depth() const { return grid.depth(); }
    bool refine() { return grid.refine(); }
    bool is_in_root(const Point_2& p) const { return grid.is_in_root({p.x(), p.y()}); }
    Grid_point grid_point(const Point_2& p) const { return grid.grid_point({p.x(), p.y()}); }
    Point_2 point(const Grid_point& g) const {
      const Kernel::Point_2 p = grid.point(g);
      return {float(p.x()), float(p.y())};
    }
    Doubles::Grid_2 grid;
  };

  struct Construct_grid_2 {
    template <class PointRange>
    Grid_2 operator()(const PointRange& points) const {
      std::vector<Kernel::Point_2> doubles;
      for (const Point_2& p : points) doubles.emplace_back(p.x(), p.y());
      return {Doubles().construct_grid_2_object()(doubles)};
    }
  };
  Construct_grid_2 construct_grid_2_object() const { return {}; }
};

int main() {
  CGAL::Pslg_2<Kernel::Point_2> lakes; // in meters, which floats have
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_EXAMPLE_DATA_DIR "/great_lakes.poly.gz", lakes);
  CGAL::Pslg_2<Float_point> graph;
  const auto in_floats = [](const Kernel::Point_2& p) { return Float_point(float(p.x()), float(p.y())); };
  float largest = 0;
  for (const auto& p : lakes.vertices) {
    graph.vertices.push_back(in_floats(p));
    largest = std::max({largest, std::fabs(float(p.x())), std::fabs(float(p.y()))});
  }
  graph.segments = lakes.segments;
  for (const auto& p : lakes.holes) graph.holes.push_back(in_floats(p));

  CGAL::Quality_mesher_2<Float_traits> mesher;
  const auto mesh = mesher(graph);
  const auto quality = CGAL::mesh_quality_2(
      mesh, graph,
      CGAL::Mesh_quality_options_2().min_angle(20.7).coordinate_unit(Float_geometry::spacing(largest)));
  std::cout << mesh.number_of_triangles() << " triangles in single precision: " << quality.exempt_triangles
            << " at sharp corners, " << quality.unmet_triangles.size() << " others below 20.7 degrees\n";
  return quality.is_valid() && quality.unmet_triangles.empty() ? 0 : 1;
}
