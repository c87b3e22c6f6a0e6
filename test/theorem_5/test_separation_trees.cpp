// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The quadtrees that separate the features of a graph: what they promise, against all pairs of features.

#include "catch.h"
#include "numbers_of_threads.h"
#include "quadtree_test_inputs.h"
#include "random_pslg_shapes.h"
#include "separation_test_tools.h"
#include "vertex_edge_brute_force.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_separation_trees {

namespace {

using namespace separation_test;
using pslg_test::Pslg;
using quadtree_test::Filtered_traits;
using Prepared = Prepared_graph<Filtered_traits>;
using Trees = Prepared::Trees;
using Geometry = Prepared::Geometry;
using internal::Edge_gaps;
using internal::Edge_id;
using internal::Edge_piece;
using internal::Local_gap;
using internal::Local_segment;
using internal::Vector;
using internal::Vertex_id;

/// No two vertices at one place.
Pslg without_duplicates(const Pslg& pslg) {
  Pslg result;
  std::map<std::pair<double, double>, Vertex_index> place;
  std::vector<Vertex_index> image;
  for (const auto& p : pslg.vertices) {
    const auto found = place.insert({{p.x(), p.y()}, Vertex_index(result.number_of_vertices())});
    if (found.second) result.add_vertex(p);
    image.push_back(found.first->second);
  }
  for (const auto& s : pslg.segments)
    if (image[std::size_t(s[0])] != image[std::size_t(s[1])])
      result.add_segment(image[std::size_t(s[0])], image[std::size_t(s[1])]);
  return result;
}

/// The graph in a box, so that the domain is on all sides of its features.
Pslg in_box(Pslg pslg) {
  const auto box = CGAL::bounding_box(pslg.vertices.begin(), pslg.vertices.end());
  const double extent = std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  std::vector<Vertex_index> corners;
  for (std::size_t i = 0; i < 4; ++i)
    corners.push_back(pslg.add_vertex({i == 0 || i == 3 ? box.xmin() - extent : box.xmax() + extent,
                                       i < 2 ? box.ymin() - extent : box.ymax() + extent}));
  for (std::size_t i = 0; i < 4; ++i) pslg.add_segment(corners[i], corners[(i + 1) % 4]);
  return pslg;
}

/// Small graphs of all families; needles take too many leaves for brute force.
template <class Function>
void for_each_graph(std::uint64_t seeds, const Function& f) {
  for (const random_pslg::Family& family : random_pslg::all_families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Pslg pslg = without_duplicates(family.make(seed));
      if (pslg.number_of_vertices() > 400) continue;
      CAPTURE(family.name, seed);
      f(pslg);
    }
}

Pslg read(const std::string& name) {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(pslg_test::data_file(name), pslg);
  return without_duplicates(pslg);
}

/// Lets T_B' be the last tree.
Tree_options of_vertices_only(double distance) { return Tree_options::of_theorem().distances(distance, 0); }

// ---- all pairs

/// What T_B* promises: two edges in a leaf, or in one next to it, that see each other there are far enough apart.
class Pair_check {
public:
  Pair_check(const Prepared& graph, const Trees& trees, const Tree_options& options)
      : trees_(trees), gaps_(graph.problem(), graph.sides(), options) {}

  /// The leaves that are too large for a pair of edges; of many leaves some are looked at.
  std::size_t number_of_faults() {
    constexpr std::size_t most = 30000;
    std::size_t faults = 0;
    for (std::size_t l = 0; l < trees_.tree().number_of_leaves();
         l += 1 + trees_.tree().number_of_leaves() / most)
      faults += trees_.is_splittable(Leaf_index(l)) && has_fault(Leaf_index(l)) ? 1 : 0;
    return faults;
  }

private:
  const Trees& trees_;
  Edge_gaps<Geometry> gaps_;

  void add_edges(Leaf_index l, std::set<Edge_id>& edges) const {
    for (const Edge_piece& p : trees_.pieces_in_leaves()[l])
      edges.insert(static_cast<Edge_id>(p.segment.value()));
  }

