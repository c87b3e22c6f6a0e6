// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_XY_H
#define CGAL_IO_READ_XY_H

#include <CGAL/Quadtree_mesh_2/internal/Line_scanner.h>
#include <CGAL/Quadtree_mesh_2/internal/read_whole_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reads points from text with one point a line, as spreadsheets and scripts write it. Linear.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Reads rows of `N` numbers that have names, which a header may use.
template <std::size_t N>
class Table_parser {
public:
  using Row = std::array<double, N>;

  Table_parser(std::string_view text, const std::string& name, const std::array<const char*, N>& columns)
      : scanner_(text, name), columns_(columns) {
    for (std::size_t i = 0; i < N; ++i) place_[i] = i;
  }

  /// Calls `take(row)` for each row.
  template <class Take>
  void read_all(Take take) {
    if (!scanner_.try_next_line()) return;
    if (is_header(scanner_.rest_of_line())) {
      find_columns(split(scanner_.rest_of_line()));
      if (!scanner_.try_next_line()) return;
    }
    const std::size_t last = *std::max_element(place_.begin(), place_.end());
    do take(read_row(last));
    while (scanner_.try_next_line());
  }

  /// Beyond its numbers: what is wrong with the row that was read last.
  [[noreturn]] void fail(const std::string& what) const { scanner_.fail(what); }

private:
  /// What divides a line; with a semicolon the comma is left for numbers, and an error there.
  static char separator_of(std::string_view line) {
    for (const char c : {';', ','})
      if (line.find(c) != std::string_view::npos) return c;
    return ' ';
  }

  Row read_row(std::size_t last) {
    Row row;
    scanner_.set_separator(separator_of(scanner_.rest_of_line()));
    for (std::size_t column = 0; column <= last; ++column) {
      const std::size_t i =
          static_cast<std::size_t>(std::find(place_.begin(), place_.end(), column) - place_.begin());
      if (i < N)
        row[i] = scanner_.template read<double>({columns_[i]});
      else
        scanner_.skip_column();
      scanner_.pass_separator();
    }
    return row;
  }

  /// The columns of a header, in small letters and without quotes.
  static std::vector<std::string> split(std::string_view line) {
    const char separator = separator_of(line);
    std::vector<std::string> columns(1);
    for (const char c : line) {
      const bool is_blank = std::isspace(static_cast<unsigned char>(c)) != 0;
      if (c == separator || (is_blank && separator == ' ' && !columns.back().empty()))
        columns.emplace_back();
      else if (!is_blank && c != '"')
        columns.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return columns;
  }

  /// A line without anything that looks like a number, not even "nan".
  static bool is_header(std::string_view line) {
    const std::vector<std::string> columns = split(line);
    return std::none_of(columns.begin(), columns.end(), [](const std::string& c) {
      return c.find_first_of("0123456789+-.") == 0 || c == "nan" || c == "inf" || c == "infinity";
    });
  }

  /// The columns that have the names, if all of them are there; else the first ones.
  void find_columns(const std::vector<std::string>& header) {
    std::array<std::size_t, N> found;
    for (std::size_t i = 0; i < N; ++i) {
      const auto column = std::find(header.begin(), header.end(), columns_[i]);
      if (column == header.end()) return;
      found[i] = static_cast<std::size_t>(column - header.begin());
    }
    place_ = found;
  }

  Line_scanner scanner_;
  std::array<const char*, N> columns_; ///< what they are called
  std::array<std::size_t, N> place_;   ///< and where they are in a line
};

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// Reads points from text, or from text compressed by gzip: one point a line, `x y`, `x,y` or `x;y`.
///
/// The first line may be a header: one with no number in it. If it has columns `x` and `y` (or `X` and `Y`), wherever,
/// these are read, else the first two. Further columns are not looked at, empty lines and what follows a `#` neither.
/// Coordinates are the doubles nearest to the decimals.
/// \throws Pslg_error_2 with file and line if the file is missing or a coordinate is missing, not a number or not
/// finite; `points` is then as it was.
/// \tparam Point can be made from two doubles.
template <class Point>
void read_XY(const std::string& file_name, std::vector<Point>& points) {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string text = internal::read_whole_file(file_name);
  std::vector<Point> result;
  internal::Table_parser<2>(text, file_name, {"x", "y"}).read_all([&](const std::array<double, 2>& row) {
    result.emplace_back(row[0], row[1]);
  });
  points = std::move(result);
}

/// Reads points with a size each, which is positive: the third column, or the one called `size`.
/// \throws Pslg_error_2 as above, and if a size is not above 0.
template <class Point>
void read_XY(const std::string& file_name, std::vector<Point>& points, std::vector<double>& sizes) {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string text = internal::read_whole_file(file_name);
  std::vector<Point> result;
  std::vector<double> result_sizes;
  internal::Table_parser<3> parser(text, file_name, {"x", "y", "size"});
  parser.read_all([&](const std::array<double, 3>& row) {
    if (!(row[2] > 0)) parser.fail("the size is not above 0");
    result.emplace_back(row[0], row[1]);
    result_sizes.push_back(row[2]);
  });
  points = std::move(result);
  sizes = std::move(result_sizes);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_XY_H
