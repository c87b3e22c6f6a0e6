// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A mesh of which each part holds some triangles, under the handles that they have in the whole mesh.
//
// Computes: who holds which triangle. A triangle is private to one part, or shared: then all parts have the same record
//           of it and of its vertices, and may compute the same from it without a message.
// Invariant: whoever holds a triangle has the right records of its vertices. What a record of a vertex names as a
//           triangle may be held by others.
// Bound:    memory for what is held, in pages, and for points that all parts know, and addresses for the whole mesh.
//           Triangles that are published are sent to all parts.
// Method:   arrays as long as those of the whole mesh, whose pages nobody touches who does not hold what is in them. So
//           all that goes by handles, such as an order of triangles, is what it is in one memory.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_HELD_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_HELD_MESH_H

#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_arrays.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Sparse_bytes.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/tell_all.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/parts_of_vertices.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// See the head of this file.
template <class Exchange, class Geometry>
class Held_mesh {
public:
  using Mesh = Kernel_mesh<Geometry>;

  /// \param mesh the whole mesh at part 0; afterward what is held
  Held_mesh(Exchange& exchange, Mesh& mesh) : exchange_(exchange), mesh_(mesh) {}

  /// Gives each part its triangles, and part 0 the vertices without any. All parts call it.
  /// \param part_of `part_of(mesh, t)` is the part of a triangle that is alive in a mesh; called at part 0
  /// \param for_all vertices of which all parts get the records, as they are now; of part 0
  /// \param most_vertices how many the mesh may get; a hint
  /// \param known of how many vertices, the first ones, all parts know the points. At other parts the mesh has these
  ///        points and nothing else. All meshes keep them, whatever they hold.
  template <class Part_of>
  void scatter(const Part_of& part_of, const std::vector<Vertex_id>& for_all, std::size_t most_vertices,
               std::size_t known = 0) {
    Mesh whole = std::exchange(mesh_, Mesh());
    Bytes sizes = bytes_of(Numbers{std::int64_t(whole.number_of_vertices()),
                                   std::int64_t(whole.triangles.size()), whole.region_of.empty() ? 0 : 1});
    exchange_.broadcast(sizes, 0);
    const auto size = records_of<std::int64_t>(sizes);
    const auto vertices = std::size_t(size[0]), slots = std::size_t(size[1]);
    if (size[2] != 0) mesh_.region_of.resize(1);
    // Room in a scratch file is room on its disk: there arrays grow if they have to.
    const std::size_t affordable = Scratch_arrays::is_active() ? 2 * vertices : most_vertices;
    const std::size_t room = std::max(vertices, std::min(most_vertices, affordable));
    reserve(room, slots + 2 * (room - vertices));
    resize(vertices, slots);
    for (const Triangle_id t : whole.dead_triangles()) mesh_.kill(t);
    known_ = known;
    for (std::size_t begin = 0; exchange_.rank() != 0 && begin < known_; begin += at_a_time)
      take_known_points(whole, begin, std::min(known_, begin + at_a_time));
    const Vertex_parts parts = exchange_.rank() == 0 ? parts_of_vertices(whole, part_of) : Vertex_parts();
    give_common(whole, parts, for_all);
    give_triangles(whole, part_of);
    give_vertices(whole, parts);
  }

  /// Part 0 gets all that others hold: its mesh is whole then, but for what is dead. Others keep what they have. Only a
  /// run of handles is on its way at a time. All parts call it.
  void gather() {
    constexpr std::size_t run = std::size_t(1) << 18;
    const std::size_t end = std::max(mesh_.triangles.size(), mesh_.number_of_vertices());
    for (std::size_t first = 0; first < end; first += run) {
      Parcels outbox;
      if (exchange_.rank() != 0) outbox = parcels_for_first_part(first, first + run);
      for (const Parcel& parcel : exchange_.exchange(std::move(outbox))) {
        Archive_reader archive(parcel.bytes);
        std::vector<Triangle_record> triangles;
        std::vector<Vertex_record> vertices;
        archive(triangles), archive(vertices);
        for (const Triangle_record& r : triangles) write(r), set_private(r.id);
        for (const Vertex_record& r : vertices) write(r), set_has(r.id);
      }
    }
  }

  /// Makes room for the handles of new triangles and vertices.
  void resize(std::size_t vertices, std::size_t slots) {
    mesh_.resize(vertices, slots);
    if (slots > hold_.size()) hold_.grow(2 * slots);
    if (vertices > has_.size()) has_.grow(2 * vertices);
  }

