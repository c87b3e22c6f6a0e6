// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A triangulation kept as the rings of its vertices. Meshes of points are relaxed and coarsened in it.
//
// The ring of a vertex is its neighbors, counterclockwise. On the border it is open and goes from one border
// edge to the other. Triangles are implicit: a vertex and two successive members of its ring. So the star of
// a vertex, which is all that relaxation looks at, is one cache line. A change is undone by restoring a few
// rings. There are no numbers of triangles on whose order anything could depend. Degrees are bounded, which
// costs nothing: if all angles are acute and not tiny, few vertices have more than ten neighbors. All
// operations take O(degree) time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_MESH_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Ring_vertex = Index<struct Ring_vertex_tag>;

enum class Mobility : std::uint8_t {
  FREE,
  SLIDES_ALONG,  ///< on a border side in the direction of `Ring_mesh::along`
  SLIDES_ACROSS, ///< on a border side perpendicular to it
  HELD,          ///< fixed for the time being
  FIXED,
  RIGID, ///< fixed, and triangles of rigid vertices only are right by construction: nothing is asked of them
  REMOVED
};

constexpr bool is_movable(Mobility m) { return m < Mobility::HELD; }

/// One cache line for each vertex.
struct alignas(64) Ring {
  static constexpr int max_size = 14;

  std::array<Ring_vertex, max_size> neighbor;
  std::uint8_t size = 0;
  Mobility mobility = Mobility::FREE;
  bool is_open = false;
  /// The widest patch with which the vertex could not be removed, since something changed near it.
  std::uint8_t tried_rings = 0;
  /// Who may write the vertex now; nobody if negative.
  std::int32_t block = 0;
  static constexpr std::int32_t sealed = -2; ///< nobody in a mesh that is a part

  int number_of_triangles() const { return is_open ? size - 1 : size; }
  int position_of(Ring_vertex v) const {
    int k = 0;
    while (neighbor[std::size_t(k)] != v) ++k;
    return k;
  }
  bool contains(Ring_vertex v) const {
    for (int k = 0; k < size; ++k)
      if (neighbor[std::size_t(k)] == v) return true;
    return false;
  }
  Ring_vertex operator[](int k) const { return neighbor[std::size_t(k)]; }
  /// The member after position k, cyclically in closed rings.
  Ring_vertex next(int k) const { return neighbor[std::size_t(k + 1 == size ? 0 : k + 1)]; }
  Ring_vertex previous(int k) const { return neighbor[std::size_t(k == 0 ? size - 1 : k - 1)]; }

  void erase(int k) {
    --size;
    for (; k < size; ++k) neighbor[std::size_t(k)] = neighbor[std::size_t(k + 1)];
  }
  /// Makes v the member at position k; the others move up. \pre size < max_size
  void insert(int k, Ring_vertex v) {
    for (int i = size; i > k; --i) neighbor[std::size_t(i)] = neighbor[std::size_t(i - 1)];
    neighbor[std::size_t(k)] = v;
    ++size;
  }
};

template <class Geometry>
class Ring_mesh {
public:
  using Point = typename Geometry::Point;

  Indexed_vector<Ring_vertex, Point> points;
  Indexed_vector<Ring_vertex, Ring> rings;
  /// The direction of two of the four sides of the border.
  Vector along{1, 0};

  std::size_t number_of_vertices() const { return rings.size(); }
  Ring& ring(Ring_vertex v) { return rings[v]; }
  const Ring& ring(Ring_vertex v) const { return rings[v]; }
  const Point& point(Ring_vertex v) const { return points[v]; }
  bool is_alive(Ring_vertex v) const { return ring(v).mobility != Mobility::REMOVED; }

  /// The vertex across the edge from `a` to the member at position `k` of its ring, to the right of it; none on the
  /// border.
  Ring_vertex right_of(Ring_vertex a, int k) const {
    const Ring& r = ring(a);
    return r.is_open && k == 0 ? Ring_vertex() : r.previous(k);
  }

