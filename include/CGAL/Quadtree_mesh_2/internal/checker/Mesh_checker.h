// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_CHECKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_CHECKER_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Border_winding.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Chain_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Chain_order.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Half_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Input_domain.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Loops.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Mesh_error_log.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Scaled_sides.h>
#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Checks a mesh of double points against its input and writes its errors into a `Mesh_quality_2`. Rounded
/// numbers decide nothing.
///
/// This suffices for "covers the domain exactly". If all triangles are counterclockwise, the winding number
/// of the mesh's border around a point is how often the point is covered. The border is checked edge by edge
/// to be the chains along the domain's border, and these divide the plane as the straight segments do
/// (Chain_order.h). So each point is covered once or not at all, and areas would say no more. The Euler
/// characteristic is compared in addition.
class Mesh_checker {
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Mesh = Indexed_mesh_2<Point>;
  using Pslg = Pslg_2<Point>;

  Mesh_checker(const Mesh& mesh, const Pslg& pslg, const Mesh_quality_options_2& options, const Loops& loops,
               Mesh_quality_2& quality)
      : mesh_(mesh), pslg_(pslg), options_(options), loops_(loops), quality_(quality),
        log_(options, quality) {}

  /// \return `false` if the arrays do not fit together, which leaves nothing more to say.
  bool check_arrays() {
    check_sizes();
    const std::size_t errors = quality_.number_of_errors;
    if (mesh_.triangles.size() > none_ / 3)
      error("the mesh has ", mesh_.triangles.size(), " triangles, more than can be checked");
    check_coordinates("vertex ", mesh_.points);
    check_coordinates("input vertex ", pslg_.vertices);
    check_coordinates("hole ", pslg_.holes);
    check_coordinates("region ", region_points());
    for (std::size_t s = 0; s < pslg_.segments.size(); ++s)
      for (Vertex_index v : pslg_.segments[s])
        if (std::size_t(v) >= pslg_.vertices.size())
          error("input segment ", s, " ends at vertex ", v, ", which does not exist");
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& vertices = mesh_.triangles[t];
      for (Vertex_index v : vertices)
        if (std::size_t(v) >= mesh_.points.size())
          error("triangle ", t, " has vertex ", v, ", which does not exist");
      if (vertices[0] == vertices[1] || vertices[1] == vertices[2] || vertices[2] == vertices[0])
        error("triangle ", t, " has vertex ", vertices[vertices[0] == vertices[1] ? 0 : 2], " twice");
    }
    return quality_.number_of_errors == errors && mesh_.points.size() >= pslg_.vertices.size();
  }

  void check() {
    std::optional<Domain> domain;
    std::optional<Chain_finder> chains;
    loops_.do_both(
        [&] {
          domain.emplace(pslg_.vertices, pslg_.segments, pslg_.holes, options_.check_domain(),
                         region_points());
        },
        [&] {
          check_input_vertices();
          check_orientations();
          half_edges_ = Half_edges(mesh_.triangles, mesh_.points.size());
          pair_half_edges();
          check_places();
          chains.emplace(mesh_, pslg_, options_, half_edges_, log_);
        });
    check_against_input(*domain, *chains);
    if (has_all_arrays()) {
      check_segments_of_vertices();
      check_regions();
    }
  }

  const Half_edges& half_edges() const { return half_edges_; }
  /// Per half-edge, the one in the other direction, `Half_edges::none` on the border.
  const std::vector<std::uint32_t>& opposites() const { return opposites_; }
  /// Per half-edge, whether it lies on an input segment.
  const std::vector<char>& constrained() const { return is_constrained_; }
  /// All pairs (vertex, input segment through it), with the domain on a side of it there; sorted.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& segments_through() const {
    return segments_through_;
  }
  /// All pairs (input segment, input vertex inside it), of vertices at one place the first: in the order of the
  /// segments, and along each of them.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& vertices_inside() const {
    return vertices_inside_;
  }

