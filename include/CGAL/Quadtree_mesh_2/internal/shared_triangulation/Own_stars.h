// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The stars of some vertices in the constrained Delaunay triangulation of a graph, without the rest of it.
//
// Computes: a triangulation of a run of the vertices in shuffle order and of some others, in which the triangles at the
//           vertices of the run are those of the canonical triangulation of all (Canonical_flipper.h).
// Bound:    that of First_triangulation.h for the run and O(r + n / 256) others, in practice, where r is the number of
//           triangles at the run's seams; and O(log n) for each triangle at the run, for graphs without many long
//           segments.
// Method:   The run, a sample of all vertices, and all segments at the run are triangulated. Then each triangle at the
//           run is asked whether there is a vertex in its circle that sees it, or a segment that meets it, which is not
//           in the triangulation (Graph_boxes.h, Triangle_reach.h). These are inserted, and the triangles that are new
//           are asked again, until no triangle knows of any. All that is asked is of the whole graph and exact: a
//           triangle with an empty circle, as far as it is seen, is one of the triangulation of all (Lee and Lin,
//           1986).
// Source:   ours. Parts that find stars from a graph that all know exchange nothing.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_STARS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_STARS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Clear_boxes.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Graph_boxes.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Triangle_reach.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Canonical_flipper.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Delaunay_inserter.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Segment_inserter.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Own_stars {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Graph = Kernel_graph<Geometry>;
  using Point = typename Geometry::Point;
  using Box = Place_box<Point>;

  /// \param box of all vertices of the graph
  /// \param own the run, without repeated vertices; of these there are no stars
  Own_stars(const Graph& graph, const Box& box, Vertex_run own)
      : graph_(graph), box_(box), own_(own), boxes_(graph), clear_(graph, boxes_, own),
        local_(graph.number_of_vertices) {}

  /// \returns false if the triangulation is of no use: segments cross, or vertices are at one place that are not next
  /// to each other in the order; or it would take too long, as circles run along many vertices
  bool run() {
    choose_vertices();
    if (!triangulate_chosen()) return false;
    find_missing(few_); // which tells if all would take too long
    if (is_late(0)) return false;
    asked_.clear();
    while (has_time_for(1)) {
      const Missing missing = find_missing(1);
      if (!has_time_for(1)) return false;
      if (missing.is_empty()) return true;
      if (!insert(missing)) return false;
      flip_changed();
    }
    return false;
  }

  Vertex_run own() const { return own_; }
  /// The triangulation. `Mesh::input_number()` gives the number in the graph of a vertex; that of the auxiliary ones
  /// follows on the last of them.
  const Mesh& mesh() const { return mesh_; }
  bool is_own(Vertex_id v) const { return own_.has(mesh_.input_number(v)); }
  /// The vertex with a number in the graph, if it is in the triangulation.
  Vertex_id local(Vertex_id number) const { return local_[number]; }
  /// Whether a segment is in the triangulation.
  bool is_in(Segment_index s) const {
    const Segment_ends& ends = graph_.segments[std::size_t(s)];
    return is_own_end(ends) || std::binary_search(segments_.begin(), segments_.end(), s);
  }

