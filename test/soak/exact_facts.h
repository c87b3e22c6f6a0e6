// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_EXACT_FACTS_H
#define QUADTREE_MESH_2_TEST_SOAK_EXACT_FACTS_H

// What is true of an input, by exact predicates and brute force: nothing here is the package's code.

#include "Soak_case.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace soak {

/// Whether two segments cross at a point that is inside both.
bool do_cross(const Pslg& graph, std::size_t s, std::size_t t);
/// The first two that do.
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(const Pslg& graph);

/// Whether there are no three vertices that are not on a line.
bool are_on_a_line(const std::vector<Point>& points);

/// Whether `p` is on a segment, ends included.
bool is_on_a_segment(const Pslg& graph, const Point& p);

/// The distance to the nearest segment; infinity if there is none.
long double distance_to_nearest_segment(const Pslg& graph, const Point& p);

/// What lies between neighboring numbers that a kernel can express at a place: the step of doubles there, or the unit
/// of words; 0 for exact numbers.
class Resolution {
public:
  explicit Resolution(const Soak_case& c);
  long double at(const Point& p) const;

private:
  long double unit_ = 0; ///< of words
  bool is_of_doubles_;
};

/// The least distance between two features of the graph, vertices or segments without a common end, one of which is
/// within `reach` of `p`; features at a distance of 0 are one. Two legs of a common vertex count with the distance
/// between them where they are nearest to `p` and, if that is at the vertex, `reach` from it.
/// \param enough any distance of at most this will do
long double least_feature_distance(const Pslg& graph, const Point& p, long double reach,
                                   long double enough = 0);
/// The same in steps of a resolution at the place.
bool is_without_room(const Soak_case& c, const Point& p, long double reach);
/// Whether two legs of a vertex have no room between them as far from it as `p` is. Neither can have a vertex there.
/// Each is a long side of the triangles next to it, however small others have to be at that vertex, on its other side
/// too.
bool is_within_needle(const Soak_case& c, const Point& p);
/// Whether bounds of size ask for sides of so few steps of the coordinates that triangles lose their shape.
bool do_sizes_lack_room(const Soak_case& c, const Point& p);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_EXACT_FACTS_H
