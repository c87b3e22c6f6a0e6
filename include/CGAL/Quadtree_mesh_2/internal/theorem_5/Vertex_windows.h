// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Vertices at which leaves are split until a rule is certain to meet the bound.
//
// Computes: for each of some vertices, its window: 7 x 7 squares of the size of the vertex's leaf around that
//           leaf, and those over the next columns along each edge of the vertex, within 3 of the edge. A strip
//           ends at the 4th grid line ahead if the sectors on both sides of the edge have at least 60
//           degrees, and at the 6th otherwise. The conditions of a window:
//           - Its squares are leaves, but for those outside the root. None over the next column is split; what is
//             there is not in the window.
//           - Neither they nor the squares next to them meet another vertex, or an edge that does not end at the
//             vertex.
//           - No leaf is in two windows.
//           Where one fails, the vertex's leaf is split, or a leaf that is larger than it.
// Bound:    O(depth) for each square. A window has at most 49 squares and 100 more for each edge.
// Source:   ours. In such a window Vertex_window.h and Column_rule.h have angles of at least 20.7 degrees in sectors
//           of at least 33 (doc/guarantees.md).
//
// Splitting ends: a leaf of a vertex is split only while something else is within a constant number of its sides.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_WINDOWS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_WINDOWS_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_closure.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Edge_columns.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Edge_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_problem.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Vertex_rays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Tree, class Geometry>
class Vertex_windows {
public:
  using Word = typename Tree::Word;
  using Grid_point = typename Tree::Grid_point;
  using Rays = Vertex_rays<Geometry>;

  explicit Vertex_windows(const Meshing_problem<Geometry>& problem) : problem_(problem) {}

  bool empty() const { return windows_.empty(); }
  std::size_t size() const { return windows_.size(); }
  const Rays& operator[](std::size_t w) const { return windows_[w].rays; }
  /// How many of them hold.
  std::size_t number_settled() const {
    return static_cast<std::size_t>(std::count_if(windows_.begin(), windows_.end(),
                                                  [](const Window& w) { return w.state == State::SETTLED; }));
  }

  /// Whether there is a window at a vertex, whatever its leaves are.
  bool has(Vertex_id v) const { return !empty() && number_of_[v] != none; }
  void add(Vertex_id v) {
    if (has(v)) return;
    if (empty())
      number_of_ = Indexed_vector<Vertex_id, std::uint32_t>(problem_.number_of_input_points(), none);
    number_of_[v] = static_cast<std::uint32_t>(windows_.size());
    windows_.push_back({Rays(problem_, v), State::NEW});
  }

  /// The leaves at which a condition fails, in order.
  template <class ConcurrencyTag>
  std::vector<Leaf_index> leaves_to_split(const Tree& tree, const Leaf_pieces& pieces) {
    if (empty()) return {};
    std::vector<Leaf_index> leaves = look_at<ConcurrencyTag>(tree, pieces, Which::UNSETTLED);
    if (leaves.empty()) leaves = look_at<ConcurrencyTag>(tree, pieces, Which::ALL);
    return leaves;
  }

  /// Names the windows of leaves in a tree that will be split no more. Windows whose conditions fail, because
  /// coordinates have no room for smaller leaves, have none.
  template <class ConcurrencyTag>
  void settle(const Tree& tree, const Leaf_pieces& pieces) {
    if (!empty()) look_at<ConcurrencyTag>(tree, pieces, Which::ALL);
  }

  static constexpr std::uint32_t none = 0xffffffffu;

  /// The window that holds at a vertex, by number; or `none`.
  std::uint32_t at(Vertex_id v) const {
    if (!has(v)) return none;
    return windows_[number_of_[v]].state == State::SETTLED ? number_of_[v] : none;
  }
  /// The window with a leaf.
  std::uint32_t of(Leaf_index l) const { return empty() ? none : window_of_[l]; }

private:
  enum class State : std::uint8_t { NEW, BROKEN, SETTLED };
  enum class Which { UNSETTLED, ALL };
  /// What a square has to be.
  enum class Part {
    LEAF,          ///< a leaf of the window
    NEXT_COLUMN,   ///< behind the last grid line of an edge: no smaller, and not in the window
    FREE_OF_OTHERS ///< without other features, as the others
  };

