// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_INPUT_DOMAIN_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_INPUT_DOMAIN_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Indexed_cdt.h>
#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The domain of a planar straight-line graph, by a constrained Delaunay triangulation of the graph alone. It
/// is everything not connected to infinity, or what another rule leaves of that, except the components of
/// hole points.
///
/// The segments become *pieces*: edges between input vertices without others between them. Each piece occurs
/// once, however many segments overlap there, with the faces on either side. O(n log n) in practice.
template <class Kernel>
class Input_domain {
public:
  using Point = typename Kernel::Point_2;
  static constexpr std::uint32_t none = 0xffffffffu;

  struct Piece {
    std::array<std::uint32_t, 2> ends; ///< places, in the direction of `segment`
    Segment_index segment;             ///< the first input segment that covers it
    bool is_domain_left = false;       ///< seen from `ends[0]` toward `ends[1]`
    bool is_domain_right = false;
    /// The places that make triangles with the piece, left and right; `none` at infinity.
    std::array<std::uint32_t, 2> apexes{none, none};
    /// The first marks of the components left and right, -1 for none.
    std::array<int, 2> marks{-1, -1};

    bool is_in_domain() const { return is_domain_left || is_domain_right; }
  };

  /// \param segments pairs of positions in `points`, all in range.
  /// \param marks points of components, which `Rule::MARKED_BY_REGIONS` leaves
  template <class Segments>
  Input_domain(const std::vector<Point>& points, const Segments& segments, const std::vector<Point>& holes,
               Mesh_quality_options_2::Domain rule = Mesh_quality_options_2::Domain::ENCLOSED_BY_SEGMENTS,
               const std::vector<Point>& marks = {})
      : cdt_(points, all_indices(points.size())), is_touched_(points.size(), 0) {
    for (const auto& s : segments) cdt_.count_segment(s[0].value(), s[1].value());
    for (const auto& s : segments)
      if (!cdt_.has_crossings()) cdt_.insert_segment(s[0].value(), s[1].value());
    if (cdt_.has_crossings()) return;
    if (cdt_.cdt().dimension() == 2) {
      const std::vector<Face_handle> at_holes = locate(holes, ambiguous_holes_);
      const std::vector<Face_handle> at_marks = locate(marks, ambiguous_marks_);
      exclude(cdt_.cdt().infinite_face());
      if (rule == Mesh_quality_options_2::Domain::MARKED_BY_REGIONS) keep_marked(at_marks);
      if (rule == Mesh_quality_options_2::Domain::NESTING_PARITY) keep_odd();
      for (Face_handle f : at_holes)
        if (f->info().is_in_domain) exclude(f);
      label(at_marks);
      count();
    }
    for (std::size_t s = 0; s < segments.size(); ++s)
      add_pieces(Segment_index(s), segments[s][0].value(), segments[s][1].value());
  }

