// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_POINT_ERROR_H
#define CGAL_QUADTREE_MESH_2_POINT_ERROR_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Thrown for input points from which no quadtree can be made. It names the points.
class Point_error : public std::invalid_argument {
public:
  /// What is wrong with the point.
  enum class Kind {
    /// A coordinate is not a number or infinite.
    NOT_FINITE,
    /// A coordinate exceeds what the traits can represent.
    OUT_OF_RANGE,
    /// Two distinct points fall on the same grid point: the words of the traits are too short.
    INDISTINGUISHABLE,
    /// Two points are nearer to each other than meshes of tiles allow, about 2^-45 of the extent over doubles and
    /// 2^-49 with words; or, in meshes with a least angle, than 2^-420 of the extent.
    TOO_NEAR
  };

  /// An error of one point.
  Point_error(Kind kind, Point_index point) : Point_error(kind, point, Point_index(), message(kind)) {}
  /// An error of two points.
  Point_error(Kind kind, Point_index point, Point_index other)
      : Point_error(kind, point, other, message(kind)) {}
  /// The same in the words of `reason`.
  Point_error(Kind kind, Point_index point, Point_index other, const std::string& reason)
      : std::invalid_argument(names(point, other) + ' ' + reason), kind_(kind), point_(point), other_(other),
        reason_(reason) {}
  /// A point that is out of range.
  /// \param limit what the coordinates have to be, such as "below 2^62"
  Point_error(Point_index point, const std::string& limit)
      : Point_error(Kind::OUT_OF_RANGE, point, Point_index(),
                    message(Kind::OUT_OF_RANGE) + ("; it has to be " + limit)) {}

  /// What is wrong.
  Kind kind() const { return kind_; }
  /// The point at fault, counted from 0 in the order of the input.
  Point_index point() const { return point_; }
  /// The second of two points that are indistinguishable or too near to each other; otherwise invalid.
  Point_index other() const { return other_; }
  /// The part of `what()` behind the names of the points, for callers with other names for them.
  const std::string& reason() const { return reason_; }

private:
  static std::string names(Point_index point, Point_index other) {
    if (!other.is_valid()) return "point " + std::to_string(point.value());
    return "points " + std::to_string(point.value()) + " and " + std::to_string(other.value());
  }

  static const char* message(Kind kind) {
    switch (kind) {
    case Kind::NOT_FINITE:
      return "has a coordinate that is not a finite number";
    case Kind::OUT_OF_RANGE:
      return "has a coordinate that is too large for the grid";
    case Kind::INDISTINGUISHABLE:
      break;
    case Kind::TOO_NEAR:
      return "are too near to each other: there are no squares small enough to separate them";
    }
    return "are distinct but fall on the same grid point";
  }

  Kind kind_;
  Point_index point_;
  Point_index other_;
  std::string reason_;
};

} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_POINT_ERROR_H
