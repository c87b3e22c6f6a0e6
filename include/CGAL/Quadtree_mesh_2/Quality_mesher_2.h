// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_QUALITY_MESHER_2_H
#define CGAL_QUADTREE_MESH_2_QUALITY_MESHER_2_H

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_pipeline.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/nearest_hits.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Rounds_runner.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/tags.h>
#include <CGAL/validate_pslg_2.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Triangulates the domain of a planar straight-line graph with few triangles, so that no triangle has an
/// angle below a bound. Wedges that acute input corners force are the only exception.
///
/// The domain is everything that segments separate from infinity, except components with a point of
/// `Pslg_2::holes`; the options have other rules. Bounds of size from the options, from the size field and
/// from regions hold together. Every input vertex of the domain is a vertex of the mesh, with its
/// coordinates. Every input segment with the domain on at least one side becomes a chain of mesh edges.
/// Duplicate vertices are merged, vertices on segments split them, and overlapping segments share their
/// pieces. The mesh is constrained Delaunay.
///
/// Where two segments meet at an angle phi below the bound, a triangle with all its vertices on the two may
/// have a smaller angle, but never one under 0.9 phi. Such triangles are counted as exempt.
/// `Quality_mesh_report_2::unmet_triangles` lists all others below the bound. The soak (doc/soak.md) counts
/// how often bounds up to 20.7 degrees are met. A budget, the callback, the least edge or the precision of
/// the coordinates may stop refinement.
///
/// By default the mesh is made by constrained Delaunay refinement. New vertices are off-centers snapped to
/// corners of quadtree squares. Vertices are processed in shuffle order and relocated where that avoids an
/// insertion. Guarded removal takes out vertices that are not needed. Acute corners are treated as in Bern,
/// Eppstein, Teng, "Parallel construction of quadtrees and quality triangulations", section 6. With
/// `Separation::THEOREM_5` the quadtrees of that paper separate the features of the graph. Expected O(n log
/// n + k) time for k triangles by default.
/// \tparam Traits a model of `QuadtreeTraits_2` that names a meshing geometry.
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the mesh is the same for any number of threads.
template <class Traits = Filtered_quadtree_traits_2<>, class ConcurrencyTag = Sequential_tag>
class Quality_mesher_2 {
public:
  /// \name Types
  /// @{

  /// The traits.
  using Geom_traits = Traits;
  /// A point of the input and of the mesh.
  using Point_2 = typename Traits::Point_2;
  /// The input.
  using Pslg = Pslg_2<Point_2>;
  /// The result.
  using Mesh = Indexed_mesh_2<Point_2>;
  /// @}

  /// A mesher with these options.
  /// \throws std::invalid_argument if an option is out of its range.
  explicit Quality_mesher_2(Quality_mesh_options_2 options = {}, const Traits& traits = Traits())
      : options_(std::move(options)), traits_(traits) {
    if (!(options_.min_angle() >= 0 && options_.min_angle() <= Quality_mesh_options_2::greatest_min_angle))
      throw std::invalid_argument("the least angle must be between 0 and 34 degrees");
    if (!(options_.max_edge() >= 0)) throw std::invalid_argument("the longest edge must not be negative");
    if (!(options_.max_area() >= 0)) throw std::invalid_argument("the largest area must not be negative");
    if (!(options_.gradation() >= 0 && options_.gradation() <= Quality_mesh_options_2::steepest_gradation))
      throw std::invalid_argument("the gradation must be between 0 and 1");
    if (options_.max_edge_ratio() != 0 &&
        !(options_.max_edge_ratio() >= Quality_mesh_options_2::least_max_edge_ratio &&
          std::isfinite(options_.max_edge_ratio())))
      throw std::invalid_argument(
          "the greatest ratio of edges must be at least 3, or 0 for no bound: below that "
          "refinement is not known to end");
    if (options_.max_angle() != 0 &&
        !(options_.max_angle() >= Quality_mesh_options_2::least_max_angle && options_.max_angle() < 180))
      throw std::invalid_argument(
          "the greatest angle must be at least 105 and below 180 degrees, or 0 for no bound");
    if (options_.smooth() < 0)
      throw std::invalid_argument("the number of smoothing rounds must not be negative");
    if (options_.thin() < 0)
      throw std::invalid_argument("the number of thinning rounds must not be negative");
    if (!(options_.min_edge() >= 0)) throw std::invalid_argument("the least edge must not be negative");
    if (options_.min_edge() > 0 && options_.separate() == Quality_mesh_options_2::Separation::THEOREM_5)
      throw std::invalid_argument("the construction by quadtrees keeps to no least edge");
    if (options_.keep_borders() != Quality_mesh_options_2::Keep_borders::NONE &&
        options_.separate() == Quality_mesh_options_2::Separation::THEOREM_5)
      throw std::invalid_argument("the construction by quadtrees cuts all segments: it cannot keep borders");
  }

  /// Returns the mesh of the domain of `pslg`.
  /// \throws Pslg_error_2 for input that cannot be meshed, see its kinds.
  Mesh operator()(const Pslg& pslg);

  /// Sets the model of `VertexEdgeNeighbors_2` by which the construction by quadtrees (Theorem 5) finds the
  /// neighbors of vertices. The default is `Quadtree_vertex_edge_neighbors_2`. The paper's is
  /// `Trapezoidal_vertex_edge_neighbors_2<Traits, ConcurrencyTag>`. The mesh is the same.
  template <class Neighbors>
  Quality_mesher_2& find_neighbors_by() {
    find_hits_ = [](const Pslg& pslg) {
      return Quadtree_mesh_2::internal::nearest_hit_distances<ConcurrencyTag>(Neighbors(pslg),
                                                                              pslg.number_of_vertices());
    };
    return *this;
  }

  /// What the last run reached.
  const Quality_mesh_report_2& report() const { return report_; }
  /// The options of this mesher.
  const Quality_mesh_options_2& options() const { return options_; }

private:
  Quality_mesh_options_2 options_;
  Traits traits_;
  Quadtree_mesh_2::internal::Find_nearest_hits<Pslg> find_hits_ = nullptr;
  Quality_mesh_report_2 report_;
  Quadtree_mesh_2::internal::Rounds_runner<Quadtree_mesh_2::internal::Mesher_geometry<Traits>>*
      rounds_runner_ = nullptr;

  /// \cond SKIP_IN_MANUAL
  friend struct Quadtree_mesh_2::internal::Mesher_rounds;
  /// \endcond
};

// Defined outside the class, so not inline: a compiled library spares the compiler the body.
template <class Traits, class ConcurrencyTag>
typename Quality_mesher_2<Traits, ConcurrencyTag>::Mesh
Quality_mesher_2<Traits, ConcurrencyTag>::operator()(const Pslg& pslg) {
  using Pipeline =
      Quadtree_mesh_2::internal::Mesh_pipeline<Traits, Quadtree_mesh_2::internal::Inner_tag<ConcurrencyTag>>;
  const Quadtree_mesh_2::internal::Concurrency_scope scope{ConcurrencyTag()};
  report_ = Quality_mesh_report_2();
  check_pslg_structure(pslg);
  Pipeline pipeline(pslg, options_, traits_, find_hits_, report_);
  pipeline.run_rounds_by(rounds_runner_);
  return pipeline.run();
}

} // namespace CGAL

#define CGAL_QUADTREE_MESH_2_HAS_QUALITY_MESHER
#include <CGAL/Quadtree_mesh_2/compiled_meshers.h>

#endif // CGAL_QUADTREE_MESH_2_QUALITY_MESHER_2_H
