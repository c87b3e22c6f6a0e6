// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether what is in a leaf is too near to what it sees around it.
//
// Computes: for the pieces of edges and the vertices in a leaf, whether a vertex or another edge of the graph is
//           nearer than so many sides of the leaf. All that is so near is looked at, however many leaves away.
// Bound:    O(p f (log f + h)) for p pieces and vertices in the leaf, f features around it, and h of these that are
//           asked whether they hide another one.
// Source:   Bern, Eppstein, Teng, section 6: "each (piece of an original) edge is contained in a sufficiently small
//           square that no vertex or other edge passes nearby (less than a specified constant - such as 3 - times
//           the square's side length)".
// Deviates: what counts is the distance from the piece, not from its square. These are near each other all the same:
//           the ends of an edge and the edge, edges at a common vertex up to `vertex_window` sides from it, and the
//           legs of a lopped corner up to where it is `strip_width` sides wide. The paper has cut acute corners off
//           by then.
//
// Only shortest ways are looked at, and only those in the domain that cross no edge. That suffices. Suppose that a
// piece sees a feature by another way, because something hides the shortest. Then a vertex of what hides it lies
// between both ways, and the nearest such vertex is in sight, and nearer.
//
// A test has the same answer until the leaf is split, whatever happens to others: it asks for the graph alone.
// The arithmetic is rounded as in Edge_gaps.h.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_FEATURES_IN_SIGHT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_FEATURES_IN_SIGHT_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Edge_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/leaves_around.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Domain_directions.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_gaps.h>
#include <CGAL/Tree_separation_options_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What is in a leaf, and what is in leaves around it.
struct Features_around {
  std::vector<Edge_id> own_edges, edges;
  std::vector<Vertex_id> own_vertices, vertices;

  /// Finds them in all leaves up to some sides away.
  template <class Tree>
  void find(const Tree& tree, const Leaf_pieces& pieces, Leaf_index leaf, int sides) {
    own_edges.clear(), own_vertices.clear(), edges.clear(), vertices.clear();
    append(tree, pieces, leaf, own_edges, own_vertices);
    if (own_edges.empty() && own_vertices.empty()) return;
    for_each_leaf_around(tree, leaf, sides, [&](Leaf_index l) { append(tree, pieces, l, edges, vertices); });
    remove_repetitions(edges), remove_repetitions(vertices);
  }

private:
  template <class Tree>
  static void append(const Tree& tree, const Leaf_pieces& pieces, Leaf_index l, std::vector<Edge_id>& edges,
                     std::vector<Vertex_id>& vertices) {
    for (const Edge_piece& p : pieces[l]) edges.push_back(static_cast<Edge_id>(p.segment.value()));
    const auto ranks = tree.points(l);
    for (auto r = ranks.begin; r != ranks.end; ++r)
      vertices.push_back(static_cast<Vertex_id>(tree.framework().input_point(r).value()));
  }

  template <class Id>
  static void remove_repetitions(std::vector<Id>& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }
};

/// An edge or a vertex, relative to a leaf.
struct Feature_near_leaf {
  Local_segment line, part; ///< all of it, and what is near
  Edge_id edge;
  Vertex_id vertex;
};

/// The shortest way between two features.
struct Way_in_sight {
  /// Where it ends: on an edge, at a vertex, or both.
  struct Foot {
    Edge_id edge;
    Vertex_id vertex;
  };
  Local_gap gap;
  Foot from, to;
};

template <class Geometry>
class Features_in_sight {
public:
  using Gaps = Edge_gaps<Geometry>;
  using Leaf = typename Gaps::Leaf;

  /// Keeps its memory from one leaf to the next.
  struct Scratch {
    Features_around around;
    std::vector<Feature_near_leaf> own, others; ///< these, relative to a leaf
    std::vector<Way_in_sight> ways;
    std::size_t hider; ///< the one of the others that was across the last way that was not free
  };

  Features_in_sight(const Meshing_problem<Geometry>& problem, const Edge_sides& sides,
                    const Tree_separation_options_2& options, const Gaps& gaps)
      : problem_(problem), options_(options), gaps_(gaps), directions_(problem, sides) {}

  /// How far around a leaf features are looked for, in its sides.
  int reach() const {
    return static_cast<int>(std::ceil(std::max(options_.vertex_distance(), options_.edge_distance())));
  }

  /// Whether a leaf is too large for something in `scratch.around`.
  bool is_too_large(const Leaf& leaf, Scratch& scratch) const {
    collect(leaf, scratch);
    find_short_ways(leaf, scratch);
    // The shortest is the most likely to be free.
    std::sort(scratch.ways.begin(), scratch.ways.end(),
              [](const auto& a, const auto& b) { return a.gap.length < b.gap.length; });
    return std::any_of(scratch.ways.begin(), scratch.ways.end(),
                       [&](const auto& way) { return is_in_domain(way) && !is_blocked(way, scratch); });
  }

private:
  using Feature = Feature_near_leaf;
  using Way = Way_in_sight;

