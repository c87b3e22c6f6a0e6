// Gives a mesh to PETSc as a DMPlex in parallel: from the arrays that each rank holds, without a file. Integrates the
// area of the domain, and solves Poisson's equation by linear finite elements with KSP:
//
//   mpirun -n 4 mesh_for_petsc [LARGEST_AREA_OF_TRIANGLES] [options of PETSc, such as -ksp_monitor]
//
// The domain is a square with a square hole. The solution is known: u = sin(x) exp(y / 2), for which -laplace u is
// 3/4 u.

#include <CGAL/Distributed_quality_mesher_2.h>

#include <petscdmplex.h>
#include <petscksp.h>
#include <petscsf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <set>
#include <utility>
#include <vector>

using Mesher = CGAL::Distributed_quality_mesher_2<>;
using Part = Mesher::Mesh;

/// Ends the program if a function of PETSc fails; PETSc has told why.
void check(int error) {
  if (error != 0) MPI_Abort(PETSC_COMM_WORLD, 1);
}

double solution(double x, double y) { return std::sin(x) * std::exp(y / 2); }
double load(double x, double y) { return 0.75 * solution(x, y); }

constexpr double area_of_domain = 12;
Mesher::Pslg domain() {
  Mesher::Pslg pslg;
  for (const double r : {2., 1.}) {
    const std::size_t first = pslg.vertices.size();
    for (const auto& [x, y] : {std::pair(-r, -r), {r, -r}, {r, r}, {-r, r}}) pslg.add_vertex({x, y});
    for (std::size_t i = 0; i < 4; ++i)
      pslg.add_segment(Mesher::Pslg::Vertex_index(first + i),
                       Mesher::Pslg::Vertex_index(first + (i + 1) % 4));
  }
  pslg.holes.push_back({0, 0});
  return pslg;
}

/// All ranks make the mesh. The graph is that of the first rank; large ones are read in slices (IO/read_slices.h).
Part mesh_on_all_ranks(double max_area) {
  const auto options = CGAL::Quality_mesh_options_2().max_area(max_area);
  return Mesher(PETSC_COMM_WORLD, options)(domain());
}

/// The vertices at the border. All triangles around a vertex of an own triangle are own ones or ghosts, so a side there
/// with one triangle is on the border. (Vertices that only ghosts have may be here wrongly; PETSc has none of them.)
std::set<Part::Number> border_vertices(const Part& part) {
  std::map<std::pair<Part::Number, Part::Number>, int> triangles_at;
  for (const auto& t : part.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++triangles_at[std::minmax(t[k], t[(k + 1) % 3])];
  std::set<Part::Number> border;
  for (const auto& [side, n] : triangles_at)
    if (n == 1) border.insert({side.first, side.second});
  return border;
}

/// A mesh of PETSc with one unknown for each vertex.
struct Plex {
  DM dm = nullptr;
  PetscSection section = nullptr;
  std::vector<Part::Number> vertices; ///< per vertex of PETSc at this rank, its number in the mesh
};

/// The arrays are what `DMPlexCreateFromCellListParallelPetsc()` takes, but for the size of PetscInt.
Plex plex_of(const Part& part) {
  std::vector<PetscInt> cells;
  std::vector<PetscReal> coordinates;
  for (std::size_t t = 0; t < part.number_of_own_triangles(); ++t)
    for (const Part::Number v : part.triangles[t]) cells.push_back(static_cast<PetscInt>(v));
  for (std::size_t v = 0; v < part.number_of_own_vertices(); ++v)
    coordinates.insert(coordinates.end(), {part.points[v].x(), part.points[v].y()});
  Plex plex;
  PetscSF places = nullptr; // where the vertices of this rank were given
  check(DMPlexCreateFromCellListParallelPetsc(
      PETSC_COMM_WORLD, 2, static_cast<PetscInt>(part.number_of_own_triangles()),
      static_cast<PetscInt>(part.number_of_own_vertices()), static_cast<PetscInt>(part.number_of_vertices()),
      3, PETSC_TRUE, cells.data(), 2, coordinates.data(), &places, nullptr, &plex.dm));
  PetscInt begin = 0, end = 0;
  check(DMPlexGetDepthStratum(plex.dm, 0, &begin, &end));
  PetscInt n = 0;
  const PetscSFNode* given = nullptr;
  check(PetscSFGetGraph(places, nullptr, &n, nullptr, &given));
  for (PetscInt v = 0; v < n; ++v)
    plex.vertices.push_back(part.first_vertex[static_cast<std::size_t>(given[v].rank)] + given[v].index);
  check(PetscSFDestroy(&places));
  check(PetscSectionCreate(PETSC_COMM_WORLD, &plex.section));
  check(PetscSectionSetChart(plex.section, begin, end));
  for (PetscInt v = begin; v < end; ++v) check(PetscSectionSetDof(plex.section, v, 1));
  check(PetscSectionSetUp(plex.section));
  check(DMSetLocalSection(plex.dm, plex.section));
  check(DMSetBasicAdjacency(plex.dm, PETSC_FALSE, PETSC_TRUE)); // that of finite elements
  return plex;
}

struct Triangle {
  std::array<PetscInt, 3> unknowns; ///< at this rank
  std::array<double, 3> x, y;

  double area() const { return ((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])) / 2; }
  /// The integral of the product of the gradients of two linear functions, which are 1 at one corner each.
  double stiffness(std::size_t i, std::size_t j) const {
    const auto dx = [this](std::size_t k) { return x[(k + 2) % 3] - x[(k + 1) % 3]; };
    const auto dy = [this](std::size_t k) { return y[(k + 2) % 3] - y[(k + 1) % 3]; };
    return (dx(i) * dx(j) + dy(i) * dy(j)) / (4 * area());
  }
};

