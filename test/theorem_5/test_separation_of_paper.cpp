// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// How far quadtrees keep features apart, by all pairs and an exact kernel. Nothing of the code that makes the trees is
// asked, but for the squares of leaves and whether one is too small to be split.

#include "catch.h"
#include "quadtree_test_inputs.h"
#include "random_pslg_shapes.h"
#include "separation_test_tools.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quadtree_mesh_2/internal/base/compat.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_separation_of_paper {

namespace {

using namespace separation_test;
using pslg_test::Pslg;
using Prepared = Prepared_graph<quadtree_test::Filtered_traits>;
using Trees = Prepared::Trees;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Exact::Point_2;
using Segment = Exact::Segment_2;
using FT = Exact::FT;

Point exact(const Pslg::Point_2& p) { return Point(p.x(), p.y()); }

/// Which places are in the domain: those that are enclosed, but for the faces with points of holes.
class Domain {
public:
  explicit Domain(const Pslg& pslg) {
    for (const auto& s : pslg.segments)
      cdt_.insert_constraint(exact(pslg.point(s[0])), exact(pslg.point(s[1])));
    for (const auto f : cdt_.all_face_handles()) f->info() = true;
    if (cdt_.dimension() < 2) return;
    leave_out(cdt_.infinite_face());
    for (const auto& p : pslg.holes) leave_out(cdt_.locate(exact(p)));
  }

  /// \pre p is on no edge
  bool contains(const Point& p) const { return cdt_.dimension() == 2 && cdt_.locate(p)->info(); }

private:
  using Vertex_base = CGAL::Triangulation_vertex_base_2<Exact>;
  using Face_base =
      CGAL::Triangulation_face_base_with_info_2<bool, Exact,
                                                CGAL::Constrained_triangulation_face_base_2<Exact>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
      Exact, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>;
  Cdt cdt_;

  static void leave_out(Cdt::Face_handle first) {
    std::vector<Cdt::Face_handle> open{first};
    while (!open.empty()) {
      const auto f = open.back();
      open.pop_back();
      if (!f->info()) continue;
      f->info() = false;
      for (int k = 0; k < 3; ++k)
        if (!f->is_constrained(k)) open.push_back(f->neighbor(k));
    }
  }
};

/// An edge or a vertex of the graph, or a part of an edge: `second` is the first where it is a vertex.
struct Feature {
  Point first, second;
  std::array<std::size_t, 2> ends; ///< vertices of the graph

  bool is_vertex() const { return ends[0] == ends[1]; }
  bool has_end(std::size_t v) const { return ends[0] == v || ends[1] == v; }
  bool is_at(const Feature& f) const {
    return ends == f.ends || (is_vertex() && f.has_end(ends[0])) || (f.is_vertex() && has_end(f.ends[0]));
  }
};

Point nearest_to(const Point& p, const Feature& f) {
  if (f.first == f.second) return f.first;
  const Exact::Vector_2 d = f.second - f.first;
  const FT share = ((p - f.first) * d) / d.squared_length();
  return share <= 0 ? f.first : share >= 1 ? f.second : f.first + share * d;
}

struct Way {
  Point from, to;
  FT squared_length() const { return CGAL::squared_distance(from, to); }
};

/// \pre they do not cross
Way shortest_way(const Feature& f, const Feature& g) {
  Way best{f.first, nearest_to(f.first, g)};
  for (const Way& way : {Way{f.second, nearest_to(f.second, g)}, Way{nearest_to(g.first, f), g.first},
                         Way{nearest_to(g.second, f), g.second}})
    if (way.squared_length() < best.squared_length()) best = way;
  return best;
}

double distance(const Feature& f, const Feature& g) {
  return std::sqrt(CGAL::to_double(shortest_way(f, g).squared_length()));
}

struct Square {
  double x, y, side;
  Exact::Iso_rectangle_2 closed() const { return {Point(x, y), Point(x + side, y + side)}; }
  bool holds(const Point& p) const {
    return x <= p.x() && p.x() < x + side && y <= p.y() && p.y() < y + side;
  }
  double gap_to(const CGAL::Bbox_2& b) const {
    return std::max({b.xmin() - x - side, x - b.xmax(), b.ymin() - y - side, y - b.ymax()});
  }
};

/// All pairs of what is in a leaf and a feature of the graph.
class All_pairs {
public:
  All_pairs(const Pslg& pslg, const Prepared& prepared, const Tree_options& options)
      : domain_(pslg), options_(options) {
    const Pslg& graph = prepared.graph();
    for (std::size_t v = 0; v < graph.number_of_vertices(); ++v)
      add(exact(graph.vertices[v]), exact(graph.vertices[v]), {{v, v}});
    for (const auto& s : graph.segments)
      add(exact(graph.point(s[0])), exact(graph.point(s[1])), {{std::size_t(s[0]), std::size_t(s[1])}});
  }

