// Builds the same quadtree with one thread and with all: the result is the same, square by square.
// Takes the number of points as an argument: parallel_quadtree 5000000

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>
#include <CGAL/point_generators_2.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Point = Traits::Point_2;

template <class ConcurrencyTag>
CGAL::Balanced_quadtree<Traits, ConcurrencyTag> build(const std::vector<Point>& points, const char* name) {
  CGAL::Real_timer timer;
  timer.start();
  CGAL::Balanced_quadtree<Traits, ConcurrencyTag> tree(points);
  std::cout << name << ": " << tree.number_of_leaves() << " leaves in " << timer.time() << " s\n";
  return tree;
}

/// Whether nodes with the same number are the same squares with the same links.
template <class Tree_1, class Tree_2>
bool are_equal(const Tree_1& a, const Tree_2& b) {
  if (a.number_of_nodes() != b.number_of_nodes()) return false;
  for (std::size_t i = 0; i < a.number_of_nodes(); ++i) {
    const typename Tree_1::Node_index v(i);
    if (a.square(v) != b.square(v) || a.parent(v) != b.parent(v) || !(a.points(v) == b.points(v)))
      return false;
    for (CGAL::Quadtree_mesh_2::Direction d : CGAL::Quadtree_mesh_2::all_directions())
      if (a.neighbor(v, d) != b.neighbor(v, d)) return false;
  }
  return true;
}

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  CGAL::Random random(1);
  CGAL::Random_points_in_square_2<Point> in_square(1.0, random);
  std::vector<Point> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) points.push_back(*in_square++);

#ifndef CGAL_LINKED_WITH_TBB
  std::cout << "built without TBB: both with one thread\n";
#endif
  const auto sequential = build<CGAL::Sequential_tag>(points, "Sequential_tag");
  const auto parallel = build<CGAL::Parallel_if_available_tag>(points, "Parallel_tag");
  const bool is_same = are_equal(sequential, parallel);
  std::cout << (is_same ? "the same tree\n" : "different trees\n");
  return is_same ? 0 : 1;
}
