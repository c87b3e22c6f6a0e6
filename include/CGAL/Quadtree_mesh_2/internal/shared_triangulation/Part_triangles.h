// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Triangles of which each part has a run of handles, and what parts tell each other of those on both sides of a seam.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_PART_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_PART_TRIANGLES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The triangles of a part. Their sides have the handles of all parts.
template <class Geometry>
struct Part_triangles {
  using Triangle = typename Kernel_mesh<Geometry>::Triangle;

  Numbers first;                            ///< the first handle of each part, and the number of all
  std::size_t begin = 0;                    ///< the first handle of this part
  Uninitialized_vector<Triangle> triangles; ///< from the first on

  std::size_t size() const { return triangles.size(); }
  std::size_t number_of_all() const { return static_cast<std::size_t>(first.back()); }
  bool has(Triangle_id t) const { return begin <= t.value() && t.value() < begin + size(); }
  std::size_t place(Triangle_id t) const { return t.value() - begin; }
  /// The part that has a triangle.
  int part_of(Triangle_id t) const {
    const auto behind = std::upper_bound(first.begin(), first.end() - 1, std::int64_t(t.value()));
    return static_cast<int>(behind - first.begin()) - 1;
  }
};

/// The sides at which another part's triangles begin.
template <class Geometry>
class Seam_sides {
public:
  /// A side of this part's, and what the other part tells of the triangle across it.
  struct Seam_side {
    std::size_t triangle; ///< its place in the part
    int slot;
    std::uint32_t told;
  };

  explicit Seam_sides(const Part_triangles<Geometry>& part) : part_(part) {
    for (std::size_t i = 0; i < part.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Side o = part.triangles[i].side[k];
        if (!o.is_border() && !part.has(o.triangle())) sides_.push_back({i, k, 0});
      }
  }

  const std::vector<Seam_side>& sides() const { return sides_; }

  /// Tells others a number for each of this part's triangles at seams, and notes theirs. All parts call it.
  /// \param number called with the place of a triangle in the part
  template <class Exchange, class Number>
  void tell(Exchange& exchange, const Number& number) {
    Records_of_parts<Told> outbox;
    for (const Seam_side& s : sides_) {
      const Side o = part_.triangles[s.triangle].side[s.slot];
      outbox[part_.part_of(o.triangle())].push_back({o.triangle(), o.slot(), number(s.triangle)});
    }
    for (const Told& told : exchange_and_join(exchange, std::move(outbox))) side(told).told = told.number;
  }

private:
  /// Of the triangle across a side of the receiver's.
  struct Told {
    Triangle_id triangle; ///< of the receiver
    std::int32_t slot;
    std::uint32_t number;
  };

  const Part_triangles<Geometry>& part_;
  std::vector<Seam_side> sides_; // by triangle, and then by slot

  Seam_side& side(const Told& told) {
    const std::size_t triangle = part_.place(told.triangle);
    const auto found = std::partition_point(sides_.begin(), sides_.end(), [&](const Seam_side& s) {
      return s.triangle < triangle || (s.triangle == triangle && s.slot < told.slot);
    });
    if (found == sides_.end() || found->triangle != triangle || found->slot != told.slot)
      throw std::logic_error("parts have different seams");
    return *found;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_PART_TRIANGLES_H
