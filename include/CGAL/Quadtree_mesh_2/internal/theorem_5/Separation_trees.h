// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The quadtrees that separate the features of a planar straight-line graph.
//
// Computes: T_B, the balanced quadtree of the vertices, where it tells distances. T_B', in which each vertex lies
//           in a leaf as small as its distance to the nearest other vertex or edge asks for. T_B'', in which
//           edges that bound a common cell in a leaf are apart. T_B*, in which edges in neighboring leaves are
//           apart as well.
// Bound:    O(log n) rounds for T_B and T_B', and for each split but for balance after it; O((n + k) log n)
//           work, for n vertices and k leaves and pieces of edges in T_B*. Sizes are in proportion to the local
//           feature size, or to the width of the gap in front of an edge. So k is within a constant of the size
//           of any triangulation with such angles.
// Source:   Bern, Eppstein, Teng, section 6; Lemma 5 for the distances.
// Deviates: by default the triangulation of the domain tells the distances (Geodesic_distance.h), and there is no T_B.
//           Several vertices may share a leaf then: leaves are as small as the distances of their vertices ask for, and
//           no smaller.
//           T_B'' and T_B* are made by splitting leaves one level at a time until nothing is too near. The
//           paper finds at once how far to go. So there are as many rounds as levels are missing, and balance
//           after each of them takes as many as the tree has levels. A leaf is looked at again only when it or
//           one next to it was split (Passed_leaves.h). T_B* looks at pairs in sight of each other, and in adjacent
//           leaves only where these have all that is as near as the options say; else as far as they say
//           (Features_in_sight.h). Tree_separation_options_2.h and Edge_gaps.h say which distances suffice.
//
// Leaves become no smaller than a few units of the coordinates there. Features nearer to each other than that
// have no room for vertices between representable coordinates (`has_room()`).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_SEPARATION_TREES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_SEPARATION_TREES_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_closure.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/nearest_hits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Edge_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/leaf_cells.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/subdivide_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/walk_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/schedule_of_threads.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Domain_directions.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_gaps.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Features_in_sight.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Geodesic_distance.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Passed_leaves.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Vertex_windows.h>
#include <CGAL/Quadtree_vertex_edge_neighbors_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/Tree_separation_options_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class ConcurrencyTag>
class Separation_trees {
public:
  using Geometry = Mesher_geometry<Traits>;
  using Point = typename Geometry::Point;
  using Point_2 = typename Traits::Point_2;
  using Tree = Balanced_quadtree<Traits, ConcurrencyTag>;
  using Grid_point = typename Tree::Grid_point;
  using Pslg = Pslg_2<Point_2>;
  using Map = Coordinate_map<Traits, Geometry>;
  using Options = Tree_separation_options_2;
  using Find_hits = Find_nearest_hits<Pslg>;
  using Windows = Vertex_windows<Tree, Geometry>;

  /// \param graph the vertices and edges of the problem, in its order
  /// \param mesh the constrained Delaunay triangulation of the domain
  /// \param find_hits by which model Lemma 5 finds neighbors of vertices; null: by the quadtree
  /// \param most_leaves separation stops before there are more, but for those of the last step, or before its steps
  ///        have looked at 25 times as many: `is_exhausted()`. Then edges are not all apart.
  Separation_trees(const Meshing_problem<Geometry>& problem, const Edge_sides& sides, const Pslg& graph,
                   const Map& map, const Options& options, const Traits& traits,
                   const Kernel_mesh<Geometry>& mesh, Find_hits find_hits, std::size_t most_leaves,
                   Tree_separation_report_2& report)
      : problem_(problem), graph_(graph), map_(map), options_(options), report_(report),
        gaps_(problem, sides, options), features_(problem, sides, options, gaps_),
        directions_(problem, sides), windows_(problem), most_leaves_(most_leaves) {
    if (options.find_distances_by() == Options::Distances::AXIS_RAYS)
      separate_vertices_by_lemma_5(traits, mesh, find_hits);
    else
      separate_vertices(
          Framework(graph.vertices, traits),
          [distance = Geodesic_distance<Geometry>(mesh)](Point_rank, Vertex_id v) { return distance(v); });
    if (options.place() == Options::Placement::BY_RULE)
      for (std::size_t v = 0; v < graph.number_of_vertices(); ++v) vertices_.push_back(Vertex_index(v));
    subdivide_edges();
    passed_.follow(tree_);
    while (!is_exhausted() && split(leaves_with_near_pieces())) {
    }
    report_.leaves_of_pieces = tree_.number_of_leaves();
    separate();
    report_.leaves_of_edges = tree_.number_of_leaves();
  }

