// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Restricts the first triangulation to the domain, and labels its components with the input's regions.
//
// Constrained edges divide the plane into components, which are flooded by nesting level. Level 0 is
// connected to infinity. Level i + 1 is reached from level i across a constrained edge and is in no lower
// level (the levels of CGAL's mark_domain_in_triangulation()). The rule of the options then determines which
// components are kept. Holes and regions are located before anything is dropped, so that no walk is blocked.
// O(n), and a walk for each hole and region.
//
// If the point of a hole or region lies on a segment with the same component on both sides, it belongs to
// that component. Otherwise it is ambiguous, and refused. Whether it lies on a segment is decided exactly.
//
// From here on the mesh is the domain alone, and no walk leaves it. Features behind an outside gap, however
// thin, are not seen and force nothing (distances are geodesic). All that remains of the outside are the triangles at
// the border, whose rooms rounded vertices of the border may not leave (Edge_room.h); flat ones are flipped before
// (Flat_triangle_flipper.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_DOMAIN_RULE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_DOMAIN_RULE_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Flat_triangle_flipper.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kept_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Place_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A triangle outside, at a side of the domain's border that has the outside on its left.
struct Outer_triangle {
  Vertex_id a, b, apex;
};

/// Thrown if the point of a hole or region lies on a segment, or an end of one, with several components around.
struct Ambiguous_seed {
  enum class Of { HOLE, REGION };
  Of of;
  std::size_t number;
  Vertex_id a, b; ///< the point is between these vertices; `a` where they are the same
};

template <class Geometry>
class Domain_finder {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;
  using Rule = Quality_mesh_options_2::Domain;

  /// The last `number_of_auxiliary_vertices` vertices of the mesh are outside whatever the rule.
  Domain_finder(Mesh& mesh, std::size_t number_of_auxiliary_vertices)
      : mesh_(mesh),
        first_auxiliary_(static_cast<Vertex_id>(mesh.points.size() - number_of_auxiliary_vertices)) {}

  /// Keeps the domain only (Kept_triangles.h); the mesh is empty afterward if there is none. If there are
  /// regions, `Kernel_mesh::region_of` tells for each triangle the first one whose point is in its component.
  /// \returns the triangles outside along the border, but for those at auxiliary vertices, beyond which nothing is
  /// \throws Ambiguous_seed
  std::vector<Outer_triangle> run(Rule rule, const std::vector<Point>& holes,
                                  const std::vector<Point>& regions) {
    find_levels(rule == Rule::NESTING_PARITY ? std::numeric_limits<std::int32_t>::max() : 1);
    is_kept_.resize(mesh_.triangles.size());
    for_each_triangle([&](Triangle_id t) { is_kept_[t] = is_kept_by(rule, level_[t]); });
    label(regions);
    if (rule == Rule::MARKED)
      for_each_triangle([&](Triangle_id t) {
        is_kept_[t] = level_[t] > 0 && !regions.empty() && mesh_.region_of[t].is_valid();
      });
    level_ = {}; // memory is fullest soon
    for (const Triangle_id t : triangles_at(holes, Ambiguous_seed::Of::HOLE)) drop_component(t);
    Flat_triangle_flipper<Geometry>(mesh_, is_kept_, first_auxiliary_).run();
    std::vector<Outer_side> outer = outer_sides();
    Kept_triangles(mesh_, is_kept_).keep(first_auxiliary_, [&outer](const auto& new_side) {
      for (Outer_side& o : outer) o.side = new_side(o.side);
    });
    return outer_triangles(outer);
  }

private:
  Mesh& mesh_;
  Vertex_id first_auxiliary_;
  Uninitialized_indexed_vector<Triangle_id, std::int32_t> level_;
  Indexed_vector<Triangle_id, char> is_kept_;
  std::vector<Triangle_id> stack_;

  /// A side of the border, and what sees it from the outside.
  struct Outer_side {
    Side side;
    Vertex_id apex;
  };

  template <class Function>
  void for_each_triangle(const Function& f) const {
    for_each_index<Chosen_tag>(mesh_.triangles.size(),
                               [&](std::size_t i) { f(static_cast<Triangle_id>(i)); });
  }

  static char is_kept_by(Rule rule, std::int32_t level) {
    return rule == Rule::NESTING_PARITY ? level % 2 == 1 : level > 0;
  }

