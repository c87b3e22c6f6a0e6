// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What the inputs of the benchmark of meshers are made of.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_SHAPES_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_SHAPES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pslg_inputs {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Vertex_index = Pslg::Vertex_index;

inline Point polar(const Point& center, double r, double angle) {
  return {center.x() + r * std::cos(angle), center.y() + r * std::sin(angle)};
}

/// Adds a closed polygon.
inline void add_loop(Pslg& pslg, const std::vector<Point>& points) {
  const std::size_t first = pslg.number_of_vertices();
  for (const Point& p : points) pslg.add_vertex(p);
  for (std::size_t i = 0; i < points.size(); ++i)
    pslg.add_segment(Vertex_index(first + i), Vertex_index(first + (i + 1) % points.size()));
}

/// A rectangle between two corners.
inline void add_box(Pslg& pslg, const Point& low, const Point& high) {
  add_loop(pslg, {low, Point(high.x(), low.y()), high, Point(low.x(), high.y())});
}

/// A square around the origin.
inline void add_box(Pslg& pslg, double half) { add_box(pslg, Point(-half, -half), Point(half, half)); }

/// So many unit squares, side by side in rows that are about as many.
class Grid_cells {
public:
  explicit Grid_cells(double number)
      : number_(std::size_t(number)), columns_(std::size_t(std::ceil(std::sqrt(number)))) {}

  std::vector<Point> centers() const {
    std::vector<Point> result;
    result.reserve(number_);
    for (std::size_t i = 0; i < number_; ++i)
      result.emplace_back(double(i % columns_) + 0.5, double(i / columns_) + 0.5);
    return result;
  }

  /// The rectangle that all of them fill.
  void add_plate(Pslg& pslg) const {
    const std::size_t rows = (number_ + columns_ - 1) / columns_;
    add_box(pslg, Point(0, 0), Point(double(columns_), double(rows)));
  }

private:
  std::size_t number_;
  std::size_t columns_;
};

/// Keeps segments that do not cross, by the unit cells that they may meet: constant time for each where a
/// cell has few of them.
class Crossing_finder {
public:
  /// \param limit all coordinates are in [-4, limit).
  explicit Crossing_finder(double limit)
      : columns_(std::size_t(limit) + 5), segments_of_cell_(columns_ * columns_) {}

  /// Keeps `s` unless it meets one that is kept.
  bool add_if_free(const Kernel::Segment_2& s) {
    for (const std::size_t cell : cells_of(s))
      for (const std::uint32_t i : segments_of_cell_[cell])
        if (CGAL::do_intersect(s, segments_[i])) return false;
    for (const std::size_t cell : cells_of(s))
      segments_of_cell_[cell].push_back(std::uint32_t(segments_.size()));
    segments_.push_back(s);
    return true;
  }

private:
  std::vector<std::size_t> cells_of(const Kernel::Segment_2& s) const {
    const CGAL::Bbox_2 box = s.bbox();
    std::vector<std::size_t> cells;
    for (std::size_t y = cell_of(box.ymin()); y <= cell_of(box.ymax()); ++y)
      for (std::size_t x = cell_of(box.xmin()); x <= cell_of(box.xmax()); ++x)
        cells.push_back(y * columns_ + x);
    return cells;
  }

  static std::size_t cell_of(double coordinate) { return std::size_t(coordinate + 4); }

  std::size_t columns_;
  std::vector<Kernel::Segment_2> segments_;
  std::vector<std::vector<std::uint32_t>> segments_of_cell_;
};

} // namespace pslg_inputs

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_SHAPES_H
