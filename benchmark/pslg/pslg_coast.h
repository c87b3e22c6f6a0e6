// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// A map of a sea with islands, lakes and rough coasts of any number of vertices: what stands in for real maps
// where time is measured against size.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_COAST_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_COAST_H

#include "pslg_shapes.h"
#include "random_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pslg_inputs {

/// A closed curve of a hexagon whose sides are bent again and again, as Koch bends them but by 55 degrees and
/// to either side.
///
/// It does not meet itself. All that becomes of a side stays in the rhombus over it with angles of 55 degrees
/// at its ends: the four parts of a side have theirs inside, and these share nothing but ends of parts, as
/// 3 * 55 < 180 and cos 55 > 1/2. So it does not matter which sides are bent how often and whereto. At the
/// end vertices move by less than a fiftieth of the shorter side beside them, which what is between the
/// rhombi allows; and the curve is squeezed in some direction.
class Coast_curve {
public:
  static constexpr double bend = 55 * CGAL_PI / 180;
  /// The curve stays in discs around its center, outside and inside, of so many times its radius.
  static constexpr double outer_radius = 1.14;
  static constexpr double inner_radius = 0.58;

  /// \param n at least so many vertices; 6 at least.
  Coast_curve(double n, Random_numbers& random) : random_(random) {
    for (int i = 0; i < 6; ++i) points_.push_back(polar(Point(0, 0), 1, CGAL_PI * i / 3));
    while (double(points_.size()) < n) bend_sides(n);
    shake();
  }

  /// The curve of radius `r` around a point, turned at random and, if `squeeze` is less than 1, narrower.
  std::vector<Point> at(const Point& center, double r, double squeeze) {
    const double turn = random_.between(0, 2 * CGAL_PI), c = std::cos(turn), s = std::sin(turn);
    std::vector<Point> result;
    result.reserve(points_.size());
    for (const Point& p : points_) {
      const double x = r * p.x(), y = r * squeeze * p.y();
      result.emplace_back(center.x() + c * x - s * y, center.y() + s * x + c * y);
    }
    return result;
  }

private:
  /// Bends most sides, as long as vertices are wanted.
  void bend_sides(double n) {
    std::vector<Point> next;
    next.reserve(4 * points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point &p = points_[i], &q = points_[(i + 1) % points_.size()];
      next.push_back(p);
      const double draw = random_();
      if (draw < 0.15 || double(next.size() + points_.size() - i - 1) >= n) continue;
      const Kernel::Vector_2 d = q - p, normal(-d.y(), d.x());
      const double part = 1 / (2 + 2 * std::cos(bend));
      next.push_back(p + part * d);
      next.push_back(p + d / 2 + (draw < 0.575 ? 1 : -1) * part * std::sin(bend) * normal);
      next.push_back(p + (1 - part) * d);
    }
    points_.swap(next);
  }

  void shake() {
    const std::vector<Point> old = points_;
    const std::size_t n = old.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double side = std::min(CGAL::squared_distance(old[i], old[(i + 1) % n]),
                                   CGAL::squared_distance(old[i], old[(i + n - 1) % n]));
      const double r = 0.02 * random_() * std::sqrt(side);
      points_[i] = polar(old[i], r, random_.between(0, 2 * CGAL_PI));
    }
  }

  Random_numbers& random_;
  std::vector<Point> points_;
};

/// Discs that do not meet, in a unit square; radii fall with a power, as those of islands do.
class Island_discs {
public:
  struct Disc {
    Point center;
    double r;
  };

  Island_discs(std::size_t number, Random_numbers& random) {
    for (std::size_t i = 0; i < number; ++i) {
      const double r = 0.19 * std::pow(double(i + 1), -0.62);
      for (int tries = 0; tries < 100; ++tries) {
        const double x = random.between(r, 1 - r), y = random.between(r, 1 - r);
        const Disc disc{Point(x, y), r};
        if (!is_free(disc)) continue;
        discs_.push_back(disc);
        break;
      }
    }
  }

  const std::vector<Disc>& discs() const { return discs_; }

private:
  bool is_free(const Disc& disc) const {
    return std::none_of(discs_.begin(), discs_.end(), [&disc](const Disc& other) {
      const double distance = disc.r + other.r;
      return CGAL::squared_distance(disc.center, other.center) < 1.0001 * distance * distance;
    });
  }

  std::vector<Disc> discs_;
};

/// A map of about n vertices: islands in a square sea, and in each that is large enough a lake. There are
/// about sqrt(n) islands, so that looking for their places takes O(n) time.
inline Pslg coast(double n) {
  Random_numbers random(4);
  const Island_discs islands(std::size_t(2 * std::sqrt(n)), random);
  // Vertices by lengths of fractal coasts.
  const double dimension = std::log(4.0) / std::log(2 + 2 * std::cos(Coast_curve::bend));
  double sum = 0;
  for (const auto& disc : islands.discs()) sum += std::pow(disc.r, dimension);

  Pslg pslg;
  add_box(pslg, Point(-0.1, -0.1), Point(1.1, 1.1));
  for (const auto& disc : islands.discs()) {
    const double vertices = n * std::pow(disc.r, dimension) / sum;
    const double r = disc.r / Coast_curve::outer_radius;
    const double squeeze = random.between(0.4, 1);
    const bool has_lake = vertices > 60;
    Coast_curve shore(has_lake ? 0.8 * vertices : vertices, random);
    add_loop(pslg, shore.at(disc.center, r, squeeze));
    if (!has_lake) continue;
    const double lake_r = 0.9 * Coast_curve::inner_radius / Coast_curve::outer_radius * squeeze * r;
    Coast_curve lake(0.2 * vertices, random);
    add_loop(pslg, lake.at(disc.center, lake_r, random.between(0.4, 1)));
  }
  return pslg;
}

} // namespace pslg_inputs

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_COAST_H