  const Meshing_problem<Geometry>& problem_;
  const Tree_separation_options_2& options_;
  const Gaps gaps_;
  const Domain_directions<Geometry> directions_;

  void collect(const Leaf& leaf, Scratch& scratch) const {
    const auto add = [&](std::vector<Feature>& features, const std::vector<Edge_id>& edges,
                         const std::vector<Vertex_id>& vertices, double far) {
      features.clear();
      for (const Edge_id e : edges) {
        const Local_segment line = gaps_.local(e, leaf);
        Local_segment part = line;
        if (part.clip(-far * leaf.side, (1 + far) * leaf.side))
          features.push_back({line, part, e, Vertex_id()});
      }
      for (const Vertex_id v : vertices) {
        const Vector p = Geometry::difference(problem_.input_point(v), leaf.corner);
        features.push_back({{p, p}, {p, p}, Edge_id(), v});
      }
    };
    const Features_around& around = scratch.around;
    add(scratch.own, around.own_edges, around.own_vertices, 0);
    add(scratch.others, around.edges, around.vertices, reach());
  }

  void find_short_ways(const Leaf& leaf, Scratch& scratch) const {
    scratch.ways.clear();
    scratch.hider = scratch.others.size();
    for (const Feature& own : scratch.own) {
      const double least =
          leaf.side * (own.vertex.is_valid() ? options_.vertex_distance() : options_.edge_distance());
      for (const Feature& other : scratch.others) {
        if (are_one(own, other)) continue;
        const Local_gap gap = Local_gap::between(own.part, other.part);
        if (gap.length >= least || may_be_near(own, other, leaf)) continue;
        scratch.ways.push_back({gap, foot(own, gap.from, gap.length), foot(other, gap.to, gap.length)});
      }
    }
  }

  bool is_end(Vertex_id v, Edge_id e) const { return problem_.edges[e].a == v || problem_.edges[e].b == v; }

  /// Whether both are the same, or a vertex and an edge that ends there.
  bool are_one(const Feature& a, const Feature& b) const {
    if (a.vertex.is_valid()) return b.vertex.is_valid() ? a.vertex == b.vertex : is_end(a.vertex, b.edge);
    return b.vertex.is_valid() ? is_end(b.vertex, a.edge) : a.edge == b.edge;
  }

  bool may_be_near(const Feature& a, const Feature& b, const Leaf& leaf) const {
    return a.edge.is_valid() && b.edge.is_valid() && gaps_.may_be_near(leaf, a.edge, b.edge);
  }

  /// Where a way of some length ends on a feature.
  Way::Foot foot(const Feature& f, Vector p, double length) const {
    if (f.vertex.is_valid()) return {f.edge, f.vertex};
    constexpr double share = 1e-6; // of the way's length, up to which the end of an edge is meant
    const auto is_at = [&](Vector end) { return squared_length(p - end) <= share * length * share * length; };
    const Input_edge& edge = problem_.edges[f.edge];
    return {f.edge, is_at(f.line.a) ? edge.a : is_at(f.line.b) ? edge.b : Vertex_id()};
  }

  bool is_in_domain(const Way& way) const {
    const Vector d = way.gap.to - way.gap.from;
    return is_domain_toward(way.from, d) && is_domain_toward(way.to, -1.0 * d);
  }

  bool is_domain_toward(const Way::Foot& foot, Vector direction) const {
    return foot.vertex.is_valid() ? directions_.is_domain(foot.vertex, direction)
                                  : directions_.is_domain(foot.edge, direction);
  }

  /// Whether another edge lies across a way. The one that did for the last way is asked first.
  bool is_blocked(const Way& way, Scratch& scratch) const {
    const auto& others = scratch.others;
    const auto ends_at = [&](const Feature& f, Vertex_id v) { return v.is_valid() && is_end(v, f.edge); };
    const auto blocks = [&](const Feature& f) {
      // Edges that end where the way does are beside it.
      return f.edge.is_valid() && way.gap.is_blocked_by(f.line) && f.edge != way.from.edge &&
             f.edge != way.to.edge && !ends_at(f, way.from.vertex) && !ends_at(f, way.to.vertex);
    };
    if (scratch.hider < others.size() && blocks(others[scratch.hider])) return true;
    scratch.hider =
        static_cast<std::size_t>(std::find_if(others.begin(), others.end(), blocks) - others.begin());
    return scratch.hider < others.size();
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_FEATURES_IN_SIGHT_H
