// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_XY_H
#define CGAL_IO_READ_XY_H

#include <CGAL/Quadtree_mesh_2/internal/io/Line_scanner.h>
#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>
#include <CGAL/Quadtree_mesh_2/internal/io/read_whole_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reads points from text with one point per line, as spreadsheets and scripts write it. Takes linear time.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Reads rows of `N` numbers. The numbers have names, which a header may use.
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
  /// What divides a line besides blanks. With a semicolon, a comma belongs to a number and is an error there.
  static std::string_view separators_of(std::string_view line) {
    for (const char* const separator : {";", ","})
      if (Line_scanner::find_unquoted(line, *separator) != std::string_view::npos) return separator;
    return "";
  }

  Row read_row(std::size_t last) {
    Row row;
    const std::string_view separators = separators_of(scanner_.rest_of_line());
    scanner_.set_separators(separators);
    for (std::size_t column = 0; column <= last; ++column) {
      const std::size_t i =
          static_cast<std::size_t>(std::find(place_.begin(), place_.end(), column) - place_.begin());
      if (i < N)
        row[i] = scanner_.template read<double>({columns_[i]});
      else
        scanner_.skip_column();
      if (!separators.empty()) pass_separator(separators);
    }
    return row;
  }
  /// The last column need not have one.
  void pass_separator(std::string_view separators) {
    if (!scanner_.has_more_columns()) return;
    if (scanner_.separator_ahead() == '\0')
      scanner_.fail(in_quotes(separators) + " is expected before " +
                    in_quotes(scanner_.word_ahead({"a column"})));
    scanner_.pass_separator();
  }

  /// The columns of a header, in lower case and without quotes.
  static std::vector<std::string> split(std::string_view line) {
    const std::string_view separators = separators_of(line);
    std::vector<std::string> columns(1);
    bool is_quoted = false;
    for (const char c : line) {
      const bool is_blank = std::isspace(static_cast<unsigned char>(c)) != 0;
      if (c == '"')
        is_quoted = !is_quoted;
      else if (!is_quoted && (separators.find(c) != std::string_view::npos ||
                              (is_blank && separators.empty() && !columns.back().empty())))
        columns.emplace_back();
      else if (!is_blank)
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

  /// The columns with the names if all of them exist, otherwise the first columns.
  /// \throws Pslg_error_2 if two columns have a name
  void find_columns(const std::vector<std::string>& header) {
    std::array<std::size_t, N> found;
    for (std::size_t i = 0; i < N; ++i) {
      const auto column = std::find(header.begin(), header.end(), columns_[i]);
      if (column == header.end()) return;
      if (std::find(column + 1, header.end(), columns_[i]) != header.end())
        fail(std::string("two columns are called ") + columns_[i]);
      found[i] = static_cast<std::size_t>(column - header.begin());
    }
    place_ = found;
  }

  Line_scanner scanner_;
  std::array<const char*, N> columns_; ///< the names of the columns
  std::array<std::size_t, N> place_;   ///< their positions in a line
};

template <class Point>
std::vector<Point> parse_points(const std::string& text, const std::string& name) {
  std::vector<Point> points;
  Table_parser<2>(text, name, {"x", "y"}).read_all([&](const std::array<double, 2>& row) {
    points.emplace_back(row[0], row[1]);
  });
  return points;
}

/// Points and their sizes.
template <class Point>
std::pair<std::vector<Point>, std::vector<double>> parse_sized_points(const std::string& text,
                                                                      const std::string& name) {
  std::pair<std::vector<Point>, std::vector<double>> result;
  Table_parser<3> parser(text, name, {"x", "y", "size"});
  parser.read_all([&](const std::array<double, 3>& row) {
    if (!(row[2] > 0)) parser.fail("the size is not above 0");
    result.first.emplace_back(row[0], row[1]);
    result.second.push_back(row[2]);
  });
  return result;
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Reads points from text, also from text compressed by gzip. Each line has one point: `x y`, `x,y` or `x;y`.
///
/// A first line without a number is a header. If it has columns `x` and `y` (or `X` and `Y`) anywhere, these
/// are read, otherwise the first two. Further columns are ignored, and may be text in double quotes. Empty
/// lines and anything after a `#` are ignored, too. Coordinates are the doubles nearest to the decimals.
/// \throws Pslg_error_2 with file and line if the file is missing, or a coordinate is missing, not a number
/// or not finite; `points` is then unchanged.
/// \tparam Point can be made from two doubles.
template <class Point>
void read_XY(const std::string& file_name, std::vector<Point>& points) {
  namespace internal = Quadtree_mesh_2::internal;
  points = internal::parse_points<Point>(internal::read_whole_file(file_name), file_name);
}

/// The same from a stream.
/// \throws Pslg_error_2 as above, with `name` for the name of the file.
template <class Point>
void read_XY(std::istream& in, std::vector<Point>& points, const std::string& name = "input") {
  namespace internal = Quadtree_mesh_2::internal;
  points = internal::parse_points<Point>(internal::read_whole_stream(in, name), name);
}

/// Reads points with a positive size each: the third column, or the one called `size`.
/// \throws Pslg_error_2 as above, and if a size is not positive.
template <class Point>
void read_XY(const std::string& file_name, std::vector<Point>& points, std::vector<double>& sizes) {
  namespace internal = Quadtree_mesh_2::internal;
  auto read = internal::parse_sized_points<Point>(internal::read_whole_file(file_name), file_name);
  points = std::move(read.first);
  sizes = std::move(read.second);
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_XY_H
