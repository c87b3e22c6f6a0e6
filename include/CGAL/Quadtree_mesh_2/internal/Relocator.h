// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Moves a Steiner vertex so that its whole star meets the bound ("warping" on demand).
//
// Pattern search for the greatest least angle of the star, from the better of the present place and the
// centroid of the link: eight directions, the step halved when none is better, given up early when the angle
// stays far below the bound. The eight candidates of a step are evaluated together in single precision,
// relative to the vertex, in loops of constant length 8 that compilers turn into vector instructions; the
// place found is accepted only by the test in double precision on the final coordinates. A vertex on an edge
// moves along its edge; one on a leg of an acute corner stays. O(degree) a step, at most 8 steps.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELOCATOR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELOCATOR_H

#include <CGAL/Quadtree_mesh_2/internal/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/Star.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Relocator {
public:
  using Point = typename Geometry::Point;

  explicit Relocator(Meshing_state<Geometry>& state) : state_(state), mesh_(state.mesh) {}

  /// Moves Steiner vertex v to a place where all its triangles meet the bounds, if one is found, and then
  /// restores the Delaunay property around it (without that an insertion may not destroy the triangle it is
  /// made for).
  bool relocate(Vertex_id v) {
    if (!star_.collect(mesh_, v)) return false;
    const Edge_id e = mesh_.edge_of[std::size_t(v)];
    const bool is_moved = e == free_vertex ? star_.is_closed && relocate_free(v) : relocate_on_edge(v, e);
    if (!is_moved) return false;
    for (int i = 0; i < star_.size; ++i) {
      const Side c = star_.corner[i];
      state_.doubtful_sides.push_back(c);
      state_.doubtful_sides.push_back(Side(c.triangle(), next_slot[c.slot()]));
    }
    state_.legalize();
    return true;
  }

