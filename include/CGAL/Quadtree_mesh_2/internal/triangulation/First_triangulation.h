// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The constrained Delaunay triangulation of the input, in parallel.
//
// Vertices come in shuffle order, so walks from one to the next are short: O(1) steps on average for points
// that are not adversarial. Three auxiliary vertices outside enclose everything. All triangles at them lie
// outside the domain and are dropped with it.
// 1. Vertices are inserted in rounds of every 16^k-th (for_each_in_rounds.h), until there are enough for blocks in the
//    next round. A small input ends here, with every vertex.
// 2. The vertices of that round are located in the triangulation, which is cut into blocks (Mesh_blocks.h).
// 3. Each block gets the vertices located there (Delaunay_inserter.h), and in the last round the segments between
//    vertices of the block (Segment_inserter.h).
// 4. Blocks are put back, and the sides at seams are made Delaunay. What seams blocked is inserted. The next round
//    goes on with 2.
// 5. Flips make it canonical (Canonical_flipper.h): the same however blocks were cut, but for handles of triangles.
//
// A small input ends with the first step. Its triangulation is constrained Delaunay except for near-ties.
// Expected O(n) work after sorting, worst case O(n^2).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FIRST_TRIANGULATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FIRST_TRIANGULATION_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/place_box.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Canonical_flipper.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Delaunay_inserter.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Segment_inserter.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/for_each_in_rounds.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class First_triangulation {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;
  using Segment = Segment_ends;
  static constexpr std::size_t number_of_auxiliary_vertices = 3;

  /// Room for so many vertices, the auxiliary ones, and those at which acute corners will be cut.
  static std::size_t room_for(std::size_t vertices) {
    return vertices + number_of_auxiliary_vertices + vertices / 8;
  }

  /// \param mesh has nothing but points, which become its vertices; the three auxiliary ones come behind them
  /// \param vertex_blocks the blocks in which they are inserted, if there are several
  First_triangulation(Mesh& mesh, Vertex_blocks vertex_blocks)
      : First_triangulation(mesh, std::move(vertex_blocks), place_box<ConcurrencyTag>(mesh.points.values())) {
  }

  /// \param box the auxiliary vertices are around it; all others are in it
  First_triangulation(Mesh& mesh, Vertex_blocks vertex_blocks, const Place_box<Point>& box)
      : mesh_(mesh), vertex_blocks_(std::move(vertex_blocks)), representative_(mesh.points.size()) {
    start(box);
    find_repeated();
  }

  /// The same, of a mesh that gets its points from a vector.
  template <class Points>
  First_triangulation(Mesh& mesh, const Points& points, Vertex_blocks vertex_blocks)
      : First_triangulation(with_points(mesh, points), std::move(vertex_blocks)) {}

  /// The same, for who does not know the squares of the points.
  template <class Points>
  First_triangulation(Mesh& mesh, const Points& points)
      : First_triangulation(mesh, points,
                            blocks_by_number(points.size(), Block_sizes<ConcurrencyTag>::vertices)) {}

  /// Triangulates all vertices and makes the segments chains of constrained edges.
  /// \returns a crossing of two segments, if there is one; the triangulation is then of no use.
  std::optional<Crossing> run(std::vector<Segment> segments) {
    edges_.segments = std::move(segments);
    if (vertex_blocks_.size() >= 2) {
      const auto crossing = run_in_blocks();
      if (!crossing) Canonical_flipper<ConcurrencyTag, Geometry>(mesh_).run();
      return crossing;
    }
    insert_every(1);
    settle_repeated();
    Segment_inserter<Geometry> inserter(mesh_);
    std::size_t s = 0;
    const auto crossing = catch_crossing([&] {
      for (; s < edges_.segments.size(); ++s) {
        Segment& ends = edges_.segments[s];
        inserter.insert_whole(representative(ends[0]), representative(ends[1]), Segment_index(s), ends);
      }
    });
    for (; s < edges_.segments.size(); ++s) edges_.segments[s] = {}; // a crossing came before
    segments_made_.push_back(inserter.take());
    add_made();
    return crossing;
  }

  /// For each vertex itself, or the one at the same place that stands for it.
  Vertex_id representative(Vertex_id v) const { return representative_[v]; }
  /// How many vertices others stand for.
  std::size_t number_of_repeated_vertices() const {
    std::size_t repeated = 0;
    for (const Vertex_id v : representative_.ids()) repeated += representative_[v] != v ? 1u : 0u;
    return repeated;
  }
  std::size_t number_of_vertices_on_segments() const { return vertices_on_segments_; }
  const Edges_of_segments& edges() const { return edges_; }
  Edges_of_segments take_edges() { return std::move(edges_); }
  /// Edges of segments that overlap others, for each segment but the one in `edges()`.
  Input_edge_list take_repeated_edges() { return std::move(repeated_edges_); }
  Vertex_blocks take_vertex_blocks() { return std::move(vertex_blocks_); }

