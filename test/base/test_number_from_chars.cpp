// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Doubles from text without the standard library's std::from_chars(), against it: the same bits, the same end and the
// same error.

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/base/number_from_chars.h>

#include <charconv>
#include <clocale>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>

#ifdef __cpp_lib_to_chars

namespace test_number_from_chars {

using CGAL::Quadtree_mesh_2::internal::decimal_from_chars;

namespace {

void check(const std::string& text) {
  CAPTURE(text);
  const char* const end = text.data() + text.size();
  double expected = 7, value = 7;
  const auto result = std::from_chars(text.data(), end, expected),
             ours = decimal_from_chars(text.data(), end, value);
  REQUIRE(ours.ec == result.ec);
  REQUIRE(ours.ptr == result.ptr);
  REQUIRE(std::memcmp(&value, &expected, sizeof value) == 0);
}

} // namespace

TEST_CASE("Doubles are read from text of all kinds", "[numbers]") {
  for (const char* text : {"",
                           "-",
                           "+1",
                           ".",
                           "-.",
                           ".5",
                           "5.",
                           "-.5e3",
                           "1e",
                           "1e+",
                           "1e5",
                           "1E-5",
                           "1e+05x",
                           "1.5.2",
                           "1,5",
                           "0x10",
                           "e5",
                           "0",
                           "-0",
                           "0.000",
                           "0e999",
                           "1e999",
                           "-1e999",
                           "1e-999",
                           "4.9e-324",
                           "2.4e-324",
                           "2.5e-324",
                           "1e-310",
                           "2.2250738585072011e-308",
                           "1.7976931348623157e308",
                           "1.7976931348623159e308",
                           "9007199254740993",
                           "0.1000000000000000055511151231257827021181583404541015625",
                           "--1",
                           "1 2",
                           "abc",
                           " 1"})
    check(text);
}

TEST_CASE("Doubles of all sizes are read from text", "[numbers]") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double v;
    std::memcpy(&v, &bits, sizeof v);
    if (v - v != 0) continue; // not finite
    char text[64];
    std::snprintf(text, sizeof text, i % 2 == 0 ? "%.17g" : "%.9e", v);
    check(text);
  }
}

TEST_CASE("The program's locale does not matter to text", "[numbers]") {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
    if (std::setlocale(LC_NUMERIC, name) == nullptr) continue;
    check("1.5");
    check("1,5");
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}

} // namespace test_number_from_chars

#endif
