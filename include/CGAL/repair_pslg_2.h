// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_REPAIR_PSLG_2_H
#define CGAL_REPAIR_PSLG_2_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Crossing_snapper.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/arrange_pslg_2.h>
#include <CGAL/validate_pslg_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

// Makes a nearly planar straight-line graph planar. Vertices at one place merge. Segments are split at the
// vertices on them. Segments that cover others are removed. Crossings are split on request.
//
// Without crossings, one constrained Delaunay triangulation with exact predicates finds everything. Nothing
// moves, in expected O(n log n) time. With crossings, a second triangulation with exact constructions finds
// them, and only then are they rounded to doubles. So segments that overlap or run through one point still
// do. Rounding while splitting, as with CGAL's Exact_predicates_tag, tears them apart.
//
// Rounded segments bend by a rounding error, so they may meet other segments nearby. The result therefore
// goes through the same passes until nothing crosses: twice in practice. Exact predicates have found the
// returned graph free of crossings. (Snap rounding would need one pass, but it moves vertices of the input.)
//
// Among vertices or segments a few units in the last place apart, each pass may make more crossings than it
// cures. If they do not halve, the passes start over with rerouting as in snap rounding: Crossing_snapper.h.

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// What `repair_pslg_2()` does where segments cross without a common vertex.
enum class Pslg_crossing_rule_2 {
  THROW, ///< a `Pslg_crossing_error_2` names both segments and the place, as crossings are often mistakes
  SPLIT  ///< a new vertex splits both
};

/// \ingroup PkgQuadtreeMesh2Data
/// Options of `repair_pslg_2()`. Each option is set by the function of its name, which returns the options.
/// Without an argument the function returns the value.
class Pslg_repair_options_2 {
public:
  /// What to do with crossings; THROW by default.
  Pslg_repair_options_2& crossings(Pslg_crossing_rule_2 value) { return crossings_ = value, *this; }
  Pslg_crossing_rule_2 crossings() const { return crossings_; } ///< the value set

private:
  Pslg_crossing_rule_2 crossings_ = Pslg_crossing_rule_2::THROW;
};

/// \ingroup PkgQuadtreeMesh2Data
/// The report of `repair_pslg_2()`.
struct Pslg_repair_report_2 {
  /// Per input vertex, its index in the result.
  std::vector<Quadtree_mesh_2::Vertex_index> vertex_map;
  /// Per segment of the result, the first input segment that it is a piece of.
  std::vector<Quadtree_mesh_2::Segment_index> segment_origin;

  // All but the last count in the input.
  std::size_t merged_vertices = 0;      ///< input vertices at the place of an earlier one
  std::size_t zero_length_segments = 0; ///< input segments whose ends are at one place
  std::size_t overlapping_segments = 0; ///< input segments that share a piece with an earlier one
  std::size_t split_segments = 0;       ///< input segments with a vertex or a crossing inside
  std::size_t crossings = 0;            ///< new vertices where segments crossed, the last ones of the result

  /// Whether there was nothing to repair.
  bool is_unchanged() const {
    return merged_vertices + zero_length_segments + overlapping_segments + split_segments + crossings == 0;
  }
};

namespace Quadtree_mesh_2 {
namespace internal {

/// Builds the repaired graph from the arrangement of the faulty one.
template <class Point>
class Pslg_repairer_2 {
public:
  Pslg_repairer_2(const Pslg_2<Point>& pslg, const Arranged_pslg_2& arranged, Pslg_repair_report_2& report)
      : pslg_(pslg), arranged_(arranged), report_(report) {}

