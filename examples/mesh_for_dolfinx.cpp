// Gives a mesh to dolfinx (FEniCSx) in parallel: from the arrays that each rank holds, without a file, and with owners
// and ghosts as they are. Integrates the area of the domain, and solves Poisson's equation by linear finite elements:
//
//   mpirun -n 4 mesh_for_dolfinx [LARGEST_AREA_OF_TRIANGLES] [options of PETSc, such as -ksp_monitor]
//
// The domain is a square with a square hole. The solution is known: u = sin(x) exp(y / 2), for which -laplace u is
// 3/4 u. The first rank solves the same by itself: the answers have to be the same.
//
// This is for dolfinx 0.5. The integrals are written out below, so no compiler of forms is needed.

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/distribute_mesh_2.h>
#include <CGAL/renumber_mesh_2.h>

#include <basix/finite-element.h>
#include <dolfinx.h>
#include <dolfinx/fem/petsc.h>
#include <dolfinx/la/petsc.h>
#include <petscksp.h>
#include <xtensor/xmath.hpp>
#include <xtensor/xview.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace fem = dolfinx::fem;
namespace graph = dolfinx::graph;

using Mesher = CGAL::Quality_mesher_2<>;
using Part = CGAL::Distributed_mesh_2<Mesher::Mesh::Point_2>;
using Mesh = dolfinx::mesh::Mesh;
using Space = fem::FunctionSpace;
using Function = fem::Function<double>;
using Form = fem::Form<double>;

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

/// Per own triangle its ranks: this one, and those that have it as a ghost. These are the owners of the ghosts at its
/// vertices, as triangles with a vertex in common are ghosts of each other's ranks.
graph::AdjacencyList<std::int32_t> ranks_of_triangles(const Part& part) {
  std::map<Part::Number, std::set<std::int32_t>> ranks_at;
  for (std::size_t t = part.number_of_own_triangles(); t < part.triangles.size(); ++t)
    for (const Part::Number v : part.triangles[t])
      ranks_at[v].insert(part.owner_of_triangle(part.number_of_triangle(t)));
  std::vector<std::vector<std::int32_t>> ranks;
  for (std::size_t t = 0; t < part.number_of_own_triangles(); ++t) {
    std::set<std::int32_t> others;
    for (const Part::Number v : part.triangles[t])
      if (const auto found = ranks_at.find(v); found != ranks_at.end())
        others.insert(found->second.begin(), found->second.end());
    ranks.push_back({part.rank}); // the owner is the first one
    ranks.back().insert(ranks.back().end(), others.begin(), others.end());
  }
  return graph::AdjacencyList<std::int32_t>(ranks);
}

/// The arrays are what `create_mesh()` takes. Its graph partitioner would move triangles, so it gets another one.
std::shared_ptr<Mesh> mesh_of(MPI_Comm comm, const Part& part) {
  std::vector<std::int64_t> cells;
  std::vector<double> coordinates;
  for (std::size_t t = 0; t < part.number_of_own_triangles(); ++t)
    cells.insert(cells.end(), part.triangles[t].begin(), part.triangles[t].end());
  for (std::size_t v = 0; v < part.number_of_own_vertices(); ++v)
    coordinates.insert(coordinates.end(), {part.points[v].x(), part.points[v].y()});
  return std::make_shared<Mesh>(dolfinx::mesh::create_mesh(
      comm, graph::regular_adjacency_list(std::move(cells), 3),
      fem::CoordinateElement(dolfinx::mesh::CellType::triangle, 1), coordinates,
      {part.number_of_own_vertices(), 2}, dolfinx::mesh::GhostMode::shared_facet,
      [&part](MPI_Comm, int, int, const auto&, auto) { return ranks_of_triangles(part); }));
}

/// Whether each rank of dolfinx owns the triangles that it had, and has the ghosts that it had.
bool is_where_it_was(MPI_Comm comm, const Mesh& mesh, const Part& part) {
  const auto triangles = mesh.topology().index_map(2);
  const std::size_t n = static_cast<std::size_t>(triangles->size_local());
  std::set<Part::Number> own, ghosts;
  for (std::size_t t = 0; t < mesh.topology().original_cell_index.size(); ++t)
    (t < n ? own : ghosts).insert(mesh.topology().original_cell_index[t]);
  int is_same = n == part.number_of_own_triangles() && own.size() == n &&
                (n == 0 || (*own.begin() == part.number_of_triangle(0) &&
                            *own.rbegin() == part.number_of_triangle(n - 1))) &&
                ghosts == std::set<Part::Number>(part.ghost_triangles.begin(), part.ghost_triangles.end());
  MPI_Allreduce(MPI_IN_PLACE, &is_same, 1, MPI_INT, MPI_LAND, comm);
  return is_same != 0;
}

