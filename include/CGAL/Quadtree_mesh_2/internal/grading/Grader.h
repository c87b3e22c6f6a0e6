// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Bounds how fast edges grow from place to place.
//
// Computes: the triangles with an edge that is more than r times as long as another edge of the mesh, and g times the
//           distance between their nearest ends. For this, each vertex has the least size r |f| + g d over all edges f,
//           d being the distance to the nearer end of f. A triangle is too large if its longest edge exceeds the size
//           at one of its corners.
// Bound:    expected O(n log n) for n triangles each time sizes are taken. All threads compare with them. One takes
//           them, in a few passes over the triangles, and inserts vertices.
// Source:   Persson, "Mesh size functions for implicit geometries and PDE-based gradient limiting" (2006): sizes that
//           grow by at most g. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation"
//           (1995): why it ends. The circumcenter of a triangle that is too large is at least |e| / 2 > r |f| / 2 away
//           from all vertices, and a half of an edge that it encroaches upon 1 / sqrt(2) times that. With r of at
//           least 2 sqrt(2) neither is shorter than f. So nothing becomes shorter than the shortest edge, but at acute
//           corners.
// Deviates: sizes are those of the mesh, not of a background grid. They are taken anew when no triangle exceeds those
//           before, so each round ends as with any bound of size. Around corners sharper than the bound of the angle
//           there is no bound (`zones()`): long edges meet short ones there in any mesh.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADER_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/grading/Graded_sizes.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Bounds.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How fast edges may grow.
struct Growth {
  double gradation; ///< over a unit of length
  double ratio;     ///< from one edge to the next
};

/// \tparam Map of places and lengths to the kernel's; it outlives the bounds
template <class ConcurrencyTag, class Geometry, class Map>
class Grader {
public:
  using Point = typename Geometry::Point;

  Grader(Meshing_state<Geometry>& state, Growth growth, const Map& map)
      : state_(state), mesh_(state.mesh), growth_(growth), map_(map), unit_(map.length_to_kernel(1.0)),
        sizes_(std::make_shared<Graded_sizes>(growth.gradation)) {}

  /// Has edges grow no faster than they may.
  /// \param account of the mesh as it is
  /// \param refine works off the worklist and makes the mesh what it has to be at the end; \returns its account
  /// \param is_stopped whether the user or a budget ends the work
  template <class Refine, class Is_stopped>
  Triangle_account run(Triangle_account account, Refine&& refine, Is_stopped&& is_stopped) {
    constexpr int most_rounds = 50; // a few are enough but where edges become shorter from round to round
    std::size_t vertices = 0;       // before the last round
    for (int round = 0; bound_sizes(account.suspects); ++round) {
      if (round == most_rounds || vertices == mesh_.number_of_vertices() || is_stopped()) {
        state_.clear_worklist();
        return Exact_legalizer<ConcurrencyTag, Geometry>(state_).run(); // what is left, by the last sizes
      }
      vertices = mesh_.number_of_vertices();
      account = refine();
    }
    return account;
  }

private:
  using Shape = typename Kernel_mesh<Geometry>::Shape;
  using Sized_point = Graded_sizes::Sized_point;
  using Zone = Graded_sizes::Zone;
  /// Which triangles may exceed the sizes.
  enum class Suspects { GIVEN, NEAR_LAST_POINTS, ALL };

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Growth growth_;
  const Map& map_;
  double unit_;                         // of the user's lengths, in the kernel's
  std::shared_ptr<Graded_sizes> sizes_; // the bounds have it, too, and outlive this
  std::vector<Zone> zones_;
  Indexed_vector<Vertex_id, double> shortest_; // edges at vertices, squared, as they were the last time; or 0

