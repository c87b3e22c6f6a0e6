// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_MESH_2_PEER_H
#define QUADTREE_MESH_2_BENCHMARK_MESH_2_PEER_H

#include "measurement.h"
#include "mesh_figures.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Pslg_2.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// CGAL's Mesh_2, used as its manual says: points and segments inserted as ranges, hole points as seeds,
/// `Delaunay_mesher_2` with the size criteria. Mesh_2 bounds angles by B = sin^2(angle), edges by their
/// length, and has no bound of areas.
template <class Point>
class Mesh_2_peer {
public:
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using Tds = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                   CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds>;

  /// Inserts points and segments.
  explicit Mesh_2_peer(const CGAL::Pslg_2<Point>& pslg) {
    std::vector<std::pair<std::size_t, std::size_t>> segments;
    segments.reserve(pslg.number_of_segments());
    for (const auto& [a, b] : pslg.segments) segments.emplace_back(std::size_t(a), std::size_t(b));
    const Stopwatch watch;
    cdt_.insert_constraints(pslg.vertices.begin(), pslg.vertices.end(), segments.begin(), segments.end());
    insertion_ = watch.seconds();
  }

  /// Refines the domain that the points of `holes` leave; 0 for no bound on edges.
  void refine(const std::vector<Point>& holes, double min_angle_in_degrees, double max_edge_length) {
    using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
    const double sine = std::sin(min_angle_in_degrees * CGAL_PI / 180);
    const Stopwatch watch;
    CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt_, Criteria(sine * sine, max_edge_length));
    mesher.set_seeds(holes.begin(), holes.end());
    mesher.refine_mesh();
    refinement_ = watch.seconds();
  }

  const Cdt& cdt() const { return cdt_; }
  Seconds insertion() const { return insertion_; }
  Seconds refinement() const { return refinement_; }

private:
  Cdt cdt_;
  Seconds insertion_, refinement_;
};

/// Meshes a graph with Mesh_2.
template <class Point>
Mesh_figures mesh_by_Mesh_2(const CGAL::Pslg_2<Point>& pslg, double min_angle_in_degrees,
                            double max_edge_length) {
  Mesh_2_peer<Point> peer(pslg);
  peer.refine(pslg.holes, min_angle_in_degrees, max_edge_length);
  Mesh_figures figures;
  figures.seconds = peer.insertion();
  figures.seconds += peer.refinement();
  figures.vertices = peer.cdt().number_of_vertices();
  Mesh_figures_builder builder(figures, min_angle_in_degrees);
  for (auto f = peer.cdt().finite_faces_begin(); f != peer.cdt().finite_faces_end(); ++f)
    if (f->is_in_domain())
      builder.add_triangle(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
  return figures;
}

#endif // QUADTREE_MESH_2_BENCHMARK_MESH_2_PEER_H
