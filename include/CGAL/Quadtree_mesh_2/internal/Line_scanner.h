// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_LINE_SCANNER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_LINE_SCANNER_H

#include <CGAL/Quality_mesh_report_2.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What a number in a file stands for, to say so if it is wrong: "x of vertex 17". No text is made before
/// that.
struct Column_name {
  const char* text;
  std::size_t record = no_record;
  static constexpr std::size_t no_record = static_cast<std::size_t>(-1);

  std::string to_string() const {
    return record == no_record ? std::string(text) : text + (' ' + std::to_string(record));
  }
};

/// Reads numbers from lines of text. A line that is blank or all comment (`#` to its end) is passed over.
///
/// Every error is a `Pslg_error_2` that begins "name:line: ". Linear in the text; independent of the locale.
class Line_scanner {
public:
  /// \param text has to outlive the scanner.
  Line_scanner(std::string_view text, std::string name)
      : name_(std::move(name)), next_line_(text.data()), end_(text.data() + text.size()),
        position_(next_line_), line_end_(next_line_) {}

  /// Goes to the next line that holds something, if there is one.
  bool try_next_line() {
    while (next_line_ != end_) {
      const std::size_t left = static_cast<std::size_t>(end_ - next_line_);
      const void* newline = std::memchr(next_line_, '\n', left);
      position_ = next_line_;
      line_end_ = newline ? static_cast<const char*>(newline) : end_;
      next_line_ = newline ? line_end_ + 1 : end_;
      ++line_number_;
      if (has_more_columns()) return true;
    }
    return false;
  }

  /// Goes to the next line that holds something, which is about to be read as `expected`.
  void next_line(Column_name expected) {
    if (!try_next_line()) fail("the file ends where " + expected.to_string() + " is expected");
  }

  bool has_more_columns() {
    while (position_ != line_end_ && is_blank(*position_)) ++position_;
    return position_ != line_end_ && *position_ != '#';
  }

  /// The next number of the line: an integer where `Number` is integral, else a finite double.
  template <class Number>
  Number read(Column_name column) {
    if (!has_more_columns()) fail("the line ends where " + column.to_string() + " is expected");
    // std::from_chars knows no leading plus.
    const bool has_plus = *position_ == '+' && position_ + 1 != line_end_ && position_[1] != '-';
    Number value{};
    const std::from_chars_result result = std::from_chars(position_ + (has_plus ? 1 : 0), line_end_, value);
    check(result, is_finite(value), std::is_integral_v<Number>, column);
    position_ = result.ptr;
    return value;
  }

  /// From now on columns end with this character, which is no blank, or with blanks if it is one.
  void set_separator(char separator) { separator_ = separator; }
  /// Goes behind the separator at the end of a column, if there is one.
  void pass_separator() {
    if (separator_ == ' ' || !has_more_columns()) return;
    if (*position_ != separator_)
      fail(std::string("a '") + separator_ + "' is expected before '" + *position_ + '\'');
    ++position_;
  }
  /// Passes over a column, whatever is in it.
  void skip_column() {
    if (has_more_columns())
      while (!(separator_ == ' ' ? is_end_of_column(position_) : is_end_of_line_or_separator(position_)))
        ++position_;
  }
  /// What is left of the line, without a comment.
  std::string_view rest_of_line() const {
    const std::string_view rest(position_, static_cast<std::size_t>(line_end_ - position_));
    return rest.substr(0, rest.find('#'));
  }

  /// As Triangle does, ignores columns behind those that have a meaning; unlike Triangle, not if they are no
  /// numbers.
  void skip_more_columns(Column_name column) {
    while (has_more_columns()) read<double>(column);
  }

  /// Characters not read yet: bounds how many records can follow, whatever a header claims.
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - position_); }

  [[noreturn]] void fail(const std::string& what) const {
    throw Pslg_error_2(name_ + ':' + std::to_string(line_number_) + ": " + what);
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

  template <class Number>
  static bool is_finite(Number value) {
    if constexpr (std::is_floating_point_v<Number>) return std::isfinite(value);
    return true;
  }

  bool is_end_of_column(const char* p) const { return is_end_of_line_or_separator(p) || is_blank(*p); }
  bool is_end_of_line_or_separator(const char* p) const {
    return p == line_end_ || *p == '#' || *p == separator_;
  }

  void check(std::from_chars_result result, bool is_finite, bool is_integral, Column_name column) const {
    if (result.ec == std::errc() && is_finite && is_end_of_column(result.ptr)) return;
    const char* column_end = position_;
    while (!is_end_of_column(column_end)) ++column_end;
    const std::string culprit = column.to_string() + ": '" + std::string(position_, column_end) + "' is ";
    if (result.ec == std::errc::invalid_argument || !is_end_of_column(result.ptr))
      fail(culprit + (is_integral ? "not an integer" : "not a number"));
    if (!is_finite) fail(culprit + "not finite");
    fail(culprit + "too large" + (is_integral ? "" : " or too small"));
  }

  std::string name_;
  const char* next_line_;
  const char* end_;
  const char* position_;
  const char* line_end_;
  std::size_t line_number_ = 0;
  char separator_ = ' ';
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_LINE_SCANNER_H