  /// Bounds sizes by the edges of the mesh as it is, and puts the triangles that exceed them on the worklist.
  /// \param left triangles that may have been left before
  /// \returns whether there are any
  bool bound_sizes(const std::vector<Triangle_id>& left) {
    std::vector<Zone> zones_before = zones();
    zones_before.swap(zones_);
    const bool are_zones_changed = zones_ != zones_before;
    if (are_zones_changed) sizes_->set_zones(zones_);
    std::vector<Sized_point> points = shorter_than_before();
    const bool is_any_new = !points.empty();
    if (is_any_new) sizes_->add(std::move(points));
    state_.problem.bounds.is_ungraded = [sizes = sizes_, &map = map_, unit = unit_](
                                            const Shape& s, const Point& a, const Point& b, const Point& c) {
      return exceeds(*sizes, s, {map.place(a), map.place(b), map.place(c)}, unit);
    };
    std::vector<char> is_suspect(mesh_.triangles.size(), 0);
    for (const Triangle_id t : left) is_suspect[t.value()] = 1;
    return push_ungraded(is_suspect, are_zones_changed ? Suspects::ALL
                                     : is_any_new      ? Suspects::NEAR_LAST_POINTS
                                                       : Suspects::GIVEN);
  }

  /// Whether an edge of a triangle is longer than the sizes at its corners, none of them in a zone.
  /// \param unit of the lengths of places, in those of shapes
  static bool exceeds(const Graded_sizes& sizes, const Shape& s, const Graded_sizes::Corners& corners,
                      double unit) {
    constexpr double margin = Bounds<Geometry>::margin;
    constexpr double least_square = std::numeric_limits<double>::min(); // squares below have lost digits
    const double length2 = std::max(ratio(s.longest(), unit) / unit, least_square);
    const double most = (1 + 2 * margin) * std::sqrt(length2); // no size above matters
    const double least = sizes.least(corners, most), size = unit * least;
    return least < most && s.longest() > size * size * (1 - margin) && !sizes.is_any_in_zone(corners);
  }

  /// The squared length of the shortest edge at each vertex that is used, else 0.
  Indexed_vector<Vertex_id, double> shortest_edges() const {
    Indexed_vector<Vertex_id, double> shortest(mesh_.number_of_vertices(), 0);
    for (const auto& r : mesh_.triangles) {
      if (!r.v[0].is_valid()) continue;
      const auto s = mesh_.shape(r);
      for (int k = 0; k < 3; ++k) {
        const double length2 = ratio(lesser(s.l[next_slot[k]], s.l[previous_slot[k]]), unit_) / unit_;
        double& least = shortest[r.v[k]];
        if (least == 0 || length2 < least) least = length2;
      }
    }
    return shortest;
  }

  /// The vertices whose shortest edges bound others more than the sizes so far do, with the lengths they allow.
  std::vector<Sized_point> shorter_than_before() {
    const Indexed_vector<Vertex_id, double> before = std::move(shortest_);
    shortest_ = shortest_edges();
    std::vector<Sized_point> all;
    for (const Vertex_id v : shortest_.ids()) {
      const bool is_known = v < before.end_id() && before[v] > 0 && before[v] <= shortest_[v];
      if (!(shortest_[v] > 0) || is_known)
        continue; // 0: not used, or nearer to another one than doubles can tell
      const auto [x, y] = map_.place(mesh_.point(v));
      all.push_back({x, y, growth_.ratio * std::sqrt(shortest_[v])});
    }
    const auto not_dominated_by = [](const Graded_sizes& sizes, const std::vector<Sized_point>& points) {
      std::vector<char> is_needed(points.size());
      for_each_index<ConcurrencyTag>(
          points.size(), [&](std::size_t i) { is_needed[i] = sizes.dominate(points[i]) ? 0 : 1; });
      std::vector<Sized_point> needed;
      for (std::size_t i = 0; i < points.size(); ++i)
        if (is_needed[i] != 0) needed.push_back(points[i]);
      return needed;
    };
    std::vector<Sized_point> some = not_dominated_by(*sizes_, all);
    if (some.empty()) return some;
    Graded_sizes own(growth_.gradation);
    own.add(some);
    return not_dominated_by(own, some);
  }

