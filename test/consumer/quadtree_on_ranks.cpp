// Makes the quadtree of points of all ranks; the exit status tells whether it has as many leaves as that of one rank.

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Distributed_quadtree_2.h>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <vector>

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  using Tree = CGAL::Distributed_quadtree_2<>;
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<Tree::Point_2> all, slice;
  for (int i = 0; i < 1000; ++i) {
    all.emplace_back(i * 37 % 101, i * 53 % 103);
    if (i % 2 == 0 ? rank == 0 : rank == ranks - 1) slice.push_back(all.back());
  }
  bool is_good = true;
  {
    const Tree tree(MPI_COMM_WORLD, slice);
    const CGAL::Balanced_quadtree<Tree::Traits> whole(all);
    is_good = tree.number_of_all_leaves() == static_cast<std::int64_t>(whole.number_of_leaves());
  }
  MPI_Finalize();
  return is_good ? 0 : 1;
}
