// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_LINE_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_LINE_WRITER_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/Number_text.h>

#include <cstddef>
#include <string>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Lines of numbers, gathered in memory.
class Line_writer {
public:
  template <class Number>
  Line_writer& operator<<(const Number& value) {
    if (!is_line_begin_) text_ += ' ';
    is_line_begin_ = false;
    append_number(text_, value);
    return *this;
  }
  template <class Tag>
  Line_writer& operator<<(Index<Tag> i) {
    return *this << i.value();
  }
  template <class Point>
  Line_writer& write_point(const Point& p) {
    return *this << p.x() << p.y();
  }
  /// Words, which have no blank in them, or a whole line.
  Line_writer& operator<<(const char* words) {
    if (!is_line_begin_) text_ += ' ';
    is_line_begin_ = false;
    text_ += words;
    return *this;
  }
  Line_writer& operator<<(const std::string& words) { return *this << words.c_str(); }
  void end_line() {
    text_ += '\n';
    is_line_begin_ = true;
  }
  void reserve(std::size_t size) { text_.reserve(size); }
  const std::string& text() const { return text_; }
  std::string take() { return std::move(text_); }

private:
  std::string text_;
  bool is_line_begin_ = true;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_LINE_WRITER_H
