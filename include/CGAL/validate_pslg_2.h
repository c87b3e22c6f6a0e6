// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_VALIDATE_PSLG_2_H
#define CGAL_VALIDATE_PSLG_2_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Wide_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/part_names.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

// Checks whether a Pslg_2 can be meshed at all, in O(n) time, without further memory or constructions. The
// only geometric question is whether all vertices lie on a line; the answer is exact. find_pslg_defects.h
// tells whether segments cross or overlap.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Number>
bool is_finite_coordinate(const Number& x) {
  if constexpr (std::is_floating_point_v<Number>)
    return std::isfinite(x);
  else if constexpr (std::is_integral_v<Number>)
    return true;
  else
    return CGAL::is_finite(x);
}

template <class Point>
bool is_finite_point(const Point& p) {
  return is_finite_coordinate(p.x()) && is_finite_coordinate(p.y());
}

/// Whether (`a - b`) times (`c - d`) equals (`e - f`) times (`g - h`), for words. Differences of 64-bit words
/// need 65 bits and their products 130. That is more than 128, so signs and magnitudes are compared
/// separately.
template <class Word>
bool are_equal_products(Word a, Word b, Word c, Word d, Word e, Word f, Word g, Word h) {
  static_assert(sizeof(Word) <= 8, "products of wider words do not fit 128 bits");
  const auto distance = [](Word s, Word t) {
    return s < t ? std::uint64_t(t) - std::uint64_t(s) : std::uint64_t(s) - std::uint64_t(t);
  };
  const Product_of_words left = product_of_words(distance(a, b), distance(c, d));
  const Product_of_words right = product_of_words(distance(e, f), distance(g, h));
  if (!(left == right)) return false;
  return left == Product_of_words() || ((a < b) != (c < d)) == ((e < f) != (g < h));
}

/// Whether three points are on a line. Exact for words, for doubles with any kernel, and for kernels with
/// exact predicates.
template <class Point>
bool are_collinear(const Point& p, const Point& q, const Point& r) {
  using Coordinate = Coordinate_t<Point>;
  if constexpr (std::is_integral_v<Coordinate>) {
    return are_equal_products<Coordinate>(q.x(), p.x(), r.y(), p.y(), q.y(), p.y(), r.x(), p.x());
  } else if constexpr (std::is_floating_point_v<Coordinate>) {
    using Exact_point = Exact_predicates_inexact_constructions_kernel::Point_2;
    return CGAL::orientation(Exact_point(p.x(), p.y()), Exact_point(q.x(), q.y()),
                             Exact_point(r.x(), r.y())) == COLLINEAR;
  } else {
    return CGAL::orientation(p, q, r) == COLLINEAR;
  }
}

template <class Point>
bool are_same_point(const Point& p, const Point& q) {
  return p.x() == q.x() && p.y() == q.y();
}

/// The error for the point of a hole or region that lies on a vertex or, if that is invalid, on a segment.
template <class Point>
Pslg_seed_error_2 make_seed_error(const Pslg_2<Point>& pslg, Pslg_seed_error_2::Mark mark, std::size_t seed,
                                  Vertex_index vertex, Segment_index segment) {
  const bool is_hole = mark == Pslg_seed_error_2::Mark::HOLE;
  const std::string what = "the point of " + (is_hole ? hole_text(pslg, seed) : region_text(pslg, seed));
  const std::string where =
      vertex.is_valid() ? vertex_text(pslg, std::size_t(vertex)) : segment_text(pslg, std::size_t(segment));
  return Pslg_seed_error_2(what + " lies on " + where +
                               ", between several components of the plane; move it into one",
                           mark, seed, vertex, segment);
}

inline void check_length(std::size_t length, std::size_t expected, const char* array) {
  if (length != expected)
    throw Pslg_error_2(Pslg_error_2::Kind::ARRAY_LENGTH, std::string(array) + " has " +
                                                             std::to_string(length) + " entries instead of " +
                                                             std::to_string(expected));
}

template <class Point>
void check_pslg_lengths(const Pslg_2<Point>& pslg) {
  const std::size_t n = pslg.vertices.size();
  const std::size_t limit = (std::numeric_limits<Vertex_index::size_type>::max)(); // itself the invalid index
  if (n >= limit || pslg.segments.size() >= limit)
    throw Pslg_error_2(Pslg_error_2::Kind::ARRAY_LENGTH,
                       "more vertices or segments than 32-bit indices can name");
  if (!pslg.vertex_markers.empty()) check_length(pslg.vertex_markers.size(), n, "vertex_markers");
  if (!pslg.segment_markers.empty())
    check_length(pslg.segment_markers.size(), pslg.segments.size(), "segment_markers");
  // By division, because the product may overflow if the number of attributes is garbage.
  const std::size_t k = pslg.number_of_vertex_attributes;
  if (n == 0 || k == 0)
    check_length(pslg.vertex_attributes.size(), 0, "vertex_attributes");
  else if (pslg.vertex_attributes.size() % k != 0 || pslg.vertex_attributes.size() / k != n)
    throw Pslg_error_2(Pslg_error_2::Kind::ARRAY_LENGTH,
                       "vertex_attributes has " + std::to_string(pslg.vertex_attributes.size()) +
                           " entries instead of " + std::to_string(k) + " for each of " + std::to_string(n) +
                           " vertices");
}

