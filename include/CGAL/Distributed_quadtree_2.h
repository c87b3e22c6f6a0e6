// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The quadtree of points that are spread over the ranks of an MPI communicator.
//
// Computes: the leaves of `Balanced_quadtree` of all points, in its order and with its numbers. Each rank has a run of
//           them, and the points in these; also the leaves of others around them, and the squares of the framework.
// Bound:    a rank with k points and leaves takes O(k log k) time. Points move three times: to their place in the
//           order, to where their leaf is, and to where balanced leaves are as many as elsewhere. What is gathered of
//           all ranks are some numbers of each of them, not of points.
// Source:   Bern, Eppstein, Teng, Theorems 1 and 2; Burstedde, Wilcox, Ghattas, "p4est: scalable algorithms for
//           parallel adaptive mesh refinement on forests of octrees", SIAM J. Sci. Comput. 2011.
// Deviates: p4est has 29 levels, the grid 62. Below level 29 squares are split and balanced by the points' rank
//           (Deep_squares.h), and what this forces on other squares is told to their ranks before p4est balances.

#ifndef CGAL_DISTRIBUTED_QUADTREE_2_H
#define CGAL_DISTRIBUTED_QUADTREE_2_H

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/Distributed_point_error.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Coarse_square.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Deep_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Framework_part.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/P4est_forest.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Point_order.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Separating_leaves.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_options.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Distributed
/// A leaf of another rank that shares a side or a corner, or parts of them, with leaves of this one.
struct Ghost_leaf {
  Quadtree_square_2<std::uint64_t> square; ///< in the grid
  std::int64_t number;                     ///< counted over all ranks
  int owner;                               ///< the rank that has it
};

/// \ingroup PkgQuadtreeMesh2Distributed
/// Points of a rank that follow each other in shuffle order, by their local numbers.
struct Local_interval {
  std::size_t begin; ///< the first point
  std::size_t end;   ///< one past the last

  /// The number of points.
  std::size_t size() const { return end - begin; }
};

/// \ingroup PkgQuadtreeMesh2Distributed
/// What a rank has sent while the quadtree was made, besides what p4est sends.
struct Distributed_traffic {
  std::size_t messages;    ///< to other ranks
  std::size_t bytes;       ///< in these
  std::size_t collectives; ///< sums, scans and gathered numbers, in which all ranks take part
};

} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Distributed
/// The quadtree of points of all ranks of an MPI communicator.
///
/// Its leaves are those of `Balanced_quadtree` for the points of all ranks, one rank after the other, with the same
/// squares, points and numbers. Each rank has a run of leaves that follow each other in shuffle order. Local numbers
/// begin at 0; numbers over all ranks have 64 bits, and are the same for any number of ranks. Which rank has a leaf
/// depends on their number.
///
/// A rank needs memory for its slice of the input, then for its points and leaves, of which ranks have about the same
/// number. Points of one square of level 29 are at one rank. That rank needs memory for all of them, so a cluster
/// should not have too many points within 2^-29 of the grid's side.
///
/// All ranks have to call the functions that are marked as collective, in the same order. Others send nothing.
/// \tparam Traits_ `Filtered_quadtree_traits_2` over some kernel.
template <class Traits_ = Filtered_quadtree_traits_2<>>
class Distributed_quadtree_2 {
public:
  /// \name Types
  /// @{

  /// The traits.
  using Traits = Traits_;
  /// A point of the input.
  using Point_2 = typename Traits::Point_2;
  /// Maps points to the grid and back.
  using Grid_2 = typename Traits::Grid_2;
  /// A point of the grid.
  using Grid_point = Quadtree_mesh_2::Grid_point_2<std::uint64_t>;
  /// A square of the grid.
  using Square = Quadtree_mesh_2::Quadtree_square_2<std::uint64_t>;
  /// A leaf of another rank.
  using Ghost_leaf = Quadtree_mesh_2::Ghost_leaf;
  /// Local points that follow each other.
  using Local_interval = Quadtree_mesh_2::Local_interval;
  /// Two equal points of the input.
  using Duplicate_point = Quadtree_mesh_2::Distributed_duplicate_point;
  /// A square of the framework.
  using Framework_square = Quadtree_mesh_2::Distributed_framework_square;
  /// What a rank sends.
  using Traffic = Quadtree_mesh_2::Distributed_traffic;
  /// @}

