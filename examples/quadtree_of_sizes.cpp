// Builds a quadtree by a size function: leaves are small near a circle and grow with the distance from it. Then
// splits once more the leaves that the circle crosses.
// Draws the tree to a file: quadtree_of_sizes tree.svg

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/quadtree_SVG.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <vector>

using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Point = Traits::Point_2;
using Quadtree = CGAL::Balanced_quadtree<Traits>;

/// The distance of the center of a square from the unit circle.
double distance(const Point& lower_left, const Point& upper_right) {
  const double x = (lower_left.x() + upper_right.x()) / 2, y = (lower_left.y() + upper_right.y()) / 2;
  return std::fabs(std::hypot(x, y) - 1);
}

bool is_too_large(const Point& lower_left, const Point& upper_right) {
  const double side = upper_right.x() - lower_left.x();
  return side > std::max(0.05, 0.4 * (distance(lower_left, upper_right) - side));
}

void print(const char* what, const Quadtree& tree) {
  std::vector<std::size_t> leaves(std::size_t(tree.depth()) + 1, 0);
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l)
    ++leaves[std::size_t(tree.level(Quadtree::Leaf_index(l)))];
  std::cout << what << ": " << tree.number_of_leaves() << " leaves, by level";
  for (std::size_t n : leaves) std::cout << ' ' << n;
  std::cout << '\n';
}

int main(int argc, char** argv) {
  const std::vector<Point> frame{{-1.2, -1.2}, {1.2, 1.2}}; // the root is chosen around the points
  Quadtree tree(frame, CGAL::Quadtree_options(), is_too_large);
  print("size function", tree);

  std::vector<Quadtree::Leaf_index> crossed;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    const auto corners = tree.corners(Quadtree::Leaf_index(i));
    const auto is_inside = [](const Point& p) { return std::hypot(p.x(), p.y()) < 1; };
    const auto inside = std::count_if(corners.begin(), corners.end(), is_inside);
    if (0 < inside && inside < 4) crossed.push_back(Quadtree::Leaf_index(i));
  }
  tree.refine(crossed); // all leaves at once: nodes are numbered anew
  print("refined", tree);

  try {
    using Options = CGAL::IO::Quadtree_svg_options;
    if (argc > 1)
      CGAL::IO::write_SVG(argv[1], tree,
                          Options().fill_by(Options::Fill::LEVEL).clip_to({-1.5, -1.5, 1.5, 1.5}));
  } catch (const std::runtime_error& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
