// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The mesh of tiles of a quadtree.
//
// Computes: for sites with levels, the smallest quadtree, balanced across sides and corners, whose leaves
//           around the sites have these levels. For each leaf, the triangles of its tile. For the blocks of
//           warped and star sites, the places to which their vertices move. All places are integers.
// Bound:    O(n + k) work for n sites and k squares, not counting sorting; rounds as for the quadtree.
// Source:   Bern, Eppstein, Teng, section 5, Theorem 3: tiles cut the leaves of a balanced quadtree into
//           triangles, and are warped around points.
// Deviates: a tile depends on one bit for each corner of the leaf, whether a smaller leaf touches it
//           (tile_tables.h). So balance across corners suffices, and the two rounds of splitting that the
//           paper adds are not needed.
//
// Points in the middle of their squares, annotated with the level, force the blocks. Vertices of neighboring
// tiles are identified by their places: all vertices of all tiles are sorted in shuffle order, which also
// makes the numbers of vertices local.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_MESH_BUILDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_MESH_BUILDER_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_sites.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/tile_blocks.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Points that ask for the leaves of a mesh of tiles.
struct Tile_demands {
  Uninitialized_vector<Tile_site> places;
  Uninitialized_vector<int> levels; ///< of the leaves that hold them
};

/// The demands of sites, first; of the squares of their blocks, where there is room; of the squares of the
/// window.
template <class ConcurrencyTag>
Tile_demands tile_demands(const Tile_sites& sites) {
  Tile_demands all;
  const Tile_window& window = sites.window;
  const std::uint64_t columns = window.x1 - window.x0;
  const std::size_t cells =
      window.level == 0 ? 0 : static_cast<std::size_t>(columns * (window.y1 - window.y0));
  const auto force = [&](std::size_t i, const Tile_square& s) { // by the middle of the square
    const std::uint64_t half = std::uint64_t(1) << (tile_log_side(s.level) - 1);
    all.places[i] = {s.x + half, s.y + half};
    all.levels[i] = s.level;
  };
  const auto block = [&](std::size_t i) {
    return tile_block(sites.places[i], sites.kind(i), sites.level(i));
  };
  const auto squares = [&](std::size_t i) -> std::size_t {
    if (sites.kind(i) == Site_kind::ON_DEMAND || !window.contains_block(block(i))) return 0;
    return static_cast<std::size_t>(block(i).number_of_squares());
  };
  const std::size_t in_blocks = count_allocate_and_place<ConcurrencyTag>(
      sites.size(),
      [&](std::size_t begin, std::size_t end) {
        std::size_t sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += squares(i);
        return sum;
      },
      [&](std::size_t sum) {
        all.places.resize(sites.size() + sum + cells);
        all.levels.resize(sites.size() + sum + cells);
      },
      [&](std::size_t begin, std::size_t end, std::size_t first) {
        std::size_t next = sites.size() + first;
        for (std::size_t i = begin; i < end; ++i) {
          all.places[i] = sites.places[i];
          all.levels[i] = sites.level(i);
          const std::size_t n = squares(i);
          for (std::size_t k = 0; k < n; ++k) force(next++, block(i).square(static_cast<int>(k)));
        }
      });
  const int shift = tile_log_side(window.level);
  for_each_index<ConcurrencyTag>(cells, [&](std::size_t i) {
    force(sites.size() + in_blocks + i,
          {(window.x0 + i % columns) << shift, (window.y0 + i / columns) << shift, window.level});
  });
  return all;
}

/// The smallest quadtree that meets the demands of sites.
template <class ConcurrencyTag>
Balanced_quadtree<Tile_traits, ConcurrencyTag> tile_quadtree(const Tile_sites& sites) {
  using Quadtree = Balanced_quadtree<Tile_traits, ConcurrencyTag>;
  const Tile_demands demands = tile_demands<ConcurrencyTag>(sites);
  typename Quadtree::Framework framework(demands.places);
  std::vector<int> levels(framework.number_of_points());
  for_each_index<ConcurrencyTag>(levels.size(), [&](std::size_t r) {
    levels[r] = demands.levels[framework.input_point(Point_rank(r)).value()];
  });
  for (const Duplicate_point& d : framework.duplicates()) {
    // Places of sites are rounded.
    if (d.duplicate.value() < sites.size()) throw Tile_level_error(d.duplicate.value());
    int& level = levels[framework.rank(d.kept).value()];
    level = std::max(level, demands.levels[d.duplicate.value()]);
  }
  framework.annotate(levels);
  // Only the levels count, not how many points a leaf has.
  return Quadtree(std::move(framework),
                  Quadtree_options().max_points_per_leaf(std::numeric_limits<std::size_t>::max()));
}