private:
  using Domain = Input_domain<Kernel>;
  using Piece = Domain::Piece;
  static constexpr std::uint32_t none_ = Half_edges::none;

  template <class... Parts>
  void error(const Parts&... parts) {
    log_.add(parts...);
  }
  bool has_all_arrays() const { return options_.check_arrays() == Mesh_quality_options_2::Arrays::ALL; }
  bool has_domain() const { return options_.check_domain() != Mesh_quality_options_2::Domain::ANY; }

  void check_sizes() {
    const std::size_t n = pslg_.vertices.size();
    if (!mesh_.input_index.empty()) error("the mesh is renumbered: renumber_by_input() it first");
    if (mesh_.points.size() < n)
      error("the mesh has ", mesh_.points.size(), " vertices, fewer than the input's ", n);
    if (!has_all_arrays()) return;
    if (mesh_.number_of_input_vertices != n)
      error("number_of_input_vertices is ", mesh_.number_of_input_vertices, ", the input has ", n);
    if (mesh_.neighbors.size() != mesh_.triangles.size())
      error("there are ", mesh_.neighbors.size(), " neighbors for ", mesh_.triangles.size(), " triangles");
    if (mesh_.segment_of_vertex.size() != mesh_.points.size())
      error("there are ", mesh_.segment_of_vertex.size(), " entries of segment_of_vertex for ",
            mesh_.points.size(), " vertices");
    const std::size_t regions = pslg_.regions.empty() ? 0 : mesh_.triangles.size();
    if (mesh_.region_of_triangle.size() != regions)
      error("there are ", mesh_.region_of_triangle.size(), " entries of region_of_triangle, not ", regions);
  }

  void check_coordinates(const char* what, const std::vector<Point>& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!std::isfinite(points[i].x()) || !std::isfinite(points[i].y()))
        error(what, i, " is at (", points[i].x(), ", ", points[i].y(), ")");
  }
  std::vector<Point> region_points() const {
    std::vector<Point> points;
    for (const auto& region : pslg_.regions) points.push_back(region.point);
    return points;
  }

  static bool same_bits(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

  void check_input_vertices() {
    for (std::size_t v = 0; v < pslg_.vertices.size(); ++v) {
      const Point &p = pslg_.vertices[v], &q = mesh_.points[v];
      if (!same_bits(p.x(), q.x()) || !same_bits(p.y(), q.y()))
        error("input vertex ", v, " moved from (", p, ") to (", q, ")");
    }
  }

  void check_orientations() {
    const auto turn_of = [this](std::uint32_t t) {
      const auto& v = mesh_.triangles[t];
      return CGAL::orientation(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]));
    };
    loops_.for_each_wrong(
        mesh_.triangles.size(), [&](std::uint32_t t) { return turn_of(t) == LEFT_TURN; },
        [&](std::uint32_t t) {
          const auto& v = mesh_.triangles[t];
          error("triangle ", t, " (", v[0], " ", v[1], " ", v[2], ") is ",
                turn_of(t) == COLLINEAR ? "flat" : "clockwise");
        });
  }

  void pair_half_edges() {
    const auto n = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
    opposites_.assign(n, none_);
    is_constrained_.assign(n, 0);
    loops_.for_each_wrong(
        n,
        [this](std::uint32_t h) {
          opposites_[h] = half_edges_.find(half_edges_.target(h), half_edges_.origin(h)).half_edge;
          return !is_repeated(h) && is_neighbor_right(h);
        },
        [this](std::uint32_t h) { report_half_edge(h); });
  }

  bool is_repeated(std::uint32_t h) const {
    return half_edges_.find(half_edges_.origin(h), half_edges_.target(h)).count > 1;
  }
  /// Whether the triangle across is the one that is stored, if such are stored.
  bool is_neighbor_right(std::uint32_t h) const {
    if (!has_all_arrays() || mesh_.neighbors.size() != mesh_.triangles.size()) return true;
    const Triangle_index stored = mesh_.neighbors[h / 3][h % 3];
    const std::uint32_t found = opposites_[h];
    return found == none_ ? !stored.is_valid() : stored == Triangle_index(found / 3);
  }
  void report_half_edge(std::uint32_t h) {
    if (is_repeated(h))
      error("triangle ", h / 3, " and another one both have the directed edge ", half_edges_.origin(h), " ",
            half_edges_.target(h));
    if (!is_neighbor_right(h))
      error("neighbor ", h % 3, " of triangle ", h / 3, " is ", name(mesh_.neighbors[h / 3][h % 3]),
            ", but the triangle across is ",
            opposites_[h] == none_ ? "none" : std::to_string(opposites_[h] / 3));
  }
  template <class Index>
  static std::string name(Index i) {
    return i.is_valid() ? std::to_string(i.value()) : "none";
  }

  void check_places() {
    std::vector<std::uint32_t> used;
    for (std::uint32_t v = 0; v < mesh_.points.size(); ++v)
      if (half_edges_.is_used(v))
        used.push_back(v);
      else if (v >= pslg_.vertices.size())
        error("vertex ", v, " is neither an input vertex nor used by a triangle");
    quality_.vertices = used.size();
    const auto less = [&](std::uint32_t v, std::uint32_t w) { return mesh_.points[v] < mesh_.points[w]; };
    std::sort(used.begin(), used.end(), less);
    for (std::size_t i = 1; i < used.size(); ++i)
      if (!less(used[i - 1], used[i]))
        error("vertices ", used[i - 1], " and ", used[i], " are used and at one place");
  }

  // --- the input: vertices, segments, domain ---

  void check_against_input(const Domain& domain, Chain_finder& finder) {
    if (domain.has_crossings()) return error("input segments cross; this is no planar straight-line graph");
    for (std::size_t h : domain.ambiguous_holes()) ambiguous_error("hole ", h, pslg_.holes[h]);
    for (std::size_t r : domain.ambiguous_marks()) ambiguous_error("region ", r, pslg_.regions[r].point);
    if (!domain.ambiguous_holes().empty() || !domain.ambiguous_marks().empty()) return;
    find_representatives(domain);
    finder.report_links();
    check_chains(domain, finder);
    if (has_domain()) {
      check_border();
      check_euler(domain);
      domain.for_each_triangle([&](const Point& p, const Point& q, const Point& r) {
        quality_.domain_area += Scaled_sides<Point>(p, q, r).area();
      });
    } else if (quality_.number_of_errors == 0) {
      check_overlaps();
    }
  }

  void ambiguous_error(const char* what, std::size_t i, const Point& p) {
    error(what, i, " at (", p.x(), ", ", p.y(), ") is on a segment between two components of the plane");
  }

  /// The mesh may use any one of the input vertices at one place.
  void find_representatives(const Domain& domain) {
    const auto n = static_cast<std::uint32_t>(pslg_.vertices.size());
    representative_.assign(n, none_);
    for (std::uint32_t v = 0; v < n; ++v)
      if (half_edges_.is_used(v)) representative_[domain.place(v)] = v;
    for (std::uint32_t v = 0; v < n; ++v) {
      if (domain.place(v) != v || representative_[v] != none_) continue;
      if (!has_domain() || domain.is_touched(v))
        error("input vertex ", v, " is in the domain, but not in the mesh");
    }
  }

  /// Follows each piece of an input segment through the mesh.
  void check_chains(const Domain& domain, Chain_finder& finder) {
    Chain_order::Chains chains(domain.pieces().size());
    for (std::size_t p = 0; p < chains.size(); ++p) {
      const Piece& piece = domain.pieces()[p];
      if (has_domain() && !piece.is_in_domain()) continue;
      const std::uint32_t a = representative_[piece.ends[0]], b = representative_[piece.ends[1]];
      if (a == none_ || b == none_) continue; // reported as a vertex already
      chains[p] = finder.find(piece, a, b);
      for (std::size_t i = 1; i < chains[p].size(); ++i) check_sides(piece, chains[p][i - 1], chains[p][i]);
    }
    finder.check_unused_constrained_edges();
    Chain_order(mesh_.points, domain, chains, representative_, loops_, log_).check([&](Segment_index s) {
      return finder.line(s);
    });
    segment_of_vertex_ = finder.segment_of_vertex();
    find_vertices_inside(domain);
    for (const auto& cover : domain.covers())
      for (std::uint32_t v : chains[cover.first]) segments_through_.emplace_back(v, cover.second.value());
    std::sort(segments_through_.begin(), segments_through_.end());
    segments_through_.erase(std::unique(segments_through_.begin(), segments_through_.end()),
                            segments_through_.end());
  }

  void find_vertices_inside(const Domain& domain) {
    const auto& covers = domain.covers();
    for (std::size_t i = 1; i < covers.size(); ++i) {
      if (covers[i - 1].second != covers[i].second) continue;
      const auto& before = domain.pieces()[covers[i - 1].first].ends;
      for (const std::uint32_t v : domain.pieces()[covers[i].first].ends)
        if (v == before[0] || v == before[1]) vertices_inside_.emplace_back(covers[i].second.value(), v);
    }
  }

  void check_sides(const Piece& piece, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t left = half_edges_.find(a, b).half_edge, right = half_edges_.find(b, a).half_edge;
    if (left != none_) is_constrained_[left] = 1;
    if (right != none_) is_constrained_[right] = 1;
    if (!has_domain()) return;
    if (piece.is_domain_left != (left != none_)) side_error(piece, a, b, left);
    if (piece.is_domain_right != (right != none_)) side_error(piece, b, a, right);
    check_region(left, piece.marks[0]);
    check_region(right, piece.marks[1]);
  }
  void check_region(std::uint32_t half_edge, int expected) {
    if (half_edge == none_ || !has_regions()) return;
    const int found = mesh_.region_of_triangle[half_edge / 3];
    if (found != expected)
      error("triangle ", half_edge / 3, " is in region ", found, ", but by the regions' points in ",
            expected);
  }
  bool has_regions() const {
    return has_all_arrays() && !pslg_.regions.empty() &&
           mesh_.region_of_triangle.size() == mesh_.triangles.size();
  }
  void side_error(const Piece& piece, std::uint32_t a, std::uint32_t b, std::uint32_t half_edge) {
    if (half_edge == none_)
      error("no triangle on the left of edge ", a, " ", b, " of input segment ", piece.segment,
            ", where the domain is");
    else
      error("triangle ", half_edge / 3, " on the left of edge ", a, " ", b, " of input segment ",
            piece.segment, " is outside the domain");
  }

  void check_border() {
    for (std::uint32_t h = 0; h < opposites_.size(); ++h)
      if (opposites_[h] == none_ && is_constrained_[h] == 0)
        error("edge ", half_edges_.origin(h), " ", half_edges_.target(h), " of triangle ", h / 3,
              " is on the border of the mesh, but on no input segment");
  }

  /// Where no domain tells what the border of the mesh has to be.
  void check_overlaps() {
    std::vector<Border_winding<Kernel>::Edge> border;
    for (std::uint32_t h = 0; h < opposites_.size(); ++h)
      if (opposites_[h] == none_) border.push_back({half_edges_.origin(h), half_edges_.target(h)});
    if (!Border_winding<Kernel>(mesh_.points, border).is_simple())
      error("triangles overlap, or border edges meet where they have no common end");
  }

  void check_euler(const Domain& domain) {
    const auto border = std::count(opposites_.begin(), opposites_.end(), none_);
    const auto sides = static_cast<std::ptrdiff_t>(opposites_.size());
    const std::ptrdiff_t euler = std::ptrdiff_t(quality_.vertices) - (sides + border) / 2 + sides / 3;
    if (euler != domain.euler_characteristic())
      error("the Euler characteristic of the mesh is ", euler, ", that of the domain ",
            domain.euler_characteristic());
  }

  // --- the remaining arrays ---

  void check_segments_of_vertices() {
    if (mesh_.segment_of_vertex.size() != mesh_.points.size()) return;
    for (std::size_t v = 0; v < mesh_.points.size() && segment_of_vertex_.size() == mesh_.points.size();
         ++v) {
      const Segment_index stored = mesh_.segment_of_vertex[v];
      if (stored.value() != segment_of_vertex_[v])
        error("segment_of_vertex of vertex ", v, " is ", name(stored), ", not ",
              segment_of_vertex_[v] == none_ ? "none" : std::to_string(segment_of_vertex_[v]));
    }
  }

  void check_regions() {
    const std::vector<int>& region = mesh_.region_of_triangle;
    if (region.size() != mesh_.triangles.size()) return;
    for (std::size_t t = 0; t < region.size(); ++t)
      if (region[t] < -1 || region[t] >= int(pslg_.regions.size()))
        error("triangle ", t, " is in region ", region[t], ", which does not exist");
    for (std::uint32_t h = 0; h < opposites_.size(); ++h) {
      const std::uint32_t other = opposites_[h];
      if (other != none_ && h < other && is_constrained_[h] == 0 && region[h / 3] != region[other / 3])
        error("no input segment separates triangles ", h / 3, " and ", other / 3, " of regions ",
              region[h / 3], " and ", region[other / 3]);
    }
  }

  const Mesh& mesh_;
  const Pslg& pslg_;
  const Mesh_quality_options_2& options_;
  const Loops& loops_;
  Mesh_quality_2& quality_;
  Mesh_error_log log_;
  Half_edges half_edges_{no_triangles(), 0};
  std::vector<std::uint32_t> opposites_;
  std::vector<char> is_constrained_;
  std::vector<std::uint32_t> representative_; // of an input place: the vertex there that the mesh uses
  std::vector<std::uint32_t> segment_of_vertex_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> segments_through_, vertices_inside_;

  static const Half_edges::Triangles& no_triangles() {
    static const Half_edges::Triangles none;
    return none;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_CHECKER_H
