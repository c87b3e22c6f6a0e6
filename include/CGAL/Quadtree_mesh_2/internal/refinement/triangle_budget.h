// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How large a mesh may become, and the words for one that would be larger, with the narrow gap that is to
// blame.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_TRIANGLE_BUDGET_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_TRIANGLE_BUDGET_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_arrays.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Facing_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The physical memory of the machine in bytes; infinity where it is not known. The system is asked once.
inline double physical_memory() {
  static const double bytes = [] {
#if defined(_SC_PHYS_PAGES) && defined(_SC_PAGESIZE)
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    if (pages > 0 && size > 0) return static_cast<double>(pages) * static_cast<double>(size);
#endif
    return std::numeric_limits<double>::infinity();
  }();
  return bytes;
}

/// The bytes free on the disk of a folder; infinity where that is not known.
inline double free_disk(const std::string& folder) {
  std::error_code error;
  const auto space = std::filesystem::space(folder, error);
  return error ? std::numeric_limits<double>::infinity() : static_cast<double>(space.available);
}

class Triangle_budget {
public:
  /// In which the owner of the mesh knows the limit. A vertex stands for two triangles.
  enum class Unit { VERTICES, TRIANGLES };

  /// What handles allow: there are at most two triangles for each vertex, and some slots of triangles that are gone.
  static constexpr std::size_t most_vertices = 200000000;
  static_assert(most_vertices < Side::most_triangles / 2 / 5 * 4, "a quarter of the slots may be of none");

  /// \param limit in words: what sets the limit, and its verb
  Triangle_budget(double vertices, const char* limit, Unit unit)
      : limit_(limit), unit_(unit), triangles_(2 * vertices) {}

  /// What handles and memory allow.
  static Triangle_budget of_machine() {
    constexpr auto by_handles = static_cast<double>(most_vertices);
    if (Scratch_arrays::is_active()) {
      const double by_disk = free_disk(Scratch_arrays::folder()) / (2 * scratch_bytes_per_triangle);
      if (by_disk < by_handles) return {by_disk, "the disk of the scratch folder allows", Unit::VERTICES};
    } else {
      const double by_memory = physical_memory() / (2 * bytes_per_triangle);
      if (by_memory < by_handles) return {by_memory, "memory allows", Unit::VERTICES};
    }
    return {by_handles, "32-bit indices allow", Unit::VERTICES};
  }
  Triangle_budget smaller(const Triangle_budget& other) const {
    return other.triangles_ < triangles_ ? other : *this;
  }

  /// The estimate may be too large by a factor of 4 and more where it is made of many things at once: only
  /// what is beyond that is refused, so that nothing is that could be meshed.
  bool is_surely_exceeded_by(double estimate) const { return estimate > margin * triangles_; }

  std::string refusal_of(double estimate) const {
    return "the mesh would need " + in_words(in_unit(estimate)) + ' ' + name_of_unit() + ", and " + limit_ +
           ' ' + whole(in_unit(triangles_)) + ':';
  }

  bool is_used_up_by(std::size_t triangles) const { return static_cast<double>(triangles) >= triangles_; }

  std::string refusal_when_used_up() const {
    return "the mesh is not done with " + whole(in_unit(triangles_)) + ' ' + name_of_unit() + ", and " +
           limit_ + " no more:";
  }

private:
  /// Of the mesher's peak memory: measured on maps, from 100 to 160.
  static constexpr double bytes_per_triangle = 130;
  /// Of scratch files, in which arrays have room to grow that memory would not give pages for.
  static constexpr double scratch_bytes_per_triangle = 250;
  static constexpr double margin = 4;

  const char* limit_;
  Unit unit_;
  double triangles_;

  double in_unit(double triangles) const { return unit_ == Unit::VERTICES ? triangles / 2 : triangles; }
  const char* name_of_unit() const { return unit_ == Unit::VERTICES ? "vertices" : "triangles"; }
  /// With two digits: an estimate says no more. Large numbers are told by their powers of ten, if they have one: bounds
  /// of size may be so small that their squares are 0.
  static std::string in_words(double number) {
    if (number < 10) return "about " + whole(number);
    if (number > 1e300) return "more than 1e+300";
    const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1),
                 rounded = unit * std::round(number / unit);
    if (rounded < 1e8) return "about " + whole(rounded);
    std::ostringstream text;
    text.precision(2);
    text << "about " << rounded;
    return text.str();
  }
  /// With all digits, as the user would write it.
  static std::string whole(double number) { return std::to_string(std::llround(number)); }
};

/// Two edges of the input that face each other across a narrow gap, in words for its owner.
template <class Geometry>
class Narrow_gap {
public:
  using Number = typename Geometry::Number;

  Narrow_gap(const Meshing_state<Geometry>& state, const Facing_pair& pair) : state_(state), pair_(pair) {}

  /// The least distance of the two edges, in kernel coordinates.
  Number width() const {
    Number least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i)
      least = std::min({least, distance(pair_.a[i], pair_.b), distance(pair_.b[i], pair_.a)});
    return least;
  }

  /// \param name gives the name of a segment by its index.
  template <class Name>
  std::string in_words(Name name, double unit) const {
    std::ostringstream text;
    text << name(segments()[0]) << " and " << name(segments()[1]) << ' ';
    if (is_wedge())
      text << "meet at an angle of " << angle_of_wedge() << " degrees, with something between them";
    else
      text << "face each other at a distance of " << ratio(width(), unit);
    return text.str();
  }

  /// The indices of the two segments.
  std::array<Segment_index, 2> segments() const { return {segment(pair_.a), segment(pair_.b)}; }

private:
  const Meshing_state<Geometry>& state_;
  const Facing_pair& pair_;

  /// Wedges begin where the first edge ends and the second begins.
  bool is_wedge() const { return pair_.a[1] == pair_.b[0]; }

  double angle_of_wedge() const {
    const auto &o = state_.mesh.point(pair_.b[0]), &p = state_.mesh.point(pair_.b[1]),
               &q = state_.mesh.point(pair_.a[0]);
    const auto u = Geometry::scaled_difference(p, o), v = Geometry::scaled_difference(q, o);
    return std::fabs(std::atan(ratio(Geometry::doubled_area_of_flat(u, v, o, p, q), dot(u, v)))) /
           radians_per_degree;
  }

  Segment_index segment(const Vertex_id (&ends)[2]) const {
    return state_.edges[state_.edges.between(ends[0], ends[1])].segment;
  }

  Number distance(Vertex_id v, const Vertex_id (&ends)[2]) const {
    const auto& p = state_.mesh.point(v);
    const auto to = Geometry::scaled_difference(p, state_.mesh.point(ends[0]));
    const auto along = Geometry::scaled_difference(state_.mesh.point(ends[1]), state_.mesh.point(ends[0]));
    const double t = ratio(dot(to, along), squared_length(along));
    if (t <= 0 || t >= 1) return length(to - (t <= 0 ? 0.0 : 1.0) * along);
    using std::fabs;
    const auto &a = state_.mesh.point(ends[0]), &b = state_.mesh.point(ends[1]);
    return fabs(Geometry::doubled_area_of_flat(along, Geometry::scaled_difference(p, b), a, b, p)) /
           length(along);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_TRIANGLE_BUDGET_H
