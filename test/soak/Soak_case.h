// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_SOAK_CASE_H
#define QUADTREE_MESH_2_TEST_SOAK_SOAK_CASE_H

// One run of a mesher that the soak judges: an input, and everything that is asked of the mesher.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <cstdint>
#include <string>
#include <vector>

namespace soak {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Mesh = CGAL::Indexed_mesh_2<Point>;

enum class Kernel { FILTERED, EXACT, FIXED, FIXED32 };
enum class Separation { ON_DEMAND, THEOREM_5 };
enum class Mode { PSLG, POINTS, BOUNDED, ACUTE, WARPED };

inline const std::vector<std::string>& kernel_names() {
  static const std::vector<std::string> names{"filtered", "exact", "fixed", "fixed32"};
  return names;
}
inline const std::vector<std::string>& separation_names() {
  static const std::vector<std::string> names{"on-demand", "theorem-5"};
  return names;
}
inline const std::vector<std::string>& mode_names() {
  static const std::vector<std::string> names{"pslg", "points", "bounded", "acute", "warped"};
  return names;
}

/// What is asked for besides. Lengths are in shares of the input's extent, areas of its square; so they mean the same
/// at any scale, and while an input is made smaller. Fields that are 0 ask for nothing.
struct Wishes {
  double min_angle = 20.7;
  double max_area = 0, max_edge = 0, min_edge = 0;
  double size = 0; ///< of a field that doubles from the left to the right
  int smooth = 0, thin = 0;
  bool is_coarsened = true;
  CGAL::Quality_mesh_options_2::Domain domain = CGAL::Quality_mesh_options_2::Domain::ENCLOSED;
  double patience = 100;
  bool has_centroid_trees = false, has_trapezoids = false; ///< with quadtrees only
  // of points:
  int effort = 2;
  bool is_square = false;
  bool is_tightest = false; ///< angles in [37.5, 78.6] instead of [36, 80]
};

struct Soak_case {
  std::string family;
  std::uint64_t seed = 0;
  Kernel kernel = Kernel::FILTERED;
  Separation separation = Separation::ON_DEMAND;
  Mode mode = Mode::PSLG;
  unsigned threads = 1;
  Wishes wishes;
  Pslg graph;
};

/// The longer side of the bounding box; 0 if there are no points, and infinite if it is too large for a double.
double extent_of(const std::vector<Point>& points);

/// What says the same on the soak's command line: kernel, separation, mode, threads and wishes that are not the
/// default.
std::string arguments_of(const Soak_case& c);
/// Sets in `c` what `arguments_of()` says.
/// \throws std::invalid_argument for what it does not know
void read_arguments(const std::string& text, Soak_case& c);

/// Writes the graph as .poly with the arguments, and `lines`, as comments at its head.
void write_case(const std::string& file_name, const Soak_case& c, const std::vector<std::string>& lines);
/// Reads what `write_case()` wrote.
Soak_case read_case(const std::string& file_name);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_SOAK_CASE_H