private:
  /// Blocks of a round before the last have this part of the vertices of it that they have of all in the last, so that
  /// there are some for many threads.
  static constexpr std::size_t part_of_early_block = 4;

  using Blocks = Mesh_blocks<ConcurrencyTag, Geometry>;
  using Block = Mesh_block<Geometry>;

  /// A segment, between the vertices up to which it is made.
  struct Rest_of_segment {
    Vertex_id from, to;
    Segment_index segment;
  };

  /// What comes of the work in a block.
  struct Block_work {
    std::vector<Vertex_id> vertices_left;
    std::vector<Rest_of_segment> segments_left;
    std::optional<Crossing> crossing;
  };

  using Works = Indexed_vector<Block_id, Block_work>;

  Mesh& mesh_;
  Vertex_blocks vertex_blocks_;
  Indexed_vector<Vertex_id, Vertex_id> representative_;
  bool is_any_repeated_ = false;
  Edges_of_segments edges_; // until they are inserted, all segments have ends
  Input_edge_list repeated_edges_;
  std::size_t vertices_on_segments_ = 0;
  std::size_t step_ = 1; // of a round in blocks, which inserts vertices whose numbers are multiples of it
  // for blocks: the triangle of the coarse triangulation that holds a vertex
  Uninitialized_indexed_vector<Vertex_id, Triangle_id> coarse_triangle_;
  std::vector<Segments_made> segments_made_; // by block, until it is added

  template <class Points>
  static Mesh& with_points(Mesh& mesh, const Points& points) {
    mesh.points.reserve(room_for(points.size()));
    mesh.points.resize(points.size());
    for_each_index<ConcurrencyTag>(
        points.size(), [&](std::size_t i) { mesh.points[static_cast<Vertex_id>(i)] = points[i]; });
    return mesh;
  }

  void start(const Place_box<Point>& box) {
    const std::size_t n = mesh_.points.size();
    mesh_.reserve(room_for(n), 0);
    mesh_.resize(n, 0);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      mesh_.role_of[v] = input_vertex(v), mesh_.triangle_of[v] = {}, mesh_.is_dirty[v] = 1;
    });
    const auto [low, high] = box;
    const Vector size = Geometry::difference(high, low);
    // A box of a few units in the last place has no room for a tenth of it.
    const double least_extent = 64 * std::max(Geometry::spacing(low), Geometry::spacing(high));
    const double extent = std::max({double(size.x), double(size.y), least_extent});
    // As near as they can be: differences of 62-bit coordinates must not overflow. Nothing inside the domain
    // sees them.
    for (const Vector corner : {Vector{-1, -0.1}, Vector{2, -0.1}, Vector{0.5, 2.9}})
      mesh_.add_vertex(Geometry::translate(low, extent * corner), input_vertex(mesh_.points.end_id()));
    const Triangle_id t = mesh_.new_triangle();
    for (int k = 0; k < 3; ++k) {
      const Vertex_id v(n + static_cast<std::size_t>(k));
      mesh_.triangle(t).v[k] = v;
      mesh_.triangle_of[v] = t;
    }
  }

  /// Whether a vertex is at the place of the one before it. In shuffle order most that are at one place are neighbors.
  bool is_repeated(Vertex_id v) const {
    const std::size_t i = std::size_t(v);
    return i > 0 && mesh_.point(v) == mesh_.point(static_cast<Vertex_id>(i - 1));
  }

  /// Lets the first of vertices at one place stand for those behind it. However long runs of them are, each vertex is
  /// looked at twice.
  void find_repeated() {
    const std::size_t n = representative_.size();
    std::vector<Vertex_id> first((n + default_block - 1) /
                                 default_block); // the last one of a run in each block
    std::vector<char> has_repeated(first.size(), 0);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (const Vertex_id v : Id_range<Vertex_id>(begin, end))
        if (is_repeated(v))
          has_repeated[b] = 1;
        else
          first[b] = v;
    });
    is_any_repeated_ = std::find(has_repeated.begin(), has_repeated.end(), 1) != has_repeated.end();
    if (!is_any_repeated_) return;
    for (std::size_t b = 1; b < first.size(); ++b)
      if (!first[b].is_valid()) first[b] = first[b - 1];
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      Vertex_id last = b > 0 ? first[b - 1] : Vertex_id();
      for (const Vertex_id v : Id_range<Vertex_id>(begin, end))
        if (is_repeated(v))
          representative_[v] = last;
        else
          last = v;
    });
  }

  /// Once all are inserted: what stands for a vertex may have been at the place of another.
  void settle_repeated() {
    if (!is_any_repeated_) return;
    for_each_index<ConcurrencyTag>(representative_.size(), [this](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      if (is_repeated(v)) representative_[v] = representative_[representative_[v]];
    });
  }

  /// In rounds: every 16^k-th vertex, then every 16^(k-1)-th, and so on, each in order.
  void insert_every(std::size_t last_step) {
    const std::size_t n = representative_.size();
    mesh_.triangles.reserve(2 * (n / last_step) + 16);
    Delaunay_inserter<Geometry> inserter(mesh_);
    Triangle_id hint(0);
    for_each_in_rounds(n, last_step, [&](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      if (!representative_[v].is_valid()) representative_[v] = inserter.insert(v, hint);
      if (mesh_.is_used(representative_[v])) hint = mesh_.incident_triangle(representative_[v]);
    });
  }

  template <class Work>
  static std::optional<Crossing> catch_crossing(const Work& work) {
    try {
      work();
    } catch (const Crossing& crossing) {
      return crossing;
    }
    return std::nullopt;
  }

  /// Takes what has been made of segments.
  void add_made() {
    using Edges = std::vector<Input_edge>;
    append_all<ConcurrencyTag>(edges_.others, segments_made_,
                               [](const Segments_made& m) -> const Edges& { return m.edges; });
    append_all<ConcurrencyTag>(repeated_edges_, segments_made_,
                               [](const Segments_made& m) -> const Edges& { return m.repeated_edges; });
    for (const Segments_made& m : segments_made_) vertices_on_segments_ += m.vertices_on_segments;
    segments_made_.clear();
  }

  // ---- in blocks

  std::optional<Crossing> run_in_blocks() {
    coarse_triangle_.resize(representative_.size());
    step_ = first_step_in_blocks();
    insert_every(step_ * growth_of_rounds);
    for (; step_ > 1; step_ /= growth_of_rounds) insert_round_in_blocks(blocks_of_round(step_));
    const auto crossing = insert_round_in_blocks(vertex_blocks_);
    coarse_triangle_ = {};
    return crossing;
  }

  /// Of the first round with vertices for several blocks.
  std::size_t first_step_in_blocks() const {
    std::size_t step = 1;
    while (blocks_of_round(step * growth_of_rounds).size() >= 2) step *= growth_of_rounds;
    return step;
  }

  Vertex_blocks blocks_of_round(std::size_t step) const {
    return vertex_blocks_.put_together(vertex_blocks_.largest() * step / part_of_early_block);
  }

  /// Inserts the vertices of the round, and segments in the last one.
  std::optional<Crossing> insert_round_in_blocks(const Vertex_blocks& vertex_blocks) {
    locate_vertices();
    const Works works = work_in_blocks(vertex_blocks);
    add_made();
    if (const auto crossing = first_crossing(works)) return crossing;
    for (const Block_work& work : works)
      for (const Vertex_id v : work.vertices_left) insert_late(v);
    return step_ > 1 ? std::nullopt : insert_segments_left(works);
  }

  /// Does what blocks can do, and puts them back unless segments cross.
  Works work_in_blocks(const Vertex_blocks& vertex_blocks) {
    Block_assignment assignment;
    Blocks blocks(mesh_, assignment,
                  cut_by_vertices<ConcurrencyTag>(mesh_, vertex_blocks, [](Vertex_id v) { return v; }));
    Works works(blocks.size());
    auto vertices = vertices_by_block(blocks);
    auto segments_of = segments_by_block(blocks);
    segments_made_.resize(blocks.size());
    blocks.for_each(
        [&](Block& block) {
          Block_work& work = works[block.id()];
          const std::size_t b = block.id().value();
          insert_vertices(block, blocks, vertices[b], assignment, work);
          insert_segments(block, blocks, segments_of[b], assignment, work);
          vertices.give_back(b), segments_of.give_back(b); // memory is fullest at the last block
        },
        [](const Block&) {});
    if (!first_crossing(works)) {
      blocks.put_together();
      std::vector<Side> doubtful = blocks.sides_to_flip();
      mesh_.make_Delaunay(doubtful);
    }
    return works;
  }

  /// How many vertices there are in the round and in those before it.
  std::size_t vertices_of_round() const { return (representative_.size() + step_ - 1) / step_; }
  Vertex_id vertex_of_round(std::size_t i) const { return static_cast<Vertex_id>(i * step_); }

  /// Locates the vertices of the round.
  void locate_vertices() {
    constexpr std::size_t run = 256 * growth_of_rounds;
    for_each_block<ConcurrencyTag>(vertices_of_round(), run,
                                   [&](std::size_t, std::size_t begin, std::size_t end) {
                                     Triangle_id t(0);
                                     for (std::size_t i = begin; i < end; ++i) {
                                       const Vertex_id v = vertex_of_round(i);
                                       t = is_coarse(v) ? mesh_.incident_triangle(representative_[v])
                                                        : locate_exactly(mesh_, t, mesh_.point(v)).triangle;
                                       coarse_triangle_[v] = t;
                                     }
                                   });
    if (!is_any_repeated_ || step_ > 1) return;
    for_each_index<ConcurrencyTag>(representative_.size(), [this](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      if (is_repeated(v)) coarse_triangle_[v] = coarse_triangle_[representative_[v]];
    });
  }

  Block_id block_of(const Blocks& blocks, Vertex_id v) const { return blocks.block_of(coarse_triangle_[v]); }

  /// Whether a vertex was inserted in a round before this one.
  bool is_coarse(Vertex_id v) const {
    return std::size_t(v) % (step_ * growth_of_rounds) == 0 && !is_repeated(v);
  }

  /// The vertices that are inserted in this round, by the block in which they are.
  Groups<Vertex_id> vertices_by_block(const Blocks& blocks) const {
    auto groups = group_in_order<ConcurrencyTag, Vertex_id>(
        vertices_of_round(), blocks.size(), [&](std::size_t i) -> std::size_t {
          const Vertex_id v = vertex_of_round(i);
          return representative_[v].is_valid() ? blocks.size() : block_of(blocks, v).value();
        });
    for_each_index<ConcurrencyTag>(groups.members.size(), [&](std::size_t i) {
      groups.members[i] = vertex_of_round(std::size_t(groups.members[i]));
    });
    return groups;
  }

  /// The segments that are inserted in this round, by the block of their first vertex.
  Groups<Segment_index> segments_by_block(const Blocks& blocks) const {
    return group_in_order<ConcurrencyTag, Segment_index>(
        step_ > 1 ? 0 : edges_.segments.size(), blocks.size(),
        [&](std::size_t s) -> std::size_t { return block_of(blocks, edges_.segments[s][0]).value(); });
  }

  /// \param assignment gets the handles of the vertices in the block
  void insert_vertices(Block& block, const Blocks& blocks, Span<Vertex_id> vertices,
                       Block_assignment& assignment, Block_work& work) {
    Mesh& mesh = block.mesh;
    mesh.triangles.reserve(mesh.triangles.size() + 2 * vertices.size());
    for (const Vertex_id v : vertices) assignment.vertex_in_block(v) = block.add_known_vertex(v);
    Delaunay_inserter<Geometry> inserter(mesh);
    Vertex_id last;
    for (const Vertex_id v : vertices) {
      const Vertex_id here = assignment.vertex_in_block(v);
      const Triangle_id coarse = blocks.place_of(coarse_triangle_[v]);
      Vertex_id stands = !last.is_valid() ? Vertex_id() : inserter.insert(here, mesh.incident_triangle(last));
      if (!stands.is_valid()) stands = inserter.insert(here, coarse);
      if (!stands.is_valid()) {
        work.vertices_left.push_back(v);
        continue;
      }
      representative_[v] = mesh.input_number(stands);
      last = stands;
    }
  }

  /// The handle in the block of what stands for a vertex, none if it is not there.
  Vertex_id find_in_block(const Block& block, const Blocks& blocks, Block_assignment& assignment,
                          Vertex_id v) const {
    if (is_coarse(v)) return block.vertex_in_block(representative(v));
    if (block_of(blocks, v) != block.id()) return {}; // what stands for it may be found right now
    const Vertex_id first = is_repeated(v) ? representative(v) : v, stands = representative(first);
    if (!stands.is_valid()) return {};
    return is_coarse(stands) ? block.vertex_in_block(stands) : assignment.vertex_in_block(stands);
  }

  void insert_segments(Block& block, const Blocks& blocks, Span<Segment_index> of_block,
                       Block_assignment& assignment, Block_work& work) {
    Segment_inserter<Geometry> inserter(block.mesh);
    const Segment_index* next = of_block.begin();
    work.crossing = catch_crossing([&] {
      for (; next != of_block.end(); ++next) {
        const Segment_index s = *next;
        Segment& ends = edges_.segments[s.value()];
        const auto [from, to] = ends;
        const Vertex_id a = find_in_block(block, blocks, assignment, from),
                        b = find_in_block(block, blocks, assignment, to);
        if (!a.is_valid() || !b.is_valid()) {
          work.segments_left.push_back({from, to, s});
          ends = {};
          continue;
        }
        const auto rest = inserter.insert_whole(a, b, s, ends);
        if (!rest.is_empty())
          work.segments_left.push_back(
              {block.mesh.input_number(rest.from), block.mesh.input_number(rest.to), s});
      }
    });
    for (; next != of_block.end(); ++next) edges_.segments[next->value()] = {}; // a crossing came before
    segments_made_[block.id().value()] = inserter.take();
  }

  static std::optional<Crossing> first_crossing(const Works& works) {
    std::optional<Crossing> first;
    for (const Block_work& work : works)
      if (work.crossing && (!first || work.crossing->segment < first->segment)) first = work.crossing;
    return first;
  }

  std::optional<Crossing> insert_segments_left(const Works& works) {
    settle_repeated();
    Segment_inserter<Geometry> inserter(mesh_);
    const auto crossing = catch_crossing([&] {
      for (const Block_work& work : works)
        for (const Rest_of_segment& s : work.segments_left)
          inserter.insert(representative(s.from), representative(s.to), s.segment);
    });
    segments_made_.push_back(inserter.take());
    add_made();
    return crossing;
  }

  /// Inserts a vertex when there are segments already, of which one may run through it.
  void insert_late(Vertex_id v) {
    const Triangle_id t = locate_exactly(mesh_, coarse_triangle_[v], mesh_.point(v)).triangle;
    Side split = Side::border();
    for (int k = 0; k < 3; ++k) {
      const Side s(t, k);
      if (mesh_.across(s).is_constrained() && mesh_.orientation(mesh_.source(s), mesh_.target(s), v) == 0)
        split = s;
    }
    const Vertex_id a = split.is_border() ? Vertex_id() : mesh_.source(split);
    const Vertex_id b = split.is_border() ? Vertex_id() : mesh_.target(split);
    representative_[v] = Delaunay_inserter<Geometry>(mesh_).insert(v, t);
    if (a.is_valid() && representative(v) == v) split_edge(a, b, v);
  }

  void split_edge(Vertex_id a, Vertex_id b, Vertex_id v) {
    edges_.list_between(a, b);
    for (auto* edges : {&edges_.others, &repeated_edges_}) {
      const std::size_t count = edges->size();
      for (std::size_t i = 0; i < count; ++i) {
        Input_edge e = (*edges)[i];
        if (!(e.a == a && e.b == b) && !(e.a == b && e.b == a)) continue;
        (*edges)[i].b = v;
        e.a = v;
        edges->push_back(e);
        ++vertices_on_segments_;
      }
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FIRST_TRIANGULATION_H