  bool has_fault(Leaf_index l) const {
    std::set<Edge_id> own, around;
    add_edges(l, own);
    around = own;
    for (const Leaf_index n : trees_.tree().neighbors(l)) add_edges(n, around);
    const auto s = trees_.tree().square(l);
    const Edge_gaps<Geometry>::Leaf leaf{trees_.kernel_point({s.x, s.y}), trees_.side(l)};
    for (const Edge_id e : own)
      for (const Edge_id f : around) {
        if (e == f) continue;
        const Local_gap gap = gaps_.gap(e, f, leaf);
        if (gap.length > 0 && gaps_.is_too_large(leaf, e, f, gap) && is_in_sight(gap, e, f, around, leaf))
          return true;
      }
    return false;
  }

  /// Whether no other edge meets the gap. Edges of which an end touches it only count as ones that do.
  bool is_in_sight(const Local_gap& gap, Edge_id e, Edge_id f, const std::set<Edge_id>& edges,
                   const Edge_gaps<Geometry>::Leaf& leaf) const {
    for (const Edge_id g : edges) {
      if (g == e || g == f) continue;
      const Local_segment s = gaps_.local(g, leaf);
      const Local_segment way{gap.from, gap.to};
      if (Local_gap::between(way, s).length <= 1e-9 * leaf.side || cuts(way, s)) return false;
    }
    return true;
  }

  static bool cuts(const Local_segment& s, const Local_segment& t) {
    return cross(s.b - s.a, t.a - s.a) * cross(s.b - s.a, t.b - s.a) <= 0 &&
           cross(t.b - t.a, s.a - t.a) * cross(t.b - t.a, s.b - t.a) <= 0;
  }
};

} // namespace

// ---- T_B'

TEST_CASE("Each vertex lies in a leaf as small as the distance to its nearest feature",
          "[trees][separation]") {
  // The near vertex is at most 1.6284 times as far as the nearest, and the nearest hit of the axes at most sqrt 2
  // times as far as the nearest edge, or an end of that is.
  const double factor = 1.6284 * std::sqrt(2.0) * (1 + 1e-9);
  for (const double distance : {0.7, 3.})
    for_each_graph(is_full_run() ? 40 : 3, [&](const Pslg& graph_alone) {
      const Pslg pslg = in_box(graph_alone);
      const Tree_options options = of_vertices_only(distance);
      Prepared graph(pslg);
      const Trees trees = graph.trees(options);
      const vertex_edge_test::Brute_force brute(graph.graph());
      std::size_t too_large = 0;
      for (std::size_t v = 0; v < pslg.number_of_vertices(); ++v) {
        const Leaf_index l = trees.tree().leaf(Point_index(v));
        const double nearest = std::min(brute.nearest_vertex(Vertex_index(v)).distance(),
                                        brute.nearest_segment(Vertex_index(v)).distance());
        if (trees.is_splittable(l) &&
            trees.side(l) * distance > factor * graph.map().length_to_kernel(nearest))
          ++too_large;
      }
      CHECK(too_large == 0);
      CHECK(graph.report.leaves_of_points <= graph.report.leaves_of_vertices);
      CHECK(graph.report.leaves_of_vertices == trees.tree().number_of_leaves());
    });
}

TEST_CASE("Leaves of T_B' are no smaller than a vertex nearby asks for", "[trees][separation]") {
  // Two points in squares that touch may be as near as they like; T_B knows distances by squares only. Balance makes
  // squares grow with their distance from the smallest.
  constexpr double share_of_distance = 1. / 8, share_of_way = 1. / 8;
  for_each_graph(is_full_run() ? 40 : 3, [&](const Pslg& pslg) {
    const Tree_options options = of_vertices_only(0.7);
    Prepared graph(pslg);
    const Trees trees = graph.trees(options);
    const vertex_edge_test::Brute_force brute(graph.graph());
    std::vector<double> asked(pslg.number_of_vertices());
    for (std::size_t v = 0; v < asked.size(); ++v)
      asked[v] = graph.map().length_to_kernel(std::min(brute.nearest_vertex(Vertex_index(v)).distance(),
                                                       brute.nearest_segment(Vertex_index(v)).distance()));
    std::size_t too_small = 0;
    for (std::size_t l = 0; l < trees.tree().number_of_leaves(); ++l) {
      const auto s = trees.tree().square(Leaf_index(l));
      const double side = trees.side(Leaf_index(l));
      const Vector half{side / 2, side / 2};
      bool is_asked_for = false;
      for (std::size_t v = 0; v < asked.size() && !is_asked_for; ++v) {
        const Vector to_leaf = Geometry::difference(trees.kernel_point({s.x, s.y}),
                                                    graph.problem().input_point(internal::Vertex_id(v))) +
                               half;
        is_asked_for =
            side >= share_of_distance * asked[v] && side >= share_of_way * std::sqrt(squared_length(to_leaf));
      }
      too_small += is_asked_for ? 0 : 1;
    }
    CHECK(too_small == 0);
  });
}

