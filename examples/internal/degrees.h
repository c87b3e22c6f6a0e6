#ifndef QUADTREE_MESH_2_EXAMPLES_DEGREES_H
#define QUADTREE_MESH_2_EXAMPLES_DEGREES_H

// Whether coordinates look like longitudes and latitudes, which are meshed as they are unless somebody says so.

#include <cmath>
#include <cstdio>

namespace degrees {

/// Whether a point may be a longitude from `west` to `east` and a latitude.
template <class Point>
bool is_in_range(const Point& p, double west, double east) {
  return west <= p.x() && p.x() <= east && std::abs(p.y()) <= 90;
}
/// The same for the longitudes in use.
template <class Point>
bool is_in_range(const Point& p) {
  return is_in_range(p, -180, 360);
}
/// Whether angles on the ground are others there, by half a degree or more.
template <class Point>
bool is_far_from_equator(const Point& p) {
  return std::abs(p.y()) > 10;
}

/// \param program whose option projects them: empty, or " of PROGRAM"
inline void print_warning(const char* program) {
  std::printf(
      "warning: if these are longitudes and latitudes, angles, lengths and areas are not those on the "
      "ground;\n         use --project auto%s, or --project none to say that they are not\n",
      program);
}

} // namespace degrees

#endif // QUADTREE_MESH_2_EXAMPLES_DEGREES_H