/// Leaves in the window that follow each other in shuffle order, by their numbers.
struct Leaf_run {
  std::size_t begin, end;

  std::size_t size() const { return end - begin; }
  bool contains(std::size_t leaf) const { return begin <= leaf && leaf < end; }
};

/// Builds the mesh of tiles of sites, or of a run of the leaves.
template <class ConcurrencyTag = Sequential_tag>
class Tile_mesh_builder {
public:
  /// \throws Tile_level_error if a site wants a leaf that would be too small, std::length_error if there are too many
  ///         vertices.
  explicit Tile_mesh_builder(const Tile_sites& sites) : sites_(sites) {
    check_tile_sites(sites);
    tree_ = tile_quadtree<ConcurrencyTag>(sites_);
    number_leaves();
  }

  std::size_t number_of_leaves() const { return kept_.size(); }
  /// The number of the leaf in which a site lies.
  std::size_t leaf_of_site(std::size_t i) const { return number_of_leaf_[tree_.leaf(Point_index(i))]; }
  int level_of_leaf(std::size_t leaf) const { return tree_.level(Leaf_index(kept_[leaf])); }
  Tile_place corner_of_leaf(std::size_t leaf) const {
    const Tile_square s = tree_.square(tree_.node(Leaf_index(kept_[leaf])));
    return {s.x, s.y};
  }
  /// The leaf that contains a place of the window.
  std::size_t leaf_at(const Tile_place& p) const { return number_of_leaf_[tree_.locate(p)]; }
  unsigned corner_bits_of_leaf(std::size_t leaf) const { return corner_bits_[leaf]; }

  Tile_mesh build() { return build({0, number_of_leaves()}, all_sites()); }
  /// The mesh of a run, whose sites are given; what it has by site is by the place in that list. Vertices that
  /// leaves outside of the run share are frozen.
  /// \pre the run has all leaves, or there are no blocks
  Tile_mesh build(Leaf_run run, const std::vector<std::uint32_t>& sites_of_run) {
    run_ = run;
    list_leaves();
    count_parts();
    identify_vertices();
    fill_triangles();
    find_leaves_of_sites(sites_of_run);
    freeze_rim();
    move_blocks();
    return std::move(mesh_);
  }

private:
  using Quadtree = Balanced_quadtree<Tile_traits, ConcurrencyTag>;
  using Places = Uninitialized_vector<Tile_place>;
  static constexpr std::size_t block_length_ =
      default_block / 16; // a leaf has about 16 vertices and triangles
  static constexpr std::uint32_t outside_ = std::numeric_limits<std::uint32_t>::max();

  bool is_in_window(Node_index v) const {
    const Tile_square s = tree_.square(v);
    return s.level >= sites_.window.level && sites_.window.contains(s.x, s.y);
  }

  /// Lists the leaves in the window, and numbers them.
  void number_leaves() {
    kept_ = pack<ConcurrencyTag>(tree_.number_of_leaves(),
                                 [&](std::size_t l) { return is_in_window(tree_.node(Leaf_index(l))); });
    number_of_leaf_.assign(tree_.number_of_leaves(), outside_);
    corner_bits_.resize(kept_.size());
    for_each_index<ConcurrencyTag>(
        kept_.size(),
        [&](std::size_t k) {
          number_of_leaf_[Leaf_index(kept_[k])] = static_cast<std::uint32_t>(k);
          corner_bits_[k] = static_cast<std::uint8_t>(corner_bits(tree_.node(Leaf_index(kept_[k]))));
        },
        block_length_);
  }

