// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Placed vertices where leaves were split: the mesh that is changed there has the vertices of one made anew, and is
// constrained Delaunay as well; cures stay outside of the scope and are undone in it.

#include "catch.h"
#include "random_pslg_shapes.h"
#include "separation_test_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Local_cures.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_update.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Tree_placement.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_placed_update {

namespace {

using namespace separation_test;
using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Prepared = Prepared_graph<Traits>;
using Geometry = Prepared::Geometry;
using Trees = Prepared::Trees;
using Placed = internal::Placed_vertices<Geometry>;
using Mesh = internal::Kernel_mesh<Geometry>;
using Triangles = internal::Edge_triangles<Geometry>;
using Corners = internal::Tree_corners<Trees::Tree>;
using internal::Placement_scope;
using internal::Triangle_id;
using internal::Vertex_id;
using Place = std::array<double, 2>;

/// A graph whose mesh is changed, round after round.
class Changed_mesh {
public:
  explicit Changed_mesh(const Prepared::Pslg& pslg) : graph_(pslg), trees_(graph_.trees(options_)) {
    place(next_scope());
  }

  /// Splits leaves, gives vertices windows, and changes the mesh. \returns the scope
  Placement_scope split(const std::vector<Leaf_index>& leaves, const std::vector<Vertex_id>& vertices) {
    trees_.refine(leaves, vertices);
    Placement_scope scope = next_scope();
    place(scope);
    return scope;
  }

  void cure() {
    CGAL::Tree_separation_report_2 report;
    internal::Local_cures<Geometry>(graph_.state(), report)
        .run(internal::missed_triangles<CGAL::Sequential_tag>(graph_.state()));
  }

  /// The mesh with all vertices that are placed now.
  Mesh made_anew() {
    const Mesh changed = graph_.state().mesh;
    place(Placement_scope());
    return std::exchange(graph_.state().mesh, changed);
  }

  const Mesh& mesh() { return graph_.state().mesh; }
  const Trees& trees() const { return trees_; }
  std::size_t number_of_input_vertices() const { return graph_.problem().input_points.size(); }

private:
  const Tree_options options_ = Tree_options::of_theorem();
  Prepared graph_;
  Trees trees_;
  const Mesh domain_ = graph_.state().mesh;
  const Triangles triangles_ =
      Triangles::of<CGAL::Sequential_tag>(domain_, graph_.problem().edges, number_of_input_vertices());
  internal::Placement_scopes scopes_;

  Placement_scope next_scope() {
    return scopes_.next(trees_.tree(), trees_.pieces_in_leaves(),
                        [this](Leaf_index l) { return trees_.windows().of(l); });
  }

  void place(const Placement_scope& scope) {
    const Placed placed =
        internal::Tree_placement<Traits, CGAL::Sequential_tag>(graph_.problem(), trees_, triangles_, scope)
            .run();
    if (scope.is_all)
      internal::Placed_insertion<CGAL::Sequential_tag, Geometry>(graph_.state(), placed, triangles_).run();
    else
      internal::Placed_update<CGAL::Sequential_tag, Trees>(graph_.state(), trees_, placed, scope, triangles_)
          .run();
  }
};

/// The vertices of a mesh for which `is_wanted(v)` holds.
template <class Is_wanted>
std::vector<Place> places(const Mesh& mesh, const Is_wanted& is_wanted) {
  std::vector<Place> places;
  for (const Vertex_id v : mesh.points.ids())
    if (mesh.is_used(v) && is_wanted(v)) places.push_back({mesh.point(v).x, mesh.point(v).y});
  std::sort(places.begin(), places.end());
  return places;
}

std::vector<Place> all_places(const Mesh& mesh) {
  return places(mesh, [](Vertex_id) { return true; });
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle_id t : mesh.triangles.ids())
    if (mesh.is_alive(t)) sum += mesh.shape(mesh.triangle(t)).area2 / 2;
  return sum;
}

