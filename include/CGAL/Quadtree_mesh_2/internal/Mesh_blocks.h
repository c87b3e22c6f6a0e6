// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Cuts a mesh into blocks that are worked on apart from each other, in parallel, and puts them back.
//
// A block is a run of triangles in shuffle order of the middles of their shortest edges: there refinement begins,
// however long the rest of the triangle is. Blocks of two rounds are cut in squares shifted against each other by a
// third of the root, so that what is near a seam of one round is well inside a block of the other: of a quadtree and
// its shifted copies one has any given disc within a square not much larger (Chan, "Approximate nearest neighbor
// queries revisited", 1998). How blocks are cut depends on the mesh alone, and they are put back in order; so the
// result is the same for any number of threads, and the blocks' small memory helps a single thread, too.
//
// O(n) work and memory for n triangles in blocks, and O(s log s) for s seams.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_BLOCKS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_BLOCKS_H

#include <CGAL/Quadtree_mesh_2/internal/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_block.h>
#include <CGAL/Quadtree_mesh_2/internal/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/radix_sort.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How squares are placed; those of different shifts have no side in common.
enum class Square_shift { none, third_of_root };

template <class Concurrency_tag, class Geometry>
class Mesh_blocks {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Block = Mesh_block<Geometry>;
  using Point = typename Geometry::Point;

  /// Cuts the given triangles into blocks of about `block_size`; other triangles stay where they are. Handles of
  /// these triangles and of all vertices stay what they are.
  Mesh_blocks(Mesh& whole, std::vector<Triangle_id> triangles, std::size_t block_size, Square_shift shift)
      : whole_(whole), triangles_(std::move(triangles)) {
    sort_triangles(shift);
    const std::size_t n = triangles_.size(), blocks = std::max<std::size_t>(1, n / block_size);
    for (std::size_t b = 0; b <= blocks; ++b) first_.push_back(n * b / blocks);
    assign_triangles();
    blocks_.resize(blocks);
  }

  std::size_t size() const { return blocks_.size(); }
  const Block& operator[](std::size_t b) const { return *blocks_[b]; }
  /// The block in which a triangle of the whole mesh is, -1 for none.
  Block_id block_of(Triangle_id t) const { return assignment_.block_of(t); }
  /// The handle that a triangle has in its block, when that is taken out.
  Triangle_id place_of(Triangle_id t) const { return assignment_.place_of(t); }

  /// Takes the blocks out and calls `work(block)` for each; calls for different blocks may overlap. The whole mesh
  /// must not be changed meanwhile.
  template <class Work>
  void for_each(const Work& work) {
    Executor<Concurrency_tag>::run(size(), [&](std::size_t b) {
      const Triangle_id* t = triangles_.data();
      blocks_[b] = std::make_unique<Block>(whole_, assignment_, static_cast<Block_id>(b), t + first_[b],
                                           t + first_[b + 1]);
      work(*blocks_[b]);
    });
  }

  /// Puts all blocks back. The sides at seams are left in `seam_sides()`.
  void put_back() {
    make_room();
    Executor<Concurrency_tag>::run(size(), [&](std::size_t b) { blocks_[b]->write(whole_); });
    for (const auto& block : blocks_) block->write_shared(whole_);
    close_seams();
  }

  /// The sides along which blocks were put together.
  const std::vector<Side>& seam_sides() const { return seam_sides_; }

private:
  Mesh& whole_;
  std::vector<Triangle_id> triangles_;
  std::vector<std::size_t> first_; // of each block, in triangles_
  Block_assignment assignment_;
  std::vector<std::unique_ptr<Block>> blocks_;
  std::vector<Side> seam_sides_;

