// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_SVG_PATH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_SVG_PATH_H

#include <cstdint>
#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A point of the picture, in tenths of pixels, y downwards.
struct Svg_point {
  std::int32_t x = 0, y = 0;
  friend bool operator==(Svg_point a, Svg_point b) { return a.x == b.x && a.y == b.y; }
};

/// The `d` attribute of one path element: numbers relative to the point before, no separator that is not
/// needed.
class Svg_path {
public:
  void move_to(Svg_point p) { append('m', p); }
  void line_to(Svg_point p) { append('l', p); }
  /// Closing moves the pen back to the start of the line.
  void close(Svg_point start) {
    text_ += 'z';
    last_command_ = 'z';
    pen_ = start;
  }
  bool is_empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }

private:
  void append(char command, Svg_point p) {
    // After m, further pairs of numbers are lines relative to the point before; after M they would be
    // absolute. The first m of a path is absolute as M is.
    if (command != last_command_ && !(command == 'l' && last_command_ == 'm')) text_ += command;
    append_number(p.x - pen_.x);
    append_number(p.y - pen_.y);
    last_command_ = command;
    pen_ = p;
  }
  void append_number(std::int32_t n) {
    if (n >= 0 && !text_.empty() && text_.back() >= '0' && text_.back() <= '9') text_ += ' ';
    text_ += std::to_string(n);
  }

  std::string text_;
  char last_command_ = 0;
  Svg_point pen_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_SVG_PATH_H
