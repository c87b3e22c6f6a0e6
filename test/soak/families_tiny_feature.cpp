// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Features that are 2^-20 to 2^-45 of the extent, or much less around the origin, and far from all others.

#include "families.h"
#include "shape_tools.h"

namespace soak {

namespace {

double tiny(Random& random) { return std::ldexp(random.between(1, 2), -random.integer(20, 45)); }

void add_frame(Builder& b, Random& random) {
  switch (random.integer(0, 2)) {
  case 0:
    return add_square(b, Point(0, 0), 1);
  case 1:
    return b.loop(star_around(random, Point(0.5, 0.5), 0.9, random.integer(3, 9), 0.8));
  default:
    return b.loop({Point(0.5, -1), Point(2, 0.5), Point(0.5, 2), Point(-1, 0.5)});
  }
}

Point place_in_frame(Random& random) {
  return random.integer(0, 2) == 0 ? Point(0.5, 0.5) : random_point(random, 0.3, 0.7);
}

/// Two vertices, with or without a segment between them.
Pslg isolated_pairs(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_frame(b, random);
  for (int k = random.integer(1, 3); k > 0; --k) {
    const Point p = place_in_frame(random), q = p + tiny(random) * direction(random);
    if (p == q) continue;
    if (random.integer(0, 2) > 0)
      b.vertex(p), b.vertex(q);
    else
      add_uncrossed(b, p, q);
  }
  return b.pslg;
}

/// Tiny polygons, holes or not.
Pslg tiny_polygons(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_frame(b, random);
  const Point c = place_in_frame(random);
  const double r = tiny(random);
  switch (random.integer(0, 2)) {
  case 0:
    add_square(b, c, r);
    break;
  case 1:
    b.loop(star_around(random, c, r, random.integer(3, 8), 0.5));
    break;
  default:
    b.loop({c, c + r * direction(random), c + r * direction(random)});
  }
  if (random.integer(0, 2) == 0) {
    const Point &p = b.pslg.vertices.end()[-1], &q = b.pslg.vertices.end()[-2],
                &s = b.pslg.vertices.end()[-3];
    b.pslg.holes.push_back(Point((p.x() + q.x() + s.x()) / 3, (p.y() + q.y() + s.y()) / 3));
  }
  return b.pslg;
}

/// Clusters in clusters, each at a vertex of the last one.
Pslg nested_clusters(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_frame(b, random);
  Point c = place_in_frame(random);
  double r = std::ldexp(1.0, -random.integer(5, 12));
  for (int depth = random.integer(2, 4); depth > 0; --depth) {
    for (int k = random.integer(1, 4); k > 0; --k) b.vertex(c + r * direction(random));
    c = b.pslg.vertices.back();
    r = std::ldexp(r, -random.integer(6, 14));
  }
  return b.pslg;
}

/// A polyline that winds around the origin, ever nearer to it, down to 2^-60 or 2^-900.
Pslg deep_spirals(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_square(b, Point(-2, -2), 4);
  const int bottom = random.integer(0, 1) == 0 ? random.integer(20, 60) : random.integer(60, 900);
  const double ratio = random.between(0.35, 0.8);
  // A turn by a rational angle, about 50 degrees.
  const double t = random.between(0.35, 0.6), cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
  Vector v = direction(random);
  std::size_t last = b.vertex(Point(v.x(), v.y()));
  double length = 1;
  while (length > std::ldexp(1.0, -bottom)) {
    v = ratio * Vector(cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y());
    length *= ratio;
    const std::size_t next = b.vertex(Point(v.x(), v.y()));
    if (random.integer(0, 9) > 0) b.segment(last, next);
    last = next;
  }
  if (random.integer(0, 1) == 0) b.vertex(Point(0, 0));
  return b.pslg;
}

/// Vertices and short segments around the end of a segment.
Pslg features_at_ends(std::uint64_t seed) {
  Random random(seed);
  Builder b;
  add_frame(b, random);
  const Point p = place_in_frame(random);
  const Vector along = direction(random);
  const std::size_t end = b.vertex(p);
  b.segment(end, b.vertex(p + random.between(0.01, 0.15) * along));
  for (int k = random.integer(1, 4); k > 0; --k) {
    const double r = tiny(random);
    const Vector to = random.integer(0, 2) == 0 ? -along : direction(random);
    const Point q = p + r * to;
    if (q == p) continue;
    if (random.integer(0, 1) == 0)
      b.vertex(q);
    else
      add_uncrossed(b, q, q + r * random.between(0.1, 4) * direction(random));
  }
  return b.pslg;
}

} // namespace

std::vector<Family> tiny_feature_families() {
  return {{"isolated-pairs", isolated_pairs},
          {"tiny-polygons", tiny_polygons},
          {"nested-clusters", nested_clusters},
          {"deep-spirals", deep_spirals},
          {"features-at-ends", features_at_ends}};
}

} // namespace soak