std::vector<internal::Axis_distances> hits_by_trapezoids(const Pslg& pslg) {
  const CGAL::Trapezoidal_vertex_edge_neighbors_2<Filtered_traits> neighbors(pslg);
  return internal::nearest_hit_distances<CGAL::Sequential_tag>(neighbors, pslg.number_of_vertices());
}

TEST_CASE("Both models of neighbors give the same trees", "[trees][separation]") {
  for_each_graph(is_full_run() ? 40 : 4, [](const Pslg& pslg) {
    const Tree_options options = Tree_options::of_theorem();
    Prepared graph(pslg);
    const auto leaves = leaves_of(graph.trees(options).tree());
    const std::size_t of_vertices = graph.report.leaves_of_vertices;
    CHECK(leaves_of(graph.trees(options, hits_by_trapezoids).tree()) == leaves);
    CHECK(graph.report.leaves_of_vertices == of_vertices);
  });
}

// ---- T_B''and T_B*

TEST_CASE("Edges in a leaf, or in one next to it, are apart", "[trees][separation]") {
  std::size_t faults = 0, leaves = 0;
  for (const Tree_options& options :
       {Tree_options::of_theorem(), Tree_options::of_theorem().distances(0.7, 1), Tree_options::of_paper()})
    for_each_graph(is_full_run() ? 30 : 1, [&](const Pslg& pslg) {
      Prepared graph(pslg);
      const Trees trees = graph.trees(options);
      const std::size_t n = Pair_check(graph, trees, options).number_of_faults();
      CHECK(n == 0);
      faults += n, leaves += trees.tree().number_of_leaves();
      CHECK(graph.report.leaves_of_vertices <= graph.report.leaves_of_pieces);
      CHECK(graph.report.leaves_of_pieces <= graph.report.leaves_of_edges);
    });
  CAPTURE(leaves);
  CHECK(faults == 0);
}

TEST_CASE("Edges stay apart when leaves are split", "[trees][separation]") {
  for_each_graph(is_full_run() ? 30 : 1, [](const Pslg& pslg) {
    const Tree_options options = Tree_options::of_theorem();
    Prepared graph(pslg);
    Trees trees = graph.trees(options);
    random_pslg::Random random(1);
    for (int round = 0; round < 2 && trees.tree().number_of_leaves() < 10000; ++round) {
      std::vector<Leaf_index> leaves;
      for (std::size_t l = 0; l < trees.tree().number_of_leaves(); ++l)
        if (random.integer(0, 9) == 0) leaves.push_back(Leaf_index(l));
      trees.refine(leaves, {});
      CHECK(Pair_check(graph, trees, options).number_of_faults() == 0);
      CHECK(trees.tree().is_valid());
    }
    CHECK_FALSE(trees.refine({}, {}));
  });
}

TEST_CASE("Leaves are looked at as often as they change, however many levels are missing",
          "[trees][separation]") {
  // Each leaf that there ever is once by itself; with its neighbors again when one of these is split.
  constexpr std::size_t times = 3;
  for (const std::string name :
       {"hard_legs_at_2e-63.poly", "syn_wedge_0.01deg.poly", "syn_near_1e-12.poly"}) {
    CAPTURE(name);
    const Tree_options options = Tree_options::of_theorem();
    Prepared graph(read(name));
    const std::size_t leaves = graph.trees(options).tree().number_of_leaves();
    CAPTURE(leaves, graph.report.splits);
    CHECK(graph.report.leaf_tests <= times * leaves);
  }
}

