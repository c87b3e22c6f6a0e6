// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The linked squares of the smallest balanced quadtree, in bands of levels that are grown at the same time.
//
// Computes: the squares that `Square_grower` computes, with the same numbers, from the squares that points
//           require and the directions in which each forces its neighbors. On levels log2 n apart, the split
//           squares are found by sorting what is required and forced there. These are the tops of bands. Below
//           them squares are grown from the top down.
// Bound:    O(n log n + k) work. O(log n) rounds, whatever the depth. Words longer than the machine's take time
//           in proportion to their length for each top.
// Source:   Bern, Eppstein, Teng, Theorem 2. There are log2 n disjoint sets of such levels. The one with the
//           fewest required squares is taken, so only O(k / log n) squares are sorted.
// Method:   What the inside of a required square forces on its own level is known in a closed form
//           (closed_forced_directions.h), and the parent of what is forced is required or forced itself. So the
//           squares named on a level are all that are split there, and bands need nothing from each other.
// Deviates: the paper splits more squares, so that what is forced is known from three forced squares each.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SPACED_LEVELS_GROWER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SPACED_LEVELS_GROWER_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Band_leaves.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Linked_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Square_grower.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/closed_forced_directions.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/forcing.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/spaced_levels.h>
#include <CGAL/Quadtree_options.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Framework, class ConcurrencyTag>
class Spaced_levels_grower {
public:
  using Grower = Square_grower<Framework, ConcurrencyTag>;
  using Squares = typename Grower::Squares;

  /// \param required the squares that the points of the framework require.
  /// \param balance not `NONE`
  Spaced_levels_grower(const Framework& framework, const Required_squares& required, Balance balance)
      : framework_(framework), required_(required), balance_(balance),
        forced_(closed_forced_directions<ConcurrencyTag>(framework, required, balance)),
        depth_(framework.grid().depth()), first_level_(first_levels_of_bands()) {}

  /// Returns the squares of the quadtree.
  Squares grow() {
    if (number_of_bands() == 1) return Grower(framework_, required_, forced_).grow();
    std::vector<std::optional<Grower>> bands(number_of_bands());
    for_each_band([&](std::size_t b) {
      bands[b].emplace(framework_, required_, forced_);
      if (b == 0) {
        bands[b]->reserve(required_.size()); // for all, as the other bands are appended
        bands[b]->begin_with_root();
      } else {
        bands[b]->reserve(number_of_required(b));
        begin_with_tops(*bands[b], first_level_[b]);
      }
      grow_band(*bands[b], first_level_[b + 1]);
    });
    Squares squares = join(bands);
    for_each_band([&](std::size_t b) { bands[b].reset(); });
    Band_leaves<Squares, ConcurrencyTag>(squares, first_level_).number(framework_.number_of_points());
    return squares;
  }

private:
  using Grid_point = typename Framework::Grid_point;
  using Word = typename Framework::Word;
  using Point_rank = typename Framework::Point_rank;

  /// The root's level, levels that are log2 n apart, so chosen that they have the fewest required squares, and the
  /// number of all levels.
  std::vector<int> first_levels_of_bands() const {
    const int spacing = spacing_of_levels(framework_.number_of_points());
    const int levels = required_.number_of_levels();
    if (levels <= spacing) return {0, levels};
    const int offset = offset_of_spaced_levels<ConcurrencyTag>(required_.level_begin, spacing);
    const int second = offset > 0 ? offset : spacing;
    std::vector<int> result(static_cast<std::size_t>((levels - second + spacing - 1) / spacing) + 2, 0);
    for_each_index<ConcurrencyTag>(result.size() - 1, [&](std::size_t i) {
      result[i + 1] = std::min(levels, second + static_cast<int>(i) * spacing);
    });
    return result;
  }

  std::size_t number_of_bands() const { return first_level_.size() - 1; }

  template <class F>
  void for_each_band(const F& f) const {
    Executor<ConcurrencyTag>::run(number_of_bands(), f);
  }