  struct Window {
    Rays rays;
    State state;
  };
  /// What a look at some windows gives.
  struct Findings {
    std::vector<Leaf_index> to_split;
    std::vector<std::pair<Leaf_index, std::uint32_t>> leaves; // of windows
  };

  static constexpr int reach_ = 3, margin_ = 1;
  static constexpr std::size_t block_ = 16;

  const Meshing_problem<Geometry>& problem_;
  std::vector<Window> windows_;
  Indexed_vector<Vertex_id, std::uint32_t> number_of_;
  Indexed_vector<Leaf_index, std::uint32_t> window_of_;

  static Leaf_index leaf_of(const Tree& tree, Vertex_id v) { return tree.leaf(Point_index(std::size_t(v))); }

  template <class ConcurrencyTag>
  std::vector<Leaf_index> look_at(const Tree& tree, const Leaf_pieces& pieces, Which which) {
    const std::size_t n = windows_.size();
    std::vector<Findings> found((n + block_ - 1) / block_);
    for_each_block<ConcurrencyTag>(n, block_, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (std::size_t w = begin; w < end; ++w)
        if (which == Which::ALL || windows_[w].state != State::SETTLED) look_at(tree, pieces, w, found[b]);
    });
    window_of_ = Indexed_vector<Leaf_index, std::uint32_t>(tree.number_of_leaves(), none);
    std::vector<std::vector<Leaf_index>> to_split(1);
    for (const Findings& f : found) {
      to_split[0].insert(to_split[0].end(), f.to_split.begin(), f.to_split.end());
      for (const auto& [l, w] : f.leaves) claim(tree, l, w, to_split[0]);
    }
    return in_order<ConcurrencyTag>(to_split, tree.number_of_leaves());
  }

  /// A leaf in two windows is too large for both.
  void claim(const Tree& tree, Leaf_index l, std::uint32_t w, std::vector<Leaf_index>& to_split) {
    std::uint32_t& owner = window_of_[l];
    if (owner != none && owner != w)
      for (const std::uint32_t u : {owner, w}) {
        windows_[u].state = State::BROKEN;
        to_split.push_back(leaf_of(tree, windows_[u].rays.vertex()));
      }
    owner = w;
  }

  void look_at(const Tree& tree, const Leaf_pieces& pieces, std::size_t w, Findings& found) {
    const Rays& rays = windows_[w].rays;
    const Leaf_index own = leaf_of(tree, rays.vertex());
    const std::size_t first = found.leaves.size(), first_to_split = found.to_split.size();
    std::vector<Leaf_index> in_next_columns;
    bool is_too_large = false;
    for_each_square(tree, rays, own, [&](const Grid_point& p, Part part) {
      const Leaf_index l = tree.locate(p);
      const int finer = tree.level(l) - tree.level(own);
      is_too_large = is_too_large || has_others(tree, pieces, rays.vertex(), l) ||
                     (part != Part::FREE_OF_OTHERS && finer > 0);
      if (part == Part::NEXT_COLUMN) in_next_columns.push_back(l);
      if (part != Part::LEAF) return;
      if (finer < 0) found.to_split.push_back(l);
      found.leaves.emplace_back(l, static_cast<std::uint32_t>(w));
    });
    if (is_too_large) found.to_split.push_back(own);
    const bool holds = found.to_split.size() == first_to_split;
    windows_[w].state = holds ? State::SETTLED : State::BROKEN;
    const auto is_out = [&](const auto& leaf) {
      return !holds ||
             std::find(in_next_columns.begin(), in_next_columns.end(), leaf.first) != in_next_columns.end();
    };
    const auto begin = found.leaves.begin() + static_cast<std::ptrdiff_t>(first);
    found.leaves.erase(std::remove_if(begin, found.leaves.end(), is_out), found.leaves.end());
  }

  /// Whether a leaf has another vertex, or a piece of an edge that does not end at this one.
  bool has_others(const Tree& tree, const Leaf_pieces& pieces, Vertex_id v, Leaf_index l) const {
    const auto points = tree.points(l);
    if (points.end.value() - points.begin.value() > (l == leaf_of(tree, v) ? 1u : 0u)) return true;
    return std::any_of(pieces[l].begin(), pieces[l].end(), [&](const Edge_piece& p) {
      const Input_edge& e = problem_.edges[static_cast<Edge_id>(p.segment.value())];
      return e.a != v && e.b != v;
    });
  }

  /// Calls `f(point, part)` for the squares that matter, by their lower left corners, some of them several times.
  template <class F>
  void for_each_square(const Tree& tree, const Rays& rays, Leaf_index own, const F& f) const {
    using Product = typename Edge_line<Word>::Product;
    const auto s = tree.square(own);
    const int depth = tree.framework().grid().depth();
    const Product side(Word_operations<Word>::power_of_two(depth - s.level)),
        root(Word_operations<Word>::power_of_two(depth));
    const auto visit = [&](const Product& x, const Product& y, Part part) {
      if (x >= 0 && y >= 0 && x < root && y < root)
        f(Grid_point{static_cast<Word>(x), static_cast<Word>(y)}, part);
    };
    constexpr int far = reach_ + margin_;
    for (int i = -far; i <= far; ++i)
      for (int j = -far; j <= far; ++j)
        visit(Product(Product(s.x) + side * i), Product(Product(s.y) + side * j),
              std::max(std::abs(i), std::abs(j)) > reach_ ? Part::FREE_OF_OTHERS : Part::LEAF);
    for (const Vertex_ray& r : rays) for_each_square_along(tree, rays.vertex(), r, own, side, visit);
  }

  template <class Product, class Visit>
  void for_each_square_along(const Tree& tree, Vertex_id v, const Vertex_ray& r, Leaf_index own,
                             const Product& side, const Visit& visit) const {
    const Input_edge& e = problem_.edges[r.edge];
    const Edge_line<Word> line = line_of_segment(
        tree, std::array{Vertex_index(std::size_t(v)), Vertex_index(std::size_t(e.a == v ? e.b : e.a))});
    const auto& framework = tree.framework();
    const auto place = [&](Vertex_id w) {
      return line.u(framework.grid_point(framework.rank(Point_index(std::size_t(w)))));
    };
    const bool is_ascending = Product(place(v)) == Product(line.first_u());
    const auto s = tree.square(own);
    const Product start(line.u({s.x, s.y}));
    for (int k = 0; k <= r.lines + margin_; ++k) {
      // Sums of wide words are expressions, each of a type of its own.
      const Product left = is_ascending ? Product(start + side * k) : Product(start - side * k),
                    right = left + side;
      const Product low = std::min(line.floor_of_v(left), line.floor_of_v(right)) - side * reach_,
                    high = std::max(line.ceiling_of_v(left), line.ceiling_of_v(right)) + side * reach_;
      const Product lowest = std::max(Product(low - side * margin_), Product(0));
      for (Product w = lowest - lowest % side; w < high + side * margin_; w += side) {
        const bool is_inside = w + side > low && w < high;
        const Part part = !is_inside || k > r.lines ? Part::FREE_OF_OTHERS
                          : k == r.lines            ? Part::NEXT_COLUMN
                                                    : Part::LEAF;
        if (line.is_steep())
          visit(w, left, part);
        else
          visit(left, w, part);
      }
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_WINDOWS_H