  Pslg_2<Point> run() {
    merge_vertices();
    add_crossings();
    add_segments();
    result_.holes = pslg_.holes;
    result_.regions = pslg_.regions;
    result_.first_number = pslg_.first_number;
    result_.marker_names = pslg_.marker_names;
    result_.region_names = pslg_.region_names;
    return std::move(result_);
  }

private:
  /// The first vertex of a place stays. It gets the first nonzero marker there.
  void merge_vertices() {
    const std::size_t n = pslg_.vertices.size(), k = pslg_.number_of_vertex_attributes;
    result_.number_of_vertex_attributes = k;
    new_index_.resize(n + arranged_.crossings.size());
    for (std::size_t v = 0; v < n; ++v) {
      const std::size_t first(arranged_.first_at_place[v]);
      if (first == v) {
        new_index_[v] = result_.add_vertex(pslg_.vertices[v]);
        if (!pslg_.vertex_markers.empty()) result_.vertex_markers.push_back(pslg_.vertex_markers[v]);
        for (std::size_t i = 0; i < k; ++i)
          result_.vertex_attributes.push_back(pslg_.vertex_attributes[v * k + i]);
      } else {
        ++report_.merged_vertices;
        new_index_[v] = new_index_[first];
        if (!pslg_.vertex_markers.empty()) offer_vertex_marker(new_index_[v], pslg_.vertex_markers[v]);
      }
      report_.vertex_map.push_back(new_index_[v]);
    }
  }

  void add_crossings() {
    for (std::size_t c = 0; c < arranged_.crossings.size(); ++c) {
      const std::array<double, 2>& p = arranged_.crossings[c];
      new_index_[pslg_.vertices.size() + c] = result_.add_vertex(Point(p[0], p[1]));
    }
    report_.crossings = arranged_.crossings.size();
    result_.vertex_attributes.resize(result_.vertices.size() * result_.number_of_vertex_attributes);
    if (!pslg_.vertex_markers.empty()) result_.vertex_markers.resize(result_.vertices.size(), 0);
    describe_crossings();
  }

  /// Interpolates the attributes of a crossing along the first segment through it. Its marker is the first
  /// nonzero marker of a segment through it.
  void describe_crossings() {
    std::vector<bool> is_described(arranged_.crossings.size(), false);
    for (std::size_t s = 0; s < arranged_.chains.size(); ++s)
      for (const Vertex_index v : arranged_.chains[s]) {
        if (std::size_t(v) < pslg_.vertices.size()) continue;
        if (!pslg_.vertex_markers.empty() && !pslg_.segment_markers.empty())
          offer_vertex_marker(new_index_[std::size_t(v)], pslg_.segment_markers[s]);
        const std::size_t c = std::size_t(v) - pslg_.vertices.size();
        if (!is_described[c]) interpolate(Segment_index(s), new_index_[std::size_t(v)]);
        is_described[c] = true;
      }
  }

  void interpolate(Segment_index s, Vertex_index new_vertex) {
    const std::size_t k = pslg_.number_of_vertex_attributes;
    if (k == 0) return;
    const std::size_t a(pslg_.segments[std::size_t(s)][0]), b(pslg_.segments[std::size_t(s)][1]);
    const auto distance = [](const Point& p, const Point& q) {
      return std::hypot(p.x() - q.x(), p.y() - q.y());
    };
    const Point& place = result_.point(new_vertex);
    const double from_a = distance(pslg_.vertices[a], place), from_b = distance(pslg_.vertices[b], place);
    const double ratio = from_a / (from_a + from_b);
    for (std::size_t i = 0; i < k; ++i)
      result_.vertex_attributes[std::size_t(new_vertex) * k + i] =
          (1 - ratio) * pslg_.vertex_attributes[a * k + i] + ratio * pslg_.vertex_attributes[b * k + i];
  }

  /// A piece belongs to the first segment that covers it. It has the first nonzero marker of the segments
  /// that cover it.
  void add_segments() {
    std::unordered_map<std::uint64_t, Segment_index> pieces;
    pieces.reserve(pslg_.segments.size());
    for (std::size_t s = 0; s < arranged_.chains.size(); ++s) {
      const std::vector<Vertex_index>& chain = arranged_.chains[s];
      if (chain.empty()) ++report_.zero_length_segments;
      if (chain.size() > 2) ++report_.split_segments;
      bool does_overlap = false;
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        const Vertex_index a = new_index_[std::size_t(chain[i])], b = new_index_[std::size_t(chain[i + 1])];
        const auto [piece, is_new] =
            pieces.emplace(unordered_pair_key(a, b), Segment_index(result_.segments.size()));
        if (is_new)
          add_piece(a, b, Segment_index(s));
        else
          does_overlap |= cover_again(piece->second, Segment_index(s));
      }
      if (does_overlap) ++report_.overlapping_segments;
    }
  }

