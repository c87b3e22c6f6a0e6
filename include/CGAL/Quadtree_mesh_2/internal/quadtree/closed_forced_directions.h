// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Which squares of its own size a required square forces to be split, in a closed form.
//
// Computes: what `least_forced_directions()` computes from level to level, for squares that points require,
//           whatever their levels are.
// Bound:    O(n log b + k) work for n points in b blocks and k required squares; O(1) rounds over blocks and
//           log2 b short ones. Words longer than the machine's take time in proportion to their length, for
//           each point but not for each square.
// Method:   A square f is split just if it is required, or a smaller required square d is near enough: the
//           distances in x and y from the far sides of d to f, 0 where the interval of f contains that of d,
//           are less than the side of f. Across corners this holds for their maximum, across sides for their
//           sum (proof: doc/quadtrees.md). Squares in d are not farther away, so only minimal required squares
//           count, each of which has points that no other has.
//           Let s be the square of the size of f that contains d. To the east of s, f is forced just if d does
//           not touch the west side of s. That is if the level of s is less than a threshold: the level of d
//           without the zeros at the end of its column's number. The other sides are likewise, and across
//           corners a diagonal direction has the lesser threshold of its two sides. A square has the greatest
//           thresholds of the minimal squares in it, which are the same along an edge of the framework.
//           Across sides only, f to the northeast is forced just if the distances of d from the lower left
//           corner of s have a sum greater than the side of s: if adding the coordinates' bits below the
//           side's carries, and leaves more than 0. The greatest sum of the coordinates of minimal squares in s
//           decides, as those of the corner of s are the same for all of them. The other three are reflected.
// Source:   Isaac, Burstedde, Ghattas, "Low-cost parallel algorithms for 2:1 octree balance", IPDPS 2012, for a
//           test in constant time of whether two leaves may be together. Bern, Eppstein, Teng, section 5, for
//           what is kept with the framework's squares.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_CLOSED_FORCED_DIRECTIONS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_CLOSED_FORCED_DIRECTIONS_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/combine_points_of_nodes.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/forcing.h>
#include <CGAL/Quadtree_options.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A minimal required square: a point in it, its level and that of the grid's units.
template <class Word>
struct Minimal_square {
  const Grid_point_2<Word>& point;
  int level;
  int depth;
};

/// The least levels of squares around a minimal square that it touches from within, by their sides.
template <class Word>
struct Touched_levels {
  int west, east, south, north;

  explicit Touched_levels(const Minimal_square<Word>& d)
      : west(level(d.point.x, d, 0)), east(level(d.point.x, d, 1)), south(level(d.point.y, d, 0)),
        north(level(d.point.y, d, 1)) {}

private:
  static int level(const Word& coordinate, const Minimal_square<Word>& d, int bit) {
    return d.level - Word_operations<Word>::run_of_bits(coordinate, d.depth - d.level, bit, d.level);
  }
};

/// By direction, below which level squares around it a minimal square forces their neighbors, across sides and
/// corners.
template <class Word>
class Corner_forcing {
public:
  using Level = typename Word_operations<Word>::Level;
  using Value = std::array<Level, 8>;

  Value nothing() const { return Value{}; }

  Value of_square(const Minimal_square<Word>& d, std::size_t) {
    const Touched_levels<Word> touched(d);
    Value least;
    for (Direction direction : all_directions()) {
      int level = d.level;
      if (step_x(direction) != 0) level = step_x(direction) > 0 ? touched.west : touched.east;
      if (step_y(direction) != 0)
        level = std::min(level, step_y(direction) > 0 ? touched.south : touched.north);
      least[static_cast<std::size_t>(direction)] = static_cast<Level>(level);
    }
    return least;
  }

  static Value combine(const Value& a, const Value& b) {
    Value greatest;
    for (std::size_t d = 0; d < 8; ++d) greatest[d] = std::max(a[d], b[d]);
    return greatest;
  }

  static Direction_set forced(const Value& thresholds, int level) {
    unsigned set = 0;
    for (std::size_t d = 0; d < 8; ++d) set |= static_cast<unsigned>(level < thresholds[d]) << d;
    return static_cast<Direction_set>(set);
  }
};

/// The same for balance across sides only: thresholds for the sides, and for each diagonal the point of the
/// minimal square that is farthest that way.
template <class Framework>
class Side_forcing {
public:
  using Word = typename Framework::Word;
  using Level = typename Word_operations<Word>::Level;
  struct Value {
    std::array<Level, 4> thresholds;       ///< east, north, west, south
    std::array<std::uint32_t, 4> farthest; ///< northeast, northwest, southwest, southeast
  };

  explicit Side_forcing(const Framework& framework)
      : framework_(framework), sums_(framework.number_of_points()) {}

  Value nothing() const { return {{}, {{none_, none_, none_, none_}}}; }

