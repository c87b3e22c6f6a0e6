// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INDEX_H
#define CGAL_QUADTREE_MESH_2_INDEX_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Data
/// It converts explicitly from and to integers, and compares as the integer does. The default-constructed
/// index is invalid (`is_valid()` is `false`).
/// \tparam Tag distinguishes the kinds of indices.
template <class Tag>
class Index {
public:
  using size_type = std::uint32_t; ///< the integer type that it holds

  /// The invalid index.
  constexpr Index() = default;
  /// The index `i`.
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  constexpr explicit Index(Integer i) : value_(static_cast<size_type>(i)) {}

  /// The number.
  constexpr size_type value() const { return value_; }
  /// The number, for looking up arrays.
  constexpr explicit operator std::size_t() const { return value_; }
  /// Whether the index is valid.
  constexpr bool is_valid() const { return value_ != invalid_; }

  /// Advances to the next index.
  Index& operator++() {
    ++value_;
    return *this;
  }

  /// Whether the numbers are the same.
  friend constexpr bool operator==(Index a, Index b) { return a.value_ == b.value_; }
  /// Whether the numbers differ.
  friend constexpr bool operator!=(Index a, Index b) { return a.value_ != b.value_; }
  /// The order of the numbers.
  friend constexpr bool operator<(Index a, Index b) { return a.value_ < b.value_; }
  /// Writes the number.
  friend std::ostream& operator<<(std::ostream& out, Index i) { return out << i.value_; }

private:
  static constexpr size_type invalid_ = 0xffffffffu;
  size_type value_ = invalid_;
};

/// \ingroup PkgQuadtreeMesh2Data
/// Distinguishes indices of vertices.
struct Vertex_tag {};
/// \ingroup PkgQuadtreeMesh2Data
/// Distinguishes indices of segments.
struct Segment_tag {};
/// \ingroup PkgQuadtreeMesh2Data
/// Distinguishes indices of triangles.
struct Triangle_tag {};
/// \ingroup PkgQuadtreeMesh2Data
/// Distinguishes indices of nodes.
struct Node_tag {};
/// \ingroup PkgQuadtreeMesh2Data
/// Distinguishes indices of leaves.
struct Leaf_tag {};
/// \ingroup PkgQuadtreeMesh2Data
/// Distinguishes indices of points.
struct Point_tag {};

/// \ingroup PkgQuadtreeMesh2Data
/// Vertex of a `Pslg_2` or an `Indexed_mesh_2`.
using Vertex_index = Index<Vertex_tag>;
/// \ingroup PkgQuadtreeMesh2Data
/// Segment of a `Pslg_2`.
using Segment_index = Index<Segment_tag>;
/// \ingroup PkgQuadtreeMesh2Data
/// Triangle of an `Indexed_mesh_2`.
using Triangle_index = Index<Triangle_tag>;
/// \ingroup PkgQuadtreeMesh2Data
/// Node (square) of a quadtree or of a quadtree framework.
using Node_index = Index<Node_tag>;
/// \ingroup PkgQuadtreeMesh2Data
/// Leaf of a quadtree.
using Leaf_index = Index<Leaf_tag>;
/// \ingroup PkgQuadtreeMesh2Data
/// Input point, in the order in which the points were given.
using Point_index = Index<Point_tag>;

} // namespace Quadtree_mesh_2
} // namespace CGAL

/// \ingroup PkgQuadtreeMesh2Data
/// Hashes indices for unordered containers.
template <class Tag>
struct std::hash<CGAL::Quadtree_mesh_2::Index<Tag>> {
  /// The hash of the number.
  std::size_t operator()(CGAL::Quadtree_mesh_2::Index<Tag> i) const noexcept {
    return std::hash<std::uint32_t>()(i.value());
  }
};

#endif // CGAL_QUADTREE_MESH_2_INDEX_H