  /// Leaves with something in them that is too near to something in sight. Leaves that have no room for children, or
  /// a billionth of the root, for which rounding counts, are left out.
  std::size_t number_of_faults(const Trees& trees) const {
    const auto& tree = trees.tree();
    std::size_t faults = 0;
    for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) {
      const auto c = tree.corners(Leaf_index(l));
      if (tree.level(Leaf_index(l)) < 30 && trees.is_splittable(Leaf_index(l)))
        faults += has_fault({c[0].x(), c[0].y(), c[1].x() - c[0].x()}) ? 1 : 0;
    }
    return faults;
  }

private:
  Domain domain_;
  const Tree_options& options_;
  std::vector<Feature> features_;
  std::vector<CGAL::Bbox_2> boxes_;

  void add(const Point& p, const Point& q, std::array<std::size_t, 2> ends) {
    features_.push_back({p, q, ends});
    boxes_.push_back(p.bbox() + q.bbox());
  }

  double far() const { return std::max(options_.vertex_distance(), options_.edge_distance()); }

  bool has_fault(const Square& leaf) const {
    std::vector<const Feature*> around;
    bool is_empty = true;
    for (std::size_t i = 0; i < features_.size(); ++i)
      if (leaf.gap_to(boxes_[i]) <= far() * leaf.side) {
        around.push_back(&features_[i]);
        is_empty = is_empty && leaf.gap_to(boxes_[i]) > 0;
      }
    if (is_empty) return false;
    for (const Feature* f : around) {
      Feature own = *f;
      if (!cut(own, leaf)) continue;
      for (const Feature* other : around)
        if (!own.is_at(*other) && is_too_near(own, *other, leaf, around)) return true;
    }
    return false;
  }

  /// Cuts off what is not in a leaf; false if no more than a point is left of an edge, or nothing of a vertex.
  static bool cut(Feature& f, const Square& leaf) {
    if (f.is_vertex()) return leaf.holds(f.first);
    const auto part = CGAL::intersection(Segment(f.first, f.second), leaf.closed());
    const Segment* s = part ? CGAL::Quadtree_mesh_2::internal::held_in<Segment>(*part) : nullptr;
    if (s == nullptr || !leaf.holds(CGAL::midpoint(s->source(), s->target()))) return false;
    f.first = s->source(), f.second = s->target();
    return true;
  }

  bool is_too_near(const Feature& own, const Feature& other, const Square& leaf,
                   const std::vector<const Feature*>& around) const {
    const double sides = own.is_vertex() ? options_.vertex_distance() : options_.edge_distance();
    const double least = sides * leaf.side * (1 - 1e-9);
    const Way way = shortest_way(own, other);
    return way.squared_length() < FT(least) * FT(least) && !is_excepted(own, other, leaf) &&
           is_free(way, own, other, leaf, around) && domain_.contains(CGAL::midpoint(way.from, way.to));
  }

  /// Whether no edge crosses a way, or comes within rounding of it between its ends.
  bool is_free(const Way& way, const Feature& own, const Feature& other, const Square& leaf,
               const std::vector<const Feature*>& around) const {
    const Segment s(way.from, way.to);
    const FT touching = FT(1e-9 * leaf.side) * FT(1e-9 * leaf.side);
    return std::none_of(around.begin(), around.end(), [&](const Feature* f) {
      if (f->is_vertex() || f->ends == own.ends || f->ends == other.ends) return false;
      if (!CGAL::do_overlap(s.bbox(), f->first.bbox() + f->second.bbox())) return false;
      const auto is_at_foot = [&](const Point& p) { return p == way.from || p == way.to; };
      return !is_at_foot(f->first) && !is_at_foot(f->second) &&
             CGAL::squared_distance(s, Segment(f->first, f->second)) <= touching;
    });
  }

  /// The exceptions that the options name: edges at a common vertex, near it or in an acute corner.
  bool is_excepted(const Feature& own, const Feature& other, const Square& leaf) const {
    if (own.is_vertex() || other.is_vertex()) return false;
    for (const std::size_t v : own.ends)
      if (other.has_end(v)) {
        const Point middle(leaf.x + leaf.side / 2, leaf.y + leaf.side / 2), &apex = features_[v].first;
        const double way = std::sqrt(CGAL::to_double(CGAL::squared_distance(middle, apex)));
        if (way < options_.vertex_window() * leaf.side * (1 + 1e-9)) return true;
        return is_acute(own, other, v) &&
               width(own, other) <= options_.strip_width() * leaf.side * (1 + 1e-9);
      }
    return false;
  }

