// Builds the balanced quadtree of random points, prints what was built and walks around the leaf of a point.
// Draws the tree to a file: quadtree_of_points tree.svg

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/quadtree_SVG.h>
#include <CGAL/Random.h>
#include <CGAL/point_generators_2.h>

#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <vector>

using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Point = Traits::Point_2;
using Quadtree = CGAL::Balanced_quadtree<Traits>;

int main(int argc, char** argv) {
  CGAL::Random random(1);
  CGAL::Random_points_in_disc_2<Point> in_disc(1.0, random);
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) points.push_back(*in_disc++);
  points.push_back(points.front()); // merged with its twin

  const Quadtree tree(points);
  std::cout << tree.framework().number_of_points() << " distinct points, "
            << tree.framework().duplicates().size() << " duplicate\n"
            << "framework: " << tree.framework().number_of_nodes()
            << " squares with two or more nonempty children\n"
            << "balanced quadtree: " << tree.number_of_nodes() << " squares, " << tree.number_of_leaves()
            << " leaves, depth " << tree.depth() << "\n";

  const Quadtree::Leaf_index leaf = tree.locate(Point(0, 0));
  const auto corners = tree.corners(leaf);
  std::cout << "the origin is in leaf " << leaf << ", from " << corners[0] << " to " << corners[2]
            << ", with " << tree.points(leaf).size() << " points\nits neighbors, counterclockwise:";
  for (Quadtree::Leaf_index neighbor : tree.neighbors(leaf)) std::cout << ' ' << neighbor;
  std::cout << '\n';

  if (argc < 2) return 0;
  try {
    using Options = CGAL::IO::Quadtree_svg_options;
    CGAL::IO::write_SVG(argv[1], tree,
                        Options().fill_by(Options::Fill::LEVEL).clip_to({-1.1, -1.1, 1.1, 1.1}));
  } catch (const std::runtime_error& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
