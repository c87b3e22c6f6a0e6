// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_VERTEX_CERTIFICATES_H
#define QUADTREE_MESH_2_TEST_VERTEX_CERTIFICATES_H

// What is proven here, in exact arithmetic, for every vertex amid 7 x 7 equal leaves whose edges stand in columns of
// that width, up to nine of them: each sector of at least 33 degrees whose other side has at least as many, and the
// surroundings of an only edge, have a triangulation with all angles at least 20.7 degrees for one of the three pairs
// of thresholds, up to the strips along edges that column_certificates.h is about. doc/guarantees.md says why no angle
// of the mesh is smaller.
//
// How: branch and bound over boxes of (x, y, m1, m2): the vertex's place and the slopes of both edges, for pairs of
// octants. The symmetries of the square leave 14 kinds. In each box one of the pairs of thresholds has to be good for
// all parameters.
// - Whether a corner is dropped follows from the signs of polynomials. What stays open is tried both ways.
// - For each choice some triangulation is found and kept for the whole box: coordinates are polynomials of degree one
//   in each parameter, angles are bounded by polynomials of degree two.

#include "sector_meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <vector>

namespace vertex_certificates {

/// In hundredths: of 32.998 degrees.
constexpr std::int64_t cotangent_of_least_sector = 154;

/// Looks for a rule that is good for all sectors of a box.
class Sector_certifier {
public:
  Sector_certifier(const Sector_box& sector, const Angle_bound& bound)
      : region_(sector), vertices_(sector, region_), mesh_(sector, region_, vertices_), bound_(bound) {}

  bool is_good(const Thresholds& t) {
    const std::size_t n = vertices_.all().size();
    std::vector<char> is_kept(n, 1), is_certain(n, 1);
    open_.clear();
    for (std::size_t v = vertices_.number_on_edges(); v < n; ++v) {
      const auto kept = vertices_.is_kept(v, t);
      if (!kept) return false;
      is_kept[v] = is_certain[v] = *kept == Answer::YES ? 1 : 0;
      if (*kept == Answer::OPEN && mesh_.belongs_to_region(vertices_.all()[v])) open_.push_back({v});
    }
    if (open_.size() > max_open) return false;
    const auto base = mesh_.triangulate(is_kept, is_certain);
    if (!base || !are_above(*base)) return false;
    return certify_groups(*base, is_kept, is_certain);
  }

private:
  using Group = std::vector<std::size_t>;
  static constexpr std::size_t max_open = 12, max_group = 6;

  /// Corners whose presence is open are tried in all combinations, but in groups: where those of a group replace other
  /// triangles than those of other groups do, any combination gives a triangulation.
  bool certify_groups(const Triangles& base, std::vector<char>& is_kept,
                      const std::vector<char>& is_certain) {
    std::vector<Group> groups = open_;
    for (;;) {
      std::vector<Triangles> replaced;
      for (const Group& g : groups) {
        if (g.size() > max_group) return false;
        Triangles all;
        for (unsigned choice = 1; choice < 1u << g.size(); ++choice) {
          for (std::size_t i = 0; i < g.size(); ++i) is_kept[g[i]] = choice >> i & 1u ? 1 : 0;
          const auto triangles = mesh_.triangulate(is_kept, is_certain);
          for (const std::size_t v : g) is_kept[v] = 0;
          if (!triangles || !are_above(*triangles)) return false;
          std::set_difference(base.begin(), base.end(), triangles->begin(), triangles->end(),
                              std::back_inserter(all));
        }
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        replaced.push_back(all);
      }
      if (!merge(groups, replaced)) return true;
    }
  }

