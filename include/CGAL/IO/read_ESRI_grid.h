// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_ESRI_GRID_H
#define CGAL_IO_READ_ESRI_GRID_H

#include <CGAL/Grid_sizing_field_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_scanner.h>
#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>
#include <CGAL/Quadtree_mesh_2/internal/io/read_whole_file.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <istream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reads sizes from an ASCII grid of ESRI (.asc), as ArcGIS, QGIS, GRASS and GDAL write it. Takes linear time.
// Source: ESRI, "ESRI ASCII Raster format", ArcGIS help; GDAL's driver AAIGrid for dx, dy and NaN.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Esri_grid_parser {
public:
  Esri_grid_parser(std::string_view text, const std::string& name) : scanner_(text, name) {}

  Grid_sizing_field_2 read() {
    read_header();
    const std::array<double, 2> spacing{spacing_of(0), spacing_of(1)};
    const std::array<double, 2> origin{first_place(0, spacing[0]), first_place(1, spacing[1])};
    const std::size_t columns = count(NCOLS), rows = count(NROWS);
    // A size takes a character: so no header makes room for more than the file can hold.
    if (columns > scanner_.remaining() / rows)
      scanner_.fail("the file is too short for ncols times nrows sizes");
    return Grid_sizing_field_2(origin, spacing, columns, rows, read_sizes(columns, rows));
  }

private:
  enum Key { NCOLS, NROWS, XLLCORNER, YLLCORNER, XLLCENTER, YLLCENTER, CELLSIZE, DX, DY, NODATA_VALUE, KEYS };
  static constexpr std::array<const char*, KEYS> names{"ncols",     "nrows",       "xllcorner", "yllcorner",
                                                       "xllcenter", "yllcenter",   "cellsize",  "dx",
                                                       "dy",        "nodata_value"};

  static std::string lower_case(std::string_view word) {
    std::string result;
    for (const char c : word) result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
  }
  static bool is_nan(std::string_view word) {
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
    return lower_case(word) == "nan";
  }

  // ---- the header

  /// Goes to the first size.
  void read_header() {
    while (true) {
      scanner_.require_more({"a keyword or a size"});
      const std::string_view word = scanner_.word_ahead({"a keyword"});
      if (std::isalpha(static_cast<unsigned char>(word[0])) == 0 || is_nan(word)) return;
      read_entry(key_of(word));
    }
  }
  Key key_of(std::string_view word) const {
    const std::string name = lower_case(word);
    for (std::size_t key = 0; key < KEYS; ++key)
      if (names[key] == name) return static_cast<Key>(key);
    scanner_.fail(in_quotes(word) + " is no keyword of an ESRI grid");
  }
  void read_entry(Key key) {
    const Column_name name{names[key]};
    if (values_[key]) scanner_.fail(std::string(name.text) + " is there twice");
    scanner_.pass_word();
    const bool is_count = key == NCOLS || key == NROWS;
    if (key == NODATA_VALUE && is_nan(scanner_.word_ahead(name))) {
      values_[key] = std::numeric_limits<double>::quiet_NaN();
      scanner_.pass_word();
    } else
      values_[key] = is_count ? static_cast<double>(scanner_.read<int>(name)) : scanner_.read<double>(name);
    if ((is_count || key == CELLSIZE || key == DX || key == DY) && !(*values_[key] > 0))
      scanner_.fail(std::string(name.text) + " is not above 0");
    if (scanner_.has_more_columns())
      scanner_.fail(in_quotes(scanner_.word_ahead(name)) + " is behind the value of " + name.text);
  }

  /// What the header has, at the end of it.
  double value(Key key) const {
    if (!values_[key]) scanner_.fail(std::string("the header has no ") + names[key]);
    return *values_[key];
  }
  std::size_t count(Key key) const { return static_cast<std::size_t>(value(key)); }
  double spacing_of(std::size_t axis) const {
    const Key own = axis == 0 ? DX : DY;
    if (values_[CELLSIZE] && values_[own])
      scanner_.fail(std::string("the header has cellsize and ") + names[own]);
    return value(values_[own] ? own : CELLSIZE);
  }
  /// The center of the cell that is the first of its row or column.
  double first_place(std::size_t axis, double spacing) const {
    const Key corner = axis == 0 ? XLLCORNER : YLLCORNER, center = axis == 0 ? XLLCENTER : YLLCENTER;
    if (values_[corner] && values_[center])
      scanner_.fail(std::string("the header has ") + names[corner] + " and " + names[center]);
    const double place = values_[center] ? *values_[center] : value(corner) + spacing / 2;
    if (!std::isfinite(place)) scanner_.fail(std::string(names[corner]) + " is too large");
    return place;
  }

  // ---- sizes

  /// Rows of files go from north to south, ours from south to north.
  std::vector<double> read_sizes(std::size_t columns, std::size_t rows) {
    std::vector<double> sizes(columns * rows);
    for (std::size_t n = 0, j = rows; j-- > 0;)
      for (std::size_t i = 0; i < columns; ++i) sizes[j * columns + i] = read_size(++n);
    if (scanner_.has_more())
      scanner_.fail(in_quotes(scanner_.word_ahead({"a size"})) +
                    " is behind the last of ncols times nrows sizes");
    return sizes;
  }
  double read_size(std::size_t number) {
    const Column_name name{"size", number};
    constexpr double no_bound = std::numeric_limits<double>::infinity();
    scanner_.require_more(name);
    const std::string_view word = scanner_.word_ahead(name);
    if (is_nan(word)) return scanner_.pass_word(), no_bound;
    const double size = scanner_.read<double>(name);
    if (is_no_data(size)) return no_bound;
    if (!(size > 0)) scanner_.fail(name.to_string() + ": " + in_quotes(word) + " is not above 0");
    return size;
  }
  /// Programs write the value with different numbers of digits, above all that of the least float.
  bool is_no_data(double size) const {
    constexpr double usual = -9999, share = 1e-7;
    const double no_data = values_[NODATA_VALUE].value_or(usual);
    return std::fabs(size - no_data) <= share * std::fabs(no_data);
  }

  Line_scanner scanner_;
  std::array<std::optional<double>, KEYS> values_;
};

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Reads sizes from an ASCII grid of ESRI (`.asc`), also from one compressed by gzip, for
/// `Quality_mesh_options_2::size()`.
///
/// The header has a keyword and a number on each line, in any order and in lower or upper case: `ncols`,
/// `nrows`, `xllcorner` or `xllcenter`, `yllcorner` or `yllcenter`, `cellsize` (or `dx` and `dy`), and
/// `NODATA_value`, which is -9999 if not there. Then there are `ncols` times `nrows` sizes, from the
/// northwest on, row by row, in lines of any length. A size holds at the center of its cell. Where it is
/// `NODATA_value` (up to 10^-7 of it) or NaN, it becomes infinite: there is no bound around that place.
/// Sizes are lengths in the unit of the coordinates.
/// \throws Pslg_error_2 with file and line if the file is missing, an entry of the header is missing, there
/// twice or out of range, or a size is missing, not a number or not above 0.
inline Grid_sizing_field_2 read_ESRI_grid(const std::string& file_name) {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string text = internal::read_whole_file(file_name);
  return internal::Esri_grid_parser(text, file_name).read();
}

/// The same from a stream.
/// \throws Pslg_error_2 as above, with `name` for the name of the file.
inline Grid_sizing_field_2 read_ESRI_grid(std::istream& in, const std::string& name = "input") {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string text = internal::read_whole_stream(in, name);
  return internal::Esri_grid_parser(text, name).read();
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_ESRI_GRID_H