TEST_CASE("Pieces by walking and by centroid trees give the same trees", "[trees][separation]") {
  for_each_graph(is_full_run() ? 30 : 3, [](const Pslg& pslg) {
    Tree_options options = Tree_options::of_theorem();
    Prepared graph(pslg);
    const Trees walked = graph.trees(options);
    const Tree_options by_centroids =
        Tree_options::of_theorem().subdivide(Tree_options::Subdivision::CENTROID_TREE);
    const Trees cut = graph.trees(by_centroids);
    CHECK(leaves_of(walked.tree()) == leaves_of(cut.tree()));
    CHECK(walked.pieces() == cut.pieces());
  });
}

TEST_CASE("Trees are the same with any number of threads", "[trees][separation][parallel]") {
  const Pslg pslg = read(is_full_run() ? "us_states_10m.poly.gz" : "syn_holes_400.poly.gz");
  const Tree_options options = Tree_options::of_theorem();
  Prepared graph(pslg);
  const auto leaves = leaves_of(graph.trees(options).tree());
  for_numbers_of_threads([&] {
    Prepared_graph<Filtered_traits, CGAL::Parallel_tag> parallel(pslg);
    CHECK(leaves_of(parallel.trees(options).tree()) == leaves);
  });
}

// ---- gaps

TEST_CASE("Gaps between segments are shortest ways", "[trees][separation]") {
  random_pslg::Random random(7);
  const auto vector = [&] { return Vector{random.between(-1, 2), random.between(-1, 2)}; };
  for (int i = 0; i < 2000; ++i) {
    const Local_segment s{vector(), vector()}, t{vector(), i % 10 == 0 ? s.a : vector()};
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    const auto segment = [](const Local_segment& l) {
      return Exact::Segment_2(Exact::Point_2(l.a.x, l.a.y), Exact::Point_2(l.b.x, l.b.y));
    };
    if (CGAL::do_intersect(segment(s), segment(t))) continue; // edges of a graph do not cross
    const Local_gap gap = Local_gap::between(s, t);
    CHECK(gap.length == Approx(std::sqrt(CGAL::to_double(CGAL::squared_distance(segment(s), segment(t))))));
    CHECK(std::sqrt(squared_length(gap.to - gap.from)) == Approx(gap.length));
    CHECK(s.distance_to(gap.from) <= 1e-12);
    CHECK(t.distance_to(gap.to) <= 1e-12);
  }
}

TEST_CASE("Segments are clipped to squares", "[trees][separation]") {
  random_pslg::Random random(8);
  const auto is_inside = [](Vector p) {
    return p.x > -1e-12 && p.y > -1e-12 && p.x < 1 + 1e-12 && p.y < 1 + 1e-12;
  };
  for (int i = 0; i < 2000; ++i) {
    Local_segment s{{random.between(-1, 2), random.between(-1, 2)},
                    {random.between(-1, 2), random.between(-1, 2)}};
    if (i % 7 == 0) s.b.x = s.a.x;
    if (i % 11 == 0) s.b.y = s.a.y;
    Local_segment clipped = s;
    const bool is_any = clipped.clip(0, 1);
    if (is_any) CHECK((is_inside(clipped.a) && is_inside(clipped.b)));
    std::size_t lost = 0;
    for (double f = 0; f <= 1; f += 1. / 64) {
      const Vector p = s.a + f * (s.b - s.a);
      if (p.x < 0 || p.y < 0 || p.x > 1 || p.y > 1) continue;
      if (!is_any || clipped.distance_to(p) > 1e-9) ++lost;
    }
    CHECK(lost == 0);
  }
}

TEST_CASE("The domain is on the sides of edges where it is", "[trees][separation]") {
  // a square, counterclockwise, with an edge within it
  const Pslg pslg = pslg_test::make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {2, 1}},
                                                 {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
  const Prepared graph(pslg);
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const auto a = static_cast<Vertex_id>(pslg.segments[i][0].value()),
               b = static_cast<Vertex_id>(pslg.segments[i][1].value());
    const Edge_id e = graph.problem().edges.between(a, b);
    const bool is_turned = graph.problem().edges[e].a != a;
    const auto& sides = graph.sides();
    CHECK((is_turned ? sides.is_domain_on_right(e) : sides.is_domain_on_left(e)));
    CHECK((is_turned ? sides.is_domain_on_left(e) : sides.is_domain_on_right(e)) == (i == 4));
  }
}

} // namespace test_separation_trees