  void sort_triangles(Square_shift shift) {
    Point low = whole_.points.front(), high = low;
    for (const Point& p : whole_.points) {
      low.x = std::min(low.x, p.x), low.y = std::min(low.y, p.y);
      high.x = std::max(high.x, p.x), high.y = std::max(high.y, p.y);
    }
    const Vector size = Geometry::difference(high, low);
    // 16 bits a coordinate; two root squares' room for the shift
    const double scale = 32767 / std::max(std::max(size.x, size.y), 1e-300);
    const double offset = shift == Square_shift::none ? 0 : 65536.0 / 3;
    std::vector<std::uint64_t> words(triangles_.size()); // key, triangle
    for_each_index<Concurrency_tag>(words.size(), [&](std::size_t i) {
      const Vector p = Geometry::difference(middle_of_shortest_edge(triangles_[i]), low);
      words[i] = interleave(static_cast<std::uint32_t>(scale * p.x + offset),
                            static_cast<std::uint32_t>(scale * p.y + offset))
                     << 32 |
                 static_cast<std::uint32_t>(triangles_[i]);
    });
    const auto buffer = uncleared_words(words.size());
    Word_sorter<Concurrency_tag>::sort(words.data(), buffer.get(), words.size(), true);
    for_each_index<Concurrency_tag>(words.size(), [&](std::size_t i) {
      triangles_[i] = static_cast<Triangle_id>(static_cast<std::uint32_t>(words[i]));
    });
  }

  Point middle_of_shortest_edge(Triangle_id t) const {
    const auto& r = whole_.triangle(t);
    const int k = whole_.shape(r).slot_of_shortest();
    const Point &a = whole_.point(r.v[next_slot[k]]), &b = whole_.point(r.v[previous_slot[k]]);
    return Geometry::translate(a, 0.5 * Geometry::difference(b, a));
  }

  void assign_triangles() {
    assignment_.block.assign(whole_.triangles.size(), -1);
    assignment_.place.resize(whole_.triangles.size());
    Executor<Concurrency_tag>::run(first_.size() - 1, [&](std::size_t b) {
      for (std::size_t i = first_[b]; i < first_[b + 1]; ++i) {
        assignment_.block[std::size_t(triangles_[i])] = static_cast<Block_id>(b);
        assignment_.place[std::size_t(triangles_[i])] = static_cast<Triangle_id>(i - first_[b]);
      }
    });
  }

  void make_room() {
    std::vector<std::size_t> triangles(size()), vertices(size());
    Executor<Concurrency_tag>::run(size(), [&](std::size_t b) {
      triangles[b] = blocks_[b]->number_of_new_triangles();
      vertices[b] = blocks_[b]->number_of_new_vertices();
    });
    const std::size_t all_triangles =
        scan_exclusively(triangles.data(), triangles.size(), whole_.triangles.size());
    const std::size_t all_vertices =
        scan_exclusively(vertices.data(), vertices.size(), whole_.number_of_vertices());
    whole_.resize(all_vertices, all_triangles);
    Executor<Concurrency_tag>::run(size(), [&](std::size_t b) {
      blocks_[b]->name(static_cast<Triangle_id>(triangles[b]), static_cast<Vertex_id>(vertices[b]));
    });
  }

  /// Links what was apart: the two sides of a seam remember the same pair of sides of the whole mesh as it was.
  void close_seams() {
    struct Half {
      Side here, beyond, now;
    };
    std::vector<Half> halves;
    for (const auto& block : blocks_)
      for (const auto& s : block->seams()) halves.push_back({s.here, s.beyond, s.now});
    const auto word = [](Side s) { return 4 * std::int64_t(s.triangle()) + s.slot(); };
    const auto lower = [&](const Half& h) { return std::min(word(h.here), word(h.beyond)); };
    std::sort(halves.begin(), halves.end(), [&](const Half& g, const Half& h) {
      return lower(g) != lower(h) ? lower(g) < lower(h) : word(g.here) < word(h.here);
    });
    for (std::size_t i = 0; i < halves.size(); ++i) {
      const Half& h = halves[i];
      const bool is_pair = i + 1 < halves.size() && lower(halves[i + 1]) == lower(h);
      const Side other = is_pair ? halves[++i].now : h.beyond; // else a triangle that was in no block
      whole_.link(h.now.triangle(), h.now.slot(),
                  Side(other.triangle(), other.slot(), h.beyond.is_constrained()));
      seam_sides_.push_back(h.now);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_BLOCKS_H
