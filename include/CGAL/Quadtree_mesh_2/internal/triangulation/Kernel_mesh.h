// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The triangulation that the mesher works in: one array of triangles with neighbors and constraint bits, and
// one of points.
//
// Side k of a triangle is opposite its vertex k. One word describes what is across a side: the neighbor, the
// slot of the common side there, and whether the side is constrained. So a flip touches two triangles and
// four links, and never searches for "which side of the neighbor am I". Dead triangles are kept in a free
// list. All operations take O(1), or O(degree) for stars.
//
// A mesh is that of the whole domain, or one block of it (Mesh_blocks.h). A block has seams where the rest of
// the mesh continues. Nothing walks, flips or splits across a seam while the block is separate.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KERNEL_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KERNEL_MESH_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/prefetch.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/reserve_in_parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_handles.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Goes around a vertex, triangle by triangle: counterclockwise; from the border on clockwise from where it began.
template <class Mesh>
class Fan_walk {
public:
  Fan_walk(const Mesh& mesh, Vertex_id v) : Fan_walk(mesh, v, mesh.incident_triangle(v)) {}
  /// \param start one of the triangles at v
  Fan_walk(const Mesh& mesh, Vertex_id v, Triangle_id start)
      : mesh_(mesh), v_(v), start_(start), t_(start_), slot_(Mesh::slot_of(mesh.triangle(t_), v)) {}

  Triangle_id triangle() const { return t_; }
  int slot() const { return slot_; } ///< of the vertex
  /// Whether it went all around.
  bool is_closed() const { return state_ == State::CLOSED; }

  /// The side from the vertex to w, if this triangle has it; else the border.
  Side side_to(Vertex_id w) const {
    const auto& r = mesh_.triangle(t_);
    return r.v[next_slot[slot_]] == w       ? Side(t_, previous_slot[slot_])
           : r.v[previous_slot[slot_]] == w ? Side(t_, next_slot[slot_])
                                            : Side::border();
  }

  /// Goes to the next triangle. \returns false, and stays, if there is none
  bool advance() {
    if (state_ != State::COUNTERCLOCKWISE) return advance_clockwise();
    const Side o = mesh_.triangle(t_).side[next_slot[slot_]];
    if (o.is_border()) return turn_around();
    if (o.triangle() == start_)
      state_ = State::CLOSED;
    else
      t_ = o.triangle(), slot_ = o.slot_after(); // the common side begins at v, seen from there
    return state_ != State::CLOSED;
  }

private:
  enum class State { COUNTERCLOCKWISE, CLOCKWISE, CLOSED, OPEN };

  const Mesh& mesh_;
  Vertex_id v_;
  Triangle_id start_, t_;
  int slot_;
  State state_ = State::COUNTERCLOCKWISE;

  bool turn_around() {
    state_ = State::CLOCKWISE;
    t_ = start_, slot_ = Mesh::slot_of(mesh_.triangle(t_), v_);
    return advance_clockwise();
  }

  bool advance_clockwise() {
    if (state_ != State::CLOCKWISE) return false;
    const Side o = mesh_.triangle(t_).side[previous_slot[slot_]];
    if (o.is_border())
      state_ = State::OPEN;
    else
      t_ = o.triangle(), slot_ = o.slot_before();
    return state_ == State::CLOCKWISE;
  }
};

template <class Geometry>
class Kernel_mesh {
public:
  using Point = typename Geometry::Point;
  using Shape = Basic_shape<typename Geometry::Number>;

  struct Triangle {
    Vertex_id v[3];
    Side side[3];
  };

  Uninitialized_indexed_vector<Triangle_id, Triangle> triangles;
  Uninitialized_indexed_vector<Vertex_id, Point> points;
  /// Some triangle at the vertex; none where it is removed, or outside the domain.
  Uninitialized_indexed_vector<Vertex_id, Triangle_id> triangle_of;
  Uninitialized_indexed_vector<Vertex_id, Vertex_role> role_of;
  /// Whether the star of a vertex has changed since its removal was tried.
  Uninitialized_indexed_vector<Vertex_id, char> is_dirty;

  /// The region each triangle lies in, if in any; empty where no region has a bound of its own.
  Uninitialized_indexed_vector<Triangle_id, Region_id> region_of;

