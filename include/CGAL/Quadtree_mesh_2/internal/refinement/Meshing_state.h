// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What the stages of the mesher work on: the problem, the mesh of it or of a block, and the worklist of bad triangles.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_STATE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_STATE_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_problem.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Worklist.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How an attempt to change the mesh for a bad triangle ended.
enum class Outcome {
  CHANGED,
  REFUSED, ///< there is no room, or nothing of the kind to do
  BLOCKED, ///< an edge that gets no vertices is in the way, and will be until the triangle is another one
  DEFERRED ///< it needs what lies beyond a seam of the block
};

/// How edges of the input are cut.
enum class Leg_rule {
  /// Legs of lopped corners are split at matched radii, where their vertices stay. Other edges are split if a
  /// new vertex would see them under more than 120 degrees, or make a triangle below a bound above 30 degrees.
  /// With this rule, refinement is established to end.
  SHELLS,
  /// All edges are split alike, where a new vertex would make a triangle below the bound (Shewchuk's lenses).
  /// This needs fewer vertices, but only a budget makes refinement end.
  FREE
};

/// Which bad triangle refinement takes up first, and where it puts a vertex for it.
enum class Refinement_rule {
  /// The sharpest one, and a corner of quadtrees next to its off-center.
  CORNERS,
  /// One with the shortest edge, and its off-center itself.
  OFF_CENTERS
};

/// From where a new vertex must not see a constrained edge, which is then split instead.
enum class Encroachment {
  LENSES, ///< where it would make a triangle below the bound, or narrow next to a corner
  CIRCLES ///< anywhere in the diametral circle; then vertices are not relocated either
};

/// One mesh, the domain's or a block of it, and what there is to do in it.
///
/// The shells of an acute corner and the locks of its sectors belong to one block, that in which all of it
/// lies, and to the whole mesh when there are no blocks: `owns()` says so. What nobody else may read or write
/// are `Leg::shells`, `Leg::ring`, `Leg::apex_vertex` and `Sector::lock_radius`; all else of the corners stays as
/// it is.
template <class Geometry>
struct Meshing_state {
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;
  using Shape = typename Mesh::Shape;
  using Vector = Basic_vector<typename Geometry::Number>;

  Meshing_problem<Geometry>& problem;
  const Input_edges& edges = problem.edges;
  Acute_corners<Geometry>& corners = problem.corners;
  const Bounds<Geometry>& bounds = problem.bounds;

  Mesh mesh;
  Worklist worklist;
  Leg_rule leg_rule = Leg_rule::SHELLS;
  Refinement_rule refinement_rule = Refinement_rule::CORNERS; ///< to be changed while the worklist is empty
  Encroachment encroachment = Encroachment::LENSES;           ///< for refiners made from now on
  /// No edge is split when the mesh has so many vertices.
  std::size_t most_vertices = std::numeric_limits<std::size_t>::max();
  /// What templates filled (Bulk_filler.h): triangles with consecutive handles, and the vertices within.
  struct Bulk {
    Triangle_id first_triangle = Triangle_id(0), end_of_triangles = Triangle_id(0);
    Vertex_id first_vertex = Vertex_id(0), end_of_vertices = Vertex_id(0);

    std::size_t number_of_triangles() const { return end_of_triangles.value() - first_triangle.value(); }
    bool has(Triangle_id t) const { return !(t < first_triangle) && t < end_of_triangles; }
    bool has_within(Vertex_id v) const { return !(v < first_vertex) && v < end_of_vertices; }
    /// To be called when other triangles may get the handles.
    void forget_handles() { first_triangle = end_of_triangles = Triangle_id(0); }
  };
  Bulk bulk;
  /// Free vertices were there before refinement: on the border of the bulk, or of quadtrees.
  bool has_placed_vertices = false;
  /// Bad triangles that are for a later round, in which they lie farther from the seams.
  std::vector<Triangle_id> deferred;

  explicit Meshing_state(Meshing_problem<Geometry>& p) : problem(p) {}
  /// The state of a block with the given corners, in order.
  Meshing_state(Meshing_problem<Geometry>& p, std::vector<Corner_id> owned)
      : problem(p), is_block_(true), owned_(std::move(owned)) {}
  Meshing_state(const Meshing_state&) = delete;
  Meshing_state& operator=(const Meshing_state&) = delete;

