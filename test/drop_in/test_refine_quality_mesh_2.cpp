// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "refined_triangulation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Delaunay_mesh_criteria_2.h>
#include <CGAL/Delaunay_mesh_local_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/IO/write_VTU.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Constrained_Delaunay_triangulation_2.h>
#include <CGAL/lloyd_optimize_mesh_2.h>
#include <CGAL/refine_quality_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <list>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_refine_quality_mesh_2 {

using namespace test_meshes;
using Options = CGAL::Quality_mesh_options_2;
using Reason = CGAL::Quality_mesh_report_2::Reason;
using Size_criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
using Check_domain = CGAL::Mesh_quality_options_2::Domain;

namespace {

/// With what `lloyd_optimize_mesh_2()` wants of vertices and faces.
using Lloyd_tds = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                       CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Lloyd_cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Lloyd_tds, CGAL::Exact_predicates_tag>;

Pslg with_holes(Pslg pslg, const std::vector<Point>& holes) {
  pslg.holes = holes;
  return pslg;
}

double longest_edge(const Cdt& cdt) {
  double longest = 0;
  for (Cdt::Face_handle f : cdt.finite_face_handles())
    for (int k = 0; k < 3 && f->is_in_domain(); ++k)
      longest = std::max(longest, std::sqrt(cdt.segment(f, k).squared_length()));
  return longest;
}

/// Only says whether a face is bad: if its longest edge is longer than a linear function of the place.
struct Graded_size {
  using Quality = double;
  struct Is_bad {
    CGAL::Mesh_2::Face_badness operator()(Quality q) const {
      return q > 1 ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const Cdt::Face_handle& f, Quality& q) const {
      const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
      const double longest = std::max(
          {CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
      q = std::sqrt(longest) / (0.2 + 0.1 * (4 + CGAL::centroid(a, b, c).x()));
      return (*this)(q);
    }
  };
  Is_bad is_bad_object() const { return {}; }
};

/// Wants angles of at least 27 degrees and says nothing of it beforehand.
struct Silent_angle {
  using Quality = double;
  using Is_bad = CGAL::Delaunay_mesh_criteria_2<Cdt>::Is_bad;
  CGAL::Delaunay_mesh_criteria_2<Cdt> criteria{std::pow(std::sin(27 * CGAL_PI / 180), 2)};
  Is_bad is_bad_object() const { return criteria.is_bad_object(); }
};

/// No triangle is good enough.
struct Never_content {
  using Quality = int;
  struct Is_bad {
    CGAL::Mesh_2::Face_badness operator()(Quality) const { return CGAL::Mesh_2::IMPERATIVELY_BAD; }
    CGAL::Mesh_2::Face_badness operator()(const Cdt::Face_handle&, Quality& q) const {
      return (*this)(q = 0);
    }
  };
  Is_bad is_bad_object() const { return {}; }
};

} // namespace

TEST_CASE("the domain without seeds, with holes, with seeds in it", "[refine_quality_mesh_2]") {
  const Pslg pslg = nested();
  const std::list<Point> inner{Point(0.1, 0.2)}, ring{Point(2, 0.1)};
  Cdt cdt;
  insert_graph(cdt, pslg);
  SECTION("all that is enclosed") {
    SECTION("by default") { CHECK(CGAL::refine_quality_mesh_2(cdt).is_met()); }
    SECTION("by criteria") { CHECK(CGAL::refine_quality_mesh_2(cdt, Size_criteria()).is_met()); }
    SECTION("by criteria of a given type") {
      CHECK(CGAL::refine_quality_mesh_2<Cdt, CGAL::Delaunay_mesh_criteria_2<Cdt>>(cdt).is_met());
    }
    require_mesh(cdt, pslg, 20.7048);
    CHECK(number_of_bad(cdt, CGAL::Delaunay_mesh_criteria_2<Cdt>()) == 0);
  }
  SECTION("seeds in holes") {
    SECTION("a range and options") { CGAL::refine_quality_mesh_2(cdt, inner, Options().min_angle(25)); }
    SECTION("two iterators and criteria") {
      CGAL::refine_quality_mesh_2(cdt, inner.begin(), inner.end(), Size_criteria(0.18, 0.7));
      CHECK(longest_edge(cdt) <= 0.7);
    }
    require_mesh(cdt, with_holes(pslg, {inner.front()}), 25);
    CHECK(area_in_domain(cdt) == Approx(60));
  }
  SECTION("seeds in the domain") {
    CGAL::refine_quality_mesh_2(cdt, ring.begin(), ring.end(), Size_criteria(), true);
    require_mesh(cdt, with_holes(pslg, {inner.front(), Point(3, 3)}), 20.7048);
    CHECK(area_in_domain(cdt) == Approx(14));
  }
  SECTION("a rule of the options") {
    CGAL::refine_quality_mesh_2(cdt, Options().mesh_domain(Options::Domain::NESTING_PARITY));
    require_mesh(cdt, pslg, 20.7, Check_domain::NESTING_PARITY);
    CHECK(area_in_domain(cdt) == Approx(64 - 14));
  }
  SECTION("no component has a seed") {
    const Point far(9, 9);
    CHECK(CGAL::refine_quality_mesh_2(cdt, &far, &far + 1, Size_criteria(), true).triangles == 0);
    CHECK(cdt.number_of_vertices() == 15);
    CHECK(cdt.is_valid());
  }
}

#if CGAL_QUADTREE_MESH_2_HAS_MESH_2_PARAMETERS
TEST_CASE("named parameters", "[refine_quality_mesh_2]") {
  namespace parameters = CGAL::parameters;
  const std::vector<Point> seeds{Point(2, 0.1)};
  Cdt cdt;
  insert_graph(cdt, nested());
  CGAL::refine_quality_mesh_2(cdt, parameters::seeds(seeds).criteria(Size_criteria(0.125, 0.5)));
  CHECK(area_in_domain(cdt) == Approx(50));
  CHECK(longest_edge(cdt) <= 0.5);
  CGAL::refine_quality_mesh_2(cdt, parameters::seeds_are_in_domain(true).seeds(seeds));
  CHECK(area_in_domain(cdt) == Approx(14));
  CGAL::refine_quality_mesh_2(cdt,
                              parameters::criteria(Size_criteria(0.125, 0.25)).domain_is_initialized(true));
  CHECK(area_in_domain(cdt) == Approx(14));
  CHECK(longest_edge(cdt) <= 0.25);
  CGAL::refine_quality_mesh_2(cdt, parameters::default_values());
  CHECK(area_in_domain(cdt) == Approx(64));
}
#endif

TEST_CASE("the domain is what faces say", "[refine_quality_mesh_2]") {
  const Pslg pslg = nested();
  Cdt cdt;
  insert_graph(cdt, pslg);
  const auto mark_where = [&](auto is_in_domain) {
    for (Cdt::Face_handle f : cdt.all_face_handles())
      f->set_in_domain(!cdt.is_infinite(f) && is_in_domain(f));
  };
  SECTION("whole components") {
    mark_where([&](Cdt::Face_handle f) {
      const Point p = CGAL::centroid(cdt.triangle(f));
      return std::abs(p.x()) + std::abs(p.y()) > 3 || std::max(std::abs(p.x()), std::abs(p.y())) < 1;
    });
    CGAL::refine_quality_mesh_2(cdt, Size_criteria(), true);
    CHECK(area_in_domain(cdt) == Approx(64 - 14));
    require_mesh(cdt, with_holes(pslg, {Point(2, 0.1)}), 20.7);
  }
  SECTION("faces of a component: the edges between become constrained") {
    mark_where([&](Cdt::Face_handle f) { return CGAL::centroid(cdt.triangle(f)).x() > 0; });
    const double area = area_in_domain(cdt);
    CHECK(CGAL::refine_quality_mesh_2(cdt, Size_criteria(0.125, 0.5), true).is_met());
    CHECK(cdt.is_valid());
    CHECK(area_in_domain(cdt) == Approx(area));
  }
  SECTION("all faces, though without constraints: connected to infinity") {
    Cdt open;
    for (const Point& p : pslg.vertices) open.insert(p);
    for (Cdt::Face_handle f : open.finite_face_handles()) f->set_in_domain(true);
    CHECK(CGAL::refine_quality_mesh_2(open, Size_criteria(), true).triangles == 0);
    CHECK(area_in_domain(open) == 0);
    CHECK(open.number_of_vertices() == pslg.vertices.size());
  }
}

TEST_CASE("vertices stay, with their handles and what is in them", "[refine_quality_mesh_2]") {
  const Pslg pslg = nested();
  Info_cdt cdt;
  const auto handles = insert_graph(cdt, pslg);
  for (std::size_t v = 0; v < handles.size(); ++v) handles[v]->info() = Vertex_index(1000 + v);
  for (const double size : {0.0, 0.4, 0.2}) {
    CGAL::refine_quality_mesh_2(cdt, CGAL::Delaunay_mesh_size_criteria_2<Info_cdt>(0.125, size));
    std::size_t with_info = 0;
    for (Info_cdt::Vertex_handle v : cdt.finite_vertex_handles()) with_info += v->info().is_valid() ? 1 : 0;
    CHECK(with_info == handles.size());
    for (std::size_t v = 0; v < handles.size(); ++v) {
      CHECK(handles[v]->point() == pslg.vertices[v]);
      CHECK(handles[v]->info() == Vertex_index(1000 + v));
      CHECK(handles[v]->face()->has_vertex(handles[v]));
    }
    require_mesh(cdt, pslg, 20.7048);
  }
}

TEST_CASE("a hierarchy of constraints knows the pieces", "[refine_quality_mesh_2]") {
  using Cdt_plus = CGAL::Constrained_triangulation_plus_2<Cdt>;
  Cdt_plus cdt;
  // two that overlap, one that crosses them, a closed polygon around
  const std::vector<Point> ring{Point(-3, -2), Point(3, -2), Point(3, 2), Point(-3, 2)};
  std::vector<Cdt_plus::Constraint_id> ids{cdt.insert_constraint(Point(-2, 0), Point(1, 0)),
                                           cdt.insert_constraint(Point(-1, 0), Point(2, 0)),
                                           cdt.insert_constraint(Point(0.25, -1), Point(0.25, 1))};
  for (std::size_t i = 0; i < 4; ++i) ids.push_back(cdt.insert_constraint(ring[i], ring[(i + 1) % 4]));
  const std::size_t before = cdt.number_of_vertices();
  for (const double size : {0.5, 0.2}) {
    CGAL::refine_quality_mesh_2(cdt, CGAL::Delaunay_mesh_size_criteria_2<Cdt_plus>(0.125, size));
    CHECK(cdt.is_valid());
    CHECK(cdt.number_of_vertices() > before + 20);
    CHECK(std::size_t(cdt.number_of_constraints()) == ids.size());
    std::size_t constrained = 0;
    for (auto e : cdt.finite_edges()) constrained += cdt.is_constrained(e) ? 1 : 0;
    CHECK(std::size_t(cdt.number_of_subconstraints()) == constrained);
    for (const auto& id : ids) {
      std::vector<Cdt_plus::Vertex_handle> chain(cdt.vertices_in_constraint_begin(id),
                                                 cdt.vertices_in_constraint_end(id));
      double length = 0;
      for (std::size_t i = 1; i < chain.size(); ++i) {
        length += std::sqrt(CGAL::squared_distance(chain[i - 1]->point(), chain[i]->point()));
        Cdt_plus::Face_handle f;
        int side = 0;
        REQUIRE(cdt.is_edge(chain[i - 1], chain[i], f, side));
        CHECK(f->is_constrained(side));
      }
      CHECK(length ==
            Approx(std::sqrt(CGAL::squared_distance(chain.front()->point(), chain.back()->point()))));
    }
  }
  cdt.remove_constraint(ids[0]); // and lets them go again
  CHECK(std::size_t(cdt.number_of_constraints()) == ids.size() - 1);
  CHECK(cdt.is_valid());
}

TEST_CASE("criteria are asked", "[refine_quality_mesh_2]") {
  const Pslg pslg = nested();
  Cdt cdt;
  insert_graph(cdt, pslg);
  SECTION("sizes by place") {
    const auto report = CGAL::refine_quality_mesh_2(cdt, Graded_size());
    CHECK(report.is_met());
    CHECK(number_of_bad(cdt, Graded_size()) == 0);
    CHECK(report.triangles < 4000); // 0.2 to 1 in a square of 8
    require_mesh(cdt, pslg, 20.7);
  }
  SECTION("a size near a segment") {
    using Criteria = CGAL::Delaunay_mesh_local_size_criteria_2<Cdt>;
    const Criteria criteria(0.125, 0.1, true, Kernel::Segment_2(Point(-2, -2), Point(-1.5, -2)));
    CHECK(CGAL::quality_mesh_options_2(criteria).max_edge() == 0);
    const auto report = CGAL::refine_quality_mesh_2(cdt, criteria);
    CHECK(report.is_met());
    CHECK(number_of_bad(cdt, criteria) == 0);
    CHECK(report.triangles < 2000);
    require_mesh(cdt, pslg, 20.7);
  }
  SECTION("angles") {
    CHECK(CGAL::refine_quality_mesh_2(cdt, Silent_angle()).is_met());
    CHECK(number_of_bad(cdt, Silent_angle()) == 0);
    require_mesh(cdt, pslg, 27);
  }
  SECTION("more than there is") {
    const auto report = CGAL::refine_quality_mesh_2(cdt, Never_content());
    CHECK(report.unmet_triangles.size() == report.triangles);
    CHECK(report.unmet_triangles.front().reason == Reason::CRITERIA);
    require_mesh(cdt, pslg, 20.7);
  }
  SECTION("angles above 34 degrees") {
    const CGAL::Delaunay_mesh_criteria_2<Cdt> criteria(0.4);
    const auto report = CGAL::refine_quality_mesh_2(cdt, criteria);
    CHECK(report.unmet_triangles.size() == number_of_bad(cdt, criteria));
    require_mesh(cdt, pslg, 34);
  }
}

TEST_CASE("what is bad at an acute corner is reported", "[refine_quality_mesh_2]") {
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(9, 0), Point(9, 1)});
  Cdt cdt;
  insert_graph(cdt, pslg);
  const auto report = CGAL::refine_quality_mesh_2(cdt, Size_criteria());
  CHECK(report.unmet_triangles.empty());
  CHECK(number_of_bad(cdt, Size_criteria()) == report.exempt_triangles.size());
  std::size_t i = 0;
  for (Cdt::Face_handle f : cdt.finite_face_handles()) { // the i-th face in the domain is triangle i
    if (i == report.triangles) break;
    CHECK(f->is_in_domain());
    ++i;
  }
  require_mesh(cdt, pslg, 20.7);
}