  /// Whether two segments cross in the interior of both: then this is no planar straight-line graph and
  /// nothing else here has a meaning.
  bool has_crossings() const { return cdt_.has_crossings(); }
  /// Holes, and marks, on segments that separate components: nobody can tell which of them is meant.
  const std::vector<std::size_t>& ambiguous_holes() const { return ambiguous_holes_; }
  const std::vector<std::size_t>& ambiguous_marks() const { return ambiguous_marks_; }
  /// Pieces of one segment are in its order, from its first vertex to its last; segments in their order.
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// All pairs (piece, segment that covers it).
  const std::vector<std::pair<std::uint32_t, Segment_index>>& covers() const { return covers_; }
  /// The first input vertex with the coordinates of vertex `i`.
  std::uint32_t place(std::uint32_t i) const { return cdt_.place(i); }
  /// Whether the closed domain contains the vertex.
  bool is_touched(std::uint32_t i) const { return is_touched_[place(i)] != 0; }
  /// Calls `visit(p, q, r)` for the corners of the triangles that the domain is made of.
  template <class Visitor>
  void for_each_triangle(Visitor visit) const {
    if (cdt_.cdt().dimension() < 2) return;
    for (Face_handle f : cdt_.cdt().finite_face_handles())
      if (f->info().is_in_domain) visit(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
  }
  /// Vertices minus edges plus triangles of the domain.
  std::ptrdiff_t euler_characteristic() const { return euler_; }

private:
  struct Face_info {
    bool is_in_domain = true;
    int mark = -1;
    std::array<std::uint32_t, 3> piece{none, none, none};
  };
  using Triangulation =
      Indexed_cdt<Kernel, Face_info, No_constraint_intersection_requiring_constructions_tag>;
  using Face_handle = typename Triangulation::Face_handle;
  using Cdt = typename Triangulation::Cdt;

  static std::vector<std::size_t> all_indices(std::size_t n) {
    std::vector<std::size_t> result(n);
    std::iota(result.begin(), result.end(), std::size_t(0));
    return result;
  }

  /// A face at each of the points. Those on segments with different components at their sides are noted.
  std::vector<Face_handle> locate(const std::vector<Point>& points, std::vector<std::size_t>& ambiguous) {
    std::vector<Face_handle> faces;
    for (const Point& p : points) {
      typename Cdt::Locate_type type;
      int i = 0;
      const Face_handle f = cdt_.cdt().locate(p, type, i, faces.empty() ? Face_handle() : faces.back());
      if ((type == Cdt::EDGE && !is_one_component({f, f->neighbor(i)})) ||
          (type == Cdt::VERTEX && !is_one_component(faces_around(f->vertex(i)))))
        ambiguous.push_back(faces.size());
      faces.push_back(f);
    }
    return faces;
  }

  std::vector<Face_handle> faces_around(typename Cdt::Vertex_handle v) {
    std::vector<Face_handle> faces;
    auto f = cdt_.cdt().incident_faces(v);
    const auto first = f;
    do faces.push_back(f);
    while (++f != first);
    return faces;
  }

  bool is_one_component(const std::vector<Face_handle>& faces) {
    std::set<Face_handle> component;
    for_component(faces[0], [&](Face_handle f) { component.insert(f); });
    return std::all_of(faces.begin(), faces.end(), [&](Face_handle f) { return component.count(f) > 0; });
  }

  /// Calls `f` for the faces of the component of `first`.
  template <class Function>
  void for_component(Face_handle first, Function f) {
    std::vector<Face_handle> stack{first};
    std::set<Face_handle> reached{first};
    while (!stack.empty()) {
      const Face_handle face = stack.back();
      stack.pop_back();
      f(face);
      for (int i = 0; i < 3; ++i)
        if (!face->is_constrained(i) && reached.insert(face->neighbor(i)).second)
          stack.push_back(face->neighbor(i));
    }
  }

  void exclude(Face_handle first) {
    first->info().is_in_domain = false;
    std::vector<Face_handle> stack{first};
    while (!stack.empty()) {
      const Face_handle f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        if (f->is_constrained(i) || !g->info().is_in_domain) continue;
        g->info().is_in_domain = false;
        stack.push_back(g);
      }
    }
  }

  void keep_marked(const std::vector<Face_handle>& marked) {
    std::set<Face_handle> kept;
    for (const Face_handle at : marked)
      if (at->info().is_in_domain && kept.count(at) == 0)
        for_component(at, [&](Face_handle f) { kept.insert(f); });
    for (Face_handle f : cdt_.cdt().finite_face_handles()) f->info().is_in_domain = kept.count(f) > 0;
  }

  void label(const std::vector<Face_handle>& marked) {
    for (std::size_t i = 0; i < marked.size(); ++i)
      if (marked[i]->info().is_in_domain && marked[i]->info().mark < 0)
        for_component(marked[i], [i](Face_handle f) { f->info().mark = static_cast<int>(i); });
  }

