// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Triangulations over kernels other than the usual one, and over projections.

#include "refined_triangulation.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Projection_traits_xz_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/refine_quality_mesh_2.h>

#include <vector>

namespace test_refine_quality_mesh_kernels {

using namespace test_meshes;

namespace {

template <class Traits>
using Cdt_over = CGAL::Constrained_Delaunay_triangulation_2<
    Traits,
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Traits>,
                                         CGAL::Delaunay_mesh_face_base_2<Traits>>,
    CGAL::Exact_predicates_tag>;

template <class Triangulation>
void refine_nested(double size) {
  Pslg pslg = nested();
  pslg.holes.push_back(Point(2, 0.1));
  Triangulation cdt;
  const auto handles = insert_graph(cdt, pslg);
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
  const std::vector<typename Triangulation::Point> seeds{typename Triangulation::Point(2, 0.1)};
  CHECK(CGAL::refine_quality_mesh_2(cdt, seeds.begin(), seeds.end(), Criteria(0.125, size)).is_met());
  CHECK(number_of_bad(cdt, Criteria(0.125, size)) == 0);
  for (std::size_t v = 0; v < handles.size(); ++v) CHECK(handles[v]->point().x() == pslg.vertices[v].x());
  require_mesh(cdt, pslg, 20.7048);
}

/// A hill over a square, seen along the traits' direction: coordinates are (u, v) of the plane and a height.
template <class Triangulation, class Place>
void refine_hill(Triangulation cdt, Place place) {
  const auto height = [](double u, double v) { return u == 0 && v == 0 ? 3.0 : 0.5 * u; };
  std::vector<typename Triangulation::Vertex_handle> ring;
  for (const Point& p : square(0, 0, 2))
    ring.push_back(cdt.insert(place(p.x(), p.y(), height(p.x(), p.y()))));
  cdt.insert(place(0, 0, 3));
  for (std::size_t i = 0; i < 4; ++i) cdt.insert_constraint(ring[i], ring[(i + 1) % 4]);
  const Triangulation surface = cdt;
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
  const Criteria criteria(0.125, 0.3, cdt.geom_traits());
  const auto report = CGAL::refine_quality_mesh_2(cdt, criteria);
  CHECK(cdt.is_valid());
  CHECK(number_of_bad(cdt, criteria) == report.unmet_triangles.size());
  CHECK(report.unmet_triangles.size() < 20); // none, if the traits measured in the plane only
  CHECK(cdt.number_of_vertices() > 200);
  CHECK(ring[0]->face()->has_vertex(ring[0]));
  for (auto v : cdt.finite_vertex_handles()) { // it lies in a triangle of the hill
    double least = 1e9;
    for (auto f : surface.finite_face_handles())
      least = std::min(least, CGAL::squared_distance(v->point(), Kernel::Triangle_3(f->vertex(0)->point(),
                                                                                    f->vertex(1)->point(),
                                                                                    f->vertex(2)->point())));
    CHECK(least < 1e-24);
  }
}

} // namespace

TEST_CASE("triangulations over exact numbers are meshed in place", "[refine_quality_mesh_2]") {
  refine_nested<Cdt_over<CGAL::Exact_predicates_exact_constructions_kernel>>(0.8);
}

TEST_CASE("triangulations over kernels of doubles are meshed in place", "[refine_quality_mesh_2]") {
  SECTION("filtered") { refine_nested<Cdt_over<CGAL::Filtered_kernel<CGAL::Simple_cartesian<double>>>>(0.5); }
  SECTION("not filtered") { refine_nested<Cdt_over<CGAL::Cartesian<double>>>(0.5); }
}

TEST_CASE("surfaces are meshed in a projection", "[refine_quality_mesh_2]") {
  using Point_3 = Kernel::Point_3;
  SECTION("along an axis") {
    refine_hill(Cdt_over<CGAL::Projection_traits_xz_3<Kernel>>(),
                [](double u, double v, double h) { return Point_3(u, h, v); });
  }
  SECTION("along a given direction") {
    using Traits = CGAL::Projection_traits_3<Kernel>;
    refine_hill(Cdt_over<Traits>(Traits(Kernel::Vector_3(0, -1, 0))),
                [](double u, double v, double h) { return Point_3(u, -h, v); });
  }
}

} // namespace test_refine_quality_mesh_kernels
