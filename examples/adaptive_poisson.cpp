// Adapts a mesh to a solution, in ten steps: solve, estimate the error, change the sizes, and again.
//
// -laplace u = f on the Great Lakes or on any .poly file, u = 0 on the shores, by linear elements with Eigen. The
// source is a spot in the widest water. The usual residual estimator (Verfuerth, 1996) tells how large the error of
// each triangle may be, in the energy norm. Sizes wanted at vertices follow from it: smaller where the error is above
// the average, larger where it is below. So each step refines in some places and coarsens in others. Vertices that stay
// have the value of the step before, from which the solver starts. Meshes with one bound of area everywhere are for
// comparison. `adaptive_poisson INPUT.poly OUT.svg` draws both as a plot.

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Mesh_sizing_field_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/refine_mesh_2.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Mesher = CGAL::Quality_mesher_2<>;
using Mesh = Mesher::Mesh;
using Point = Mesh::Point_2;
using Vector = Eigen::VectorXd;

/// A source that is strong in a spot.
struct Source {
  Point center;
  double radius;

  double operator()(const Point& p) const {
    return std::exp(-CGAL::squared_distance(p, center) / (radius * radius)) / (radius * radius);
  }
};

double area(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return CGAL::area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
}

double longest_edge(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  double longest2 = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest2 = std::max(longest2, CGAL::squared_distance(mesh.point(v[k]), mesh.point(v[(k + 1) % 3])));
  return std::sqrt(longest2);
}

Point centroid(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
}

/// In the middle of the largest triangle.
Source source_in_the_widest_water(const Mesh& mesh) {
  std::size_t largest = 0;
  for (std::size_t t = 1; t < mesh.triangles.size(); ++t)
    if (area(mesh, t) > area(mesh, largest)) largest = t;
  return {centroid(mesh, largest), longest_edge(mesh, largest) / 10};
}

/// The gradients of the three hat functions of a triangle.
std::array<Mesher::Geom_traits::Point_2, 3> gradients(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  std::array<Point, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto across = mesh.point(v[(k + 2) % 3]) - mesh.point(v[(k + 1) % 3]);
    result[k] = Point(-across.y() / (2 * area(mesh, t)), across.x() / (2 * area(mesh, t)));
  }
  return result;
}

struct Solution {
  std::vector<double> values; // at vertices
  long iterations = 0;
};