  std::vector<std::uint32_t> all_sites() const {
    std::vector<std::uint32_t> all(sites_.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  /// Those of the run.
  void list_leaves() {
    mesh_.leaves.resize(run_.size());
    mesh_.corner_bits.resize(run_.size());
    for_each_index<ConcurrencyTag>(run_.size(), [&](std::size_t k) {
      mesh_.leaves[k] = tree_.square(tree_.node(Leaf_index(kept_[run_.begin + k])));
      mesh_.corner_bits[k] = corner_bits_[run_.begin + k];
    });
  }

  /// Tells for each corner of a leaf whether one of the squares of its size there is split.
  unsigned corner_bits(Node_index v) const {
    std::array<bool, 9> is_split{}; // by direction; east again at the end
    for (const Direction d : all_directions()) {
      const Node_index n = tree_.neighbor(v, d);
      is_split[std::size_t(d)] = n.is_valid() && !tree_.is_leaf(n) && is_in_window(n);
    }
    is_split[8] = is_split[0];
    unsigned bits = 0;
    for (unsigned corner = 0; corner < 4; ++corner) {
      const std::size_t first = (2 * corner + 4) % 8; // the corner is between west and south, and so on
      if (is_split[first] || is_split[first + 1] || is_split[first + 2]) bits |= 1u << corner;
    }
    return bits;
  }

  const Tile& tile_of(std::size_t leaf) const { return tile(mesh_.corner_bits[leaf]); }

  /// Makes room for the vertices and triangles of leaves.
  void count_parts() {
    const std::size_t n = mesh_.number_of_leaves();
    mesh_.first_vertex.resize(n + 1);
    mesh_.first_triangle.resize(n + 1);
    mesh_.first_vertex[n] = mesh_.first_triangle[n] = 0;
    if (n > std::numeric_limits<std::uint32_t>::max() / Tile::max_triangles)
      throw std::length_error("mesh of tiles: too many triangles");
    for_each_index<ConcurrencyTag>(n, [&](std::size_t k) {
      mesh_.first_vertex[k] = static_cast<std::uint32_t>(tile_of(k).number_of_vertices);
      mesh_.first_triangle[k] = static_cast<std::uint32_t>(tile_of(k).number_of_triangles);
    });
    const auto vertices = exclusive_scan<ConcurrencyTag>(mesh_.first_vertex.data(), n + 1);
    const auto triangles = exclusive_scan<ConcurrencyTag>(mesh_.first_triangle.data(), n + 1);
    if (vertices > static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max()))
      throw std::length_error("mesh of tiles: too many vertices");
    mesh_.leaf_vertices.resize(vertices);
    mesh_.triangles.resize(triangles);
  }

  /// Places the vertices of all leaves.
  Places places_of_instances() const {
    Places places(mesh_.leaf_vertices.size());
    for_each_index<ConcurrencyTag>(
        mesh_.number_of_leaves(),
        [&](std::size_t k) {
          const Tile& t = tile_of(k);
          const Tile_square& s = mesh_.leaves[k];
          const int shift = tile_log_side(s.level) - 10;
          Tile_place* const place = places.data() + mesh_.first_vertex[k];
          for (std::size_t v = 0; v < static_cast<std::size_t>(t.number_of_vertices); ++v)
            place[v] = {s.x + (static_cast<std::uint64_t>(t.vertices[v][0]) << shift),
                        s.y + (static_cast<std::uint64_t>(t.vertices[v][1]) << shift)};
        },
        block_length_);
    return places;
  }

  Sorted_keys<Tile_place> sorted_instances() const {
    const Places places = places_of_instances();
    return shuffled<ConcurrencyTag>(places.size(), [&places](std::size_t i) { return places[i]; });
  }

  /// Numbers the distinct places, in shuffle order.
  void identify_vertices() {
    Sorted_keys<Tile_place> sorted = sorted_instances();
    mesh_.instances = std::move(sorted.order);
    const auto place = [&](std::size_t k) -> const Tile_place& { return sorted.keys[k]; };
    const auto is_first = [&](std::size_t k) { return k == 0 || place(k) != place(k - 1); };
    count_allocate_and_place<ConcurrencyTag>(
        sorted.keys.size(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t k = begin; k < end; ++k) sum += is_first(k) ? 1 : 0;
          return sum;
        },
        [&](std::size_t n) { resize_vertices(n); },
        [&](std::size_t begin, std::size_t end, std::size_t next) {
          for (std::size_t k = begin; k < end; ++k) {
            if (is_first(k)) put_vertex(next++, place(k), k);
            mesh_.leaf_vertices[mesh_.instances[k]] = static_cast<std::int32_t>(next - 1);
          }
        });
  }

