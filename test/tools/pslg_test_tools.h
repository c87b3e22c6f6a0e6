// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_PSLG_TEST_TOOLS_H
#define QUADTREE_MESH_2_TEST_PSLG_TEST_TOOLS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>

#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>

namespace pslg_test {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Vertex_index = CGAL::Quadtree_mesh_2::Vertex_index;
using Segment_index = CGAL::Quadtree_mesh_2::Segment_index;

/// A point of words, as fixed-point geometry has them.
template <class Word>
class Word_point {
public:
  Word_point() = default;
  Word_point(Word x, Word y) : x_(x), y_(y) {}
  Word x() const { return x_; }
  Word y() const { return y_; }

private:
  Word x_ = 0, y_ = 0;
};

inline std::string data_file(const std::string& name) {
  return std::string(QUADTREE_MESH_TEST_DATA_DIR) + '/' + name;
}

template <class Coordinate, class P = Point>
CGAL::Pslg_2<P> make_pslg(std::initializer_list<std::pair<Coordinate, Coordinate>> points,
                          std::initializer_list<std::pair<std::size_t, std::size_t>> segments = {}) {
  CGAL::Pslg_2<P> pslg;
  for (const auto& p : points) pslg.add_vertex(P(p.first, p.second));
  for (const auto& s : segments) pslg.add_segment(Vertex_index(s.first), Vertex_index(s.second));
  return pslg;
}

inline Pslg unit_square() {
  return make_pslg<double>({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
}

/// The message of the `Pslg_error_2` that `f` throws; empty if it throws none.
template <class Function>
std::string error_of(Function f) {
  try {
    f();
  } catch (const CGAL::Pslg_error_2& error) {
    return error.what();
  }
  return std::string();
}

inline bool has_text(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace pslg_test

#endif // QUADTREE_MESH_2_TEST_PSLG_TEST_TOOLS_H