template <class Point>
void check_pslg_coordinates(const Pslg_2<Point>& pslg) {
  constexpr auto kind = Pslg_error_2::Kind::NOT_FINITE;
  for (std::size_t v = 0; v < pslg.vertices.size(); ++v)
    if (!is_finite_point(pslg.vertices[v]))
      throw Pslg_error_2(kind, vertex_text(pslg, v) + " is not finite",
                         Pslg_parts_2().vertex(Vertex_index(v)));
  for (std::size_t h = 0; h < pslg.holes.size(); ++h)
    if (!is_finite_point(pslg.holes[h]))
      throw Pslg_error_2(kind, hole_text(pslg, h) + " is not finite", Pslg_parts_2().hole(h));
  for (std::size_t r = 0; r < pslg.regions.size(); ++r) {
    const auto& region = pslg.regions[r];
    if (!is_finite_point(region.point))
      throw Pslg_error_2(kind, region_text(pslg, r) + " is not finite", Pslg_parts_2().region(r));
    if (!std::isfinite(region.attribute) || !std::isfinite(region.max_area))
      throw Pslg_error_2(kind, region_text(pslg, r) + " has an attribute or an area bound that is not finite",
                         Pslg_parts_2().region(r));
  }
}

template <class Point>
void check_pslg_indices(const Pslg_2<Point>& pslg) {
  for (std::size_t s = 0; s < pslg.segments.size(); ++s)
    for (const Vertex_index v : pslg.segments[s])
      if (std::size_t(v) >= pslg.vertices.size())
        throw Pslg_error_2(
            Pslg_error_2::Kind::NO_SUCH_VERTEX,
            "segment " + number_of_part(pslg, s) + " ends at vertex " + number_of_part(pslg, std::size_t(v)) +
                (pslg.vertices.empty() ? std::string(", but there are no vertices")
                                       : ", but the vertices are " + number_of_part(pslg, 0) + " to " +
                                             number_of_part(pslg, pslg.vertices.size() - 1)),
            Pslg_parts_2().segment(Segment_index(s)));
}

/// Throws unless three vertices span a triangle.
template <class Point>
void check_pslg_extent(const Pslg_2<Point>& pslg) {
  constexpr auto kind = Pslg_error_2::Kind::NO_AREA;
  const std::size_t n = pslg.vertices.size();
  if (n == 0) throw Pslg_error_2(kind, "there are no vertices");
  std::size_t other = 1;
  while (other < n && are_same_point(pslg.vertices[other], pslg.vertices[0])) ++other;
  if (other >= n) {
    const std::string text = n == 1 ? "there is only one vertex, " + vertex_text(pslg, 0)
                                    : "all " + std::to_string(n) + " vertices are one point, " +
                                          coordinates_text(pslg.vertices[0]);
    throw Pslg_error_2(kind, text, Pslg_parts_2().vertex(Vertex_index(0)));
  }
  for (std::size_t v = other + 1; v < n; ++v)
    if (!are_collinear(pslg.vertices[0], pslg.vertices[other], pslg.vertices[v])) return;
  throw Pslg_error_2(kind,
                     "all " + std::to_string(n) + " vertices lie on the line through " +
                         vertex_text(pslg, 0) + " and " + vertex_text(pslg, other),
                     Pslg_parts_2().vertex(Vertex_index(0)).vertex(Vertex_index(other)));
}

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Data
/// Checks the basic requirements of a `Pslg_2`: the arrays fit together, all coordinates are finite, segments
/// end at existing vertices, and the vertices do not all lie on a line.
///
/// Segments of length zero and vertices at the same place pass: see `validate_pslg_2()`. Crossing segments
/// pass, too: see `find_pslg_defects()`. O(n) time, no memory.
/// \throws Pslg_error_2 that names the first culprit by its 0-based index, and in its text by its number and
/// coordinates.
template <class Point>
void check_pslg_structure(const Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::check_pslg_lengths(pslg);
  internal::check_pslg_indices(pslg);
  internal::check_pslg_coordinates(pslg);
  internal::check_pslg_extent(pslg);
}

/// \ingroup PkgQuadtreeMesh2Data
/// The strict form of `check_pslg_structure()`. No segment may have length zero either, whether its ends are
/// one vertex or two vertices at the same place. O(n) time, no memory.
/// \throws Pslg_error_2 that names the first culprit by its 0-based index, and in its text by its number and
/// coordinates.
template <class Point>
void validate_pslg_2(const Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  check_pslg_structure(pslg);
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const auto& [a, b] = pslg.segments[s];
    if (internal::are_same_point(pslg.point(a), pslg.point(b)))
      throw Pslg_error_2(Pslg_error_2::Kind::ZERO_LENGTH,
                         internal::segment_text(pslg, s) + " has length zero",
                         Pslg_parts_2().segment(Quadtree_mesh_2::Segment_index(s)).vertex(a).vertex(b));
  }
}

} // namespace CGAL

#endif // CGAL_VALIDATE_PSLG_2_H