  void resize_vertices(std::size_t n) {
    mesh_.places.resize(n);
    mesh_.sides.resize(n);
    mesh_.is_frozen.resize(n);
    mesh_.first_instance.resize(n + 1);
    mesh_.first_instance[n] = static_cast<std::uint32_t>(mesh_.instances.size());
  }

  void put_vertex(std::size_t v, const Tile_place& p, std::size_t first_instance) {
    const Tile_window& w = sites_.window;
    mesh_.places[v] = p;
    mesh_.sides[v] =
        static_cast<std::uint8_t>((p.x == w.left() ? left_side : 0) | (p.x == w.right() ? right_side : 0) |
                                  (p.y == w.bottom() ? bottom_side : 0) | (p.y == w.top() ? top_side : 0));
    mesh_.is_frozen[v] = 0;
    mesh_.first_instance[v] = static_cast<std::uint32_t>(first_instance);
  }

  void fill_triangles() {
    for_each_index<ConcurrencyTag>(
        mesh_.number_of_leaves(),
        [&](std::size_t k) {
          const Tile& t = tile_of(k);
          const std::int32_t* const vertex = mesh_.leaf_vertices.data() + mesh_.first_vertex[k];
          std::array<std::int32_t, 3>* const triangle = mesh_.triangles.data() + mesh_.first_triangle[k];
          for (std::size_t i = 0; i < static_cast<std::size_t>(t.number_of_triangles); ++i)
            for (std::size_t j = 0; j < 3; ++j) triangle[i][j] = vertex[t.triangles[i][j]];
        },
        block_length_);
  }

  void find_leaves_of_sites(const std::vector<std::uint32_t>& sites_of_run) {
    mesh_.leaf_of_site.resize(sites_of_run.size());
    mesh_.vertex_of_site.assign(sites_of_run.size(), -1);
    for_each_index<ConcurrencyTag>(sites_of_run.size(), [&](std::size_t i) {
      mesh_.leaf_of_site[i] = static_cast<std::int32_t>(leaf_of_site(sites_of_run[i]) - run_.begin);
    });
  }

  /// \name The rim of a run
  /// @{

  void freeze_rim() {
    if (run_.size() == number_of_leaves()) return;
    const std::vector<std::uint32_t> leaves = pack<ConcurrencyTag>(run_.size(), [&](std::size_t k) {
      return has_neighbor_outside(tree_.node(Leaf_index(kept_[run_.begin + k])));
    });
    for (const std::uint32_t k : leaves)
      for (std::size_t i = mesh_.first_vertex[k]; i < mesh_.first_vertex[k + 1]; ++i) {
        const auto v = static_cast<std::size_t>(mesh_.leaf_vertices[i]);
        if (mesh_.is_frozen[v] == 0 && touches_outside(mesh_.places[v])) mesh_.is_frozen[v] = 1;
      }
  }

  bool has_neighbor_outside(Node_index v) const {
    const Leaf_index first(kept_[run_.begin]), last(kept_[run_.end - 1]);
    for (const Direction d : all_directions()) {
      const Node_index n = tree_.neighbor(v, d);
      if (!n.is_valid()) continue;
      const auto leaves = tree_.leaves(n);
      if (leaves.begin < first || leaves.end.value() > last.value() + 1) return true;
    }
    return false;
  }

  /// Whether a place is a corner, or on the side, of a leaf in the window that is not in the run.
  bool touches_outside(const Tile_place& p) const {
    for (const std::uint64_t x : {p.x - 1, p.x})
      for (const std::uint64_t y : {p.y - 1, p.y})
        if (sites_.window.contains(x, y) && !run_.contains(leaf_at({x, y}))) return true;
    return false;
  }

  /// @}

  /// \name Blocks
  /// @{

  /// The leaves in the place of the squares of a block.
  using Block_leaves = std::array<std::uint32_t, 16>;

  /// Finds the leaves of the block of a site. Returns false if they are not those that the moves are made for.
  bool find_leaves(const Tile_block& block, Block_leaves& leaves) const {
    if (!sites_.window.contains_block(block)) return false;
    for (int i = 0; i < block.number_of_squares(); ++i) {
      const Tile_square s = block.square(i);
      const std::uint32_t leaf = number_of_leaf_[tree_.locate(Tile_place{s.x, s.y})];
      if (mesh_.leaves[leaf].level != block.level || mesh_.corner_bits[leaf] != 0) return false;
      leaves[std::size_t(i)] = leaf;
    }
    return true;
  }

