// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes of rings, and their changes, against sets of triangles to which the same is done.

#include "catch.h"
#include "random_numbers.h"
#include "ring_mesh_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_patch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_ring_mesh {

using namespace ring_test;
using internal::Patch_marks;

namespace {

using Mesh = Ring_mesh<Integers>;
using Patch = internal::Ring_patch<Integers>;
using Diagonal = std::pair<int, int>;

std::size_t below(Random_numbers& random, std::size_t n) {
  return static_cast<std::size_t>(random() * double(n));
}

/// A mesh, and its triangles as a set, to which the same things are done.
class Twice_changed_mesh {
public:
  Twice_changed_mesh(int columns, int rows, std::uint64_t seed) : random_(seed) {
    const Ring_mesh<Doubles> start = lattice(columns, rows);
    for (const auto& p : start.points)
      mesh.points.push_back(
          {std::int64_t(p.x * 1000) + any_offset(), std::int64_t(p.y * 1000) + any_offset()});
    triangles = triangles_of(start);
    mesh.set_triangles(std::vector<Triangle>(triangles.begin(), triangles.end()));
    spare = append_spare(mesh, 200);
    marks.resize(mesh.number_of_vertices());
  }

  Mesh mesh;
  Triangle_set triangles;
  std::vector<Ring_vertex> spare;
  internal::Indexed_vector<Ring_vertex, Patch_marks> marks;

  /// One of all kinds of changes, if it can be done at the place that is chosen at random.
  void change(Patch& patch) {
    const Triangle t = any_triangle();
    const Ring_vertex a = t[0], b = t[1], c = t[2], d = across(a, b);
    switch (below(random_, 5)) {
    case 0:
      return flip(patch, a, b, c, d);
    case 1:
      return split_edge(patch, a, b, c, d);
    case 2:
      return split_triangle(patch, a, b, c);
    case 3:
      return remove(patch, a);
    default:
      if (patch.is_ours(a)) patch.move(a, any_point());
    }
  }

  std::array<int, 5>
      done{}; // by kind of change; the third and the last are splits and removals at the border

private:
  Random_numbers random_;

  std::int64_t any_offset() { return std::int64_t(below(random_, 200)); }
  Integers::Point any_point() {
    return {std::int64_t(below(random_, 5000)), std::int64_t(below(random_, 5000))};
  }

  Triangle any_triangle() {
    auto it = triangles.begin();
    std::advance(it, std::ptrdiff_t(below(random_, triangles.size())));
    Triangle t = *it;
    std::rotate(t.begin(), t.begin() + std::ptrdiff_t(below(random_, 3)), t.end());
    return t;
  }

  /// Of the set. None on the border.
  Ring_vertex across(Ring_vertex a, Ring_vertex b) const {
    for (const Triangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] == b && t[(k + 1) % 3] == a) return t[(k + 2) % 3];
    return {};
  }
  void replace(const std::vector<Triangle>& old, const std::vector<Triangle>& fresh) {
    for (const Triangle& t : old)
      if (triangles.erase(canonical(t)) != 1) FAIL("no such triangle");
    for (const Triangle& t : fresh)
      if (!triangles.insert(canonical(t)).second) FAIL("there is such a triangle");
  }

  bool can_gain(Ring_vertex v) const { return mesh.ring(v).size < Ring::max_size; }
  bool can_lose(Ring_vertex v) const { return mesh.ring(v).size > (mesh.ring(v).is_open ? 2 : 3); }

