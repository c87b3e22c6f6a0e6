// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_DISTRIBUTED_POINT_ERROR_H
#define CGAL_QUADTREE_MESH_2_DISTRIBUTED_POINT_ERROR_H

#include <CGAL/Quadtree_mesh_2/Point_error.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Distributed
/// As `Point_error`, of points that have numbers of 64 bits: they are counted over all ranks. All ranks throw the same.
class Distributed_point_error : public std::invalid_argument {
public:
  /// What is wrong with the points.
  using Kind = Point_error::Kind;

  /// An error of one point or of two.
  /// \param kind what is wrong
  /// \param point the point at fault
  /// \param other a second one, or -1
  /// \param reason what is said behind their names
  Distributed_point_error(Kind kind, std::int64_t point, std::int64_t other, const std::string& reason)
      : std::invalid_argument((other < 0
                                   ? "point " + std::to_string(point)
                                   : "points " + std::to_string(point) + " and " + std::to_string(other)) +
                              ' ' + reason),
        kind_(kind), point_(point), other_(other), reason_(reason) {}

  /// What is wrong.
  Kind kind() const { return kind_; }
  /// The point at fault, counted from 0 in the order of the input.
  std::int64_t point() const { return point_; }
  /// The second of two points that are indistinguishable; otherwise -1.
  std::int64_t other() const { return other_; }
  /// The part of `what()` behind the names of the points.
  const std::string& reason() const { return reason_; }

private:
  Kind kind_;
  std::int64_t point_, other_;
  std::string reason_;
};

} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_DISTRIBUTED_POINT_ERROR_H
