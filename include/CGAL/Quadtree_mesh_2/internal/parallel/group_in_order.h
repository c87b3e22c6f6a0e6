// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_GROUP_IN_ORDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_GROUP_IN_ORDER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Consecutive values in memory.
template <class Value>
class Span {
public:
  using value_type = Value;

  Span(const Value* begin, const Value* end) : begin_(begin), end_(end) {}
  const Value* begin() const { return begin_; }
  const Value* end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  const Value& operator[](std::size_t i) const { return begin_[i]; }

private:
  const Value *begin_, *end_;
};

/// Members by group: those of group g begin at `first[g]`, and `first.back()` is the number of all.
template <class Member>
struct Groups {
  Uninitialized_vector<Member> members;
  std::vector<std::size_t> first;

  std::size_t size() const { return first.size() - 1; }
  Span<Member> operator[](std::size_t g) const {
    return {members.data() + first[g], members.data() + first[g + 1]};
  }
  /// Gives the memory of a group back to the system. Nobody may read it any more.
  void give_back(std::size_t g) { give_back_values(members, first[g], first[g + 1]); }
};

/// Returns `Member(i)` for the indices i below `n`, by `group_of(i)`, in order within each group. Indices of the group
/// `groups` are left out. O(n) work; `group_of` is called twice for each index.
/// \pre `n < 2^32`
template <class ConcurrencyTag, class Member, class Group_of>
Groups<Member> group_in_order(std::size_t n, std::size_t groups, const Group_of& group_of) {
  constexpr std::size_t block_length = std::size_t(1) << 16;
  Digit_counts<ConcurrencyTag> counts(n, block_length, groups + 1);
  counts.count(group_of);
  Groups<Member> result;
  result.first = counts.place_runs();
  result.first.pop_back();
  result.members.resize(result.first.back());
  for_each_block<ConcurrencyTag>(n, block_length, [&](std::size_t b, std::size_t begin, std::size_t end) {
    std::uint32_t* const next = counts.places(b);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t group = group_of(i);
      if (group < groups) result.members[next[group]++] = Member(i);
    }
  });
  return result;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_GROUP_IN_ORDER_H
