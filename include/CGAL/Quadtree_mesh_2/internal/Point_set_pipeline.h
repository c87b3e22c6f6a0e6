// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The stages of the mesher of point sets, one after the other (section 5 of the paper).
//
//   equal points merged
//   -> frame: a square parallel to the axes, or a row of squares along the diameter
//   -> clusters, if all angles have to be acute and nothing more
//   -> levels of squares, tiles, sites assigned to vertices (Tile_forest.h); if there are many tiles, what
//      follows is done in parts, which are then joined (Site_mesh_parts.h), and again on the whole
//   -> vertices moved to the points, relaxation, repair (Site_mesh.h); as long as some triangles remain outside the
//      range, smaller squares for the points next to them, and again
//   -> vertices removed that are not needed
//   -> every triangle checked; flat arrays in the user's coordinates and order

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_POINT_SET_PIPELINE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_POINT_SET_PIPELINE_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Phase_clock.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Progress.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/find_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/Distinct_points.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/points_in_box.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/output/site_mesh_to_indexed_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Corner_warper.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Separated_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Site_mesh_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_forest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class ConcurrencyTag>
class Point_set_pipeline {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  static_assert(
      is_kernel_geometry<Geometry>,
      "Point_set_mesher_2 knows no geometries but those of the package: traits have to name one of these");
  using Point_2 = typename Traits::Point_2;
  using Mesh = Indexed_mesh_2<Point_2>;

  Point_set_pipeline(const std::vector<Point_2>& points, const Point_set_mesh_options_2& options,
                     const Traits& traits, Point_set_mesh_report_2& report)
      : points_(points), options_(options), traits_(traits), report_(report) {}

  Mesh run() {
    report_.input_points = points_.size();
    traits_.construct_grid_2_object()(points_); // throws if one is no place
    if (options_.mode() == Mode::LEAST_ANGLE) return mesh_in_box();
    if (points_.empty()) return Mesh();
    const Coordinate_map<Traits, Geometry> map(points_);
    if (!map.is_in_range()) throw std::invalid_argument("the coordinates span more than 2^61");
    const Distinct_points<ConcurrencyTag, Geometry> distinct(points_, map);
    report_.merged_points = points_.size() - distinct.points().size();
    Mesh mesh =
        options_.mode() == Mode::WARPED_SQUARES ? warp_squares(distinct, map) : mesh_tiles(distinct, map);
    report_.is_cancelled = progress_.is_cancelled();
    return mesh;
  }

private:
  using Mode = Point_set_mesh_options_2::Mode;
  using Seconds = Point_set_mesh_report_2::Seconds;
  using Kernel_point = typename Geometry::Point;
  using Frame = Grid_frame<Geometry>;
  using Distinct = Distinct_points<ConcurrencyTag, Geometry>;
  using Map = Coordinate_map<Traits, Geometry>;
  using Forest = Tile_forest<ConcurrencyTag, Geometry>;
  using Parts = Site_mesh_parts<ConcurrencyTag, Geometry>;
  static constexpr double largest_acute_angle = 89.5;
  /// Of coarsening, if there are parts; the rest is at their rims.
  static constexpr double share_of_parts_ = 0.8;

  const std::vector<Point_2>& points_;
  const Point_set_mesh_options_2& options_;
  const Traits& traits_;
  Point_set_mesh_report_2& report_;
  Phase_clock<Point_set_mesh_report_2, ConcurrencyTag> clock_{report_};
  Progress progress_{options_.progress()};

  // --- Theorems 3 and 4 ---

  Mesh mesh_tiles(const Distinct& distinct, const Map& map) {
    const bool is_acute = options_.mode() == Mode::ACUTE;
    const double least = is_acute ? 0 : options_.least_angle_in_degrees(),
                 largest = is_acute ? largest_acute_angle : options_.largest_angle_in_degrees();
    const Angle_range range(least, largest);
    Forest forest = plant(distinct.points(), tile_options(least, largest));
    Site_mesh<Geometry> mesh = separate(forest, distinct, range);
    coarsen(mesh, range, {forest.number_of_runs() > 1 ? share_of_parts_ : 0, 1});
    clock_.enter(&Seconds::convert);
    report_.certified_points = forest.number_of_certified_points();
    return Site_mesh_converter<Traits, ConcurrencyTag>(mesh, points_, distinct, map, least, largest, is_acute,
                                                       report_)
        .run();
  }

  /// Wide ranges bear vertices that are neighbors; and with a few points in a leaf there are fewer to remove.
  static Tile_options tile_options(double least, double largest) {
    Tile_options result;
    const bool is_wide = largest > 88 && least < 31;
    result.max_points_per_leaf = is_wide ? 2 : 1;
    result.spacing = is_wide ? Spacing::DISTINCT : Spacing::NO_NEIGHBORS;
    result.sides_per_distance = is_wide ? 5 : 3;
    return result;
  }