/// As PETSc has them, counterclockwise.
std::vector<Triangle> triangles_of(const Plex& plex) {
  Vec places = nullptr;
  PetscSection of_places = nullptr;
  const PetscScalar* coordinates = nullptr;
  check(DMGetCoordinatesLocal(plex.dm, &places));
  check(DMGetCoordinateSection(plex.dm, &of_places));
  check(VecGetArrayRead(places, &coordinates));
  PetscInt begin = 0, end = 0, first_vertex = 0, last_vertex = 0;
  check(DMPlexGetHeightStratum(plex.dm, 0, &begin, &end));
  check(DMPlexGetDepthStratum(plex.dm, 0, &first_vertex, &last_vertex));
  std::vector<Triangle> triangles;
  for (PetscInt cell = begin; cell < end; ++cell) {
    PetscInt n = 0, *closure = nullptr;
    check(DMPlexGetTransitiveClosure(plex.dm, cell, PETSC_TRUE, &n, &closure));
    Triangle t{};
    std::size_t k = 0;
    for (PetscInt i = 0; i < n; ++i) {
      const PetscInt point = closure[2 * i];
      if (point < first_vertex || point >= last_vertex) continue;
      PetscInt place = 0;
      check(PetscSectionGetOffset(of_places, point, &place));
      check(PetscSectionGetOffset(plex.section, point, &t.unknowns[k]));
      t.x[k] = PetscRealPart(coordinates[place]), t.y[k] = PetscRealPart(coordinates[place + 1]);
      ++k;
    }
    check(DMPlexRestoreTransitiveClosure(plex.dm, cell, PETSC_TRUE, &n, &closure));
    triangles.push_back(t);
  }
  check(VecRestoreArrayRead(places, &coordinates));
  return triangles;
}

double area_of(const std::vector<Triangle>& triangles) {
  long double own = 0; // a double would lose digits if there are many
  for (const Triangle& t : triangles) own += t.area();
  double area = static_cast<double>(own);
  check(MPI_Allreduce(MPI_IN_PLACE, &area, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD));
  return area;
}

/// The linear system; `exact` has the solution at the vertices.
struct System {
  Mat matrix = nullptr;
  Vec load = nullptr, unknown = nullptr, exact = nullptr;
};

