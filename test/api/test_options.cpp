// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Options are set in chains by functions that return, without an argument, what was set.

#include "catch.h"

#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>
#include <CGAL/Quadtree_mesh_2/svg_options.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Tree_separation_options_2.h>

#include <cstddef>

namespace test_options {

TEST_CASE("Options of meshes of graphs are what was set", "[options]") {
  using Options = CGAL::Quality_mesh_options_2;
  CHECK(Options().min_angle() == 20.7);
  CHECK(Options().separate() == Options::Separation::ON_DEMAND);
  CHECK_FALSE(Options().size());
  CHECK_FALSE(Options().progress());
  const Options o = Options()
                        .min_angle(25)
                        .max_edge(1)
                        .max_area(2)
                        .min_edge(3)
                        .mesh_domain(Options::Domain::MARKED)
                        .coarsen(Options::Coarsening::NONE)
                        .smooth(4)
                        .thin(5)
                        .patience(6)
                        .patience_memory(7)
                        .max_vertices(8)
                        .max_steiner_vertices(0)
                        .conform(Options::Conforming::DELAUNAY)
                        .keep_borders(Options::Keep_borders::MARKED)
                        .size([](double x, double y) { return x + y; })
                        .refine_where([](const Options::Corners& c) { return c[0][0] > 0; })
                        .progress([](double share) { return share < 0.5; });
  CHECK(o.min_angle() == 25);
  CHECK(o.max_edge() == 1);
  CHECK(o.max_area() == 2);
  CHECK(o.min_edge() == 3);
  CHECK(o.mesh_domain() == Options::Domain::MARKED);
  CHECK(o.coarsen() == Options::Coarsening::NONE);
  CHECK(o.smooth() == 4);
  CHECK(o.thin() == 5);
  CHECK(o.patience() == 6);
  CHECK(o.patience_memory() == 7);
  CHECK(o.max_vertices() == 8);
  CHECK(o.max_steiner_vertices() == std::size_t(0));
  CHECK_FALSE(Options().max_steiner_vertices());
  CHECK(o.conform() == Options::Conforming::DELAUNAY);
  CHECK(Options().conform() == Options::Conforming::NONE);
  CHECK(o.keep_borders() == Options::Keep_borders::MARKED);
  CHECK(Options().keep_borders() == Options::Keep_borders::NONE);
  CHECK(o.size()(1, 2) == 3);
  CHECK(o.refine_where()({{{1, 0}, {0, 1}, {0, 0}}}));
  CHECK_FALSE(o.progress()(0.75));
}

TEST_CASE("Options of the construction by quadtrees choose it", "[options]") {
  using Options = CGAL::Quality_mesh_options_2;
  using Tree_options = CGAL::Tree_separation_options_2;
  const Options o = Options().separate(
      Tree_options().distances(1, 2).vertex_window(4).strip_width(5).max_vertices_per_leaf(3).place(
          Tree_options::Placement::BY_RULE));
  CHECK(o.separate() == Options::Separation::THEOREM_5);
  CHECK(o.trees().vertex_distance() == 1);
  CHECK(o.trees().edge_distance() == 2);
  CHECK(o.trees().vertex_window() == 4);
  CHECK(o.trees().strip_width() == 5);
  CHECK(o.trees().max_vertices_per_leaf() == 3);
  CHECK(o.trees().place() == Tree_options::Placement::BY_RULE);
  CHECK(o.trees().subdivide() == Tree_options::Subdivision::WALKING);
  CHECK(Tree_options::of_paper().edge_distance() == 3);
  CHECK(Tree_options::of_theorem().max_vertices_per_leaf() == 1);
  CHECK(Tree_options::of_theorem().find_distances_by() == Tree_options::Distances::AXIS_RAYS);
  CHECK(Tree_options().find_distances_by() == Tree_options::Distances::TRIANGULATION);
}

TEST_CASE("Options of meshes of points are what was set", "[options]") {
  using Options = CGAL::Point_set_mesh_options_2;
  using Mode = Options::Mode;
  CHECK(Options().mode() == Mode::BOUNDED_ANGLES);
  CHECK(Options().least_angle().mode() == Mode::LEAST_ANGLE);
  CHECK(Options().acute().mode() == Mode::ACUTE);
  CHECK(Options().warped_squares().mode() == Mode::WARPED_SQUARES);
  const Options o = Options()
                        .acute()
                        .bounded_angles(30, 85)
                        .mesh_domain(Options::Domain::SQUARE)
                        .effort(3)
                        .max_removals(7)
                        .clusters(4096);
  CHECK(o.mode() == Mode::BOUNDED_ANGLES);
  CHECK(o.least_angle_in_degrees() == 30);
  CHECK(o.largest_angle_in_degrees() == 85);
  CHECK(o.mesh_domain() == Options::Domain::SQUARE);
  CHECK(o.effort() == 3);
  CHECK(o.max_removals() == 7);
  CHECK(o.clusters() == 4096);
}

TEST_CASE("Options of checks and pictures are what was set", "[options]") {
  using Check = CGAL::Mesh_quality_options_2;
  const Check check =
      Check().min_angle(1).max_edge(2).max_area(3).coordinate_unit(4).max_errors(5).check_domain(
          Check::Domain::ANY);
  CHECK(check.min_angle() == 1);
  CHECK(check.max_edge() == 2);
  CHECK(check.max_area() == 3);
  CHECK(check.coordinate_unit() == 4);
  CHECK(check.max_errors() == 5);
  CHECK(check.check_domain() == Check::Domain::ANY);
  CHECK(check.check_arrays() == Check::Arrays::ALL);

  using Picture = CGAL::IO::Svg_options_2;
  const Picture picture =
      Picture().width(80).margin(1).fill_by(Picture::Fill::REGION).edge_color("red").clip_to({0, 1, 2, 3});
  CHECK(picture.width() == 80);
  CHECK(picture.margin() == 1);
  CHECK(picture.fill_by() == Picture::Fill::REGION);
  CHECK(picture.edge_color() == "red");
  CHECK(picture.clip_to()->ymax() == 3);
  CHECK_FALSE(Picture().clip_to());
}

} // namespace test_options