  /// Relaxes the number of segments between infinity and each face until none falls: slow, and like nothing
  /// the mesher does.
  void keep_odd() {
    std::map<Face_handle, int> depth;
    std::deque<Face_handle> open{cdt_.cdt().infinite_face()};
    depth[open.front()] = 0;
    while (!open.empty()) {
      const Face_handle f = open.front();
      open.pop_front();
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        const int through = depth[f] + (f->is_constrained(i) ? 1 : 0);
        const auto [place, is_new] = depth.emplace(g, through);
        if (!is_new && place->second <= through) continue;
        place->second = through;
        open.push_back(g);
      }
    }
    for (Face_handle f : cdt_.cdt().finite_face_handles()) f->info().is_in_domain = depth.at(f) % 2 == 1;
  }

  void count() {
    std::ptrdiff_t faces = 0, sides = 0, vertices = 0;
    for (Face_handle f : cdt_.cdt().finite_face_handles()) {
      if (!f->info().is_in_domain) continue;
      ++faces;
      for (int i = 0; i < 3; ++i) {
        sides += f->neighbor(i)->info().is_in_domain ? 1 : 2; // an edge on the border has one side only
        char& touched = is_touched_[f->vertex(i)->info()];
        vertices += touched == 0;
        touched = 1;
      }
    }
    euler_ = vertices - sides / 2 + faces;
  }

  struct Step {
    Face_handle face;
    int side;
    bool is_left_of_segment; // the face, seen along the segment from its first vertex to its second
  };

  void add_pieces(Segment_index segment, std::uint32_t a, std::uint32_t b) {
    const bool is_reversed = cdt_.is_reversed(a, b);
    steps_.clear();
    cdt_.walk_segment(a, b, [&](Face_handle f, int i, bool is_left_of_walk) {
      steps_.push_back({f, i, is_left_of_walk != is_reversed});
    });
    if (is_reversed) std::reverse(steps_.begin(), steps_.end());
    for (const Step& step : steps_) {
      std::uint32_t& piece = step.face->info().piece[std::size_t(step.side)];
      if (piece == none) add_piece(segment, step);
      covers_.emplace_back(piece, segment);
    }
  }

  void add_piece(Segment_index segment, const Step& step) {
    const Face_handle f = step.face, g = f->neighbor(step.side);
    const auto number = static_cast<std::uint32_t>(pieces_.size());
    f->info().piece[std::size_t(step.side)] = number;
    Piece piece;
    piece.ends = {f->vertex(Cdt::ccw(step.side))->info(), f->vertex(Cdt::cw(step.side))->info()};
    piece.segment = segment;
    if (cdt_.cdt().dimension() == 2) {
      g->info().piece[std::size_t(cdt_.cdt().mirror_index(f, step.side))] = number;
      piece.is_domain_left = f->info().is_in_domain;
      piece.is_domain_right = g->info().is_in_domain;
      piece.marks = {f->info().mark, g->info().mark};
      piece.apexes = {place(f->vertex(step.side)), place(cdt_.cdt().mirror_vertex(f, step.side))};
    }
    if (!step.is_left_of_segment) {
      std::swap(piece.ends[0], piece.ends[1]);
      std::swap(piece.is_domain_left, piece.is_domain_right);
      std::swap(piece.marks[0], piece.marks[1]);
      std::swap(piece.apexes[0], piece.apexes[1]);
    }
    pieces_.push_back(piece);
  }

  std::uint32_t place(typename Cdt::Vertex_handle v) const {
    return cdt_.cdt().is_infinite(v) ? none : v->info();
  }

  Triangulation cdt_;
  std::vector<std::size_t> ambiguous_holes_, ambiguous_marks_;
  std::vector<Piece> pieces_;
  std::vector<std::pair<std::uint32_t, Segment_index>> covers_;
  std::vector<Step> steps_;
  std::vector<char> is_touched_;
  std::ptrdiff_t euler_ = 0;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_INPUT_DOMAIN_H