  bool is_alive(Triangle_id t) const { return triangle(t).v[0].is_valid(); }
  Region_id region(Triangle_id t) const { return region_of.empty() ? Region_id() : region_of[t]; }
  const Triangle& triangle(Triangle_id t) const { return triangles[t]; }
  Triangle& triangle(Triangle_id t) { return triangles[t]; }
  const Point& point(Vertex_id v) const { return points[v]; }
  Triangle_id incident_triangle(Vertex_id v) const { return triangle_of[v]; }
  Vertex_role role(Vertex_id v) const { return role_of[v]; }
  /// The input edge that the vertex lies on, unless it is of the input.
  Edge_id edge(Vertex_id v) const { return role(v).edge(); }
  bool is_free(Vertex_id v) const { return role(v).is_free(); }
  bool is_input(Vertex_id v) const { return role(v).is_input(); }
  /// The number of an input vertex: in the whole mesh its handle, in a block that of the whole mesh.
  Vertex_id input_number(Vertex_id v) const { return role(v).input_number(); }
  bool is_used(Vertex_id v) const { return incident_triangle(v).is_valid(); }
  std::size_t number_of_vertices() const { return points.size(); }

  /// Prefetch the triangle, or its corners, or the triangles next to it, or the one known at a vertex.
  void prefetch_triangle(Triangle_id t) const { prefetch(triangles.data() + t.value()); }
  void prefetch_corners(Triangle_id t) const {
    for (const Vertex_id v : triangle(t).v) prefetch(points.data() + v.value());
  }
  void prefetch_neighbors(Triangle_id t) const {
    for (const Side o : triangle(t).side)
      if (!o.is_border()) prefetch_triangle(o.triangle());
  }
  void prefetch_star(Vertex_id v) const {
    if (is_used(v)) prefetch_triangle(incident_triangle(v));
  }
  /// Prefetches the place of the vertex opposite a side, which in-circle tests of the side read.
  void prefetch_apex(Side s) const {
    if (!s.is_border()) prefetch(points.data() + opposite(s).value());
  }

  /// Calls `f(t)` for the triangles alive of the given ones, which may read their corners and neighbors. Those of which
  /// not `is_wanted(t)` are not read.
  template <class Is_wanted, class Function>
  void for_each_alive(Id_range<Triangle_id> range, const Is_wanted& is_wanted, const Function& f) const {
    visit_with_foresight(
        range,
        [&](Triangle_id t) {
          if (is_wanted(t)) prefetch_corners(t), prefetch_neighbors(t);
        },
        [&](Triangle_id t) {
          if (is_wanted(t) && is_alive(t)) f(t);
        });
  }
  template <class Function>
  void for_each_alive(Id_range<Triangle_id> range, const Function& f) const {
    for_each_alive(
        range, [](Triangle_id) { return true; }, f);
  }

  Side across(Side s) const { return triangle(s.triangle()).side[s.slot()]; }
  Vertex_id opposite(Side s) const { return triangle(s.triangle()).v[s.slot()]; }
  /// The ends of a side; the triangle lies to the left of source -> target.
  Vertex_id source(Side s) const { return triangle(s.triangle()).v[next_slot[s.slot()]]; }
  Vertex_id target(Side s) const { return triangle(s.triangle()).v[previous_slot[s.slot()]]; }

  static int slot_of_least(const Triangle& t) {
    const int k = t.v[1] < t.v[0] ? 1 : 0;
    return t.v[2] < t.v[k] ? 2 : k;
  }
  static int slot_of(const Triangle& t, Vertex_id v) { return t.v[0] == v ? 0 : t.v[1] == v ? 1 : 2; }

  Vertex_id add_vertex(Point p, Vertex_role role) {
    role_of.push_back(role);
    triangle_of.push_back({});
    is_dirty.push_back(1);
    points.push_back(p);
    return points.last_id();
  }

  Triangle_id new_triangle() {
    if (free_.empty()) {
      if (!region_of.empty()) region_of.push_back({});
      triangles.push_back(Triangle());
      return triangles.last_id();
    }
    const Triangle_id t = free_.back();
    free_.pop_back();
    return t;
  }

  void set_region(Triangle_id t, Region_id region) {
    if (!region_of.empty()) region_of[t] = region;
  }

  /// Makes room for vertices and triangles with handles below these, to be filled in by the caller.
  void resize(std::size_t vertices, std::size_t number_of_slots) {
    points.resize(vertices), role_of.resize(vertices), triangle_of.resize(vertices);
    is_dirty.resize(vertices);
    triangles.resize(number_of_slots);
    if (!region_of.empty()) region_of.resize(number_of_slots);
  }

