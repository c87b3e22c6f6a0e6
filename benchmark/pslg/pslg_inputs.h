// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Inputs of meshers by name and size, as "coast:1e5": no segments cross, and the same name gives the same
// bits everywhere that the standard library's sine does. Each takes O(n log n) time or less.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_INPUTS_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_INPUTS_H

#include "pslg_coast.h"
#include "pslg_shapes.h"
#include "random_numbers.h"

#include <CGAL/Pslg_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace pslg_inputs {

/// The snowflake of Koch with at least n vertices: sides of the last generation are bent in their order until
/// there are enough, which no other bend is in the way of.
inline Pslg koch(double n) {
  std::vector<Point> curve;
  for (int i = 0; i < 3; ++i) curve.push_back(polar(Point(0, 0), 1, -2 * CGAL_PI * i / 3));
  while (double(curve.size()) < n) {
    std::vector<Point> next;
    next.reserve(4 * curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Point &p = curve[i], &q = curve[(i + 1) % curve.size()];
      next.push_back(p);
      if (double(next.size() + curve.size() - i - 1) >= n) continue;
      const Kernel::Vector_2 d = q - p;
      next.push_back(p + d / 3);
      next.push_back(p + d / 2 + std::sqrt(0.75) / 3 * Kernel::Vector_2(-d.y(), d.x()));
      next.push_back(p + 2 * d / 3);
    }
    curve.swap(next);
  }
  Pslg pslg;
  add_loop(pslg, curve);
  return pslg;
}

/// A smooth closed curve around the origin, as a polygon of n sides, or of three if that is more.
inline Pslg blob(double n) {
  n = std::max(n, 3.0);
  Random_numbers random(1);
  std::vector<double> height, phase;
  for (int k = 2; k < 9; ++k) {
    height.push_back(random.between(0, 0.5) / k);
    phase.push_back(random.between(0, 2 * CGAL_PI));
  }
  std::vector<Point> points;
  for (double i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n;
    double r = 1.5;
    for (std::size_t k = 0; k < height.size(); ++k)
      r += height[k] * std::cos(double(k + 2) * angle + phase[k]);
    points.push_back(polar(Point(0, 0), r, angle));
  }
  Pslg pslg;
  add_loop(pslg, points);
  return pslg;
}

/// Stars of 50 thin tips in the cells of a plate, about n vertices in all.
inline Pslg stars(double n) {
  constexpr int tips = 50;
  Random_numbers random(2);
  const Grid_cells cells(std::ceil(n / (2 * tips)));
  Pslg pslg;
  cells.add_plate(pslg);
  for (const Point& center : cells.centers()) {
    std::vector<Point> points;
    const double turn = random.between(0, 2 * CGAL_PI);
    for (int i = 0; i < 2 * tips; ++i) {
      const double r = i % 2 == 0 ? random.between(0.2, 0.48) : random.between(0.08, 0.12);
      points.push_back(polar(center, r, turn + CGAL_PI * i / tips));
    }
    add_loop(pslg, points);
  }
  return pslg;
}

/// n hexagonal holes in a plate.
inline Pslg holes(double n) {
  const Grid_cells cells(n);
  Pslg pslg;
  cells.add_plate(pslg);
  for (const Point& center : cells.centers()) {
    std::vector<Point> points;
    for (int i = 0; i < 6; ++i) points.push_back(polar(center, 0.3, 0.1 + CGAL_PI * i / 3));
    add_loop(pslg, points);
    pslg.holes.push_back(center);
  }
  return pslg;
}

/// A comb of n thin teeth, twenty times as long as they are wide.
inline Pslg comb(double n) {
  std::vector<Point> points{Point(0, -1), Point(n, -1)};
  for (double i = n; i > 0; --i) {
    points.emplace_back(i, 0);
    points.emplace_back(i - 0.5, 20);
  }
  points.emplace_back(0, 0);
  Pslg pslg;
  add_loop(pslg, points);
  return pslg;
}

/// A full circle of spokes so many degrees apart, in a box.
inline Pslg fan(double degrees) {
  Pslg pslg;
  add_box(pslg, 2);
  const Vertex_index center = pslg.add_vertex(Point(0, 0));
  const double spokes = std::floor(360 / degrees + 1e-9);
  for (double i = 0; i < spokes; ++i)
    pslg.add_segment(center, pslg.add_vertex(polar(Point(0, 0), 1, i * degrees * CGAL_PI / 180)));
  return pslg;
}

/// A chain of n vertices on a curve over [0, 1), in a box whose corners most edges of the first triangulation meet at.
template <class Curve>
Pslg chain(double n, const Curve& curve) {
  Pslg pslg;
  for (double i = 0; i < n; ++i) {
    const Vertex_index v = pslg.add_vertex(curve(i / n));
    if (i > 0) pslg.add_segment(Vertex_index(std::size_t(v) - 1), v);
  }
  add_box(pslg, Point(-1.25, -1.25), Point(1.5, 1.5));
  return pslg;
}

