// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The vertices of a mesh from a quadtree whose leaves are equal at vertices and in columns along edges.
//
// Computes: points on the edges, and corners of leaves. A constrained Delaunay triangulation of them and the
//           graph has no angle below 20.7 degrees, except in acute corners.
// Bound:    O(1) for each piece of an edge and each vertex of the graph.
// Source:   Bern, Eppstein, Teng, Theorem 5. The rules are ours: Column_rule.h and Column_placement.h along
//           edges, Vertex_placement.h at vertices, both with a proof (doc/guarantees.md).
// Deviates: nothing is warped. Sectors below 33 degrees, the acute corners, get no vertices where they are
//           narrow. Rings put vertices on their legs at equal distances.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_RULE_PLACEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_RULE_PLACEMENT_H

#include <CGAL/Quadtree_mesh_2/internal/columns/Column_closure.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Grid_box.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Tree_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Corner_location.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_rooms.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Vertex_rays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class ConcurrencyTag>
class Rule_placement {
public:
  using Trees = Separation_trees<Traits, ConcurrencyTag>;
  using Geometry = typename Trees::Geometry;
  using Point = typename Geometry::Point;
  using Problem = Meshing_problem<Geometry>;

  /// \pre leaves are equal at vertices, and in columns along edges: `Separation_trees` sees to it
  Rule_placement(const Problem& problem, const Trees& trees, const Edge_triangles<Geometry>& triangles)
      : problem_(problem), trees_(trees), triangles_(triangles), rooms_(problem, triangles),
        tree_(trees.tree()), corners_(trees.tree()), box_(box_of_points<ConcurrencyTag>(trees.tree())) {}

  Placed_vertices<Geometry> run() {
    Placed_vertices<Geometry> placed(problem_.input_points);
    placed.template append_vertices_of_edges<ConcurrencyTag>(
        problem_.edges, Placement_scope(), rooms_,
        [this](Edge_id e, auto& crossings) { cut_edge(e, crossings); });
    is_kept_.resize(corners_.number_of_names());
    for_each_index<ConcurrencyTag>(is_kept_.size(), [&](std::size_t c) {
      is_kept_[c] = corners_.exists(c) && box_.contains(corners_.place(c)) ? 1 : 0;
    });
    drop_corners(problem_.edges.size(), [this](std::size_t e, auto& names) {
      Edge edge(*this, static_cast<Edge_id>(e));
      edge.placement.for_each_dropped_corner([&](const Grid_point& p) { append_name(p, names); });
    });
    drop_corners(problem_.number_of_input_points(), [this](std::size_t i, auto& names) {
      const auto v = static_cast<Vertex_id>(i);
      for_each_dropped_corner(trees_.placement_at(v), Vertex_rays<Geometry>(problem_, v),
                              [&](const Grid_point& p) { append_name(p, names); });
    });
    placed.template append_corners<ConcurrencyTag>(
        trees_, corners_, is_kept_, Location(problem_, trees_, corners_, triangles_, Placement_scope()));
    return placed;
  }

private:
  using Tree = typename Trees::Tree;
  using Word = typename Tree::Word;
  using Grid_point = typename Trees::Grid_point;
  using Corners = Tree_corners<Tree>;
  using Location = Corner_location<Traits, ConcurrencyTag>;
  using Name = typename Corners::Name;
  using Line = Edge_line<Word>;
  using Columns = std::vector<Edge_column<Word>>;
  using Placement = Column_placement<Tree>;

  const Problem& problem_;
  const Trees& trees_;
  const Edge_triangles<Geometry>& triangles_;
  const Edge_rooms<Geometry> rooms_;
  const Tree& tree_;
  Corners corners_;
  const Grid_box<Grid_point> box_;
  std::vector<char> is_kept_; // by name of a corner

  Window_point direction(Vertex_id from, Vertex_id to) const {
    const Vector d = Geometry::difference(problem_.input_point(to), problem_.input_point(from));
    const double length = std::sqrt(squared_length(d));
    return {d.x / length, d.y / length};
  }

  /// An edge among its columns.
  struct Edge {
    Line line;
    std::array<Edge_start, 2> start;
    std::array<double, 2> side; // of the leaves of its ends, in the kernel's units
    Columns columns;
    Placement placement;

    Edge(const Rule_placement& all, Edge_id e)
        : line(line_of_segment(all.tree_, all.ends(e))), start{all.start(e, 0, line), all.start(e, 1, line)},
          side{all.trees_.side(all.trees_.leaf(all.problem_.edges[e].a)),
               all.trees_.side(all.trees_.leaf(all.problem_.edges[e].b))},
          columns(columns_along(all.tree_, all.trees_.pieces()[Segment_index(std::size_t(e))], line)),
          placement(all.tree_, line, columns, Transition_rule::BETTER_OF_TWO, all.reach(e, *this)) {}
  };