  const Tree& tree() const { return tree_; }
  const Edge_pieces& pieces() const { return pieces_; }
  const Leaf_pieces& pieces_in_leaves() const { return pieces_in_leaves_; }

  /// Where rules hold that are certain to meet the bound.
  const Windows& windows() const { return windows_; }

  /// Splits leaves, and what has to follow for balance, separation and windows. Returns whether there were any leaves
  /// or new windows.
  /// \param vertices that get windows
  bool refine(std::vector<Leaf_index> leaves, const std::vector<Vertex_id>& vertices) {
    for (const Vertex_id v : vertices) windows_.add(v);
    if (!split(std::move(leaves)) && vertices.empty()) return false;
    separate();
    windows_.template settle<ConcurrencyTag>(tree_, pieces_in_leaves_);
    return true;
  }

  /// Whether separation ended before its time.
  bool is_exhausted() const {
    return tree_.number_of_leaves() >= most_leaves_ || leaves_of_steps_ / most_steps_ >= most_leaves_;
  }

  /// The leaf of a vertex, which may have others, and how that lies in it.
  Leaf_index leaf(Vertex_id v) const { return tree_.leaf(Point_index(std::size_t(v))); }
  Vertex_placement<typename Tree::Word> placement_at(Vertex_id v) const {
    const auto& framework = tree_.framework();
    return {
        framework.grid_point(framework.rank(Point_index(std::size_t(v)))),
        Word_operations<typename Tree::Word>::power_of_two(framework.grid().depth() - tree_.level(leaf(v)))};
  }
  /// The side of squares of a level, in the kernel's coordinates.
  double side(int level) const { return std::ldexp(side_of_root_, -level); }
  double side(Leaf_index l) const { return side(tree_.level(l)); }
  /// The grid point of a kernel's point.
  Grid_point grid_point(const Point& p) const { return tree_.framework().grid().grid_point(map_.to_user(p)); }
  /// The kernel's point for a grid point, rounded only if it cannot represent it.
  Point kernel_point(const Grid_point& p) const { return map_.to_kernel(tree_.framework().grid(), p); }
  /// Whether the grid, and the coordinates, have room for the children of a leaf.
  bool is_splittable(Leaf_index l) const {
    const auto s = tree_.square(l);
    return s.level < tree_.framework().grid().depth() && has_room(s.level + 1, kernel_point({s.x, s.y}));
  }
  /// Whether squares of a level can have vertices of a mesh on their sides near p, so that rounding them changes no
  /// angle much.
  bool has_room(int level, const Point& p) const { return side(level) >= least_side_ * Geometry::spacing(p); }

private:
  using Framework = typename Tree::Framework;

  static constexpr std::size_t block_of_leaves_ = 256;
  /// How many steps may be taken in a tree of as many leaves as there may be.
  static constexpr std::size_t most_steps_ = 25;
  /// Of leaves that are split off, in units of the coordinates.
  static constexpr double least_side_ = 16;

  const Meshing_problem<Geometry>& problem_;
  const Pslg& graph_;
  const Map& map_;
  const Options& options_;
  Tree_separation_report_2& report_;
  Edge_gaps<Geometry> gaps_;
  Features_in_sight<Geometry> features_;
  Domain_directions<Geometry> directions_;
  Tree tree_;
  Edge_pieces pieces_;
  Leaf_pieces pieces_in_leaves_;
  Passed_leaves passed_; // whose edges are apart
  Windows windows_;
  std::size_t most_leaves_;
  std::size_t leaves_of_steps_ = 0; // together: each step takes time for all leaves that there are
  double side_of_root_ = 0;
  std::vector<Vertex_index> vertices_; // all of them, for the placement by rule

