// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Merely sorting in shuffle order: what no method that sorts can be faster than by much. The standard's sort and
// the sort of our trees, of keys alone and of keys with the indices of their points.

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_FLOORS_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_FLOORS_H

#include "quadtree_run.h"

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadtree_floors {

using Traits = CGAL::Filtered_quadtree_traits_2<>;

/// The shuffles of the first bits of the coordinates in our grid.
template <int bits>
std::uint64_t short_key(const Traits::Grid_point& p) {
  static_assert(bits <= 32, "two coordinates have to fit in one word");
  constexpr int shift = Traits::depth - bits;
  return CGAL::Quadtree_mesh_2::internal::interleave(std::uint32_t(p.x >> shift),
                                                     std::uint32_t(p.y >> shift));
}

using Key_64 = std::uint64_t;
using Key_128 = std::array<std::uint64_t, 2>;

template <class Key>
using Indexed = std::pair<Key, std::uint32_t>;

inline void set_key(const Traits::Grid_point& p, Key_64& key) { key = short_key<32>(p); }
inline void set_key(const Traits::Grid_point& p, Key_128& key) {
  key[0] = short_key<32>(p);
  key[1] = CGAL::Quadtree_mesh_2::internal::interleave(std::uint32_t(p.x << 2), std::uint32_t(p.y << 2));
}

template <class Key>
std::vector<Key> keys_of(const Points& points) {
  const Traits::Grid_2 grid = Traits().construct_grid_2_object()(points);
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) set_key(grid.grid_point(points[i]), keys[i]);
  return keys;
}

/// Takes the time of `sort()`, which returns sorted keys.
template <class Sort>
Run run(const Sort& sort) {
  Run_recorder recorder;
  const auto sorted = sort();
  recorder.stop();
  recorder.set_size(sorted.size());
  if (!std::is_sorted(sorted.begin(), sorted.end())) throw std::logic_error("the floor does not sort");
  return recorder.run();
}

template <class Key>
Run sort_by_standard(const Points& points) {
  std::vector<Key> keys = keys_of<Key>(points);
  return run([&keys] {
    std::sort(keys.begin(), keys.end());
    return std::move(keys);
  });
}

template <class Key>
Run sort_indexed_by_standard(const Points& points) {
  const std::vector<Key> keys = keys_of<Key>(points);
  std::vector<Indexed<Key>> records(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) records[i] = {keys[i], std::uint32_t(i)};
  return run([&records] {
    std::sort(records.begin(), records.end());
    return std::move(records);
  });
}

/// Sorts keys as our trees do, without indices.
inline void sort(std::vector<Key_64>& keys) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  const auto buffer = internal::uncleared_words(keys.size());
  internal::Word_sorter<CGAL::Sequential_tag>::sort(keys.data(), buffer.get(), keys.size(), true);
}

inline Run sort_words(const Points& points) {
  std::vector<Key_64> keys = keys_of<Key_64>(points);
  return run([&keys] {
    sort(keys);
    return std::move(keys);
  });
}

template <class Key>
Run sort_by_keys(const Points& points) {
  const std::vector<Key> keys = keys_of<Key>(points);
  return run([&keys] {
    return CGAL::Quadtree_mesh_2::internal::sort_by_keys(keys.size(),
                                                         [&keys](std::size_t i) { return keys[i]; })
        .keys;
  });
}

inline std::vector<Method> methods() {
  const std::vector<Method::Stage> stages{{"sort", Product::SORTED_KEYS}};
  return {{"std::sort, 64 bits", stages, sort_by_standard<Key_64>},
          {"our sort, 64 bits", stages, sort_words},
          {"std::sort, 64 bits and index", stages, sort_indexed_by_standard<Key_64>},
          {"our sort, 64 bits and index", stages, sort_by_keys<Key_64>},
          {"std::sort, 128 bits and index", stages, sort_indexed_by_standard<Key_128>},
          {"our sort, 128 bits and index", stages, sort_by_keys<Key_128>}};
}

} // namespace quadtree_floors

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_FLOORS_H
