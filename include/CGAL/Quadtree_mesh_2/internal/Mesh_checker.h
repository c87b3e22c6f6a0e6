// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_CHECKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_CHECKER_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Half_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/Input_domain.h>
#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Checks a mesh of double points against its input and writes what is wrong into a `Mesh_quality_2`.
///
/// Why nothing more is needed for "covers the domain exactly": where all triangles are counterclockwise, how
/// often a point is covered is the winding number of the mesh's border around it, and the border is checked
/// edge by edge to be the domain's. The area and the Euler characteristic are checked on top of that.
class Mesh_checker {
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Mesh = Indexed_mesh_2<Point>;
  using Pslg = Pslg_2<Point>;

  Mesh_checker(const Mesh& mesh, const Pslg& pslg, const Mesh_quality_options_2& options,
               Mesh_quality_2& quality)
      : mesh_(mesh), pslg_(pslg), options_(options), quality_(quality) {}

  /// \return `false` if the arrays do not fit together, which leaves nothing more to say.
  bool check_arrays() {
    check_sizes();
    const std::size_t errors = quality_.number_of_errors;
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
    check_input_vertices();
    check_orientations();
    half_edges_ = Half_edges(mesh_.triangles, mesh_.points.size());
    pair_half_edges();
    check_places();
    check_against_input();
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

private:
  using Domain = Input_domain<Kernel>;
  using Piece = Domain::Piece;
  static constexpr std::uint32_t none_ = Half_edges::none;

  template <class... Parts>
  void error(const Parts&... parts) {
    if (++quality_.number_of_errors > options_.max_errors) return;
    std::ostringstream text;
    text.precision(17);
    (text << ... << parts);
    quality_.errors.push_back(text.str());
  }
  bool has_all_arrays() const { return options_.arrays == Mesh_quality_options_2::Arrays::ALL; }
  bool has_domain() const { return options_.domain != Mesh_quality_options_2::Domain::ANY; }

  void check_sizes() {
    const std::size_t n = pslg_.vertices.size();
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

  static bool same_bits(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

  void check_input_vertices() {
    for (std::size_t v = 0; v < pslg_.vertices.size(); ++v) {
      const Point &p = pslg_.vertices[v], &q = mesh_.points[v];
      if (!same_bits(p.x(), q.x()) || !same_bits(p.y(), q.y()))
        error("input vertex ", v, " moved from (", p, ") to (", q, ")");
    }
  }

  void check_orientations() {
    const std::vector<Point>& p = mesh_.points;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& v = mesh_.triangles[t];
      const Orientation turn =
          CGAL::orientation(p[std::size_t(v[0])], p[std::size_t(v[1])], p[std::size_t(v[2])]);
      if (turn != LEFT_TURN)
        error("triangle ", t, " (", v[0], " ", v[1], " ", v[2], ") is ",
              turn == COLLINEAR ? "flat" : "clockwise");
    }
  }

  void pair_half_edges() {
    const auto n = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
    opposites_.assign(n, none_);
    is_constrained_.assign(n, 0);
    const bool has_neighbors = has_all_arrays() && mesh_.neighbors.size() == mesh_.triangles.size();
    for (std::uint32_t h = 0; h < n; ++h) {
      const std::uint32_t a = half_edges_.origin(h), b = half_edges_.target(h);
      if (half_edges_.find(a, b).count > 1)
        error("triangle ", h / 3, " and another one both have the directed edge ", a, " ", b);
      opposites_[h] = half_edges_.find(b, a).half_edge;
      if (has_neighbors) check_neighbor(h);
    }
  }

  void check_neighbor(std::uint32_t h) {
    const Triangle_index stored = mesh_.neighbors[h / 3][h % 3];
    const std::uint32_t found = opposites_[h];
    if (found == none_ ? stored.is_valid() : stored != Triangle_index(found / 3))
      error("neighbor ", h % 3, " of triangle ", h / 3, " is ", name(stored), ", but the triangle across is ",
            found == none_ ? "none" : std::to_string(found / 3));
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

  void check_against_input() {
    std::vector<Point> marks;
    for (const auto& region : pslg_.regions) marks.push_back(region.point);
    const Domain domain(pslg_.vertices, pslg_.segments, pslg_.holes, options_.domain, marks);
    if (domain.has_crossings()) return error("input segments cross; this is no planar straight-line graph");
    set_scale();
    find_representatives(domain);
    sort_constrained_edges();
    check_pieces(domain);
    if (has_all_arrays()) check_unexplained_constrained_edges();
    if (has_domain()) {
      check_border();
      check_area_and_euler(domain);
    }
  }

  void set_scale() {
    double x[2] = {0, 0}, y[2] = {0, 0};
    for (std::size_t v = 0; v < pslg_.vertices.size(); ++v) {
      const Point& p = pslg_.vertices[v];
      x[0] = v == 0 ? p.x() : std::min(x[0], p.x());
      x[1] = v == 0 ? p.x() : std::max(x[1], p.x());
      y[0] = v == 0 ? p.y() : std::min(y[0], p.y());
      y[1] = v == 0 ? p.y() : std::max(y[1], p.y());
    }
    epsilon_ = options_.tolerance_on_edge * std::hypot(x[1] - x[0], y[1] - y[0]);
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

  struct Span {
    std::uint32_t segment;
    double low; // position of ends[0] along the segment
    std::uint32_t ends[2];
    bool is_explained;
  };
  struct Line {
    Line(const Point& p, const Point& q)
        : x(p.x()), y(p.y()), dx(q.x() - x), dy(q.y() - y), length(std::hypot(dx, dy)) {}
    double along(const Point& p) const { return ((p.x() - x) * dx + (p.y() - y) * dy) / length; }
    double off(const Point& p) const { return std::abs((p.x() - x) * dy - (p.y() - y) * dx) / length; }
    double x, y, dx, dy, length;
  };
  Line line_of(Segment_index s) const {
    const auto& ends = pslg_.segments[std::size_t(s)];
    return Line(pslg_.point(ends[0]), pslg_.point(ends[1]));
  }

  /// Checks the constrained edges one by one and sorts them along their segments.
  void sort_constrained_edges() {
    if (!has_all_arrays()) return;
    for (std::size_t e = 0; e < mesh_.constrained_edges.size(); ++e) {
      const auto& edge = mesh_.constrained_edges[e];
      const std::size_t a = std::size_t(edge.vertices[0]), b = std::size_t(edge.vertices[1]),
                        s = std::size_t(edge.segment);
      if (a >= mesh_.points.size() || b >= mesh_.points.size() || s >= pslg_.segments.size()) {
        error("constrained edge ", e, " has an index that does not exist");
        continue;
      }
      const Line line = line_of(edge.segment);
      const Point &p = mesh_.points[a], &q = mesh_.points[b];
      if (!half_edges_.is_edge(std::uint32_t(a), std::uint32_t(b))) {
        error("constrained edge ", e, " (", a, " ", b, ") is not an edge of the mesh");
      } else if (!(line.off(p) <= epsilon_ &&
                   line.off(q) <= epsilon_)) { // not > : a segment of length zero gives NaN
        error("constrained edge ", e, " (", a, " ", b, ") is not on input segment ", s);
      } else {
        Span span{std::uint32_t(s), line.along(p), {std::uint32_t(a), std::uint32_t(b)}, false};
        if (line.along(q) < span.low) std::swap(span.ends[0], span.ends[1]), span.low = line.along(q);
        spans_.push_back(span);
      }
    }
    std::sort(spans_.begin(), spans_.end(), [](const Span& a, const Span& b) {
      return a.segment != b.segment ? a.segment < b.segment : a.low < b.low;
    });
  }

  /// Follows each piece of an input segment through the mesh.
  void check_pieces(const Domain& domain) {
    std::vector<std::vector<std::uint32_t>> chains(domain.pieces().size());
    std::vector<std::uint32_t> chain;
    segment_of_vertex_.assign(mesh_.points.size(), none_);
    std::vector<std::uint32_t> starts{0}, flat; // vertices of all chains
    std::size_t next_span = 0;
    for (const Piece& piece : domain.pieces()) {
      chain.clear();
      if (!has_domain() || piece.is_in_domain()) follow(piece, next_span, chain);
      for (std::size_t i = 1; i < chain.size(); ++i) check_sides(piece, chain[i - 1], chain[i]);
      for (std::size_t i = 1; i + 1 < chain.size(); ++i)
        if (chain[i] >= pslg_.vertices.size()) segment_of_vertex_[chain[i]] = piece.segment.value();
      flat.insert(flat.end(), chain.begin(), chain.end());
      starts.push_back(std::uint32_t(flat.size()));
    }
    for (const auto& cover : domain.covers())
      for (std::uint32_t i = starts[cover.first]; i < starts[cover.first + 1]; ++i)
        segments_through_.emplace_back(flat[i], cover.second.value());
    std::sort(segments_through_.begin(), segments_through_.end());
    segments_through_.erase(std::unique(segments_through_.begin(), segments_through_.end()),
                            segments_through_.end());
  }

  /// \param[in,out] next_span spans before it belong to earlier pieces.
  /// \param[out] chain the mesh vertices along the piece; empty if it is not in the mesh.
  void follow(const Piece& piece, std::size_t& next_span, std::vector<std::uint32_t>& chain) {
    const std::uint32_t a = representative_[piece.ends[0]], b = representative_[piece.ends[1]];
    if (a == none_ || b == none_) return; // reported as a vertex already
    if (has_all_arrays()) {
      if (follow_spans(piece.segment.value(), a, b, next_span, chain)) return;
      chain.clear();
    }
    if (!follow_geometry(piece.segment, a, b, chain)) {
      chain.clear();
      error("input segment ", piece.segment, " is not a chain of mesh edges between vertices ", a, " and ",
            b);
    } else if (has_all_arrays()) {
      error("not all edges of input segment ", piece.segment, " between vertices ", a, " and ", b,
            " are constrained edges of it");
    }
  }

  bool follow_spans(std::uint32_t segment, std::uint32_t a, std::uint32_t b, std::size_t& next,
                    std::vector<std::uint32_t>& chain) {
    const auto is_ours = [&](std::size_t i) { return i < spans_.size() && spans_[i].segment == segment; };
    while (next < spans_.size() && spans_[next].segment < segment) ++next;
    std::size_t i = next;
    while (is_ours(i) && spans_[i].ends[0] != a) ++i;
    const std::size_t first = i;
    chain.push_back(a);
    while (chain.back() != b && is_ours(i) && spans_[i].ends[0] == chain.back())
      chain.push_back(spans_[i++].ends[1]);
    if (chain.back() != b) return false;
    for (std::size_t k = first; k < i; ++k) spans_[k].is_explained = true;
    next = i;
    return true;
  }

  /// Always to the nearest neighbour ahead that is on the segment.
  bool follow_geometry(Segment_index segment, std::uint32_t a, std::uint32_t b,
                       std::vector<std::uint32_t>& chain) const {
    const Line line = line_of(segment);
    const double goal = line.along(mesh_.points[b]);
    double position = line.along(mesh_.points[a]);
    chain.push_back(a);
    while (chain.back() != b) {
      std::uint32_t best = none_;
      double best_position = std::numeric_limits<double>::infinity();
      half_edges_.for_each_neighbor(chain.back(), [&](std::uint32_t v) {
        const double t = line.along(mesh_.points[v]);
        if (t > position && t < best_position && (v == b || t < goal) &&
            line.off(mesh_.points[v]) <= epsilon_)
          best = v, best_position = t;
      });
      if (best == none_) return false;
      chain.push_back(best);
      position = best_position;
    }
    return true;
  }

  void check_sides(const Piece& piece, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t left = half_edges_.find(a, b).half_edge, right = half_edges_.find(b, a).half_edge;
    if (left != none_) is_constrained_[left] = 1;
    if (right != none_) is_constrained_[right] = 1;
    if (!has_domain()) return;
    if (piece.is_domain_left != (left != none_)) side_error(piece, a, b, left);
    if (piece.is_domain_right != (right != none_)) side_error(piece, b, a, right);
  }
  void side_error(const Piece& piece, std::uint32_t a, std::uint32_t b, std::uint32_t half_edge) {
    if (half_edge == none_)
      error("no triangle on the left of edge ", a, " ", b, " of input segment ", piece.segment,
            ", where the domain is");
    else
      error("triangle ", half_edge / 3, " on the left of edge ", a, " ", b, " of input segment ",
            piece.segment, " is outside the domain");
  }

  void check_unexplained_constrained_edges() {
    for (std::size_t i = 0; i < spans_.size(); ++i)
      if (!spans_[i].is_explained)
        error("constrained edge ", spans_[i].ends[0], " ", spans_[i].ends[1],
              " is listed twice, or input segment ", spans_[i].segment, " is not the first one along it");
  }

  void check_border() {
    for (std::uint32_t h = 0; h < opposites_.size(); ++h)
      if (opposites_[h] == none_ && is_constrained_[h] == 0)
        error("edge ", half_edges_.origin(h), " ", half_edges_.target(h), " of triangle ", h / 3,
              " is on the border of the mesh, but on no input segment");
  }

  void check_area_and_euler(const Domain& domain) {
    quality_.domain_area = domain.area();
    long double area = 0;
    for (const auto& t : mesh_.triangles) {
      const Point &p = mesh_.point(t[0]), &q = mesh_.point(t[1]), &r = mesh_.point(t[2]);
      area += 0.5 * ((q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y()));
    }
    const auto mesh_area = static_cast<double>(area);
    if (!(std::abs(mesh_area - domain.area()) <= options_.tolerance_of_area * domain.area()))
      error("the area of the mesh is ", mesh_area, ", that of the domain ", domain.area());
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
  Mesh_quality_2& quality_;
  double epsilon_ = 0;
  Half_edges half_edges_{no_triangles(), 0};
  std::vector<std::uint32_t> opposites_;
  std::vector<char> is_constrained_;
  std::vector<std::uint32_t> representative_; // of an input place: the vertex there that the mesh uses
  std::vector<Span> spans_;
  std::vector<std::uint32_t> segment_of_vertex_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> segments_through_;

  static const Half_edges::Triangles& no_triangles() {
    static const Half_edges::Triangles none;
    return none;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_CHECKER_H
