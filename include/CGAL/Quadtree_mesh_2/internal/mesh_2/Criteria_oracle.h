// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Finds out what a criteria object of Mesh_2 wants, by asking it.
//
// A model of `MeshingCriteria_2` only says of a face whether it is bad. The oracle shows it other triangles
// at the same place to find out how large or how sharp a triangle may be: equilateral ones of falling size,
// then isosceles ones of a rising angle. That takes a few dozen questions for a face.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CRITERIA_ORACLE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CRITERIA_ORACLE_H

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/Flat_points.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A triangle in doubles.
struct Plane_triangle {
  std::array<std::array<double, 2>, 3> p;

  double squared_side(std::size_t k) const {
    const auto &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
  }
  double longest() const { return std::sqrt(std::max({squared_side(0), squared_side(1), squared_side(2)})); }
  std::array<double, 2> centroid() const {
    return {(p[0][0] + p[1][0] + p[2][0]) / 3, (p[0][1] + p[1][1] + p[2][1]) / 3};
  }
  /// In degrees, the least one first.
  std::array<double, 3> angles() const {
    const double area2 =
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    std::array<double, 3> angles;
    for (std::size_t k = 0; k < 3; ++k) {
      const double cosine2 = squared_side((k + 1) % 3) + squared_side((k + 2) % 3) - squared_side(k);
      angles[k] = std::atan2(2 * std::fabs(area2), cosine2) * 180 / pi;
    }
    std::sort(angles.begin(), angles.end());
    return angles;
  }
};

template <class Cdt, class Criteria>
class Criteria_oracle {
public:
  using Flat = Flat_points<Cdt>;
  using Face_handle = typename Cdt::Face_handle;

  Criteria_oracle(const Criteria& criteria, const Cdt& cdt, const Flat& flat)
      : criteria_(criteria), is_bad_(criteria_.is_bad_object()), flat_(flat), sample_(cdt.geom_traits()) {}

  /// Its function object refers to the criteria.
  Criteria_oracle(const Criteria_oracle&) = delete;
  Criteria_oracle& operator=(const Criteria_oracle&) = delete;

  CGAL::Mesh_2::Face_badness badness(Face_handle f) const {
    typename Criteria::Quality quality;
    return is_bad_(f, quality);
  }

  Plane_triangle triangle(Face_handle f) const {
    Plane_triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = flat_(f->vertex(static_cast<int>(k))->point());
      t.p[k] = {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
    }
    return t;
  }

  /// The side of the largest equilateral triangle around the centroid that is not bad, to a twelfth; at most the
  /// longest side of `t`; 0 if all are bad.
  double wanted_size(const Plane_triangle& t) {
    const double longest = t.longest();
    double good = longest;
    for (int halvings = 0; is_bad_equilateral(t, good); ++halvings, good /= 2)
      if (halvings == most_halvings_) return 0;
    double bad = 2 * good;
    if (good < longest)
      for (int i = 0; i < 3; ++i) {
        const double middle = (good + bad) / 2;
        (is_bad_equilateral(t, middle) ? bad : good) = middle;
      }
    return good;
  }

  /// The least angle, in degrees, of an isosceles triangle like `t` that is not bad; 0 if those of up to `most`
  /// are.
  double wanted_angle(const Plane_triangle& t, double most) {
    constexpr double step = 0.5;
    const double least = t.angles().front();
    for (double angle = std::min(most, least + step); angle <= most; angle += step)
      if (!is_bad_isosceles(t, angle)) return angle;
    return is_bad_isosceles(t, most) ? 0 : most;
  }

private:
  static constexpr int most_halvings_ = 60;

  const Criteria criteria_;
  const typename Criteria::Is_bad is_bad_;
  const Flat& flat_;
  Cdt sample_;

  bool is_bad_equilateral(const Plane_triangle& t, double side) {
    const auto [x, y] = t.centroid();
    const double r = side / std::sqrt(3.0);
    return is_bad_sample({{{{x, y + r}, {x - side / 2, y - r / 2}, {x + side / 2, y - r / 2}}}}) ||
           is_bad_sample({{{{x, y - r}, {x + side / 2, y + r / 2}, {x - side / 2, y + r / 2}}}});
  }

  bool is_bad_isosceles(const Plane_triangle& t, double degrees) {
    const auto [x, y] = t.centroid();
    const double half = degrees * pi / 360, leg = t.longest();
    const double height = leg * std::cos(half), width = leg * std::sin(half);
    return is_bad_sample(
        {{{{x, y + 2 * height / 3}, {x - width, y - height / 3}, {x + width, y - height / 3}}}});
  }

  bool is_bad_sample(const Plane_triangle& t) {
    using Point = typename Flat::Point;
    sample_.clear();
    for (const auto& p : t.p) sample_.insert(flat_.lift(Point(p[0], p[1])));
    if (sample_.dimension() < 2) return true;
    const Face_handle f = sample_.finite_faces_begin();
    f->set_in_domain(true);
    return badness(f) != CGAL::Mesh_2::NOT_BAD;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_CRITERIA_ORACLE_H