  void add_piece(Vertex_index a, Vertex_index b, Segment_index origin) {
    result_.add_segment(a, b);
    report_.segment_origin.push_back(origin);
    if (!pslg_.segment_markers.empty())
      result_.segment_markers.push_back(pslg_.segment_markers[std::size_t(origin)]);
  }

  /// Returns whether the piece belonged to another segment already. A segment bent by rounding may cover the
  /// same piece twice.
  bool cover_again(Segment_index piece, Segment_index origin) {
    if (!result_.segment_markers.empty() && result_.segment_markers[std::size_t(piece)] == 0)
      result_.segment_markers[std::size_t(piece)] = pslg_.segment_markers[std::size_t(origin)];
    return report_.segment_origin[std::size_t(piece)] != origin;
  }

  void offer_vertex_marker(Vertex_index v, int marker) {
    int& own = result_.vertex_markers[std::size_t(v)];
    if (own == 0) own = marker;
  }

  const Pslg_2<Point>& pslg_;
  const Arranged_pslg_2& arranged_;
  Pslg_repair_report_2& report_;
  Pslg_2<Point> result_;
  std::vector<Vertex_index> new_index_; ///< of input vertices, then of crossings
};

template <class Point>
[[noreturn]] void throw_crossing(const Pslg_2<Point>& pslg, Segment_index s) {
  const std::optional<Segment_index> crossed = find_crossed_segment(pslg, s);
  if (!crossed)
    throw Pslg_error_2(Pslg_error_2::Kind::CROSSING,
                       segment_text(pslg, std::size_t(s)) + " crosses another one",
                       Pslg_parts_2().segment(s));
  const std::array<double, 2> p = crossing_of_segments(pslg, *crossed, s);
  throw Pslg_crossing_error_2(segment_text(pslg, std::size_t(*crossed)) + " and " +
                                  segment_text(pslg, std::size_t(s)) + " cross at " + place_text(p),
                              {*crossed, s});
}

/// Names the segments of the input whose pieces still cross.
/// \param origin per piece, its segment
/// \param piece one that crosses an earlier one
template <class Point>
[[noreturn]] void throw_no_room(const Pslg_2<Point>& pslg, const Pslg_2<Point>& pieces,
                                const std::vector<Segment_index>& origin, Segment_index piece) {
  const Segment_index crossed = find_crossed_segment(pieces, piece).value_or(piece);
  const Point& end = pieces.point(pieces.segment(piece)[0]);
  const std::array<double, 2> place = crossed == piece ? std::array<double, 2>{end.x(), end.y()}
                                                       : crossing_of_segments(pieces, crossed, piece);
  const auto [s, t] = std::minmax(origin[std::size_t(piece)], origin[std::size_t(crossed)]);
  Pslg_parts_2 parts = Pslg_parts_2().segment(s);
  std::string text = segment_text(pslg, std::size_t(s));
  if (s != t) {
    parts.segment(t);
    text += " and " + segment_text(pslg, std::size_t(t));
  }
  throw Pslg_error_2(Pslg_error_2::Kind::ROUNDING,
                     "doubles are too coarse at " + place_text(place) + " to round the crossings of " + text,
                     parts);
}

/// Cures all defects but crossings.
/// \return a segment that crosses an earlier one, if there are any; the graph is then as before
template <class Point>
std::optional<Segment_index> repair_without_crossings(Pslg_2<Point>& pslg, Pslg_repair_report_2& report) {
  Pslg_arranger_2<Crossing_free_triangulation_2> arranger(pslg);
  if (const std::optional<Segment_index> crossing = arranger.insert_segments(pslg)) return crossing;
  const Arranged_pslg_2 arranged = arranger.result();
  pslg = Pslg_repairer_2<Point>(pslg, arranged, report).run();
  return std::nullopt;
}

/// Cures all defects, but rounded crossings may make new ones.
/// \param reach how far crossings go to vertices, in units in the last place (see Crossing_snapper.h); 0 if they do not
/// \return the number of places where segments crossed
template <class Point>
std::size_t repair_with_crossings(Pslg_2<Point>& pslg, double reach, Pslg_repair_report_2& report) {
  Pslg_arranger_2<Exact_triangulation_2> arranger(pslg);
  arranger.insert_segments(pslg);
  Arranged_pslg_2 arranged = arranger.result();
  const std::size_t crossings = arranged.crossings.size();
  if (reach > 0) Crossing_snapper<Point>(pslg, arranged, reach).run();
  pslg = Pslg_repairer_2<Point>(pslg, arranged, report).run();
  return crossings;
}

/// Products of differences that are not finite crash the triangulation.
/// \throws Pslg_error_2 naming the first vertex that is too far away
template <class Point>
void check_range_for_crossings(const Pslg_2<Point>& pslg) {
  constexpr double limit = 0x1p1000;
  for (std::size_t v = 0; v < pslg.vertices.size(); ++v) {
    const Point& p = pslg.vertices[v];
    if (std::abs(static_cast<double>(p.x())) < limit && std::abs(static_cast<double>(p.y())) < limit)
      continue;
    throw Pslg_error_2(Pslg_error_2::Kind::OUT_OF_RANGE,
                       vertex_text(pslg, v) +
                           " has a coordinate that is too large for crossings to be found;" +
                           " it has to be below 2^1000 in magnitude",
                       Pslg_parts_2().vertex(Vertex_index(v)));
  }
}

/// Adds the report of a further pass. The counts of defects stay those of the first pass, in the input.
inline void append_pass(Pslg_repair_report_2& report, const Pslg_repair_report_2& pass) {
  for (Vertex_index& v : report.vertex_map) v = pass.vertex_map[std::size_t(v)];
  std::vector<Segment_index> origin;
  origin.reserve(pass.segment_origin.size());
  for (const Segment_index s : pass.segment_origin) origin.push_back(report.segment_origin[std::size_t(s)]);
  report.segment_origin = std::move(origin);
  // Vertices of the input are distinct by now, so that only crossings can have merged.
  report.crossings = report.crossings + pass.crossings - pass.merged_vertices;
}

/// Repairs a graph in passes, until nothing crosses. The passes only round crossings while these halve. If they
/// do not, the passes start over, and crossings go to vertices nearby.
template <class Point>
class Pslg_repair_passes_2 {
public:
  explicit Pslg_repair_passes_2(const Pslg_2<Point>& pslg) : pslg_(pslg), result_(pslg) {}

