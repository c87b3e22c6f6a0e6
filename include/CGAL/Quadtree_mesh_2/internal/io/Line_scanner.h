// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_LINE_SCANNER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_LINE_SCANNER_H

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/number_from_chars.h>
#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
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

/// Reads numbers and words from lines of text, which end with a line feed, a carriage return, or both. A line that is
/// blank or all comment (`#` to its end) is passed over.
///
/// Every error is a `Pslg_error_2` that begins "name:line: ". Linear in the text; independent of the locale.
class Line_scanner {
public:
  /// \param text has to outlive the scanner.
  /// \param lines_before how many lines of the file come before the text
  Line_scanner(std::string_view text, std::string name, std::size_t lines_before = 0)
      : name_(std::move(name)), text_(text), line_number_(lines_before) {}

  /// So many more lines of the file come before the text.
  void add_lines_before(std::size_t lines) { line_number_ += lines; }

  /// Goes to the next line that holds something, if there is one.
  bool try_next_line() {
    while (next_line_ != text_.size()) {
      position_ = next_line_;
      line_end_ = end_of_line(position_);
      next_line_ = behind_line(line_end_);
      ++line_number_;
      if (has_more_columns()) return true;
    }
    return false;
  }

  /// Goes to the next line that holds something, which is about to be read as `expected`.
  void next_line(Column_name expected) {
    if (!try_next_line()) fail_at_end(expected.to_string());
  }

  bool has_more_columns() {
    while (position_ != line_end_ && is_blank(text_[position_])) ++position_;
    return position_ != line_end_ && text_[position_] != '#';
  }

  /// Whether anything is left, in this line or a later one, to which it goes then.
  bool has_more() { return has_more_columns() || try_next_line(); }
  /// Goes to what is left, which is about to be read as `expected`.
  void require_more(Column_name expected) {
    if (!has_more()) fail_at_end(expected.to_string());
  }

  /// The next number of the line: an integer where `Number` is integral, else a finite double.
  template <class Number>
  Number read(Column_name column) {
    const std::string_view word = word_ahead(column);
    // std::from_chars knows no leading plus.
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    const char* const end = word.data() + word.size();
    Number value{};
    const std::from_chars_result result = number_from_chars(word.data() + (has_plus ? 1 : 0), end, value);
    if (result.ec != std::errc() || result.ptr != end || !is_finite(value))
      fail_at_number<Number>(word, result, column);
    position_ += word.size();
    return value;
  }

  /// The next column of the line as it stands there, without going on.
  std::string_view word_ahead(Column_name column) {
    if (!has_more_columns()) fail("the line ends where " + column.to_string() + " is expected");
    if (is_separator(text_[position_]))
      fail(column.to_string() + " is expected before " + in_quotes(text_.substr(position_, 1)));
    return text_.substr(position_, end_of_column() - position_);
  }
  void pass_word() { position_ = end_of_column(); }

  /// From now on columns end with any of these characters, which are no blanks, and with blanks.
  void set_separators(std::string_view separators) { separators_ = separators; }
  /// The separator that comes next in the line, 0 if there is none.
  char separator_ahead() {
    return has_more_columns() && is_separator(text_[position_]) ? text_[position_] : '\0';
  }
  /// Goes behind the separator that comes next in the line.
  void pass_separator() { ++position_; }
  /// Passes over what comes before the next separator, or the next blank if there are no separators; both may stand
  /// between double quotes.
  void skip_column() {
    if (!has_more_columns()) return;
    bool is_quoted = false;
    for (; position_ != line_end_; ++position_) {
      const char c = text_[position_];
      if (c == '"') is_quoted = !is_quoted;
      if (!is_quoted && (c == '#' || is_separator(c) || (separators_.empty() && is_blank(c)))) return;
    }
  }
  /// What is left of the line, without a comment.
  std::string_view rest_of_line() const {
    const std::string_view rest = text_.substr(position_, line_end_ - position_);
    return rest.substr(0, find_unquoted(rest, '#'));
  }
  /// Where a character stands first outside double quotes.
  static std::size_t find_unquoted(std::string_view text, char c) {
    bool is_quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '"') is_quoted = !is_quoted;
      if (text[i] == c && !is_quoted) return i;
    }
    return std::string_view::npos;
  }

  /// As Triangle does, ignores columns behind those that have a meaning; unlike Triangle, not if they are no
  /// numbers.
  void skip_more_columns(Column_name column) {
    while (has_more_columns()) read<double>(column);
  }

  /// Characters not read yet: bounds how many records can follow, whatever a header claims.
  std::size_t remaining() const { return text_.size() - position_; }

  /// The line, as messages begin: "name:line".
  std::string place() const { return name_ + ":" + std::to_string(line_number()); }
  std::size_t line_number() const { return (std::max)(line_number_, std::size_t(1)); }
  /// How many lines have been begun, with those before the text.
  std::size_t lines_begun() const { return line_number_; }
  [[noreturn]] void fail(const std::string& what) const {
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, place() + ": " + what);
  }
  [[noreturn]] void fail_at_end(const std::string& expected) const {
    fail("the file ends where " + expected + " is expected");
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  bool is_separator(char c) const { return separators_.find(c) != std::string_view::npos; }

  template <class Number>
  static bool is_finite(Number value) {
    if constexpr (std::is_floating_point_v<Number>) return std::isfinite(value);
    return true;
  }

  /// Text with no line feed is searched for one only once.
  std::size_t end_of_line(std::size_t begin) {
    if (line_feed_ == unknown_ || line_feed_ < begin)
      line_feed_ = (std::min)(text_.find('\n', begin), text_.size());
    const std::string_view line = text_.substr(begin, line_feed_ - begin);
    return begin + (std::min)(line.find('\r'), line.size());
  }
  std::size_t behind_line(std::size_t end) const {
    if (end == text_.size()) return end;
    return end + (text_.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }

  std::size_t end_of_column() const {
    std::size_t end = position_;
    while (end != line_end_ && text_[end] != '#' && !is_blank(text_[end]) && !is_separator(text_[end])) ++end;
    return end;
  }

  template <class Number>
  [[noreturn]] void fail_at_number(std::string_view word, std::from_chars_result result,
                                   Column_name column) const {
    const std::string culprit = column.to_string() + ": " + in_quotes(word) + " is ";
    if (result.ec == std::errc::invalid_argument || result.ptr != word.data() + word.size())
      fail(culprit + (std::is_integral_v<Number> ? "not an integer" : "not a number"));
    if (result.ec == std::errc()) fail(culprit + "not finite");
    fail(culprit + "too large" + (std::is_integral_v<Number> ? "" : " or too small"));
  }

  static constexpr std::size_t unknown_ = static_cast<std::size_t>(-1);

  std::string name_;
  std::string_view text_;
  std::string_view separators_;
  std::size_t position_ = 0, line_end_ = 0, next_line_ = 0; // in the text
  std::size_t line_feed_ = unknown_;                        // the first behind the beginning of the line
  std::size_t line_number_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_LINE_SCANNER_H
