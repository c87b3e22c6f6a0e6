// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Inserts placed vertices into the constrained Delaunay triangulation of the domain.
//
// Computes: the constrained Delaunay triangulation of the graph and the placed vertices, restricted to the domain.
//           Input vertices keep their numbers, and placed ones follow.
// Bound:    expected O(1) for each vertex, as corners of leaves are as far from each other as features are. Blocks of
//           the triangulation (Mesh_blocks.h) get their vertices at the same time, and what is at seams is inserted
//           afterward, by one thread.
// Source:   Bern, Eppstein, Teng, section 6; constrained Delaunay where the paper triangulates each leaf.
//
// A corner of a leaf is left out if it is at the place of another vertex, on an edge, or outside of the domain. A
// vertex on an edge is left out if rounding has put it where triangles beside the edge would be turned over, which its
// room (Edge_rooms.h) nearly rules out.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_INSERTION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_INSERTION_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Block_cut.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Placed_insertion {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;
  using Placed = Placed_vertices<Geometry>;
  using Run = typename Placed::Run;

  /// \param state whose mesh is replaced
  /// \param placed its corners are located in `triangles.mesh()`, the triangulation of the domain
  Placed_insertion(Meshing_state<Geometry>& state, const Placed& placed,
                   const Edge_triangles<Geometry>& triangles)
      : state_(state), mesh_(state.mesh), placed_(placed), triangles_(triangles) {}

  /// Makes the mesh anew.
  /// \returns edges without some of their vertices, which rounding has put in the wrong place
  std::vector<Edge_id> run() {
    begin_with_domain();
    if (state_.problem.vertex_blocks.size() < 2)
      insert_all();
    else
      insert_in_blocks();
    return std::move(cramped_);
  }

  /// Placed vertices on an edge that are missing between two that follow each other in the mesh.
  struct Gap {
    Run run;
    Vertex_id a, b; ///< of the mesh
  };

  /// Inserts into a mesh that this has made before the corners that it has not got, and the vertices in gaps.
  /// \returns the same of edges with gaps
  std::vector<Edge_id> add_to_mesh(const std::vector<Gap>& gaps) {
    Last_inserted last(triangles_.mesh().triangles.size());
    for (std::size_t i = 0; i < placed_.triangle_of_corner.size(); ++i) add_corner(i, last);
    for (const Gap& gap : gaps) fill(gap);
    return std::move(cramped_);
  }