private:
  static constexpr std::size_t sample_ = 256;
  /// As many take about as long as all else that is done for a triangle. Maps take a tenth.
  static constexpr std::size_t looks_for_triangle_ = 64, least_triangles_ = 32768, few_ = 64;
  /// How many looks a vertex is worth for which filtered predicates are no help.
  static constexpr std::size_t looks_for_exact_ = 32;
  /// How many triangles are a look where all of them are gone through.
  static constexpr std::size_t triangles_for_look_ = 16;

  using Reach = Triangle_reach<Geometry>;
  using Corners = std::array<Vertex_id, 3>;

  /// What a triangle has asked for.
  template <class Id>
  struct Found {
    Id id;
    Triangle_id near;

    friend bool operator<(const Found& a, const Found& b) {
      return a.id < b.id || (a.id == b.id && a.near < b.near);
    }
    friend bool operator==(const Found& a, const Found& b) { return a.id == b.id; }
  };
  struct Missing {
    std::vector<Found<Vertex_id>> vertices;
    std::vector<Found<Segment_index>> segments;

    bool is_empty() const { return vertices.empty() && segments.empty(); }
  };
  /// What is looked for.
  struct Look {
    bool vertex = true, segment = true;

    bool is_over() const { return !vertex && !segment; }
    bool is_any_found() const { return !vertex || !segment; }
  };

  const Graph& graph_;
  Box box_;
  Vertex_run own_;
  Graph_boxes<Geometry> boxes_;
  Clear_boxes<Geometry> clear_;
  Mesh mesh_;
  Indexed_vector<Vertex_id, Vertex_id> local_; // by number in the graph
  std::size_t most_looks_ = 0;
  std::atomic<std::size_t> looks_{0};          // at boxes, and at vertices and segments in them
  std::vector<Segment_index> segments_;        // in the triangulation, without ends in the run
  Indexed_vector<Triangle_id, Corners> asked_; // the triangles as they were when they knew of nothing missing

  bool is_own_end(const Segment_ends& ends) const { return own_.has(ends[0]) || own_.has(ends[1]); }

  /// Gives the chosen vertices local handles in the order of their numbers.
  void choose_vertices() {
    const Vertex_id chosen(0);
    const std::size_t n = graph_.number_of_vertices;
    for (const Vertex_id v : Id_range<Vertex_id>(own_.begin, own_.end)) local_[v] = chosen;
    for (std::size_t v = 0; v < n; v += sample_) local_[Vertex_id(v)] = chosen;
    for (const Segment_ends& ends : graph_.segments)
      if (is_own_end(ends)) local_[ends[0]] = local_[ends[1]] = chosen;
    std::size_t size = 0;
    for (const Vertex_id v : Id_range<Vertex_id>(0, n))
      if (local_[v].is_valid()) local_[v] = graph_.is_repeated(v) ? Vertex_id() : Vertex_id(size++);
    mesh_.points.reserve(First_triangulation<ConcurrencyTag, Geometry>::room_for(size));
    for (const Vertex_id v : Id_range<Vertex_id>(0, n))
      if (local_[v].is_valid()) mesh_.points.push_back(graph_.points[v]);
  }

  bool triangulate_chosen() {
    const std::size_t n = mesh_.points.size();
    std::vector<Segment_ends> segments;
    for (const Segment_ends& ends : graph_.segments)
      if (is_own_end(ends) && ends[0] != ends[1]) segments.push_back({local_[ends[0]], local_[ends[1]]});
    const Vertex_blocks blocks = blocks_by_number(n, Block_sizes<ConcurrencyTag>::vertices);
    First_triangulation<ConcurrencyTag, Geometry> first(mesh_, blocks, box_);
    if (first.run(std::move(segments)) || first.number_of_repeated_vertices() > 0) return false;
    if (blocks.size() < 2) Canonical_flipper<ConcurrencyTag, Geometry>(mesh_).run(); // as it is in blocks
    for (const Vertex_id v : Id_range<Vertex_id>(0, graph_.number_of_vertices))
      if (local_[v].is_valid()) mesh_.role_of[local_[v]] = input_vertex(v);
    for (std::size_t k = 0; k < first.number_of_auxiliary_vertices; ++k)
      mesh_.role_of[Vertex_id(n + k)] = input_vertex(Vertex_id(graph_.number_of_vertices + k));
    return true;
  }

  // ---- what is missing

  /// Allows for the looks of the triangles with handles that are multiples of a step.
  /// \returns false if so many are done
  bool has_time_for(std::size_t step) {
    most_looks_ = looks_for_triangle_ * (mesh_.triangles.size() / step + least_triangles_);
    return looks_ <= most_looks_;
  }

  bool is_late(std::size_t looks) const {
    return looks_.load(std::memory_order_relaxed) + looks > most_looks_;
  }

  /// Asks the triangles with handles that are multiples of a step.
  Missing find_missing(std::size_t step) {
    if (!has_time_for(step)) return {};
    const std::size_t n = (mesh_.triangles.size() + step - 1) / step;
    asked_.resize(mesh_.triangles.size());
    std::vector<Missing> found((n + default_block - 1) / default_block);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ask(static_cast<Triangle_id>(i * step), found[b]);
    });
    Missing all;
    append_all<ConcurrencyTag>(
        all.vertices, found, [](const Missing& m) -> const auto& { return m.vertices; });
    append_all<ConcurrencyTag>(
        all.segments, found, [](const Missing& m) -> const auto& { return m.segments; });
    sort_and_drop_equal(all.vertices), sort_and_drop_equal(all.segments);
    return all;
  }

  /// Looks for a vertex and a segment that are missing at a triangle.
  void ask(Triangle_id t, Missing& missing) {
    const auto& v = mesh_.triangle(t).v;
    if (asked_[t] == corners_of(t)) return;
    asked_[t] = corners_of(t);
    if (!is_own(v[0]) && !is_own(v[1]) && !is_own(v[2])) return;
    const int k = is_own(v[0]) ? 0 : is_own(v[1]) ? 1 : 2;
    const Reach reach = reach_of(t, k);
    const Box* const clear = clear_.around(mesh_.input_number(v[k]));
    if (clear != nullptr && reach.is_within(*clear)) return;
    Look left;
    std::size_t looks = 0;
    boxes_.descend(
        Look(),
        [&](std::size_t begin, std::size_t end, const auto& node, Look& look) {
          // of the run all are in the triangulation
          if (left.is_over() || own_.has(Vertex_run{begin, end}) || is_late(++looks)) return false;
          look.vertex = look.vertex && left.vertex && reach.may_have_in_circle(node.places);
          look.segment = look.segment && left.segment && !Graph_boxes<Geometry>::is_empty(node.segments) &&
                         reach.may_meet(node.segments);
          return !look.is_over();
        },
        [&](std::size_t begin, std::size_t end, Span<Segment_index> segments, Look look) {
          if (is_late(looks += segments.size())) return;
          if (look.vertex && find_vertex(t, begin, end, missing, looks)) left.vertex = false;
          if (look.segment && find_segment(t, k, reach, segments, missing)) left.segment = false;
        });
    looks_.fetch_add(looks, std::memory_order_relaxed);
    if (left.is_any_found() || is_late(0)) asked_[t] = {}; // there may be more
  }

  /// \param first the slot of the reach's first corner
  Reach reach_of(Triangle_id t, int first) const {
    const auto& r = mesh_.triangle(t);
    const auto corner = [&](int k) {
      return typename Reach::Corner{mesh_.point(r.v[k]), r.side[k].is_constrained()};
    };
    return {corner(first), corner(next_slot[first]), corner(previous_slot[first])};
  }

  bool find_vertex(Triangle_id t, std::size_t begin, std::size_t end, Missing& missing,
                   std::size_t& looks) const {
    for (const Vertex_id w : Id_range<Vertex_id>(begin, end)) {
      if (local_[w].is_valid()) continue;
      const Point& p = graph_.points[w];
      if (!is_in_circle(p, t, looks) || graph_.is_repeated(w) || !sees(p, t, looks)) continue;
      missing.vertices.push_back({w, t});
      return true;
    }
    return false;
  }

  /// Whether a place is inside the circle of a triangle, or on it.
  bool is_in_circle(const Point& p, Triangle_id t, std::size_t& looks) const {
    const auto& v = mesh_.triangle(t).v;
    const Point &a = mesh_.point(v[0]), &b = mesh_.point(v[1]), &c = mesh_.point(v[2]);
    const In_circle test(Geometry::difference(a, p), Geometry::difference(b, p), Geometry::difference(c, p));
    looks += test.is_certain() ? 1 : looks_for_exact_;
    return Geometry::side_of_circle(a, b, c, p) >= 0;
  }

  /// Whether a place in the circle of a triangle sees it, as far as the segments in the triangulation tell. All
  /// triangles between have it in their circles, too, so it is beyond one side of each of them at most.
  /// \pre the triangulation is canonical
  bool sees(const Point& p, Triangle_id t, std::size_t& looks) const {
    for (;; ++looks) {
      const auto& r = mesh_.triangle(t);
      int k = 0;
      while (k < 3 && !is_behind_side(mesh_, r, k, p)) ++k;
      if (k == 3) return true;
      if (r.side[k].is_constrained()) return false;
      t = r.side[k].triangle();
    }
  }

  /// \param first the slot of the reach's first corner
  bool find_segment(Triangle_id t, int first, const Reach& reach, Span<Segment_index> segments,
                    Missing& missing) const {
    const auto& v = mesh_.triangle(t).v;
    const Corners numbers{mesh_.input_number(v[first]), mesh_.input_number(v[next_slot[first]]),
                          mesh_.input_number(v[previous_slot[first]])};
    for (const Segment_index s : segments) {
      if (is_in(s) || !is_in_the_way(numbers, reach, graph_.segments[std::size_t(s)])) continue;
      missing.segments.push_back({s, t});
      return true;
    }
    return false;
  }

  /// Whether a segment is a side of a triangle, leads along one, or crosses it.
  bool is_in_the_way(const Corners& numbers, const Reach& reach, const Segment_ends& ends) const {
    if (ends[0] == ends[1]) return false;
    const auto slot = [&](Vertex_id v) {
      return static_cast<int>(std::find(numbers.begin(), numbers.end(), v) - numbers.begin());
    };
    const int a = slot(ends[0]), b = slot(ends[1]);
    const Point &p = graph_.points[ends[0]], &q = graph_.points[ends[1]];
    if (a == 3 && b == 3) return reach.meets(p, q);
    return (a < 3 && b < 3) || (a < 3 ? reach.is_entered(a, q) : reach.is_entered(b, p));
  }

  Corners corners_of(Triangle_id t) const {
    const auto& v = mesh_.triangle(t).v;
    return {v[0], v[1], v[2]};
  }

  // ---- and inserted

  bool insert(const Missing& missing) {
    std::vector<Found<Segment_index>> segments = missing.segments, for_later;
    if (!insert(missing.vertices, segments)) return false;
    sort_and_drop_equal(segments);
    std::vector<Found<Vertex_id>> ends;
    for (const auto& [s, near] : segments)
      for (const Vertex_id v : graph_.segments[std::size_t(s)]) ends.push_back({v, near});
    if (!insert(std::move(ends), for_later)) return false;
    Segment_inserter<Geometry> inserter(mesh_);
    for (const auto& [s, near] : segments) {
      const Segment_ends& of_graph = graph_.segments[std::size_t(s)];
      try {
        inserter.insert(local_[of_graph[0]], local_[of_graph[1]], s);
      } catch (const Crossing&) {
        return false;
      }
      segments_.push_back(s);
    }
    std::sort(segments_.begin(), segments_.end());
    return true;
  }

  /// Inserts vertices, and what triangles at them ask for.
  /// \returns false if two are at one place, or if it takes too long
  bool insert(std::vector<Found<Vertex_id>> vertices, std::vector<Found<Segment_index>>& segments) {
    while (!vertices.empty()) {
      if (is_late(0)) return false;
      const auto [number, near] = vertices.back();
      vertices.pop_back();
      if (local_[number].is_valid()) continue;
      const Vertex_id v = mesh_.add_vertex(graph_.points[number], input_vertex(number));
      local_[number] = v;
      if (Delaunay_inserter<Geometry>(mesh_).insert(v, near) != v) return false;
      flip_around(v);
      Missing missing;
      asked_.resize(mesh_.triangles.size());
      mesh_.for_each_triangle_at(v, [&](Triangle_id t, int) { ask(t, missing); });
      vertices.insert(vertices.end(), missing.vertices.begin(), missing.vertices.end());
      segments.insert(segments.end(), missing.segments.begin(), missing.segments.end());
    }
    return true;
  }

  void flip_around(Vertex_id v) {
    std::vector<Side> doubtful;
    mesh_.for_each_triangle_at(v, [&](Triangle_id t, int) {
      for (int k = 0; k < 3; ++k) doubtful.push_back(Side(t, k));
    });
    Canonical_flipper<ConcurrencyTag, Geometry>(mesh_).run(doubtful);
  }

  /// Segments have changed triangles here and there.
  void flip_changed() {
    std::vector<Side> doubtful;
    looks_ += mesh_.triangles.size() / triangles_for_look_;
    asked_.resize(mesh_.triangles.size());
    for (const Triangle_id t : mesh_.triangles.ids())
      for (int k = 0; k < 3 && asked_[t] != corners_of(t); ++k) doubtful.push_back(Side(t, k));
    Canonical_flipper<ConcurrencyTag, Geometry>(mesh_).run(doubtful);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_STARS_H
