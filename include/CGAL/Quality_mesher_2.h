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
#include <CGAL/Kernel_traits.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_pipeline.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/indexed_mesh_to_triangulation_2.h>
#include <CGAL/tags.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/// Triangulates the domain of a planar straight-line graph so that no triangle has an angle below a bound,
/// except in wedges that acute input corners force, with few triangles.
///
/// The domain is what the segments separate from infinity, less the components with a point of
/// `Pslg_2::holes`. Every input vertex of the domain is a vertex of the mesh, with its coordinates; every
/// input segment with the domain on at least one side is a chain of mesh edges. Duplicate vertices are
/// merged, vertices on segments split them, overlapping segments share their pieces. The mesh is constrained
/// Delaunay.
///
/// Where two segments meet at an angle phi below the bound, a triangle with all its vertices on the two may
/// have a smaller angle, never under 0.9 phi; such triangles are counted as exempt. Anything else below the
/// bound is listed in `Quality_mesh_report_2::unmet_triangles`: nothing for bounds up to 20.7 degrees unless
/// a budget, the callback or the precision of the coordinates stops refinement.
///
/// After Bern, Eppstein, Teng, "Parallel construction of quadtrees and quality triangulations", section 6,
/// with the squares refined one corner at a time where the mesh asks for them. Expected O(n log n + k) time
/// for k triangles.
/// \tparam Traits a model of `QuadtreeTraits_2` that names a meshing geometry.
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the mesh is the same, for any number of threads.
template <class Traits = Filtered_quadtree_traits_2<>, class ConcurrencyTag = Sequential_tag>
class Quality_mesher_2 {
public:
  using Geom_traits = Traits;
  using Point_2 = typename Traits::Point_2;
  using Pslg = Pslg_2<Point_2>;
  using Mesh = Indexed_mesh_2<Point_2>;

  /// \throws std::invalid_argument if an option is out of its range.
  explicit Quality_mesher_2(Quality_mesh_options_2 options = {}, const Traits& traits = Traits())
      : options_(std::move(options)), traits_(traits) {
    if (!(options_.min_angle_in_degrees >= 0 && options_.min_angle_in_degrees <= 30))
      throw std::invalid_argument("the least angle must be between 0 and 30 degrees");
    if (!(options_.max_edge_length >= 0))
      throw std::invalid_argument("the longest edge must not be negative");
    if (!(options_.max_triangle_area >= 0))
      throw std::invalid_argument("the largest area must not be negative");
  }

  /// Returns the mesh of the domain of `pslg`.
  /// \throws Pslg_error_2 if there is nothing to mesh or segments cross; the message names the culprit.
  Mesh operator()(const Pslg& pslg) {
    report_ = Quality_mesh_report_2();
    check_pslg_structure(pslg);
    return Quadtree_mesh_2::internal::Mesh_pipeline<Traits, ConcurrencyTag>(pslg, options_, traits_, report_)
        .run();
  }

  /// What the last run reached.
  const Quality_mesh_report_2& report() const { return report_; }
  const Quality_mesh_options_2& options() const { return options_; }

private:
  Quality_mesh_options_2 options_;
  Traits traits_;
  Quality_mesh_report_2 report_;
};

/// Replaces a constrained triangulation by a quality mesh of its domain: what its constrained edges separate
/// from infinity, less the components of the seeds.
///
/// Takes the place of `refine_Delaunay_mesh_2()`. Afterwards `cdt` is a valid constrained Delaunay
/// triangulation whose faces in the domain, those with `is_in_domain()`, are the mesh; pockets and holes up
/// to the convex hull are filled with faces that are not. Vertex and face handles from before are invalid.
/// \tparam Cdt a `Constrained_Delaunay_triangulation_2` over doubles whose faces model
/// `DelaunayMeshFaceBase_2`.
/// \tparam Seeds a range of points, one in each hole.
/// \throws Pslg_error_2 if
/// nothing is enclosed; `cdt` is then as it was.
template <class Cdt, class Seeds>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const Seeds& seeds,
                                            const Quality_mesh_options_2& options = {}) {
  using Kernel = typename Kernel_traits<typename Cdt::Point>::Kernel;
  const auto pslg = pslg_from_triangulation_2(cdt, seeds);
  Quality_mesher_2<Filtered_quadtree_traits_2<Kernel>> mesher(options);
  indexed_mesh_to_constrained_Delaunay_triangulation_2(mesher(pslg), pslg, cdt);
  return mesher.report();
}

/// The same for a domain without holes.
template <class Cdt>
Quality_mesh_report_2 refine_quality_mesh_2(Cdt& cdt, const Quality_mesh_options_2& options = {}) {
  return refine_quality_mesh_2(cdt, std::vector<typename Cdt::Point>(), options);
}

} // namespace CGAL

#endif // CGAL_QUALITY_MESHER_2_H
