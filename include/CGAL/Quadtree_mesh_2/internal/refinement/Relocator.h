// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Moves a Steiner vertex so that its whole star meets the bound ("warping" on demand).
//
// Computes: the place with the greatest least angle of the star, by pattern search. The search starts from
//           the best of the present place, the centroid of the link, and two more places on the line through
//           them. It tries eight directions, and halves the step if none is better. It gives up early if the
//           angle stays far below the bound.
// Bound:    O(degree) for a step, at most 8 steps.
// Method:   The eight candidates of a step are evaluated together in single precision, relative to the
//           vertex, in vectors of four. A step ends as soon as none of them can serve. It begins with the
//           triangle that was worst at the start, so this is soon. The place found is accepted only by a test
//           in double precision on the final coordinates.
//
// Large stars, and those that start far below the bound, are hardly ever cured. In a mesh that is not small
// they are not tried. A vertex on an edge moves along it, where some place may do (may_star_meet_bound_on_line.h).
// One on a leg of an acute corner stays, unless legs are free. The same search smooths if it has no bound to stop at.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_RELOCATOR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_RELOCATOR_H

#include <CGAL/Quadtree_mesh_2/internal/base/Float_lanes.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/may_star_meet_bound_on_line.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Star.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Relocator {
public:
  using Point = typename Geometry::Point;
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  using Shape = typename Kernel_mesh<Geometry>::Shape;

  explicit Relocator(Meshing_state<Geometry>& state) : state_(state), mesh_(state.mesh) {}

  /// Moves Steiner vertex v to a place where all its triangles meet the bounds, if one is found, and then
  /// restores the Delaunay property around it (without that an insertion may not destroy the triangle it is
  /// made for).
  bool relocate(Vertex_id v) { return move(v, Aim::BOUND); }

  /// The same, where an angle is above the greatest one. The place is that of the greatest least angle that the search
  /// finds: near it all angles are best.
  bool relocate_for_shape(Vertex_id v) { return move(v, Aim::SHAPE); }

  /// Moves Steiner vertex v to a place where all triangles of the star that it is to have meet the bounds, if one is
  /// found. The search begins at its place now.
  bool relocate_in(const Star& star, Vertex_id v) {
    star_ = star;
    return search(v, Aim::BOUND);
  }

  /// Moves Steiner vertex v to where the least angle of its star is greatest, as far as the search finds it, if all
  /// its triangles meet the bounds there; and restores the Delaunay property.
  bool improve(Vertex_id v) {
    if (!move(v, Aim::BEST)) return false;
    for (int i = 0; i < star_.number_of_link_vertices(); ++i) mesh_.is_dirty[star_.link[i]] = 1;
    mesh_.is_dirty[v] = 1;
    return true;
  }

