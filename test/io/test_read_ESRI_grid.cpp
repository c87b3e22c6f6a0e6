// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "mutate_text.h"
#include "scratch_folder.h"

#include <CGAL/IO/read_ESRI_grid.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_read_ESRI_grid {

namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

CGAL::Grid_sizing_field_2 read(const std::string& text) {
  std::istringstream in(text);
  return CGAL::IO::read_ESRI_grid(in, "file");
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const CGAL::Pslg_error_2& e) {
    return e.what();
  }
  return "";
}

const std::string header = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\nNODATA_value -1\n";

/// Whether the grid is that of the header with sizes 1 2 3 in the north, 4 none 6 in the south.
bool is_expected(const CGAL::Grid_sizing_field_2& grid) {
  return grid(11, 23) == 1 && grid(13, 23) == 2 && grid(15, 23) == 3 && grid(11, 21) == 4 &&
         grid(13, 21) == no_bound && grid(15, 21) == 6;
}

} // namespace

TEST_CASE("ESRI grids of many kinds", "[ESRI_grid]") {
  CHECK(is_expected(read(header + "1 2 3\n4 -1 6\n")));
  CHECK(is_expected(read(header + "1 2\n3 4 -1\n\n6"))); // in lines of any length
  CHECK(is_expected(read(header + " 1.0 2e0 +3\r\n4 NaN 6\r\n")));
  CHECK(is_expected(
      read("NROWS 2\r\nNCOLS 3\r\nXLLCENTER 11\r\nYLLCENTER 21\r\nCELLSIZE 2\r\n1 2 3\r\n4 -9999.0 6")));
  CHECK(is_expected(
      read("ncols 3\nnrows 2\nxllcorner 10\nyllcenter 21\ndx 2\ndy 2\nnodata_value nan\n1 2 3 4 nan 6")));
  CHECK(is_expected(read("ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\n"
                         "NODATA_value -3.4028234663852886e+38\n1 2 3 4 -3.40282346638529e+38 6\n")));
  CHECK(is_expected(
      read("ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\nNODATA_value 0\n1 2 3 4 0 6")));
  const auto oblong = read("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ndx 1\ndy 4\n1 2 3 4");
  CHECK(oblong(0.5, 2) == 3);
  CHECK(oblong(1.5, 6) == 2);
  CHECK(oblong(1, 4) == Approx(2.5));
  const auto one = read("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n7");
  CHECK(one(-5, 100) == 7);
  const auto none = read("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n-9999");
  CHECK(none(-5, 100) == no_bound);
  const Scratch_folder folder;
  CHECK(is_expected(CGAL::IO::read_ESRI_grid(folder.write("sizes.asc", header + "1 2 3 4 -1 6"))));
}

TEST_CASE("Errors of ESRI grids name line and value", "[ESRI_grid]") {
  const std::string h = header, short_header = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\n";
  for (const auto& [text, culprit] : std::vector<std::pair<std::string, std::string>>{
           {"", "file:1: the file ends where a keyword or a size is expected"},
           {h, "file:6: the file ends where a keyword or a size is expected"},
           {h + "1 2 3\n4 5\n", "file:8: the file ends where size 6 is expected"},
           {h + "1 2", "file:7: the file is too short"},
           {h + "1 2 3\n4 5 6\n7\n", "file:9: '7' is behind"},
           {h + "1 2 3\n4 0 6\n", "file:8: size 5: '0' is not above 0"},
           {h + "1 2 3\n4 -9999 6\n", "file:8: size 5: '-9999' is not above 0"},
           {h + "1 2 3\n4 x 6\n", "file:8: size 5: 'x' is not a number"},
           {h + "1 2 3\n4 0,5 6\n", "file:8: size 5: '0,5' is not a number"},
           {h + "1 2 3\n4 inf 6\n", "file:8: size 5: 'inf' is not finite"},
           {h + "1 2 3\n4 1e999 6\n", "file:8: size 5: '1e999' is too large"},
           {h + "x 2 3 4 5 6\n", "file:7: 'x' is no keyword"},
           {"rows 2\n", "file:1: 'rows' is no keyword"},
           {"1 2 3\n4 5 6\n", "file:1: the header has no cellsize"},
           {short_header + "1 2 3 4 5 6", "file:5: the header has no cellsize"},
           {"ncols 3\nnrows 2\nyllcorner 1\ncellsize 1\n1 2 3 4 5 6", "file:5: the header has no xllcorner"},
           {"ncols 3\nxllcorner 1\nyllcorner 1\ncellsize 1\n1 2 3", "file:5: the header has no nrows"},
           {short_header + "xllcenter 1\ncellsize 1\n1 2 3 4 5 6", "xllcorner and xllcenter"},
           {short_header + "dx 1\ncellsize 1\n1 2 3 4 5 6", "cellsize and dx"},
           {short_header + "dx 1\n1 2 3 4 5 6", "no cellsize"},
           {short_header + "cellsize 0\n1 2 3 4 5 6", "file:5: cellsize is not above 0"},
           {short_header + "cellsize\n1 2 3 4 5 6", "file:5: the line ends where cellsize is expected"},
           {short_header + "ncols 3\n", "file:5: ncols is there twice"},
           {"ncols 0\n", "file:1: ncols is not above 0"},
           {"ncols -4\n", "file:1: ncols is not above 0"},
           {"ncols 2.5\n", "file:1: ncols: '2.5' is not an integer"},
           {"ncols 99999999999\n", "file:1: ncols: '99999999999' is too large"},
           {"ncols 3 4\n", "file:1: '4' is behind the value of ncols"},
           {"ncols 2147483647\nnrows 2147483647\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n",
            "file:6: the file is too short"}}) {
    CAPTURE(text, culprit, error_of(text));
    CHECK(error_of(text).find(culprit) != std::string::npos);
    CHECK(error_of(text).compare(0, 5, "file:") == 0);
  }
  CHECK_THROWS_AS(CGAL::IO::read_ESRI_grid("/nowhere/sizes.asc"), CGAL::Pslg_error_2);
}

TEST_CASE("Damaged ESRI grids are read or refused", "[ESRI_grid]") {
  const std::string whole = header + "1 2 3\n4 -1 6\n";
  for (std::size_t end = 0; end < whole.size(); ++end) error_of(whole.substr(0, end));
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const std::string error = error_of(Text_mutator(seed)(whole));
    if (!error.empty() && error.compare(0, 5, "file:") != 0) FAIL_CHECK(error);
  }
}

} // namespace test_read_ESRI_grid