  void add_all(Patch& patch, const std::vector<Ring_vertex>& vertices) {
    for (const Ring_vertex v : vertices) patch.add(v);
  }
  bool are_ours(const Patch& patch, const std::vector<Ring_vertex>& vertices) const {
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](Ring_vertex v) { return !v.is_valid() || patch.is_ours(v); });
  }

  void flip(Patch& patch, Ring_vertex a, Ring_vertex b, Ring_vertex c, Ring_vertex d) {
    if (!d.is_valid() || !are_ours(patch, {a, b, c, d}) || mesh.ring(c).contains(d)) return;
    if (!can_gain(c) || !can_gain(d) || !can_lose(a) || !can_lose(b)) return;
    add_all(patch, {a, b, c, d});
    patch.flip(a, b, c, d);
    replace({{a, b, c}, {b, a, d}}, {{c, a, d}, {d, b, c}});
    ++done[0];
  }

  void split_edge(Patch& patch, Ring_vertex a, Ring_vertex b, Ring_vertex c, Ring_vertex d) {
    if (spare.empty() || !are_ours(patch, {a, b, c, d}) || !can_gain(c) || (d.is_valid() && !can_gain(d)))
      return;
    const Ring_vertex m = spare.back();
    spare.pop_back();
    patch.split_edge(m, any_point(), a, b, c, d);
    replace({{a, b, c}}, {{a, m, c}, {m, b, c}});
    if (d.is_valid()) replace({{b, a, d}}, {{b, m, d}, {m, a, d}});
    ++done[d.is_valid() ? 1 : 2];
  }

  void split_triangle(Patch& patch, Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    if (spare.empty() || !are_ours(patch, {a, b, c}) || !can_gain(a) || !can_gain(b) || !can_gain(c)) return;
    const Ring_vertex m = spare.back();
    spare.pop_back();
    patch.split_triangle(m, any_point(), a, b, c);
    replace({{a, b, c}}, {{m, a, b}, {m, b, c}, {m, c, a}});
  }

  /// Of the polygon of positions i to j.
  void triangulate(int i, int j, std::vector<std::array<int, 3>>& filling, std::vector<Diagonal>& diagonals) {
    if (j - i < 2) return;
    const int k = i + 1 + int(below(random_, std::size_t(j - i - 1)));
    filling.push_back({{i, k, j}});
    if (k - i > 1) diagonals.push_back({i, k});
    if (j - k > 1) diagonals.push_back({k, j});
    triangulate(i, k, filling, diagonals);
    triangulate(k, j, filling, diagonals);
  }

  void remove(Patch& patch, Ring_vertex v) {
    const Ring ring = mesh.ring(v);
    std::vector<Triangle> star, filled;
    std::vector<std::array<int, 3>> filling; // by positions
    std::vector<Diagonal> diagonals;
    if (!patch.is_ours(v) || ring.size < 3) return;
    triangulate(0, ring.size - 1, filling, diagonals);
    if (ring.is_open) diagonals.push_back({0, ring.size - 1});
    for (int i = 0; i < ring.size; ++i) {
      const Ring& r = mesh.ring(ring[i]);
      int size = r.size - 1;
      for (const auto& [a, b] : diagonals) {
        if (a != i && b != i) continue;
        ++size;
        if (r.contains(ring[a == i ? b : a])) return;
      }
      if (!patch.is_ours(ring[i]) || size > Ring::max_size || size < (r.is_open ? 2 : 3)) return;
    }
    for (int k = 0; k < ring.number_of_triangles(); ++k) star.push_back({v, ring[k], ring.next(k)});
    for (const auto& [i, j, k] : filling) filled.push_back({ring[i], ring[j], ring[k]});
    patch.drop(v);
    for (int k = 0; k < ring.size; ++k) patch.add(ring[k]);
    patch.remove(v, diagonals);
    replace(star, filled);
    ++done[ring.is_open ? 4 : 3];
  }
};

/// The ring of v by brute force: each member the one after which the triangle of the member before says.
std::vector<Ring_vertex> ring_of(const Triangle_set& triangles, Ring_vertex v) {
  std::map<Ring_vertex, Ring_vertex> next;
  std::set<Ring_vertex> targets;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == v) {
        next[t[(k + 1) % 3]] = t[(k + 2) % 3];
        targets.insert(t[(k + 2) % 3]);
      }
  std::vector<Ring_vertex> ring;
  if (next.empty()) return ring;
  Ring_vertex start = next.begin()->first; // the least, if the ring is closed
  for (const auto& side : next)
    if (targets.count(side.first) == 0) start = side.first;
  ring.push_back(start);
  while (next.count(ring.back()) != 0 && next[ring.back()] != start) ring.push_back(next[ring.back()]);
  return ring;
}

template <class Geometry>
void check_rings_by_brute_force(const Ring_mesh<Geometry>& mesh, const Triangle_set& triangles) {
  for (const Ring_vertex v : mesh.rings.ids()) {
    const Ring& r = mesh.rings[v];
    const std::vector<Ring_vertex> expected = ring_of(triangles, v);
    if (!std::equal(expected.begin(), expected.end(), r.neighbor.begin(), r.neighbor.begin() + r.size))
      FAIL("a ring is not that of the triangles");
    const bool is_closed = expected.size() > 2 && has_triangle(mesh, v, expected.back(), expected[0]);
    if (!expected.empty() && r.is_open == is_closed) FAIL("open or closed");
    if (mesh.is_alive(v) == expected.empty()) FAIL("alive or not");
    for (int k = 0; k < r.size; ++k) {
      Ring_vertex right = Ring_vertex();
      for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i)
          if (t[i] == r[k] && t[(i + 1) % 3] == v) right = t[(i + 2) % 3];
      if (mesh.right_of(v, k) != right) FAIL("another vertex is across an edge");
    }
  }
}

} // namespace

