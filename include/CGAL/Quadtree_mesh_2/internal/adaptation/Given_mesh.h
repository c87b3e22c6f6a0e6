// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A given mesh, checked: its triangles, who is next to whom, which of its edges are constrained, and its components.
//
// Computes: neighbors; the constrained edge at each side; components, which constrained edges separate, with a place
//           inside of each.
// Bound:    O(k log k) time for k triangles, besides the check (Given_mesh_checker.h).
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_GIVEN_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_GIVEN_MESH_H

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Border_sweep.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh_checker.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Input_words.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/triangle_neighbors.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Twice the area of a triangle, in doubles.
template <class Point>
double double_area(const std::array<Point, 3>& t) {
  return (t[1].x() - t[0].x()) * (t[2].y() - t[0].y()) - (t[1].y() - t[0].y()) * (t[2].x() - t[0].x());
}

template <class Point>
Point centroid(const std::array<Point, 3>& t) {
  return Point((t[0].x() + t[1].x() + t[2].x()) / 3, (t[0].y() + t[1].y() + t[2].y()) / 3);
}

/// Of the largest coordinate.
template <class Points>
double magnitude_of(const Points& points) {
  double magnitude = 0;
  for (const auto& p : points) magnitude = std::max({magnitude, std::fabs(p.x()), std::fabs(p.y())});
  return magnitude;
}

/// The power of two by which numbers of a magnitude are divided to be near 1.
inline int exponent_of(double magnitude) {
  return magnitude > 0 && std::isfinite(magnitude) ? std::ilogb(magnitude) : 0;
}

/// The place inside the largest of those triangles that have room for one; nothing if none has.
class Inner_place {
public:
  using Point = Triangle_tree::Point;
  using Corners = Triangle_tree::Corners;

  /// \param magnitude of the largest coordinate; products of coordinates may be beyond doubles
  explicit Inner_place(double magnitude) : exponent_(exponent_of(magnitude)) {}

  /// One more triangle.
  void offer(const Corners& t) {
    const Corners small{scaled(t[0], -exponent_), scaled(t[1], -exponent_), scaled(t[2], -exponent_)};
    const double area = double_area(small);
    if (!(area > area_)) return;
    const Point p = scaled(centroid(small), exponent_);
    const auto turn = Triangle_tree::Kernel().orientation_2_object();
    for (std::size_t k = 0; k < 3; ++k)
      if (turn(t[k], t[(k + 1) % 3], p) != LEFT_TURN) return;
    area_ = area, place_ = p;
  }
  const std::optional<Point>& get() const { return place_; }

private:
  int exponent_;
  double area_ = 0;
  std::optional<Point> place_;

  static Point scaled(const Point& p, int exponent) {
    return Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent));
  }
};

class Given_mesh {
public:
  using Mesh = Indexed_mesh_2<Triangle_tree::Point>;
  struct Component {
    std::size_t first_triangle;
    Triangle_tree::Point inside;
  };

  /// \param first_number what messages count from
  /// \throws Pslg_error_2 naming the triangles at fault if they are no mesh
  Given_mesh(const Mesh& mesh, std::size_t first_number) : mesh_(mesh), checker_(mesh, first_number) {
    checker_.check();
    check_range(first_number);
    tree_.emplace(mesh.points, mesh.triangles);
    neighbors_ = triangle_neighbors<Sequential_tag>(mesh.triangles, mesh.points.size());
    touches_ = checker_.touches(*tree_, neighbors_);
  }

  const Mesh& mesh() const { return mesh_; }
  /// Where the border touches itself but for ends of edges.
  const Border_touches& touches() const { return touches_; }
  /// \throws Pslg_error_2 naming what touches
  void refuse_touches() const { checker_.refuse(touches_); }
  const Triangle_tree& tree() const { return *tree_; }
  const std::vector<std::array<Triangle_index, 3>>& neighbors() const { return neighbors_; }
  Triangle_tree::Corners corners(std::size_t t) const {
    const auto& v = mesh_.triangles[t];
    return {mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2])};
  }

  /// The components of triangles that no constrained edge separates, in the order of their first triangles.
  /// \param is_constrained whether the edge between two vertices is
  /// \param[out] component_of per triangle, its component
  /// \throws Pslg_error_2 if coordinates have no room for a place in one
  template <class Is_constrained>
  std::vector<Component> components(const Is_constrained& is_constrained,
                                    std::vector<int>& component_of) const {
    std::vector<Component> result;
    component_of.assign(mesh_.triangles.size(), -1);
    std::vector<std::size_t> stack;
    const double magnitude = magnitude_of(mesh_.points);
    for (std::size_t first = 0; first < mesh_.triangles.size(); ++first) {
      if (component_of[first] >= 0) continue;
      const int component = static_cast<int>(result.size());
      Inner_place place(magnitude);
      component_of[first] = component, stack.push_back(first);
      while (!stack.empty()) {
        const std::size_t t = stack.back();
        stack.pop_back();
        place.offer(corners(t));
        for (std::size_t k = 0; k < 3; ++k) {
          const Triangle_index n = neighbors_[t][k];
          const auto& v = mesh_.triangles[t];
          if (!n.is_valid() || component_of[std::size_t(n)] >= 0 ||
              is_constrained(v[(k + 1) % 3], v[(k + 2) % 3]))
            continue;
          component_of[std::size_t(n)] = component, stack.push_back(std::size_t(n));
        }
      }
      const auto& inside = place.get();
      if (!inside)
        throw Pslg_error_2(Pslg_error_2::Kind::ROUNDING,
                           "the component of " + checker_.text(first) +
                               " of the mesh is too thin: the coordinates have no room for a point in it",
                           Pslg_parts_2().triangle(Triangle_index(first)));
      result.push_back({first, *inside});
    }
    return result;
  }

private:
  /// \throws Pslg_error_2 for coordinates that the mesher would refuse
  void check_range(std::size_t first_number) const try {
    Filtered_quadtree_traits_2<>().construct_grid_2_object()(mesh_.points);
  } catch (const Point_error& error) {
    Pslg_2<Triangle_tree::Point> pslg;
    pslg.vertices = mesh_.points, pslg.first_number = first_number;
    const Order in_place;
    throw Input_words<Triangle_tree::Point>(pslg, in_place).out_of_range(error);
  }

  const Mesh& mesh_;
  Given_mesh_checker checker_;
  std::optional<Triangle_tree> tree_;
  std::vector<std::array<Triangle_index, 3>> neighbors_;
  Border_touches touches_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_GIVEN_MESH_H
