// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUALITY_CDT_MESHER_2_H
#define CGAL_QUALITY_CDT_MESHER_2_H

#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Cdt_refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/criteria_options.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/mark_domain.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <iterator>
#include <list>
#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Meshes a constrained triangulation in place, with the interface of `Delaunay_mesher_2`.
///
/// The domain is everything that constrained edges separate from infinity, except components with a seed.
/// Alternatively it is only the components with a seed, or the faces that the user has marked.
/// `refine_mesh()` makes a mesh in which the criteria call no face bad. `report()` lists the places where
/// that is impossible: near acute corners of the input (as in Mesh_2), for angles above 34 degrees, and for
/// criteria that no triangle can meet (Mesh_2 does not end then).
///
/// Vertex handles stay valid, and so does what users keep in vertices. A new vertex is as the default
/// constructor of its base leaves it. The constraints of a `Constrained_triangulation_plus_2` stay valid,
/// too, and their subconstraints become mesh edges. Face handles do not stay valid. The faces of the mesh
/// come first in the order of iteration. Faces between the mesh and the convex hull, and in holes, are not in
/// the domain.
///
/// Vertices are only ever added. As in Mesh_2, meshing again with other criteria continues from the present
/// mesh. You get the fewest triangles by setting the final criteria at once.
///
/// Unlike `Delaunay_mesher_2`, this class makes the mesh as a whole in one step (see
/// `step_by_step_refine_mesh()`). Constrained edges outside the domain stay as they are.
///
/// Expected O(n log n + k) time for k triangles. Criteria that only say whether a face is bad take this a few
/// times. The mesh is the same for any number of threads.
///
/// \tparam CDT a `Constrained_Delaunay_triangulation_2`, or a `Constrained_triangulation_plus_2` of one,
/// whose faces model `DelaunayMeshFaceBase_2`. Its kernel has double coordinates (predicates need not be
/// exact) or exact ones. It may also have traits that project points with double coordinates along an axis
/// (`Projection_traits_xy_3` and its like, `Projection_traits_3` with such a normal). New points then lie on
/// the surface of the original triangulation. (Other normals work, too, up to rounding at the convex hull;
/// but \cgal's criteria measure partly in space there.)
/// \tparam Criteria_ a model of `MeshingCriteria_2`. The mesher reads its `bound()` and `size_bound()` if
/// they exist. It asks the criteria about every face of the mesh, and about single triangles in a
/// triangulation of their own.
template <class CDT, class Criteria_ = Delaunay_mesh_size_criteria_2<CDT>>
class Quality_cdt_mesher_2 {
public:
  /// \name Types
  /// @{

  /// The triangulation, as in `Delaunay_mesher_2`.
  using Triangulation = CDT;
  /// What a face must satisfy.
  using Criteria = Criteria_;
  /// A point of the triangulation.
  using Point = typename CDT::Point;
  /// The seeds, which are kept in their order.
  using Seeds = std::list<Point>;
  /// Goes through the seeds.
  using Seeds_iterator = typename Seeds::const_iterator;
  /// The same: seeds do not change.
  using Seeds_const_iterator = Seeds_iterator;
  /// @}

  /// Keeps a reference to `cdt`, and does not change it yet.
  explicit Quality_cdt_mesher_2(CDT& cdt, const Criteria& criteria = Criteria())
      : cdt_(cdt), criteria_(criteria) {}

  /// \name Seeds
  ///@{

  /// The components with a point of the range are the domain if `mark` is true, and holes otherwise. With
  /// `do_it_now` faces are marked immediately.
  template <class InputIterator>
  void set_seeds(InputIterator begin, InputIterator end, bool mark = false, bool do_it_now = false) {
    seeds_.assign(begin, end);
    are_seeds_in_domain_ = mark;
    if (do_it_now) mark_facets();
  }
  /// Removes the seeds. The domain is then everything that constrained edges separate from infinity.
  void clear_seeds() {
    seeds_.clear();
    are_seeds_in_domain_ = false;
  }
  /// The first seed.
  Seeds_const_iterator seeds_begin() const { return seeds_.begin(); }
  /// Behind the last seed.
  Seeds_const_iterator seeds_end() const { return seeds_.end(); }

  /// Marks faces by the seeds. If `domain_specified`, it only takes faces connected to infinity out of the
  /// domain.
  void mark_facets(bool domain_specified = false) {
    if (domain_specified)
      Quadtree_mesh_2::internal::mark_outside(cdt_);
    else
      mark_facets(cdt_, seeds_.begin(), seeds_.end(), are_seeds_in_domain_);
  }
  /// Marks the faces of a triangulation by the seeds of a range, as `set_seeds()` has it.
  template <class InputIterator>
  static void mark_facets(CDT& cdt, InputIterator begin, InputIterator end, bool mark = false) {
    Quadtree_mesh_2::internal::mark_by_seeds(cdt, begin, end, mark);
  }

