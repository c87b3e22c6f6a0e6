// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Words of unlimited length, for the grid coordinates of exact quadtrees.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_LONG_WORDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_LONG_WORDS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// An integer of unlimited length; up to 256 bits, which products of two coordinates mostly have, it needs no memory of
/// its own.
using Long_word = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<256>>;

/// The operations of quadtrees on words that are not negative.
template <>
struct Word_operations<Long_word> {
  using Level = std::int32_t;

  /// Corners of deep squares are as long as the tree is deep.
  static constexpr bool are_corners_stored = false;

  /// Looks at the limbs from the highest down to the first that differ; makes no third word.
  static int width_of_difference(const Long_word& x, const Long_word& y) {
    const auto& a = x.backend();
    const auto& b = y.backend();
    for (unsigned i = std::max(a.size(), b.size()); i-- > 0;) {
      const auto difference = limb(a, i) ^ limb(b, i);
      if (difference != 0) return static_cast<int>(i) * limb_bits + bit_width(std::uint64_t(difference));
    }
    return 0;
  }
  static int bit(const Long_word& w, int i) {
    return boost::multiprecision::bit_test(w, static_cast<unsigned>(i)) ? 1 : 0;
  }
  /// Looks at the limbs from the first one up to the run's end.
  static int run_of_bits(const Long_word& w, int i, int value, int most) {
    const auto& a = w.backend();
    for (int begin = i; begin - i < most; begin += limb_bits - begin % limb_bits) {
      const Limb bits = limb(a, static_cast<unsigned>(begin / limb_bits));
      const Limb others = static_cast<Limb>(value == 0 ? bits : ~bits) >> begin % limb_bits;
      if (others != 0) return std::min(most, begin - i + lowest_bit(std::uint64_t(others)));
    }
    return most;
  }
  static Long_word without_low_bits(const Long_word& w, int i) {
    Long_word result = w >> i;
    result <<= i;
    return result;
  }
  static Long_word power_of_two(int i) {
    Long_word result = 0;
    boost::multiprecision::bit_set(result, static_cast<unsigned>(i));
    return result;
  }

private:
  using Backend = Long_word::backend_type;
  using Limb = boost::multiprecision::limb_type;
  static constexpr int limb_bits = static_cast<int>(sizeof(Limb)) * 8;

  static Limb limb(const Backend& w, unsigned i) { return i < w.size() ? w.limbs()[i] : 0; }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_LONG_WORDS_H