  void separate_vertices_by_lemma_5(const Traits& traits, const Kernel_mesh<Geometry>& mesh,
                                    Find_hits find_hits) {
    if (find_hits) {
      separate_vertices_of(Tree(graph_.vertices, tree_options(), traits), find_hits(graph_), mesh);
    } else {
      const Quadtree_vertex_edge_neighbors_2<Traits, ConcurrencyTag> neighbors(
          graph_, Vertex_edge_neighbors_options_2(), traits);
      separate_vertices_of(neighbors.quadtree(),
                           nearest_hit_distances<ConcurrencyTag>(neighbors, graph_.number_of_vertices()),
                           mesh);
    }
  }

  static Quadtree_options tree_options() {
    return Quadtree_options().schedule(schedule_of_threads<ConcurrencyTag>());
  }

  /// From the near vertex in T_B and the nearest of the edges that a vertex sees along the axes, of which one is within
  /// a constant of what is nearest (Lemma 5). What the outside separates from a vertex does not count. Where the near
  /// vertex is such, the nearest vertex in sight is a neighbor in the triangulation.
  /// \param first T_B
  /// \param hits how far edges are that vertices see along the axes
  void separate_vertices_of(const Tree& first, const std::vector<Axis_distances>& hits,
                            const Kernel_mesh<Geometry>& mesh) {
    const Geodesic_distance<Geometry> geodesic_distance(mesh);
    report_.leaves_of_points = first.number_of_leaves();
    separate_vertices(first.framework(), [&](Point_rank r, Vertex_id v) {
      double distance = std::numeric_limits<double>::infinity();
      if (const Point_rank near = first.near_neighbor(r); near.is_valid()) {
        const Vector way = Geometry::difference(problem_.input_point(vertex_at(first.framework(), near)),
                                                problem_.input_point(v));
        distance = directions_.is_domain(v, way) ? std::sqrt(squared_length(way)) : geodesic_distance(v);
      }
      for (std::size_t d = 0; d < directions_of_axes.size(); ++d) {
        const double hit = hits[v.value()][d];
        const Vector axis{double(step_x(directions_of_axes[d])), double(step_y(directions_of_axes[d]))};
        if (hit > 0 && std::isfinite(hit) && directions_.is_domain(v, axis))
          distance = std::min(distance, map_.length_to_kernel(hit));
      }
      return distance;
    });
  }

  /// Makes T_B'.
  /// \param distance gives the distance of a vertex, by rank and handle, to what is nearest to it
  template <class Distance>
  void separate_vertices(Framework framework, const Distance& distance) {
    side_of_root_ = width_of_root(framework);
    std::vector<int> levels(framework.number_of_points(), 0);
    for_each_index<ConcurrencyTag>(levels.size(), [&](std::size_t i) {
      const Vertex_id v = vertex_at(framework, Point_rank(i));
      levels[i] = level_for(distance(Point_rank(i), v) / least_vertex_distance(), framework.grid().depth(),
                            problem_.input_point(v));
    });
    framework.annotate(levels);
    tree_ = Tree(std::move(framework), tree_options().max_points_per_leaf(options_.max_vertices_per_leaf()));
    report_.leaves_of_vertices = tree_.number_of_leaves();
  }

  static Vertex_id vertex_at(const Framework& framework, Point_rank r) {
    return static_cast<Vertex_id>(framework.input_point(r).value());
  }

  double width_of_root(const Framework& framework) const {
    const auto& grid = framework.grid();
    const auto half = Word_operations<typename Tree::Word>::power_of_two(grid.depth() - 1);
    return 2 * Geometry::difference(map_.to_kernel(grid, Grid_point{half, 0}),
                                    map_.to_kernel(grid, Grid_point{0, 0}))
                   .x;
  }