  static double width(const Feature& own, const Feature& other) {
    const auto at = [&](const Point& p) { return distance({p, p, {{0, 0}}}, other); };
    return std::max(at(own.first), at(own.second));
  }

  /// Whether a corner is so acute that it is lopped where the bound is 20.7 degrees.
  bool is_acute(const Feature& f, const Feature& g, std::size_t v) const {
    const auto along = [&](const Feature& x) {
      const Exact::Vector_2 d = features_[x.ends[0] == v ? x.ends[1] : x.ends[0]].first - features_[v].first;
      return std::array<double, 2>{{CGAL::to_double(d.x()), CGAL::to_double(d.y())}};
    };
    const auto [a, b] = along(f);
    const auto [c, d] = along(g);
    return std::fabs(std::atan2(a * d - b * c, a * c + b * d)) < 1.6 * 20.7 * CGAL_PI / 180 * (1 + 1e-9);
  }
};

/// The graph with each place once.
Pslg without_duplicates(const Pslg& pslg) {
  Pslg result;
  result.holes = pslg.holes;
  std::vector<Vertex_index> image;
  for (const auto& p : pslg.vertices) {
    const auto found = std::find(result.vertices.begin(), result.vertices.end(), p);
    image.push_back(Vertex_index(std::size_t(found - result.vertices.begin())));
    if (found == result.vertices.end()) result.add_vertex(p);
  }
  for (const auto& s : pslg.segments)
    if (image[std::size_t(s[0])] != image[std::size_t(s[1])])
      result.add_segment(image[std::size_t(s[0])], image[std::size_t(s[1])]);
  return result;
}

struct Outcome {
  std::size_t leaves, faults;
};

Outcome check(const Pslg& input, const Tree_options& options) {
  const Pslg pslg = without_duplicates(input);
  Prepared prepared(pslg);
  const Trees trees = prepared.trees(options);
  return {trees.tree().number_of_leaves(), All_pairs(pslg, prepared, options).number_of_faults(trees)};
}

Pslg read(const std::string& name) {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(pslg_test::data_file(name), pslg);
  return pslg;
}

} // namespace

TEST_CASE("What is in sight is as many sides of a leaf away as the options say, in whatever leaf",
          "[trees][separation]") {
  const std::size_t most_vertices = is_full_run() ? 400 : 45;
  std::size_t leaves = 0;
  for (const Tree_options& options :
       {Tree_options::of_paper(), Tree_options::of_theorem().distances(0.7, 1).vertex_window(4)})
    for (const random_pslg::Family& family : random_pslg::all_families())
      for (std::uint64_t seed = 0; seed < (is_full_run() ? 20u : 1u); ++seed) {
        const Pslg pslg = family.make(seed);
        if (pslg.number_of_vertices() > most_vertices) continue;
        const Outcome outcome = check(pslg, options);
        CAPTURE(family.name, seed, options.edge_distance(), outcome.leaves);
        CHECK(outcome.faults == 0);
        leaves += outcome.leaves;
      }
  CHECK(leaves > 10000);
}

TEST_CASE("Inputs of test/data are separated as the paper says", "[trees][separation]") {
  for (const std::string name :
       {"syn_square.poly", "syn_wedge_10deg.poly", "syn_near_1e-06.poly", "hard_visibility_graph_2608.poly",
        "hard_gap_outside_for_rounds.poly", "small_lattice_164.poly", "small_spokes_74.poly"}) {
    const Outcome outcome = check(read(name), Tree_options::of_paper());
    CAPTURE(name, outcome.leaves);
    CHECK(outcome.faults == 0);
  }
}

TEST_CASE("Leaves in a corner of any angle are split a few times, not without an end",
          "[trees][separation]") {
  // What a leaf at the limit of an exception asks for must not be what its children break again.
  for (const double angle : {0.01, 0.3, 3., 15., 25., 30., 33., 34., 40., 50., 70., 89.}) {
    Pslg pslg = pslg_test::make_pslg<double>({{-2, -2}, {3, -2}, {3, 3}, {-2, 3}, {0, 0}, {1, 0}},
                                             {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
    const double turn = angle * CGAL_PI / 180;
    const auto tip = pslg.add_vertex(Pslg::Point_2(0.7 * std::cos(turn), 0.7 * std::sin(turn)));
    pslg.add_segment(Vertex_index(4), tip);
    Prepared prepared(pslg);
    const Tree_options options = Tree_options::of_paper();
    const Trees trees = prepared.trees(options);
    CAPTURE(angle, trees.tree().number_of_leaves());
    CHECK(prepared.report.splits <= 8);
    CHECK(All_pairs(pslg, prepared, options).number_of_faults(trees) == 0);
  }
}

} // namespace test_separation_of_paper
