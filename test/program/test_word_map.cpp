// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The program's map between doubles and 64-bit words, at the ends of its range.

#include "catch.h"
#include "pslg_test_tools.h"

#include "Word_map.h"

#include <string>
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

TEST_CASE("Coordinates too large for words are refused by vertex and limit", "[fixed]") {
  for (const Room room : {Room::HALF, Room::EIGHTEENTH}) {
    const std::vector<Point> points{Point(0, 0), Point(1, 2), Point(3, -1e308)};
    const std::string error = pslg_test::error_of([&] { Word_map<Point>(points, room); });
    CHECK(pslg_test::has_text(error, "point 2 "));
    CHECK(pslg_test::has_text(error, "2^999"));
  }
}

} // namespace test_word_map
