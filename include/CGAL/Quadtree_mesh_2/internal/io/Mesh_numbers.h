// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_MESH_NUMBERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_MESH_NUMBERS_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The rows of an array of a file that one part of a mesh writes: runs of consecutive ones.
struct Array_rows {
  struct Run {
    std::size_t row;   ///< the first one in the array
    std::size_t index; ///< what the part calls it; those behind it follow
    std::size_t length;
  };

  std::size_t all = 0; ///< rows of the array
  std::vector<Run> runs;

  static Array_rows whole(std::size_t n) {
    Array_rows rows{n, {}};
    rows.add(0, 0, n);
    return rows;
  }
  /// Behind what is there already.
  void add(std::size_t row, std::size_t index, std::size_t length) {
    if (length == 0) return;
    if (!runs.empty() && runs.back().row + runs.back().length == row &&
        runs.back().index + runs.back().length == index)
      runs.back().length += length;
    else
      runs.push_back({row, index, length});
  }
};

/// Numbers that grow with their indices, of which those of a run follow each other: they take no memory.
class Numbers_around_run {
public:
  using List = std::vector<std::uint64_t>;

  Numbers_around_run() = default;
  /// \param begin the index at which the run begins
  /// \param first the number there
  /// \param others the numbers before and behind it
  Numbers_around_run(std::size_t begin, std::size_t length, std::uint64_t first, List others)
      : begin_(begin), length_(length), first_(first), others_(std::move(others)) {}

  std::uint64_t operator[](std::size_t i) const {
    if (i < begin_) return others_[i];
    return i < begin_ + length_ ? first_ + (i - begin_) : others_[i - length_];
  }

private:
  std::size_t begin_ = 0, length_ = 0;
  std::uint64_t first_ = 0;
  List others_;
};

/// What the vertices, triangles and constrained edges of a part of a mesh are called in the whole mesh, and which of
/// them the part owns: these no other part owns. For a whole mesh all are called what they are.
///
/// Numbers grow with indices: vertices in their order; triangles that the part owns, which follow each other, and then
/// others, in their order; edges in their order, all owned.
class Mesh_numbers {
public:
  /// Whether the part is the first one, which writes what is one for all.
  enum class Part { FIRST, OTHER };
  /// How many there are in the whole mesh.
  struct Counts {
    std::size_t vertices = 0, triangles = 0, edges = 0, outside = 0;
  };
  /// Indices from `begin` on, before `end`.
  struct Range {
    std::size_t begin = 0, end = 0;
    std::size_t size() const { return end - begin; }
  };
  using List = Numbers_around_run::List;

  /// \param outside segments of the input of which nothing is in the mesh
  template <class Point>
  explicit Mesh_numbers(const Indexed_mesh_2<Point>& mesh, std::size_t outside = 0)
      : is_whole_(true), part_(Part::FIRST), counts_{mesh.points.size(), mesh.triangles.size(),
                                                     mesh.constrained_edges.size(), outside},
        own_vertices_{0, mesh.points.size()}, own_triangles_(mesh.triangles.size()) {}

  /// \param own_triangles their number; they come first
  Mesh_numbers(Part part, const Counts& counts, Numbers_around_run vertices, Range own_vertices,
               Numbers_around_run triangles, std::size_t own_triangles, List edges)
      : is_whole_(false), part_(part), counts_(counts), own_vertices_(own_vertices),
        own_triangles_(own_triangles), vertices_(std::move(vertices)), triangles_(std::move(triangles)),
        edges_(std::move(edges)) {}

  bool is_first() const { return part_ == Part::FIRST; }
  const Counts& counts() const { return counts_; }
  const Range& own_vertices() const { return own_vertices_; }
  std::size_t number_of_own_triangles() const { return own_triangles_; }

  std::size_t vertex(Vertex_index v) const { return number(vertices_, std::size_t(v)); }
  std::size_t triangle(std::size_t t) const { return number(triangles_, t); }
  std::size_t edge(std::size_t e) const { return number(edges_, e); }

private:
  template <class Numbers>
  std::size_t number(const Numbers& list, std::size_t i) const {
    return is_whole_ ? i : static_cast<std::size_t>(list[i]);
  }

  bool is_whole_;
  Part part_;
  Counts counts_;
  Range own_vertices_;
  std::size_t own_triangles_;
  Numbers_around_run vertices_, triangles_;
  List edges_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_MESH_NUMBERS_H
