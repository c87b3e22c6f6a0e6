// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_CONFORMAL_PROJECTION_2_H
#define CGAL_CONFORMAL_PROJECTION_2_H

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// A conformal map of the sphere: Mercator, Lambert's conic one with two standard parallels, or the polar
/// stereographic one. It takes longitudes and latitudes in degrees to meters in a plane and back, and keeps angles.
///
/// The three are one family. With the cone's constant `n`, the difference `l` of longitudes from the central meridian
/// and the difference `q` of isometric latitudes from the latitude of the origin, it is
/// x = r exp(-n q) sin(n l), y = r (1 - exp(-n q) cos(n l)). Lambert's map tends to Mercator's for n -> 0 and to the
/// stereographic one for n -> 1. See Snyder, Map Projections: A Working Manual, USGS Professional Paper 1395 (1987),
/// equations (7-1), (15-1) to (15-3) and (21-5) to (21-7), here without cancellation next to the origin.
///
/// The earth is a sphere of the mean radius 6 371 008.8 meters. Latitudes are taken as those of the sphere. On the
/// ellipsoid WGS 84 angles differ from those by up to 0.2 degrees, and lengths by up to 0.6 percent: less than what
/// bounds of meshes mean. The sphere has closed formulas both ways, so the inverse needs no iteration.
class Conformal_projection_2 {
public:
  /// The projections.
  enum class Kind {
    MERCATOR,     ///< the map with the cone's constant 0
    LAMBERT,      ///< Lambert's conic map
    STEREOGRAPHIC ///< the map with the cone's constant 1
  };
  using Place = std::array<double, 2>; ///< (longitude, latitude) in degrees, or (x, y) in meters

  /// The range of longitudes and latitudes, in degrees.
  struct Box {
    Place low;  ///< the least longitude and the least latitude
    Place high; ///< the largest ones
  };

  static constexpr double radius = 6371008.8; ///< of the sphere, in meters

  /// Mercator's projection. The two parallels `latitude` and `-latitude` have scale 1.
  /// \throws std::invalid_argument if `latitude` is not in (-90, 90)
  static Conformal_projection_2 mercator(double central_longitude, double latitude) {
    check_parallel(latitude);
    Conformal_projection_2 p(Kind::MERCATOR, central_longitude, {latitude, latitude}, 0, 0);
    p.unit_ = radius * std::cos(radians(latitude));
    return p;
  }

  /// Lambert's conformal conic projection. Both parallels have scale 1; they may be the same one.
  /// \throws std::invalid_argument if a parallel is not in (-90, 90), or they are opposite, so that there is no cone
  static Conformal_projection_2 lambert(double central_longitude, double first, double second) {
    check_parallel(first), check_parallel(second);
    const double c1 = std::cos(radians(first)), c2 = std::cos(radians(second));
    const double n = first == second
                         ? std::sin(radians(first))
                         : std::log(c1 / c2) / isometric_difference(radians(second), radians(first));
    if (!(std::abs(n) > 1e-9))
      throw std::invalid_argument(
          "Lambert's projection needs parallels that are not opposite: use Mercator's");
    Conformal_projection_2 p(Kind::LAMBERT, central_longitude, {first, second}, n, (first + second) / 2);
    p.set_scale_at(first);
    return p;
  }

  /// The stereographic projection from the other pole, of the hemisphere of `latitude`, whose parallel has scale 1.
  /// \throws std::invalid_argument if `latitude` is 0 or not in (-90, 90)
  static Conformal_projection_2 stereographic(double central_longitude, double latitude) {
    check_parallel(latitude);
    if (latitude == 0) throw std::invalid_argument("the polar projection needs a latitude other than 0");
    Conformal_projection_2 p(Kind::STEREOGRAPHIC, central_longitude, {latitude, latitude},
                             latitude > 0 ? 1 : -1, latitude);
    p.set_scale_at(latitude);
    return p;
  }

  /// Mercator's projection for a box: scales at its latitudes are as much below 1 as above.
  /// \throws std::invalid_argument if the box reaches a pole, or is wider than 360 degrees
  static Conformal_projection_2 mercator(const Box& box) {
    check(box);
    const double most = box.low[1] <= 0 && box.high[1] >= 0
                            ? 1
                            : std::max(std::cos(radians(box.low[1])), std::cos(radians(box.high[1])));
    const double least = std::min(std::cos(radians(box.low[1])), std::cos(radians(box.high[1])));
    return mercator(middle(box, 0), degrees(std::acos(std::sqrt(most * least))));
  }

  /// Lambert's projection for a box, with parallels a sixth of its height from its upper and lower end (Snyder,
  /// p. 99).
  /// \throws std::invalid_argument as `mercator()` does, and if the equator halves the box
  static Conformal_projection_2 lambert(const Box& box) {
    check(box);
    const double sixth = (box.high[1] - box.low[1]) / 6;
    return lambert(middle(box, 0), box.low[1] + sixth, box.high[1] - sixth);
  }