  Pslg_2<Point> run(Pslg_crossing_rule_2 rule, Pslg_repair_report_2& report) {
    for (;;) {
      Pslg_repair_report_2 step;
      const std::optional<Segment_index> crossing = repair_without_crossings(result_, step);
      if (crossing && rule == Pslg_crossing_rule_2::THROW) throw_crossing(pslg_, *crossing);
      if (crossing && is_hopeless()) throw_no_room(pslg_, result_, sum_->segment_origin, *crossing);
      const std::size_t crossings = crossing ? repair_with_crossings(result_, reach_, step) : 0;
      add_to_sum(std::move(step));
      if (!crossing) break;
      prepare_next_pass(crossings);
    }
    report = std::move(*sum_);
    return std::move(result_);
  }

private:
  /// As far as a crossing is rounded along both axes, and its segments with it.
  static constexpr double reach_in_units = 2;
  /// Passes in a row without fewer crossings than ever before.
  static constexpr int patience = 6;
  /// Passes that make so many times as many crossings as there were will not end well.
  static constexpr std::size_t most_growth = 16;

  bool is_hopeless() const {
    return passes_in_vain_ >= patience || last_crossings_ / most_growth > fewest_crossings_;
  }

  void add_to_sum(Pslg_repair_report_2&& step) {
    if (sum_)
      append_pass(*sum_, step);
    else
      sum_ = std::move(step);
  }