private:
  /// What is enough: a star that meets the bound; nothing but the best one; or the best one, if it meets the bounds.
  enum class Aim { BOUND, BEST, SHAPE };

  bool move(Vertex_id v, Aim aim) {
    if (!star_.collect(mesh_, v, is_hurried(aim) ? largest_star : Star::max_size)) return false;
    if (!search(v, aim)) return false;
    for (int i = 0; i < star_.size; ++i) {
      const Side c = star_.corner[i];
      state_.doubtful_sides.push_back(c);
      state_.doubtful_sides.push_back(Side(c.triangle(), next_slot[c.slot()]));
    }
    state_.legalize();
    return true;
  }

  bool search(Vertex_id v, Aim aim) {
    return mesh_.is_free(v) ? star_.is_closed && relocate_free(v, aim)
                            : relocate_on_edge(v, mesh_.edge(v), aim);
  }

  static constexpr int directions = 8;
  static constexpr int max_steps = 8;
  // Of larger stars hardly one in 200 is cured.
  static constexpr int largest_star = 9;
  // Given up before the first step if the squared sine is below this share of the bound's: one in 500 would be cured.
  static constexpr float hope_at_start = 0.3f;
  static constexpr double first_step = 0.2; // of the mean distance to the link
  /// Of the squared sine, for a step to be taken: by this factor and this difference.
  static constexpr double least_gain_of_step = 1.0001, least_difference = 1e-9;
  // Given up after step i if the best squared sine is below this share of the bound's.
  static constexpr float hope[max_steps - 1] = {0.7f, 0.8f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f};

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Star star_;
  // The link relative to the vertex, scaled to mean distance 1, and its squared edge lengths.
  float x_[Star::max_size + 1], y_[Star::max_size + 1], edge2_[Star::max_size];
  Number scale_ = 1;
  Basic_vector<double> link_[Star::max_size + 1]; // relative to a vertex on an edge, in a unit

  bool is_hurried(Aim aim) const { return aim == Aim::BOUND && !state_.is_small_mesh(); }

  static float float_of(const Number& n) { return static_cast<float>(ratio(n, 1)); }

  /// Sets up the scaled link; returns its centroid.
  Vector prepare_link(Point origin) {
    using std::sqrt;
    Number x[Star::max_size], y[Star::max_size], sum = 0;
    Vector centroid;
    for (int i = 0; i < star_.size; ++i) {
      const Vector p = Geometry::scaled_difference(mesh_.point(star_.link[i]), origin);
      sum += squared_length(p);
      centroid = centroid + p;
      x[i] = p.x, y[i] = p.y;
    }
    scale_ = sqrt(sum / star_.size);
    const Number inverse = 1 / scale_;
    for (int i = 0; i < star_.size; ++i) {
      x_[i] = float_of(x[i] * inverse);
      y_[i] = float_of(y[i] * inverse);
    }
    x_[star_.size] = x_[0], y_[star_.size] = y_[0];
    for (int i = 0; i < star_.size; ++i) {
      const float dx = x_[i + 1] - x_[i], dy = y_[i + 1] - y_[i];
      edge2_[i] = dx * dx + dy * dy;
    }
    return (inverse / star_.size) * centroid;
  }

  /// From the vertex at four places to a link vertex, and the squares of the distances.
  struct Spokes {
    Float_lanes x, y, length2;
    Spokes(float to_x, float to_y, Float_lanes from_x, Float_lanes from_y)
        : x(to_x - from_x), y(to_y - from_y), length2(x * x + y * y) {}
  };

  /// The squared sines of the least angles of the triangles between two consecutive spokes, with the sign of
  /// the area.
  static Float_lanes signed_sin2(const Spokes& u, const Spokes& w, Float_lanes edge2) {
    const Float_lanes area2 = u.x * w.y - u.y * w.x;
    return area2 * abs(area2) * min(min(u.length2, w.length2), edge2) / (u.length2 * w.length2 * edge2);
  }

  struct Start {
    float x, y;
    float least;     ///< signed squared sine of the least angle of the star there
    int of_triangle; ///< of the star, with that angle
  };

  /// The best of the present place, the centroid, the middle between them, and as far beyond the centroid.
  Start best_start(Vector centroid) const {
    const float cx = float_of(centroid.x), cy = float_of(centroid.y);
    const Float_lanes px(0, cx, 0.5f * cx, 1.5f * cx);
    const Float_lanes py(0, cy, 0.5f * cy, 1.5f * cy);
    Float_lanes least = 2, of_triangle = 0;
    Spokes u(x_[0], y_[0], px, py);
    for (int i = 0; i < star_.size; ++i) {
      const Spokes w(x_[i + 1], y_[i + 1], px, py);
      const Float_lanes q = signed_sin2(u, w, edge2_[i]);
      of_triangle = select_where_less(q, least, static_cast<float>(i), of_triangle);
      least = min(q, least);
      u = w;
    }
    int k = 0;
    for (const int other : {1, 2, 3}) k = least[other] > least[k] ? other : k;
    return {px[k], py[k], least[k], static_cast<int>(of_triangle[k])};
  }

  /// The signed squared sines of the least angle of the star with the vertex at each of the eight places,
  /// from triangle `first` on; false as soon as all are below `hopeless`.
  bool evaluate(const Float_lanes (&px)[2], const Float_lanes (&py)[2], int first, float hopeless,
                Float_lanes (&least)[2]) const {
    Spokes u0(x_[first], y_[first], px[0], py[0]), u1(x_[first], y_[first], px[1], py[1]);
    Float_lanes least0 = 2, least1 = 2;
    for (int i = first;;) {
      const float edge2 = edge2_[i++];
      const Spokes w0(x_[i], y_[i], px[0], py[0]), w1(x_[i], y_[i], px[1], py[1]);
      least0 = min(signed_sin2(u0, w0, edge2), least0);
      least1 = min(signed_sin2(u1, w1, edge2), least1);
      if (!is_any_at_least(least0, least1, hopeless)) return false;
      if (i == star_.size) i = 0;
      if (i == first) break;
      u0 = w0, u1 = w1;
    }
    least[0] = least0, least[1] = least1;
    return true;
  }

  static int place_of_greatest(const Float_lanes (&a)[2]) {
    int place = 0;
    float greatest = a[0][0];
    for (int k = 1; k < directions; ++k) {
      const float x = a[k / 4][k % 4];
      place = x > greatest ? k : place; // no branches: they would be taken at random
      greatest = x > greatest ? x : greatest;
    }
    return place;
  }

  bool relocate_free(Vertex_id v, Aim aim) {
    constexpr float d = .70710678f;
    const Float_lanes cx[2] = {{1, d, 0, -d}, {-1, -d, 0, d}}, cy[2] = {{0, d, 1, d}, {0, -d, -1, -d}};
    const Point origin = mesh_.point(v);
    const Start start = best_start(prepare_link(origin));
    float x = start.x, y = start.y, best = start.least;
    const float bound = static_cast<float>(state_.bounds.sin2);
    const float goal = aim == Aim::BOUND ? bound * (1 + 1e-5f) : 1;
    if (is_hurried(aim) && best < hope_at_start * bound) return false;
    float step = static_cast<float>(first_step);
    for (int i = 0; i < max_steps && best < goal; ++i) {
      const float hoped = i + 1 < max_steps ? bound * hope[i] : goal;
      const float needed = aim == Aim::BOUND ? hoped : 0; // to go on after this step
      const Float_lanes px[2] = {x + step * cx[0], x + step * cx[1]};
      const Float_lanes py[2] = {y + step * cy[0], y + step * cy[1]};
      const float improved = best * 1.0001f;
      Float_lanes least[2];
      const bool is_hope = evaluate(px, py, start.of_triangle, best < needed ? needed : improved, least);
      const int k = is_hope ? place_of_greatest(least) : 0;
      if (is_hope && least[k / 4][k % 4] > improved)
        best = least[k / 4][k % 4], x = px[k / 4][k % 4], y = py[k / 4][k % 4];
      else
        step *= 0.5f;
      if (best < needed) return false;
    }
    return accept(v, Geometry::translate(origin, Vector{scale_ * double(x), scale_ * double(y)}), aim);
  }

  /// Moves v to p if all its triangles meet the bounds there and, to be the best, the least angle grows.
  bool accept(Vertex_id v, Point p, Aim aim) {
    constexpr double least_gain = 1.001; // of the squared sine
    if (aim == Aim::BEST && least_with_vertex_at(p) < least_gain * least_with_vertex_at(mesh_.point(v)))
      return false;
    for (int i = 0; i < star_.size; ++i) {
      const Shape s = mesh_.shape(p, mesh_.point(star_.link[i]), mesh_.point(star_.link[i + 1]));
      if (!s.is_certainly_counterclockwise() || state_.bounds.is_misshapen(s) ||
          state_.bounds.is_large(s, p, mesh_.point(star_.link[i]), mesh_.point(star_.link[i + 1]),
                                 mesh_.region(star_.corner[i].triangle())))
        return false;
    }
    if (!is_far_from_link(p)) return false;
    mesh_.points[v] = p;
    return true;
  }

  /// The least squared sine of the star with the vertex at p, -1 if the star is not one then.
  double least_with_vertex_at(const Point& p) const {
    double least = 2;
    for (int i = 0; i < star_.size; ++i) {
      const Shape s = mesh_.shape(p, mesh_.point(star_.link[i]), mesh_.point(star_.link[i + 1]));
      if (s.area2 <= 0) return -1;
      least = std::min(least, s.sin2_of_least_angle());
    }
    return least;
  }

  /// Whether p keeps the least length of edges, to the link and to what flips may join it with.
  bool is_far_from_link(const Point& p) const {
    const double least = state_.bounds.least_squared_length;
    const auto is_far = [&](Vertex_id w) {
      return squared_length(Geometry::scaled_difference(mesh_.point(w), p)) >= least;
    };
    for (int i = 0; i < star_.number_of_link_vertices() && least > 0; ++i)
      if (!is_far(star_.link[i])) return false;
    for (int i = 0; i < star_.size && least > 0; ++i) {
      const Side o = mesh_.across(star_.corner[i]);
      if (!o.is_constrained() && !is_far(mesh_.opposite(o))) return false;
    }
    return true;
  }

  /// Searches along the edge with vectors, from the vertex's place; the place found is then made as a share of
  /// the input edge, so that the vertex is as near to it as it can be however often it has moved.
  bool relocate_on_edge(Vertex_id v, Edge_id e, Aim aim) {
    const Input_edge& edge = state_.edges[e];
    const auto& is_acute = state_.corners.is_acute;
    if (state_.leg_rule == Leg_rule::SHELLS && (is_acute[edge.a] != 0 || is_acute[edge.b] != 0)) return false;
    const Point &a = state_.problem.input_point(edge.a), &b = state_.problem.input_point(edge.b);
    const Vector from_a = Geometry::scaled_difference(mesh_.point(v), a),
                 from_b = Geometry::scaled_difference(mesh_.point(v), b);
    const Vector d = Geometry::scaled_difference(b, a);
    const Number whole = length(d);
    const Number unit = prepare_link_of_edge(mesh_.point(v));
    const Vector unit_vector = (1 / whole) * d;
    const Basic_vector<double> direction{ratio(unit_vector.x, 1), ratio(unit_vector.y, 1)};
    if (aim == Aim::BOUND && !may_star_meet_bound_on_line(link_, star_.size, direction, state_.bounds.sin2))
      return false;
    const Number place = unit * place_on_line(direction, aim);
    if (place == 0) return false;
    // shares are finest near the end from which they are taken
    const bool is_nearer_to_a = squared_length(from_a) <= squared_length(from_b);
    const Number share_of_a = dot(from_a, d) / squared_length(d) + place / whole;
    const Number share_of_b = -dot(from_b, d) / squared_length(d) - place / whole;
    const Point p =
        is_nearer_to_a ? Geometry::between(a, b, share_of_a) : Geometry::between(b, a, share_of_b);
    return state_.problem.is_clear_of_outside(e, p) && accept(v, p, aim);
  }

  /// How far to go from the vertex along a direction for the best star that is found, in the unit of the link.
  double place_on_line(Basic_vector<double> direction, Aim aim) const {
    const double goal = aim == Aim::BOUND ? state_.bounds.sin2 : 1;
    int worst = 0; // triangle of the star
    double best = least_of_star({0, 0}, -1, worst);
    double place = 0, step = first_step * mean_distance_of_link();
    for (int i = 0; i < max_steps && best < goal; ++i) {
      bool is_better = false;
      for (const double sign : {-1.0, 1.0}) {
        const double q = least_of_star((place + sign * step) * direction, best, worst);
        if (q <= best * least_gain_of_step + least_difference) continue;
        best = q, place = place + sign * step, is_better = true;
      }
      if (!is_better) step = 0.5 * step;
    }
    return place;
  }

  /// Sets up the link relative to the vertex, in a power of two next to its longest distance. So the search is one in
  /// doubles, whatever the numbers are, and rounded alike in any unit. Returns the unit.
  Number prepare_link_of_edge(const Point& origin) {
    using std::sqrt;
    Vector link[Star::max_size + 1];
    Number longest2 = 0;
    for (int i = 0; i <= star_.size; ++i) {
      link[i] = Geometry::scaled_difference(mesh_.point(star_.link[i]), origin);
      longest2 = std::max(longest2, squared_length(link[i]));
    }
    const Number unit = power_of_two_at_most(sqrt(longest2));
    for (int i = 0; i <= star_.size; ++i) link_[i] = {ratio(link[i].x, unit), ratio(link[i].y, unit)};
    return unit;
  }

  double mean_distance_of_link() const {
    double sum = 0;
    for (int i = 0; i < star_.number_of_link_vertices(); ++i) sum += squared_length(link_[i]);
    return std::sqrt(sum / star_.number_of_link_vertices());
  }

  /// The least squared sine of the star with the vertex at `p`, relative to its place; something at most `floor` as
  /// soon as it falls to that. From the triangle `worst` on, which becomes the one with that angle: it is as likely to
  /// be the worst of the next place, and then no other is looked at.
  double least_of_star(Basic_vector<double> p, double floor, int& worst) const {
    double least = 2;
    int i = worst;
    for (int looked_at = 0; looked_at < star_.size && least > floor; ++looked_at) {
      const auto u = link_[i] - p, v = link_[i + 1] - link_[i], w = link_[i + 1] - p;
      const Basic_shape<double> s = {{squared_length(v), squared_length(w), squared_length(u)}, cross(u, v)};
      const double sin2 = s.area2 <= 0 ? -1 : s.sin2_of_least_angle();
      if (sin2 < least) least = sin2, worst = i;
      i = i + 1 < star_.size ? i + 1 : 0;
    }
    return least;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_RELOCATOR_H
