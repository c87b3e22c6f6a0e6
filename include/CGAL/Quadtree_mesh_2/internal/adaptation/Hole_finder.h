// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A place in each hole of a mesh.
//
// Computes: a place in each bounded component of the plane that the mesh does not cover.
// Bound:    O(b log b) expected time for b edges on the border, around vertices of any degree whose neighbors have few.
// Source:   ours. A constrained triangulation of the border edges, whose components are asked for.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_HOLE_FINDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_HOLE_FINDER_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/mark_domain.h>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Hole_finder {
public:
  using Point = Triangle_tree::Point;

  /// \pre the border of the mesh does not touch itself but at vertices
  explicit Hole_finder(const Given_mesh& given) : magnitude_(magnitude_of(given.mesh().points)) {
    const Given_mesh::Mesh& mesh = given.mesh();
    Border border;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (!given.neighbors()[t][k].is_valid())
          border.add(mesh, mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]);
    for (const auto& [a, b] : border.edges) border_.insert(ends(border.points[a], border.points[b]));
    border.begin_edges_at_lesser_degrees();
    // all at a time, as CGAL puts the points into an order in which they are found soon
    cdt_.insert_constraints(border.points.begin(), border.points.end(), border.edges.begin(),
                            border.edges.end());
  }

  /// \throws Pslg_error_2 if coordinates have no room for a place in one
  std::vector<Point> places() {
    flood_component<Cdt>(
        cdt_.infinite_face(), [this](Face_handle f) { return visit(f); }, [](Face_handle) {});
    std::vector<Point> places;
    for (const Face_handle first : cdt_.finite_face_handles())
      if (reached_.count(&*first) == 0)
        if (const auto place = place_if_hole(first)) places.push_back(*place);
    return places;
  }

private:
  using Cdt = Constrained_Delaunay_triangulation_2<Triangle_tree::Kernel>;
  using Face_handle = Cdt::Face_handle;
  using Ends = std::array<double, 4>;

  /// The edges with a triangle on one side.
  struct Border {
    std::vector<Point> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges;

    void add(const Given_mesh::Mesh& mesh, Vertex_index a, Vertex_index b) {
      const std::size_t first = number(mesh, a); // before the other one
      edges.emplace_back(first, number(mesh, b));
    }

    /// CGAL looks for an edge all around the first of its ends.
    void begin_edges_at_lesser_degrees() {
      std::vector<std::size_t> degree(points.size(), 0);
      for (const auto& [a, b] : edges) ++degree[a], ++degree[b];
      for (auto& [a, b] : edges)
        if (degree[b] < degree[a]) std::swap(a, b);
    }

  private:
    std::unordered_map<std::size_t, std::size_t> number_of_; // per vertex, its point

    std::size_t number(const Given_mesh::Mesh& mesh, Vertex_index v) {
      const auto [entry, is_new] = number_of_.emplace(std::size_t(v), points.size());
      if (is_new) points.push_back(mesh.point(v));
      return entry->second;
    }
  };

  double magnitude_;
  Cdt cdt_;
  std::set<Ends> border_; // edges with the mesh on their left
  std::unordered_set<const Cdt::Face*> reached_;

  static Ends ends(const Point& a, const Point& b) { return {a.x(), a.y(), b.x(), b.y()}; }
  bool visit(Face_handle f) { return reached_.insert(&*f).second; }

  /// Whether the mesh covers a face, as a side of it tells.
  bool is_known_as_covered(Face_handle f) const {
    for (int k = 0; k < 3; ++k)
      if (f->is_constrained(k) &&
          border_.count(ends(f->vertex(Cdt::ccw(k))->point(), f->vertex(Cdt::cw(k))->point())) > 0)
        return true;
    return false;
  }

  /// Visits the component of a face.
  std::optional<Point> place_if_hole(Face_handle first) {
    Inner_place place(magnitude_);
    bool is_covered = false;
    flood_component<Cdt>(
        first,
        [&](Face_handle f) {
          if (!visit(f)) return false;
          place.offer({f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()});
          is_covered = is_covered || is_known_as_covered(f);
          return true;
        },
        [](Face_handle) {});
    if (is_covered) return std::nullopt;
    const auto& inside = place.get();
    if (!inside)
      throw Pslg_error_2(Pslg_error_2::Kind::ROUNDING,
                         "the hole of the mesh at " + coordinates_text(first->vertex(0)->point()) +
                             " is too thin: the coordinates have no room for a point in it");
    return inside;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_HOLE_FINDER_H
