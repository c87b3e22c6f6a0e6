// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes a given mesh again: refines it, or makes it as coarse as it may be, too.
//
// The mesher gets all vertices of the mesh that are kept as input (Kept_vertices_graph.h). So they stay as they are,
// and it only inserts others where a triangle misses a bound. Only what sharp corners place is made anew
// (Sharp_corner_finder.h), mostly at the same places (Recurring_vertices.h).
//
// To coarsen, vertices are left out that a mesh made afresh, from the input alone and within the same bounds, would not
// have: those at which even the longest edge is shorter than a share of the longest edge that the fresh mesh has there.
// The mesher fills in what is missing, with its guarantees. Where it needs about as many vertices again, because of
// what is around, those left out are put back. So where sizes and input stay the same, the mesh does.
//
// Expected O(n log n + k) time, as for a mesh made afresh, of which there are up to three.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_MESH_ADAPTER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_MESH_ADAPTER_H

#include <CGAL/Adapted_mesh_2.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Kept_vertices_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Recurring_vertices.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Sharp_corner_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Sufficient_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_area_bounds.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/edge_key.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/same_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag>
class Mesh_adapter {
public:
  using Point = Triangle_tree::Point;
  using Mesh = Indexed_mesh_2<Point>;
  using Pslg = Pslg_2<Point>;
  using Options = Quality_mesh_options_2;

  /// \throws Pslg_error_2 naming what is at fault if the mesh is none, or none of this graph
  Mesh_adapter(const Mesh& mesh, const Pslg& pslg, const Options& options)
      : mesh_(mesh), pslg_(pslg), options_(options), given_(mesh, pslg.first_number) {
    given_.refuse_touches();
    options_.mesh_domain(Options::Domain::MARKED);
    read_input_vertices();
    read_constrained_edges();
    is_made_anew_.resize(mesh.points.size(), 0);
    if (options.keep_borders() == Options::Keep_borders::NONE)
      is_made_anew_ = Sharp_corner_finder<Point>(mesh, pslg, options.min_angle()).vertices();
    for (std::size_t v = 0; v < is_made_anew_.size(); ++v)
      if (!is_free(v)) is_made_anew_[v] = 0;
  }

  /// Keeps all vertices, but for those that sharp corners place. A mesh that needs nothing stays as it is.
  Adapted_mesh_2 refine() {
    const auto is_constrained = [this](Vertex_index a, Vertex_index b) { return this->is_constrained(a, b); };
    Adapted_mesh_2 result;
    if (Sufficient_mesh(given_, pslg_, options_, is_constrained).is_one(result.report)) {
      keep_mesh(result);
      return result;
    }
    find_components();
    return convert(Kept_vertices_graph(mesh_, pslg_, components_, all_kept()));
  }

  /// The same with bounds of area by triangle, in addition to those of the options.
  Adapted_mesh_2 refine(const std::vector<double>& areas) {
    const Triangle_area_bounds is_large(given_.tree(), areas, mesh_.triangles.size(), pslg_.first_number);
    is_large.check_size([this](std::size_t t) { return double_area(given_.corners(t)); }, options_);
    const Options::Predicate users = options_.refine_where();
    options_.refine_where(
        [&is_large, users](const Options::Corners& t) { return is_large(t) || (users && users(t)); });
    return refine();
  }

  /// Leaves out vertices that are not needed.
  Adapted_mesh_2 adapt() {
    number_of_runs_ = 3;
    options_.checkpoints(""); // a state is of one mesh only
    find_components();
    std::vector<char> keeps = vertices_to_keep();
    Adapted_mesh_2 result = convert(Kept_vertices_graph(mesh_, pslg_, components_, keeps));
    const bool is_whole = !result.report.is_cancelled && !result.report.is_budget_exhausted;
    if (is_whole && put_back(result.transfer, keeps))
      result = convert(Kept_vertices_graph(mesh_, pslg_, components_, keeps));
    return result;
  }

private:
  using Mesher = Quality_mesher_2<Filtered_quadtree_traits_2<>, ConcurrencyTag>;
  using Kind = Pslg_error_2::Kind;
  /// Vertices stay where an edge has this share of the longest edge in a mesh made afresh. With a greater share a mesh
  /// is a few percent smaller, but more of it is made anew.
  static constexpr double share_kept = 0.6;
  /// Vertices are put back where more than this share of them is made again.
  static constexpr double share_made_again = 0.75;
  /// How many new vertices are tried where the mesher would refuse edges without room between them.
  static constexpr std::size_t fewest_tried = 100000, tried_per_vertex = 10;

