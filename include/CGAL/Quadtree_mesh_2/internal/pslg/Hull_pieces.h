// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_HULL_PIECES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_HULL_PIECES_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The border of the convex hull of a graph's vertices, cut at those that lie on it. See `add_convex_hull_2()`.
template <class Point>
class Hull_pieces {
public:
  using Piece = std::array<Vertex_index, 2>;

  /// Keeps a reference.
  explicit Hull_pieces(const Pslg_2<Point>& pslg) : pslg_(pslg) { find_border(); }

  /// The pieces on which no segment lies, counterclockwise.
  std::vector<Piece> missing() const {
    std::vector<Piece> pieces;
    const std::vector<char> is_covered = covered();
    for (std::size_t i = 0; i < border_.size(); ++i)
      if (is_covered[i] == 0) pieces.push_back({border_[i], border_[(i + 1) % border_.size()]});
    return pieces;
  }

private:
  const Pslg_2<Point>& pslg_;
  std::vector<Vertex_index> sorted_; // by places; of those at one place the first
  std::vector<Vertex_index> border_; // counterclockwise from a corner; empty if all is on a line

  Orientation orientation(Vertex_index a, Vertex_index b, Vertex_index c) const {
    using Kernel = typename Kernel_traits<Point>::Kernel;
    return Kernel().orientation_2_object()(pslg_.point(a), pslg_.point(b), pslg_.point(c));
  }
  bool is_before(Vertex_index a, Vertex_index b) const {
    const Point &p = pslg_.point(a), &q = pslg_.point(b);
    return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
  }
  bool is_at_place_of(Vertex_index a, Vertex_index b) const {
    return pslg_.point(a).x() == pslg_.point(b).x() && pslg_.point(a).y() == pslg_.point(b).y();
  }

  /// The lower border from left to right, then the upper one back. Vertices on it are kept.
  void find_border() {
    for (std::size_t v = 0; v < pslg_.number_of_vertices(); ++v) sorted_.push_back(Vertex_index(v));
    std::stable_sort(sorted_.begin(), sorted_.end(),
                     [this](Vertex_index a, Vertex_index b) { return is_before(a, b); });
    sorted_.erase(std::unique(sorted_.begin(), sorted_.end(),
                              [this](Vertex_index a, Vertex_index b) { return is_at_place_of(a, b); }),
                  sorted_.end());
    const bool is_line =
        sorted_.size() < 3 || std::all_of(sorted_.begin() + 1, sorted_.end() - 1, [this](Vertex_index v) {
          return orientation(sorted_.front(), sorted_.back(), v) == COLLINEAR;
        });
    if (is_line) return;
    append_chain(sorted_.begin(), sorted_.end());
    append_chain(sorted_.rbegin(), sorted_.rend());
  }

  /// Without the last one, with which the other chain begins.
  template <class Iterator>
  void append_chain(Iterator begin, Iterator end) {
    const std::size_t first = border_.size();
    for (; begin != end; ++begin) {
      while (border_.size() >= first + 2 &&
             orientation(border_[border_.size() - 2], border_.back(), *begin) == RIGHT_TURN)
        border_.pop_back();
      border_.push_back(*begin);
    }
    border_.pop_back();
  }

  /// Per piece, whether a segment lies on it.
  std::vector<char> covered() const {
    const std::size_t n = border_.size(), none = pslg_.number_of_vertices();
    std::vector<std::size_t> place(none, n); // of a vertex on the border, or of the one at its place
    for (std::size_t i = 0; i < n; ++i) place[std::size_t(border_[i])] = i;
    std::vector<std::size_t> side(n + 1, 0); // of the hull, that a piece is on
    for (std::size_t i = 1; i < n; ++i)
      side[i] =
          side[i - 1] + (orientation(border_[i - 1], border_[i], border_[(i + 1) % n]) == COLLINEAR ? 0 : 1);
    std::vector<std::ptrdiff_t> begun(n + 1, 0); // how many segments begin at a vertex, less those that end
    for (const auto& s : pslg_.segments) {
      std::size_t i = place_of(s[0], place), j = place_of(s[1], place);
      if (i == n || j == n || i == j) continue;
      if (i > j) std::swap(i, j);
      if (i == 0 && side[j] == side[n - 1] && side[0] != side[j]) i = j, j = n; // back to the first vertex
      if (side[i] == side[j - 1]) ++begun[i], --begun[j];
    }
    std::partial_sum(begun.begin(), begun.end(), begun.begin());
    std::vector<char> result(n);
    std::transform(begun.begin(), begun.end() - 1, result.begin(), [](std::ptrdiff_t k) { return k > 0; });
    return result;
  }

  std::size_t place_of(Vertex_index v, const std::vector<std::size_t>& place) const {
    const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), v,
                                     [this](Vertex_index a, Vertex_index b) { return is_before(a, b); });
    return place[std::size_t(*at)];
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_HULL_PIECES_H