  Forest plant(const std::vector<Kernel_point>& points, const Tile_options& options) {
    clock_.enter(&Seconds::quadtree);
    if (options_.mode() == Mode::BOUNDED_ANGLES) {
      const bool is_row = options_.mesh_domain() == Point_set_mesh_options_2::Domain::ROW;
      return Forest(points,
                    checked(is_row ? Frame::template along_diameter<ConcurrencyTag>(points)
                                   : Frame::template axis_parallel<ConcurrencyTag>(points)),
                    options);
    }
    const Frame frame = checked(Frame::template axis_parallel<ConcurrencyTag>(points));
    const Framed_clusters<Geometry> clusters = frame_clusters<ConcurrencyTag, Geometry>(
        points, find_clusters<ConcurrencyTag, Geometry>(points, options_.clusters()));
    report_.clusters = clusters.tree.clusters.size() - 1;
    return clusters.tree.clusters.size() > 1 ? Forest(points, frame, clusters, options)
                                             : Forest(points, frame, options);
  }

  /// \throws std::invalid_argument if words cannot hold the corners of the domain.
  static Frame checked(const Frame& frame) {
    if constexpr (std::is_integral<typename Geometry::Coordinate>::value) {
      const Grid_window& w = frame.window();
      const auto side = [&](std::uint64_t cells) { return cells << (Frame::depth - w.level); };
      for (const std::uint64_t x : {side(w.x0), side(w.x1)})
        for (const std::uint64_t y : {side(w.y0), side(w.y1)}) {
          const Kernel_point p = frame.to_point({x, y});
          constexpr std::int64_t end = std::int64_t(1) << Traits::depth;
          if (p.x < 0 || p.y < 0 || p.x > end || p.y > end)
            throw std::invalid_argument(
                "the domain around the points has a corner at (" + std::to_string(p.x) + ", " +
                std::to_string(p.y) + "), which is out of range: words are from 0 to " + std::to_string(end) +
                "; points in the middle half of that have room for a square around them, "
                "those in the middle eighteenth for a row of squares in any direction");
        }
    }
    return frame;
  }

  /// Fills tiles and moves vertices to the points until all triangles are in the range. Each round that fails
  /// gives smaller squares to a point that does not have the smallest ones yet. Once all points have these,
  /// only coordinates can fail.
  Site_mesh<Geometry> separate(Forest& forest, const Distinct& distinct, const Angle_range& range) {
    Parts parts;
    for (;;) {
      ++report_.rounds;
      find_leaves(forest, distinct);
      Site_mesh<Geometry> mesh;
      std::vector<std::size_t> to_blame;
      if (forest.number_of_runs() == 1)
        parts = Parts(), mesh = forest.mesh();
      else
        to_blame = make_parts(forest, parts, range);
      if (to_blame.empty()) {
        clock_.enter(&Seconds::separate);
        if (forest.number_of_runs() > 1) mesh = parts.joined(forest);
        const std::size_t in_parts = parts.number_of_triangles(), triangles = mesh.mesh.number_of_triangles();
        to_blame =
            Site_mesh_relaxer<ConcurrencyTag, Geometry>(mesh, range).place_sites([&forest](std::size_t p) {
              return !forest.is_certified(p);
            });
        report_.triangles_before_coarsening =
            mesh.mesh.number_of_triangles() + (in_parts > 0 ? in_parts - triangles : 0);
      }
      progress_.shall_go_on(Progress_shares::placing);
      if (to_blame.empty()) return mesh;
      for (const std::size_t p : to_blame) forest.refine_for(p);
    }
  }

  /// Makes the parts of a mesh whose tiles are too many to be in memory at a time. Returns the sites to blame.
  std::vector<std::size_t> make_parts(Forest& forest, Parts& parts, const Angle_range& range) {
    clock_.enter(&Seconds::separate);
    const std::vector<std::size_t> to_blame =
        parts.make(forest, range, [&](Site_mesh<Geometry>& mesh, std::size_t r) {
          const double share = share_of_parts_ / static_cast<double>(forest.number_of_runs());
          coarsen(mesh, range, {static_cast<double>(r) * share, static_cast<double>(r + 1) * share});
          clock_.enter(&Seconds::separate);
        });
    if (to_blame.empty()) forest.let_go_of_leaves();
    return to_blame;
  }

  /// \throws Point_error for points that are too near to each other.
  void find_leaves(Forest& forest, const Distinct& distinct) try {
    clock_.enter(&Seconds::quadtree);
    forest.find_leaves();
  } catch (const Tile_level_error& e) {
    throw too_near(distinct, e.site());
  }