  /// Builds the quadtree. Collective.
  /// \param comm the communicator, of which a copy is made
  /// \param slice the points of this rank. Points of all ranks are counted one rank after the other. It may be empty.
  /// \param options as for `Balanced_quadtree`; the schedule does not matter
  /// \param traits makes the grid
  /// \tparam PointRange a random access range with value type `Point_2`.
  /// \throws Quadtree_mesh_2::Distributed_point_error at all ranks as `Quadtree_framework` throws `Point_error` for the
  /// points of all ranks, with the same kind, points and reason
  /// \throws std::length_error if a rank has 2^32 points or more
  template <class PointRange>
  Distributed_quadtree_2(MPI_Comm comm, const PointRange& slice,
                         const Quadtree_options& options = Quadtree_options(),
                         const Traits& traits = Traits())
      : exchange_(std::make_unique<Exchange>(comm)), options_(options) {
    CGAL_precondition(options.max_points_per_leaf() >= 1);
    namespace internal = Quadtree_mesh_2::internal;
    order_ = internal::Point_sorter<Traits, Exchange>(*exchange_, traits).sort(slice);
    {
      const internal::Separating_leaves<Traits, Exchange> separating(*exchange_, order_,
                                                                     options_.max_points_per_leaf());
      const auto& leaves = separating.leaves();
      forest_ = std::make_unique<internal::P4est_forest>(
          exchange_->communicator(), leaves, exchange_->gather(static_cast<std::int64_t>(leaves.size())));
    }
    balance();
    partition();
    list_leaves();
    number();
    find_ghosts();
  }

  /// \name The input
  /// @{

  /// The options it was built with.
  const Quadtree_options& options() const { return options_; }
  /// The map between points and the grid; the same at all ranks.
  const Grid_2& grid() const { return order_.grid; }
  /// The number of points of all ranks, including equal ones.
  std::int64_t number_of_input_points() const { return order_.number_of_input_points; }
  /// The points of this rank's slice that equal earlier points of any slice, by index.
  const std::vector<Duplicate_point>& duplicates() const { return order_.duplicates; }
  /// @}

  /// \name Points
  /// The points in the leaves of this rank, each once, in shuffle order.
  /// @{

  /// The number of points at this rank.
  std::size_t number_of_points() const { return order_.points.size(); }
  /// The number of distinct points of all ranks.
  std::int64_t number_of_all_points() const { return order_.begins.back(); }
  /// The number over all ranks, in shuffle order, of the first point of this one. Others follow.
  std::int64_t first_point() const { return order_.begins[static_cast<std::size_t>(rank())]; }
  /// Point `i` of this rank.
  Point_2 point(std::size_t i) const { return Point_2(order_.points[i].x, order_.points[i].y); }
  /// The place of point `i` of this rank on the grid.
  const Grid_point& grid_point(std::size_t i) const { return order_.points[i].place; }
  /// The number in the input, over all ranks, of point `i` of this rank: of the first one of equal points.
  std::int64_t input_index(std::size_t i) const { return order_.points[i].index; }
  /// @}

  /// \name Leaves
  /// @{

  /// The number of leaves of this rank; may be 0.
  std::size_t number_of_leaves() const { return leaves_.size(); }
  /// The number of leaves of all ranks.
  std::int64_t number_of_all_leaves() const { return number_of_all_leaves_; }
  /// The number over all ranks, in shuffle order, of the first leaf of this one. Others follow.
  std::int64_t first_leaf() const { return first_leaf_; }
  /// The level of the smallest leaves of all ranks.
  int depth() const { return depth_; }
  /// Leaf `l` of this rank.
  const Square& square(std::size_t l) const { return leaves_[l]; }
  /// The lower left, lower right, upper right and upper left corners of leaf `l` of this rank.
  std::array<Point_2, 4> corners(std::size_t l) const {
    const Square& s = leaves_[l];
    const std::uint64_t side = Quadtree_mesh_2::internal::side_of_level(s.level);
    return {{grid().point({s.x, s.y}), grid().point({s.x + side, s.y}),
             grid().point({s.x + side, s.y + side}), grid().point({s.x, s.y + side})}};
  }
  /// The points in leaf `l` of this rank.
  Local_interval points(std::size_t l) const { return {point_begin_[l], point_begin_[l + 1]}; }

  /// The leaves of other ranks that touch leaves of this one, by number.
  const std::vector<Ghost_leaf>& ghosts() const { return ghosts_; }