  /// Empties the mesh, which keeps its memory.
  void clear() {
    triangles.clear(), points.clear(), triangle_of.clear(), role_of.clear(), is_dirty.clear();
    region_of.clear(), free_.clear(), star_.clear();
  }

  /// Room for this many in the end, so that they are copied less often.
  void reserve(std::size_t vertices, std::size_t number_of_slots) {
    reserve_in_parallel(points, vertices), reserve_in_parallel(role_of, vertices);
    reserve_in_parallel(triangle_of, vertices), reserve_in_parallel(is_dirty, vertices);
    reserve_in_parallel(triangles, number_of_slots);
    if (!region_of.empty()) reserve_in_parallel(region_of, number_of_slots);
  }

  void kill(Triangle_id t) {
    triangle(t).v[0] = {};
    free_.push_back(t);
  }

  /// Writes or reads all of it (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(triangles, points, triangle_of, role_of, is_dirty, region_of, free_);
  }

  std::size_t number_of_triangles() const { return triangles.size() - free_.size(); }
  /// The slots of triangles that are not alive, in no order.
  const std::vector<Triangle_id>& dead_triangles() const { return free_; }
  /// Puts these in their place, and marks them as dead.
  void set_dead_triangles(std::vector<Triangle_id> dead) {
    for (const Triangle_id t : dead) triangle(t).v[0] = {};
    free_ = std::move(dead);
  }

  /// Makes `other` (a side with its bit, or the border) what lies across side `slot` of t, and the converse.
  void link(Triangle_id t, int slot, Side other) {
    triangle(t).side[slot] = other;
    if (!other.is_border())
      triangle(other.triangle()).side[other.slot()] = Side(t, slot, other.is_constrained());
  }

  /// Sets or clears the constraint bit of the edge, on both sides of it.
  void constrain(Side s) {
    const Side o = across(s);
    if (o.is_border()) return;
    triangle(s.triangle()).side[s.slot()].constrain();
    triangle(o.triangle()).side[o.slot()].constrain();
  }
  void release(Side s) {
    const Side o = across(s);
    if (o.is_border()) return;
    triangle(s.triangle()).side[s.slot()].release();
    triangle(o.triangle()).side[o.slot()].release();
  }

  Shape shape(Vertex_id a, Vertex_id b, Vertex_id c) const { return shape(point(a), point(b), point(c)); }
  Shape shape(const Triangle& t) const { return shape(t.v[0], t.v[1], t.v[2]); }
  static Shape shape(const Point& a, const Point& b, const Point& c) {
    const auto u = Geometry::scaled_difference(b, a), v = Geometry::scaled_difference(c, b),
               w = Geometry::scaled_difference(a, c);
    return {{squared_length(v), squared_length(w), squared_length(u)}, Geometry::doubled_area(u, v, a, b, c)};
  }

  /// With an area that is good to a relative 1e-4 however flat the triangle is.
  Shape shape_of_flat(Vertex_id a, Vertex_id b, Vertex_id c) const {
    Shape s = shape(a, b, c);
    s.area2 = Geometry::doubled_area_of_flat(Geometry::scaled_difference(point(b), point(a)),
                                             Geometry::scaled_difference(point(c), point(b)), point(a),
                                             point(b), point(c));
    return s;
  }

  int orientation(Vertex_id a, Vertex_id b, Vertex_id c) const {
    return Geometry::orientation(point(a), point(b), point(c));
  }

  /// Exchanges the diagonal of the quadrilateral at side k of t. Afterward t = (a, b, d), its neighbor u =
  /// (a, d, c).
  void flip(Triangle_id t, int k) {
    Triangle& I = triangle(t);
    const Side o = I.side[k];
    const Triangle_id u = o.triangle();
    const int l = o.slot();
    Triangle& J = triangle(u);
    const Vertex_id a = I.v[k], b = I.v[next_slot[k]], c = I.v[previous_slot[k]], d = J.v[l];
    const Side ca = I.side[next_slot[k]], ab = I.side[previous_slot[k]];
    const Side bd = J.side[next_slot[l]], dc = J.side[previous_slot[l]];
    I.v[0] = a, I.v[1] = b, I.v[2] = d;
    J.v[0] = a, J.v[1] = d, J.v[2] = c;
    link(t, 0, bd), link(t, 2, ab), link(u, 0, dc), link(u, 1, ca);
    I.side[1] = Side(u, 2), J.side[2] = Side(t, 1);
    triangle_of[a] = triangle_of[b] = triangle_of[d] = t;
    triangle_of[c] = u;
  }

  /// Whether the free side k of t has to be flipped: the apex across lies certainly inside t's circle.
  /// Ties and near-ties are left as they are, so that flipping ends whatever the rounding.
  bool is_certainly_not_Delaunay(Triangle_id t, int k) const {
    const Triangle& r = triangle(t);
    const Point& d = point(opposite(r.side[k]));
    return Geometry::is_certainly_in_circle(point(r.v[k]), point(r.v[next_slot[k]]),
                                            point(r.v[previous_slot[k]]), d);
  }

  /// Flips until the given sides, and those of triangles that flips change, are Delaunay or not certainly else. Calls
  /// `flipped(t, u)` after each flip, with its two triangles, and `before_look(s)` before the triangle beyond a side is
  /// read.
  template <class Flipped, class Before_look>
  void make_Delaunay(std::vector<Side>& doubtful, const Flipped& flipped, const Before_look& before_look) {
    while (!doubtful.empty()) {
      const Side s = doubtful.back();
      doubtful.pop_back();
      before_look(s);
      const Side o = across(s);
      if (o.is_constrained() || !is_certainly_not_Delaunay(s.triangle(), s.slot())) continue;
      flip(s.triangle(), s.slot());
      const Triangle_id t = s.triangle(), u = o.triangle();
      for (const Side n : {Side(t, 0), Side(u, 0), Side(t, 2), Side(u, 1)}) doubtful.push_back(n);
      flipped(t, u);
    }
  }

  template <class Flipped>
  void make_Delaunay(std::vector<Side>& doubtful, const Flipped& flipped) {
    make_Delaunay(doubtful, flipped, [](Side) {});
  }
  void make_Delaunay(std::vector<Side>& doubtful) {
    make_Delaunay(
        doubtful, [](Triangle_id, Triangle_id) {}, [](Side) {});
  }

  /// Puts vertex v inside triangle t and restores the Delaunay property around it.
  void insert_in_triangle(Triangle_id t, Vertex_id v) {
    const Triangle old = triangle(t);
    const Triangle_id part[3] = {t, new_triangle(), new_triangle()};
    for (int k = 0; k < 3; ++k) {
      set_region(part[k], region(t));
      Triangle& n = triangle(part[k]);
      n.v[0] = v, n.v[1] = old.v[next_slot[k]], n.v[2] = old.v[previous_slot[k]];
      n.side[1] = Side(part[next_slot[k]], 2), n.side[2] = Side(part[previous_slot[k]], 1);
      triangle_of[n.v[1]] = part[k];
    }
    for (int k = 0; k < 3; ++k) {
      link(part[k], 0, old.side[k]);
      prefetch_apex(old.side[k]);
      star_.push_back(part[k]);
    }
    triangle_of[v] = t;
    legalize_star();
  }

  /// Puts vertex v on side k of t, whose two halves inherit the constraint bit, and restores the Delaunay
  /// property.
  void insert_on_side(Triangle_id t, int k, Vertex_id v) {
    const Side o = triangle(t).side[k];
    const bool bit = o.is_constrained();
    const Triangle A = triangle(t);
    const Vertex_id a = A.v[k], b = A.v[next_slot[k]], c = A.v[previous_slot[k]];
    const Triangle_id t2 = new_triangle();
    set_region(t2, region(t));
    set(t, v, a, b), set(t2, v, c, a);
    link(t, 0, A.side[previous_slot[k]]), link(t2, 0, A.side[next_slot[k]]);
    triangle(t).side[2] = Side(t2, 1), triangle(t2).side[1] = Side(t, 2);
    triangle(t).side[1] = triangle(t2).side[2] = Side::border();
    if (!o.is_border()) insert_on_far_side(o, v, t, t2, bit);
    triangle_of[v] = triangle_of[a] = triangle_of[b] = t;
    triangle_of[c] = t2;
    star_.push_back(t), star_.push_back(t2);
    legalize_star();
  }

  /// Calls `f(t, slot of v in t)` for every triangle at v, counterclockwise; for a vertex on the border the
  /// fan is completed clockwise from where the walk began. (An input vertex where parts of the domain merely
  /// touch has several fans; one is visited.)
  template <class Function>
  void for_each_triangle_at(Vertex_id v, Function f) const {
    Fan_walk<Kernel_mesh> walk(*this, v);
    do f(walk.triangle(), walk.slot());
    while (walk.advance());
  }

  /// The side a-b, seen from the triangle to its left where there is one; the border if neither the fan of a that is
  /// stored nor that of b has it. Both fans are gone around in step, until one of them has the answer: so the sides
  /// of any planar graph are found in O(1) each on average, whatever the degrees (Chiba and Nishizeki, "Arboricity
  /// and subgraph listing algorithms", 1985: the sum of the lesser degrees is O(n)).
  Side find_side(Vertex_id a, Vertex_id b) const {
    Fan_walk<Kernel_mesh> at_a(*this, a), at_b(*this, b);
    for (;;) {
      Side found = at_a.side_to(b);
      if (found.is_border()) found = at_b.side_to(a);
      if (!found.is_border()) return seen_from_left(found, a);
      const bool has_more = at_a.advance(), other_has_more = at_b.advance();
      if (at_a.is_closed() || at_b.is_closed() || (!has_more && !other_has_more)) return Side::border();
    }
  }