  bool is_held(Triangle_id t) const { return hold_[t.value()] != ABSENT; }
  bool is_private(Triangle_id t) const { return hold_[t.value()] == PRIVATE; }
  bool is_shared(Triangle_id t) const { return hold_[t.value()] >= SHARED; }
  /// Whether this part vouches for the record of a vertex.
  bool has(Vertex_id v) const { return has_[v.value()] != 0; }

  /// What this part has made, or what is no more.
  void set_private(Triangle_id t) { set(t, PRIVATE); }
  void set_absent(Triangle_id t) { set(t, ABSENT); }
  void set_has(Vertex_id v) { has_[v.value()] = HAS; }

  /// Whether this part is the one that speaks for a triangle where one has to: for its private ones, and those that it
  /// has told to all.
  bool speaks_for(Triangle_id t) const { return is_private(t) || hold_[t.value()] == TOLD; }
  /// The same for a vertex with a triangle.
  bool speaks_for(Vertex_id v) const {
    return has(v) && mesh_.is_used(v) && speaks_for(mesh_.incident_triangle(v));
  }

  /// Lets go of the memory of the triangles with handles in [begin, end), which nobody reads any more.
  void give_back(std::size_t begin, std::size_t end) {
    give_back_values(mesh_.triangles, begin, end), give_back_values(mesh_.region_of, begin, end);
  }

  /// Ends all sharing. Who speaks for a triangle keeps it as private. Others drop it, and vertices that only such
  /// triangles have, and give their pages back. All parts call it; there are no messages. O(n) for n handles.
  void unshare() {
    const auto of = [this](Vertex_id v) -> char& { return has_[v.value()]; };
    for (const Vertex_id v : mesh_.points.ids())
      if (has(v) && mesh_.is_used(v)) of(v) = PERHAPS;
    for (const Triangle_id t : mesh_.triangles.ids()) {
      if (!is_shared(t)) continue;
      if (!speaks_for(t))
        for (const Vertex_id v : mesh_.triangle(t).v) of(v) = OF_OTHERS;
      set(t, speaks_for(t) ? PRIVATE : ABSENT);
    }
    for (const Triangle_id t : mesh_.triangles.ids())
      if (is_private(t))
        for (const Vertex_id v : mesh_.triangle(t).v) of(v) = of(v) == PERHAPS || of(v) == HAS ? HAS : COMMON;
    for (const Vertex_id v : mesh_.points.ids()) {
      if (of(v) == COMMON) common_.push_back(v);
      if (has(v)) of(v) = of(v) == HAS || of(v) == COMMON ? HAS : HAS_NOT;
    }
    sort_and_drop_equal(common_);
    for_each_needless_run<Triangle_id>(
        mesh_.triangles.size(), [this](Triangle_id t) { return !is_held(t); },
        [this](std::size_t begin, std::size_t end) { give_back(begin, end); });
    for_each_needless_run<Vertex_id>(
        mesh_.number_of_vertices(), [this](Vertex_id v) { return !has(v); },
        [this](std::size_t begin, std::size_t end) { give_back_vertices(mesh_, begin, end, known_); });
    give_back_free_memory();
  }

  /// Gives back the points that all parts knew, but for those of vertices that this part has.
  void forget_known_points() {
    for_each_needless_run<Vertex_id>(
        std::exchange(known_, 0), [this](Vertex_id v) { return !has(v); },
        [this](std::size_t begin, std::size_t end) { give_back_values(mesh_.points, begin, end); });
  }

  std::size_t number_held() const { return number_[PRIVATE] + number_shared(); }
  std::size_t number_shared() const { return number_[SHARED] + number_[TOLD]; }
  /// How many triangles this part has held at once.
  std::size_t most_held() const { return most_held_; }
  /// The vertices that several parts got, or may have since they shared triangles; perhaps some more.
  const std::vector<Vertex_id>& common_vertices() const { return common_; }

  // ---- what all parts call together

  /// Shares private triangles; what else is in the list, which each part has its own of, is passed over.
  /// \returns how many all parts have published
  std::size_t publish(const std::vector<Triangle_id>& wanted) {
    Package package;
    for (const Triangle_id t : wanted) {
      if (!is_private(t)) continue;
      set(t, TOLD);
      package.add(mesh_, t);
    }
    return tell(std::move(package));
  }

  /// Shares triangles of a list that is the same at all parts. Those that are shared already cost nothing. So they do
  /// not meet if all are.
  /// \param rings how many rings of triangles around them are shared too, if they are private to the same part
  void require(const std::vector<Triangle_id>& wanted, int rings = 0) {
    if (std::all_of(wanted.begin(), wanted.end(), [this](Triangle_id t) { return is_shared(t); })) return;
    publish(private_around(wanted, rings));
  }

