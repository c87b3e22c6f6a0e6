// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "arrays.h"
#include "definitions.h"
#include "sizes.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The balanced quadtree of points, with its leaves as arrays.

namespace quadtree_mesh_python {

namespace {

using Tree = CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
using CGAL::Quadtree_mesh_2::Balance;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Point_index;
using CGAL::Quadtree_mesh_2::Point_rank;

Balance balance_named(const std::string& name) {
  if (name == "corners") return Balance::SIDES_AND_CORNERS;
  if (name == "sides") return Balance::SIDES;
  if (name == "none") return Balance::NONE;
  throw std::invalid_argument("balance must be 'corners', 'sides' or 'none', not '" + name + "'");
}

Tree make_tree(const Input_array<double>& array, std::size_t max_points_per_leaf, const std::string& balance,
               const py::list& sizes) {
  if (max_points_per_leaf == 0) throw std::invalid_argument("a leaf must be able to hold a point");
  const std::vector<Point> points = points_from(array, "points");
  const auto size = least_size(sizes, nullptr);
  const auto options =
      CGAL::Quadtree_options().max_points_per_leaf(max_points_per_leaf).balance(balance_named(balance));
  const py::gil_scoped_release release;
  if (!size) return Tree(points, options);
  return Tree(points, options, [&](const Point& low, const Point& high) {
    return high.x() - low.x() > size(low.x() / 2 + high.x() / 2, low.y() / 2 + high.y() / 2);
  });
}

void require_balance(const Tree& tree, bool is_enough) {
  if (!is_enough || tree.options().balance() == Balance::NONE)
    throw std::invalid_argument("this needs a quadtree that is balanced across sides and corners");
}

/// x and y of the lower left corner, then of the upper right one.
py::array_t<double> boxes_of(const Tree& tree) {
  std::vector<std::array<double, 4>> boxes;
  boxes.reserve(tree.number_of_leaves());
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    const auto corners = tree.corners(Leaf_index(i));
    boxes.push_back({corners[0].x(), corners[0].y(), corners[2].x(), corners[2].y()});
  }
  return array_of_rows<double>(std::move(boxes));
}

py::array_t<std::int32_t> levels_of(const Tree& tree) {
  std::vector<std::int32_t> levels(tree.number_of_leaves());
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = tree.level(Leaf_index(i));
  return array_of(std::move(levels));
}

/// Where each leaf's neighbors begin, then all neighbors.
py::tuple neighbors_of(const Tree& tree) {
  require_balance(tree, true);
  std::vector<std::int64_t> begin{0};
  std::vector<std::int32_t> neighbors;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    for (const Leaf_index l : tree.neighbors(Leaf_index(i)))
      neighbors.push_back(static_cast<std::int32_t>(l.value()));
    begin.push_back(static_cast<std::int64_t>(neighbors.size()));
  }
  return py::make_tuple(array_of(std::move(begin)), array_of(std::move(neighbors)));
}

py::array_t<std::int32_t> leaves_of_points(const Tree& tree) {
  std::vector<std::int32_t> leaves(tree.framework().number_of_input_points());
  for (std::size_t i = 0; i < leaves.size(); ++i)
    leaves[i] = static_cast<std::int32_t>(tree.leaf(Point_index(i)).value());
  return array_of(std::move(leaves));
}

py::array_t<std::int32_t> locate(const Tree& tree, const Input_array<double>& array) {
  const std::vector<Point> queries = points_from(array, "points");
  std::vector<Leaf_index> leaves;
  {
    const py::gil_scoped_release release;
    leaves = tree.locate_all(queries);
  }
  const Shown_object<std::vector<Leaf_index>> shown(std::move(leaves));
  return shown.show_numbers<std::int32_t>(*shown);
}

py::array_t<std::int32_t> near_neighbors(const Tree& tree) {
  require_balance(tree, tree.options().balance() == Balance::SIDES_AND_CORNERS);
  std::vector<Point_rank> near;
  {
    const py::gil_scoped_release release;
    near = tree.near_neighbors();
  }
  const auto& framework = tree.framework();
  std::vector<std::int32_t> result(framework.number_of_input_points(), -1);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Point_rank r = near[std::size_t(framework.rank(Point_index(i)))];
    if (r.is_valid()) result[i] = static_cast<std::int32_t>(framework.input_point(r).value());
  }
  return array_of(std::move(result));
}

} // namespace

void define_quadtrees(py::module_& module) {
  py::class_<Tree>(module, "Quadtree")
      .def(py::init(&make_tree), py::arg("points"), py::arg("max_points_per_leaf"), py::arg("balance"),
           py::arg("size"))
      .def("number_of_nodes", &Tree::number_of_nodes)
      .def("number_of_leaves", &Tree::number_of_leaves)
      .def("depth", &Tree::depth)
      .def("is_valid", [](const Tree& tree) { return tree.is_valid(); })
      .def("boxes", &boxes_of)
      .def("levels", &levels_of)
      .def("neighbors", &neighbors_of)
      .def("leaves_of_points", &leaves_of_points)
      .def("locate", &locate, py::arg("points"))
      .def("near_neighbors", &near_neighbors);
}

} // namespace quadtree_mesh_python
