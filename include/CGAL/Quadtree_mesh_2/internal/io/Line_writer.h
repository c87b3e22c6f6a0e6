// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_LINE_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_LINE_WRITER_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Lines of numbers and words with blanks between them, gathered in memory.
///
/// Numbers are made where they stay: the text is longer than what is in it so far.
class Line_writer {
public:
  template <class Number, class = std::enable_if_t<!std::is_convertible_v<const Number&, std::string_view>>>
  Line_writer& operator<<(const Number& value) {
    begin_column(longest_number_);
    char* const begin = &text_[end_];
    if constexpr (std::is_arithmetic_v<Number>)
      end_ += static_cast<std::size_t>(std::to_chars(begin, begin + longest_number_, value).ptr - begin);
    else // the double next to it
      end_ += static_cast<std::size_t>(
          std::to_chars(begin, begin + longest_number_, CGAL::to_double(value)).ptr - begin);
    return *this;
  }
  template <class Tag>
  Line_writer& operator<<(Index<Tag> i) {
    return *this << i.value();
  }
  Line_writer& operator<<(std::string_view words) {
    begin_column(words.size());
    words.copy(&text_[end_], words.size());
    end_ += words.size();
    return *this;
  }
  template <class Point>
  Line_writer& write_point(const Point& p) {
    return *this << p.x() << p.y();
  }
  void end_line() {
    make_room(1);
    text_[end_++] = '\n';
    is_line_begin_ = true;
  }
  void reserve(std::size_t size) { make_room(size); }
  /// The text; the writer is empty then.
  std::string take() {
    text_.resize(end_);
    end_ = 0;
    return std::move(text_);
  }

private:
  static constexpr std::size_t longest_number_ = 32; // a double has up to 24 characters

  void begin_column(std::size_t size) {
    make_room(size + 1);
    if (!is_line_begin_) text_[end_++] = ' ';
    is_line_begin_ = false;
  }
  void make_room(std::size_t size) {
    if (text_.size() - end_ < size) text_.resize((std::max)(2 * text_.size(), end_ + size));
  }

  std::string text_;
  std::size_t end_ = 0; // of what is written
  bool is_line_begin_ = true;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_LINE_WRITER_H