  static bool merge(std::vector<Group>& groups, const std::vector<Triangles>& replaced) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        Triangles common;
        std::set_intersection(replaced[i].begin(), replaced[i].end(), replaced[j].begin(), replaced[j].end(),
                              std::back_inserter(common));
        if (common.empty()) continue;
        groups[j].insert(groups[j].end(), groups[i].begin(), groups[i].end());
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
      }
    return false;
  }

  bool are_above(const Triangles& triangles) {
    return std::all_of(triangles.begin(), triangles.end(), [&](const std::array<std::size_t, 3>& t) {
      const auto found = known_.find(t);
      if (found != known_.end()) return found->second;
      const auto& v = vertices_.all();
      return known_[t] = is_certainly_above(bound_, v[t[0]].place, v[t[1]].place, v[t[2]].place);
    });
  }

  const Sector_region region_;
  const Sector_vertices vertices_;
  Sector_mesh mesh_;
  Angle_bound bound_;
  std::vector<Group> open_;
  std::map<std::array<std::size_t, 3>, bool> known_;
};

struct Certificate {
  bool is_proven = true;
  std::size_t boxes = 0, tests = 0;
  int depth = 0;

  void add(const Certificate& other) {
    is_proven = is_proven && other.is_proven;
    boxes += other.boxes;
    tests += other.tests;
    depth = std::max(depth, other.depth);
  }
};

struct Sector_kind {
  Octants octants;
  Turn turn;
};

/// One for each class of kinds that the symmetries of the square map to each other.
inline const std::vector<Sector_kind>& sector_kinds() {
  constexpr Turn less = Turn::LESS_THAN_HALF;
  static const std::vector<Sector_kind> kinds{{{0, 0}, less},
                                              {{0, 1}, less},
                                              {{1, 2}, less},
                                              {{0, 2}, less},
                                              {{0, 3}, less},
                                              {{1, 4}, less},
                                              {{0, 4}, less},
                                              {{0, 5}, less},
                                              {{1, 6}, less},
                                              {{0, 6}, less},
                                              {{0, 7}, less},
                                              {{1, 0}, less},
                                              {{0, 0}, Turn::ALMOST_FULL},
                                              {{0, 0}, Turn::FULL}};
  return kinds;
}

/// Divided by halves so many times, parameter by parameter in turn.
struct Deep_box {
  Sector_parameters box;
  int depth;
};

/// All parameters are eighths at first, so that no box has a quarter inside.
constexpr std::int64_t side_of_roots = grid / 8;

/// That of a root by its place in x, y, and the slopes.
inline Deep_box root_box(const std::array<std::int64_t, 4>& place) {
  Deep_box root{{}, 0};
  for (std::size_t d = 0; d < 4; ++d) {
    root.box.low[d] = place[d] * side_of_roots;
    root.box.side[d] = side_of_roots;
  }
  return root;
}

/// Divides a box until in each part one of the rules is good, if possible.
inline Certificate certify(const Sector_kind& kind, const Deep_box& root,
                           const std::vector<Thresholds>& rules, const Angle_bound& bound) {
  Certificate result;
  std::vector<Deep_box> left{root};
  while (!left.empty()) {
    Deep_box b = left.back();
    left.pop_back();
    const Sector_box sector(kind.octants, kind.turn, b.box);
    if (sector.is_at_least(cotangent_of_least_sector) == Answer::NO ||
        sector.is_other_side_at_least(cotangent_of_least_sector) == Answer::NO)
      continue;
    result.depth = std::max(result.depth, b.depth);
    ++result.tests;
    Sector_certifier certifier(sector, bound);
    if (std::any_of(rules.begin(), rules.end(), [&](const Thresholds& t) { return certifier.is_good(t); })) {
      ++result.boxes;
      continue;
    }
    // The second slope of an only edge does not matter.
    const auto d = static_cast<std::size_t>(b.depth) % (kind.turn == Turn::FULL ? 3 : 4);
    if (b.box.side[d] == 1) {
      result.is_proven = false;
      return result;
    }
    b.box.side[d] /= 2;
    ++b.depth;
    left.push_back(b);
    b.box.low[d] += b.box.side[d];
    left.push_back(b);
  }
  return result;
}

} // namespace vertex_certificates

#endif // QUADTREE_MESH_2_TEST_VERTEX_CERTIFICATES_H