private:
  static constexpr int directions = 8;
  static constexpr int max_steps = 8;
  static constexpr double first_step = 0.2; // of the mean distance to the link
  // Given up after step i if the best squared sine is below this share of the bound's.
  static constexpr float hope[max_steps] = {0, 0.7f, 0.8f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f};

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Star star_;
  // The link relative to the vertex, scaled to mean distance 1, and its squared edge lengths.
  float x_[Star::max_size + 1], y_[Star::max_size + 1], edge2_[Star::max_size];
  double scale_ = 1;

  /// Sets up the scaled link; returns its centroid.
  Vector prepare_link(Point origin) {
    Vector link[Star::max_size], centroid;
    double sum = 0;
    for (int i = 0; i < star_.size; ++i) {
      link[i] = Geometry::difference(mesh_.point(star_.link[i]), origin);
      sum += squared_length(link[i]);
      centroid = centroid + link[i];
    }
    scale_ = std::sqrt(sum / star_.size);
    const double inverse = 1 / scale_;
    for (int i = 0; i < star_.size; ++i) {
      x_[i] = static_cast<float>(link[i].x * inverse);
      y_[i] = static_cast<float>(link[i].y * inverse);
    }
    x_[star_.size] = x_[0], y_[star_.size] = y_[0];
    for (int i = 0; i < star_.size; ++i) {
      const float dx = x_[i + 1] - x_[i], dy = y_[i + 1] - y_[i];
      edge2_[i] = dx * dx + dy * dy;
    }
    return (inverse / star_.size) * centroid;
  }

  /// The squared sines (signed) of the least angle of the star with the vertex at each of the 8 places.
  void evaluate(const float (&px)[directions], const float (&py)[directions],
                float (&least)[directions]) const {
    float ux[directions], uy[directions], ul[directions];
    for (int k = 0; k < directions; ++k) {
      least[k] = 2;
      ux[k] = x_[0] - px[k], uy[k] = y_[0] - py[k];
      ul[k] = ux[k] * ux[k] + uy[k] * uy[k];
    }
    for (int i = 0; i < star_.size; ++i) {
      const float nx = x_[i + 1], ny = y_[i + 1], el = edge2_[i];
      for (int k = 0; k < directions; ++k) {
        const float wx = nx - px[k], wy = ny - py[k], wl = wx * wx + wy * wy;
        const float area2 = ux[k] * wy - uy[k] * wx;
        const float m = ul[k] < wl ? ul[k] : wl, shortest = m < el ? m : el;
        const float q = area2 * std::fabs(area2) * shortest / (ul[k] * wl * el);
        least[k] = q < least[k] ? q : least[k];
        ux[k] = wx, uy[k] = wy, ul[k] = wl;
      }
    }
  }

  bool relocate_free(Vertex_id v) {
    static constexpr float cx[directions] = {1, .70710678f, 0, -.70710678f, -1, -.70710678f, 0, .70710678f};
    static constexpr float cy[directions] = {0, .70710678f, 1, .70710678f, 0, -.70710678f, -1, -.70710678f};
    const Point origin = mesh_.point(v);
    const Vector centroid = prepare_link(origin);
    // the first evaluation compares the present place with the centroid
    float px[directions] = {0, static_cast<float>(centroid.x)},
          py[directions] = {0, static_cast<float>(centroid.y)};
    float least[directions];
    evaluate(px, py, least);
    const int start = least[1] > least[0] ? 1 : 0;
    float x = px[start], y = py[start], best = least[start];
    const float bound = static_cast<float>(state_.bounds.sin2), goal = bound * (1 + 1e-5f);
    float step = static_cast<float>(first_step);
    for (int i = 0; best < goal; ++i) {
      if (i == max_steps || (i > 0 && best < bound * hope[i])) return false;
      for (int k = 0; k < directions; ++k) px[k] = x + step * cx[k], py[k] = y + step * cy[k];
      evaluate(px, py, least);
      const int k = static_cast<int>(std::max_element(least, least + directions) - least);
      if (least[k] > best * 1.0001f)
        best = least[k], x = px[k], y = py[k];
      else
        step *= 0.5f;
    }
    return accept(v, Geometry::translate(origin, {scale_ * double(x), scale_ * double(y)}));
  }

  /// Moves v to p if all its triangles meet the bounds there.
  bool accept(Vertex_id v, Point p) {
    for (int i = 0; i < star_.size; ++i) {
      const Shape s = mesh_.shape(p, mesh_.point(star_.link[i]), mesh_.point(star_.link[i + 1]));
      if (s.area2 <= 0 || state_.bounds.is_sharp(s) ||
          state_.bounds.is_large(s, p, mesh_.point(star_.link[i]), mesh_.point(star_.link[i + 1]),
                                 mesh_.region(star_.corner[i].triangle())))
        return false;
    }
    mesh_.points[std::size_t(v)] = p;
    return true;
  }

  bool relocate_on_edge(Vertex_id v, Edge_id e) {
    const Input_edge& edge = state_.edges[e];
    const auto& is_acute = state_.corners.is_acute;
    if (is_acute[std::size_t(edge.a)] != 0 || is_acute[std::size_t(edge.b)] != 0) return false;
    const Vector d =
        Geometry::difference(state_.problem.input_point(edge.b), state_.problem.input_point(edge.a));
    const Vector direction = (1 / std::sqrt(squared_length(d))) * d;
    const Point origin = mesh_.point(v);
    double place = 0, best = least_of_star(origin, -1), step = first_step * mean_distance(origin);
    for (int i = 0; i < max_steps && best < state_.bounds.sin2; ++i) {
      bool is_better = false;
      for (const double sign : {-1.0, 1.0}) {
        const double q = least_of_star(Geometry::translate(origin, (place + sign * step) * direction), best);
        if (q <= best * 1.0001 + 1e-9) continue;
        best = q, place += sign * step, is_better = true;
      }
      if (!is_better) step *= 0.5;
    }
    return place != 0 && accept(v, Geometry::translate(origin, place * direction));
  }

  double mean_distance(Point p) const {
    double sum = 0;
    for (int i = 0; i < star_.number_of_link_vertices(); ++i)
      sum += squared_length(Geometry::difference(mesh_.point(star_.link[i]), p));
    return std::sqrt(sum / star_.number_of_link_vertices());
  }

  /// The least squared sine of the star with the vertex at p; something at most `floor` as soon as it falls
  /// to that.
  double least_of_star(Point p, double floor) const {
    double least = 2;
    for (int i = 0; i < star_.size && least > floor; ++i) {
      const Shape s = mesh_.shape(p, mesh_.point(star_.link[i]), mesh_.point(star_.link[i + 1]));
      least = s.area2 <= 0 ? -1 : std::min(least, s.sin2_of_least_angle());
    }
    return least;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELOCATOR_H