  /// Writes or reads the mesh and what there is to do in it, while nothing is on the worklist (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(mesh, leg_rule, refinement_rule, bulk, has_placed_vertices, deferred, doubtful_sides);
  }

  bool owns(Corner_id c) const { return !is_block_ || std::binary_search(owned_.begin(), owned_.end(), c); }
  bool is_block() const { return is_block_; }

  /// A mesh up to this size is a small mesh, which is worth any effort. In larger ones what seldom helps is not tried.
  /// (A graph of few vertices, of which Vertex_budgets.h speaks, need not have a small mesh.)
  static constexpr std::size_t most_triangles_of_small_mesh = 1000;
  /// In one up to this size, pairs of vertices are merged (thin_small_mesh.h).
  static constexpr std::size_t most_triangles_to_merge_pairs = 2 * most_triangles_of_small_mesh;
  bool is_small_mesh() const { return mesh.number_of_triangles() <= most_triangles_of_small_mesh; }

  bool is_exempt(Vertex_id a, Vertex_id b, Vertex_id c) const {
    return problem.keeps_edges() ? corners.excusing_sector(mesh, a, b, c).is_valid()
                                 : corners.is_exempt(mesh, a, b, c);
  }

  bool is_large(Triangle_id t, const Shape& s) const {
    const auto& r = mesh.triangle(t);
    return bounds.is_large(s, mesh.point(r.v[0]), mesh.point(r.v[1]), mesh.point(r.v[2]), mesh.region(t));
  }

  /// Whether t misses a bound that no acute corner excuses.
  bool is_bad(Triangle_id t) const { return is_bad(t, mesh.shape(mesh.triangle(t))); }
  bool is_bad(Triangle_id t, const Shape& s) const {
    const auto& r = mesh.triangle(t);
    return (bounds.is_sharp(s) && !is_exempt(r.v[0], r.v[1], r.v[2])) || is_large(t, s);
  }

  std::size_t number_of_bad() const {
    std::size_t n = 0;
    for (const Triangle_id t : mesh.triangles.ids()) n += mesh.is_alive(t) && is_bad(t) ? 1 : 0;
    return n;
  }

  /// How many bad triangles another mesh of the same graph may have, to be as good as this one: none, unless edges that
  /// get no vertices force some.
  std::size_t number_of_bad_allowed() const { return problem.keeps_edges() ? number_of_bad() : 0; }

  /// The point at a share of the way between two vertices on an input edge. Rounding must not add up from split to
  /// split: a vertex of an edge is as near to it as one made from the edge's ends.
  typename Geometry::Point point_on_edge_between(Edge_id e, Vertex_id x, Vertex_id y, double share) const {
    const Input_edge& edge = edges[e];
    return Geometry::back_to_line(problem.input_point(edge.a), problem.input_point(edge.b),
                                  Geometry::between(mesh.point(x), mesh.point(y), share));
  }

  /// Whether a side is on an edge that gets no vertices.
  bool is_kept(Side s) const { return problem.keeps_edges() && kept_edge(s).is_valid(); }
  /// That edge, if there is one.
  Edge_id kept_edge(Side s) const {
    const Edge_id e = whole_edge(s);
    return e.is_valid() && problem.is_kept(e) ? e : Edge_id();
  }

  /// Whether t misses a bound, excused or not.
  bool is_suspect(Triangle_id t) const { return is_suspect(t, mesh.shape(mesh.triangle(t))); }
  bool is_suspect(Triangle_id t, const Shape& s) const { return bounds.is_sharp(s) || is_large(t, s); }

  /// Whether t misses any bound, that of the greatest angle too, which refinement leaves to Wide_angle_curer.h.
  bool misses_bound(Triangle_id t) const { return misses_bound(t, mesh.shape(mesh.triangle(t))); }
  bool misses_bound(Triangle_id t, const Shape& s) const { return is_suspect(t, s) || bounds.is_wide(s); }
  /// Whether the greatest angle of t is above the bound, and no acute corner excuses it.
  bool is_too_wide(Triangle_id t, const Shape& s) const {
    const auto& r = mesh.triangle(t);
    return bounds.is_wide(s) && !is_exempt(r.v[0], r.v[1], r.v[2]);
  }

  void clear_worklist() {
    while (!worklist.is_empty()) worklist.pop();
  }

  /// Whether the worklist has bad triangles; takes the others off it.
  bool has_bad_on_worklist() {
    std::vector<Triangle_id> bad;
    while (!worklist.is_empty()) {
      const Triangle_id t = worklist.pop();
      if (mesh.is_alive(t) && is_bad(t)) bad.push_back(t);
    }
    for (const Triangle_id t : bad) push(t);
    return !bad.empty();
  }

  void push(Triangle_id t) { push(t, mesh.shape(mesh.triangle(t))); }
  void push(Triangle_id t, const Shape& s) {
    if (refinement_rule == Refinement_rule::CORNERS)
      worklist.push(t, s.sin2_of_least_angle() / bounds.sin2);
    else
      worklist.push_by_length(t, squared_length_of_shortest(s));
  }
  /// Whether a triangle of this shape that came off the worklist has another place on it.
  bool is_outdated(const Shape& s) const {
    return refinement_rule == Refinement_rule::OFF_CENTERS &&
           worklist.is_outdated(squared_length_of_shortest(s));
  }

  void push_all_bad() {
    for (const Triangle_id t : mesh.triangles.ids())
      if (mesh.is_alive(t) && is_bad(t)) push(t);
  }

  void push_if_suspect(Triangle_id t) {
    const Shape s = mesh.shape(mesh.triangle(t));
    if (is_suspect(t, s)) push(t, s);
  }

  /// Pushes the triangles at v that may miss a bound: where sizes have none, by angles that are computed with one
  /// difference a triangle and a little to spare.
  void push_suspects_around(Vertex_id v) {
    if (bounds.is_size_bounded() || bounds.is_refused)
      mesh.for_each_triangle_at(v, [this](Triangle_id t, int) { push_if_suspect(t); });
    else
      push_sharp_around(v);
  }

  /// The side between x and y that are neighbors in the mesh. An input vertex may have several fans, of
  /// which the mesh knows one: where both are such, the side is searched everywhere if it is in neither.
  Side side_between(Vertex_id x, Vertex_id y) const {
    const Side s = mesh.find_side(x, y);
    return s.is_border() && mesh.is_input(x) && mesh.is_input(y) ? find_side_everywhere(x, y) : s;
  }

  /// Flips free sides that are certainly not Delaunay, starting from those of `doubtful_sides`; triangles
  /// that come out of it suspect go to the worklist.
  void legalize() {
    legalize([](Side) {});
  }
  /// \param before_look called with a side before the triangles on both sides of it are read
  template <class Before_look>
  void legalize(const Before_look& before_look) {
    while (!doubtful_sides.empty()) {
      const Side s = doubtful_sides.back();
      doubtful_sides.pop_back();
      before_look(s);
      const Triangle_id t = s.triangle();
      if (!mesh.is_alive(t)) continue;
      const Side o = mesh.across(s);
      if (o.is_constrained() || !mesh.is_certainly_not_Delaunay(t, s.slot())) continue;
      mesh.flip(t, s.slot());
      const Triangle_id u = o.triangle();
      for (const Side outer : {Side(t, 0), Side(t, 2), Side(u, 0), Side(u, 1)})
        doubtful_sides.push_back(outer);
      push_if_suspect(t), push_if_suspect(u);
    }
  }

  std::vector<Side> doubtful_sides;

  /// The input edge that a side is, as a whole; none if it is none.
  Edge_id whole_edge(Side s) const {
    const Vertex_id x = mesh.source(s), y = mesh.target(s);
    if (!mesh.across(s).is_constrained() || !mesh.is_input(x) || !mesh.is_input(y)) return {};
    return edges.between(mesh.input_number(x), mesh.input_number(y));
  }