  /// The rank whose leaf contains `p`, which need not be a point of the input; -1 outside the root. Takes O(log P) time
  /// for P ranks.
  int owner(const Point_2& p) const {
    if (!grid().is_in_root(p)) return -1;
    return forest_->owner(Quadtree_mesh_2::internal::coarse_code(grid().grid_point(p)));
  }
  /// Whether a leaf of this rank contains `p`.
  bool is_local(const Point_2& p) const { return owner(p) == rank(); }
  /// The leaf of this rank that contains `p`. Takes O(log k) time for k leaves.
  /// \pre `is_local(p)`
  std::size_t locate(const Point_2& p) const {
    CGAL_precondition(is_local(p));
    const Grid_point place = grid().grid_point(p);
    const auto behind =
        std::upper_bound(leaves_.begin(), leaves_.end(), place, [](const Grid_point& g, const Square& s) {
          return Quadtree_mesh_2::internal::less_shuffle(g, Grid_point{s.x, s.y});
        });
    return static_cast<std::size_t>(behind - leaves_.begin()) - 1;
  }
  /// @}

  /// \name Across ranks
  /// @{

  /// The number of this rank.
  int rank() const { return exchange_->rank(); }
  /// The number of ranks.
  int number_of_ranks() const { return exchange_->size(); }
  /// The squares of the framework (Theorem 1) whose first point this rank has, in preorder. One rank after the other
  /// they are those of `Quadtree_framework`. Collective. Takes O(k) time for k points of a rank, and about log2 P
  /// messages for each of P ranks.
  std::vector<Framework_square> framework() {
    return Quadtree_mesh_2::internal::Framework_part_finder<Traits, Exchange>(*exchange_, order_).find();
  }
  /// What this rank has sent so far, without what p4est sends.
  Traffic traffic() const {
    const auto& sent = exchange_->traffic();
    return {sent.messages, sent.bytes, sent.collectives};
  }
  /// The squares down to level 29, in which deeper leaves are not split, as p4est has them. Its x is our y, and its y
  /// our x. Coordinates are those of the grid without their lower 32 bits.
  const p4est_t* forest() const { return forest_->get(); }
  /// @}

private:
  using Exchange = Quadtree_mesh_2::internal::Mpi_exchange;
  using Coarse_square = Quadtree_mesh_2::internal::Coarse_square;
  using Coarse_code = Quadtree_mesh_2::internal::Coarse_code;

  /// Sends squares to the ranks that have their lower left corners, and returns those that arrive, in preorder.
  std::vector<Square> moved_squares(const std::vector<Square>& squares) {
    namespace internal = Quadtree_mesh_2::internal;
    internal::Records_of_parts<Square> outbox;
    for (const Square& s : squares) outbox[forest_->owner(internal::coarse_code(s))].push_back(s);
    std::vector<Square> result = internal::exchange_and_join(*exchange_, std::move(outbox));
    internal::sort_and_unify(result);
    return result;
  }

  /// The split squares of level 28 and below for which level 29 has too many points.
  std::vector<Square> squares_split_by_points() const {
    namespace internal = Quadtree_mesh_2::internal;
    internal::Deep_squares_finder finder(order_.points, options_.max_points_per_leaf(), options_.balance());
    for (std::size_t i = 0, first = 0; i < forest_->size(); ++i) {
      const Coarse_square s = forest_->square(i);
      if (s.level != internal::last_coarse_level) continue;
      first = internal::first_point_from(order_.points, first, s.code);
      finder.add(first, internal::first_point_from(order_.points, first, s.end()));
    }
    return finder.find();
  }

  void balance() {
    namespace internal = Quadtree_mesh_2::internal;
    deep_ = moved_squares(squares_split_by_points());
    std::vector<Coarse_code> wanted; // of level 28, in order
    const auto behind = std::stable_partition(
        deep_.begin(), deep_.end(), [](const Square& s) { return s.level >= internal::last_coarse_level; });
    for (auto s = behind; s != deep_.end(); ++s) wanted.push_back(internal::coarse_code(*s));
    deep_.erase(behind, deep_.end());
    forest_->refine([&](const Coarse_square& s) {
      const auto first = std::lower_bound(wanted.begin(), wanted.end(), s.code);
      return s.level < internal::last_coarse_level && first != wanted.end() && *first < s.end();
    });
    forest_->balance(options_.balance());
  }

  /// Leaves count as much as points.
  void partition() {
    namespace internal = Quadtree_mesh_2::internal;
    forest_->partition([this](const Coarse_square& s) {
      const std::size_t first = internal::first_point_from(order_.points, 0, s.code);
      return 1 + internal::first_point_from(order_.points, first, s.end()) - first;
    });
    order_.points = internal::moved_points(*exchange_, std::move(order_.points), order_.grid,
                                           [this](Coarse_code code) { return forest_->owner(code); });
    deep_ = moved_squares(deep_);
  }