  /// Builds the rings of triangles, given counterclockwise, over the present points. Closed rings begin with their
  /// least member, whatever the order of the triangles. Points without triangles count as removed.
  /// \param triangles with random access
  /// \pre the triangles are those of a disk, every vertex has at most `Ring::max_size` neighbors
  template <class Triangles>
  void set_triangles(const Triangles& triangles) {
    std::vector<std::uint32_t> first(points.size() + 2, 0);
    for (const auto& t : triangles)
      for (const auto v : t) ++first[std::size_t(v) + 2];
    for (std::size_t v = 2; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<std::uint32_t> triangle_at(
        first.back()); // half the memory of the sides, where most is needed
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const auto v : triangles[t])
        triangle_at[first[std::size_t(v) + 1]++] = static_cast<std::uint32_t>(t);
    rings.resize(points.size());
    std::vector<Side> sides;
    for (const Ring_vertex v : rings.ids()) {
      sides.clear();
      for (std::uint32_t i = first[v.value()]; i < first[v.value() + 1]; ++i)
        sides.push_back(side_opposite(v, triangles[triangle_at[i]]));
      rings[v] = ring_of_sides(sides.data(), sides.data() + sides.size());
    }
  }

  /// Makes the ring of a vertex anew, of the sides opposite it.
  void set_ring(Ring_vertex v, const std::vector<std::array<Ring_vertex, 2>>& sides) {
    Ring r = ring_of_sides(sides.data(), sides.data() + sides.size());
    r.mobility = ring(v).mobility;
    ring(v) = r;
  }

  /// Calls f(a, b, c) for each triangle, counterclockwise, `a` being its least vertex; by increasing `a`.
  template <class F>
  void for_each_triangle(F f) const {
    for (const Ring_vertex v : rings.ids()) for_each_triangle_of(v, f);
  }
  /// For those whose least vertex is v.
  template <class F>
  void for_each_triangle_of(Ring_vertex v, F f) const {
    const Ring& r = ring(v);
    if (r.mobility == Mobility::REMOVED) return;
    for (int k = 0; k < r.number_of_triangles(); ++k)
      if (v < r[k] && v < r.next(k)) f(v, r[k], r.next(k));
  }

  std::size_t number_of_triangles() const {
    std::size_t corners = 0;
    for (const Ring& r : rings)
      if (r.mobility != Mobility::REMOVED) corners += static_cast<unsigned>(r.number_of_triangles());
    return corners / 3;
  }

private:
  using Side = std::array<Ring_vertex, 2>;

  template <class Triangle>
  static Side side_opposite(Ring_vertex v, const Triangle& t) {
    const std::size_t k = Ring_vertex(t[0]) == v ? 0 : Ring_vertex(t[1]) == v ? 1 : 2;
    return {Ring_vertex(t[(k + 1) % 3]), Ring_vertex(t[(k + 2) % 3])};
  }

  /// The ring of a vertex, from the sides opposite it.
  static Ring ring_of_sides(const Side* begin, const Side* end) {
    Ring r;
    if (begin == end) {
      r.mobility = Mobility::REMOVED;
      return r;
    }
    const auto side_from = [&](Ring_vertex v) {
      return std::find_if(begin, end, [v](const Side& s) { return s[0] == v; });
    };
    const Side* start = std::find_if(begin, end, [&](const Side& s) {
      return std::none_of(begin, end, [&s](const Side& o) { return o[1] == s[0]; });
    });
    r.is_open = start != end;
    if (!r.is_open) start = std::min_element(begin, end);
    const Ring_vertex first = (*start)[0];
    for (const Side* s = start; s != end && (r.size == 0 || (*s)[0] != first); s = side_from((*s)[1])) {
      CGAL_precondition(r.size < Ring::max_size);
      r.insert(r.size, (*s)[0]);
      if (r.is_open && side_from((*s)[1]) == end) r.insert(r.size, (*s)[1]);
    }
    return r;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_RING_MESH_H
