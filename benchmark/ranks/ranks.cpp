// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What ranks of MPI hold and send to make the quadtree of all their points:
//
//     mpirun -n 4 build/bin/ranks uniform:1e6 clusters:1e6 pairs:1e5 FILE.poly [--max-points M]
//
// Each rank makes its slice of the points by itself, or reads it from the file. Messages and collective operations are
// those of the whole program, p4est among it: MPI's profiling interface sees them all. Prints a row for each input.
//
// Memory is the peak of what each process has in memory while the tree is made, with the slice, the libraries and the
// buffers of MPI. What was freed after an earlier input may be among it, so measure one input in a run. That of no
// points, uniform:0, is what a rank needs in any case.

#include <CGAL/Distributed_quadtree_2.h>
#include <CGAL/IO/read_slices.h>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

std::int64_t messages = 0, bytes = 0, collectives = 0;

int count_message(int n, MPI_Datatype type) {
  int size = 0;
  PMPI_Type_size(type, &size);
  ++messages, bytes += std::int64_t(n) * size;
  return 0;
}

} // namespace

// What all that is linked here calls to send. Names and parameters are MPI's.
extern "C" {
int MPI_Send(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  return count_message(n, type), PMPI_Send(data, n, type, to, tag, comm);
}
int MPI_Isend(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request* request) {
  return count_message(n, type), PMPI_Isend(data, n, type, to, tag, comm, request);
}
int MPI_Issend(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm,
               MPI_Request* request) {
  return count_message(n, type), PMPI_Issend(data, n, type, to, tag, comm, request);
}
int MPI_Allreduce(const void* from, void* to, int n, MPI_Datatype type, MPI_Op operation, MPI_Comm comm) {
  return ++collectives, PMPI_Allreduce(from, to, n, type, operation, comm);
}
int MPI_Allgather(const void* from, int n, MPI_Datatype type, void* to, int m, MPI_Datatype to_type,
                  MPI_Comm comm) {
  return ++collectives, PMPI_Allgather(from, n, type, to, m, to_type, comm);
}
int MPI_Exscan(const void* from, void* to, int n, MPI_Datatype type, MPI_Op operation, MPI_Comm comm) {
  return ++collectives, PMPI_Exscan(from, to, n, type, operation, comm);
}
int MPI_Scan(const void* from, void* to, int n, MPI_Datatype type, MPI_Op operation, MPI_Comm comm) {
  return ++collectives, PMPI_Scan(from, to, n, type, operation, comm);
}
int MPI_Bcast(void* data, int n, MPI_Datatype type, int root, MPI_Comm comm) {
  return ++collectives, PMPI_Bcast(data, n, type, root, comm);
}
int MPI_Ibarrier(MPI_Comm comm, MPI_Request* request) { return ++collectives, PMPI_Ibarrier(comm, request); }
}

namespace {

using Tree = CGAL::Distributed_quadtree_2<>;
using Point_2 = Tree::Point_2;

/// A number between 0 and 1 that follows from two others alone, so that slices do not depend on the number of ranks.
double number_of(std::int64_t i, std::uint64_t which) {
  std::uint64_t z = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u + which * 0xd1342543de82ef95u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return std::ldexp(static_cast<double>((z ^ (z >> 31)) >> 11), -53);
}

Point_2 point_of(const std::string& family, std::int64_t i) {
  if (family == "uniform") return Point_2(number_of(i, 1), number_of(i, 2));
  if (family == "clusters") { // around 100 places, at distances of all sizes down to 2^-20
    const std::int64_t center = static_cast<std::int64_t>(100 * number_of(i, 3));
    const double r = std::exp2(-20 * number_of(i, 4)), angle = 6.283185307179586 * number_of(i, 5);
    return Point_2(number_of(center, 6) + r * std::cos(angle), number_of(center, 7) + r * std::sin(angle));
  }
  // Pairs, 2^-35 apart, which is below the levels of p4est.
  return Point_2(number_of(i / 2, 8) + (i % 2 == 0 ? 0 : 0x1p-35), number_of(i / 2, 9));
}

std::vector<Point_2> slice_of(const std::string& input, int rank, int ranks) {
  const std::size_t colon = input.find(':');
  if (colon == std::string::npos) {
    CGAL::Pslg_slice_2<Point_2> slice;
    CGAL::IO::read_triangle_poly_slice(MPI_COMM_WORLD, input, slice);
    return slice.vertices;
  }
  const std::int64_t n = static_cast<std::int64_t>(std::atof(input.c_str() + colon + 1));
  const std::int64_t begin = n * rank / ranks, end = n * (rank + 1) / ranks;
  std::vector<Point_2> points;
  points.reserve(static_cast<std::size_t>(end - begin));
  for (std::int64_t i = begin; i < end; ++i) points.push_back(point_of(input.substr(0, colon), i));
  return points;
}

// By the files of Linux; without them there is no peak, and it is 0.
void forget_peak_of_memory() { std::ofstream("/proc/self/clear_refs") << 5; }
double peak_of_memory_in_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return std::stod(line.substr(6)) * 1024e-6;
  return 0;
}

struct Over_ranks {
  double mean, most;
};

Over_ranks over_ranks(double value, int ranks) {
  Over_ranks result{value, value};
  PMPI_Allreduce(MPI_IN_PLACE, &result.mean, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  PMPI_Allreduce(MPI_IN_PLACE, &result.most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  result.mean /= ranks;
  return result;
}

void print_row(const std::string& input, const CGAL::Quadtree_options& options) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::vector<Point_2> slice = slice_of(input, rank, ranks);
  messages = bytes = collectives = 0;
  forget_peak_of_memory();
  const double begin = MPI_Wtime();
  const Tree tree(MPI_COMM_WORLD, slice, options);
  const double seconds = over_ranks(MPI_Wtime() - begin, ranks).most;
  const Over_ranks sent = over_ranks(static_cast<double>(messages), ranks),
                   kilobytes = over_ranks(1e-3 * static_cast<double>(bytes), ranks),
                   taken_part = over_ranks(static_cast<double>(collectives), ranks),
                   leaves = over_ranks(static_cast<double>(tree.number_of_leaves()), ranks),
                   points = over_ranks(static_cast<double>(tree.number_of_points()), ranks),
                   ghosts = over_ranks(static_cast<double>(tree.ghosts().size()), ranks),
                   memory = over_ranks(peak_of_memory_in_mb(), ranks);
  if (rank != 0) return;
  const std::string name = input.substr(input.find_last_of('/') + 1);
  std::printf(
      "| %s | %d | %lld | %lld | %d | %.2f | %.2f | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f | "
      "%.2f |\n",
      name.c_str(), ranks, static_cast<long long>(tree.number_of_all_points()),
      static_cast<long long>(tree.number_of_all_leaves()), tree.depth(),
      points.mean > 0 ? points.most / points.mean : 1, leaves.most / leaves.mean, ghosts.most, sent.mean,
      sent.most, kilobytes.mean, kilobytes.most, taken_part.most, memory.mean, memory.most, seconds);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  CGAL::Quadtree_options options;
  std::vector<std::string> inputs;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--max-points" && i + 1 < argc)
      options.max_points_per_leaf(static_cast<std::size_t>(std::atoll(argv[++i])));
    else
      inputs.emplace_back(argv[i]);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    std::printf("| input | ranks | points | leaves | depth | points: most / mean | leaves: most / mean | "
                "most ghosts | "
                "messages: mean | most | kB: mean | most | collectives | peak MB: mean | most | s |\n");
  for (const std::string& input : inputs) print_row(input, options);
  MPI_Finalize();
}
