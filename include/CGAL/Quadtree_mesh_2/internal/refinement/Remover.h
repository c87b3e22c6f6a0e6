// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Guarded removal of vertices. Takes out Steiner vertices whose star can be triangulated without them within
// the bounds.
//
// Computes: the star of a free vertex is one polygon. That of a vertex on an edge is one or two, closed by
//           the merged subsegment. A vertex is removed if all its polygons can be triangulated within the
//           bounds. Every triangle made is checked, so the bounds are kept unconditionally.
// Bound:    O(k^3) for a polygon of k vertices. Mostly O(k): if no triangle on its shortest side is feasible,
//           a polygon cannot be triangulated. On maps, nine trials out of ten end there.
// Source:   Klincsek (1980): dynamic programming over sub-polygons for the greatest least angle.
// Deviates: restricted to feasible triangles. Bit j of `forward[i]` says that the sub-polygon i..j can be
//           triangulated within the bounds.
//
// There are two passes in order of creation. The second is over vertices whose star has changed. Large stars
// are tried in small meshes alone. Of others hardly one can be triangulated.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_REMOVER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_REMOVER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Progress.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Star.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Remover {
public:
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  using Shape = typename Kernel_mesh<Geometry>::Shape;
  static constexpr int passes = 2; ///< of a run

  explicit Remover(Meshing_state<Geometry>& state) : Remover(state, state.bounds) {}
  /// Keeps to other bounds than those of the state.
  Remover(Meshing_state<Geometry>& state, const Bounds<Geometry>& bounds)
      : state_(state), mesh_(state.mesh), bounds_(bounds) {}

  /// Removes what can be removed, of the vertices whose star has changed since that was last tried.
  /// \returns the number of vertices removed.
  template <class Continue>
  std::size_t run(Continue&& shall_go_on) {
    std::size_t removed = 0;
    for (int pass = 0; pass < passes; ++pass)
      for (const Vertex_id v : mesh_.points.ids()) {
        if (is_time_to_ask(std::size_t(v)) && !shall_go_on()) return removed;
        if (!is_to_be_tried(v)) continue;
        prefetch_after(v);
        removed += remove_if_changed(v) ? 1 : 0;
      }
    return removed;
  }

  /// Whether a vertex might be removed, and its star has changed since that was last tried.
  bool is_to_be_tried(Vertex_id v) const {
    return mesh_.is_dirty[v] != 0 && !mesh_.is_input(v) && mesh_.is_used(v);
  }

  /// Removes such a vertex if it can be removed; reads and writes its star and what is next to that.
  bool remove_if_changed(Vertex_id v) {
    const int largest = state_.is_small_mesh() ? Star::max_size : largest_star;
    const bool is_collected = star_.collect(mesh_, v, largest);
    if (!is_collected && star_.size < largest) return false; // perhaps at a seam: another round may do it
    mesh_.is_dirty[v] = 0;
    return is_collected && try_to_remove(v);
  }

  /// Removes one vertex, if it is a Steiner vertex whose star can be triangulated without it.
  bool remove(Vertex_id v) {
    return !mesh_.is_input(v) && mesh_.is_used(v) && star_.collect(mesh_, v) && try_to_remove(v);
  }

