// Builds the framework of a few points (Theorem 1 of the paper): only squares with two or more nonempty
// children. Prints the squares with their points, climbs from a point to the root, and annotates a point with
// the size that its leaf should have.

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>

#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint32_t>; // the root is [0, 2^31) x [0, 2^31)
using Framework = CGAL::Quadtree_framework<Traits>;
using Node = Framework::Node_index;
using Rank = Framework::Point_rank;

int main() {
  const std::vector<Traits::Point_2> points{{40, 40}, {1, 1}, {7, 6}, {2, 1}, {1, 1}, {44, 44}, {41, 40}};
  Framework framework(points);

  // Equal points count once.
  for (const auto& d : framework.duplicates())
    std::cout << "point " << d.duplicate << " equals point " << d.kept << '\n';

  // Nodes are in preorder, and each holds an interval of the points in shuffle order (Lemma 1).
  int indentation = 0;
  const auto print = [&](Node v, const auto& print_node) -> void {
    const auto square = framework.square(v);
    std::cout << std::string(std::size_t(indentation), ' ') << "square at (" << square.x << ", " << square.y
              << ") with side " << (1u << (31 - square.level)) << ": points of rank "
              << framework.points(v).begin << " to " << framework.points(v).end.value() - 1 << '\n';
    indentation += 2;
    framework.for_each_child(
        v, [&](Node child) { print_node(child, print_node); },
        [&](Rank r) {
          std::cout << std::string(std::size_t(indentation), ' ') << "point " << framework.input_point(r)
                    << " (" << framework.grid_point(r) << ")\n";
        });
    indentation -= 2;
  };
  print(framework.root(), print);

  // The nearest ancestors are found in constant time each (Lemma 3), however many squares lie between them.
  const Rank rank = framework.rank(Framework::Point_index(6));
  std::cout << "levels of the squares around point 6:";
  for (Node v = framework.node(rank); v.is_valid(); v = framework.parent(v))
    std::cout << ' ' << framework.level(v);

  // Quadtrees made from the framework follow annotations.
  std::vector<int> levels(framework.number_of_points(), 0);
  levels[std::size_t(framework.rank(Framework::Point_index(2)))] = 31;
  const auto leaves = [&] { return CGAL::Balanced_quadtree<Traits>(framework).number_of_leaves(); };
  std::cout << "\nbalanced quadtree: " << leaves() << " leaves";
  framework.annotate(levels);
  std::cout << ", with point 2 in a leaf of one unit: " << leaves() << '\n';
}