  Tile_block block_of(std::size_t site) const {
    return tile_block(sites_.places[site], sites_.kind(site), sites_.level(site));
  }

  void move_blocks() {
    if (sites_.kinds.empty()) return;
    const std::vector<std::uint32_t> blocks = pack<ConcurrencyTag>(
        sites_.size(), [&](std::size_t i) { return sites_.kind(i) != Site_kind::ON_DEMAND; });
    if (blocks.empty()) return;
    std::vector<Block_leaves> leaves(blocks.size());
    std::vector<std::uint8_t> is_whole(blocks.size());
    for_each_index<ConcurrencyTag>(
        blocks.size(),
        [&](std::size_t b) { is_whole[b] = find_leaves(block_of(blocks[b]), leaves[b]) ? 1 : 0; },
        block_length_);
    break_overlapping(blocks, leaves, is_whole);
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (is_whole[b] == 0)
        mesh_.broken_blocks.push_back(blocks[b]);
      else if (sites_.kind(blocks[b]) == Site_kind::STAR)
        mesh_.stars.push_back({blocks[b], {}});
    const Block_moves moves;
    for_each_index<ConcurrencyTag>(
        blocks.size(),
        [&](std::size_t b) {
          if (is_whole[b] != 0) move_block(moves, blocks[b], leaves[b]);
        },
        block_length_);
  }

  /// Marks whole blocks that share a leaf with another one as not whole.
  void break_overlapping(const std::vector<std::uint32_t>& blocks, const std::vector<Block_leaves>& leaves,
                         std::vector<std::uint8_t>& is_whole) const {
    std::vector<std::uint8_t> uses(mesh_.number_of_leaves(), 0); // 2 for more
    const auto for_each_leaf = [&](std::size_t b, const auto& f) {
      const int n = is_whole[b] != 0 ? block_of(blocks[b]).number_of_squares() : 0;
      for (int i = 0; i < n; ++i) f(leaves[b][std::size_t(i)]);
    };
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for_each_leaf(b, [&](std::uint32_t leaf) { uses[leaf] = uses[leaf] == 0 ? 1 : 2; });
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      bool is_shared = false;
      for_each_leaf(b, [&](std::uint32_t leaf) { is_shared = is_shared || uses[leaf] == 2; });
      if (is_shared) is_whole[b] = 0;
    }
  }

  void move_block(const Block_moves& moves, std::uint32_t site, const Block_leaves& leaves) {
    const Tile_block block = block_of(site);
    const auto target = moves.target(sites_.places[site], sites_.kind(site), block);
    std::array<std::int32_t, 8> spokes{};
    for (const Block_moves::Move& move : *target.moves) {
      const std::size_t instance =
          mesh_.first_vertex[leaves[std::size_t(move.square)]] + std::size_t(move.vertex);
      const std::int32_t v = mesh_.leaf_vertices[instance];
      Tile_place& place = mesh_.places[static_cast<std::size_t>(v)];
      if (place == target.vertex) mesh_.vertex_of_site[site] = v;
      if (move.spoke >= 0) spokes[static_cast<std::size_t>(move.spoke)] = v;
      mesh_.is_frozen[static_cast<std::size_t>(v)] = 1;
      place = Block_moves::moved(target, move, block.level);
    }
    if (sites_.kind(site) != Site_kind::STAR) return;
    const auto star = std::lower_bound(mesh_.stars.begin(), mesh_.stars.end(), site,
                                       [](const Star_spokes& s, std::uint32_t i) { return s.site < i; });
    star->vertices = spokes;
  }

  /// @}

  const Tile_sites& sites_;
  Quadtree tree_;
  std::vector<std::uint32_t> kept_;                          // the leaves of the quadtree in the window
  Uninitialized_vector<std::uint8_t> corner_bits_;           // of their tiles
  Indexed_vector<Leaf_index, std::uint32_t> number_of_leaf_; // their places in that list
  Leaf_run run_{0, 0};
  Tile_mesh mesh_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_MESH_BUILDER_H