private:
  using Block = Mesh_block<Geometry>;
  using Blocks = Mesh_blocks<ConcurrencyTag, Geometry>;
  /// The vertex inserted last into each triangle of the domain. Nothing is between two places in one of them, and
  /// corners of leaves come in the order of leaves, so a walk from there is short. One from the last vertex of all may
  /// not be: if an edge is between, it has to begin anew, far away.
  using Last_inserted = Indexed_vector<Triangle_id, Vertex_id>;

  /// Whether it is known what becomes of a corner.
  enum class Insertion { DONE, BLOCKED };

  /// What comes of the work in a block, by number in `placed_`.
  struct Block_work {
    std::vector<std::uint32_t> corners_left, runs_left;
    std::vector<Edge_id> cramped;
  };

  Meshing_state<Geometry>& state_;
  Mesh& mesh_;
  const Placed& placed_;
  const Edge_triangles<Geometry>& triangles_;
  std::vector<Edge_id> cramped_;

  /// The triangulation of the domain, with all vertices, of which placed ones have no triangles.
  void begin_with_domain() {
    const Mesh& domain = triangles_.mesh();
    const std::size_t first = domain.number_of_vertices(), n = placed_.points.size();
    constexpr double share_of_refinement = 0.5; // of the vertices, and more
    const auto with_refinement = [](std::size_t size) {
      return size + static_cast<std::size_t>(share_of_refinement * static_cast<double>(size));
    };
    mesh_.clear();
    mesh_.reserve(with_refinement(n), with_refinement(domain.triangles.size() + 2 * (n - first)));
    mesh_ = domain;
    mesh_.resize(n, mesh_.triangles.size());
    for_each_index<ConcurrencyTag>(n - first, [&](std::size_t i) {
      const Vertex_id v(first + i);
      mesh_.points[v] = placed_.points[v], mesh_.role_of[v] = placed_.role_of[v];
      mesh_.triangle_of[v] = {}, mesh_.is_dirty[v] = 1;
    });
  }

  Vertex_id corner(std::size_t i) const { return Vertex_id(placed_.first_corner.value() + i); }

  // ---- in the whole mesh

  void insert_all() {
    Last_inserted last(triangles_.mesh().triangles.size());
    for (std::size_t i = 0; i < placed_.triangle_of_corner.size(); ++i) insert_corner_late(i, last);
    for (const Run& run : placed_.runs) insert_run_late(run);
  }

  void insert_corner_late(std::size_t i, Last_inserted& last) {
    const Triangle_id t = placed_.triangle_of_corner[i];
    if (insert_corner(mesh_, corner(i), t, last[t]) == Insertion::DONE) return;
    const Walk_end end = locate_from_vertices_of(t, mesh_.point(corner(i)));
    const auto handle = [this, i] { return corner(i); };
    if (!end.is_blocked()) insert_corner_at(mesh_, mesh_.point(corner(i)), handle, end.triangle, last[t]);
  }

  void add_corner(std::size_t i, Last_inserted& last) {
    const Triangle_id t = placed_.triangle_of_corner[i];
    const Point& p = placed_.points[corner(i)];
    Walk_end end{{}, 0};
    if (last[t].is_valid()) end = locate_exactly(mesh_, mesh_.incident_triangle(last[t]), p);
    if (end.is_blocked()) end = locate_from_vertices_of(t, p);
    if (end.is_blocked()) return;
    insert_corner_at(
        mesh_, p, [&] { return mesh_.add_vertex(p, free_vertex); }, end.triangle, last[t]);
  }

  /// \param t the triangle of the domain that has p. Nothing is between p and its vertices, whatever was inserted.
  Walk_end locate_from_vertices_of(Triangle_id t, const Point& p) const {
    for (const Vertex_id v : triangles_.mesh().triangle(t).v) {
      const Triangle_id start = triangle_toward(mesh_, v, mesh_.incident_triangle(v), p);
      if (!start.is_valid()) continue;
      const Walk_end end = walk_along(mesh_, start, mesh_.point(v), p);
      if (!end.is_blocked()) return end;
    }
    return {{}, 0};
  }

  void insert_run_late(const Run& run) {
    const Vertex_id a = state_.edges[run.edge].a, b = state_.edges[run.edge].b;
    insert_run(
        mesh_, run, a, b, state_.side_between(a, b), [](Vertex_id v) { return v; }, cramped_);
  }

  /// Where a vertex that should have been removed is still between, nothing is inserted.
  void fill(const Gap& gap) {
    const Side s = state_.side_between(gap.a, gap.b);
    if (s.is_border()) return cramped_.push_back(gap.run.edge);
    const auto handle = [this](Vertex_id v) {
      return mesh_.add_vertex(placed_.points[v], placed_.role_of[v]);
    };
    insert_run(mesh_, gap.run, gap.a, gap.b, s, handle, cramped_);
  }

  // ---- in blocks

  void insert_in_blocks() {
    Block_assignment assignment;
    Blocks blocks(
        mesh_, assignment,
        cut_by_vertices<ConcurrencyTag>(mesh_, state_.problem.vertex_blocks, [](Vertex_id v) { return v; }));
    const auto corners = group_in_order<ConcurrencyTag, std::uint32_t>(
        placed_.triangle_of_corner.size(), blocks.size(),
        [&](std::size_t i) -> std::size_t { return blocks.block_of(placed_.triangle_of_corner[i]).value(); });
    const auto runs = group_in_order<ConcurrencyTag, std::uint32_t>(
        placed_.runs.size(), blocks.size(), [&](std::size_t i) -> std::size_t {
          return blocks.block_of(triangles_[placed_.runs[i].edge].any().triangle()).value();
        });
    Indexed_vector<Block_id, Block_work> works(blocks.size());
    blocks.for_each(
        [&](Block& block) {
          const std::size_t b = block.id().value();
          insert_corners(block, blocks, corners[b], works[block.id()]);
          insert_runs(block, runs[b], works[block.id()]);
        },
        [](const Block&) {});
    blocks.put_together();
    std::vector<Side> doubtful = blocks.sides_to_flip();
    mesh_.make_Delaunay(doubtful);
    Last_inserted last(triangles_.mesh().triangles.size());
    for (const Block_work& work : works) insert_what_is_left(work, last);
  }

  void insert_corners(Block& block, const Blocks& blocks, Span<std::uint32_t> corners,
                      Block_work& work) const {
    Last_inserted last(block.mesh.triangles.size());
    for (const std::uint32_t i : corners) {
      const Vertex_id v = block.add_known_vertex(corner(i));
      const Triangle_id t = blocks.place_of(placed_.triangle_of_corner[i]);
      if (insert_corner(block.mesh, v, t, last[t]) == Insertion::BLOCKED) work.corners_left.push_back(i);
    }
  }

  void insert_runs(Block& block, Span<std::uint32_t> runs, Block_work& work) const {
    for (const std::uint32_t i : runs) {
      const Run& run = placed_.runs[i];
      const Vertex_id a = block.vertex_in_block(state_.edges[run.edge].a),
                      b = block.vertex_in_block(state_.edges[run.edge].b);
      const Side s = block.mesh.find_side(a, b);
      if (s.is_border() || block.mesh.across(s).is_seam())
        work.runs_left.push_back(i);
      else
        insert_run(
            block.mesh, run, a, b, s, [&block](Vertex_id v) { return block.add_known_vertex(v); },
            work.cramped);
    }
  }

  void insert_what_is_left(const Block_work& work, Last_inserted& last) {
    cramped_.insert(cramped_.end(), work.cramped.begin(), work.cramped.end());
    for (const std::uint32_t i : work.corners_left) insert_corner_late(i, last);
    for (const std::uint32_t i : work.runs_left) insert_run_late(placed_.runs[i]);
  }

  // ---- single vertices

  /// \param t at the place of v, before vertices were inserted
  /// \param last the vertex inserted last into t, if there is one; v, if that is inserted
  static Insertion insert_corner(Mesh& mesh, Vertex_id v, Triangle_id t, Vertex_id& last) {
    const Point p = mesh.point(v);
    Walk_end end{{}, 0};
    if (last.is_valid()) end = locate_exactly(mesh, mesh.incident_triangle(last), p);
    if (end.is_blocked()) end = locate_exactly(mesh, t, p);
    const auto handle = [v] { return v; };
    return end.is_blocked() ? Insertion::BLOCKED : insert_corner_at(mesh, p, handle, end.triangle, last);
  }

  /// \param handle gives that of the vertex once it is certain to be inserted
  /// \param t has the place p of the corner
  template <class Handle>
  static Insertion insert_corner_at(Mesh& mesh, const Point& p, const Handle& handle, Triangle_id t,
                                    Vertex_id& last) {
    const auto r = mesh.triangle(t);
    int on_slot = -1;
    for (int k = 0; k < 3; ++k) {
      const Point &a = mesh.point(r.v[next_slot[k]]), &b = mesh.point(r.v[previous_slot[k]]);
      if (mesh.point(r.v[k]) == p) return Insertion::DONE;
      if (Geometry::orientation(a, b, p) == 0) on_slot = k;
    }
    if (on_slot >= 0 && r.side[on_slot].is_seam()) return Insertion::BLOCKED;
    if (on_slot >= 0 && r.side[on_slot].is_constrained()) return Insertion::DONE;
    const Vertex_id v = handle();
    if (on_slot < 0)
      mesh.insert_in_triangle(t, v);
    else
      mesh.insert_on_side(t, on_slot, v);
    last = v;
    return Insertion::DONE;
  }

  /// A piece of an edge, which is not at a seam, and the vertices to be inserted on it.
  struct Piece {
    Vertex_id a, b;
    std::size_t first, last; ///< placed vertices
    std::size_t size() const { return last - first; }
  };

  /// \param a, b its ends in the mesh
  /// \param handle gives the handle in the mesh of a placed vertex that is inserted
  template <class Handle>
  void insert_run(Mesh& mesh, const Run& run, Vertex_id a, Vertex_id b, Side s, const Handle& handle,
                  std::vector<Edge_id>& cramped) const {
    const std::size_t first = run.first.value();
    std::vector<Piece> pieces{{a, b, first, first + run.size}};
    bool are_all_inserted = true;
    while (!pieces.empty()) {
      const Piece piece = pieces.back();
      pieces.pop_back();
      if (piece.size() == 0) continue;
      if (piece.size() < run.size) s = mesh.find_side(piece.a, piece.b);
      const std::size_t i = place_to_split(mesh, piece, s);
      are_all_inserted = are_all_inserted && i < piece.last;
      if (i == piece.last) continue;
      const Vertex_id v = handle(static_cast<Vertex_id>(i));
      mesh.insert_on_side(s.triangle(), s.slot(), v);
      pieces.push_back({v, piece.b, i + 1, piece.last});
      pieces.push_back({piece.a, v, piece.first, i});
    }
    if (!are_all_inserted) cramped.push_back(run.edge);
  }

  /// Which vertex splits a piece: the middle one, if there is room for it. Triangles beside a long piece may be too low
  /// for one that is far from their apex. Then another one is first. None: the last one's successor.
  std::size_t place_to_split(const Mesh& mesh, const Piece& piece, Side s) const {
    constexpr std::size_t most_parts = 32;
    for (std::size_t parts = 2; parts <= most_parts && parts < 4 * piece.size(); parts *= 2)
      for (std::size_t part = 1; part < parts; part += 2) {
        const std::size_t i = piece.first + piece.size() * part / parts;
        if (may_split_at(mesh, s, placed_.points[static_cast<Vertex_id>(i)])) return i;
      }
    return piece.last;
  }

  /// Whether the triangles at a side keep their orientation if the side is split at p, which rounding may have put
  /// beside it. Lengths are for rooms to judge.
  static bool may_split_at(const Mesh& mesh, Side s, const Point& p) {
    const Side o = mesh.across(s);
    return keeps_orientation(mesh, s, p) && (o.is_border() || keeps_orientation(mesh, o, p));
  }
  static bool keeps_orientation(const Mesh& mesh, Side s, const Point& p) {
    const Point& apex = mesh.point(mesh.opposite(s));
    return Geometry::orientation(apex, mesh.point(mesh.source(s)), p) > 0 &&
           Geometry::orientation(apex, p, mesh.point(mesh.target(s))) > 0;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_INSERTION_H
