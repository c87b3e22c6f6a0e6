// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A mesh of which parts hold some triangles each: who holds what is as by brute force, with the records of the whole
// mesh, and what is not held takes no memory.

#include "catch.h"
#include "random_pslg_shapes.h"
#include "rounds_of_parts_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <random>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace test_held_mesh {

namespace {

using namespace rounds_of_parts_checks;
using Held = Held_mesh<In_memory_exchange, Geometry>;

/// Who holds what, as all parts know here.
struct Model {
  std::vector<int> owner;      ///< by triangle; -1: it is dead
  std::vector<char> is_shared; ///< by triangle

  bool is_held(std::size_t t, int part) const {
    return owner[t] >= 0 && (is_shared[t] != 0 || owner[t] == part);
  }
};

Model random_owners(const Mesh& whole, int parts, std::mt19937& random) {
  Model model;
  for (const Triangle_id t : whole.triangles.ids())
    model.owner.push_back(whole.is_alive(t) ? static_cast<int>(random() % static_cast<unsigned>(parts)) : -1);
  model.is_shared.assign(model.owner.size(), 0);
  return model;
}

std::size_t faults_of_model(const Mesh& whole, const Mesh& mesh, const Held& held, const Model& model,
                            int part) {
  std::size_t faults = faults_of_records(whole, mesh, held), number = 0;
  std::vector<char> has(whole.number_of_vertices(), 0);
  for (const Triangle_id t : whole.triangles.ids()) {
    const std::size_t i = t.value();
    const bool is_held = model.is_held(i, part);
    if (held.is_held(t) != is_held || held.is_shared(t) != (is_held && model.is_shared[i] != 0)) ++faults;
    if (!is_held) continue;
    ++number;
    for (const Vertex_id v : whole.triangle(t).v) has[v.value()] = 1;
  }
  for (const Vertex_id v : whole.points.ids())
    if (has[v.value()] != 0 && !held.has(v)) ++faults;
  if (held.number_shared() == 0) // nor of what others have
    for (const Vertex_id v : whole.points.ids())
      if (has[v.value()] == 0 && held.has(v) && whole.is_used(v)) ++faults;
  return faults + (held.number_held() == number ? 0 : 1);
}

std::vector<Triangle_id> random_triangles(const Mesh& whole, std::mt19937& random) {
  std::vector<Triangle_id> found;
  const std::size_t n = random() % 20;
  while (found.size() < n) found.push_back(static_cast<Triangle_id>(random() % whole.triangles.size()));
  return found;
}

/// How many vertices of triangles that were another part's, and shared, this part has, but does not know as common.
std::size_t missing_common_vertices(const Mesh& whole, const Held& held, const Model& model,
                                    const std::vector<char>& was_shared, int part) {
  const auto& common = held.common_vertices();
  std::size_t missing = 0;
  for (const Triangle_id t : whole.triangles.ids()) {
    if (was_shared[t.value()] == 0 || model.owner[t.value()] == part) continue;
    for (const Vertex_id v : whole.triangle(t).v)
      if (held.has(v) && std::find(common.begin(), common.end(), v) == common.end()) ++missing;
  }
  return missing;
}

/// A part of a mesh that is published bit by bit.
/// \param known of how many vertices, the first ones, all parts know the points
std::size_t faults_of_part(In_memory_exchange& exchange, const Mesh& whole, std::size_t known,
                           std::uint32_t seed) {
  std::mt19937 random(seed); // the same at all parts
  Model model = random_owners(whole, exchange.size(), random);
  Mesh mesh;
  if (exchange.rank() == 0) mesh = whole;
  if (exchange.rank() != 0)
    mesh.points.assign(whole.points.begin(), whole.points.begin() + std::ptrdiff_t(known));
  Held held(exchange, mesh);
  held.scatter([&](const auto&, Triangle_id t) { return model.owner[t.value()]; }, {},
               2 * whole.number_of_vertices(), known);
  const auto all_known = [&] {
    return std::equal(mesh.points.begin(), mesh.points.begin() + std::ptrdiff_t(known), whole.points.begin());
  };
  std::size_t faults = faults_of_model(whole, mesh, held, model, exchange.rank()) + (all_known() ? 0 : 1);
  for (int step = 0; step < 30; ++step) {
    const std::vector<Triangle_id> wanted = random_triangles(whole, random);
    std::size_t expected = 0;
    for (const Triangle_id t : wanted) {
      const std::size_t i = t.value();
      if (model.owner[i] < 0 || model.is_shared[i] != 0) continue;
      model.is_shared[i] = 1, ++expected;
    }
    if (step % 2 == 0)
      faults += held.publish(wanted) == expected ? 0 : 1;
    else
      held.require(wanted);
    faults += faults_of_model(whole, mesh, held, model, exchange.rank());
    if (step % 8 != 7) continue;
    const std::vector<char> shared = model.is_shared;
    std::fill(model.is_shared.begin(), model.is_shared.end(), char(0));
    held.unshare();
    faults += all_known() ? 0 : 1;
    faults += faults_of_model(whole, mesh, held, model, exchange.rank());
    faults += missing_common_vertices(whole, held, model, shared, exchange.rank());
  }
  held.forget_known_points();
  return faults + faults_of_model(whole, mesh, held, model, exchange.rank());
}

constexpr std::uint32_t number_in_row = 500000;

/// Triangles in a row, of which the vertices are alike.
Mesh row_of_triangles() {
  constexpr std::uint32_t vertices = number_in_row / 2;
  Mesh whole;
  whole.resize(vertices, number_in_row);
  for (const Vertex_id v : whole.points.ids()) {
    whole.points[v] = {double(v.value()), 0}, whole.role_of[v] = free_vertex, whole.is_dirty[v] = 0;
    whole.triangle_of[v] = Triangle_id(2 * v.value());
  }
  for (const Triangle_id t : whole.triangles.ids()) {
    whole.triangle(t) = {};
    for (std::uint32_t k = 0; k < 3; ++k) whole.triangle(t).v[k] = Vertex_id((t.value() / 2 + k) % vertices);
  }
  return whole;
}

#ifdef __linux__
/// The share of an array's pages that are in memory.
template <class Vector>
double share_in_memory(const Vector& values) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const auto begin = (reinterpret_cast<std::uintptr_t>(values.data()) + page - 1) & ~(page - 1);
  const auto end = reinterpret_cast<std::uintptr_t>(values.data() + values.size()) & ~(page - 1);
  std::vector<unsigned char> pages((end - begin) / page);
  if (mincore(reinterpret_cast<void*>(begin), end - begin, pages.data()) != 0) return 1;
  std::size_t number = 0;
  for (const unsigned char p : pages) number += p & 1u;
  return static_cast<double>(number) / static_cast<double>(pages.size());
}
#endif

} // namespace

