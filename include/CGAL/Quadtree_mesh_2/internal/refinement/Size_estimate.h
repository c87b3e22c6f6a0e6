// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How many triangles a mesh will need, from the constrained Delaunay triangulation of its domain alone.
//
// Computes: an estimate that is within a factor of 3 of the true number on maps and on thin boxes, rings, combs and
//           strips of any aspect, within a factor of 4 on the hard families of the tests, and of 2 for bounds of
//           size (test_quality_mesher_budget.cpp). Needles with short legs in them may take more.
// Bound:    O(n), with `field_samples` calls of the size field and a few for each triangle.
// Source:   Ruppert (1995): up to constants, any mesh with a bound on the least angle has as many triangles
//           as the integral of 1/lfs^2 over the domain, where lfs is the local feature size. Bern, Eppstein
//           and Gilbert (1994) for the layers around points.
// Method:   Four things make the integral large, and each shows in the triangulation. The constants are
//           measured.
//           - A triangle with longest edge L and height h over it asks for about log(L/h) layers.
//           - Two constrained edges that face each other across a gap g, over a length l, ask for about l/g
//             triangles in the gap, and for as many again behind each of them that has domain there, which they
//             grade up to the width of what is there. Such a pair meets in the fan of some vertex, in a sector of
//             its triangles. Either one edge is at the vertex, first or last in the sector, and the other closes a
//             triangle of the sector. Then the pair may meet at an end of the other edge, too, and each time counts
//             half. Or two consecutive edges close triangles of it.
//           - A vertex between two edges that meet makes the wedge beyond it as expensive as the wedge's
//             width there asks for.
//           - Bounds of size ask for the quotient of the area and the area of one triangle.
//           Otherwise edges that share a vertex do not count as facing each other. Rings cut off wedges
//           (Acute_corners.h), and their number grows with the logarithm only.
//
// The same look at each triangle finds where acute sectors may begin (Corner_finder.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SIZE_ESTIMATE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SIZE_ESTIMATE_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Facing_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The area of a triangle that a bound on areas leads to, as a share of the bound.
constexpr double share_of_area = 0.55;
/// The same for a bound h on edges, as a share of h^2.
constexpr double share_of_squared_edge = 0.28;

/// Per triangle of the first triangulation, bit k: an acute sector may begin at its vertex k, which is the first end of
/// a constrained side then.
struct Acute_starts {
  Indexed_vector<Triangle_id, unsigned char> slots_of_triangle;
};

/// Calls `visit(side)` for the slots k of triangles whose `mark(t)` has bit k, in order. They are gathered before that,
/// without branches, which would be taken at random.
template <class Mark, class Visit>
void for_each_marked_slot(const Mark& mark, Id_range<Triangle_id> triangles, const Visit& visit) {
  constexpr std::size_t most = 256; // triangles at once
  Side slots[3 * most];
  const auto end = static_cast<std::size_t>(*triangles.end());
  for (auto first = static_cast<std::size_t>(*triangles.begin()); first < end; first += most) {
    std::size_t count = 0;
    for (const Triangle_id t : Id_range<Triangle_id>(first, std::min(first + most, end))) {
      const unsigned marks = mark(t);
      for (int k = 0; k < 3; ++k) {
        slots[count] = Side(t, k);
        count += marks >> k & 1u;
      }
    }
    std::for_each(slots, slots + count, visit);
  }
}

template <class Geometry>
class Size_estimate {
public:
  using Point = typename Geometry::Point;
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  using Shape = typename Kernel_mesh<Geometry>::Shape;
  using Facing = Facing_edges<Geometry>;

  /// \pre the mesh is the first triangulation, restricted to the domain.
  template <class ConcurrencyTag>
  Size_estimate(const Meshing_state<Geometry>& state, ConcurrencyTag)
      : state_(state), mesh_(state.mesh), least_(std::sqrt(state.bounds.least_squared_length)),
        facing_(mesh_, narrow_, least_) {
    if (state.bounds.squared_length_at)
      for (const auto& r : mesh_.triangles) total_area2_ = total_area2_ + mesh_.shape(r).area2;
    narrow_.assign(mesh_.triangles.size(), 0);
    acute_starts_.slots_of_triangle.assign(mesh_.triangles.size(), 0);
    const Demand all = reduce<ConcurrencyTag>(
        mesh_.triangles.size(), Demand(),
        [this](std::size_t begin, std::size_t end) {
          Demand sum;
          mesh_.for_each_alive({begin, end}, [&](Triangle_id t) { add_triangle(t, sum); });
          return sum;
        },
        [](const Demand& a, const Demand& b) {
          return Demand{a.of_shapes + b.of_shapes, a.of_sizes + b.of_sizes};
        });
    of_shapes_ = all.of_shapes, of_sizes_ = all.of_sizes;
    add_facing_edges<ConcurrencyTag>();
  }