private:
  std::vector<Triangle_id> free_;
  std::vector<Triangle_id> star_;

  /// A side with end a, from the triangle to the left of it as it leaves a, if there is one.
  Side seen_from_left(Side s, Vertex_id a) const {
    const Side o = across(s);
    return source(s) == a || o.is_border() ? s : Side(o.triangle(), o.slot());
  }

  void set(Triangle_id t, Vertex_id a, Vertex_id b, Vertex_id c) {
    Triangle& r = triangle(t);
    r.v[0] = a, r.v[1] = b, r.v[2] = c;
  }

  void insert_on_far_side(Side o, Vertex_id v, Triangle_id t, Triangle_id t2, bool bit) {
    const Triangle_id u = o.triangle(), u2 = new_triangle();
    set_region(u2, region(u));
    const int l = o.slot();
    const Triangle B = triangle(u);
    const Vertex_id d = B.v[l], c = B.v[next_slot[l]], b = B.v[previous_slot[l]];
    set(u, v, b, d), set(u2, v, d, c);
    link(u, 0, B.side[next_slot[l]]), link(u2, 0, B.side[previous_slot[l]]);
    triangle(u).side[1] = Side(u2, 2), triangle(u2).side[2] = Side(u, 1);
    triangle(t).side[1] = Side(u, 2, bit), triangle(u).side[2] = Side(t, 1, bit);
    triangle(t2).side[2] = Side(u2, 1, bit), triangle(u2).side[1] = Side(t2, 2, bit);
    triangle_of[d] = u;
    star_.push_back(u), star_.push_back(u2);
  }

  /// Flips until the sides opposite the new vertex, at slot 0 of every triangle on the stack, are Delaunay.
  void legalize_star() {
    while (!star_.empty()) {
      Triangle_id t = star_.back();
      star_.pop_back();
      for (;;) {
        const Side o = triangle(t).side[0];
        if (o.is_constrained() || !is_certainly_not_Delaunay(t, 0)) break;
        flip_at_apex(t);
        star_.push_back(t);
        t = o.triangle();
      }
    }
  }

  /// `flip(t, 0)`: vertex 0, and the side opposite vertex 2, stay where they are.
  void flip_at_apex(Triangle_id t) {
    Triangle& I = triangle(t);
    const Side o = I.side[0];
    const Triangle_id u = o.triangle();
    const int l = o.slot();
    Triangle& J = triangle(u);
    const Vertex_id a = I.v[0], b = I.v[1], c = I.v[2], d = J.v[l];
    const Side ca = I.side[1], bd = J.side[next_slot[l]], dc = J.side[previous_slot[l]];
    I.v[2] = d;
    J.v[0] = a, J.v[1] = d, J.v[2] = c;
    link(t, 0, bd), link(u, 0, dc), link(u, 1, ca);
    prefetch_apex(bd);
    I.side[1] = Side(u, 2), J.side[2] = Side(t, 1);
    triangle_of[a] = triangle_of[b] = triangle_of[d] = t;
    triangle_of[c] = u;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KERNEL_MESH_H
