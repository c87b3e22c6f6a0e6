// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "cluster_test_tools.h"
#include "random_numbers.h"

#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/dyadic_steps.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace test_cluster_frame {

using namespace cluster_tests;

TEST_CASE("Steps of powers of two lose nothing", "[clusters]") {
  CHECK(internal::add_steps(0.5, 3, -10) == 0.5 + 3 * 0x1p-10);
  CHECK(internal::add_steps(-0x1p50, -7, -2) == -0x1p50 - 1.75);
  CHECK(internal::add_steps(0x1p-300, -512, 40) == -0x1p49);
  const std::int64_t n = (std::int64_t(1) << 60) + 5;
  CHECK(internal::add_steps(-0x1p60, n, 0) == 5);
  CHECK(internal::count_steps(0.75, 0.5, -59) == std::int64_t(1) << 57);
  CHECK(internal::count_steps(-0x1p-100, 0.5, -60) == -(std::int64_t(1) << 59) - 1);
  CHECK(internal::add_steps(std::int64_t(10), 7, -2) == 12);
  CHECK(internal::add_steps(std::int64_t(10), -7, -2) == 8);
  CHECK(internal::add_steps(std::int64_t(10), -3, 4) == -38);
  CHECK(internal::middle_multiple(std::int64_t(-21), std::int64_t(-20), 3) == -24);
  CHECK(internal::middle_multiple(0.3, 0.4, -2) == 0.25);
  Random_numbers random(3);
  for (int i = 0; i < 1000; ++i) {
    const int e = int(random() * 40) - 80;
    const std::int64_t steps = std::int64_t((random() - 0.5) * 0x1p62);
    const double p = std::ldexp(std::floor(random() * 0x1p40), e);
    const Exact::Coordinate q = internal::add_steps(Exact::Coordinate(p), steps, e);
    REQUIRE(q.exact() == Number(p) + Number(static_cast<long>(steps)) * power(e));
    REQUIRE(internal::count_steps(q, Exact::Coordinate(p), e) == steps);
    REQUIRE(internal::count_steps(q, Exact::Coordinate(p), e - 1) == 2 * steps);
    REQUIRE(std::fabs(internal::add_steps(p, steps, e) - q.high()) <= std::ldexp(std::fabs(q.high()), -52));
    // what is a double is found exactly
    const double target = std::ldexp(std::floor(random() * 0x1p53) - 0x1p52, e);
    REQUIRE(internal::add_steps(p, internal::count_steps(target, p, e), e) == target);
  }
}

TEST_CASE("Places of the grid and points belong together", "[clusters]") {
  Random_numbers random(8);
  for (int i = 0; i < 300; ++i) {
    const double x = random() * 100 - 50, y = random(), w = std::exp2(-25 * random());
    const Points<Doubles> points{{x, y}, {x + w, y + w / 3}};
    const internal::Cluster_frame<Doubles> frame(points, {0, 1, 0, 1},
                                                 internal::Cluster_frame<Doubles>::exponent_for_width(w));
    REQUIRE(frame.cell() >= 2.49 * w);
    REQUIRE(frame.cell() < 5.01 * w);
    for (const auto& p : points) {
      const auto q = frame.point_at(frame.place_of(p));
      REQUIRE(std::fabs(q.x - p.x) <= frame.cell() * 0x1p-52 + std::fabs(p.x) * 0x1p-52);
      REQUIRE(std::fabs(q.y - p.y) <= frame.cell() * 0x1p-52 + std::fabs(p.y) * 0x1p-52);
    }
    const auto cell = [&] {
      return (std::uint64_t(random() * 8) << 59) + (std::uint64_t(random() * 1024) << 49);
    };
    const Place place{cell(), cell()};
    REQUIRE(frame.place_of(frame.point_at(place)) == place);
  }
}

TEST_CASE("The ring around a cluster is exact and acute", "[clusters]") {
  const int rounds = is_full_run() ? 300 : 25;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    Random_numbers random(std::uint64_t(round) + 1);
    // as near to the last bits as is allowed
    const double x = random() - 0.5, y = std::exp2(-60 * random()),
                 w = round % 5 == 0 ? 0x1p-45 : std::exp2(-40 * random());
    const Points<Doubles> points{{x, y}, {x + w, y}};
    const int exponent =
        std::max(internal::Cluster_frame<Doubles>::exponent_for_width(w),
                 internal::Dyadic_room<Doubles>::least_exponent(std::max(std::fabs(x + w), y)));
    const internal::Cluster_frame<Doubles> frame(points, {0, 1, 0, 1}, exponent);
    for (int k : {6, 7, int(6 + random() * 43), 48}) check_ring(frame, exponent + k);

    const auto to_integer = [](double c) { return std::int64_t(c * 0x1p55); };
    const Points<Integers> integers{{to_integer(x), to_integer(y)}, {to_integer(x) + 400, to_integer(y) + 3}};
    check_ring(internal::Cluster_frame<Integers>(integers, {0, 1, 0, 1}, 10), 16 + int(random() * 40));

    const Number third = Number(1) / Number(3);
    const Points<Exact> exacts{
        {Exact::Coordinate(Number(third * Number(x))), Exact::Coordinate(y)},
        {Exact::Coordinate(Number(third * Number(x) + Number(w))), Exact::Coordinate(y)}};
    const internal::Cluster_frame<Exact> of_exacts(exacts, {0, 1, 0, 1}, exponent);
    check_ring(of_exacts, exponent + 6);
    check_ring(of_exacts, exponent + 6 + int(random() * 400));
  }
}

} // namespace test_cluster_frame