private:
  static double squared_length_of_shortest(const Shape& s) { return ratio(s.l[s.slot_of_shortest()], 1); }

  bool is_block_ = false;
  std::vector<Corner_id> owned_;

  void push_sharp_around(Vertex_id v) {
    const double least_sin2 = bounds.sin2 * (1 + 1e-9);
    const Point& origin = mesh.point(v);
    Vertex_id end; // of the last spoke
    Vector spoke;
    auto length2 = squared_length(spoke);
    mesh.for_each_triangle_at(v, [&](Triangle_id t, int slot) {
      const auto& r = mesh.triangle(t);
      const Vertex_id right = r.v[next_slot[slot]];
      if (right != end) { // the first triangle, or one clockwise of it
        spoke = Geometry::scaled_difference(mesh.point(right), origin);
        length2 = squared_length(spoke);
      }
      end = r.v[previous_slot[slot]];
      const Vector next = Geometry::scaled_difference(mesh.point(end), origin);
      const auto next_length2 = squared_length(next);
      const Shape s = {{squared_length(next - spoke), next_length2, length2}, cross(spoke, next)};
      if (s.is_below(least_sin2)) push(t, s);
      spoke = next, length2 = next_length2;
    });
  }

  Side find_side_everywhere(Vertex_id x, Vertex_id y) const {
    for (const Triangle_id t : mesh.triangles.ids())
      for (int k = 0; k < 3; ++k) {
        const Side s(t, k);
        if (mesh.is_alive(t) && mesh.source(s) == x && mesh.target(s) == y) return s;
        if (mesh.is_alive(t) && mesh.source(s) == y && mesh.target(s) == x) return s;
      }
    return Side::border();
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_STATE_H
