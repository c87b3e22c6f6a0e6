// Builds the quadtree of a spiral of points that ends 2^-900 from its center (1/3, 1/3). Doubles cannot hold
// such points and words cannot hold such squares; exact traits have no least distance.

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/number_utils.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Quadtree = CGAL::Balanced_quadtree<CGAL::Exact_quadtree_traits_2<Kernel>>;

int main() {
  const Point center(Kernel::FT(1) / 3, Kernel::FT(1) / 3);
  std::vector<Point> points{center};
  Kernel::Vector_2 arm(1, 0);
  for (int i = 0; i <= 900; ++i) {
    points.push_back(center + arm);
    arm = arm.perpendicular(CGAL::COUNTERCLOCKWISE) / 2; // a quarter turn, half the length
  }

  const Quadtree tree(points);
  std::cout << "framework: " << tree.framework().number_of_nodes() << " squares for "
            << tree.framework().number_of_points() << " points\n"
            << "balanced quadtree: " << tree.number_of_leaves() << " leaves, depth " << tree.depth() << '\n';

  const Quadtree::Leaf_index leaf = tree.locate(center);
  const auto corners = tree.corners(leaf);
  std::cout << "the center is in leaf " << leaf << " of level " << tree.level(leaf) << ", with "
            << tree.points(leaf).size() << " point and side "
            << CGAL::to_double(corners[1].x() - corners[0].x()) << "\nits least x is 1/3 "
            << (corners[0].x() < center.x() ? "less" : "and") << " a number near "
            << CGAL::to_double(center.x() - corners[0].x()) << '\n';
}