  /// The triangle that holds each point, if there is one, by walks from one to the next in shuffle order. One thread
  /// walks to the first point of each run.
  /// \throws Ambiguous_seed
  std::vector<Triangle_id> triangles_at(const std::vector<Point>& points, Ambiguous_seed::Of of) {
    constexpr std::size_t run = 256;
    std::vector<Triangle_id> found(points.size());
    if (points.empty()) return found;
    const Place_keys<Geometry> key(mesh_.points.values());
    const auto order = radix_order<Chosen_tag>(points.size(), [&](std::size_t p) { return key(points[p]); });
    std::vector<Walk_end> ends(points.size()); // in this order
    Triangle_id hint(0);
    for (std::size_t i = 0; i < ends.size(); i += run)
      ends[i] = locate_exactly(mesh_, hint, points[order[i]]), hint = ends[i].triangle;
    std::vector<char> is_doubtful(points.size(), 0);
    for_each_block<Chosen_tag>(ends.size(), run, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Point& p = points[order[i]];
        if (i > begin) ends[i] = locate_exactly(mesh_, ends[i - 1].triangle, p);
        is_doubtful[i] = !ends[i].is_blocked() && may_be_in_border(ends[i].triangle, p);
      }
    });
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].is_blocked()) continue;
      found[order[i]] = ends[i].triangle;
      if (is_doubtful[i] != 0) check_place(ends[i].triangle, points[order[i]], {of, order[i], {}, {}});
    }
    return found;
  }

  /// The slots of a triangle's sides that a point of it is on: two at a vertex.
  std::vector<int> sides_with(Triangle_id t, const Point& p) const {
    const auto& r = mesh_.triangle(t);
    std::vector<int> sides;
    for (int k = 0; k < 3; ++k)
      if (Geometry::orientation(mesh_.point(r.v[next_slot[k]]), mesh_.point(r.v[previous_slot[k]]), p) == 0)
        sides.push_back(k);
    return sides;
  }

  bool may_be_in_border(Triangle_id t, const Point& p) const {
    const std::vector<int> sides = sides_with(t, p);
    return sides.size() == 2 || (sides.size() == 1 && mesh_.triangle(t).side[sides[0]].is_constrained());
  }

  /// \pre `may_be_in_border(t, p)`
  /// \throws Ambiguous_seed if a point of the triangle is in the border of several components.
  void check_place(Triangle_id t, const Point& p, Ambiguous_seed seed) {
    const std::vector<int> sides = sides_with(t, p);
    std::vector<Triangle_id> around;
    if (sides.size() == 1) {
      const Side side(t, sides[0]);
      seed.a = mesh_.source(side), seed.b = mesh_.target(side);
      around = {mesh_.across(side).triangle()};
    } else if (sides.size() == 2) {
      seed.a = seed.b = mesh_.triangle(t).v[3 - sides[0] - sides[1]];
      mesh_.for_each_triangle_at(seed.a, [&](Triangle_id u, int) { around.push_back(u); });
    }
    if (!is_one_component(t, around)) throw seed;
  }

  bool is_one_component(Triangle_id first, const std::vector<Triangle_id>& others) {
    if (others.empty()) return true;
    Indexed_vector<Triangle_id, char> is_reached(mesh_.triangles.size(), 0);
    is_reached[first] = 1;
    stack_.push_back(first);
    flood([&](Triangle_id t) { return std::exchange(is_reached[t], char(1)) == 0; }, [](Triangle_id) {});
    return std::all_of(others.begin(), others.end(), [&](Triangle_id t) { return is_reached[t] != 0; });
  }

  /// Calls `visit(t)` for the triangles that are reached from those on the stack without crossing a
  /// constrained side and for which it returns true, and for those across constrained sides `across(t)`.
  template <class Visit, class Across>
  void flood(Visit visit, Across across) {
    while (!stack_.empty()) {
      const Triangle_id t = stack_.back();
      stack_.pop_back();
      for (const Side o : mesh_.triangle(t).side) {
        if (o.is_border()) continue;
        if (o.is_constrained())
          across(o.triangle());
        else if (visit(o.triangle()))
          stack_.push_back(o.triangle());
      }
    }
  }

  /// The levels below `most` by flooding; all that is left has the level `most`.
  void find_levels(std::int32_t most) {
    level_.resize(mesh_.triangles.size());
    for_each_triangle([&](Triangle_id t) { level_[t] = most; });
    std::vector<Triangle_id> seeds = triangles_at_auxiliary_vertices(), next;
    for (std::int32_t level = 0; level < most && !seeds.empty(); ++level) {
      const auto visit = [&](Triangle_id t) {
        if (level_[t] < most) return false;
        level_[t] = level;
        return true;
      };
      for (const Triangle_id t : seeds)
        if (visit(t)) stack_.push_back(t);
      next.clear();
      flood(visit, [&](Triangle_id t) {
        if (level_[t] == most) next.push_back(t);
      });
      std::swap(seeds, next);
    }
  }

  std::vector<Triangle_id> triangles_at_auxiliary_vertices() const {
    std::vector<Triangle_id> triangles;
    append_by_blocks<Chosen_tag>(
        triangles, mesh_.triangles.size(),
        [this](std::size_t begin, std::size_t end, std::vector<Triangle_id>& found) {
          for (const Triangle_id t : Id_range<Triangle_id>(begin, end)) {
            const auto& v = mesh_.triangle(t).v;
            if (std::any_of(v, v + 3, [this](Vertex_id w) { return !(w < first_auxiliary_); }))
              found.push_back(t);
          }
        });
    return triangles;
  }

  void label(const std::vector<Point>& regions) {
    mesh_.region_of.clear();
    if (regions.empty()) return;
    mesh_.region_of.assign(mesh_.triangles.size(), {});
    const std::vector<Triangle_id> holders = triangles_at(regions, Ambiguous_seed::Of::REGION);
    for (std::size_t i = 0; i < regions.size(); ++i) {
      const auto visit = [&](Triangle_id t) {
        Region_id& region = mesh_.region_of[t];
        if (region.is_valid()) return false;
        region = static_cast<Region_id>(i);
        return true;
      };
      const Triangle_id first = holders[i];
      if (!first.is_valid() || level_[first] == 0 || !visit(first)) continue;
      stack_.push_back(first);
      flood(visit, [](Triangle_id) {});
    }
  }

  /// For as few bytes as can be, as memory is fullest soon.
  std::vector<Outer_side> outer_sides() const {
    std::vector<Outer_side> outer;
    append_by_blocks<Chosen_tag>(outer, is_kept_.size(),
                                 [this](std::size_t begin, std::size_t end, std::vector<Outer_side>& found) {
                                   for (const Triangle_id t : Id_range<Triangle_id>(begin, end))
                                     for (int k = 0; k < 3 && is_kept_[t] == 0; ++k)
                                       add_if_outer(Side(t, k), found);
                                 });
    return outer;
  }

  /// \pre the side's triangle is not kept
  void add_if_outer(Side s, std::vector<Outer_side>& outer) const {
    const Side o = mesh_.across(s);
    if (o.is_border() || is_kept_[o.triangle()] == 0) return;
    const Vertex_id apex = mesh_.opposite(s);
    if (apex < first_auxiliary_) outer.push_back({o, apex});
  }

  /// \pre the mesh has nothing but the domain
  std::vector<Outer_triangle> outer_triangles(const std::vector<Outer_side>& outer) const {
    std::vector<Outer_triangle> triangles(outer.size());
    for_each_index<Chosen_tag>(outer.size(), [&](std::size_t i) {
      const auto& [side, apex] = outer[i];
      triangles[i] = {mesh_.target(side), mesh_.source(side), apex};
    });
    return triangles;
  }

  void drop_component(Triangle_id first) {
    const auto visit = [&](Triangle_id t) {
      if (is_kept_[t] == 0) return false;
      is_kept_[t] = 0;
      return true;
    };
    if (!first.is_valid() || !visit(first)) return;
    stack_.push_back(first);
    flood(visit, [](Triangle_id) {});
  }
};

/// What of the plane is meshed.
template <class Geometry>
struct Domain_rule {
  Quality_mesh_options_2::Domain rule = Quality_mesh_options_2::Domain::ENCLOSED;
  std::vector<typename Geometry::Point> holes, regions;

  /// \returns the triangles outside along the border
  template <class Mesh>
  std::vector<Outer_triangle> apply(Mesh& mesh, std::size_t number_of_auxiliary_vertices) const {
    return Domain_finder<Geometry>(mesh, number_of_auxiliary_vertices).run(rule, holes, regions);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_DOMAIN_RULE_H
