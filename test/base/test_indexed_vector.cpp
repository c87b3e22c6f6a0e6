// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_indexed_vector {

namespace {

using CGAL::Quadtree_mesh_2::internal::Id_range;
using CGAL::Quadtree_mesh_2::internal::Indexed_vector;

using Animal_id = CGAL::Quadtree_mesh_2::Index<struct Animal_tag>;
using Plant_id = CGAL::Quadtree_mesh_2::Index<struct Plant_tag>;
using Animals = Indexed_vector<Animal_id, std::string>;

template <class Id, class = void>
struct Has_lookup_by : std::false_type {};
template <class Id>
struct Has_lookup_by<Id, std::void_t<decltype(std::declval<Animals&>()[std::declval<Id>()])>>
    : std::true_type {};

} // namespace

TEST_CASE("Vectors with handles are looked up by their own handles alone", "[base]") {
  CHECK(Has_lookup_by<Animal_id>::value);
  CHECK_FALSE(Has_lookup_by<Plant_id>::value);
  CHECK_FALSE(Has_lookup_by<int>::value);
  CHECK_FALSE(Has_lookup_by<std::size_t>::value);
}

TEST_CASE("Handles are those of the values in order", "[base]") {
  Animals animals;
  CHECK(animals.end_id() == Animal_id(0));
  const Animal_id ant = animals.add("ant"), bee = animals.add("bee");
  CHECK(ant == Animal_id(0));
  CHECK(bee == Animal_id(1));
  CHECK(animals.end_id() == Animal_id(2));
  animals[bee] = "bear";
  CHECK(std::as_const(animals)[bee] == "bear");
  CHECK(animals.has(bee));
  CHECK_FALSE(animals.has(animals.end_id()));
  CHECK_FALSE(animals.has(Animal_id()));

  std::vector<std::string> all;
  for (const Animal_id i : animals.ids()) all.push_back(animals[i]);
  CHECK(all == animals.values());
  animals.truncate(bee);
  CHECK(animals.values() == std::vector<std::string>{"ant"});
}

TEST_CASE("Room is made for handles beyond the last one", "[base]") {
  Indexed_vector<Plant_id, char> is_evergreen;
  is_evergreen.make_room_for(Plant_id(100), 7);
  REQUIRE(is_evergreen.has(Plant_id(100)));
  CHECK(is_evergreen[Plant_id(100)] == 7);
  is_evergreen[Plant_id(3)] = 1;
  is_evergreen.make_room_for(Plant_id(3), 0);
  CHECK(is_evergreen[Plant_id(3)] == 1);
}

TEST_CASE("Ranges of handles may be empty, and begin anywhere", "[base]") {
  int sum = 0;
  for (const Plant_id i : Id_range<Plant_id>(std::size_t(4), std::size_t(7)))
    sum += static_cast<int>(i.value());
  CHECK(sum == 4 + 5 + 6);
  for (const Plant_id i : Indexed_vector<Plant_id, int>().ids()) FAIL("there is no plant " << i);
}

} // namespace test_indexed_vector
