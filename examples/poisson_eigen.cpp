// Solves -laplace u + u / L^2 = f by linear finite elements with Eigen, on the Great Lakes or on any .poly file. The
// sun brings heat and the surface loses it, with L = 100 km and no flow through shores. Meshes with different bounds
// show what the least angle is for. Small angles make the largest eigenvalue of the matrix large, and with it the
// condition. The time of iterative solvers and the precision of all solvers depend on the condition. (Small
// triangles raise it, too, and a bound of 30 degrees takes more of these.)

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>

#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <vector>

using Mesher = CGAL::Quality_mesher_2<>;
using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

struct Equations {
  Matrix matrix;
  Vector load;
  double least_angle = 180;
};

/// One unknown for each vertex of a triangle; the mass of a triangle is lumped at its corners.
Equations equations(const Mesher::Mesh& mesh) {
  std::vector<int> unknown(mesh.number_of_vertices(), -1);
  int n = 0;
  for (const auto& t : mesh.triangles)
    for (const auto v : t)
      if (unknown[std::size_t(v)] < 0) unknown[std::size_t(v)] = n++;

  Equations result;
  result.load = Vector::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& t : mesh.triangles) {
    const double area = CGAL::area(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const auto a = mesh.point(t[i]) - mesh.point(t[k]), b = mesh.point(t[j]) - mesh.point(t[k]);
      const double half_cotangent = a * b / (4 * area); // of the angle at k, for the edge across it
      result.least_angle = std::min(result.least_angle, std::atan2(2 * area, a * b) * 180 / CGAL_PI);
      const int here = unknown[std::size_t(t[k])], row = unknown[std::size_t(t[i])],
                column = unknown[std::size_t(t[j])];
      entries.emplace_back(here, here, area / 3 / 1e10);
      result.load[here] += area / 3 * (1 + std::sin(mesh.point(t[k]).y() / 1e5)) / 1e10;
      entries.emplace_back(row, row, half_cotangent), entries.emplace_back(column, column, half_cotangent);
      entries.emplace_back(row, column, -half_cotangent), entries.emplace_back(column, row, -half_cotangent);
    }
  }
  result.matrix.resize(n, n);
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// The largest eigenvalue of a symmetric operator, by power iteration.
template <class Operator>
double largest_eigenvalue(Eigen::Index n, Operator apply) {
  Vector x = Vector::LinSpaced(n, 1, 1000).array().sin();
  double eigenvalue = 0;
  for (int i = 0; i < 100; ++i) {
    const Vector y = apply(x.normalized());
    eigenvalue = y.norm();
    x = y;
  }
  return eigenvalue;
}

int main(int argc, char** argv) try {
  Mesher::Pslg lakes;
  CGAL::IO::read_triangle_poly(argc > 1 ? argv[1] : QUADTREE_MESH_EXAMPLE_DATA_DIR "/great_lakes.poly.gz",
                               lakes);

  std::cout << "bound  least angle  triangles  unknowns  largest eigenvalue  condition   rms of u\n";
  bool is_solved = true;
  for (const double bound : {0.0, 5.0, 10.0, 20.7, 30.0}) {
    Mesher mesher(CGAL::Quality_mesh_options_2().min_angle(bound).max_area(5e7)); // 50 km^2
    const Mesher::Mesh mesh = mesher(lakes);
    const Equations e = equations(mesh);
    const Eigen::SimplicialLDLT<Matrix> solver(e.matrix);
    const Vector u = solver.solve(e.load);
    is_solved =
        is_solved && solver.info() == Eigen::Success && (e.matrix * u - e.load).norm() < 1e-9 * e.load.norm();
    const double largest = largest_eigenvalue(u.size(), [&](const Vector& x) { return e.matrix * x; });
    const double of_inverse = largest_eigenvalue(u.size(), [&](const Vector& x) { return solver.solve(x); });
    std::cout << std::setw(5) << bound << std::setw(13) << e.least_angle << std::setw(11)
              << mesh.number_of_triangles() << std::setw(10) << u.size() << std::setw(20) << largest
              << std::setw(11) << largest * of_inverse << std::setw(11)
              << std::sqrt(u.squaredNorm() / double(u.size())) << '\n';
  }
  return is_solved ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
