// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_NUMBER_TEXT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_NUMBER_TEXT_H

#include <CGAL/number_utils.h>

#include <array>
#include <charconv>
#include <string>
#include <type_traits>
#include <utility>

// Numbers as text, independent of the locale. A double is written with the fewest digits that give the same
// bits back when read (Ryu, as std::to_chars of libstdc++ has it).

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The type of the coordinates of `Point`: a word for fixed-point points, the kernel's `FT` otherwise.
template <class Point>
using Coordinate_t = std::decay_t<decltype(std::declval<const Point&>().x())>;

/// Appends `value` to `out`. A number type that is neither integral nor floating point is written as the
/// double next to it.
template <class Number>
void append_number(std::string& out, const Number& value) {
  if constexpr (std::is_arithmetic_v<Number>) {
    char digits[32]; // the longest shortest form, -2.2250738585072014e-308, has 24 characters
    const std::to_chars_result result = std::to_chars(digits, digits + sizeof digits, value);
    out.append(digits, result.ptr);
  } else {
    append_number(out, CGAL::to_double(value));
  }
}

/// "(x, y)"
template <class Number>
std::string place_text(const std::array<Number, 2>& p) {
  std::string text = "(";
  append_number(text, p[0]);
  text += ", ";
  append_number(text, p[1]);
  return text += ')';
}

template <class Point>
std::string coordinates_text(const Point& p) {
  return place_text(std::array<Coordinate_t<Point>, 2>{p.x(), p.y()});
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_NUMBER_TEXT_H