  /// Rules want equal leaves around each vertex, apart from those around others.
  double least_vertex_distance() const {
    constexpr double by_rule = 8;
    return options_.place() == Options::Placement::BY_RULE ? std::max(by_rule, options_.vertex_distance())
                                                           : options_.vertex_distance();
  }

  /// The first level with sides of at most a length, or the last one that there is room for at p.
  int level_for(double length, int depth, const Point& p) const {
    if (!(length < side_of_root_)) return 0;
    const double least = std::max(length, least_side_ * Geometry::spacing(p));
    int level = std::max(0, std::ilogb(side_of_root_) - std::ilogb(least) - 1);
    while (level < depth && side(level) > length && has_room(level + 1, p)) ++level;
    return std::min(level, depth);
  }

  void subdivide_edges() {
    Subdivision_rounds rounds;
    pieces_ = options_.subdivide() == Options::Subdivision::WALKING
                  ? walk_edges<ConcurrencyTag>(tree_, graph_.segments)
                  : internal::subdivide_edges<ConcurrencyTag>(tree_, graph_.segments, &rounds);
    report_.leaves_made += tree_.number_of_leaves();
    report_.pieces_cut += pieces_.size();
    report_.subdivision_rounds += rounds.rounds;
    report_.centroid_height = rounds.height;
    pieces_in_leaves_ = Leaf_pieces::of<ConcurrencyTag>(pieces_, tree_.number_of_leaves());
  }

  bool split(std::vector<Leaf_index> leaves) {
    leaves.erase(
        std::remove_if(leaves.begin(), leaves.end(), [this](Leaf_index l) { return !is_splittable(l); }),
        leaves.end());
    if (leaves.empty()) return false;
    tree_.refine(leaves);
    passed_.follow(tree_);
    leaves_of_steps_ += tree_.number_of_leaves();
    ++report_.splits;
    subdivide_edges();
    return true;
  }

  void separate() {
    while (!is_exhausted() &&
           (split(leaves_with_near_pieces()) || split(leaves_near_pieces()) ||
            split(leaves_that_break_rules()) ||
            split(windows_.template leaves_to_split<ConcurrencyTag>(tree_, pieces_in_leaves_)))) {
    }
  }

  /// For the placement by rule: leaves that are not equal at vertices, or not in columns along edges.
  std::vector<Leaf_index> leaves_that_break_rules() const {
    if (options_.place() != Options::Placement::BY_RULE) return {};
    std::vector<Leaf_index> leaves = leaves_to_split_for_vertices<ConcurrencyTag>(tree_, vertices_);
    const auto more = leaves_to_split_for_columns<ConcurrencyTag>(tree_, pieces_, graph_.segments,
                                                                  Column_closure_options());
    leaves.insert(leaves.end(), more.begin(), more.end());
    return leaves;
  }

  typename Edge_gaps<Geometry>::Leaf frame(Leaf_index l) const {
    const auto s = tree_.square(l);
    return {kernel_point({s.x, s.y}), side(s.level)};
  }

  /// The leaves that do not pass a test. It is made of those only that have not passed it yet.
  template <class Is_wrong>
  std::vector<Leaf_index> leaves_that_fail(Leaf_test test, const Is_wrong& is_wrong) {
    const std::vector<Leaf_index> leaves = pack_values<ConcurrencyTag, Leaf_index>(
        tree_.number_of_leaves(), [&](std::size_t l) { return !passed_.has_passed(Leaf_index(l), test); },
        [](std::size_t l) { return Leaf_index(l); });
    report_.leaf_tests += leaves.size();
    for_each_block<ConcurrencyTag>(leaves.size(), block_of_leaves_,
                                   [&](std::size_t, std::size_t begin, std::size_t end) {
                                     Scratch scratch;
                                     for (std::size_t i = begin; i < end; ++i)
                                       if (!is_wrong(leaves[i], scratch)) passed_.pass(leaves[i], test);
                                   });
    return pack_values<ConcurrencyTag, Leaf_index>(
        leaves.size(), [&](std::size_t i) { return !passed_.has_passed(leaves[i], test); },
        [&](std::size_t i) { return leaves[i]; });
  }

