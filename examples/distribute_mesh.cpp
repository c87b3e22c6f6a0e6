// Meshes a graph on one rank of MPI, gives each rank its part, and writes each kind of file by all ranks:
//
//   mpirun -n 4 distribute_mesh INPUT.poly OUTPUT
//
// OUTPUT.pvtu with a piece for each rank, OUTPUT_1.msh, OUTPUT_2.msh, ... for Gmsh, OUTPUT.vtkhdf, and OUTPUT.xdmf with
// OUTPUT.h5.

#include <CGAL/IO/Distributed_mesh_files.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/distribute_mesh_2.h>
#include <CGAL/renumber_mesh_2.h>

#include <mpi.h>

#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

using Mesher = CGAL::Quality_mesher_2<>;
using Part = CGAL::Distributed_mesh_2<Mesher::Mesh::Point_2>;

/// The mesh is made at the first rank; others have nothing before they get their part.
Part mesh_at_first_rank(const std::string& input, int rank) {
  Mesher::Pslg pslg;
  Mesher::Mesh mesh;
  try {
    if (rank == 0) {
      CGAL::IO::read_triangle_poly(input, pslg);
      mesh = Mesher()(pslg);
      CGAL::renumber_by_place(mesh); // so that parts are compact
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    MPI_Abort(MPI_COMM_WORLD, 1); // others wait for their parts
  }
  return CGAL::distribute_mesh_2(MPI_COMM_WORLD, mesh, pslg);
}

void write_files(const Part& part, const std::string& output) {
  // A number for each triangle, here the rank that owns it.
  CGAL::IO::Triangle_fields_2 fields{{"rank", {}}};
  fields[0].values.assign(part.number_of_own_triangles(), part.rank);
  CGAL::IO::write_PVTU(MPI_COMM_WORLD, output + ".pvtu", part, fields);
  CGAL::IO::write_MSH_parts(MPI_COMM_WORLD, output + ".msh", part);
  CGAL::IO::write_VTKHDF(MPI_COMM_WORLD, output + ".vtkhdf", part, fields);
  CGAL::IO::write_XDMF(MPI_COMM_WORLD, output + ".xdmf", part, fields);
}

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, failed = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  try {
    const Part part =
        mesh_at_first_rank(argc > 1 ? argv[1] : QUADTREE_MESH_EXAMPLE_DATA_DIR "/great_lakes.poly.gz", rank);
    std::ostringstream line; // whole lines, as ranks write at the same time
    line << "rank " << rank << ": " << part.number_of_own_triangles() << " triangles, "
         << part.ghost_triangles.size() << " ghosts, " << part.number_of_own_vertices() << " vertices, "
         << part.foreign_vertices.size() << " foreign ones\n";
    std::cout << line.str() << std::flush;
    const std::string defect = CGAL::defect_of_distributed_mesh_2(MPI_COMM_WORLD, part);
    if (!defect.empty()) throw std::logic_error(defect);
    write_files(part, argc > 2 ? argv[2] : "great_lakes_in_parts");
  } catch (const std::exception& error) { // the same at all ranks
    if (rank == 0) std::cerr << error.what() << '\n';
    failed = 1;
  }
  MPI_Finalize();
  return failed;
}
