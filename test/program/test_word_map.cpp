// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The program's map between doubles and 64-bit words, at the ends of its range.

#include "catch.h"
#include "pslg_test_tools.h"

#include "Word_map.h"

#include <cstddef>
#include <vector>

namespace test_word_map {

using namespace mesh_in_words_internal;
using pslg_test::Point;

TEST_CASE("No points have a map to words", "[fixed]") {
  for (const Room room : {Room::HALF, Room::EIGHTEENTH}) {
    const Word_map<Point> map(std::vector<Point>{}, room);
    CHECK(map.is_exact(Point(0, 0)));
  }
}

TEST_CASE("Coordinates too large for words are refused by index and limit", "[fixed]") {
  for (const Room room : {Room::HALF, Room::EIGHTEENTH}) {
    const std::vector<Point> points{Point(0, 0), Point(1, 2), Point(3, -1e308)};
    try {
      const Word_map<Point> map(points, room);
      FAIL("not refused");
    } catch (const CGAL::Quadtree_mesh_2::Point_error& error) {
      CHECK(std::size_t(error.point()) == 2);
      CHECK(pslg_test::has_text(error.reason(), "2^999"));
    }
  }
}

} // namespace test_word_map