TEST_CASE("Members of rings are inserted and erased in place", "[ring_mesh]") {
  Ring r;
  CHECK(r.number_of_triangles() == 0);
  for (const int v : {5, 7, 9}) r.insert(r.size, Ring_vertex(v));
  r.insert(1, Ring_vertex(6));
  r.insert(0, Ring_vertex(4));
  const auto members = [&r] {
    std::vector<unsigned> numbers;
    for (int k = 0; k < r.size; ++k) numbers.push_back(r[k].value());
    return numbers;
  };
  CHECK(members() == std::vector<unsigned>{4, 5, 6, 7, 9});
  CHECK(r.position_of(Ring_vertex(6)) == 2);
  CHECK(r.contains(Ring_vertex(9)));
  CHECK_FALSE(r.contains(Ring_vertex(8)));
  CHECK(r.next(4) == Ring_vertex(4));
  CHECK(r.next(0) == Ring_vertex(5));
  CHECK(r.previous(0) == Ring_vertex(9));
  CHECK(r.number_of_triangles() == 5);
  r.is_open = true;
  CHECK(r.number_of_triangles() == 4);
  r.erase(4);
  r.erase(0);
  r.erase(1);
  CHECK(members() == std::vector<unsigned>{5, 7});
  while (r.size < Ring::max_size) r.insert(1, Ring_vertex(100 + r.size));
  CHECK(r[1] == Ring_vertex(100 + Ring::max_size - 1));
  CHECK(r[Ring::max_size - 1] == Ring_vertex(7));
}

TEST_CASE("Rings are those of the triangles, whatever their order", "[ring_mesh]") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Twice_changed_mesh m(4, 4, seed);
    Patch patch(m.mesh, m.marks, 0);
    patch.begin();
    for (int i = 0; i < 60; ++i) m.change(patch);
    std::vector<Triangle> triangles(m.triangles.begin(), m.triangles.end());
    std::mt19937_64 random(seed);
    Mesh mesh, again;
    mesh.points = again.points = m.mesh.points;
    mesh.set_triangles(triangles);
    check_disk(mesh);
    check_rings_by_brute_force(mesh, m.triangles);
    CHECK(triangles_of(mesh) == m.triangles);
    std::shuffle(triangles.begin(), triangles.end(), random);
    for (Triangle& t : triangles) std::rotate(t.begin(), t.begin() + std::ptrdiff_t(random() % 3), t.end());
    again.set_triangles(triangles);
    for (const Ring_vertex v : mesh.rings.ids()) {
      const Ring &r = mesh.rings[v], &s = again.rings[v];
      REQUIRE(std::equal(r.neighbor.begin(), r.neighbor.begin() + r.size, s.neighbor.begin(),
                         s.neighbor.begin() + s.size));
      REQUIRE((r.is_open == s.is_open && r.mobility == s.mobility));
    }
  }
}

TEST_CASE("Small meshes have rings", "[ring_mesh]") {
  Mesh none;
  none.set_triangles(std::vector<Triangle>());
  CHECK(none.number_of_vertices() == 0);
  CHECK(none.number_of_triangles() == 0);
  Mesh one;
  one.points.resize(5);
  one.set_triangles(std::vector<std::array<int, 3>>{{3, 1, 4}});
  check_disk(one);
  CHECK(triangles_of(one) == Triangle_set{{Ring_vertex(1), Ring_vertex(4), Ring_vertex(3)}});
  CHECK_FALSE(one.is_alive(Ring_vertex(0)));
  CHECK_FALSE(one.is_alive(Ring_vertex(2)));
  Mesh fan; // around a vertex with as many neighbors as there can be
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < Ring::max_size; ++k) triangles.push_back({Ring::max_size, k, (k + 1) % Ring::max_size});
  fan.points.resize(Ring::max_size + 1);
  fan.set_triangles(triangles);
  check_disk(fan);
  CHECK(fan.number_of_triangles() == std::size_t(Ring::max_size));
  CHECK(fan.ring(Ring_vertex(int(Ring::max_size)))[0] == Ring_vertex(0));
}