  bool contains(const Square& s, const Grid_point& p) const {
    const int shift = Quadtree_mesh_2::internal::fine_depth - s.level;
    return p.x >> shift == s.x >> shift && p.y >> shift == s.y >> shift;
  }

  /// Appends the leaves in a square. Split squares below level 29 come in preorder, as this asks for them.
  void append_leaves(const Square& s, std::size_t& next_deep) {
    namespace internal = Quadtree_mesh_2::internal;
    if (next_deep < deep_.size() && deep_[next_deep] == s) {
      ++next_deep;
      const std::uint64_t side = internal::side_of_level(s.level + 1);
      for (unsigned q = 0; q < 4; ++q)
        append_leaves({s.x + (q / 2) * side, s.y + (q % 2) * side, s.level + 1}, next_deep);
      return;
    }
    leaves_.push_back(s);
    std::size_t behind = point_begin_.back();
    while (behind < order_.points.size() && contains(s, order_.points[behind].place)) ++behind;
    point_begin_.push_back(behind);
  }

  void list_leaves() {
    namespace internal = Quadtree_mesh_2::internal;
    const std::size_t n = forest_->size() + 3 * deep_.size();
    leaves_.reserve(n), point_begin_.reserve(n + 1), leaf_begin_.reserve(forest_->size() + 1);
    point_begin_.assign(1, 0);
    std::size_t next_deep = 0;
    for (std::size_t i = 0; i < forest_->size(); ++i) {
      leaf_begin_.push_back(leaves_.size());
      append_leaves(internal::fine_square(forest_->square(i)), next_deep);
    }
    leaf_begin_.push_back(leaves_.size());
    std::vector<Square>().swap(deep_);
  }

  void number() {
    order_.begins.assign(1, 0);
    for (const std::int64_t n : exchange_->gather(static_cast<std::int64_t>(order_.points.size())))
      order_.begins.push_back(order_.begins.back() + n);
    const std::int64_t n = static_cast<std::int64_t>(leaves_.size());
    first_leaf_ = exchange_->exclusive_scan(n);
    number_of_all_leaves_ = exchange_->sum(n);
    std::int64_t depth = 0;
    for (const Square& s : leaves_) depth = std::max<std::int64_t>(depth, s.level);
    depth_ = static_cast<int>(exchange_->max(depth));
  }

  void find_ghosts() {
    namespace internal = Quadtree_mesh_2::internal;
    internal::Records_of_parts<Ghost_leaf> outbox;
    for (const internal::Mirrors& mirrors : forest_->mirrors())
      for (const std::size_t i : mirrors.squares)
        for (std::size_t l = leaf_begin_[i]; l < leaf_begin_[i + 1]; ++l)
          outbox[mirrors.part].push_back({leaves_[l], first_leaf_ + static_cast<std::int64_t>(l), rank()});
    for (const Ghost_leaf& leaf : internal::exchange_and_join(*exchange_, std::move(outbox)))
      if (touches_local_leaf(leaf.square)) ghosts_.push_back(leaf);
  }

  /// A square of p4est touches, or it would not have come. Leaves below level 29 have neighbors of their size in
  /// squares of that level, which are not cut between ranks.
  bool touches_local_leaf(const Square& s) const {
    namespace internal = Quadtree_mesh_2::internal;
    if (s.level <= internal::last_coarse_level) return true;
    const std::uint64_t side = internal::side_of_level(s.level), end = internal::side_of_level(0);
    for (const Quadtree_mesh_2::Direction d : Quadtree_mesh_2::all_directions()) {
      const std::uint64_t x = s.x + static_cast<std::uint64_t>(step_x(d)) * side,
                          y = s.y + static_cast<std::uint64_t>(step_y(d)) * side;
      if (x < end && y < end && forest_->owner(internal::coarse_code(Grid_point{x, y})) == rank())
        return true;
    }
    return false;
  }

  std::unique_ptr<Exchange> exchange_;
  Quadtree_options options_;
  Quadtree_mesh_2::internal::Ordered_points<Traits> order_;
  std::unique_ptr<Quadtree_mesh_2::internal::P4est_forest> forest_;
  std::vector<Square> deep_; // the split squares of level 29 and below, until leaves are listed

  std::vector<Square> leaves_;
  std::vector<std::size_t> point_begin_; // by leaf, and behind all
  std::vector<std::size_t> leaf_begin_;  // by square of the forest, and behind all
  std::int64_t first_leaf_ = 0, number_of_all_leaves_ = 0;
  int depth_ = 0;
  std::vector<Ghost_leaf> ghosts_;
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_QUADTREE_2_H