  const Mesh& mesh_;
  const Pslg& pslg_;
  Options options_;
  Given_mesh given_;
  std::vector<char> is_input_;                    // per vertex
  std::vector<std::uint32_t> edges_at_;           // per vertex, how many constrained edges
  std::unordered_set<std::uint64_t> constrained_; // edges, by their keys
  std::vector<char> is_made_anew_;                // per vertex: a sharp corner places it
  std::vector<Given_mesh::Component> components_;
  int number_of_runs_ = 1, run_ = 0; // of the mesher

  std::string number(std::size_t i) const { return std::to_string(pslg_.first_number + i); }
  bool is_constrained(Vertex_index a, Vertex_index b) const { return constrained_.count(edge_key(a, b)) > 0; }
  /// \throws Pslg_error_2
  static void check_length(std::size_t length, std::size_t wanted, const char* name) {
    if (length != wanted)
      throw Pslg_error_2(Kind::ARRAY_LENGTH, std::string("the mesh has ") + std::to_string(length) + ' ' +
                                                 name + " instead of " + std::to_string(wanted));
  }

  void read_input_vertices() {
    const std::size_t n = mesh_.points.size(), inputs = pslg_.vertices.size();
    if (!mesh_.input_index.empty()) check_length(mesh_.input_index.size(), n, "indices in the input");
    if (!mesh_.vertex_markers.empty()) check_length(mesh_.vertex_markers.size(), n, "markers of vertices");
    check_length(mesh_.number_of_input_vertices, inputs, "input vertices");
    is_input_.resize(n, 0);
    std::size_t found = 0;
    for (std::size_t v = 0; v < n; ++v) {
      const Vertex_index i = !mesh_.input_index.empty() ? mesh_.input_index[v]
                             : v < inputs               ? Vertex_index(v)
                                                        : Vertex_index();
      if (!i.is_valid()) continue;
      if (std::size_t(i) >= inputs || pslg_.point(i) != mesh_.points[v])
        throw Pslg_error_2(Kind::INVALID_MESH,
                           "vertex " + number(v) + " of the mesh is not vertex " + number(std::size_t(i)) +
                               " of the graph",
                           Pslg_parts_2().vertex(Vertex_index(v)));
      is_input_[v] = 1, ++found;
    }
    check_length(found, inputs, "input vertices");
  }

  void read_constrained_edges() {
    edges_at_.resize(mesh_.points.size(), 0);
    for (const auto& e : mesh_.constrained_edges) {
      if (std::size_t(e.segment) >= pslg_.segments.size())
        throw Pslg_error_2(Kind::INVALID_MESH, "a constrained edge of the mesh is of segment " +
                                                   number(std::size_t(e.segment)) + ", which does not exist");
      for (const Vertex_index v : e.vertices)
        if (std::size_t(v) < edges_at_.size()) ++edges_at_[std::size_t(v)];
      constrained_.insert(edge_key(e.vertices[0], e.vertices[1]));
    }
    if (!mesh_.region_of_triangle.empty())
      check_length(mesh_.region_of_triangle.size(), mesh_.triangles.size(), "regions of triangles");
    check_constrained_edges();
  }