  double triangles() const {
    const double above = std::max(0.0, state_.bounds.angle / radians_per_degree - 20.7);
    return (1 + per_degree * above) * (of_shapes_ + facing_.triangles()) + of_sizes_;
  }
  /// What bounds of size ask for alone.
  double triangles_of_sizes() const { return of_sizes_; }
  /// The pair that asks for most.
  const Facing_pair& worst_pair() const { return facing_.worst(); }
  /// Where acute sectors may begin: the slots that can be the apex in the clockwise-most triangle of one.
  Acute_starts take_acute_starts() { return std::move(acute_starts_); }

private:
  static constexpr double per_triangle = 1.5;
  static constexpr double per_layer = 3;
  static constexpr double ordinary_aspect = 8, largest_aspect = 0x1p52;
  /// By how much more triangles a bound takes above 20.7 degrees.
  static constexpr double per_degree = 0.08;
  static constexpr double field_samples = 20000;

  /// What triangles ask for, each for itself.
  struct Demand {
    double of_shapes = 0, of_sizes = 0;
  };

  const Meshing_state<Geometry>& state_;
  const Kernel_mesh<Geometry>& mesh_;
  double least_;
  Number total_area2_ = 0;
  double of_shapes_ = 0, of_sizes_ = 0;
  typename Facing::Narrow_sides narrow_;
  Facing facing_;
  Acute_starts acute_starts_;

  void add_triangle(Triangle_id t, Demand& demand) {
    const auto& r = mesh_.triangle(t);
    const Shape s = reliable_shape(r);
    unsigned constrained = 0, narrow = 0, starts = 0;
    for (int k = 0; k < 3; ++k) { // no branches: they would be taken at random
      const unsigned is_constrained = r.side[k].is_constrained() ? 1 : 0;
      constrained += is_constrained;
      narrow |= (is_constrained & (2 * s.area2 < s.l[k] ? 1u : 0u)) << k;
      const int apex = next_slot[k]; // of the sector to the left of side k
      starts |= (is_constrained & (s.may_be_below_60_degrees(apex) ? 1u : 0u)) << apex;
    }
    narrow_[t] = static_cast<unsigned char>(state_.problem.keeps_edges() ? splittable(t, narrow) : narrow);
    acute_starts_.slots_of_triangle[t] = static_cast<unsigned char>(starts);
    demand.of_shapes += per_triangle;
    if (constrained < 2 && s.longest() > ordinary_aspect * s.area2) {
      // collinear vertices give no area in doubles
      double aspect = std::min(ratio(s.longest(), s.area2), largest_aspect);
      if (least_ > 0)
        aspect = std::min(aspect, std::max(ordinary_aspect, std::sqrt(ratio(s.longest(), least_ * least_))));
      demand.of_shapes += per_layer * std::log2(std::min(aspect / ordinary_aspect, growth_around(r, s)));
    }
    demand.of_sizes += sizes_demand(t, s);
  }

  /// Those of some sides that may get vertices. The others ask for no triangles in gaps.
  unsigned splittable(Triangle_id t, unsigned sides) const {
    for (int k = 0; k < 3; ++k)
      if ((sides >> k & 1u) != 0 && state_.is_kept(Side(t, k))) sides &= ~(1u << k);
    return sides;
  }

  /// Vertices units in the last place from a line give any area in doubles, also a negative one.
  Shape reliable_shape(const typename Kernel_mesh<Geometry>::Triangle& r) const {
    const Shape s = mesh_.shape(r);
    return s.is_certainly_counterclockwise() ? s : mesh_.shape_of_flat(r.v[0], r.v[1], r.v[2]);
  }

