// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Rasters that GDAL itself has written become grids of sizes.

#ifdef CGAL_LINKED_WITH_GDAL

#include "catch.h"
#include "gdal_files.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <CGAL/IO/read_ESRI_grid.h>
#include <CGAL/IO/read_GDAL_grid.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace test_read_GDAL_grid {

using namespace program_test;

namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();
using Transform = std::array<double, 6>;
constexpr Transform north_up{10, 2, 0, 24, 0, -2}; ///< the corner in the northwest, and cells of 2 x 2

/// \param sizes from the first row of the file on, three in a row
void write_raster(const std::string& file, std::vector<double> sizes, Transform transform = north_up,
                  GDALDataType type = GDT_Float64, double no_data = -1) {
  GDALAllRegister();
  const GDALDriverH driver = GDALGetDriverByName("GTiff");
  gdal_files::require(driver != nullptr);
  const int rows = static_cast<int>(sizes.size() / 3);
  const GDALDatasetH dataset = GDALCreate(driver, file.c_str(), 3, rows, 1, type, nullptr);
  gdal_files::require(dataset != nullptr);
  gdal_files::require(GDALSetGeoTransform(dataset, transform.data()) == CE_None);
  const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  gdal_files::require(GDALSetRasterNoDataValue(band, no_data) == CE_None);
  gdal_files::require(GDALRasterIO(band, GF_Write, 0, 0, 3, rows, sizes.data(), 3, rows, GDT_Float64, 0, 0) ==
                      CE_None);
  GDALClose(dataset);
}

/// Whether sizes are 1 2 3 in the north, 4 none 6 in the south, at the centers of cells.
bool is_expected(const CGAL::Grid_sizing_field_2& grid) {
  return grid(11, 23) == 1 && grid(13, 23) == 2 && grid(15, 23) == 3 && grid(11, 21) == 4 &&
         grid(13, 21) == no_bound && grid(15, 21) == 6;
}

std::string error_of(const std::string& file) {
  try {
    CGAL::IO::read_GDAL_grid(file);
  } catch (const CGAL::Pslg_error_2& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("rasters of GDAL become sizes", "[GDAL_grid]") {
  const Scratch_folder folder;
  const std::string file = folder.file("sizes.tif");
  const auto read = [&](const auto&... arguments) {
    write_raster(file, arguments...);
    return CGAL::IO::read_GDAL_grid(file);
  };
  const std::vector<double> sizes{1, 2, 3, 4, -1, 6};
  CHECK(is_expected(read(sizes)));
  CHECK(is_expected(read(sizes, north_up, GDT_Int16)));
  CHECK(is_expected(
      read(std::vector<double>{4, -1, 6, 1, 2, 3}, Transform{10, 2, 0, 20, 0, 2}))); // from the south
  CHECK(is_expected(
      read(std::vector<double>{3, 2, 1, 6, -1, 4}, Transform{16, -2, 0, 24, 0, -2}))); // from the east
  const double lowest = std::numeric_limits<float>::lowest();
  CHECK(is_expected(read(std::vector<double>{1, 2, 3, 4, lowest, 6}, north_up, GDT_Float32, lowest)));
  CHECK(is_expected(read(std::vector<double>{1, 2, 3, 4, std::nan(""), 6})));
}

TEST_CASE("GDAL and our reader give the same sizes of a grid of ESRI", "[GDAL_grid]") {
  const Scratch_folder folder;
  const std::string file = folder.write("a.asc", "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\n"
                                                 "NODATA_value -9999\n1 2.5 3\n4 -9999 6\n");
  const auto by_gdal = CGAL::IO::read_GDAL_grid(file), ours = CGAL::IO::read_ESRI_grid(file);
  for (double x = 9; x < 18; x += 0.37)
    for (double y = 19; y < 26; y += 0.41) CHECK(by_gdal(x, y) == ours(x, y));
}

TEST_CASE("errors of rasters of GDAL", "[GDAL_grid]") {
  const Scratch_folder folder;
  const std::string file = folder.file("sizes.tif");
  write_raster(file, {1, 2, 3, 4, 0, 6});
  CHECK(contains(error_of(file), "sizes.tif: the size in row 1, column 1, is 0, and has to be above 0"));
  write_raster(file, {1, 2, -3, 4, 5, 6});
  CHECK(contains(error_of(file), "row 0, column 2, is -3"));
  write_raster(file, {1, 2, 3, 4, 5, 6}, {10, 2, 0.5, 24, 0.5, -2});
  CHECK(contains(error_of(file), "turned against the axes"));
  CHECK(contains(error_of(folder.file("none.tif")), "none.tif: cannot be opened"));
  CHECK(contains(error_of(folder.write("text.tif", "no raster")), "text.tif: cannot be opened"));
  write_raster(file, std::vector<double>(3000, 1));
  const std::string whole = content(file);
  folder.write("sizes.tif", whole.substr(0, whole.size() / 2));
  CHECK(contains(error_of(file), "sizes.tif"));
}

#ifdef QUADTREE_MESH_PROGRAM
TEST_CASE("the program takes sizes from a raster", "[GDAL_grid][program]") {
  const Scratch_folder folder;
  write_raster(folder.file("sizes.tif"), {0.05, 0.05, 0.2, 0.05, -1, 0.2}, {0, 1. / 3, 0, 1, 0, -0.5});
  folder.write("sizes.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ndx 0.33333333333333331\ndy 0.5\n"
                            "NODATA_value -1\n0.05 0.05 0.2\n0.05 -1 0.2\n");
  const auto off = [&](const char* sizes) {
    const Run r = run(test_data("syn_square.poly") + " --size-grid " + folder.file(sizes) +
                      " -o - --output-format off");
    CAPTURE(r.err);
    CHECK(r.status == 0);
    return r.out;
  };
  CHECK(off("sizes.tif").size() > 3000);
  CHECK(off("sizes.tif") == off("sizes.asc"));
  const Run bad = run(test_data("syn_square.poly") + " --size-grid " + folder.file("none.tif"));
  CHECK(bad.status == 2);
  CHECK(contains(bad.err, "none.tif: cannot be opened"));
}
#endif

} // namespace test_read_GDAL_grid

#endif // CGAL_LINKED_WITH_GDAL