  /// Around the corners with exempt triangles, so far out that the sizes allowed by what is in the corner exceed those
  /// at its apex, the length of the legs of these triangles: no leg is then split for what its halves bring about.
  std::vector<Zone> zones() const {
    const double reach = 2 + 2 / growth_.gradation;
    std::vector<Zone> zones;
    for (const Triangle_id t : mesh_.triangles.ids()) {
      if (!mesh_.is_alive(t)) continue;
      const auto& r = mesh_.triangle(t);
      if (!state_.bounds.is_sharp(mesh_.shape(r)) || !state_.is_exempt(r.v[0], r.v[1], r.v[2])) continue;
      const Sector_id s = state_.corners.sector_of(mesh_, r.v[0], r.v[1], r.v[2]);
      const auto center =
          map_.place(state_.problem.input_point(state_.corners.leg(state_.corners.sector(s).right).apex));
      double leg = 0;
      for (const Vertex_id v : r.v) {
        const auto p = map_.place(mesh_.point(v));
        leg = std::max(leg, std::hypot(p[0] - center[0], p[1] - center[1]));
      }
      zones.push_back({center, reach * leg});
    }
    return zones;
  }

  /// Which vertices have a triangle that is larger than the points added last allow there.
  std::vector<char> vertices_near_last_points() const {
    Indexed_vector<Vertex_id, double> longest(mesh_.number_of_vertices(), 0); // squared
    for (const auto& r : mesh_.triangles) {
      if (!r.v[0].is_valid()) continue;
      const double length2 = ratio(mesh_.shape(r).longest(), unit_) / unit_;
      for (const Vertex_id v : r.v) longest[v] = std::max(longest[v], length2);
    }
    std::vector<char> are_near(longest.size(), 0);
    for_each_index<ConcurrencyTag>(are_near.size(), [&](std::size_t i) {
      const auto v = static_cast<Vertex_id>(i);
      if (longest[v] > 0 && sizes_->is_less_by_last(map_.place(mesh_.point(v)), std::sqrt(longest[v])))
        are_near[i] = 1;
    });
    return are_near;
  }

  /// \param is_bad of triangles that are looked at in any case; becomes whether they exceed the sizes
  bool push_ungraded(std::vector<char> is_bad, Suspects suspects) {
    const std::vector<char> are_near = suspects == Suspects::NEAR_LAST_POINTS
                                           ? vertices_near_last_points()
                                           : std::vector<char>(mesh_.number_of_vertices(), 0);
    for_each_block<ConcurrencyTag>(
        is_bad.size(), default_block, [&](std::size_t, std::size_t begin, std::size_t end) {
          mesh_.for_each_alive({begin, end}, [&](Triangle_id t) {
            const auto& [a, b, c] = mesh_.triangle(t).v;
            const bool is_near = (are_near[a.value()] | are_near[b.value()] | are_near[c.value()]) != 0;
            const bool is_suspect = is_bad[t.value()] != 0 || suspects == Suspects::ALL || is_near;
            is_bad[t.value()] = is_suspect && is_ungraded(a, b, c) ? 1 : 0;
          });
        });
    bool is_any = false;
    for (const Triangle_id t : mesh_.triangles.ids()) {
      if (is_bad[t.value()] == 0 || !mesh_.is_alive(t)) continue;
      state_.push(t);
      is_any = true;
    }
    return is_any;
  }

  bool is_ungraded(Vertex_id a, Vertex_id b, Vertex_id c) const {
    return state_.bounds.is_ungraded(mesh_.shape(a, b, c), mesh_.point(a), mesh_.point(b), mesh_.point(c));
  }
};

/// Makes the end of all work on a mesh, and has edges grow no faster than they may.
/// \param growth nothing if there is no bound on it
/// \param map outlives the bounds of the state
/// \param finish_exactly makes the mesh what it has to be at the end; \returns its account
/// \param refine works off the worklist, and does the same
template <class ConcurrencyTag, class Geometry, class Map, class Is_stopped, class Finish, class Refine>
Triangle_account grade_edges(Meshing_state<Geometry>& state, const std::optional<Growth>& growth,
                             const Map& map, const Is_stopped& is_stopped, const Finish& finish_exactly,
                             const Refine& refine) {
  Triangle_account account = finish_exactly();
  if (!growth) return account;
  return Grader<ConcurrencyTag, Geometry, Map>(state, *growth, map)
      .run(std::move(account), refine, is_stopped);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADER_H