  /// Tells all parts the triangles, which are shared then, and the vertices, for both of which this part vouches.
  void tell(const std::vector<Triangle_id>& triangles, const std::vector<Vertex_id>& vertices) {
    Package package;
    for (const Triangle_id t : triangles) set(t, TOLD), package.add(mesh_, t);
    package.vertices.insert(package.vertices.end(), vertices.begin(), vertices.end());
    tell(std::move(package));
  }

  /// The private triangles of a list and of so many rings around them, as far as one gets in what is held.
  std::vector<Triangle_id> private_around(const std::vector<Triangle_id>& wanted, int rings) const {
    std::vector<Triangle_id> found, before, last; // of rings: the last one, and that before it
    for (const Triangle_id t : wanted)
      if (is_held(t)) last.push_back(t);
    sort_and_drop_equal(last);
    for (;; --rings) {
      std::copy_if(last.begin(), last.end(), std::back_inserter(found),
                   [this](Triangle_id t) { return is_private(t); });
      if (rings == 0 || last.empty()) break;
      std::vector<Triangle_id> next = next_ring(before, last);
      before = std::exchange(last, std::move(next));
    }
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  enum Hold : char { ABSENT, PRIVATE, SHARED, TOLD }; // shared: told by others, or by this part
  /// Whether a part has a vertex. While sharing ends: perhaps it has; or it has if one of its own triangles has the
  /// vertex, as one of others did; or so it is.
  enum Have : char { HAS_NOT, HAS, PERHAPS, OF_OTHERS, COMMON };

  struct Triangle_record {
    Triangle_id id;
    Region_id region;
    typename Mesh::Triangle triangle;
  };
  struct Vertex_record {
    Vertex_id id;
    Triangle_id triangle;
    Vertex_role role;
    std::int32_t is_dirty;
    typename Geometry::Point point;
  };

  /// What is sent, by handles.
  struct Package {
    std::vector<Triangle_id> triangles;
    std::vector<Vertex_id> vertices; ///< some more than once

    void add(const Mesh& mesh, Triangle_id t) {
      triangles.push_back(t);
      for (const Vertex_id v : mesh.triangle(t).v) vertices.push_back(v);
    }
  };

  /// A piece of a package, as it arrives.
  struct Told {
    bool is_followed = false; ///< by another piece
    std::vector<Triangle_record> triangles;
    std::vector<Vertex_record> vertices;

    explicit Told(const Bytes& bytes) {
      Archive_reader archive(bytes);
      archive(is_followed), archive(triangles), archive(vertices);
    }
  };

  /// How many triangles, and how many vertices, are on their way to all parts at a time, or from all.
  static constexpr std::size_t at_a_time = std::size_t(1) << 14;

  std::size_t number_of_each() const { return at_a_time / static_cast<std::size_t>(exchange_.size()) + 1; }

  Exchange& exchange_;
  Mesh& mesh_;
  Sparse_bytes hold_, has_;
  std::size_t number_[4] = {0, 0, 0, 0};
  std::size_t most_held_ = 0;
  std::vector<Vertex_id> common_;
  std::size_t known_ = 0; // of the first vertices all parts know the points

  void set(Triangle_id t, Hold hold) {
    char& now = hold_[t.value()];
    if (now != ABSENT) --number_[std::size_t(now)];
    now = hold;
    if (now != ABSENT) ++number_[std::size_t(now)];
    most_held_ = std::max(most_held_, number_held());
  }

  /// What is held beside a ring: it is in none of those before that.
  std::vector<Triangle_id> next_ring(const std::vector<Triangle_id>& before,
                                     const std::vector<Triangle_id>& last) const {
    std::vector<Triangle_id> beside, beyond, next;
    for (const Triangle_id t : last)
      for (const Side o : mesh_.triangle(t).side)
        if (!o.is_border() && is_held(o.triangle())) beside.push_back(o.triangle());
    sort_and_drop_equal(beside);
    std::set_difference(beside.begin(), beside.end(), last.begin(), last.end(), std::back_inserter(beyond));
    std::set_difference(beyond.begin(), beyond.end(), before.begin(), before.end(), std::back_inserter(next));
    return next;
  }

  void reserve(std::size_t vertices, std::size_t slots) {
    const auto reserve = [](auto& values, std::size_t n) {
      values.reserve(n);
      ask_for_small_pages(values.data(), n * sizeof(*values.data()));
      give_back_pages(values.data(), n * sizeof(*values.data())); // of an array that was there before
    };
    reserve(mesh_.points, vertices), reserve(mesh_.role_of, vertices), reserve(mesh_.triangle_of, vertices);
    reserve(mesh_.is_dirty, vertices), reserve(mesh_.triangles, slots);
    if (!mesh_.region_of.empty()) reserve(mesh_.region_of, slots);
    hold_.grow(slots), has_.grow(vertices);
  }

  /// What it gets of a run of handles; none if that is nothing.
  Parcels parcels_for_first_part(std::size_t first, std::size_t last) const {
    std::vector<Triangle_id> triangles;
    std::vector<Vertex_id> vertices;
    for (std::size_t t = first; t < std::min(last, mesh_.triangles.size()); ++t)
      if (is_private(Triangle_id(t))) triangles.push_back(Triangle_id(t));
    for (std::size_t v = first; v < std::min(last, mesh_.number_of_vertices()); ++v)
      if (has(Vertex_id(v))) vertices.push_back(Vertex_id(v));
    if (triangles.empty() && vertices.empty()) return {};
    Archive_writer archive;
    archive(records(mesh_, triangles)), archive(records(mesh_, vertices));
    return {{0, std::move(archive.bytes)}};
  }

  static Triangle_record record(const Mesh& mesh, Triangle_id t) {
    return {t, mesh.region(t), mesh.triangle(t)};
  }
  static Vertex_record record(const Mesh& mesh, Vertex_id v) {
    return {v, mesh.incident_triangle(v), mesh.role(v), mesh.is_dirty[v], mesh.point(v)};
  }
  template <class Id>
  static auto records(const Mesh& mesh, const std::vector<Id>& ids) {
    return records(mesh, ids, 0, ids.size());
  }
  /// Of at most so many of the ids, from a place on.
  template <class Id>
  static auto records(const Mesh& mesh, const std::vector<Id>& ids, std::size_t begin, std::size_t most) {
    std::vector<decltype(record(mesh, Id()))> found;
    const std::size_t end = std::min(ids.size(), begin + most);
    found.reserve(end - std::min(begin, end));
    for (std::size_t i = begin; i < end; ++i) found.push_back(record(mesh, ids[i]));
    return found;
  }
  void write(const Triangle_record& r) {
    mesh_.triangle(r.id) = r.triangle;
    mesh_.set_region(r.id, r.region);
  }
  void write(const Vertex_record& r) {
    mesh_.points[r.id] = r.point, mesh_.role_of[r.id] = r.role;
    mesh_.triangle_of[r.id] = r.triangle, mesh_.is_dirty[r.id] = static_cast<char>(r.is_dirty);
  }

  /// \returns how many triangles all parts have told
  std::size_t tell(Package package) {
    sort_and_drop_equal(package.vertices);
    const std::size_t of_each = number_of_each();
    std::size_t number = 0;
    bool is_more = true;
    for (std::size_t piece = 0; is_more; ++piece) {
      is_more = false;
      const Bytes bytes = bytes_of_piece(mesh_, package, piece * of_each, of_each);
      for (const Parcel& parcel : tell_all_bytes(exchange_, bytes)) {
        const Told told(parcel.bytes);
        is_more = is_more || told.is_followed;
        number += told.triangles.size();
        if (parcel.part == exchange_.rank()) continue;
        for (const Triangle_record& r : told.triangles) write(r), set(r.id, SHARED);
        for (const Vertex_record& r : told.vertices) write(r), set_has(r.id);
      }
    }
    return number;
  }

  /// Some triangles and some vertices of a package, and whether there are more; nothing behind its end.
  static Bytes bytes_of_piece(const Mesh& mesh, const Package& package, std::size_t begin, std::size_t most) {
    if (begin >= size_of(package)) return {};
    const auto triangles = records(mesh, package.triangles, begin, most);
    const auto vertices = records(mesh, package.vertices, begin, most);
    constexpr std::size_t rest = 64;
    Archive_writer archive(triangles.size() * sizeof(Triangle_record) +
                           vertices.size() * sizeof(Vertex_record) + rest);
    archive(begin + most < size_of(package)), archive(triangles), archive(vertices);
    return std::move(archive.bytes);
  }
  static std::size_t size_of(const Package& package) {
    return std::max(package.triangles.size(), package.vertices.size());
  }

  // ---- scatter

  /// Gives each part its triangles, by runs of handles. The whole mesh loses those that are given.
  template <class Part_of>
  void give_triangles(Mesh& whole, const Part_of& part_of) {
    Pieces_given_back given(mesh_.triangles.size());
    give_runs<Triangle_record>(
        mesh_.triangles.size(),
        [&](std::size_t begin, std::size_t end, auto& to) {
          for (const Triangle_id t : Id_range<Triangle_id>(begin, end))
            if (whole.is_alive(t))
              to[static_cast<std::size_t>(part_of(whole, t))].push_back(record(whole, t));
          given.give_back_before(end, [&](std::size_t first, std::size_t last) {
            give_back_values(whole.triangles, first, last), give_back_values(whole.region_of, first, last);
          });
        },
        [this](const Triangle_record& r) { write(r), set_private(r.id); });
  }
  void give_vertices(Mesh& whole, const Vertex_parts& parts) {
    auto other = parts.others.begin();
    Pieces_given_back given(mesh_.number_of_vertices());
    give_runs<Vertex_record>(
        mesh_.number_of_vertices(),
        [&](std::size_t begin, std::size_t end, auto& to) {
          for (const Vertex_id v : Id_range<Vertex_id>(begin, end)) {
            to[static_cast<std::size_t>(parts.first[v])].push_back(record(whole, v));
            for (; other != parts.others.end() && other->first == v; ++other)
              to[static_cast<std::size_t>(other->second)].push_back(record(whole, v));
          }
          given.give_back_before(end, [&](std::size_t first, std::size_t last) {
            take_known_points(whole, first, std::min(known_, last));
            give_back_vertices(whole, first, last);
          });
        },
        [this](const Vertex_record& r) { write(r), set_has(r.id); });
  }

  /// \param fill puts the records of handles [begin, end) where their parts are; part 0 calls it
  /// \param take called for each record that is for this part
  template <class Record, class Fill, class Take>
  void give_runs(std::size_t size, const Fill& fill, const Take& take) {
    // Most of a run goes to one part: so few that their parcel comes from the heap at once, and needs no pages of its
    // own.
    constexpr std::size_t run = std::size_t(1) << 12;
    for (std::size_t begin = 0; begin < size; begin += run) {
      Parcels outbox;
      if (exchange_.rank() == 0) {
        std::vector<std::vector<Record>> to(static_cast<std::size_t>(exchange_.size()));
        fill(begin, std::min(size, begin + run), to);
        for (const Record& r : to[0]) take(r);
        for (std::size_t part = 1; part < to.size(); ++part)
          if (!to[part].empty()) outbox.push_back({static_cast<int>(part), bytes_of(to[part])});
      }
      for (const Parcel& parcel : exchange_.exchange(std::move(outbox)))
        for (const Record& r : records_of<Record>(parcel.bytes)) take(r);
    }
  }

  /// Those of [begin, end), of which there may be none, from a mesh that loses them.
  void take_known_points(Mesh& from, std::size_t begin, std::size_t end) {
    if (begin >= end) return;
    std::copy(from.points.data() + begin, from.points.data() + end, mesh_.points.data() + begin);
    give_back_values(from.points, begin, end);
  }

  /// \param end_of_kept_points those before it stay
  static void give_back_vertices(Mesh& mesh, std::size_t begin, std::size_t end,
                                 std::size_t end_of_kept_points = 0) {
    give_back_values(mesh.points, std::min(std::max(begin, end_of_kept_points), end), end);
    give_back_values(mesh.role_of, begin, end), give_back_values(mesh.triangle_of, begin, end);
    give_back_values(mesh.is_dirty, begin, end);
  }

  /// Gives each part the records of some vertices, for which no part vouches, and the names of those it shares with
  /// others.
  void give_common(const Mesh& whole, const Vertex_parts& parts, const std::vector<Vertex_id>& for_all) {
    Parcels outbox;
    if (exchange_.rank() == 0) {
      std::vector<std::vector<Vertex_id>> common(static_cast<std::size_t>(exchange_.size()));
      for (auto other = parts.others.begin(); other != parts.others.end(); ++other) {
        const Vertex_id v = other->first;
        if (other == parts.others.begin() || std::prev(other)->first != v)
          common[static_cast<std::size_t>(parts.first[v])].push_back(v);
        common[static_cast<std::size_t>(other->second)].push_back(v);
      }
      for (std::size_t part = 0; part < common.size(); ++part) {
        Archive_writer archive;
        archive(records(whole, for_all)), archive(common[part]);
        outbox.push_back({static_cast<int>(part), std::move(archive.bytes)});
      }
    }
    for (const Parcel& parcel : exchange_.exchange(std::move(outbox))) {
      Archive_reader archive(parcel.bytes);
      std::vector<Vertex_record> records;
      archive(records), archive(common_);
      for (const Vertex_record& r : records) write(r);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_HELD_MESH_H
