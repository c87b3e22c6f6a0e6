// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The last flips of a mesh that parts hold, from triangulations whose edges were flipped at random: the bits and the
// account of one memory, whoever holds what.

#include "catch.h"
#include "flipped_meshes.h"
#include "rounds_of_parts_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Flips_of_parts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace test_flips_of_parts {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using namespace flipped_meshes;
using rounds_of_parts_checks::faults_of_records;

struct Problem {
  Meshing_problem<Geometry> problem;
  Meshing_state<Geometry> state{problem};

  explicit Problem(double angle) { problem.bounds = Bounds<Geometry>(angle * CGAL_PI / 180, 0, 0); }

  std::vector<Triangle_id> take_worklist() {
    std::vector<Triangle_id> found;
    while (!state.worklist.is_empty()) found.push_back(state.worklist.pop());
    return found;
  }
};

/// Where triangles are: in strips, or anywhere.
enum class Owners { STRIPS, RANDOM };

std::vector<int> owners(const Mesh& mesh, Owners kind, int parts, Random& random) {
  double end = 0;
  for (const auto& p : mesh.points) end = std::max(end, p.x);
  std::vector<int> owner;
  for (const Triangle_id t : mesh.triangles.ids()) {
    const double x = mesh.point(mesh.triangle(t).v[0]).x;
    const int strip = std::clamp(static_cast<int>(x / end * parts), 0, parts - 1);
    owner.push_back(kind == Owners::STRIPS ? strip
                                           : static_cast<int>(random() % static_cast<unsigned>(parts)));
  }
  return owner;
}

/// How far parts are from what one memory does, at one of them.
std::size_t faults(In_memory_exchange& exchange, const Mesh& mesh, double angle,
                   const std::vector<int>& owner) {
  Problem expected(angle), found(angle);
  expected.state.mesh = mesh;
  const Triangle_account right = Exact_legalizer<CGAL::Sequential_tag, Geometry>(expected.state).run();
  if (exchange.rank() == 0) found.state.mesh = mesh;
  Held_mesh<In_memory_exchange, Geometry> held(exchange, found.state.mesh);
  held.scatter([&](const auto&, Triangle_id t) { return owner[t.value()]; }, {}, mesh.number_of_vertices());
  Triangle_account account =
      Flips_of_parts<CGAL::Sequential_tag, In_memory_exchange, Geometry>(exchange, held, found.state).run();
  std::size_t faults = faults_of_records(expected.state.mesh, found.state.mesh, held);
  if (expected.take_worklist() != found.take_worklist()) ++faults;
  held.unshare();
  faults += faults_of_records(expected.state.mesh, found.state.mesh, held);
  std::size_t speakers = 0;
  for (const Vertex_id v : mesh.points.ids()) speakers += held.speaks_for(v) ? 1 : 0;
  Numbers sums{static_cast<std::int64_t>(speakers)};
  const auto add = [&](const Histograms& h) {
    sums.insert(sums.end(), h.first.begin(), h.first.end());
    sums.insert(sums.end(), h.second.begin(), h.second.end());
  };
  add(histograms_of(account.angles));
  exchange.sum(sums);
  const Numbers all = std::exchange(sums, {});
  std::size_t used = 0;
  for (const Vertex_id v : mesh.points.ids()) used += mesh.is_used(v) ? 1 : 0;
  sums.push_back(static_cast<std::int64_t>(used));
  add(histograms_of(right.angles));
  for (std::size_t i = 0; i < all.size(); ++i) // by modulus
    faults += static_cast<std::uint32_t>(all[i]) == static_cast<std::uint32_t>(sums[i]) ? 0 : 1;
  std::vector<Triangle_id> suspects = tell_all(exchange, account.suspects);
  std::sort(suspects.begin(), suspects.end());
  held.gather();
  faults += faults_of_records(expected.state.mesh, found.state.mesh, held);
  if (exchange.rank() == 0 && held.number_held() != mesh.triangles.size()) ++faults;
  return faults + (suspects == right.suspects ? 0 : 1);
}

} // namespace

TEST_CASE("Parts flip as one memory does, whoever holds what", "[parts][distributed][exact_legalizer]") {
  const Places places = GENERATE(Places::RANDOM, Places::LATTICE, Places::NEEDLES);
  const Owners kind = GENERATE(Owners::STRIPS, Owners::RANDOM);
  const double angle = GENERATE(1e-9, 20.7); // with few triangles that may be bad, or many
  const int parts = GENERATE(1, 2, 3, 5);
  CAPTURE(places, kind, angle, parts);
  Random random(7);
  for (const double share : {0.02, 0.1, 1.0}) {
    CAPTURE(share);
    Mesh mesh = triangulation(points(places, is_full_run() ? 40 : 25, random));
    const std::size_t n = mesh.triangles.size();
    for (std::size_t i = 0; i < n / 20; ++i)
      mesh.constrain(Side(Triangle_id(random() % n), static_cast<int>(random() % 3)));
    flip_at_random(mesh, static_cast<std::size_t>(share * static_cast<double>(n)), random);
    const std::vector<int> owner = owners(mesh, kind, parts, random);
    In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
      const auto all = exchange.sum(static_cast<std::int64_t>(faults(exchange, mesh, angle, owner)));
      if (exchange.rank() == 0) CHECK(all == 0);
    });
  }
}

TEST_CASE("Parts share little of a mesh to flip it", "[parts][distributed][exact_legalizer]") {
  Random random(11);
  Mesh mesh = triangulation(points(Places::RANDOM, 200, random));
  flip_at_random(mesh, mesh.triangles.size() / 50, random);
  constexpr int parts = 4;
  const std::vector<int> owner = owners(mesh, Owners::STRIPS, parts, random);
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    Problem found(1e-9);
    if (exchange.rank() == 0) found.state.mesh = mesh;
    Held_mesh<In_memory_exchange, Geometry> held(exchange, found.state.mesh);
    held.scatter([&](const auto&, Triangle_id t) { return owner[t.value()]; }, {}, mesh.number_of_vertices());
    Flips_of_parts<CGAL::Sequential_tag, In_memory_exchange, Geometry>(exchange, held, found.state).run();
    const auto most = exchange.max(static_cast<std::int64_t>(held.number_shared()));
    if (exchange.rank() == 0) CHECK(most < static_cast<std::int64_t>(mesh.triangles.size() / 10));
  });
}

} // namespace test_flips_of_parts
