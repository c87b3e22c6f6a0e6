// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_WORKLIST_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_WORKLIST_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Triangles that may be bad, last in first out; each stands in it at most once. Whether one is bad is
/// decided when it is taken out, so that entries need not be withdrawn when flips cure a triangle.
class Worklist {
public:
  bool is_empty() const { return stack_.empty(); }

  void push(Triangle_id t) {
    is_queued_.make_room_for(t, 0);
    if (is_queued_[t] != 0) return;
    is_queued_[t] = 1;
    stack_.push_back(t);
  }

  Triangle_id pop() {
    const Triangle_id t = stack_.back();
    stack_.pop_back();
    is_queued_[t] = 0;
    return t;
  }

private:
  std::vector<Triangle_id> stack_;
  Indexed_vector<Triangle_id, char> is_queued_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_WORKLIST_H