/// A triangle as dolfinx has it: three coordinates of each corner.
struct Triangle {
  const double* corners;

  double x(std::size_t k) const { return corners[3 * (k % 3)]; }
  double y(std::size_t k) const { return corners[3 * (k % 3) + 1]; }
  double area() const { return std::abs((x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0))) / 2; }
  /// The integral of the product of the gradients of two linear functions, which are 1 at one corner each.
  double stiffness(std::size_t i, std::size_t j) const {
    return ((x(i + 2) - x(i + 1)) * (x(j + 2) - x(j + 1)) + (y(i + 2) - y(i + 1)) * (y(j + 2) - y(j + 1))) /
           (4 * area());
  }
  /// The integral of the product of such functions.
  double mass(std::size_t i, std::size_t j) const { return area() / (i == j ? 6 : 12); }
};

/// An integral over all triangles.
/// \param add what a triangle adds, from the values of `coefficient` at its corners
Form form(const std::vector<std::shared_ptr<const Space>>& spaces,
          const std::vector<std::shared_ptr<const Function>>& coefficients,
          const std::function<void(double* sums, const double* values, const Triangle&)>& add,
          const std::shared_ptr<const Mesh>& mesh) {
  const auto of_triangle = [add](double* sums, const double* values, const double*, const double* corners,
                                 const int*, const std::uint8_t*) { add(sums, values, {corners}); };
  return Form(spaces, {{fem::IntegralType::cell, {{{-1, of_triangle}}, nullptr}}}, coefficients, {}, false,
              mesh);
}

double sum_over_ranks(const Form& form) {
  double sum = fem::assemble_scalar(form);
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, form.mesh()->comm());
  return sum;
}

/// The integral of 1. Each unknown gets its share, as `assemble_scalar()` adds up triangle by triangle, which costs
/// digits if they are many.
double area_of(const std::shared_ptr<const Space>& space) {
  dolfinx::la::Vector<double> shares(space->dofmap()->index_map, 1);
  const auto add = [](double* sums, auto, const Triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) sums[i] += t.area() / 3;
  };
  fem::assemble_vector(shares.mutable_array(), form({space}, {}, add, space->mesh()));
  shares.scatter_rev(std::plus<>());
  const std::span<const double> own =
      shares.array().first(static_cast<std::size_t>(space->dofmap()->index_map->size_local()));
  double area = static_cast<double>(std::accumulate(own.begin(), own.end(), 0.L));
  MPI_Allreduce(MPI_IN_PLACE, &area, 1, MPI_DOUBLE, MPI_SUM, space->mesh()->comm());
  return area;
}

/// The integral of the square of a function.
double square_of(const std::shared_ptr<const Function>& u) {
  const auto add = [](double* sum, const double* values, const Triangle& t) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) *sum += values[i] * values[j] * t.mass(i, j);
  };
  return sum_over_ranks(form({}, {u}, add, u->function_space()->mesh()));
}

std::shared_ptr<Function> exact_solution(const std::shared_ptr<const Space>& space) {
  const auto u = std::make_shared<Function>(space);
  u->interpolate([](const auto& x) -> xt::xarray<double> {
    return xt::sin(xt::row(x, 0)) * xt::exp(xt::row(x, 1) / 2);
  });
  return u;
}

std::vector<std::int32_t> unknowns_at_border(const Space& space) {
  const auto& topology = space.mesh()->topology_mutable();
  space.mesh()->topology_mutable().create_connectivity(1, 2);
  return fem::locate_dofs_topological(space, 1, dolfinx::mesh::exterior_facet_indices(topology));
}