  /// The usual choice for a box, by the latitude of its middle: Mercator's up to 15 degrees, the stereographic one
  /// from 75 degrees, else Lambert's.
  /// \throws std::invalid_argument as `mercator()` does
  static Conformal_projection_2 for_box(const Box& box) {
    check(box);
    const double latitude = middle(box, 1);
    if (std::abs(latitude) < 15) return mercator(box);
    return std::abs(latitude) > 75 ? stereographic(middle(box, 0), latitude) : lambert(box);
  }

  Kind kind() const { return kind_; }                            ///< which one it is
  double central_longitude() const { return longitude_; }        ///< in degrees; x is 0 there
  const Place& standard_parallels() const { return parallels_; } ///< latitudes with scale 1, in degrees
  double cone_constant() const { return n_; } ///< 0 for Mercator's, 1 or -1 for the stereographic one

  /// From degrees to meters. Longitudes may go on beyond 180 degrees.
  /// \pre The latitude is in (-90, 90), and longitudes differ from the central one by less than 180 / |n| degrees.
  Place forward(double longitude, double latitude) const {
    const double l = radians(longitude - longitude_), q = isometric_difference(radians(latitude), origin_);
    if (n_ == 0) return {unit_ * l, unit_ * q};
    const double half = std::sin(n_ * l / 2), shrink = std::exp(-n_ * q);
    return {unit_ / n_ * shrink * std::sin(n_ * l),
            unit_ / n_ * (2 * shrink * half * half - std::expm1(-n_ * q))};
  }

  /// From meters to degrees: the longitude within 180 / |n| degrees of the central one.
  Place inverse(double x, double y) const {
    if (n_ == 0) return {longitude_ + degrees(x / unit_), latitude_of(y / unit_)};
    const double u = n_ * x / unit_, v = n_ * y / unit_;
    const double l = std::atan2(u, 1 - v) / n_;
    return {longitude_ + degrees(l), latitude_of(-0.5 * std::log1p(u * u + v * (v - 2)) / n_)};
  }

  /// Meters in the plane for one meter on the ground. It depends on the latitude alone.
  double scale(double latitude) const {
    const double phi = radians(latitude);
    return unit_ * std::exp(-n_ * isometric_difference(phi, origin_)) / (radius * std::cos(phi));
  }

  /// The least and the largest scale between two latitudes.
  Place scale_range(double low, double high) const {
    const double a = scale(low), b = scale(high);
    Place range{std::min(a, b), std::max(a, b)};
    const double least = degrees(std::asin(std::clamp(n_, -1., 1.))); // where its derivative is 0
    if (std::abs(n_) < 1 && low < least && least < high) range[0] = std::min(range[0], scale(least));
    return range;
  }

private:
  Conformal_projection_2(Kind kind, double longitude, Place parallels, double n, double origin)
      : kind_(kind), longitude_(longitude), parallels_(parallels), n_(n), origin_(radians(origin)) {}

  static constexpr double pi = 3.14159265358979323846;
  static double radians(double x) { return x * (pi / 180); }
  static double degrees(double x) { return x * (180 / pi); }
  static double middle(const Box& box, std::size_t i) { return box.low[i] + (box.high[i] - box.low[i]) / 2; }

  static void check_parallel(double latitude) {
    if (!(latitude > -90 && latitude < 90))
      throw std::invalid_argument("a standard parallel has to be between -90 and 90 degrees");
  }
  static void check(const Box& box) {
    if (!(box.low[1] > -90 && box.high[1] < 90 && box.low[1] <= box.high[1]))
      throw std::invalid_argument(
          "a conformal projection needs latitudes between -90 and 90 degrees, without the "
          "poles");
    if (!(box.high[0] - box.low[0] <= 360))
      throw std::invalid_argument("a conformal projection needs longitudes within 360 degrees");
  }

  /// asinh(tan(a)) - asinh(tan(b)) in radians, without cancellation.
  static double isometric_difference(double a, double b) {
    return std::asinh(2 * std::cos((a + b) / 2) * std::sin((a - b) / 2) / (std::cos(a) * std::cos(b)));
  }
  /// In degrees, from the difference of isometric latitudes. Adds a small angle to that of the origin.
  double latitude_of(double q) const {
    const double s = std::sinh(q), tan = std::tan(origin_);
    const double sum = tan * std::cosh(q) + s * std::sqrt(1 + tan * tan);
    return degrees(std::atan(sum));
  }
  /// Chooses the unit so that the scale at a latitude is 1.
  void set_scale_at(double latitude) {
    const double phi = radians(latitude);
    unit_ = radius * std::cos(phi) * std::exp(n_ * isometric_difference(phi, origin_));
  }

  Kind kind_;
  double longitude_;
  Place parallels_;
  double n_;        ///< the cone's constant
  double origin_;   ///< latitude where y is 0 on the central meridian, in radians
  double unit_ = 0; ///< meters for a radian of longitude on the parallel of the origin
};

} // namespace CGAL

#endif // CGAL_CONFORMAL_PROJECTION_2_H
