// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADED_SIZES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADED_SIZES_H

#include <CGAL/Points_sizing_field_2.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The greatest lengths of edges at places; infinite in zones. Several threads may ask at once.
class Graded_sizes {
public:
  using Sized_point = Points_sizing_field_2::Sized_point;
  using Place = std::array<double, 2>;

  /// A disk around a corner, in which lengths have no bound.
  struct Zone {
    Place center;
    double radius;
    bool operator!=(const Zone& z) const { return center != z.center || radius != z.radius; }
    bool operator==(const Zone& z) const { return !(*this != z); }
  };

  explicit Graded_sizes(double gradation) : gradation_(gradation) {}

  void add(std::vector<Sized_point> points) {
    fields_.emplace_back(std::move(points), gradation_);
    generation_ = next_generation();
  }

  /// In place of those before.
  void set_zones(const std::vector<Zone>& zones) {
    zones_.reset(), reach_ = 0;
    for (const Zone& z : zones) reach_ = std::max(reach_, 2 * z.radius);
    std::vector<Sized_point> centers; // within a radius the size is then less than the reach
    for (const Zone& z : zones) centers.push_back({z.center[0], z.center[1], reach_ - z.radius});
    if (!zones.empty()) zones_.emplace(std::move(centers), 1.0);
    generation_ = next_generation();
  }

  /// Whether the points added so far allow less at the place of this one.
  bool dominate(const Sized_point& p) const {
    return std::any_of(fields_.begin(), fields_.end(),
                       [&](const auto& field) { return field(p.x, p.y, p.size) < p.size; });
  }

  /// Whether the points added last allow less than a length at a place, be it in a zone or not.
  bool is_less_by_last(const Place& p, double length) const {
    return fields_.back()(p[0], p[1], length) < length;
  }

  /// Triangles ask for the same corners again and again while they are made, so each thread keeps some answers.
  double operator()(const Place& p) const {
    constexpr std::size_t slots = 4096;
    thread_local std::vector<Answer> answers(slots);
    Answer& answer = answers[(hash(p[0]) * 31 + hash(p[1])) % slots];
    if (answer.generation != generation_ || answer.place != p) answer = {generation_, p, size(p)};
    return answer.size;
  }

private:
  struct Answer {
    std::uint64_t generation = 0;
    Place place{};
    double size = 0;
  };

  double gradation_;
  std::vector<Points_sizing_field_2> fields_;
  std::optional<Points_sizing_field_2> zones_;
  double reach_ = 0;
  std::uint64_t generation_ = next_generation(); ///< of answers

  static std::uint64_t next_generation() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
  }
  static std::size_t hash(double x) { return std::hash<double>()(x); }

  double size(const Place& p) const {
    double least = std::numeric_limits<double>::infinity();
    if (zones_ && (*zones_)(p[0], p[1], reach_) < reach_) return least;
    for (const auto& field : fields_) least = field(p[0], p[1], least);
    return least;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADED_SIZES_H
