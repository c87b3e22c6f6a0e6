// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUALITY_MESH_OPTIONS_2_H
#define CGAL_QUALITY_MESH_OPTIONS_2_H

#include <CGAL/Tree_separation_options_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Options of `Quality_mesher_2`. Each option is set by the function of its name, which returns the options,
/// so that calls can be chained. Without an argument the function returns the value:
/// `Quality_mesh_options_2().min_angle(25).max_area(0.1)`.
class Quality_mesh_options_2 {
public:
  /// Which components of the plane are meshed; segments separate components. Each component is judged by
  /// itself. The unbounded one is never meshed, nor is one with a point of `Pslg_2::holes`.
  enum class Domain {
    /// All bounded components, as by Triangle, and by `refine_Delaunay_mesh_2()` with seeds in holes.
    ENCLOSED,
    /// The components with a point of `Pslg_2::regions`, as by Mesh_2 with seeds in the domain.
    MARKED,
    /// The components that a path from infinity reaches only by crossing an odd number of segments or more,
    /// as by `mark_domain_in_triangulation()`: borders in borders are holes, islands in holes are not.
    NESTING_PARITY
  };
  /// How the features of the input are separated.
  enum class Separation {
    ON_DEMAND, ///< by constrained Delaunay refinement, a vertex at a time: fewer triangles in less time
    THEOREM_5  ///< by the quadtrees of Bern, Eppstein and Teng: `Tree_separation_options_2`
  };
  /// Whether superfluous Steiner vertices are removed at the end.
  enum class Coarsening {
    NONE,           ///< all vertices stay
    GUARDED_REMOVAL ///< a vertex is removed if all triangles around it then meet the bounds
  };

  /// Whether edges on segments are Delaunay, too.
  enum class Conforming {
    NONE,    ///< not more than the bounds ask for: the mesh is constrained Delaunay
    DELAUNAY ///< they are split until they are
  };

  /// Which segments get no vertices.
  enum class Keep_borders {
    NONE,     ///< none: all may be split
    BOUNDARY, ///< those with the domain on one side only, as with Triangle's `-Y`
    MARKED,   ///< those whose marker (`Pslg_2::segment_markers`) is not 0
    ALL       ///< all, as with Triangle's `-YY`
  };

  /// The corners of a triangle, (x, y) each, counterclockwise.
  using Corners = std::array<std::array<double, 2>, 3>;
  using Size_field = std::function<double(double, double)>; ///< of the place (x, y)
  using Predicate = std::function<bool(const Corners&)>;    ///< of a triangle
  using Callback = std::function<bool(double)>;             ///< of the share of work done

  /// The greatest bound on the least angle that is tried, in degrees.
  static constexpr double greatest_min_angle = 34;
  /// Least angle in degrees of every triangle, in [0, 34], unless an acute input corner forces a smaller one;
  /// 20.7 by default. The soak (doc/soak.md) counts how often bounds up to 20.7 are met, and
  /// doc/guarantees.md those above, which are tried. The report lists what is left.
  Quality_mesh_options_2& min_angle(double value) { return min_angle_ = value, *this; }
  double min_angle() const { return min_angle_; } ///< the value set

  /// Longest edge, in the units of the input; 0, the default, means no bound.
  Quality_mesh_options_2& max_edge(double value) { return max_edge_ = value, *this; }
  double max_edge() const { return max_edge_; } ///< the value set

  /// Largest area of a triangle, in squared units of the input; 0, the default, means no bound.
  Quality_mesh_options_2& max_area(double value) { return max_area_ = value, *this; }
  double max_area() const { return max_area_; } ///< the value set

  /// The longest edge wanted of a triangle with its centroid at (x, y), in the units of the input; positive.
  /// An empty function, the default, means no such bound. With `Parallel_tag` several threads call it at
  /// once.
  Quality_mesh_options_2& size(Size_field value) { return size_ = std::move(value), *this; }
  const Size_field& size() const { return size_; } ///< the value set