/// Some leaves that can be split, near each other.
std::vector<Leaf_index> leaves_to_split(const Trees& trees, random_pslg::Random& random) {
  const std::size_t n = trees.tree().number_of_leaves();
  const auto first = static_cast<std::size_t>(random.between(0, double(n) - 1));
  std::vector<Leaf_index> leaves;
  for (std::size_t l = first; l < std::min(first + 3, n); ++l)
    if (trees.is_splittable(Leaf_index(l))) leaves.push_back(Leaf_index(l));
  return leaves;
}

/// One vertex in some rounds.
std::vector<Vertex_id> vertices_for_windows(const Changed_mesh& changed, random_pslg::Random& random) {
  if (random.between(0, 1) < .5) return {};
  return {Vertex_id(std::size_t(random.between(0, double(changed.number_of_input_vertices()) - 1)))};
}

/// \returns whether a part was changed
bool check_that_it_is_as_made_anew(Changed_mesh& changed, random_pslg::Random& random) {
  const auto leaves = leaves_to_split(changed.trees(), random);
  const Placement_scope scope = changed.split(leaves, vertices_for_windows(changed, random));
  const Mesh anew = changed.made_anew();
  CHECK(all_places(changed.mesh()) == all_places(anew));
  CHECK(changed.mesh().number_of_triangles() == anew.number_of_triangles());
  CHECK_FALSE(flaws_of(changed.mesh()).is_any());
  CHECK(area(changed.mesh()) == Approx(area(anew)));
  return !scope.is_all;
}

/// \returns whether a part was changed
bool check_that_cures_stay_outside(Changed_mesh& changed, random_pslg::Random& random) {
  changed.cure();
  const Mesh before = changed.mesh();
  const auto leaves = leaves_to_split(changed.trees(), random);
  const Placement_scope scope = changed.split(leaves, vertices_for_windows(changed, random));
  if (scope.is_all) return false;
  const Trees& trees = changed.trees();
  const Corners corners(trees.tree());
  const auto is_free = [&](const Mesh& mesh, Vertex_id v, bool is_wanted_inside) {
    if (!mesh.is_free(v)) return false;
    const auto p = trees.grid_point(mesh.point(v));
    const auto c = trees.kernel_point(p) == mesh.point(v) ? corners.name(p) : Corners::none;
    return scope.has(c == Corners::none ? trees.tree().locate(p) : Corners::leaf_of(c)) == is_wanted_inside;
  };
  const auto free_places = [&](const Mesh& mesh, bool is_wanted_inside) {
    return places(mesh, [&](Vertex_id v) { return is_free(mesh, v, is_wanted_inside); });
  };
  CHECK(free_places(changed.mesh(), false) == free_places(before, false));
  CHECK(free_places(changed.mesh(), true) == free_places(changed.made_anew(), true));
  CHECK(flaws_of(changed.mesh()).clockwise == 0);
  CHECK(area(changed.mesh()) == Approx(area(before)));
  return true;
}

/// Calls `check(mesh, random)` in several rounds for each of many graphs.
template <class Check>
void check_graphs(const Check& check) {
  std::size_t parts = 0, rounds = 0;
  for (const auto& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < (is_full_run() ? 20 : 2); ++seed) {
      CAPTURE(family.name, seed);
      random_pslg::Random random(seed);
      Changed_mesh changed(family.make(seed));
      for (int round = 0; round < 4; ++round, ++rounds) parts += check(changed, random) ? 1 : 0;
    }
  CHECK(4 * parts > rounds);
}

} // namespace

TEST_CASE("A mesh changed where leaves were split is as made anew", "[theorem5]") {
  check_graphs(check_that_it_is_as_made_anew);
}

TEST_CASE("Cures stay where no leaf was split", "[theorem5]") { check_graphs(check_that_cures_stay_outside); }

} // namespace test_placed_update
