// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What parts agree on to have their places in one order: the box of all, and where the order is cut.
//
// Computes: the least box of the places of all parts; the first places, in shuffle order, of runs of about the same
//           length, one for each part, by regular samples of each; and where these cut the places of this part.
// Bound:    each part tells all others up to 64 of its places, which is all that grows with the number P of parts. No
//           part gets many more than n / P + n / 64 of n distinct places.
// Source:   Shi, Schaeffer, "Parallel sorting by regular sampling", JPDC 1992.
// Deviates: parts that have more places count more, as these may differ in number. Equal places go to one part.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_AGREE_ON_ORDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_AGREE_ON_ORDER_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Place_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Doubles as integers in the same order.
inline std::int64_t ordered_bits(double value) {
  std::int64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}
inline double double_of_ordered_bits(std::int64_t bits) {
  if (bits < 0) bits = std::numeric_limits<std::int64_t>::min() - bits;
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Returns the least box that holds the boxes of all parts; empty ones count for nothing.
template <class Exchange>
Double_box agree_on_box(Exchange& exchange, const Double_box& box) {
  Numbers sides{ordered_bits(box.low[0]), ordered_bits(box.low[1]), ordered_bits(-box.high[0]),
                ordered_bits(-box.high[1])};
  exchange.min(sides);
  return {{double_of_ordered_bits(sides[0]), double_of_ordered_bits(sides[1])},
          {-double_of_ordered_bits(sides[2]), -double_of_ordered_bits(sides[3])}};
}

/// A place that stands for as many as its weight.
struct Sampled_place {
  Grid_point_2<std::uint64_t> place;
  double weight;
};

/// Returns the samples of all parts, in shuffle order.
template <class Exchange, class Place_at>
std::vector<Sampled_place> sampled_places(Exchange& exchange, std::size_t n, const Place_at& place_at) {
  constexpr std::size_t samples_of_part = 64;
  const std::size_t k = std::min(n, samples_of_part);
  Numbers numbers(2 + 2 * samples_of_part, 0);
  numbers[0] = static_cast<std::int64_t>(n), numbers[1] = static_cast<std::int64_t>(k);
  for (std::size_t s = 0; s < k; ++s) {
    const Grid_point_2<std::uint64_t> place = place_at((2 * s + 1) * n / (2 * k));
    numbers[2 + 2 * s] = static_cast<std::int64_t>(place.x);
    numbers[3 + 2 * s] = static_cast<std::int64_t>(place.y);
  }
  numbers = exchange.gather(numbers);
  std::vector<Sampled_place> samples;
  for (std::size_t at = 0; at < numbers.size(); at += 2 + 2 * samples_of_part) {
    const double weight =
        static_cast<double>(numbers[at]) / static_cast<double>(std::max<std::int64_t>(numbers[at + 1], 1));
    for (std::size_t s = at + 2; s < at + 2 + 2 * static_cast<std::size_t>(numbers[at + 1]); s += 2)
      samples.push_back(
          {{static_cast<std::uint64_t>(numbers[s]), static_cast<std::uint64_t>(numbers[s + 1])}, weight});
  }
  std::stable_sort(samples.begin(), samples.end(), [](const Sampled_place& a, const Sampled_place& b) {
    return less_shuffle(a.place, b.place);
  });
  return samples;
}

/// Returns the first of the places from `begin` on that is not before `place`; `end` if there is none.
template <class Place_at>
std::size_t first_not_before(const Grid_point_2<std::uint64_t>& place, std::size_t begin, std::size_t end,
                             const Place_at& place_at) {
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    if (less_shuffle(place_at(middle), place))
      begin = middle + 1;
    else
      end = middle;
  }
  return begin;
}

/// Returns where the places of this part are cut: the run of part `p` ends at the `p`-th of what is returned, and
/// parts for which there is none get nothing.
/// \param place_at called as `place_at(i)` for `i < n`, in shuffle order
template <class Exchange, class Place_at>
std::vector<std::size_t> sampled_cuts(Exchange& exchange, std::size_t n, const Place_at& place_at) {
  const std::vector<Sampled_place> samples = sampled_places(exchange, n, place_at);
  const auto parts = static_cast<std::size_t>(exchange.size());
  double sum = 0, before = 0;
  for (const Sampled_place& sample : samples) sum += sample.weight;
  std::vector<std::size_t> cuts;
  for (const Sampled_place& sample : samples) {
    const double middle = before + sample.weight / 2;
    before += sample.weight;
    while (cuts.size() + 1 < parts &&
           middle >= sum * static_cast<double>(cuts.size() + 1) / static_cast<double>(parts))
      cuts.push_back(first_not_before(sample.place, cuts.empty() ? 0 : cuts.back(), n, place_at));
  }
  cuts.push_back(n);
  return cuts;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_AGREE_ON_ORDER_H