/// \param exact is the solution at the border, too
std::shared_ptr<Function> solve(const std::shared_ptr<const Function>& exact) {
  const auto space = exact->function_space();
  const auto mesh = space->mesh();
  const auto a = std::make_shared<Form>(form(
      {space, space}, {},
      [](double* sums, auto, const Triangle& t) {
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) sums[3 * i + j] += t.stiffness(i, j);
      },
      mesh));
  const Form load = form(
      {space}, {exact},
      [](double* sums, const double* u, const Triangle& t) {
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) sums[i] += 0.75 * u[j] * t.mass(i, j);
      },
      mesh);
  const std::vector<std::shared_ptr<const fem::DirichletBC<double>>> border{
      std::make_shared<const fem::DirichletBC<double>>(exact, unknowns_at_border(*space))};
  const auto u = std::make_shared<Function>(space);
  dolfinx::la::Vector<double> b(space->dofmap()->index_map, 1);
  const dolfinx::la::petsc::Matrix matrix(fem::petsc::create_matrix(*a), false);

  fem::assemble_matrix(dolfinx::la::petsc::Matrix::set_fn(matrix.mat(), ADD_VALUES), *a, border);
  MatAssemblyBegin(matrix.mat(), MAT_FLUSH_ASSEMBLY), MatAssemblyEnd(matrix.mat(), MAT_FLUSH_ASSEMBLY);
  fem::set_diagonal(dolfinx::la::petsc::Matrix::set_fn(matrix.mat(), INSERT_VALUES), *space, border);
  MatAssemblyBegin(matrix.mat(), MAT_FINAL_ASSEMBLY), MatAssemblyEnd(matrix.mat(), MAT_FINAL_ASSEMBLY);
  fem::assemble_vector(b.mutable_array(), load);
  fem::apply_lifting(b.mutable_array(), {a}, {border}, {}, 1.);
  b.scatter_rev(std::plus<>());
  fem::set_bc(b.mutable_array(), border);

  const dolfinx::la::petsc::KrylovSolver solver(mesh->comm());
  KSPSetType(solver.ksp(), KSPCG);
  KSPSetTolerances(solver.ksp(), 1e-12, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT);
  KSPSetFromOptions(solver.ksp());
  KSPSetOperators(solver.ksp(), matrix.mat(), matrix.mat());
  const dolfinx::la::petsc::Vector unknown(dolfinx::la::petsc::create_vector_wrap(*u->x()), false),
      right(dolfinx::la::petsc::create_vector_wrap(b), false);
  solver.solve(unknown.vec(), right.vec());
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  KSPGetConvergedReason(solver.ksp(), &reason);
  if (reason <= 0) throw std::runtime_error("the solver did not get there");
  u->x()->scatter_fwd();
  return u;
}

struct Answer {
  std::int64_t unknowns;
  double area, square, error; ///< of the domain; the integral of the square of u; the error of u, relative
  bool is_where_it_was;
};

/// The graph and the mesh count at the first rank.
Answer answer(MPI_Comm comm, const Mesher::Mesh& mesh_at_first_rank, const Mesher::Pslg& pslg) {
  const Part part = CGAL::distribute_mesh_2(comm, mesh_at_first_rank, pslg);
  const std::shared_ptr<Mesh> mesh = mesh_of(comm, part);
  const auto space = std::make_shared<const Space>(
      fem::create_functionspace(mesh,
                                basix::create_element(basix::element::family::P, basix::cell::type::triangle,
                                                      1, basix::element::lagrange_variant::equispaced, false),
                                1));
  const std::shared_ptr<Function> exact = exact_solution(space), u = solve(exact),
                                  error = std::make_shared<Function>(space);
  for (std::size_t i = 0; i < u->x()->array().size(); ++i)
    error->x()->mutable_array()[i] = u->x()->array()[i] - exact->x()->array()[i];
  return {space->dofmap()->index_map->size_global(), area_of(space), square_of(u),
          std::sqrt(square_of(error) / square_of(exact)), is_where_it_was(comm, *mesh, part)};
}

bool run(double max_area) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const Mesher::Pslg pslg = domain();
  Mesher::Mesh mesh;
  if (rank == 0) {
    mesh = Mesher(CGAL::Quality_mesh_options_2().max_area(max_area))(pslg);
    CGAL::renumber_by_place(mesh); // so that parts are compact
  }
  const Answer here = answer(MPI_COMM_WORLD, mesh, pslg);
  if (rank != 0) return true;
  const Answer of_one_rank = answer(MPI_COMM_SELF, mesh, pslg);
  const double area_error = here.area / area_of_domain - 1, difference = here.square / of_one_rank.square - 1;
  std::cout << "area " << here.area << ", relative error " << area_error << '\n'
            << here.unknowns << " unknowns; relative error " << here.error << '\n'
            << "triangles and ghosts " << (here.is_where_it_was ? "are" : "are not") << " where they were\n"
            << "relative difference from one rank: area " << here.area / of_one_rank.area - 1
            << ", integral of the square " << difference << '\n';
  return std::abs(area_error) < 1e-12 && here.error < 1e-3 && std::abs(difference) < 1e-10 &&
         here.unknowns == of_one_rank.unknowns && here.is_where_it_was;
}

int main(int argc, char** argv) {
  PetscInitialize(&argc, &argv, nullptr, nullptr);
  dolfinx::init_logging(argc, argv);
  bool is_right = false;
  try {
    is_right = run(argc > 1 && argv[1][0] != '-' ? std::strtod(argv[1], nullptr) : 0.002);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  PetscFinalize();
  return is_right ? 0 : 1;
}