  /// Whether to refine a triangle that meets all other bounds, for wishes that no bound of size can express.
  /// An empty function, the default, means none. With `Parallel_tag` several threads call it at once, for
  /// triangles that come and go. It must give the same answer whenever it is asked. If no triangle ever
  /// satisfies it, refinement stops at the vertex budget. Without a budget it stops at
  /// `patience()` times the expected vertices and twenty million more, in place of two million.
  Quality_mesh_options_2& refine_where(Predicate value) { return refine_where_ = std::move(value), *this; }
  const Predicate& refine_where() const { return refine_where_; } ///< the value set

  /// Refinement inserts no vertex nearer than this to another one in sight, in the units of the input.
  /// Triangles that miss a bound for this reason are left, and reported with the reason LEAST_EDGE. 0, the
  /// default, means no such rule.
  Quality_mesh_options_2& min_edge(double value) { return min_edge_ = value, *this; }
  double min_edge() const { return min_edge_; } ///< the value set

  /// The greatest value of `gradation()`. Without a bound most meshes of maps grow no faster.
  static constexpr double steepest_gradation = 1;
  /// The least value of `max_edge_ratio()` other than 0. In a triangle of 20.7 degrees edges may differ by a factor of
  /// 2.83, and from there on refinement ends by Ruppert's argument.
  static constexpr double least_max_edge_ratio = 3;

  /// How fast edges grow, in [0, 1]: each edge is at most as long as `max_edge_ratio()` times any other one, plus
  /// `gradation()` times the distance between their nearest ends. 0.1 to 0.3 is usual for flow. 0, the default, means
  /// no such bound, or 1 if there is a `max_edge_ratio()`.
  ///
  /// This is a bound on the mesh, whatever makes edges short: the input, bounds of regions, or a size field. Vertices
  /// for it are made at the end, on one thread. The report lists triangles that miss it, with the reason. It does not
  /// hold near corners of the input that are sharper than `min_angle()`, where any mesh has long edges at short ones:
  /// for triangles with a vertex within (2 + 2 / gradation) times the length of the legs of exempt triangles there,
  /// counted from the corner.
  Quality_mesh_options_2& gradation(double value) { return gradation_ = value, *this; }
  double gradation() const { return gradation_; } ///< the value set

  /// By which factor edges that share an end may differ, at least 3; see `gradation()`. 0, the default, means no such
  /// bound, or 3 if there is a `gradation()`.
  Quality_mesh_options_2& max_edge_ratio(double value) { return max_edge_ratio_ = value, *this; }
  double max_edge_ratio() const { return max_edge_ratio_; } ///< the value set

  /// The least value of `max_angle()` other than 0, in degrees.
  static constexpr double least_max_angle = 105;
  /// The greatest angle wanted, in degrees, at least 105 and below 180; 0, the default, means no such bound. With
  /// `min_angle()` alone no angle exceeds 180 degrees less twice that, 138.6, but in acute corners.
  ///
  /// This bound is tried, and all others go before it. At the end, triangles that miss it get another place for a
  /// vertex or one more vertex, in a limited number of rounds, on one thread. The report lists those left with the
  /// reason GREATEST_ANGLE. Removal and relocation of vertices make no angle above the bound. Triangles in corners of
  /// the input sharper than `min_angle()` are exempt; of those, angles above 150 degrees are tried to be avoided.
  Quality_mesh_options_2& max_angle(double value) { return max_angle_ = value, *this; }
  double max_angle() const { return max_angle_; } ///< the value set

  /// What is meshed; ENCLOSED by default.
  Quality_mesh_options_2& mesh_domain(Domain value) { return mesh_domain_ = value, *this; }
  Domain mesh_domain() const { return mesh_domain_; } ///< the value set