  /// All of them are edges, and all edges of the border are among them.
  void check_constrained_edges() const {
    std::size_t found = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex_index a = mesh_.triangles[t][(k + 1) % 3], b = mesh_.triangles[t][(k + 2) % 3];
        const Triangle_index n = given_.neighbors()[t][k];
        const bool is_one = is_constrained(a, b);
        if (!n.is_valid() && !is_one)
          throw Pslg_error_2(Kind::INVALID_MESH,
                             "the edge from vertex " + number(std::size_t(a)) + " to vertex " +
                                 number(std::size_t(b)) + " is on the border of the mesh, but on no segment",
                             Pslg_parts_2().vertex(a).vertex(b));
        if (is_one && (!n.is_valid() || t < std::size_t(n))) ++found;
      }
    if (found != constrained_.size())
      throw Pslg_error_2(Kind::INVALID_MESH, std::to_string(constrained_.size() - found) +
                                                 " constrained edges of the mesh are not edges of triangles");
  }

  void find_components() {
    std::vector<int> component_of;
    components_ = given_.components([this](Vertex_index a, Vertex_index b) { return is_constrained(a, b); },
                                    component_of);
  }

  /// Whether a vertex may be left out: none of the input, and inside of a component or a segment.
  bool is_free(std::size_t v) const {
    if (is_input_[v] != 0) return false;
    const bool is_on_segment = !mesh_.segment_of_vertex.empty() && mesh_.segment_of_vertex[v].is_valid();
    return edges_at_[v] == (is_on_segment ? 2u : 0u);
  }

  std::vector<char> vertices_to_keep() {
    const std::size_t n = mesh_.points.size();
    std::vector<char> fixed(n), keeps = all_kept();
    for (std::size_t v = 0; v < n; ++v) fixed[v] = is_free(v) ? 0 : 1;
    if (std::find(fixed.begin(), fixed.end(), 0) == fixed.end()) return keeps;
    Mesher mesher(options_of_run());
    const Mesh fresh = mesher(Kept_vertices_graph(mesh_, pslg_, components_, fixed).graph());
    // A part of a mesh tells nothing about lengths.
    if (mesher.report().is_cancelled || mesher.report().is_budget_exhausted) return keeps;
    const std::vector<double> longest = longest_edges_at_vertices();
    const Triangle_tree tree(fresh.points, fresh.triangles);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t v) {
      if (fixed[v] != 0 || is_made_anew_[v] != 0) return;
      const auto& t = fresh.triangles[std::size_t(tree.nearest(mesh_.points[v]).triangle)];
      keeps[v] =
          longest[v] >= share_kept * longest_edge({fresh.point(t[0]), fresh.point(t[1]), fresh.point(t[2])});
    });
    return keeps;
  }

  std::vector<char> all_kept() const {
    std::vector<char> keeps(mesh_.points.size());
    for (std::size_t v = 0; v < keeps.size(); ++v) keeps[v] = is_made_anew_[v] == 0 ? 1 : 0;
    return keeps;
  }

  static double longest_edge(const Triangle_tree::Corners& t) {
    const auto length = [&](std::size_t i, std::size_t j) {
      return std::hypot(t[i].x() - t[j].x(), t[i].y() - t[j].y());
    };
    return std::max({length(0, 1), length(1, 2), length(2, 0)});
  }

  std::vector<double> longest_edges_at_vertices() const {
    std::vector<double> longest(mesh_.points.size(), 0);
    for (const auto& t : mesh_.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &a = mesh_.point(t[k]), &b = mesh_.point(t[(k + 1) % 3]);
        const double length = std::hypot(a.x() - b.x(), a.y() - b.y());
        for (const Vertex_index v : {t[k], t[(k + 1) % 3]})
          longest[std::size_t(v)] = std::max(longest[std::size_t(v)], length);
      }
    return longest;
  }

  /// Puts vertices back into clusters where about as many are made again.
  /// \returns whether there are any
  bool put_back(const Mesh_transfer_2& transfer, std::vector<char>& keeps) const {
    const std::vector<int> cluster_of = clusters(keeps);
    struct Count {
      std::size_t left_out = 0, made = 0;
      bool is_futile() const { return double(made) > share_made_again * double(left_out); }
    };
    std::vector<Count> counts(mesh_.points.size());
    for (const int c : cluster_of)
      if (c >= 0) ++counts[std::size_t(c)].left_out;
    for (std::size_t v = 0; v < transfer.places.size(); ++v) {
      if (transfer.old_vertex[v].is_valid()) continue;
      const int c = cluster_near(cluster_of, std::size_t(transfer.places[v].triangle));
      if (c >= 0) ++counts[std::size_t(c)].made;
    }
    bool is_any = false;
    for (std::size_t v = 0; v < keeps.size(); ++v)
      if (cluster_of[v] >= 0 && counts[std::size_t(cluster_of[v])].is_futile()) keeps[v] = 1, is_any = true;
    return is_any;
  }

  /// The cluster with a corner of a triangle, or of one next to it; -1 for none.
  int cluster_near(const std::vector<int>& cluster_of, std::size_t t) const {
    std::array<std::size_t, 4> near{t, t, t, t};
    for (std::size_t k = 0; k < 3; ++k)
      if (const Triangle_index n = given_.neighbors()[t][k]; n.is_valid()) near[k + 1] = std::size_t(n);
    for (const std::size_t n : near)
      for (const Vertex_index v : mesh_.triangles[n])
        if (cluster_of[std::size_t(v)] >= 0) return cluster_of[std::size_t(v)];
    return -1;
  }

  /// Per vertex left out, the number of its cluster: of those that edges connect; -1 for those that stay, and for those
  /// that sharp corners place.
  std::vector<int> clusters(const std::vector<char>& keeps) const {
    std::vector<int> cluster_of(keeps.size(), -1);
    for (std::size_t v = 0; v < keeps.size(); ++v)
      if (keeps[v] == 0 && is_made_anew_[v] == 0) cluster_of[v] = static_cast<int>(v);
    const auto root = [&](int v) {
      while (cluster_of[std::size_t(v)] != v) {
        cluster_of[std::size_t(v)] = cluster_of[std::size_t(cluster_of[std::size_t(v)])];
        v = cluster_of[std::size_t(v)];
      }
      return v;
    };
    for (const auto& t : mesh_.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto a = std::size_t(t[k]), b = std::size_t(t[(k + 1) % 3]);
        if (cluster_of[a] < 0 || cluster_of[b] < 0) continue;
        const auto [least, other] = std::minmax({root(int(a)), root(int(b))});
        cluster_of[std::size_t(other)] = least;
      }
    for (std::size_t v = 0; v < keeps.size(); ++v)
      if (cluster_of[v] >= 0) cluster_of[v] = root(int(v));
    return cluster_of;
  }

  /// Of the next run of the mesher, whose callback gets its share of the whole work.
  Options options_of_run() {
    Options options = options_;
    const double begin = run_++, runs = number_of_runs_;
    if (options_.progress())
      options.progress(
          [users = options_.progress(), begin, runs](double share) { return users((begin + share) / runs); });
    return options;
  }

  /// \param[in,out] result has the report's triangles, and becomes the mesh as it is
  void keep_mesh(Adapted_mesh_2& result) {
    result.mesh = mesh_;
    result.mesh.neighbors = given_.neighbors();
    std::vector<char> is_used(mesh_.points.size(), 0);
    for (const auto& t : mesh_.triangles)
      for (const Vertex_index v : t) is_used[std::size_t(v)] = 1;
    result.report.vertices = std::size_t(std::count(is_used.begin(), is_used.end(), 1));
    result.report.input_vertices = pslg_.number_of_vertices();
    result.report.input_segments = pslg_.number_of_segments();
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      result.transfer.old_vertex.push_back(Vertex_index(v));
    find_places(result.mesh, result.transfer);
    if (options_.progress()) options_.progress()(1);
  }

  Adapted_mesh_2 convert(const Kept_vertices_graph& kept) {
    Adapted_mesh_2 result;
    Options options = options_of_run();
    if (options.max_steiner_vertices()) // those left out are not new
      options.max_steiner_vertices(*options.max_steiner_vertices() + mesh_.points.size() -
                                   kept.old_vertex().size());
    result.mesh = mesh_of(kept.graph(), std::move(options), result.report);
    rename_segments(result.mesh, kept);
    result.transfer.old_vertex = kept.old_vertex();
    Recurring_vertices<Point> recurring(mesh_, result.mesh, result.transfer.old_vertex);
    if (const auto new_index = recurring.sort(result.mesh); !new_index.empty())
      for (auto& exempt : result.report.exempt_triangles)
        exempt.corner = new_index[std::size_t(exempt.corner)];
    name_vertices(result.mesh, result.transfer.old_vertex);
    for (auto& unmet : result.report.unmet_triangles)
      if (unmet.segment.is_valid()) unmet.segment = kept.old_segment()[std::size_t(unmet.segment)];
    keep_order_of_triangles(result);
    result.report.input_vertices = pslg_.number_of_vertices();
    result.report.input_segments = pslg_.number_of_segments();
    find_places(result.mesh, result.transfer);
    return result;
  }

  /// Where the mesher finds no room between edges, it leaves them as they are, and so may the old mesh. But its
  /// estimate takes them for a gap to be filled, as such edges are hardly what the owner of a graph means. In a mesh
  /// they may be. So it is asked to try.
  Mesh mesh_of(const Pslg& graph, Options options, Quality_mesh_report_2& report) const {
    const auto run = [&] {
      Mesher mesher(options);
      Mesh mesh = mesher(graph);
      report = mesher.report();
      return mesh;
    };
    try {
      return run();
    } catch (const Pslg_gap_error_2& gap) {
      if (options.max_steiner_vertices() || !is_without_room(graph, gap)) throw;
      options.max_steiner_vertices(fewest_tried + tried_per_vertex * mesh_.points.size());
      Mesh mesh = run();
      if (report.is_budget_exhausted) throw;
      return mesh;
    }
  }

  /// Whether two edges are less than a unit in the last place apart.
  static bool is_without_room(const Pslg& graph, const Pslg_gap_error_2& gap) {
    std::vector<Point> ends;
    for (const Segment_index s : gap.segments)
      for (const Vertex_index v : graph.segment(s)) ends.push_back(graph.point(v));
    const double magnitude = magnitude_of(ends);
    return gap.distance < std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
  }

  /// Where all triangles are those of the old mesh, it is that.
  void keep_order_of_triangles(Adapted_mesh_2& result) const {
    const auto& old_vertex = result.transfer.old_vertex;
    if (old_vertex.size() != mesh_.points.size() || (!old_vertex.empty() && !old_vertex.back().is_valid()))
      return;
    const std::vector<Triangle_index> old_triangle = same_triangles(result.mesh.triangles, mesh_.triangles);
    if (old_triangle.empty()) return;
    std::vector<int> markers = std::move(result.mesh.vertex_markers);
    result.mesh = mesh_;
    result.mesh.neighbors = given_.neighbors();
    if (mesh_.vertex_markers.empty()) result.mesh.vertex_markers = std::move(markers);
    for (auto& exempt : result.report.exempt_triangles)
      exempt.triangle = old_triangle[std::size_t(exempt.triangle)];
    for (auto& unmet : result.report.unmet_triangles)
      unmet.triangle = old_triangle[std::size_t(unmet.triangle)];
  }

  /// Segments and regions become those of the user's graph.
  void rename_segments(Mesh& mesh, const Kept_vertices_graph& kept) const {
    for (auto& edge : mesh.constrained_edges) edge.segment = kept.old_segment()[std::size_t(edge.segment)];
    for (Segment_index& s : mesh.segment_of_vertex)
      if (s.is_valid()) s = kept.old_segment()[std::size_t(s)];
    if (mesh_.region_of_triangle.empty())
      mesh.region_of_triangle.clear();
    else
      for (int& r : mesh.region_of_triangle) r = kept.old_region()[std::size_t(r)];
  }

  /// Vertices of the old mesh are on the segments, and input, as they were.
  void name_vertices(Mesh& mesh, const std::vector<Vertex_index>& old_vertex) const {
    mesh.number_of_input_vertices = pslg_.vertices.size();
    if (!mesh_.input_index.empty()) mesh.input_index.resize(mesh.points.size());
    for (std::size_t v = 0; v < old_vertex.size() && old_vertex[v].is_valid(); ++v) {
      const auto old = std::size_t(old_vertex[v]);
      if (!mesh_.segment_of_vertex.empty()) mesh.segment_of_vertex[v] = mesh_.segment_of_vertex[old];
      if (!mesh_.input_index.empty()) mesh.input_index[v] = mesh_.input_index[old];
    }
  }

  void find_places(const Mesh& mesh, Mesh_transfer_2& transfer) const {
    std::vector<Mesh_transfer_2::Place> of_old(mesh_.points.size());
    for (std::size_t t = mesh_.triangles.size(); t-- > 0;)
      for (std::size_t k = 0; k < 3; ++k) {
        auto& place = of_old[std::size_t(mesh_.triangles[t][k])];
        place = {Triangle_index(t), {}};
        place.weights[k] = 1;
      }
    transfer.places.resize(mesh.points.size());
    for_each_index<ConcurrencyTag>(mesh.points.size(), [&](std::size_t v) {
      if (transfer.old_vertex[v].is_valid()) {
        transfer.places[v] = of_old[std::size_t(transfer.old_vertex[v])];
        return;
      }
      const Triangle_index t = given_.tree().nearest(mesh.points[v]).triangle;
      transfer.places[v] = {t, corner_weights(given_.corners(std::size_t(t)), mesh.points[v])};
    });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_MESH_ADAPTER_H
