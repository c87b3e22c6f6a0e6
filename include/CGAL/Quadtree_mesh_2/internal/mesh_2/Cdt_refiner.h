// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes a constrained triangulation in place, until a criteria object of Mesh_2 accepts every face or
// nothing more can be done.
//
// The mesher knows bounds of angles and lengths. If the criteria object tells its bounds, they are given to
// the mesher. Then the object is asked about every face. If it still calls a face bad, Criteria_oracle.h
// finds out what it wants there. The triangulation is meshed again with that. This starts from its own
// vertices, so nothing is left of earlier attempts. If a criterion cannot be met, Mesh_2 does not end. Here
// the number of attempts is bounded, and faces that stay bad are reported.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_REFINER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_REFINER_H

#include <CGAL/Points_sizing_field_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Cdt_input.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Cdt_replacer.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Criteria_oracle.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Cdt>
class Cdt_refiner {
public:
  /// Takes the marks of the faces as the domain.
  explicit Cdt_refiner(Cdt& cdt) : cdt_(cdt), flat_(cdt), input_(cdt, flat_), replacer_(cdt, flat_, input_) {}

  /// Meshes by the options alone; their rule of domains is of no importance.
  Quality_mesh_report_2 refine(const Quality_mesh_options_2& options) {
    if (!input_.has_domain()) return {};
    set_options(options);
    make_mesh();
    replacer_.split_constraints(mesh_);
    return std::move(report_);
  }

  /// Meshes by the options, then as the criteria want it.
  template <class Criteria>
  Quality_mesh_report_2 refine(const Quality_mesh_options_2& options, const Criteria& criteria) {
    if (!input_.has_domain()) return {};
    set_options(options);
    Criteria_oracle<Cdt, Criteria> oracle(criteria, cdt_, flat_);
    make_mesh();
    try {
      find_bad(oracle);
      for (int attempt = 1; attempt < most_attempts_ && shall_try_again() && ask_for_more(oracle);
           ++attempt) {
        make_mesh();
        find_bad(oracle);
      }
    } catch (...) { // from the criteria: the triangulation is meshed, and complete but for this
      replacer_.split_constraints(mesh_);
      throw;
    }
    replacer_.split_constraints(mesh_);
    report_bad(oracle);
    return std::move(report_);
  }

private:
  using Input = Cdt_input<Cdt>;
  using Flat = typename Input::Flat;
  using Face_handle = typename Cdt::Face_handle;
  /// On all cores if the program links TBB: the mesh is the same.
  using Mesher = Quality_mesher_2<typename Flat::Traits, Parallel_tag>;
  static constexpr int most_attempts_ = 12;
  static constexpr double gradation_ = 0.5;

  Cdt& cdt_;
  Flat flat_;
  Input input_;
  Cdt_replacer<Cdt> replacer_;
  Quality_mesh_options_2 options_;
  std::function<double(double, double)> users_field_;
  std::vector<Points_sizing_field_2::Sized_point> wanted_;
  typename Mesher::Mesh mesh_;
  Quality_mesh_report_2 report_;
  std::vector<Face_handle> faces_; // of the mesh's triangles
  std::vector<std::size_t> bad_;   // triangles
  std::vector<char> is_excused_;   // per triangle: its angle is below the bound for a reason that is reported

  void set_options(const Quality_mesh_options_2& options) {
    options_ = options;
    options_.mesh_domain(input_.rule());
    users_field_ = options.size();
  }

  void make_mesh() {
    Mesher mesher(options_);
    auto mesh = mesher(input_.pslg());
    if (mesher.report().merged_vertices > 0)
      throw Pslg_error_2(Pslg_error_2::Kind::ROUNDING,
                         "vertices of the triangulation are at one place after projection and rounding");
    faces_ = replacer_.put(mesh);
    mesh_ = std::move(mesh), report_ = mesher.report();
  }

  template <class Oracle>
  void find_bad(const Oracle& oracle) {
    is_excused_.assign(faces_.size(), 0);
    for (const auto& t : report_.exempt_triangles) is_excused_[t.triangle.value()] = 1;
    for (const auto& t : report_.unmet_triangles) is_excused_[t.triangle.value()] = 1;
    bad_.clear();
    for (std::size_t t = 0; t < faces_.size(); ++t) {
      const CGAL::Mesh_2::Face_badness badness = oracle.badness(faces_[t]);
      if (badness == CGAL::Mesh_2::IMPERATIVELY_BAD || (badness == CGAL::Mesh_2::BAD && is_excused_[t] == 0))
        bad_.push_back(t);
    }
  }

  bool shall_try_again() const {
    return !bad_.empty() && !report_.is_cancelled && !report_.is_budget_exhausted;
  }

  /// Returns false if there is nothing new to ask for.
  template <class Oracle>
  bool ask_for_more(Oracle& oracle) {
    const std::size_t before = wanted_.size();
    constexpr double greatest_angle = Quality_mesh_options_2::greatest_min_angle;
    double angle = options_.min_angle();
    for (const std::size_t t : bad_) {
      const Plane_triangle triangle = oracle.triangle(faces_[t]);
      const double size = oracle.wanted_size(triangle);
      if (size > 0 && size < triangle.longest())
        want_size(triangle, size);
      else if (size > 0 && angle < greatest_angle)
        angle = std::max(angle, oracle.wanted_angle(triangle, greatest_angle));
    }
    const bool is_more = wanted_.size() > before || angle > options_.min_angle();
    options_.min_angle(angle);
    if (wanted_.size() > before) set_field();
    return is_more;
  }

  void want_size(const Plane_triangle& t, double size) {
    const auto [x, y] = t.centroid();
    wanted_.push_back({x, y, size});
    for (const auto& p : t.p) wanted_.push_back({(p[0] + x) / 2, (p[1] + y) / 2, size});
  }

  void set_field() {
    options_.size(
        [users = users_field_, wanted = Points_sizing_field_2(wanted_, gradation_)](double x, double y) {
          const double size = wanted(x, y);
          return users ? std::min(size, users(x, y)) : size;
        });
  }

  template <class Oracle>
  void report_bad(const Oracle& oracle) {
    std::vector<char> is_listed(faces_.size(), 0);
    for (const auto& t : report_.unmet_triangles) is_listed[t.triangle.value()] = 1;
    for (const std::size_t t : bad_) {
      if (is_listed[t] != 0) continue;
      const Plane_triangle triangle = oracle.triangle(faces_[t]);
      const auto angles = triangle.angles();
      Quality_mesh_report_2::Unmet_triangle unmet{Triangle_index(t), triangle.centroid(), angles.front(),
                                                  Quality_mesh_report_2::Reason::CRITERIA};
      unmet.greatest_angle = angles.back();
      report_.unmet_triangles.push_back(unmet);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CDT_REFINER_H