  /// The error that names a point and the one that is nearest to it, by the larger of the distances in x and y, whose
  /// square might be no double.
  static Point_error too_near(const Distinct& distinct, std::size_t point) {
    const std::vector<Kernel_point>& points = distinct.points();
    const auto distance = [&](std::size_t i) {
      const auto d = Geometry::difference(points[i], points[point]);
      return std::max(std::abs(d.x), std::abs(d.y));
    };
    std::size_t nearest = point == 0 ? 1 : 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i != point && distance(i) < distance(nearest)) nearest = i;
    return Point_error(Point_error::Kind::TOO_NEAR, Point_index(distinct.input_point(point)),
                       Point_index(distinct.input_point(nearest)));
  }

  /// Does this work from `shares[0]` to `shares[1]` of all that there is, of which it tells and for which it has that
  /// much of the removals that the user grants.
  void coarsen(Site_mesh<Geometry>& mesh, const Angle_range& range, const std::array<double, 2>& shares) {
    clock_.enter(&Seconds::coarsen);
    Coarsening_effort effort;
    effort.most_rings = options_.effort();
    if (options_.max_removals() > 0)
      effort.tries_per_vertex = (shares[1] - shares[0]) * static_cast<double>(options_.max_removals()) /
                                static_cast<double>(mesh.mesh.number_of_vertices());
    Site_mesh_relaxer<ConcurrencyTag, Geometry>(mesh, range).coarsen(effort, [&](double share) {
      const double of_all = shares[0] + share * (shares[1] - shares[0]);
      return progress_.shall_go_on(Progress_shares::placing + Progress_shares::coarsening * of_all);
    });
  }

  // --- the other triangulations ---

  /// By the mesher of graphs; the library has it for the two tags of users.
  Mesh mesh_in_box() {
    if constexpr (!std::is_same_v<ConcurrencyTag, Chosen_tag>)
      return mesh_in_box_by<ConcurrencyTag>();
    else
      return Concurrency_scope::is_parallel() ? mesh_in_box_by<Parallel_tag>()
                                              : mesh_in_box_by<Sequential_tag>();
  }

  template <class Tag>
  Mesh mesh_in_box_by() {
    Quality_mesh_options_2 options;
    if (options_.progress()) options.progress(options_.progress());
    if (options_.effort() == 0) options.coarsen(Quality_mesh_options_2::Coarsening::NONE);
    if (options_.effort() == 3) options.smooth(1);
    const Pslg_2<Point_2> pslg = points_in_box(points_);
    Quality_mesher_2<Traits, Tag> mesher(options, traits_);
    Mesh mesh = mesh_of_points(mesher, pslg);
    const Quality_mesh_report_2& report = mesher.report();
    // the box is none of the user's
    mesh.number_of_input_vertices = points_.size();
    mesh.constrained_edges.clear();
    mesh.segment_of_vertex.assign(mesh.points.size(), Segment_index());
    report_.merged_points = report.merged_vertices;
    report_.vertices = report.vertices;
    report_.triangles = report_.triangles_before_coarsening = report.triangles;
    report_.is_cancelled = report.is_cancelled;
    for (const auto& t : report.unmet_triangles) report_.unmet_triangles.push_back({t.triangle, t.centroid});
    report_.seconds = seconds_of(report.seconds);
    report_.wall_seconds = seconds_of(report.wall_seconds);
    measure_angles(mesh, Map(pslg.vertices));
    return mesh;
  }

  /// \throws Point_error for an error of the graph that points are at fault for: their user knows of no graph.
  template <class Mesher>
  Mesh mesh_of_points(Mesher& mesher, const Pslg_2<Point_2>& pslg) const try {
    return mesher(pslg);
  } catch (const Pslg_error_2& error) {
    std::vector<Point_index> points;
    for (const auto v : error.parts().vertices)
      if (std::size_t(v) < points_.size()) points.push_back(Point_index(std::size_t(v)));
    if (error.kind() == Pslg_error_2::Kind::OUT_OF_RANGE && points.size() == 1)
      throw Point_error(Point_error::Kind::OUT_OF_RANGE, points[0], Point_index(),
                        "is too near to 0, or too far from it, for doubles beside the extent");
    if (error.kind() != Pslg_error_2::Kind::TOO_NEAR || points.size() < 2) throw;
    throw Point_error(
        Point_error::Kind::TOO_NEAR, points[0], points[1],
        "are nearer to each other, or to a line through a third point, than 2^-420 of the extent");
  }

  static Seconds seconds_of(const Quality_mesh_report_2::Seconds& phases) {
    return {phases.quadtree + phases.first_mesh, phases.refine, phases.coarsen, phases.convert};
  }

  Mesh warp_squares(const Distinct& distinct, const Map& map) {
    const Frame frame = checked(Frame::template axis_parallel<ConcurrencyTag>(distinct.points()));
    std::vector<Fixed_point_2<std::uint64_t>> places(distinct.points().size());
    for_each_index<ConcurrencyTag>(places.size(), [&](std::size_t i) {
      const auto g = frame.to_grid(distinct.points()[i]);
      places[i] = {g.x, g.y};
    });
    clock_.enter(&Seconds::quadtree);
    const Warped_mesh warped = warped_squares(places, distinct);
    clock_.enter(&Seconds::convert);
    std::vector<Kernel_point> vertices(warped.places.size());
    for_each_index<ConcurrencyTag>(
        vertices.size(), [&](std::size_t v) { vertices[v] = frame.to_point(warped.places.values()[v]); });
    std::vector<Ring_vertex> vertex_of_point(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      vertex_of_point[i] = static_cast<Ring_vertex>(warped.vertex_of_point[i].value());
    Point_mesh_builder<Traits, ConcurrencyTag> builder(points_, distinct, map, vertex_of_point);
    builder.number_vertices(vertices.size(), [](std::size_t) { return true; });
    Mesh mesh = builder.mesh_of(vertices, warped.triangles);
    report_.vertices = mesh.number_of_vertices() - report_.merged_points;
    report_.triangles = report_.triangles_before_coarsening = mesh.number_of_triangles();
    report_.rounds = 1;
    check_orientations(mesh, distinct, map);
    const std::vector<Kernel_point> points = measure_angles(mesh, map);
    const Range_check<Geometry> range(least_warped_angle, largest_warped_angle);
    for (const std::uint32_t t : range.template outside<ConcurrencyTag>(mesh.triangles, points)) {
      const auto p = [&](std::size_t k) { return points[mesh.triangles[t][k].value()]; };
      report_.unmet_triangles.push_back({Triangle_index(t), centroid_of(map, p(0), p(1), p(2))});
    }
    return mesh;
  }

  /// \throws Point_error for points that are too near to each other.
  static Warped_mesh warped_squares(const std::vector<Fixed_point_2<std::uint64_t>>& places,
                                    const Distinct& distinct) try {
    Warped_mesh warped = Corner_warper<ConcurrencyTag>::run(places);
    constexpr std::size_t none = std::size_t(-1);
    Indexed_vector<Vertex_index, std::size_t> point_at(warped.places.size(), none);
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::size_t& other = point_at[warped.vertex_of_point[i]];
      if (other != none)
        throw Point_error(Point_error::Kind::INDISTINGUISHABLE, Point_index(distinct.input_point(other)),
                          Point_index(distinct.input_point(i)));
      other = i;
    }
    return warped;
  } catch (const Separation_error& e) {
    throw too_near(distinct, std::size_t(e.point()));
  }

  /// Between points that differ in their last bits only, the grid has room for corners, but coordinates have not.
  /// \throws Point_error naming the points nearest to a triangle that rounding has made flat or turned around.
  void check_orientations(const Mesh& mesh, const Distinct& distinct, const Map& map) const {
    const auto point = [&](Vertex_index v) { return map.to_kernel(mesh.point(v)); };
    const std::vector<std::uint32_t> wrong = pack<ConcurrencyTag>(mesh.triangles.size(), [&](std::size_t t) {
      const auto& v = mesh.triangles[t];
      return Geometry::orientation(point(v[0]), point(v[1]), point(v[2])) <= 0;
    });
    if (wrong.empty()) return;
    const Kernel_point corner = point(mesh.triangles[wrong[0]][0]);
    const auto distance = [&](std::size_t i) {
      return squared_length(Geometry::difference(distinct.points()[i], corner));
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < distinct.points().size(); ++i)
      if (distance(i) < distance(nearest)) nearest = i;
    throw too_near(distinct, nearest);
  }

  /// \return the kernel's points of the mesh
  std::vector<Kernel_point> measure_angles(const Mesh& mesh, const Map& map) {
    std::vector<Kernel_point> points(mesh.points.size());
    for_each_index<ConcurrencyTag>(points.size(),
                                   [&](std::size_t v) { points[v] = map.to_kernel(mesh.points[v]); });
    Angle_extremes extremes;
    extremes.add_all<ConcurrencyTag, Geometry>(mesh.triangles, points);
    report_.least_angle = extremes.least_angle();
    report_.largest_angle = extremes.largest_angle();
    return points;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_POINT_SET_PIPELINE_H
