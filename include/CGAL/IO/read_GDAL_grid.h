// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_GDAL_GRID_H
#define CGAL_IO_READ_GDAL_GRID_H

/// \file
/// Sizes from GeoTIFF and all other rasters that GDAL reads. Programs that include this header link GDAL
/// (`libgdal-dev`).

#include <CGAL/Grid_sizing_field_2.h>
#include <CGAL/Quadtree_mesh_2/internal/gis/Gdal_dataset.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>

#include <gdal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The first band of a raster whose rows and columns run along the axes.
class Gdal_grid_reader {
public:
  explicit Gdal_grid_reader(const std::string& file_name) : dataset_(file_name, GDAL_OF_RASTER) {}

  Grid_sizing_field_2 read() {
    columns_ = GDALGetRasterXSize(dataset_.handle()), rows_ = GDALGetRasterYSize(dataset_.handle());
    if (columns_ < 1 || rows_ < 1 || GDALGetRasterCount(dataset_.handle()) < 1)
      dataset_.fail("there is no raster in it");
    find_place();
    read_sizes();
    return Grid_sizing_field_2(origin_, spacing_, std::size_t(columns_), std::size_t(rows_),
                               std::move(sizes_));
  }

private:
  /// Sizes are those at the centers of cells.
  void find_place() {
    std::array<double, 6> t{};
    if (GDALGetGeoTransform(dataset_.handle(), t.data()) != CE_None)
      dataset_.fail("it does not say where its cells are");
    if (t[2] != 0 || t[4] != 0) dataset_.fail("its rows and columns are turned against the axes");
    for (const double number : t)
      if (!std::isfinite(number)) dataset_.fail("where its cells are is not finite");
    if (!(std::abs(t[1]) > 0) || !(std::abs(t[5]) > 0)) dataset_.fail("its cells are flat");
    is_from_west_ = t[1] > 0, is_from_south_ = t[5] > 0;
    spacing_ = {std::abs(t[1]), std::abs(t[5])};
    origin_ = {t[0] + (is_from_west_ ? 0.5 : columns_ - 0.5) * t[1],
               t[3] + (is_from_south_ ? 0.5 : rows_ - 0.5) * t[5]};
  }

  /// From the southwest on, row by row.
  void read_sizes() {
    const GDALRasterBandH band = GDALGetRasterBand(dataset_.handle(), 1);
    int has_none = 0;
    const double none = GDALGetRasterNoDataValue(band, &has_none);
    sizes_.reserve(std::size_t(columns_) * std::size_t(rows_));
    std::vector<double> row(static_cast<std::size_t>(columns_));
    for (int j = 0; j < rows_; ++j) {
      const int line = is_from_south_ ? j : rows_ - 1 - j;
      if (GDALRasterIO(band, GF_Read, 0, line, columns_, 1, row.data(), columns_, 1, GDT_Float64, 0, 0) !=
          CE_None) {
        dataset_.check();
        dataset_.fail("row " + std::to_string(line) + " cannot be read");
      }
      if (!is_from_west_) std::reverse(row.begin(), row.end());
      for (std::size_t i = 0; i < row.size(); ++i)
        sizes_.push_back(size(row[i], has_none != 0, none, line, i));
    }
  }

  /// Infinite where there is no bound.
  double size(double value, bool has_none, double none, int line, std::size_t i) const {
    constexpr double share = 1e-7; // files keep the value with different numbers of digits
    if (std::isnan(value) || (has_none && std::abs(value - none) <= share * std::abs(none)))
      return std::numeric_limits<double>::infinity();
    if (value > 0 && std::isfinite(value)) return value;
    std::string number;
    append_number(number, value);
    const std::size_t column = is_from_west_ ? i : std::size_t(columns_) - 1 - i;
    dataset_.fail("the size in row " + std::to_string(line) + ", column " + std::to_string(column) + ", is " +
                  number + ", and has to be above 0");
  }

  Gdal_dataset dataset_;
  int columns_ = 0, rows_ = 0;
  bool is_from_west_ = true, is_from_south_ = false;
  std::array<double, 2> origin_{}, spacing_{};
  std::vector<double> sizes_;
};

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Reads sizes from the first band of a raster, in any format that GDAL reads: GeoTIFF and others. They are lengths in
/// the unit of the raster's coordinates, at the centers of its cells. No data, and NaN, mean no bound around that
/// place. Scale and offset of the band are not applied.
/// \throws Pslg_error_2 with the file, and the row and column, both from 0 on, if the file is missing, damaged or of no
///         format that is known, if it does not say where its cells are or they are turned, or if a size is not above
///         0.
inline Grid_sizing_field_2 read_GDAL_grid(const std::string& file_name) {
  return Quadtree_mesh_2::internal::Gdal_grid_reader(file_name).read();
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_GDAL_GRID_H
