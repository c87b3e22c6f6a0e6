// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUALITY_MESHER_2_H
#define CGAL_QUALITY_MESHER_2_H

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_pipeline.h>
#include <CGAL/Quadtree_mesh_2/internal/nearest_hits.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/tags.h>
#include <CGAL/validate_pslg_2.h>

#include <stdexcept>
#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Triangulates the domain of a planar straight-line graph so that no triangle has an angle below a bound,
/// except in wedges that acute input corners force, with few triangles.
///
/// The domain is what the segments separate from infinity, less the components with a point of
/// `Pslg_2::holes`, unless the options have another rule. Bounds of size of the options, of its size field
/// and of the regions hold all together. Every input vertex of the domain is a vertex of the mesh, with its
/// coordinates; every input segment with the domain on at least one side is a chain of mesh edges.
/// Duplicate vertices are merged, vertices on segments split them, overlapping segments share their pieces.
/// The mesh is constrained Delaunay.
///
/// Where two segments meet at an angle phi below the bound, a triangle with all its vertices on the two may
/// have a smaller angle, never under 0.9 phi; such triangles are counted as exempt. Anything else below the
/// bound is listed in `Quality_mesh_report_2::unmet_triangles`: for bounds up to 20.7 degrees nothing so far, unless
/// a budget, the callback, the least edge or the precision of the coordinates stops refinement.
///
/// After Bern, Eppstein, Teng, "Parallel construction of quadtrees and quality triangulations", section 6,
/// with the squares refined one corner at a time where the mesh asks for them. Expected O(n log n + k) time
/// for k triangles.
/// \tparam Traits a model of `QuadtreeTraits_2` that names a meshing geometry.
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the mesh is the same, for any number of threads.
template <class Traits = Filtered_quadtree_traits_2<>, class ConcurrencyTag = Sequential_tag>
class Quality_mesher_2 {
public:
  /// \name Types
  /// @{

  /// What goes in and what comes out.
  using Geom_traits = Traits;
  using Point_2 = typename Traits::Point_2;
  using Pslg = Pslg_2<Point_2>;
  using Mesh = Indexed_mesh_2<Point_2>;
  /// @}

  /// \throws std::invalid_argument if an option is out of its range.
  explicit Quality_mesher_2(Quality_mesh_options_2 options = {}, const Traits& traits = Traits())
      : options_(std::move(options)), traits_(traits) {
    if (!(options_.min_angle_in_degrees >= 0 && options_.min_angle_in_degrees <= 30))
      throw std::invalid_argument("the least angle must be between 0 and 30 degrees");
    if (!(options_.max_edge_length >= 0))
      throw std::invalid_argument("the longest edge must not be negative");
    if (!(options_.max_triangle_area >= 0))
      throw std::invalid_argument("the largest area must not be negative");
    if (options_.smoothing_rounds < 0)
      throw std::invalid_argument("the number of smoothing rounds must not be negative");
    if (options_.thinning_rounds < 0)
      throw std::invalid_argument("the number of thinning rounds must not be negative");
    if (!(options_.min_edge_length >= 0)) throw std::invalid_argument("the least edge must not be negative");
    if (options_.min_edge_length > 0 && options_.separation == Quality_mesh_options_2::Separation::THEOREM_5)
      throw std::invalid_argument("the construction by quadtrees keeps to no least edge");
  }

  /// Returns the mesh of the domain of `pslg`.
  /// \throws Pslg_error_2 if there is nothing to mesh or segments cross; the message names the culprit.
  Mesh operator()(const Pslg& pslg);

  /// Lets the construction by quadtrees (Theorem 5) find the neighbours of vertices by another model of
  /// `VertexEdgeNeighbors_2` than `Quadtree_vertex_edge_neighbors_2`, for example the paper's,
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
  /// What is asked for.
  const Quality_mesh_options_2& options() const { return options_; }

private:
  Quality_mesh_options_2 options_;
  Traits traits_;
  Quadtree_mesh_2::internal::Find_nearest_hits<Pslg> find_hits_ = nullptr;
  Quality_mesh_report_2 report_;
};

// Outside the class, thus not inline: where a compiled library has it, the compiler need not look into it.
template <class Traits, class ConcurrencyTag>
typename Quality_mesher_2<Traits, ConcurrencyTag>::Mesh
Quality_mesher_2<Traits, ConcurrencyTag>::operator()(const Pslg& pslg) {
  using Pipeline =
      Quadtree_mesh_2::internal::Mesh_pipeline<Traits, Quadtree_mesh_2::internal::Inner_tag<ConcurrencyTag>>;
  const Quadtree_mesh_2::internal::Concurrency_scope scope{ConcurrencyTag()};
  report_ = Quality_mesh_report_2();
  check_pslg_structure(pslg);
  return Pipeline(pslg, options_, traits_, find_hits_, report_).run();
}

} // namespace CGAL

#define CGAL_QUADTREE_MESH_2_HAS_QUALITY_MESHER
#include <CGAL/Quadtree_mesh_2/compiled_meshers.h>

// For programs that come from Mesh_2, refine_quality_mesh_2() and Quality_cdt_mesher_2.
#include <CGAL/refine_quality_mesh_2.h>

#endif // CGAL_QUALITY_MESHER_2_H