  std::array<Vertex_index, 2> ends(Edge_id e) const {
    return {Vertex_index(std::size_t(problem_.edges[e].a)), Vertex_index(std::size_t(problem_.edges[e].b))};
  }

  /// As the edge leaves its end.
  Edge_axis axis(Edge_id e, int end, const Line& line) const {
    return {line.is_steep(), is_reversed(e, line) == (end == 1)};
  }

  Edge_start start(Edge_id e, int end, const Line& line) const {
    const Vertex_id a = problem_.edges[e].a, b = problem_.edges[e].b;
    return end == 0 ? trees_.placement_at(a).start_of_edge(direction(a, b), axis(e, 0, line))
                    : trees_.placement_at(b).start_of_edge(direction(b, a), axis(e, 1, line));
  }

  /// Where the ends' rules give way to that of columns, by increasing u.
  std::array<typename Placement::End, 2> reach(Edge_id e, const Edge& edge) const {
    using Product = typename Line::Product;
    const auto reach_of = [&](int end) {
      const auto vertex = trees_.placement_at(end == 0 ? problem_.edges[e].a : problem_.edges[e].b);
      const Product u(edge.line.u(vertex.corner())), side(vertex.side());
      return typename Placement::End{u + side * edge.start[std::size_t(end)].first_line,
                                     u + side * axis(e, end, edge.line).line(first_far_line)};
    };
    std::array<typename Placement::End, 2> reach{reach_of(0), reach_of(1)};
    if (is_reversed(e, edge.line)) std::swap(reach[0], reach[1]);
    return reach;
  }

  /// Whether u decreases from the edge's first end to its second.
  bool is_reversed(Edge_id e, const Line& line) const {
    const auto& framework = tree_.framework();
    const auto place = [&](Vertex_id v) {
      return framework.grid_point(framework.rank(Point_index(std::size_t(v))));
    };
    return line.u(place(problem_.edges[e].b)) < line.u(place(problem_.edges[e].a));
  }

  double least_side_along(Edge_id e) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Leaf_index l : trees_.pieces()[Segment_index(std::size_t(e))])
      least = std::min(least, trees_.side(l));
    return least;
  }

  /// The points on the ring of the first end, the crossings, those on the ring of the second end.
  void cut_edge(Edge_id e, std::vector<Edge_crossing<Geometry>>& crossings) const {
    const Edge edge(*this, e);
    const Point &a = problem_.input_point(problem_.edges[e].a),
                &b = problem_.input_point(problem_.edges[e].b);
    const double length = std::sqrt(squared_length(Geometry::difference(b, a)));
    const double least_side = least_side_along(e);
    using Vertex = Point_on_edge<Geometry>;
    std::vector<Vertex> vertices;
    edge.placement.for_each_crossing([&](const Word& u) {
      vertices.push_back(Vertex::beside(trees_.kernel_point(edge.line.point(u, Word(0))), a, b,
                                        edge.line.is_steep(), least_side));
    });
    for (std::size_t end = 0; end < 2; ++end)
      for (const double distance : edge.start[end].distances) {
        const double share = distance * edge.side[end] / length;
        if (share < 0.5)
          vertices.push_back(end == 0 ? Vertex{share, 1 - share, Geometry::between(a, b, share)}
                                      : Vertex{1 - share, share, Geometry::between(b, a, share)});
      }
    std::sort(vertices.begin(), vertices.end(),
              [](const Vertex& p, const Vertex& q) { return p.share < q.share; });
    for (const Vertex& v : vertices)
      if (v.share > 0 && v.share < 1) crossings.push_back({e, v.point});
  }

  /// \param find called as `find(i, names)`, maybe at the same time; appends names of corners to be dropped
  template <class Find>
  void drop_corners(std::size_t n, const Find& find) {
    constexpr std::size_t block = 64;
    std::vector<std::vector<Name>> found((n + block - 1) / block);
    for_each_block<ConcurrencyTag>(n, block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) find(i, found[b]);
    });
    for (const auto& names : found)
      for (const Name c : names) is_kept_[c] = 0;
  }

  void append_name(const Grid_point& p, std::vector<Name>& names) const {
    const Name c = corners_.name(p);
    if (c != Corners::none) names.push_back(c);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_RULE_PLACEMENT_H
