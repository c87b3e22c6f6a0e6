// Finds what is near the vertices of a planar straight-line graph: the segments that horizontal and vertical
// rays hit, and how far a sector between two segments is empty.

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quadtree_vertex_edge_neighbors_2.h>

#include <iostream>

using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Pslg = CGAL::Pslg_2<Traits::Point_2>;
using Neighbors = CGAL::Quadtree_vertex_edge_neighbors_2<Traits>;
using CGAL::Quadtree_mesh_2::Direction;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Vertex_index;

int main() {
  // An acute corner at vertex 0, and a segment that cuts across it.
  Pslg pslg;
  const Vertex_index apex = pslg.add_vertex({0, 0}), a = pslg.add_vertex({10, 1}),
                     b = pslg.add_vertex({9, 4});
  const Vertex_index c = pslg.add_vertex({6, 2}), d = pslg.add_vertex({4, 8});
  const Segment_index right = pslg.add_segment(apex, a), left = pslg.add_segment(apex, b);
  pslg.add_segment(c, d);

  const Neighbors neighbors(pslg);
  const char* const names[] = {"east", "north", "west", "south"};
  for (const Vertex_index v : {apex, c}) {
    std::cout << "from vertex " << v << " at " << pslg.point(v) << ":\n";
    for (int i = 0; i < 4; ++i) {
      const auto hit = neighbors.first_hit(v, static_cast<Direction>(2 * i)); // every other one is diagonal
      if (hit.exists())
        std::cout << "  " << names[i] << ": segment " << hit.segment << " at distance " << hit.distance
                  << '\n';
    }
    if (neighbors.nearest_hit(v).exists())
      std::cout << "  the nearest of them: segment " << neighbors.nearest_hit(v).segment << '\n';
  }

  const auto nearest = neighbors.nearest_in_sector(apex, right, left);
  std::cout << "the corner at vertex 0 is clear up to " << nearest.distance << ", where "
            << (nearest.vertex.is_valid() ? "vertex " : "segment ")
            << (nearest.vertex.is_valid() ? nearest.vertex.value() : nearest.segment.value()) << " is\n";
}