private:
  static constexpr int max_polygon = 13;
  static constexpr std::uint32_t foresight = 8; // vertices
  static constexpr int largest_star = 9;        // of a mesh that is not small

  /// A polygon of the star, counterclockwise, and the triangles it is cut into.
  struct Polygon {
    int size = 0;
    Region_id region;
    Vertex_id v[Star::max_size + 2];
  };

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  const Bounds<Geometry> bounds_;
  Star star_;
  // the new triangles, and the subsegment a-b that the removed vertex split
  Vertex_id made_[Star::max_size + 2][3];
  Region_id region_of_made_[Star::max_size + 2];
  int number_made_ = 0;
  Vertex_id merged_a_, merged_b_ = Vertex_id();
  // the polygon's vertices, relative to its first, and the dynamic program
  Vector place_[max_polygon];
  double quality_[max_polygon][max_polygon];
  std::int8_t middle_[max_polygon][max_polygon];

  /// Prefetches a triangle of a later vertex, and what is next to that of one before it.
  void prefetch_after(Vertex_id v) const {
    const Vertex_id later(v.value() + foresight), much_later(v.value() + 2 * foresight);
    if (!mesh_.triangle_of.has(much_later)) return;
    mesh_.prefetch_star(much_later);
    if (!mesh_.is_used(later)) return;
    mesh_.prefetch_corners(mesh_.incident_triangle(later));
    mesh_.prefetch_neighbors(mesh_.incident_triangle(later));
  }

  /// \pre the star is that of v
  bool try_to_remove(Vertex_id v) {
    number_made_ = 0;
    merged_a_ = merged_b_ = {};
    if (mesh_.is_free(v)) {
      if (!star_.is_closed || !triangulate(polygon(0, star_.size - 1))) return false;
    } else if (star_.is_closed) {
      if (!triangulate_both_sides()) return false;
    } else {
      if (crosses_constraint()) return false;
      merged_a_ = star_.link[0], merged_b_ = star_.link[star_.size];
      if (!triangulate(polygon(0, star_.size))) return false;
    }
    replace(v);
    return true;
  }

  /// The polygon of the link vertices first..last, indices modulo the size of a closed star.
  Polygon polygon(int first, int last) const {
    Polygon p;
    p.region = mesh_.region(star_.corner[first].triangle());
    for (int i = first; i <= last; ++i)
      p.v[p.size++] = star_.link[star_.is_closed && i >= star_.size ? i - star_.size : i];
    return p;
  }

  /// Whether a constrained edge lies within the open star.
  bool crosses_constraint() const {
    for (int i = 1; i < star_.size; ++i) {
      const Side c = star_.corner[i];
      if (mesh_.triangle(c.triangle()).side[previous_slot[c.slot()]].is_constrained()) return true;
    }
    return false;
  }

  bool triangulate_both_sides() {
    int a = -1, b = -1;
    for (int i = 0; i < star_.size; ++i) {
      const Side c = star_.corner[i];
      if (!mesh_.triangle(c.triangle()).side[previous_slot[c.slot()]].is_constrained()) continue;
      if (b >= 0) return false; // more than its own edge meets here
      (a < 0 ? a : b) = i;
    }
    if (b < 0 || b - a < 2 || a + star_.size - b < 2) return false;
    merged_a_ = star_.link[a], merged_b_ = star_.link[b];
    return triangulate(polygon(a, b)) && triangulate(polygon(b, a + star_.size));
  }

  /// Appends a triangulation of the polygon within the bounds to `made_`, if there is one.
  bool triangulate(const Polygon& p) {
    const int n = p.size;
    if (n < 3 || n > max_polygon) return false;
    for (int i = 0; i < n; ++i)
      place_[i] = Geometry::scaled_difference(mesh_.point(p.v[i]), mesh_.point(p.v[0]));
    if (!has_triangle_on_shortest_side(p) || !fill_table(p)) return false;
    const int first = number_made_;
    emit(p, 0, n - 1);
    return is_within_bounds(first) && (!is_near_corner(p) || withstands_flips(first));
  }

  /// Whether the new triangles are counterclockwise and within the bounds by their own differences: those of `place_`
  /// are rounded at the scale of the polygon, and a side may be far shorter.
  bool is_within_bounds(int first) const {
    for (int i = first; i < number_made_; ++i) {
      const Vertex_id* t = made_[i];
      const Shape s = mesh_.shape(t[0], t[1], t[2]);
      if (!s.is_certainly_counterclockwise() && mesh_.orientation(t[0], t[1], t[2]) <= 0) return false;
      if (!keeps_bounds(s, t[0], t[1], t[2], region_of_made_[i], true)) return false;
    }
    return true;
  }

  /// Whether some triangle of the polygon's vertices on its shortest side is not below the bound, with a little to
  /// spare, or may be excused: without one the polygon is not feasible, and nearly all polygons that are not fail here.
  /// No branches: they would be taken at random.
  bool has_triangle_on_shortest_side(const Polygon& p) const {
    constexpr double to_spare = 1 - 1e-9;
    const int n = p.size;
    int end = 0; // of the side; the place before it is the other end
    Number least = squared_length(place_[n - 1]);
    for (int k = 1; k < n; ++k) {
      const Number length = squared_length(place_[k] - place_[k - 1]);
      end = length < least ? k : end;
      least = length < least ? length : least;
    }
    const int begin = end == 0 ? n - 1 : end - 1;
    const Vector from = place_[begin], side = place_[end] - from;
    int found = 0;
    for (int m = 0; m < n; ++m) { // the ends themselves have no area
      const Vector u = place_[m] - from, v = u - side;
      const Shape s = {{squared_length(v), squared_length(u), least}, cross(side, u)};
      const int is_left = s.area2 > 0 ? 1 : 0, is_wide = s.is_below(to_spare * bounds_.sin2) ? 0 : 1;
      found |= is_left & is_wide;
    }
    return found != 0 ||
           (state_.corners.is_on_leg(mesh_, p.v[begin]) && state_.corners.is_on_leg(mesh_, p.v[end]));
  }

  bool is_near_corner(const Polygon& p) const {
    for (int i = 0; i < p.size; ++i)
      if (state_.corners.is_on_leg(mesh_, p.v[i])) return true;
    return false;
  }

  /// Fills the table; whether the whole polygon is feasible.
  bool fill_table(const Polygon& p) {
    const int n = p.size;
    const bool may_be_exempt = is_near_corner(p);
    std::uint32_t forward[max_polygon],
        backward[max_polygon]; // bit j of forward[i], bit i of backward[j]: i..j is feasible
    for (int i = 0; i < n; ++i) {
      forward[i] = i + 1 < n ? 1u << (i + 1) : 0;
      backward[i] = i > 0 ? 1u << (i - 1) : 0;
      if (i + 1 < n) quality_[i][i + 1] = 2;
    }
    for (int length = 2; length < n; ++length) {
      bool is_any = false;
      for (int i = 0; i + length < n; ++i) {
        const int j = i + length;
        double best = 0;
        int best_middle = -1;
        for (std::uint32_t middles = forward[i] & backward[j]; middles != 0; middles &= middles - 1) {
          const int m = lowest_bit(middles);
          const Shape s = shape(i, m, j);
          if (!is_feasible(s, p, i, m, j, may_be_exempt)) continue;
          const double w = std::min(weight(s), std::min(quality_[i][m], quality_[m][j]));
          if (w > best) best = w, best_middle = m;
        }
        if (best_middle < 0) continue;
        forward[i] |= 1u << j, backward[j] |= 1u << i;
        quality_[i][j] = best, middle_[i][j] = static_cast<std::int8_t>(best_middle);
        is_any = true;
      }
      if (!is_any && length == 2) return false; // not even an ear
    }
    return (forward[0] >> (n - 1) & 1u) != 0;
  }

  /// The triangle of the polygon's vertices a < b < c.
  Shape shape(int a, int b, int c) const {
    const Vector u = place_[b] - place_[a], v = place_[c] - place_[a];
    return {{squared_length(place_[c] - place_[b]), squared_length(v), squared_length(u)}, cross(u, v)};
  }

  /// Whether the triangle of the polygon's vertices a < b < c, of shape s, meets the bounds, or a corner
  /// excuses it.
  bool is_feasible(const Shape& s, const Polygon& p, int a, int b, int c, bool may_be_exempt) const {
    const Vertex_id x = p.v[a], y = p.v[b], z = p.v[c];
    return s.area2 > 0 && keeps_bounds(s, x, y, z, p.region, may_be_exempt);
  }

  bool keeps_bounds(const Shape& s, Vertex_id x, Vertex_id y, Vertex_id z, Region_id region,
                    bool may_be_exempt) const {
    if (bounds_.is_misshapen(s) && !(may_be_exempt && state_.is_exempt(x, y, z))) return false;
    return !bounds_.is_large(s, mesh_.point(x), mesh_.point(y), mesh_.point(z), region);
  }

  /// The squared sine of the least angle of a feasible triangle. Exempt ones count as better than others,
  /// which then have no say. Among exempt ones the best are preferred, because they are the Delaunay ones.
  double weight(const Shape& s) const { return (bounds_.is_misshapen(s) ? 1 : 0) + s.sin2_of_least_angle(); }

  void emit(const Polygon& p, int i, int j) {
    if (j - i < 2) return;
    const int m = middle_[i][j];
    region_of_made_[number_made_] = p.region;
    Vertex_id* t = made_[number_made_++];
    t[0] = p.v[i], t[1] = p.v[m], t[2] = p.v[j];
    emit(p, i, m), emit(p, m, j);
  }

  /// Whether the flips that follow leave triangles within the bounds. Near a corner, the last flips, which
  /// make the mesh Delaunay, could take an exempt triangle apart. This looks at the flips that come first:
  /// those among the new triangles and with what is around. Where four vertices are on a circle up to
  /// rounding, as in lattices, any diagonal will do.
  bool withstands_flips(int first) const {
    for (int i = first; i < number_made_; ++i)
      for (int k = 0; k < 3; ++k) {
        const Vertex_id a = made_[i][next_slot[k]], b = made_[i][previous_slot[k]], c = made_[i][k];
        const Vertex_id d = apex_across(first, a, b);
        if (!d.is_valid() ||
            !Geometry::is_in_circle(mesh_.point(c), mesh_.point(a), mesh_.point(b), mesh_.point(d)))
          continue;
        const Region_id region = region_of_made_[i];
        if (!keeps_bounds(mesh_.shape(a, d, c), a, d, c, region, true) ||
            !keeps_bounds(mesh_.shape(d, b, c), d, b, c, region, true))
          return false;
      }
    return true;
  }

  /// The vertex opposite the edge a-b on its right: of a new triangle, or of the mesh beyond the star; none
  /// behind a constraint.
  Vertex_id apex_across(int first, Vertex_id a, Vertex_id b) const {
    for (int i = first; i < number_made_; ++i)
      for (int k = 0; k < 3; ++k)
        if (made_[i][next_slot[k]] == b && made_[i][previous_slot[k]] == a) return made_[i][k];
    for (int i = 0; i < star_.size; ++i) {
      const Vertex_id to = star_.link[i + 1];
      if (star_.link[i] != a || to != b) continue;
      const Side o = mesh_.across(star_.corner[i]);
      return o.is_constrained() ? Vertex_id() : mesh_.opposite(o);
    }
    return {};
  }

  struct Open_side {
    Vertex_id a, b;
    Side side;
  };

  /// Puts the new triangles in place of the star.
  void replace(Vertex_id v) {
    Side beyond[Star::max_size];
    for (int i = 0; i < star_.size; ++i) beyond[i] = mesh_.across(star_.corner[i]);
    for (int i = number_made_; i < star_.size; ++i) mesh_.kill(star_.corner[i].triangle());
    for (int i = 0; i < number_made_; ++i) {
      const Triangle_id t = star_.corner[i].triangle();
      mesh_.set_region(t, region_of_made_[i]);
      for (int k = 0; k < 3; ++k) {
        mesh_.triangle(t).v[k] = made_[i][k];
        mesh_.triangle_of[made_[i][k]] = t;
      }
    }
    Open_side open[3 * Star::max_size];
    int number_open = 0;
    for (int i = 0; i < number_made_; ++i)
      for (int k = 0; k < 3; ++k) connect(Side(star_.corner[i].triangle(), k), beyond, open, number_open);
    mesh_.triangle_of[v] = {};
    for (int i = 0; i < star_.number_of_link_vertices(); ++i) mesh_.is_dirty[star_.link[i]] = 1;
  }

  /// Links a side of a new triangle to the mesh beyond the star, to a new triangle made before, or leaves it
  /// open for a later one.
  void connect(Side s, const Side* beyond, Open_side* open, int& number_open) {
    const Vertex_id a = mesh_.source(s), b = mesh_.target(s);
    for (int j = 0; j < star_.size; ++j)
      if (star_.link[j] == a && star_.link[j + 1] == b) return mesh_.link(s.triangle(), s.slot(), beyond[j]);
    for (int j = 0; j < number_open; ++j)
      if (open[j].a == b && open[j].b == a) {
        const bool is_merged = (a == merged_a_ && b == merged_b_) || (a == merged_b_ && b == merged_a_);
        mesh_.link(s.triangle(), s.slot(), Side(open[j].side.triangle(), open[j].side.slot(), is_merged));
        open[j] = open[--number_open];
        return;
      }
    mesh_.triangle(s.triangle()).side[s.slot()] = Side::border();
    open[number_open++] = {a, b, s};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_REMOVER_H
