// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_VERTEX_BUDGETS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_VERTEX_BUDGETS_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Bounds.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/triangle_budget.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What the construction by quadtrees may take before refinement on demand takes over.
struct Construction_budget {
  std::size_t leaves;                 ///< of the trees, and vertices of a round
  std::size_t vertices_of_all_rounds; ///< together
};

/// How many vertices a mesh may have before work on it is given up. This is the user's budget, or else a
/// multiple of what is expected, because no proof says that refinement ends.
template <class Geometry>
class Vertex_budgets {
public:
  /// \param expected the vertices that the mesh is expected to have
  /// \param expected_of_sizes those of them that bounds of size ask for
  Vertex_budgets(const Quality_mesh_options_2& options, const Bounds<Geometry>& bounds,
                 std::size_t input_vertices, double expected, double expected_of_sizes)
      : options_(options), input_vertices_(input_vertices), is_established_(bounds.is_established()),
        is_capped_(input_vertices < few_vertices && !options.refine_where()), expected_(expected),
        cap_(std::floor(cap_of_few_vertices + margin_of_sizes * expected_of_sizes)) {}

  /// Whether the user set a budget.
  bool is_of_user() const { return options_.max_vertices() > 0 || options_.max_steiner_vertices(); }

  /// How many triangles the mesh may be expected to have for it to be begun.
  Triangle_budget of_triangles() const {
    const Triangle_budget machine = Triangle_budget::of_machine();
    if (options_.max_vertices() > 0)
      return machine.smaller({static_cast<double>(options_.max_vertices()), "the vertex budget allows",
                              Triangle_budget::Unit::VERTICES});
    const std::optional<Triangle_budget> limit = of_few_vertices();
    return limit ? machine.smaller(*limit) : machine;
  }

  /// The limit of a graph of few vertices, if this is one and its user has not set another.
  std::optional<Triangle_budget> of_few_vertices() const {
    if (!is_capped_ || is_of_user()) return std::nullopt;
    return Triangle_budget(cap_, limit_of_few_vertices, Triangle_budget::Unit::TRIANGLES);
  }

  /// Quadtrees make ten times the triangles needed.
  bool allows_quadtrees() const { return !is_capped_ || 10 * expected_ < cap_; }

  /// \param may_construct_instead whether quadtrees take over when patience ends
  Mesh_limit of_refinement(bool may_construct_instead) const {
    if (is_of_user()) return {of_user()};
    const double patience = may_construct_instead ? options_.patience() : Quality_mesh_options_2().patience();
    if (!(patience > 0)) return {0};
    const double unexpected =
        options_.refine_where() ? unexpected_by_users_rule : std::min(1.0, patience) * allowance();
    const double affordable =
        std::max(least_patience * expected_ + unexpected, options_.patience_memory() / bytes_of_vertex);
    return {limited(std::min(patience * expected_ + unexpected, affordable)), most_triangles()};
  }

  /// A limit for the work from now on, where so many vertices have been inserted.
  static Mesh_limit from_now_on(Mesh_limit limit, std::size_t inserted) {
    return {limited(static_cast<double>(limit.vertices) + static_cast<double>(inserted)), limit.triangles};
  }

  /// Quadtrees make ten times the triangles needed, a hundred times with the placement by rule.
  Construction_budget of_construction() const {
    constexpr std::size_t any = Mesh_limit::any;
    if (is_of_user()) return {of_user(), any};
    const std::size_t leaves = limited(1000 * expected_ + 1e6);
    if (!is_capped_) return {leaves, any};
    constexpr double cost = Geometry::has_unlimited_coordinates ? cost_of_exact_leaves : 1;
    const std::size_t affordable = std::min(leaves, static_cast<std::size_t>(cap_ / cost));
    return {affordable, 2 * affordable};
  }

  /// For what refinement has to do in a mesh that is made.
  Mesh_limit of_repair(std::size_t vertices_of_mesh) const {
    if (is_of_user()) return {of_user()};
    return {std::max(vertices_of_mesh,
                     limited(static_cast<double>(vertices_of_mesh) + 10 * expected_ + allowance())),
            most_triangles()};
  }

private:
  /// Refinement that is expected to end may take so many times the vertices expected, whatever memory that needs.
  static constexpr double least_patience = 10;
  /// A graph of fewer vertices is given up at a mesh of some seconds and, together with what checks it, half a
  /// gigabyte, not counting what bounds of size ask for. Over exact numbers a vertex takes twice that and more. Gaps
  /// are so narrow then that their owner should know of them.
  static constexpr std::size_t few_vertices = 1000;
  static constexpr double cap_of_few_vertices = Geometry::has_unlimited_coordinates ? 5e5 : 1e6;
  static constexpr const char* limit_of_few_vertices =
      "without a vertex budget a graph of fewer than 1000 vertices is allowed";
  /// What bounds of size ask for is estimated; it may be so many times that.
  static constexpr double margin_of_sizes = 4;
  /// Time of a leaf of quadtrees over exact numbers, in that of a vertex.
  static constexpr double cost_of_exact_leaves = 2;
  /// What a user's rule asks for cannot be expected.
  static constexpr double unexpected_by_users_rule = 2e7;
  /// Of a vertex and its two triangles, in arrays of twice the size, and of what refinement notes about them.
  static constexpr double bytes_of_vertex =
      2 * (sizeof(typename Geometry::Point) + 2 * sizeof(typename Kernel_mesh<Geometry>::Triangle) + 64);

  const Quality_mesh_options_2& options_;
  std::size_t input_vertices_;
  bool is_established_, is_capped_;
  double expected_;
  double cap_; // vertices, for each of which there are two triangles

  /// Vertices beyond what is expected, for graphs that are small and hard. There are more where refinement is
  /// established to end. Elsewhere it goes on until the allowance is used up.
  double allowance() const { return is_established_ ? 2e6 : 2e5; }

  std::size_t of_user() const {
    std::size_t most = Triangle_budget::most_vertices;
    if (options_.max_vertices() > 0) most = std::min(most, options_.max_vertices());
    if (const auto steiner = options_.max_steiner_vertices(); steiner && *steiner < most)
      most = std::min(most, input_vertices_ + *steiner);
    return most;
  }
  static std::size_t limited(double vertices) {
    return static_cast<std::size_t>(std::min(static_cast<double>(Triangle_budget::most_vertices), vertices));
  }

  std::size_t most_triangles() const {
    return is_capped_ ? static_cast<std::size_t>(2 * cap_) : Mesh_limit::any;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_VERTEX_BUDGETS_H