  /// How much longer than the shortest edge of a needle the next edges around its apex are, at least 1: of
  /// needles side by side the layers are in common.
  double growth_around(const typename Kernel_mesh<Geometry>::Triangle& r, const Shape& s) const {
    const int k = s.slot_of_shortest();
    Number next = s.longest();
    for (const int j : {next_slot[k], previous_slot[k]}) {
      const Side o = r.side[j];
      if (o.is_constrained()) continue;
      const auto& n = mesh_.triangle(o.triangle());
      const Side base(o.triangle(), Kernel_mesh<Geometry>::slot_of(n, r.v[k]));
      next = std::min(next, squared_length(Geometry::scaled_difference(mesh_.point(mesh_.source(base)),
                                                                       mesh_.point(mesh_.target(base)))));
    }
    const bool is_needle = s.longest() > 16 * s.shortest();
    return !is_needle ? std::numeric_limits<double>::infinity()
                      : std::max(1.0, std::sqrt(ratio(next, s.shortest())));
  }

  double sizes_demand(Triangle_id t, const Shape& s) const {
    const Bounds<Geometry>& bounds = state_.bounds;
    if (!bounds.is_size_bounded()) return 0;
    double area2 = bounds.area2;
    if (!bounds.area2_of_region.empty() && mesh_.region(t).is_valid())
      area2 = std::min(area2, bounds.area2_of_region[mesh_.region(t)]);
    double per_area2 =
        std::max(1 / (share_of_area * area2), 0.5 / (share_of_squared_edge * bounds.squared_length));
    if (bounds.squared_length_at) per_area2 = std::max(per_area2, field_density(t, s));
    const double finest = least_ > 0 ? 0.5 / (share_of_squared_edge * least_ * least_) : per_area2;
    // finite, so that areas of exact numbers that doubles do not have are worth nothing
    constexpr double densest = std::numeric_limits<double>::max();
    return ratio(s.area2, 1) * std::min({per_area2, finest, densest});
  }

  /// The mean of the density that the size field asks for in t, at the centers of k^2 parts of equal area.
  double field_density(Triangle_id t, const Shape& s) const {
    const auto& r = mesh_.triangle(t);
    const Point& a = mesh_.point(r.v[0]);
    const Vector ab = Geometry::scaled_difference(mesh_.point(r.v[1]), a),
                 ac = Geometry::scaled_difference(mesh_.point(r.v[2]), a);
    const int k = static_cast<int>(std::ceil(std::sqrt(ratio(field_samples * s.area2, total_area2_))));
    double sum = 0;
    for (int i = 0; i < k; ++i)
      for (int j = 0; i + j < k; ++j)
        for (const double third : {1. / 3, 2. / 3}) {
          if (third > 0.5 && i + j + 1 == k) continue; // no second part at the border
          const Point p = Geometry::translate(a, ((i + third) / k) * ab + ((j + third) / k) * ac);
          sum += 0.5 / (share_of_squared_edge * state_.bounds.squared_length_at(p));
        }
    return sum / (static_cast<double>(k) * k);
  }

  // ---- edges that face each other

  /// Adds the sectors in which narrow sides are, each once.
  template <class ConcurrencyTag>
  void add_facing_edges() {
    const std::size_t n = mesh_.triangles.size();
    std::vector<std::atomic<unsigned char>> starts(n); // bit k of t: a sector begins at slot k
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t, std::size_t begin, std::size_t end) {
      for_each_marked_slot([this](Triangle_id t) { return narrow_[t]; }, {begin, end},
                           [&](Side narrow) {
                             const Side s = Facing::start_of_sector(mesh_, narrow);
                             starts[s.triangle().value()].fetch_or(static_cast<unsigned char>(1u << s.slot()),
                                                                   std::memory_order_relaxed);
                           });
    });
    facing_ = reduce<ConcurrencyTag>(
        n, facing_,
        [&](std::size_t begin, std::size_t end) {
          Facing sum(mesh_, narrow_, least_);
          for_each_marked_slot(
              [&](Triangle_id t) { return starts[t.value()].load(std::memory_order_relaxed); }, {begin, end},
              [&](Side start) { sum.add_sector(start); });
          return sum;
        },
        [](Facing sum, const Facing& later) {
          sum.add(later);
          return sum;
        });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SIZE_ESTIMATE_H