TEST_CASE("nothing to mesh", "[refine_quality_mesh_2]") {
  Cdt cdt;
  CHECK(CGAL::refine_quality_mesh_2(cdt).triangles == 0);
  cdt.insert(Point(1, 2));
  CHECK(CGAL::refine_quality_mesh_2(cdt, Size_criteria()).triangles == 0);
  cdt.insert_constraint(Point(1, 2), Point(2, 3));
  CHECK(CGAL::refine_quality_mesh_2(cdt, Size_criteria()).triangles == 0);
  cdt.insert(Point(1, 3));
  CHECK(CGAL::refine_quality_mesh_2(cdt, Size_criteria()).triangles == 0);
  CHECK(cdt.number_of_vertices() == 3);
  CHECK(cdt.is_valid());
}

TEST_CASE("what works on meshes of Mesh_2 works on these", "[refine_quality_mesh_2]") {
  const Pslg pslg = with_holes(nested(), {Point(0, 0)});
  Lloyd_cdt cdt;
  insert_graph(cdt, pslg);
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Lloyd_cdt>;
  CGAL::refine_quality_mesh_2(cdt, pslg.holes.begin(), pslg.holes.end(), Criteria(0.125, 0.6));
  const auto vertices = cdt.number_of_vertices();
  SECTION("Lloyd's optimization") {
    CGAL::lloyd_optimize_mesh_2(cdt); // without seeds it takes all that is enclosed for the domain
    CHECK(cdt.number_of_vertices() == vertices);
    CHECK(cdt.is_valid());
    CHECK(area_in_domain(cdt) == Approx(64));
  }
  SECTION("refine_Delaunay_mesh_2()") {
    CGAL::Delaunay_mesher_2<Lloyd_cdt, Criteria> mesher(cdt, Criteria(0.125, 0.3));
    mesher.set_seeds(pslg.holes.begin(), pslg.holes.end());
    mesher.refine_mesh();
    CHECK(cdt.number_of_vertices() > vertices);
    CHECK(number_of_bad(cdt, Criteria(0.125, 0.3)) == 0);
    CHECK(cdt.is_valid());
  }
  SECTION("write_VTU()") {
    std::ostringstream out;
    CGAL::IO::write_VTU(out, cdt, CGAL::IO::ASCII);
    CHECK(out.str().find("NumberOfPoints=\"" + std::to_string(vertices) + "\"") != std::string::npos);
  }
  SECTION("as a graph") {
    std::size_t edges = 0, halfedges = 0;
    for (auto f : CGAL::faces(cdt))
      for (auto h : CGAL::halfedges_around_face(halfedge(f, cdt), cdt))
        halfedges += h != Lloyd_cdt::Edge() ? 1 : 0;
    for (auto e : CGAL::edges(cdt)) edges += source(e, cdt) != target(e, cdt) ? 1 : 0;
    CHECK(halfedges == 3 * cdt.number_of_faces());
    CHECK(edges == cdt.number_of_vertices() + cdt.number_of_faces() - 1); // Euler
  }
}

} // namespace test_refine_quality_mesh_2
