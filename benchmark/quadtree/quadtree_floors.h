// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sorting in shuffle order, by the simplest means: what no method that sorts can be faster than by much.

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_FLOORS_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_FLOORS_H

#include "quadtree_run.h"

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

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

struct Key_64 {
  static constexpr int words = 1;
  std::uint64_t word(int) const { return high; }
  friend bool operator<(const Key_64& a, const Key_64& b) { return a.high < b.high; }
  std::uint64_t high;
};

struct Key_128 {
  static constexpr int words = 2;
  std::uint64_t word(int i) const { return i == 0 ? low : high; }
  friend bool operator<(const Key_128& a, const Key_128& b) {
    return a.high != b.high ? a.high < b.high : a.low < b.low;
  }
  std::uint64_t high, low;
};

template <class Key>
struct Indexed : Key {
  std::uint32_t index;
};

inline void set_key(const Traits::Grid_point& p, Key_64& key) { key.high = short_key<32>(p); }
inline void set_key(const Traits::Grid_point& p, Key_128& key) {
  key.high = short_key<32>(p);
  key.low = CGAL::Quadtree_mesh_2::internal::interleave(std::uint32_t(p.x << 2), std::uint32_t(p.y << 2));
}

template <class Key>
void set_index(Key&, std::size_t) {}
template <class Key>
void set_index(Indexed<Key>& key, std::size_t i) {
  key.index = std::uint32_t(i);
}

template <class Record>
std::vector<Record> records_of(const Points& points) {
  const Traits::Grid_2 grid = Traits().construct_grid_2_object()(points);
  std::vector<Record> records(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    set_key(grid.grid_point(points[i]), records[i]);
    set_index(records[i], i);
  }
  return records;
}

/// Sorts by digits of `bits` bits, the least significant one first; digits that are equal in all keys are
/// left out.
template <int bits, class Record>
void radix_sort(std::vector<Record>& records) {
  constexpr int passes = (64 + bits - 1) / bits;
  constexpr std::uint64_t mask = (std::uint64_t(1) << bits) - 1;
  using Counts = std::array<std::uint32_t, std::size_t(mask) + 1>;
  std::vector<Record> buffer(records.size());
  for (int w = 0; w < Record::words; ++w) {
    std::vector<Counts> counts(passes);
    for (const Record& r : records)
      for (int p = 0; p < passes; ++p) ++counts[std::size_t(p)][(r.word(w) >> (p * bits)) & mask];
    for (int p = 0; p < passes; ++p) {
      const auto digit = [w, p](const Record& r) { return std::size_t((r.word(w) >> (p * bits)) & mask); };
      Counts& place = counts[std::size_t(p)];
      if (records.empty() || place[digit(records[0])] == records.size()) continue;
      std::uint32_t sum = 0;
      for (std::uint32_t& c : place) sum += std::exchange(c, sum);
      for (const Record& r : records) buffer[place[digit(r)]++] = r;
      records.swap(buffer);
    }
  }
}

/// With 8 bits 10^6 keys of 64 bits take as long, and longer keys half as long again.
constexpr int digit_bits = 11;

template <class Record, bool is_radix>
Run sort(const Points& points) {
  std::vector<Record> records = records_of<Record>(points);
  Run_recorder recorder;
  if constexpr (is_radix)
    radix_sort<digit_bits>(records);
  else
    std::sort(records.begin(), records.end());
  recorder.stop();
  recorder.set_size(records.size());
  if (!std::is_sorted(records.begin(), records.end())) throw std::logic_error("the floor does not sort");
  return recorder.run();
}

template <class Record>
void append_methods(const std::string& name, std::vector<Method>& methods) {
  const std::vector<Method::Stage> stages{{"sort", Product::SORTED_KEYS}};
  methods.push_back({"std::sort, " + name, stages, sort<Record, false>});
  methods.push_back({"radix sort, " + name, stages, sort<Record, true>});
}

inline std::vector<Method> methods() {
  std::vector<Method> result;
  append_methods<Key_64>("64 bits", result);
  append_methods<Indexed<Key_64>>("64 bits and index", result);
  append_methods<Key_128>("128 bits", result);
  append_methods<Indexed<Key_128>>("128 bits and index", result);
  return result;
}

} // namespace quadtree_floors

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_FLOORS_H
