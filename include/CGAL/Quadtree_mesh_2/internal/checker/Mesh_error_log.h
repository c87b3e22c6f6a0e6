// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_ERROR_LOG_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_ERROR_LOG_H

#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>

#include <cstddef>
#include <sstream>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Counts the errors of a mesh and writes out the first of them.
class Mesh_error_log {
public:
  Mesh_error_log(const Mesh_quality_options_2& options, Mesh_quality_2& quality)
      : most_(options.max_errors()), quality_(quality) {}

  template <class... Parts>
  void add(const Parts&... parts) {
    if (++quality_.number_of_errors > most_) return;
    std::ostringstream text;
    text.precision(17);
    (text << ... << parts);
    quality_.errors.push_back(text.str());
  }
  std::size_t number_of_errors() const { return quality_.number_of_errors; }

private:
  std::size_t most_;
  Mesh_quality_2& quality_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_ERROR_LOG_H