  using Part = typename Edge_gaps<Geometry>::Part;
  using Frame = typename Edge_gaps<Geometry>::Leaf;

  struct Scratch {
    Leaf_cells<typename Tree::Word> cells;
    std::vector<typename Leaf_cells<typename Tree::Word>::Ends> segments;
    std::vector<Part> own, around; ///< parts of edges in a leaf, and near it
    Edge_id hider;                 ///< among these
    typename Features_in_sight<Geometry>::Scratch sight;
  };

  /// For T_B'': leaves too large for two pieces that bound a common cell in them.
  std::vector<Leaf_index> leaves_with_near_pieces() {
    return leaves_that_fail(Leaf_test::OF_LEAF_ALONE, [this](Leaf_index l, Scratch& scratch) {
      const auto pieces = pieces_in_leaves_[l];
      if (pieces.size() < 2 || !is_splittable(l)) return false;
      const auto leaf = frame(l);
      // A leaf with a vertex in its corner has pieces of all edges there, and all of them in each of its cells.
      if (gaps_.are_all_joined_near(leaf, pieces)) return false;
      if (pieces.size() > 2 && !has_near_pieces(l, leaf, scratch)) return false; // which spares their cells
      bool is_any = false;
      for_each_pair_in_cell(l, scratch, [&](Edge_id e, Edge_id f) {
        is_any = is_any || (!gaps_.are_joined_near(leaf, e, f) &&
                            gaps_.is_too_large(leaf, e, f, gaps_.gap(e, f, leaf)));
      });
      return is_any;
    });
  }

  /// Whether any two pieces in a leaf are too near for it, in whatever cells.
  bool has_near_pieces(Leaf_index l, const Frame& leaf, Scratch& scratch) const {
    find_own_parts(l, leaf, scratch), find_parts_around(std::array{l}, leaf, scratch);
    return has_near_pair(leaf, scratch, [](std::size_t, Edge_id, const Local_gap&) { return true; });
  }

  /// Calls `f` for the pairs of edges on the boundary of a common cell in a leaf.
  template <class F>
  void for_each_pair_in_cell(Leaf_index l, Scratch& scratch, const F& f) const {
    const auto pieces = pieces_in_leaves_[l];
    if (pieces.size() == 2) return f(edge(pieces[0]), edge(pieces[1]));
    const Framework& framework = tree_.framework();
    scratch.segments.clear();
    for (const Edge_piece& p : pieces) {
      const auto& ends = graph_.segment(p.segment);
      scratch.segments.push_back({framework.grid_point(framework.rank(Point_index(ends[0].value()))),
                                  framework.grid_point(framework.rank(Point_index(ends[1].value())))});
    }
    const auto s = tree_.square(l);
    scratch.cells.for_each_pair(
        {s.x, s.y}, Word_operations<typename Tree::Word>::power_of_two(framework.grid().depth() - s.level),
        scratch.segments, [&](std::uint32_t i, std::uint32_t j) { f(edge(pieces[i]), edge(pieces[j])); });
  }

  /// For T_B*: leaves too large for a piece in them and one next to them, or for anything that is as near as the
  /// options say.
  std::vector<Leaf_index> leaves_near_pieces() {
    if (gaps_.is_beyond_neighbors())
      return leaves_that_fail(Leaf_test::OF_GRAPH_AROUND, [this](Leaf_index l, Scratch& scratch) {
        if (!is_splittable(l)) return false;
        scratch.sight.around.find(tree_, pieces_in_leaves_, l, features_.reach());
        return features_.is_too_large(frame(l), scratch.sight);
      });
    return leaves_that_fail(Leaf_test::OF_LEAF_AND_NEIGHBORS, [this](Leaf_index l, Scratch& scratch) {
      return pieces_in_leaves_[l].size() > 0 && is_splittable(l) && is_near_piece(l, scratch);
    });
  }

  bool is_near_piece(Leaf_index l, Scratch& scratch) const {
    const auto leaf = frame(l);
    find_own_parts(l, leaf, scratch), find_parts_around(tree_.neighbors(l), leaf, scratch);
    scratch.hider = {};
    sort_across(scratch.own);
    return has_near_pair(leaf, scratch, [&](std::size_t k, Edge_id f, const Local_gap& gap) {
      return !is_hidden(gap, k, f, scratch, leaf);
    });
  }

