// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What of the plane is meshed, decided for the pieces of its components that parts have.
//
// Computes: for each piece whether it is kept, and its region, as Domain_rule.h does for triangles.
// Bound:    O(k log k) for k pieces and pairs of them.
// Method:   Pieces that meet at a seam are one component. The level of a component is the least number of segments
//           between it and the outside, found by breadth-first search in the graph of components next to each other.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_COMPONENT_LEVELS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_COMPONENT_LEVELS_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What is known of pieces of components, which have numbers.
struct Component_graph {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  /// The place of a hole's or a region's point, by its number in the input.
  struct Seed {
    std::uint32_t number, piece;

    friend bool operator<(const Seed& s, const Seed& t) {
      return s.number < t.number || (s.number == t.number && s.piece < t.piece);
    }
  };

  std::vector<Pair> joined; ///< pieces of one component
  std::vector<Pair> beside; ///< pieces with a segment between them
  std::vector<std::uint32_t> outside;
  std::vector<Seed> holes, regions;
};

/// What becomes of a piece: not kept, kept, or kept as part of the region with this number.
enum Piece_label : std::uint32_t { PIECE_NOT_KEPT = 0xffffffffu, PIECE_WITHOUT_REGION = 0xfffffffeu };

class Component_levels {
public:
  using Rule = Quality_mesh_options_2::Domain;

  Component_levels(std::size_t number_of_pieces, Component_graph graph)
      : graph_(std::move(graph)), parent_(number_of_pieces) {
    for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = static_cast<std::uint32_t>(i);
    for (const auto& [a, b] : graph_.joined) parent_[root(a)] = root(b);
  }

  /// The label of each piece.
  std::vector<std::uint32_t> labels(Rule rule) {
    find_levels(rule == Rule::NESTING_PARITY ? most_ : 1);
    std::vector<std::uint32_t> region(parent_.size(), PIECE_WITHOUT_REGION); // by root
    std::sort(graph_.regions.begin(), graph_.regions.end());
    for (const auto& [number, piece] : graph_.regions)
      if (const std::uint32_t r = root(piece); level_[r] > 0 && region[r] == PIECE_WITHOUT_REGION)
        region[r] = number;
    std::vector<char> is_hole(parent_.size(), 0);
    for (const auto& hole : graph_.holes) is_hole[root(hole.piece)] = 1;
    std::vector<std::uint32_t> labels(parent_.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const std::uint32_t r = root(static_cast<std::uint32_t>(i));
      const bool is_kept = rule == Rule::NESTING_PARITY ? level_[r] % 2 == 1 : level_[r] > 0;
      const bool is_unmarked = rule == Rule::MARKED && region[r] == PIECE_WITHOUT_REGION;
      labels[i] = is_kept && !is_unmarked && is_hole[r] == 0 ? region[r] : std::uint32_t(PIECE_NOT_KEPT);
    }
    return labels;
  }

private:
  static constexpr std::int32_t most_ = std::numeric_limits<std::int32_t>::max();

  Component_graph graph_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::int32_t> level_; // by root

  std::uint32_t root(std::uint32_t piece) {
    while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
    return piece;
  }

  /// The levels below `most`; all that is left has the level `most`.
  void find_levels(std::int32_t most) {
    std::vector<Component_graph::Pair> beside;
    for (const auto& [a, b] : graph_.beside) {
      const std::uint32_t x = root(a), y = root(b);
      if (x != y) beside.emplace_back(x, y), beside.emplace_back(y, x);
    }
    sort_and_drop_equal(beside);
    level_.assign(parent_.size(), most);
    std::vector<std::uint32_t> last, next;
    const auto reach = [&](std::uint32_t r, std::int32_t level) {
      if (level_[r] == most) level_[r] = level, next.push_back(r);
    };
    for (const std::uint32_t piece : graph_.outside) reach(root(piece), 0);
    for (std::int32_t level = 1; level < most && !next.empty(); ++level) {
      last.swap(next), next.clear();
      for (const std::uint32_t r : last)
        for (auto p = std::lower_bound(beside.begin(), beside.end(), Component_graph::Pair{r, 0});
             p != beside.end() && p->first == r; ++p)
          reach(p->second, level);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_COMPONENT_LEVELS_H
