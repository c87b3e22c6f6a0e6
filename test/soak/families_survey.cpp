// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What surveyors have: parcels in degrees with seven decimals, plans of half a meter with coordinates of millions.

#include "families.h"
#include "shape_tools.h"

namespace soak {

namespace {

double rounded(double v, double units_of_one) { return std::round(v * units_of_one) / units_of_one; }

/// Rows of parcels with common borders, in degrees; corners of one row are not those of the next, but lie on its
/// border, but for rounding.
Pslg cadastre(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double x0 = random.between(-180, 180), y0 = random.between(-80, 80),
               size = magnitude(random, -15, -12);
  const int rows = random.integer(1, 4), columns = random.integer(1, 5);
  const Vector right = size * direction(random), up(-right.y(), right.x());
  const auto at = [&](double i, double j) {
    const Point p = Point(x0, y0) + i * right + j * up;
    return Point(rounded(p.x(), 1e7), rounded(p.y(), 1e7));
  };
  // Each row's borders by themselves; the border between two rows is in both.
  for (int j = 0; j < rows; ++j) {
    double last = 0;
    const double low = j + 0.0, high = j + 1.0;
    for (int i = 0; i < columns; ++i) {
      const double next = i + 1 == columns ? columns : last + (columns - last) * random.between(0.2, 0.6);
      std::vector<Point> ring{at(last, low), at(next, low), at(next, high), at(last, high)};
      if (random.integer(0, 3) == 0) ring.insert(ring.begin() + 2, at(next, low + random.between(0.2, 0.8)));
      b.loop(ring);
      last = next;
    }
  }
  return b.pslg;
}

/// Polygons of half a meter to a hundred meters at millions of meters, to the millimeter or not rounded at all.
Pslg utm(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double units[] = {100, 1000, 0x1p60};
  const double unit = units[random.integer(0, 2)];
  const Point c(random.between(2e5, 8e5), random.between(3e6, 6e6));
  const double r = magnitude(random, -1, 6);
  std::vector<Point> ring = star_around(random, c, r, random.integer(3, 30), random.between(0.3, 0.9));
  for (Point& p : ring) p = Point(rounded(p.x(), unit), rounded(p.y(), unit));
  b.loop(ring);
  if (random.integer(0, 1) == 0) {
    std::vector<Point> hole = star_around(random, c, 0.2 * r, random.integer(3, 8), 0.5);
    for (Point& p : hole) p = Point(rounded(p.x(), unit), rounded(p.y(), unit));
    b.loop(hole);
    if (random.integer(0, 1) == 0) b.pslg.holes.push_back(c);
  }
  return b.pslg;
}

/// Squares of a grid whose offset is 1 to 10^9 times its extent.
Pslg offset_grids(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const int n = random.integer(1, 6);
  const double side = magnitude(random, -10, 10), ratio = power_of_ten(random.integer(0, 9));
  const double x0 = side * n * ratio * random.between(-1, 1), y0 = side * n * ratio * random.between(-1, 1);
  std::vector<std::vector<std::size_t>> index;
  for (int i = 0; i <= n; ++i) {
    index.emplace_back();
    for (int j = 0; j <= n; ++j) index.back().push_back(b.vertex(Point(x0 + i * side, y0 + j * side)));
  }
  for (std::size_t i = 0; i < index.size(); ++i)
    for (std::size_t j = 0; j < index.size(); ++j) {
      const bool is_border_x = j == 0 || j + 1 == index.size(), is_border_y = i == 0 || i + 1 == index.size();
      if (i + 1 < index.size() && (is_border_x || random.integer(0, 1) == 0))
        b.segment(index[i][j], index[i + 1][j]);
      if (j + 1 < index.size() && (is_border_y || random.integer(0, 1) == 0))
        b.segment(index[i][j], index[i][j + 1]);
    }
  return b.pslg;
}

/// Polygons that nobody would call hard, with holes, from the origin or far away.
Pslg ordinary(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  const double ratio = power_of_ten(random.integer(0, 9));
  const double r = magnitude(random, -10, 10);
  const Point c(r * ratio * random.between(-1, 1), r * ratio * random.between(-1, 1));
  b.loop(star_around(random, c, r, random.integer(3, 200), random.between(0.5, 1)));
  const int holes = random.integer(0, 3);
  for (int k = 0; k < holes; ++k) {
    const Point hole(c.x() + r * (0.2 * k - 0.2), c.y() + r * 0.05 * k);
    b.loop(star_around(random, hole, 0.09 * r, random.integer(3, 20), 0.6));
    if (random.integer(0, 2) > 0) b.pslg.holes.push_back(hole);
  }
  return b.pslg;
}

} // namespace

std::vector<Family> survey_families() {
  return {{"cadastre", cadastre}, {"utm", utm}, {"offset-grids", offset_grids}, {"ordinary", ordinary}};
}

} // namespace soak
