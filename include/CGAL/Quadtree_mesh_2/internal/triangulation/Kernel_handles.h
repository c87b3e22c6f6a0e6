// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// By what the kernel's mesh (Kernel_mesh.h) names its parts: handles, sides of triangles, and roles of vertices.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KERNEL_HANDLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KERNEL_HANDLES_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Handles inside the kernel; an invalid one is none.
using Vertex_id = Index<struct Kernel_vertex_tag>;
using Triangle_id = Index<struct Kernel_triangle_tag>;
using Edge_id = Index<struct Kernel_edge_tag>;     ///< of an input edge
using Region_id = Index<struct Kernel_region_tag>; ///< the position of a region in the input

constexpr int next_slot[3] = {1, 2, 0};
constexpr int previous_slot[3] = {2, 0, 1};

/// One side of one triangle, with the constraint bit of the edge; the border or a seam when there is no triangle. One
/// word: 29 bits for the triangle or the number of a seam, 2 for the slot, or that there is no triangle, 1 for the bit.
class Side {
public:
  /// A mesh has fewer triangles than this, alive or not.
  static constexpr std::size_t most_triangles = std::size_t(1) << 29;

  Side() = default;
  Side(Triangle_id t, int slot, bool is_constrained = false)
      : code_(code(t) | static_cast<std::uint32_t>(slot << 1) | (is_constrained ? 1u : 0u)) {}
  static Side border() { return Side(); }

  /// Where another block goes on. The number is kept by all that links and flips do to the triangle.
  static Side seam(std::int32_t number) {
    Side s;
    s.code_ = static_cast<std::uint32_t>(number) << 3 | no_triangle | 1;
    return s;
  }

  /// Whether no triangle lies there: at the border of the domain, or at a seam.
  bool is_border() const { return (code_ & no_triangle) == no_triangle; }
  bool is_seam() const { return is_border() && code_ != border_code; }
  std::int32_t seam_number() const { return static_cast<std::int32_t>(code_ >> 3); }
  /// The border and seams count as constrained: nothing walks or flips across them.
  bool is_constrained() const { return (code_ & 1) != 0; }
  Triangle_id triangle() const { return Triangle_id(code_ >> 3); }
  int slot() const { return static_cast<int>((code_ >> 1) & 3); }
  /// `next_slot[slot()]` and `previous_slot[slot()]`. Walks around vertices wait for one after the other of them, which
  /// takes less time by arithmetic than by a table.
  int slot_after() const { return (0b00'10'01 >> (code_ & 6)) & 3; }
  int slot_before() const { return (0b01'00'10 >> (code_ & 6)) & 3; }
  /// The same side of a triangle that has got another handle.
  Side renamed(Triangle_id t) const {
    Side s;
    s.code_ = code(t) | (code_ & 7);
    return s;
  }
  void constrain() { code_ |= 1; }
  void release() { code_ &= ~1u; }

private:
  static constexpr std::uint32_t no_triangle = 3 << 1; // in place of a slot
  static constexpr std::uint32_t border_code = ~0u;

  std::uint32_t code_ = border_code;

  static std::uint32_t code(Triangle_id t) { return t.value() << 3; }
};

/// What a vertex is: free to move, on an input edge, or a vertex of the input. One word for all three.
class Vertex_role {
public:
  /// A free vertex.
  constexpr Vertex_role() = default;
  /// A vertex on an input edge.
  constexpr Vertex_role(Edge_id e) : code_(static_cast<std::int32_t>(e.value())) {}
  static constexpr Vertex_role input(Vertex_id number) {
    Vertex_role role;
    role.code_ = -2 - static_cast<std::int32_t>(number.value());
    return role;
  }

  constexpr bool is_free() const { return code_ == -1; }
  constexpr bool is_input() const { return code_ < -1; }
  /// The edge that the vertex lies on; none if it is free, or of the input.
  constexpr Edge_id edge() const { return code_ >= 0 ? Edge_id(code_) : Edge_id(); }
  /// The number of a vertex of the input.
  constexpr Vertex_id input_number() const { return Vertex_id(-2 - code_); }

  friend constexpr bool operator==(Vertex_role a, Vertex_role b) { return a.code_ == b.code_; }
  friend constexpr bool operator!=(Vertex_role a, Vertex_role b) { return a.code_ != b.code_; }

private:
  std::int32_t code_ = -1;
};

constexpr Vertex_role free_vertex;
constexpr Vertex_role input_vertex(Vertex_id number) { return Vertex_role::input(number); }

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KERNEL_HANDLES_H