  std::size_t number_of_required(std::size_t band) const {
    return required_.level_begin[std::size_t(first_level_[band + 1])] -
           required_.level_begin[std::size_t(first_level_[band])];
  }

  /// Makes the levels of a band down to level `end`, exclusive, and marks what is split there.
  static void grow_band(Grower& band, int end) {
    for (band.mark_children(); band.number_of_marks() > 0 && band.level_of_children() < end;
         band.mark_children())
      band.split_marked_children();
    // What is marked on the last level are the tops of the next band, and leaves until they are linked.
    band.for_each_child(
        [&](std::uint32_t node, std::size_t) { band.squares_.leaf_or_family_[node] = Squares::leaf_flag; });
  }

  /// \name The tops of a band
  /// A square of a level is given by its lower left corner in units of its side.
  /// @{

  Grid_point place_of_point(std::uint32_t point, int level) const {
    const Grid_point& p = framework_.grid_point(Point_rank(point));
    const int shift = depth_ - level;
    return {static_cast<Word>(p.x >> shift), static_cast<Word>(p.y >> shift)};
  }

  /// The square next to `s`; false if it is outside the root.
  static bool step(const Grid_point& s, Direction d, int level, Grid_point& neighbor) {
    const Word last = static_cast<Word>(Word_operations<Word>::power_of_two(level) - 1);
    const int dx = step_x(d), dy = step_y(d);
    if ((dx < 0 && s.x == 0) || (dx > 0 && s.x == last) || (dy < 0 && s.y == 0) || (dy > 0 && s.y == last))
      return false;
    neighbor = s;
    if (dx > 0) ++neighbor.x;
    if (dx < 0) --neighbor.x;
    if (dy > 0) ++neighbor.y;
    if (dy < 0) --neighbor.y;
    return true;
  }