TEST_CASE("Changes of rings are those of triangles", "[ring_mesh]") {
  std::array<int, 5> done{};
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Twice_changed_mesh m(3 + int(seed % 3), 4, seed);
    Patch patch(m.mesh, m.marks, 0);
    for (int i = 0; i < 120; ++i) {
      patch.begin();
      m.change(patch);
      check_disk(m.mesh);
      REQUIRE(triangles_of(m.mesh) == m.triangles);
      const auto areas = doubled_areas(m.mesh);
      REQUIRE(areas.first == areas.second);
    }
    for (std::size_t k = 0; k < done.size(); ++k) done[k] += m.done[k];
  }
  for (const int n : done) CHECK(n > 60);
}

TEST_CASE("The area stays where the border does", "[ring_mesh]") {
  Twice_changed_mesh m(5, 4, 7);
  Patch patch(m.mesh, m.marks, 0);
  for (const Ring_vertex v : m.mesh.rings.ids())
    if (m.mesh.is_alive(v) && m.mesh.rings[v].is_open) m.mesh.rings[v].block = -1;
  const std::int64_t area = doubled_areas(m.mesh).first;
  for (int i = 0; i < 300; ++i) {
    patch.begin();
    m.change(patch);
    REQUIRE(doubled_areas(m.mesh).first == area);
  }
  CHECK(m.done[2] + m.done[4] == 0);
}

TEST_CASE("Undoing restores every bit, and what is of others is not changed", "[ring_mesh]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random_numbers random(seed + 1000);
    Twice_changed_mesh m(5, 5, seed);
    Patch patch(m.mesh, m.marks, 0);
    for (Ring& r : m.mesh.rings) {
      if (r.mobility == Mobility::REMOVED) continue;
      r.block = random() < 0.15 ? -1 : 0;
      r.tried_rings = std::uint8_t(below(random, 4));
    }
    const Mesh first = m.mesh;
    for (int operation = 0; operation < 30; ++operation) {
      const Mesh before = m.mesh;
      const Triangle_set triangles = m.triangles;
      const std::vector<Ring_vertex> spare = m.spare;
      patch.begin();
      const std::size_t n = below(random, 12);
      for (std::size_t i = 0; i < n; ++i) m.change(patch);
      check_disk(m.mesh);
      REQUIRE(triangles_of(m.mesh) == m.triangles);
      for (const Ring_vertex v : before.rings.ids()) {
        if (are_same_bits(before.rings[v], m.mesh.rings[v])) continue;
        // members are marked, so that their stars are looked at
        const bool is_known = patch.is_changed(v) || !m.mesh.is_alive(v);
        if (!is_known && patch.is_member(v)) FAIL("a change that is not marked");
      }
      if (operation % 3 == 0) continue;
      patch.undo();
      REQUIRE(are_same_bits(m.mesh, before));
      m.triangles = triangles;
      m.spare = spare;
    }
    for (const Ring_vertex v : first.rings.ids())
      if (first.rings[v].block < 0) REQUIRE(are_same_bits(first.rings[v], m.mesh.rings[v]));
  }
}

TEST_CASE("A patch grows by rings within its block", "[ring_mesh]") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Twice_changed_mesh m(7, 7, seed);
    Random_numbers random(seed);
    for (Ring& r : m.mesh.rings)
      if (seed % 2 == 1 && random() < 0.3) r.block = 1;
    Patch patch(m.mesh, m.marks, 0);
    const Ring_vertex start(30);
    m.mesh.ring(start).block = 0;
    for (int rings = 0; rings < 5; ++rings) {
      std::set<Ring_vertex> expected{start};
      bool is_cut = false;
      for (int k = 0; k < rings; ++k)
        for (const Ring_vertex v : std::set<Ring_vertex>(expected)) {
          const Ring& r = m.mesh.ring(v);
          for (int i = 0; i < r.size; ++i)
            if (m.mesh.ring(r[i]).block == 0)
              expected.insert(r[i]);
            else
              is_cut = true;
        }
      patch.begin();
      patch.add(start);
      patch.add(start);
      patch.grow(rings);
      CHECK(patch.members().size() == expected.size());
      CHECK(std::set<Ring_vertex>(patch.members().begin(), patch.members().end()) == expected);
      CHECK(patch.is_cut() == is_cut);
      CHECK_FALSE(patch.is_active(start));
      patch.activate(start);
      CHECK(patch.is_active(start));
      CHECK(patch.is_changed(start));
      patch.settle(start);
      CHECK_FALSE(patch.is_active(start));
      CHECK(patch.is_changed(start));
      patch.drop(start);
      CHECK_FALSE(patch.is_member(start));
      CHECK(patch.members().size() == expected.size() - 1);
      patch.activate(start); // not a member
      CHECK_FALSE(patch.is_active(start));
    }
  }
}

} // namespace test_ring_mesh