/// The solution is fixed on the border: such a vertex has an equation of its own, and its value goes to the load of
/// others.
System assemble(const Plex& plex, const std::vector<Triangle>& triangles, const std::vector<bool>& is_fixed) {
  System s;
  check(DMCreateMatrix(plex.dm, &s.matrix));
  check(DMCreateGlobalVector(plex.dm, &s.load));
  ISLocalToGlobalMapping numbers = nullptr; // of unknowns
  check(DMGetLocalToGlobalMapping(plex.dm, &numbers));
  check(MatSetLocalToGlobalMapping(s.matrix, numbers, numbers));
  check(VecSetLocalToGlobalMapping(s.load, numbers));
  check(VecDuplicate(s.load, &s.unknown)), check(VecDuplicate(s.load, &s.exact));
  for (const Triangle& t : triangles) {
    std::array<PetscScalar, 9> stiffness{};
    std::array<PetscScalar, 3> loads{}, values{};
    for (std::size_t i = 0; i < 3; ++i) values[i] = solution(t.x[i], t.y[i]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_fixed[static_cast<std::size_t>(t.unknowns[i])]) {
        stiffness[4 * i] = 1, loads[i] = values[i];
        continue;
      }
      loads[i] = load(t.x[i], t.y[i]) * t.area() / 3;
      for (std::size_t j = 0; j < 3; ++j)
        if (is_fixed[static_cast<std::size_t>(t.unknowns[j])])
          loads[i] -= t.stiffness(i, j) * values[j];
        else
          stiffness[3 * i + j] = t.stiffness(i, j);
    }
    check(MatSetValuesLocal(s.matrix, 3, t.unknowns.data(), 3, t.unknowns.data(), stiffness.data(),
                            ADD_VALUES));
    check(VecSetValuesLocal(s.load, 3, t.unknowns.data(), loads.data(), ADD_VALUES));
    check(VecSetValuesLocal(s.exact, 3, t.unknowns.data(), values.data(), INSERT_VALUES));
  }
  check(MatAssemblyBegin(s.matrix, MAT_FINAL_ASSEMBLY)), check(MatAssemblyEnd(s.matrix, MAT_FINAL_ASSEMBLY));
  for (const Vec v : {s.load, s.exact}) check(VecAssemblyBegin(v)), check(VecAssemblyEnd(v));
  return s;
}

/// \returns whether the solver got there
bool solve(const System& s) {
  KSP solver = nullptr;
  check(KSPCreate(PETSC_COMM_WORLD, &solver));
  check(KSPSetOperators(solver, s.matrix, s.matrix));
  check(KSPSetType(solver, KSPCG));
  check(KSPSetTolerances(solver, 1e-10, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT));
  check(KSPSetFromOptions(solver));
  check(KSPSolve(solver, s.load, s.unknown));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt steps = 0, n = 0;
  PetscReal norm = 0, error = 0, greatest = 0;
  check(KSPGetConvergedReason(solver, &reason)), check(KSPGetIterationNumber(solver, &steps));
  check(VecGetSize(s.unknown, &n)), check(VecNorm(s.exact, NORM_2, &norm));
  check(VecAXPY(s.unknown, -1, s.exact));
  check(VecNorm(s.unknown, NORM_2, &error)), check(VecNorm(s.unknown, NORM_INFINITY, &greatest));
  check(PetscPrintf(PETSC_COMM_WORLD, "%d unknowns, %d steps; relative error %.3e, greatest error %.3e\n",
                    static_cast<int>(n), static_cast<int>(steps), error / norm, greatest));
  check(KSPDestroy(&solver));
  return reason > 0 && error < 1e-3 * norm;
}

bool run(double max_area) {
  const Part part = mesh_on_all_ranks(max_area);
  Plex plex = plex_of(part);
  const std::vector<Triangle> triangles = triangles_of(plex);
  const double area = area_of(triangles);
  check(PetscPrintf(PETSC_COMM_WORLD, "area %.15g, relative error %.1e\n", area, area / area_of_domain - 1));
  const std::set<Part::Number> border = border_vertices(part);
  std::vector<bool> is_fixed;
  for (const Part::Number v : plex.vertices) is_fixed.push_back(border.count(v) > 0);
  System s = assemble(plex, triangles, is_fixed);
  const bool is_solved = solve(s);
  check(MatDestroy(&s.matrix));
  for (Vec* v : {&s.load, &s.unknown, &s.exact}) check(VecDestroy(v));
  check(PetscSectionDestroy(&plex.section)), check(DMDestroy(&plex.dm));
  return is_solved && std::abs(area / area_of_domain - 1) < 1e-12;
}

int main(int argc, char** argv) {
  check(PetscInitialize(&argc, &argv, nullptr, nullptr));
  bool is_right = false;
  try {
    is_right = run(argc > 1 && argv[1][0] != '-' ? std::strtod(argv[1], nullptr) : 0.002);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    MPI_Abort(PETSC_COMM_WORLD, 1);
  }
  check(PetscFinalize());
  return is_right ? 0 : 1;
}
