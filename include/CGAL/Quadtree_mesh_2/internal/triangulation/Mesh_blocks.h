// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Cuts a mesh into blocks that are processed separately, in parallel, and puts them back.
//
// The mesh alone determines how blocks are cut (Block_cut.h), and new things are named in the order of blocks. So the
// result is the same for any number of threads. Some blocks are taken out at a time, by a single thread one,
// and written before the next, which get their memory.
//
// O(n) work and memory for n triangles in blocks, and O(s log s) for s seams.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_MESH_BLOCKS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_MESH_BLOCKS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_arrays.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Block_cut.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_block.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Links what was apart: the two sides of a seam remember the same pair of sides of the whole mesh as it was.
/// O(n log n) for n halves, of all blocks.
/// \returns the sides along which blocks are put together, one of each pair, in an order that the halves' does not
/// change
template <class ConcurrencyTag, class Mesh>
std::vector<Side> link_seams(Mesh& whole, std::vector<Seam> halves) {
  const auto word = [](Side s) { return 4 * std::int64_t(s.triangle().value()) + s.slot(); };
  const auto lower = [&](const Seam& h) { return std::min(word(h.here), word(h.beyond)); };
  sort<ConcurrencyTag>(halves.begin(), halves.end(), [&](const Seam& g, const Seam& h) {
    return lower(g) != lower(h) ? lower(g) < lower(h) : word(g.here) < word(h.here);
  });
  const auto is_first = [&](std::size_t i) { return i == 0 || lower(halves[i - 1]) != lower(halves[i]); };
  for_each_index<ConcurrencyTag>(halves.size(), [&](std::size_t i) {
    if (!is_first(i)) return;
    const Seam& h = halves[i];
    const bool is_pair = i + 1 < halves.size() && !is_first(i + 1);
    const Side other = is_pair ? halves[i + 1].now : h.beyond; // else a triangle that was in no block
    whole.link(h.now.triangle(), h.now.slot(),
               Side(other.triangle(), other.slot(), h.beyond.is_constrained()));
  });
  return pack_values<ConcurrencyTag, Side>(halves.size(), is_first,
                                           [&](std::size_t i) { return halves[i].now; });
}

/// Those of the sides that have to be flipped.
template <class ConcurrencyTag, class Mesh>
std::vector<Side> sides_to_flip(const Mesh& mesh, const std::vector<Side>& sides) {
  return pack_values<ConcurrencyTag, Side>(
      sides.size(),
      [&](std::size_t i) {
        const Side s = sides[i];
        return !mesh.across(s).is_constrained() && mesh.is_certainly_not_Delaunay(s.triangle(), s.slot());
      },
      [&](std::size_t i) { return sides[i]; });
}

/// The triangles on both sides.
template <class ConcurrencyTag, class Mesh>
Uninitialized_vector<Triangle_id> triangles_at(const Mesh& mesh, const std::vector<Side>& sides) {
  Uninitialized_vector<Triangle_id> triangles(2 * sides.size());
  for_each_index<ConcurrencyTag>(sides.size(), [&](std::size_t i) {
    triangles[2 * i] = sides[i].triangle();
    triangles[2 * i + 1] = mesh.across(sides[i]).triangle();
  });
  return triangles;
}

template <class ConcurrencyTag, class Geometry>
class Mesh_blocks {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Block = Mesh_block<Geometry>;
  using Point = typename Geometry::Point;

  /// Triangles in no block stay where they are. Handles of these triangles and of all vertices stay what they are.
  /// \param assignment of the same mesh, without blocks, or empty
  Mesh_blocks(Mesh& whole, Block_assignment& assignment, Block_cut cut)
      : whole_(whole), assignment_(assignment), cut_(std::move(cut)), blocks_(cut_.size()) {
    assign_triangles();
  }

  std::size_t size() const { return blocks_.size(); }
  const Block_cut& cut() const { return cut_; }
  /// The block in which a triangle of the whole mesh is, if it is in one.
  Block_id block_of(Triangle_id t) const { return assignment_[t].block; }
  /// The handle that a triangle has in its block, when that is taken out.
  Triangle_id place_of(Triangle_id t) const { return assignment_[t].triangle; }

  /// Takes the blocks out, calls `work(block)` for each, and writes them into the whole mesh. Then calls
  /// `take_results(block)` for each, which may ask for handles in the whole mesh; afterward the block is empty. Calls
  /// for different blocks may overlap. Nobody else may use the whole mesh until the blocks are put together.
  template <class Work, class TakeResults>
  void for_each(const Work& work, const TakeResults& take_results) {
    const std::size_t batch = std::min(size(), blocks_at_once());
    std::vector<Mesh> spare(batch);
    for (std::size_t begin = 0; begin < size(); begin += batch) {
      const std::size_t end = std::min(size(), begin + batch);
      run_largest_first(begin, end, [&](std::size_t b) { work(take_out(b, std::move(spare[b - begin]))); });
      const std::vector<First_names> names = make_room(begin, end);
      run_largest_first(begin, end, [&](std::size_t b) {
        Block& block = *blocks_[b];
        block.name_new(names[b - begin].triangle, names[b - begin].vertex);
        block.write(whole_);
        take_results(block);
        Mesh rest = block.release();
        if (end < size()) spare[b - begin] = std::move(rest);
      });
    }
  }