  /// Whether edges on segments are Delaunay, too; NONE by default. With DELAUNAY no vertex in sight is within the
  /// diametral circle of such an edge. So all triangles are Delaunay: no vertex in sight is within their circumcircles.
  /// And all circumcenters are in the domain, as finite volumes want it (`dual_of_mesh_2()`). Edges are split at the
  /// end, on one thread. Maps get up to a third more triangles, and graphs of acute corners more. What could not be
  /// split is counted (`Quality_mesh_report_2::encroached_edges`).
  Quality_mesh_options_2& conform(Conforming value) { return conform_ = value, *this; }
  Conforming conform() const { return conform_; } ///< the value set

  /// Which segments get no vertices, so that the edges on them are those of the input; NONE by default. So meshes of
  /// neighboring domains fit, and a mesh fits one that exists. Input vertices on a segment still divide it.
  ///
  /// What is away from these segments meets all bounds as before. Where a segment is in the way of the vertex that
  /// would cure a triangle, the triangle is left, and reported with the reason KEPT_SEGMENT and the segment. That is so
  /// next to segments that are longer than a bound of size, or much longer than what is near to them. The construction
  /// by quadtrees cannot keep borders: it neither takes over nor may be chosen.
  Quality_mesh_options_2& keep_borders(Keep_borders value) { return keep_borders_ = value, *this; }
  Keep_borders keep_borders() const { return keep_borders_; } ///< the value set

  /// How features are kept apart; ON_DEMAND by default.
  Quality_mesh_options_2& separate(Separation value) { return separate_ = value, *this; }
  Separation separate() const { return separate_; } ///< the value set

  /// Chooses the construction by quadtrees, with these options.
  Quality_mesh_options_2& separate(const Tree_separation_options_2& options) {
    trees_ = options;
    return separate(Separation::THEOREM_5);
  }
  /// Options of the construction by quadtrees.
  const Tree_separation_options_2& trees() const { return trees_; }

  /// Whether superfluous Steiner vertices are removed at the end; GUARDED_REMOVAL by default.
  Quality_mesh_options_2& coarsen(Coarsening value) { return coarsen_ = value, *this; }
  Coarsening coarsen() const { return coarsen_; } ///< the value set

  /// Rounds of smoothing, each followed by removal if that is chosen; 0 by default. A round gives a percent
  /// or two fewer triangles and better angles, for about the time of refinement.
  Quality_mesh_options_2& smooth(int value) { return smooth_ = value, *this; }
  int smooth() const { return smooth_; } ///< the value set

  /// Rounds of thinning; 0 by default. A round removes vertices even if angles then miss the bound, and
  /// refines these again. On maps the first round gives 3 to 4 percent fewer triangles and the second one
  /// percent, each for about the time of refinement. Meshes of up to 1000 triangles are refined a second time,
  /// thinned and smoothed in any case, unless `coarsen()` is `NONE`.
  Quality_mesh_options_2& thin(int value) { return thin_ = value, *this; }
  int thin() const { return thin_; } ///< the value set

  /// When the construction by quadtrees takes over because refinement on demand does not come to rest: when
  /// the mesh has this many times the expected vertices, and two million more; 100 by default. Below 1 it is as
  /// small a share of the two million. Graphs of fewer than 1000 vertices have a limit of their own
  /// (`max_vertices()`). Quadtrees make only the components of the domain that do not come to rest.
  /// `Quality_mesh_report_2::trees` then says so. 0: use quadtrees immediately.
  ///
  /// Quadtrees cannot take over for bounds above 20.7048 degrees (sin^2 = 1/8), with a least edge, or with
  /// `refine_where()`. The option is then ignored: refinement stops at 100 times the expected vertices, and
  /// what is left is reported. A vertex budget replaces all this.
  Quality_mesh_options_2& patience(double value) { return patience_ = value, *this; }
  double patience() const { return patience_; } ///< the value set

  /// Patience also ends when the mesh takes this many bytes, 2e9 by default, by an estimate of 256 bytes per
  /// vertex (more over exact numbers). But it does not end below 10 times the expected vertices and two
  /// million more.
  Quality_mesh_options_2& patience_memory(double value) { return patience_memory_ = value, *this; }
  double patience_memory() const { return patience_memory_; } ///< the value set