  /// The squares of a level that are required or forced, in shuffle order: all split ones.
  std::vector<Grid_point> find_tops(int level) const {
    const std::uint32_t first = required_.level_begin[std::size_t(level)];
    const std::uint32_t last = required_.level_begin[std::size_t(level) + 1];
    std::vector<Grid_point> tops;
    count_allocate_and_place<ConcurrencyTag>(
        last - first,
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t i = first + begin; i < first + end; ++i)
            for_each_named(i, level, [&](const Grid_point&) { ++sum; });
          return sum;
        },
        [&](std::size_t sum) { tops.resize(sum); },
        [&](std::size_t begin, std::size_t end, std::size_t next) {
          for (std::size_t i = first + begin; i < first + end; ++i)
            for_each_named(i, level, [&](const Grid_point& s) { tops[next++] = s; });
        });
    sort<ConcurrencyTag>(tops.begin(), tops.end(), Less_shuffle());
    unique<ConcurrencyTag>(tops);
    return tops;
  }

  /// Calls `f` for a required square and those of its level that it forces.
  template <class F>
  void for_each_named(std::size_t required, int level, const F& f) const {
    const Grid_point s = place_of_point(required_.point_begin[required][0], level);
    f(s);
    for (unsigned set = forced_[required]; set != 0; set &= set - 1) {
      Grid_point neighbor;
      if (step(s, static_cast<Direction>(lowest_bit(set)), level, neighbor)) f(neighbor);
    }
  }

  static std::size_t find_top(const std::vector<Grid_point>& tops, const Grid_point& s) {
    const auto found = std::lower_bound(tops.begin(), tops.end(), s, Less_shuffle());
    return found != tops.end() && *found == s ? static_cast<std::size_t>(found - tops.begin()) : tops.size();
  }

  /// Gives a band its first level. Above it is one of squares that stand for the unknown parents, four tops
  /// each, so that tops are children as all others are.
  void begin_with_tops(Grower& band, int level) const {
    const std::vector<Grid_point> tops = find_tops(level);
    const std::size_t parents = (tops.size() + 3) / 4;
    Squares& squares = band.squares_;
    squares.resize(parents + tops.size());
    squares.level_begin_ = {0, static_cast<std::uint32_t>(parents),
                            static_cast<std::uint32_t>(parents + tops.size())};
    band.level_offset_ = level - 1;
    band.growth_.resize(tops.size());
    for_each_index<ConcurrencyTag>(tops.size(),
                                   [&](std::size_t i) { band.growth_[i].required = Required_squares::none; });
    const std::uint32_t first = required_.level_begin[std::size_t(level)];
    const std::uint32_t last = required_.level_begin[std::size_t(level) + 1];
    for_each_index<ConcurrencyTag>(last - first, [&](std::size_t i) {
      const std::size_t top = find_top(tops, place_of_point(required_.point_begin[first + i][0], level));
      band.growth_[top].required = first + static_cast<std::uint32_t>(i);
    });
    for_each_index<ConcurrencyTag>(tops.size(), [&](std::size_t i) { make_top(band, tops, i, level); });
  }

  void make_top(Grower& band, const std::vector<Grid_point>& tops, std::size_t i, int level) const {
    Squares& squares = band.squares_;
    const std::size_t node = 1 + i, family = (tops.size() + 3) / 4 + i;
    squares.leaf_or_family_[node] = static_cast<std::uint32_t>(family);
    squares.node_[family] = static_cast<std::uint32_t>(node);
    squares.family_level_[family] = static_cast<typename Squares::Level>(level);
    const int shift = depth_ - level;
    const Grid_point corner{static_cast<Word>(tops[i].x << shift), static_cast<Word>(tops[i].y << shift)};
    if constexpr (Squares::are_corners_stored) squares.corner_[family] = corner;
    for (Direction d : all_directions()) {
      Grid_point neighbor;
      std::size_t n = tops.size();
      if (step(tops[i], d, level, neighbor)) n = find_top(tops, neighbor);
      squares.neighbors_[family][std::size_t(d)] =
          n < tops.size() ? static_cast<std::uint32_t>(1 + n) : Node_index().value();
    }
    squares.point_begin_[node] = first_point_from(corner);
    band.growth_[i].point_end = end_of_points(squares.point_begin_[node], corner, level);
    const auto begins =
        band.points_.child_begins(level, squares.point_begin_[node], band.growth_[i].point_end);
    std::copy(begins.begin(), begins.end(), &squares.point_begin_[4 * family + 1]);
  }

  /// The first rank from `begin` on for which `is_before` is false.
  template <class Is_before>
  std::uint32_t first_rank(std::size_t begin, const Is_before& is_before) const {
    std::size_t end = framework_.number_of_points();
    while (begin < end) {
      const std::size_t middle = begin + (end - begin) / 2;
      if (is_before(framework_.grid_point(Point_rank(middle))))
        begin = middle + 1;
      else
        end = middle;
    }
    return static_cast<std::uint32_t>(begin);
  }
  std::uint32_t first_point_from(const Grid_point& corner) const {
    return first_rank(0, [&](const Grid_point& p) { return less_shuffle(p, corner); });
  }
  std::uint32_t end_of_points(std::uint32_t begin, const Grid_point& corner, int level) const {
    return first_rank(
        begin, [&](const Grid_point& p) { return level_of_derived_square(p, corner, depth_) >= level; });
  }

  /// @}

  /// \name Joining bands
  /// Levels of different bands are disjoint, so the numbers of one band follow those of the one above.
  /// @{

  /// Appends all bands to the first one, and takes it.
  Squares join(std::vector<std::optional<Grower>>& bands) const {
    Squares& result = bands[0]->squares_;
    const auto tops = [&](std::size_t b) { // the band's first family that is not a stand-in
      return b == 0 ? std::size_t(0) : std::size_t(bands[b]->squares_.level_begin(1));
    };
    std::vector<std::size_t> base(bands.size() + 1, 0); // of the band's families in the result
    for_each_index<ConcurrencyTag>(
        bands.size(), [&](std::size_t b) { base[b] = bands[b]->squares_.number_of_families() - tops(b); });
    exclusive_scan<ConcurrencyTag>(base.data(), base.size());
    result.resize(base.back());
    for_each_band([&](std::size_t b) {
      if (b > 0) copy_band(bands[b]->squares_, tops(b), base[b], result);
    });
    for_each_band([&](std::size_t b) {
      if (b + 1 < bands.size()) link_tops(*bands[b], tops(b), base[b], base[b + 1], result);
    });
    // From here on the first band is the result.
    result.level_begin_.resize(std::size_t(first_level_.back()) + 1);
    for_each_band([&](std::size_t b) {
      for (int l = 1; b > 0 && l < bands[b]->squares_.number_of_split_levels(); ++l)
        result.level_begin_[std::size_t(first_level_[b] + l)] =
            static_cast<std::uint32_t>(base[b] + bands[b]->squares_.level_begin(l + 1) - tops(b));
    });
    link_neighbors(result);
    return std::move(result);
  }

  /// Finds the cross pointers of tops, whose parents were made in another band. Across corners the split children
  /// of a top have all neighbors in the band. Across sides a corner may touch a leaf as large as the top. The
  /// parents of tops are no tops, nor children of tops, unless of the root, as levels are three apart.
  void link_neighbors(Squares& result) const {
    for (int depth = 0; depth < (balance_ == Balance::SIDES ? 2 : 1); ++depth)
      for_each_band([&](std::size_t b) {
        const int level = first_level_[b] + depth;
        if (b > 0 && level < first_level_[b + 1])
          link_neighbors(result.level_begin(level), result.level_begin(level + 1), result);
      });
  }

  /// Finds the cross pointers of families from those of their parents.
  static void link_neighbors(std::uint32_t begin, std::uint32_t end, Squares& result) {
    for_each_index<ConcurrencyTag>(end - begin, [&](std::size_t i) {
      result.neighbors_[begin + i] = result.neighbors(Node_index(result.node_[begin + i]));
    });
  }

  /// Copies the families of a band from number `first` on to those from number `base` on.
  static void copy_band(const Squares& band, std::size_t first, std::size_t base, Squares& result) {
    const auto moved_node = [&](std::uint32_t node) {
      return node == Node_index().value() ? node : static_cast<std::uint32_t>(node + 4 * base - 4 * first);
    };
    for_each_index<ConcurrencyTag>(band.number_of_families() - first, [&](std::size_t i) {
      const std::size_t from = first + i, to = base + i;
      result.node_[to] = moved_node(band.node_[from]);
      result.family_level_[to] = band.family_level_[from];
      if constexpr (Squares::are_corners_stored) result.corner_[to] = band.corner_[from];
      for (std::size_t d = 0; d < 8; ++d) result.neighbors_[to][d] = moved_node(band.neighbors_[from][d]);
      for (std::size_t q = 1; q <= 4; ++q) {
        const std::uint32_t child = band.leaf_or_family_[4 * from + q];
        result.leaf_or_family_[4 * to + q] =
            (child & Squares::leaf_flag) != 0 ? child : static_cast<std::uint32_t>(child + base - first);
        result.point_begin_[4 * to + q] = band.point_begin_[4 * from + q];
      }
    });
  }

  /// Links the marked children of a band's last level to the tops of the next band: both are in shuffle order.
  static void link_tops(Grower& band, std::size_t first, std::size_t base, std::size_t next_base,
                        Squares& result) {
    band.for_each_child([&](std::uint32_t node, std::size_t i) {
      const std::uint32_t f = static_cast<std::uint32_t>(next_base + i);
      const std::uint32_t moved = static_cast<std::uint32_t>(node + 4 * base - 4 * first);
      result.leaf_or_family_[moved] = f;
      result.node_[f] = moved;
    });
  }

  /// @}

  const Framework& framework_;
  const Required_squares& required_;
  Balance balance_;
  Uninitialized_vector<Direction_set> forced_;
  int depth_;
  std::vector<int> first_level_; // of each band, and the number of levels
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SPACED_LEVELS_GROWER_H
