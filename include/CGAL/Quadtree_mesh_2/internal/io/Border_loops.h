// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_BORDER_LOOPS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_BORDER_LOOPS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

// The border of a mesh as simple loops of vertices, for flow models. From the triangles alone, as meshes made by hand
// have no neighbors. O(T log d) for T triangles and at most d of them at a vertex.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The vertices of a loop in order, the domain on the left, none twice. The least index is in front.
using Border_loop = std::vector<Vertex_index>;

/// Each side of a triangle without a triangle behind it is in one loop. Loops are sorted by their first vertices.
struct Border_loops {
  std::vector<Border_loop> outer;   ///< counterclockwise: one for each set of triangles connected by sides
  std::vector<Border_loop> islands; ///< clockwise, around holes
};

/// Finds the loops. A walk along the border goes on in the fan of triangles in which it comes to a vertex, so it never
/// crosses itself. Where it comes to a vertex again, as where holes touch, a loop is cut off.
template <class Point>
class Border_loop_finder {
public:
  explicit Border_loop_finder(const Indexed_mesh_2<Point>& mesh)
      : mesh_(mesh), first_corner_(mesh.points.size() + 1, 0), place_in_path_(mesh.points.size(), nowhere) {
    gather_corners();
  }

  Border_loops loops() {
    std::vector<char> is_walked(corners_.size(), 0);
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      for (std::size_t c = first_corner_[v]; c < first_corner_[v + 1]; ++c)
        if (is_walked[c] == 0 && corner_before(Vertex_index(v), corners_[c].next) == nowhere)
          walk(Vertex_index(v), c, is_walked);
    for (auto* loops : {&loops_.outer, &loops_.islands}) std::sort(loops->begin(), loops->end());
    return std::move(loops_);
  }

private:
  static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

  /// What a triangle has besides a vertex.
  struct Corner {
    Vertex_index next, previous; ///< counterclockwise
  };

  /// The corners at each vertex, sorted by the vertex before it.
  void gather_corners() {
    for (const auto& t : mesh_.triangles)
      for (const Vertex_index v : t) ++first_corner_[std::size_t(v) + 1];
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) first_corner_[v + 1] += first_corner_[v];
    std::vector<std::size_t> end(first_corner_.begin(), first_corner_.end() - 1);
    corners_.resize(3 * mesh_.triangles.size());
    for (const auto& t : mesh_.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        corners_[end[std::size_t(t[k])]++] = {t[(k + 1) % 3], t[(k + 2) % 3]};
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      std::sort(begin_at(v), begin_at(v + 1),
                [](const Corner& a, const Corner& b) { return a.previous < b.previous; });
  }
  typename std::vector<Corner>::iterator begin_at(std::size_t v) {
    return corners_.begin() + static_cast<std::ptrdiff_t>(first_corner_[v]);
  }

  /// The corner at `v` of the triangle with the side from `previous` to `v`; `nowhere` if there is none.
  std::size_t corner_before(Vertex_index v, Vertex_index previous) {
    const auto end = begin_at(std::size_t(v) + 1);
    const auto found =
        std::lower_bound(begin_at(std::size_t(v)), end, previous,
                         [](const Corner& c, Vertex_index sought) { return c.previous < sought; });
    if (found == end || found->previous != previous) return nowhere;
    return static_cast<std::size_t>(found - corners_.begin());
  }

  /// The last corner of the fan at `v` in which the border comes from `from`: the border goes on to its `next`.
  std::size_t end_of_fan(Vertex_index from, Vertex_index v) {
    std::size_t c = corner_before(v, from);
    for (std::size_t further = c; further != nowhere; further = corner_before(v, corners_[c].next))
      c = further;
    return c;
  }

  void walk(Vertex_index v, std::size_t start, std::vector<char>& is_walked) {
    Border_loop path;
    std::size_t c = start;
    do {
      is_walked[c] = 1;
      cut_off(path, place_in_path_[v]);
      place_in_path_[v] = path.size();
      path.push_back(v);
      const Vertex_index next = corners_[c].next;
      c = end_of_fan(v, next);
      v = next;
    } while (c != start);
    cut_off(path, 0);
  }

  /// Takes what a path has from a place on as a loop.
  void cut_off(Border_loop& path, std::size_t place) {
    if (place == nowhere) return;
    const auto begin = path.begin() + static_cast<std::ptrdiff_t>(place);
    Border_loop loop(begin, path.end());
    path.erase(begin, path.end());
    for (const Vertex_index v : loop) place_in_path_[v] = nowhere;
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    (is_clockwise(loop) ? loops_.islands : loops_.outer).push_back(std::move(loop));
  }

  /// By the turn at the first vertex in the order of coordinates, exactly.
  bool is_clockwise(const Border_loop& loop) const {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const auto point = [&](std::size_t i) {
      const Point& p = mesh_.point(loop[i % loop.size()]);
      return Kernel::Point_2(as_double(p.x()), as_double(p.y()));
    };
    std::size_t first = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
      if (point(i) < point(first)) first = i;
    return orientation(point(first + loop.size() - 1), point(first), point(first + 1)) == RIGHT_TURN;
  }

  const Indexed_mesh_2<Point>& mesh_;
  std::vector<std::size_t> first_corner_; // of each vertex, in `corners_`
  std::vector<Corner> corners_;
  Indexed_vector<Vertex_index, std::size_t> place_in_path_;
  Border_loops loops_;
};

/// \pre sides are between at most two triangles, which are counterclockwise
template <class Point>
Border_loops border_loops(const Indexed_mesh_2<Point>& mesh) {
  return Border_loop_finder<Point>(mesh).loops();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_BORDER_LOOPS_H