inline Pslg line(double n) {
  return chain(n, [](double t) { return Point(t, 0); });
}
inline Pslg upright(double n) {
  return chain(n, [](double t) { return Point(0, t); });
}
inline Pslg parabola(double n) {
  return chain(n, [](double t) { return Point(t, t * t); });
}
inline Pslg circle(double n) {
  return chain(n, [](double t) { return polar(Point(0, 0), 1, 2 * CGAL_PI * t); });
}
/// To and fro between two lines.
inline Pslg zigzag(double n) {
  return chain(n, [n](double t) { return Point(t, std::fmod(std::round(n * t), 2)); });
}

/// Two segments that meet at an angle of so many degrees, in a box.
inline Pslg wedge(double degrees) {
  Pslg pslg;
  add_box(pslg, 2);
  const Vertex_index apex = pslg.add_vertex(Point(-1, 0));
  pslg.add_segment(apex, pslg.add_vertex(Point(1, 0)));
  pslg.add_segment(apex, pslg.add_vertex(polar(Point(-1, 0), 2, degrees * CGAL_PI / 180)));
  return pslg;
}

/// Two segments of length 2 that are so far apart, in a box.
inline Pslg parallel(double gap) {
  Pslg pslg;
  add_box(pslg, 2);
  for (const double y : {0.0, gap}) {
    const Vertex_index v = pslg.add_vertex(Point(-1, y));
    pslg.add_segment(v, pslg.add_vertex(Point(1, y)));
  }
  return pslg;
}

/// n disjoint segments at random places of a box, of lengths from a hundredth of their distance to three
/// times as much. One that crosses another is drawn again.
inline Pslg segments(double n) {
  Random_numbers random(3);
  const double side = std::ceil(std::sqrt(n));
  Pslg pslg;
  add_box(pslg, Point(-4, -4), Point(side + 4, side + 4));
  Crossing_finder finder(side + 4);
  while (double(pslg.number_of_segments()) < n + 4) {
    const double x = random.between(0, side), y = random.between(0, side);
    const double length = std::pow(10, random.between(-2, 0.5)), angle = random.between(0, 2 * CGAL_PI);
    const Kernel::Segment_2 s(Point(x, y), polar(Point(x, y), length, angle));
    if (!finder.add_if_free(s)) continue;
    const Vertex_index v = pslg.add_vertex(s.source());
    pslg.add_segment(v, pslg.add_vertex(s.target()));
  }
  return pslg;
}

/// The unit square, with a bound on the area of triangles.
inline Pslg square(double) {
  Pslg pslg;
  add_box(pslg, 0.5);
  return pslg;
}

/// What the number of a name says.
enum class Size { VERTICES, PARTS, MEASURE };

struct Family {
  std::string name;
  std::string size_name; ///< for people
  Size size;
  Pslg (*make)(double size);
};

inline const std::vector<Family>& all() {
  static const std::vector<Family> families{{"koch", "vertices", Size::VERTICES, koch},
                                            {"blob", "vertices", Size::VERTICES, blob},
                                            {"stars", "vertices", Size::VERTICES, stars},
                                            {"comb", "teeth", Size::PARTS, comb},
                                            {"fan", "degrees", Size::MEASURE, fan},
                                            {"wedge", "degrees", Size::MEASURE, wedge},
                                            {"segments", "segments", Size::PARTS, segments},
                                            {"holes", "holes", Size::PARTS, holes},
                                            {"parallel", "gap", Size::MEASURE, parallel},
                                            {"coast", "vertices", Size::VERTICES, coast},
                                            {"line", "vertices", Size::VERTICES, line},
                                            {"upright", "vertices", Size::VERTICES, upright},
                                            {"parabola", "vertices", Size::VERTICES, parabola},
                                            {"circle", "vertices", Size::VERTICES, circle},
                                            {"zigzag", "vertices", Size::VERTICES, zigzag},
                                            {"square", "area of triangles", Size::MEASURE, square}};
  return families;
}

/// A graph and the bound on areas that goes with it.
struct Input {
  Pslg pslg;
  double max_area = 0; ///< 0: none
};

/// The family of "FAMILY:NUMBER"; nothing if it is none of ours.
inline const Family* find_family(const std::string& name) {
  for (const Family& family : all())
    if (name.compare(0, family.name.size() + 1, family.name + ':') == 0) return &family;
  return nullptr;
}

/// Whether a name is "FAMILY:...".
inline bool is_name(const std::string& name) { return find_family(name) != nullptr; }

/// The number in "FAMILY:NUMBER".
/// \throws std::invalid_argument if there is no such family or the number is not positive.
inline double size_of(const std::string& name) {
  const Family* const family = find_family(name);
  if (family == nullptr) throw std::invalid_argument("there is no input '" + name + "'");
  const char* const begin = name.c_str() + family->name.size() + 1;
  char* end = nullptr;
  const double size = std::strtod(begin, &end);
  if (end == begin || *end != '\0' || !(size > 0) || !(size <= 1e9))
    throw std::invalid_argument("'" + name + "' has no size: " + family->size_name + " expected");
  return size;
}

/// The input "FAMILY:NUMBER".
/// \throws std::invalid_argument as `size_of()` does.
inline Input by_name(const std::string& name) {
  const double size = size_of(name);
  const Family& family = *find_family(name);
  return {family.make(size), family.name == "square" ? size : 0};
}

} // namespace pslg_inputs

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_INPUTS_H
