// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The inputs of the benchmark: a comparison on graphs that are not planar would say nothing.

#include "catch.h"

#include "pslg_inputs.h"

#include <CGAL/find_pslg_defects.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_pslg_inputs {

namespace {

std::size_t defects(const pslg_inputs::Pslg& pslg) {
  const auto found = CGAL::find_pslg_defects(pslg);
  for (std::size_t i = 0; i < found.size() && i < 3; ++i) UNSCOPED_INFO(found[i].to_string());
  return found.size();
}

} // namespace

TEST_CASE("Inputs of the benchmark have no defects", "[benchmark]") {
  const std::string large = is_full_run() ? "1e5" : "1e3";
  for (const auto& family : pslg_inputs::all()) {
    std::vector<std::string> sizes{"1", "60", large};
    if (family.size == pslg_inputs::Size::MEASURE) sizes = {"1e-4", "0.1", "1"};
    if (family.name == "fan") sizes = {"0.1", "1", "7"}; // 1e-4 would be millions of spokes
    for (const std::string& size : sizes) {
      const std::string name = family.name + ':' + size;
      CAPTURE(name);
      CHECK(defects(pslg_inputs::by_name(name).pslg) == 0);
    }
  }
}

TEST_CASE("Inputs of the benchmark have the size they are asked for", "[benchmark]") {
  for (const auto& family : pslg_inputs::all()) {
    if (family.size != pslg_inputs::Size::VERTICES) continue;
    for (const double n : {1000.0, 20000.0}) {
      CAPTURE(family.name, n);
      const double vertices = double(family.make(n).number_of_vertices());
      CHECK(vertices > 0.9 * n);
      CHECK(vertices < 1.2 * n + 20);
    }
  }
  CHECK(pslg_inputs::by_name("fan:0.1").pslg.number_of_segments() == 3604);
  CHECK(pslg_inputs::by_name("segments:1e3").pslg.number_of_segments() == 1004);
  CHECK(pslg_inputs::by_name("square:1e-3").max_area == 1e-3);
  CHECK(pslg_inputs::by_name("holes:7").pslg.holes.size() == 7);
}

TEST_CASE("Inputs of the benchmark are the same every time", "[benchmark]") {
  for (const char* name : {"coast:5000", "segments:500", "stars:1000"}) {
    const auto a = pslg_inputs::by_name(name).pslg, b = pslg_inputs::by_name(name).pslg;
    CHECK(a.vertices == b.vertices);
    CHECK(a.segments == b.segments);
  }
}

TEST_CASE("Names of inputs that make no sense are refused", "[benchmark]") {
  for (const char* name : {"coast", "coast:", "coast:x", "coast:-1", "coast:1e5x", "coast:nan", "cost:10"})
    CHECK_THROWS_AS(pslg_inputs::by_name(name), std::invalid_argument);
  CHECK(pslg_inputs::is_name("coast:10"));
  CHECK(!pslg_inputs::is_name("coast.poly"));
  CHECK(!pslg_inputs::is_name("coast"));
}

} // namespace test_pslg_inputs