  void prepare_next_pass(std::size_t crossings) {
    const bool has_halved = crossings <= fewest_crossings_ / 2;
    if (!is_near_degenerate_ && !has_halved) return start_over();
    const bool is_in_vain = crossings >= fewest_crossings_;
    passes_in_vain_ = is_in_vain ? passes_in_vain_ + 1 : 0;
    fewest_crossings_ = (std::min)(fewest_crossings_, crossings);
    last_crossings_ = crossings;
    // Among vertices units apart, segments may go to one vertex and back to another. A pass between stops that.
    if (is_near_degenerate_) reach_ = is_in_vain && reach_ > 0 ? 0 : reach_in_units;
  }

  void start_over() {
    is_near_degenerate_ = true;
    reach_ = reach_in_units;
    result_ = pslg_;
    sum_.reset();
    fewest_crossings_ = (std::numeric_limits<std::size_t>::max)();
  }

  const Pslg_2<Point>& pslg_;
  Pslg_2<Point> result_;
  std::optional<Pslg_repair_report_2> sum_; ///< of the passes so far
  bool is_near_degenerate_ = false;         ///< whether passes have started over
  double reach_ = 0;                        ///< of crossings, in units in the last place
  std::size_t fewest_crossings_ = (std::numeric_limits<std::size_t>::max)();
  std::size_t last_crossings_ = 0;
  int passes_in_vain_ = 0;
};

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Data
/// Repairs a graph. Merges duplicate vertices. Removes segments of length zero or covered by others. Splits
/// segments at the vertices on them and, on request, where they cross.
///
/// Vertices keep their order and their bits, and vertices without segments stay. Crossings come last. The
/// pieces of a segment follow each other in its direction, in the order of the segments. Holes and regions
/// are copied. Markers and attributes are:
/// - A place has the attributes of its first vertex and the first nonzero marker there.
/// - A piece has the first nonzero marker of the segments that cover it.
/// - A crossing has attributes interpolated along the first segment through it. If vertices have markers, its
///   marker is the first nonzero one of the segments through it.
///
/// A crossing is rounded to doubles, which bends the segments through it. Segments a few units in the last
/// place apart may meet elsewhere then. Only if that goes on, crossings within two units of a vertex go to it,
/// and segments with crossings go through the vertices within two units of them. These may then touch, or share
/// pieces, where they passed each other by some units. Units are those of the largest coordinate of a segment.
///
/// Expected O(n log n) time. c crossings that are split take O(c) more, in exact arithmetic. Passes over crossings
/// that rounding made take the same again; they are few, as crossings must become fewer.
/// \tparam Point has floating-point coordinates.
/// \throws Pslg_error_2 if `check_pslg_structure()` does, or for coordinates of 2^1000 and more. Also if segments
/// cross and `options` do not ask for a split; the message has both segments and the place. Its kind is `ROUNDING` if
/// crossings do not become fewer, however they are rounded; the message has two of the segments and a place, too.
/// `report` is then unchanged.
template <class Point>
Pslg_2<Point> repair_pslg_2(const Pslg_2<Point>& pslg, const Pslg_repair_options_2& options,
                            Pslg_repair_report_2& report) {
  namespace internal = Quadtree_mesh_2::internal;
  check_pslg_structure(pslg);
  internal::check_range_for_crossings(pslg);
  return internal::Pslg_repair_passes_2<Point>(pslg).run(options.crossings(), report);
}

/// \ingroup PkgQuadtreeMesh2Data
/// The same without a report.
template <class Point>
Pslg_2<Point> repair_pslg_2(const Pslg_2<Point>& pslg,
                            const Pslg_repair_options_2& options = Pslg_repair_options_2()) {
  Pslg_repair_report_2 report;
  return repair_pslg_2(pslg, options, report);
}

} // namespace CGAL

#endif // CGAL_REPAIR_PSLG_2_H