  /// Refinement stops when the mesh has this many vertices, and what is left is reported. 0, the default,
  /// means no bound but that of memory; for graphs of fewer than 1000 vertices it means two million triangles
  /// (half of that over exact numbers) besides four times what bounds of size ask for, unless there is
  /// `refine_where()`. A graph that needs more is refused; so it is if the mesh is expected to have a tenth of
  /// that and is not done then, because quadtrees would need more.
  Quality_mesh_options_2& max_vertices(std::size_t value) { return max_vertices_ = value, *this; }
  std::size_t max_vertices() const { return max_vertices_; } ///< the value set

  /// Refinement stops when the mesh has so many vertices that are not of the input, and what is left is reported, as
  /// with Triangle's `-S`. It may be 0. Unlike `max_vertices()` it refuses no graph. By default there is no such bound.
  Quality_mesh_options_2& max_steiner_vertices(std::size_t value) {
    return max_steiner_vertices_ = value, *this;
  }
  /// The value set; nothing by default.
  std::optional<std::size_t> max_steiner_vertices() const { return max_steiner_vertices_; }

  /// A folder in which the state of a large mesh is kept while it is refined, so that the work can go on after an
  /// interruption. Empty, the default: none is kept.
  ///
  /// If there is a state of the same input and options in the folder, the work goes on from there and gives the same
  /// bits. The folder is made if need be. The state, one file of some 50 bytes for each triangle, stays until the
  /// user removes it. The time of what is interrupted is lost back to the last round of blocks, or to the first
  /// triangulation. Small meshes, of less than 50 000 triangles before they are refined, and those by quadtrees begin
  /// anew.
  /// The mesher throws `std::system_error` if the file cannot be written, `std::runtime_error` if it cannot be
  /// read or belongs to another mesh, and `std::invalid_argument` over exact numbers.
  /// \param key stands for the functions `size()` and `refine_where()`, which cannot be compared: a state with another
  ///        key belongs to another mesh. Choose another one for other functions.
  Quality_mesh_options_2& checkpoints(std::string folder, std::uint64_t key = 0) {
    checkpoints_ = std::move(folder), checkpoint_key_ = key;
    return *this;
  }
  const std::string& checkpoints() const { return checkpoints_; } ///< the folder set
  /// The key set with it.
  std::uint64_t checkpoint_key() const { return checkpoint_key_; }

  /// Called now and then with the share of work done, in [0, 1]. Returning false stops with the mesh so far.
  /// With `Parallel_tag` any thread may call it, one at a time. An empty function, the default, is not
  /// called.
  Quality_mesh_options_2& progress(Callback value) { return progress_ = std::move(value), *this; }
  const Callback& progress() const { return progress_; } ///< the value set

private:
  double min_angle_ = 20.7;
  double max_edge_ = 0;
  double max_area_ = 0;
  Size_field size_;
  Predicate refine_where_;
  double min_edge_ = 0;
  double gradation_ = 0;
  double max_edge_ratio_ = 0;
  double max_angle_ = 0;
  Domain mesh_domain_ = Domain::ENCLOSED;
  Separation separate_ = Separation::ON_DEMAND;
  Coarsening coarsen_ = Coarsening::GUARDED_REMOVAL;
  int smooth_ = 0;
  int thin_ = 0;
  double patience_ = 100;
  double patience_memory_ = 2e9;
  std::size_t max_vertices_ = 0;
  std::optional<std::size_t> max_steiner_vertices_;
  Conforming conform_ = Conforming::NONE;
  Keep_borders keep_borders_ = Keep_borders::NONE;
  Callback progress_;
  std::string checkpoints_;
  std::uint64_t checkpoint_key_ = 0;
  Tree_separation_options_2 trees_;
};

} // namespace CGAL

#endif // CGAL_QUALITY_MESH_OPTIONS_2_H