TEST_CASE("Parts hold what is theirs and what is shared, with the records of the whole mesh",
          "[distributed]") {
  std::uint32_t seed = 0;
  for (const auto& family : random_pslg::all_families())
    for (const int parts : {1, 2, 5}) {
      CAPTURE(family.name, parts);
      Prepared prepared(family.make(7));
      Splitter<Geometry>(prepared.state).cut_rings();
      const Mesh& whole = prepared.state.mesh;
      const std::size_t known = ++seed % 2 == 0 ? prepared.problem.input_points.size() : 0;
      In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
        const auto faults =
            exchange.sum(static_cast<std::int64_t>(faults_of_part(exchange, whole, known, seed)));
        if (exchange.rank() == 0) CHECK(faults == 0);
      });
    }
}

TEST_CASE("Parts tell many triangles in pieces", "[distributed]") {
  const Mesh whole = row_of_triangles();
  constexpr std::uint32_t parts = 5, of_part = number_in_row / parts;
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    const auto rank = static_cast<std::uint32_t>(exchange.rank());
    Mesh mesh;
    if (rank == 0) mesh = whole;
    Held held(exchange, mesh);
    held.scatter([](const auto&, Triangle_id t) { return static_cast<int>(t.value() / of_part); }, {},
                 whole.number_of_vertices());
    std::vector<Triangle_id> wanted; // the last part tells most
    for (std::uint32_t t = 0; t < of_part * (rank + 1) / parts; ++t)
      wanted.push_back(Triangle_id(rank * of_part + t));
    const std::size_t published = held.publish(wanted);
    std::size_t faults = 0;
    for (std::uint32_t t = 0; t < number_in_row; ++t) {
      const std::uint32_t owner = t / of_part;
      const bool is_shared = t % of_part < of_part * (owner + 1) / parts;
      if (held.is_shared(Triangle_id(t)) != is_shared) ++faults;
      if (!is_shared) continue;
      for (const Vertex_id v : whole.triangle(Triangle_id(t)).v)
        if (!held.has(v) || !(mesh.point(v) == whole.point(v))) ++faults;
      for (std::size_t k = 0; k < 3; ++k)
        if (mesh.triangle(Triangle_id(t)).v[k] != whole.triangle(Triangle_id(t)).v[k]) ++faults;
    }
    faults = static_cast<std::size_t>(exchange.sum(static_cast<std::int64_t>(faults)));
    if (rank == 0) CHECK(faults == 0);
    if (rank == 0) CHECK(published == number_in_row * 3 / parts);
  });
}

#ifdef __linux__
TEST_CASE("What a part does not hold takes no memory", "[distributed]") {
  const Mesh whole = row_of_triangles();
  constexpr int parts = 5;
  std::mutex one_by_one;
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    Mesh mesh;
    if (exchange.rank() == 0) mesh = whole;
    Held held(exchange, mesh);
    held.scatter(
        [](const auto&, Triangle_id t) { return static_cast<int>(t.value() / (number_in_row / parts)); }, {},
        4 * whole.number_of_vertices());
    const auto check_memory = [&] {
      const std::lock_guard<std::mutex> lock(one_by_one);
      CHECK(held.number_held() == number_in_row / parts);
      CHECK(share_in_memory(mesh.triangles) < 1.05 / parts);
      CHECK(share_in_memory(mesh.points) < 1.05 / parts);
    };
    check_memory();
    std::vector<Triangle_id> all;
    for (const Triangle_id t : mesh.triangles.ids()) all.push_back(t);
    held.publish(all);
    held.unshare();
    check_memory();
    std::size_t lost = 0;
    for (const Triangle_id t : mesh.triangles.ids())
      if (held.is_held(t) && mesh.triangle(t).v[0] != whole.triangle(t).v[0]) ++lost;
    const std::lock_guard<std::mutex> lock(one_by_one);
    CHECK(lost == 0);
    held.give_back(0, mesh.triangles.size());
    CHECK(share_in_memory(mesh.triangles) < 0.01);
  });
}
#endif

} // namespace test_held_mesh
