// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SPARSE_VALUES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SPARSE_VALUES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Values by handle, most of which are not set. There is memory for each run of 16 handles of which one has a value,
/// and 4 bytes for any other run. O(1) for each function.
template <class Id, class Value>
class Sparse_values {
public:
  Sparse_values() = default;
  /// \param n handles are below this
  explicit Sparse_values(std::size_t n) : place_of_run_((n + length - 1) / length, none) {}

  bool has(Id id) const { return id.value() / length < place_of_run_.size(); }

  /// A default value where none is set.
  Value operator[](Id id) const {
    const std::uint32_t place = place_of_run_[id.value() / length];
    return place == none ? Value() : runs_[place][id.value() % length];
  }

  /// Where a value is. Not for several threads at once, unless all of their handles have been asked for before.
  Value& at(Id id) {
    std::uint32_t& place = place_of_run_[id.value() / length];
    if (place == none) {
      place = static_cast<std::uint32_t>(runs_.size());
      runs_.emplace_back();
    }
    return runs_[place][id.value() % length];
  }

  /// Writes or reads them (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(place_of_run_, runs_);
  }

private:
  static constexpr std::size_t length = 16;
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  std::vector<std::uint32_t> place_of_run_;
  std::vector<std::array<Value, length>> runs_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SPARSE_VALUES_H
