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

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh_checker.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/triangle_neighbors.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The ends of an edge in one number, whatever their order.
inline std::uint64_t edge_key(Vertex_index a, Vertex_index b) {
  const auto [least, other] = std::minmax({a.value(), b.value()});
  return std::uint64_t(least) << 32 | other;
}

/// Twice the area of a triangle, in doubles.
template <class Point>
double double_area(const std::array<Point, 3>& t) {
  return (t[1].x() - t[0].x()) * (t[2].y() - t[0].y()) - (t[1].y() - t[0].y()) * (t[2].x() - t[0].x());
}

template <class Point>
Point centroid(const std::array<Point, 3>& t) {
  return Point((t[0].x() + t[1].x() + t[2].x()) / 3, (t[0].y() + t[1].y() + t[2].y()) / 3);
}

/// The place inside the largest of some triangles; nothing if rounding leaves none.
class Inner_place {
public:
  using Corners = Triangle_tree::Corners;

  /// One more triangle.
  void offer(const Corners& t) {
    if (const double area = double_area(t); area > area_) area_ = area, corners_ = t;
  }
  std::optional<Triangle_tree::Point> get() const {
    if (!(area_ > 0)) return std::nullopt;
    const auto p = centroid(corners_);
    const auto turn = Triangle_tree::Kernel().orientation_2_object();
    for (std::size_t k = 0; k < 3; ++k)
      if (turn(corners_[k], corners_[(k + 1) % 3], p) != LEFT_TURN) return std::nullopt;
    return p;
  }

private:
  double area_ = 0;
  Corners corners_;
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
  Given_mesh(const Mesh& mesh, std::size_t first_number) : mesh_(mesh) {
    const Given_mesh_checker checker(mesh, first_number);
    checker.check();
    tree_.emplace(mesh.points, mesh.triangles);
    neighbors_ = triangle_neighbors<Sequential_tag>(mesh.triangles, mesh.points.size());
    checker.check_overlaps(*tree_, neighbors_);
  }

  const Mesh& mesh() const { return mesh_; }
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
    for (std::size_t first = 0; first < mesh_.triangles.size(); ++first) {
      if (component_of[first] >= 0) continue;
      const int component = static_cast<int>(result.size());
      Inner_place place;
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
      const auto inside = place.get();
      if (!inside)
        throw Pslg_error_2(
            Pslg_error_2::Kind::ROUNDING,
            "a component of the mesh is too thin: the coordinates have no room for a point in it",
            Pslg_parts_2().triangle(Triangle_index(first)));
      result.push_back({first, *inside});
    }
    return result;
  }

private:
  const Mesh& mesh_;
  std::optional<Triangle_tree> tree_;
  std::vector<std::array<Triangle_index, 3>> neighbors_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_GIVEN_MESH_H