  ///@}
  /// \name Criteria
  ///@{

  /// Sets the criteria; only `refine_mesh()` changes the mesh. After a completed run, unless
  /// `recalculate_bad_faces`, `refine_mesh()` does nothing until `set_bad_faces()` names bad faces or
  /// `init()` looks for them.
  void set_criteria(const Criteria& criteria, bool recalculate_bad_faces = true) {
    criteria_ = criteria;
    if (recalculate_bad_faces && is_initialized_) look_for_bad_faces();
  }
  /// The criteria.
  const Criteria& get_criteria() const { return criteria_; }

  /// Sets what criteria do not express: bounds of areas, smoothing, budgets, a callback. Of two bounds of
  /// edges the stricter holds. The least angle and the domain of the options are ignored.
  void set_options(const Quality_mesh_options_2& options) {
    options_ = options;
    if (is_initialized_) is_done_ = false;
  }
  /// What `set_options()` has set.
  const Quality_mesh_options_2& options() const { return options_; }

  ///@}
  /// \name Meshing
  ///@{

  /// Marks the domain and looks for bad faces. If `domain_specified`, it uses the marks that faces have.
  void init(bool domain_specified = false) {
    mark_facets(domain_specified);
    is_initialized_ = true;
    look_for_bad_faces();
  }

  /// Makes the mesh. Calls `init()` first if that was not done. Changes nothing if no face in the domain is
  /// bad.
  /// \throws Pslg_error_2 if the domain cannot be meshed: a component is too thin for its coordinates, or
  /// constraints cross by rounding. The triangulation is then unchanged except for the marks of the domain.
  const Quality_mesh_report_2& refine_mesh() {
    if (!is_initialized_) init();
    if (is_done_) return report_;
    report_ = Quadtree_mesh_2::internal::Cdt_refiner<CDT>(cdt_).refine(combined_options(), criteria_);
    is_done_ = true;
    return report_;
  }

  /// Whether `refine_mesh()` has nothing to do: no face is bad, or bad faces cannot be cured.
  bool is_refinement_done() const { return !is_initialized_ || is_done_; }

  /// Does the whole of `refine_mesh()`. There are no smaller steps, because no face is final before the last.
  /// Returns whether there was something to do.
  /// \pre `init()` was called
  bool step_by_step_refine_mesh() {
    if (is_refinement_done()) return false;
    refine_mesh();
    return true;
  }
  /// The same.
  bool try_one_step_refine_mesh() { return step_by_step_refine_mesh(); }

  /// Declares that there are bad faces if the range is not empty. The criteria find out which ones in any
  /// case.
  template <class Face_handle_iterator>
  void set_bad_faces(Face_handle_iterator begin, Face_handle_iterator end) {
    is_done_ = begin == end;
  }

  ///@}

  /// What the last run reached. The i-th face of the mesh is its triangle i.
  const Quality_mesh_report_2& report() const { return report_; }
  /// The triangulation that is meshed.
  const Triangulation& triangulation() const { return cdt_; }

private:
  CDT& cdt_;
  Criteria criteria_;
  Quality_mesh_options_2 options_;
  Seeds seeds_;
  bool are_seeds_in_domain_ = false;
  bool is_initialized_ = false;
  bool is_done_ = false;
  Quality_mesh_report_2 report_;

  void look_for_bad_faces() {
    const auto is_bad = criteria_.is_bad_object();
    is_done_ = !has_wishes_of_its_own();
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end() && is_done_; ++f) {
      typename Criteria::Quality quality;
      is_done_ = !f->is_in_domain() || is_bad(f, quality) == Mesh_2::NOT_BAD;
    }
  }

  /// Whether the options bound sizes, which the criteria do not know.
  bool has_wishes_of_its_own() const {
    return options_.max_area() > 0 || options_.max_edge() > 0 || options_.size() || options_.refine_where();
  }

  Quality_mesh_options_2 combined_options() const {
    const Quality_mesh_options_2 of_criteria = quality_mesh_options_2(criteria_);
    Quality_mesh_options_2 options = options_;
    options.min_angle(of_criteria.min_angle());
    if (of_criteria.max_edge() > 0 &&
        !(options.max_edge() > 0 && options.max_edge() < of_criteria.max_edge()))
      options.max_edge(of_criteria.max_edge());
    return options;
  }
};

} // namespace CGAL

#endif // CGAL_QUALITY_CDT_MESHER_2_H