  /// \param p the first point in the square
  Value of_square(const Minimal_square<Word>& d, std::size_t p) {
    const Touched_levels<Word> touched(d);
    const Word side = Operations::power_of_two(d.depth - d.level), root = Operations::power_of_two(d.depth);
    const Word west = Operations::without_low_bits(d.point.x, d.depth - d.level);
    const Word south = Operations::without_low_bits(d.point.y, d.depth - d.level);
    const Word east = static_cast<Word>(root - west - side), north = static_cast<Word>(root - south - side);
    Sums& sums = sums_[p];
    sums.sum = {{static_cast<Word>(west + south), static_cast<Word>(east + south),
                 static_cast<Word>(east + north), static_cast<Word>(west + north)}};
    for (std::size_t i = 0; i < 4; ++i)
      sums.zeros[i] = Operations::run_of_bits(sums.sum[i], 0, 0, d.depth + 1);
    const std::uint32_t point = static_cast<std::uint32_t>(p);
    return {{{static_cast<Level>(touched.west), static_cast<Level>(touched.south),
              static_cast<Level>(touched.east), static_cast<Level>(touched.north)}},
            {{point, point, point, point}}};
  }

  Value combine(const Value& a, const Value& b) const {
    Value greatest;
    for (std::size_t i = 0; i < 4; ++i) {
      greatest.thresholds[i] = std::max(a.thresholds[i], b.thresholds[i]);
      greatest.farthest[i] = farther(a.farthest[i], b.farthest[i], i);
    }
    return greatest;
  }

  Direction_set forced(const Value& value, int level) const {
    unsigned set = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      set |= static_cast<unsigned>(level < value.thresholds[i]) << 2 * i;
      set |= static_cast<unsigned>(value.farthest[i] != none_ && does_carry(value.farthest[i], i, level))
             << (2 * i + 1);
    }
    return static_cast<Direction_set>(set);
  }

private:
  using Operations = Word_operations<Word>;
  using Point_rank = typename Framework::Point_rank;
  static constexpr std::uint32_t none_ = Required_squares::none;

  /// Of a minimal square, by diagonal: its distances from the root's sides that lie the other way.
  struct Sums {
    std::array<Word, 4> sum;
    std::array<int, 4> zeros; ///< at the end of the sum
  };

  std::uint32_t farther(std::uint32_t p, std::uint32_t q, std::size_t diagonal) const {
    if (p == q || q == none_) return p;
    if (p == none_) return q;
    return sums_[p].sum[diagonal] < sums_[q].sum[diagonal] ? q : p;
  }

  /// Whether the sum of the parts of both distances that lie in a square of a level is greater than its side.
  /// \pre the level is less than that of the minimal square of the point
  bool does_carry(std::uint32_t p, std::size_t diagonal, int level) const {
    const int log_side = framework_.grid().depth() - level;
    const Sums& sums = sums_[p];
    if (sums.zeros[diagonal] >= log_side) return false;
    // What is carried is the difference between a bit of the sum and the sum of the bits. All bits of a distance
    // from the far side of the root are reversed, but for those below the minimal square's side.
    const Grid_point_2<Word>& point = framework_.grid_point(Point_rank(p));
    const bool is_in_root = level > 0, is_east = diagonal == 1 || diagonal == 2, is_north = diagonal >= 2;
    const bool x = (Operations::bit(point.x, log_side) != 0) != (is_east && is_in_root);
    const bool y = (Operations::bit(point.y, log_side) != 0) != (is_north && is_in_root);
    return (Operations::bit(sums.sum[diagonal], log_side) != 0) != (x != y);
  }

  const Framework& framework_;
  Uninitialized_vector<Sums> sums_; // by the first point of a minimal square
};

/// Returns for each square that the points of a framework require where it forces squares of its size.
template <class ConcurrencyTag, class Framework, class Forcing>
Uninitialized_vector<Direction_set>
closed_forced_directions(const Framework& framework, const Required_squares& squares, Forcing forcing) {
  using Value = typename Forcing::Value;
  const int depth = framework.grid().depth();
  Uninitialized_vector<Value> of_point(framework.number_of_points());
  for_each_index<ConcurrencyTag>(of_point.size(), [&](std::size_t p) { of_point[p] = forcing.nothing(); });
  squares.template for_each_with_level<ConcurrencyTag>([&](std::size_t i, int level) {
    if (squares.children[i] != 0) return;
    const std::size_t p = squares.point_begin[i][0];
    of_point[p] =
        forcing.of_square({framework.grid_point(typename Framework::Point_rank(p)), level, depth}, p);
  });
  const auto of_node = combine_points_of_nodes<Value, ConcurrencyTag>(
      framework, [&](std::size_t p) { return of_point[p]; },
      [&](const Value& a, const Value& b) { return forcing.combine(a, b); });
  Uninitialized_vector<Direction_set> forced(squares.size());
  squares.template for_each_with_level<ConcurrencyTag>([&](std::size_t i, int level) {
    const std::uint32_t node = squares.node[i];
    forced[i] = squares.children[i] == 0         ? Direction_set(0)
                : node != Required_squares::none ? forcing.forced(of_node[Node_index(node)], level)
                                                 : forcing.forced(of_point[squares.point_begin[i][0]], level);
  });
  return forced;
}

/// The same for a kind of balance.
/// \pre `balance` is not `NONE`
template <class ConcurrencyTag, class Framework>
Uninitialized_vector<Direction_set>
closed_forced_directions(const Framework& framework, const Required_squares& squares, Balance balance) {
  if (balance == Balance::SIDES)
    return closed_forced_directions<ConcurrencyTag>(framework, squares, Side_forcing<Framework>(framework));
  return closed_forced_directions<ConcurrencyTag>(framework, squares,
                                                  Corner_forcing<typename Framework::Word>());
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_CLOSED_FORCED_DIRECTIONS_H