/// \param guess values at vertices to start from
Solution solve(const Mesh& mesh, const Source& source, const std::vector<double>& guess) {
  std::vector<int> unknown(mesh.number_of_vertices(), -1); // none for what is on the shore, or unused
  for (const auto& t : mesh.triangles)
    for (const auto v : t) unknown[std::size_t(v)] = 0;
  for (const auto& e : mesh.constrained_edges)
    for (const auto v : e.vertices) unknown[std::size_t(v)] = -1;
  int n = 0;
  for (int& u : unknown)
    if (u == 0) u = n++;

  std::vector<Eigen::Triplet<double>> entries;
  Vector load = Vector::Zero(n), start = Vector::Zero(n);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto gradient = gradients(mesh, t);
    for (std::size_t i = 0; i < 3; ++i) {
      const int row = unknown[std::size_t(mesh.triangles[t][i])];
      if (row < 0) continue;
      load[row] += area(mesh, t) / 3 * source(centroid(mesh, t));
      for (std::size_t j = 0; j < 3; ++j) {
        const int column = unknown[std::size_t(mesh.triangles[t][j])];
        const double product = gradient[i].x() * gradient[j].x() + gradient[i].y() * gradient[j].y();
        if (column >= 0) entries.emplace_back(row, column, area(mesh, t) * product);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  for (std::size_t v = 0; v < unknown.size(); ++v)
    if (unknown[v] >= 0) start[unknown[v]] = guess[v];
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(1e-8);
  const Vector u = solver.solveWithGuess(load, start);
  Solution result{std::vector<double>(unknown.size(), 0), solver.iterations()};
  for (std::size_t v = 0; v < unknown.size(); ++v)
    if (unknown[v] >= 0) result.values[v] = u[unknown[v]];
  return result;
}

/// Per triangle, how large its share of the error may be, squared: h^2 |f|^2, and half of what the flow across its
/// sides jumps.
std::vector<double> squared_errors(const Mesh& mesh, const Source& source, const std::vector<double>& u) {
  std::vector<std::array<double, 2>> flow(mesh.triangles.size());
  for (std::size_t t = 0; t < flow.size(); ++t) {
    const auto gradient = gradients(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = u[std::size_t(mesh.triangles[t][k])];
      flow[t][0] += value * gradient[k].x(), flow[t][1] += value * gradient[k].y();
    }
  }
  std::vector<double> errors(mesh.triangles.size());
  for (std::size_t t = 0; t < errors.size(); ++t) {
    const double h = longest_edge(mesh, t), f = source(centroid(mesh, t));
    errors[t] = h * h * f * f * area(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto across = mesh.neighbors[t][k];
      if (!across.is_valid()) continue;
      const auto side =
          mesh.point(mesh.triangles[t][(k + 2) % 3]) - mesh.point(mesh.triangles[t][(k + 1) % 3]);
      const auto& other = flow[std::size_t(across)];
      const double jump = (flow[t][0] - other[0]) * side.y() - (flow[t][1] - other[1]) * side.x();
      errors[t] += jump * jump / 2; // times the length of the side, divided by that of its normal, squared
    }
  }
  return errors;
}

double root_of_sum(const std::vector<double>& squares) {
  double sum = 0;
  for (const double s : squares) sum += s;
  return std::sqrt(sum);
}

/// Sizes at vertices with which triangles would have equal errors, a share of the present average. The error of a
/// triangle goes by the square of its size.
std::vector<double> sizes_wanted(const Mesh& mesh, const std::vector<double>& errors, double share) {
  const double wanted = share * root_of_sum(errors) / std::sqrt(double(errors.size()));
  std::vector<double> sizes(mesh.number_of_vertices(), 0), triangles(sizes.size(), 0);
  for (std::size_t t = 0; t < errors.size(); ++t) {
    const double factor = std::sqrt(wanted / std::max(std::sqrt(errors[t]), 1e-300));
    for (const auto v : mesh.triangles[t]) {
      sizes[std::size_t(v)] += longest_edge(mesh, t) * std::clamp(factor, 0.4, 2.0);
      triangles[std::size_t(v)] += 1;
    }
  }
  for (std::size_t v = 0; v < sizes.size(); ++v) sizes[v] /= std::max(1., triangles[v]);
  return sizes;
}

struct Figure {
  double triangles, error;
};
using Curve = std::vector<Figure>;

/// Both curves, with logarithmic axes.
void draw(std::ostream& out, const std::array<std::pair<std::string, Curve>, 2>& curves) {
  double low[2] = {1e300, 1e300}, high[2] = {0, 0};
  for (const auto& [name, curve] : curves)
    for (const Figure& f : curve) {
      low[0] = std::min(low[0], f.triangles), high[0] = std::max(high[0], f.triangles);
      low[1] = std::min(low[1], f.error), high[1] = std::max(high[1], f.error);
    }
  const auto x = [&](double v) { return 80 + 480 * std::log(v / low[0]) / std::log(high[0] / low[0]); };
  const auto y = [&](double v) { return 340 - 300 * std::log(v / low[1]) / std::log(high[1] / low[1]); };
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 620 400' font-family='sans-serif' "
         "font-size='13'>\n"
         "<rect width='620' height='400' fill='white'/>\n"
         "<path d='M80 40V340H560' fill='none' stroke='#888'/>\n"
         "<text x='320' y='385' text-anchor='middle'>triangles</text>\n"
         "<text x='20' y='190' text-anchor='middle' transform='rotate(-90 20 190)'>estimated error</text>\n";
  for (double tick : {1e3, 2e3, 5e3, 1e4, 2e4, 3e4, 5e4, 1e5, 2e5})
    if (tick >= low[0] && tick <= high[0])
      out << "<text x='" << x(tick) << "' y='358' text-anchor='middle'>" << tick << "</text>\n";
  for (int power = -6; power <= 2; ++power)
    for (const int digit : {1, 2, 5})
      if (const double tick = digit * std::pow(10, power); tick >= low[1] && tick <= high[1])
        out << "<text x='74' y='" << y(tick) + 4 << "' text-anchor='end'>" << tick << "</text>\n";
  const char* const colors[] = {"#1b6ca8", "#d1495b"};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& [name, curve] = curves[i];
    out << "<polyline fill='none' stroke-width='2' stroke='" << colors[i] << "' points='";
    for (const Figure& f : curve) out << x(f.triangles) << ',' << y(f.error) << ' ';
    out << "'/>\n";
    for (const Figure& f : curve)
      out << "<circle r='3.5' fill='" << colors[i] << "' cx='" << x(f.triangles) << "' cy='" << y(f.error)
          << "'/>\n";
    out << "<text fill='" << colors[i] << "' x='430' y='" << 60 + 20 * i << "'>" << name << "</text>\n";
  }
  out << "</svg>\n";
}

/// The error on a line between figures, logarithmically; the last one's beyond them.
double error_at(const Curve& curve, double triangles) {
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (triangles <= curve[i].triangles) {
      const Figure &a = curve[i - 1], &b = curve[i];
      const double t = std::log(triangles / a.triangles) / std::log(b.triangles / a.triangles);
      return a.error * std::pow(b.error / a.error, t);
    }
  return curve.back().error;
}

int main(int argc, char** argv) try {
  constexpr int steps = 10;
  Mesher::Pslg lakes;
  CGAL::IO::read_triangle_poly(argc > 1 ? argv[1] : QUADTREE_MESH_EXAMPLE_DATA_DIR "/great_lakes.poly.gz",
                               lakes);
  const Mesh coarse = Mesher()(lakes);
  const Source source = source_in_the_widest_water(coarse);
  double area_of_all = 0;
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t) area_of_all += area(coarse, t);
  const auto even_mesh = [&](double triangles) {
    return Mesher(CGAL::Quality_mesh_options_2().max_area(2 * area_of_all / triangles))(lakes);
  };
  Mesh mesh = even_mesh(1e4);

  std::cout << "step  triangles  kept  left out  new  iterations  estimated error\n";
  Curve adaptive, uniform;
  bool is_met = true;
  std::vector<double> guess(mesh.number_of_vertices(), 0);
  for (int step = 0;; ++step) {
    const Solution u = solve(mesh, source, guess);
    const std::vector<double> errors = squared_errors(mesh, source, u.values);
    adaptive.push_back({double(mesh.number_of_triangles()), root_of_sum(errors)});
    std::cout << std::setw(10) << u.iterations << std::setw(14) << adaptive.back().error << std::endl;
    if (step == steps) break;
    const CGAL::Mesh_sizing_field_2 sizes(mesh, sizes_wanted(mesh, errors, 1.6));
    const CGAL::Adapted_mesh_2 adapted =
        CGAL::adapt_mesh_2<CGAL::Parallel_tag>(mesh, lakes, CGAL::Quality_mesh_options_2().size(sizes));
    is_met = is_met && adapted.report.is_met();
    guess = adapted.transfer.carry_over(mesh, u.values);
    const auto& old = adapted.transfer.old_vertex;
    const auto kept = std::size_t(std::count_if(old.begin(), old.end(), [](auto v) { return v.is_valid(); }));
    std::cout << std::setw(4) << step + 1 << std::setw(11) << adapted.mesh.number_of_triangles()
              << std::setw(8) << kept << std::setw(8) << mesh.number_of_vertices() - kept << std::setw(8)
              << old.size() - kept;
    mesh = adapted.mesh;
  }

  std::cout << "one bound of area: triangles, estimated error\n";
  for (double triangles = 1e4; triangles < 1.2e5; triangles *= 1.8) {
    const Mesh even = even_mesh(triangles);
    const Solution u = solve(even, source, std::vector<double>(even.number_of_vertices(), 0));
    uniform.push_back(
        {double(even.number_of_triangles()), root_of_sum(squared_errors(even, source, u.values))});
    std::cout << std::setw(15) << uniform.back().triangles << std::setw(14) << uniform.back().error << '\n';
  }
  if (argc > 2) {
    std::ofstream out(argv[2]);
    draw(out, {{{"adapted in ten steps", adaptive}, {"one bound of area", uniform}}});
    if (!out.flush()) throw std::runtime_error(std::string("cannot write ") + argv[2]);
  }
  const bool is_better = adaptive.back().error < error_at(uniform, adaptive.back().triangles) / 2;
  return is_met && is_better ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