  /// Puts parts into an order in which those beside one are next to it, where they run side by side.
  static void sort_across(std::vector<Part>& parts) {
    const auto place = [](const Part& p) { return p.low.x + p.high.x + p.low.y + p.high.y; };
    std::sort(parts.begin(), parts.end(), [&](const Part& p, const Part& q) {
      return std::pair(place(p), p.edge) < std::pair(place(q), q.edge);
    });
  }

  void find_own_parts(Leaf_index l, const Frame& leaf, Scratch& scratch) const {
    scratch.own.clear();
    for (const Edge_piece& p : pieces_in_leaves_[l])
      if (const auto part = gaps_.part_in(edge(p), leaf)) scratch.own.push_back(*part);
  }

  /// \param leaves whose pieces may be near
  template <class Leaves>
  void find_parts_around(const Leaves& leaves, const Frame& leaf, Scratch& scratch) const {
    scratch.around.clear();
    for (const Leaf_index n : leaves)
      for (const Edge_piece& p : pieces_in_leaves_[n])
        if (const auto part = gaps_.part_around(edge(p), leaf)) scratch.around.push_back(*part);
    const auto is_before = [](const Part& p, const Part& q) { return p.edge < q.edge; };
    const auto is_same = [](const Part& p, const Part& q) { return p.edge == q.edge; };
    std::sort(scratch.around.begin(), scratch.around.end(), is_before);
    scratch.around.erase(std::unique(scratch.around.begin(), scratch.around.end(), is_same),
                         scratch.around.end());
  }

  /// Whether a leaf is too large for an edge in it and one in or around it, of which `counts(k, f, gap)` holds, for
  /// the k-th one in it and the other one. Pairs of edges at one vertex near the leaf are passed over together, as
  /// there may be many.
  template <class Counts>
  bool has_near_pair(const Frame& leaf, Scratch& scratch, const Counts& counts) const {
    const Vertex_id hub = gaps_.vertex_near(leaf, scratch.around);
    const std::size_t own = hub.is_valid() ? gaps_.put_first(hub, scratch.own) : 0,
                      around = hub.is_valid() ? gaps_.put_first(hub, scratch.around) : 0;
    for (std::size_t i = 0; i < scratch.around.size(); ++i)
      for (std::size_t k = i < around ? own : 0; k < scratch.own.size(); ++k) {
        const Part &q = scratch.around[i], &p = scratch.own[k];
        if (gaps_.are_boxes_apart(p, q, leaf) || p.edge == q.edge ||
            gaps_.are_joined_near(leaf, p.edge, q.edge))
          continue;
        const Local_gap gap = Local_gap::between(p.segment, q.segment);
        if (gaps_.is_too_large(leaf, p.edge, q.edge, gap) && counts(k, q.edge, gap)) return true;
      }
    return false;
  }

  static Edge_id edge(const Edge_piece& p) { return static_cast<Edge_id>(p.segment.value()); }

  /// Whether another edge lies between the k-th one in the leaf and f. Those beside the first one, and the one that
  /// did for the last pair, are asked first.
  bool is_hidden(const Local_gap& gap, std::size_t k, Edge_id f, Scratch& scratch, const Frame& leaf) const {
    const std::vector<Part>& own = scratch.own;
    const auto hides = [&](Edge_id g) {
      return g != own[k].edge && g != f && gap.is_blocked_by(gaps_.local(g, leaf));
    };
    if ((k > 0 && hides(own[k - 1].edge)) || (k + 1 < own.size() && hides(own[k + 1].edge)) ||
        (scratch.hider.is_valid() && hides(scratch.hider)))
      return true;
    for (const auto* parts : {&scratch.own, &scratch.around})
      for (const Part& g : *parts)
        if (hides(g.edge)) {
          scratch.hider = g.edge;
          return true;
        }
    return false;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_SEPARATION_TREES_H
