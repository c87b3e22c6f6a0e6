// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_DRAW_BALANCED_QUADTREE_H
#define CGAL_DRAW_BALANCED_QUADTREE_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/viewer/show_scene.h>

#include <array>
#include <cstddef>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Shows the leaves of a quadtree in a window, until that is closed. Deeper leaves are darker.
///
/// The viewer, and what happens without it, are those of `draw(const Indexed_mesh_2<Point>&, const char*)`.
/// `IO::write_SVG()` makes a picture instead. O(k) time for k leaves.
/// \param title of the window
/// \tparam Traits `x()` and `y()` of its points are arithmetic or have a `CGAL::to_double()`.
template <class Traits, class ConcurrencyTag>
void draw(const Balanced_quadtree<Traits, ConcurrencyTag>& tree, const char* title = "Quadtree") {
  using Quadtree_mesh_2::internal::as_double;
  using Viewer_point = Exact_predicates_inexact_constructions_kernel::Point_2;
  constexpr int darkest = 24; // of the levels that colors tell apart
  const auto fill = [&](auto& scene) {
    for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) {
      const Quadtree_mesh_2::Leaf_index leaf(l);
      const auto corners = tree.corners(leaf);
      std::array<Viewer_point, 4> places;
      for (std::size_t i = 0; i < 4; ++i)
        places[i] = Viewer_point(as_double(corners[i].x()), as_double(corners[i].y()));
      const int level = tree.level(leaf) < darkest ? tree.level(leaf) : darkest;
      const auto shade = static_cast<unsigned char>(125 - 4 * level);
      scene.face_begin(IO::Color(shade, shade, 150));
      for (const Viewer_point& p : places) scene.add_point_in_face(p);
      scene.face_end();
      for (std::size_t i = 0; i < 4; ++i) scene.add_segment(places[i], places[(i + 1) % 4]);
    }
  };
  Quadtree_mesh_2::internal::show_scene(fill, title);
}

} // namespace CGAL

#endif // CGAL_DRAW_BALANCED_QUADTREE_H