  /// Links the blocks to each other. The sides at seams are left in `seam_sides()`.
  void put_together() {
    for (const auto& block : blocks_) block->write_shared(whole_);
    seam_sides_ = link_seams<ConcurrencyTag>(whole_, halves_of_seams());
    for_each_index<ConcurrencyTag>(cut_.members.size(),
                                   [&](std::size_t i) { assignment_.set(cut_.members[i], {}); });
  }

  /// Those of a block that is written.
  const std::vector<Seam>& seams_of(Block_id b) const { return blocks_[b.value()]->seams(); }
  /// The sides along which blocks were put together.
  const std::vector<Side>& seam_sides() const { return seam_sides_; }
  /// Those of them that have to be flipped.
  std::vector<Side> sides_to_flip() const {
    return internal::sides_to_flip<ConcurrencyTag>(whole_, seam_sides_);
  }

private:
  Mesh& whole_;
  Block_assignment& assignment_;
  Block_cut cut_;
  std::vector<std::unique_ptr<Block>> blocks_;
  std::vector<Side> seam_sides_;

  /// How many blocks are taken out before they are written back: enough that no thread waits long for the last of
  /// them, and few enough that they are little beside a large mesh, or in what memory there is beside a scratch file.
  static std::size_t blocks_at_once() {
    if (is_sequential<ConcurrencyTag>()) return 1;
    return Scratch_arrays::is_active() ? 16 : 256;
  }

  void assign_triangles() {
    assignment_.template cover<ConcurrencyTag>(whole_);
    Executor<ConcurrencyTag>::run(size(), [&](std::size_t b) {
      for (std::size_t i = cut_.first[b]; i < cut_.first[b + 1]; ++i)
        assignment_.set(cut_.members[i],
                        {static_cast<Block_id>(b), static_cast<Triangle_id>(i - cut_.first[b])});
    });
  }

  /// Calls `task(b)` for the blocks [begin, end). A thread that is free takes the largest one that nobody has taken, so
  /// that none begins with a large one when others are about to end.
  template <class Task>
  void run_largest_first(std::size_t begin, std::size_t end, const Task& task) const {
    std::vector<std::size_t> order(end - begin);
    std::iota(order.begin(), order.end(), begin);
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t b, std::size_t c) { return cut_[b].size() > cut_[c].size(); });
    std::atomic<std::size_t> next{0};
    Executor<ConcurrencyTag>::run(order.size(), [&](std::size_t) { task(order[next++]); });
  }

  Block& take_out(std::size_t b, Mesh spare) {
    blocks_[b] =
        std::make_unique<Block>(whole_, assignment_, static_cast<Block_id>(b), cut_[b], std::move(spare));
    return *blocks_[b];
  }

  /// The first handles in the whole mesh that what is new in a block gets.
  struct First_names {
    Triangle_id triangle;
    Vertex_id vertex;
  };

  /// Makes room in the whole mesh for what is new in the blocks [begin, end).
  std::vector<First_names> make_room(std::size_t begin, std::size_t end) {
    const std::size_t triangles_before = whole_.triangles.size(),
                      vertices_before = whole_.number_of_vertices();
    std::size_t triangles = triangles_before, vertices = vertices_before;
    std::vector<First_names> names;
    for (std::size_t b = begin; b < end; ++b) {
      names.push_back({static_cast<Triangle_id>(triangles), static_cast<Vertex_id>(vertices)});
      triangles += blocks_[b]->number_of_new_triangles(), vertices += blocks_[b]->number_of_new_vertices();
    }
    if (begin == 0) { // other blocks will need as much, or a little more, and so will the seams
      const double share = 0.125 + 1.25 * static_cast<double>(size() - end) / static_cast<double>(end);
      const auto with_others = [&](std::size_t before, std::size_t now) {
        return now + static_cast<std::size_t>(share * static_cast<double>(now - before));
      };
      whole_.reserve(with_others(vertices_before, vertices), with_others(triangles_before, triangles));
    }
    whole_.resize(vertices, triangles);
    return names;
  }

  std::vector<Seam> halves_of_seams() const {
    std::vector<Seam> halves;
    halves.reserve(std::accumulate(
        blocks_.begin(), blocks_.end(), std::size_t(0),
        [](std::size_t n, const std::unique_ptr<Block>& block) { return n + block->seams().size(); }));
    for (const auto& block : blocks_)
      halves.insert(halves.end(), block->seams().begin(), block->seams().end());
    return halves;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_MESH_BLOCKS_H
